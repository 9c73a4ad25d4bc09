// The commands `plumb solid distance` and `plumb plane distance`.
// Tested by tests/cli/model_command_test.cpp.

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "plumb/cli/commands/plane_kind.h"
#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/commands/solid_kind.h"
#include "plumb/cli/session/command.h"
#include "plumb/io/text/text_output.h"
#include "plumb/model/distance.h"
#include "plumb/predicates/rounding.h"

namespace plumb::cli {
namespace {

const char* name_of_cell(const SpaceLocation& cell) { return name_of(cell.item.kind()); }
const char* name_of_cell(const PlaneLocation& cell) {
  return cell.vertex.is_valid() ? "vertex" : cell.edge.is_valid() ? "edge" : "face";
}

std::vector<Rational> numbers_in(const RationalPoint3& p) { return {p.x, p.y, p.z}; }
std::vector<Rational> numbers_in(const RationalPoint2& p) { return {p.x, p.y}; }

/// How far two sets are apart.
template <SetKind Kind>
class SetDistance : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    declare_first<Kind>(app, a_);
    declare_second(app, b_);
    input_.declare(app);
  }
  ExitCode run(Session& session) override {
    require_one_stdin({a_, b_});
    session.expect({Kind::reading(), Kind::reading(), Kind::measuring(), writing()});
    const auto sets = read_sets(input_, {a_, b_}, session);
    session.begin("measure");
    const auto found = distance(sets[0], sets[1], session.context());
    const double length = root_of(found.squared);
    Json json{{"distance", length},
              {"squared",
               {{"exact", format_exact(found.squared)}, {"double", nearest_double(found.squared)}}},
              {"a", place(found.at_a, found.cell_a)},
              {"b", place(found.at_b, found.cell_b)}};
    session.answer(json.dump(), [&](std::ostream& out) {
      out << "distance " << length << ", squared " << readable(found.squared) << '\n';
      write(out, "A: ", found.at_a, found.cell_a);
      write(out, "B: ", found.at_b, found.cell_b);
    });
    return ExitCode::Yes;
  }

 private:
  using Json = nlohmann::ordered_json;

  template <class Point, class Cell>
  static Json place(const Point& at, const Cell& cell) {
    Json point = Json::array(), exact = Json::array();
    for (const Rational& x : numbers_in(at)) {
      point.push_back(nearest_double(x));
      exact.push_back(format_exact(x));
    }
    return {{"on", name_of_cell(cell)}, {"point", point}, {"exact", exact}};
  }
  template <class Point, class Cell>
  static void write(std::ostream& out, const char* name, const Point& at, const Cell& cell) {
    out << name << name_of_cell(cell) << " (";
    const char* separator = "";
    for (const Rational& x : numbers_in(at)) {
      out << separator << decimal_text(x, 6);
      separator = " ";
    }
    out << ")\n";
  }

  std::string a_;
  std::string b_;
  typename Kind::Input input_;
};

}  // namespace

std::unique_ptr<CommandBody> make_solid_distance() {
  return std::make_unique<SetDistance<Solid>>();
}
std::unique_ptr<CommandBody> make_plane_distance() {
  return std::make_unique<SetDistance<Plane>>();
}

}  // namespace plumb::cli
