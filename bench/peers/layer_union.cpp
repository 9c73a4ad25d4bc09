// The union of a layer, in this process: prints the least CPU time of three calls of
// dissolve_layer() in seconds, without reading and writing. coverage_peer.py runs it beside the
// calls of GEOS and Clipper2.
//
//   layer_union LAYER
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <vector>

#include "plumb/io/layer_io.h"
#include "plumb/plane/layer_dissolve.h"

namespace {

double union_seconds(const plumb::Layer& layer) {
  const std::vector<std::uint32_t> one_group(layer.feature_count(), 0);
  const std::clock_t start = std::clock();
  const plumb::DissolvedLayer result = plumb::dissolve_layer(layer, one_group, 1);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: layer_union LAYER\n", stderr);
    return 2;
  }
  try {
    const plumb::Layer layer = plumb::read_layer_file(argv[1]).layer;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) least = std::min(least, union_seconds(layer));
    std::printf("%.6f\n", least);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "layer_union: %s\n", error.what());
    return 2;
  }
}
