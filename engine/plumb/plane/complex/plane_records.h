// A complex as a plain list, for files: what .nef2 holds, and how it is checked on the way in.
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

struct PlaneRecords {
  static constexpr std::uint32_t kUnbounded = std::numeric_limits<std::uint32_t>::max();

  struct Vertex {
    std::uint32_t point;  ///< dense index
    bool mark;
    friend bool operator==(const Vertex&, const Vertex&) = default;
  };
  struct Edge {
    std::uint32_t from;  ///< vertex (index into vertices), or kUnbounded; the lesser end
    std::uint32_t to;    ///< vertex, or kUnbounded
    PlaneLine line;      ///< input points; runs from -> to
    bool mark;
    bool left;   ///< mark of the face to the left
    bool right;  ///< mark of the face to the right
    friend bool operator==(const Edge&, const Edge&) = default;
  };

  PlanePoints points;
  std::vector<Vertex> vertices;  ///< in lexicographic order
  std::vector<Edge> edges;       ///< in the order of PlaneComplex
  bool bottom = false;           ///< mark of face 0
};

/// What from_records() throws when one record is at fault.
class RecordError : public Error {
 public:
  enum class Kind : std::uint8_t { Crossing, Vertex, Edge };

  /// `why` is a sentence about record `index`, 0-based.
  RecordError(Kind kind, std::size_t index, const std::string& why);

  Kind kind() const { return kind_; }
  std::size_t index() const { return index_; }

 private:
  Kind kind_;
  std::size_t index_;
};

PlaneRecords to_records(const PlaneComplex& complex);
/// One of its records.
PlaneRecords::Vertex record_of(const PlaneComplex& complex, VertexId v);
PlaneRecords::Edge record_of(const PlaneComplex& complex, EdgeId e);

/// Rebuilds the minimal complex. from_records(to_records(c)) is c when c is minimal. Throws
/// Error{BadArgument}, mostly a RecordError, with the first thing that is wrong: an index, a line
/// through two equal points or parallel lines of a crossing, a vertex that is not on the line of
/// its edge, edges that meet elsewhere than at their vertices, marks of one face that disagree, an
/// element that is not needed or out of order.
PlaneComplex from_records(const PlaneRecords& records, Context& context);

/// The same for complexes that need not be minimal (arrangements).
PlaneComplex rebuild(const PlaneRecords& records, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
