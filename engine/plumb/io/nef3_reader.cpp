// Reading of `.nef`, the lossless format of sets of space.
//
// Records come in the order planes, points, vertices, edges, edge uses, facets, volumes, each named
// by its position. Planes are interned as they are read. Each plane must get the number and the
// orientation that it has in the file, so a file cannot name a plane twice. The planes of a
// constructed point must meet in exactly one point. Ids are checked against counts, and links
// against each other (flaw_of_links()) before any walk over them. Callers run the audit, which
// decides whether the complex is a set of space (solid_io.cpp). Format: docs/formats.md, section
// .nef.
// Tested by tests/io/nef3_reader_test.cpp.
#include "plumb/io/nef3_reader.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/solid/solid_text.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kFirstOfFrame = 3;

/// The number of records of one kind that the file announces, and their memory.
struct Count {
  std::string_view name;
  std::uint64_t least_bytes;   ///< Least bytes of a record with its line break.
  std::uint64_t charge_bytes;  ///< Bytes that a record takes in the complex.
  std::uint32_t value = 0;
};

class Nef3Reader {
 public:
  Nef3Reader(std::string_view text, const ReadOptions& options, Context& context)
      : in_(text, {options.name, false}, context, "the set", ResultNumbers::All) {}

  SpaceComplex read() {
    return with_place(cursor(), [this] {
      in_.read_magic("plumb-nef3", "1");
      read_counts();
      each(planes_, "plane", [this](std::uint32_t i) { read_plane(i); });
      each(points_, "point", [this](std::uint32_t) { read_point(); });
      each(vertices_, "vertex", [this](std::uint32_t v) { read_vertex(v); });
      require_origins();
      each(edges_, "edge", [this](std::uint32_t) { read_edge(); });
      each(uses_, "use", [this](std::uint32_t u) { read_use(u); });
      each(facets_, "facet", [this](std::uint32_t f) { read_facet(f); });
      each(volumes_, "volume", [this](std::uint32_t) { c_.volume_mark.push_back(read_mark()); });
      read_end();
      c_.tables = tables_;
      return std::move(c_);
    });
  }

 private:
  template <class Read>
  void each(const Count& count, std::string_view what, Read read_record);
  void read_counts();
  void size_arrays();
  void read_plane(std::uint32_t index);
  void read_frame_plane(std::uint32_t index);
  void read_point();
  void read_input_point();
  double double_of(const ReadNumber& number, const char* start);
  void read_line_point(const char* start);
  void read_plane_point(const char* start);
  void add_point(SpacePoint p, const char* start);
  void read_vertex(std::uint32_t v);
  void require_origins();
  void read_edge();
  void read_use(std::uint32_t u);
  std::uint32_t read_origin();
  void read_facet(std::uint32_t f);
  void read_inner(FacetId f);
  void read_end();

  std::uint32_t read_index(const Count& count, std::string_view what) {
    return in_.read_id(what, count.value) - 1;
  }
  /// Returns an id. It is invalid for the number 0.
  template <class Id>
  Id read_optional(const Count& count, std::string_view what) {
    const std::uint32_t id = in_.read_id(what, count.value, 0);
    return id == 0 ? Id() : Id(id - 1);
  }
  PlaneId read_plane_id() { return PlaneId(read_index(planes_, "plane")); }
  Mark read_mark() { return static_cast<Mark>(in_.read_id("mark", kBeyond, 0)); }
  TextCursor& cursor() { return in_.cursor(); }
  /// Returns the place where the next token begins, or the end of the line.
  const char* next_token() {
    cursor().at_line_end();
    return cursor().position();
  }
  [[noreturn]] void fail(ErrorCode code, std::string message, const char* where = nullptr) {
    cursor().fail(code, std::move(message), where);
  }

  RecordReader in_;
  Count planes_{"planes", 8, 256};
  Count points_{"points", 8, 128};
  Count vertices_{"vertices", 6, 24};
  Count edges_{"edges", 10, 40};
  Count uses_{"uses", 8, 24};
  Count facets_{"facets", 14, 40};
  Count volumes_{"volumes", 2, 1};
  std::shared_ptr<SpaceTables> tables_ = std::make_shared<SpaceTables>();
  std::vector<SpacePoint> point_;
  SpaceComplex c_;
  ReadNumber number_[4];
};

template <class Read>
void Nef3Reader::each(const Count& count, std::string_view what, Read read_record) {
  for (std::uint32_t i = 0; i < count.value; ++i) {
    in_.next_record(what, i, count.value);
    read_record(i);
    if (!cursor().at_line_end()) in_.end_line("the end of " + in_.record_name());
  }
}

/// Reads the seven counts and charges the complex at once. The counts are compared with the bytes
/// that follow at the least length of a record.
void Nef3Reader::read_counts() {
  if (!cursor().next_line()) {
    fail(ErrorCode::CountMismatch,
         "the file ends where the numbers of planes, points, vertices, "
         "edges, uses, facets and volumes are expected");
  }
  const char* const start = cursor().position();
  std::uint64_t bytes = 0;
  std::uint64_t charge = 0;
  for (Count* count : {&planes_, &points_, &vertices_, &edges_, &uses_, &facets_, &volumes_}) {
    count->value = in_.read_count("the number of " + std::string(count->name));
    bytes += count->value * count->least_bytes;
    charge += count->value * count->charge_bytes;
  }
  in_.end_line("seven numbers on this line");
  in_.require_bytes(bytes, "as many records", start);
  // The greatest number of cells that a SpaceItem can represent.
  constexpr std::uint32_t kMost = 0x3fff'ffff;
  const bool is_far = planes_.value > kMost || points_.value > kMost || vertices_.value > kMost ||
                      edges_.value > kMost || uses_.value > kMost || facets_.value > kMost;
  if (is_far) fail(ErrorCode::ResourceLimit, "more than 2^30 items of a kind", start);
  if (planes_.value < kFirstOfFrame || volumes_.value == 0) {
    fail(ErrorCode::CountMismatch, "there are at least three planes and one volume", start);
  }
  in_.charge(charge);
  size_arrays();
}

void Nef3Reader::size_arrays() {
  tables_->planes.reserve(planes_.value);
  point_.reserve(points_.value);
  c_.vertex_facet.resize(vertices_.value);
  c_.star_begin = {0};
  c_.origin.resize(std::size_t{2} * edges_.value);
  c_.use_prev.resize(uses_.value);
  c_.cycle_begin = {0};
  c_.inner_begin = {0};
}

/// Reads a plane: the exact row of a plane that was not read before, in canonical orientation, or a
/// plane of the frame.
void Nef3Reader::read_plane(std::uint32_t index) {
  const char* const start = cursor().position();
  if (cursor().rest().starts_with("frame")) return read_frame_plane(index);
  for (ReadNumber& number : number_) in_.read_number(number, "four numbers, a, b, c and d");
  if (const std::size_t bytes = exact_bytes(number_[0], number_[1])) in_.charge(bytes);
  if (const std::size_t bytes = exact_bytes(number_[2], number_[3])) in_.charge(bytes);
  const OrientedPlane plane = tables_->planes.intern(number_[0].exact(), number_[1].exact(),
                                                     number_[2].exact(), number_[3].exact());
  if (!plane.is_valid()) fail(ErrorCode::BadShape, in_.record_name() + " has no normal", start);
  if (plane.is_opposite()) {
    fail(ErrorCode::BadShape,
         in_.record_name() + " is not canonical: the first of a, b, c that is not 0 is negative",
         start);
  }
  if (plane.plane() == PlaneId(index)) return;
  const std::string found =
      index < kFirstOfFrame ? " is not x = 0, y = 0, z = 0 in this order"
                            : " is plane " + std::to_string(plane.plane().value() + 1) + " again";
  fail(ErrorCode::BadShape, in_.record_name() + found, start);
}

/// Reads a plane of the frame. Either planes 4 to 9 are the frame, in the order of kFrame, or there
/// is no frame.
void Nef3Reader::read_frame_plane(std::uint32_t index) {
  const char* const start = cursor().position();
  const std::string_view word = cursor().token();
  if (word != "frame") cursor().fail_token(word, "a plane");
  const std::string_view side = cursor().at_line_end() ? std::string_view() : cursor().token();
  const bool is_next = index >= kFirstOfFrame && index < kFirstOfFrame + kFrameSides.size() &&
                       side == kFrameSides[index - kFirstOfFrame] &&
                       planes_.value >= kFirstOfFrame + kFrameSides.size();
  if (!is_next) {
    fail(ErrorCode::Syntax, "planes 4 to 9 are frame -x, +x, -y, +y, -z, +z in this order, or none",
         start);
  }
  tables_->planes.intern_frame();
}

void Nef3Reader::read_point() {
  const char* const start = cursor().position();
  const std::string_view kind = cursor().token();
  if (kind == "i") return read_input_point();
  if (kind == "t") return read_plane_point(start);
  if (kind == "l") return read_line_point(start);
  cursor().fail_token(kind, "i, t or l");
}

void Nef3Reader::read_input_point() {
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) {
    const char* const start = next_token();
    in_.read_number(number_[i], "three numbers, x, y and z");
    at[i] = double_of(number_[i], start) + 0.0;  // Negative zero becomes zero.
  }
  point_.push_back(SpacePoint(tables_->planes.add_point({at[0], at[1], at[2]})));
}

/// Returns the number as a double. Large integers are read as rationals, but may also be doubles.
double Nef3Reader::double_of(const ReadNumber& number, const char* start) {
  if (number.is_double()) return number.as_double();
  const RoundedDouble nearest = round_to_double(number.exact());
  if (nearest.error == Sign::Zero) return nearest.value;
  fail(ErrorCode::NumberOutOfRange, "a coordinate of " + in_.record_name() + " is no double",
       start);
}

void Nef3Reader::read_plane_point(const char* start) {
  const PlaneId p = read_plane_id();
  const PlaneId q = read_plane_id();
  const PlaneId r = read_plane_id();
  add_point(tables_->points.add(p, q, r), start);
}

void Nef3Reader::read_line_point(const char* start) {
  std::array<InputPointId, 2> ends;
  for (InputPointId& end : ends) {
    const char* const where = next_token();
    const std::uint32_t index = read_index(points_, "point");
    if (index >= point_.size() || !point_[index].is_input()) {
      fail(ErrorCode::BadIndex, in_.record_name() + " names a point that is no i before it", where);
    }
    end = point_[index].input();
  }
  const PlaneId plane = read_plane_id();
  add_point(tables_->points.add(ends[0], ends[1], plane), start);
}

void Nef3Reader::add_point(SpacePoint p, const char* start) {
  if (!p.is_valid()) {
    fail(ErrorCode::BadShape, in_.record_name() + " is not one point", start);
  }
  point_.push_back(p);
}

/// Reads point, mark and volume of a vertex, and the half-edges that leave it.
void Nef3Reader::read_vertex(std::uint32_t v) {
  c_.vertex_point.push_back(point_[read_index(points_, "point")]);
  c_.vertex_mark.push_back(read_mark());
  c_.vertex_volume.push_back(read_optional<VolumeId>(volumes_, "volume"));
  while (!cursor().at_line_end()) {
    const char* const start = cursor().position();
    const std::uint32_t h = in_.read_id("half-edge", 2 * edges_.value) - 1;
    if (c_.origin[h].is_valid()) {
      fail(ErrorCode::BadShape, "half-edge " + std::to_string(h + 1) + " leaves two vertices",
           start);
    }
    c_.origin[h] = VertexId(v);
    c_.star.push_back(HalfedgeId(h));
  }
  c_.star_begin.push_back(static_cast<std::uint32_t>(c_.star.size()));
}

/// Requires that every half-edge leaves a vertex, so that later steps may follow it.
void Nef3Reader::require_origins() {
  for (std::size_t h = 0; h < c_.origin.size(); ++h) {
    if (c_.origin[h].is_valid()) continue;
    fail(ErrorCode::BadShape, "half-edge " + std::to_string(h + 1) + " leaves no vertex");
  }
}

void Nef3Reader::read_edge() {
  const PlaneId p = read_plane_id();
  const PlaneId q = read_plane_id();
  c_.edge_planes.push_back({p, q});
  c_.edge_mark.push_back(read_mark());
  c_.edge_volume.push_back(read_optional<VolumeId>(volumes_, "volume"));
  c_.edge_use.push_back(read_optional<UseId>(uses_, "use"));
}

/// Reads an edge use, and stores it as the previous use of its next one. flaw_of_links() finds a
/// use that is not the next of any use.
void Nef3Reader::read_use(std::uint32_t u) {
  c_.use_halfedge.emplace_back(in_.read_id("half-edge", 2 * edges_.value) - 1);
  const std::uint32_t next = read_index(uses_, "use");
  c_.use_next.emplace_back(next);
  c_.use_prev[next] = UseId(u);
  c_.use_radial.emplace_back(read_index(uses_, "use"));
  c_.use_facet.emplace_back(read_index(facets_, "facet"));
}

/// Reads a number of 32 bits.
std::uint32_t Nef3Reader::read_origin() {
  constexpr std::uint32_t kLast = 0xffff'ffff;
  if (!cursor().at_line_end() && cursor().rest().starts_with("4294967295")) {
    const std::string_view token = cursor().token();
    if (token == "4294967295") return kLast;
    cursor().fail_token(token, "the origin of the facet");
  }
  return in_.read_count("the origin of the facet");
}

/// Reads plane, mark, volumes and origin of a facet, its cycles, and the vertices inside it.
void Nef3Reader::read_facet(std::uint32_t f) {
  c_.facet_plane.push_back(read_plane_id());
  c_.facet_mark.push_back(read_mark());
  const VolumeId positive(read_index(volumes_, "volume"));
  const VolumeId negative(read_index(volumes_, "volume"));
  c_.facet_volume.push_back({positive, negative});
  c_.facet_origin.push_back(read_origin());
  for (std::uint32_t k = in_.read_count("the number of cycles"); k > 0; --k) {
    c_.cycle.emplace_back(read_index(uses_, "use"));
    if (c_.cycle.size() > uses_.value) fail(ErrorCode::BadShape, "more cycles than uses");
  }
  for (std::uint32_t k = in_.read_count("the number of vertices inside"); k > 0; --k) {
    read_inner(FacetId(f));
  }
  c_.cycle_begin.push_back(static_cast<std::uint32_t>(c_.cycle.size()));
  c_.inner_begin.push_back(static_cast<std::uint32_t>(c_.inner.size()));
}

void Nef3Reader::read_inner(FacetId f) {
  const char* const start = next_token();
  const VertexId v(read_index(vertices_, "vertex"));
  if (c_.vertex_facet[v].is_valid()) {
    fail(ErrorCode::BadShape, "vertex " + std::to_string(v.value() + 1) + " is in two facets",
         start);
  }
  c_.vertex_facet[v] = f;
  c_.inner.push_back(v);
}

void Nef3Reader::read_end() {
  in_.next_record("end", 0, 1);
  const std::string_view word = cursor().token();
  if (word != "end") cursor().fail_token(word, "end");
  in_.end_line("the end of the line");
  if (cursor().next_line()) fail(ErrorCode::CountMismatch, "there is more after the end");
}

}  // namespace

SpaceComplex read_nef3(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  SpaceComplex complex = Nef3Reader(text, options, context).read();
  const std::string flaw = flaw_of_links(complex);
  if (!flaw.empty()) throw Error(ErrorCode::BadShape, flaw, {options.name});
  return complex;
}

}  // namespace plumb
