// Rounding of subdivisions and sets of the plane to doubles and to grids, against brute force:
// valid, near, idempotent, with the faces of before.
//
// Input: a program of records of six bytes (tests/generate/rounding_scenes.h), a segment each.
#include "generate/rounding_scenes.h"
#include "oracle/rounding_check.h"
#include "record_target.h"

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{
    plumb::testing::kRoundingRecord, 26, plumb::testing::rounding_of_program_disagreement};
