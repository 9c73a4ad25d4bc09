// Finds the strip of faces that contains a globally shortest path between two points of a mesh. A
// Tracer with PathChoice::Shortest uses this search (trace.h). A Tracer with PathChoice::Local
// finds paths that are only locally shortest.
//
// Main flow of ShortestStripFinder::find:
//  1. start      makes a window on each side of the faces that contain the start, except for sides
//                on which the start lies. A window is a part of a side through which straight lines
//                from the start pass
//  2. spread     takes the window or vertex with the least bound from a heap. This bound is a lower
//                bound for the lengths of all paths from the start to the end that pass through the
//                window or vertex. From a window, the step makes new windows on the two other sides
//                of the face behind the window. It also computes a distance for the vertex between
//                these sides. From a vertex, the step makes windows around the vertex if shortest
//                paths can bend there
//  3. reach      is taken if a window or a vertex reaches a face that contains the end. The path to
//                the end through this window or vertex becomes a candidate
//  4. stop       ends the search if no bound is less than the length of the best path found so far
//  5. collect    follows the windows of the best path back to the start, and lists the sides on
//                which they lie
//
// Lengths are computed in doubles. Rounding can therefore affect the choice between paths whose
// lengths differ by less than 2^-40 of their length. The result is always a valid strip.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/predicates/point.h"
#include "plumb/surface/strip/face_strip.h"
#include "plumb/surface/surface_mesh.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Finds strips of shortest paths on one mesh. An object reuses its working memory.
class ShortestStripFinder {
 public:
  /// `positions` are the positions of the vertices, scaled so that no product of two coordinates
  /// overflows. Cost: O(n) for n vertices.
  ShortestStripFinder(const SurfaceMesh& mesh, std::span<const Point3> positions);

  /// Returns a strip that contains a shortest path from `from` to `to`, if it is shorter than
  /// `bound`. Returns no value if no path is shorter than `bound` by more than 2^-40 of `bound`.
  /// Requires that no face contains both ends. Cost: O(w log w) for w windows. Consider the
  /// ellipsoid whose foci are the two ends, and whose longest axis has the length `bound`. On usual
  /// meshes, w is a small multiple of the number of sides in this ellipsoid. In the worst case, w
  /// is O(n^2) for n vertices. Throws the errors of the Context.
  std::optional<FaceStrip> find(const StripEnd& from, const StripEnd& to, double bound,
                                Context& context);

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// A part of a side of a face. All points of this part are reached from one source by straight
  /// lines through the same faces. The side lies on the x axis, from its origin at (0, 0); the face
  /// behind it lies above the axis, and the source lies below.
  struct Window {
    HalfedgeId into;       // The side, in the face behind it.
    double begin, end;     // The part of the side, as distances from its origin.
    Point2 source;         // The position of the source after unfolding.
    std::uint32_t seat;    // The source of the lines (a Seat).
    std::uint32_t before;  // The window before this window; kNone if it is the first after `seat`.
  };
  /// A source of windows: the start, or a vertex together with a path from the start to it.
  struct Seat {
    VertexId vertex;       // Invalid for the start.
    double distance;       // The length of the path from the start.
    std::uint32_t window;  // The window through which the vertex was reached, or kNone.
    std::uint32_t seat;    // The source before this one, if `window` is kNone.
    FaceId face;           // A face that contains both sources, if `window` is kNone.
  };
  /// The last step of a path that reaches the end point.
  struct Arrival {
    std::uint32_t window = kNone;  // The last window, or kNone.
    std::uint32_t seat = kNone;    // The last source, if `window` is kNone.
    FaceId face;  // A face that contains the last source and the end point, if `window` is kNone.
  };
  struct Entry {
    double bound;
    std::uint32_t index;  // The index of a window or of a source.
    bool is_seat;
  };
  /// The length of the shortest path to a vertex that the search has found so far. The entry counts
  /// only if `round` is the number of the current search (round_).
  struct Reached {
    std::uint32_t round = 0;
    double distance = 0;
  };
  /// A step of the path, for collecting the strip.
  struct Step {
    HalfedgeId door;  // The side to cross; invalid if the strip goes around a vertex.
    FaceId face;      // The face to which the strip goes, if `door` is invalid.
    VertexId around;  // The vertex around which it goes; invalid if the strip starts in `face`.
  };

  void start();
  void spread_window(std::uint32_t w);
  void spread_seat(std::uint32_t s);
  void add_window(HalfedgeId exit, const FaceCorners& corners, double begin, double end,
                  Point2 source, std::uint32_t seat, std::uint32_t before);
  bool is_dominated(const Window& window, double side) const;
  double bound_of(const Window& window, double side) const;
  void offer(VertexId v, const Seat& seat);
  void arrive(double length, const Arrival& arrival);
  void push(const Entry& entry);
  double best_of(VertexId v) const;
  bool can_bend(VertexId v) const;
  std::vector<Step> steps() const;
  FaceStrip collected() const;

  const SurfaceMesh& mesh_;
  std::span<const Point3> positions_;
  IdVector<VertexId, Reached> reached_;
  std::uint32_t round_ = 0;
  std::vector<Window> windows_;
  std::vector<Seat> seats_;
  std::vector<Entry> heap_;
  const StripEnd* from_ = nullptr;
  const StripEnd* to_ = nullptr;
  VertexId goal_;    // The end point, if it is a vertex.
  double best_ = 0;  // The length of the best path found, or the argument `bound` of find().
  Arrival arrival_;
};

}  // namespace plumb
#pragma GCC visibility pop
