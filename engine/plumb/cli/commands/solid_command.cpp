// The commands `plumb solid ...`: sets of space, combined, transformed and queried.
//
// Most commands are templates (set_command.h, csg_command.h); this file adds expressions over named
// files, sections by planes, intersections of half-spaces, comparison, and Minkowski sums. If there
// are several threads, files are read in parallel. If no format is named, a result is written as
// .nef, which represents every set. Tested by tests/cli/solid_command_test.cpp.

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "plumb/base/set_expression.h"
#include "plumb/base/set_tree.h"
#include "plumb/cli/commands/csg_command.h"
#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/commands/solid_kind.h"
#include "plumb/cli/files/certificate.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/session/command.h"
#include "plumb/convex/minkowski.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/text/text_output.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/canonical.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_measure.h"

namespace plumb::cli {

using Json = nlohmann::ordered_json;

Json SolidFacts::json() const {
  Json volume_json = nullptr;
  if (volume) volume_json = {{"exact", format_exact(*volume)}, {"double", nearest_double(*volume)}};
  return {{"vertices", counts.vertices},
          {"edges", counts.edges},
          {"facets", counts.facets},
          {"volumes", counts.volumes},
          {"marked_volumes", counts.marked_volumes},
          {"bounded", is_bounded},
          {"empty", is_empty},
          {"simple", is_simple},
          {"convex", is_convex},
          {"volume", volume_json}};
}

void SolidFacts::write(std::ostream& out) const {
  out << counted(counts.vertices, "vertex", "vertices") << ", " << counted(counts.edges, "edge")
      << ", " << counted(counts.facets, "facet") << ", " << counted(counts.volumes, "volume")
      << " (" << counts.marked_volumes << " marked)\n"
      << (is_bounded ? "bounded" : "unbounded") << (is_empty ? ", empty" : "")
      << (is_simple ? ", simple" : ", not simple") << (is_convex ? ", convex\n" : ", not convex\n");
  if (volume) out << "volume " << readable(*volume) << '\n';
}

const char* name_of(SpaceItem::Kind kind) {
  switch (kind) {
    case SpaceItem::Kind::Vertex:
      return "vertex";
    case SpaceItem::Kind::Edge:
      return "edge";
    case SpaceItem::Kind::Facet:
      return "facet";
    case SpaceItem::Kind::Volume:
      break;
  }
  return "volume";
}

namespace {

// ---------------------------------------------------------------- sums of points

/// Computes the Minkowski sum of two or more sets.
class MinkowskiSum : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    declare_first<Solid>(app, a_);
    app.add_option("B", others_, "The other sets")->required()->type_name("");
  }
  ProgressStages stages() const override {
    ProgressStages all(1 + others_.size(), reading_solid());
    all.push_back(adding_solids());
    return all;
  }
  Nef3 compute(Session& session) override {
    std::vector<std::string> files{a_};
    files.insert(files.end(), others_.begin(), others_.end());
    require_one_stdin(files);
    std::vector<Nef3> sets = read_all(files, session);
    session.begin("combine");
    Context& context = session.context();
    // The closure of the sum is the sum of the closures, which has far fewer parts.
    if (needs_closure_only(session)) {
      for (Nef3& set : sets) set = set.closure(context);
    }
    return minkowski_sum(sets, context);
  }

  std::string a_;
  std::vector<std::string> others_;
};

// ---------------------------------------------------------------- expressions

/// The operations of an expression, for evaluate_tree().
struct SolidOperations {
  Context& context;

  Nef3 union_of(const std::vector<Nef3>& sets) { return plumb::union_of(sets, context); }
  Nef3 intersection_of(const std::vector<Nef3>& sets) {
    return plumb::intersection_of(sets, context);
  }
  Nef3 difference_of(const std::vector<Nef3>& sets) {
    return plumb::difference_of(sets[0], std::span(sets).subspan(1), context);
  }
  Nef3 symmetric_difference(Nef3 a, Nef3 b) {
    return boolean_op(std::move(a), std::move(b), kSymmetricDifference, context);
  }
  Nef3 complement(const Nef3& a) { return a.complement(context); }
  Nef3 minkowski_sum(const std::vector<Nef3>& sets) { return plumb::minkowski_sum(sets, context); }
};

/// Computes the set that an expression over named files describes.
class Evaluation : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("EXPR", text_,
                   "+ union, * intersection, - difference, ^ symmetric, ! complement, @ sum "
                   "(Minkowski)")
        ->required()
        ->type_name("");
    app.add_option("NAME=FILE", bindings_, "A solid for each name")->type_name("");
  }

  Nef3 compute(Session& session) override {
    const SetExpression expression = parse_set_expression(text_, SetOperators::WithSums);
    const std::map<std::string, std::string> files = bound_files();
    require_used(files, expression.names);
    std::vector<std::string> names;
    for (const std::string& name : expression.names) {
      const auto file = files.find(name);
      if (file == files.end()) {
        throw Error(ErrorCode::Usage, "no file for '" + name + "': add " + name + "=FILE");
      }
      names.push_back(file->second);
    }
    const std::vector<Nef3> operands = read_all(names, session);
    session.begin("combine");
    SolidOperations operations{session.context()};
    return evaluate_tree<Nef3>(
        rewritten(expression), [&](std::uint32_t name) { return operands[name]; }, operations);
  }

  ProgressStages stages() const override {
    return stages_of_sets<Solid>(parse_set_expression(text_, SetOperators::WithSums).names.size(),
                                 1);
  }

  static void require_used(const std::map<std::string, std::string>& files,
                           const std::vector<std::string>& names) {
    for (const auto& [name, file] : files) {
      if (std::find(names.begin(), names.end(), name) != names.end()) continue;
      throw Error(ErrorCode::Usage,
                  "the expression has no '" + name + "': leave out " + name + "=" + file);
    }
  }

  std::map<std::string, std::string> bound_files() const {
    std::map<std::string, std::string> files;
    bool has_stdin = false;
    for (const std::string& binding : bindings_) {
      const std::size_t equals = binding.find('=');
      if (equals == std::string::npos || equals == 0 || equals + 1 == binding.size()) {
        throw Error(ErrorCode::Usage, "expected NAME=FILE, found '" + binding + "'");
      }
      const std::string file = binding.substr(equals + 1);
      if (file == "-" && std::exchange(has_stdin, true)) require_one_stdin({"-", "-"});
      if (!files.emplace(binding.substr(0, equals), file).second) {
        throw Error(ErrorCode::Usage, "two files for '" + binding.substr(0, equals) + "'");
      }
    }
    return files;
  }

  std::string text_;
  std::vector<std::string> bindings_;
};

// ---------------------------------------------------------------- planes

/// Computes the part of a set on a plane, or on one side of it.
class SectionOperation : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    declare_first<Solid>(app, a_);
    app.add_option("--plane", plane_, "The numbers a,b,c,d of a x + b y + c z + d")
        ->required()
        ->type_name("a,b,c,d");
    add_choice(app, "--side", side_, {"closed", "open", "plane"},
               "Where it is <= 0 (closed), < 0 (open), = 0 (plane)")
        ->required();
    add_choice(app, "--keep", keep_, {"inside", "outside"},
               "Keep this part of A (default), or the rest");
  }

  Nef3 compute(Session& session) override {
    const Section section = side_ == "plane"    ? Section::PlaneOnly
                            : side_ == "closed" ? Section::ClosedHalfSpace
                                                : Section::OpenHalfSpace;
    const MarkFunction f = keep_ == "inside" ? kIntersection : kDifference;
    const Nef3 set = read(a_, session);
    session.begin("combine");
    return boolean_op(set, plane(session), section, f, session.context());
  }

  Plane3 plane(Session& session) const {
    std::array<Rational, 4> numbers;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t end = i < 3 ? plane_.find(',', begin) : plane_.size();
      if (end == std::string::npos) {
        throw Error(ErrorCode::Usage, "--plane needs four numbers: a,b,c,d");
      }
      numbers[i] = read_number_argument(plane_.substr(begin, end - begin), "--plane", session);
      begin = end + 1;
    }
    if (numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0) {
      throw Error(ErrorCode::Usage, "--plane: a, b and c are all zero");
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
  }

  std::string a_;
  std::string plane_;
  std::string side_;
  std::string keep_ = "inside";
};

/// Computes the intersection of half-spaces, which are read from a file.
class HalfSpaces : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("FILE", file_, "Lines a b c d closed|open: a x + b y + c z + d <= 0, < 0")
        ->required()
        ->type_name("");
  }
  bool reads_sets() const override { return false; }
  ProgressStages stages() const override { return {reading_solid(), intersecting_half_spaces()}; }
  Nef3 compute(Session& session) override {
    session.begin("read");
    const auto half_spaces = read_half_spaces_file(
        file_, {.exact_decimals = session.options().exact_decimals}, session.context());
    session.begin("combine");
    return intersection_of(half_spaces, session.context());
  }

  std::string file_;
};

/// Compares two sets: they are equal, one contains the other, they are disjoint, or they overlap.
class SolidCompare : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    declare_first<Solid>(app, a_);
    declare_second(app, b_);
    input_.declare(app);
    certificate_.declare(app);
  }
  ExitCode run(Session& session) override {
    require_one_stdin({a_, b_});
    certificate_.open(session);
    ProgressStages stages = stages_of_sets<Solid>(2, 2);
    stages.push_back(writing());
    session.expect(std::move(stages));
    const std::vector<Nef3> sets = read_sets(input_, {a_, b_}, session);
    const Nef3 &a = sets[0], &b = sets[1];
    session.begin("combine");
    const bool is_equal = a == b;
    const bool a_in_b = is_equal || a.is_subset_of(b, session.context());
    const bool b_in_a = is_equal || b.is_subset_of(a, session.context());
    session.begin("combine");
    const bool is_disjoint = boolean_op(a, b, kIntersection, session.context()).is_empty();
    certify_comparison(a, b, input_, session, certificate_);
    const Json json{
        {"equal", is_equal}, {"a_in_b", a_in_b}, {"b_in_a", b_in_a}, {"disjoint", is_disjoint}};
    session.answer(json.dump(), [&](std::ostream& out) {
      out << (is_equal      ? "equal"
              : a_in_b      ? "A lies in B"
              : b_in_a      ? "B lies in A"
              : is_disjoint ? "disjoint"
                            : "they overlap")
          << '\n';
    });
    return is_equal ? ExitCode::Yes : ExitCode::No;
  }

 private:
  std::string a_;
  std::string b_;
  SolidInput input_;
  CertificateOption certificate_;
};

}  // namespace

std::unique_ptr<CommandBody> make_solid_union() {
  return std::make_unique<NaryOperation<Solid>>(NaryFunction::Union);
}
std::unique_ptr<CommandBody> make_solid_intersection() {
  return std::make_unique<NaryOperation<Solid>>(NaryFunction::Intersection);
}
std::unique_ptr<CommandBody> make_solid_difference() {
  return std::make_unique<BinaryOperation<Solid>>(kDifference);
}
std::unique_ptr<CommandBody> make_solid_symmetric_difference() {
  return std::make_unique<BinaryOperation<Solid>>(kSymmetricDifference);
}
std::unique_ptr<CommandBody> make_solid_eval() { return std::make_unique<Evaluation>(); }
std::unique_ptr<CommandBody> make_solid_csg() { return std::make_unique<CsgOperation<Solid>>(); }
std::unique_ptr<CommandBody> make_solid_complement() {
  return std::make_unique<UnaryOperation<Solid>>(&Nef3::complement);
}
std::unique_ptr<CommandBody> make_solid_interior() {
  return std::make_unique<UnaryOperation<Solid>>(&Nef3::interior);
}
std::unique_ptr<CommandBody> make_solid_closure() {
  return std::make_unique<UnaryOperation<Solid>>(&Nef3::closure);
}
std::unique_ptr<CommandBody> make_solid_boundary() {
  return std::make_unique<UnaryOperation<Solid>>(&Nef3::boundary);
}
std::unique_ptr<CommandBody> make_solid_regularize() {
  return std::make_unique<UnaryOperation<Solid>>(&Nef3::regularization);
}
std::unique_ptr<CommandBody> make_solid_section() { return std::make_unique<SectionOperation>(); }
std::unique_ptr<CommandBody> make_solid_halfspaces() { return std::make_unique<HalfSpaces>(); }
std::unique_ptr<CommandBody> make_solid_info() { return std::make_unique<SetInfo<Solid>>(); }
std::unique_ptr<CommandBody> make_solid_locate() { return std::make_unique<SetLocate<Solid>>(); }
std::unique_ptr<CommandBody> make_solid_compare() { return std::make_unique<SolidCompare>(); }
std::unique_ptr<CommandBody> make_convex_minkowski() { return std::make_unique<MinkowskiSum>(); }

}  // namespace plumb::cli
