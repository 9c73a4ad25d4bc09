// The nodes around a piece of a face as points of the plane, with the distances of the face.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/space/planar_points.h"
#include "plumb/surface/surface.h"
#include "plumb/surface/surface_arrangement.h"

namespace plumb {

/// Orientation and order are those of (u, v). Distances are |u p + v q|, p and q the sides of the face
/// from its first corner: (E, F, G) = (p p, p q, q q), taken exactly from the doubles of the mesh.
/// Ladder: rounded points with a radius; rationals.
class PiecePoints final : public PlanarPoints {
 public:
  explicit PiecePoints(const SurfaceDivision& division);

  /// Starts again, in that face.
  void reset(FaceId f);
  void push_back(NodeId n);

  std::uint32_t size() const override { return static_cast<std::uint32_t>(at_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override;
  Sign compare(std::uint32_t i, std::uint32_t j) const override;
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override;

 private:
  struct Entry {
    Point2 mid;
    double radius;  ///< both coordinates are that near
    NodeId node;
  };
  const RationalPoint2& exact_point(std::uint32_t i) const;
  const std::array<Rational, 3>& exact_form() const;

  const SurfaceMesh& mesh_;
  const SurfaceArrangement& a_;
  const SurfacePointTable& points_;
  FaceId face_;
  std::array<double, 3> form_{};  // E, F, G, rounded
  double form_scale_ = 0;         // E + 2 |F| + G
  std::vector<Entry> at_;
  mutable std::optional<std::array<Rational, 3>> exact_form_;
  mutable std::vector<std::optional<RationalPoint2>> exact_;
};

}  // namespace plumb
