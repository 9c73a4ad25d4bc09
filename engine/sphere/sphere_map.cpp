#include "plumb/sphere/sphere_map.h"

namespace plumb {

void SphereMap::clear() {
  for (auto* marks : {&point_mark, &arc_mark, &face_mark}) marks->clear();
  for (auto* ids : {&first_out, &point_face, &origin, &next, &face}) ids->clear();
  direction.clear();
  circle.clear();
  centre_mark = 0;
}

}  // namespace plumb
