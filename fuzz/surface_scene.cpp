// Polygons on surfaces against the plane: cells, labels, regions and borders of flat scenes, in
// every degenerate position; and meshes and paths nobody has checked, which are refused or pass the
// audit.
//
// Input: a program of records of three bytes (tests/generate/surface_program.h). The mutator works
// on records; every input is a program.
#include "generate/surface_program.h"
#include "record_target.h"

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kSurfaceRecord,
                                                     plumb::testing::kMostSurfaceRecords,
                                                     plumb::testing::disagreement_on_surface};
