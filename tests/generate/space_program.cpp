#include "generate/space_program.h"

#include <algorithm>

#include "generate/space_solids.h"

namespace plumb::testing {
namespace {

using Record = std::span<const std::uint8_t>;

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
  kFirstOperation,
  kCopy = kFirstOperation + kSetOperators,  // the operations are those of SetOperator
  kSwap,
  kWhats
};

bool are_collinear(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  return cross(b - a, c - a) == ExactPoint3{};
}

// One leaf; null when it has no extent.
class LeafMaker {
 public:
  LeafMaker(ProgramValues values, Record record) : how_(record[1]) {
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
        return solid(tetrahedron_of_points());
      case kPrism:
        return solid(prism_of_points());
      case kTwoBoxes:
        return solid(two_boxes());
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
  std::optional<MeshLeaf> tetrahedron_of_points() const {
    if (dot(cross(p_[1] - p_[0], p_[2] - p_[0]), p_[3] - p_[0]) == 0) return std::nullopt;
    return tetrahedron(p_[0], p_[1], p_[2], p_[3]);
  }
  std::optional<MeshLeaf> prism_of_points() const {
    const auto [low, high] = std::minmax(coordinate(p_[3], axis()), coordinate(p_[4], axis()));
    const ExactPoint3 normal = cross(p_[1] - p_[0], p_[2] - p_[0]);
    if (low == high || coordinate(normal, axis()) == 0) return std::nullopt;
    return prism({p_[0], p_[1], p_[2]}, axis(), low, high);
  }
  // The second inside the first, beside it or the same, and the other way out or not. Just the first
  // where doubles do not say where they are: such meshes are convex (engine_nef3.cpp).
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
    return has_double_coordinates(both) ? both : first;
  }
  static bool has_double_coordinates(const MeshLeaf& mesh) {
    Point3 rounded;
    return std::all_of(mesh.points.begin(), mesh.points.end(),
                       [&](const ExactPoint3& p) { return as_double(p, rounded); });
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

class StackMachine {
 public:
  StackMachine(std::span<const std::uint8_t> program, std::size_t max_planes)
      : program_(program), max_planes_(max_planes) {}

  SpaceSetPointer run() {
    if (program_.size() >= 2) {
      values_ = static_cast<ProgramValues>(program_[0] % kProgramValues);
    }
    for (std::size_t i = kProgramRecord; i + kProgramRecord <= program_.size();
         i += kProgramRecord) {
      if (!step(program_.subspan(i, kProgramRecord))) break;
    }
    return folded();
  }

 private:
  bool step(Record r) {
    const int what = r[0] % kWhats;
    if (what < kFirstOperation) return push(LeafMaker(values_, r).make(what));
    if (what == kCopy) {
      if (!stack_.empty()) stack_.push_back(stack_[r[1] % stack_.size()]);
    } else if (what == kSwap) {
      if (stack_.size() >= 2) std::swap(stack_.back(), stack_[stack_.size() - 2]);
    } else {
      operate(static_cast<SetOperator>(what - kFirstOperation));
    }
    return stack_.size() <= 16;
  }

  bool push(const SpaceSetPointer& set) {
    if (!set) return true;
    std::vector<CellPlane> planes = planes_;
    add_planes(*set, planes);
    for (CellPlane& plane : planes) plane = unoriented(plane);
    std::sort(planes.begin(), planes.end());
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    if (planes.size() > max_planes_) return false;
    planes_ = std::move(planes);
    stack_.push_back(set);
    return true;
  }

  void operate(SetOperator op) {
    if (stack_.size() < (is_binary(op) ? 2U : 1U)) return;
    SpaceSetPointer last = std::move(stack_.back());
    stack_.pop_back();
    if (!is_binary(op)) {
      stack_.push_back(apply(op, std::move(last)));
    } else {
      stack_.back() = apply(op, stack_.back(), std::move(last));
    }
  }

  SpaceSetPointer folded() {
    const auto op = static_cast<SetOperator>(program_.size() < 2 ? 0 : program_[1] % 4);
    while (stack_.size() > 1) operate(op);
    return stack_.empty() ? empty_space() : stack_.back();
  }

  std::span<const std::uint8_t> program_;
  std::size_t max_planes_;
  ProgramValues values_ = ProgramValues::Plain;
  std::vector<CellPlane> planes_;
  std::vector<SpaceSetPointer> stack_;
};

std::uint8_t any_byte(Dice& dice) { return static_cast<std::uint8_t>(dice.below(256)); }

std::uint8_t any_grid_point(Dice& dice) {
  const std::uint8_t mask = dice.below(16) == 0 ? 0xff : 0x3f;
  return any_byte(dice) & mask;
}

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
  return StackMachine(program, max_planes).run();
}

std::vector<std::uint8_t> random_space_program(Dice& dice, ProgramValues values,
                                               std::size_t records) {
  std::vector<std::uint8_t> program{static_cast<std::uint8_t>(values), any_byte(dice)};
  program.resize(kProgramRecord);
  for (std::size_t i = 0; i < records; ++i) {
    const bool is_leaf = i < 2 || dice.below(5) < 3;
    program.push_back(static_cast<std::uint8_t>(
        is_leaf ? dice.below(kFirstOperation)
                : kFirstOperation + dice.below(kWhats - kFirstOperation)));
    program.push_back(any_byte(dice));
    for (int p = 0; p < 6; ++p) program.push_back(any_grid_point(dice));
  }
  return program;
}

}  // namespace plumb::testing
