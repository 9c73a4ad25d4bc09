// Traced paths: locally shortest or shortest paths between two points of a mesh, and polygons made
// of them.
//
// A strip of faces between the points is found by A* over the dual graph, and tightened: the funnel
// algorithm gives the shortest path within the strip, and at each vertex where the path could be
// shortened on the other side the strip is led around it. This repeats as long as the path becomes
// shorter by a fixed factor, so it ends. A shortest path is searched for among the paths that are
// shorter than this one (strip/shortest_strip.h), and its strip is tightened, too. The idea of
// flipping a strip across a bend follows N. Sharp and K. Crane, You can find geodesic paths in
// triangle meshes by just flipping edges, ACM Transactions on Graphics 39 (2020).
//
// Doubles choose the strip, but the topology of the result is exact: every point of the path is a
// vertex or a point of an edge that both faces share, with an exact rational place where the faces
// lie in one plane (strip/unfolded_strip.h). A path is the same in both directions, because it is
// traced from the lower point to the higher. Tested by tests/surface/trace_test.cpp.
#include "plumb/surface/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "plumb/predicates/error.h"
#include "plumb/surface/strip/face_strip.h"
#include "plumb/surface/strip/unfolded_strip.h"

namespace plumb {
namespace {

// The memory of a point of a path, and of a point of a polygon.
constexpr std::uint64_t kStopBytes = 96;
// This is the number of parts of a path between checkpoints.
constexpr std::size_t kLegs = 256;
constexpr std::uint64_t kPartBytes = 128;  // The memory of an exact place in a side.
constexpr double kShorter = 1 - 0x1p-48;

/// Whether a precedes b in an order of points that does not depend on their ids. Two points are
/// equal if neither precedes the other.
bool is_lower(const SurfacePointTable& points, SurfacePointId a, SurfacePointId b) {
  const auto index = [&points](SurfacePointId p) {
    return points.place(p) == SurfacePlace::Vertex ? points.vertex(p).value()
           : points.place(p) == SurfacePlace::Edge ? points.edge(p).value()
                                                   : points.face(p).value();
  };
  if (points.place(a) != points.place(b)) return points.place(a) < points.place(b);
  if (index(a) != index(b)) return index(a) < index(b);
  const RationalPoint2 p = points.exact(a), q = points.exact(b);
  return p.x != q.x ? p.x < q.x : p.y < q.y;
}

StripEnd end_at(const SurfacePointTable& points, SurfacePointId p, FaceId f,
                const std::vector<Point3>& positions) {
  const std::array<double, 3> weights = weights_in(points, p, f);
  Point3 at;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& corner = positions[points.mesh().corner(f, k).value()];
    at = {at.x + weights[k] * corner.x, at.y + weights[k] * corner.y, at.z + weights[k] * corner.z};
  }
  return {&points, p, at};
}

/// Leads the strip around the other side of bends, from the last bend to the first. If two bends
/// share more than one face, only the later bend is changed. Returns false if there was no change.
bool flip(const SurfaceMesh& mesh, const std::vector<StripTurn>& turns, FaceStrip& strip) {
  bool has_changed = false;
  std::size_t free_until = strip.doors.size();
  for (auto turn = turns.rbegin(); turn != turns.rend(); ++turn) {
    if (turn->last > free_until) continue;
    const HalfedgeId door = strip.doors[turn->first];
    const HalfedgeId leaving = turn->is_left ? SurfaceMesh::next(door) : door;
    const FaceId to = SurfaceMesh::face(mesh.twin(strip.doors[turn->last - 1]));
    const auto doors = doors_around(mesh, leaving, to, turn->is_left);
    if (!doors) continue;
    const auto at = [&](std::uint32_t i) { return strip.doors.begin() + i; };
    strip.doors.insert(strip.doors.erase(at(turn->first), at(turn->last)), doors->begin(),
                       doors->end());
    free_until = turn->first;
    has_changed = true;
  }
  return has_changed;
}

void keep_sharpest(std::vector<StripTurn>& turns) {
  if (turns.empty()) return;
  turns = {*std::ranges::max_element(turns, {}, &StripTurn::gain)};
}

/// Converts the path that was found in doubles to exact points.
class Reading {
 public:
  Reading(const std::vector<StripStop>& stops, const FaceStrip& strip, SurfacePointId a,
          SurfacePointId b, SurfacePointTable& points, Context& context)
      : mesh_(points.mesh()),
        stops_(stops),
        strip_(strip),
        a_(a),
        b_(b),
        points_(points),
        context_(context) {}

  SurfacePath path() {
    std::vector<FaceId> faces{strip_.first};
    for (const HalfedgeId door : strip_.doors) faces.push_back(SurfaceMesh::face(mesh_.twin(door)));
    SurfacePath path{{a_}, {}};
    for (std::size_t i = 1; i < stops_.size(); ++i) {
      if (!is_fixed(i) && is_fixed(i - 1)) look_ahead(i);
      path.points.push_back(i + 1 == stops_.size() ? b_ : point_at(i));
      path.faces.push_back(faces[std::max(stops_[i - 1].first, stops_[i].first)]);
    }
    return path;
  }

 private:
  /// Whether a stop is a vertex or an end, that is, not a place in a door.
  bool is_fixed(std::size_t i) const {
    return i == 0 || i + 1 == stops_.size() || stops_[i].vertex.is_valid();
  }
  FlatRunEnd end(std::size_t i) const { return {stops_[i].vertex, i == 0 ? a_ : b_}; }

  /// Finds exact places in the doors from here to the next vertex or end, if the faces there are
  /// flat.
  void look_ahead(std::size_t i) {
    std::size_t to = i;
    while (!is_fixed(to)) ++to;
    run_begin_ = i;
    run_ = flat_run(points_, std::span(strip_.doors).subspan(stops_[i].door, to - i), end(i - 1),
                    end(to), context_);
    // The points remain in the table, so the charge is not released.
    if (run_) context_.charge_memory(kPartBytes * run_->size(), "traced paths");
  }

  /// Returns the point of a stop, added to the table. If the run is not flat, both t and 1 - t are
  /// doubles, which makes signs cheap.
  SurfacePointId point_at(std::size_t i) {
    const StripStop& stop = stops_[i];
    if (stop.vertex.is_valid()) return points_.add_vertex(stop.vertex);
    const HalfedgeId door = strip_.doors[stop.door];
    const EdgeId edge = mesh_.edge(door);
    const bool is_upward = mesh_.is_upward(door);
    if (run_) {
      const Rational& part = (*run_)[i - run_begin_];
      return points_.add_on_edge(edge, is_upward ? part : Rational(1 - part));
    }
    return points_.add_on_edge(edge, is_upward ? 1 - (1 - stop.part) : 1 - stop.part);
  }

  const SurfaceMesh& mesh_;
  const std::vector<StripStop>& stops_;
  const FaceStrip& strip_;
  SurfacePointId a_, b_;
  SurfacePointTable& points_;
  Context& context_;
  std::optional<std::vector<Rational>> run_;
  std::size_t run_begin_ = 0;  // The stop of the first place of run_.
};

}  // namespace

Tracer::Tracer(const SurfaceMesh& mesh, PathChoice choice)
    : mesh_(mesh), positions_(scaled_positions(mesh).at), finder_(mesh, positions_) {
  if (choice == PathChoice::Shortest) shortest_finder_.emplace(mesh_, positions_);
}

std::optional<SurfacePath> Tracer::trace(SurfacePointTable& points, SurfacePointId a,
                                         SurfacePointId b, Context& context) {
  if (points.is_same(a, b)) return SurfacePath{{a}, {}};
  if (is_lower(points, a, b)) return trace_upward(points, a, b, context);
  std::optional<SurfacePath> path = trace_upward(points, b, a, context);
  if (path) {
    std::ranges::reverse(path->points);
    std::ranges::reverse(path->faces);
  }
  return path;
}

std::optional<SurfacePath> Tracer::trace_upward(SurfacePointTable& points, SurfacePointId a,
                                                SurfacePointId b, Context& context) {
  const std::vector<FaceId> near_a = faces_at(points, a), near_b = faces_at(points, b);
  if (near_a.empty() || near_b.empty()) return {};
  if (mesh_.component(near_a.front()) != mesh_.component(near_b.front())) return {};
  for (const FaceId f : near_a) {
    if (points.is_in(b, f)) return SurfacePath{{a, b}, {f}};
  }
  const StripEnd from = end_at(points, a, near_a.front(), positions_);
  const StripEnd to = end_at(points, b, near_b.front(), positions_);
  const FaceStrip strip = chosen_strip(from, to, context);
  const UnfoldedStrip unfolded(mesh_, positions_, strip, from, to);
  const std::vector<StripStop> stops = unfolded.stops();
  return Reading(stops, strip, a, b, points, context).path();
}

FaceStrip Tracer::chosen_strip(const StripEnd& from, const StripEnd& to, Context& context) {
  std::optional<FaceStrip> quick = finder_.find(from, to, context);
  PLUMB_CHECK(quick.has_value());
  FaceStrip local = tightened(std::move(*quick), from, to, context);
  if (!shortest_finder_) return local;
  const double bound = UnfoldedStrip(mesh_, positions_, local, from, to).path_length();
  std::optional<FaceStrip> found = shortest_finder_->find(from, to, bound, context);
  if (!found) return local;
  FaceStrip shortest = tightened(std::move(*found), from, to, context);
  const double length = UnfoldedStrip(mesh_, positions_, shortest, from, to).path_length();
  return length < bound ? shortest : local;
}

// First, all bends are flipped at the same time. When this does not shorten the path any more, only
// the sharpest bend is flipped, until this does not help either.
FaceStrip Tracer::tightened(FaceStrip strip, const StripEnd& from, const StripEnd& to,
                            Context& context) {
  finder_.shorten(strip, from, to);
  for (bool all_at_once = true;;) {
    context.checkpoint("trace", 0, 1);
    const UnfoldedStrip unfolded(mesh_, positions_, strip, from, to);
    std::vector<StripTurn> turns = unfolded.turns();
    if (!all_at_once) keep_sharpest(turns);
    FaceStrip other = strip;
    if (!flip(mesh_, turns, other)) return strip;
    finder_.shorten(other, from, to);
    const UnfoldedStrip flipped(mesh_, positions_, other, from, to);
    if (flipped.path_length() < kShorter * unfolded.path_length()) {
      strip = std::move(other);
    } else if (!std::exchange(all_at_once, false)) {
      return strip;
    }
  }
}

namespace {

/// Returns the distance of two points. The last bits of std::hypot() would differ between systems.
double segment_length(const SurfacePointTable& points, SurfacePointId a, SurfacePointId b) {
  const Point3 p = points.position(a), q = points.position(b);
  const double x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
  const double most = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
  if (most == 0) return 0;
  const double u = x / most, v = y / most, w = z / most;
  return most * std::sqrt(u * u + v * v + w * w);
}

}  // namespace

double path_length(const SurfacePointTable& points, const SurfacePath& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += segment_length(points, path.points[i - 1], path.points[i]);
  }
  return sum;
}

double polygon_length(const SurfacePolygons& polygons, std::size_t p) {
  double sum = 0;
  for (std::uint32_t i = polygons.begin[p]; i < polygons.begin[p + 1]; ++i) {
    const SurfacePointId next = polygons.point[polygons.next(p, i)];
    sum += segment_length(polygons.points, polygons.point[i], next);
  }
  return sum;
}

std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              std::span<const FaceId> named,
                                              SurfacePolygons& polygons, Context& context) {
  std::vector<SurfacePath> legs;
  for (std::size_t i = 0; i < control.size(); ++i) {
    if (i % kLegs == 0) context.checkpoint("trace", i, control.size());
    const SurfacePointId from = control[i], next = control[i + 1 < control.size() ? i + 1 : 0];
    if (!named.empty() && !polygons.points.is_same(from, next) &&
        polygons.points.is_in(next, named[i])) {
      legs.push_back({{from, next}, {named[i]}});
      continue;
    }
    std::optional<SurfacePath> leg = tracer.trace(polygons.points, from, next, context);
    if (!leg) return i;
    // The path remains in the polygon, so the charge is not released.
    context.charge_memory(kStopBytes * leg->points.size(), "traced paths");
    legs.push_back(std::move(*leg));
  }
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (i % kLegs == 0) context.checkpoint("trace", i, legs.size());
    polygons.add_leg(legs[i]);
  }
  polygons.close();
  return {};
}

std::optional<std::size_t> add_traced_polygon(Tracer& tracer,
                                              std::span<const SurfacePointId> control,
                                              SurfacePolygons& polygons, Context& context) {
  return add_traced_polygon(tracer, control, {}, polygons, context);
}

}  // namespace plumb
