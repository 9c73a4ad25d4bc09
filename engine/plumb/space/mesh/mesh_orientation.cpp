// Coherent orientation of a mesh by the incidences of faces and edges.
//
// Faces are nodes of a graph; an edge of the mesh at which exactly two faces are not yet balanced
// by themselves says whether their signs are equal or opposite. Classes of such relations are kept
// in a union-find with signs. If a relation contradicts an earlier relation, its class is marked as
// one-sided: it has no consistent signs, and none of its faces is flipped.
//
// Invariant: signs within a class are determined up to a common factor, so that each class has two
// coherent orientations, and only choose() decides between them. Where more than two faces meet,
// the signs of each class at the edge are added first: two solids that touch along an edge balance
// there by themselves and stay independent.
//
// See docs/design/meshes.md, "Flipped faces".
// Tested by tests/space/mesh_orientation_test.cpp.

#include "plumb/space/mesh/mesh_orientation.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/mesh/mesh_topology.h"

namespace plumb {
namespace {

/// Classes of faces whose signs depend on each other. The root of a class is its least face.
class SignedClasses {
 public:
  explicit SignedClasses(std::size_t size) : parent_(size), is_opposite_(size), clash_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// The sign of a face relative to the root of its class.
  struct Place {
    std::uint32_t root;
    bool is_opposite;  ///< Whether its sign is opposite to that of the root.
  };
  Place find(std::uint32_t i) {
    bool is_opposite = false;
    for (;;) {
      const std::uint32_t parent = parent_[i];
      if (parent == parent_[parent]) {
        return {parent, is_opposite != (is_opposite_[i] != 0)};
      }
      is_opposite_[i] ^= is_opposite_[parent];
      is_opposite = is_opposite != (is_opposite_[i] != 0);
      parent_[i] = parent_[parent];
      i = parent_[i];
    }
  }

  /// Requires equal or opposite signs of two faces. Returns whether this united two classes.
  bool relate(std::uint32_t i, std::uint32_t j, bool are_opposite) {
    Place a = find(i), b = find(j);
    const bool roots_are_opposite = (a.is_opposite != b.is_opposite) != are_opposite;
    if (a.root == b.root) {
      if (roots_are_opposite) clash_[a.root] = 1;
      return false;
    }
    if (a.root > b.root) std::swap(a, b);
    parent_[b.root] = a.root;
    is_opposite_[b.root] = roots_are_opposite ? 1 : 0;
    clash_[a.root] |= clash_[b.root];
    return true;
  }

  /// Whether the requirements of the class of a root contradict each other.
  bool has_clash(std::uint32_t root) const { return clash_[root] != 0; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> is_opposite_;  // The sign of each face relative to its parent.
  std::vector<std::uint8_t> clash_;        // One entry for each root.
};

using VertexPair = std::array<std::uint32_t, 2>;
using Chains = std::vector<std::vector<std::uint32_t>>;

/// A face along an edge.
struct FaceAtEdge {
  std::uint32_t face;
  std::int32_t
      times;  ///< How often it runs from the lesser to the greater end, less how often back.
};

/// The faces that use each edge. Faces that use an edge equally often in both directions are left
/// out, and so are edges without faces.
struct EdgeFaces {
  std::vector<VertexPair> end;             ///< The ends of each edge, ascending.
  std::vector<std::uint32_t> begin = {0};  ///< Starts in `use`, one more than there are edges.
  std::vector<FaceAtEdge> use;             ///< The faces of each edge, ascending.

  std::span<const FaceAtEdge> of(std::size_t e) const {
    return std::span(use).subspan(begin[e], begin[e + 1] - begin[e]);
  }
};

/// A face that uses an edge, in a list to be sorted.
struct Run {
  VertexPair end;
  FaceAtEdge at;
};

void add_run(std::uint32_t from, std::uint32_t to, FaceAtEdge at, std::vector<Run>& runs) {
  if (from == to) return;
  if (from > to) {
    std::swap(from, to);
    at.times = -at.times;
  }
  runs.push_back({{from, to}, at});
}

/// Sorts uses by edge and face, and adds up the uses of a face at an edge.
EdgeFaces collected(std::vector<Run> runs) {
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) {
    return std::tie(a.end, a.at.face) < std::tie(b.end, b.at.face);
  });
  EdgeFaces edges;
  for (std::size_t i = 0; i < runs.size();) {
    const VertexPair end = runs[i].end;
    while (i < runs.size() && runs[i].end == end) {
      FaceAtEdge at{runs[i].at.face, 0};
      for (; i < runs.size() && runs[i].end == end && runs[i].at.face == at.face; ++i) {
        at.times += runs[i].at.times;
      }
      if (at.times != 0) edges.use.push_back(at);
    }
    if (edges.use.size() == edges.begin.back()) continue;
    edges.end.push_back(end);
    edges.begin.push_back(static_cast<std::uint32_t>(edges.use.size()));
  }
  return edges;
}

/// Finds the faces that must be flipped.
class FaceOrienter {
 public:
  FaceOrienter(const MeshView& mesh, const MeshVertices& vertices, const Point3Table& table,
               Context& context, const Chains* borders)
      : mesh_(mesh),
        vertices_(vertices),
        table_(table),
        context_(context),
        memory_(context),
        borders_(borders),
        classes_(mesh.face_count()) {}

  MeshOrientation run() {
    context_.checkpoint("orientation", 0, 4);
    list_edges();
    cut_edges();
    context_.checkpoint("orientation", 1, 4);
    relate_pairs();
    relate_rest();
    context_.checkpoint("orientation", 2, 4);
    choose();
    context_.checkpoint("orientation", 3, 4);
    find_holes();
    context_.checkpoint("orientation", 4, 4);
    return std::move(result_);
  }

 private:
  void list_edges() {
    // Each use contributes at most one edge with one face.
    constexpr std::size_t kBytesPerRun =
        sizeof(Run) + sizeof(VertexPair) + sizeof(std::uint32_t) + sizeof(FaceAtEdge);
    memory_.add(
        mesh_.corners.size() * kBytesPerRun + mesh_.face_count() * 2 * sizeof(std::uint64_t),
        "the orientation of a mesh");
    std::vector<Run> runs;
    runs.reserve(mesh_.corners.size());
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (f % 4096 == 0) context_.checkpoint("orientation", 0, 4);
      const auto face = mesh_.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const std::uint32_t next = face[i + 1 < face.size() ? i + 1 : 0];
        add_run(vertices_.of_point[face[i]], vertices_.of_point[next], {f, 1}, runs);
      }
    }
    edges_ = collected(std::move(runs));
  }

  // An edge with an odd number of faces cannot balance, whatever the directions of the faces are.
  void cut_edges() {
    std::vector<VertexPair> odd;
    for (std::size_t e = 0; e < edges_.end.size(); ++e) {
      if (is_odd(e)) odd.push_back(edges_.end[e]);
    }
    const InnerVertices inner = vertices_inside(odd, vertices_.point, table_, memory_, context_);
    if (inner.vertex.empty()) return;
    memory_.add(inner.vertex.size() * 2 * sizeof(Run), "the orientation of a mesh");
    std::vector<Run> runs;
    for (std::size_t e = 0, i = 0; e < edges_.end.size(); ++e) {
      const std::span<const std::uint32_t> cuts =
          is_odd(e) ? inner.of(i++) : std::span<const std::uint32_t>();
      for (const FaceAtEdge& at : edges_.of(e)) {
        std::uint32_t from = edges_.end[e][0];
        for (const std::uint32_t v : cuts) add_run(std::exchange(from, v), v, at, runs);
        add_run(from, edges_.end[e][1], at, runs);
      }
    }
    edges_ = collected(std::move(runs));
  }

  bool is_odd(std::size_t e) const {
    std::int32_t sum = 0;
    for (const FaceAtEdge& at : edges_.of(e)) sum += at.times;
    return sum % 2 != 0;
  }

  /// Relates two faces that balance an edge if their directions are right.
  bool relate(const FaceAtEdge& a, const FaceAtEdge& b) {
    if (std::abs(a.times) != std::abs(b.times)) return false;
    return classes_.relate(a.face, b.face, a.times == b.times);
  }

  void relate_pairs() {
    for (std::size_t e = 0; e < edges_.end.size(); ++e) {
      const auto at = edges_.of(e);
      if (at.size() == 2) relate(at[0], at[1]);
      if (at.size() > 2) crowded_.push_back(static_cast<std::uint32_t>(e));
    }
  }

  // Each round except the last unites classes. More than a few rounds are only needed for meshes
  // that do not occur in practice.
  void relate_rest() {
    constexpr int kMostRounds = 8;
    bool has_united = true;
    for (int round = 0; has_united && round < kMostRounds; ++round) {
      has_united = false;
      for (const std::uint32_t e : crowded_) {
        sum_classes(e);
        if (sums_.size() == 2) has_united |= relate(sums_[0], sums_[1]);
      }
    }
  }

  /// For each class, adds up the faces at an edge. Stores the sums that are not 0, by root.
  void sum_classes(std::uint32_t e) {
    sums_.clear();
    for (const FaceAtEdge& at : edges_.of(e)) {
      const auto [root, is_opposite] = classes_.find(at.face);
      const std::int32_t times = is_opposite ? -at.times : at.times;
      sums_.push_back({root, times});
    }
    std::ranges::sort(sums_, {}, &FaceAtEdge::face);
    std::size_t count = 0;
    for (std::size_t i = 0; i < sums_.size();) {
      FaceAtEdge sum{sums_[i].face, 0};
      for (; i < sums_.size() && sums_[i].face == sum.face; ++i) sum.times += sums_[i].times;
      if (sum.times != 0) sums_[count++] = sum;
    }
    sums_.resize(count);
  }

  // ---------------------------------------------------------------- the choice

  void choose() {
    const auto count = static_cast<std::uint32_t>(mesh_.face_count());
    std::vector<std::uint32_t> opposite(count, 0), size(count, 0);  // The counts for each root.
    for (std::uint32_t f = 0; f < count; ++f) {
      const auto [root, is_opposite] = classes_.find(f);
      ++size[root];
      if (is_opposite) ++opposite[root];
    }
    // For each root, whether the faces with its own sign are flipped instead of the others.
    std::vector<std::uint8_t> turns_root(count, 0);
    std::vector<std::uint32_t> equal;
    for (std::uint32_t r = 0; r < count; ++r) {
      if (opposite[r] == 0 || classes_.has_clash(r)) continue;
      turns_root[r] = 2 * opposite[r] > size[r] ? 1 : 0;
      if (2 * opposite[r] == size[r]) equal.push_back(r);
    }
    choose_by_volume(equal, turns_root);
    for (std::uint32_t f = 0; f < count; ++f) {
      const auto [root, is_opposite] = classes_.find(f);
      if (classes_.has_clash(root)) {
        if (root == f) result_.one_sided.push_back(f);
      } else if (opposite[root] > 0 && is_opposite == (turns_root[root] == 0)) {
        result_.flipped.push_back(f);
      }
    }
  }

  /// Chooses for classes with two equal parts. After the flip, the volume is positive. If it is 0,
  /// the part without the least face is flipped.
  void choose_by_volume(std::span<const std::uint32_t> roots,
                        std::vector<std::uint8_t>& turns_root) {
    if (roots.empty()) return;
    std::map<std::uint32_t, Rational> volume;  // The sum has the sign of the root's orientation.
    for (const std::uint32_t r : roots) volume[r] = 0;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (f % 4096 == 0) context_.checkpoint("orientation", 2, 4);
      const auto [root, is_opposite] = classes_.find(f);
      const auto at = volume.find(root);
      if (at == volume.end()) continue;
      const Rational cone = cone_over(mesh_.face(f));
      at->second += is_opposite ? -cone : cone;
    }
    for (const auto& [root, v] : volume) turns_root[root] = v < 0 ? 1 : 0;
  }

  /// Returns six times the volume of the cones from the origin over a fan of the face.
  Rational cone_over(std::span<const std::uint32_t> face) const {
    Rational sum;
    if (face.size() < 3) return sum;
    const RationalPoint3 a = place(face[0]);
    RationalPoint3 b = place(face[1]);
    for (std::size_t i = 2; i < face.size(); ++i) {
      RationalPoint3 c = place(face[i]);
      sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
             a.z * (b.x * c.y - b.y * c.x);
      b = std::move(c);
    }
    return sum;
  }
  RationalPoint3 place(std::uint32_t corner) const {
    return exact(table_, vertices_.point[vertices_.of_point[corner]]);
  }

  // ---------------------------------------------------------------- what is left

  void find_holes() {
    if (result_.flipped.empty()) {
      result_.holes = borders_ != nullptr ? *borders_ : chains_of(surplus(), memory_, context_);
      return;
    }
    EdgeSurpluses after = surplus();
    std::vector<std::uint32_t> flipped;
    std::swap(flipped, result_.flipped);
    EdgeSurpluses before = surplus();
    const bool helps = length(after) < length(before);
    if (helps) std::swap(flipped, result_.flipped);
    result_.holes = chains_of(helps ? after : before, memory_, context_);
  }

  /// Returns the edges that do not balance after the faces `flipped` have been flipped.
  EdgeSurpluses surplus() {
    std::vector<std::uint8_t> is_flipped(mesh_.face_count());
    for (const std::uint32_t f : result_.flipped) is_flipped[f] = 1;
    EdgeSurpluses result;
    for (std::size_t e = 0; e < edges_.end.size(); ++e) {
      std::int32_t sum = 0;
      for (const FaceAtEdge& at : edges_.of(e)) {
        sum += is_flipped[at.face] != 0 ? -at.times : at.times;
      }
      if (sum != 0) result.push_back({edges_.end[e], sum});
    }
    if (result.empty()) return result;
    return cut_at_vertices(result, vertices_.point, table_, memory_, context_);
  }

  static std::uint64_t length(const EdgeSurpluses& surplus) {
    std::uint64_t sum = 0;
    for (const EdgeSurplus& s : surplus) sum += static_cast<std::uint64_t>(std::abs(s.times));
    return sum;
  }

  const MeshView& mesh_;
  const MeshVertices& vertices_;
  const Point3Table& table_;
  Context& context_;
  MemoryCharge memory_;
  const Chains* borders_;  // The borders of the mesh as it is, or null.
  EdgeFaces edges_;
  SignedClasses classes_;
  std::vector<std::uint32_t> crowded_;  // The edges with more than two faces.
  std::vector<FaceAtEdge> sums_;        // The classes at an edge, by their roots.
  MeshOrientation result_;
};

}  // namespace

MeshOrientation orient_faces(const MeshView& mesh, const MeshVertices& vertices,
                             const Point3Table& table, Context& context, const Chains* borders) {
  return FaceOrienter(mesh, vertices, table, context, borders).run();
}

void reverse_faces(PolygonMesh& mesh, std::span<const std::uint32_t> faces) {
  for (const std::uint32_t f : faces) {
    if (mesh.face(f).empty()) continue;
    const auto begin = mesh.corners.begin();
    std::reverse(begin + mesh.face_begin[f] + 1, begin + mesh.face_begin[f + 1]);
  }
}

}  // namespace plumb
