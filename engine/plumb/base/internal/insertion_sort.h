// A stable sort for few items. std::stable_sort() allocates memory, which costs more than the sort.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace plumb {

/// Sorts items by is_before(a, b); items of which neither is before the other keep their order.
/// O(n^2).
template <class Item, class IsBefore>
void insertion_sort(std::span<Item> items, const IsBefore& is_before) {
  for (std::size_t i = 1; i < items.size(); ++i) {
    const Item item = items[i];
    std::size_t at = i;
    for (; at > 0 && is_before(item, items[at - 1]); --at) items[at] = items[at - 1];
    items[at] = item;
  }
}

}  // namespace plumb
