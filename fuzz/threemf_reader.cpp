// The readers of 3MF and of AMF on arbitrary bytes.
//
// The first byte chooses exact decimals or nearest doubles, and whether attributes are read. If the
// rest begins like AMF, it is read as AMF. If it begins like a ZIP archive, it is the file.
// Otherwise it is the texts of parts, separated by bytes of 30, of which the target makes an
// archive: the model, another model, and the settings of two slicers. Either the reader throws an
// Error that names the file or a part of it, or the mesh it read is sound, and written as exact OFF
// and as 3MF it is read again as it was.

#include <array>
#include <sstream>
#include <vector>

#include "mesh_laws.h"
#include "plumb/io/mesh/amf.h"
#include "plumb/io/mesh/threemf.h"
#include "plumb/io/mesh/threemf_archive.h"

namespace plumb::fuzz {
namespace {

constexpr std::string_view kRelationships =
    "<Relationships><Relationship Target=\"/3D/a.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
constexpr std::array<const char*, 4> kParts{"3D/a.model", "3D/b.model",
                                            "Metadata/model_settings.config",
                                            "Metadata/Slic3r_PE_model.config"};

std::string archive_of(std::string_view texts) {
  std::vector<ZipEntry> entries{{"_rels/.rels", kRelationships}};
  for (const char* const name : kParts) {
    const std::size_t end = texts.find('\x1e');
    entries.push_back({name, texts.substr(0, end)});
    if (end == texts.npos) break;
    texts.remove_prefix(end + 1);
  }
  std::ostringstream out;
  write_zip(out, entries);
  return out.str();
}

/// Returns the colour of a corner: that of its material times that of the channel.
std::array<double, 4> color_at(const MeshFile& file, std::size_t corner) {
  std::array<double, 4> color{1, 1, 1, 1};
  const MeshAttributes& all = file.attributes;
  const std::size_t face = corner / 3;
  if (!all.face_material.empty() && all.face_material[face] != MeshAttributes::kNone) {
    color = all.materials[all.face_material[face]].color.value_or(color);
  }
  for (const MeshChannel& channel : all.channels) {
    for (std::size_t k = 0; k < channel.width; ++k) {
      color[k] *= channel.values[corner * channel.width + k];
    }
  }
  return color;
}

/// Written with its attributes and read again, a mesh has the same colours and groups.
void require_looks_round(const MeshFile& file) {
  if (file.mesh.face_count() == 0) return;
  std::ostringstream out;
  try {
    write_threemf(out, file.mesh, file.attributes);
  } catch (const Error& error) {
    require(error.code() == ErrorCode::NumberOutOfRange, "only far coordinates cannot be written");
    return;
  }
  Context context;
  ReadOptions options{"written"};
  options.attributes = true;
  const MeshFile copy = read_threemf(out.str(), options, context);
  require_sound_attributes(copy);
  require(copy.mesh.corners == file.mesh.corners, "faces stay in order");
  for (std::size_t c = 0; c < file.mesh.corners.size(); ++c) {
    require(color_at(copy, c) == color_at(file, c), "colours stay");
  }
  require(copy.attributes.face_group.empty() == file.attributes.face_group.empty(), "groups stay");
}

void judge_threemf(std::string_view bytes, bool exact_decimals, bool attributes) {
  constexpr std::uint64_t kMostBytes = 64U << 20U;  // Objects can be placed many times.
  Limits limits;
  limits.max_memory_bytes = kMostBytes;
  Context context(limits);
  ReadOptions options{kFileName, exact_decimals};
  options.attributes = attributes;
  try {
    const MeshFile file = begins_like_amf(bytes) ? read_amf(bytes, options, context)
                                                 : read_threemf(bytes, options, context);
    oracle_reached();
    require_sound_attributes(file);
    if (attributes) require_looks_round(file);
    require_sound_points(file.mesh);
    require_sound_faces(file.mesh);
    require(has_triangles_only(file.mesh), "faces are triangles");
    require_round(file.mesh, MeshFormat::ExactOff);
    if (file.mesh.face_count() > 0) require_round(file.mesh, MeshFormat::ThreeMf);
  } catch (const Error& error) {
    require(error.place().file.starts_with(kFileName), "an error names the file");
    require(
        error.place().file.size() == std::string_view(kFileName).size() || error.place().line > 0,
        "an error in a part has a line");
  }
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  fuzz::begin_input();
  if (size == 0 || !has_threemf()) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const bool exact_decimals = (data[0] & 1U) != 0, attributes = (data[0] & 2U) != 0;
  if (begins_like_zip(bytes) || begins_like_amf(bytes)) {
    fuzz::judge_threemf(bytes, exact_decimals, attributes);
  } else {
    fuzz::judge_threemf(fuzz::archive_of(bytes), exact_decimals, attributes);
  }
  return 0;
}
