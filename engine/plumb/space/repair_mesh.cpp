// The steps of the repair of a mesh, in their order.
//
// The mesh is copied, repaired and moved back, so that an exception does not change it. `origin_`
// keeps the original number of each face for the report. After the first step, every place has one
// point, so that indices determine whether faces share an edge. Equal points with different indices
// occur only before this step.
//
// orient_faces() always decides whether a mesh is closed. Like complex_of_mesh(), it cuts edges at
// vertices on them. Therefore a mesh that is reported as closed is read as closed.
//
// Tested by tests/space/repair_mesh_test.cpp.

#include "plumb/space/repair_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "plumb/base/internal/message_text.h"
#include "plumb/predicates/error.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/mesh/face_corners.h"
#include "plumb/space/mesh/fill_polygons.h"
#include "plumb/space/mesh/mesh_arrangement.h"
#include "plumb/space/mesh/mesh_facets.h"
#include "plumb/space/mesh/mesh_orientation.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/weld_points.h"

namespace plumb {
namespace {

using Faces = std::vector<std::uint32_t>;

// ---------------------------------------------------------------- doubled faces

/// Faces with the same corners: each face with the first of its kind.
class DoubledSearch {
 public:
  explicit DoubledSearch(const PolygonMesh& mesh) : mesh_(mesh) { list_keys(); }

  /// Returns for each face the first one with its corners, in either direction.
  std::vector<std::uint32_t> find() {
    std::vector<std::uint32_t> order(mesh_.face_count());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t f, std::uint32_t g) {
      const auto a = key(f), b = key(g);
      if (a.size() != b.size()) return a.size() < b.size();
      const auto [x, y] = std::ranges::mismatch(a, b);
      return x != a.end() ? *x < *y : f < g;
    });
    std::vector<std::uint32_t> first(order.size());
    are_opposite_ = are_alike_ = true;
    for (std::size_t i = 0; i < order.size();) {
      std::int64_t forth = 0;
      const std::size_t begin = i;
      const std::uint32_t head = order[i];
      for (; i < order.size() && std::ranges::equal(key(order[i]), key(head)); ++i) {
        first[order[i]] = head;
        forth += is_reversed_[order[i]] != 0 ? -1 : 1;
      }
      are_opposite_ = are_opposite_ && forth == 0;
      are_alike_ = are_alike_ && std::cmp_equal(forth < 0 ? -forth : forth, i - begin);
    }
    return first;
  }
  /// Whether find() found each face equally often in both directions.
  bool are_opposite() const { return are_opposite_; }
  /// Whether find() found each face in only one direction.
  bool are_alike() const { return are_alike_; }

 private:
  /// Lists the corners of each face from its least one, towards the lesser of its neighbours.
  void list_keys() {
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      const auto face = mesh_.face(f);
      const std::size_t n = face.size();
      const auto least = static_cast<std::size_t>(std::ranges::min_element(face) - face.begin());
      const bool is_reversed = face[(least + n - 1) % n] < face[(least + 1) % n];
      is_reversed_.push_back(is_reversed ? 1 : 0);
      for (std::size_t i = 0; i < n; ++i) {
        keys_.push_back(face[(least + (is_reversed ? n - i : i)) % n]);
      }
    }
  }
  std::span<const std::uint32_t> key(std::uint32_t f) const {
    return std::span(keys_).subspan(mesh_.face_begin[f],
                                    mesh_.face_begin[f + 1] - mesh_.face_begin[f]);
  }

  const PolygonMesh& mesh_;
  std::vector<std::uint32_t> keys_;  // The place in mesh_.corners of the corners of the same face.
  std::vector<std::uint8_t> is_reversed_;
  bool are_opposite_ = false;
  bool are_alike_ = false;
};

// ---------------------------------------------------------------- the steps

/// Repairs a mesh.
class MeshRepair {
 public:
  MeshRepair(PolygonMesh mesh, const RepairOptions& options, Context& context)
      : mesh_(std::move(mesh)),
        options_(options),
        context_(context),
        charge_(context),
        next_face_(static_cast<std::uint32_t>(mesh_.face_count())) {
    constexpr std::uint64_t kBytesPerCorner = 200;
    charge_.add(kBytesPerCorner * mesh_.corners.size(), "mending of a mesh");
  }

  /// Stores the data for origins(). Must be called before run().
  void keep_origins() { before_.emplace(); }
  /// Returns the origins of the faces of the repaired mesh.
  FaceOrigins origins() const { return origins_of(*before_, mesh_, origin_); }

  RepairReport run() {
    weld();
    drop_doubled();
    orient();
    fill();
    turn_components();
    drop_unused();
    return std::move(report_);
  }
  PolygonMesh take() { return std::move(mesh_); }

 private:
  void weld() {
    const PointWeld weld = weld_points(mesh_, options_.weld, context_);
    report_.equal = weld.equal;
    report_.welded = weld.moved;
    report_.farthest = weld.farthest;
    if (before_) {
      before_->corners = mesh_.corners;
      before_->face_begin = mesh_.face_begin;
    }
    trim_faces();
  }

  void trim_faces() {
    PolygonMesh trimmed;
    trimmed.corners.reserve(mesh_.corners.size());
    trimmed.face_begin.reserve(mesh_.face_begin.size());
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      const auto face = mesh_.face(f);
      const std::size_t first = trimmed.corners.size();
      for (const std::uint32_t v : face) push_corner(trimmed.corners, first, v);
      trim_ends(trimmed.corners, first);
      const std::size_t size = trimmed.corners.size() - first;
      if (size < 3) {
        trimmed.corners.resize(first);
        report_.degenerate.push_back(f);
        continue;
      }
      if (size < face.size()) ++report_.trimmed;
      trimmed.face_begin.push_back(static_cast<std::uint32_t>(trimmed.corners.size()));
      origin_.push_back(f);
    }
    mesh_.corners = std::move(trimmed.corners);
    mesh_.face_begin = std::move(trimmed.face_begin);
  }

  // ---------------------------------------------------------------- doubled faces

  void drop_doubled() {
    if (options_.doubled == DoubledFaces::Keep) return;
    DoubledSearch search(mesh_);
    const std::vector<std::uint32_t> first = search.find();
    PolygonMesh single = without_doubled(first);
    if (single.face_count() == mesh_.face_count()) return;
    if (options_.doubled == DoubledFaces::DropIfBetter && !is_better(single, search)) {
      return;
    }
    std::vector<std::uint32_t> origin;
    for (std::uint32_t f = 0; f < first.size(); ++f) {
      if (first[f] == f) {
        origin.push_back(origin_[f]);
      } else {
        report_.doubled.emplace_back(origin_[f], origin_[first[f]]);
      }
    }
    origin_ = std::move(origin);
    mesh_ = std::move(single);
  }

  PolygonMesh without_doubled(std::span<const std::uint32_t> first) const {
    PolygonMesh single;
    for (std::uint32_t f = 0; f < first.size(); ++f) {
      if (first[f] == f) single.add_face(mesh_.face(f));
    }
    single.points = mesh_.points;
    single.exact = mesh_.exact;
    return single;
  }

  /// Whether doubled faces should be removed. This is the case if the mesh without them has shorter
  /// borders; if it has none, and the mesh certainly encloses nothing; or if complete closed
  /// surfaces occur several times.
  bool is_better(const PolygonMesh& single, const DoubledSearch& search) const {
    const std::size_t after = length(orientation_of(single).holes);
    if (search.are_opposite()) return after == 0;
    const std::size_t before = length(orientation_of(mesh_).holes);
    return after < before || (search.are_alike() && before == 0 && after == 0);
  }
  static std::size_t length(const std::vector<std::vector<std::uint32_t>>& chains) {
    std::size_t sum = 0;
    for (const auto& chain : chains) sum += chain.size();
    return sum;
  }

  // ---------------------------------------------------------------- directions and holes

  /// Returns the orientation of a mesh. Chains have indices of points.
  MeshOrientation orientation_of(const PolygonMesh& mesh) const {
    SpaceTables tables;
    const MeshView view(mesh);
    const MeshVertices vertices = merge_equal_points(view, tables);
    MeshOrientation found = orient_faces(view, vertices, tables.points, context_);
    for (auto& chain : found.holes) {
      for (std::uint32_t& v : chain) v = vertices.input[v];
    }
    return found;
  }

  // If faces must not be flipped, the borders that they make count as holes.
  void orient() {
    MeshOrientation found = orientation_of(mesh_);
    for (const std::uint32_t f : found.one_sided) report_.one_sided.push_back(origin_[f]);
    if (found.flipped.empty()) {
      report_.holes = std::move(found.holes);
    } else if (options_.reorient || options_.fills_holes()) {
      reverse_faces(mesh_, found.flipped);
      for (const std::uint32_t f : found.flipped) report_.flipped.push_back(origin_[f]);
      report_.holes = std::move(found.holes);
    } else {
      MeshOptions reading;
      report_.holes = complex_of_mesh(mesh_, reading, context_).report.borders;
    }
  }

  // The missing part of a one-sided component is not a hole.
  void fill() {
    if (!options_.fills_holes() || report_.holes.empty() || !report_.one_sided.empty()) return;
    SpaceTables tables;
    const MeshVertices vertices = merge_equal_points(mesh_, tables);
    std::vector<SpacePoint> place;
    for (const std::uint32_t v : vertices.of_point) {
      place.push_back(v == kNone ? SpacePoint() : vertices.point[v]);
    }
    std::vector<std::vector<std::uint32_t>> left;
    for (std::size_t i = 0; i < report_.holes.size(); ++i) {
      if (i % 64 == 0) context_.checkpoint("filling holes", i, report_.holes.size());
      std::vector<std::uint32_t>& chain = report_.holes[i];
      if (!is_to_be_filled(chain)) {
        left.push_back(std::move(chain));
      } else {
        report_.filled.push_back(static_cast<std::uint32_t>(chain.size()));
        report_.added += fill_hole(mesh_, chain, place, tables);
      }
    }
    report_.holes = std::move(left);
    while (origin_.size() < mesh_.face_count()) origin_.push_back(next_face_++);
  }

  bool is_to_be_filled(const std::vector<std::uint32_t>& hole) const {
    if (hole.size() <= options_.fill_holes) return true;
    Point3 low = mesh_.points[hole.front()], high = low;
    for (const std::uint32_t v : hole) {
      const Point3& p = mesh_.points[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double diagonal = std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
    return diagonal <= options_.fill_holes_below;
  }

  // ---------------------------------------------------------------- inside and outside

  // A component balances by itself, so the mesh remains closed if all its faces are flipped. If a
  // face is triangulated and its triangles belong to several components, it cannot follow all of
  // them. If this would open the mesh, no face is flipped.
  void turn_components() {
    if (!options_.reorient || !report_.is_closed() || mesh_.face_count() == 0) return;
    MeshComplex made = complex_of_mesh(mesh_, {}, context_);
    if (made.report.inside_out.empty()) return;
    const Faces origin(made.complex.facet_origin.begin(), made.complex.facet_origin.end());
    const std::vector<std::int32_t> jump = made.jump;
    const Faces turned = turn_inside_out(made, context_);
    if (turned.empty()) return;
    const Faces faces = faces_of_turned(made, origin, jump);
    reverse_faces(mesh_, faces);
    const MeshOrientation after = orientation_of(mesh_);
    if (!after.holes.empty() || !after.flipped.empty()) return reverse_faces(mesh_, faces);
    for (const std::uint32_t f : turned) report_.turned.push_back(origin_[f]);
  }

  /// Returns the faces of the components whose jumps have changed. `origin` has the face of each
  /// sheet, and `jump` its jump before.
  Faces faces_of_turned(const MeshComplex& made, const Faces& origin,
                        std::span<const std::int32_t> jump) const {
    std::vector<std::uint8_t> is_component_turned(made.is_inside_out.size());
    for (std::size_t s = 0; s < jump.size(); ++s) {
      if (made.jump[s] != jump[s]) is_component_turned[made.component[s]] = 1;
    }
    std::vector<std::uint8_t> is_turned(mesh_.face_count());
    for (std::size_t s = 0; s < jump.size(); ++s) {
      if (is_component_turned[made.component[s]] != 0) is_turned[origin[s]] = 1;
    }
    for (const auto& [face, earlier] : made.report.doubled) is_turned[face] |= is_turned[earlier];
    Faces faces;
    for (std::uint32_t f = 0; f < is_turned.size(); ++f) {
      if (is_turned[f] != 0) faces.push_back(f);
    }
    return faces;
  }

  // ---------------------------------------------------------------- points

  void drop_unused() {
    const std::vector<std::uint32_t> number = drop_unused_points(mesh_);
    report_.unused = number.size() - mesh_.points.size();
    for (auto& chain : report_.holes) {
      for (std::uint32_t& v : chain) v = number[v];
    }
    if (!before_) return;
    for (std::uint32_t& v : before_->corners) v = number[v];
  }

  PolygonMesh mesh_;
  const RepairOptions& options_;
  Context& context_;
  MemoryCharge charge_;
  std::vector<std::uint32_t> origin_;  // The original number of each face.
  std::uint32_t next_face_;            // The number of the next face that is added.
  RepairReport report_;
  // The faces after the weld, without points, if origins are kept.
  std::optional<PolygonMesh> before_;
};

// ---------------------------------------------------------------- sentences

void add_faces(const std::string& what, std::span<const std::uint32_t> faces,
               std::vector<std::string>& notes) {
  if (!faces.empty()) notes.push_back(what + ": " + listed(faces));
}

}  // namespace

RepairReport repair_mesh(PolygonMesh& mesh, const RepairOptions& options, Context& context) {
  MeshRepair repair(mesh, options, context);
  RepairReport report = repair.run();
  mesh = repair.take();
  return report;
}

RepairReport repair_mesh(PolygonMesh& mesh, MeshAttributes& attributes,
                         const RepairOptions& options, Context& context) {
  if (attributes.empty()) return repair_mesh(mesh, options, context);
  require_sizes(attributes, mesh.face_count(), mesh.corners.size());
  MeshRepair repair(mesh, options, context);
  repair.keep_origins();
  RepairReport report = repair.run();
  const FaceOrigins origins = repair.origins();
  PolygonMesh mended = repair.take();
  attributes = carried(attributes, mended, origins);
  mesh = std::move(mended);
  return report;
}

std::vector<std::string> sentences(const RepairReport& report) {
  std::vector<std::string> notes;
  if (report.welded > 0) {
    notes.push_back(std::to_string(report.welded) + (report.welded == 1 ? " vertex" : " vertices") +
                    " welded to others, moved by at most " + format_double(report.farthest));
  }
  add_faces("faces with fewer than three different corners, dropped", report.degenerate, notes);
  std::vector<std::uint32_t> doubled;
  for (const auto& [face, earlier] : report.doubled) doubled.push_back(face);
  add_faces("faces with the corners of an earlier one, dropped", doubled, notes);
  add_faces("faces that disagreed with their neighbours, flipped", report.flipped, notes);
  if (!report.filled.empty()) {
    notes.push_back("holes filled, by their numbers of edges: " + listed(report.filled) + "; " +
                    std::to_string(report.added) + (report.added == 1 ? " face" : " faces") +
                    " added");
  }
  add_faces("components that were inside out, turned; their first faces", report.turned, notes);
  return notes;
}

}  // namespace plumb
