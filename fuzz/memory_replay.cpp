// Readers under MemorySanitizer: memory_replay FILE... ; ./check --full memory gives it the
// corpora.
//
// MemorySanitizer knows only what is compiled with it, and GMP, MPFR and the C++ library are not.
// So this program is made of the readers alone and what they need, of which everything on the way
// of an ordinary number is compiled here (fuzz/CMakeLists.txt). Where a file needs GMP, for an
// integer of 16 digits, a fraction, an exact decimal, the reading is given up (NeedsGmp).
//
// Every reader gets every file, as it stands and without its first byte, which chooses exact
// decimals in inputs of fuzz targets; and versions that were cut off or changed in some bytes, the
// same ones every time. A value that was never written and decides a branch ends the program with a
// report; so does one in a result or in the message of an error. Exit status 1 when a file cannot
// be read, or one of the readers took nothing.

#include <gmp.h>
#include <sanitizer/msan_interface.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/io/map_io.h"
#include "plumb/io/mesh/obj.h"
#include "plumb/io/mesh/off.h"
#include "plumb/io/mesh/ply.h"
#include "plumb/io/svg_reader.h"
#include "plumb/predicates/error.h"

namespace {

struct NeedsGmp {};

}  // namespace

// A number is 0 and takes no memory until it gets a value; the first value that only GMP can hold
// ends the reading.
static mp_limb_t one = 1;
extern "C" void __gmpz_init(mpz_ptr z) { *z = {0, 0, &one}; }
extern "C" void __gmpz_clear(mpz_ptr /*z*/) {}
extern "C" void __gmpq_init(mpq_ptr q) { *q = {{0, 0, &one}, {1, 1, &one}}; }
extern "C" void __gmpq_clear(mpq_ptr /*q*/) {}
extern "C" int __gmpz_set_str(mpz_ptr /*z*/, const char* /*text*/, int /*base*/) {
  throw NeedsGmp();
}
extern "C" void __gmpz_ui_pow_ui(mpz_ptr /*z*/, unsigned long /*base*/,
                                 unsigned long /*exponent*/) {
  throw NeedsGmp();
}

// The C++ library's own code hangs nodes into a tree.
extern "C" void __real__ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_(
    bool is_left, void* node, void* parent, void* header);
extern "C" void __wrap__ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_(
    bool is_left, void* node, void* parent, void* header) {
  __real__ZSt29_Rb_tree_insert_and_rebalancebPSt18_Rb_tree_node_baseS0_RS_(is_left, node, parent,
                                                                           header);
  constexpr std::size_t kLinks = 4 * sizeof(void*);  // colour, parent, two children
  __msan_unpoison(node, kLinks);
}

namespace {

template <class Items>
void require_written(const Items& items) {
  __msan_check_mem_is_initialized(items.data(), items.size() * sizeof(*items.data()));
}

void require_written(const plumb::PolygonMesh& mesh) {
  require_written(mesh.points);
  require_written(mesh.face_begin);
  require_written(mesh.corners);
}

void require_written(const plumb::Map& map) {
  for (std::uint32_t i = 0; i < map.points.size(); ++i) {
    const plumb::Point2 p = map.points.approx(i);
    require_written(std::array{p.x, p.y});
  }
  require_written(map.corners);
  require_written(map.cycle_begin);
}

void require_written(const plumb::SvgDrawing& drawing) {
  require_written(drawing.points);
  require_written(drawing.places);
  require_written(drawing.ring_begin);
  require_written(drawing.shape_begin);
}

using Options = plumb::ReadOptions;
using plumb::Context;

struct Reader {
  const char* name;
  void (*read)(std::string_view bytes, const Options& options, Context& context);
  std::size_t taken = 0;
  std::size_t refused = 0;
  std::size_t given_up = 0;
};

std::array readers{
    Reader{"map", [](auto bytes, auto& o, auto& c) { require_written(read_map(bytes, o, c)); }},
    Reader{"off",
           [](auto bytes, auto& o, auto& c) { require_written(read_off(bytes, o, c).mesh); }},
    Reader{"obj",
           [](auto bytes, auto& o, auto& c) { require_written(read_obj(bytes, o, c).mesh); }},
    Reader{"ply",
           [](auto bytes, auto& o, auto& c) { require_written(read_ply(bytes, o, c).mesh); }},
    Reader{"svg", [](auto bytes, auto& o, auto& c) { require_written(read_svg(bytes, o, {}, c)); }},
};

void try_reader(Reader& reader, std::string_view bytes) {
  // A copy of its own, so that what lies behind the end was never written.
  const std::vector<char> copy(bytes.begin(), bytes.end());
  Context context;
  try {
    reader.read({copy.data(), copy.size()}, {"replayed"}, context);
    ++reader.taken;
  } catch (const plumb::Error& error) {
    require_written(error.message());
    require_written(std::array{error.place().line, error.place().column});
    ++reader.refused;
  } catch (const NeedsGmp&) {
    ++reader.given_up;
  }
}

void try_readers(std::string_view bytes) {
  for (Reader& reader : readers) try_reader(reader, bytes);
}

void try_changed(std::string_view bytes) {
  constexpr int kVersions = 8;
  std::minstd_rand dice;  // always the same seed
  for (int i = 0; i < kVersions; ++i) {
    std::string changed(bytes.substr(0, dice() % (bytes.size() + 1)));
    try_readers(changed);
    changed = bytes;
    for (int k = 0; k <= i && !changed.empty(); ++k) {
      changed[dice() % changed.size()] = changed[dice() % changed.size()];
    }
    try_readers(changed);
  }
}

bool replay(const char* path) {
  std::FILE* const file = std::fopen(path, "rb");
  if (file == nullptr) {
    std::perror(path);
    return false;
  }
  std::string bytes(1U << 20U, '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  std::fclose(file);
  for (const std::size_t skipped : {0U, 1U}) {
    const std::string_view rest = std::string_view(bytes).substr(std::min(skipped, bytes.size()));
    try_readers(rest);
    try_changed(rest);
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  bool is_well = argc > 1;
  for (int i = 1; i < argc; ++i) is_well &= replay(argv[i]);
  std::printf("%d files\n%-6s %10s %10s %10s\n", argc - 1, "reader", "read", "refused", "need GMP");
  for (const Reader& reader : readers) {
    std::printf("%-6s %10zu %10zu %10zu\n", reader.name, reader.taken, reader.refused,
                reader.given_up);
    is_well &= reader.taken > 0;
  }
  return is_well ? 0 : 1;
}
