// The WKB reader on arbitrary bytes.
//
// The first byte has no meaning; the rest is the file, as bytes or as hexadecimal digits. Either
// the reader throws an Error that names the file and a place in it, or the shapes it read become a
// set that passes its audit, holds at sampled points what the even-odd rule says, survives .nef2,
// and survives WKT and GeoJSON as far as their writer says.

#include "plumb/io/plane/wkb.h"
#include "shape_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::judge_reader(plumb::read_wkb, data, size, plumb::fuzz::require_binary_place);
  return 0;
}
