// Parts of a set of the plane in its picture, each filled with a colour of its own, with thin lines around: what is
// drawn over the fill and under the edges of the set (nef2_svg.h).
#pragma once

#include <cstddef>
#include <ostream>
#include <span>

#include "plumb/base/context.h"
#include "plumb/picture/plane_window.h"
#include "plumb/picture/view.h"
#include "plumb/plane/nef2.h"

namespace plumb {

inline constexpr const char* kPieceStyle =
    R"(.piece{fill-rule:evenodd;stroke:#5b6672;stroke-width:10}
.under{fill:none;stroke:#fff;stroke-linecap:butt}
)";

/// Those too small to be seen are not counted, nor those of dimension 1 and 0.
struct PieceCounts {
  std::size_t drawn = 0;
  std::size_t left_out = 0;  ///< beyond what one file should hold
};

/// Marked faces of the pieces. `is_cut`: pieces may leave the window. `context`, if any, is asked at each piece.
PieceCounts write_pieces(std::span<const Nef2> pieces, const PlaneWindow& window, const View& view,
                         bool is_cut, Context* context, std::ostream& out);

}  // namespace plumb
