#include "oracle/nef3_check.h"

#include <algorithm>

#include "oracle/twin_check.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"

namespace plumb::testing {
namespace {

std::string to_text(SpaceItem item, bool marked) {
  static constexpr const char* kKinds[] = {"vertex ", "edge ", "facet ", "volume "};
  if (!item.is_valid()) return "nowhere";
  return kKinds[static_cast<int>(item.kind())] + std::to_string(item.index()) +
         (marked ? " marked" : " unmarked");
}

template <class Items>
std::size_t number_marked(const Items& items) {
  return static_cast<std::size_t>(
      std::count_if(items.begin(), items.end(), [](const auto& item) { return item.mark; }));
}

// Every check throws the first difference, as text.
class Checker {
 public:
  Checker(const SpaceCells& cells, const TwoSpaceSets& sets)
      : cells_(cells), sets_(sets), engine_(sets.engine), twin_(sets.twin) {}

  std::string run(bool deeply) {
    return first_difference([&] {
      check_complex();
      check_answers();
      if (deeply) check_deeply();
    });
  }

 private:
  void check_complex() {
    graph_ = minimal_graph(cells_, twin_);
    match_ = match(engine_.complex(), graph_, cells_);
    const std::optional<SpaceFlaw> flaw = audit(engine_.complex(), AuditForm::Minimal);
    if (!match_.difference.empty()) {
      throw match_.difference + (flaw ? " (audit: " + flaw->invariant + ")" : "");
    }
    if (flaw) throw "audit: " + flaw->invariant + " at " + flaw->place;
  }

  void check_answers() const {
    const SpaceCounts counts{graph_.vertices.size(), graph_.edges.size(), graph_.facets.size(),
                             graph_.volumes.size(), number_marked(graph_.volumes)};
    expect(engine_.counts() == counts, "counts: engine differs from twin");
    const auto none = std::none_of(twin_.begin(), twin_.end(), [](bool b) { return b; });
    const auto all = std::all_of(twin_.begin(), twin_.end(), [](bool b) { return b; });
    expect_same(engine_.is_empty(), none, "is_empty");
    expect_same(engine_.is_whole(), all, "is_space");
    expect_same(engine_.is_bounded(), is_bounded(cells_, twin_), "is_bounded");
    expect_same(engine_.is_closed(), closure_of(cells_, twin_) == twin_, "is_closed");
    expect_same(engine_.is_open(), interior_of(cells_, twin_) == twin_, "is_open");
    const std::optional<Rational> volume = marked_volume(engine_.complex());
    const std::optional<BigRational> expected = volume_of(cells_, twin_);
    expect_same(volume.has_value(), expected.has_value(), "volume is finite");
    expect(!volume || exact_of(*volume) == *expected, "volume: engine differs from twin");
  }

  void check_deeply() const {
    check_locations();
    check_operators(cells_, sets_);
    check_marks();
  }

  void check_locations() const {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const ExactPoint3& p = cells_[c].point;
      const std::string where = " at " + testing::to_text(p);
      const SpaceLocation got = engine_.locate(to_rational(p));
      const SpaceItem expected = match_.item(graph_.element_of[c]);
      if (got.item != expected || got.marked != twin_[c]) {
        throw "locate" + where + ": engine " + to_text(got.item, got.marked) + ", twin " +
            to_text(expected, twin_[c]);
      }
      Point3 rounded;
      if (as_double(p, rounded)) {
        expect(engine_.locate(rounded).item == got.item, "locate by doubles" + where);
      }
    }
  }

  // Of the frame, anything.
  static std::vector<Mark> flipped(std::vector<Mark> marks, bool is_flipped) {
    for (Mark& m : marks) m = m == kBeyond ? 0 : m ^ (is_flipped ? 1U : 0U);
    return marks;
  }
  static SpaceMarks marks_of(const SpaceComplex& c, bool is_flipped) {
    return {flipped(c.vertex_mark, is_flipped), flipped(c.edge_mark, is_flipped),
            flipped(c.facet_mark, is_flipped), flipped(c.volume_mark, is_flipped)};
  }

  void check_marks() const {
    const SpaceComplex& complex = engine_.complex();
    Context context;
    expect(engine_.with_marks(marks_of(complex, false), context) == engine_,
           "with_marks of its own marks");
    expect(engine_.with_marks(marks_of(complex, true), context) == !engine_,
           "with_marks of flipped marks");
    expect(Nef3::from_complex(complex, context) == engine_, "from_complex of its own complex");
  }

  const SpaceCells& cells_;
  const TwoSpaceSets& sets_;
  const Nef3& engine_;
  const CellMarks& twin_;
  SpaceGraph graph_;
  SpaceMatch match_;
};

}  // namespace

std::string difference(const SpaceCells& cells, const TwoSpaceSets& sets) {
  return Checker(cells, sets).run(false);
}

std::string deep_difference(const SpaceCells& cells, const TwoSpaceSets& sets) {
  return Checker(cells, sets).run(true);
}

std::string disagreement(const SpaceSet& set) {
  const SpaceCells cells = cells_of(set);
  return TreeCheck<SpaceOperation, TwoSpaceSets, SpaceSet, SpaceCells>(set, cells).run();
}

}  // namespace plumb::testing
