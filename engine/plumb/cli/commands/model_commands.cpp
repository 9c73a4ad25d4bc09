// The commands that make, move and measure models: `plumb solid make`, `hull`, `offset`, `extrude`,
// `revolve`, `transform`, `slice`, `project` and `components`.
//
// Results are sets of space or of the plane, so the commands share everything else with
// set_command.h. A command whose operands and result are of different kinds has a kind of its own:
// the kind of the result with the input of the operand. Tested by tests/cli/model_command_test.cpp.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/cli/commands/plane_kind.h"
#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/commands/solid_kind.h"
#include "plumb/cli/session/command.h"
#include "plumb/io/text/text_output.h"
#include "plumb/model/extrude.h"
#include "plumb/model/hull.h"
#include "plumb/model/parts.h"
#include "plumb/model/primitives.h"
#include "plumb/model/slice.h"
#include "plumb/model/solid_offset.h"
#include "plumb/model/transform.h"
#include "plumb/picture/svg/sheet.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb::cli {
namespace {

double double_argument(const std::string& text, const std::string& name, Session& session) {
  return nearest_double(read_number_argument(text, name, session));
}

/// Returns the N numbers of "a,b,c".
template <std::size_t N>
std::array<Rational, N> numbers_argument(const std::string& text, const std::string& name,
                                         Session& session) {
  std::array<Rational, N> numbers;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t end = text.find(',', begin);
    if ((end == std::string::npos) != (i + 1 == N)) {
      throw Error(ErrorCode::Usage,
                  name + " needs " + std::to_string(N) + " numbers between commas, found " + text);
    }
    const std::size_t length = end == std::string::npos ? end : end - begin;
    numbers[i] = read_number_argument(text.substr(begin, length), name, session);
    begin = end + 1;
  }
  return numbers;
}

template <std::size_t N>
std::array<double, N> doubles_argument(const std::string& text, const std::string& name,
                                       Session& session) {
  const std::array<Rational, N> numbers = numbers_argument<N>(text, name, session);
  std::array<double, N> doubles;
  for (std::size_t i = 0; i < N; ++i) doubles[i] = nearest_double(numbers[i]);
  return doubles;
}

// ---------------------------------------------------------------- solids from numbers

/// The command reads no operands.
struct NoInput {
  void declare(CLI::App&) {}
  SolidRead load(const std::string&, const CommonOptions&, Context&) const { return {}; }
};

struct MadeSolid : Solid {
  using Input = NoInput;
};

class MakeSolid : public SetOperation<MadeSolid> {
 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("SHAPE", shape_, "box, sphere, cylinder, cone or torus")
        ->required()
        ->type_name("")
        ->check(
            CLI::IsMember({"box", "cube", "sphere", "cylinder", "cone", "torus"}).description(""));
    app.add_option("--size", size_, "Sides of a box (default 1,1,1)")->type_name("X,Y,Z");
    app.add_option("--radius", radius_, "Radius of the circles (default 1)")->type_name("R");
    app.add_option("--top", top_, "Radius at the top of a cone (default 0)")->type_name("R");
    app.add_option("--tube", tube_, "Radius of the tube of a torus (default 1/4)")->type_name("R");
    app.add_option("--height", height_, "Height of a cylinder or cone (default 1)")->type_name("H");
    app.add_option("--segments", segments_, "Chords of a circle (default 30)")->type_name("N");
    app.add_flag("--centre", is_centred_, "Put the centre of the solid at the origin");
  }
  ProgressStages stages() const override { return {Solid::combining()}; }

  Nef3 compute(Session& session) override {
    session.begin("combine");
    return Nef3::from_mesh(mesh(session), {.rule = WindingRule::Positive}, session.context());
  }
  PolygonMesh mesh(Session& session) const {
    const Placement placement = is_centred_ ? Placement::Centred : Placement::Corner;
    Context& context = session.context();
    if (shape_ == "box" || shape_ == "cube") {
      return box_mesh(doubles_argument<3>(size_, "--size", session), placement);
    }
    const double radius = double_argument(radius_, "--radius", session);
    if (shape_ == "sphere") return sphere_mesh(radius, segments_, context);
    if (shape_ == "torus") {
      return torus_mesh(radius, double_argument(tube_, "--tube", session), segments_, segments_,
                        context);
    }
    const double height = double_argument(height_, "--height", session);
    const double top = shape_ == "cone" ? double_argument(top_, "--top", session) : radius;
    return cylinder_mesh(height, radius, top, segments_, placement, context);
  }

  std::string shape_;
  std::string size_ = "1,1,1";
  std::string radius_ = "1";
  std::string top_ = "0";
  std::string tube_ = "1/4";
  std::string height_ = "1";
  std::uint32_t segments_ = 30;
  bool is_centred_ = false;
};

// ---------------------------------------------------------------- solids from solids

/// Computes the convex hull of solids.
class HullOfSolids : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    app.add_option("A", files_, Solid::kHelp)->required()->type_name("");
  }
  ProgressStages stages() const override { return stages_of_sets<Solid>(files_.size(), 1); }
  Nef3 compute(Session& session) override {
    require_one_stdin(files_);
    const std::vector<Nef3> sets = read_all(files_, session);
    session.begin("combine");
    return convex_hull(sets, session.context());
  }

  std::vector<std::string> files_;
};

/// Grows or shrinks a solid by a distance.
class OffsetSolid : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    declare_first<Solid>(app, a_);
    app.add_option("--by", by_, "The distance; a negative one shrinks A")
        ->required()
        ->type_name("D");
    app.add_option("--rounds", options_.rounds,
                   "Divisions of the octahedron that replaces a ball (default 2)")
        ->type_name("N")
        ->check(CLI::Range(0U, 7U).description(""));
  }
  ProgressStages stages() const override { return {Solid::reading(), adding_solids()}; }
  Nef3 compute(Session& session) override {
    const double by = double_argument(by_, "--by", session);
    const Nef3 set = read(a_, session);
    session.begin("combine");
    return offset(set, by, options_, session.context());
  }

  std::string a_;
  std::string by_;
  SolidOffsetOptions options_;
};

/// Applies affine maps to a solid, in the order in which the help lists the options.
class TransformSolid : public SolidOperation {
 private:
  void declare_operands(CLI::App& app) override {
    declare_first<Solid>(app, a_);
    app.add_option("--mirror", mirror_, "Mirror at the plane through 0 with this normal")
        ->type_name("X,Y,Z");
    app.add_option("--scale", scale_, "Scale by these factors along the axes")->type_name("X,Y,Z");
    app.add_option("--resize", resize_, "New size of the bounding box; 0 keeps a size")
        ->type_name("X,Y,Z");
    app.add_option("--rotate", rotate_, "Rotate about an axis through 0: 0,0,1,45")
        ->type_name("X,Y,Z,DEGREES");
    app.add_option("--translate", translate_, "Move by this vector")->type_name("X,Y,Z");
  }
  Nef3 compute(Session& session) override {
    const Nef3 set = read(a_, session);
    session.begin("combine");
    const AffineMap3 map = map_for(set, session);
    if (determinant(map) == 0) {
      throw Error(ErrorCode::Usage, "the map makes the solid flat; its determinant is 0");
    }
    return set.transformed(map, session.context());
  }

  AffineMap3 map_for(const Nef3& set, Session& session) const {
    AffineMap3 map = translation({0, 0, 0});
    const auto then = [&map](const AffineMap3& next) { map = composed(next, map); };
    if (!mirror_.empty()) then(reflection(numbers_argument<3>(mirror_, "--mirror", session)));
    if (!scale_.empty()) then(scaling(numbers_argument<3>(scale_, "--scale", session)));
    if (!resize_.empty()) {
      const auto size = numbers_argument<3>(resize_, "--resize", session);
      const auto box = bounding_box(set.transformed(map, session.context()));
      if (box) then(resizing(*box, size));
    }
    if (!rotate_.empty()) {
      const auto [x, y, z, degrees] = doubles_argument<4>(rotate_, "--rotate", session);
      then(rotation({x, y, z}, degrees));
    }
    if (!translate_.empty()) {
      then(translation(numbers_argument<3>(translate_, "--translate", session)));
    }
    return map;
  }
  std::string a_;
  std::string mirror_, scale_, resize_, rotate_, translate_;
};

// ---------------------------------------------------------------- solids from plane sets

/// Outlines are read as sets of the plane, without their features.
struct OutlineInput : PlaneInput {
  void declare_keep(CLI::App&) = delete;
};

struct SweptSolid : Solid {
  using Input = OutlineInput;
  static constexpr const char* kHelp = Plane::kHelp;
};

Nef2 read_outline(const PlaneInput& input, const std::string& file, Session& session) {
  return std::move(read_sets(input, {file}, session).front());
}

class ExtrudeOutline : public SetOperation<SweptSolid> {
 private:
  void declare_operands(CLI::App& app) override {
    declare_first<SweptSolid>(app, a_);
    app.add_option("--height", height_, "Height along the z-axis")->required()->type_name("H");
    app.add_flag("--centre", is_centred_, "Extrude from -H/2 to H/2, not from 0 to H");
    app.add_option("--twist", twist_, "Rotate the top clockwise by this angle")
        ->type_name("DEGREES");
    app.add_option("--scale", scale_, "Scale x and y at the top by these factors")
        ->type_name("X,Y");
    app.add_option("--slices", slices_, "Number of layers, for a twist (default 1)")
        ->type_name("N");
  }
  ProgressStages stages() const override { return {Plane::reading(), Solid::combining()}; }
  Nef3 compute(Session& session) override {
    LinearExtrusion options;
    options.height = double_argument(height_, "--height", session);
    options.centred = is_centred_;
    options.twist = double_argument(twist_, "--twist", session);
    options.scale = doubles_argument<2>(scale_, "--scale", session);
    options.slices = slices_;
    const Nef2 outline = read_outline(input(), a_, session);
    session.begin("combine");
    return linear_extrusion(outline, options, session.context());
  }

  std::string a_;
  std::string height_;
  bool is_centred_ = false;
  std::string twist_ = "0";
  std::string scale_ = "1,1";
  std::uint32_t slices_ = 1;
};

class RevolveOutline : public SetOperation<SweptSolid> {
 private:
  void declare_operands(CLI::App& app) override {
    declare_first<SweptSolid>(app, a_);
    app.add_option("--angle", angle_, "Angle (default 360); y of the set becomes z")
        ->type_name("DEGREES");
    app.add_option("--steps", steps_, "Number of steps (default 30)")->type_name("N");
  }
  ProgressStages stages() const override { return {Plane::reading(), Solid::combining()}; }
  Nef3 compute(Session& session) override {
    const double angle = double_argument(angle_, "--angle", session);
    const Nef2 outline = read_outline(input(), a_, session);
    session.begin("combine");
    return rotational_extrusion(outline, angle, steps_, session.context());
  }

  std::string a_;
  std::string angle_ = "360";
  std::uint32_t steps_ = 30;
};

// ---------------------------------------------------------------- plane sets from solids

struct FlatPart : Plane {
  using Input = SolidInput;
  static constexpr const char* kHelp = Solid::kHelp;
};

Nef3 read_one_solid(const SolidInput& input, const std::string& file, Session& session) {
  return std::move(read_sets(input, {file}, session).front());
}

/// Slices at several heights, as GeoJSON. Each slice is a feature whose id is the height.
class SliceStack {
 public:
  SliceStack(std::vector<Rational> heights, std::vector<Nef2> slices)
      : heights_(std::move(heights)), slices_(std::move(slices)) {}

  nlohmann::ordered_json facts(Context& context) const {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < slices_.size(); ++i) {
      nlohmann::ordered_json entry = number(heights_[i]);
      nlohmann::ordered_json one{{"z", std::move(entry)}};
      one.update(Plane::facts(slices_[i], context).json());
      list.push_back(std::move(one));
    }
    return {{"slices", std::move(list)}};
  }

  ReadyFile file(const SetOutput& output, Context& context) const {
    const auto features = std::make_shared<std::vector<Feature>>();
    ReadyFile all;
    for (std::size_t i = 0; i < slices_.size(); ++i) {
      context.checkpoint("slices", i, slices_.size());
      ReadyFile one = Plane::ready(slices_[i], output, context);
      const std::string place = "the slice at z = " + heights_[i].str() + ": ";
      for (const std::string& loss : one.losses) all.losses.push_back(place + loss);
      for (const std::string& change : one.changes) all.changes.push_back(place + change);
      features->push_back({heights_[i], std::move(one.write)});
    }
    all.write = [features](std::ostream& out) { write(out, *features); };
    return all;
  }

 private:
  struct Feature {
    Rational height;
    std::function<void(std::ostream&)> geometry;
  };

  static nlohmann::ordered_json number(const Rational& x) {
    return {{"exact", x.str()}, {"double", nearest_double(x)}};
  }
  static void write(std::ostream& out, const std::vector<Feature>& features) {
    out << R"({"type":"FeatureCollection","features":[)";
    const char* separator = "\n";
    for (const Feature& feature : features) {
      std::ostringstream geometry;
      feature.geometry(geometry);
      std::string text = geometry.str();
      if (text.ends_with('\n')) text.pop_back();
      out << std::exchange(separator, ",\n") << R"({"type":"Feature","id":"z=)"
          << feature.height.str() << R"(","properties":{"z":)"
          << nlohmann::json(nearest_double(feature.height)).dump() << R"(},"geometry":)" << text
          << '}';
    }
    out << "\n]}\n";
  }

  std::vector<Rational> heights_;
  std::vector<Nef2> slices_;
};

class SliceSolid : public SetOperation<FlatPart> {
 public:
  ExitCode run(Session& session) override {
    if (heights_.size() == 1 && every_.empty()) return SetOperation::run(session);
    SetOutput& output = open_output(session);
    const auto format = output.format();
    const bool is_geojson =
        format && kPlaneFormats[static_cast<std::size_t>(*format)].text == PlaneFormat::GeoJson;
    if (!is_geojson && !(session.options().json && !format)) {
      throw Error(ErrorCode::Usage,
                  "several slices are features of a GeoJSON file: -o OUT.geojson, or --format "
                  "geojson");
    }
    std::vector<Rational> heights = all_heights(session);
    session.expect(stack_stages(session, output));
    const Nef3 set = read_one_solid(input(), a_, session);
    session.begin("combine");
    std::vector<Nef2> sets = slices(set, heights, session.context());
    const SliceStack stack(std::move(heights), std::move(sets));
    const auto facts = [&] {
      session.begin("measure");
      return stack.facts(session.context());
    };
    const auto file = [&] {
      session.begin("result");
      return stack.file(output, session.context());
    };
    output.prepare(facts, file, is_strict(), session);
    output.deliver(session);
    return ExitCode::Yes;
  }

 private:
  static constexpr std::size_t kMostSlices = std::size_t{1} << 20U;

  bool may_keep() const override { return false; }
  void declare_operands(CLI::App& app) override {
    declare_first<FlatPart>(app, a_);
    app.add_option("--z", heights_, "Height of the slice; several give GeoJSON features")
        ->required()
        ->type_name("Z")
        ->allow_extra_args(false);
    app.add_option("--every", every_, "Slices H apart, from the first --z to the second")
        ->type_name("H");
  }
  ProgressStages stages() const override { return {Solid::reading(), Solid::combining()}; }
  ProgressStages stack_stages(Session& session, const SetOutput& output) const {
    ProgressStages all = stages();
    if (session.options().json) all.push_back(Plane::measuring());
    for (const ProgressStage& stage : Plane::writing(output)) all.push_back(stage);
    return all;
  }
  Nef2 compute(Session& session) override {
    const Rational height = read_number_argument(heights_[0], "--z", session);
    const Nef3 set = read_one_solid(input(), a_, session);
    session.begin("combine");
    return slice(set, height, session.context());
  }

  /// The ids of the features are the heights, which are all different.
  static void require_different(std::vector<Rational> heights) {
    std::sort(heights.begin(), heights.end());
    const auto twice = std::adjacent_find(heights.begin(), heights.end());
    if (twice == heights.end()) return;
    throw Error(ErrorCode::Usage, "--z " + twice->str() +
                                      " is given twice; the slices at different heights are "
                                      "features with different ids");
  }

  std::vector<Rational> all_heights(Session& session) const {
    std::vector<Rational> heights;
    for (const std::string& text : heights_) {
      heights.push_back(read_number_argument(text, "--z", session));
    }
    if (every_.empty()) {
      require_different(heights);
      return heights;
    }
    const Rational step = read_number_argument(every_, "--every", session);
    if (heights.size() != 2 || heights[0] > heights[1] || step <= 0) {
      throw Error(ErrorCode::Usage,
                  "--every needs a positive number and two heights: --z LOW --z HIGH --every H");
    }
    const Rational last = (heights[1] - heights[0]) / step;
    if (last >= kMostSlices) {
      throw Error(ErrorCode::Usage,
                  "--every gives more than " + std::to_string(kMostSlices) + " slices");
    }
    std::vector<Rational> all;
    for (std::size_t i = 0; i <= last; ++i) all.push_back(heights[0] + step * i);
    return all;
  }

  std::string a_;
  std::vector<std::string> heights_;
  std::string every_;
};

class ProjectSolid : public SetOperation<FlatPart> {
 private:
  bool may_keep() const override { return false; }
  void declare_operands(CLI::App& app) override { declare_first<FlatPart>(app, a_); }
  ProgressStages stages() const override { return {Solid::reading(), Solid::combining()}; }
  Nef2 compute(Session& session) override {
    const Nef3 set = read_one_solid(input(), a_, session);
    session.begin("combine");
    return shadow(set, session.context());
  }

  std::string a_;
};

// ---------------------------------------------------------------- what a solid consists of

class ListComponents : public CommandBody {
 public:
  void declare(CLI::App& app) override {
    declare_first<Solid>(app, a_);
    input_.declare(app);
  }
  ExitCode run(Session& session) override {
    session.expect({Solid::reading(), Solid::measuring(), writing()});
    const Nef3 set = read_one_solid(input_, a_, session);
    session.begin("measure");
    std::vector<Part> parts;
    for (const Nef3& part : components(set, session.context())) {
      parts.emplace_back(part, session.context());
    }
    session.answer(json(parts).dump(), [&](std::ostream& out) { write(out, parts); });
    return ExitCode::Yes;
  }

 private:
  struct Part {
    Part(const Nef3& set, Context& context) : facts(set, context), handles(genus(set)) {
      if (facts.is_bounded) box = bounding_box(set);
    }
    SolidFacts facts;
    std::optional<std::uint64_t> handles;
    std::optional<BoundingBox3> box;
  };

  static nlohmann::ordered_json json(const std::vector<Part>& parts) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Part& part : parts) {
      nlohmann::ordered_json json = part.facts.json();
      json["genus"] = nullptr;
      if (part.handles) json["genus"] = *part.handles;
      json["box"] = nullptr;
      if (part.box) json["box"] = {point(part.box->low), point(part.box->high)};
      list.push_back(json);
    }
    return {{"components", list}};
  }
  static nlohmann::ordered_json point(const RationalPoint3& p) {
    return {nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)};
  }
  static void write(std::ostream& out, const std::vector<Part>& parts) {
    out << counted(parts.size(), "component") << '\n';
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Part& part = parts[i];
      out << i + 1 << ": " << counted(part.facts.counts.facets, "facet");
      if (part.facts.volume) out << ", volume " << nearest_double(*part.facts.volume);
      if (part.handles) out << ", genus " << *part.handles;
      if (part.box) out << ", box " << text(part.box->low) << " to " << text(part.box->high);
      out << '\n';
    }
  }
  static std::string text(const RationalPoint3& p) {
    return '(' + decimal_text(p.x, 6) + ' ' + decimal_text(p.y, 6) + ' ' + decimal_text(p.z, 6) +
           ')';
  }

  std::string a_;
  SolidInput input_;
};

}  // namespace

std::unique_ptr<CommandBody> make_solid_make() { return std::make_unique<MakeSolid>(); }
std::unique_ptr<CommandBody> make_solid_hull() { return std::make_unique<HullOfSolids>(); }
std::unique_ptr<CommandBody> make_solid_offset() { return std::make_unique<OffsetSolid>(); }
std::unique_ptr<CommandBody> make_solid_transform() { return std::make_unique<TransformSolid>(); }
std::unique_ptr<CommandBody> make_solid_extrude() { return std::make_unique<ExtrudeOutline>(); }
std::unique_ptr<CommandBody> make_solid_revolve() { return std::make_unique<RevolveOutline>(); }
std::unique_ptr<CommandBody> make_solid_slice() { return std::make_unique<SliceSolid>(); }
std::unique_ptr<CommandBody> make_solid_project() { return std::make_unique<ProjectSolid>(); }
std::unique_ptr<CommandBody> make_solid_components() { return std::make_unique<ListComponents>(); }

}  // namespace plumb::cli
