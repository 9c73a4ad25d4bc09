#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "plumb/cli/files/operands.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/map_io.h"
#include "plumb/io/map_report_io.h"
#include "plumb/io/nef3_reader.h"
#include "plumb/io/plane/nef2_format.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/text/files.h"
#include "plumb/plane/complex/plane_records.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/predicates/error.h"
#include "plumb/space/space_audit.h"

namespace plumb::cli {
namespace {

using Flaw = std::optional<DcelFlaw>;

Flaw audit_nef3(const std::string& text, const ReadOptions& options, Context& context) {
  const auto flaw = audit(read_nef3(text, options, context), AuditForm::Minimal, context);
  if (!flaw) return std::nullopt;
  return DcelFlaw{flaw->invariant, flaw->place};
}

/// Audits a mesh as the set it describes.
Flaw audit_mesh(const Nef3& set, Context& context) {
  const auto flaw = audit(set.complex(), AuditForm::Minimal, context);
  if (!flaw) return std::nullopt;
  return DcelFlaw{flaw->invariant, flaw->place};
}

/// Audits the records as they are in the file, not what a reader would accept.
Flaw audit_nef2(const std::string& text, const ReadOptions& options, Context& context) {
  const PlaneRecords records = read_nef2_records(text, options, context);
  try {
    return audit(from_records(records, context), AuditForm::Minimal, context);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::BadArgument) throw;
    return DcelFlaw{error.message(), ""};
  }
}

Flaw audit_map(const std::string& text, const ReadOptions& options, Session& session) {
  session.expect({reading_map(), checking_map(), auditing_map(), writing()});
  session.begin("read");
  Map map = read_map(text, options, session.context());
  session.begin("check");
  const MapReport report = check_map(std::move(map), {}, session.context());
  if (report.verdict != MapVerdict::Valid) {
    return DcelFlaw{std::string(headline(report.verdict)), report.defects.front().hint};
  }
  session.begin("audit");
  const Dcel dcel = to_dcel(report).dcel;
  Flaw flaw = dcel.audit();
  return flaw ? flaw : dcel.audit_planar();
}

Flaw audit_text(const std::string& path, const std::string& text, const SolidInput& solids,
                const ReadOptions& options, Session& session) {
  const FileKind kind = kind_of_file(path, text);
  if (kind != FileKind::Solid) solids.require_plain();
  if (kind == FileKind::Map) return audit_map(text, options, session);
  session.expect({kind == FileKind::Solid ? auditing_solid() : auditing_plane(), writing()});
  session.begin("audit");
  Context& context = session.context();
  if (kind == FileKind::Solid) {
    if (is_nef_file(path, text)) return audit_nef3(text, options, context);
    return audit_mesh(solids.load(path, text, session.options(), context).set, context);
  }
  const PlaneFormat format = plane_format_of(path, text);
  if (format == PlaneFormat::Nef2) return audit_nef2(text, options, context);
  return audit(read_plane_set(text, format, options, context).set.complex(), AuditForm::Minimal,
               context);
}

void write_flaw(std::ostream& out, const Flaw& flaw) {
  if (!flaw) {
    out << "ok: every invariant holds\n";
    return;
  }
  out << "broken: " << flaw->invariant << (flaw->place.empty() ? "" : ": ") << flaw->place << '\n';
}

nlohmann::ordered_json flaw_json(const Flaw& flaw) {
  if (!flaw) return {{"ok", true}, {"broken", nullptr}, {"place", nullptr}};
  return {{"ok", false}, {"broken", flaw->invariant}, {"place", flaw->place}};
}

class Audit : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("FILE", file_, "A set (.nef, .nef2, .off, .wkt ...) or a .map; - is stdin")
        ->required()
        ->type_name("");
    solids_.declare(app);
  }

  ExitCode run(Session& session) override {
    const ReadOptions options{input_name(file_), session.options().exact_decimals};
    const std::string text = read_input(file_, session.context());
    return answer(audit_text(file_, text, solids_, options, session), session);
  }

 private:
  static ExitCode answer(const Flaw& flaw, Session& session) {
    session.answer(flaw_json(flaw).dump(), [&](std::ostream& out) { write_flaw(out, flaw); });
    return flaw ? ExitCode::No : ExitCode::Yes;
  }

  std::string file_;
  SolidInput solids_;
};

}  // namespace

std::unique_ptr<CommandBody> make_audit() { return std::make_unique<Audit>(); }

}  // namespace plumb::cli
