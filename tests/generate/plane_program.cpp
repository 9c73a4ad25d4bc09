#include "generate/plane_program.h"

#include <algorithm>

namespace plumb::testing {
namespace {

using Record = std::span<const std::uint8_t>;

// What a record does.
enum What : std::uint8_t {
  kHalfPlane,
  kLine,
  kRay,
  kPolygon,
  kTwoTriangles,
  kRectangle,
  kPolyline,
  kPoints,
  kFirstOperation,
  kCopy = kFirstOperation + 10,  // the operations are those of SetOperator
  kSwap,
  kWhats
};

class StackMachine {
 public:
  StackMachine(std::span<const std::uint8_t> program, std::size_t max_lines)
      : program_(program), max_lines_(max_lines) {}

  PlaneSetPointer run() {
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
    if (what < kFirstOperation) return push(leaf(r));
    if (what == kCopy) {
      if (!stack_.empty()) stack_.push_back(stack_[r[1] % stack_.size()]);
    } else if (what == kSwap) {
      if (stack_.size() >= 2) std::swap(stack_.back(), stack_[stack_.size() - 2]);
    } else {
      operate(static_cast<SetOperator>(what - kFirstOperation));
    }
    return stack_.size() <= 16;
  }

  bool push(const PlaneSetPointer& set) {
    if (!set) return true;
    std::vector<CellLine> lines = lines_;
    add_lines(*set, lines);
    for (CellLine& line : lines) line = undirected(line);
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    if (lines.size() > max_lines_) return false;
    lines_ = std::move(lines);
    stack_.push_back(set);
    return true;
  }

  void operate(SetOperator op) {
    if (stack_.size() < (is_binary(op) ? 2U : 1U)) return;
    PlaneSetPointer last = std::move(stack_.back());
    stack_.pop_back();
    if (!is_binary(op)) {
      stack_.push_back(apply(op, std::move(last)));
    } else {
      stack_.back() = apply(op, stack_.back(), std::move(last));
    }
  }

  PlaneSetPointer folded() {
    const auto op = static_cast<SetOperator>(program_.size() < 2 ? 0 : program_[1] % 4);
    while (stack_.size() > 1) operate(op);
    return stack_.empty() ? set_of(SetPoints{}) : stack_.back();
  }

  ExactPoint point(std::uint8_t byte) const { return program_point(values_, byte); }

  Chain chain(Record points, std::size_t count) const {
    Chain result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(point(points[i]));
    return result;
  }

  PlaneSetPointer leaf(Record r) const {
    const Record points = r.subspan(2);
    const Boundary boundary = r[1] % 2 == 0 ? Boundary::Open : Boundary::Closed;
    const auto rule = static_cast<WindingRule>(r[1] / 2 % 3);
    const std::size_t count = 1 + r[1] / 8 % 6;
    switch (r[0] % kWhats) {
      case kHalfPlane:
      case kLine:
      case kRay:
        return straight(r[0] % kWhats, point(points[0]), point(points[1]), boundary);
      case kPolygon:
        return set_of(SetPolygons{{chain(points, count)}, rule, boundary});
      case kTwoTriangles:
        return set_of(SetPolygons{{chain(points, 3), chain(points.subspan(3), 3)}, rule, boundary});
      case kRectangle:
        return rectangle(point(points[0]), point(points[1]), rule, boundary);
      case kPolyline:
        return set_of(SetPolylines{{chain(points, count)}});
      default:
        return set_of(SetPoints{chain(points, count)});
    }
  }

  static PlaneSetPointer straight(int what, const ExactPoint& a, const ExactPoint& b,
                                  Boundary boundary) {
    if (a == b) return nullptr;
    if (what == kHalfPlane) return set_of(SetHalfPlane{a, b, boundary});
    if (what == kLine) return set_of(SetLine{a, b});
    return set_of(SetRay{a, b, boundary});
  }

  static PlaneSetPointer rectangle(const ExactPoint& p, const ExactPoint& q, WindingRule rule,
                                   Boundary boundary) {
    const Chain corners{p, {q.x, p.y}, q, {p.x, q.y}};
    return set_of(SetPolygons{{corners}, rule, boundary});
  }

  std::span<const std::uint8_t> program_;
  std::size_t max_lines_;
  ProgramValues values_ = ProgramValues::Plain;
  std::vector<CellLine> lines_;
  std::vector<PlaneSetPointer> stack_;
};

std::uint8_t any_byte(Dice& dice) { return static_cast<std::uint8_t>(dice.below(256)); }

std::uint8_t any_grid_point(Dice& dice) {
  const std::uint8_t mask = dice.below(16) == 0 ? 0xff : 0x33;
  return any_byte(dice) & mask;
}

class SceneProgram {
 public:
  explicit SceneProgram(ProgramValues values) : values_(values) {}

  void add(Record r) {
    const ExactPoint a = program_point(values_, r[2]);
    const ExactPoint b = program_point(values_, r[3]);
    if (r[0] % 8 == 0) {
      scene_.isolated.push_back(a);
    } else if (a == b) {
      scene_.curves.push_back({a, b, a, b});
    } else {
      add_curve({a, b, std::nullopt, std::nullopt}, r);
    }
  }

  CurveScene result() { return std::move(scene_); }
  std::size_t size() const { return scene_.curves.size() + scene_.isolated.size(); }

 private:
  // Each end: at infinity, at a or b, or at the crossing with another curve.
  void add_curve(TestCurve curve, Record r) {
    curve.from = end_of(curve, r[1] % 4, r[4], curve.a);
    curve.to = end_of(curve, r[1] / 4 % 4, r[5], curve.b);
    const bool backward =
        curve.from && curve.to && (*curve.to < *curve.from) == (curve.a < curve.b);
    if (backward) std::swap(curve.from, curve.to);
    if (curve.is_point()) curve.a = curve.b = *curve.from;
    scene_.curves.push_back(curve);
  }

  std::optional<ExactPoint> end_of(const TestCurve& curve, int how, std::uint8_t which,
                                   const ExactPoint& own) const {
    if (how == 0) return std::nullopt;
    if (how != 3 || scene_.curves.empty()) return own;
    const TestCurve& other = scene_.curves[which % scene_.curves.size()];
    return other.is_point() ? std::nullopt : crossing_of(curve, other);
  }

  ProgramValues values_;
  CurveScene scene_;
};

}  // namespace

BigRational program_value(ProgramValues values, const BigRational& v, int axis) {
  static const BigInt kTen30 = boost::multiprecision::pow(BigInt(10), 30);
  switch (values) {
    case ProgramValues::Tenths:
      return exact_of(0.1 * v.convert_to<double>());
    case ProgramValues::Thirds:
      return v / 3;
    case ProgramValues::Far:
      return v + power_of_two(60);
    case ProgramValues::Large:
      return v * power_of_two(1000);
    case ProgramValues::Small:
      return v * power_of_two(-1060);
    case ProgramValues::Uneven:
      return v * power_of_two(axis == 0 ? -500 : axis == 1 ? 500 : 0);
    case ProgramValues::Long:
      return v * BigRational(kTen30 + 1, kTen30 + 7);
    default:
      return v;
  }
}

ExactPoint program_point(ProgramValues values, std::uint8_t byte) {
  const auto x = BigRational(byte & 7U) + BigRational((byte & 8U) == 0 ? 0 : 1, 2);
  const auto y = BigRational((byte >> 4U) & 7U) + BigRational((byte & 128U) == 0 ? 0 : 1, 3);
  return {program_value(values, x, 0), program_value(values, y, 1)};
}

PlaneSetPointer set_of_program(std::span<const std::uint8_t> program, std::size_t max_lines) {
  return StackMachine(program, max_lines).run();
}

CurveScene scene_of_program(std::span<const std::uint8_t> program, std::size_t max_curves) {
  SceneProgram scene(static_cast<ProgramValues>(program.empty() ? 0 : program[0] % kProgramValues));
  for (std::size_t i = kProgramRecord;
       i + kProgramRecord <= program.size() && scene.size() < max_curves; i += kProgramRecord) {
    scene.add(program.subspan(i, kProgramRecord));
  }
  return scene.result();
}

std::vector<std::uint8_t> random_program(Dice& dice, ProgramValues values, std::size_t records) {
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

std::vector<std::uint8_t> wild_program(Dice& dice, std::size_t records) {
  std::vector<std::uint8_t> program(records * kProgramRecord);
  for (std::uint8_t& byte : program) byte = any_byte(dice);
  return program;
}

}  // namespace plumb::testing
