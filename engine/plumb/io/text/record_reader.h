// Reads files of counted records, one a line: what map, OFF, text PLY, .nef2 and .nef share.
//
// Claims are held against the bytes that follow before anything is reserved for them; every error,
// an exhausted memory limit included, is thrown with its place.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/number_reader.h"
#include "plumb/predicates/point_table2.h"

namespace plumb {

class RecordReader {
 public:
  static constexpr std::uint32_t kMostIds = std::numeric_limits<std::uint32_t>::max() - 1;

  /// `contents` is what the memory is charged for: "the map". Everything must outlive the reader.
  RecordReader(std::string_view text, const ReadOptions& options, Context& context,
               std::string_view contents);

  TextCursor& cursor() { return cursor_; }
  const TextCursor& cursor() const { return cursor_; }

  /// Charges the context; a limit is met at the place of the cursor.
  void charge(std::uint64_t bytes);

  /// The first line, `MAGIC VERSION`. Errors: Syntax, UnknownFormat for another version.
  void read_magic(std::string_view magic, std::string_view version);
  /// A number of records: 0 or more, at most kMostIds.
  std::uint32_t read_count(std::string_view what);
  /// Fails at `start` unless as many bytes follow as `announced` needs at least.
  void require_bytes(std::uint64_t bytes, const std::string& announced, const char* start) const;

  /// To the line of record `index` of `count`, or an error that says what is missing.
  void next_record(std::string_view what, std::uint32_t index, std::uint32_t count);
  /// "face 3": the record last begun, numbered from 1.
  std::string record_name() const;

  /// The next number of the line; fails with "face 3 needs NEEDS" if there is none.
  void read_number(ReadNumber& number, std::string_view needs);
  /// Two numbers x y and the end of the line: appended to `points`, exact ones charged.
  void read_point(PointTable2& points);
  /// The number of a `what`: in the text `lowest` to `count`, with a `lowest` of 0 or 1.
  std::uint32_t read_id(std::string_view what, std::uint32_t count, std::uint32_t lowest = 1);
  /// The same for `count` of them numbered from 0.
  std::uint32_t read_index(std::string_view what, std::uint32_t count);
  /// Fails with `expected` if the line goes on.
  void end_line(const std::string& expected);

 private:
  std::uint32_t read_long_id(std::string_view token, std::string_view what) const;

  TextCursor cursor_;
  NumberReader numbers_;
  Context& context_;
  std::size_t total_bytes_;
  std::string_view contents_;
  std::string_view record_;
  std::uint32_t record_index_ = 0;
  ReadNumber x_;
  ReadNumber y_;
};

}  // namespace plumb
