// What commands go through, for the progress bar: stages, their steps, and how long each takes as a rule.
//
// Shares are of one run each, of inputs large enough to take seconds; only what they are to each other counts. A command that does
// other things than most, with other inputs, has its time left corrected on the way, no more.
#pragma once

#include "progress_estimate.h"

namespace plumb::cli {

ProgressStage reading_map();
ProgressStage checking_map();
ProgressStage overlaying_maps();
ProgressStage auditing_map();
ProgressStage drawing_map();

ProgressStage reading_plane();
ProgressStage combining_plane();
ProgressStage measuring_plane();
ProgressStage locating_plane();
ProgressStage auditing_plane();
ProgressStage drawing_plane();
ProgressStages writing_plane_text();
ProgressStages writing_nef2();
ProgressStages writing_plane_picture();

ProgressStage reading_solid();
ProgressStage combining_solids();
ProgressStage intersecting_half_spaces();
ProgressStage numbering_solid();  ///< canonically
ProgressStage measuring_solid();
ProgressStage locating_solid();
ProgressStage auditing_solid();
ProgressStage drawing_solid();
ProgressStages writing_mesh();
ProgressStages writing_nef();

ProgressStage checking_convexity();
ProgressStage cutting_solid();
ProgressStage writing_pieces();
ProgressStage drawing_pieces();
ProgressStage adding_solids();  ///< Minkowski sums

ProgressStages stages_of_surfaces();
ProgressStages stages_of_demo();

ProgressStage writing();  ///< an answer, or what is short beside the rest

}  // namespace plumb::cli
