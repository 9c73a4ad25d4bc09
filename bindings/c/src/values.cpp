// Bytes, notes, lists of indices and of exact numbers, and the checks of arguments.
//
// Every array and every struct that a caller passes goes through a function of this file, which
// refuses null pointers, counts that do not fit, numbers that are not finite, and sizes of structs
// that are not set. Exact numbers keep their texts, so that a caller can borrow them. Texts of
// numbers are read by the rules of files (record_reader.h), decimals exactly.
// Tested by tests/c/interface_test.c.
#include <cmath>
#include <cstddef>

#include "handles.h"
#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/rounding.h"

namespace plumb::c {

std::span<const double> finite(const double* data, std::size_t count, const char* name,
                               std::size_t width) {
  const std::span<const double> numbers = array(data, count, name, width);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i])) {
      throw Error(ErrorCode::NotFinite,
                  std::string(name) + "[" + std::to_string(i) + "] is not finite");
    }
  }
  return numbers;
}

std::span<const std::uint32_t> offsets(const std::uint32_t* begin, std::size_t count,
                                       const char* name) {
  static constexpr std::uint32_t kNothing = 0;
  if (count == 0 && begin == nullptr) return {&kNothing, 1};
  // The largest number has no successor; array() refuses it.
  return array(&need(begin, name), std::max(count, count + 1), name);
}

std::span<const Rational> records(const plumb_numbers* numbers, const char* name,
                                  std::size_t width) {
  const std::vector<Rational>& values = need(numbers, name).values;
  if (values.size() % width != 0) {
    fail_argument(std::string(name) + " has " + std::to_string(values.size()) +
                  " numbers, no multiple of " + std::to_string(width));
  }
  return values;
}

std::span<const Rational> exactly(const plumb_numbers* numbers, const char* name, std::size_t width,
                                  std::size_t count) {
  const std::size_t size = need(numbers, name).values.size();
  if (size % width != 0 || size / width != count) {
    fail_argument(std::string(name) + " has " + std::to_string(size) + " numbers, not " +
                  std::to_string(count) + " times " + std::to_string(width));
  }
  return numbers->values;
}

std::vector<RationalPoint3> points3(const plumb_numbers* numbers, const char* name) {
  const std::span<const Rational> values = records(numbers, name, 3);
  std::vector<RationalPoint3> points;
  points.reserve(values.size() / 3);
  for (std::size_t i = 0; i < values.size(); i += 3) {
    points.push_back({values[i], values[i + 1], values[i + 2]});
  }
  return points;
}

std::vector<RationalPoint2> points2(const plumb_numbers* numbers, const char* name) {
  const std::span<const Rational> values = records(numbers, name, 2);
  std::vector<RationalPoint2> points;
  points.reserve(values.size() / 2);
  for (std::size_t i = 0; i < values.size(); i += 2) points.push_back({values[i], values[i + 1]});
  return points;
}

plumb_numbers numbers_of(std::vector<Rational> values) {
  plumb_numbers numbers{std::move(values), {}};
  numbers.texts.reserve(numbers.values.size());
  for (const Rational& value : numbers.values) numbers.texts.push_back(exact_text(value));
  return numbers;
}

plumb_numbers numbers_of(const RationalPoint3& point) {
  return numbers_of(std::vector<Rational>{point.x, point.y, point.z});
}

plumb_numbers numbers_of(const RationalPoint2& point) {
  return numbers_of(std::vector<Rational>{point.x, point.y});
}

std::string text(const char* argument, const char* name) { return &need(argument, name); }

void fail_format(const std::string& format, const char* known) {
  throw Error(ErrorCode::UnknownFormat, "format: '" + format + "' is none of " + known);
}

void add_notes(plumb_notes& notes, const std::vector<std::string>& texts) {
  notes.texts.insert(notes.texts.end(), texts.begin(), texts.end());
}

void add_warnings(plumb_notes& notes, const std::vector<std::string>& texts) {
  add_notes(notes, texts);
  notes.warnings += texts.size();
}

std::size_t checked_size(std::size_t stated, std::size_t known) {
  if (stated < sizeof(std::size_t)) fail_argument("struct_size is not set");
  return std::min(stated, known);
}

ReadOptions read_options(const plumb_read_options* options, const std::string& name) {
  const plumb_read_options asked = options_of(options, PLUMB_READ_OPTIONS_INIT);
  ReadOptions reading{name, asked.exact_decimals};
  reading.attributes = asked.attributes != 0;
  return reading;
}

std::string name_of(const plumb_read_options* options) {
  const plumb_read_options read = options_of(options, PLUMB_READ_OPTIONS_INIT);
  return read.name != nullptr ? read.name : "input";
}

bool reads_exact_decimals(const plumb_read_options* options) {
  return options_of(options, PLUMB_READ_OPTIONS_INIT).exact_decimals;
}

RepairOptions repair_options(const plumb_repair_options* options) {
  const plumb_repair_options asked = options_of(options, PLUMB_REPAIR_OPTIONS_INIT);
  if (!std::isfinite(asked.weld)) throw Error(ErrorCode::NotFinite, "weld is not finite");
  if (asked.weld < 0) fail_argument("weld is negative");
  if (asked.doubled < PLUMB_DOUBLED_KEEP || asked.doubled > PLUMB_DOUBLED_DROP) {
    fail_argument("doubled is no constant of plumb_doubled");
  }
  if (!std::isfinite(asked.fill_holes_below)) {
    throw Error(ErrorCode::NotFinite, "fill_holes_below is not finite");
  }
  return {asked.weld, static_cast<DoubledFaces>(asked.doubled), asked.reorient, asked.fill_holes,
          asked.fill_holes_below};
}

std::optional<WindingRule> rule_of(int rule) {
  switch (rule) {
    case PLUMB_RULE_DEFAULT:
      return std::nullopt;
    case PLUMB_RULE_NONZERO:
      return WindingRule::NonZero;
    case PLUMB_RULE_EVEN_ODD:
      return WindingRule::EvenOdd;
    case PLUMB_RULE_POSITIVE:
      return WindingRule::Positive;
    default:
      fail_argument("rule is no constant of plumb_rule");
  }
}

void deliver(const ConvexityEvidence& found, bool* is_convex, std::uint64_t* reflex_edges,
             plumb_indices** failing) {
  if (failing != nullptr) {
    auto pairs = std::make_unique<plumb_indices>();
    for (const FailingFace& f : found.faces) {
      pairs->values.push_back(f.face);
      pairs->values.push_back(f.vertex);
    }
    *failing = pairs.release();
  }
  if (reflex_edges != nullptr) *reflex_edges = found.reflex_edges;
  *is_convex = found.is_convex;
}

namespace {

Rational number_of(const char* given, const std::string& name, const Context& context) {
  const RoundToNearest rounding;
  const std::string number = text(given, "an element of texts");
  TextCursor cursor(number, name);
  if (!cursor.next_line()) cursor.fail(ErrorCode::Syntax, "expected a number, found nothing");
  const std::string_view token = cursor.token();
  if (token.size() != number.size()) cursor.fail_token(number, "a number");
  NumberReader numbers(context, true, number.size());
  ReadNumber read;
  numbers.read(cursor, token, read);
  return read.exact();
}

}  // namespace
}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

const char* plumb_bytes_data(const plumb_bytes* bytes) {
  return bytes != nullptr ? bytes->bytes.c_str() : nullptr;
}
std::size_t plumb_bytes_size(const plumb_bytes* bytes) {
  return bytes != nullptr ? bytes->bytes.size() : 0;
}
void plumb_bytes_free(plumb_bytes* bytes) { delete bytes; }

std::size_t plumb_notes_count(const plumb_notes* notes) {
  return notes != nullptr ? notes->texts.size() : 0;
}
const char* plumb_notes_text(const plumb_notes* notes, std::size_t i) {
  return i < plumb_notes_count(notes) ? notes->texts[i].c_str() : nullptr;
}
bool plumb_notes_is_warning(const plumb_notes* notes, std::size_t i) {
  const std::size_t count = plumb_notes_count(notes);
  return i < count && i >= count - notes->warnings;
}
void plumb_notes_free(plumb_notes* notes) { delete notes; }

const std::uint32_t* plumb_indices_data(const plumb_indices* indices) {
  return indices != nullptr ? indices->values.data() : nullptr;
}
std::size_t plumb_indices_count(const plumb_indices* indices) {
  return indices != nullptr ? indices->values.size() : 0;
}
void plumb_indices_free(plumb_indices* indices) { delete indices; }

plumb_status plumb_numbers_from_doubles(const double* values, std::size_t count,
                                        plumb_numbers** out, plumb_error** error) {
  return make(out, error, [&] {
    std::vector<Rational> numbers;
    numbers.reserve(count);
    for (const double value : finite(values, count, "values", 1)) {
      numbers.push_back(exact_rational(value));
    }
    return numbers_of(std::move(numbers));
  });
}

plumb_status plumb_numbers_from_texts(const char* const* texts, std::size_t count,
                                      plumb_numbers** out, const plumb_context* context,
                                      plumb_error** error) {
  return make(out, error, [&] {
    Call call(context);
    std::vector<Rational> numbers;
    for (const char* const given : array(texts, count, "texts")) {
      numbers.push_back(number_of(given, "number " + std::to_string(numbers.size()), call));
    }
    return numbers_of(std::move(numbers));
  });
}

std::size_t plumb_numbers_count(const plumb_numbers* numbers) {
  return numbers != nullptr ? numbers->values.size() : 0;
}
const char* plumb_numbers_exact(const plumb_numbers* numbers, std::size_t i) {
  return i < plumb_numbers_count(numbers) ? numbers->texts[i].c_str() : nullptr;
}
double plumb_numbers_nearest(const plumb_numbers* numbers, std::size_t i) {
  return i < plumb_numbers_count(numbers) ? nearest_double(numbers->values[i]) : 0;
}
void plumb_numbers_free(plumb_numbers* numbers) { delete numbers; }
