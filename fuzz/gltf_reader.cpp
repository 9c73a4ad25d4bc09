// The glTF reader on arbitrary bytes.
//
// Either the reader throws an Error that names the file, or the mesh it read is sound, and written
// as OFF and STL it is read again as it was. With attributes, the file is read or refused, and what
// was read is complete and can be written and read again. Nothing beside the file is opened.

#include <sstream>

#include "gltf_mutator.h"
#include "mesh_laws.h"
#include "plumb/io/mesh/gltf.h"

namespace plumb::fuzz {
namespace {

void judge_attributes(std::string_view bytes, const Limits& limits) {
  Context context(limits);
  ReadOptions options{kFileName};
  options.attributes = true;
  try {
    const MeshFile file = read_gltf(bytes, {}, options, context);
    require_sound_faces(file.mesh);
    require_sound_attributes(file);
    require(has_triangles_only(file.mesh), "faces are triangles");
    if (file.mesh.face_count() == 0) return;
    std::ostringstream out;
    write_mesh(out, file.mesh, file.attributes, MeshFormat::Gltf);
    const MeshFile copy = read_gltf(out.str(), {}, options, context);
    require_sound_attributes(copy);
    require(copy.attributes.channels.size() <= file.attributes.channels.size(),
            "no channel is new");
  } catch (const Error& error) {
    // Only far coordinates cannot be written, and their error has no place.
    if (error.code() != ErrorCode::NumberOutOfRange) require_mesh_place(error, bytes);
  }
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  using namespace plumb::fuzz;
  begin_input();
  constexpr std::uint64_t kMostBytes = 64U << 20U;  // meshes can be placed many times
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Limits limits;
  limits.max_memory_bytes = kMostBytes;
  judge_attributes(bytes, limits);
  Context context(limits);
  try {
    const MeshFile file = read_gltf(bytes, {}, {kFileName}, context);
    oracle_reached();
    require_sound_points(file.mesh);
    require_sound_faces(file.mesh);
    for (const MeshFormat format : {MeshFormat::ExactOff, MeshFormat::Stl}) {
      require_round(file.mesh, format);
    }
  } catch (const Error& error) {
    require_mesh_place(error, bytes);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return plumb::fuzz::GltfMutator(seed).mutate(data, size, max_size);
}
