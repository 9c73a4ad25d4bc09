#include "generate/model_program.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <utility>

namespace plumb::testing {
namespace {

// What a record does.
enum ModelWhat : std::uint8_t {
  kModelBox,
  kModelHalf,
  kModelHull,
  kModelUnion,
  kModelDifference,
  kModelIntersection,
  kModelMap,
  kModelCopy,
  kModelSwap,
  kModelWhats
};
constexpr std::array<std::uint8_t, 16> kModelWhatOfByte{
    kModelBox,   kModelBox,        kModelBox,        kModelHalf,         kModelHalf, kModelHull,
    kModelUnion, kModelDifference, kModelDifference, kModelIntersection, kModelMap,  kModelMap,
    kModelCopy,  kModelSwap,       kModelUnion,      kModelIntersection};

/// Twice the entries of a linear map.
using HalfMatrix = std::array<std::array<int, 3>, 3>;
constexpr std::array<HalfMatrix, 12> kHalfMatrices{{
    {{{2, 1, 0}, {0, 2, 0}, {0, 0, 2}}},  // Shears.
    {{{2, 0, 0}, {0, 2, 0}, {1, 1, 2}}},
    {{{2, 0, -2}, {0, 2, 0}, {0, 0, 2}}},
    {{{2, -2, 0}, {2, 2, 0}, {0, 0, 2}}},  // Turns by 45 degrees that enlarge.
    {{{1, 0, 1}, {0, 2, 0}, {-1, 0, 1}}},
    {{{2, -1, 0}, {1, 2, 1}, {0, -1, 2}}},
    {{{0, 2, 0}, {0, 0, 2}, {2, 0, 0}}},  // Permutations of axes, with and without a mirror.
    {{{0, -2, 0}, {2, 0, 0}, {0, 0, 2}}},
    {{{-2, 0, 0}, {0, 2, 0}, {0, 0, 2}}},
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}},  // Scales.
    {{{2, 0, 0}, {0, 3, 0}, {0, 0, 1}}},
    {{{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}}},
}};

constexpr int kMostModelMaps = 2;
constexpr std::int64_t kHalf = kModelUnit / 2;
constexpr IntegerPoint kCentre{2 * kModelUnit, 2 * kModelUnit, 2 * kModelUnit};

std::string decimal(std::int64_t units) {
  std::ostringstream text;
  text.precision(17);
  text << static_cast<double>(units) / static_cast<double>(kModelUnit);
  return text.str();
}

/// A linear map followed by a shift, on points in units.
struct UnitMap {
  HalfMatrix matrix{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
  IntegerPoint shift{};

  IntegerPoint operator()(const IntegerPoint& p) const {
    IntegerPoint image = shift;
    for (std::size_t row = 0; row < 3; ++row) {
      std::int64_t twice = 0;
      for (std::size_t i = 0; i < 3; ++i) twice += matrix[row][i] * p[i];
      image[row] += twice / 2;
    }
    return image;
  }
  std::string text() const {
    std::string rows = "multmatrix([";
    for (std::size_t row = 0; row < 3; ++row) {
      rows += "[";
      for (const int entry : matrix[row]) rows += decimal(entry * kHalf) + ", ";
      rows += decimal(shift[row]) + "], ";
    }
    return rows + "[0, 0, 0, 1]])";
  }
  AffineMap3 exact() const {
    AffineMap3 map;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t i = 0; i < 3; ++i) map.matrix[row][i] = Rational(matrix[row][i]) / 2;
      map.offset[row] = Rational(shift[row]) / kModelUnit;
    }
    return map;
  }
};

/// The map with a matrix of the table that keeps a point, or moves it.
UnitMap map_about(std::uint8_t which, const IntegerPoint& from, const IntegerPoint& to) {
  UnitMap map;
  map.matrix = kHalfMatrices[which % kHalfMatrices.size()];
  const IntegerPoint image = map(from);
  for (std::size_t axis = 0; axis < 3; ++axis) map.shift[axis] = to[axis] - image[axis];
  return map;
}

/// A point of the grid of halves from 0 to 3.5, two bits of the byte for x, y, and z, and one bit
/// each for the halves of x and y.
IntegerPoint grid_point(std::uint8_t byte) {
  IntegerPoint p{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    p[axis] = kModelUnit * ((byte >> (2 * axis)) & 3);
    if (axis < 2 && ((byte >> (6 + axis)) & 1) != 0) p[axis] += kHalf;
  }
  return p;
}

/// A box, as a node and as corners.
struct ModelBox {
  std::string text;
  std::vector<IntegerPoint> corners;
};

ModelBox box_of(const IntegerPoint& low, const IntegerPoint& size) {
  ModelBox box;
  UnitMap map;
  map.shift = low;
  box.text = map.text() + " cube(size = [" + decimal(size[0]) + ", " + decimal(size[1]) + ", " +
             decimal(size[2]) + "], center = false);";
  for (unsigned corner = 0; corner < 8; ++corner) {
    IntegerPoint p = low;
    for (std::size_t axis = 0; axis < 3; ++axis) p[axis] += (corner >> axis & 1U) * size[axis];
    box.corners.push_back(p);
  }
  return box;
}

/// A box between two points of the grid; its sizes are at least 1.
ModelBox box_between(std::uint8_t a, std::uint8_t b) {
  const IntegerPoint p = grid_point(a), q = grid_point(b);
  IntegerPoint low{}, size{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(p[axis], q[axis]);
    size[axis] = std::max(std::max(p[axis], q[axis]) - low[axis], kModelUnit);
  }
  return box_of(low, size);
}

Model leaf_of(ModelBox box, int maps) {
  Model leaf;
  leaf.text = std::move(box.text);
  leaf.corners = std::move(box.corners);
  leaf.maps = maps;
  return leaf;
}

void map_corners(Model& model, const UnitMap& map) {
  for (IntegerPoint& p : model.corners) p = map(p);
  for (Model& child : model.children) map_corners(child, map);
}

/// Runs a program.
class ModelProgram {
 public:
  ModelProgram(std::span<const std::uint8_t> program, std::size_t most_planes)
      : program_(program), most_planes_(most_planes) {}

  Model run() {
    for (std::size_t i = kProgramRecord; i + kProgramRecord <= program_.size();
         i += kProgramRecord) {
      if (!step(program_.subspan(i, kProgramRecord))) break;
    }
    if (stack_.empty()) return {Model::Kind::Union, {}, {}, {}, {}, 0};
    constexpr std::array kLast{Model::Kind::Union, Model::Kind::Difference,
                               Model::Kind::Intersection};
    combine(kLast[program_[1] % kLast.size()], stack_.size());
    return std::move(stack_[0]);
  }

 private:
  /// Returns whether the program goes on.
  bool step(ProgramRecord r) {
    switch (kModelWhatOfByte[r[0] % kModelWhatOfByte.size()]) {
      case kModelBox:
        return push(leaf_of(box_between(r[2], r[3]), 0));
      case kModelHalf:
        return push(half_of(r));
      case kModelHull:
        return push(hull_leaf(r));
      case kModelMap:
        add_map(r);
        break;
      case kModelCopy:
        return stack_.empty() || push(Model(stack_[r[1] % stack_.size()]));
      case kModelSwap:
        if (stack_.size() >= 2) std::swap(stack_.back(), stack_[stack_.size() - 2]);
        break;
      case kModelUnion:
        combine(Model::Kind::Union, 2 + r[1] % 2U);
        break;
      case kModelDifference:
        combine(Model::Kind::Difference, 2 + r[1] % 2U);
        break;
      default:
        combine(Model::Kind::Intersection, 2 + r[1] % 2U);
    }
    return stack_.size() <= 12;
  }

  bool push(Model model) {
    planes_ += planes_of(model);
    if (planes_ > most_planes_) return false;
    stack_.push_back(std::move(model));
    return true;
  }

  /// Returns the sum of the numbers of planes of all leaves.
  static std::size_t planes_of(const Model& model) {
    if (model.kind == Model::Kind::Leaf) {
      return ModelPlanes().hull_of(model.corners).planes.count();
    }
    std::size_t sum = 0;
    for (const Model& child : model.children) sum += planes_of(child);
    return sum;
  }

  /// A big box with one face through a point of the grid.
  static Model half_of(ProgramRecord r) {
    constexpr std::int64_t kSize = 32 * kModelUnit;
    ModelBox box = box_of({0, -kSize / 2, -kSize / 2}, {kSize, kSize, kSize});
    const UnitMap map = map_about(r[1], {0, 0, 0}, grid_point(r[2]));
    for (IntegerPoint& p : box.corners) p = map(p);
    box.text = map.text() + " { " + box.text + " }";
    return leaf_of(std::move(box), 1);
  }

  static Model hull_leaf(ProgramRecord r) {
    ModelBox a = box_between(r[2], r[3]);
    const ModelBox b = box_between(r[4], r[5]);
    a.text = "hull() { " + a.text + " " + b.text + " }";
    a.corners.insert(a.corners.end(), b.corners.begin(), b.corners.end());
    return leaf_of(std::move(a), 0);
  }

  void add_map(ProgramRecord r) {
    if (stack_.empty() || stack_.back().maps >= kMostModelMaps) return;
    const UnitMap map = map_about(r[1], kCentre, r[2] < 128 ? kCentre : grid_point(r[3]));
    Model mapped{Model::Kind::Map, map.text(), map.exact(), {}, {}, stack_.back().maps + 1};
    map_corners(stack_.back(), map);
    mapped.children.push_back(std::move(stack_.back()));
    stack_.back() = std::move(mapped);
  }

  void combine(Model::Kind kind, std::size_t count) {
    if (stack_.size() < count || count < 2) return;
    Model made{kind, {}, {}, {}, {}, 0};
    const auto first = stack_.end() - static_cast<std::ptrdiff_t>(count);
    for (auto child = first; child != stack_.end(); ++child) {
      made.maps = std::max(made.maps, child->maps);
      made.children.push_back(std::move(*child));
    }
    stack_.erase(first, stack_.end());
    stack_.push_back(std::move(made));
  }

  std::span<const std::uint8_t> program_;
  std::size_t most_planes_;
  std::size_t planes_ = 0;
  std::vector<Model> stack_;
};

}  // namespace

Model model_of_program(std::span<const std::uint8_t> program, std::size_t most_planes) {
  return ModelProgram(program, most_planes).run();
}

std::string text_of_model(const Model& model) {
  if (model.kind == Model::Kind::Leaf) return model.text + "\n";
  const std::string head = model.kind == Model::Kind::Map          ? model.text
                           : model.kind == Model::Kind::Union      ? "union()"
                           : model.kind == Model::Kind::Difference ? "difference()"
                                                                   : "intersection()";
  std::string text = head + " {\n";
  for (const Model& child : model.children) text += text_of_model(child);
  return text + "}\n";
}

Model shuffled(const Model& model, Dice& dice) {
  Model other = model;
  for (Model& child : other.children) child = shuffled(child, dice);
  const std::size_t kept = model.kind == Model::Kind::Difference ? 1 : 0;
  for (std::size_t i = other.children.size(); i > kept + 1; --i) {
    std::swap(other.children[i - 1], other.children[kept + dice.below(i - kept)]);
  }
  return other;
}

std::vector<std::uint8_t> random_model_program(Dice& dice, std::size_t records) {
  std::vector<std::uint8_t> program(kProgramRecord);
  program[1] = any_byte(dice);
  for (std::size_t i = 0; i < records; ++i) {
    const bool is_leaf = i < 2 || dice.below(5) < 2;
    program.push_back(static_cast<std::uint8_t>(is_leaf ? dice.below(6) : 6 + dice.below(10)));
    for (int k = 1; k < 8; ++k) program.push_back(any_byte(dice));
  }
  return program;
}

}  // namespace plumb::testing
