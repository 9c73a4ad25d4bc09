#include "plumb/space/append.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "plumb/space/combine.h"
#include "plumb/space/space_boxes.h"

namespace plumb {
namespace {

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Ids that are not valid stay so.
template <class Id>
void append_shifted(std::vector<Id>& all, const std::vector<Id>& more, std::size_t shift) {
  for (const Id id : more) all.push_back(id.is_valid() ? Id(id.value() + shift) : id);
}

void append_begins(std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& more,
                   std::size_t shift) {
  for (std::size_t i = 1; i < more.size(); ++i) {
    all.push_back(more[i] + static_cast<std::uint32_t>(shift));
  }
}

/// Volume 0 is common.
class VolumeShift {
 public:
  explicit VolumeShift(std::size_t volumes_before)
      : shift_(static_cast<std::uint32_t>(volumes_before - 1)) {}
  VolumeId operator()(VolumeId v) const {
    return v.is_valid() && v.value() != 0 ? VolumeId(v.value() + shift_) : v;
  }

 private:
  std::uint32_t shift_;
};

}  // namespace

namespace {

/// Ways from a box to infinity along the axes, and which of them are free.
class Ways {
 public:
  explicit Ways(const Box3& from) : from_(from) {
    ways_.fill(from);
    for (std::size_t i = 0; i < 3; ++i) {
      ways_[2 * i].low[i] = -Box3::kInfinity;
      ways_[2 * i + 1].high[i] = Box3::kInfinity;
    }
  }
  /// False: the box itself is met, or no way is left.
  bool obstruct(const Box3& by) {
    if (by.meets(from_)) return false;
    for (std::size_t w = 0; w < ways_.size(); ++w) {
      if (by.meets(ways_[w])) is_free_[w] = false;
    }
    return std::ranges::find(is_free_, true) != is_free_.end();
  }

 private:
  Box3 from_;
  std::array<Box3, 6> ways_;
  std::array<bool, 6> is_free_ = {true, true, true, true, true, true};
};

/// Can the box be taken to infinity without meeting the boundary?
bool is_beyond(const SpaceComplex& complex, const Box3& box) {
  Ways ways(box);
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    if (!ways.obstruct(box_of(complex, FacetId(f)))) return false;
  }
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (complex.edge_use[e].is_valid()) continue;
    if (!ways.obstruct(box_of(complex, EdgeId(e)))) return false;
  }
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) {
    if (!complex.star_of(VertexId(v)).empty()) continue;
    if (!ways.obstruct(box_of(complex, VertexId(v)))) return false;
  }
  return true;
}

}  // namespace

namespace {

bool is_beyond(std::span<const Box3> parts, const Box3& box) {
  Ways ways(box);
  return std::ranges::all_of(parts, [&](const Box3& part) { return ways.obstruct(part); });
}

Box3 around(std::span<const Box3> parts) {
  Box3 all;
  for (const Box3& part : parts) all.add(part);
  return all;
}

}  // namespace

bool are_apart(const BoxedComplex& a, const BoxedComplex& b) {
  if (a.complex.vertex_count() == 0 || b.complex.vertex_count() == 0) return false;
  const Box3 of_a = around(a.parts), of_b = around(b.parts);
  if (!of_a.meets(of_b) || is_beyond(a.parts, of_b) || is_beyond(b.parts, of_a)) return true;
  const bool is_a_larger = a.complex.facet_count() > b.complex.facet_count();
  return is_a_larger ? is_beyond(a.complex, of_b) : is_beyond(b.complex, of_a);
}

SpaceComplex appended(SpaceComplex a, SpaceComplex b) {
  unite_tables(a, b);
  const std::size_t vertices = a.vertex_count(), edges = a.edge_count(), uses = a.use_count(),
                    facets = a.facet_count();
  const VolumeShift volume(a.volume_count());
  append(a.vertex_point, b.vertex_point);
  append(a.vertex_mark, b.vertex_mark);
  for (const VolumeId v : b.vertex_volume) a.vertex_volume.push_back(volume(v));
  append_shifted(a.vertex_facet, b.vertex_facet, facets);
  append_begins(a.star_begin, b.star_begin, a.star.size());
  append_shifted(a.star, b.star, 2 * edges);

  append(a.edge_planes, b.edge_planes);
  append(a.edge_mark, b.edge_mark);
  append_shifted(a.edge_use, b.edge_use, uses);
  for (const VolumeId v : b.edge_volume) a.edge_volume.push_back(volume(v));
  append_shifted(a.origin, b.origin, vertices);

  append_shifted(a.use_halfedge, b.use_halfedge, 2 * edges);
  append_shifted(a.use_next, b.use_next, uses);
  append_shifted(a.use_prev, b.use_prev, uses);
  append_shifted(a.use_radial, b.use_radial, uses);
  append_shifted(a.use_facet, b.use_facet, facets);

  append(a.facet_plane, b.facet_plane);
  append(a.facet_mark, b.facet_mark);
  for (const auto& [above, below] : b.facet_volume) {
    a.facet_volume.push_back({volume(above), volume(below)});
  }
  append(a.facet_origin, b.facet_origin);
  append_begins(a.cycle_begin, b.cycle_begin, a.cycle.size());
  append_shifted(a.cycle, b.cycle, uses);
  append_begins(a.inner_begin, b.inner_begin, a.inner.size());
  append_shifted(a.inner, b.inner, vertices);
  a.volume_mark.insert(a.volume_mark.end(), b.volume_mark.begin() + 1, b.volume_mark.end());
  return a;
}

}  // namespace plumb
