// Mending of meshes against brute force: what the report says of holes, points and faces holds, and
// mending again finds nothing to weld or drop.
//
// Input: a program of records of eight bytes (tests/oracle/repair_check.h), a face each.
#include "oracle/repair_check.h"
#include "record_target.h"

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{
    plumb::testing::kRepairRecord, 32, plumb::testing::repair_of_program_disagreement};
