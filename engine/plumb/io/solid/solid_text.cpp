#include "plumb/io/solid/solid_text.h"

#include <array>
#include <utility>

#include "plumb/io/nef3_writer.h"
#include "plumb/predicates/error.h"
#include "plumb/space/to_mesh.h"

namespace plumb {
namespace {

constexpr std::array kFormats{
    SolidFormat{"off", ".off", MeshFormat::Off},
    SolidFormat{"obj", ".obj", MeshFormat::Obj},
    SolidFormat{"stl", ".stl", MeshFormat::Stl},
    SolidFormat{"ply", ".ply", MeshFormat::Ply},
    SolidFormat{"nef", ".nef", std::nullopt},
    SolidFormat{"off-exact", ".off", MeshFormat::ExactOff},
    SolidFormat{"stl-binary", ".stl", MeshFormat::StlBinary},
    SolidFormat{"ply-text", ".ply", MeshFormat::PlyText},
};

std::string counted(std::uint64_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string to_text(const ItemCounts& items) {
  std::string text;
  const auto add = [&text](std::uint64_t count, const char* what) {
    if (count != 0) text += (text.empty() ? "" : ", ") + counted(count, what);
  };
  add(items.facets, "facet");
  add(items.edges, "edge");
  text += items.vertices == 0 ? ""
                              : (text.empty() ? "" : ", ") + std::to_string(items.vertices) +
                                    (items.vertices == 1 ? " vertex" : " vertices");
  return text;
}

void describe(const RoundingReport& rounding, std::vector<std::string>& losses) {
  const auto add = [&losses](std::uint64_t count, const std::string& what) {
    if (count != 0) {
      losses.push_back("rounding to doubles: " + std::to_string(count) + " " + what +
                       "; .nef keeps the exact set");
    }
  };
  add(rounding.vertices_merged, "vertices fell onto others");
  add(rounding.degenerate.size(), "faces lost their area");
  add(rounding.flipped.size(), "faces turned over");
  add(rounding.not_simple.size(), "faces cross themselves");
  add(rounding.doubled.size(), "faces fell onto each other");
  add(rounding.crossing_count, "pairs of faces cross");
}

}  // namespace

std::span<const SolidFormat> solid_formats() { return kFormats; }

SolidText::SolidText(const Nef3& set, const SolidFormat& format, Context& context)
    : set_(set), format_(format) {
  if (format.mesh) make_mesh(*format.mesh, context);
}

void SolidText::make_mesh(MeshFormat format, Context& context) {
  const bool wants_triangles = format == MeshFormat::Stl || format == MeshFormat::StlBinary;
  ToMeshOptions options;
  options.faces = wants_triangles ? MeshFaces::Triangles : MeshFaces::PlanarPolygons;
  MeshOfComplex made = mesh_of_complex(set_.complex(), options, context);
  if (made.report.is_unbounded) {
    throw Error(ErrorCode::CannotWrite,
                "the set reaches to infinity: a mesh cannot hold it, .nef can");
  }
  if (made.report.dropped.total() != 0) {
    losses_.push_back("left out what no volume of the set touches: " +
                      to_text(made.report.dropped));
  }
  if (made.report.filled.total() != 0) {
    losses_.push_back("the set is not closed; its closure was written, with " +
                      to_text(made.report.filled));
  }
  if (format != MeshFormat::ExactOff) {
    constexpr std::uint64_t kListed = 1;
    describe(check_rounding(made.mesh, kListed, context), losses_);
  }
  mesh_ = std::move(made.mesh);
}

void SolidText::write(std::ostream& out, Context& context) const {
  if (format_.mesh) {
    write_mesh(out, mesh_, *format_.mesh);
  } else {
    write_nef3(out, set_.complex(), context);
  }
}

}  // namespace plumb
