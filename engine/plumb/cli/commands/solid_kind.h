// Sets of space as a kind of sets (set_command.h): formats, and the facts that `info` prints.
#pragma once

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <span>
#include <utility>

#include "plumb/cli/commands/set_command.h"
#include "plumb/cli/files/operands.h"
#include "plumb/cli/files/outputs.h"
#include "plumb/io/solid/solid_text.h"
#include "plumb/io/solid_io.h"
#include "plumb/space/canonical.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_measure.h"

namespace plumb::cli {

/// The facts that `info` prints.
struct SolidFacts {
  SolidFacts(const Nef3& set, Context& context)
      : counts(set.counts()),
        is_bounded(set.is_bounded()),
        is_empty(set.is_empty()),
        is_simple(set.is_simple()),
        is_convex(set.is_convex()),
        volume(marked_volume(set.complex(), context)) {}
  nlohmann::ordered_json json() const;
  void write(std::ostream& out) const;

  SpaceCounts counts;
  bool is_bounded;
  bool is_empty;
  bool is_simple;
  bool is_convex;
  std::optional<Rational> volume;
};

/// Returns the word for a kind of cells.
const char* name_of(SpaceItem::Kind kind);

/// The kind of sets of space, for set_command.h. Without a name for the format: .nef.
struct Solid {
  using Set = Nef3;
  using Input = SolidInput;
  static constexpr const char* kHelp = "Mesh (.off .obj .stl .ply .glb .3mf .amf), .nef, -";
  static constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};

  static ProgressStage reading() { return reading_solid(); }
  static ProgressStage combining() { return combining_solids(); }
  static ProgressStage measuring() { return measuring_solid(); }
  static ProgressStage locating() { return locating_solid(); }
  static ProgressStages writing(const SetOutput& output) {
    return keeps_marks(output) ? writing_nef() : writing_mesh();
  }
  static constexpr bool kWritesMeshes = true;
  static std::span<const SolidFormat> formats() { return solid_formats(); }
  static const SolidFormat& format_of(const SetOutput& output) {
    return output.format() ? formats()[static_cast<std::size_t>(*output.format())]
                           : format_named(formats(), "nef");
  }
  static bool keeps_marks(const SetOutput& output) { return format_of(output).name == "nef"; }
  static ReadyFile ready(const Nef3& set, const SetOutput& output, Context& context) {
    if (output.writes_triangles() && keeps_marks(output)) {
      throw Error(ErrorCode::Usage, "--triangles needs a format of meshes: -o OUT.obj");
    }
    const SolidFaces faces{output.keeps_faces() ? PieceJoin::SameFace : PieceJoin::SameAttributes,
                           output.writes_triangles()};
    const auto text =
        std::make_shared<SolidText>(set, format_of(output), output.rounding().rounding, context,
                                    output.material_library(), faces);
    ReadyFile file{[text, &context](std::ostream& out) { text->write(out, context); },
                   text->losses(), text->changes(), text->dropped()};
    if (text->has_library()) {
      file.write_library = [text](std::ostream& out) { text->write_library(out); };
    }
    return file;
  }
  static Nef3 canonical(const Nef3& set, Context& context) {
    return plumb::canonical(set, context).with_sources(set.sources());
  }
  static SolidFacts facts(const Nef3& set, Context& context) { return {set, context}; }
  static std::pair<const char*, bool> locate(const Nef3& set, const std::array<Rational, 3>& p) {
    const SpaceLocation place = set.locate(RationalPoint3{p[0], p[1], p[2]});
    return {name_of(place.item.kind()), place.marked};
  }
};

using SolidOperation = SetOperation<Solid>;

}  // namespace plumb::cli
