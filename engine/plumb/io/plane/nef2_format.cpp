// Reading and writing of `.nef2`, the lossless format of plane sets.
//
// A record is a line: points, crossings as four points of two lines, vertices, and edges with their
// ends and marks. The reader trusts nothing: counts are compared with bytes, ids with counts,
// crossings with exact signs of their lines, and finally from_records() verifies the whole, so that
// a file can only give a set if it is the minimal complex of one. An error of that last step is
// reported at the line of the record, which the reader remembers for vertices and edges. Format:
// docs/formats.md, section .nef2.
// Tested by tests/io/plane_io_test.cpp.
#include "plumb/io/plane/nef2_format.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// The shortest lines, each with its line break: "0 0", "1 2 3 4", "1 0", "0 0 1 2 0 0 0".
constexpr std::uint64_t kPointBytes = 4;
constexpr std::uint64_t kCrossingBytes = 8;
constexpr std::uint64_t kVertexBytes = 4;
constexpr std::uint64_t kEdgeBytes = 14;

class Nef2Reader {
 public:
  Nef2Reader(std::string_view text, const ReadOptions& options, Context& context)
      : in_(text, options, context, "the set", ResultNumbers::All) {}

  PlaneRecords read();
  /// Returns the line of a vertex or an edge that has been read, or 0 for other records.
  std::size_t line_of(const RecordError& error) const;

 private:
  void read_counts();
  void read_points();
  void read_crossings();
  void read_vertices();
  void read_edges();
  std::uint32_t read_point_id() { return in_.read_id("point", points_) - 1; }
  std::uint32_t read_end();
  bool read_mark(std::string_view what);
  void end_record(std::string_view content);
  TextCursor& cursor() { return in_.cursor(); }

  RecordReader in_;
  std::size_t counts_line_ = 0;
  std::uint32_t points_ = 0;
  std::uint32_t crossings_ = 0;
  std::uint32_t vertices_ = 0;
  std::uint32_t edges_ = 0;
  PlaneRecords records_;
  std::vector<std::uint32_t> vertex_lines_;
  std::vector<std::uint32_t> edge_lines_;
};

std::size_t Nef2Reader::line_of(const RecordError& error) const {
  const bool is_edge = error.kind() == RecordError::Kind::Edge;
  const auto& lines = is_edge ? edge_lines_ : vertex_lines_;
  const bool has_line = error.kind() != RecordError::Kind::Crossing && error.index() < lines.size();
  return has_line ? lines[error.index()] : 0;
}

PlaneRecords Nef2Reader::read() {
  in_.read_magic("plumb-nef2", "1");
  read_counts();
  read_points();
  read_crossings();
  read_vertices();
  read_edges();
  if (cursor().next_line()) {
    cursor().fail(ErrorCode::CountMismatch, "there is more after the last record; line " +
                                                std::to_string(counts_line_) +
                                                " announces how many there are");
  }
  return std::move(records_);
}

/// Reads the counts and the mark of the bottom face, compares the counts with the bytes that
/// follow, and reserves all lists.
void Nef2Reader::read_counts() {
  if (!cursor().next_line()) {
    cursor().fail(ErrorCode::CountMismatch,
                  "the file ends where the numbers of points, crossings, vertices and edges are "
                  "expected");
  }
  counts_line_ = cursor().line();
  const char* const start = cursor().position();
  points_ = in_.read_count("the number of points");
  crossings_ = in_.read_count("the number of crossings");
  vertices_ = in_.read_count("the number of vertices");
  edges_ = in_.read_count("the number of edges");
  records_.bottom = read_mark("the mark of the bottom face");
  in_.end_line("four numbers and a mark on this line");
  in_.require_bytes(points_ * kPointBytes + crossings_ * kCrossingBytes + vertices_ * kVertexBytes +
                        edges_ * kEdgeBytes,
                    std::to_string(points_) + " points, " + std::to_string(crossings_) +
                        " crossings, " + std::to_string(vertices_) + " vertices and " +
                        std::to_string(edges_) + " edges",
                    start);
  if (std::uint64_t{points_} + crossings_ > RecordReader::kMostIds) {
    cursor().fail(ErrorCode::CountMismatch, "more than 2^32 points and crossings", start);
  }
  in_.charge(points_ * sizeof(Point2) + crossings_ * sizeof(Crossing2) +
             vertices_ * sizeof(PlaneRecords::Vertex) + edges_ * sizeof(PlaneRecords::Edge));
  records_.points.inputs.reserve(points_);
  records_.points.crossings.reserve(crossings_);
  records_.vertices.reserve(vertices_);
  records_.edges.reserve(edges_);
}

void Nef2Reader::read_points() {
  for (std::uint32_t i = 0; i < points_; ++i) {
    in_.next_record("point", i, points_);
    in_.read_point(records_.points.inputs);
  }
}

void Nef2Reader::read_crossings() {
  const PointTable2& inputs = records_.points.inputs;
  for (std::uint32_t i = 0; i < crossings_; ++i) {
    in_.next_record("crossing", i, crossings_);
    const char* const start = cursor().position();
    const std::uint32_t a = read_point_id();
    const std::uint32_t b = read_point_id();
    const std::uint32_t c = read_point_id();
    const std::uint32_t d = read_point_id();
    end_record("four points");
    if (cross_sign(inputs, a, b, c, d) == Sign::Zero) {
      cursor().fail(ErrorCode::BadShape, "the lines of " + in_.record_name() + " are parallel",
                    start);
    }
    records_.points.crossings.push_back(make_crossing(inputs, a, b, c, d));
  }
}

void Nef2Reader::read_vertices() {
  for (std::uint32_t i = 0; i < vertices_; ++i) {
    in_.next_record("vertex", i, vertices_);
    vertex_lines_.push_back(static_cast<std::uint32_t>(cursor().line()));
    const std::uint32_t point = in_.read_id("point", points_ + crossings_) - 1;
    const bool mark = read_mark("the mark of the vertex");
    end_record("a point and a mark");
    records_.vertices.push_back({point, mark});
  }
}

/// Returns a vertex, or kUnbounded for an end at infinity, which has the number 0 in the file.
std::uint32_t Nef2Reader::read_end() {
  const std::uint32_t id = in_.read_id("vertex", vertices_, 0);
  return id == 0 ? PlaneRecords::kUnbounded : id - 1;
}

void Nef2Reader::read_edges() {
  for (std::uint32_t i = 0; i < edges_; ++i) {
    in_.next_record("edge", i, edges_);
    edge_lines_.push_back(static_cast<std::uint32_t>(cursor().line()));
    const std::uint32_t from = read_end();
    const std::uint32_t to = read_end();
    const char* const line = cursor().position();
    const std::uint32_t a = read_point_id();
    const std::uint32_t b = read_point_id();
    const bool mark = read_mark("the mark of the edge");
    const bool left = read_mark("the mark to its left");
    const bool right = read_mark("the mark to its right");
    end_record("two ends, two points and three marks");
    if (compare_xy(records_.points.inputs, a, b) == Sign::Zero) {
      cursor().fail(ErrorCode::BadShape,
                    "the line of " + in_.record_name() + " runs through two equal points", line);
    }
    records_.edges.push_back({from, to, {a, b}, mark, left, right});
  }
}

/// Reads "0" or "1".
bool Nef2Reader::read_mark(std::string_view what) {
  if (cursor().at_line_end()) {
    cursor().fail(ErrorCode::Syntax,
                  "expected " + std::string(what) + ", found the end of the line");
  }
  const std::string_view token = cursor().token();
  if (token != "0" && token != "1") cursor().fail_token(token, std::string(what) + ", 0 or 1");
  return token == "1";
}

void Nef2Reader::end_record(std::string_view content) {
  if (cursor().at_line_end()) return;
  in_.end_line("the end of the line after " + std::string(content) + " of " + in_.record_name());
}

}  // namespace

PlaneRecords read_nef2_records(std::string_view text, const ReadOptions& options,
                               Context& context) {
  const RoundToNearest rounding;
  return Nef2Reader(text, options, context).read();
}

Nef2 read_nef2(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  Nef2Reader reader(text, options, context);
  const PlaneRecords records = reader.read();
  try {
    return Nef2::from_minimal_unchecked(from_records(records, context));
  } catch (const RecordError& error) {
    const std::size_t line = reader.line_of(error);
    throw Error(ErrorCode::BadShape, error.message(),
                {options.name, line, line == 0 ? std::size_t{0} : std::size_t{1}});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadArgument) throw;
    throw Error(ErrorCode::BadShape, error.message(), {options.name});
  }
}

namespace {

class Nef2Writer {
 public:
  Nef2Writer(std::ostream& stream, const PlaneComplex& complex, Context& context)
      : out_(stream, context), complex_(complex) {}

  void write() {
    write_header();
    for (std::uint32_t i = 0; i < complex_.points.inputs.size(); ++i) write_point(i);
    for (const Crossing2& c : complex_.points.crossings) {
      write_line(c.a + 1, c.b + 1, c.c + 1, c.d + 1);
    }
    for (std::uint32_t i = 0; i < complex_.vertex_count(); ++i) {
      const PlaneRecords::Vertex v = record_of(complex_, VertexId(i));
      write_line(v.point + 1, mark(v.mark));
    }
    for (std::uint32_t i = 0; i < complex_.edge_count(); ++i) {
      const PlaneRecords::Edge e = record_of(complex_, EdgeId(i));
      write_line(end(e.from), end(e.to), e.line.a + 1, e.line.b + 1, mark(e.mark), mark(e.left),
                 mark(e.right));
    }
    out_.flush();
  }

 private:
  void write_header() {
    out_ << "plumb-nef2 1\n";
    write_line(complex_.points.inputs.size(), complex_.points.crossings.size(),
               complex_.vertex_count(), complex_.edge_count(), mark(complex_.mark(FaceId(0))));
  }

  void write_point(std::uint32_t i) {
    const PointTable2& points = complex_.points.inputs;
    const Point2 p = points.approx(i);
    if (points.is_double(i) && is_short_integer(p.x) && is_short_integer(p.y)) {
      out_ << p.x << ' ' << p.y << '\n';
      return;
    }
    const RationalPoint2 exact = points.exact(i);
    out_ << format_exact(exact.x) << ' ' << format_exact(exact.y) << '\n';
  }

  /// Whether format_double() writes the number as an integer.
  static bool is_short_integer(double value) {
    return std::fabs(value) < 0x1p53 && std::trunc(value) == value;
  }
  static std::uint64_t mark(bool marked) { return marked ? 1 : 0; }
  static std::uint64_t end(std::uint32_t vertex) {
    return vertex == PlaneRecords::kUnbounded ? 0 : std::uint64_t{vertex} + 1;
  }

  template <class... Rest>
  void write_line(std::uint64_t first, Rest... rest) {
    out_ << first;
    ((out_ << ' ' << std::uint64_t{rest}), ...);
    out_ << '\n';
  }

  TextOutput out_;
  const PlaneComplex& complex_;
};

}  // namespace

void write_nef2(std::ostream& out, const PlaneComplex& complex, Context& context) {
  Nef2Writer(out, complex, context).write();
}

}  // namespace plumb
