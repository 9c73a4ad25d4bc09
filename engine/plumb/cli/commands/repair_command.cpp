// The command `plumb solid repair FILE`: a mesh mended as a mesh, without making a set of it.
//
// Without options, the command takes all steps that do not change the set of a correct mesh. Equal
// points become one point. Faces with fewer than three corners are dropped, and doubled faces are
// dropped if this helps. Faces and components with the wrong orientation are flipped. With options,
// the command takes exactly the steps that they ask for. The report goes to standard output, or to
// standard error if the mesh is written there. The mesh is written even if it is still open; only
// .nef needs a set.
// Tested by tests/cli/repair_command_test.cpp.

#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/io/mesh/attribute_writer.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/space/repair_mesh.h"

namespace plumb::cli {
namespace {

/// Repairs one mesh.
class SolidRepair : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("FILE", file_,
                   "A mesh: .off, .obj, .stl, .ply, .glb, .gltf, .3mf, .amf; - is standard input")
        ->required()
        ->type_name("");
    flags_.declare(app);
    input_.declare_keep(app);
  }

  ExitCode run(Session& session) override {
    open(session);
    session.expect({mending_mesh(), writing()});
    session.begin("mend");
    read(session);
    report_ = repair_mesh(mesh_, attributes_, asked(), session.context());
    if (!report_.is_closed()) {
      SolidReadOptions reading;
      reading.repair = flags_.options();
      remedy_ = remedy_for(mesh_, reading, session.context());
    }
    prepare(session);
    if (is_on_stdout_) {
      std::istringstream lines(text());
      for (std::string line; std::getline(lines, line);) {
        session.note(input_name(file_) + ": " + line);
      }
    }
    session.deliver();
    if (!dropped_.empty()) session.note(out_name_ + ": " + dropped_);
    return report_.is_closed() ? ExitCode::Yes : ExitCode::No;
  }

 private:
  /// Opens the outputs before the work.
  void open(Session& session) {
    const CommonOptions& common = session.options();
    if (common.out == "-" && common.format.empty()) {
      throw Error(ErrorCode::Usage, "-o - needs --format " + names_of(solid_formats()));
    }
    if (!common.format.empty()) {
      format_ = &format_named(solid_formats(), common.format);
    } else if (!common.out.empty()) {
      format_ = &format_of_file(solid_formats(), common.out);
    }
    out_name_ = common.out.empty() ? "-" : common.out;
    is_on_stdout_ = format_ != nullptr && (common.out.empty() || common.out == "-");
    if (format_ != nullptr) {
      session.outputs().add(is_on_stdout_ ? "-" : common.out,
                            [this, &session](std::ostream& out) { write(out, session.context()); });
    }
    if (common.json) {
      session.outputs().add("-", [this](std::ostream& out) { out << json().dump() << '\n'; });
    } else if (!is_on_stdout_) {
      session.outputs().add("-", [this](std::ostream& out) { out << text(); });
    }
  }

  void read(Session& session) {
    const std::string bytes = read_input(file_, session.context());
    require_solid(file_, bytes);
    if (is_nef_file(file_, bytes)) {
      throw Error(ErrorCode::UnknownFormat, "a .nef file has a set, where a mesh is needed",
                  {input_name(file_)});
    }
    ReadOptions options{input_name(file_), session.options().exact_decimals};
    options.attributes = input_.kept() != KeptAttributes::None;
    MeshFile file = read_mesh_of(file_, bytes, options, session.context());
    print_notes(file_, file, session);
    mesh_ = std::move(file.mesh);
    attributes_ = std::move(file.attributes);
    keep_only(input_.kept(), attributes_);
    session.context().release_memory(bytes.size());
  }

  /// Returns the repairs that the options request. If the options request none, returns the repairs
  /// that are always safe.
  RepairOptions asked() const {
    const RepairOptions options = flags_.options();
    if (options.asks()) return options;
    return {.weld = 0,
            .doubled = DoubledFaces::DropIfBetter,
            .reorient = true,
            .fill_holes = 0,
            .fill_holes_below = 0};
  }

  /// Takes all steps that can fail before any output is written: triangulates faces for formats of
  /// triangles, and makes the set for .nef.
  void prepare(Session& session) {
    if (format_ == nullptr) return;
    dropped_ = lost_attributes(attributes_, format_->mesh.value_or(MeshFormat::Stl));
    if (!format_->mesh) {
      set_.emplace(Nef3::from_mesh(mesh_, {}, session.context()), *format_, OutputRounding::Valid,
                   session.context());
      return;
    }
    if (lists_triangles(*format_->mesh)) {
      mesh_ = triangulated(mesh_, attributes_, session.context());
    }
    keep_used_materials(attributes_);
    if (format_->mesh == MeshFormat::Obj && !attributes_.materials.empty() && !is_on_stdout_) {
      library_ = material_library_of(session.options().out);
    }
    if (library_.empty()) return;
    const auto path = path_of(session.options().out).replace_extension(".mtl");
    session.outputs().add(file_name_of(path),
                          [this](std::ostream& out) { write_material_library(out, attributes_); });
  }

  void write(std::ostream& out, Context& context) const {
    if (set_) {
      set_->write(out, context);
    } else {
      write_mesh(out, mesh_, attributes_, *format_->mesh, library_);
    }
  }

  std::string text() const {
    std::string lines = counted(mesh_.points.size(), "vertex", "vertices") + ", " +
                        counted(mesh_.face_count(), "face") + ", ";
    if (report_.is_closed()) {
      lines += "closed\n";
    } else {
      lines += "open: " + counted(report_.holes.size(), "border") + ", the longest of " +
               counted(longest_hole(), "edge") + '\n';
    }
    for (const std::string& sentence : sentences(report_)) lines += sentence + '\n';
    if (!report_.one_sided.empty()) {
      lines += "a component has one side only, as a Moebius strip; its first face: " +
               std::to_string(report_.one_sided.front()) + '\n';
    }
    if (!report_.has_changed()) lines += "nothing was mended\n";
    if (remedy_) lines += words_of(*remedy_) + " closes it\n";
    return lines;
  }

  std::size_t longest_hole() const {
    std::size_t most = 0;
    for (const auto& hole : report_.holes) most = std::max(most, hole.size());
    return most;
  }

  nlohmann::ordered_json json() const {
    return {{"closed", report_.is_closed()}, {"vertices", mesh_.points.size()},
            {"faces", mesh_.face_count()},   {"equal", report_.equal},
            {"welded", report_.welded},      {"farthest", report_.farthest},
            {"trimmed", report_.trimmed},    {"degenerate", report_.degenerate},
            {"doubled", report_.doubled},    {"flipped", report_.flipped},
            {"turned", report_.turned},      {"filled", report_.filled},
            {"added", report_.added},        {"holes", report_.holes},
            {"one_sided", report_.one_sided}};
  }

  std::string file_;
  RepairFlags flags_;
  SolidInput input_;                     // It declares the option --keep.
  const SolidFormat* format_ = nullptr;  // Null if only the report is requested.
  bool is_on_stdout_ = false;            // Whether the mesh is written to standard output.
  std::string out_name_;
  PolygonMesh mesh_;
  MeshAttributes attributes_;
  std::string library_;  // The material library beside an OBJ file, or empty.
  std::string dropped_;  // A sentence on attributes that the file does not hold, or empty.
  RepairReport report_;
  std::optional<RepairOptions> remedy_;  // The repairs that close the mesh, if it is still open.
  std::optional<SolidText> set_;         // The text of the set, if the format is .nef.
};

}  // namespace

std::unique_ptr<CommandBody> make_solid_repair() { return std::make_unique<SolidRepair>(); }

}  // namespace plumb::cli
