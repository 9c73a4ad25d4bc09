// The DXF reader on arbitrary bytes.
//
// The first byte chooses a tolerance, or none; the rest is the file. Either the reader throws an
// Error that names the file, a line and a column inside it, or the shapes it read become a set that
// passes its audit, holds at sampled points what the even-odd rule says, and survives .nef2, WKT,
// GeoJSON and DXF as far as their writer says.

#include <cmath>

#include "plumb/io/plane/dxf.h"
#include "shape_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  using namespace plumb::fuzz;
  begin_input();
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  constexpr std::uint64_t kMostBytes = 256U << 20U;  // A curve may have 2^20 chords.
  Limits limits;
  limits.max_memory_bytes = kMostBytes;
  Context context(limits);
  ReadOptions options{kFileName};
  if (data[0] % 4 != 0) options.curve_tolerance = std::ldexp(1.0, data[0] % 32 - 16);
  try {
    const PlaneShapes shapes = read_dxf(text, options, context).shapes;
    judge_shapes(shapes);
    if (is_small(shapes)) {
      require_text_round(to_set(shapes).regularization(), PlaneFormat::Dxf);
    }
  } catch (const Error& error) {
    require_place(error, text);
  }
  return 0;
}
