#include <nlohmann/json.hpp>
#include <string>

#include "command.h"
#include "plumb/predicates/environment.h"

namespace plumb::cli {
namespace {

void print(std::ostream& stream, const SelfTestReport& report) {
  if (report.ok) stream << "ok: the predicates' requirements hold in this build\n";
  for (const std::string& line : report.failures) stream << "failure: " << line << '\n';
  for (const std::string& line : report.notes) stream << "note: " << line << '\n';
}

class SelfTest : public CommandBody {
 public:
  void declare(CLI::App&) override {}

  ExitCode run(Session& session) override {
    const SelfTestReport report = self_test();
    const nlohmann::ordered_json json{
        {"ok", report.ok}, {"failures", report.failures}, {"notes", report.notes}};
    session.answer(json.dump(), [&](std::ostream& out) { print(out, report); });
    return report.ok ? ExitCode::Yes : ExitCode::No;
  }
};

}  // namespace

std::unique_ptr<CommandBody> make_self_test() { return std::make_unique<SelfTest>(); }

}  // namespace plumb::cli
