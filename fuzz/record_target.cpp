#include "record_target.h"

#include <cstdio>
#include <cstdlib>

#include "plumb/testing/oracle_reached.h"
#include "plumb/testing/record_mutator.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using plumb::fuzz::kTarget;
  plumb::fuzz::begin_input();
  if (size < 2 * kTarget.record || size > kTarget.max_records * kTarget.record) return 0;
  plumb::fuzz::oracle_reached();
  const std::string wrong = kTarget.difference({data, size});
  if (wrong.empty()) return 0;
  std::fprintf(stderr, "the engine and its twin disagree: %s\n", wrong.c_str());
  std::abort();
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(plumb::fuzz::kTarget.record, seed).mutate(data, size, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                                 const std::uint8_t* second,
                                                 std::size_t second_size, std::uint8_t* out,
                                                 std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(plumb::fuzz::kTarget.record, seed)
      .cross({first, first_size}, {second, second_size}, out, max_size);
}
