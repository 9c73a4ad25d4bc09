#include <array>

#include "command.h"

namespace plumb::cli {

std::unique_ptr<CommandBody> make_map_check();
std::unique_ptr<CommandBody> make_map_overlay();
std::unique_ptr<CommandBody> make_plane_union();
std::unique_ptr<CommandBody> make_plane_intersection();
std::unique_ptr<CommandBody> make_plane_difference();
std::unique_ptr<CommandBody> make_plane_symmetric_difference();
std::unique_ptr<CommandBody> make_plane_complement();
std::unique_ptr<CommandBody> make_plane_interior();
std::unique_ptr<CommandBody> make_plane_closure();
std::unique_ptr<CommandBody> make_plane_boundary();
std::unique_ptr<CommandBody> make_plane_regularize();
std::unique_ptr<CommandBody> make_plane_info();
std::unique_ptr<CommandBody> make_plane_locate();
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
std::unique_ptr<CommandBody> make_solid_info();
std::unique_ptr<CommandBody> make_solid_locate();
std::unique_ptr<CommandBody> make_solid_compare();
std::unique_ptr<CommandBody> make_convex_check();
std::unique_ptr<CommandBody> make_convex_decompose();
std::unique_ptr<CommandBody> make_convex_report();
std::unique_ptr<CommandBody> make_convex_minkowski();
std::unique_ptr<CommandBody> make_surface_cells();
std::unique_ptr<CommandBody> make_surface_boolean();
std::unique_ptr<CommandBody> make_surface_draw();
std::unique_ptr<CommandBody> make_view();
std::unique_ptr<CommandBody> make_audit();
std::unique_ptr<CommandBody> make_demo();
std::unique_ptr<CommandBody> make_completion();
std::unique_ptr<CommandBody> make_manual();
std::unique_ptr<CommandBody> make_self_test();

std::span<const Command> commands() {  // NOLINT(readability-function-size): a table
  static constexpr std::array kCommands{
      Command{"map check", "FILE", "A planar subdivision? All defects, or the DCEL",
              "./plumb map check corpus/maps/us-counties.map --svg out.svg", "map-check",
              make_map_check},
      Command{"map overlay", "A B", "The faces of two maps at once, each with its pair",
              "./plumb map overlay corpus/maps/us-states.clean.map "
              "corpus/maps/us-counties.clean.map -o out.svg",
              "map-overlay", make_map_overlay},
      Command{"plane union", "A B", "What lies in either set",
              "./plumb plane union corpus/plane/star.wkt corpus/plane/frame.geojson -o out.wkt",
              "plane-set", make_plane_union},
      Command{
          "plane intersection", "A B", "What lies in both sets",
          "./plumb plane intersection corpus/plane/star.wkt corpus/plane/quadrant.nef2 -o out.nef2",
          "plane-set", make_plane_intersection},
      Command{"plane difference", "A B", "What lies in A and not in B",
              "./plumb plane difference corpus/plane/frame.geojson corpus/plane/star.wkt -o "
              "out.geojson",
              "plane-set", make_plane_difference},
      Command{"plane symmetric-difference", "A B", "What lies in one of the sets only",
              "./plumb plane symmetric-difference corpus/plane/star.wkt corpus/plane/frame.geojson",
              "plane-set", make_plane_symmetric_difference},
      Command{"plane complement", "A", "What does not lie in A",
              "./plumb plane complement corpus/plane/frame.geojson -o out.nef2", "plane-set",
              make_plane_complement},
      Command{"plane interior", "A", "A without its boundary",
              "./plumb plane interior corpus/plane/star.wkt -o out.nef2", "plane-set",
              make_plane_interior},
      Command{"plane closure", "A", "A with its boundary",
              "./plumb plane closure corpus/plane/quadrant.nef2 -o out.nef2", "plane-set",
              make_plane_closure},
      Command{"plane boundary", "A", "The boundary of A",
              "./plumb plane boundary corpus/plane/star.wkt", "plane-set", make_plane_boundary},
      Command{"plane regularize", "A", "The closure of the interior of A",
              "./plumb plane regularize corpus/plane/frame.geojson", "plane-set",
              make_plane_regularize},
      Command{"plane info", "A", "Counts, exact area; bounded? empty?",
              "./plumb plane info corpus/plane/star.wkt --json", "plane-set", make_plane_info},
      Command{"plane locate", "A X Y", "Where does the point lie; is it in A?",
              "./plumb plane locate corpus/plane/quadrant.nef2 0 -1/3", "locate",
              make_plane_locate},
      Command{
          "solid union", "A B", "What lies in either solid",
          "./plumb solid union corpus/solids/l-block.off corpus/solids/tetrahedron.obj -o out.off",
          "solid-set", make_solid_union},
      Command{"solid intersection", "A B", "What lies in both solids",
              "./plumb solid intersection corpus/solids/l-block.off corpus/solids/tetrahedron.obj "
              "-o out.nef",
              "solid-set", make_solid_intersection},
      Command{"solid difference", "A B", "What lies in A and not in B",
              "./plumb solid difference corpus/solids/l-block.off corpus/solids/tetrahedron.obj -o "
              "out.nef",
              "solid-set", make_solid_difference},
      Command{"solid symmetric-difference", "A B", "What lies in one of the solids only",
              "./plumb solid symmetric-difference corpus/solids/l-block.off "
              "corpus/solids/tetrahedron.obj -o out.nef",
              "solid-set", make_solid_symmetric_difference},
      Command{"solid eval", "EXPR NAME=FILE...", "An expression over solids: + * - ^ ! ( )",
              "./plumb solid eval 'A - B * !C' A=corpus/solids/l-block.off "
              "B=corpus/solids/tetrahedron.obj C=corpus/solids/l-block.off -o out.nef",
              "solid-set", make_solid_eval},
      Command{"solid complement", "A", "What does not lie in A",
              "./plumb solid complement corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_complement},
      Command{"solid interior", "A", "A without its boundary",
              "./plumb solid interior corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_interior},
      Command{"solid closure", "A", "A with its boundary",
              "./plumb solid closure corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_closure},
      Command{"solid boundary", "A", "The boundary of A",
              "./plumb solid boundary corpus/solids/l-block.off -o out.nef", "solid-set",
              make_solid_boundary},
      Command{"solid regularize", "A", "The closure of the interior of A",
              "./plumb solid regularize corpus/solids/l-block.off -o out.off", "solid-set",
              make_solid_regularize},
      Command{"solid section", "A", "What lies of A on a plane, or on one side",
              "./plumb solid section corpus/solids/l-block.off --plane 1,0,0,-1/2 --side closed -o "
              "out.off",
              "solid-set", make_solid_section},
      Command{"solid halfspaces", "FILE", "The intersection of half-spaces",
              "./plumb solid halfspaces corpus/solids/octahedron.txt -o out.off", "solid-set",
              make_solid_halfspaces},
      Command{"solid info", "A", "Counts, exact volume; bounded? simple?",
              "./plumb solid info corpus/solids/l-block.off --json", "solid-set", make_solid_info},
      Command{"solid locate", "A X Y Z", "Where does the point lie; is it in A?",
              "./plumb solid locate corpus/solids/l-block.off 1/2 1/2 1/2", "locate",
              make_solid_locate},
      Command{"solid compare", "A B", "Equal? One in the other? Disjoint?",
              "./plumb solid compare corpus/solids/l-block.off corpus/solids/l-block.off",
              "solid-compare", make_solid_compare},
      Command{"convex check", "A", "Convex? Reflex edges or corners, faces that fail",
              "./plumb convex check corpus/solids/ball.off", "convex-check", make_convex_check},
      Command{"convex decompose", "A", "Convex pieces of any set; -o DIR: a file each",
              "./plumb convex decompose corpus/solids/l-block.off --json", "convex-decompose",
              make_convex_decompose},
      Command{"convex report", "FILE...", "Solids tested, cut and tested again, one line a check",
              "./plumb convex report corpus/polyhedra/test_zero.off corpus/polyhedra/test_one.off",
              "convex-report", make_convex_report},
      Command{
          "convex minkowski", "A B", "Minkowski sum: all sums of points of A and B",
          "./plumb convex minkowski corpus/solids/l-block.off corpus/solids/ball.off -o sum.off",
          "solid-set", make_convex_minkowski},
      Command{"surface cells", "SCENE", "Cells of polygons on a mesh, with labels",
              "./plumb surface cells corpus/scenes/torus.json --json", "surface-cells",
              make_surface_cells},
      Command{"surface boolean", "SCENE --op EXPR", "What an expression selects: area, borders",
              "./plumb surface boolean corpus/scenes/torus.json --op 'A + B * !C' -o out.obj",
              "surface-boolean", make_surface_boolean},
      Command{"surface draw", "SCENE --what WHAT", "A picture: .png, .svg, .html, .glb",
              "./plumb surface draw corpus/scenes/torus.json --what labels -o out.html",
              "surface-draw", make_surface_draw},
      Command{"view", "FILE...", "A picture of maps, sets, solids: .png, .svg, .html, .glb",
              "./plumb view corpus/solids/square-hole.off -o out.html", "view", make_view},
      Command{"audit", "FILE", "Does every invariant of the structure in FILE hold?",
              "./plumb audit corpus/plane/quadrant.nef2", "audit", make_audit},
      Command{"demo", "", "One example of each, with times and pictures: index.html",
              "./plumb demo -o plumb-demo", "demo", make_demo},
      Command{"completion bash", "", "For .bashrc: source <(plumb completion bash)",
              "./plumb completion bash", "completion", make_completion},
      Command{"manual", "", "The manual page: plumb manual | man -l -", "./plumb manual", "manual",
              make_manual},
      Command{"self-test", "", "Is the floating-point environment what the predicates need?",
              "./plumb self-test", "self-test", make_self_test},
  };
  return kCommands;
}

std::span<const CommandGroup> command_groups() {
  static constexpr std::array kGroups{
      CommandGroup{"map", "Maps, exactly: check regions for defects, overlay two maps"},
      CommandGroup{"plane", "Sets of the plane, exactly: union ... info, locate"},
      CommandGroup{"solid", "Sets of space, exactly: union ... section, info, compare"},
      CommandGroup{"convex", "Convexity, convex pieces: check, decompose, report, minkowski"},
      CommandGroup{"surface", "Polygons on meshes, exactly: cells, boolean, draw"},
  };
  return kGroups;
}

}  // namespace plumb::cli
