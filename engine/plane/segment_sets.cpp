#include "plumb/plane/segment_sets.h"

#include "plumb/base/error.h"

namespace plumb {
namespace {

// The finisher of MurmurHash3 (Appleby): one to one.
std::uint32_t priority(SegmentId s) {
  std::uint32_t h = s.value();
  h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
  h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
  return h ^ (h >> 16U);
}

}  // namespace

void SegmentSets::begin_change() {
  own_from_ = nodes_.size();
  free_ = Set();
}

SegmentSets::Set SegmentSets::make(SegmentId key, Set left, Set right) {
  if (!left.is_valid() && !right.is_valid()) return Set(key.value());
  if (free_.is_valid()) {
    const Set reused = free_;
    free_ = node(reused).left;
    node(reused) = {key, left, right};
    return reused;
  }
  if (curves_ + nodes_.size() >= Set::kInvalid) {
    throw Error(ErrorCode::ResourceLimit, "too many overlaps for ids of 32 bits");
  }
  nodes_.push_back({key, left, right});
  return Set(curves_ + nodes_.size() - 1);
}

SegmentSets::Set SegmentSets::with_halves(Set set, Set left, Set right) {
  const SegmentId s = key(set);
  release(set);
  return make(s, left, right);
}

void SegmentSets::release(Set set) {
  if (!is_own(set)) return;
  node(set).left = free_;
  free_ = set;
}

SegmentSets::Halves SegmentSets::split(Set set, SegmentId at) {
  if (!set.is_valid()) return {};
  if (key(set) < at) {
    const Halves h = split(right(set), at);
    return {with_halves(set, left(set), h.less), h.greater};
  }
  const Halves h = split(left(set), at);
  return {h.less, with_halves(set, h.greater, right(set))};
}

SegmentSets::Set SegmentSets::join(Set less, Set greater) {
  if (!less.is_valid()) return greater;
  if (!greater.is_valid()) return less;
  if (priority(key(less)) > priority(key(greater))) {
    return with_halves(less, left(less), join(right(less), greater));
  }
  return with_halves(greater, join(less, left(greater)), right(greater));
}

SegmentSets::Set SegmentSets::with(Set set, SegmentId s) {
  if (!set.is_valid()) return Set(s.value());
  if (priority(key(set)) < priority(s)) {
    const Halves h = split(set, s);
    return make(s, h.less, h.greater);
  }
  if (s < key(set)) return with_halves(set, with(left(set), s), right(set));
  return with_halves(set, left(set), with(right(set), s));
}

SegmentSets::Set SegmentSets::without(Set set, SegmentId s) {
  if (key(set) == s) {
    const Halves h{left(set), right(set)};
    release(set);
    return join(h.less, h.greater);
  }
  if (s < key(set)) return with_halves(set, without(left(set), s), right(set));
  return with_halves(set, left(set), without(right(set), s));
}

void SegmentSets::append(Set set, std::vector<SegmentId>& curves) const {
  std::vector<Set> path;
  while (set.is_valid() || !path.empty()) {
    for (; set.is_valid(); set = left(set)) path.push_back(set);
    curves.push_back(key(path.back()));
    set = right(path.back());
    path.pop_back();
  }
}

}  // namespace plumb
