// What the tables of cases argued by hand have in common.
#pragma once

#include <string>

#include "plumb/io/plane_io.h"
#include "plumb/plane/nef2.h"

namespace plumb::testing {

inline Nef2 set_of_wkt(const std::string& wkt) {
  Context context;
  return read_plane_set(wkt, PlaneFormat::Wkt, {"case"}, context).set;
}

inline constexpr const char* kSquare = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
inline constexpr const char* kFrame =
    "POLYGON ((0 0, 6 0, 6 6, 0 6, 0 0), (2 2, 4 2, 4 4, 2 4, 2 2))";

}  // namespace plumb::testing
