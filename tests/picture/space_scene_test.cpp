// Scenes of sets of space, and their images.

#include "plumb/picture/space_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/convex/decompose.h"
#include "plumb/picture/render.h"
#include "plumb/picture/scene_html.h"
#include "plumb/picture/space_svg.h"
#include "plumb/picture/svg/svg_text.h"
#include "plumb/picture/texture_image.h"
#include "plumb/predicates/error.h"
#include "plumb/space/source_mesh.h"
#include "plumb/space/space_measure.h"
#include "svg_checks.h"

namespace plumb::space_scene_test {
namespace {

using testing::expect_sound;

Nef3 cube(double low, double high, Boundary boundary = Boundary::Closed) {
  const std::vector<HalfSpace3> sides = {{{-1, 0, 0, low}, boundary}, {{1, 0, 0, -high}, boundary},
                                         {{0, -1, 0, low}, boundary}, {{0, 1, 0, -high}, boundary},
                                         {{0, 0, -1, low}, boundary}, {{0, 0, 1, -high}, boundary}};
  Context context;
  return Nef3::intersection(sides, context);
}

Scene scene(const Nef3& set) {
  Context context;
  return scene_of(set, context);
}

std::size_t count(const Scene& scene, Paint paint) {
  const auto is = [paint](const auto& item) { return item.paint == paint; };
  return static_cast<std::size_t>(std::ranges::count_if(scene.patches, is) +
                                  std::ranges::count_if(scene.lines, is) +
                                  std::ranges::count_if(scene.dots, is));
}

/// What the triangles enclose, in the coordinates of the set.
double volume(const Scene& scene) {
  double sum = 0;
  for (const Scene::Triangle& t : scene.triangles) {
    const Point3 &a = scene.points[t.corners[0]], &b = scene.points[t.corners[1]],
                 &c = scene.points[t.corners[2]];
    sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
  }
  return sum / 6 * std::pow(4 * scene.quarter_scale, 3);
}

TEST(SpaceScene, facets_enclose_the_volume_of_the_set) {
  for (const Nef3& set : {cube(-1, 3), cube(0, 3) - cube(1, 2), cube(1e6, 1e6 + 1),
                          cube(0, 2) + cube(1, 3), cube(0, 3, Boundary::Open)}) {
    const double exact = static_cast<double>(*marked_volume(set.complex()));
    EXPECT_NEAR(volume(scene(set)), exact, 1e-9 * exact);
  }
}

TEST(SpaceScene, tells_what_belongs_to_the_set) {
  const Scene closed = scene(cube(0, 1)), open = scene(cube(0, 1, Boundary::Open));
  EXPECT_EQ(count(closed, Paint::ClosedFacet), 6U);
  EXPECT_EQ(count(closed, Paint::Edge), 12U);
  EXPECT_EQ(count(open, Paint::OpenFacet), 6U);
  EXPECT_EQ(count(open, Paint::OpenEdge), 12U);
  EXPECT_TRUE(closed.dots.empty() && open.dots.empty()) << "corners as their edges are";
  const Scene bitten = scene(cube(0, 2) - cube(1, 3));
  EXPECT_EQ(count(bitten, Paint::OpenFacet), 3U);
  EXPECT_EQ(count(bitten, Paint::OpenEdge), 9U);
  const Scene skin = scene(cube(0, 1).boundary());
  EXPECT_EQ(count(skin, Paint::Sheet), 6U);
  const Scene parts = scene(Nef3::segment({0, 0, 0}, {1, 0, 0}) + Nef3::point({2, 2, 2}) +
                            (cube(4, 5) - Nef3::point({4, 4, 4})));
  EXPECT_EQ(count(parts, Paint::FreeEdge), 1U);
  EXPECT_EQ(count(parts, Paint::Point), 1U);
  EXPECT_EQ(count(parts, Paint::OpenPoint), 1U);
}

TEST(SpaceScene, cuts_what_has_no_end) {
  const Nef3 half = Nef3::half_space({1, 2, 2, -900}, Boundary::Closed);
  const Scene shown = scene(half);
  EXPECT_TRUE(shown.fades);
  EXPECT_EQ(count(shown, Paint::ClosedFacet), 1U);
  EXPECT_GE(count(shown, Paint::Cut), 3U);
  EXPECT_TRUE(shown.lines.empty()) << "no edge belongs to the set";
  const Scene wedge = scene(half * Nef3::half_space({1, -1, 0, 0}, Boundary::Open));
  EXPECT_EQ(count(wedge, Paint::OpenFacet), 1U);
  EXPECT_EQ(count(wedge, Paint::OpenEdge), 1U);
  const Scene rest = scene(!cube(0, 1));
  EXPECT_EQ(count(rest, Paint::OpenFacet), 6U);
  EXPECT_EQ(count(rest, Paint::Cut), 6U);
  const Scene plane = scene(Nef3::plane({0, 0, 1, 0}));
  EXPECT_EQ(count(plane, Paint::Sheet), 1U);
  EXPECT_EQ(count(plane, Paint::Cut), 0U);
}

TEST(SpaceScene, stays_in_its_box_whatever_the_coordinates) {
  for (const Nef3& set :
       {cube(-1e300, 1e300), cube(0, 5e-324), cube(1e15, 1e15 + 0.125), Nef3(), Nef3::whole(),
        Nef3::point({7, 8, 9}), !cube(1e200, 1e201), Nef3::plane({1, 1, 1, -1e100})}) {
    for (const Point3& p : scene(set).points) {
      for (const double x : {p.x, p.y, p.z}) EXPECT_LE(std::fabs(x), 1.000001);
    }
  }
}

/// The depth of the nearest triangle at every sample, found by trying all.
TEST(Canvas, shows_what_is_nearest) {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> in(-5, 45);
  const auto spot = [&] {
    const double x = in(random), y = in(random), z = in(random);
    return Spot{x, y, z};
  };
  std::vector<std::array<Spot, 3>> triangles;
  Canvas canvas(40, 30, {255, 255, 255});
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Spot a = spot(), b = spot(), c = spot();
    triangles.push_back({a, b, c});
    canvas.for_triangle(a, b, c, [&](std::size_t sample, const Spot& at) {
      canvas.put(sample, at.z, i, {0, 0, 0});
    });
  }
  const auto area = [](const Spot& a, const Spot& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  for (std::uint32_t j = 0; j < 30; ++j) {
    for (std::uint32_t i = 0; i < 40; ++i) {
      double nearest = -std::numeric_limits<double>::infinity();
      for (const auto& [a, b, c] : triangles) {
        const double x = i + .5, y = j + .5, all = area(a, b, c.x, c.y);
        const double u = area(b, c, x, y) / all, v = area(c, a, x, y) / all, w = 1 - u - v;
        if (std::min({u, v, w}) >= 0) nearest = std::max(nearest, u * a.z + v * b.z + w * c.z);
      }
      const double got = canvas.depth(j * 40 + i);
      EXPECT_TRUE(got == nearest || std::fabs(got - nearest) < 1e-3) << i << ' ' << j;
    }
  }
}

/// Neighbours share their side without a gap and without a sample twice.
TEST(Canvas, triangles_meet_without_gaps) {
  Canvas canvas(64, 64, {255, 255, 255});
  std::vector<int> visits(64 * 64);
  const Spot middle{31.7, 30.2, 0};
  const std::vector<Spot> ring{{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    canvas.for_triangle(middle, ring[i], ring[(i + 1) % 4],
                        [&](std::size_t sample, const Spot&) { ++visits[sample]; });
  }
  EXPECT_TRUE(std::ranges::all_of(visits, [](int n) { return n == 1; }));
}

TEST(Canvas, lines_are_hidden_by_what_is_nearer) {
  const auto inked = [](double depth) {
    Canvas canvas(40, 40, {255, 255, 255});
    canvas.for_triangle({0, 0, 10}, {80, 0, 10}, {0, 80, 10}, [&](std::size_t s, const Spot& at) {
      canvas.put(s, at.z, 0, {200, 200, 200});
    });
    const std::array<std::uint32_t, 2> none{Scene::kNoPatch, Scene::kNoPatch};
    canvas.line({5, 20, depth}, {35, 20, depth}, 3, none, {0, 0, 0},
                [](const Spot&) { return 1.; });
    const Image image = canvas.finish(1);
    return std::ranges::count(image.rgb, 0) / 3;
  };
  EXPECT_GE(inked(20), 60) << "two samples wide at least";
  EXPECT_EQ(inked(0), 0);
}

TEST(Render, a_camera_undoes_itself) {
  const Scene shown = scene(cube(0, 1) + cube(3, 4));
  const Camera camera(shown, 800, 600);
  for (const Point3& p : shown.points) {
    const Spot spot = camera.place(p);
    EXPECT_TRUE(spot.x > 0 && spot.x < 800 && spot.y > 0 && spot.y < 600);
    const Point3 back = camera.point_at(spot);
    EXPECT_NEAR(back.x, p.x, 1e-12);
    EXPECT_NEAR(back.y, p.y, 1e-12);
    EXPECT_NEAR(back.z, p.z, 1e-12);
  }
}

/// An image of an open set is orange where that of the closed one is blue, and the same elsewhere.
TEST(Render, marks_are_colours) {
  const auto reds = [](const Nef3& set) {
    const Image image = rendered(scene(set), {120, 90});
    EXPECT_EQ(image.rgb.size(), 3U * 120 * 90);
    std::size_t red = 0, blue = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
      red += image.rgb[i] > image.rgb[i + 2] + 20 ? 1 : 0;
      blue += image.rgb[i + 2] > image.rgb[i] + 20 ? 1 : 0;
    }
    return std::pair(red, blue);
  };
  const auto [open_red, open_blue] = reds(cube(0, 1, Boundary::Open));
  const auto [red, blue] = reds(cube(0, 1));
  EXPECT_EQ(red, 0U);
  EXPECT_EQ(open_blue, 0U);
  EXPECT_GT(blue, 2000U);
  EXPECT_GT(open_red, 2000U);
}

TEST(SpaceSvg, is_sound_and_says_what_the_set_is) {
  for (const Nef3& set : {cube(0, 1), !cube(0, 1), Nef3(), Nef3::whole(), cube(0, 1).boundary()}) {
    std::ostringstream out;
    Context context;
    write_space_svg(out, set, scene(set), "no image", "a <set>", context);
    expect_sound(out.str());
    EXPECT_NE(out.str().find(kind_of(set)), std::string::npos);
    EXPECT_NE(out.str().find("a &lt;set&gt;"), std::string::npos);
  }
  EXPECT_EQ(kind_of(cube(0, 1) - cube(0, .5)), "bounded, partly open");
  EXPECT_EQ(facts_of(cube(0, 1)), "8 vertices, 12 edges, 6 facets, 2 volumes, volume 1");
}

/// The test vectors of RFC 4648.
TEST(Base64, is_that_of_the_standard) {
  const std::vector<std::pair<std::string, std::string>> cases{{"", ""},
                                                               {"f", "Zg=="},
                                                               {"fo", "Zm8="},
                                                               {"foo", "Zm9v"},
                                                               {"foob", "Zm9vYg=="},
                                                               {"fooba", "Zm9vYmE="},
                                                               {"foobar", "Zm9vYmFy"},
                                                               {"\xff\xfe", "//4="}};
  for (const auto& [bytes, text] : cases) EXPECT_EQ(base64(bytes), text);
}

TEST(PiecesScene, moves_pieces_away_from_the_middle_and_keeps_their_volume) {
  Context context;
  const std::vector<Nef3> pieces = {cube(0, 1), cube(1, 2, Boundary::Open), Nef3(), cube(2, 4)};
  const Scene together = exploded_scene(pieces, 0, context);
  const Scene apart = exploded_scene(pieces, .5, context);
  for (const Scene* s : {&together, &apart}) {
    EXPECT_NEAR(volume(*s), 1 + 1 + 8, 1e-9);
    EXPECT_EQ(s->groups.size(), 4U);
    EXPECT_EQ(count(*s, Paint::OpenFacet), 6U);
    EXPECT_FALSE(s->legend()[static_cast<std::size_t>(Paint::OpenFacet)])
        << "has its piece's colour";
    EXPECT_TRUE(s->legend()[static_cast<std::size_t>(Paint::OpenEdge)]);
    for (const Point3& p : s->points) {
      EXPECT_LE(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), 1 + 1e-12);
    }
  }
  // Middles were 0.5, 1.5, 3 and are half as far again from 2; the widest cube goes from 2.5 to
  // 4.5.
  EXPECT_NEAR(4 * together.quarter_scale, 2, 1e-12);
  EXPECT_NEAR(4 * apart.quarter_scale, (4.5 + .75) / 2, 1e-12);
  std::set<Colour> colours;
  for (const Scene::Patch& p : apart.patches) colours.insert(apart.colour_of(p));
  EXPECT_EQ(colours.size(), 3U);
  EXPECT_THROW(exploded_scene(std::vector{Nef3::whole()}, 0, context), Error);
  EXPECT_THROW(exploded_scene(pieces, -1, context), Error);
}

TEST(PiecesScene, hatches_what_cuts_made) {
  Context context;
  std::size_t seen = 0;  // of six sides three
  for (std::size_t wall = 0; wall < 6; ++wall) {
    std::vector<std::uint32_t> origins(6, 7);
    origins[wall] = kWallOrigin;
    Scene scene = exploded_scene(std::vector{cube(0, 1).with_origins(origins)}, 0, context);
    EXPECT_EQ(std::ranges::count_if(scene.patches, &Scene::Patch::is_hatched), 1);
    const Image hatched = rendered(scene);
    for (Scene::Patch& p : scene.patches) p.is_hatched = false;
    seen += hatched.rgb != rendered(scene).rgb ? 1 : 0;
  }
  EXPECT_EQ(seen, 3U);
  const Nef3 inner = cube(0, 1).with_origins(std::vector<std::uint32_t>(6, kWallOrigin));
  const Scene scene = exploded_scene(std::vector{inner}, 0, context);
  EXPECT_TRUE(std::ranges::all_of(scene.patches, &Scene::Patch::is_hatched)) << "amid others";
  const Scene alone = scene_of(inner, context);
  EXPECT_TRUE(std::ranges::none_of(alone.patches, &Scene::Patch::is_hatched));
}

// What a Boolean with a half-space cuts off has no id either.
TEST(PiecesScene, hatches_no_facets_without_ids) {
  Context context;
  const Plane3 plane{1, 1, 1, -1};
  for (const Nef3& set :
       {boolean_op(cube(0, 1), plane, Section::ClosedHalfSpace, kIntersection, context),
        cube(0, 1).with_origins(std::vector<std::uint32_t>(6, kNoOrigin))}) {
    const Scene scene = exploded_scene(std::vector{set}, 0, context);
    EXPECT_TRUE(std::ranges::none_of(scene.patches, &Scene::Patch::is_hatched));
  }
}

// ---------------------------------------------------------------- colours

/// A cube whose faces are a checkerboard of unit squares, in two materials.
Nef3 checkered_cube(int n) {
  MeshSource source;
  std::map<std::array<int, 3>, std::uint32_t> index;
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          std::vector<std::uint32_t>& face = faces.emplace_back();
          for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = i + a;
            at[(axis + 2) % 3] = j + b;
            const auto next = static_cast<std::uint32_t>(source.mesh.points.size());
            const auto [entry, is_new] = index.emplace(at, next);
            if (is_new) {
              source.mesh.points.push_back({static_cast<double>(at[0]), static_cast<double>(at[1]),
                                            static_cast<double>(at[2])});
            }
            face.push_back(entry->second);
          }
          if (side == 0) std::ranges::reverse(face);
          source.attributes.face_material.push_back(static_cast<std::uint32_t>((i + j) % 2));
        }
      }
    }
  }
  for (const auto& face : faces) source.mesh.add_face(face);
  source.attributes.materials = {{"white", {{1, 1, 1, 1}}, {}}, {"red", {{1, 0, 0, 1}}, {}}};
  return from_source(std::make_shared<const MeshSource>(std::move(source)));
}

/// The area of the triangles of each colour, in the coordinates of the set.
std::map<Colour, double> areas(const Scene& scene) {
  std::map<Colour, double> sums;
  for (const Scene::Triangle& t : scene.triangles) {
    const Point3 &a = scene.points[t.corners[0]], &b = scene.points[t.corners[1]],
                 &c = scene.points[t.corners[2]];
    const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    sums[scene.colour_of(scene.patches[t.patch])] +=
        std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2 *
        std::pow(4 * scene.quarter_scale, 2);
  }
  return sums;
}

// Cutting off a corner along unit squares leaves whole squares, and three walls of the other set.
TEST(ColouredScene, has_each_colour_on_the_area_of_its_faces) {
  Context context;
  const Nef3 set = checkered_cube(4);
  const Colour white{255, 255, 255}, red{255, 0, 0};
  const Colour plain = style_of(Paint::ClosedFacet).colour;
  const std::map<Colour, double> before = areas(coloured_scene(set, context));
  EXPECT_NEAR(before.at(white), 48, 1e-9);
  EXPECT_NEAR(before.at(red), 48, 1e-9);
  const Scene cut = coloured_scene(set - cube(2, 5), context);
  const std::map<Colour, double> after = areas(cut);
  EXPECT_NEAR(after.at(white), 42, 1e-9);
  EXPECT_NEAR(after.at(red), 42, 1e-9);
  EXPECT_NEAR(after.at(plain), 12, 1e-9);
  EXPECT_NEAR(volume(cut), 64 - 8, 1e-9);
  EXPECT_EQ(count(cut, Paint::Edge) + count(cut, Paint::OpenEdge),
            count(scene(set - cube(2, 5)), Paint::Edge) +
                count(scene(set - cube(2, 5)), Paint::OpenEdge));
}

// JPEG files have their size in a segment somewhere behind the start; PNG files in the first chunk.
TEST(TextureImage, types_and_sizes_are_read_and_bounded) {
  const auto jpeg = [](std::string_view width) {
    return std::string("\xff\xd8\xff\xe0\0\4ab\xff\xff\xc4\0\3x\xff\xc2\0\x0b\x08\0\2", 21) +
           std::string(width) + std::string(8, '\0');
  };
  EXPECT_EQ(texture_image(jpeg({"\0\3", 2})).type, "image/jpeg");
  const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1", 24);
  EXPECT_EQ(texture_image(png).type, "image/png");
  EXPECT_EQ(texture_image(png).bytes, png);
  const auto refused = [](std::string bytes) {
    EXPECT_THROW(texture_image(std::move(bytes)), Error);
  };
  refused(jpeg("\x40\1"));
  refused(jpeg({"\0\0", 2}));
  for (std::size_t size = 0; size < 24; ++size) refused(png.substr(0, size));
  for (std::size_t size = 0; size < 23; ++size) refused(jpeg("\1\1").substr(0, size));
  refused(std::string(png).replace(19, 1, 1, '\0'));
  refused("GIF89a, which browsers draw");
}

TEST(ColouredScene, shows_what_has_no_colours_as_before) {
  Context context;
  const Nef3 set = cube(0, 1);
  EXPECT_FALSE(has_colours(set));
  EXPECT_TRUE(coloured_scene(set, context).layers.empty());
  EXPECT_TRUE(has_colours(checkered_cube(1)));
  EXPECT_TRUE(coloured_scene(checkered_cube(1).complement(), context).layers.empty())
      << "an unbounded set is cut by its window";
}

TEST(PiecesScene, refuses_to_move_pieces_beyond_doubles) {
  Context context;
  const std::vector<Nef3> pieces = {cube(-2e303, -1e303), cube(1e303, 2e303)};
  EXPECT_THROW(exploded_scene(pieces, 1e6, context), Error);
  for (const Point3& p : exploded_scene(pieces, 1e3, context).points) {
    EXPECT_LE(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), 1 + 1e-12);
  }
}

}  // namespace
}  // namespace plumb::space_scene_test
