// Steps 4 to 6 of boolean_op(): overlay at the contacts, selection of the other vertices, pairing
// of half-edges. Contacts and labels are given.
//
// Several combiners of the same operands may each make a part at the same time; one of them then
// appends the parts of the others.
//
// Cost: O(k log k) for k half-edges whose ends are paired along lines, besides the overlays. Proof:
// docs/design/boolean.md, steps 3 to 5 and Lemma 5.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/space/boolean/assemble.h"
#include "plumb/space/boolean/boolean_op.h"
#include "plumb/space/boolean/find_contacts.h"
#include "plumb/space/boolean/vertex_labels.h"
#include "plumb/space/local_maps.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {

/// The vertices of a result, before they are assembled.
struct CombinedDraft {
  SpaceDraft vertices;  ///< The vertices with their sphere maps; points of maps are paired.
  Mark outside;         ///< The mark of all of space if no vertex is left.
};

/// Makes the draft of one Boolean, or a part of it.
class Combiner {
 public:
  /// Keeps references to all arguments but `tables`, which it shares.
  Combiner(std::array<const SpaceComplex*, 2> operands, std::shared_ptr<SpaceTables> tables,
           std::span<const Contact> contacts, const MarkTable& f, const CommonOrigin& origin)
      : operands_(operands),
        planes_(tables->planes),
        points_(tables->points),
        contacts_(contacts),
        table_(f),
        common_origin_(origin),
        draft_(tables),
        overlay_(tables->planes) {}

  /// Overlays the maps at all contacts. Must come first: contacts make the first vertices of the
  /// draft.
  void overlay_contacts(Context& context) { overlay_contacts(0, contacts_.size(), context); }
  /// Overlays the maps at contacts begin, ..., end - 1.
  void overlay_contacts(std::size_t begin, std::size_t end, Context& context);
  /// Adds the vertices of one operand that lie in volumes of the other, with the marks they get
  /// there. `labels` has the volume around each of them.
  void keep_vertices(std::size_t operand, const TouchedComplex& own,
                     std::span<const VolumeId> labels, Context& context);
  /// Appends the results of other combiners of the same operands, in the given order, and consumes
  /// these combiners.
  void append(std::span<std::optional<Combiner>> parts, Context& context);
  /// Pairs all half-edges and returns the draft. The combiner is used up.
  CombinedDraft finish();

 private:
  /// A point of the draft and the line along which it looks.
  struct LineEnd {
    std::uint64_t line;   ///< The cells of a and of b in which the half-edge runs.
    std::uint32_t point;  ///< An index of the draft.
    Sign sign;            ///< Positive if it looks along the line's reference direction.
  };

  /// Applies the function of marks, with the arguments in the order of the operands.
  Mark combined(std::size_t operand, Mark own, Mark other) const {
    return operand == 0 ? table_(own, other) : table_(other, own);
  }
  std::array<Mark, 3> marks_in(std::size_t operand, VolumeId volume) const;
  void reserve(std::size_t operand, const TouchedComplex& own, std::span<const VolumeId> labels);
  void keep_rings(const SpaceComplex& complex, std::vector<VertexCarrier::Remarked>& rings,
                  VertexCarrier& carrier);
  void keep_vertex(const SpaceComplex& complex, VertexId v, const std::array<Mark, 3>& becomes,
                   bool may_dissolve, VertexCarrier& carrier);
  void face_kept_ends(std::size_t operand, const TouchedComplex& own,
                      std::span<const VolumeId> labels, std::span<const std::uint32_t> point_of);
  std::uint32_t facet_origin(const SphereOrigins::Pair& cells) const;
  void add_contact_end(std::uint32_t draft_point, std::uint32_t p);
  Sign sign_on_line(const SphereOrigins::Pair& cells, SphereDirection direction) const;

  void pair_ends();
  void pair_line(std::span<LineEnd> line);
  void face_each_other(std::uint32_t p, std::uint32_t q) {
    draft_.twin[p] = q;
    draft_.twin[q] = p;
  }
  void sort_along(std::span<LineEnd> line);
  std::array<PlaneId, 2> planes_of(std::uint64_t line) const;

  std::array<const SpaceComplex*, 2> operands_;
  const PlaneTable& planes_;
  const Point3Table& points_;
  std::span<const Contact> contacts_;
  MarkTable table_;
  const CommonOrigin& common_origin_;
  SpaceDraft draft_;
  SphereOverlay overlay_;
  std::vector<LineEnd> ends_;
  // The maps of the contact at hand and their overlay; memory that is reused.
  std::array<LocalMap, 2> local_;
  SphereMap map_;
  SphereOrigins origins_;
};

}  // namespace plumb
