#include <array>

#include "command.h"

namespace plumb::cli {

std::unique_ptr<CommandBody> make_map_check();
std::unique_ptr<CommandBody> make_demo();
std::unique_ptr<CommandBody> make_self_test();

std::span<const Command> commands() {
  static constexpr std::array kCommands{
      Command{"map check", "FILE",
              "Are listed regions a planar subdivision? All defects, or the DCEL",
              "./plumb map check corpus/maps/us-counties.map --svg out.svg", make_map_check},
      Command{"demo", "", "Check a real map, picture its defects, build a DCEL; index.html",
              "./plumb demo -o plumb-demo", make_demo},
      Command{"self-test", "", "Is the floating-point environment what the predicates need?",
              "./plumb self-test", make_self_test},
  };
  return kCommands;
}

}  // namespace plumb::cli
