#include "plumb/io/text/record_reader.h"

#include <charconv>
#include <system_error>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::size_t kLinesPerCheckpoint = 4096;

}  // namespace

RecordReader::RecordReader(std::string_view text, const ReadOptions& options, Context& context,
                           std::string_view contents)
    : cursor_(text, options.name),
      numbers_(context.limits(), options.exact_decimals, text.size()),
      context_(context),
      total_bytes_(text.size()),
      contents_(contents) {}

void RecordReader::charge(std::uint64_t bytes) {
  try {
    context_.charge_memory(bytes, contents_);
  } catch (const Error& error) {
    cursor_.fail(error.code(), error.message());
  }
}

void RecordReader::read_magic(std::string_view magic, std::string_view version) {
  const std::string line = std::string(magic) + ' ' + std::string(version);
  const bool has_content = cursor_.next_line();
  if (!has_content || cursor_.line() != 1 || cursor_.token() != magic) {
    cursor_.fail(ErrorCode::Syntax, "the first line is not '" + line + "'",
                 has_content && cursor_.line() == 1 ? cursor_.line_start() : nullptr);
  }
  const std::string_view found = cursor_.at_line_end() ? std::string_view() : cursor_.token();
  if (found != version) {
    cursor_.fail(
        ErrorCode::UnknownFormat,
        "version " + quoted(found) + " of the format; this program reads " + std::string(version));
  }
  end_line("the end of the line after '" + line + "'");
}

std::uint32_t RecordReader::read_count(std::string_view what) {
  if (cursor_.at_line_end()) {
    cursor_.fail(ErrorCode::Syntax,
                 "expected " + std::string(what) + ", found the end of the line");
  }
  const std::string_view token = cursor_.token();
  std::uint64_t value = 0;
  const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size()) {
    cursor_.fail_token(token, std::string(what) + " (0 or more, digits only)");
  }
  if (code != std::errc() || value > kMostIds) {
    cursor_.fail(ErrorCode::CountMismatch,
                 quoted(token) + ": at most " + std::to_string(kMostIds) + " are possible",
                 token.data());
  }
  return static_cast<std::uint32_t>(value);
}

void RecordReader::require_bytes(std::uint64_t bytes, const std::string& announced,
                                 const char* start) const {
  // The last line may lack its line break.
  if (bytes <= std::uint64_t{cursor_.bytes_left()} + 1) return;
  cursor_.fail(ErrorCode::CountMismatch,
               announced + " are announced, but the file is too short for them", start);
}

void RecordReader::next_record(std::string_view what, std::uint32_t index, std::uint32_t count) {
  record_ = what;
  record_index_ = index;
  if (index % kLinesPerCheckpoint == 0) {
    context_.checkpoint("read", cursor_.bytes_read(), total_bytes_);
  }
  if (cursor_.next_line()) return;
  cursor_.fail(ErrorCode::CountMismatch, "the file ends where " + record_name() + " of " +
                                             std::to_string(count) + " is expected");
}

std::string RecordReader::record_name() const {
  return std::string(record_) + ' ' + std::to_string(std::uint64_t{record_index_} + 1);
}

void RecordReader::read_number(ReadNumber& number, std::string_view needs) {
  if (cursor_.at_line_end()) {
    cursor_.fail(ErrorCode::Syntax, record_name() + " needs " + std::string(needs));
  }
  std::uint32_t small = 0;
  if (cursor_.short_number(small)) {
    number.set(small);
  } else {
    numbers_.read_next(cursor_, number);
  }
}

void RecordReader::read_point(PointTable2& points) {
  for (ReadNumber* number : {&x_, &y_}) read_number(*number, "two numbers, x and y");
  if (!cursor_.at_line_end()) {
    end_line("the end of the line after the two numbers of " + record_name());
  }
  if (const std::size_t bytes = exact_bytes(x_, y_)) charge(bytes);
  push_point(points, x_, y_);
}

std::uint32_t RecordReader::read_id(std::string_view what, std::uint32_t count,
                                    std::uint32_t lowest) {
  if (cursor_.at_line_end()) {
    cursor_.fail(ErrorCode::Syntax, record_name() + " needs the number of a " + std::string(what));
  }
  const char* const start = cursor_.position();
  std::uint32_t id = 0;
  if (!cursor_.short_number(id)) id = read_long_id(cursor_.token(), what);
  if (lowest <= id && id <= count) return id;
  const std::string_view token(start, static_cast<std::size_t>(cursor_.position() - start));
  cursor_.fail(ErrorCode::BadIndex,
               record_name() + " names " + std::string(what) + ' ' + quoted(token) +
                   "; ids run from " + std::to_string(lowest) + " to " + std::to_string(count),
               start);
}

std::uint32_t RecordReader::read_index(std::string_view what, std::uint32_t count) {
  if (count > 0) return read_id(what, count - 1, 0);
  cursor_.fail(ErrorCode::BadIndex,
               record_name() + " names a " + std::string(what) + "; there are none");
}

/// Ids of any length; those beyond every range become one that is beyond it too.
std::uint32_t RecordReader::read_long_id(std::string_view token, std::string_view what) const {
  constexpr std::uint32_t kBeyond = kMostIds + 1;
  const std::string_view digits = token.substr(token.starts_with('-') ? 1 : 0);
  std::uint32_t id = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), id);
  if (end != digits.data() + digits.size()) {
    cursor_.fail_token(token, "a " + std::string(what) + " id");
  }
  return code == std::errc() && digits.size() == token.size() ? id : kBeyond;
}

void RecordReader::end_line(const std::string& expected) {
  if (!cursor_.at_line_end()) cursor_.fail_token(cursor_.token(), expected);
}

}  // namespace plumb
