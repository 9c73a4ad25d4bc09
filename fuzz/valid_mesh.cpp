// Rounding of sets of space to doubles and floats, against brute force: the mesh is valid and near,
// and rounding it again changes nothing. Booleans in a row go through what was written.
//
// Input: a program of records of fourteen bytes (tests/generate/near_solids.h), a solid each.
#include "generate/near_solids.h"
#include "oracle/valid_mesh_check.h"
#include "record_target.h"

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{
    plumb::testing::kNearSolidRecord, 3, plumb::testing::valid_mesh_of_program_disagreement};
