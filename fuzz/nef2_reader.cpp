// The .nef2 reader on arbitrary bytes, and on what the writer writes with a few words changed.
//
// First byte even: the rest is the file. Odd: records of four bytes build a set by operations on
// half-planes, rays, lines and small polygons; it is written, and the records left over change
// words of the text. Either the reader throws an Error (with a place in the file, but for records
// that are no set), or the set it read passes its audit and is written and read again as it was,
// byte for byte.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/plane_sets.h"
#include "plumb/io/plane/nef2_format.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"
#include "shape_laws.h"

namespace {

using plumb::Nef2;
using plumb::fuzz::require;

/// The least line of an edge, "0 0 1 2 0 0 0", has 14 bytes and takes 28; that of a crossing, 8 and
/// 40; "1/3 2" 6 and 112.
plumb::Limits limits_for(std::size_t bytes) {
  plumb::Limits limits;
  limits.max_memory_bytes = 20 * bytes + (std::size_t{1} << 16U);
  return limits;
}

/// Records of few numbers, and short ones: the judgement is quadratic and worse.
bool is_small(const plumb::PlaneRecords& records) {
  constexpr std::size_t kMost = 60;
  if (records.edges.size() + records.vertices.size() > kMost) return false;
  for (std::uint32_t i = 0; i < records.points.inputs.size(); ++i) {
    const plumb::RationalPoint2 p = records.points.inputs.exact(i);
    if (p.x.str().size() + p.y.str().size() > 1000) return false;
  }
  return true;
}

std::optional<plumb::PlaneRecords> read_records(std::string_view text) {
  plumb::Context context(limits_for(text.size()));
  try {
    return plumb::read_nef2_records(text, {plumb::fuzz::kFileName}, context);
  } catch (const plumb::Error& error) {
    require(error.code() != plumb::ErrorCode::ResourceLimit,
            "memory charged is in proportion to the input");
    plumb::fuzz::require_place(error, text);
    return {};
  }
}

void judge(std::string_view text) {
  const std::optional<plumb::PlaneRecords> records = read_records(text);
  if (!records || !is_small(*records)) return;
  plumb::fuzz::oracle_reached();
  plumb::Context context;
  try {
    const Nef2 set = plumb::read_nef2(text, {plumb::fuzz::kFileName}, context);
    plumb::fuzz::require_sound(set);
    plumb::fuzz::require_nef2_round(set);
  } catch (const plumb::Error& error) {
    require(error.code() == plumb::ErrorCode::BadShape, "records are a set or contradict");
    require(error.place().file == plumb::fuzz::kFileName, "an error names the file");
  }
}

// ---------------------------------------------------------------- sets with changed words

/// Takes bytes off the front; zeros when there are none left.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }
  std::uint32_t take(std::size_t count) {
    std::uint32_t value = 0;
    for (; count > 0; --count) {
      value = value << 8U | (bytes_.empty() ? 0U : bytes_.front());
      if (!bytes_.empty()) bytes_ = bytes_.subspan(1);
    }
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

Nef2 any_set(plumb::testing::Dice& dice) {
  if (dice.below(2) == 0) return plumb::testing::any_unbounded(dice);
  return plumb::fuzz::read_back(plumb::testing::any_wkt(dice), plumb::PlaneFormat::Wkt);
}

Nef2 built(Bytes& bytes) {
  const std::uint32_t steps = bytes.take(1) % 4;
  Nef2 set;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    plumb::testing::Dice dice(bytes.take(2));
    set = plumb::testing::changed(set, any_set(dice), dice);
  }
  return set;
}

/// One word of the text, from the second line on, becomes a small number.
void change_word(std::string& text, Bytes& bytes) {
  const std::size_t start = text.find('\n') + 1;
  const std::size_t at = start + bytes.take(2) % (text.size() - start);
  const std::size_t first = std::min(text.find_first_not_of(" \n", at), text.size() - 1);
  const std::size_t last = text.find_first_of(" \n", first);
  text.replace(first, last - first, std::to_string(bytes.take(1) % 12));
}

void judge_built(Bytes bytes) {
  const Nef2 set = built(bytes);
  plumb::fuzz::require_sound(set);
  plumb::fuzz::require_nef2_round(set);
  plumb::Context context;
  std::string text = plumb::fuzz::text_of(plumb::PlaneText(set, plumb::PlaneFormat::Nef2, context));
  judge(text);
  while (!bytes.empty()) change_word(text, bytes);
  judge(text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  if (size == 0) return 0;
  if (data[0] % 2 == 0) {
    judge({reinterpret_cast<const char*>(data) + 1, size - 1});
  } else {
    judge_built(Bytes({data + 1, std::min<std::size_t>(size - 1, 64)}));
  }
  return 0;
}
