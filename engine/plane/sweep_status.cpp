#include "plumb/plane/sweep_status.h"

#include <utility>

namespace plumb {
namespace {

// One step of splitmix64 (Steele, Lea and Flood 2014); a fixed start keeps runs alike.
std::uint32_t next_random(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15ULL);
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return static_cast<std::uint32_t>(z >> 32U);
}

}  // namespace

StatusNode SweepStatus::allocate(SegmentId s) {
  StatusNode n(nodes_.size());
  if (free_.empty()) {
    nodes_.emplace_back();
  } else {
    n = free_.back();
    free_.pop_back();
    at(n) = Node();
  }
  at(n).segment = s;
  at(n).priority = next_random(random_state_);
  return n;
}

StatusNode SweepStatus::insert_above(StatusNode below, SegmentId s) {
  const StatusNode n = allocate(s);
  attach(n, below);
  thread(n, below);
  sift_up(n);
  return n;
}

// The free child slot between `below` and its successor: one of the two always has it.
void SweepStatus::attach(StatusNode n, StatusNode below) {
  if (below.is_valid() && !at(below).right.is_valid()) {
    at(below).right = n;
    at(n).parent = below;
    return;
  }
  const StatusNode above = below.is_valid() ? at(below).next : first_;
  if (!above.is_valid()) {
    root_ = n;
    return;
  }
  at(above).left = n;
  at(n).parent = above;
}

void SweepStatus::thread(StatusNode n, StatusNode below) {
  const StatusNode above = below.is_valid() ? at(below).next : first_;
  at(n).prev = below;
  at(n).next = above;
  if (above.is_valid()) at(above).prev = n;
  if (below.is_valid()) {
    at(below).next = n;
  } else {
    first_ = n;
  }
}

void SweepStatus::sift_up(StatusNode n) {
  while (at(n).parent.is_valid() && at(at(n).parent).priority < at(n).priority) rotate_up(n);
}

void SweepStatus::rotate_up(StatusNode n) {
  const StatusNode p = at(n).parent;
  const StatusNode grandparent = at(p).parent;
  const bool is_left = at(p).left == n;
  const StatusNode inner = is_left ? at(n).right : at(n).left;
  (is_left ? at(p).left : at(p).right) = inner;
  if (inner.is_valid()) at(inner).parent = p;
  (is_left ? at(n).right : at(n).left) = p;
  at(p).parent = n;
  at(n).parent = grandparent;
  replace_child(grandparent, p, n);
}

void SweepStatus::replace_child(StatusNode parent, StatusNode old_child, StatusNode new_child) {
  if (!parent.is_valid()) {
    root_ = new_child;
  } else if (at(parent).left == old_child) {
    at(parent).left = new_child;
  } else {
    at(parent).right = new_child;
  }
}

void SweepStatus::erase(StatusNode n) {
  while (at(n).left.is_valid() && at(n).right.is_valid()) {
    const StatusNode l = at(n).left;
    const StatusNode r = at(n).right;
    rotate_up(at(l).priority > at(r).priority ? l : r);
  }
  const StatusNode child = at(n).left.is_valid() ? at(n).left : at(n).right;
  if (child.is_valid()) at(child).parent = at(n).parent;
  replace_child(at(n).parent, n, child);
  const StatusNode below = at(n).prev;
  const StatusNode above = at(n).next;
  if (above.is_valid()) at(above).prev = below;
  (below.is_valid() ? at(below).next : first_) = above;
  free_.push_back(n);
}

}  // namespace plumb
