// The command `plumb convex decompose`: convex pieces of a solid or of a set of the plane, as
// numbered files of one folder: DIR/piece_0001.off, piece_0002.off, ...
//
// PieceFiles writes each piece under a temporary name and closes it at once, because a set may have
// more pieces than a process may have open files. All become visible together when the last one is
// complete; pieces of an earlier run with higher numbers are then removed, but never the input.
// What files leave out is reported once, for the file that leaves out most.
// Tested by tests/cli/convex_command_test.cpp.

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/internal/message_text.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/cli/session/session.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/convex/sum/volume_sum.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"

namespace plumb::cli {

class PieceFiles {
 public:
  /// Creates the folder. If its name is empty, no pieces are written. Throws Error{Usage} and
  /// Error{CannotWrite}.
  explicit PieceFiles(std::string directory);

  bool is_wanted() const { return !directory_.empty(); }
  /// Writes the next piece and closes its file at once, because a set may have more pieces than a
  /// process may have open files. `losses` states what the file cannot represent.
  void add(std::string_view extension, const std::vector<std::string>& losses,
           const std::function<void(std::ostream&)>& write);
  /// Returns the name of the material library of the next piece.
  std::string next_library() const;
  /// Writes the material library of the last piece.
  void add_library(const std::function<void(std::ostream&)>& write);
  /// Opens a picture of the pieces, which becomes visible with them. Throws Error{Usage} if it has
  /// the name of a piece in one of the extensions, and Error{CannotWrite}.
  void open_picture(const std::string& path, const std::vector<std::string_view>& extensions);
  /// Writes the picture. Requires open_picture().
  void finish_picture(std::string_view bytes);
  /// Notes how many of the files lose information, what the file that loses most cannot represent,
  /// and which format can.
  void note_losses(std::string_view better, Session& session) const;
  /// Makes the files visible. If an earlier run wrote more pieces, the surplus files with one of
  /// the extensions are removed. The input is never removed.
  void commit(const std::vector<std::string_view>& extensions, const std::string& input);

 private:
  std::string directory_;
  std::optional<OutputDirectory> made_;  // Outlives the files in it.
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::vector<std::unique_ptr<OutputFile>> libraries_;
  std::unique_ptr<OutputFile> picture_;
  std::size_t changed_ = 0;
  std::string worst_;  // Name of a file.
  std::vector<std::string> worst_losses_;
};

namespace {

constexpr std::string_view kStem = "piece_";
constexpr std::string_view kLibraryExtension = ".mtl";

std::string file_name(std::size_t piece, std::string_view extension) {
  std::string number = std::to_string(piece);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return std::string(kStem) + number + std::string(extension);
}

/// Returns the number in a file's name; 0 if no piece with one of the extensions has that name.
std::size_t piece_number(const std::string& name, const std::vector<std::string_view>& extensions) {
  std::size_t number = 0;
  const auto [end, failed] = std::from_chars(name.data() + std::min(kStem.size(), name.size()),
                                             name.data() + name.size(), number);
  const auto is_name = [&](std::string_view extension) {
    return name == file_name(number, extension);
  };
  return failed == std::errc() && std::ranges::any_of(extensions, is_name) ? number : 0;
}

}  // namespace

PieceFiles::PieceFiles(std::string directory) : directory_(std::move(directory)) {
  if (directory_.empty()) return;
  if (directory_ == "-") throw Error(ErrorCode::Usage, "-o needs a directory");
  made_.emplace(path_of(directory_));
}

void PieceFiles::add(std::string_view extension, const std::vector<std::string>& losses,
                     const std::function<void(std::ostream&)>& write) {
  const std::string name = file_name(files_.size() + 1, extension);
  if (!losses.empty()) ++changed_;
  if (losses.size() > worst_losses_.size()) {
    worst_ = name;
    worst_losses_ = losses;
  }
  const auto path = path_of(directory_) / name;
  files_.push_back(std::make_unique<OutputFile>(file_name_of(path)));
  write(files_.back()->stream());
  files_.back()->finish();
}

std::string PieceFiles::next_library() const {
  return file_name(files_.size() + 1, kLibraryExtension);
}

void PieceFiles::add_library(const std::function<void(std::ostream&)>& write) {
  const auto path = path_of(directory_) / file_name(files_.size(), kLibraryExtension);
  libraries_.push_back(std::make_unique<OutputFile>(file_name_of(path)));
  write(libraries_.back()->stream());
  libraries_.back()->finish();
}

void PieceFiles::open_picture(const std::string& path,
                              const std::vector<std::string_view>& extensions) {
  namespace fs = std::filesystem;
  if (path == "-") throw Error(ErrorCode::Usage, "--svg needs a file");
  if (is_wanted()) {
    std::error_code ignored;  // A path that is not valid cannot be opened either.
    const fs::path picture = fs::weakly_canonical(path_of(path), ignored);
    const bool is_beside = fs::equivalent(picture.parent_path(), path_of(directory_), ignored);
    if (is_beside && piece_number(picture.filename().string(), extensions) > 0) {
      throw Error(ErrorCode::Usage, "--svg has the name of a piece", {.file = path});
    }
  }
  picture_ = std::make_unique<OutputFile>(path);
}

void PieceFiles::finish_picture(std::string_view bytes) {
  picture_->stream() << bytes;
  picture_->finish();
}

void PieceFiles::note_losses(std::string_view better, Session& session) const {
  if (changed_ == 0) return;
  session.note(directory_ + ": warning: " + std::to_string(changed_) + " of " +
               counted(files_.size(), "file") + " do not say all (--format " + std::string(better) +
               " does); of " + worst_ + ": " + worst_losses_.back());
}

void PieceFiles::commit(const std::vector<std::string_view>& extensions, const std::string& input) {
  const std::size_t pieces = files_.size();
  std::move(libraries_.begin(), libraries_.end(), std::back_inserter(files_));
  if (picture_) files_.push_back(std::move(picture_));
  commit_all(files_);
  if (!is_wanted()) return;
  made_->keep();
  std::error_code failed;
  std::filesystem::directory_iterator at(path_of(directory_), failed);
  for (; !failed && at != std::filesystem::directory_iterator(); at.increment(failed)) {
    std::error_code ignored;
    if (piece_number(at->path().filename().string(), extensions) <= pieces) continue;
    if (!at->is_regular_file(ignored)) continue;
    // Neither the input nor a material library beside it.
    auto beside = at->path();
    beside.replace_extension(path_of(input).extension());
    if (std::filesystem::equivalent(beside, path_of(input), ignored)) continue;
    std::filesystem::remove(at->path(), ignored);
  }
}

// Implements the command.

namespace {

using Json = nlohmann::ordered_json;
// The distance of moved pieces, as a part of the distances between the pieces.
constexpr double kPiecesApart = 0.5;

struct PlaneChoice {
  std::string_view name;
  std::string_view extension;
  PlaneFormat format;
};
constexpr std::array kPlaneFormats{
    PlaneChoice{"wkt", ".wkt", PlaneFormat::Wkt},
    PlaneChoice{"geojson", ".geojson", PlaneFormat::GeoJson},
    PlaneChoice{"wkb", ".wkb", PlaneFormat::Wkb},
    PlaneChoice{"nef2", ".nef2", PlaneFormat::Nef2},
};

struct Answer {
  std::size_t pieces;
  std::uint64_t reflex;
  const char* reflex_name;
  /// Whether volumes or areas add up; no value if they are infinite or were not asked for.
  std::optional<bool> matches;
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
    app.add_flag("--closed", closed_, "Write the closures of the pieces");
    app.add_option("--svg", svg_,
                   "Draw the pieces, one colour each: of the plane those of dimension 2; of a "
                   "solid moved apart")
        ->type_name("OUT");
    input_.declare(app);
    input_.declare_keep(app);
  }

  ExitCode run(Session& session) override {
    const std::string bytes = read_input(file_, session.context());
    PieceFiles files(session.options().out);
    const bool is_plane = kind_of_file(file_, bytes) == FileKind::PlaneSet;
    session.expect(stages(is_plane, session.options()));
    session.begin("read");
    auto names = is_plane ? extensions(kPlaneFormats) : extensions(solid_formats());
    if (!is_plane) names.push_back(kLibraryExtension);
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
  std::string title() const { return file_name_of(path_of(input_name(file_)).filename()); }
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
    std::string dropped;         // A sentence on attributes that the format does not hold.
    bool has_bare_cuts = false;  // Whether faces on cuts stand beside faces with attributes.
    session.begin("pieces");
    for (const Nef3& piece : found.pieces) {
      if (!files.is_wanted()) break;
      context.checkpoint("pieces", done++, found.pieces.size());
      const SolidFormat& format = solid_format(piece, session.options().format);
      const SolidText text(piece, format, OutputRounding::Valid, context, files.next_library());
      files.add(format.extension, text.losses(),
                [&](std::ostream& out) { text.write(out, context); });
      if (text.has_library()) {
        files.add_library([&](std::ostream& out) { text.write_library(out); });
      }
      if (dropped.empty()) dropped = text.dropped();
      has_bare_cuts = has_bare_cuts || (text.has_attributes() && has_wall(piece));
    }
    if (!dropped.empty()) session.note(session.options().out + ": " + dropped);
    if (has_bare_cuts) session.note(session.options().out + ": faces on cuts have no attributes");
    if (!svg_.empty()) {
      session.begin("draw");
      // Without sources, so that each piece has a colour of its own.
      std::vector<Nef3> shown;
      for (const Nef3& piece : found.pieces) shown.push_back(piece.with_sources({}));
      files.finish_picture(
          picture_of(shown, kPiecesApart, picture(PictureFormat::Svg, title()), context));
    }
    Answer answer{found.pieces.size(), found.reflex_edges, "reflex edge", {}};
    if (session.options().json) answer.matches = do_volumes_add_up(set, found.pieces, context);
    return answer;
  }
  static bool has_wall(const Nef3& piece) {
    const SpaceComplex& complex = piece.complex();
    for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
      if (is_wall(complex, FacetId(f))) return true;
    }
    return false;
  }
  /// Returns the requested format. If none was requested, returns OFF, or .nef if a mesh cannot
  /// represent the pieces.
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
    session.begin("pieces");
    if (files.is_wanted()) write_pieces(found.pieces, files, session);
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
  /// Writes the files of the pieces. If the format has doubles, all pieces are rounded together, so
  /// that pieces with a common border still have it after rounding.
  static void write_pieces(const std::vector<Nef2>& pieces, PieceFiles& files, Session& session) {
    Context& context = session.context();
    const std::string& asked = session.options().format;
    const RoundedPieces rounded =
        asked == "nef2" ? RoundedPieces{} : round_to_doubles(pieces, context);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      context.checkpoint("pieces", i, pieces.size());
      const PlaneChoice& format = plane_format(pieces[i], asked);
      const bool is_exact = format.format == PlaneFormat::Nef2;
      const PlaneText text(is_exact ? pieces[i] : rounded.pieces[i], format.format, context);
      files.add(format.extension, text.losses().sentences(),
                [&](std::ostream& out) { text.write(out, context); });
    }
    note_rounding(rounded, session);
  }
  static void note_rounding(const RoundedPieces& rounded, Session& session) {
    const std::string& folder = session.options().out;
    const std::string sentence = rounding_sentence(rounded.rounding, {});
    if (!sentence.empty()) session.note(folder + ": warning: " + sentence + " (.nef2 is exact)");
    if (rounded.not_convex == 0) return;
    session.note(
        folder + ": warning: " + counted(rounded.not_convex, "piece") +
        (rounded.not_convex == 1 ? " is" : " are") +
        " not quite convex, as a side is bent to a rounded corner of a neighbour; no point "
        "moved by more than " +
        format_double(rounded.rounding.largest_move) + " (.nef2 is exact)");
  }
  /// Returns the requested format. If none was requested, returns WKT, or .nef2 if a piece is
  /// unbounded.
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
