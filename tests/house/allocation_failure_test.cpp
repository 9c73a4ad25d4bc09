// Memory that runs out, at the n-th allocation of an operation, for n = 1, 2, 3 ... (beyond 300 in growing steps): an
// exception leaves the operation, what it took is given back, and the same call on the same operands then gives what it
// always gave.
//
// GMP and MPFR allocate by malloc and end the program when it fails; what they are asked for is bounded before
// (Limits). Everything else comes through operator new (generate/counted_memory.h).
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <new>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

#include "generate/counted_memory.h"
#include "plumb/base/error.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/minkowski.h"
#include "plumb/io/map_reader.h"
#include "plumb/io/map_report_text.h"
#include "plumb/io/nef3_writer.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/scene_reader.h"
#include "plumb/io/solid_io.h"
#include "plumb/io/solid_sets.h"
#include "plumb/plane/map_check.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_measure.h"
#include "plumb/space/space_shells.h"
#include "plumb/space/to_mesh.h"
#include "plumb/surface/surface.h"

namespace plumb::testing {
namespace {

// ---------------------------------------------------------------- what an operation gives

/// A sum over all that is written, without memory of its own.
class Digest : public std::streambuf, public std::ostream {
 public:
  Digest() : std::ostream(this) { exceptions(std::ios::badbit); }
  std::uint64_t value() const { return value_; }

 private:
  std::streambuf::int_type overflow(std::streambuf::int_type c) override {
    value_ = (value_ ^ static_cast<std::uint64_t>(c)) * 0x100000001b3U;
    return c;
  }
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

struct Operation {
  const char* name;
  std::function<std::uint64_t()> run;
};

std::uint64_t digest_of(const Nef2& set) {
  Context context;
  Digest out;
  PlaneText(set, PlaneFormat::Nef2, context).write(out);
  return out.value();
}

std::uint64_t digest_of(const Nef3& set) {
  Digest out;
  write_nef3(out, set.complex());
  return out.value();
}

// ---------------------------------------------------------------- the law

void expect_survival(const Operation& operation) {
  SCOPED_TRACE(operation.name);
  CountedMemory& memory = counted_memory();
  const std::uint64_t expected = operation.run();  // whatever is made once is made now
  const std::uint64_t before = memory.allocations;
  ASSERT_EQ(operation.run(), expected);
  const auto all = static_cast<std::int64_t>(memory.allocations - before);
  ASSERT_GT(all, 0);
  const std::int64_t held = memory.held;
  for (std::int64_t n = 0; n < all; n += 1 + n / 300) {
    bool threw = false;
    std::uint64_t got = expected;
    memory.left = n;
    try {
      got = operation.run();
    } catch (const std::bad_alloc&) {
      threw = true;
    } catch (const Error& error) {
      threw = error.code() == ErrorCode::ResourceLimit;
    }
    memory.left = -1;
    ASSERT_TRUE(threw || got == expected) << "allocation " << n << " of " << all;
    ASSERT_EQ(memory.held, held) << "allocation " << n << " of " << all;
  }
  EXPECT_EQ(operation.run(), expected);
}

std::string contents(const std::string& path) {
  std::FILE* const file = std::fopen(path.c_str(), "rb");
  EXPECT_NE(file, nullptr) << path;
  std::string text;
  for (int c = 0; file != nullptr && (c = std::fgetc(file)) != EOF;) {
    text.push_back(static_cast<char>(c));
  }
  if (file != nullptr) std::fclose(file);
  return text;
}

Nef3 solid(const std::string& path) {
  Context context;
  return read_solid_file(path, {}, context).set;
}

// ---------------------------------------------------------------- operations

TEST(AllocationFailure, Maps) {
  const std::string map = "6 3\n0 0\n2 0\n4 0\n4 3\n2 3\n0 3\n1 2 5 6\n2 3 4 5\n1 6 5 4 3 2\n";
  const std::string crossed = "5 2\n0 0\n4 0\n4 4\n0 4\n1 7\n1 2 3 4\n1 3 5\n";
  for (const std::string& text : {map, crossed}) {
    expect_survival({"check_map", [&] {
                       Context context;
                       Digest out;
                       write_map_report_text(out,
                                             check_map(read_map(text, {}, context), {}, context));
                       return out.value();
                     }});
  }
}

TEST(AllocationFailure, Plane) {
  Context context;
  const std::string wkt =
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (2 2, 2 4, 4 4, 2 2)), LINESTRING "
      "(1 -1, 8 "
      "10), POINT (20 20))";
  const std::string json =
      R"({"type": "Polygon", "coordinates": [[[1, 1], [12, 3], [5, 11], [1, 1]]]})";
  const Nef2 a = read_plane_set(wkt, PlaneFormat::Wkt, {}, context);
  const Nef2 b = read_plane_set(json, PlaneFormat::GeoJson, {}, context);
  const auto reads = [](const std::string& text, PlaneFormat format) {
    return [&text, format] {
      Context own;
      return digest_of(read_plane_set(text, format, {}, own));
    };
  };
  expect_survival({"read WKT", reads(wkt, PlaneFormat::Wkt)});
  expect_survival({"read GeoJSON", reads(json, PlaneFormat::GeoJson)});
  expect_survival({"union", [&] { return digest_of(a + b); }});
  expect_survival({"symmetric difference of complements", [&] { return digest_of(!a ^ b); }});
  expect_survival({"boundary", [&] { return digest_of(a.boundary()); }});
  expect_survival({"parts", [&] { return a.parts().polygons.size(); }});
  expect_survival({"locate", [&] {
                     const Nef2 fresh = a - b;
                     return static_cast<std::uint64_t>(fresh.contains(Point2{1, 1}));
                   }});
}

TEST(AllocationFailure, Readers) {
  for (const char* const path :
       {"corpus/solids/square-hole.obj", "corpus/solids/tetrahedron.stl",
        "corpus/solids/l-block.ply", "corpus/solids/tetrahedron.binary.stl",
        "corpus/solids/two-tetrahedra.off"}) {
    const std::string bytes = contents(path);
    expect_survival({path, [&] {
                       Context context;
                       return digest_of(read_solid(path, bytes, {}, context).set);
                     }});
  }
}

TEST(AllocationFailure, Space) {
  const Nef3 a = solid("corpus/solids/l-block.off");
  const Nef3 b = solid("corpus/solids/tetrahedron.off");
  const std::uint64_t of_a = digest_of(a);
  expect_survival({"difference", [&] { return digest_of(a - b); }});
  expect_survival({"union with an open complement", [&] { return digest_of(a + !b); }});
  expect_survival({"boundary", [&] { return digest_of(a.boundary()); }});
  expect_survival({"half-space", [&] {
                     return digest_of(Nef3::half_space({1, 1, 1, -1}, Boundary::Open) * a);
                   }});
  expect_survival({"mesh", [&] {
                     Context context;
                     Digest out;
                     write_mesh(out, mesh_of_complex((a + b).complex(), {}, context).mesh,
                                MeshFormat::Obj);
                     return out.value();
                   }});
  expect_survival({"locate", [&] {
                     const Nef3 fresh = a + b;
                     return static_cast<std::uint64_t>(fresh.contains(Point3{1, 1, 1}));
                   }});
  expect_survival({"shells", [&] { return SpaceShells(a.complex()).size(); }});
  EXPECT_EQ(digest_of(a), of_a);
}

TEST(AllocationFailure, Convex) {
  const Nef3 block = solid("corpus/solids/l-block.off");
  const Nef3 ball = solid("corpus/solids/tetrahedron.off");
  for (const DecomposeMethod method : {DecomposeMethod::Cuts, DecomposeMethod::Walls}) {
    expect_survival({"decompose", [&] {
                       Context context;
                       return decompose(block, {method}, context).pieces.size();
                     }});
  }
  expect_survival({"minkowski_sum", [&] {
                     Context context;
                     return digest_of(minkowski_sum(block, ball, context));
                   }});
}

TEST(AllocationFailure, Surface) {
  Context context;
  const SurfaceScene scene = read_scene_file("corpus/scenes/torus.json", {}, context).scene;
  expect_survival({"divide, select, borders", [&] {
                     Context own;
                     const SurfaceDivision division(scene, own);
                     const SurfaceResult result =
                         division.evaluate(parse_set_expression("A"), WindingRule::EvenOdd);
                     return result.region.cells + 100 * division.cell_count();
                   }});
}

}  // namespace
}  // namespace plumb::testing
