// How the check of a map grows with its faces, family by family (growth.h says how it is measured).
#include "plumb/testing/map_families.h"

#include <memory>
#include <utility>

#include "growth.h"
#include "plumb/plane/map_check.h"
#include "plumb/predicates/error.h"

namespace plumb::bench {
namespace {

Work check_of(const testing::TestMap& source) {
  const auto map = std::make_shared<const Map>(to_map(source));
  return {static_cast<double>(testing::face_count(source)), [map](Meter& meter) {
            Map copy = *map;
            Context context;
            meter.start();
            const MapReport report = check_map(std::move(copy), {}, context);
            meter.stop();
            PLUMB_CHECK(report.verdict == MapVerdict::Valid);
          }};
}

std::vector<Family> families() {
  std::vector<Family> result;
  for (const testing::MapFamily& family : testing::map_families()) {
    result.push_back(
        {family.name,
         "the whole check of a map; the note on the DCEL implies O(m^2) for crossings alone",
         "faces",
         {1, 1},
         sizes_between(1000, 1000000, 3.1622776601683795),
         [make = family.make](std::size_t faces) {
           return check_of(make(static_cast<std::uint32_t>(faces)));
         },
         1.15});
  }
  return result;
}

}  // namespace
}  // namespace plumb::bench

int main(int argc, char** argv) {
  return plumb::bench::growth_main("Growth of the check of maps", plumb::bench::families(), argc,
                                   argv);
}
