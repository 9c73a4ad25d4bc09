// The lines of a text. Lines may end in different ways, and different characters may fill up the
// file.
#pragma once

#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/io/text/input_cursors.h"

namespace plumb {

/// Returns the text without the padding that some systems put at its end: zeros, or Ctrl-Z.
inline std::string_view without_padding(std::string_view text) {
  constexpr std::string_view kPadding("\0\x1A", 2);
  return text.substr(0, text.find_last_not_of(kPadding) + 1);
}

/// Returns `read(text)`. If the lines of the text end with CR alone, `read` gets a copy with LF,
/// whose memory is charged while it exists.
template <class Read>
auto read_lines(std::string_view text, const ReadOptions& options, Context& context, Read read) {
  if (!ends_lines_with_cr(text)) return read(text);
  MemoryCharge charge(context);
  with_place(WholeFile{options.name}, [&] { charge.add(text.size(), "the lines of the file"); });
  const std::string lines = with_line_feeds(text, text.size());
  return read(std::string_view(lines));
}

}  // namespace plumb
