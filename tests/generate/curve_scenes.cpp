#include "generate/curve_scenes.h"

#include <algorithm>

namespace plumb::testing {
namespace {

BigRational cross_of_segments(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                              const ExactPoint& d) {
  return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
}

bool lies_on_line(const ExactPoint& p, const TestCurve& curve) {
  return cross_of_segments(curve.a, curve.b, curve.a, p) == 0;
}

// Does q come after p on the curve's line?
bool is_after(const TestCurve& curve, const ExactPoint& p, const ExactPoint& q) {
  return curve.a < curve.b ? p < q : q < p;
}

class SceneMaker {
 public:
  SceneMaker(SceneKind kind, std::uint64_t seed)
      : dice_(seed), kind_(kind), range_(dice_.between(1, 6)) {
    for (ExactPoint& centre : centres_) centre = any_point();
  }

  CurveScene run(std::uint32_t curves) {
    while (scene_.curves.size() < curves) scene_.curves.push_back(any_curve());
    for (std::uint32_t i = 0; i < curves; ++i) {
      if (dice_.below(3) == 0) cut(scene_.curves[i]);
    }
    for (std::int64_t i = dice_.between(0, 2); i > 0; --i) scene_.isolated.push_back(any_point());
    return std::move(scene_);
  }

 private:
  BigRational any_coordinate() {
    const std::int64_t small = dice_.between(-range_, range_);
    if (kind_ == SceneKind::Fractions) return BigRational(small, dice_.below(2) == 0 ? 3 : 7);
    if (kind_ == SceneKind::Wild && dice_.below(2) == 0) {
      return small * power_of_two(static_cast<int>(dice_.between(-1000, 1000)));
    }
    return small;
  }
  ExactPoint any_point() { return {any_coordinate(), any_coordinate()}; }

  TestCurve any_curve() {
    const ExactPoint a = kind_ == SceneKind::Concurrent ? centres_[dice_.below(2)] : any_point();
    const ExactPoint b = any_point();
    if (a == b) return {a, b, a, b};
    switch (dice_.below(4)) {
      case 0:
        return {a, b, a, std::nullopt};
      case 1:
        return {a, b, std::nullopt, b};
      case 2:
        return {a, b, std::nullopt, std::nullopt};
      default:
        return {a, b, a, b};
    }
  }

  // Moves one end to the crossing with another line.
  void cut(TestCurve& curve) {
    const TestCurve& other = scene_.curves[dice_.below(scene_.curves.size())];
    if (curve.is_point() || other.is_point()) return;
    const std::optional<ExactPoint> stop = crossing_of(curve, other);
    if (!stop) return;
    if (dice_.below(2) == 0) {
      if (!curve.to || is_after(curve, *stop, *curve.to)) curve.from = stop;
    } else {
      if (!curve.from || is_after(curve, *curve.from, *stop)) curve.to = stop;
    }
  }

  Dice dice_;
  SceneKind kind_;
  std::int64_t range_;
  ExactPoint centres_[2];
  CurveScene scene_;
};

class SceneLoader {
 public:
  SceneLoader(const CurveScene& scene, std::uint64_t seed) : scene_(scene), dice_(seed) {}

  EngineScene run() {
    for (const TestCurve& curve : scene_.curves) {
      result_.curves.push_back({0, 0, input(curve.a), input(curve.b)});
    }
    for (const TestCurve& curve : scene_.curves) {
      for (const auto& end : {curve.from, curve.to}) {
        if (end) input(*end);
      }
    }
    for (const ExactPoint& p : scene_.isolated) result_.isolated.push_back(input(p));
    for (std::size_t i = 0; i < scene_.curves.size(); ++i) {
      result_.curves[i].from = end_of(i, scene_.curves[i].from);
      result_.curves[i].to = end_of(i, scene_.curves[i].to);
    }
    return std::move(result_);
  }

 private:
  std::uint32_t input(const ExactPoint& p) {
    const auto found = std::find(places_.begin(), places_.end(), p);
    if (found != places_.end() && dice_.below(2) == 0) {
      return static_cast<std::uint32_t>(found - places_.begin());
    }
    places_.push_back(p);
    add_point(result_.points.inputs, p);
    return static_cast<std::uint32_t>(places_.size() - 1);
  }

  // The inputs are complete by now.
  std::uint32_t end_of(std::size_t i, const std::optional<ExactPoint>& end) {
    if (!end) return SweepCurve::kUnbounded;
    if (!scene_.curves[i].is_point() && dice_.below(2) == 0) {
      for (std::size_t j = 0; j < scene_.curves.size(); ++j) {
        if (is_crossing(i, j, *end)) return add_crossing(result_.curves[i], result_.curves[j]);
      }
    }
    const auto found = std::find(places_.begin(), places_.end(), *end);
    return static_cast<std::uint32_t>(found - places_.begin());
  }

  bool is_crossing(std::size_t i, std::size_t j, const ExactPoint& p) const {
    const TestCurve& other = scene_.curves[j];
    return !other.is_point() && lies_on_line(p, other) && crossing_of(scene_.curves[i], other);
  }

  std::uint32_t add_crossing(const SweepCurve& s, const SweepCurve& t) {
    result_.points.crossings.push_back(make_crossing(result_.points.inputs, s.a, s.b, t.a, t.b));
    return static_cast<std::uint32_t>(result_.points.size() - 1);
  }

  const CurveScene& scene_;
  Dice dice_;
  std::vector<ExactPoint> places_;
  EngineScene result_;
};

std::string to_text(const std::optional<ExactPoint>& p) {
  return p ? "(" + p->x.str() + "," + p->y.str() + ")" : "infinity";
}

}  // namespace

bool TestCurve::contains(const ExactPoint& p) const {
  if (is_point()) return p == *from;
  return lies_on_line(p, *this) && (!from || !is_after(*this, p, *from)) &&
         (!to || !is_after(*this, *to, p));
}

std::optional<ExactPoint> crossing_of(const TestCurve& s, const TestCurve& t) {
  const BigRational w = cross_of_segments(s.a, s.b, t.a, t.b);
  if (w == 0) return std::nullopt;
  const BigRational u = cross_of_segments(s.a, t.a, t.a, t.b) / w;
  return ExactPoint{s.a.x + u * (s.b.x - s.a.x), s.a.y + u * (s.b.y - s.a.y)};
}

void add_point(PointTable2& points, const ExactPoint& p) {
  Point2 rounded;
  if (as_double(p.x, rounded.x) && as_double(p.y, rounded.y)) {
    points.push_back(rounded);
  } else {
    points.push_back(to_rational(p.x), to_rational(p.y));
  }
}

CurveScene random_curves(SceneKind kind, std::uint32_t curves, std::uint64_t seed) {
  return SceneMaker(kind, seed).run(curves);
}

EngineScene to_engine(const CurveScene& scene, std::uint64_t seed) {
  return SceneLoader(scene, seed).run();
}

std::string to_text(const CurveScene& scene) {
  std::string text;
  for (const TestCurve& c : scene.curves) {
    text += to_text(c.a) + " -> " + to_text(c.b) + " from " + to_text(c.from) + " to " +
            to_text(c.to) + "\n";
  }
  for (const ExactPoint& p : scene.isolated) text += "point " + to_text(std::optional(p)) + "\n";
  return text;
}

}  // namespace plumb::testing
