#include "progress_stages.h"

namespace plumb::cli {

// Maps of 360,000 squares.
ProgressStage reading_map() { return {"read", {{"load", .1}, {"read", .2}}}; }
ProgressStage checking_map() {
  return {"check", {{"match edges", .4}, {"sweep", .5}, {"faces", .1}}};
}
ProgressStage overlaying_maps() {
  return {"overlay", {{"sweep", 6}, {"areas of regions", 17}, {"areas of cells", 58}, {"", 60}}};
}

// Stars of 300,000 corners.
ProgressStage reading_plane() { return {"read", {{"load", .1}, {"read", .8}, {"sweep", 4.6}}}; }
ProgressStage combining_plane() { return {"combine", {{"sweep", 15}}}; }
ProgressStage finishing_plane() { return {"result", {{"area", 2}}}; }

// Spheres of 600,000 triangles.
ProgressStage reading_solid() {
  return {"read",
          {{"load", .1},
           {"read", 1.1},
           {"reading faces", 1.5},
           {"planes of faces", .4},
           {"linking facets", .5},
           {"components", .3},
           {"crossings of the mesh with itself", 1.7},
           {"volumes", .2}}};
}
ProgressStage combining_solids() {
  return {"combine",
          {{"", .9},
           {"box trees", .4},
           {"meet", .3},
           {"vertices that stay", .6},
           {"join", .4},
           {"volumes", .1}}};
}
ProgressStage finishing_solid() {
  return {"result", {{"faces of the mesh", .6}, {"crossings of the mesh with itself", .5}}};
}

// Solids of some thousand triangles, where these take long: reading them is nothing beside it.
ProgressStage checking_convexity() { return {"convexity", {{"convexity", 10}}}; }
ProgressStage cutting_solid() { return {"cut", {{"cutting", 100}, {"", 40}}}; }
ProgressStage writing_pieces() { return {"pieces", {{"pieces", 1500}}}; }
ProgressStage adding_solids() { return {"combine", {{"", 20}, {"sums of parts", 400}}}; }
ProgressStage drawing() { return {"draw", {{"", 100}}}; }

std::vector<ProgressStage> stages_of_surfaces() {
  return {{"read", {{"load", .1}, {"read", .2}, {"trace", 2.3}}},
          {"divide", {{"slice", .2}, {"labels", .1}}},
          {"result", {{"triangulate", 1.5}}},
          writing()};
}

std::vector<ProgressStage> stages_of_demo() {
  std::vector<ProgressStage> stages;
  for (const double seconds : {.6, .5, .5, 1.6, 7., 3.5, 8.}) {
    stages.push_back({"chapter", {{"", seconds}}});
  }
  stages.push_back({"write", {{"", 1.9}}});
  return stages;
}

ProgressStage auditing() {
  return {"audit", {{"load", .1}, {"read", .1}, {"linking facets", .1}, {"audit", .2}}};
}
ProgressStage writing() { return {"write", {{"", 1}}}; }

}  // namespace plumb::cli
