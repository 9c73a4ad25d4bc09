// Sums over results, made without memory of their own, or with some that is never refused.
#pragma once

#include <bit>
#include <cstdint>
#include <ostream>
#include <streambuf>

#include "generate/counted_memory.h"
#include "plumb/io/map_report_io.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/plane/map_check.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/surface/surface.h"

namespace plumb::testing {

/// A stream that adds up what is written.
class Digest : public std::streambuf, public std::ostream {
 public:
  Digest() : std::ostream(this) { exceptions(std::ios::badbit); }
  std::uint64_t value() const { return value_; }

  void add(std::uint64_t number) { value_ = (value_ ^ number) * 0x100000001b3U; }
  void add(const Rational& number) {
    unrefused([&] { return &(*this << number << ' '); });
  }
  void add_bits(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  template <class Numbers>
  void add_all(const Numbers& numbers) {
    add(numbers.size());
    for (const auto number : numbers) add(static_cast<std::uint64_t>(number));
  }
  template <class Ids>
  void add_ids(const Ids& ids) {
    add(ids.size());
    for (const auto id : ids) add(id.value());
  }

 private:
  std::streambuf::int_type overflow(std::streambuf::int_type c) override {
    add(static_cast<std::uint64_t>(c));
    return c;
  }
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

inline std::uint64_t digest_of(const Nef2& set, Context& context) {
  Digest out;
  PlaneText(set, PlaneFormat::Nef2, context).write(out, context);
  return out.value();
}

inline std::uint64_t digest_of(const Nef3& set) {
  Digest out;
  write_nef3(out, set.complex());
  return out.value();
}

inline void add(const SphereVector& vector, Digest& out) {
  for (const Rational* number : {&vector.x, &vector.y, &vector.z}) out.add(*number);
}

inline std::uint64_t digest_of(const NefSphere& set) {
  Digest out;
  const SphereMap& map = set.map();
  for (const auto* marks : {&map.point_mark, &map.arc_mark, &map.face_mark}) out.add_all(*marks);
  for (const auto* links : {&map.first_out, &map.point_face, &map.origin, &map.next, &map.face}) {
    out.add_all(*links);
  }
  return unrefused([&] {
    for (std::uint32_t p = 0; p < map.point_count(); ++p) add(set.direction(p), out);
    for (std::uint32_t a = 0; a < map.arc_count(); ++a) add(set.normal(a), out);
    return out.value();
  });
}

inline void add(const SurfacePointTable& points, SurfacePointId p, Digest& out) {
  const SurfacePlace place = points.place(p);
  out.add(static_cast<std::uint64_t>(place));
  if (place == SurfacePlace::Vertex) out.add(points.vertex(p).value());
  if (place == SurfacePlace::Edge) out.add(points.edge(p).value());
  if (place == SurfacePlace::Face) out.add(points.face(p).value());
  const RationalPoint2 exact = unrefused([&] { return points.exact(p); });
  out.add(exact.x);
  out.add(exact.y);
}

inline std::uint64_t digest_of(const SurfacePolygons& polygons) {
  Digest out;
  for (std::uint32_t p = 0; p < polygons.points.size(); ++p) {
    add(polygons.points, SurfacePointId(p), out);
  }
  out.add_all(polygons.begin);
  out.add_ids(polygons.point);
  out.add_ids(polygons.face);
  out.add_all(polygons.is_control);
  return out.value();
}

inline std::uint64_t digest_of(const SurfaceScene& scene) {
  Digest out;
  const SurfaceMesh& mesh = *scene.mesh;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const Point3& point = mesh.point(VertexId(v));
    for (const double number : {point.x, point.y, point.z}) out.add_bits(number);
  }
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) out.add_all(mesh.corners(FaceId(f)));
  out.add(digest_of(scene.polygons));
  if (scene.shapes) {
    for (const auto& shape : *scene.shapes) out.add_all(shape);
  }
  out.add(scene.outside.value());
  for (const SurfaceLevel& level : scene.levels) {
    out.add(level.shape);
    out.add(level.face.value());
    out.add(static_cast<std::uint64_t>(level.label));
  }
  return out.value();
}

inline std::uint64_t digest_of(const SurfaceDivision& division) {
  Digest out;
  for (std::uint32_t c = 0; c < division.cell_count(); ++c) {
    const auto labels = division.labels(CellId(c));
    out.add(labels.size());
    for (const SignedEntry& entry : labels) {
      out.add(entry.id);
      out.add(static_cast<std::uint64_t>(entry.value));
    }
  }
  return out.value();
}

inline std::uint64_t digest_of(const SurfaceResult& result) {
  Digest out;
  out.add_all(result.region.is_selected);
  out.add_all(result.region.generators);
  out.add_bits(result.region.area);
  out.add(digest_of(result.borders));
  return out.value();
}

inline std::uint64_t digest_of(const MapReport& report) {
  Digest out;
  write_map_report_text(out, report);
  return out.value();
}

}  // namespace plumb::testing
