#include "oracle/surface_oracle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>

#include "generate/surface_scenes.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/rounding.h"
#include "plumb/surface/surface_audit.h"

namespace plumb::testing {
namespace {

using Label = std::map<std::uint32_t, std::int64_t>;

struct Cell {
  Label label;
  double area = 0;
};

std::string to_text(const Label& label) {
  std::ostringstream text;
  for (const auto& [polygon, value] : label) text << " " << polygon << ":" << value;
  return text.str();
}

// ---------------------------------------------------------------- the plane

class PlaneCells {
 public:
  explicit PlaneCells(const FlatScene& scene) {
    add_polygon(frame_of(scene));
    for (const auto& polygon : scene.polygons) add_polygon(polygon);
    Context context;
    arrangement_ = arrange(points_, segments_, context);
    dcel_ = &arrangement_.complex.dcel;
    add_multiplicities();
    join_faces();
    label_faces();
  }

  /// Sorted by label, then area.
  std::vector<Cell> cells() {
    std::map<std::uint32_t, Cell> by_root;
    for (std::uint32_t f = 1; f < dcel_->face_count(); ++f) {
      Cell& cell = by_root[root(f)];
      cell.label = label_[f];
      cell.area += nearest_double(*face_area(arrangement_.complex, FaceId(f)));
    }
    std::vector<Cell> cells;
    for (auto& [r, cell] : by_root) cells.push_back(std::move(cell));
    return cells;
  }

 private:
  static std::vector<RationalPoint2> frame_of(const FlatScene& scene) {
    const Rational x = scene.columns, y = scene.rows;
    return {{0, 0}, {x, 0}, {x, y}, {0, y}};
  }
  void add_polygon(const std::vector<RationalPoint2>& polygon) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (const RationalPoint2& p : polygon) points_.push_back(p.x, p.y);
    for (std::uint32_t i = 0; i < n; ++i) {
      if (polygon[i] == polygon[(i + 1) % n]) continue;
      segments_.push_back({first + i, first + (i + 1) % n});
      polygon_of_.push_back(polygons_);
    }
    ++polygons_;
  }

  /// Per edge what runs along its half-edge 2 e; polygon 0 is the frame.
  void add_multiplicities() {
    const PlanePointsView points(arrangement_.complex.points);
    for (std::uint32_t e = 0; e < arrangement_.complex.edge_count(); ++e) {
      const HalfedgeId h(std::size_t{2} * e);
      const auto at = [&](VertexId v) { return arrangement_.complex.vertex_point[v.value()]; };
      const Sign way = compare_xy(points, at(dcel_->origin(h)), at(dcel_->target(h)));
      Label& sum = sum_.emplace_back();
      for (const SegmentId s : arrangement_.origins_of(EdgeId(e))) {
        const SweepSegment& segment = segments_[s.value()];
        const Sign other = compare_xy(points_, segment.from, segment.to);
        sum[polygon_of_[s.value()]] += way == other ? 1 : -1;
      }
      std::erase_if(sum, [](const auto& entry) { return entry.second == 0; });
    }
  }
  std::uint32_t root(std::uint32_t f) const {
    while (joined_[f] != f) f = joined_[f];
    return f;
  }
  std::uint32_t face(std::size_t h) const { return dcel_->face(HalfedgeId(h)).value(); }
  void join_faces() {
    joined_.resize(dcel_->face_count());
    std::iota(joined_.begin(), joined_.end(), 0U);
    for (std::size_t e = 0; e < sum_.size(); ++e) {
      if (sum_[e].empty()) joined_[root(face(2 * e))] = root(face(2 * e + 1));
    }
  }

  void label_faces() {
    std::vector<std::optional<Label>> winding(dcel_->face_count());
    winding[0] = Label();
    for (bool changes = true; changes;) {
      changes = false;
      for (std::size_t h = 0; h < 2 * sum_.size(); ++h) {
        if (!winding[face(h)] || winding[face(h ^ 1U)]) continue;
        changes = true;
        Label label = *winding[face(h)];
        for (const auto& [polygon, m] : sum_[h / 2]) label[polygon] -= h % 2 == 0 ? m : -m;
        winding[face(h ^ 1U)] = label;
      }
    }
    Label least;  // at the frame
    for (std::size_t h = 0; h < 2 * sum_.size(); ++h) {
      if (!sum_[h / 2].contains(0) || face(h) == 0) continue;
      for (std::uint32_t p = 1; p < polygons_; ++p) {
        const std::int64_t value = (*winding[face(h)])[p];
        const auto [at, is_new] = least.emplace(p, value);
        if (!is_new) at->second = std::min(at->second, value);
      }
    }
    for (const auto& label : winding) {
      Label shifted;
      for (std::uint32_t p = 1; p < polygons_; ++p) {
        Label known = *label;
        if (known[p] != least[p]) shifted[p - 1] = known[p] - least[p];
      }
      label_.push_back(shifted);
    }
  }

  PointTable2 points_;
  std::vector<SweepSegment> segments_;
  std::vector<std::uint32_t> polygon_of_;
  std::uint32_t polygons_ = 0;
  Arrangement arrangement_;
  const Dcel* dcel_ = nullptr;
  std::vector<Label> sum_;
  std::vector<std::uint32_t> joined_;
  std::vector<Label> label_;
};

// ---------------------------------------------------------------- comparing

void sort_cells(std::vector<Cell>& cells) {
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return std::tie(a.label, a.area) < std::tie(b.label, b.area);
  });
}

std::vector<Cell> cells_of(const SurfaceDivision& division) {
  std::vector<Cell> cells;
  for (std::uint32_t c = 0; c < division.cell_count(); ++c) {
    Cell& cell = cells.emplace_back();
    for (const SignedEntry& e : division.labels(CellId(c))) cell.label[e.id] = e.value;
    cell.area = division.area(CellId(c));
  }
  return cells;
}

bool is_near(double a, double b) { return std::fabs(a - b) <= 1e-9; }

std::string difference(std::vector<Cell> expected, std::vector<Cell> found) {
  sort_cells(expected);
  sort_cells(found);
  std::ostringstream text;
  if (expected.size() != found.size()) {
    text << expected.size() << " cells expected, " << found.size() << " found";
  } else {
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (expected[i].label == found[i].label && is_near(expected[i].area, found[i].area)) continue;
      text << "cell" << to_text(expected[i].label) << " of " << expected[i].area << " expected,"
           << to_text(found[i].label) << " of " << found[i].area << " found";
      break;
    }
  }
  return text.str();
}

RationalPoint2 flat_position(const SurfacePointTable& points, SurfacePointId p, FaceId f) {
  const RationalPoint2 uv = points.exact_in(p, f);
  const auto corner = [&](std::size_t i) {
    const Point3& q = points.mesh().point(points.mesh().corner(f, i));
    return RationalPoint2{exact_rational(q.x), exact_rational(q.y)};
  };
  const RationalPoint2 a = corner(0), b = corner(1), c = corner(2);
  return {a.x + uv.x * (b.x - a.x) + uv.y * (c.x - a.x),
          a.y + uv.x * (b.y - a.y) + uv.y * (c.y - a.y)};
}

Nef2 nef_of(const std::vector<std::vector<RationalPoint2>>& polygons, WindingRule rule) {
  PointTable2 points;
  std::vector<std::uint32_t> corners, begin = {0};
  for (const auto& polygon : polygons) {
    for (const RationalPoint2& p : polygon) {
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p.x, p.y);
    }
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  Context context;
  return Nef2::polygons(points, corners, begin, rule, Boundary::Closed, context).regularization();
}

std::vector<std::vector<RationalPoint2>> flat_polygons(const SurfacePolygons& polygons) {
  std::vector<std::vector<RationalPoint2>> flat;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    auto& polygon = flat.emplace_back();
    for (std::uint32_t i = polygons.begin[p]; i < polygons.begin[p + 1]; ++i) {
      polygon.push_back(flat_position(polygons.points, polygons.point[i], polygons.face[i]));
    }
  }
  return flat;
}

/// Labels of plane and surface agree where no polygon runs along the mesh border against its label.
bool stays_inside(const FlatScene& scene) {
  for (const auto& polygon : scene.polygons) {
    for (const RationalPoint2& p : polygon) {
      if (p.x <= 0 || p.y <= 0 || p.x >= scene.columns || p.y >= scene.rows) return false;
    }
  }
  return true;
}

std::string region_difference(const SurfaceDivision& division, const FlatScene& scene,
                              const char* text) {
  const SetExpression expression = parse_set_expression(text);
  const WindingRule rule = WindingRule::EvenOdd;
  const auto flat = [&](std::uint32_t name) {
    const auto shape = static_cast<std::size_t>(expression.names[name][0] - 'A');
    return nef_of({scene.polygons[shape]}, rule);
  };
  const Rational x = scene.columns, y = scene.rows;
  const Nef2 frame = nef_of({{{0, 0}, {x, 0}, {x, y}, {0, y}}}, rule);
  const Nef2 expected = evaluate<Nef2>(
                            expression, flat, [&](const Nef2& a) { return frame - a; },
                            [](SetOperator op, const Nef2& a, const Nef2& b) {
                              if (op == SetOperator::Intersection) return a * b;
                              if (op == SetOperator::Union) return a + b;
                              if (op == SetOperator::Difference) return a - b;
                              return a ^ b;
                            })
                            .regularization();
  const SurfaceResult result = division.evaluate(expression, rule);
  const double area = nearest_double(*expected.area());
  if (!is_near(area, result.region.area)) return std::string(text) + ": another area";
  auto loops = flat_polygons(result.borders);
  for (const auto& loop : loops) {
    if (loop.size() < 3) return std::string(text) + ": a loop of two corners";
  }
  if (expected.contains(RationalPoint2{0, 0})) loops.push_back({{0, 0}, {x, 0}, {x, y}, {0, y}});
  if (!(nef_of(loops, WindingRule::Positive) == expected)) return std::string(text) + ": borders";
  // Borders are input again: labels are 0 and 1, or 0 and -1 where what is outside all is selected.
  SurfaceScene again{division.scene().mesh, result.borders, {}, FaceId{}};
  if (result.borders.size() == 0) return "";
  std::vector<std::uint32_t> all(result.borders.size());
  std::iota(all.begin(), all.end(), 0U);
  again.shapes = {all};
  Context context;
  const SurfaceDivision second(again, context);
  if (const auto flaw = audit(second)) return "borders: " + *flaw;
  double inside = 0, outside = 0;
  for (std::uint32_t c = 0; c < second.cell_count(); ++c) {
    const auto label = second.labels(CellId(c));
    const bool is_outside_in = expected.contains(RationalPoint2{0, 0});
    if (!label.empty() && label[0].value != (is_outside_in ? -1 : 1)) {
      return std::string(text) + ": labels of borders";
    }
    (label.empty() ? outside : inside) += second.area(CellId(c));
  }
  if (is_near(expected.contains(RationalPoint2{0, 0}) ? outside : inside, area)) return "";
  return std::string(text) + ": area within borders";
}

}  // namespace

std::string disagreement_on_plane(const FlatScene& scene, std::uint64_t shuffle) {
  SurfaceDrawing drawing(grid_mesh(scene.columns, scene.rows, shuffle));
  for (const auto& polygon : scene.polygons) drawing.add_flat_polygon(polygon);
  Context context;
  const SurfaceDivision division(drawing.scene, context);
  if (const auto flaw = audit(division)) return *flaw;
  if (std::string text = difference(PlaneCells(scene).cells(), cells_of(division)); !text.empty()) {
    return text;
  }
  if (scene.polygons.size() < 2 || !stays_inside(scene)) return "";
  for (const char* text : {"A + B", "A * B", "A - B", "A ^ B", "!A"}) {
    if (std::string found = region_difference(division, scene, text); !found.empty()) return found;
  }
  return "";
}

}  // namespace plumb::testing
