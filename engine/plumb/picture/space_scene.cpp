// Scenes of sets of space, and exploded scenes of their parts.
//
// The window surrounds all vertices, and a point of each facet and edge without one, in doubles.
// The set is then intersected exactly with the box of the window, so unbounded facets end on this
// box. Facets on the box are drawn as cuts. Facets are triangulated on their exact complex and
// become patches whose normals point away from the marked volume. A vertex gets a dot if its mark
// does not follow from its edges.
//
// A coloured scene has the edges and dots of the scene of the set, and the triangles of the mesh
// with attributes, whose groups are the colours and textures.
//
// An exploded scene moves every part away from the common middle, in proportion to the distance of
// its own middle.
// Tested by tests/picture/space_scene_test.cpp.
#include "plumb/picture/space_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/convex/decompose.h"
#include "plumb/picture/scene/scene_frame.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/mesh_with_attributes.h"
#include "plumb/space/planar/facet_triangles.h"
#include "plumb/space/source_mesh.h"

namespace plumb {
namespace {

// A part of the longest side. The part that fades out lies within it.
constexpr double kFadingMargin = 0.45;
constexpr double kGoodBox = 1e-9;  // The ratio of the radius to the coordinates.
// In scene units. Points that are not on the box are farther from it.
constexpr double kOnBox = 1e-7;

Point3 normal_of(const SpaceComplex& complex, PlaneId plane) {
  const PlaneRow& row = complex.planes().row(plane);
  const double length = std::hypot(row.n[0], row.n[1], row.n[2]);
  return {row.n[0] / length, row.n[1] / length, row.n[2] / length};
}

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// ---------------------------------------------------------------- the window

/// Finds the window around all vertices, and a point of each facet and edge without one.
class WindowFinder {
 public:
  WindowFinder(const SpaceComplex& complex, SceneFrame& frame) : complex_(complex), frame_(frame) {}

  void run() {
    for (const SpacePoint p : complex_.vertex_point) {
      if (!complex_.points().depends_on_frame(p)) include(place(p));
    }
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      const HalfedgeId h(static_cast<std::uint32_t>(2 * e));
      if (!is_far(complex_.origin[h]) || !is_far(complex_.target(h))) continue;
      const auto& [p, q] = complex_.edge_planes[e];
      if (!complex_.planes().is_frame(p) && !complex_.planes().is_frame(q)) include_line(p, q);
    }
    for (std::size_t f = 0; f < complex_.facet_count(); ++f) {
      if (!complex_.planes().is_frame(complex_.facet_plane[f])) include_plane(FacetId(f));
    }
  }

 private:
  bool is_far(VertexId v) const {
    return complex_.points().depends_on_frame(complex_.vertex_point[v]);
  }
  Point3 place(SpacePoint p) const {
    const PointBox box = complex_.points().box(p);
    const double most =
        std::max({std::fabs(box.mid[0]), std::fabs(box.mid[1]), std::fabs(box.mid[2])});
    if (box.radius <= kGoodBox * most) return {box.mid[0], box.mid[1], box.mid[2]};
    const RationalPoint3 at = exact(complex_.points(), p);
    const auto nearest = [](const Rational& x) { return clamped_to_finite(nearest_double(x)); };
    return {nearest(at.x), nearest(at.y), nearest(at.z)};
  }
  void include(const Point3& p) {
    if (is_finite(p)) frame_.include(p);
  }

  /// Includes the point of the line that is nearest to the origin.
  void include_line(PlaneId p, PlaneId q) {
    const Point3 a = normal_of(complex_, p), b = normal_of(complex_, q), along = cross(a, b);
    const double s = -offset(p), t = -offset(q), w = dot(along, along);
    const Point3 x = cross(b, along), y = cross(along, a);
    include({(s * x.x + t * y.x) / w, (s * x.y + t * y.y) / w, (s * x.z + t * y.z) / w});
  }
  void include_plane(FacetId f) {
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        if (!is_far(complex_.use_origin(u))) return;
        u = complex_.use_next[u];
      } while (u != first);
    }
    const PlaneId plane = complex_.facet_plane[f];
    const Point3 n = normal_of(complex_, plane);
    const double d = -offset(plane);
    include({n.x * d, n.y * d, n.z * d});
  }
  double offset(PlaneId p) const {
    const PlaneRow& row = complex_.planes().row(p);
    return row.d / std::hypot(row.n[0], row.n[1], row.n[2]);
  }

  const SpaceComplex& complex_;
  SceneFrame& frame_;
};

Nef3 inside_box(const Nef3& set, const SceneFrame& frame, Context& context) {
  const Point3 low = frame.low(), high = frame.high();
  const std::array<HalfSpace3, 6> sides = {{{{-1, 0, 0, low.x}, Boundary::Open},
                                            {{1, 0, 0, -high.x}, Boundary::Open},
                                            {{0, -1, 0, low.y}, Boundary::Open},
                                            {{0, 1, 0, -high.y}, Boundary::Open},
                                            {{0, 0, -1, low.z}, Boundary::Open},
                                            {{0, 0, 1, -high.z}, Boundary::Open}}};
  return boolean_op(set, Nef3::intersection(sides, context), kIntersection, context);
}

// ---------------------------------------------------------------- the scene

class SceneMaker {
 public:
  SceneMaker(const SpaceComplex& complex, const SceneFrame& frame, bool fades, Context& context)
      : complex_(complex), frame_(frame), context_(context), triangles_(complex) {
    scene_.fades = fades;
    frame.describe(scene_);
  }

  Scene run() {
    add_points();
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) add_facet(FacetId(f));
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) add_edge(EdgeId(e));
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) add_dot(VertexId(v));
    return std::move(scene_);
  }

 private:
  void add_points() {
    scene_.points.reserve(complex_.vertex_count());
    for (const SpacePoint p : complex_.vertex_point) {
      scene_.points.push_back(p.is_input() ? frame_.at(complex_.planes().point(p.input()))
                                           : frame_.at(exact(complex_.points(), p)));
    }
  }

  /// Returns the set of sides of the box that contain a vertex, one bit for each side.
  unsigned sides_at(VertexId v) const {
    if (!scene_.fades) return 0;
    const Point3& p = scene_.points[v.value()];
    const Point3& h = scene_.half;
    unsigned sides = 0;
    const auto see = [&](double x, double half, unsigned bit) {
      if (std::fabs(std::fabs(x) - half) < kOnBox) sides |= x < 0 ? bit : 2 * bit;
    };
    see(p.x, h.x, 1);
    see(p.y, h.y, 4);
    see(p.z, h.z, 16);
    return sides;
  }
  bool is_on_box(FacetId f) const {
    unsigned sides = scene_.fades ? ~0U : 0U;
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        sides &= sides_at(complex_.use_origin(u));
        u = complex_.use_next[u];
      } while (sides != 0 && u != first);
    }
    return sides != 0;
  }

  bool is_marked(VolumeId v) const { return complex_.volume_mark[v] == 1; }

  /// Adds a facet. Normals point away from the marked volume.
  void add_facet(FacetId f) {
    if (f.value() % 4096 == 0) context_.checkpoint("facets", f.value(), complex_.facet_count());
    const auto& [above, below] = complex_.facet_volume[f];
    const bool is_reversed = is_marked(above) && !is_marked(below);
    const bool is_solid = is_marked(above) || is_marked(below);
    const Paint paint = is_on_box(f)                  ? Paint::Cut
                        : complex_.facet_mark[f] != 1 ? Paint::OpenFacet
                        : is_solid                    ? Paint::ClosedFacet
                                                      : Paint::Sheet;
    const Point3 n = normal_of(complex_, complex_.facet_plane[f]);
    const double sign = is_reversed ? -1 : 1;
    const auto patch = static_cast<std::uint32_t>(scene_.patches.size());
    scene_.patches.push_back({{sign * n.x, sign * n.y, sign * n.z}, paint});
    triangles_.for_each(f, [&](VertexId a, VertexId b, VertexId c) {
      if (is_reversed) std::swap(b, c);
      scene_.triangles.push_back({{a.value(), b.value(), c.value()}, patch});
    });
  }

  void add_edge(EdgeId e) {
    const HalfedgeId h(2 * e.value());
    const VertexId a = complex_.origin[h], b = complex_.target(h);
    if ((sides_at(a) & sides_at(b)) != 0) return;
    Scene::Line line{{a.value(), b.value()}, Paint::Edge, {Scene::kNoPatch, Scene::kNoPatch}};
    const UseId use = complex_.edge_use[e];
    if (complex_.edge_mark[e] != 1) {
      line.paint = Paint::OpenEdge;
    } else if (!use.is_valid()) {
      line.paint = Paint::FreeEdge;
    }
    if (use.is_valid()) {
      const UseId next = complex_.use_radial[use];
      line.patches = {complex_.use_facet[use].value(), complex_.use_facet[next].value()};
    }
    scene_.lines.push_back(line);
  }

  /// Adds a dot for a point whose mark does not follow from the edges.
  void add_dot(VertexId v) {
    if (sides_at(v) != 0) return;
    const bool is_point = complex_.vertex_mark[v] == 1;
    const auto star = complex_.star_of(v);
    const auto is_unlike = [&](HalfedgeId h) {
      return (complex_.edge_mark[SpaceComplex::edge_of(h)] == 1) != is_point;
    };
    const bool says_more = star.empty() || (is_point ? std::ranges::all_of(star, is_unlike)
                                                     : std::ranges::any_of(star, is_unlike));
    if (says_more) scene_.dots.push_back({v.value(), is_point ? Paint::Point : Paint::OpenPoint});
  }

  const SpaceComplex& complex_;
  const SceneFrame& frame_;
  Context& context_;
  FacetTriangles triangles_;
  Scene scene_;
};

}  // namespace

Scene scene_of(const Nef3& set, Context& context) {
  SceneFrame frame;
  WindowFinder(set.complex(), frame).run();
  const bool fades = !set.is_bounded();
  frame.close(fades ? kFadingMargin : 0);
  const Nef3 shown = fades ? inside_box(set, frame, context) : set;
  return SceneMaker(shown.complex(), frame, fades, context).run();
}

// ---------------------------------------------------------------- colours of sources

namespace {

constexpr const char* kColourChannel = "color";
constexpr const char* kTextureChannel = "texcoord_0";
constexpr double kSteps = 15;  // The number of steps of a corner's colour between 0 and 1.

std::uint8_t byte_of(double part) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
}

const MeshChannel* channel_of(const MeshAttributes& attributes, std::string_view name,
                              std::uint32_t least_width) {
  for (const MeshChannel& channel : attributes.channels) {
    if (channel.name == name && channel.width >= least_width) return &channel;
  }
  return nullptr;
}

const MeshChannel* colour_channel(const MeshAttributes& attributes) {
  return channel_of(attributes, kColourChannel, 3);
}

/// The images of the materials of a set.
class Textures {
 public:
  /// Loads each image once into `scene`. Materials have the numbers that mesh_with_attributes()
  /// gives them: the materials of all sources, one source after the other.
  Textures(const Nef3& set, const TextureLoader& load, Scene& scene) {
    std::map<std::pair<std::string, std::string>, std::uint32_t> known;
    for (const PlacedSource& placed : set.sources()) {
      const MeshSource& source = *placed.source;
      const bool has_places = load &&
                              channel_of(source.attributes, kTextureChannel, 2) != nullptr &&
                              !source.attributes.face_material.empty();
      const std::vector<bool> is_used = used_materials(source.attributes);
      for (std::size_t m = 0; m < source.attributes.materials.size(); ++m) {
        const std::string& name = source.attributes.materials[m].texture;
        std::uint32_t texture = Scene::kNoTexture;
        if (has_places && is_used[m] && !name.empty()) {
          const auto [entry, is_new] = known.emplace(std::pair(source.name, name), texture);
          if (is_new) entry->second = add(load(source.name, name), scene);
          texture = entry->second;
        }
        of_material_.push_back(texture);
      }
    }
  }

  /// Returns the texture of a material of the result, or Scene::kNoTexture.
  std::uint32_t of(std::uint32_t material) const {
    return material < of_material_.size() ? of_material_[material] : Scene::kNoTexture;
  }

 private:
  static std::vector<bool> used_materials(const MeshAttributes& attributes) {
    std::vector<bool> is_used(attributes.materials.size());
    for (const std::uint32_t material : attributes.face_material) {
      if (material != MeshAttributes::kNone) is_used[material] = true;
    }
    return is_used;
  }
  static std::uint32_t add(std::optional<TextureImage> image, Scene& scene) {
    if (!image) return Scene::kNoTexture;
    scene.textures.push_back(std::move(*image));
    return static_cast<std::uint32_t>(scene.textures.size() - 1);
  }

  std::vector<std::uint32_t> of_material_;
};

/// The colours of the faces of a mesh of triangles.
class FaceColours {
 public:
  /// The attributes must outlive the object.
  explicit FaceColours(const MeshAttributes& attributes)
      : attributes_(attributes), channel_(colour_channel(attributes)) {}

  /// Returns the colour of a face. If the face has none, returns the colour of `plain`.
  Colour of(std::size_t face, Colour plain) const {
    const std::uint32_t material =
        attributes_.face_material.empty() ? MeshAttributes::kNone : attributes_.face_material[face];
    const bool has_material =
        material != MeshAttributes::kNone && attributes_.materials[material].color.has_value();
    if (!has_material && channel_ == nullptr) return plain;
    Colour colour;
    for (std::size_t i = 0; i < 3; ++i) {
      const double base = has_material ? (*attributes_.materials[material].color)[i] : 1;
      colour[i] = byte_of(base * corner_mean(face, i));
    }
    return colour;
  }

 private:
  /// Returns the mean of a number of the channel at the corners of a face.
  double corner_mean(std::size_t face, std::size_t i) const {
    if (channel_ == nullptr) return 1;
    double sum = 0;
    for (std::size_t c = 3 * face; c < 3 * face + 3; ++c) {
      sum += channel_->values[c * channel_->width + i];
    }
    return std::round(kSteps * sum / 3) / kSteps;
  }

  const MeshAttributes& attributes_;
  const MeshChannel* channel_;
};

/// Returns the unit normal of a triangle, or zero if doubles do not determine it.
Point3 unit_normal(const Point3& a, const Point3& b, const Point3& c) {
  const Point3 n =
      cross(Point3{b.x - a.x, b.y - a.y, b.z - a.z}, Point3{c.x - a.x, c.y - a.y, c.z - a.z});
  const double length = std::hypot(n.x, n.y, n.z);
  return length > 0 ? Point3{n.x / length, n.y / length, n.z / length} : Point3{0, 0, 0};
}

/// Replaces the triangles beside marked volumes by coloured triangles.
void colour_triangles(const MeshWithAttributes& made, const Textures& textures, Scene& scene) {
  const Colour plain = style_of(Paint::ClosedFacet).colour;
  const FaceColours colours(made.attributes);
  const auto point = static_cast<std::uint32_t>(scene.points.size());
  for (const Point3& p : made.mesh.points) {
    const auto along = [&](double x, double quarter_centre) {
      return (x / 4 - quarter_centre) / scene.quarter_scale;
    };
    scene.points.push_back({along(p.x, scene.quarter_centre.x), along(p.y, scene.quarter_centre.y),
                            along(p.z, scene.quarter_centre.z)});
  }
  std::erase_if(scene.triangles, [&](const Scene::Triangle& t) {
    return scene.patches[t.patch].paint != Paint::Sheet;
  });
  if (!scene.textures.empty()) scene.texcoords.resize(scene.triangles.size());
  const MeshChannel* const places = channel_of(made.attributes, kTextureChannel, 2);
  constexpr Colour kWhite{255, 255, 255};
  scene.groups = {{"without a colour", ""}};
  Scene::Layer layer{"colours", {plain}};
  std::map<std::pair<Colour, std::uint32_t>, std::uint32_t> group_of{
      {{plain, Scene::kNoTexture}, 0}};
  for (std::size_t f = 0; f < made.mesh.face_count(); ++f) {
    const auto face = made.mesh.face(f);
    const Scene::Triangle triangle{{point + face[0], point + face[1], point + face[2]},
                                   static_cast<std::uint32_t>(scene.patches.size())};
    const std::uint32_t texture = made.attributes.face_material.empty()
                                      ? Scene::kNoTexture
                                      : textures.of(made.attributes.face_material[f]);
    const Colour colour = colours.of(f, texture == Scene::kNoTexture ? plain : kWhite);
    const auto next = static_cast<std::uint32_t>(scene.groups.size());
    const auto [entry, is_new] = group_of.emplace(std::pair(colour, texture), next);
    if (is_new) {
      scene.groups.push_back({hex(colour), "", texture});
      layer.tints.push_back(colour);
    }
    const auto& [a, b, c] = triangle.corners;
    scene.patches.push_back({unit_normal(scene.points[a], scene.points[b], scene.points[c]),
                             Paint::ClosedFacet, entry->second});
    scene.triangles.push_back(triangle);
    if (scene.textures.empty()) continue;
    std::array<float, 6>& place = scene.texcoords.emplace_back();
    if (texture == Scene::kNoTexture || places == nullptr) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double* const own = &places->values[(3 * f + c) * places->width];
      place[2 * c] = static_cast<float>(own[0]);
      place[2 * c + 1] = static_cast<float>(own[1]);
    }
  }
  scene.layers = {std::move(layer)};
  scene.shown = 1;
}

}  // namespace

bool has_colours(const Nef3& set) {
  return std::ranges::any_of(set.sources(), [](const PlacedSource& placed) {
    const MeshAttributes& attributes = placed.source->attributes;
    return colour_channel(attributes) != nullptr ||
           (!attributes.face_material.empty() &&
            std::ranges::any_of(attributes.materials, [](const MeshMaterial& material) {
              return material.color.has_value();
            }));
  });
}

bool has_textures(const Nef3& set) {
  return std::ranges::any_of(set.sources(), [](const PlacedSource& placed) {
    const MeshAttributes& attributes = placed.source->attributes;
    return channel_of(attributes, kTextureChannel, 2) != nullptr &&
           !attributes.face_material.empty() &&
           std::ranges::any_of(attributes.materials, [](const MeshMaterial& material) {
             return !material.texture.empty();
           });
  });
}

Scene coloured_scene(const Nef3& set, Context& context, const TextureLoader& load_texture) {
  Scene scene = scene_of(set, context);
  if (scene.fades) return scene;
  const Textures textures(set, load_texture, scene);
  if (!has_colours(set) && scene.textures.empty()) return scene;
  colour_triangles(mesh_with_attributes(set, {}, context), textures, scene);
  return scene;
}

namespace {

double middle_of(double low, double high) { return low / 2 + high / 2; }
Point3 middle_of(const SceneFrame& frame) {
  const Point3 low = frame.low(), high = frame.high();
  return {middle_of(low.x, high.x), middle_of(low.y, high.y), middle_of(low.z, high.z)};
}

/// Returns the positions in space of the points of a scene.
std::vector<Point3> unscaled_points(const Scene& scene) {
  const auto along = [&scene](double p, double quarter_centre) {
    return clamped_to_finite(4 * (quarter_centre + scene.quarter_scale * p));
  };
  std::vector<Point3> points;
  for (const Point3& p : scene.points) {
    points.push_back({along(p.x, scene.quarter_centre.x), along(p.y, scene.quarter_centre.y),
                      along(p.z, scene.quarter_centre.z)});
  }
  return points;
}

SceneFrame frame_of(std::span<const Point3> points) {
  SceneFrame frame;
  for (const Point3& p : points) frame.include(p);
  frame.close(0);
  return frame;
}

/// Hatches the facets that cuts made. Each of them has one patch.
void hatch_walls(const SpaceComplex& complex, Scene& scene) {
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    scene.patches[f].is_hatched = is_wall(complex, FacetId(f));
  }
}

/// Appends a scene whose points have been moved to `points`.
void append(const Scene& part, std::span<const Point3> points, Scene& all) {
  const auto point = static_cast<std::uint32_t>(all.points.size());
  const auto patch = static_cast<std::uint32_t>(all.patches.size());
  const auto group = static_cast<std::uint32_t>(all.groups.size());
  all.points.insert(all.points.end(), points.begin(), points.end());
  for (Scene::Patch p : part.patches) {
    p.group = group;
    all.patches.push_back(p);
  }
  for (Scene::Triangle t : part.triangles) {
    for (std::uint32_t& c : t.corners) c += point;
    t.patch += patch;
    all.triangles.push_back(t);
  }
  for (Scene::Line l : part.lines) {
    for (std::uint32_t& e : l.ends) e += point;
    for (std::uint32_t& p : l.patches) p += p == Scene::kNoPatch ? 0 : patch;
    all.lines.push_back(l);
  }
  for (Scene::Dot d : part.dots) {
    d.at += point;
    all.dots.push_back(d);
  }
  all.groups.push_back({"piece " + std::to_string(group + 1), ""});
}

}  // namespace

Scene exploded_scene(std::span<const Nef3> sets, double apart, Context& context) {
  if (!(apart >= 0) || !std::isfinite(apart)) {
    throw Error(ErrorCode::BadArgument, "pieces cannot be moved apart by that");
  }
  Scene all;
  SceneFrame together;
  for (const Nef3& set : sets) {
    if (!set.is_bounded()) {
      throw Error(ErrorCode::BadArgument, "an unbounded set has no middle to be moved");
    }
    Scene part = scene_of(set, context);
    hatch_walls(set.complex(), part);
    const std::vector<Point3> points = unscaled_points(part);
    for (const Point3& p : points) together.include(p);
    append(part, points, all);
  }
  together.close(0);
  const Point3 middle = middle_of(together);

  // The points of a piece are consecutive.
  std::vector<Point3> moved;
  std::size_t begin = 0;
  for (const Nef3& set : sets) {
    const auto own = std::span(all.points).subspan(begin, set.complex().vertex_count());
    begin += own.size();
    const Point3 at = own.empty() ? middle : middle_of(frame_of(own));
    for (const Point3& p : own) {
      moved.push_back({p.x + apart * (at.x - middle.x), p.y + apart * (at.y - middle.y),
                       p.z + apart * (at.z - middle.z)});
      if (!is_finite(moved.back())) {
        throw Error(ErrorCode::BadArgument, "pieces would be moved beyond the largest double");
      }
    }
  }
  const SceneFrame frame = frame_of(moved);
  for (std::size_t i = 0; i < moved.size(); ++i) all.points[i] = frame.at(moved[i]);
  frame.describe(all);

  Scene::Layer layer{"pieces", {}};
  for (std::size_t i = 0; i < sets.size(); ++i) layer.tints.push_back(distinct_colour(i));
  all.layers.push_back(std::move(layer));
  all.shown = 1;
  return all;
}

}  // namespace plumb
