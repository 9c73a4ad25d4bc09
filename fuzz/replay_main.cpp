// main() of a fuzz target where libFuzzer is not: runs every file given (directories: every file
// below them, in name order, so that two runs do the same). Exit 1 when there was nothing to run or
// nothing got as far as the oracle: a replay that checks nothing must not pass.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "plumb/testing/oracle_reached.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" __attribute__((weak)) int LLVMFuzzerInitialize(int* argc, char*** argv);

// libFuzzer's own mutation, which custom mutators build on. Nothing is mutated in a replay; the
// symbol only has to exist.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* /*data*/, std::size_t size,
                                        std::size_t /*max_size*/) {
  return size;
}

namespace {

using Path = std::filesystem::path;

// A missing directory is an empty one: most targets have no regressions yet.
std::vector<Path> files_below(const Path& path) {
  if (!std::filesystem::is_directory(path)) {
    return std::filesystem::exists(path) ? std::vector<Path>{path} : std::vector<Path>{};
  }
  std::vector<Path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool replay(const Path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
    return false;
  }
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  // On a crash the last name printed is the input that did it.
  std::fprintf(stderr, "%s (%zu bytes)\n", file.c_str(), bytes.size());
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (LLVMFuzzerInitialize != nullptr) LLVMFuzzerInitialize(&argc, &argv);
  std::size_t replayed = 0;
  bool all_read = true;
  for (int i = 1; i < argc; ++i) {
    for (const Path& file : files_below(argv[i])) {
      all_read &= replay(file);
      ++replayed;
    }
  }
  const auto reached = static_cast<std::size_t>(plumb::fuzz::oracle_share.reached);
  std::printf("replayed %zu inputs, %zu reached the oracle\n", replayed, reached);
  return all_read && reached > 0 ? 0 : 1;
}
