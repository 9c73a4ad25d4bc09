// The commands `plumb convex check` and `plumb convex report`: whether sets are convex.
//
// The check reads a solid or a set of the plane and prints the answer with its evidence: reflex
// edges or corners, and the faces that fail. If a mesh is the surface of one solid, its own faces
// are tested. Otherwise the set that it describes is tested. In both cases, the failing faces are
// faces of the mesh. The report runs the check and a decomposition over a list of files and prints
// one line for each condition.
// Tested by tests/cli/convex_command_test.cpp.

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/cli/files/certificate.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/plane_convexity.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/text_output.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;

// ---------------------------------------------------------------- check

class ConvexCheck : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", file_, kSolidOrPlaneHelp)->required()->type_name("");
    input_.declare(app);
    certificate_.declare(app);
  }

  ExitCode run(Session& session) override {
    certificate_.open(session);
    const std::string bytes = read_input(file_, session.context());
    const bool is_plane = kind_of_file(file_, bytes) == FileKind::PlaneSet;
    session.expect({is_plane ? reading_plane() : reading_solid(), checking_convexity(), writing()});
    session.begin("read");
    if (is_plane) return check_plane(bytes, session);
    const ConvexityEvidence found = evidence(bytes, session);
    certify(found.is_convex, bytes, session);
    Json faces = Json::array();
    for (const FailingFace& failing : found.faces) faces.push_back(failing.face);
    const Json json{
        {"convex", found.is_convex}, {"reflex_edges", found.reflex_edges}, {"faces", faces}};
    session.answer(json.dump(), [&found](std::ostream& out) {
      out << (found.is_convex ? "convex\n" : "not convex\n");
      if (found.is_convex) return;
      out << counted(found.reflex_edges, "reflex edge") << '\n';
      for (const FailingFace& failing : found.faces) {
        out << "face " << failing.face << ": vertex " << failing.vertex << " lies outside\n";
      }
    });
    return found.is_convex ? ExitCode::Yes : ExitCode::No;
  }

 private:
  ExitCode check_plane(const std::string& bytes, Session& session) {
    const Nef2 set = input_.read_plane(file_, bytes, session);
    certificate_.explain("sets of the plane have no certificate");
    session.begin("convexity");
    const PlaneConvexity found = convexity_of_set(set, session.context());
    Json faces = Json::array();
    Json corners = Json::array();
    for (const FailingRegion& failing : found.faces) {
      faces.push_back(failing.face.value());
      corners.push_back({format_exact(failing.corner.x), format_exact(failing.corner.y)});
    }
    const Json json{{"convex", found.is_convex},
                    {"reflex_edges", found.reflex_corners},
                    {"faces", faces},
                    {"corners", corners}};
    session.answer(json.dump(), [&found](std::ostream& out) {
      out << (found.is_convex ? "convex\n" : "not convex\n");
      if (found.is_convex) return;
      out << counted(found.reflex_corners, "reflex corner") << ", "
          << counted(found.parts, "connected part") << '\n';
      for (const FailingRegion& failing : found.faces) {
        out << "face " << failing.face.value() << ": reflex corner at "
            << readable(failing.corner.x) << ' ' << readable(failing.corner.y) << '\n';
      }
    });
    return found.is_convex ? ExitCode::Yes : ExitCode::No;
  }

  /// If a mesh is the surface of one solid, returns the evidence found at its own faces. Otherwise,
  /// returns the evidence for the set that the mesh describes. In both cases, the failing faces are
  /// faces of the mesh.
  ConvexityEvidence evidence(const std::string& bytes, Session& session) const {
    Context& context = session.context();
    require_solid(file_, bytes);
    if (is_nef_file(file_, bytes)) {
      const Nef3 set = input_.read(file_, bytes, session);
      session.begin("convexity");
      return convexity_of_set(set, context);
    }
    ReadOptions options;
    options.name = input_name(file_);
    options.exact_decimals = session.options().exact_decimals;
    const MeshFile mesh_file = read_mesh_of(file_, bytes, options, context);
    if (!lack_of_faces(mesh_file).empty()) {
      return convexity_of_set(input_.read(file_, bytes, session), context);
    }
    session.begin("convexity");
    ConvexityEvidence of_mesh = convexity_of_mesh(mesh_file.mesh, context);
    const bool is_solid = of_mesh.is_convex || of_mesh.reflex_edges > 0;
    if (input_.is_plain() && is_solid) {
      print_notes(file_, mesh_file, session);
      return of_mesh;
    }
    ConvexityEvidence of_set = convexity_of_set(input_.read(file_, bytes, session), context);
    if (!of_set.is_convex) of_set.faces = std::move(of_mesh.faces);
    return of_set;
  }

  /// The set is made again for the certificate, because the check may have tested the faces of a
  /// mesh without making a set.
  void certify(bool is_convex, const std::string& bytes, Session& session) {
    if (!certificate_.is_given()) return;
    if (is_convex) {
      certificate_.explain("the set is convex");
      return;
    }
    const SolidRead read = input_.load(file_, bytes, session.options(), session.context());
    certify_not_convex(read.set, input_, session, certificate_);
  }

  std::string file_;
  SolidInput input_;
  CertificateOption certificate_;
};

// ---------------------------------------------------------------- report

/// Runs the checks on test polyhedra, one line each.
class NoteReport : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("FILE", files_, "Solids; test_one.off is called TestOne")
        ->required()
        ->type_name("");
    input_.declare(app);
  }

  ExitCode run(Session& session) override {
    session.expect(stages());
    for (const std::string& file : files_) test(file, session);
    const Json json{{"checks", lines_},
                    {"total", success_ + failed_},
                    {"success", success_},
                    {"failed", failed_}};
    session.answer(json.dump(), [this](std::ostream& out) {
      for (const std::string& line : lines_) out << line << '\n';
      out << "Total Tests done: " << success_ + failed_ << ", Number Success Tests: " << success_
          << ", Number Error Tests: " << failed_ << '\n';
    });
    return are_pieces_convex_ ? ExitCode::Yes : ExitCode::No;
  }

 private:
  ProgressStages stages() const {
    ProgressStages stages;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      stages.insert(stages.end(), {reading_solid(), cutting_solid()});
    }
    stages.push_back(writing());
    return stages;
  }

  void test(const std::string& file, Session& session) {
    const std::string name = title(file);
    session.begin("read");
    const Nef3 set = input_.read(file, session);
    session.begin("cut");
    if (check(name + ": IsPolyhedronConvex", set.closure(session.context()).is_convex())) return;
    const ConvexPieces pieces = decompose(set, {DecomposeMethod::Cuts, true}, session.context());
    check(name + ": ConcaveToConvexPolyhedron", true);
    for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
      const std::string number = std::to_string(i + 1);
      are_pieces_convex_ &=
          check(name + ": IsPolyhedronConvex " + number, pieces.pieces[i].is_convex());
    }
  }

  bool check(const std::string& what, bool is_success) {
    ++(is_success ? success_ : failed_);
    lines_.push_back(std::to_string(success_ + failed_) + " - " + what +
                     (is_success ? " SUCCESS" : " FAILED"));
    return is_success;
  }

  /// Returns the title of a file: TestOne for dir/test_one.off.
  static std::string title(const std::string& file) {
    std::string name;
    bool is_start = true;
    for (const char c : std::filesystem::path(file).stem().string()) {
      const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      if (is_letter || (c >= '0' && c <= '9')) {
        name += is_start && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        is_start = false;
      } else {
        is_start = true;
      }
    }
    return name;
  }

  std::vector<std::string> files_;
  SolidInput input_;
  std::vector<std::string> lines_;
  std::uint64_t success_ = 0, failed_ = 0;
  bool are_pieces_convex_ = true;
};

}  // namespace

std::unique_ptr<CommandBody> make_convex_check() { return std::make_unique<ConvexCheck>(); }
std::unique_ptr<CommandBody> make_convex_report() { return std::make_unique<NoteReport>(); }

}  // namespace plumb::cli
