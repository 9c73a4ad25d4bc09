// Models of OpenSCAD: nodes, the modifier `!`, and imported files.
//
// Nodes are appended to the tree as they are read; the end of a subtree is set when its block ends.
// A node with the modifier `*` or `%` is read like any other, so that its errors are found, and
// removed at its end. Files are imported last, so that the files of removed nodes are never opened.
//
// Tested by tests/io/csg_reader_test.cpp and fuzz/csg_reader.cpp.
#include "plumb/io/csg_reader.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/io/csg/csg_nodes.h"
#include "plumb/io/csg/csg_syntax.h"
#include "plumb/io/csg/surface_file.h"
#include "plumb/io/plane/dxf.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

/// Reads one model.
class ModelReader {
 public:
  ModelReader(const std::string& path, std::string_view text, const CsgReadOptions& options,
              Context& context)
      : path_(path),
        options_(options),
        context_(context),
        scanner_(text, input_name(path), context),
        nodes_(read_.tree, scanner_, context) {
    read_.tree.file = input_name(path);
  }

  CsgRead run() {
    read_nodes_with_places();
    read_.notes = nodes_.notes();
    read_.warnings = nodes_.warnings();
    note_left_out();
    if (root_) keep_subtree(*root_);
    for (const CsgImport& import : nodes_.imports()) import_file(import);
    return std::move(read_);
  }

 private:
  using Event = CsgScanner::Event;

  /// The kind of an imported set, and its index in the tree.
  using ImportedValue = std::pair<CsgKind, std::uint32_t>;
  struct Imported {
    CsgImport import;
    ImportedValue value;
  };
  /// A node whose block is open.
  struct Open {
    std::uint32_t node;
    bool is_left_out;                // By the modifier * or %.
    bool leaves_out_children;        // Because an extrusion names a drawing.
    bool is_beside_drawing = false;  // A child of such an extrusion.
  };

  std::vector<CsgTree::Node>& tree_nodes() { return read_.tree.nodes; }

  /// Reads the nodes. Errors about limits get the place of the node that is read.
  void read_nodes_with_places() {
    try {
      read_nodes();
    } catch (const Error& error) {
      if (error.code() != ErrorCode::ResourceLimit || !error.place().file.empty()) throw;
      scanner_.fail(error.code(), error.message());
    }
  }

  void read_nodes() {
    std::vector<Open> open;
    for (Event event = scanner_.next(); event != Event::Done; event = scanner_.next()) {
      if (event == Event::Close) {
        close(open.back());
        open.pop_back();
        continue;
      }
      const Open node{static_cast<std::uint32_t>(tree_nodes().size()),
                      scanner_.has('*') || scanner_.has('%'), nodes_.names_profile(),
                      !open.empty() && open.back().leaves_out_children};
      nodes_.append();
      if (scanner_.has('!') && !root_) root_ = node.node;
      if (event == Event::Open) {
        // Primitives are the last kinds. If a primitive has a child, a semicolon is missing.
        const bool is_primitive = tree_nodes()[node.node].kind >= CsgKind::Cube;
        if (is_primitive || scanner_.name() == "text") scanner_.require_braces();
        open.push_back(node);
      } else {
        close(node);
      }
    }
    tree_nodes()[0].end = static_cast<std::uint32_t>(tree_nodes().size());
  }

  void close(const Open& open) {
    if (open.is_beside_drawing) {
      has_children_beside_drawing_ = true;
      nodes_.remove_from(open.node);
      if (root_ && *root_ >= open.node) root_.reset();
      return;
    }
    if (!open.is_left_out) {
      tree_nodes()[open.node].end = static_cast<std::uint32_t>(tree_nodes().size());
      return;
    }
    ++left_out_;
    nodes_.remove_from(open.node);
    if (root_ && *root_ >= open.node) root_.reset();
  }

  void note_left_out() {
    if (has_children_beside_drawing_) {
      read_.notes.emplace_back("the children of extrusions that name a file left out");
    }
    if (left_out_ == 0) return;
    read_.notes.push_back(std::to_string(left_out_) + (left_out_ == 1 ? " node" : " nodes") +
                          " with the modifier * or % left out");
  }

  /// Makes the subtree of a node the only subtree below the root.
  void keep_subtree(std::uint32_t top) {
    const std::vector<CsgTree::Node> all = std::move(tree_nodes());
    const std::uint32_t end = all[top].end;
    tree_nodes() = {all[0]};
    tree_nodes()[0].end = end - top + 1;
    for (std::uint32_t i = top; i < end; ++i) {
      tree_nodes().push_back(all[i]);
      tree_nodes().back().end -= top - 1;
    }
    std::vector<CsgImport> kept;
    for (CsgImport& import : nodes_.imports()) {
      if (import.node < top || import.node >= end) continue;
      import.node -= top - 1;
      kept.push_back(std::move(import));
    }
    nodes_.imports() = std::move(kept);
    read_.notes.push_back("all but the node with the modifier ! left out");
  }

  // -------------------------------------------------------------- imports

  [[noreturn]] void fail_at(const CsgTree::Node& node, ErrorCode code,
                            const std::string& message) const {
    throw Error(code, message, {read_.tree.file, node.line, node.column});
  }

  fs::path folder() const {
    const fs::path parent = path_ == "-" ? fs::path() : path_of(path_).parent_path();
    return parent.empty() ? fs::path(".") : parent;
  }

  /// Returns the file that a node names, if this file may be read.
  std::string allowed_file(const CsgTree::Node& node, const std::string& name) const {
    if (options_.imports == CsgImports::None) {
      fail_at(node, ErrorCode::CannotOpen, "imports are not allowed");
    }
    const fs::path file = folder() / path_of(name);
    if (options_.imports == CsgImports::Anywhere) return file_name_of(file);
    if (!lies_below(file_name_of(folder()), file_name_of(file))) {
      fail_at(node, ErrorCode::CannotOpen,
              "the imported file " + plumb::quoted(name) +
                  " does not lie in the folder of the model or below it");
    }
    return file_name_of(file);
  }

  /// Reads an imported file. Nodes that import the same part of a file share it.
  void import_file(const CsgImport& import) {
    CsgTree::Node& node = tree_nodes()[import.node];
    std::vector<Imported>& known = imported_[import.file];
    for (const Imported& each : known) {
      if (is_same_shape(each.import, import)) return set_import(node, each.value);
    }
    const std::string file = allowed_file(node, import.file);
    try {
      known.push_back({import, read_import(file, import)});
      set_import(node, known.back().value);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Cancelled) throw;
      fail_at(node, error.code(),
              (import.is_surface ? "surface: " : "import: ") + std::string(error.what()));
    }
  }

  void set_import(CsgTree::Node& node, const ImportedValue& value) {
    node.kind = value.first;
    node.first_index = static_cast<std::uint32_t>(read_.tree.indices.size());
    node.index_count = 1;
    read_.tree.indices.push_back(value.second);
  }

  ImportedValue read_import(const std::string& file, const CsgImport& import) {
    CsgTree& tree = read_.tree;
    if (import.is_surface) {
      tree.solids.push_back(read_surface(file, import));
      return {CsgKind::Solid, static_cast<std::uint32_t>(tree.solids.size() - 1)};
    }
    const auto format = plane_format_of(file);
    const bool is_drawing = format == PlaneFormat::Dxf;
    if (!is_drawing && (!import.layer.empty() || import.has_placement())) {
      read_.notes.push_back(file + ": layer, origin and scale of import() are used for DXF alone");
    }
    if (format) {
      PlaneRead shape = is_drawing ? read_drawing(file, import) : read_shape(file);
      if (format == PlaneFormat::Svg && import.is_centred) shape.set = centred(shape.set);
      tell(file, shape.notes, read_.notes);
      tell(file, shape.warnings, read_.warnings);
      tree.shapes.push_back(shape.set.regularization(context_));
      return {CsgKind::Shape, static_cast<std::uint32_t>(tree.shapes.size() - 1)};
    }
    SolidReadOptions options;
    options.exact_decimals = options_.exact_decimals;
    options.attributes = options_.attributes;
    SolidRead solid = read_solid_file(file, options, context_);
    tell(file, solid.notes, read_.notes);
    tell(file, solid.warnings, read_.warnings);
    tree.solids.push_back(solid.set.regularization(context_));
    return {CsgKind::Solid, static_cast<std::uint32_t>(tree.solids.size() - 1)};
  }

  Nef3 read_surface(const std::string& file, const CsgImport& import) {
    const std::string bytes = read_input(file, context_);
    MemoryCharge charge(context_);
    const HeightGrid grid = read_heights(bytes, file, import.is_inverted, charge, context_);
    const PolygonMesh mesh = surface_mesh(grid, import.is_centred, charge, context_);
    context_.release_memory(bytes.size());
    if (mesh.face_count() > 0) return Nef3::from_mesh(mesh, {}, context_);
    read_.notes.push_back(file + ": a surface of fewer than two rows or columns is empty");
    return Nef3::empty();
  }
  PlaneRead read_shape(const std::string& file) {
    return read_plane_set_file(file, {}, {file, options_.exact_decimals}, context_);
  }
  /// Reads one layer of a drawing as OpenSCAD does, moved and scaled.
  PlaneRead read_drawing(const std::string& file, const CsgImport& import) {
    const std::string text = read_input(file, context_);
    const DxfSelection selection{import.layer, true, import.division, import.scale};
    PlaneRead shape = read_dxf_set(text, selection, {file, options_.exact_decimals}, context_);
    context_.release_memory(text.size());
    if (!import.has_placement()) return shape;
    const Rational scale = import.scale;
    AffineMap2 map{.xx = scale, .x0 = -scale * import.origin[0]};
    map.yy = scale;
    map.y0 = -scale * import.origin[1];
    shape.set = shape.set.transformed(map, context_);
    return shape;
  }

  /// Returns a bounded set whose bounding box has its middle at the origin.
  Nef2 centred(const Nef2& set) {
    std::optional<RationalPoint2> low, high;
    const PlaneParts parts = set.parts(context_);
    for (const PolygonWithHoles2& polygon : parts.polygons) {
      for (const RationalPoint2& p : polygon.outer) {
        if (!low) low = high = p;
        low = RationalPoint2{std::min(low->x, p.x), std::min(low->y, p.y)};
        high = RationalPoint2{std::max(high->x, p.x), std::max(high->y, p.y)};
      }
    }
    if (!low) return set;
    AffineMap2 map{.xx = 1, .x0 = -(low->x + high->x) / 2};
    map.yy = 1;
    map.y0 = -(low->y + high->y) / 2;
    return set.transformed(map, context_);
  }

  static void tell(const std::string& file, const std::vector<std::string>& from,
                   std::vector<std::string>& to) {
    for (const std::string& text : from) to.push_back(file + ": " + text);
  }

  std::string path_;
  CsgReadOptions options_;
  Context& context_;
  CsgRead read_;
  CsgScanner scanner_;
  CsgNodes nodes_;
  std::optional<std::uint32_t> root_;  // The first node with the modifier `!`.
  std::uint64_t left_out_ = 0;
  bool has_children_beside_drawing_ = false;
  std::map<std::string, std::vector<Imported>> imported_;  // The key is the name of the file.
};

}  // namespace

CsgRead read_csg(const std::string& path, std::string_view text, const CsgReadOptions& options,
                 Context& context) {
  const RoundToNearest rounding;
  return ModelReader(path, text, options, context).run();
}

CsgRead read_csg_file(const std::string& path, const CsgReadOptions& options, Context& context) {
  const std::string text = read_input(path, context);
  CsgRead read = read_csg(path, text, options, context);
  context.release_memory(text.size());
  return read;
}

}  // namespace plumb
