// The map reader on arbitrary bytes.
//
// The first byte chooses exact decimals or nearest doubles; the rest is the file. Either the reader
// throws an Error that names the file, a line and a column inside it, or writing what was read and
// reading it again gives the same points and cycles. Memory charged to the context stays in
// proportion to the input.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "plumb/io/map_io.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace {

using plumb::Map;
using plumb::fuzz::require;
using plumb::fuzz::require_place;

/// What a map of `bytes` bytes may be charged at most: a vertex line "1/3 2" (6 bytes) takes 16 +
/// 32 + 64 bytes; corners come in steps of 2^18 bytes.
plumb::Limits limits_for(std::size_t bytes) {
  plumb::Limits limits;
  limits.max_memory_bytes = 20 * bytes + (std::size_t{1} << 18U);
  return limits;
}

std::optional<Map> read(std::string_view text, bool exact_decimals) {
  plumb::Context context(limits_for(text.size()));
  try {
    return plumb::read_map(text, {plumb::fuzz::kFileName, exact_decimals}, context);
  } catch (const plumb::Error& error) {
    const bool is_expansion = error.code() == plumb::ErrorCode::ResourceLimit;
    require(!is_expansion || exact_decimals, "memory charged is in proportion to the input");
    require_place(error, text);
    return {};
  }
}

void require_same(const Map& a, const Map& b) {
  require(a.corners == b.corners && a.cycle_begin == b.cycle_begin, "cycles survive a round trip");
  require(a.points.size() == b.points.size(), "vertices survive a round trip");
  for (std::uint32_t i = 0; i < a.points.size(); ++i) {
    require(a.points.exact(i) == b.points.exact(i), "coordinates survive a round trip");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::optional<Map> map = read(text, (data[0] & 1U) != 0);
  if (!map) return 0;
  plumb::fuzz::oracle_reached();
  std::ostringstream written;
  plumb::write_map(written, *map);
  plumb::Context context;
  // Written maps hold no exact decimals: doubles, integers and fractions only.
  const std::string copy = written.str();
  require_same(*map, plumb::read_map(copy, {"written", false}, context));
  return 0;
}
