// open_edges() on maps with every kind of defect, against plumb's brute-force twin.
#include <cstdlib>

#include "open_edges.h"
#include "plumb/testing/map_oracle.h"
#include "plumb/testing/map_program.h"
#include "plumb/testing/oracle_reached.h"
#include "plumb/testing/record_mutator.h"

using namespace plumb::testing;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  const TestMap map = map_of_program({data, size}, 48);
  if (!refusal(map, {}).empty() || map.corner_count() > 96) return 0;
  plumb::fuzz::oracle_reached();
  if (open_edges(map.cycles) != judge(map, {}).counts.open) std::abort();
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(kMapRecord, seed).mutate(data, size, max_size);
}
