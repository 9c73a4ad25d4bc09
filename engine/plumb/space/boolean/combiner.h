// Steps 4 to 6 of boolean_op() (boolean_op.h), given contacts and labels. Internal.
//
// Several combiners of the same operands may each make a part, at once, and one of them put the
// parts together.
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

/// What is joined; `outside` is the mark of everything if nothing is left.
struct CombinedDraft {
  SpaceDraft vertices;
  Mark outside;
};

class Combiner {
 public:
  /// What is given is not copied.
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

  /// Contacts make the first vertices of the draft.
  void overlay_contacts(Context& context) { overlay_contacts(0, contacts_.size(), context); }
  void overlay_contacts(std::size_t begin, std::size_t end, Context& context);
  /// Vertices of one operand that lie in volumes of the other.
  void keep_vertices(std::size_t operand, const TouchedComplex& own,
                     std::span<const VolumeId> labels, Context& context);
  /// What other combiners of the same operands have made, one after the other. They are used up.
  void append(std::span<std::optional<Combiner>> parts);
  CombinedDraft finish();

 private:
  /// A point of the draft and the line it points along.
  struct LineEnd {
    std::uint64_t line;   ///< items of a and of b that the half-edge runs in
    std::uint32_t point;  ///< of the draft
    Sign sign;            ///< along the line's reference direction or against it
  };

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
  // of the contact at hand
  std::array<LocalMap, 2> local_;
  SphereMap map_;
  SphereOrigins origins_;
};

}  // namespace plumb
