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
std::unique_ptr<CommandBody> make_audit();
std::unique_ptr<CommandBody> make_demo();
std::unique_ptr<CommandBody> make_self_test();

std::span<const Command> commands() {
  static constexpr std::array kCommands{
      Command{"map check", "FILE",
              "Are listed regions a planar subdivision? All defects, or the DCEL",
              "./plumb map check corpus/maps/us-counties.map --svg out.svg", make_map_check},
      Command{"map overlay", "A B", "The faces of two maps at once, each with its pair of regions",
              "./plumb map overlay corpus/maps/us-states.clean.map "
              "corpus/maps/us-counties.clean.map -o out.svg",
              make_map_overlay},
      Command{"plane union", "A B", "What lies in either set",
              "./plumb plane union corpus/plane/star.wkt corpus/plane/frame.geojson -o out.wkt",
              make_plane_union},
      Command{
          "plane intersection", "A B", "What lies in both sets",
          "./plumb plane intersection corpus/plane/star.wkt corpus/plane/quadrant.nef2 -o out.nef2",
          make_plane_intersection},
      Command{"plane difference", "A B", "What lies in A and not in B",
              "./plumb plane difference corpus/plane/frame.geojson corpus/plane/star.wkt -o "
              "out.geojson",
              make_plane_difference},
      Command{"plane symmetric-difference", "A B", "What lies in one of the sets only",
              "./plumb plane symmetric-difference corpus/plane/star.wkt corpus/plane/frame.geojson",
              make_plane_symmetric_difference},
      Command{"plane complement", "A", "What does not lie in A",
              "./plumb plane complement corpus/plane/frame.geojson -o out.nef2",
              make_plane_complement},
      Command{"plane interior", "A", "A without its boundary",
              "./plumb plane interior corpus/plane/star.wkt -o out.nef2", make_plane_interior},
      Command{"plane closure", "A", "A with its boundary",
              "./plumb plane closure corpus/plane/quadrant.nef2 -o out.nef2", make_plane_closure},
      Command{"plane boundary", "A", "The boundary of A",
              "./plumb plane boundary corpus/plane/star.wkt", make_plane_boundary},
      Command{"plane regularize", "A", "The closure of the interior of A",
              "./plumb plane regularize corpus/plane/frame.geojson", make_plane_regularize},
      Command{"plane info", "A", "Numbers of its elements, exact area; bounded? empty?",
              "./plumb plane info corpus/plane/star.wkt --json", make_plane_info},
      Command{"plane locate", "A X Y", "Is the point on a vertex, an edge, a face; in A?",
              "./plumb plane locate corpus/plane/quadrant.nef2 0 -1/3", make_plane_locate},
      Command{"audit", "FILE", "Does every invariant of the structure in FILE hold?",
              "./plumb audit corpus/plane/quadrant.nef2", make_audit},
      Command{"demo", "", "Real maps checked and overlaid, sets combined, pictured; index.html",
              "./plumb demo -o plumb-demo", make_demo},
      Command{"self-test", "", "Is the floating-point environment what the predicates need?",
              "./plumb self-test", make_self_test},
  };
  return kCommands;
}

std::span<const CommandGroup> command_groups() {
  static constexpr std::array kGroups{
      CommandGroup{"plane", "Sets of the plane, exactly: union ... regularize, info, locate"},
  };
  return kGroups;
}

}  // namespace plumb::cli
