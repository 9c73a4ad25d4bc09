// Evaluation of trees of constructive solid geometry.
//
// Nodes are numbered in preorder, so a pass over falling numbers sees children before parents, and
// a pass over rising numbers sees parents first. Each step below is one such pass; no step
// recurses.
//
// Equal subtrees have one representative, the one with the greatest number; children of a
// representative are named by their representatives, which have greater numbers than it. A node
// that changes nothing, such as a group with one child, is represented by its child.
//
// A Boolean that only another Boolean uses has no value of its own: it becomes a part of the
// expression of its user, which is rewritten as a whole (set_tree.h). Operations on sets are
// regularized one by one. By the laws of the Boolean algebra of closed regular sets, the value does
// not depend on the order in which they are done.
//
// Colours are values of the nodes that make faces (node_colors.h). Only for such nodes, a different
// colour makes a different node. Booleans differ if their operands differ.
//
// Tested by tests/csg/evaluate_test.cpp: random trees against the oracle of unit cells; colours by
// tests/csg/colors_test.cpp.
#include "plumb/csg/evaluate.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "plumb/base/set_tree.h"
#include "plumb/convex/minkowski.h"
#include "plumb/convex/plane_minkowski.h"
#include "plumb/csg/node/node_colors.h"
#include "plumb/csg/node/node_values.h"
#include "plumb/model/hull.h"
#include "plumb/model/transform.h"
#include "plumb/predicates/error.h"
#include "plumb/space/source_mesh.h"

namespace plumb {
namespace {

using Node = CsgTree::Node;

constexpr std::uint32_t kNoNode = ~std::uint32_t{0};
/// What an evaluation needs for each node besides its value.
constexpr std::uint64_t kBytesPerNode = 200;

/// Operations on closed regular sets, for evaluate_tree().
template <class Set>
struct RegularOperations {
  Context& context;

  Set union_of(const std::vector<Set>& sets) { return plumb::union_of(sets, context); }
  Set intersection_of(const std::vector<Set>& sets) {
    return plumb::intersection_of(sets, context).regularization(context);
  }
  Set difference_of(const std::vector<Set>& sets) {
    return plumb::difference_of(sets[0], std::span(sets).subspan(1), context).closure(context);
  }
  Set symmetric_difference(const Set& a, const Set& b) {
    return regularized_symmetric_difference(a, b, context);
  }
  Set complement(const Set& a) { return a.complement(context).closure(context); }
};

bool is_primitive(CsgKind kind) { return kind >= CsgKind::Cube; }

CsgDimension dimension_of_primitive(CsgKind kind) {
  const bool is_flat = kind == CsgKind::Square || kind == CsgKind::Circle ||
                       kind == CsgKind::Polygon || kind == CsgKind::Shape;
  return is_flat ? CsgDimension::Plane : CsgDimension::Space;
}

/// Whether the map of a multmatrix node is the identity.
bool is_identity(std::span<const double> n) {
  for (std::size_t i = 0; i < n.size(); ++i) {
    if (n[i] != (i % 5 == 0 ? 1 : 0)) return false;
  }
  return true;
}

/// Evaluates one tree.
class Evaluator {
 public:
  Evaluator(const CsgTree& tree, const CsgEvaluateOptions& options, Context& context)
      : tree_(tree),
        context_(context),
        memory_(context),
        has_colors_(options.colors),
        count_(static_cast<std::uint32_t>(tree.nodes.size())),
        dimension_(count_, CsgDimension::Nothing),
        same_(count_),
        input_begin_(count_, 0),
        users_(count_, 0),
        only_user_(count_, kNoNode),
        is_only_in_hulls_(count_, true),
        region_(count_, Region::Own),
        values_(count_) {}

  CsgResult run() {
    memory_.add(count_ * kBytesPerNode, "a tree of solids");
    result_.nodes.resize(count_);
    find_dimensions();
    find_colors();
    represent_nodes();
    find_users();
    find_regions();
    compute_values();
    report_nodes();
    return take_result();
  }

 private:
  using Value = std::variant<std::monostate, Nef2, Nef3>;

  /// How a node is computed: by itself, as a part of a Boolean, or as operands of a hull.
  enum class Region : std::uint8_t { Own, Boolean, Hull };

  /// A remark on some of the nodes.
  struct Remark {
    std::uint32_t first;  // The one of these nodes that has the least number.
    std::string text;
    std::uint64_t count;
  };

  const Node& node(std::uint32_t i) const { return tree_.nodes[i]; }
  CsgNodeReport& report(std::uint32_t i) { return result_.nodes[i]; }

  // -------------------------------------------------------------- structure

  /// Returns the dimension that a child must have to be an input of a node.
  CsgDimension input_dimension(std::uint32_t i) const {
    const CsgKind kind = node(i).kind;
    if (kind == CsgKind::Projection) return CsgDimension::Space;
    const bool is_extrusion = kind == CsgKind::LinearExtrude || kind == CsgKind::RotateExtrude;
    if (is_extrusion || kind == CsgKind::Offset) return CsgDimension::Plane;
    return dimension_[i];
  }

  void find_dimensions() {
    for (std::uint32_t i = count_; i-- > 0;) {
      check(i);
      dimension_[i] = dimension_of(i);
    }
  }

  CsgDimension dimension_of(std::uint32_t i) const {
    const CsgKind kind = node(i).kind;
    if (is_primitive(kind)) return dimension_of_primitive(kind);
    const CsgDimension needed = input_dimension(i);
    CsgDimension first = CsgDimension::Nothing;
    bool has_needed = false;
    tree_.for_each_child(i, [&](std::uint32_t child) {
      if (first == CsgDimension::Nothing) first = dimension_[child];
      has_needed = has_needed || dimension_[child] == needed;
    });
    if (needed == CsgDimension::Nothing) return first;
    if (!has_needed) return CsgDimension::Nothing;
    if (kind == CsgKind::Projection || kind == CsgKind::Offset) return CsgDimension::Plane;
    return CsgDimension::Space;
  }

  void find_colors() {
    if (!has_colors_) return;
    paint_ = paint_of(tree_);
    for (const std::uint32_t i : paint_.losing) {
      if (dimension_[i] != CsgDimension::Space) continue;
      note(i, "the colours of its children are left out, because it makes faces of its own");
    }
  }

  /// Returns the colour of a node if the node makes the faces of a set of space; otherwise nothing.
  std::optional<CsgColor> color_at(std::uint32_t i) const {
    if (paint_.of_node.empty() || dimension_[i] != CsgDimension::Space) return {};
    const std::uint32_t from = paint_.of_node[i];
    const CsgKind kind = node(i).kind;
    const bool has_faces = is_primitive(kind) || makes_new_faces(kind);
    return has_faces && from != CsgPaint::kNone ? color_of(tree_, node(from)) : std::nullopt;
  }

  /// Whether the value of a node is the union of its children.
  bool acts_as_union(std::uint32_t i) const {
    const Node& n = node(i);
    return is_union(n.kind) || (n.kind == CsgKind::Multmatrix && is_identity(tree_.numbers_of(n)));
  }

  bool is_boolean(std::uint32_t i) const {
    const CsgKind kind = node(i).kind;
    return kind == CsgKind::Difference || kind == CsgKind::Intersection || acts_as_union(i);
  }

  /// Whether a node is empty because a child is. In a difference, only the first child counts.
  bool is_emptied(std::uint32_t i) const {
    const CsgKind kind = node(i).kind;
    bool is_empty = false, is_first = true;
    tree_.for_each_child(i, [&](std::uint32_t child) {
      const bool counts =
          kind == CsgKind::Intersection || (kind == CsgKind::Difference && is_first);
      is_first = false;
      is_empty = is_empty || (counts && dimension_[child] == CsgDimension::Nothing);
    });
    return is_empty;
  }

  /// Finds the inputs of all nodes (children of the right dimension), and equal nodes.
  void represent_nodes() {
    std::unordered_multimap<std::uint64_t, std::uint32_t> known;
    std::vector<std::uint32_t> inputs;
    inputs_.reserve(count_);
    // Inputs are appended in the order of decreasing numbers, so each range is found from both
    // ends.
    for (std::uint32_t i = count_; i-- > 0;) {
      check(i);
      input_begin_[i] = static_cast<std::uint32_t>(inputs_.size());
      append_inputs(i);
      input_end_.push_back(static_cast<std::uint32_t>(inputs_.size()));
      same_[i] = i;
      if (acts_as_union(i) && inputs_of(i).size() == 1) {
        same_[i] = inputs_of(i)[0];
        continue;
      }
      const std::uint64_t hash = hash_of(i);
      const auto [begin, end] = known.equal_range(hash);
      const auto equal =
          std::find_if(begin, end, [&](const auto& entry) { return is_equal(i, entry.second); });
      if (equal != end) {
        same_[i] = equal->second;
      } else {
        known.emplace(hash, i);
      }
    }
  }

  void append_inputs(std::uint32_t i) {
    const CsgDimension needed = input_dimension(i);
    if (dimension_[i] == CsgDimension::Nothing || is_emptied(i)) return;
    tree_.for_each_child(i, [&](std::uint32_t child) {
      if (dimension_[child] == needed) {
        inputs_.push_back(same_[child]);
      } else if (dimension_[child] != CsgDimension::Nothing) {
        note(child, needed == CsgDimension::Space
                        ? "a set of the plane among sets of space is left out"
                        : "a set of space among sets of the plane is left out");
      }
    });
  }

  std::span<const std::uint32_t> inputs_of(std::uint32_t i) const {
    const std::uint32_t end = input_end_[count_ - 1 - i];
    return std::span(inputs_).subspan(input_begin_[i], end - input_begin_[i]);
  }

  /// Returns those numbers of a node on which its value depends. For a union, there are none.
  std::span<const double> numbers_of(std::uint32_t i) const {
    return is_union(node(i).kind) ? std::span<const double>() : tree_.numbers_of(node(i));
  }
  /// Returns the kind of a node. All nodes that compute unions get the same kind.
  CsgKind kind_of(std::uint32_t i) const {
    return is_union(node(i).kind) ? CsgKind::Union : node(i).kind;
  }

  std::uint64_t hash_of(std::uint32_t i) const {
    std::uint64_t hash = static_cast<std::uint64_t>(kind_of(i)) + 1;
    const auto add = [&hash](std::uint64_t value) {
      hash = (hash ^ value) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32U;
    };
    for (const double x : numbers_of(i)) add(std::hash<double>()(x));
    for (const std::uint32_t x : tree_.indices_of(node(i))) add(x);
    for (const std::uint32_t x : inputs_of(i)) add(x);
    if (const std::optional<CsgColor> color = color_at(i)) {
      for (const double x : *color) add(std::hash<double>()(x));
    }
    return hash;
  }

  bool is_equal(std::uint32_t i, std::uint32_t j) const {
    const auto a = numbers_of(i), b = numbers_of(j);
    const auto c = tree_.indices_of(node(i)), d = tree_.indices_of(node(j));
    const auto e = inputs_of(i), f = inputs_of(j);
    return kind_of(i) == kind_of(j) && dimension_[i] == dimension_[j] &&
           std::equal(a.begin(), a.end(), b.begin(), b.end()) &&
           std::equal(c.begin(), c.end(), d.begin(), d.end()) &&
           std::equal(e.begin(), e.end(), f.begin(), f.end()) && color_at(i) == color_at(j);
  }

  /// Returns the first node below a chain of affine maps, each of which has one input.
  std::uint32_t below_maps(std::uint32_t i) const {
    while (is_map(i) && inputs_of(i).size() == 1) i = inputs_of(i)[0];
    return i;
  }
  bool is_map(std::uint32_t i) const {
    return node(i).kind == CsgKind::Multmatrix && !acts_as_union(i);
  }

  /// Whether only the points of the inputs of a node are needed, because they are used in hulls.
  bool needs_points(std::uint32_t user) const {
    if (user == kNoNode) return false;
    const bool passes_points_on = acts_as_union(user) || is_map(user);
    return node(user).kind == CsgKind::Hull || (passes_points_on && is_only_in_hulls_[user]);
  }

  /// For each representative, counts the nodes that need its value, and determines whether all of
  /// them need only its points. The users of a node are visited before the node.
  void find_users() {
    const auto use = [this](std::uint32_t i, std::uint32_t user) {
      only_user_[i] = users_[i]++ == 0 ? user : kNoNode;
      is_only_in_hulls_[i] = is_only_in_hulls_[i] && needs_points(user);
    };
    if (dimension_[0] != CsgDimension::Nothing) use(same_[0], kNoNode);
    for (std::uint32_t i = 0; i < count_; ++i) {
      if (users_[i] == 0) continue;
      ++needed_;
      if (is_map(i) && inputs_of(i).size() == 1) {
        const std::uint32_t base = below_maps(i);
        for (std::uint32_t k = inputs_of(i)[0]; k != base; k = inputs_of(k)[0]) {
          report(k).work = CsgWork::Rewritten;  // This changes if another node needs the value.
        }
        use(base, i);
      } else {
        for (const std::uint32_t input : inputs_of(i)) use(input, i);
      }
    }
  }

  /// Finds the nodes that are computed together with their only user. Users are visited before
  /// their inputs.
  void find_regions() {
    for (std::uint32_t i = 0; i < count_; ++i) {
      const std::uint32_t user = only_user_[i];
      if (user == kNoNode) continue;
      const bool is_in_hull = node(user).kind == CsgKind::Hull || region_[user] == Region::Hull;
      if (is_in_hull && (acts_as_union(i) || node(i).kind == CsgKind::Hull)) {
        region_[i] = Region::Hull;
      } else if (!is_in_hull && is_boolean(i) && is_boolean(user)) {
        region_[i] = Region::Boolean;
      }
    }
  }
  bool is_rewritten(std::uint32_t i) const { return region_[i] != Region::Own; }

  // -------------------------------------------------------------- values

  void compute_values() {
    std::uint64_t done = 0;
    for (std::uint32_t i = count_; i-- > 0;) {
      if (users_[i] == 0) continue;
      ++done;
      if (is_rewritten(i)) {
        report(i).work = CsgWork::Rewritten;
        continue;
      }
      const std::string phase = phase_of(i);
      context_.checkpoint(phase, done, needed_);
      const auto start = std::chrono::steady_clock::now();
      values_[i] = placed(i, [&] { return value_of(i); });
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      report(i).work = CsgWork::Computed;
      report(i).seconds = taken.count();
      report(i).cells = cells_of(values_[i]);
    }
  }

  std::string phase_of(std::uint32_t i) const {
    std::string text(name_of(node(i).kind));
    if (node(i).line > 0) text += " at line " + std::to_string(node(i).line);
    return text;
  }

  static std::size_t cells_of(const Value& value) {
    if (const Nef3* solid = std::get_if<Nef3>(&value)) return solid->counts().facets;
    const Nef2* shape = std::get_if<Nef2>(&value);
    return shape == nullptr ? 0 : shape->counts().edges;
  }

  /// Calls compute(). Adds the place of the node to every error.
  template <class Compute>
  Value placed(std::uint32_t i, Compute compute) const {
    try {
      return compute();
    } catch (const Error& error) {
      const bool is_known =
          error.code() == ErrorCode::Cancelled || node(i).line == 0 || error.place().line > 0;
      if (is_known) throw;
      throw Error(error.code(), std::string(name_of(node(i).kind)) + ": " + error.message(),
                  {tree_.file, node(i).line, node(i).column});
    }
  }

  Value value_of(std::uint32_t i) {
    if (dimension_[i] == CsgDimension::Space) return solid_of(i);
    return shape_of(i);
  }

  Nef3 solid_of(std::uint32_t i) {
    const Node& n = node(i);
    std::string remark;
    Nef3 solid;
    if (n.kind == CsgKind::LinearExtrude || n.kind == CsgKind::RotateExtrude) {
      solid = extrusion_of(united_inputs<Nef2>(i), tree_, n, remark, context_);
    } else if (is_primitive(n.kind)) {
      solid = plain_primitive(i, remark);
    } else {
      solid = set_of<Nef3>(i, remark);
    }
    if (!remark.empty()) note(i, remark);
    if (const std::optional<CsgColor> color = color_at(i)) {
      solid = painted(solid, *color, phase_of(i), context_);
    }
    if (is_primitive(n.kind) || makes_new_faces(n.kind)) remember_sources(i, solid);
    return solid;
  }

  /// Returns the set of a primitive without its colour. Equal primitives of different colours share
  /// it.
  Nef3 plain_primitive(std::uint32_t i, std::string& remark) {
    if (node(i).kind == CsgKind::Polyhedron && is_only_in_hulls_[i]) {
      return hull_of_polyhedron(tree_, node(i), context_);
    }
    const auto has_same_shape = [&](const PlainPrimitive& known) {
      return kind_of(i) == kind_of(known.node) &&
             std::ranges::equal(numbers_of(i), numbers_of(known.node)) &&
             std::ranges::equal(tree_.indices_of(node(i)), tree_.indices_of(node(known.node)));
    };
    if (primitive_ && has_same_shape(*primitive_)) {
      remark = primitive_->remark;
      return primitive_->solid;
    }
    Nef3 solid = primitive_solid(tree_, node(i), remark, context_);
    if (has_colors_) primitive_ = {i, solid, remark};
    return solid;
  }

  Nef2 shape_of(std::uint32_t i) {
    const Node& n = node(i);
    std::string remark;
    Nef2 shape;
    if (n.kind == CsgKind::Projection) {
      shape = projection_of(united_inputs<Nef3>(i), tree_, n, context_);
    } else if (n.kind == CsgKind::Offset) {
      shape = offset_of(united_inputs<Nef2>(i), tree_, n, context_);
    } else if (is_primitive(n.kind)) {
      shape = primitive_shape(tree_, n, remark, context_);
    } else {
      shape = set_of<Nef2>(i, remark);
    }
    if (!remark.empty()) note(i, remark);
    return shape;
  }

  /// Returns the value of a node whose inputs are sets of its own dimension.
  template <class Set>
  Set set_of(std::uint32_t i, std::string& remark) {
    if (is_boolean(i)) return region<Set>(i);
    if (node(i).kind == CsgKind::Hull) return hull<Set>(i);
    if (node(i).kind == CsgKind::Minkowski) return sum<Set>(i);
    if (node(i).kind == CsgKind::Resize) {
      return resized(united_inputs<Set>(i), tree_, node(i), remark, context_);
    }
    return image<Set>(i, remark);
  }

  /// Returns the image under the maps of a chain, which are composed first.
  template <class Set>
  Set image(std::uint32_t i, std::string& remark) {
    AffineMap3 map = map_of(tree_, node(i));
    if (inputs_of(i).size() != 1) return mapped(united_inputs<Set>(i), map, remark, context_);
    const std::uint32_t base = below_maps(i);
    for (std::uint32_t k = inputs_of(i)[0]; k != base; k = inputs_of(k)[0]) {
      map = composed(map, map_of(tree_, node(k)));
    }
    return mapped(taken<Set>(base), map, remark, context_);
  }

  /// Returns the value of a representative, and frees it if no other node needs it.
  template <class Set>
  Set taken(std::uint32_t i) {
    if (--users_[i] > 0) return std::get<Set>(values_[i]);
    return std::get<Set>(std::exchange(values_[i], Value()));
  }

  template <class Set>
  std::vector<Set> taken_inputs(std::uint32_t i) {
    std::vector<Set> sets;
    for (const std::uint32_t input : inputs_of(i)) sets.push_back(taken<Set>(input));
    return sets;
  }

  template <class Set>
  Set united_inputs(std::uint32_t i) {
    const std::vector<Set> sets = taken_inputs<Set>(i);
    return sets.size() == 1 ? sets[0] : union_of(sets, context_);
  }

  template <class Set>
  Set sum(std::uint32_t i) {
    std::vector<Set> sets = taken_inputs<Set>(i);
    sets.erase(std::remove_if(sets.begin(), sets.end(), [](const Set& s) { return s.is_empty(); }),
               sets.end());
    if (sets.empty()) return Set();
    return minkowski_sum(std::span<const Set>(sets), context_);
  }

  /// Returns the hull of the inputs. If an input is a union or a hull, its parts can replace it.
  template <class Set>
  Set hull(std::uint32_t i) {
    std::vector<Set> sets;
    for (const std::uint32_t part : region_of(i)) {
      for (const std::uint32_t input : inputs_of(part)) {
        if (!is_rewritten(input)) sets.push_back(taken<Set>(input));
      }
    }
    const Set all = convex_hull(std::span<const Set>(sets), context_);
    // Only the hull of flat polyhedra can be flat, because every other input has an interior.
    return all.regularization(context_);
  }

  /// Returns the nodes that are computed together with a node: itself, and its rewritten inputs.
  /// Users come before what they use.
  std::vector<std::uint32_t> region_of(std::uint32_t top) const {
    std::vector<std::uint32_t> nodes{top};
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      for (const std::uint32_t input : inputs_of(nodes[k])) {
        if (is_rewritten(input)) nodes.push_back(input);
      }
    }
    return nodes;
  }

  /// Returns the value of a Boolean with all Booleans that are computed together with it.
  template <class Set>
  Set region(std::uint32_t top) {
    const std::vector<std::uint32_t> nodes = region_of(top);
    SetTreeBuilder builder;
    std::unordered_map<std::uint32_t, std::optional<SetTreeBuilder::Term>> terms;
    for (std::size_t k = nodes.size(); k-- > 0;) {
      terms[nodes[k]] = term_of(nodes[k], terms, builder);
    }
    const std::optional<SetTreeBuilder::Term> term = terms[top];
    Set value;
    if (term) {
      RegularOperations<Set> operations{context_};
      value = evaluate_tree<Set>(
          builder.finish(*term),
          [this](std::uint32_t input) { return std::get<Set>(values_[input]); }, operations);
    }
    free_inputs(nodes);
    return value;
  }

  /// Returns the term of a Boolean, or nothing if it has no inputs.
  std::optional<SetTreeBuilder::Term> term_of(
      std::uint32_t i,
      const std::unordered_map<std::uint32_t, std::optional<SetTreeBuilder::Term>>& terms,
      SetTreeBuilder& builder) const {
    const SetOperator op = node(i).kind == CsgKind::Difference     ? SetOperator::Difference
                           : node(i).kind == CsgKind::Intersection ? SetOperator::Intersection
                                                                   : SetOperator::Union;
    std::optional<SetTreeBuilder::Term> value;
    bool is_first = true;
    for (const std::uint32_t input : inputs_of(i)) {
      const auto known = terms.find(input);
      const std::optional<SetTreeBuilder::Term> term =
          known == terms.end() ? builder.operand(input) : known->second;
      if (is_first) {
        value = term;
      } else if (!term || !value) {
        // A union with an empty part is the other part, and an intersection with an empty part is
        // empty.
        if (op == SetOperator::Intersection) value.reset();
        if (op == SetOperator::Union && term) value = term;
      } else {
        value = builder.combine(op, *value, *term);
      }
      is_first = false;
    }
    return value;
  }

  void free_inputs(const std::vector<std::uint32_t>& nodes) {
    for (const std::uint32_t part : nodes) {
      for (const std::uint32_t input : inputs_of(part)) {
        if (!is_rewritten(input) && --users_[input] == 0) values_[input] = Value();
      }
    }
  }

  // -------------------------------------------------------------- answers

  void report_nodes() {
    for (std::uint32_t i = 0; i < count_; ++i) {
      CsgNodeReport& own = report(i);
      own.dimension = dimension_[i];
      own.same_as = same_[i];
      if (same_[i] != i && report(same_[i]).work != CsgWork::LeftOut) own.work = CsgWork::Shared;
    }
  }

  CsgResult take_result() {
    write_notes();
    result_.dimension = dimension_[0];
    if (dimension_[0] == CsgDimension::Space) {
      result_.solid = with_sorted_sources(std::get<Nef3>(values_[same_[0]]));
    }
    if (dimension_[0] == CsgDimension::Plane) result_.shape = std::get<Nef2>(values_[same_[0]]);
    return std::move(result_);
  }

  /// Remembers the sources of a node that makes faces. Values are computed in the order of falling
  /// numbers, but the place of equal nodes is that of the first one.
  void remember_sources(std::uint32_t i, const Nef3& solid) {
    for (const PlacedSource& placed : solid.sources()) rank_[placed.source.get()] = i;
  }

  /// Returns the set with its sources in the order of the tree. Where faces coincide, the first
  /// source has precedence. The rewriting of Booleans must not change which source is the first.
  Nef3 with_sorted_sources(Nef3 solid) const {
    if (solid.sources().size() < 2) return solid;
    // The first of all nodes that are equal to a node.
    std::vector<std::uint32_t> first(count_, kNoNode);
    for (std::uint32_t i = count_; i-- > 0;) first[same_[i]] = i;
    const auto place_of = [&](const PlacedSource& placed) {
      const auto known = rank_.find(placed.source.get());
      return known == rank_.end() ? kNoNode : first[known->second];
    };
    std::vector<PlacedSource> sources(solid.sources().begin(), solid.sources().end());
    std::stable_sort(
        sources.begin(), sources.end(),
        [&](const PlacedSource& a, const PlacedSource& b) { return place_of(a) < place_of(b); });
    return solid.with_sources(sources);
  }

  /// Adds a remark. Equal remarks become one note, with the place of the first node.
  void note(std::uint32_t i, const std::string& text) {
    const std::string full = std::string(name_of(node(i).kind)) + ": " + text;
    const auto known = std::find_if(remarks_.begin(), remarks_.end(),
                                    [&](const Remark& remark) { return remark.text == full; });
    if (known == remarks_.end()) {
      remarks_.push_back({i, full, 1});
    } else {
      known->first = std::min(known->first, i);
      ++known->count;
    }
  }

  void write_notes() {
    std::sort(remarks_.begin(), remarks_.end(),
              [](const Remark& a, const Remark& b) { return a.first < b.first; });
    for (const Remark& remark : remarks_) {
      const Node& n = node(remark.first);
      std::string text = remark.text;
      if (n.line > 0) {
        text = std::to_string(n.line) + ":" + std::to_string(n.column) + ": " + text;
      }
      if (remark.count > 1) text += " (and " + std::to_string(remark.count - 1) + " more)";
      result_.notes.push_back(std::move(text));
    }
  }

  void check(std::uint32_t i) {
    if ((i & 0xfffU) == 0) context_.checkpoint("tree", count_ - i, count_);
  }

  const CsgTree& tree_;
  Context& context_;
  MemoryCharge memory_;
  bool has_colors_;
  std::uint32_t count_;
  std::vector<CsgDimension> dimension_;
  CsgPaint paint_;
  std::vector<std::uint32_t> same_;    // The representative of each node.
  std::vector<std::uint32_t> inputs_;  // Representatives, last node first.
  // The index into inputs_ at which the inputs of each node begin.
  std::vector<std::uint32_t> input_begin_;
  // The index at which they end, with the last node first.
  std::vector<std::uint32_t> input_end_;
  std::vector<std::uint32_t> users_;  // How many nodes still need the value.
  // The only user, or kNoNode if there are no users or several.
  std::vector<std::uint32_t> only_user_;
  std::vector<bool> is_only_in_hulls_;  // Whether all users need only the points.
  std::vector<Region> region_;
  std::vector<Remark> remarks_;
  std::uint64_t needed_ = 0;  // Representatives whose values are needed.
  std::vector<Value> values_;
  std::unordered_map<const MeshSource*, std::uint32_t> rank_;  // The node of each source.
  /// A primitive without its colour.
  struct PlainPrimitive {
    std::uint32_t node;
    Nef3 solid;
    std::string remark;
  };
  std::optional<PlainPrimitive> primitive_;  // The primitive that was computed last.
  CsgResult result_;
};

}  // namespace

CsgResult evaluate(const CsgTree& tree, Context& context) {
  return evaluate(tree, CsgEvaluateOptions(), context);
}

CsgResult evaluate(const CsgTree& tree, const CsgEvaluateOptions& options, Context& context) {
  return Evaluator(tree, options, context).run();
}

}  // namespace plumb
