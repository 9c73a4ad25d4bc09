#include "plumb/io/map_writer.h"

#include "plumb/base/refused_memory.h"
#include "plumb/io/text_output.h"

namespace plumb {
namespace {

void write_cycle(TextOutput& out, std::span<const std::uint32_t> cycle) {
  char separator = '\0';
  for (const std::uint32_t vertex : cycle) {
    if (separator != '\0') out << separator;
    out << vertex + 1;
    separator = ' ';
  }
  out << '\n';
}

}  // namespace

void write_map(std::ostream& stream, const Map& map) try {
  TextOutput out(stream);
  out << std::uint64_t{map.vertex_count()} << ' ' << std::uint64_t{map.cycle_count()} << '\n';
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    write_point(out, map.points, v);
    out << '\n';
  }
  for (std::size_t c = 0; c < map.cycle_count(); ++c) write_cycle(out, map.cycle(c));
  out.flush();
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
