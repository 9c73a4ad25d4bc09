// plumb convex decompose: convex pieces of a solid or of a set of the plane.

#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.h"
#include "format_choice.h"
#include "picture_files.h"
#include "piece_files.h"
#include "plumb/base/error.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/convex/volume_sum.h"
#include "plumb/io/file_kind.h"
#include "plumb/io/input.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid_text.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/sheet.h"
#include "progress_stages.h"
#include "solid_input.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr double kApart = 0.5;  // of their distances

struct PlaneChoice {
  std::string_view name;
  std::string_view extension;
  PlaneFormat format;
};
constexpr std::array kPlaneFormats{
    PlaneChoice{"wkt", ".wkt", PlaneFormat::Wkt},
    PlaneChoice{"geojson", ".geojson", PlaneFormat::GeoJson},
    PlaneChoice{"nef2", ".nef2", PlaneFormat::Nef2},
};

struct Answer {
  std::size_t pieces;
  std::uint64_t reflex;
  const char* reflex_name;
  std::optional<bool> matches;  ///< volumes or areas; none: infinite, or nobody asked
};

class Decomposition : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", file_, kSolidOrPlaneHelp)->required()->type_name("");
    app.add_option("--method", method_,
                   "cuts: along faces or sides at reflex edges; walls: vertical ones (solids); "
                   "diagonals, optimal: between vertices (plane); best: the fewest pieces")
        ->type_name("METHOD")
        ->check(CLI::IsMember({"cuts", "walls", "diagonals", "optimal", "best"}).description(""));
    app.add_flag("--closed", closed_, "Closures of the pieces");
    app.add_option("--svg", svg_,
                   "Draw the pieces, one colour each: of the plane those of dimension 2; of a "
                   "solid moved apart")
        ->type_name("OUT");
    input_.declare(app);
  }

  ExitCode run(Session& session) override {
    const std::string bytes = read_input(file_, session.context());
    PieceFiles files(session.options().out);
    const bool is_plane = kind_of_file(file_, bytes) == FileKind::PlaneSet;
    session.expect(stages(is_plane, session.options()));
    session.begin("read");
    const auto names = is_plane ? extensions(kPlaneFormats) : extensions(solid_formats());
    if (!svg_.empty()) files.open_picture(svg_, names);
    const Answer answer =
        is_plane ? decompose_plane(bytes, files, session) : decompose_solid(bytes, files, session);
    session.context().release_memory(bytes.size());
    files.note_losses(is_plane ? "nef2" : "nef", session);
    session.outputs().add("-", [&, is_json = session.options().json](std::ostream& out) {
      is_json ? write_json(out, answer) : write_text(out, answer);
    });
    session.deliver();
    files.commit(names, file_);
    return ExitCode::Yes;
  }

 private:
  ProgressStages stages(bool is_plane, const CommonOptions& common) const {
    ProgressStages stages{is_plane ? reading_plane() : reading_solid(), cutting_solid()};
    if (!common.out.empty()) stages.push_back(writing_pieces());
    if (!svg_.empty()) stages.push_back(drawing_pieces());
    stages.push_back(writing());
    return stages;
  }
  static void write_json(std::ostream& out, const Answer& answer) {
    Json matches = nullptr;
    if (answer.matches) matches = *answer.matches;
    out << Json{{"pieces", answer.pieces},
                {"reflex_edges", answer.reflex},
                {"volume_matches", matches}}
               .dump()
        << '\n';
  }
  static void write_text(std::ostream& out, const Answer& answer) {
    out << counted(answer.pieces, "convex piece") << ", "
        << counted(answer.reflex, answer.reflex_name) << '\n';
  }
  template <class Table>
  static std::vector<std::string_view> extensions(const Table& formats) {
    std::vector<std::string_view> all;
    all.reserve(std::size(formats));
    for (const auto& format : formats) all.push_back(format.extension);
    return all;
  }
  std::string title() const { return std::filesystem::path(input_name(file_)).filename().string(); }
  Error cannot(const std::string& what) const {
    return {ErrorCode::Usage, "--method " + method_ + " is for " + what};
  }

  // ---------------------------------------------------------------- solids

  Answer decompose_solid(const std::string& bytes, PieceFiles& files, Session& session) {
    if (method_ == "diagonals" || method_ == "optimal") throw cannot("sets of the plane");
    const DecomposeMethod method = method_ == "cuts"    ? DecomposeMethod::Cuts
                                   : method_ == "walls" ? DecomposeMethod::Walls
                                                        : DecomposeMethod::Best;
    Context& context = session.context();
    const Nef3 set = input_.read(file_, bytes, session);
    if (!svg_.empty() && !set.is_bounded()) {
      throw Error(ErrorCode::BadArgument, "--svg draws the pieces of bounded solids only",
                  {.file = input_name(file_)});
    }
    session.begin("cut");
    const ConvexPieces found = decompose(set, {method, closed_}, context);
    std::size_t done = 0;
    session.begin("pieces");
    for (const Nef3& piece : found.pieces) {
      if (!files.is_wanted()) break;
      context.checkpoint("pieces", done++, found.pieces.size());
      const SolidFormat& format = solid_format(piece, session.options().format);
      const SolidText text(piece, format, context);
      files.add(format.extension, text.losses(),
                [&](std::ostream& out) { text.write(out, context); });
    }
    if (!svg_.empty()) {
      session.begin("draw");
      files.finish_picture(picture_of(found.pieces, kApart, Picture::Svg, title(), context));
    }
    Answer answer{found.pieces.size(), found.reflex_edges, "reflex edge", {}};
    if (session.options().json) answer.matches = do_volumes_add_up(set, found.pieces, context);
    return answer;
  }
  /// In the format asked for; else OFF, and .nef for what no mesh can hold.
  static const SolidFormat& solid_format(const Nef3& piece, const std::string& asked) {
    if (!asked.empty()) return format_named(solid_formats(), asked);
    const bool is_mesh = piece.is_bounded() && piece.counts().marked_volumes > 0;
    return format_named(solid_formats(), is_mesh ? "off" : "nef");
  }

  // ---------------------------------------------------------------- the plane

  Answer decompose_plane(const std::string& bytes, PieceFiles& files, Session& session) {
    if (method_ == "walls") throw cannot("solids");
    const PartitionMethod method = method_ == "cuts"        ? PartitionMethod::Cuts
                                   : method_ == "diagonals" ? PartitionMethod::Diagonals
                                   : method_ == "optimal"   ? PartitionMethod::Optimal
                                                            : PartitionMethod::Best;
    Context& context = session.context();
    const Nef2 set = input_.read_plane(file_, bytes, session);
    session.begin("cut");
    const PlanePieces found = decompose(set, {method, closed_}, context);
    std::size_t done = 0;
    session.begin("pieces");
    for (const Nef2& piece : found.pieces) {
      if (!files.is_wanted()) break;
      context.checkpoint("pieces", done++, found.pieces.size());
      const PlaneChoice& format = plane_format(piece, session.options().format);
      const PlaneText text(piece, format.format, context);
      files.add(format.extension, text.losses().sentences(),
                [&](std::ostream& out) { text.write(out, context); });
    }
    if (!svg_.empty()) {
      session.begin("draw");
      std::ostringstream out;
      write_nef2_svg(out, set, {.title = title(), .pieces = found.pieces, .context = &context});
      files.finish_picture(std::move(out).str());
    }
    Answer answer{found.pieces.size(), found.reflex_corners, "reflex corner", {}};
    if (session.options().json) answer.matches = do_areas_add_up(set, found.pieces, context);
    return answer;
  }
  /// In the format asked for; else WKT, and .nef2 for what has no end.
  static const PlaneChoice& plane_format(const Nef2& piece, const std::string& asked) {
    if (!asked.empty()) return format_named(kPlaneFormats, asked);
    return format_named(kPlaneFormats, piece.is_bounded() ? "wkt" : "nef2");
  }

  std::string file_;
  std::string method_ = "best";
  bool closed_ = false;
  std::string svg_;
  SolidInput input_;
};

}  // namespace

std::unique_ptr<CommandBody> make_convex_decompose() { return std::make_unique<Decomposition>(); }

}  // namespace plumb::cli
