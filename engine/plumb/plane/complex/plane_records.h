// Records represent a complex as a plain list of its vertices and edges. A .nef2 file contains such
// a list. from_records() checks a list and makes the complex.
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

/// The vertices and edges of a complex with their marks. The record of an edge also has the marks
/// of the two faces beside the edge. from_records() computes the faces and the links between cells
/// from these records.
struct PlaneRecords {
  static constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

  /// A vertex.
  struct Vertex {
    std::uint32_t point;  ///< The index of the vertex's point, as numbered in plane_points.h.
    bool mark;            ///< The mark of the vertex.
    friend bool operator==(const Vertex&, const Vertex&) = default;
  };
  /// An edge.
  struct Edge {
    std::uint32_t from;  ///< The left end: an index into `vertices`, or kUnbounded.
    std::uint32_t to;    ///< The right end: an index into `vertices`, or kUnbounded.
    PlaneLine line;      ///< The line of the edge, in the direction from `from` to `to`.
    bool mark;           ///< The mark of the edge.
    bool left;           ///< The mark of the face to the left.
    bool right;          ///< The mark of the face to the right.
    friend bool operator==(const Edge&, const Edge&) = default;
  };

  PlanePoints points;            ///< All points.
  std::vector<Vertex> vertices;  ///< The vertices in lexicographic order.
  std::vector<Edge> edges;       ///< The edges in the order of PlaneComplex.
  bool bottom = false;           ///< The mark of face 0.
};

/// The error that from_records() throws if the fault concerns one record.
class RecordError : public Error {
 public:
  /// The kind of the record.
  enum class Kind : std::uint8_t { Crossing, Vertex, Edge };

  /// Makes the error. `index` is the 0-based index of the record among the records of this kind.
  /// `why` is a sentence that explains the fault.
  RecordError(Kind kind, std::size_t index, const std::string& why);

  Kind kind() const { return kind_; }
  std::size_t index() const { return index_; }

 private:
  Kind kind_;
  std::size_t index_;
};

/// Returns the records of a complex. O(n) for n cells.
PlaneRecords to_records(const PlaneComplex& complex);
/// Returns the record of one vertex.
PlaneRecords::Vertex record_of(const PlaneComplex& complex, VertexId v);
/// Returns the record of one edge.
PlaneRecords::Edge record_of(const PlaneComplex& complex, EdgeId e);

/// Returns the minimal complex of the records. If c is minimal, from_records(to_records(c)) equals
/// c. Throws Error{BadArgument} if the records have a fault. If the fault concerns a single record,
/// the error is a RecordError. Faults are:
///   - an index out of range
///   - a line through two equal points, or a crossing of two parallel lines
///   - a vertex that does not lie on the line of its edge
///   - edges that intersect in points other than their common vertices
///   - different marks for the same face
///   - a cell that is not needed, because the set is the same without the cell
///   - a vertex or edge that is out of order
/// The cost is the cost of a sweep.
PlaneComplex from_records(const PlaneRecords& records, Context& context);

/// Returns the complex of the records. The complex need not be minimal; for example, it can be the
/// complex of an arrangement. Errors and cost are the same as for from_records().
PlaneComplex rebuild(const PlaneRecords& records, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
