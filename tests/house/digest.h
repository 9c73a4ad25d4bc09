// Sums over results, made without memory of their own.
#pragma once

#include <cstdint>
#include <ostream>
#include <streambuf>

#include "plumb/io/map_report_text.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/plane/map_check.h"
#include "plumb/space/nef3.h"
#include "plumb/sphere/nef_sphere.h"

namespace plumb::testing {

/// A stream that adds up what is written.
class Digest : public std::streambuf, public std::ostream {
 public:
  Digest() : std::ostream(this) { exceptions(std::ios::badbit); }
  std::uint64_t value() const { return value_; }

  void add(std::uint64_t number) { value_ = (value_ ^ number) * 0x100000001b3U; }

 private:
  std::streambuf::int_type overflow(std::streambuf::int_type c) override {
    add(static_cast<std::uint64_t>(c));
    return c;
  }
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

inline std::uint64_t digest_of(const Nef2& set, Context& context) {
  Digest out;
  PlaneText(set, PlaneFormat::Nef2, context).write(out);
  return out.value();
}

inline std::uint64_t digest_of(const Nef3& set) {
  Digest out;
  write_nef3(out, set.complex());
  return out.value();
}

inline std::uint64_t digest_of(const NefSphere& set) {
  Digest out;
  const SphereMap& map = set.map();
  for (const auto* marks : {&map.point_mark, &map.arc_mark, &map.face_mark}) {
    out.add(marks->size());
    for (const Mark mark : *marks) out.add(mark);
  }
  return out.value();
}

inline std::uint64_t digest_of(const MapReport& report) {
  Digest out;
  write_map_report_text(out, report);
  return out.value();
}

}  // namespace plumb::testing
