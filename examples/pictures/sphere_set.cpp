// A set of the sphere, seen from outside: an SVG file on standard output.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "page.h"
#include "plumb/predicates/rounding.h"
#include "plumb/sphere/nef_sphere.h"

namespace {

using plumb::NefSphere;
using plumb::SphereVector;
using Vector = std::array<double, 3>;

constexpr double kRadius = 180, kCentre = 210;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(Vector v) {
  const double length = std::sqrt(dot(v, v));
  for (double& x : v) x /= length;
  return v;
}
Vector rounded(const SphereVector& v) {
  return unit({plumb::nearest_double(v.x), plumb::nearest_double(v.y), plumb::nearest_double(v.z)});
}

const Vector kTowardsViewer = unit({1, 0.55, 0.62});
const Vector kRight = unit(cross({0, 0, 1}, kTowardsViewer));
const Vector kUp = cross(kTowardsViewer, kRight);

double page_x(const Vector& v) { return kCentre + kRadius * dot(v, kRight); }
double page_y(const Vector& v) { return kCentre - kRadius * dot(v, kUp); }

/// The directions of the set that face the viewer, in rows of a pixel each.
void fill(const NefSphere& set) {
  std::vector<SphereVector> asked;
  std::vector<std::array<int, 2>> pixels;
  const int last = static_cast<int>(kRadius);
  for (int j = -last; j <= last; ++j) {
    for (int i = -last; i <= last; ++i) {
      const double x = i / kRadius, y = j / kRadius, z2 = 1 - x * x - y * y;
      if (z2 <= 0) continue;
      Vector v;
      for (std::size_t k = 0; k < 3; ++k) {
        v[k] = x * kRight[k] + y * kUp[k] + std::sqrt(z2) * kTowardsViewer[k];
      }
      asked.emplace_back(v[0], v[1], v[2]);
      pixels.push_back({i, j});
    }
  }
  const std::vector<plumb::SphereLocation> places = set.locate(asked);
  std::printf("<path class=\"inside\" d=\"");
  for (std::size_t k = 0, end = 0; k < places.size(); k = end + 1) {
    for (end = k; end < places.size() && places[end].marked && pixels[end][1] == pixels[k][1];)
      ++end;
    if (end == k) continue;
    std::printf("M%g %gh%zuv1h-%zuz", kCentre + pixels[k][0] - .5, kCentre - pixels[k][1] - .5,
                end - k, end - k);
    if (end < places.size() && pixels[end][1] != pixels[k][1]) --end;
  }
  std::printf("\"/>\n");
}

/// From `from` counter-clockwise about `normal` by an angle: what of it faces the viewer, or what
/// does not.
void draw_arc(const Vector& from, const Vector& normal, double angle, bool faces, const char* css) {
  constexpr int kSteps = 120;
  const Vector aside = cross(normal, from);
  bool draws = false;
  std::printf("<path class=\"%s\" d=\"", css);
  for (int i = 0; i <= kSteps; ++i) {
    const double t = angle * i / kSteps;
    Vector v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = std::cos(t) * from[k] + std::sin(t) * aside[k];
    const bool is_seen = (dot(v, kTowardsViewer) >= 0) == faces;
    if (is_seen) std::printf("%c%.1f %.1f", draws ? 'L' : 'M', page_x(v), page_y(v));
    draws = is_seen;
  }
  std::printf("\"/>\n");
}

/// An arc of the map: solid if it belongs to the set, faint on the far side.
void draw_arc(const NefSphere& set, std::uint32_t arc) {
  const plumb::SphereMap& map = set.map();
  const Vector normal = rounded(set.normal(arc));
  Vector from = unit(cross(normal, kTowardsViewer));  // of a whole circle: anywhere on it
  double angle = 2 * std::numbers::pi;
  if (!map.is_loop(arc)) {
    from = rounded(set.direction(map.origin[2 * std::size_t{arc}]));
    const Vector to = rounded(set.direction(map.target(2 * arc)));
    const double turn = std::atan2(dot(cross(from, to), normal), dot(from, to));
    angle = turn > 1e-9 ? turn : turn + 2 * std::numbers::pi;
  }
  const bool is_marked = map.arc_mark[arc] != 0;
  draw_arc(from, normal, angle, false, is_marked ? "arc far" : "arc open far");
  draw_arc(from, normal, angle, true, is_marked ? "arc" : "arc open");
}

void draw_point(const NefSphere& set, std::uint32_t point) {
  const Vector v = rounded(set.direction(point));
  if (dot(v, kTowardsViewer) < 0) return;
  const char* const css = set.map().point_mark[point] != 0 ? "dot" : "dot hollow";
  std::printf("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"5\"/>\n", css, page_x(v),
              page_y(v));
}

void draw(const NefSphere& set) {
  std::printf("<circle class=\"ball\" cx=\"%g\" cy=\"%g\" r=\"%g\"/>\n", kCentre, kCentre, kRadius);
  fill(set);
  for (std::uint32_t a = 0; a < set.map().arc_count(); ++a) draw_arc(set, a);
  for (std::uint32_t p = 0; p < set.map().point_count(); ++p) draw_point(set, p);
}

void draw_key(double y, const char* symbol, const char* words) {
  std::printf("%s", symbol);
  text(476, y + 5, "", words);
}

}  // namespace

int main() {
  const SphereVector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const NefSphere octant =
      NefSphere::convex(std::vector<SphereVector>{x, y, z}, plumb::Boundary::Closed);
  const NefSphere north = NefSphere::half_sphere(z, plumb::Boundary::Open);
  const NefSphere rest = north - octant;
  const NefSphere set = rest + NefSphere::point({3, 2, 2}) +
                        NefSphere::arc({4, -3, -2}, {5, 2, -3}, plumb::Boundary::Open);
  if (set.audit()) return 1;
  begin_page(
      720, 420, "A set of the sphere",
      ".ball{fill:#f6f7f9;stroke:#9aa5b1}\n.inside{fill:#cfe2f3}\n"
      ".arc{fill:none;stroke:#0b4f8a;stroke-width:2.6;stroke-linecap:round;stroke-linejoin:round}\n"
      ".open{stroke-dasharray:7 6;stroke-linecap:butt}\n.far{opacity:.3;stroke-width:1.6}\n"
      ".dot{fill:#0b4f8a;stroke:#0b4f8a;stroke-width:2}\n.hollow{fill:#fff}\n"
      ".title{font-weight:bold}\n.sub{fill:#5b6672}\n");
  draw(set);
  text(430, 60, "title", "The northern half-sphere, open,");
  text(430, 80, "title", "without the closed octant x, y, z &gt;= 0,");
  text(430, 100, "title", "with a point and an open arc");
  const plumb::SphereMap& map = set.map();
  std::printf("<text class=\"sub\" x=\"430\" y=\"128\">%zu points, %zu arcs, %zu faces</text>\n",
              map.point_count(), map.arc_count(), map.face_mark.size());
  draw_key(160, "<rect class=\"inside\" x=\"430\" y=\"150\" width=\"32\" height=\"20\"/>\n",
           "in the set");
  draw_key(192, "<path class=\"arc\" d=\"M430 192h32\"/>\n", "arc that belongs to it");
  draw_key(224, "<path class=\"arc open\" d=\"M430 224h32\"/>\n", "arc that does not");
  draw_key(256, "<circle class=\"dot\" cx=\"446\" cy=\"256\" r=\"5\"/>\n",
           "point that belongs to it");
  draw_key(288, "<circle class=\"dot hollow\" cx=\"446\" cy=\"288\" r=\"5\"/>\n",
           "point that does not");
  draw_key(320, "<path class=\"arc far\" d=\"M430 320h32\"/>\n", "on the far side");
  end_page();
}
