// Solids swept by sets of the plane.
//
// OutlineMesh has the border of a regularized outline: its corners, its edges with the outline on
// their left, and triangles between its corners that cover it. A layer of a solid is a copy of the
// corners. Strips of faces join neighbouring layers, and the triangles close the ends. Each edge of
// the mesh therefore has as many faces in one direction as in the other, whatever the layers are,
// so that winding numbers exist. If the mesh crosses itself, the winding rule makes a set of it.
//
// Tested by tests/model/extrude_test.cpp.
#include "plumb/model/extrude.h"

#include <cmath>
#include <utility>
#include <vector>

#include "plumb/model/primitives.h"
#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

constexpr std::uint32_t kMostSlices = 1U << 20U;
// If a symmetry makes the diagonals of a wall equal, they differ in doubles by less than this. For
// the correctness of the solid it does not matter which one is used. But all symmetric walls should
// use the same one.
constexpr double kSameLength = 0x1p-40;

/// The vertices of a complex for triangulate().
class TablePoints final : public PlanarPoints {
 public:
  explicit TablePoints(const PointTable2& table) : table_(table) {}
  std::uint32_t size() const override { return static_cast<std::uint32_t>(table_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override {
    return orient2d(table_, i, j, k);
  }
  Sign compare(std::uint32_t i, std::uint32_t j) const override { return compare_xy(table_, i, j); }
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override {
    return plumb::incircle(table_.exact(i), table_.exact(j), table_.exact(k), table_.exact(l));
  }

 private:
  const PointTable2& table_;
};

struct OutlineMesh {
  PointTable2 corners;
  std::vector<IndexEdge> edges;  ///< The edges, with the outline on their left.
  std::vector<IndexTriangle> triangles;
};

OutlineMesh outline_mesh(const Nef2& outline, Context& context) {
  if (!outline.is_bounded()) {
    throw Error(ErrorCode::BadArgument, "an unbounded outline cannot be extruded");
  }
  const Nef2 regular = outline.regularization(context);
  const PlaneComplex& c = regular.complex();
  OutlineMesh mesh;
  for (const std::uint32_t p : c.vertex_point) {
    const RationalPoint2 at = exact(c.points, p);
    mesh.corners.push_back(at.x, at.y);
  }
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    const HalfedgeId first = first_half(EdgeId(e));
    const HalfedgeId h = c.mark(c.dcel.face(first)) ? first : twin(first);
    mesh.edges.push_back({c.dcel.origin(h).value(), c.dcel.target(h).value()});
  }
  PLUMB_CHECK(mesh.edges.empty() ||
              triangulate(TablePoints(mesh.corners), mesh.edges, mesh.triangles));
  return mesh;
}

/// Collects the layers of a solid and the faces between them.
class Sweep {
 public:
  Sweep(const OutlineMesh& outline, Context& context) : outline_(outline), memory_(context) {}

  /// Adds a layer: a function from the number of a corner to a point.
  template <class Place>
  void add_layer(const Place& place) {
    expect_layer();
    for (std::uint32_t v = 0; v < outline_.corners.size(); ++v) {
      const auto p = static_cast<std::uint32_t>(mesh_.points.size());
      const RationalPoint3 at = place(v);
      mesh_.points.push_back({nearest_double(at.x), nearest_double(at.y), nearest_double(at.z)});
      mesh_.exact.emplace_back(p, at);
    }
  }
  /// Adds a layer of doubles.
  template <class Place>
  void add_rounded_layer(const Place& place) {
    expect_layer();
    for (std::uint32_t v = 0; v < outline_.corners.size(); ++v) {
      mesh_.points.push_back(place(outline_.corners.approx(v)));
    }
  }
  /// Joins two layers by quadrilaterals, which have to be planar.
  void add_walls(std::uint32_t low, std::uint32_t high) {
    for (const auto& [p, q] : outline_.edges) {
      mesh_.add_face(std::array{at(low, p), at(low, q), at(high, q), at(high, p)});
    }
  }
  /// The diagonal of a wall that becomes the common edge of its two triangles.
  enum class Diagonal : std::uint8_t { Shorter, Longer };

  /// Joins two layers by pairs of triangles. If both diagonals are equally long up to rounding,
  /// `rises_in_doubt` says whether the chosen one rises in the direction of the outline.
  void add_triangle_walls(std::uint32_t low, std::uint32_t high, bool rises_in_doubt,
                          Diagonal diagonal = Diagonal::Shorter) {
    for (const auto& [p, q] : outline_.edges) {
      const std::array<std::uint32_t, 4> wall{at(low, p), at(low, q), at(high, q), at(high, p)};
      const double rising = distance(wall[0], wall[2]), falling = distance(wall[1], wall[3]);
      const bool is_doubtful = std::fabs(rising - falling) <= kSameLength * falling;
      const bool is_rising = (rising < falling) == (diagonal == Diagonal::Shorter);
      const bool rises = is_doubtful ? rises_in_doubt : is_rising;
      mesh_.add_face(std::array{wall[0], wall[1], wall[rises ? 2 : 3]});
      mesh_.add_face(std::array{wall[rises ? 0 : 1], wall[2], wall[3]});
    }
  }
  void add_bottom(std::uint32_t layer) {
    for (const auto& [a, b, c] : outline_.triangles) {
      mesh_.add_face(std::array{at(layer, a), at(layer, c), at(layer, b)});
    }
  }
  void add_top(std::uint32_t layer) {
    for (const auto& [a, b, c] : outline_.triangles) {
      mesh_.add_face(std::array{at(layer, a), at(layer, b), at(layer, c)});
    }
  }
  Nef3 set(Context& context) const {
    return Nef3::from_mesh(mesh_, {.rule = WindingRule::Positive}, context);
  }

 private:
  static constexpr std::size_t kMostPoints = std::size_t{1} << 30;
  static constexpr std::uint64_t kBytesPerPoint = 160;  // The memory includes the faces at a point.

  /// Charges the memory of one more layer.
  void expect_layer() {
    if (mesh_.points.size() + outline_.corners.size() > kMostPoints) {
      throw Error(ErrorCode::ResourceLimit, "an extrusion has more than 2^30 corners");
    }
    memory_.add(kBytesPerPoint * outline_.corners.size(), "an extrusion");
  }
  std::uint32_t at(std::uint32_t layer, std::uint32_t corner) const {
    return layer * static_cast<std::uint32_t>(outline_.corners.size()) + corner;
  }

  double distance(std::uint32_t i, std::uint32_t j) const {
    const Point3& a = mesh_.points[i];
    const Point3& b = mesh_.points[j];
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  }

  const OutlineMesh& outline_;
  PolygonMesh mesh_;
  MemoryCharge memory_;
};

void require_extrusion(const LinearExtrusion& options) {
  for (const double number : {options.height, options.twist, options.scale[0], options.scale[1]}) {
    if (is_finite(number)) continue;
    throw Error(ErrorCode::NotFinite, "the numbers of an extrusion must be finite");
  }
  if (!(options.height > 0)) {
    throw Error(ErrorCode::BadArgument, "the height of an extrusion must be positive");
  }
  if (!(options.scale[0] >= 0 && options.scale[1] >= 0)) {
    throw Error(ErrorCode::BadArgument, "the scale of an extrusion must not be negative");
  }
  if (options.slices < 1 || options.slices > kMostSlices) {
    throw Error(ErrorCode::BadArgument, "an extrusion must have from 1 to 1048576 slices");
  }
}

/// Returns the side of the line x = 0 on which an outline lies: Negative if no corner has x > 0.
Sign side_of_axis(const PointTable2& corners) {
  bool has_left = false, has_right = false;
  for (std::uint32_t v = 0; v < corners.size(); ++v) {
    has_left = has_left || corners.approx(v).x < 0;
    has_right = has_right || corners.approx(v).x > 0;
  }
  if (has_left && has_right) {
    throw Error(ErrorCode::BadArgument, "the outline lies on both sides of the axis");
  }
  return has_left ? Sign::Negative : Sign::Positive;
}

}  // namespace

Nef3 linear_extrusion(const Nef2& outline, const LinearExtrusion& options, Context& context) {
  require_extrusion(options);
  const OutlineMesh flat = outline_mesh(outline, context);
  if (flat.edges.empty()) return Nef3::empty();
  const double low = options.centred ? -options.height / 2 : 0;
  const bool is_straight = options.twist == 0 && options.scale == std::array<double, 2>{1, 1};
  Sweep sweep(flat, context);
  if (is_straight) {
    for (const double z : {low, low + options.height}) {
      const Rational height = exact_rational(z);
      sweep.add_layer([&](std::uint32_t v) {
        const RationalPoint2 p = flat.corners.exact(v);
        return RationalPoint3{p.x, p.y, height};
      });
    }
    sweep.add_walls(0, 1);
    sweep.add_bottom(0);
    sweep.add_top(1);
    return sweep.set(context);
  }
  for (std::uint32_t i = 0; i <= options.slices; ++i) {
    context.checkpoint("extrusion", i, options.slices);
    const double part = static_cast<double>(i) / options.slices;
    const double cosine = cosine_of_degrees(-options.twist * part);
    const double sine = sine_of_degrees(-options.twist * part);
    const double scale_x = 1 - (1 - options.scale[0]) * part;
    const double scale_y = 1 - (1 - options.scale[1]) * part;
    const double z = low + options.height * part;
    sweep.add_rounded_layer([&](Point2 p) {
      return Point3{scale_x * (p.x * cosine - p.y * sine), scale_y * (p.x * sine + p.y * cosine),
                    z};
    });
    if (i == 0) continue;
    // Towards a segment, the shorter diagonals would leave out the ends of the segment, because two
    // triangles of a wall would lie in one plane, back to back. OpenSCAD 2021.01 takes the longer
    // diagonals, too.
    const bool ends_in_segment = i == options.slices && (scale_x == 0) != (scale_y == 0);
    sweep.add_triangle_walls(i - 1, i, options.twist > 0,
                             ends_in_segment ? Sweep::Diagonal::Longer : Sweep::Diagonal::Shorter);
  }
  sweep.add_bottom(0);
  sweep.add_top(options.slices);
  return sweep.set(context);
}

// The plane of the outline is x and z. Seen along y it is mirrored, so that the first layer looks
// like the top of a linear extrusion. A turn counter-clockwise moves towards positive y.
Nef3 rotational_extrusion(const Nef2& outline, double angle, std::uint32_t steps,
                          Context& context) {
  if (!is_finite(angle)) throw Error(ErrorCode::NotFinite, "the angle of a turn must be finite");
  const bool is_full = !(std::fabs(angle) < 360);
  const double turn = is_full ? 360 : std::fabs(angle);
  if (steps < 1 || steps > kMostSlices) {
    throw Error(ErrorCode::BadArgument, "a turn needs from 1 to 1048576 steps");
  }
  if (!(turn / steps < 180)) {
    throw Error(ErrorCode::BadArgument, "a step of a turn must be less than 180 degrees");
  }
  const OutlineMesh flat = outline_mesh(outline, context);
  if (flat.edges.empty() || angle == 0) return Nef3::empty();
  const Sign side = side_of_axis(flat.corners);
  const bool turns_left = (is_full || angle > 0);
  Sweep sweep(flat, context);
  const std::uint32_t layers = is_full ? steps : steps + 1;
  for (std::uint32_t i = 0; i < layers; ++i) {
    context.checkpoint("turn", i, layers);
    const double at = (is_full ? 180 : 0) + (turns_left ? 1 : -1) * (turn * i / steps);
    const double cosine = cosine_of_degrees(at), sine = sine_of_degrees(at);
    sweep.add_rounded_layer([&](Point2 p) { return Point3{p.x * cosine, p.x * sine, p.y}; });
  }
  // Walls between layers look outward if the later layer is on the side of the bottom.
  const bool is_reverse = turns_left == (side == Sign::Positive);
  const auto join = [&](std::uint32_t i, std::uint32_t j) {
    is_reverse ? sweep.add_triangle_walls(j, i, true) : sweep.add_triangle_walls(i, j, true);
  };
  for (std::uint32_t i = 0; i + 1 < layers; ++i) join(i, i + 1);
  if (is_full) {
    join(layers - 1, 0);
  } else {
    sweep.add_bottom(is_reverse ? layers - 1 : 0);
    sweep.add_top(is_reverse ? 0 : layers - 1);
  }
  return sweep.set(context);
}

}  // namespace plumb
