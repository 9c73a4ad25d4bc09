#include "progress_stages.h"

namespace plumb::cli {

ProgressStage writing() { return {"write", {{"", .5}}}; }

// Maps of 1,440,000 squares, for overlays of 90,000.
ProgressStage reading_map() { return {"read", {{"load", .2}, {"read", .5}}}; }
ProgressStage checking_map() {
  return {"check", {{"match edges", 1.3}, {"sweep", 1}, {"faces", .3}}};
}
ProgressStage overlaying_maps() {
  return {"overlay", {{"sweep", 12}, {"areas of regions", 22}, {"areas of cells", 115}}};
}
ProgressStage auditing_map() { return {"audit", {{"", 1.9}}}; }
ProgressStage drawing_map() { return {"draw", {{"", 2}}}; }

// Stars of 500,000 corners.
ProgressStage reading_plane() { return {"read", {{"load", .1}, {"read", 1}, {"sweep", 4.5}}}; }
ProgressStage combining_plane() { return {"combine", {{"sweep", 15}}}; }
ProgressStage measuring_plane() { return {"measure", {{"area", 50}}}; }
ProgressStage locating_plane() { return {"locate", {{"", 13}}}; }
ProgressStage auditing_plane() { return {"audit", {{"read", 1}, {"sweep", 4.5}, {"audit", 10}}}; }
ProgressStage drawing_plane() { return {"draw", {{"", 130}}}; }
ProgressStages writing_plane_text() {
  return {{"result", {{"", 4}, {"parts", 10}, {"shapes", 13}, {"round", 7}, {"sweep", 8}}},
          {"write", {{"", 2}}}};
}
ProgressStages writing_nef2() { return {{"write", {{"", 12}}}}; }
ProgressStages writing_plane_picture() { return {{"write", {{"", 130}}}}; }

// Spheres of 480,000 triangles.
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
ProgressStage intersecting_half_spaces() {
  return {"combine", {{"planes", 3}, {"half-spaces", 19}}};
}
ProgressStage numbering_solid() {
  return {"number",
          {{"order of vertices", 1.3},
           {"order of edges", .2},
           {"order of facets", .2},
           {"order of uses", .2},
           {"order of volumes", .2},
           {"names of planes", 15},
           {"names of points", 1.3}}};
}
ProgressStage measuring_solid() { return {"measure", {{"", .3}, {"measures", 22}}}; }
ProgressStage locating_solid() { return {"locate", {{"", .5}}}; }
ProgressStage auditing_solid() {
  return {"audit",
          {{"read", 1.1},
           {"reading faces", 1.5},
           {"planes of faces", .4},
           {"linking facets", .5},
           {"components", .3},
           {"crossings of the mesh with itself", 1.7},
           {"audit", 7}}};
}
ProgressStage drawing_solid() { return {"draw", {{"", .5}, {"facets", 5}}}; }
ProgressStages writing_mesh() {
  return {{"result", {{"faces of the mesh", .6}, {"crossings of the mesh with itself", .5}}},
          {"write", {{"", 1}}}};
}
ProgressStages writing_nef() { return {{"write", {{"", 10}}}}; }

// The same spheres, not convex; of pieces and sums solids of some thousand triangles: reading them is nothing beside it.
ProgressStage checking_convexity() {
  return {"convexity",
          {{"convexity", .3},
           {"reading faces", 1.5},
           {"planes of faces", .4},
           {"linking facets", .5},
           {"components", .3},
           {"crossings of the mesh with itself", 1.7},
           {"faces", 26}}};
}
ProgressStage cutting_solid() { return {"cut", {{"cutting", 1000}, {"merging", 20}}}; }
ProgressStage writing_pieces() { return {"pieces", {{"pieces", 1500}}}; }
ProgressStage drawing_pieces() { return {"draw", {{"", 100}}}; }
ProgressStage adding_solids() {
  return {"combine", {{"", 20}, {"sums of parts", 400}, {"box trees", 1200}}};
}

ProgressStages stages_of_surfaces() {
  return {{"read", {{"load", .1}, {"read", .2}, {"trace", 2.3}}},
          {"divide", {{"slice", .2}, {"labels", .1}}},
          {"result", {{"triangulate", 1.5}}},
          {"write", {{"", 1}}}};
}

ProgressStages stages_of_demo() {
  ProgressStages stages;
  for (const double seconds : {.6, .5, .5, 1.6, 7., 3.5, 8.}) {
    stages.push_back({"chapter", {{"", seconds}}});
  }
  stages.push_back({"write", {{"", 1.9}}});
  return stages;
}

}  // namespace plumb::cli
