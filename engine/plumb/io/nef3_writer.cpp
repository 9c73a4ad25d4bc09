// Writing of `.nef`.
//
// Tables may hold planes and points of other sets, so the writer first marks what the complex uses,
// transitively through the sources of constructed points, and numbers it: the three axis planes,
// then the frame (all of it or nothing), then the others. Everything is written exactly: planes as
// primitive integer rows, input points as doubles in their shortest form, constructed points by
// their planes. The reader reproduces the same complex. Format: docs/formats.md, section .nef.
// Tested by tests/io/nef3_reader_test.cpp.
#include "plumb/io/nef3_writer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <ostream>
#include <string_view>
#include <vector>

#include "plumb/io/solid/solid_text.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kUnused = 0;
constexpr std::uint32_t kUsed = 1;

class Nef3Writer {
 public:
  Nef3Writer(std::ostream& stream, const SpaceComplex& complex, Context& context)
      : out_(stream, context),
        complex_(complex),
        plane_(complex.planes().size(), kUnused),
        input_(complex.planes().points().size(), kUnused),
        constructed_(complex.points().size(), kUnused) {}

  void write() {
    mark_used();
    number_planes();
    number_points();
    write_header();
    write_planes();
    write_points();
    write_vertices();
    write_edges();
    write_uses();
    write_facets();
    for (const Mark mark : complex_.volume_mark) write_line(mark);
    out_ << "end\n";
    out_.flush();
  }

 private:
  void mark_used();
  void mark_point(SpacePoint p);
  void number_planes();
  void number_points();

  void write_header();
  void write_planes();
  void write_points();
  void write_source(const PointSource& source);
  void write_vertices();
  void write_edges();
  void write_uses();
  void write_facets();

  /// Returns the 1-based number of an id, or 0 if it is invalid.
  template <class Id>
  static std::uint64_t number(Id id) {
    return id.is_valid() ? std::uint64_t{id.value()} + 1 : 0;
  }
  std::uint64_t number(PlaneId p) const { return plane_[p]; }
  std::uint64_t number(SpacePoint p) const {
    return p.is_input() ? input_[p.input()] : constructed_[p.index()];
  }

  template <class... Rest>
  void write_numbers(std::uint64_t first, Rest... rest) {
    out_ << first;
    ((out_ << ' ' << std::uint64_t{rest}), ...);
  }
  template <class... Rest>
  void write_line(std::uint64_t first, Rest... rest) {
    write_numbers(first, rest...);
    out_ << '\n';
  }
  template <class List>
  void write_list(const List& list) {
    for (const auto id : list) out_ << ' ' << number(id);
  }

  TextOutput out_;
  const SpaceComplex& complex_;
  // First, whether an element is used. Then, its number in the file, from 1, in the order of
  // `planes_`.
  IdVector<PlaneId, std::uint32_t> plane_;
  IdVector<InputPointId, std::uint32_t> input_;
  std::vector<std::uint32_t> constructed_;
  std::vector<PlaneId> planes_;
  std::uint32_t point_count_ = 0;
};

/// Marks a point and the planes and input points that define it.
void Nef3Writer::mark_point(SpacePoint p) {
  if (p.is_input()) {
    input_[p.input()] = kUsed;
    return;
  }
  constructed_[p.index()] = kUsed;
  const PointSource& source = complex_.points().source(p);
  for (std::size_t i = 0; i < source.plane_count(); ++i) plane_[source.plane(i)] = kUsed;
  for (std::size_t i = 0; source.is_line() && i < 2; ++i) input_[source.end(i)] = kUsed;
}

void Nef3Writer::mark_used() {
  for (const SpacePoint p : complex_.vertex_point) mark_point(p);
  for (const auto& planes : complex_.edge_planes) {
    for (const PlaneId p : planes) plane_[p] = kUsed;
  }
  for (const PlaneId p : complex_.facet_plane) plane_[p] = kUsed;
}

/// Numbers the axis planes, the frame (all of it or nothing), and the others.
void Nef3Writer::number_planes() {
  planes_ = {kPlaneX, kPlaneY, kPlaneZ};
  const auto& frame = complex_.planes().frame();
  const bool has_frame = std::any_of(frame.begin(), frame.end(),
                                     [&](PlaneId p) { return p.is_valid() && plane_[p] == kUsed; });
  if (has_frame) planes_.insert(planes_.end(), frame.begin(), frame.end());
  for (std::uint32_t p = kPlaneZ.value() + 1; p < plane_.size(); ++p) {
    const PlaneId plane(p);
    if (plane_[p] == kUsed && !complex_.planes().is_frame(plane)) planes_.push_back(plane);
  }
  for (std::uint32_t i = 0; i < planes_.size(); ++i) {
    if (planes_[i].is_valid()) plane_[planes_[i]] = i + 1;
  }
}

void Nef3Writer::number_points() {
  for (std::vector<std::uint32_t>* points :
       std::initializer_list<std::vector<std::uint32_t>*>{&input_, &constructed_}) {
    for (std::uint32_t& point : *points) {
      if (point == kUsed) point = ++point_count_;
    }
  }
}

void Nef3Writer::write_header() {
  out_ << "plumb-nef3 1\n";
  write_line(planes_.size(), point_count_, complex_.vertex_count(), complex_.edge_count(),
             complex_.use_count(), complex_.facet_count(), complex_.volume_count());
}

void Nef3Writer::write_planes() {
  const PlaneTable& table = complex_.planes();
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const bool is_frame = i > 2 && (!planes_[i].is_valid() || table.is_frame(planes_[i]));
    if (is_frame) {
      out_ << "frame " << kFrameSides[i - 3] << '\n';
      continue;
    }
    const IntegerRow row = table.primitive(planes_[i]);
    out_ << exact_text(row[0]) << ' ' << exact_text(row[1]) << ' ' << exact_text(row[2]) << ' '
         << exact_text(row[3]) << '\n';
  }
}

void Nef3Writer::write_points() {
  for (std::uint32_t i = 0; i < input_.size(); ++i) {
    if (input_[i] == kUnused) continue;
    const Point3& p = complex_.planes().point(InputPointId(i));
    out_ << "i " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  }
  for (std::uint32_t i = 0; i < constructed_.size(); ++i) {
    if (constructed_[i] != kUnused) {
      write_source(complex_.points().source(SpacePoint::constructed(i)));
    }
  }
}

void Nef3Writer::write_source(const PointSource& s) {
  if (s.is_line()) {
    out_ << "l ";
    write_line(input_[s.end(0)], input_[s.end(1)], number(s.plane(0)));
  } else {
    out_ << "t ";
    write_line(number(s.plane(0)), number(s.plane(1)), number(s.plane(2)));
  }
}

void Nef3Writer::write_vertices() {
  for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
    write_numbers(number(complex_.vertex_point[v]), complex_.vertex_mark[v],
                  number(complex_.vertex_volume[v]));
    write_list(complex_.star_of(VertexId(v)));
    out_ << '\n';
  }
}

void Nef3Writer::write_edges() {
  for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
    write_line(number(complex_.edge_planes[e][0]), number(complex_.edge_planes[e][1]),
               complex_.edge_mark[e], number(complex_.edge_volume[e]),
               number(complex_.edge_use[e]));
  }
}

void Nef3Writer::write_uses() {
  for (std::size_t u = 0; u < complex_.use_count(); ++u) {
    write_line(number(complex_.use_halfedge[u]), number(complex_.use_next[u]),
               number(complex_.use_radial[u]), number(complex_.use_facet[u]));
  }
}

void Nef3Writer::write_facets() {
  for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
    write_numbers(number(complex_.facet_plane[f]), complex_.facet_mark[f],
                  number(complex_.facet_volume[f][0]), number(complex_.facet_volume[f][1]),
                  complex_.facet_origin[f]);
    const auto cycles = complex_.cycles_of(FacetId(f));
    const auto inner = complex_.inner_of(FacetId(f));
    out_ << ' ' << std::uint64_t{cycles.size()};
    write_list(cycles);
    out_ << ' ' << std::uint64_t{inner.size()};
    write_list(inner);
    out_ << '\n';
  }
}

}  // namespace

void write_nef3(std::ostream& out, const SpaceComplex& complex, Context& context) {
  // The memory of new numbers of planes and points, and of a list of planes that grows.
  MemoryCharge memory(context);
  memory.add(sizeof(std::uint32_t) * (4 * complex.planes().size() +
                                      complex.planes().points().size() + complex.points().size()),
             "numbers of planes and points");
  Nef3Writer(out, complex, context).write();
}

}  // namespace plumb
