// plumb plane ...: sets of the plane, combined, transformed, asked.

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "command.h"
#include "format_choice.h"
#include "number_argument.h"
#include "plumb/base/error.h"
#include "plumb/io/input.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text_output.h"
#include "plumb/picture/nef2_svg.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rounding.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;

Nef2 read_operand(const std::string& file, Session& session) {
  return read_plane_set_file(file, {}, {.exact_decimals = session.options().exact_decimals},
                             session.context());
}

// ---------------------------------------------------------------- what a set is like

Json area_json(const Nef2& set) {
  if (!set.is_bounded()) return nullptr;
  const Rational area = set.area().value();
  return {{"exact", format_exact(area)}, {"double", nearest_double(area)}};
}

Json info_json(const Nef2& set) {
  const PlaneCounts counts = counts_of(set);
  return {{"vertices", counts.vertices}, {"edges", counts.edges},   {"faces", counts.faces},
          {"bounded", set.is_bounded()}, {"empty", set.is_empty()}, {"area", area_json(set)}};
}

void write_info(std::ostream& out, const Nef2& set) {
  const PlaneCounts counts = counts_of(set);
  out << counts.vertices << " vertices, " << counts.edges << " edges, " << counts.faces
      << " faces\n"
      << (set.is_bounded() ? "bounded" : "unbounded") << (set.is_empty() ? ", empty" : "") << '\n';
  if (set.is_bounded()) out << "area " << readable(set.area().value()) << '\n';
}

// ---------------------------------------------------------------- where a result goes

struct OutputFormat {
  std::string_view name;
  std::string_view extension;
  std::optional<PlaneFormat> text;  ///< none: a picture
};

constexpr std::array kFormats{
    OutputFormat{"wkt", ".wkt", PlaneFormat::Wkt},
    OutputFormat{"geojson", ".geojson", PlaneFormat::GeoJson},
    OutputFormat{"json", ".json", PlaneFormat::GeoJson},
    OutputFormat{"nef2", ".nef2", PlaneFormat::Nef2},
    OutputFormat{"svg", ".svg", std::nullopt},
};

std::string name_of_file(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// The file or stream for a set, opened before the work: a path that cannot be written costs
/// nothing. Without -o and --format: WKT on standard output if the set is bounded, else .nef2; with
/// --json nothing but the object.
class ResultOutput {
 public:
  void open(Session& session) {
    const CommonOptions& common = session.options();
    if (common.out == "-" && common.format.empty()) {
      throw Error(ErrorCode::Usage, "-o - needs --format " + names_of(kFormats));
    }
    const bool is_named = !common.out.empty() || !common.format.empty();
    if (!common.format.empty()) {
      format_ = &format_named(kFormats, common.format);
    } else if (!common.out.empty()) {
      format_ = &format_of_file(kFormats, common.out);
    }
    if (is_named || !common.json) {
      path_ = common.out.empty() ? "-" : common.out;
      session.outputs().add(path_, [this](std::ostream& out) { write(out); });
    }
    if (common.json) {
      session.outputs().add("-", [this](std::ostream& out) { out << json_.dump() << '\n'; });
    }
  }

  /// Under `strict`, a file that would not say all is not written.
  void prepare(const Nef2& set, bool strict, Session& session) {
    if (session.options().json) json_ = info_json(set);
    if (path_.empty()) return;
    if (format_ != nullptr && !format_->text) {
      drawn_ = set;
      return;
    }
    const PlaneFormat by_itself = set.is_bounded() ? PlaneFormat::Wkt : PlaneFormat::Nef2;
    text_.emplace(set, format_ == nullptr ? by_itself : *format_->text, session.context());
    if (!strict || !text_->losses().any()) return;
    throw Error(ErrorCode::CannotWrite, "--strict: " + text_->losses().sentences().front(),
                {name()});
  }

  void deliver(Session& session) {
    session.finish_progress();
    session.outputs().deliver();
    if (!text_) return;
    for (const std::string& sentence : text_->losses().sentences()) {
      session.note(name() + ": warning: " + sentence);
    }
  }

 private:
  std::string name() const { return path_ == "-" ? "stdout" : path_; }
  void write(std::ostream& out) const {
    if (text_) {
      text_->write(out);
    } else {
      write_nef2_svg(out, drawn_, {.title = path_ == "-" ? "" : name_of_file(path_)});
    }
  }

  std::string path_;                      // empty: the set is not written
  const OutputFormat* format_ = nullptr;  // null: by the set itself
  std::optional<PlaneText> text_;         // none: a picture
  Nef2 drawn_;
  Json json_;
};

// ---------------------------------------------------------------- commands

class PlaneOperation : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", a_, "A set: .wkt, .geojson, .json, .nef2; - is standard input")
        ->required()
        ->type_name("");
    declare_more(app);
    app.add_flag("--strict", strict_,
                 "Exit 2 instead of writing a file that leaves something out or is reshaped by "
                 "rounding");
  }

  ExitCode run(Session& session) override {
    output_.open(session);
    const Nef2 result = compute(session);
    output_.prepare(result, strict_, session);
    output_.deliver(session);
    return ExitCode::Yes;
  }

 protected:
  virtual void declare_more(CLI::App&) {}
  virtual Nef2 compute(Session& session) = 0;

  std::string a_;

 private:
  bool strict_ = false;
  ResultOutput output_;
};

class BinaryOperation : public PlaneOperation {
 public:
  explicit BinaryOperation(MarkFunction function) : function_(function) {}

 private:
  void declare_more(CLI::App& app) override {
    app.add_option("B", b_, "The other set")->required()->type_name("");
  }
  Nef2 compute(Session& session) override {
    if (a_ == "-" && b_ == "-") {
      throw Error(ErrorCode::Usage, "only one of the sets can come from standard input");
    }
    const Nef2 a = read_operand(a_, session);
    return combine(a, read_operand(b_, session), function_, session.context());
  }

  MarkFunction function_;
  std::string b_;
};

class UnaryOperation : public PlaneOperation {
 public:
  using Function = Nef2 (Nef2::*)() const;
  explicit UnaryOperation(Function function) : function_(function) {}

 private:
  Nef2 compute(Session& session) override { return (read_operand(a_, session).*function_)(); }

  Function function_;
};

class PlaneInfo : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", a_, "A set: .wkt, .geojson, .json, .nef2; - is standard input")
        ->required()
        ->type_name("");
    app.add_option("--svg", svg_, "Draw the set")->type_name("OUT");
  }

  ExitCode run(Session& session) override {
    Nef2 set;
    if (!svg_.empty()) {
      session.outputs().add(svg_, [&](std::ostream& out) {
        write_nef2_svg(out, set, {.title = name_of_file(input_name(a_))});
      });
    }
    set = read_operand(a_, session);
    session.answer(info_json(set).dump(), [&](std::ostream& out) { write_info(out, set); });
    return ExitCode::Yes;
  }

 private:
  std::string a_;
  std::string svg_;
};

class PlaneLocate : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    app.add_option("A", a_, "A set: .wkt, .geojson, .json, .nef2; - is standard input")
        ->required()
        ->type_name("");
    app.add_option("X", x_, "The point: 3, -1/7, 2.5")->required()->type_name("");
    app.add_option("Y", y_)->required()->type_name("");
  }

  ExitCode run(Session& session) override {
    const RationalPoint2 point{read_number_argument(x_, "X", session),
                               read_number_argument(y_, "Y", session)};
    const PlaneLocation place = read_operand(a_, session).locate(point);
    const std::string on = place.vertex.is_valid() ? "vertex"
                           : place.edge.is_valid() ? "edge"
                                                   : "face";
    session.answer(Json{{"on", on}, {"marked", place.marked}}.dump(), [&](std::ostream& out) {
      out << on << (place.marked ? ", in the set\n" : ", not in the set\n");
    });
    return ExitCode::Yes;
  }

 private:
  std::string a_;
  std::string x_;
  std::string y_;
};

}  // namespace

std::unique_ptr<CommandBody> make_plane_union() {
  return std::make_unique<BinaryOperation>(kUnion);
}
std::unique_ptr<CommandBody> make_plane_intersection() {
  return std::make_unique<BinaryOperation>(kIntersection);
}
std::unique_ptr<CommandBody> make_plane_difference() {
  return std::make_unique<BinaryOperation>(kDifference);
}
std::unique_ptr<CommandBody> make_plane_symmetric_difference() {
  return std::make_unique<BinaryOperation>(kSymmetricDifference);
}
std::unique_ptr<CommandBody> make_plane_complement() {
  return std::make_unique<UnaryOperation>(&Nef2::complement);
}
std::unique_ptr<CommandBody> make_plane_interior() {
  return std::make_unique<UnaryOperation>(&Nef2::interior);
}
std::unique_ptr<CommandBody> make_plane_closure() {
  return std::make_unique<UnaryOperation>(&Nef2::closure);
}
std::unique_ptr<CommandBody> make_plane_boundary() {
  return std::make_unique<UnaryOperation>(&Nef2::boundary);
}
std::unique_ptr<CommandBody> make_plane_regularize() {
  return std::make_unique<UnaryOperation>(&Nef2::regularization);
}
std::unique_ptr<CommandBody> make_plane_info() { return std::make_unique<PlaneInfo>(); }
std::unique_ptr<CommandBody> make_plane_locate() { return std::make_unique<PlaneLocate>(); }

}  // namespace plumb::cli
