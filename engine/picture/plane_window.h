// The part of the plane that a picture of a complex shows: a box with exact borders, so that what
// goes on to infinity can be cut off exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumb/picture/picture.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_complex.h"

namespace plumb {

class PlaneWindow {
 public:
  /// Around all vertices of the complex and a point of each line without vertices; [-1, 1]^2 when
  /// there is nothing. `margin` is left free on every side, as a part of the longer side.
  PlaneWindow(const PlaneComplex& complex, double margin);

  /// The corners, counter-clockwise from the lower left.
  PointTable2 corners() const;
  /// height / width, between 0.45 and 1.15.
  double aspect() const { return half_height_; }

  /// Window coordinates of a point: the middle is (0, 0), the left and right borders are x = -1 and
  /// x = 1, equally scaled in y. Good to 2^-25 of the window's width wherever the window lies.
  Point2 at(const PlanePoints& points, std::uint32_t i) const;
  /// The borders that a point lies on, exactly: 1 left, 2 right, 4 bottom, 8 top.
  unsigned borders(const PlanePoints& points, std::uint32_t i) const;

  /// Round values along an axis and where they lie in window coordinates.
  struct Tick {
    double at;
    std::string text;
  };
  /// None where doubles cannot tell them apart in a few digits.
  std::vector<Tick> ticks(bool is_vertical) const;

 private:
  void surround(const Rational& left, const Rational& bottom, const Rational& right,
                const Rational& top, double margin);

  Rational left_, bottom_, right_, top_;
  Rational centre_x_, centre_y_, half_;  // half the width
  double half_height_ = 1;               // window coordinates
  bool is_plain_ = false;                // doubles are good enough
  double plain_x_ = 0, plain_y_ = 0, plain_half_ = 1;
};

/// The part of the set inside the window, which is open. O(n log n).
Nef2 cut_at(const Nef2& set, const PlaneWindow& window);

}  // namespace plumb
