#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "plumb/predicates/environment.h"

namespace plumb::cli {
namespace {

class SelfTest : public CommandBody {
 public:
  void declare(CLI::App&) override {}

  ExitCode run(Session& session) override {
    const std::string problem = self_test();
    const bool is_fine = problem.empty();
    const std::string out = session.options().out.empty() ? "-" : session.options().out;
    session.outputs().add(out, [&](std::ostream& stream) {
      if (session.options().json) {
        stream << nlohmann::ordered_json{{"ok", is_fine}, {"problem", problem}}.dump() << '\n';
      } else {
        stream << (is_fine ? "ok: the predicates' requirements hold in this build" : problem)
               << '\n';
      }
    });
    session.outputs().deliver();
    return is_fine ? ExitCode::Yes : ExitCode::No;
  }
};

}  // namespace

std::unique_ptr<CommandBody> make_self_test() { return std::make_unique<SelfTest>(); }

}  // namespace plumb::cli
