// The PLY reader on arbitrary bytes.
//
// The first byte chooses exact decimals or nearest doubles; the rest is the file. Either the reader
// throws an Error that names the file and a place in it, or the mesh it read is sound, and written
// in this and other formats it is read again as it was.

#include "mesh_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using plumb::MeshFormat;
  plumb::fuzz::judge_mesh_reader({MeshFormat::Ply, MeshFormat::PlyText, MeshFormat::ExactOff}, data,
                                 size);
  return 0;
}
