// Writes the lines of many items, on several threads if the context has them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/part_charges.h"
#include "plumb/io/text/text_output.h"

namespace plumb {

/// Writes the lines of the items 0 ... count - 1 in their order. write(out, i) writes the lines of
/// item i. With threads, the texts of ranges of items are made in parallel. Some texts for each
/// thread wait until they are written; they are charged to the context. Throws the exceptions of
/// `stream` and `write`, and the errors of the Context.
template <class WriteItem>
void write_lines(std::ostream& stream, std::size_t count, Context& context,
                 const WriteItem& write) {
  constexpr std::size_t kItemsAText = 4096, kTextsAThread = 8, kItemsACharge = 64;
  if (context.threads() == 1 || count < 2 * kItemsAText) {
    TextOutput out(stream, context);
    for (std::size_t i = 0; i < count; ++i) write(out, i);
    return out.flush();
  }
  std::vector<std::string> texts(kTextsAThread * context.threads());
  PartCharges charges(context, texts.size());
  const auto make = [&](std::size_t part, std::size_t begin, std::size_t end, Context& own) {
    std::ostringstream text;
    TextOutput out(text, own);
    // The buffer of a stream has up to twice the size of its text.
    const auto charge = [&] {
      charges.raise(part, 2 * static_cast<std::uint64_t>(text.tellp()), "text", own);
    };
    for (std::size_t i = begin; i < end; ++i) {
      write(out, i);
      if (i % kItemsACharge == 0) charge();
    }
    out.flush();
    charge();
    texts[part] = std::move(text).str();
  };
  for (std::size_t first = 0; first < count; first += kItemsAText * texts.size()) {
    const std::size_t all = (count - first + kItemsAText - 1) / kItemsAText;
    const std::size_t made = std::min(all, texts.size());
    run_jobs(context, made, [&](std::size_t i, Context& own) {
      const std::size_t begin = first + i * kItemsAText;
      make(i, begin, std::min(begin + kItemsAText, count), own);
    });
    for (std::size_t i = 0; i < made; ++i) {
      stream.write(texts[i].data(), static_cast<std::streamsize>(texts[i].size()));
      texts[i] = {};
      charges.release(i);
    }
  }
}

}  // namespace plumb
