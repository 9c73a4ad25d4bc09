#include "plumb/space/turn.h"

#include <algorithm>

#include "plumb/space/volumes.h"

namespace plumb {

std::vector<std::uint32_t> turn_inside_out(MeshComplex& mesh, Context& context) {
  const SpaceComplex& c = mesh.complex;
  label_volumes(mesh.complex, context);
  // A component that lies in no other one has a facet towards volume 0.
  std::vector<std::uint8_t> is_turned(mesh.is_inside_out.size(), 0);
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    const auto& sides = c.facet_volume[f];
    const bool is_outermost = sides[0] == VolumeId(0) || sides[1] == VolumeId(0);
    if (is_outermost && mesh.is_inside_out[mesh.component[f]] != 0)
      is_turned[mesh.component[f]] = 1;
  }
  std::vector<std::uint32_t> first_face(is_turned.size(), ~std::uint32_t{0}), turned;
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    if (is_turned[mesh.component[f]] == 0) continue;
    mesh.jump[f] = -mesh.jump[f];
    std::uint32_t& first = first_face[mesh.component[f]];
    first = std::min(first, c.facet_origin[f]);
  }
  for (std::size_t i = 0; i < is_turned.size(); ++i) {
    if (is_turned[i] != 0) turned.push_back(first_face[i]);
  }
  return turned;
}

}  // namespace plumb
