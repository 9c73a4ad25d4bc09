// What commands go through, for the progress bar: stages, their steps, and how long each takes as a rule.
//
// Shares are seconds of one run each, of inputs large enough to take seconds; only what they are to each other counts.
// A command that does other things than most, with other inputs, has its percentage grow unevenly, no more.
#pragma once

#include <vector>

#include "progress_estimate.h"

namespace plumb::cli {

ProgressStage reading_map();
ProgressStage checking_map();
ProgressStage overlaying_maps();

ProgressStage reading_plane();
ProgressStage combining_plane();
ProgressStage finishing_plane();

ProgressStage reading_solid();
ProgressStage combining_solids();
ProgressStage finishing_solid();

ProgressStage checking_convexity();
ProgressStage cutting_solid();
ProgressStage writing_pieces();
ProgressStage adding_solids();  ///< Minkowski sums

std::vector<ProgressStage> stages_of_surfaces();
std::vector<ProgressStage> stages_of_demo();

ProgressStage auditing();
ProgressStage drawing();
ProgressStage writing();

}  // namespace plumb::cli
