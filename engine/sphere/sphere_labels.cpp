#include "plumb/sphere/sphere_labels.h"

#include <algorithm>

namespace plumb {
namespace {

constexpr std::uint32_t kNone = SphereMap::kNone;

SphereCell face_cell(std::uint32_t face) {
  return face == kNone ? SphereCell() : SphereCell::face(face);
}

}  // namespace

// ---------------------------------------------------------------- what the contacts tell

void SphereLabels::take_known(const SphereContacts& contacts) {
  point_cell_ = contacts.cell;
  const SphereMap& map = pieces_->map;
  for (std::size_t k = 0; k < 2; ++k) {
    label_[k].assign(map.arc_count(), kNone);
    stack_.clear();
    for (std::uint32_t v = 0; v < map.point_count(); ++v) {
      if (point_cell_[v][k].is_valid() && map.first_out[v] != kNone) label_around(k, v);
    }
    flood(k);
  }
}

void SphereLabels::set_label(std::size_t k, std::uint32_t half, std::uint32_t face) {
  const std::uint32_t piece = half / 2;
  if (face == kNone || pieces_->arc[piece][k] != kNone || label_[k][piece] != kNone) return;
  label_[k][piece] = face;
  stack_.push_back(piece);
}

/// Clockwise: the face to the right of a half-arc of map k holds what follows.
void SphereLabels::label_around(std::size_t k, std::uint32_t point) {
  const SphereMap& map = pieces_->map;
  const SphereCell cell = point_cell_[point][k];
  std::uint32_t face = kNone;
  if (cell.kind() == SphereCell::Kind::Point) face = map_[k]->point_face[cell.index()];
  const std::uint32_t first = map.first_out[point];
  const int rounds = face == kNone ? 2 : 1;  // the first of two comes upon a half-arc of map k
  for (int round = 0; round < rounds; ++round) {
    std::uint32_t h = first;
    do {
      const std::uint32_t a = pieces_->arc[h / 2][k];
      if (a != kNone) {
        face = map_[k]->face[2 * a + ((h & 1U) ^ 1U)];
      } else {
        set_label(k, h, face);
      }
      h = map.clockwise(h);
    } while (h != first);
  }
}

void SphereLabels::flood(std::size_t k) {
  const SphereMap& map = pieces_->map;
  while (!stack_.empty()) {
    const std::uint32_t piece = stack_.back();
    stack_.pop_back();
    for (const std::uint32_t start : {2 * piece, 2 * piece + 1}) {
      const std::uint32_t v = map.origin[start];
      if (point_cell_[v][k].is_valid()) continue;
      point_cell_[v][k] = SphereCell::face(label_[k][piece]);
      std::uint32_t h = start;
      do {
        set_label(k, h, label_[k][piece]);
        h = map.clockwise(h);
      } while (h != start);
    }
  }
}

// ---------------------------------------------------------------- connected parts

std::uint32_t SphereLabels::cycle_of(SphereSlot slot) const {
  return slot.half_arc != kNone ? pieces_->map.face[slot.half_arc]
                                : pieces_->map.point_face[slot.point];
}

void SphereLabels::join_cycles() {
  make_singles(class_, pieces_->cycle_count + pieces_->map.point_count());
  for (const SphereParts::Link& l : parts_.links()) {
    unite(class_, cycle_of(l.first), cycle_of(l.second));
  }
  if (pieces_->map.arc_count() == 0) std::fill(class_.begin(), class_.end(), 0U);
}

SphereCell SphereLabels::half_cell(std::size_t k, std::uint32_t half) const {
  const std::uint32_t a = pieces_->arc[half / 2][k];
  return face_cell(a != kNone ? map_[k]->face[2 * a + (half & 1U)] : label_[k][half / 2]);
}

/// The face of map k at a slot; kNone: the part touches nothing of it.
std::uint32_t SphereLabels::face_at(std::size_t k, SphereSlot slot) const {
  if (slot.half_arc != kNone) {
    const SphereCell cell = half_cell(k, slot.half_arc);
    return cell.is_valid() ? cell.index() : kNone;
  }
  const SphereCell cell = point_cell_[slot.point][k];
  if (!cell.is_valid()) return kNone;
  return cell.kind() == SphereCell::Kind::Point ? map_[k]->point_face[cell.index()] : cell.index();
}

bool SphereLabels::pass_label(std::size_t k, SphereSlot from, SphereSlot to) {
  std::uint32_t& label = part_label_[k][parts_.of(to)];
  if (label != kNone || face_at(k, to) != kNone) return false;
  label = face_at(k, from);
  if (label == kNone) label = part_label_[k][parts_.of(from)];
  return label != kNone;
}

/// Parts that touch nothing of map k get the face of those that they are linked with.
void SphereLabels::label_parts(std::size_t k) {
  part_label_[k].assign(parts_.bound(), kNone);
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const SphereParts::Link& l : parts_.links()) {
      if (pass_label(k, l.first, l.second)) goes_on = true;
      if (pass_label(k, l.second, l.first)) goes_on = true;
    }
  }
  // Nothing of map k is anywhere, or there are isolated points alone.
  for (std::uint32_t& label : part_label_[k]) {
    if (label == kNone) label = 0;
  }
}

// ---------------------------------------------------------------- faces and cells

void SphereLabels::number_faces(SphereOrigins& cells) {
  SphereMap& map = pieces_->map;
  face_number_.assign(class_.size() + 1, kNone);
  const auto number = [&](SphereSlot slot) {
    std::uint32_t& face = face_number_[find_root(class_, cycle_of(slot))];
    if (face == kNone) {
      face = static_cast<std::uint32_t>(cells.face.size());
      SphereOrigins::Pair pair;
      for (std::size_t k = 0; k < 2; ++k) {
        const std::uint32_t f = face_at(k, slot);
        pair[k] = SphereCell::face(f != kNone ? f : part_label_[k][parts_.of(slot)]);
      }
      cells.face.push_back(pair);
    }
    return face;
  };
  for (std::uint32_t h = 0; h < map.face.size(); ++h) map.face[h] = number({h, kNone});
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (map.first_out[v] == kNone) map.point_face[v] = number({kNone, v});
  }
  if (cells.face.empty()) cells.face.push_back({SphereCell::face(0), SphereCell::face(0)});
}

void SphereLabels::fill_cells(SphereOrigins& cells) {
  const SphereMap& map = pieces_->map;
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    SphereOrigins::Pair pair = point_cell_[v];
    for (std::size_t k = 0; k < 2; ++k) {
      if (!pair[k].is_valid()) pair[k] = SphereCell::face(part_label_[k][parts_.of_point(v)]);
    }
    cells.point.push_back(pair);
  }
  for (std::uint32_t i = 0; i < map.arc_count(); ++i) {
    SphereOrigins::Pair pair;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t a = pieces_->arc[i][k];
      const std::uint32_t face = label_[k][i];
      pair[k] = a != kNone
                    ? SphereCell::arc(a)
                    : SphereCell::face(face != kNone ? face : part_label_[k][parts_.of_arc(i)]);
    }
    cells.arc.push_back(pair);
  }
}

void SphereLabels::build(const PlaneTable& planes, const SphereMap& a, const SphereMap& b,
                         const SphereContacts& contacts, SpherePieces& pieces, SphereOrigins& cells,
                         SphereLimits* limits) {
  planes_ = &planes;
  map_ = {&a, &b};
  pieces_ = &pieces;
  for (auto* pairs : {&cells.point, &cells.arc, &cells.face}) pairs->clear();
  take_known(contacts);
  parts_.find(planes, pieces.map);
  look(limits);
  join_cycles();
  look(limits);
  for (std::size_t k = 0; k < 2; ++k) {
    label_parts(k);
    look(limits);
  }
  number_faces(cells);
  fill_cells(cells);
  look(limits);
}

}  // namespace plumb
