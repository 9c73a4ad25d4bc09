// The reader of half-spaces on arbitrary bytes, and the set they intersect in.
//
// The first byte chooses exact decimals or nearest doubles; the rest is the file. Either the reader
// throws an Error that names the file and a place in it, or it read what the words of the lines
// say, and reads it again as it was once written. Of a few short lines the intersection is a sound
// set, the same as by Booleans one by one, and holds of some points those that all lines hold.

#include "plumb/io/solid/half_space_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace {

using plumb::AuditForm;
using plumb::Boundary;
using plumb::HalfSpace3;
using plumb::HalfSpaceList;
using plumb::Nef3;
using plumb::Rational;
using plumb::fuzz::require;

constexpr std::size_t kMostJudged = 10;  // half-spaces
constexpr std::size_t kMostDigits = 40;  // of a word
constexpr std::size_t kBytesOfMemory =
    400;  // for each of the file: "1/3" takes 3 bytes and a rational

std::optional<HalfSpaceList> list_of(std::string_view text, bool exact) {
  plumb::Limits limits;
  limits.max_memory_bytes = kBytesOfMemory * text.size() + (std::size_t{1} << 16U);
  plumb::Context context(limits);
  try {
    plumb::ReadOptions options{plumb::fuzz::kFileName};
    options.exact_decimals = exact;
    return plumb::read_half_spaces(text, options, context);
  } catch (const plumb::Error& error) {
    require(error.code() != plumb::ErrorCode::ResourceLimit,
            "memory charged is in proportion to the input");
    plumb::fuzz::require_place(error, text);
    return {};
  }
}

/// The words of the lines that are not empty; # begins a comment, and a mark of the byte order may
/// begin the file.
std::vector<std::vector<std::string>> words_of(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::vector<std::string>> lines(1);
  std::string word;
  bool is_comment = false;
  const auto end_word = [&] {
    if (!word.empty()) lines.back().push_back(std::exchange(word, {}));
  };
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      end_word();
      is_comment = false;
      if (!lines.back().empty()) lines.emplace_back();
    } else if (c == '#' || is_comment) {
      end_word();
      is_comment = true;
    } else if (c == ' ' || c == '\t' || c == '\f' || c == '\v') {
      end_word();
    } else {
      word += c;
    }
  }
  end_word();
  if (lines.back().empty()) lines.pop_back();
  return lines;
}

/// Of decimals the standard library says which double is nearest.
void require_number(const Rational& number, const std::string& word) {
  const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* const end = word.data() + word.size();
  double value = 0;
  const auto [stop, code] = std::from_chars(begin, end, value);
  if (stop != end || code != std::errc()) return;
  require(plumb::nearest_double(number) == value, "a number is what its word says");
}

bool is_short(const std::vector<std::vector<std::string>>& lines) {
  if (lines.size() > kMostJudged) return false;
  for (const auto& line : lines) {
    for (const std::string& word : line) {
      if (word.size() > kMostDigits || word.find_first_of("eE") < word.size()) {
        if (word != "closed" && word != "open") return false;
      }
    }
  }
  return true;
}

std::string written(const HalfSpaceList& list) {
  std::ostringstream out;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const HalfSpace3 h = list[i];
    for (const Rational& c : {h.plane.a, h.plane.b, h.plane.c, h.plane.d}) {
      out << plumb::exact_text(c) << ' ';
    }
    out << (h.boundary == Boundary::Closed ? "closed\n" : "open\n");
  }
  return std::move(out).str();
}

bool holds(const HalfSpace3& h, const plumb::RationalPoint3& p) {
  const Rational value = h.plane.a * p.x + h.plane.b * p.y + h.plane.c * p.z + h.plane.d;
  return value < 0 || (value == 0 && h.boundary == Boundary::Closed);
}

void require_members(const Nef3& set, const std::vector<HalfSpace3>& all,
                     const plumb::RationalPoint3& p) {
  const bool is_in = std::ranges::all_of(all, [&](const HalfSpace3& h) { return holds(h, p); });
  require(set.contains(p) == is_in, "a set holds the points that all half-spaces hold");
}

void judge_set(const HalfSpaceList& list) {
  plumb::Context context;
  const Nef3 set = plumb::intersection_of(list, context);
  require(!plumb::audit(set.complex(), AuditForm::Minimal), "an intersection passes its audit");
  std::vector<HalfSpace3> all;
  Nef3 folded = Nef3::whole();
  for (std::size_t i = 0; i < list.size(); ++i) {
    all.push_back(list[i]);
    folded *= Nef3::half_space(list[i].plane, list[i].boundary);
  }
  require(set == folded, "an intersection is that of one after another");
  const auto& complex = set.complex();
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    if (complex.vertex_mark[v] == plumb::kBeyond) continue;
    require_members(set, all, plumb::exact(complex.points(), complex.vertex_point[v]));
  }
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 2}) require_members(set, all, {x, y, x - y});
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const std::optional<HalfSpaceList> list = list_of(text, data[0] % 2 == 0);
  if (!list) return 0;
  const auto lines = words_of(text);
  require(lines.size() == list->size(), "a half-space for each line");
  plumb::fuzz::oracle_reached();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const HalfSpace3 h = (*list)[i];
    require(lines[i].size() == 5, "five words in a line");
    require((lines[i][4] == "closed") == (h.boundary == Boundary::Closed), "closed or open");
    const std::array numbers{h.plane.a, h.plane.b, h.plane.c, h.plane.d};
    for (std::size_t k = 0; k < 4; ++k) require_number(numbers[k], lines[i][k]);
  }
  if (!is_short(lines)) return 0;
  const std::string again = written(*list);
  const std::optional<HalfSpaceList> copy = list_of(again, true);
  require(copy && written(*copy) == again, "half-spaces are read as they are written");
  judge_set(*list);
  return 0;
}
