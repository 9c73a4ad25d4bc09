// What programs that embed the library rely on: const members called from several threads at once.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "plumb/base/set_expression.h"
#include "plumb/io/scene_reader.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/local_maps.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_locator.h"
#include "plumb/sphere/nef_sphere.h"
#include "plumb/sphere/sphere_audit.h"
#include "plumb/surface/exponential_map.h"
#include "plumb/surface/surface.h"

namespace plumb::testing::embedding_test {
namespace {

using Doubles = std::vector<double>;
using Indices = std::vector<std::uint32_t>;

const Doubles kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const Indices kTriangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

Nef3 tetrahedron(double shift) {
  Doubles moved = kCorners;
  for (double& x : moved) x += shift;
  Context context;
  return Nef3::from_mesh(mesh_of_triangles(moved, kTriangles), {.rule = WindingRule::Positive},
                         context);
}

/// What four threads hear that ask at the same time.
std::vector<std::string> answers_of_threads(const std::function<std::string()>& ask) {
  std::vector<std::string> answers(4);
  {
    std::vector<std::jthread> threads;
    for (std::string& answer : answers) threads.emplace_back([&] { answer = ask(); });
  }
  return answers;
}

/// The same value in every one of four threads that ask at the same time as for one that asks
/// alone.
template <class Set>
void expect_same_from_threads(const std::function<Set()>& make,
                              const std::function<std::string(const Set&)>& ask) {
  const std::string expected = ask(make());
  for (int round = 0; round < 20; ++round) {
    const Set shared = make();  // what is built on demand is not there yet
    const auto answers = answers_of_threads([&] {
      const Set copy = shared;
      return ask(shared) + (copy == shared ? "" : " unequal");
    });
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
        return answer + digit(s.is_subset_of(s.closure()));
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
          const auto hit = s.shoot_to_boundary({-1, t}, {1, 0});
          answer += hit ? hit->point.x.str() : "none";
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
          answer += digit(s.shoot_to_boundary({t, 1, 1}, {t, -1, -2}).has_value());
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
  for (const std::string& answer : answers_of_threads(ask)) EXPECT_EQ(answer, expected);
}

TEST(Threads, may_share_a_locator_of_space) {
  const Nef3 set = (tetrahedron(0) - tetrahedron(.25)) + tetrahedron(3);
  const SpaceComplex& complex = set.complex();
  const auto ask = [&complex](const SpaceLocator& locator) {
    std::string answer;
    for (double t = -.25; t <= 4; t += .125) {
      answer += std::to_string(locator.locate(Point3{t, .125, t}).code()) + ' ';
      answer += std::to_string(locator.locate(RationalPoint3{t, 0, 0}).code()) + ' ';
      const auto hit = locator.shoot(Point3{-1, t, .0625}, Point3{1, 0, 0});
      answer += hit ? hit->point.x.str() + ' ' : "none ";
    }
    for (const SpacePoint p : complex.vertex_point) {
      answer += std::to_string(locator.shoot_left(p).code()) + ' ';
    }
    return answer;
  };
  const std::string expected = ask(SpaceLocator(complex));
  for (int round = 0; round < 20; ++round) {
    const SpaceLocator shared(complex);  // grids are not there yet
    for (const std::string& answer : answers_of_threads([&] { return ask(shared); })) {
      EXPECT_EQ(answer, expected);
    }
  }
}

/// The sphere maps around all items of a complex, and what audits say.
std::string local_maps_of(const SpaceComplex& complex) {
  std::string answer{digit(audit(complex, AuditForm::Minimal).has_value())};
  LocalMap local;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    local_map(complex, VertexId(v), local);
    answer += digit(audit(complex.planes(), local.map, AuditForm::Minimal).has_value());
    for (const std::uint32_t p : local.map.origin) answer += std::to_string(p) + ' ';
  }
  return answer;
}

TEST(Threads, may_share_a_complex_and_its_sphere_maps) {
  const Nef3 set = (tetrahedron(0) - tetrahedron(.25)) + tetrahedron(3);
  const std::string expected = local_maps_of(set.complex());
  for (const auto& answer : answers_of_threads([&] { return local_maps_of(set.complex()); })) {
    EXPECT_EQ(answer, expected);
  }
}

TEST(Threads, may_share_a_map_and_its_half_edges) {
  Map map;
  for (const Point2 p : {Point2{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {2, 3}}) {
    map.points.push_back(p);
  }
  map.add_cycle(Indices{0, 1, 2, 3});
  map.add_cycle(Indices{3, 2, 1, 0});
  map.add_cycle(Indices{4, 5, 6});
  map.add_cycle(Indices{6, 5, 4});
  Context context;
  const MapReport report = check_map(std::move(map), {}, context);
  const Dcel shared = to_dcel(report).dcel;
  const auto ask = [&] {
    std::string answer{digit(shared.audit().has_value()), digit(shared.audit_planar().has_value())};
    for (std::uint32_t h = 0; h < shared.halfedge_slots(); ++h) {
      answer += std::to_string(shared.face(HalfedgeId(h)).value()) + ' ';
      for (const HalfedgeId next : shared.along(shared.loop(HalfedgeId(h)))) {
        answer += std::to_string(next.value()) + ' ';
      }
    }
    return answer + std::to_string(to_dcel(report).dcel.face_count()) +
           digit(orient2d(report.map.points, 4, 5, 6) == Sign::Positive);
  };
  const std::string expected = ask();
  EXPECT_EQ(expected.substr(0, 2), "00");
  for (const std::string& answer : answers_of_threads(ask)) EXPECT_EQ(answer, expected);
}

TEST(Threads, may_share_a_mesh_as_a_surface) {
  Context context;
  const auto mesh = read_scene_file("corpus/scenes/torus.json", {}, context).scene.mesh;
  SurfacePointTable centre(*mesh);
  const SurfacePointId middle = centre.add_in_face(FaceId(0), .25, .25);
  const ExponentialMap map(centre, middle, FaceId(0), 30);
  const auto ask = [&] {
    std::string answer;
    for (std::uint32_t h = 0; h < 3 * mesh->face_count(); ++h) {
      answer += std::to_string(mesh->twin(HalfedgeId(h)).value()) + ' ';
      answer += std::to_string(mesh->lower(mesh->edge(HalfedgeId(h))).value()) + ' ';
    }
    Context own;
    SurfacePointTable points(*mesh);
    for (double t = -.5; t <= .5; t += .125) {
      const auto at = map.add({t, .25}, points, own);
      answer += at ? std::to_string(points.position(*at).x) + ' ' : "none ";
    }
    return answer;
  };
  const std::string expected = ask();
  for (const std::string& answer : answers_of_threads(ask)) EXPECT_EQ(answer, expected);
}

}  // namespace
}  // namespace plumb::testing::embedding_test
