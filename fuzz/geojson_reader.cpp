// The GeoJSON reader on arbitrary bytes.
//
// The first byte chooses exact decimals or nearest doubles; the rest is the file. Either the reader
// throws an Error that names the file, a line and a column inside it, or the shapes it read become
// a set that passes its audit, holds at sampled points what the even-odd rule says, survives .nef2,
// and survives WKT and GeoJSON as far as their writer says.

#include "plumb/io/plane/geojson.h"
#include "shape_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::judge_reader(plumb::read_geojson, data, size);
  return 0;
}
