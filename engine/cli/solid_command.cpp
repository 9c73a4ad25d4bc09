// plumb solid ...: sets of space, combined, transformed, asked.

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "command.h"
#include "number_argument.h"
#include "plumb/base/error.h"
#include "plumb/base/set_expression.h"
#include "plumb/io/input.h"
#include "plumb/io/solid_sets.h"
#include "plumb/space/nef3.h"
#include "solid_output.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSetHelp = "A solid: .off, .obj, .stl, .ply, .nef; - is standard input";

/// How meshes are read as sets: the same options for all operands.
class MeshRule {
 public:
  void declare(CLI::App& app) {
    app.add_option("--rule", rule_,
                   "Winding numbers inside: positive, nonzero, odd (default: positive, and "
                   "components inside out are turned)")
        ->type_name("RULE")
        ->check(CLI::IsMember({"positive", "nonzero", "odd"}));
    app.add_flag("--surface", surface_, "Read a mesh, open or not, as the set of its facets");
  }

  Nef3 read(const std::string& file, Session& session) const {
    SolidReadOptions options;
    options.exact_decimals = session.options().exact_decimals;
    options.surface = surface_;
    if (!rule_.empty()) {
      options.rule = rule_ == "odd"       ? WindingRule::EvenOdd
                     : rule_ == "nonzero" ? WindingRule::NonZero
                                          : WindingRule::Positive;
    }
    SolidRead solid = read_solid_file(file, options, session.context());
    for (const std::string& note : solid.notes) session.note(input_name(file) + ": " + note);
    return std::move(solid.set);
  }

 private:
  std::string rule_;
  bool surface_ = false;
};

class SolidOperation : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    declare_operands(app);
    rule_.declare(app);
    app.add_flag("--strict", strict_,
                 "Exit 2 instead of writing a file that leaves something out or is reshaped by "
                 "rounding");
  }

  ExitCode run(Session& session) override {
    output_.open(session);
    const Nef3 result = compute(session);
    output_.prepare(result, strict_, session);
    output_.deliver(session);
    return ExitCode::Yes;
  }

 protected:
  virtual void declare_operands(CLI::App& app) = 0;
  virtual Nef3 compute(Session& session) = 0;
  Nef3 read(const std::string& file, Session& session) const { return rule_.read(file, session); }

 private:
  MeshRule rule_;
  bool strict_ = false;
  SolidOutput output_;
};

void require_one_stdin(const std::string& a, const std::string& b) {
  if (a == "-" && b == "-") {
    throw Error(ErrorCode::Usage, "only one of the sets can come from standard input");
  }
}

class BinaryOperation : public SolidOperation {
 public:
  explicit BinaryOperation(MarkFunction function) : function_(function) {}

 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("A", a_, kSetHelp)->required()->type_name("");
    app.add_option("B", b_, "The other set")->required()->type_name("");
  }
  Nef3 compute(Session& session) override {
    require_one_stdin(a_, b_);
    const Nef3 a = read(a_, session);
    return combine(a, read(b_, session), function_, session.context());
  }

  MarkFunction function_;
  std::string a_;
  std::string b_;
};

class UnaryOperation : public SolidOperation {
 public:
  using Function = Nef3 (Nef3::*)() const;
  explicit UnaryOperation(Function function) : function_(function) {}

 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("A", a_, kSetHelp)->required()->type_name("");
  }
  Nef3 compute(Session& session) override { return (read(a_, session).*function_)(); }

  Function function_;
  std::string a_;
};

// ---------------------------------------------------------------- expressions

MarkFunction function_of(SetOperator op) {
  switch (op) {
    case SetOperator::Union:
      return kUnion;
    case SetOperator::Intersection:
      return kIntersection;
    case SetOperator::Difference:
      return kDifference;
    default:
      return kSymmetricDifference;
  }
}

class Evaluation : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("EXPR", text_,
                   "+ union, * intersection, - difference, ^ symmetric, ! complement")
        ->required()
        ->type_name("");
    app.add_option("NAME=FILE", bindings_, "A solid for each name")->type_name("");
  }

  Nef3 compute(Session& session) override {
    const SetExpression expression = parse_set_expression(text_);
    const std::map<std::string, std::string> files = bound_files();
    std::vector<Nef3> operands;
    for (const std::string& name : expression.names) {
      const auto file = files.find(name);
      if (file == files.end()) {
        throw Error(ErrorCode::Usage, "no file for '" + name + "': add " + name + "=FILE");
      }
      operands.push_back(read(file->second, session));
    }
    return evaluate<Nef3>(
        expression, [&](std::uint32_t name) { return operands[name]; },
        [](const Nef3& a) { return !a; },
        [&](SetOperator op, const Nef3& a, const Nef3& b) {
          return combine(a, b, function_of(op), session.context());
        });
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
      if (file == "-" && std::exchange(has_stdin, true)) require_one_stdin("-", "-");
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

class SectionOperation : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("A", a_, kSetHelp)->required()->type_name("");
    app.add_option("--plane", plane_, "a,b,c,d of a x + b y + c z + d")
        ->required()
        ->type_name("a,b,c,d");
    app.add_option("--side", side_, "closed: <= 0, open: < 0, plane: = 0")
        ->required()
        ->type_name("SIDE")
        ->check(CLI::IsMember({"closed", "open", "plane"}));
    app.add_option("--keep", keep_, "outside: what lies beyond instead")
        ->type_name("outside")
        ->check(CLI::IsMember({"outside"}));
  }

  Nef3 compute(Session& session) override {
    const Section section = side_ == "plane"    ? Section::PlaneOnly
                            : side_ == "closed" ? Section::ClosedHalfSpace
                                                : Section::OpenHalfSpace;
    const MarkFunction f = keep_.empty() ? kIntersection : kDifference;
    return combine(read(a_, session), plane(session), section, f, session.context());
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
  std::string keep_;
};

class HalfSpaces : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("FILE", file_, "Lines a b c d closed|open: a x + b y + c z + d <= 0, < 0")
        ->required()
        ->type_name("");
  }
  Nef3 compute(Session& session) override {
    const auto half_spaces = read_half_spaces_file(
        file_, {.exact_decimals = session.options().exact_decimals}, session.context());
    return Nef3::intersection(half_spaces, session.context());
  }

  std::string file_;
};

// ---------------------------------------------------------------- questions

class SolidInfo : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", a_, kSetHelp)->required()->type_name("");
    rule_.declare(app);
  }
  ExitCode run(Session& session) override {
    const Nef3 set = rule_.read(a_, session);
    session.answer(solid_json(set).dump(), [&](std::ostream& out) { write_solid_info(out, set); });
    return ExitCode::Yes;
  }

 private:
  std::string a_;
  MeshRule rule_;
};

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

class SolidLocate : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", a_, kSetHelp)->required()->type_name("");
    app.add_option("X", x_, "The point: 3, -1/7, 2.5")->required()->type_name("");
    app.add_option("Y", y_)->required()->type_name("");
    app.add_option("Z", z_)->required()->type_name("");
    rule_.declare(app);
  }
  ExitCode run(Session& session) override {
    const RationalPoint3 point{read_number_argument(x_, "X", session),
                               read_number_argument(y_, "Y", session),
                               read_number_argument(z_, "Z", session)};
    const SpaceLocation place = rule_.read(a_, session).locate(point);
    const std::string on = name_of(place.item.kind());
    session.answer(Json{{"on", on}, {"marked", place.marked}}.dump(), [&](std::ostream& out) {
      out << on << (place.marked ? ", in the set\n" : ", not in the set\n");
    });
    return ExitCode::Yes;
  }

 private:
  std::string a_;
  std::string x_;
  std::string y_;
  std::string z_;
  MeshRule rule_;
};

class SolidCompare : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", a_, kSetHelp)->required()->type_name("");
    app.add_option("B", b_, "The other set")->required()->type_name("");
    rule_.declare(app);
  }
  ExitCode run(Session& session) override {
    require_one_stdin(a_, b_);
    const Nef3 a = rule_.read(a_, session), b = rule_.read(b_, session);
    const bool is_equal = a == b, a_in_b = is_equal || a <= b, b_in_a = is_equal || b <= a;
    const bool is_disjoint = combine(a, b, kIntersection, session.context()).is_empty();
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
  MeshRule rule_;
};

}  // namespace

std::unique_ptr<CommandBody> make_solid_union() {
  return std::make_unique<BinaryOperation>(kUnion);
}
std::unique_ptr<CommandBody> make_solid_intersection() {
  return std::make_unique<BinaryOperation>(kIntersection);
}
std::unique_ptr<CommandBody> make_solid_difference() {
  return std::make_unique<BinaryOperation>(kDifference);
}
std::unique_ptr<CommandBody> make_solid_symmetric_difference() {
  return std::make_unique<BinaryOperation>(kSymmetricDifference);
}
std::unique_ptr<CommandBody> make_solid_eval() { return std::make_unique<Evaluation>(); }
std::unique_ptr<CommandBody> make_solid_complement() {
  return std::make_unique<UnaryOperation>(&Nef3::operator!);
}
std::unique_ptr<CommandBody> make_solid_interior() {
  return std::make_unique<UnaryOperation>(&Nef3::interior);
}
std::unique_ptr<CommandBody> make_solid_closure() {
  return std::make_unique<UnaryOperation>(&Nef3::closure);
}
std::unique_ptr<CommandBody> make_solid_boundary() {
  return std::make_unique<UnaryOperation>(&Nef3::boundary);
}
std::unique_ptr<CommandBody> make_solid_regularize() {
  return std::make_unique<UnaryOperation>(&Nef3::regularization);
}
std::unique_ptr<CommandBody> make_solid_section() { return std::make_unique<SectionOperation>(); }
std::unique_ptr<CommandBody> make_solid_halfspaces() { return std::make_unique<HalfSpaces>(); }
std::unique_ptr<CommandBody> make_solid_info() { return std::make_unique<SolidInfo>(); }
std::unique_ptr<CommandBody> make_solid_locate() { return std::make_unique<SolidLocate>(); }
std::unique_ptr<CommandBody> make_solid_compare() { return std::make_unique<SolidCompare>(); }

}  // namespace plumb::cli
