#include "oracle/nef2_check.h"

#include <algorithm>

#include "oracle/twin_check.h"
#include "plumb/plane/complex/plane_records.h"

namespace plumb::testing {
namespace {

PlaneLocation location_of(const GraphMatch& match, const PlaneGraph::Element& element, bool mark) {
  PlaneLocation location;
  location.marked = mark;
  if (element.dimension == 0) location.vertex = match.vertex[element.index];
  if (element.dimension == 1) location.edge = match.edge[element.index];
  if (element.dimension == 2) location.face = match.face[element.index];
  return location;
}

std::string to_text(const PlaneLocation& l) {
  const std::string mark = l.marked ? " marked" : " unmarked";
  if (l.vertex.is_valid()) return "vertex " + std::to_string(l.vertex.value()) + mark;
  if (l.edge.is_valid()) return "edge " + std::to_string(l.edge.value()) + mark;
  if (l.face.is_valid()) return "face " + std::to_string(l.face.value()) + mark;
  return "nowhere";
}

// Every check throws the first difference, as text.
class Checker {
 public:
  Checker(const LineCells& cells, const TwoSets& sets)
      : cells_(cells), sets_(sets), engine_(sets.engine), twin_(sets.twin) {}

  std::string run(bool deeply) {
    return first_difference([&] {
      check_complex();
      check_answers();
      if (deeply) check_deeply();
    });
  }

 private:
  void check_complex() {
    const std::optional<DcelFlaw> flaw = engine_.audit();
    if (flaw) throw "audit: " + flaw->invariant + " at " + flaw->place;
    graph_ = minimal_graph(cells_, twin_);
    match_ = match(engine_.complex(), graph_, cells_);
    if (!match_.difference.empty()) throw match_.difference;
  }

  void check_answers() const {
    const auto none = std::none_of(twin_.begin(), twin_.end(), [](bool b) { return b; });
    const auto all = std::all_of(twin_.begin(), twin_.end(), [](bool b) { return b; });
    expect_same(engine_.is_empty(), none, "is_empty");
    expect_same(engine_.is_whole(), all, "is_plane");
    expect_same(engine_.is_bounded(), is_bounded(cells_, twin_), "is_bounded");
    expect_same(engine_.is_closed(), closure_of(cells_, twin_) == twin_, "is_closed");
    expect_same(engine_.is_open(), interior_of(cells_, twin_) == twin_, "is_open");
    const std::optional<Rational> area = engine_.area();
    const std::optional<BigRational> expected = area_of(cells_, twin_);
    expect_same(area.has_value(), expected.has_value(), "area is finite");
    expect(!area || exact_of(*area) == *expected, "area: engine differs from twin");
  }

  void check_deeply() const {
    check_locations();
    check_rays();
    check_operators(cells_, sets_);
    check_parts();
    check_records();
    check_marks();
  }

  PlaneLocation expected_at(std::size_t cell) const {
    return location_of(match_, graph_.element_of[cell], twin_[cell]);
  }

  void check_locations() const {
    const CellMarks boundary = testing::apply(SetOperator::Boundary, cells_, twin_, CellMarks());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const ExactPoint p = cells_[c].point;
      const RationalPoint2 query = to_rational(p);
      const std::string where = " at " + testing::to_text(p);
      const PlaneLocation got = engine_.locate(query);
      if (!(got == expected_at(c))) {
        throw "locate" + where + ": engine " + to_text(got) + ", twin " + to_text(expected_at(c));
      }
      expect_same(engine_.has_on_boundary(query), boundary[c], "has_on_boundary" + where);
      Point2 rounded;
      if (as_double(p.x, rounded.x) && as_double(p.y, rounded.y)) {
        expect(engine_.locate(rounded) == got, "locate by doubles" + where);
        expect_same(engine_.contains(rounded), twin_[c], "contains" + where);
      }
    }
  }

  // ---------------------------------------------------------------- rays

  void check_rays() const {
    CellMarks on_boundary(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      on_boundary[c] = graph_.element_of[c].dimension < 2;
    }
    const std::size_t step = 1 + cells_.size() / 12;
    for (std::size_t c = 0; c < cells_.size(); c += step) {
      for (const ExactPoint& direction : directions_from(c)) {
        const ExactPoint origin = cells_[c].point;
        const auto hit = engine_.shoot(to_rational(origin), to_rational(direction));
        check_hit(hit, first_hit(cells_, twin_, origin, direction), origin, direction);
        const auto edge_hit =
            engine_.shoot_to_boundary(to_rational(origin), to_rational(direction));
        check_hit(edge_hit, first_hit(cells_, on_boundary, origin, direction), origin, direction);
      }
    }
  }

  // Along the axes, somewhere, and at other cells: through vertices and along edges.
  std::vector<ExactPoint> directions_from(std::size_t c) const {
    const ExactPoint from = cells_[c].point;
    std::vector<ExactPoint> directions{{1, 0}, {0, -1}, {-3, 2}};
    for (const std::size_t d : {c * 7 % cells_.size(), (c + 1) % cells_.size(), std::size_t{0}}) {
      const ExactPoint to = cells_[d].point;
      if (!(from == to)) directions.push_back({to.x - from.x, to.y - from.y});
    }
    return directions;
  }

  void check_hit(const std::optional<PlaneHit>& got, const std::optional<CellHit>& expected,
                 const ExactPoint& origin, const ExactPoint& direction) const {
    const std::string what =
        "ray from " + testing::to_text(origin) + " towards " + testing::to_text(direction);
    expect_same(got.has_value(), expected.has_value(), what + " hits");
    if (!got) return;
    const PlaneLocation on = expected_at(expected->cell);
    if (!(got->location == on)) {
      throw what + ": engine " + to_text(got->location) + ", twin " + to_text(on);
    }
    const ExactPoint at = exact_of(got->point);
    if (!(at == expected->point)) {
      throw what + ": engine " + testing::to_text(at) + ", twin " +
          testing::to_text(expected->point);
    }
  }

  // ---------------------------------------------------------------- derived sets

  static Chain chain_of(const std::vector<RationalPoint2>& points) {
    Chain chain;
    for (const RationalPoint2& p : points) chain.push_back(exact_of(p));
    return chain;
  }

  // A ring has no repeated point and runs the right way.
  static void check_ring(const Chain& ring, bool counter_clockwise) {
    Chain sorted = ring;
    std::sort(sorted.begin(), sorted.end());
    expect(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(),
           "a ring of parts() has a point twice");
    BigRational doubled = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const ExactPoint& p = ring[i];
      const ExactPoint& q = ring[(i + 1) % ring.size()];
      doubled += p.x * q.y - p.y * q.x;
    }
    expect(counter_clockwise ? doubled > 0 : doubled < 0, "a ring of parts() runs the wrong way");
  }

  static PlaneSetPointer set_of_polygon(const PolygonWithHoles2& polygon) {
    std::vector<Chain> rings{chain_of(polygon.outer)};
    check_ring(rings[0], true);
    for (const auto& hole : polygon.holes) {
      rings.push_back(chain_of(hole));
      check_ring(rings.back(), false);
    }
    return set_of(SetPolygons{rings, WindingRule::NonZero, Boundary::Closed});
  }

  // Put together again they are the closure; what has a lower dimension adds something new.
  void check_parts() const {
    const PlaneParts parts = engine_.parts();
    const CellMarks closed = closure_of(cells_, twin_);
    expect_same(parts.dropped_open, closed != twin_, "dropped_open");
    expect_same(parts.filled && !parts.dropped_open, false, "filled without being open");
    const CellMarks inner = interior_of(cells_, closed);
    bool lacks_inner = false;
    for (std::size_t i = 0; i < inner.size(); ++i) lacks_inner |= inner[i] != 0 && twin_[i] == 0;
    if (lacks_inner) expect_same(parts.filled, true, "filled");
    expect_same(parts.dropped_unbounded, !is_bounded(cells_, twin_), "dropped_unbounded");
    check_polygon_count(parts, minimal_graph(cells_, closed));
    CellMarks built(cells_.size());
    for (const PolygonWithHoles2& polygon : parts.polygons) add(built, set_of_polygon(polygon));
    for (const auto& line : parts.lines) {
      expect(line.size() >= 2, "a line of parts() has no edge");
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        add_new(built, set_of(SetPolylines{{chain_of({line[i], line[i + 1]})}}), 1);
      }
    }
    for (const RationalPoint2& p : parts.points)
      add_new(built, set_of(SetPoints{{exact_of(p)}}), 0);
    if (!parts.dropped_unbounded) expect(built == closed, "parts() are not the closure");
  }

  static void check_polygon_count(const PlaneParts& parts, const PlaneGraph& closed) {
    const auto bounded = std::count_if(closed.faces.begin(), closed.faces.end(),
                                       [](const auto& f) { return f.mark && !f.unbounded; });
    expect(parts.polygons.size() >= static_cast<std::size_t>(bounded),
           "parts() has too few polygons");
  }

  void add(CellMarks& built, const PlaneSetPointer& part) const {
    built = testing::apply(SetOperator::Union, cells_, built, marks_of(*part, cells_));
  }

  void add_new(CellMarks& built, const PlaneSetPointer& part, int dimension) const {
    const CellMarks marks = marks_of(*part, cells_);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      expect(!(marks[c] && built[c] && cells_[c].dimension == dimension),
             "parts() lists something twice");
    }
    add(built, part);
  }

  // ---------------------------------------------------------------- round trips

  void check_records() const {
    const PlaneComplex& complex = engine_.complex();
    Context context;
    const PlaneRecords records = to_records(complex);
    const PlaneComplex again = from_records(records, context);
    const PlaneRecords second = to_records(again);
    expect(records.vertices == second.vertices && records.edges == second.edges &&
               records.bottom == second.bottom,
           "records of records differ");
    const GraphMatch same = match(again, graph_, cells_);
    if (!same.difference.empty()) throw "records: " + same.difference;
  }

  void check_marks() const {
    const PlaneComplex& complex = engine_.complex();
    expect(engine_.with_marks(complex.marks) == engine_, "with_marks of its own marks");
    expect(Nef2::from_complex(complex) == engine_, "from_complex of its own complex");
    PlaneMarks flipped = complex.marks;
    for (std::vector<std::uint8_t>* marks : std::initializer_list<std::vector<std::uint8_t>*>{
             &flipped.vertex, &flipped.edge, &flipped.face}) {
      for (std::uint8_t& mark : *marks) mark = mark == 0 ? 1 : 0;
    }
    expect(engine_.with_marks(flipped) == !engine_, "with_marks of flipped marks");
  }

  const LineCells& cells_;
  const TwoSets& sets_;
  const Nef2& engine_;
  const CellMarks& twin_;
  PlaneGraph graph_;
  GraphMatch match_;
};

}  // namespace

std::string difference(const LineCells& cells, const TwoSets& sets) {
  return Checker(cells, sets).run(false);
}

std::string deep_difference(const LineCells& cells, const TwoSets& sets) {
  return Checker(cells, sets).run(true);
}

std::string disagreement(const PlaneSet& set) {
  const LineCells cells = cells_of(set);
  return TreeCheck<SetOperation, TwoSets, PlaneSet, LineCells>(set, cells).run();
}

LineCells cells_of(const PlaneSet& set) {
  std::vector<CellLine> lines;
  add_lines(set, lines);
  return LineCells(std::move(lines));
}

// A point on every line met, and one between any two of them.
std::optional<CellHit> first_hit(const LineCells& cells, const std::vector<bool>& accepted,
                                 const ExactPoint& origin, const ExactPoint& direction) {
  std::vector<BigRational> stops{0};
  for (const CellLine& line : cells.lines()) {
    const BigRational speed = line.a * direction.x + line.b * direction.y;
    if (speed == 0) continue;
    const BigRational at = -(line.a * origin.x + line.b * origin.y + line.c) / speed;
    if (at > 0) stops.push_back(at);
  }
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  const auto point_at = [&](const BigRational& t) {
    return ExactPoint{origin.x + t * direction.x, origin.y + t * direction.y};
  };
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const BigRational next = i + 1 < stops.size() ? stops[i + 1] : stops[i] + 2;
    for (const BigRational& t : {stops[i], BigRational((stops[i] + next) / 2)}) {
      const std::size_t cell = cells.cell_of(cell_point(point_at(t)));
      if (accepted[cell]) return CellHit{cell, point_at(stops[i])};
    }
  }
  return std::nullopt;
}

}  // namespace plumb::testing
