// The .nef reader on arbitrary bytes, and on what the writer writes with a few words changed.
//
// First byte even: the rest is the file. Odd: the second says how many records of eight bytes build
// a set (tests/generate/space_program.h); it is written, and what is left, three bytes each,
// changes words of the text. Either the reader throws an Error that names the file and a place in
// it (but for records that do not fit together), or what it read is written and read again as it
// was, byte for byte; the audit rejects it, or it is a set that keeps the laws of sets.

#include "plumb/io/nef3_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>

#include "generate/space_program.h"
#include "oracle/nef3_check.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace {

using plumb::AuditForm;
using plumb::Nef3;
using plumb::SpaceComplex;
using plumb::fuzz::require;

constexpr std::size_t kMaxPlanes = 9;

/// A record takes at most 32 times its bytes (a plane); "1/3 0 0 0" has 10 bytes and takes 256 +
/// 112.
plumb::Limits limits_for(std::size_t bytes) {
  plumb::Limits limits;
  limits.max_memory_bytes = 48 * bytes + (std::size_t{1} << 16U);
  return limits;
}

std::string written(const SpaceComplex& complex) {
  std::ostringstream out;
  plumb::write_nef3(out, complex);
  return out.str();
}

std::optional<SpaceComplex> complex_of(std::string_view text) {
  plumb::Context context(limits_for(text.size()));
  try {
    return plumb::read_nef3(text, {plumb::fuzz::kFileName}, context);
  } catch (const plumb::Error& error) {
    require(error.code() != plumb::ErrorCode::ResourceLimit,
            "memory charged is in proportion to the input");
    if (error.place().line != 0) {
      plumb::fuzz::require_place(error, text);
    } else {
      require(error.code() == plumb::ErrorCode::BadShape, "only records that do not fit");
      require(error.place().file == plumb::fuzz::kFileName, "an error names the file");
    }
    return {};
  }
}

/// Files of few and short numbers: the audit is quadratic at a vertex, products of long numbers are
/// slow.
bool is_small(std::string_view text) {
  constexpr std::size_t kMostBytes = 20000;
  constexpr std::size_t kMostDigits = 200;
  std::size_t digits = 0;
  for (const char c : text) {
    digits = c == ' ' || c == '\n' ? 0 : digits + 1;
    if (digits > kMostDigits) return false;
  }
  return text.size() <= kMostBytes;
}

void require_sound(const Nef3& set) {
  const auto flaw = plumb::audit(set.complex(), AuditForm::Minimal);
  if (!flaw) return;
  std::fprintf(stderr, "%s at %s\n", flaw->invariant.c_str(), flaw->place.c_str());
  require(false, "a set passes its audit");
}

void require_laws(const Nef3& set) {
  require(set == !!set, "a complement is undone");
  const Nef3 closure = set.closure();
  const Nef3 interior = set.interior();
  require_sound(closure);
  require_sound(interior);
  require(interior.is_subset_of(set) && set.is_subset_of(closure), "interior <= set <= closure");
  require((closure - interior) == set.boundary(), "closure - interior is the boundary");
  require((set ^ set).is_empty(), "a set is itself");
}

void require_round(const SpaceComplex& complex) {
  const std::string text = written(complex);
  plumb::Context context;
  const SpaceComplex copy = plumb::read_nef3(text, {"written"}, context);
  require(written(copy) == text, "a complex is written as it was read");
}

void judge(std::string_view text) {
  std::optional<SpaceComplex> complex = complex_of(text);
  if (!complex || !is_small(text)) return;
  plumb::fuzz::oracle_reached();
  require_round(*complex);
  if (plumb::audit(*complex, AuditForm::Minimal)) return;
  require_laws(Nef3::from_minimal_unchecked(std::move(*complex)));
}

// ---------------------------------------------------------------- sets with changed words

using Bytes = std::span<const std::uint8_t>;

/// One word of the text, from the second line on, becomes a small number.
void change_word(Bytes change, std::string& text) {
  const std::size_t start = text.find('\n') + 1;
  const std::size_t at = start + (change[0] * std::size_t{256} + change[1]) % (text.size() - start);
  const std::size_t first = std::min(text.find_first_not_of(" \n", at), text.size() - 1);
  const std::size_t last = text.find_first_of(" \n", first);
  text.replace(first, last - first, std::to_string(change[2] % 32));
}

/// Read again it is the same set: what is left out of the tables is not missed.
std::string text_of(const Nef3& set) {
  std::string text = written(set.complex());
  plumb::Context context;
  const Nef3 copy = Nef3::from_minimal_unchecked(plumb::read_nef3(text, {"written"}, context));
  require_sound(copy);
  require(copy == set, "a set survives .nef");
  return text;
}

void judge_built(Bytes bytes) {
  if (bytes.empty()) return;
  constexpr std::size_t kRecord = plumb::testing::kProgramRecord;
  const std::size_t records = std::min<std::size_t>(1 + bytes[0] % 8, (bytes.size() - 1) / kRecord);
  const Bytes program = bytes.subspan(1, records * kRecord);
  Bytes changes = bytes.subspan(1 + program.size());
  const Nef3 set =
      plumb::testing::to_nef(*plumb::testing::space_set_of_program(program, kMaxPlanes));
  require_sound(set);
  std::string text = text_of(set);
  judge(text);
  if (changes.size() < 3) return;
  for (; changes.size() >= 3; changes = changes.subspan(3)) change_word(changes, text);
  judge(text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  if (size == 0) return 0;
  if (data[0] % 2 == 0) {
    judge({reinterpret_cast<const char*>(data) + 1, size - 1});
  } else {
    judge_built({data + 1, std::min<std::size_t>(size - 1, 128)});
  }
  return 0;
}
