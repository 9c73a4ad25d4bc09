// Defects and warnings drawn over a view of a map, and the placement of labels.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/picture/plane/plane_view.h"
#include "plumb/picture/svg/svg_text.h"
#include "plumb/plane/map_check.h"

namespace plumb {

/// Places labels near their points without overlap, greedily, in a fixed order of tries.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Rectangle& frame) : frame_(frame) {}

  /// Keeps labels off a place, such as a symbol, if possible.
  void avoid(const Rectangle& r) { points_.push_back(r); }
  /// Keeps labels off a place strictly.
  void block(const Rectangle& r) { taken_.push_back(r); }

  /// Returns a place for a label of this size. Its distance from `anchor` is 0.7 to 4 times
  /// `reach`. The label lies within the frame, overlaps no other label, and covers as few of the
  /// avoided places as possible. Returns no value if there is no such place.
  std::optional<Rectangle> place(Point2 anchor, double width, double height, double reach);

 private:
  bool is_free(const Rectangle& r) const;
  int covered(const Rectangle& r) const;

  Rectangle frame_;
  std::vector<Rectangle> points_;
  std::vector<Rectangle> taken_;
};

// Defects and warnings over a view of the map.

inline constexpr std::size_t kMaxMarks = 5000;  // Largest number of defects drawn.
inline constexpr std::size_t kMaxLabels = 48;   // Largest number of labels in a view.

/// The amount of detail that is drawn.
enum class Detail {
  Overview,
  Closeup,  ///< Also draws vertex numbers and the directions of directed edges.
};

/// Numbers of neighbouring defects under one label. Defects are numbered from 1 as in the report.
struct DefectGroup {
  Point2 anchor;                     ///< Place of the first defect, in picture units.
  std::vector<std::size_t> members;  ///< Indices into the report, ascending.
};

/// Returns the text on the label of a group: "3", "3-7" (with an en dash), "3, 9"; after
/// `long_text` bytes only an ellipsis follows.
std::string group_label(const std::vector<std::size_t>& members, std::size_t long_text);

/// Draws the defects and warnings of a report.
class MapMarks {
 public:
  MapMarks(const MapReport& report, const Plane& plane);

  /// Draws all that lies in the view. Returns the number of groups left without a label.
  std::size_t paint(const View& view, Detail detail, LabelPlacer& room, std::ostream& out) const;

  std::size_t drawn() const { return count_; }
  /// Returns the number of defects that lie in a window of the plane.
  std::size_t count_in(const Rectangle& window) const;
  Point2 place(std::size_t defect) const { return plane_.at(report_.defects[defect].near); }

 private:
  std::pair<std::string, std::string> edge_paths(const View& view, DefectKind kind,
                                                 LabelPlacer& room) const;
  void paint_edges(const View& view, Detail detail, LabelPlacer& room, std::ostream& out) const;
  void paint_warnings(const View& view, Detail detail, std::ostream& out) const;
  void paint_symbols(const View& view, Detail detail, LabelPlacer& room, std::ostream& out) const;
  void paint_vertex_numbers(const View& view, LabelPlacer& room, std::ostream& out) const;
  std::size_t paint_labels(const View& view, Detail detail, LabelPlacer& room,
                           std::ostream& out) const;
  std::string label_colour(const DefectGroup& group) const;
  std::vector<DefectGroup> grouped(const View& view) const;

  const MapReport& report_;
  const Plane& plane_;
  std::size_t count_;
};

}  // namespace plumb
