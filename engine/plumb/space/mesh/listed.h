// Lists of faces and vertices in messages.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

namespace plumb {

/// Returns "3, 8, 11, 12, 20 and 5 more": the first five.
inline std::string listed(std::span<const std::uint32_t> list) {
  constexpr std::size_t kMost = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(list.size(), kMost); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(list[i]);
  }
  if (list.size() > kMost) text += " and " + std::to_string(list.size() - kMost) + " more";
  return text;
}

}  // namespace plumb
