#include "generate/sphere_program.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "oracle/sphere_leaf.h"

namespace plumb::testing {
namespace {

using Record = std::span<const std::uint8_t>;

// What a record does.
enum What : std::uint8_t {
  kFirstOperation = SphereLeaf::Kinds,
  kCombine = kFirstOperation,  // four kinds of it: operations are not to be rare
  kComplement = kCombine + 4,
  kInterior,
  kClosure,
  kBoundary,
  kRegularization,
  kRemark,
  kCopy,
  kSwap,
  kWhats
};

MarkFunction function_of(unsigned bits) {
  return {(bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0, (bits & 8U) != 0};
}

Rational value(SphereValues values, int n, int axis) {
  switch (values) {
    case SphereValues::Tenths:
      return Rational(0.1 * n + (axis == 0 ? 0.7 * n * n : 0));
    case SphereValues::Thirds:
      return Rational(n) / 3;
    case SphereValues::Large:
      return Rational(std::ldexp(n, 1000));
    case SphereValues::Uneven:
      return Rational(std::ldexp(n, axis == 0 ? -500 : axis == 2 ? 500 : 0));
    case SphereValues::Long: {
      const Rational thirty("1000000000000000000000000000000");
      return axis == 0 ? Rational(n * (thirty + 1) / (thirty + 7)) : Rational(n);
    }
    default:
      return Rational(n);
  }
}

SphereVector vector_of_byte(SphereValues values, std::uint8_t byte) {
  const int x = byte % 5 - 2;
  const int y = byte / 5 % 5 - 2;
  const int z = byte / 25 % 5 - 2;
  const int nonzero_x = x == 0 && y == 0 && z == 0 ? 1 : x;
  return {value(values, nonzero_x, 0), value(values, y, 1), value(values, z, 2)};
}

SphereLeaf leaf_of(SphereValues values, Record r) {
  SphereLeaf leaf{static_cast<SphereLeaf::Kind>(r[0] % kWhats),
                  r[1] % 2 == 0 ? Boundary::Open : Boundary::Closed,
                  {}};
  const std::size_t count = 1 + r[1] / 2 % 6;
  const bool takes_any = leaf.kind == SphereLeaf::Points || leaf.kind == SphereLeaf::Convex;
  for (std::size_t i = 0; i < (takes_any ? count : 3); ++i) {
    leaf.v.push_back(vector_of_byte(values, r[2 + i]));
  }
  return leaf;
}

// The records that fit within the circles, and these.
struct Plan {
  std::vector<Record> records;
  std::vector<CellVector> normals;
  SphereValues values = SphereValues::Plain;
};

CellVector undirected_normal(CellVector n) {
  n = reduced(n);
  const CellVector minus{-n[0], -n[1], -n[2]};
  return std::max(n, minus);
}

Plan plan_of(std::span<const std::uint8_t> program, std::size_t max_circles) {
  Plan plan;
  if (!program.empty()) plan.values = static_cast<SphereValues>(program[0] % kSphereValues);
  std::set<CellVector> circles;
  for (std::size_t i = kSphereRecord; i + kSphereRecord <= program.size(); i += kSphereRecord) {
    const Record r = program.subspan(i, kSphereRecord);
    if (r[0] % kWhats < kFirstOperation) {
      const SphereLeaf leaf = leaf_of(plan.values, r);
      if (!leaf.is_valid()) continue;
      std::set<CellVector> more = circles;
      for (const CellVector& n : leaf.normals()) more.insert(undirected_normal(n));
      if (more.size() > max_circles) break;
      circles = std::move(more);
    }
    plan.records.push_back(r);
  }
  plan.normals.assign(circles.begin(), circles.end());
  return plan;
}

class StackMachine {
 public:
  StackMachine(const Plan& plan, const SphereCells& cells, bool compares)
      : plan_(plan), cells_(cells), compares_(compares) {}

  /// Throws the first difference, as text.
  void run() {
    for (const Record r : plan_.records) {
      step(r);
      if (stack_.size() > 12) break;
    }
  }
  std::string deep_difference_of_last() const {
    if (stack_.empty()) return "";
    const std::string wrong = deep_difference(cells_, stack_.back().sets);
    return wrong.empty() ? "" : wrong + "\nin " + stack_.back().text;
  }
  std::vector<NefSphere> sets() const {
    std::vector<NefSphere> result;
    for (const Entry& e : stack_) result.push_back(e.sets.engine);
    return result;
  }

 private:
  struct Entry {
    TwoSpheres sets;
    std::string text;
  };

  void push(NefSphere engine, CellMarks twin, std::string text) {
    stack_.push_back({{std::move(engine), std::move(twin)}, std::move(text)});
    if (!compares_) return;
    const std::string wrong = difference(cells_, stack_.back().sets);
    if (!wrong.empty()) throw wrong + "\nin " + stack_.back().text;
  }

  Entry pop() {
    Entry e = std::move(stack_.back());
    stack_.pop_back();
    return e;
  }

  void step(Record r) {
    const int what = r[0] % kWhats;
    if (what < kFirstOperation) {
      push_leaf(leaf_of(plan_.values, r));
    } else if (what < kComplement) {
      if (stack_.size() >= 2) combine_two(r);
    } else if (what == kCopy) {
      if (!stack_.empty()) stack_.push_back(stack_[r[1] % stack_.size()]);
    } else if (what == kSwap) {
      if (stack_.size() >= 2) std::swap(stack_.back(), stack_[stack_.size() - 2]);
    } else if (!stack_.empty()) {
      change_one(what, r);
    }
  }

  void push_leaf(const SphereLeaf& leaf) {
    CellMarks marks;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      marks.push_back(leaf.contains(cells_[c].sample));
    push(leaf.to_nef(), std::move(marks), leaf.to_text());
  }

  void combine_two(Record r) {
    const Entry b = pop();
    const Entry a = pop();
    const MarkFunction f = function_of(r[1]);
    Context context;
    push(boolean_op(a.sets.engine, b.sets.engine, f, context),
         combined(f, a.sets.twin, b.sets.twin),
         '(' + a.text + ") op" + std::to_string(r[1] % 16) + " (" + b.text + ')');
  }

  void change_one(int what, Record r) {
    const Entry e = pop();
    const NefSphere& set = e.sets.engine;
    const CellMarks& marks = e.sets.twin;
    switch (what) {
      case kInterior:
        return push(set.interior(), interior_of(cells_, marks), "interior (" + e.text + ')');
      case kClosure:
        return push(set.closure(), closure_of(cells_, marks), "closure (" + e.text + ')');
      case kBoundary:
        return push(set.boundary(), testing::apply(SetOperator::Boundary, cells_, marks, {}),
                    "boundary (" + e.text + ')');
      case kRegularization:
        return push(set.regularization(), closure_of(cells_, interior_of(cells_, marks)),
                    "regularization (" + e.text + ')');
      case kRemark:
        return remark(e, r);
      default:
        return push(!set, complement_of(marks), "! (" + e.text + ')');
    }
  }

  /// Other marks, as the bytes say, for each item of the minimal form.
  void remark(const Entry& e, Record r) {
    const auto mark = [&](SphereCell cell) {
      const std::size_t hash = 7 * cell.index() + 3 * static_cast<std::size_t>(cell.kind());
      return (r[2 + hash % 6] >> (hash / 6 % 8) & 1U) != 0;
    };
    std::vector<SphereVector> samples;
    for (std::size_t c = 0; c < cells_.size(); ++c) samples.push_back(vector_of(cells_[c].sample));
    CellMarks marks;
    for (const SphereLocation& l : e.sets.engine.locate(samples)) marks.push_back(mark(l.cell));
    SphereMarks changed = e.sets.engine.marks();
    for (std::uint32_t i = 0; i < changed.point.size(); ++i) {
      changed.point[i] = mark(SphereCell::point(i)) ? 1 : 0;
    }
    for (std::uint32_t i = 0; i < changed.arc.size(); ++i) {
      changed.arc[i] = mark(SphereCell::arc(i)) ? 1 : 0;
    }
    for (std::uint32_t i = 0; i < changed.face.size(); ++i) {
      changed.face[i] = mark(SphereCell::face(i)) ? 1 : 0;
    }
    push(e.sets.engine.with_marks(changed), std::move(marks), "remarked (" + e.text + ')');
  }

  const Plan& plan_;
  const SphereCells& cells_;
  bool compares_;
  std::vector<Entry> stack_;
};

std::uint8_t any_byte(Dice& dice) { return static_cast<std::uint8_t>(dice.below(256)); }

std::uint8_t any_vector(Dice& dice) {
  if (dice.below(16) == 0) return any_byte(dice);
  const auto digit = [&] { return 1 + dice.below(3); };
  return static_cast<std::uint8_t>(digit() + 5 * digit() + 25 * digit());
}

}  // namespace

std::string disagreement_on_sphere(std::span<const std::uint8_t> program, std::size_t max_circles) {
  const Plan plan = plan_of(program, max_circles);
  const SphereCells cells(plan.normals);
  StackMachine machine(plan, cells, true);
  try {
    machine.run();
  } catch (const std::string& difference) {
    return difference;
  }
  return machine.deep_difference_of_last();
}

/// The twin beside it is one of few cells, to no purpose.
std::vector<NefSphere> sets_on_sphere(std::span<const std::uint8_t> program,
                                      std::size_t max_circles) {
  const Plan plan = plan_of(program, max_circles);
  const SphereCells cells({});
  StackMachine machine(plan, cells, false);
  machine.run();
  return machine.sets();
}

std::vector<std::uint8_t> random_sphere_program(Dice& dice, SphereValues values,
                                                std::size_t records) {
  std::vector<std::uint8_t> program{static_cast<std::uint8_t>(values)};
  program.resize(kSphereRecord);
  for (std::size_t i = 0; i < records; ++i) {
    const bool is_leaf = i < 2 || dice.below(5) < 3;
    program.push_back(static_cast<std::uint8_t>(
        is_leaf ? dice.below(kFirstOperation)
                : kFirstOperation + dice.below(kWhats - kFirstOperation)));
    program.push_back(any_byte(dice));
    for (int p = 0; p < 6; ++p) program.push_back(any_vector(dice));
  }
  return program;
}

std::vector<std::uint8_t> wild_sphere_program(Dice& dice, std::size_t records) {
  std::vector<std::uint8_t> program(records * kSphereRecord);
  for (std::uint8_t& byte : program) byte = any_byte(dice);
  return program;
}

}  // namespace plumb::testing
