// The command `plumb view FILE...`: a picture of whatever the file holds, or of several solids.
//
// The extension of a file determines its kind. If the extension is unknown, the first bytes do
// (files/operands.h). The extension of the output determines the format of the picture. Outputs are
// opened before the work, so that a path that cannot be written costs nothing.
// Tested by tests/cli/view_command_test.cpp.

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/cli/session/command.h"
#include "plumb/cli/session/progress.h"
#include "plumb/io/map_io.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text/file_names.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/picture/space_scene.h"
#include "plumb/picture/texture_image.h"
#include "plumb/plane/map_check.h"

namespace plumb::cli {
namespace {

struct Format {
  std::string_view name;
  std::string_view extension;
  PictureFormat picture;
};

constexpr std::array kFormats{
    Format{"png", ".png", PictureFormat::Png},
    Format{"svg", ".svg", PictureFormat::Svg},
    Format{"html", ".html", PictureFormat::Html},
    Format{"glb", ".glb", PictureFormat::Glb},
};

class View : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("FILE", files_, "A map, a set of the plane, a solid; - is standard input")
        ->required()
        ->type_name("");
    app.add_option("--explode", apart_,
                   "Move solids apart: by X times the distance from their common middle")
        ->type_name("X")
        ->check(CLI::Range(0., 1e6).description(""));
    input_.declare(app);
    input_.declare_keep(app);
  }

  ExitCode run(Session& session) override {
    const Format& format = open_outputs(session);
    const bool is_one = files_.size() == 1 && !apart_;
    const FileKind kind = is_one ? draw_file(format.picture, session) : FileKind::Solid;
    if (!is_one) draw_solids(format.picture, session);
    if (session.options().json) json_ = answer(kind, format);
    session.deliver();
    return ExitCode::Yes;
  }

 private:
  /// Opens the outputs before the work, so that a path that cannot be written costs no time.
  const Format& open_outputs(Session& session) {
    const CommonOptions& common = session.options();
    if (common.format.empty() && (common.out.empty() || common.out == "-")) {
      throw Error(ErrorCode::Usage, "view needs -o OUT (" + extensions_of(kFormats) +
                                        ") or --format " + names_of(kFormats));
    }
    const Format& format = common.format.empty() ? format_of_file(kFormats, common.out)
                                                 : format_named(kFormats, common.format);
    session.outputs().add(common.out.empty() ? "-" : common.out,
                          [this](std::ostream& out) { out << picture_; });
    if (common.json) {
      session.outputs().add("-", [this](std::ostream& out) { out << json_ << '\n'; });
    }
    return format;
  }

  static std::string title_of(const std::string& file) {
    return file_name_of(path_of(input_name(file)).filename());
  }

  FileKind draw_file(PictureFormat format, Session& session) {
    const std::string bytes = read_input(files_.front(), session.context());
    const FileKind kind = kind_of_file(files_.front(), bytes);
    picture_ = drawn(kind, bytes, format, session);
    return kind;
  }

  std::string drawn(FileKind kind, const std::string& bytes, PictureFormat format,
                    Session& session) const {
    const std::string& file = files_.front();
    Context& context = session.context();
    const std::string title = title_of(file);
    const ReadOptions options{input_name(file), session.options().exact_decimals};
    switch (kind) {
      case FileKind::Map: {
        session.expect({reading_map(), checking_map(), drawing_map(), writing()});
        session.begin("read");
        Map map = read_map(bytes, options, context);
        session.begin("check");
        const MapReport report = check_map(std::move(map), {}, context);
        session.begin("draw");
        return picture_of(report, picture(format, title), context);
      }
      case FileKind::PlaneSet: {
        session.expect({reading_plane(), drawing_plane(), writing()});
        session.begin("read");
        const Nef2 set = read_plane(file, bytes, session);
        session.begin("draw");
        return picture_of(set, picture(format, title), context);
      }
      case FileKind::Solid:
        break;
    }
    session.expect({reading_solid(), drawing_solid(), writing()});
    session.begin("read");
    const Nef3 set = input_.read(file, bytes, session);
    session.begin("draw");
    PictureOptions shown = picture(format, title);
    shown.load_texture = [&](const std::string&, const std::string& name) {
      return loaded_texture(file, name, session);
    };
    const bool shows_textures = format == PictureFormat::Html || format == PictureFormat::Glb;
    if (!shows_textures && has_textures(set)) {
      session.note("textures are not drawn; pictures in HTML and GLB show them");
    }
    return picture_of(set, shown, context);
  }

  /// Returns the image of a texture if the texture lies in the folder of the file, or in a folder
  /// below. A note states why any other texture is not drawn.
  static std::optional<TextureImage> loaded_texture(const std::string& file,
                                                    const std::string& name, Session& session) {
    try {
      const std::string path = named_file(file, name, NamedFiles::Below);
      std::error_code unknown;  // The reader reports any error of the file.
      const std::uintmax_t size = std::filesystem::file_size(path_of(path), unknown);
      if (!unknown && size > TextureImage::kMostBytes) {
        throw Error(ErrorCode::BadArgument, "it has more than 64 MiB");
      }
      return texture_image(read_input(path, session.context()));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::CannotOpen && error.code() != ErrorCode::BadArgument) throw;
      session.note("the texture " + plumb::quoted(name) + " is not drawn: " + error.what());
      return std::nullopt;
    }
  }

  void draw_solids(PictureFormat format, Session& session) {
    ProgressStages stages(files_.size(), reading_solid());
    stages.insert(stages.end(), {drawing_solid(), writing()});
    session.expect(std::move(stages));
    std::vector<Nef3> sets;
    for (const std::string& file : files_) {
      session.begin("read");
      sets.push_back(input_.read(file, session));
    }
    session.begin("draw");
    std::string title = title_of(files_.front());
    if (files_.size() > 1) title += " and " + std::to_string(files_.size() - 1) + " more";
    picture_ = picture_of(sets, apart_.value_or(0), picture(format, title), session.context());
  }

  static std::string answer(FileKind kind, const Format& format) {
    static constexpr std::array kKinds{"map", "plane", "solid"};
    return nlohmann::ordered_json{{"kind", kKinds[static_cast<std::size_t>(kind)]},
                                  {"format", std::string(format.name)}}
        .dump();
  }

  std::vector<std::string> files_;
  std::optional<double> apart_;
  SolidInput input_;
  std::string picture_;
  std::string json_;
};

}  // namespace

std::unique_ptr<CommandBody> make_view() { return std::make_unique<View>(); }

}  // namespace plumb::cli
