// Writes the lines of many items, on several threads if the context has them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/parallel.h"
#include "plumb/io/text/text_output.h"

namespace plumb {

/// Writes the lines of the items 0 ... count - 1 in their order; write(out, i) writes those of item
/// i. With threads, the texts of ranges of items are made in parallel. At most some megabytes of
/// text for each thread wait until they are written. Throws what `stream` and `write` throw.
template <class WriteItem>
void write_lines(std::ostream& stream, std::size_t count, Context& context,
                 const WriteItem& write) {
  constexpr std::size_t kItemsAText = 4096, kTextsAThread = 8;
  const auto write_range = [&](std::ostream& to, std::size_t begin, std::size_t end) {
    TextOutput out(to);
    for (std::size_t i = begin; i < end; ++i) write(out, i);
    out.flush();
  };
  if (context.threads() == 1 || count < 2 * kItemsAText) return write_range(stream, 0, count);
  std::vector<std::string> texts(kTextsAThread * context.threads());
  for (std::size_t first = 0; first < count; first += kItemsAText * texts.size()) {
    const std::size_t all = (count - first + kItemsAText - 1) / kItemsAText;
    const std::size_t made = std::min(all, texts.size());
    run_jobs(context, made, [&](std::size_t i, Context&) {
      std::ostringstream text;
      const std::size_t begin = first + i * kItemsAText;
      write_range(text, begin, std::min(begin + kItemsAText, count));
      texts[i] = std::move(text).str();
    });
    for (std::size_t i = 0; i < made; ++i) {
      stream.write(texts[i].data(), static_cast<std::streamsize>(texts[i].size()));
    }
  }
}

}  // namespace plumb
