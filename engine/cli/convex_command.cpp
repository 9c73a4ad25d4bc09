// plumb convex ...: is a set convex? Convex pieces of it; the run of the course notes.

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "format_choice.h"
#include "plumb/base/error.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/volume_sum.h"
#include "plumb/io/input.h"
#include "plumb/io/output_file.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/solid_sets.h"
#include "plumb/io/solid_text.h"
#include "plumb/picture/sheet.h"
#include "solid_input.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* kHelp =
    "A solid: .off, .obj, .stl, .ply, .glb, .gltf, .nef; - is standard input";

// ---------------------------------------------------------------- check

class ConvexCheck : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", file_, kHelp)->required()->type_name("");
    input_.declare(app);
  }

  ExitCode run(Session& session) override {
    const ConvexityEvidence found = evidence(session);
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
  /// Of a mesh by its own faces, if it is the surface of one solid; else of the set it describes.
  ConvexityEvidence evidence(Session& session) const {
    const std::string bytes = read_input(file_, session.context());
    if (!input_.is_plain() || is_nef_file(file_, bytes)) return evidence_of_set(bytes, session);
    ReadOptions options;
    options.name = input_name(file_);
    options.exact_decimals = session.options().exact_decimals;
    const PolygonMesh mesh = read_mesh_of(file_, bytes, options, session.context()).mesh;
    ConvexityEvidence found = convexity_of_mesh(mesh, session.context());
    if (found.is_convex || found.reflex_edges > 0) return found;
    return evidence_of_set(bytes, session);
  }

  ConvexityEvidence evidence_of_set(const std::string& bytes, Session& session) const {
    const Nef3 set = input_.read(file_, bytes, session);
    ConvexityEvidence found = convexity_of_set(set, session.context());
    if (is_nef_file(file_, bytes)) return found;
    for (FailingFace& failing : found.faces) {
      failing.face = set.complex().facet_origin[failing.face];
    }
    std::ranges::stable_sort(found.faces, {}, &FailingFace::face);
    const auto is_same = [](const FailingFace& f, const FailingFace& g) {
      return f.face == g.face;
    };
    found.faces.erase(std::unique(found.faces.begin(), found.faces.end(), is_same),
                      found.faces.end());
    return found;
  }

  std::string file_;
  SolidInput input_;
};

// ---------------------------------------------------------------- decompose

class Decomposition : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", file_, kHelp)->required()->type_name("");
    app.add_option("--method", method_,
                   "cuts: planes through reflex edges; walls: vertical ones; best: the fewer "
                   "pieces, merged")
        ->type_name("METHOD")
        ->check(CLI::IsMember({"cuts", "walls", "best"}).description(""));
    app.add_flag("--closed", closed_, "Closures of the pieces");
    input_.declare(app);
  }

  ExitCode run(Session& session) override {
    const Nef3 set = input_.read(file_, session);
    const DecomposeMethod method = method_ == "cuts"    ? DecomposeMethod::Cuts
                                   : method_ == "walls" ? DecomposeMethod::Walls
                                                        : DecomposeMethod::Best;
    const ConvexPieces pieces = decompose(set, {method, closed_}, session.context());
    write_files(pieces, session);
    const bool is_json = session.options().json;
    const std::string json = is_json ? json_of(set, pieces, session.context()).dump() : "";
    session.outputs().add("-", [&pieces, is_json, json](std::ostream& out) {
      if (is_json) {
        out << json << '\n';
        return;
      }
      out << counted(pieces.pieces.size(), "convex piece") << ", "
          << counted(pieces.reflex_edges, "reflex edge") << '\n';
    });
    session.outputs().deliver();
    commit_all(files_);
    remove_older(session.options().out);
    return ExitCode::Yes;
  }

 private:
  static Json json_of(const Nef3& set, const ConvexPieces& pieces, Context& context) {
    Json matches = nullptr;  // of unbounded sets
    if (const std::optional<bool> known = do_volumes_add_up(set, pieces.pieces, context)) {
      matches = *known;
    }
    return {{"pieces", pieces.pieces.size()},
            {"reflex_edges", pieces.reflex_edges},
            {"volume_matches", matches}};
  }

  /// In the format asked for; else OFF, and .nef for what no mesh can hold. One after the other: a set may have more
  /// pieces than files may be open.
  void write_files(const ConvexPieces& pieces, Session& session) {
    const std::string& directory = session.options().out;
    if (directory.empty()) return;
    if (directory == "-") throw Error(ErrorCode::Usage, "-o needs a directory");
    make_directory(directory);
    std::size_t changed = 0;
    std::vector<std::string> worst;  // a file's name and what it does not say
    for (const Nef3& piece : pieces.pieces) {
      const SolidFormat& format = format_of(piece, session.options().format);
      const SolidText text(piece, format, session.context());
      const std::string name = file_name(files_.size() + 1, format);
      const auto path = std::filesystem::path(directory) / name;
      if (!text.losses().empty()) ++changed;
      if (text.losses().size() + 1 > std::max<std::size_t>(worst.size(), 1)) {
        worst = text.losses();
        worst.insert(worst.begin(), name);
      }
      files_.push_back(std::make_unique<OutputFile>(path.string()));
      text.write(files_.back()->stream());
      files_.back()->finish();
    }
    if (changed == 0) return;
    session.note(directory + ": warning: " + std::to_string(changed) + " of " +
                 counted(pieces.pieces.size(), "file") +
                 " do not say all (--format nef does); of " + worst.front() + ": " + worst.back());
  }
  static std::string file_name(std::size_t piece, const SolidFormat& format) {
    std::string number = std::to_string(piece);
    if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
    return "piece_" + number + std::string(format.extension);
  }
  /// What an earlier run left that made more pieces; never the file just read.
  void remove_older(const std::string& directory) const {
    if (directory.empty()) return;
    std::error_code failed;
    std::filesystem::directory_iterator at(directory, failed);
    for (; !failed && at != std::filesystem::directory_iterator(); at.increment(failed)) {
      std::error_code ignored;
      if (!is_older(at->path().filename().string()) || !at->is_regular_file(ignored)) continue;
      if (std::filesystem::equivalent(at->path(), file_, ignored)) continue;
      std::filesystem::remove(at->path(), ignored);
    }
  }
  bool is_older(const std::string& name) const {
    constexpr std::size_t kNumberAt = 6;  // piece_
    std::size_t number = 0;
    const auto [end, failed] = std::from_chars(name.data() + std::min(kNumberAt, name.size()),
                                               name.data() + name.size(), number);
    if (failed != std::errc() || number <= files_.size()) return false;
    return std::ranges::any_of(solid_formats(), [&](const SolidFormat& format) {
      return name == file_name(number, format);
    });
  }
  static const SolidFormat& format_of(const Nef3& piece, const std::string& asked) {
    if (!asked.empty()) return format_named(solid_formats(), asked);
    const bool is_mesh = piece.is_bounded() && piece.counts().marked_volumes > 0;
    return format_named(solid_formats(), is_mesh ? "off" : "nef");
  }
  static void make_directory(const std::string& directory) {
    std::error_code failed;
    std::filesystem::create_directories(directory, failed);
    if (failed) throw Error(ErrorCode::CannotWrite, directory + ": " + failed.message());
  }

  std::string file_;
  std::string method_ = "best";
  bool closed_ = false;
  std::vector<std::unique_ptr<OutputFile>> files_;
  SolidInput input_;
};

// ---------------------------------------------------------------- report

/// The checks of the notes, one line each.
class NoteReport : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("FILE", files_, "Solids; test_one.off is called TestOne")
        ->required()
        ->type_name("");
    input_.declare(app);
  }

  ExitCode run(Session& session) override {
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
  void test(const std::string& file, Session& session) {
    const std::string name = title(file);
    const Nef3 set = input_.read(file, session);
    if (check(name + ": IsPolyhedronConvex", set.closure().is_convex())) return;
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

  /// dir/test_one.off: TestOne.
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
std::unique_ptr<CommandBody> make_convex_decompose() { return std::make_unique<Decomposition>(); }
std::unique_ptr<CommandBody> make_convex_report() { return std::make_unique<NoteReport>(); }

}  // namespace plumb::cli
