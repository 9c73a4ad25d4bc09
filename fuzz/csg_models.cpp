// Models of OpenSCAD, from their text to the canonical file of the solid, against the oracle of
// cells of half-spaces.
//
// Input: a program of records of eight bytes (tests/generate/model_program.h). The mutator works on
// records; every input is a model.
#include "generate/set_program.h"
#include "oracle/model_check.h"
#include "record_target.h"

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 20,
                                                     plumb::testing::flaw_of_model};
