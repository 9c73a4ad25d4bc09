#include "plumb/io/merge_points.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace plumb {
namespace {

constexpr std::uint32_t kNone = 0xffff'ffff;

class PointMerger {
 public:
  explicit PointMerger(PolygonMesh& mesh) : mesh_(mesh) {}

  std::size_t merge() {
    find_first_of_equals();
    keep_sound_faces();
    renumber_points();
    return dropped_;
  }

 private:
  struct Key {
    Point3 point;
    std::uint32_t index;
  };
  void find_first_of_equals();
  bool is_before(const Key& a, const Key& b) const;
  bool is_equal(const Key& a, const Key& b) const;
  const RationalPoint3* exact(std::uint32_t point) const;
  void keep_sound_faces();
  void renumber_points();

  PolygonMesh& mesh_;
  std::vector<std::uint32_t> first_;  // per point: the first one equal to it
  std::size_t dropped_ = 0;
};

/// Null when the doubles say it all.
const RationalPoint3* PointMerger::exact(std::uint32_t point) const {
  const auto found =
      std::lower_bound(mesh_.exact.begin(), mesh_.exact.end(), point,
                       [](const auto& entry, std::uint32_t p) { return entry.first < p; });
  return found != mesh_.exact.end() && found->first == point ? &found->second : nullptr;
}

/// By place, then by index; points of the same doubles by their exact coordinates, those without first.
bool PointMerger::is_before(const Key& a, const Key& b) const {
  const auto place = [](const Point3& p) { return std::tie(p.x, p.y, p.z); };
  if (place(a.point) != place(b.point)) return place(a.point) < place(b.point);
  const RationalPoint3* const p = mesh_.exact.empty() ? nullptr : exact(a.index);
  const RationalPoint3* const q = mesh_.exact.empty() ? nullptr : exact(b.index);
  if (p == nullptr || q == nullptr || *p == *q) {
    return (p != nullptr) != (q != nullptr) ? p == nullptr : a.index < b.index;
  }
  return std::tie(p->x, p->y, p->z) < std::tie(q->x, q->y, q->z);
}

bool PointMerger::is_equal(const Key& a, const Key& b) const {
  if (!(a.point == b.point)) return false;
  if (mesh_.exact.empty()) return true;
  const RationalPoint3* const p = exact(a.index);
  const RationalPoint3* const q = exact(b.index);
  return p == nullptr || q == nullptr ? p == q : *p == *q;
}

void PointMerger::find_first_of_equals() {
  std::vector<Key> keys(mesh_.points.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = {mesh_.points[i], i};
  std::sort(keys.begin(), keys.end(),
            [this](const Key& a, const Key& b) { return is_before(a, b); });
  first_.resize(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const bool is_new = k == 0 || !is_equal(keys[k - 1], keys[k]);
    first_[keys[k].index] = is_new ? keys[k].index : first_[keys[k - 1].index];
  }
}

void PointMerger::keep_sound_faces() {
  PolygonMesh kept;
  std::vector<std::uint32_t> face;
  for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
    face.clear();
    for (const std::uint32_t v : mesh_.face(f)) face.push_back(first_[v]);
    const bool is_sound =
        face.front() != face.back() && std::adjacent_find(face.begin(), face.end()) == face.end();
    dropped_ += is_sound ? 0 : 1;
    if (is_sound) kept.add_face(face);
  }
  mesh_.face_begin = std::move(kept.face_begin);
  mesh_.corners = std::move(kept.corners);
}

void PointMerger::renumber_points() {
  std::vector<std::uint32_t> number(mesh_.points.size(), kNone);
  PolygonMesh used;
  for (std::uint32_t& corner : mesh_.corners) {
    std::uint32_t& now = number[corner];
    if (now == kNone) {
      now = static_cast<std::uint32_t>(used.points.size());
      used.points.push_back(mesh_.points[corner]);
      const RationalPoint3* const p = exact(corner);
      if (p != nullptr) used.exact.emplace_back(now, *p);
    }
    corner = now;
  }
  mesh_.points = std::move(used.points);
  mesh_.exact = std::move(used.exact);
}

}  // namespace

std::size_t merge_equal_points(PolygonMesh& mesh, Context& context) {
  constexpr std::uint64_t kPointBytes = 96;   // key, first, number, and a copy
  constexpr std::uint64_t kCornerBytes = 16;  // a copy of the faces
  MemoryCharge charge(context);
  charge.add(kPointBytes * mesh.points.size() + kCornerBytes * mesh.corners.size(),
             "the vertices of the mesh");
  return PointMerger(mesh).merge();
}

}  // namespace plumb
