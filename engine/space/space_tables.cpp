#include "plumb/space/space_tables.h"

#include "plumb/base/error.h"

namespace plumb {

SpaceTables::SpaceTables() : points(planes) {
  PLUMB_CHECK(planes.intern(1, 0, 0, 0).plane() == kPlaneX);
  PLUMB_CHECK(planes.intern(0, 1, 0, 0).plane() == kPlaneY);
  PLUMB_CHECK(planes.intern(0, 0, 1, 0).plane() == kPlaneZ);
}

}  // namespace plumb
