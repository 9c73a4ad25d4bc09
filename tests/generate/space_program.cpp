#include "generate/space_program.h"

#include <algorithm>

#include "generate/space_solids.h"

namespace plumb::testing {
namespace {

// What a record does.
enum What : std::uint8_t {
  kHalfSpace,
  kAxisHalfSpace,
  kPlane,
  kBox,
  kTetrahedron,
  kPrism,
  kTwoBoxes,
  kTriangle,
  kRectangle,
  kChain,
  kPoints,
  kFirstOperation
};

bool are_collinear(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  return cross(b - a, c - a) == ExactPoint3{};
}

// One leaf; null when it has no extent.
class LeafMaker {
 public:
  LeafMaker(ProgramValues values, ProgramRecord record) : how_(record[1]) {
    for (std::size_t i = 0; i < 6; ++i) p_[i] = space_program_point(values, record[2 + i]);
  }

  SpaceSetPointer make(int what) const {
    switch (what) {
      case kHalfSpace:
      case kPlane:
        return slanted(what);
      case kAxisHalfSpace:
        return space_set(HalfSpaceLeaf{upright(), is_closed()});
      case kBox:
        return solid(box_at(0));
      case kTetrahedron:
        return solid(tetrahedron_at(0));
      case kPrism:
        return solid(prism_of_points());
      case kTwoBoxes:
        return solid(how_ < 128 ? two_boxes() : soup());
      case kTriangle:
        return are_collinear(p_[0], p_[1], p_[2]) ? nullptr : flat({{p_[0], p_[1], p_[2]}});
      case kRectangle:
        return rectangle_of_points();
      case kChain:
        return space_set(ChainsLeaf{{first_points()}});
      default:
        return space_set(PointsLeaf{first_points()});
    }
  }

 private:
  bool is_closed() const { return how_ % 2 != 0; }
  std::size_t axis() const { return how_ / 2 % 3; }
  Chain3 first_points() const { return {p_.begin(), p_.begin() + 1 + how_ / 8 % 4}; }

  CellPlane upright() const {
    ExactPoint3 normal;
    coordinate(normal, axis()) = how_ / 8 % 2 == 0 ? 1 : -1;
    return plane_at(p_[0], normal);
  }
  SpaceSetPointer slanted(int what) const {
    if (are_collinear(p_[0], p_[1], p_[2])) return nullptr;
    const CellPlane plane = plane_through(p_[0], p_[1], p_[2]);
    if (what == kPlane) return space_set(PlaneLeaf{plane});
    return space_set(HalfSpaceLeaf{plane, is_closed()});
  }

  std::optional<MeshLeaf> box_at(std::size_t i) const {
    const ExactPoint3& p = p_[i];
    const ExactPoint3& q = p_[i + 1];
    if (p.x == q.x || p.y == q.y || p.z == q.z) return std::nullopt;
    return box(p, q);
  }
  std::optional<MeshLeaf> tetrahedron_at(std::size_t i) const {
    const ExactPoint3 &a = p_[i], &b = p_[i + 1], &c = p_[i + 2], &d = p_[i + 3];
    if (dot(cross(b - a, c - a), d - a) == 0) return std::nullopt;
    return tetrahedron(a, b, c, d);
  }
  std::optional<MeshLeaf> prism_of_points() const {
    const auto [low, high] = std::minmax(coordinate(p_[3], axis()), coordinate(p_[4], axis()));
    const ExactPoint3 normal = cross(p_[1] - p_[0], p_[2] - p_[0]);
    if (low == high || coordinate(normal, axis()) == 0) return std::nullopt;
    return prism({p_[0], p_[1], p_[2]}, axis(), low, high);
  }
  // The second inside the first, beside it or the same, and the other way out or not.
  std::optional<MeshLeaf> two_boxes() const {
    std::optional<MeshLeaf> first = box_at(0);
    if (!first) return first;
    const ExactPoint3 quarter = BigRational(1, 4) * (p_[1] - p_[0]);
    const unsigned where = how_ / 16 % 3;
    MeshLeaf second = where == 0   ? box(p_[0] + quarter, p_[1] - quarter)
                      : where == 1 ? moved(*first, 5 * quarter)
                                   : *first;
    if (how_ / 2 % 2 != 0) second = inside_out(std::move(second));
    MeshLeaf both = together(*first, second);
    both.rule = static_cast<MeshRule>(how_ / 4 % 3);
    return both;
  }
  // One mesh that crosses itself, or two that may cross each other, by all six points.
  std::optional<MeshLeaf> soup() const {
    const bool is_of_boxes = how_ / 4 % 2 != 0;
    std::optional<MeshLeaf> mesh = how_ / 2 % 2 == 0 ? bipyramid()
                                   : is_of_boxes     ? box_at(0)
                                                     : tetrahedron_at(0);
    if (mesh && how_ / 2 % 2 != 0) {
      std::optional<MeshLeaf> second = how_ / 8 % 2 == 0 ? box_at(4) : tetrahedron_at(2);
      if (!second) return second;
      if (how_ / 16 % 2 != 0) second = inside_out(std::move(*second));
      mesh = together(std::move(*mesh), *second);
    }
    if (mesh) mesh->rule = static_cast<MeshRule>(how_ / 32 % 3);
    return mesh;
  }
  // Faces like those of an octahedron, wherever its points are.
  std::optional<MeshLeaf> bipyramid() const {
    MeshLeaf mesh{{p_.begin(), p_.end()}, {}};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      if (are_collinear(p_[i], p_[next], p_[4]) || are_collinear(p_[i], p_[next], p_[5])) return {};
      mesh.faces.push_back({i, next, 4});
      mesh.faces.push_back({next, i, 5});
    }
    return mesh;
  }
  SpaceSetPointer solid(std::optional<MeshLeaf> mesh) const {
    if (!mesh) return nullptr;
    SpaceSetPointer set = space_set(std::move(*mesh));
    return is_closed() ? set : apply(SetOperator::Interior, std::move(set));
  }

  SpaceSetPointer rectangle_of_points() const {
    const ExactPoint3 size = p_[1] - p_[0];
    if (coordinate(size, (axis() + 1) % 3) == 0 || coordinate(size, (axis() + 2) % 3) == 0) {
      return nullptr;
    }
    return flat(rectangle(p_[0], p_[1], axis(), coordinate(p_[2], axis())));
  }
  // With its edges or without them.
  SpaceSetPointer flat(const PolygonLeaf& polygon) const {
    SpaceSetPointer set = space_set(polygon);
    if (is_closed()) return set;
    Chain3 ring = polygon.corners;
    ring.push_back(ring.front());
    return apply(SetOperator::Difference, std::move(set), space_set(ChainsLeaf{{ring}}));
  }

  unsigned how_;
  std::array<ExactPoint3, 6> p_;
};

// Sets of space as SetProgram wants them.
struct SpaceLanguage {
  using Set = SpaceSetPointer;
  using Carrier = CellPlane;
  static constexpr int kLeafKinds = kFirstOperation;

  static SpaceSetPointer leaf(ProgramValues values, int what, ProgramRecord record) {
    return LeafMaker(values, record).make(what);
  }
  static SpaceSetPointer nothing() { return empty_space(); }
  static void add_carriers(const SpaceSet& set, std::vector<CellPlane>& planes) {
    add_planes(set, planes);
    for (CellPlane& plane : planes) plane = unoriented(plane);
  }
};

}  // namespace

ExactPoint3 space_program_point(ProgramValues values, std::uint8_t byte) {
  const BigRational half(byte / 64 % 2, 2);
  const BigRational third(byte / 128, 3);
  return {program_value(values, BigRational(byte % 4) + half, 0),
          program_value(values, BigRational(byte / 4 % 4) + half, 1),
          program_value(values, BigRational(byte / 16 % 4) + third, 2)};
}

SpaceSetPointer space_set_of_program(std::span<const std::uint8_t> program,
                                     std::size_t max_planes) {
  return SetProgram<SpaceLanguage>(program, max_planes).run();
}

std::vector<std::uint8_t> random_space_program(Dice& dice, ProgramValues values,
                                               std::size_t records) {
  return random_set_program(dice, values, records, kFirstOperation, 0x3f);
}

}  // namespace plumb::testing
