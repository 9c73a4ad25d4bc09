#include "plumb/sphere/sphere_overlay.h"

#include <optional>

#include "plumb/sphere/sphere_labels.h"
#include "plumb/sphere/sphere_limits.h"
#include "plumb/sphere/sphere_lunes.h"
#include "plumb/sphere/sphere_simplify.h"

namespace plumb {
namespace {

Mark mark_of(const SphereMap& map, SphereCell cell) {
  switch (cell.kind()) {
    case SphereCell::Kind::Point:
      return map.point_mark[cell.index()];
    case SphereCell::Kind::Arc:
      return map.arc_mark[cell.index()];
    case SphereCell::Kind::Face:
      break;
  }
  return map.face_mark[cell.index()];
}

void pick(const std::vector<std::uint32_t>& old, const std::vector<SphereOrigins::Pair>& from,
          std::vector<SphereOrigins::Pair>& to) {
  to.clear();
  for (const std::uint32_t i : old) to.push_back(from[i]);
}

void name(const std::vector<std::uint32_t>& old, SphereCell::Kind kind,
          std::vector<SphereOrigins::Pair>& to) {
  to.clear();
  for (const std::uint32_t i : old) to.push_back({SphereCell(kind, i), SphereCell()});
}

void name_all(std::size_t count, SphereCell::Kind kind, std::vector<SphereOrigins::Pair>& to) {
  to.clear();
  for (std::uint32_t i = 0; i < count; ++i) to.push_back({SphereCell(kind, i), SphereCell()});
}

}  // namespace

struct SphereOverlay::Work {
  explicit Work(const PlaneTable& p) : planes(p) {}

  void overlay(const SphereMap& a, const SphereMap& b, SphereLimits* limits);
  void select(const SphereMap& a, const SphereMap& b, const MarkTable& table);
  void simplify(SphereMap& out, SphereOrigins& origins);

  const PlaneTable& planes;
  SphereLunes lunes;
  SphereContacts contacts;
  SpherePieces pieces;
  SphereLabels labels;
  SphereOrigins cells;
  SphereSimplifier simplifier;
  SphereMap spare;
};

/// To pieces.map and cells, without marks.
void SphereOverlay::Work::overlay(const SphereMap& a, const SphereMap& b, SphereLimits* limits) {
  if (lunes.build(planes, a, b, pieces.map, cells)) return;
  contacts.find(planes, a, b, SphereContacts::kMostTabled, limits);
  pieces.build(planes, a, b, contacts, limits);
  labels.build(planes, a, b, contacts, pieces, cells, limits);
}

void SphereOverlay::Work::select(const SphereMap& a, const SphereMap& b, const MarkTable& table) {
  const auto add = [&](const std::vector<SphereOrigins::Pair>& pairs, std::vector<Mark>& marks) {
    for (const auto& [in_a, in_b] : pairs)
      marks.push_back(table(mark_of(a, in_a), mark_of(b, in_b)));
  };
  add(cells.point, pieces.map.point_mark);
  add(cells.arc, pieces.map.arc_mark);
  add(cells.face, pieces.map.face_mark);
  pieces.map.centre_mark = table(a.centre_mark, b.centre_mark);
}

void SphereOverlay::Work::simplify(SphereMap& out, SphereOrigins& origins) {
  if (simplifier.run(pieces.map, out)) {
    pick(simplifier.old_point(), cells.point, origins.point);
    pick(simplifier.old_arc(), cells.arc, origins.arc);
    pick(simplifier.old_face(), cells.face, origins.face);
  } else {
    std::swap(out, pieces.map);
    std::swap(origins, cells);
  }
}

SphereOverlay::SphereOverlay(const PlaneTable& planes) : work_(std::make_unique<Work>(planes)) {}
SphereOverlay::~SphereOverlay() = default;

void SphereOverlay::combine(const SphereMap& a, const SphereMap& b, const MarkTable& table,
                            SphereMap& out, SphereOrigins& origins, Context* context) {
  Work& w = *work_;
  std::optional<SphereLimits> limits;
  if (context != nullptr && !SphereContacts::are_small(a, b)) limits.emplace(*context);
  w.overlay(a, b, limits ? &*limits : nullptr);
  w.select(a, b, table);
  w.simplify(out, origins);
}

bool SphereOverlay::simplify(SphereMap& map, SphereOrigins* kept) {
  const SphereSimplifier& s = work_->simplifier;
  const bool changed = work_->simplifier.run(map, work_->spare);
  if (changed) std::swap(map, work_->spare);
  if (kept == nullptr) return changed;
  using Kind = SphereCell::Kind;
  if (changed) {
    name(s.old_point(), Kind::Point, kept->point);
    name(s.old_arc(), Kind::Arc, kept->arc);
    name(s.old_face(), Kind::Face, kept->face);
  } else {
    name_all(map.point_count(), Kind::Point, kept->point);
    name_all(map.arc_count(), Kind::Arc, kept->arc);
    name_all(map.face_count(), Kind::Face, kept->face);
  }
  return changed;
}

}  // namespace plumb
