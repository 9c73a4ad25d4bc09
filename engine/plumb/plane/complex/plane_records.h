// A complex as a plain list, as files have it (.nef2), and the check of such a list.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/predicates/error.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The vertices and edges of a complex with their marks. Faces and links follow from them.
struct PlaneRecords {
  static constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

  /// A vertex.
  struct Vertex {
    std::uint32_t point;  ///< Its point (dense index).
    bool mark;            ///< Its mark.
    friend bool operator==(const Vertex&, const Vertex&) = default;
  };
  /// An edge.
  struct Edge {
    std::uint32_t from;  ///< The lesser end, an index into `vertices`, or kUnbounded.
    std::uint32_t to;    ///< The greater end, or kUnbounded.
    PlaneLine line;      ///< Two input points of its line, which runs from -> to.
    bool mark;           ///< Its mark.
    bool left;           ///< The mark of the face to the left.
    bool right;          ///< The mark of the face to the right.
    friend bool operator==(const Edge&, const Edge&) = default;
  };

  PlanePoints points;            ///< All points.
  std::vector<Vertex> vertices;  ///< The vertices in lexicographic order.
  std::vector<Edge> edges;       ///< The edges in the order of PlaneComplex.
  bool bottom = false;           ///< The mark of face 0.
};

/// The error that from_records() throws if one record is at fault.
class RecordError : public Error {
 public:
  /// The kind of the record.
  enum class Kind : std::uint8_t { Crossing, Vertex, Edge };

  /// Makes the error; `why` is a sentence about record `index`, which counts from 0.
  RecordError(Kind kind, std::size_t index, const std::string& why);

  Kind kind() const { return kind_; }
  std::size_t index() const { return index_; }

 private:
  Kind kind_;
  std::size_t index_;
};

/// Returns the records of a complex. O(n).
PlaneRecords to_records(const PlaneComplex& complex);
/// Returns the record of one vertex.
PlaneRecords::Vertex record_of(const PlaneComplex& complex, VertexId v);
/// Returns the record of one edge.
PlaneRecords::Edge record_of(const PlaneComplex& complex, EdgeId e);

/// Returns the minimal complex of the records; from_records(to_records(c)) is c if c is minimal.
/// Throws Error{BadArgument}, mostly a RecordError, with the first thing that is wrong: an index, a
/// line through two equal points, parallel lines of a crossing, a vertex that is not on the line of
/// its edge, edges that meet elsewhere than at their vertices, marks of one face that disagree, or
/// a cell that is not needed or out of order. Costs a sweep.
PlaneComplex from_records(const PlaneRecords& records, Context& context);

/// Returns the same for complexes that need not be minimal, such as arrangements.
PlaneComplex rebuild(const PlaneRecords& records, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
