// Finding room for labels.
#pragma once

#include <optional>
#include <vector>

#include "plumb/picture/picture.h"

namespace plumb {

/// Places labels near their points without overlapping, greedily, in a fixed order of tries.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Rectangle& frame) : frame_(frame) {}

  /// Keeps labels off a place, such as a symbol.
  void avoid(const Rectangle& r) { points_.push_back(r); }
  /// Keeps labels off entirely.
  void block(const Rectangle& r) { taken_.push_back(r); }

  /// Room for a label of this size at 0.7 to 4 times `reach` from `anchor`: within the frame, off
  /// all other labels, covering as few of the avoided places as possible. Nothing if there is no
  /// room.
  std::optional<Rectangle> place(Point2 anchor, double width, double height, double reach);

 private:
  bool is_free(const Rectangle& r) const;
  int covered(const Rectangle& r) const;

  Rectangle frame_;
  std::vector<Rectangle> points_;
  std::vector<Rectangle> taken_;
};

}  // namespace plumb
