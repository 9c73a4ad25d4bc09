// What programs that embed the library rely on: const members called from several threads at once.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "plumb/base/set_expression.h"
#include "plumb/io/scene_reader.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/surface/surface.h"

namespace plumb::testing {
namespace {

using Doubles = std::vector<double>;
using Indices = std::vector<std::uint32_t>;

const Doubles kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const Indices kTriangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

Nef3 tetrahedron(double shift) {
  Doubles moved = kCorners;
  for (double& x : moved) x += shift;
  Context context;
  return Nef3::mesh(mesh_of_triangles(moved, kTriangles), WindingRule::Positive, context);
}

/// The same value in every one of four threads that ask at the same time as for one that asks alone.
template <class Set>
void expect_same_from_threads(const std::function<Set()>& make,
                              const std::function<std::string(const Set&)>& ask) {
  const std::string expected = ask(make());
  for (int round = 0; round < 20; ++round) {
    const Set shared = make();  // what is built on demand is not there yet
    std::vector<std::string> answers(4);
    std::vector<std::thread> threads;
    for (std::string& answer : answers) {
      threads.emplace_back([&shared, &answer, &ask] {
        const Set copy = shared;
        answer = ask(shared);
        if (!(copy == shared)) answer += " unequal";
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::string& answer : answers) EXPECT_EQ(answer, expected);
  }
}

char digit(bool value) { return value ? '1' : '0'; }

TEST(Threads, may_share_a_set_of_space) {
  const Nef3 set = tetrahedron(0) - tetrahedron(.25);
  expect_same_from_threads<Nef3>(
      [&] {
        return (set + Nef3::point({2, 2, 2})) * !Nef3::point({0, 0, 0});
      },
      [](const Nef3& s) {
        std::string answer{digit(s.is_convex()), digit(s.is_closed()), digit(s.is_simple()),
                           digit(s.is_bounded())};
        for (double t = -.25; t <= 2; t += .125) {
          answer += digit(s.contains(Point3{t, t, t}));
          answer += digit(s.has_on_boundary(Point3{t, .125, 0}));
        }
        const auto hit = s.shoot_to_boundary({-1, 0, 0}, {1, 0, 0});
        answer += hit ? hit->point.x.str() : "none";
        answer += digit((s * s) == s);
        return answer + digit(s <= s.closure());
      });
}

TEST(Threads, may_share_a_set_of_the_plane) {
  expect_same_from_threads<Nef2>(
      [] {
        const Line2 x_axis{{0, 0}, {1, 0}}, y_axis{{0, 1}, {0, 0}};
        return Nef2::half_plane(x_axis, Boundary::Closed) *
               Nef2::half_plane(y_axis, Boundary::Open);
      },
      [](const Nef2& s) {
        std::string answer{digit(s.is_closed()), digit(s.is_open())};
        for (double t = -1; t <= 1; t += .25) {
          answer += digit(s.contains(Point2{t, 0}));
          answer += digit(s.contains(Point2{t, t}));
        }
        return answer + digit((s + s) == s);
      });
}

TEST(Threads, may_share_a_set_of_the_sphere) {
  expect_same_from_threads<NefSphere>(
      [] {
        return NefSphere::half_sphere({0, 0, 1}, Boundary::Closed) *
               NefSphere::half_sphere({0, 1, 0}, Boundary::Open);
      },
      [](const NefSphere& s) {
        std::string answer{digit(s.is_closed()), digit(s.is_open())};
        for (double t = -1; t <= 1; t += .25) {
          answer += digit(s.contains({1, t, 0}));
          answer += digit(s.contains({1, 0, t}));
        }
        return answer + digit((s + s) == s);
      });
}

TEST(Threads, may_share_a_divided_surface) {
  Context context;
  const SurfaceDivision division(read_scene_file("corpus/scenes/torus.json", {}, context).scene,
                                 context);
  const auto ask = [&division] {
    std::string answer;
    for (const char* text : {"A + B * !C", "A ^ C", "!(A - B)"}) {
      const SurfaceResult result =
          division.evaluate(parse_set_expression(text), WindingRule::EvenOdd);
      answer += std::to_string(result.region.cells) + ' ' + std::to_string(result.borders.size());
      for (const std::uint8_t selected : result.region.is_selected) answer += digit(selected != 0);
    }
    return answer;
  };
  const std::string expected = ask();
  std::vector<std::string> answers(4);
  {
    std::vector<std::jthread> threads;
    for (std::string& answer : answers) threads.emplace_back([&] { answer = ask(); });
  }
  for (const std::string& answer : answers) EXPECT_EQ(answer, expected);
}

}  // namespace
}  // namespace plumb::testing
