// Placing of 3MF objects: transforms in exact arithmetic.
//
// Objects are visited depth first with a stack, so nested components cost no recursion. The stack
// is the path from an item to the current object: an object that is on it contains itself. A few
// nested objects can describe very many placements, so these are counted.
//
// A coordinate is the sum of up to three products and a number. If the transform moves along an
// axis only, the sum of two doubles is tested for exactness before fractions are used; most
// coordinates that slicers write stay doubles then. Tested by tests/io/threemf_test.cpp.
#include "plumb/io/mesh/threemf_build.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kMostNested = 64;
constexpr std::uint64_t kMostPlaced = std::uint64_t{1} << 20U;
constexpr std::size_t kPlacedPerCheckpoint = 4096;

/// Returns the map that applies `b`, then `a`.
ThreeMfTransform product_3mf(const ThreeMfTransform& a, const ThreeMfTransform& b) {
  ThreeMfTransform c;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      Rational& sum = c[3 * column + row];
      if (column == 3) sum = a[9 + row];
      for (std::size_t k = 0; k < 3; ++k) {
        if (a[3 * k + row].sign() != 0) sum += a[3 * k + row] * b[3 * column + k];
      }
    }
  }
  return c;
}

bool is_mirror(const ThreeMfTransform& m) {
  const Rational determinant = m[0] * (m[4] * m[8] - m[5] * m[7]) -
                               m[1] * (m[3] * m[8] - m[5] * m[6]) +
                               m[2] * (m[3] * m[7] - m[4] * m[6]);
  return determinant.sign() < 0;
}

/// A transform, prepared for many points.
class PointMap {
 public:
  explicit PointMap(const ThreeMfTransform& transform) : m_(transform) {
    for (std::size_t row = 0; row < 3; ++row) moved_axis_[row] = axis_moved(row);
  }

  /// Sets three numbers to the image of a point. `exact` is null if the point is `p`.
  void apply(const Point3& p, const RationalPoint3* exact, std::array<ReadNumber, 3>& image) const {
    const std::array<double, 3> numbers{p.x, p.y, p.z};
    for (std::size_t row = 0; row < 3; ++row) {
      const auto& moved = moved_axis_[row];
      if (moved && exact == nullptr) {
        if (const auto sum = exact_sum(numbers[moved->first], moved->second)) {
          image[row].set(*sum);
          continue;
        }
      }
      image[row].set(exact == nullptr
                         ? exact_image(row, {Rational(p.x), Rational(p.y), Rational(p.z)})
                         : exact_image(row, *exact));
    }
  }

 private:
  /// If a row only moves along an axis, returns the axis and the double by which the row moves.
  [[nodiscard]] std::optional<std::pair<std::size_t, double>> axis_moved(std::size_t row) const {
    std::optional<std::size_t> axis;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational& factor = m_[3 * k + row];
      if (factor.sign() == 0) continue;
      if (axis || factor != 1) return {};
      axis = k;
    }
    const double move = nearest_double(m_[9 + row]);
    if (!axis || !std::isfinite(move) || m_[9 + row] != Rational(move)) return {};
    return std::pair(*axis, move);
  }

  /// If the sum of two doubles is a double, returns the sum. The error of the rounded sum is
  /// computed exactly.
  static std::optional<double> exact_sum(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    const double error = (a - (sum - part)) + (b - part);
    if (!std::isfinite(sum) || error != 0) return {};
    return sum;
  }

  [[nodiscard]] Rational exact_image(std::size_t row, const RationalPoint3& p) const {
    Rational sum = m_[9 + row];
    const std::array<const Rational*, 3> parts{&p.x, &p.y, &p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational& factor = m_[3 * k + row];
      if (factor.sign() != 0) sum += factor * *parts[k];
    }
    return sum;
  }

  const ThreeMfTransform& m_;
  std::array<std::optional<std::pair<std::size_t, double>>, 3> moved_axis_;
};

class SceneBuilder3mf {
 public:
  SceneBuilder3mf(const ThreeMfScene& scene, const ThreeMfSettings& settings,
                  const std::string& file, Context& context)
      : scene_(scene),
        settings_(settings),
        file_(file),
        out_(context),
        painter_(scene.looks, context),
        context_(context) {}

  MeshFile build() {
    for (const ThreeMfPlacement& item : scene_.items) place(item);
    const bool has_build = !scene_.items.empty() || scene_.has_lost_items || scene_.objects.empty();
    if (!has_build) place_free_objects();
    for (const std::string& what : scene_.passed) out_.pass_over(what);
    for (const std::string& what : scene_.left_out) out_.leave_out(what);
    MeshFile result = out_.take();
    result.faces_left_out = flat_;
    if (scene_.looks.is_kept) result.attributes = painter_.take(result.mesh);
    if (!has_build) {
      result.notes.emplace_back("the file has no build items; its objects are read as they are");
    }
    add_notes(result.notes);
    return result;
  }

 private:
  /// An object on the path from an item to the current object.
  struct Open {
    std::uint32_t object;
    std::uint32_t next_component;
    // If there is no value, the transform is the identity.
    std::optional<ThreeMfTransform> transform;
  };

  void place(const ThreeMfPlacement& item) {
    open(item, {});
    while (!path_.empty()) {
      Open& top = path_.back();
      if (top.next_component == scene_.objects[top.object].end_component) {
        path_.pop_back();
        continue;
      }
      const ThreeMfPlacement& component = scene_.components[top.next_component++];
      const ThreeMfObject& parent = scene_.objects[top.object];
      if (!is_excluded(parent, component)) {
        const std::optional<ThreeMfTransform> above = top.transform;
        open(component, above);
      }
    }
  }

  /// Places the objects of the first part that are not components.
  void place_free_objects() {
    std::vector<std::uint8_t> is_component(scene_.objects.size());
    for (const ThreeMfPlacement& component : scene_.components) {
      const auto found = scene_.object_of.find({component.part, component.object});
      if (found != scene_.object_of.end()) is_component[found->second] = 1;
    }
    for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
      const ThreeMfObject& object = scene_.objects[i];
      ThreeMfPlacement item;
      item.object = object.id;
      if (object.part == 0 && is_component[i] == 0) place(item);
    }
  }

  bool is_excluded(const ThreeMfObject& parent, const ThreeMfPlacement& component) {
    if (parent.part != 0 || settings_.components.empty()) return false;
    const auto found = settings_.components.find({parent.id, component.object});
    if (found == settings_.components.end()) return false;
    out_.leave_out(found->second);
    return true;
  }

  /// Appends an object to the path. If the object has a mesh, adds it.
  void open(const ThreeMfPlacement& placement, const std::optional<ThreeMfTransform>& above) {
    count_placement(placement);
    const std::uint32_t number = object_of(placement);
    const ThreeMfObject& object = scene_.objects[number];
    if (object.type != ThreeMfType::Model) return leave_out(object.type);
    for (const Open& each : path_) {
      if (each.object == number) {
        fail(placement, ErrorCode::BadShape,
             "object " + std::to_string(object.id) + " contains itself");
      }
    }
    if (path_.size() >= kMostNested) {
      fail(placement, ErrorCode::ResourceLimit,
           "objects are nested more than " + std::to_string(kMostNested) + " deep");
    }
    path_.push_back({number, object.first_component, composed(above, placement)});
    if (object.end_face > object.first_face) add_mesh(placement, object);
  }

  void count_placement(const ThreeMfPlacement& placement) {
    if (placed_++ % kPlacedPerCheckpoint == 0) context_.checkpoint("place", placed_, 0);
    if (placed_ > kMostPlaced) {
      fail(placement, ErrorCode::ResourceLimit, "more than 2^20 objects are placed");
    }
  }

  std::uint32_t object_of(const ThreeMfPlacement& placement) const {
    const auto found = scene_.object_of.find({placement.part, placement.object});
    if (found != scene_.object_of.end()) return found->second;
    fail(placement, ErrorCode::BadIndex,
         "there is no object " + std::to_string(placement.object) + " in " +
             plumb::quoted(scene_.parts[placement.part].name));
  }

  void leave_out(ThreeMfType type) {
    out_.leave_out(type == ThreeMfType::Support   ? "support objects"
                   : type == ThreeMfType::Surface ? "surface objects"
                                                  : "objects that are no parts of the model");
  }

  /// Returns the transform of a placement below `above`. Its translation is in the unit of its
  /// part.
  std::optional<ThreeMfTransform> composed(const std::optional<ThreeMfTransform>& above,
                                           const ThreeMfPlacement& placement) const {
    if (placement.transform == ThreeMfPlacement::kNoTransform) return above;
    ThreeMfTransform here = scene_.transforms[placement.transform];
    const Rational& unit = scene_.parts[placement.stated_in].unit;
    if (unit != 1) {
      for (std::size_t row = 0; row < 3; ++row) here[9 + row] *= unit;
    }
    return above ? product_3mf(*above, here) : here;
  }

  /// Adds the mesh of the object on top of the path.
  void add_mesh(const ThreeMfPlacement& placement, const ThreeMfObject& object) {
    std::optional<ThreeMfTransform> transform = path_.back().transform;
    const Rational& unit = scene_.parts[object.part].unit;
    if (unit != 1) {
      const ThreeMfTransform scale{unit, 0, 0, 0, unit, 0, 0, 0, unit, 0, 0, 0};
      transform = transform ? product_3mf(*transform, scale) : scale;
    }
    try {
      const std::uint32_t base = out_.point_count();
      add_points(object, transform);
      add_faces(object, base, transform && is_mirror(*transform));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::ResourceLimit || !error.place().file.empty()) throw;
      fail(placement, error.code(), error.message());
    }
  }

  void add_points(const ThreeMfObject& object, const std::optional<ThreeMfTransform>& transform) {
    const PolygonMesh& mesh = scene_.source.mesh();
    std::optional<PointMap> map;
    if (transform) map.emplace(*transform);
    auto exact = std::lower_bound(
        mesh.exact.begin(), mesh.exact.end(), object.first_point,
        [](const auto& entry, std::uint32_t point) { return entry.first < point; });
    std::array<ReadNumber, 3> image;
    for (std::uint32_t i = object.first_point; i < object.end_point; ++i) {
      watch();
      const bool is_exact = exact != mesh.exact.end() && exact->first == i;
      const RationalPoint3* const fractions = is_exact ? &exact->second : nullptr;
      if (is_exact) ++exact;
      if (map) {
        map->apply(mesh.points[i], fractions, image);
        out_.add_point(image[0], image[1], image[2]);
      } else if (is_exact) {
        image[0].set(fractions->x);
        image[1].set(fractions->y);
        image[2].set(fractions->z);
        out_.add_point(image[0], image[1], image[2]);
      } else {
        out_.add_point(mesh.points[i]);
      }
    }
  }

  /// Adds the triangles that belong to the shape, except those with equal corners.
  void add_faces(const ThreeMfObject& object, std::uint32_t base, bool turns) {
    const std::uint32_t name = name_of_top();
    std::vector<ThreeMfSettings::Range> excluded;
    for (const ThreeMfSettings::Range& range : settings_.ranges) {
      if (object.part == 0 && range.object == object.id) excluded.push_back(range);
    }
    for (std::uint32_t f = object.first_face; f < object.end_face; ++f) {
      watch();
      const std::uint32_t number = f - object.first_face;
      const auto range = std::find_if(excluded.begin(), excluded.end(), [&](const auto& each) {
        return each.first <= number && number <= each.last;
      });
      if (range != excluded.end()) {
        out_.leave_out(range->called);
        continue;
      }
      add_face(f, base - object.first_point, turns, name);
    }
  }

  /// Returns the name of the last object of the path. If it has no name, returns the name of the
  /// innermost object above it that has one.
  std::uint32_t name_of_top() const {
    for (std::size_t i = path_.size(); i-- > 0;) {
      const std::uint32_t name = scene_.objects[path_[i].object].name;
      if (name != ThreeMfLook::kNone) return name;
    }
    return ThreeMfLook::kNone;
  }

  void add_face(std::uint32_t face, std::uint32_t shift, bool turns, std::uint32_t name) {
    const std::span<const std::uint32_t> corners = scene_.source.mesh().face(face);
    const std::uint32_t a = corners[0];
    const std::uint32_t b = corners[turns ? 2 : 1];
    const std::uint32_t c = corners[turns ? 1 : 2];
    if (a == b || b == c || c == a) {
      ++flat_;
      return;
    }
    for (const std::uint32_t corner : {a, b, c}) out_.add_corner(corner + shift);
    out_.end_face();
    if (scene_.looks.is_kept) painter_.add_face(face, name, turns);
  }

  void watch() {
    if (++steps_ % kPlacedPerCheckpoint == 0) context_.checkpoint("place", steps_, 0);
  }

  void add_notes(std::vector<std::string>& notes) const {
    if (flat_ > 0) {
      notes.push_back("triangles with two equal corners, left out: " + std::to_string(flat_));
    }
    for (const ThreeMfPart& part : scene_.parts) {
      if (part.unit == 1 || part.unit_name.empty()) continue;
      const std::string of_part = part.name.empty() ? "" : " of " + plumb::quoted(part.name);
      notes.push_back("the unit" + of_part + " is the " + part.unit_name +
                      "; the coordinates are scaled to millimetres");
    }
  }

  /// Throws an error with the place of the tag of a placement. An object that is placed without an
  /// item has no tag.
  [[noreturn]] void fail(const ThreeMfPlacement& placement, ErrorCode code,
                         const std::string& message) const {
    throw Error(code, message,
                {threemf_text_name(file_, scene_.parts[placement.stated_in].name), placement.line,
                 placement.column});
  }

  const ThreeMfScene& scene_;
  const ThreeMfSettings& settings_;
  const std::string& file_;
  MeshCollector out_;
  ThreeMfPainter painter_;
  Context& context_;
  std::vector<Open> path_;
  std::uint64_t placed_ = 0;
  std::uint64_t steps_ = 0;
  std::size_t flat_ = 0;
};

}  // namespace

MeshFile build_threemf(const ThreeMfScene& scene, const ThreeMfSettings& settings,
                       const std::string& file, Context& context) {
  return SceneBuilder3mf(scene, settings, file, context).build();
}

}  // namespace plumb
