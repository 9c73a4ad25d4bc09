// The glTF reader on arbitrary bytes.
//
// Either the reader throws an Error that names the file, or the mesh it read is sound, and written
// as OFF and STL it is read again as it was. Nothing beside the file is opened.

#include "gltf_mutator.h"
#include "mesh_laws.h"
#include "plumb/io/mesh/gltf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  using namespace plumb::fuzz;
  begin_input();
  constexpr std::uint64_t kMostBytes = 64U << 20U;  // meshes can be placed many times
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Limits limits;
  limits.max_memory_bytes = kMostBytes;
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
