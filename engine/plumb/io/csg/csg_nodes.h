// From the parameters of a node in a file to the numbers of a node in a tree.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/csg/csg_tree.h"
#include "plumb/io/csg/csg_syntax.h"
#include "plumb/io/csg/text_outlines.h"
#include "plumb/model/primitives.h"

namespace plumb {

/// A file that a node imports. The node gets its kind and its index when the file has been read.
struct CsgImport {
  std::uint32_t node = 0;
  std::string file;
  std::string layer;                      ///< Of a drawing in DXF; empty for all layers.
  std::array<double, 2> origin = {0, 0};  ///< Of a drawing in DXF: the point that becomes (0, 0).
  double scale = 1;                       ///< Of a drawing in DXF, around the origin.
  CircleDivision division;                ///< Of a drawing in DXF: how curves are divided.
  bool is_surface = false;                ///< Whether it is a field of heights: surface().
  bool is_centred = false;                ///< Of a surface, or of a drawing in SVG.
  bool is_inverted = false;               ///< Of a surface.

  bool has_placement() const { return origin != std::array<double, 2>{0, 0} || scale != 1; }
  /// Whether the import gives the same as another import of the same file.
  friend bool is_same_shape(const CsgImport& a, const CsgImport& b) {
    return a.layer == b.layer && a.origin == b.origin && a.scale == b.scale &&
           a.division.count == b.division.count && a.division.angle == b.division.angle &&
           a.division.length == b.division.length && a.is_surface == b.is_surface &&
           a.is_centred == b.is_centred && a.is_inverted == b.is_inverted;
  }
};

/// Appends nodes to a tree.
class CsgNodes {
 public:
  CsgNodes(CsgTree& tree, CsgScanner& scanner, Context& context)
      : tree_(tree), scanner_(scanner), context_(context), memory_(context) {}

  /// Appends the node that the scanner reported last. Its subtree is the node alone, except for
  /// text(), which is a group of polygons, and for an extrusion that names a drawing.
  void append();
  /// Whether the node that the scanner reported last is an extrusion that names a drawing. The
  /// drawing is its only child; children in its block do not count.
  bool names_profile();
  /// Removes the last nodes, from a node on.
  void remove_from(std::uint32_t node);

  std::vector<CsgImport>& imports() { return imports_; }
  /// Notes on parameters that were skipped, each once.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Warnings about nodes that give less than they state, because a number is not finite.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Kind = CsgValue::Kind;

  CsgKind kind_of_node();
  void append_numbers(CsgKind kind);
  void append_map();
  void append_color();
  void append_named_color(const CsgValue& text);
  void append_resize();
  void append_offset();
  void append_linear();
  void append_cylinder();
  void append_points(std::uint32_t axes);
  void append_lists(std::optional<CsgValue> lists, std::uint32_t points, bool are_faces);
  void append_import();
  void append_profile();
  void append_text();
  void append_glyph(const GlyphOutline& glyph);
  TextOutlines outlines_of(const TextRequest& request);
  void count_entries(CsgTree::Node& node) const;
  std::string text(std::string_view name, const std::string& otherwise);
  void append_division();
  CircleDivision division();
  void empty_last_node();
  double fragments();
  double bound_of_chords(const char* name, double otherwise);
  void note_unknown();
  void add_warning(const std::string& text);
  void add_note(const std::string& note);

  std::optional<CsgValue> find(std::string_view name);
  std::optional<CsgValue> find_or_first(std::string_view name);
  double number(std::string_view name, double otherwise);
  double flag(std::string_view name);
  double number_of(const CsgValue& value);
  std::vector<CsgValue> elements(const CsgValue& vector);
  void append_vector(const std::optional<CsgValue>& value, std::size_t count, double otherwise);
  std::uint32_t index_of(const CsgValue& value, std::uint32_t count);
  void push(double value);
  void push_index(std::size_t value);
  void count_step();

  CsgTree& tree_;
  CsgScanner& scanner_;
  Context& context_;
  std::uint32_t steps_ = 0;
  MemoryCharge memory_;
  std::vector<CsgImport> imports_;
  std::vector<std::string> notes_;
  std::vector<std::string> warnings_;
  bool has_lost_number_ = false;  // Whether a number of the node is not finite.
};

}  // namespace plumb
