// What the readers of WKT, GeoJSON and WKB, and the writers, have in common.
#pragma once

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {

/// The greatest depth of nested geometries of WKT and WKB.
inline constexpr int kMostNested = 64;

// Words of notes and errors.

inline constexpr std::string_view kReferenceSystems = "coordinate reference systems";
inline constexpr std::string_view kHeights = "heights (Z)";
inline constexpr std::string_view kMeasures = "measures (M)";
inline constexpr std::string_view kClosedByEdge =
    "closed by an edge: rings that end elsewhere than they start";
inline constexpr std::string_view kNoCurves =
    "curves are not read, because edges are straight; replace them by short edges first "
    "(ST_CurveToLine, or ogr2ogr -nlt CONVERT_TO_LINEAR)";
inline constexpr std::string_view kSurfaceInSpace =
    "a surface whose heights differ is no set of the plane; drop its heights (ST_Force2D) if it is "
    "meant as seen from above, or write it as a mesh (.off)";

/// Collects shapes, charged to a context. A limit is reported at the place of the `in` that a
/// function is given: a TextCursor or a BinaryInput.
class ShapeCollector {
 public:
  ShapeCollector(Context& context, std::size_t total_bytes)
      : context_(context), total_bytes_(total_bytes) {}

  /// Reserves memory for so many positions, charged at once. Requires counts that the file
  /// supports.
  template <class Input>
  void expect(const Input& in, std::size_t positions) {
    charge(in, positions * sizeof(Point2));
    shapes_.points.reserve(positions);
  }

  /// Returns the number of positions read so far, which is the index of the next one.
  std::uint32_t position_count() const { return static_cast<std::uint32_t>(shapes_.points.size()); }
  /// Adds a position that was read up to `in`.
  template <class Input>
  void add_position(const Input& in, const ReadNumber& x, const ReadNumber& y) {
    if (position_count() == charged_positions_) begin_step(in);
    if (const std::size_t bytes = exact_bytes(x, y)) charge(in, bytes);
    push_point(shapes_.points, x, y);
  }

  // Each of these functions takes the positions [first, last). If the positions are wrong, the
  // function returns the reason and adds nothing. Otherwise it returns an empty string.
  /// Adds a ring to the polygon that end_polygon() ends. If the ring does not end where it starts,
  /// an edge closes it, and a note counts such rings.
  std::string add_ring(std::uint32_t first, std::uint32_t last);
  std::string add_line(std::uint32_t first, std::uint32_t last);
  void add_points(std::uint32_t first, std::uint32_t last);
  /// Ends a polygon; does nothing without a ring.
  void end_polygon();
  std::size_t polygon_count() const { return shapes_.polygon_count(); }
  /// States that the polygons from `first` on belong to one MULTIPOLYGON.
  template <class Input>
  void join_polygons(const Input& in, std::size_t first) {
    charge(in, (polygon_count() - std::min(first, polygon_count())) * kCornerBytes);
    for (std::size_t p = first + 1; p < polygon_count(); ++p) {
      continued_.push_back(static_cast<std::uint32_t>(p));
    }
  }

  /// Ends a geometry that began when there were as many polygons and as many geometries without
  /// polygons as stated, and records it if it has none of both.
  template <class Input>
  void end_geometry(const Input& in, std::size_t polygons, std::size_t without_polygons) {
    if (polygons != polygon_count() || without_polygons != without_polygons_.size()) return;
    if (without_polygons_.size() % kStep == 0) charge(in, kStep * kCornerBytes);
    without_polygons_.push_back(static_cast<std::uint32_t>(polygons));
  }
  std::size_t without_polygons() const { return without_polygons_.size(); }

  /// Names something of the file that shapes cannot hold: one note lists each of them once.
  void pass_over(std::string_view what);
  /// Adds another note.
  void note(std::string sentence) { notes_.push_back(std::move(sentence)); }

  /// Returns the shapes with the notes.
  PlaneFile take();

 private:
  static constexpr std::uint32_t kStep = 4096;  ///< Positions between two checks of the context.
  static constexpr std::uint64_t kMostPositions = 0xffff'fffe - kStep;
  /// A position lies in the table, and as a corner in vectors that grow by doubling; while one
  /// grows, old and new exist.
  static constexpr std::uint64_t kCornerBytes = 3 * sizeof(std::uint32_t);

  template <class Input>
  void begin_step(const Input& in) {
    if (charged_positions_ > kMostPositions) {
      in.fail(ErrorCode::ResourceLimit, "more than 2^32 positions");
    }
    context_.checkpoint("read", in.bytes_read(), total_bytes_);
    charge(in, kStep * kCornerBytes);
    charged_positions_ += kStep;
  }
  template <class Input>
  void charge(const Input& in, std::uint64_t bytes) {
    with_place(in, [&] { context_.charge_memory(bytes, "the shapes"); });
  }

  Context& context_;
  std::size_t total_bytes_;
  std::uint64_t charged_positions_ = 0;
  PlaneShapes shapes_;
  std::vector<std::uint32_t> continued_, without_polygons_;
  std::size_t unclosed_ = 0;  ///< Rings that an edge had to close.
  std::vector<std::string> passed_over_;
  std::vector<std::string> notes_;
};

// What the writers of WKT and GeoJSON have in common: both write shapes as nested lists.

/// Writes shapes; the formats differ in brackets, separators and names.
class ShapeWriter {
 public:
  virtual ~ShapeWriter() = default;
  ShapeWriter(const ShapeWriter&) = delete;
  ShapeWriter& operator=(const ShapeWriter&) = delete;

  /// Writes one line: a geometry of the only kind of shape there is, or a collection of geometries.
  void write();

 protected:
  struct Lists {
    char open;
    std::string_view separator;
    char close;
  };
  ShapeWriter(std::ostream& out, const PlaneShapes& shapes, Lists lists, Context& context)
      : out_(out, context), shapes_(shapes), lists_(lists) {}

  /// Called around the geometries if their number is not one.
  virtual void begin_collection(bool is_empty) = 0;
  virtual void end_collection(bool is_empty) = 0;
  /// Called around the coordinates of `count` > 0 shapes called "Polygon", "LineString" or "Point".
  virtual void begin_geometry(std::string_view name, bool is_multiple) = 0;
  virtual void end_geometry() = 0;
  /// Writes the coordinates of a geometry of one point.
  virtual void write_point(Point2 p) = 0;
  /// Writes a member of a list of positions.
  virtual void write_position(Point2 p) = 0;

  template <class Item>
  void write_list(std::size_t first, std::size_t last, Item item) {
    out_ << lists_.open;
    for (std::size_t i = first; i < last; ++i) {
      if (i != first) out_ << lists_.separator;
      item(i);
    }
    out_ << lists_.close;
  }

  TextOutput out_;

 private:
  void write_geometries();
  template <class Item>
  void write_geometry(std::string_view name, std::size_t count, Item item);
  void write_polygon(std::size_t p);
  Point2 point(std::uint32_t i) const { return shapes_.points.approx(i); }

  const PlaneShapes& shapes_;
  Lists lists_;
  bool is_first_ = true;
};

}  // namespace plumb
