// The nodes of a full tree over boxes in a row: what BoxTree and PackedBoxTree have in common.
#pragma once

#include <cstddef>
#include <vector>

namespace plumb {

/// Nodes level by level, the leaves first; each level but the top one is filled up to an even number.
template <class Box>
struct BoxLevels {
  std::vector<Box> nodes;
  std::vector<std::size_t> begin;  ///< of each level, into nodes
};

/// `leaf` consecutive boxes make a leaf, two consecutive nodes the node above them. `empty` is what boxes are added to,
/// `nowhere` what fills a level up. Requires whole leaves. O(n).
template <class Box>
BoxLevels<Box> levels_over(const std::vector<Box>& boxes, std::size_t leaf, const Box& empty,
                           const Box& nowhere) {
  constexpr std::size_t kMostLevels = 64;
  BoxLevels<Box> levels;
  std::size_t count = boxes.size() / leaf;
  levels.nodes.reserve(2 * count + kMostLevels);
  levels.begin = {0};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i % leaf == 0) levels.nodes.push_back(empty);
    levels.nodes.back().add(boxes[i]);
  }
  while (count > 1) {
    if (count % 2 == 1) levels.nodes.push_back(nowhere);
    const std::size_t begin = levels.begin.back(), end = levels.nodes.size();
    levels.begin.push_back(end);
    for (std::size_t i = begin; i < end; i += 2) {
      Box both = levels.nodes[i];
      both.add(levels.nodes[i + 1]);
      levels.nodes.push_back(both);
    }
    count = (end - begin) / 2;
  }
  return levels;
}

}  // namespace plumb
