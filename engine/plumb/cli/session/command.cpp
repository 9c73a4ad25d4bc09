// The table of commands, and the options of each as CLI11 represents them.
//
// The table is the only list of commands. Help, manual, completion, the suggestion after a typing
// error, and the tests read it. Descriptions are wrapped at 80 columns by a formatter of our own,
// because the formatter of CLI11 makes longer lines. Tested by tests/cli/help_commands_test.cpp and
// tests/cli/program_test.cpp.
#include "plumb/cli/session/command.h"

#include <array>
#include <memory>
#include <sstream>
#include <utility>

namespace plumb::cli {
namespace {

constexpr std::size_t kScreen = 80;        // Columns of the screen.
constexpr std::size_t kDescriptions = 30;  // Column in which descriptions begin.

/// Returns `text` in lines of at most `width` characters, broken between words.
std::string wrapped(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string lines;
  std::size_t used = 0;
  for (std::string word; words >> word;) {
    const bool fits = used + 1 + word.size() <= width;
    if (used > 0) lines += fits ? ' ' : '\n';
    used = used > 0 && fits ? used + 1 + word.size() : word.size();
    lines += word;
  }
  return lines;
}

/// CLI11's help on a screen of 80 columns, without notes on how options exclude each other.
class Formatter : public CLI::Formatter {
 public:
  Formatter() {
    column_width(kDescriptions);
    label("Positionals", "Arguments");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(option->get_description(), kScreen - kDescriptions);
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_positional()) return {};
    std::string text;
    if (!option->get_type_name().empty()) text += ' ' + option->get_type_name();
    if (option->get_required()) text += " REQUIRED";
    return text;
  }

  /// CLI11 writes an empty line after each group except the last, even if it does not list the
  /// group. Two empty lines are reduced to one.
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    if (const auto at = text.find("\n\n\n"); at != text.npos) text.erase(at, 1);
    return text;
  }

  /// In CLI11, make_groups() writes an empty line after each group except the last. Here, each
  /// group begins with an empty line.
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override {
    const bool is_last = group == kCommonGroup;
    if (group == kUnlistedGroup) return {};
    return CLI::Formatter::make_group(std::move(group), is_positional, std::move(options))
        .substr(is_last ? 1 : 0);
  }
};

}  // namespace

CommandApp::CommandApp(const Command& command)
    : app(std::string(command.summary), "plumb " + std::string(command.name)),
      body(command.make()) {
  app.footer("Example:\n  " + std::string(command.example));
  app.allow_windows_style_options(false);  // On Windows, /tmp/a.off is the name of a file, too.
  app.formatter(std::make_shared<Formatter>());
  app.get_help_ptr()->group("");  // A user who reads this page knows the option.
  body->declare(app);
  common.declare(app);
  app.get_option("--json")->description("JSON: docs/schema/" + std::string(command.schema) +
                                        ".schema.json");
}

std::string_view first_word(std::string_view name) { return name.substr(0, name.find(' ')); }

/// The options are read back from CLI11, so that help, manual and completion describe the options
/// that are parsed.
std::vector<OptionText> options_of(const CLI::App& app) {
  std::vector<OptionText> texts;
  for (const CLI::Option* option : app.get_options()) {
    OptionText text;
    text.is_argument = option->get_positional();
    text.name = option->get_name(text.is_argument, !text.is_argument);
    text.text = option->get_description();
    const std::string& group = option->get_group();
    text.is_common = group == kCommonGroup || group == kUnlistedGroup;
    const bool takes_value = !text.is_argument && option->get_expected_max() > 0;
    if (takes_value) text.value = option->get_type_name();
    if (text.value.find('|') != std::string::npos) {
      text.choices = CLI::detail::split(text.value, '|');
    }
    texts.push_back(std::move(text));
  }
  return texts;
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& words, const std::string& text) {
  return app.add_option(name, value, text)
      ->type_name(CLI::detail::join(words, "|"))
      ->check(CLI::IsMember(words).description(""));
}

std::unique_ptr<CommandBody> make_map_check();
std::unique_ptr<CommandBody> make_map_overlay();
std::unique_ptr<CommandBody> make_map_repair();
std::unique_ptr<CommandBody> make_map_dissolve();
std::unique_ptr<CommandBody> make_map_simplify();
std::unique_ptr<CommandBody> make_plane_union();
std::unique_ptr<CommandBody> make_plane_intersection();
std::unique_ptr<CommandBody> make_plane_difference();
std::unique_ptr<CommandBody> make_plane_symmetric_difference();
std::unique_ptr<CommandBody> make_plane_complement();
std::unique_ptr<CommandBody> make_plane_interior();
std::unique_ptr<CommandBody> make_plane_closure();
std::unique_ptr<CommandBody> make_plane_boundary();
std::unique_ptr<CommandBody> make_plane_regularize();
std::unique_ptr<CommandBody> make_plane_minkowski();
std::unique_ptr<CommandBody> make_plane_offset();
std::unique_ptr<CommandBody> make_plane_csg();
std::unique_ptr<CommandBody> make_plane_triangulate();
std::unique_ptr<CommandBody> make_plane_voronoi();
std::unique_ptr<CommandBody> make_plane_arrange();
std::unique_ptr<CommandBody> make_plane_simplify();
std::unique_ptr<CommandBody> make_plane_info();
std::unique_ptr<CommandBody> make_plane_locate();
std::unique_ptr<CommandBody> make_plane_distance();
std::unique_ptr<CommandBody> make_solid_union();
std::unique_ptr<CommandBody> make_solid_intersection();
std::unique_ptr<CommandBody> make_solid_difference();
std::unique_ptr<CommandBody> make_solid_symmetric_difference();
std::unique_ptr<CommandBody> make_solid_eval();
std::unique_ptr<CommandBody> make_solid_complement();
std::unique_ptr<CommandBody> make_solid_interior();
std::unique_ptr<CommandBody> make_solid_closure();
std::unique_ptr<CommandBody> make_solid_boundary();
std::unique_ptr<CommandBody> make_solid_regularize();
std::unique_ptr<CommandBody> make_solid_section();
std::unique_ptr<CommandBody> make_solid_halfspaces();
std::unique_ptr<CommandBody> make_solid_csg();
std::unique_ptr<CommandBody> make_solid_info();
std::unique_ptr<CommandBody> make_solid_locate();
std::unique_ptr<CommandBody> make_solid_distance();
std::unique_ptr<CommandBody> make_solid_compare();
std::unique_ptr<CommandBody> make_solid_repair();
std::unique_ptr<CommandBody> make_solid_make();
std::unique_ptr<CommandBody> make_solid_hull();
std::unique_ptr<CommandBody> make_solid_offset();
std::unique_ptr<CommandBody> make_solid_transform();
std::unique_ptr<CommandBody> make_solid_extrude();
std::unique_ptr<CommandBody> make_solid_revolve();
std::unique_ptr<CommandBody> make_solid_slice();
std::unique_ptr<CommandBody> make_solid_project();
std::unique_ptr<CommandBody> make_solid_components();
std::unique_ptr<CommandBody> make_convex_check();
std::unique_ptr<CommandBody> make_convex_decompose();
std::unique_ptr<CommandBody> make_convex_report();
std::unique_ptr<CommandBody> make_convex_minkowski();
std::unique_ptr<CommandBody> make_surface_cells();
std::unique_ptr<CommandBody> make_surface_boolean();
std::unique_ptr<CommandBody> make_surface_draw();
std::unique_ptr<CommandBody> make_surface_path();
std::unique_ptr<CommandBody> make_view();
std::unique_ptr<CommandBody> make_audit();
std::unique_ptr<CommandBody> make_demo();
std::unique_ptr<CommandBody> make_completion();
std::unique_ptr<CommandBody> make_manual();
std::unique_ptr<CommandBody> make_self_test();

std::span<const Command> commands() {  // NOLINT(readability-function-size): a table
  static constexpr std::array kCommands{
      Command{"map check", "FILE", "Lists all defects of a map, or the DCEL of a valid map",
              "./plumb map check corpus/maps/us-counties.map --svg out.svg", "map-check",
              make_map_check},
      Command{"map overlay", "A B", "Overlays two maps or layers, and lists pairs of regions",
              "./plumb map overlay corpus/maps/us-states.clean.map "
              "corpus/maps/us-counties.clean.map -o out.svg",
              "map-overlay", make_map_overlay},
      Command{"map repair", "LAYER", "Removes overlaps and gaps of a layer, and reports them",
              "./plumb map repair corpus/layers/fields.geojson -o out.geojson", "map-repair",
              make_map_repair},
      Command{"map dissolve", "LAYER", "Unites features with the same value of a property",
              "./plumb map dissolve corpus/layers/districts.geojson --by state --sum people -o "
              "out.geojson",
              "map-dissolve", make_map_dissolve},
      Command{"map simplify", "LAYER", "Removes corners of borders, and keeps all features",
              "./plumb map simplify corpus/layers/districts.geojson --percent 50 -o out.geojson",
              "map-simplify", make_map_simplify},
      Command{"plane union", "A B...", "Computes the points in any of the sets",
              "./plumb plane union corpus/plane/star.wkt corpus/plane/frame.geojson -o out.wkt",
              "plane-set", make_plane_union},
      Command{
          "plane intersection", "A B...", "Computes the points in all sets",
          "./plumb plane intersection corpus/plane/star.wkt corpus/plane/quadrant.nef2 -o out.nef2",
          "plane-set", make_plane_intersection},
      Command{"plane difference", "A B", "Computes the points in A that are not in B",
              "./plumb plane difference corpus/plane/frame.geojson corpus/plane/star.wkt -o "
              "out.geojson",
              "plane-set", make_plane_difference},
      Command{"plane symmetric-difference", "A B", "Computes the points in exactly one of the sets",
              "./plumb plane symmetric-difference corpus/plane/star.wkt corpus/plane/frame.geojson",
              "plane-set", make_plane_symmetric_difference},
      Command{"plane complement", "A", "Computes the points that are not in A",
              "./plumb plane complement corpus/plane/frame.geojson -o out.nef2", "plane-set",
              make_plane_complement},
      Command{"plane interior", "A", "Computes A without its boundary",
              "./plumb plane interior corpus/plane/star.wkt -o out.nef2", "plane-set",
              make_plane_interior},
      Command{"plane closure", "A", "Computes A with its boundary",
              "./plumb plane closure corpus/plane/quadrant.nef2 -o out.nef2", "plane-set",
              make_plane_closure},
      Command{"plane boundary", "A", "Computes the boundary of A",
              "./plumb plane boundary corpus/plane/star.wkt", "plane-set", make_plane_boundary},
      Command{"plane regularize", "A", "Computes the closure of the interior of A",
              "./plumb plane regularize corpus/plane/frame.geojson", "plane-set",
              make_plane_regularize},
      Command{"plane minkowski", "A B...", "Computes the Minkowski sum of the sets",
              "./plumb plane minkowski corpus/plane/star.wkt corpus/plane/frame.geojson -o out.wkt",
              "plane-set", make_plane_minkowski},
      Command{"plane offset", "A", "Grows or shrinks A by a distance",
              "./plumb plane offset corpus/plane/star.wkt --by 0.5 -o out.svg", "plane-set",
              make_plane_offset},
      Command{"plane simplify", "A", "Removes corners of A, and keeps its topology",
              "./plumb plane simplify corpus/plane/star.wkt --percent 50 -o out.svg", "plane-set",
              make_plane_simplify},
      Command{"plane csg", "MODEL", "Evaluates a flat model of OpenSCAD (.csg)",
              "./plumb plane csg corpus/csg/gasket.csg -o out.svg", "plane-set", make_plane_csg},
      Command{"plane triangulate", "A", "Divides A into constrained Delaunay triangles",
              "./plumb plane triangulate corpus/plane/star.wkt -o out.off", "plane-triangulate",
              make_plane_triangulate},
      Command{"plane voronoi", "A", "Computes Voronoi cells of the vertices of A",
              "./plumb plane voronoi corpus/plane/star.wkt -o out.geojson", "plane-voronoi",
              make_plane_voronoi},
      Command{"plane arrange", "A...", "Computes the faces that all edges bound",
              "./plumb plane arrange corpus/plane/star.wkt corpus/plane/frame.geojson -o "
              "out.geojson",
              "plane-arrange", make_plane_arrange},
      Command{"plane info", "A", "Prints counts, exact area and properties of A",
              "./plumb plane info corpus/plane/star.wkt --json", "plane-set", make_plane_info},
      Command{"plane locate", "A X Y", "Finds the cell that contains a point",
              "./plumb plane locate corpus/plane/quadrant.nef2 0 -1/3", "locate",
              make_plane_locate},
      Command{"plane distance", "A B", "Computes the distance, and the nearest points",
              "./plumb plane distance corpus/plane/star.wkt corpus/plane/frame.geojson", "distance",
              make_plane_distance},
      Command{
          "solid union", "A B...", "Computes the points in any of the solids",
          "./plumb solid union corpus/solids/l-block.off corpus/solids/tetrahedron.obj -o out.off",
          "solid-set", make_solid_union},
      Command{"solid intersection", "A B...", "Computes the points in all solids",
              "./plumb solid intersection corpus/solids/l-block.off corpus/solids/tetrahedron.obj "
              "-o out.nef",
              "solid-set", make_solid_intersection},
      Command{"solid difference", "A B", "Computes the points in A that are not in B",
              "./plumb solid difference corpus/solids/l-block.off corpus/solids/tetrahedron.obj -o "
              "out.nef",
              "solid-set", make_solid_difference},
      Command{"solid symmetric-difference", "A B", "Computes the points in exactly one solid",
              "./plumb solid symmetric-difference corpus/solids/l-block.off "
              "corpus/solids/tetrahedron.obj -o out.nef",
              "solid-set", make_solid_symmetric_difference},
      Command{"solid eval", "EXPR NAME=FILE...", "Evaluates an expression: + * - ^ ! ( )",
              "./plumb solid eval 'A - B * !C' A=corpus/solids/l-block.off "
              "B=corpus/solids/tetrahedron.obj C=corpus/solids/l-block.off -o out.nef",
              "solid-set", make_solid_eval},
      Command{"solid complement", "A", "Computes the points that are not in A",
              "./plumb solid complement corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_complement},
      Command{"solid interior", "A", "Computes A without its boundary",
              "./plumb solid interior corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_interior},
      Command{"solid closure", "A", "Computes A with its boundary",
              "./plumb solid closure corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_closure},
      Command{"solid boundary", "A", "Computes the boundary of A",
              "./plumb solid boundary corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_boundary},
      Command{"solid regularize", "A", "Computes the closure of the interior of A",
              "./plumb solid regularize corpus/solids/l-block.off -o out.off", "solid-set",
              make_solid_regularize},
      Command{"solid section", "A", "Computes A on a plane, or on one side of it",
              "./plumb solid section corpus/solids/l-block.off --plane 1,0,0,-1/2 --side closed -o "
              "out.off",
              "solid-set", make_solid_section},
      Command{"solid halfspaces", "FILE", "Computes the intersection of half-spaces",
              "./plumb solid halfspaces corpus/solids/octahedron.txt -o out.off", "solid-set",
              make_solid_halfspaces},
      Command{"solid csg", "MODEL", "Evaluates a model of OpenSCAD (.csg)",
              "./plumb solid csg corpus/csg/bracket.csg --explain -o out.off", "solid-set",
              make_solid_csg},
      Command{"solid info", "A", "Prints counts, volume and properties of A",
              "./plumb solid info corpus/solids/l-block.off --json", "solid-set", make_solid_info},
      Command{"solid locate", "A X Y Z", "Finds the cell that contains a point",
              "./plumb solid locate corpus/solids/l-block.off 1/2 1/2 1/2", "locate",
              make_solid_locate},
      Command{"solid distance", "A B", "Computes the distance, and the nearest points",
              "./plumb solid distance corpus/solids/l-block.off corpus/solids/ball.off", "distance",
              make_solid_distance},
      Command{"solid compare", "A B", "Tests if A and B are equal, nested or disjoint",
              "./plumb solid compare corpus/solids/l-block.off corpus/solids/l-block.off",
              "solid-compare", make_solid_compare},
      Command{"solid repair", "FILE", "Repairs a mesh: flips, welds, fills holes",
              "./plumb solid repair corpus/solids/flipped-box.off -o out.off", "solid-repair",
              make_solid_repair},
      Command{"solid make", "SHAPE", "Makes a box, sphere, cylinder, cone or torus",
              "./plumb solid make sphere --radius 2 --segments 24 -o out.off", "solid-set",
              make_solid_make},
      Command{
          "solid hull", "A...", "Computes the convex hull of solids",
          "./plumb solid hull corpus/solids/l-block.off corpus/solids/tetrahedron.obj -o out.off",
          "solid-set", make_solid_hull},
      Command{"solid offset", "A", "Grows or shrinks A by a distance",
              "./plumb solid offset corpus/solids/l-block.off --by 1/4 --rounds 1 -o out.off",
              "solid-set", make_solid_offset},
      Command{"solid transform", "A", "Rotates, moves, scales or mirrors A",
              "./plumb solid transform corpus/solids/l-block.off --rotate 0,0,1,30 -o out.off",
              "solid-set", make_solid_transform},
      Command{"solid extrude", "A", "Extrudes a set of the plane along z",
              "./plumb solid extrude corpus/plane/star.wkt --height 2 -o out.off", "solid-set",
              make_solid_extrude},
      Command{"solid revolve", "A", "Revolves a set of the plane around its y-axis",
              "./plumb solid revolve corpus/plane/ring-section.wkt -o out.off", "solid-set",
              make_solid_revolve},
      Command{"solid slice", "A", "Slices A at one height, or at several heights",
              "./plumb solid slice corpus/solids/l-block.off --z 1/2 -o out.svg", "solid-slice",
              make_solid_slice},
      Command{"solid project", "A", "Computes the shadow of A along z",
              "./plumb solid project corpus/solids/l-block.off -o out.wkt", "plane-set",
              make_solid_project},
      Command{"solid components", "A", "Lists connected parts: volume, genus, box",
              "./plumb solid components corpus/solids/l-block.off", "solid-components",
              make_solid_components},
      Command{"convex check", "A", "Tests if A is convex: reflex edges, failing faces",
              "./plumb convex check corpus/solids/ball.off", "convex-check", make_convex_check},
      Command{"convex decompose", "A", "Divides A into convex pieces; -o DIR: a file each",
              "./plumb convex decompose corpus/solids/l-block.off --json", "convex-decompose",
              make_convex_decompose},
      Command{"convex report", "FILE...", "Tests and decomposes solids, one line for each check",
              "./plumb convex report corpus/polyhedra/test_zero.off corpus/polyhedra/test_one.off",
              "convex-report", make_convex_report},
      Command{
          "convex minkowski", "A B...", "Computes the Minkowski sum of the sets",
          "./plumb convex minkowski corpus/solids/l-block.off corpus/solids/ball.off -o sum.off",
          "solid-set", make_convex_minkowski},
      Command{"surface cells", "SCENE", "Lists the cells of polygons on a mesh",
              "./plumb surface cells corpus/scenes/torus.json --json", "surface-cells",
              make_surface_cells},
      Command{"surface boolean", "SCENE --op EXPR", "Selects cells by an expression",
              "./plumb surface boolean corpus/scenes/torus.json --op 'A + B * !C' -o out.obj",
              "surface-boolean", make_surface_boolean},
      Command{"surface draw", "SCENE --what WHAT", "Draws a scene as .png, .svg, .html or .glb",
              "./plumb surface draw corpus/scenes/torus.json --what labels -o out.html",
              "surface-draw", make_surface_draw},
      Command{"surface path", "SCENE", "Finds a shortest path between two points",
              "./plumb surface path corpus/scenes/room.json --json", "surface-path",
              make_surface_path},
      Command{"view", "FILE...", "Draws maps, sets and solids: .png, .svg, .html, .glb",
              "./plumb view corpus/solids/square-hole.off -o out.html", "view", make_view},
      Command{"audit", "FILE", "Checks every invariant of the structure in FILE",
              "./plumb audit corpus/plane/quadrant.nef2", "audit", make_audit},
      Command{"demo", "", "Shows examples with times and pictures: index.html",
              "./plumb demo -o plumb-demo", "demo", make_demo},
      Command{"completion bash", "", "Prints completion: source <(plumb completion bash)",
              "./plumb completion bash", "completion", make_completion},
      Command{"manual", "", "Prints the manual page: plumb manual | man -l -", "./plumb manual",
              "manual", make_manual},
      Command{"self-test", "", "Checks the floating-point environment of the predicates",
              "./plumb self-test", "self-test", make_self_test},
  };
  return kCommands;
}

std::span<const CommandGroup> command_groups() {
  static constexpr std::array kGroups{
      CommandGroup{"map", "Commands for maps: check, overlay, repair, dissolve, ..."},
      CommandGroup{"plane", "Commands for sets of the plane: union, offset, info, ..."},
      CommandGroup{"solid", "Commands for sets of space: union, make, slice, info, ..."},
      CommandGroup{"convex", "Commands for convex pieces: check, decompose, minkowski, ..."},
      CommandGroup{"surface", "Commands for polygons on meshes: cells, boolean, draw, path"},
  };
  return kGroups;
}

}  // namespace plumb::cli
