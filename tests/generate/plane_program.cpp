#include "generate/plane_program.h"

namespace plumb::testing {
namespace {

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
  kFirstOperation
};

// Sets of the plane as SetProgram wants them.
struct PlaneLanguage {
  using Set = PlaneSetPointer;
  using Carrier = CellLine;
  static constexpr int kLeafKinds = kFirstOperation;

  static PlaneSetPointer nothing() { return set_of(SetPoints{}); }

  static void add_carriers(const PlaneSet& set, std::vector<CellLine>& lines) {
    add_lines(set, lines);
    for (CellLine& line : lines) line = undirected(line);
  }

  static Chain chain(ProgramValues values, ProgramRecord points, std::size_t count) {
    Chain result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(program_point(values, points[i]));
    return result;
  }

  static PlaneSetPointer leaf(ProgramValues values, int what, ProgramRecord r) {
    const ProgramRecord points = r.subspan(2);
    const Boundary boundary = r[1] % 2 == 0 ? Boundary::Open : Boundary::Closed;
    const auto rule = static_cast<WindingRule>(r[1] / 2 % 3);
    const std::size_t count = 1 + r[1] / 8 % 6;
    switch (what) {
      case kHalfPlane:
      case kLine:
      case kRay:
        return straight(what, program_point(values, points[0]), program_point(values, points[1]),
                        boundary);
      case kPolygon:
        return set_of(SetPolygons{{chain(values, points, count)}, rule, boundary});
      case kTwoTriangles:
        return set_of(SetPolygons{
            {chain(values, points, 3), chain(values, points.subspan(3), 3)}, rule, boundary});
      case kRectangle:
        return rectangle(program_point(values, points[0]), program_point(values, points[1]), rule,
                         boundary);
      case kPolyline:
        return set_of(SetPolylines{{chain(values, points, count)}});
      default:
        return set_of(SetPoints{chain(values, points, count)});
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
};

class SceneProgram {
 public:
  explicit SceneProgram(ProgramValues values) : values_(values) {}

  void add(ProgramRecord r) {
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
  void add_curve(TestCurve curve, ProgramRecord r) {
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

ExactPoint program_point(ProgramValues values, std::uint8_t byte) {
  const auto x = BigRational(byte & 7U) + BigRational((byte & 8U) == 0 ? 0 : 1, 2);
  const auto y = BigRational((byte >> 4U) & 7U) + BigRational((byte & 128U) == 0 ? 0 : 1, 3);
  return {program_value(values, x, 0), program_value(values, y, 1)};
}

PlaneSetPointer set_of_program(std::span<const std::uint8_t> program, std::size_t max_lines) {
  return SetProgram<PlaneLanguage>(program, max_lines).run();
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
  return random_set_program(dice, values, records, kFirstOperation, 0x33);
}

std::vector<std::uint8_t> wild_program(Dice& dice, std::size_t records) {
  std::vector<std::uint8_t> program(records * kProgramRecord);
  for (std::uint8_t& byte : program) byte = any_byte(dice);
  return program;
}

}  // namespace plumb::testing
