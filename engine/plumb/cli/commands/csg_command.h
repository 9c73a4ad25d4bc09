// The commands `plumb solid csg` and `plumb plane csg`: models of OpenSCAD, as templates over the
// kind of sets.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/files/openscad.h"
#include "plumb/cli/session/command.h"
#include "plumb/csg/evaluate.h"
#include "plumb/io/csg_reader.h"
#include "plumb/io/text/files.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

/// The lines that explain how a model was evaluated: for each node, they state the kind of the
/// node, the number of facets or edges, and the time without the time of its children.
///
/// Nodes that only pass on their child are not shown. If an equal node has been shown before, the
/// subtree of the node is not shown again.
class CsgTreeView {
 public:
  CsgTreeView(const CsgTree& tree, const CsgResult& result) : tree_(tree), result_(result) {}

  std::vector<std::string> lines() const {
    std::vector<std::string> all{"seconds   cells  node"};
    std::vector<std::uint32_t> ends;  // Of the shown nodes that contain the next one.
    for (std::uint32_t i = 0; i < tree_.nodes.size();) {
      while (!ends.empty() && ends.back() <= i) ends.pop_back();
      const std::uint32_t end = tree_.nodes[i].end;
      if (passes_on(i)) {
        ++i;
        continue;
      }
      all.push_back(line(i, ends.size()));
      if (report(i).work == CsgWork::Shared || report(i).work == CsgWork::LeftOut) {
        i = end;
      } else {
        ends.push_back(end);
        ++i;
      }
    }
    return all;
  }

 private:
  const CsgNodeReport& report(std::uint32_t i) const { return result_.nodes[i]; }

  /// Whether a node has the same value as a node below it.
  bool passes_on(std::uint32_t i) const {
    const std::uint32_t same = report(i).same_as;
    return same > i && same < tree_.nodes[i].end;
  }

  std::string line(std::uint32_t i, std::size_t depth) const {
    constexpr std::size_t kMostDepth = 40;
    const CsgNodeReport& own = report(i);
    std::string numbers(15, ' ');
    if (own.work == CsgWork::Computed) numbers = seconds(own.seconds) + padded(own.cells);
    std::string text = numbers + "  " + std::string(2 * std::min(depth, kMostDepth), ' ');
    text += name_with_line(i);
    if (own.work == CsgWork::Rewritten) text += ", together with the node above";
    if (own.work == CsgWork::Shared) text += ", equal to " + name_with_line(own.same_as);
    if (own.work == CsgWork::LeftOut) {
      const bool is_nothing = own.dimension == CsgDimension::Nothing;
      text += is_nothing ? ", empty" : ", not needed";
    }
    return text;
  }

  std::string name_with_line(std::uint32_t i) const {
    const CsgTree::Node& node = tree_.nodes[i];
    std::string text(name_of(node.kind));
    if (node.line > 0) text += " at line " + std::to_string(node.line);
    return text;
  }

  /// Returns the seconds with three digits after the point, in seven columns.
  static std::string seconds(double value) {
    const std::string milliseconds =
        std::to_string(static_cast<std::uint64_t>(value * 1000 + 0.5) + 1000000000U);
    const std::size_t point = milliseconds.size() - 3;
    std::string whole = milliseconds.substr(1, point - 1);
    whole.erase(0, std::min(whole.find_first_not_of('0'), whole.size() - 1));
    const std::string text = whole + "." + milliseconds.substr(point);
    return std::string(text.size() < 7 ? 7 - text.size() : 0, ' ') + text;
  }
  static std::string padded(std::size_t value) {
    const std::string text = std::to_string(value);
    return std::string(text.size() < 8 ? 8 - text.size() : 0, ' ') + text;
  }

  const CsgTree& tree_;
  const CsgResult& result_;
};

/// The set that a model describes. No option says how files are read, because imports are read as
/// OpenSCAD reads them.
template <SetKind Kind>
class CsgOperation : public SetOperation<Kind> {
 public:
  using Set = typename Kind::Set;

 private:
  static constexpr bool kIsSolid = std::is_same_v<Set, Nef3>;

  void declare_operands(CLI::App& app) override {
    app.add_option("MODEL", model_,
                   "A model of OpenSCAD: .csg; .scad if openscad is installed; - is standard input")
        ->required()
        ->type_name("");
    app.add_flag("--anywhere", anywhere_, "Import files from anywhere, not only below MODEL");
    app.add_flag("--explain", explains_, "Print the tree with times and sizes (standard error)");
    if constexpr (kIsSolid) this->input().declare_keep(app);
  }
  bool reads_sets() const override { return false; }
  ProgressStages stages() const override { return {Kind::reading(), Kind::combining()}; }

  Set compute(Session& session) override {
    session.begin("read");
    const CsgRead model = read(session);
    print_notes(model_, model, session);
    session.begin("combine");
    CsgResult result = evaluate(model.tree, {.colors = keeps_colors()}, session.context());
    print_notes(model_, result, session);
    if (explains_) {
      for (const std::string& line : CsgTreeView(model.tree, result).lines()) session.note(line);
    }
    require_dimension(result);
    Set set = [&result]() -> Set {
      if constexpr (kIsSolid) {
        return std::move(result.solid);
      } else {
        return std::move(result.shape);
      }
    }();
    if (set.is_empty()) session.warn(model_, "the model is empty");
    return set;
  }

  CsgRead read(Session& session) const {
    CsgReadOptions options;
    options.imports = anywhere_ ? CsgImports::Anywhere : CsgImports::BelowModel;
    options.exact_decimals = session.options().exact_decimals;
    if constexpr (kIsSolid) options.attributes = this->input().kept();
    Context& context = session.context();
    if (!model_.ends_with(".scad")) return read_csg_file(model_, options, context);
    // The positions in messages refer to the flat model.
    const std::string text = flat_model_of(model_, context);
    CsgRead model = read_csg(model_ + " (as .csg)", text, options, context);
    context.release_memory(text.size());
    return model;
  }

  /// Whether --keep asks for colours.
  bool keeps_colors() const {
    if constexpr (kIsSolid) {
      const KeptAttributes kept = this->input().kept();
      return kept == KeptAttributes::All || kept == KeptAttributes::Colours;
    }
    return false;
  }

  void require_dimension(const CsgResult& result) const {
    const CsgDimension other = kIsSolid ? CsgDimension::Plane : CsgDimension::Space;
    if (result.dimension != other) return;
    throw Error(ErrorCode::BadShape,
                kIsSolid ? "the model is a set of the plane: use plumb plane csg"
                         : "the model is a set of space: use plumb solid csg",
                {input_name(model_)});
  }

  std::string model_;
  bool anywhere_ = false;
  bool explains_ = false;
};

}  // namespace plumb::cli
