#include "plumb/testing/small_maps.h"

#include <ostream>
#include <sstream>

namespace plumb::testing {
namespace {

constexpr OuterRule kListed = OuterRule::Listed;
constexpr OuterRule kInfer = OuterRule::Infer;
constexpr OuterRule kIgnore = OuterRule::Ignore;
constexpr MapVerdict kValid = MapVerdict::Valid;
constexpr MapVerdict kNotPlanar = MapVerdict::NotAPlanarSubdivision;
constexpr MapVerdict kOpen = MapVerdict::Open;
constexpr MapVerdict kSuperposed = MapVerdict::Superposed;

// Points of two unit squares side by side: 1 2 3 below, 4 5 6 above.
const std::string kTwoSquares = "0 0\n1 0\n2 0\n0 1\n1 1\n2 1\n";
// A big square 1-4 and a small one 5-8 inside it.
const std::string kRing = "0 0\n9 0\n9 9\n0 9\n3 3\n6 3\n6 6\n3 6\n";
// Two triangles 1 2 3 and 3 4 5 that share vertex 3 only.
const std::string kButterfly = "0 0\n2 0\n1 1\n2 2\n0 2\n";

std::vector<SmallMap> simple_cases() {
  return {
      {"triangle and its outer cycle", "3 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1", kListed, false, kValid,
       0, 0, 0, 0, 0, 0, 1},
      {"triangle alone", "3 1\n0 0\n1 0\n0 1\n1 2 3", kListed, false, kOpen, 0, 3, 0, 0, -1, 0, 1},
      {"triangle alone, outer inferred", "3 1\n0 0\n1 0\n0 1\n1 2 3", kInfer, false, kValid, 0, 0,
       0, 0, 0, 0, 1},
      {"triangle alone, outer ignored", "3 1\n0 0\n1 0\n0 1\n1 2 3", kIgnore, false, kValid, 0, 0,
       0, 0, 0, 0, 1},
      {"clockwise triangle alone, outer ignored", "3 1\n0 0\n1 0\n0 1\n3 2 1", kIgnore, false,
       kValid, 0, 0, 0, 0, 0, 0, 1},
      {"both cycles counter-clockwise", "3 2\n0 0\n1 0\n0 1\n1 2 3\n2 3 1", kListed, false,
       kNotPlanar, 3, 3, 0, 0, -1, 0, 1},
      {"three times the same", "3 3\n0 0\n1 0\n0 1\n1 2 3\n2 3 1\n3 1 2", kListed, false,
       kNotPlanar, 6, 3, 0, 0, -1, 0, 1},
      {"two squares", "6 3\n" + kTwoSquares + "1 2 5 4\n2 3 6 5\n1 4 5 6 3 2", kListed, false,
       kValid, 0, 0, 0, 0, 0, 0, 1},
      {"two squares, outer missing", "6 2\n" + kTwoSquares + "1 2 5 4\n2 3 6 5", kListed, false,
       kOpen, 0, 6, 0, 0, -1, 0, 1},
      {"two squares, one flipped", "6 3\n" + kTwoSquares + "1 2 5 4\n2 5 6 3\n1 4 5 6 3 2", kListed,
       false, kNotPlanar, 4, 4, 0, 0, -1, 0, 1},
      {"an isolated vertex", "4 2\n0 0\n3 0\n0 3\n1 1\n1 2 3\n3 2 1", kListed, false, kValid, 0, 0,
       0, 0, 0, 0, 1},
      {"reversed everything", "6 3\n" + kTwoSquares + "4 5 2 1\n5 6 3 2\n2 3 6 5 4 1", kListed,
       false, kSuperposed, 0, 0, 0, 0, 2, 0, 1},
      {"a face with a spike", "4 2\n0 0\n9 0\n0 9\n1 1\n1 4 1 2 3\n3 2 1", kListed, false,
       kSuperposed, 0, 0, 0, 1, 0, 0, 1},
      {"an edge alone, both sides in one face", "3 1\n0 0\n1 0\n3 1\n1 2 3 2", kListed, false,
       kSuperposed, 0, 0, 0, 2, 0, 0, 1},
  };
}

std::vector<SmallMap> crossing_cases() {
  return {
      {"bow-tie of area zero", "4 2\n0 0\n2 2\n2 0\n0 2\n1 2 3 4\n4 3 2 1", kListed, false,
       kSuperposed, 0, 0, 1, 0, -1, 0, 1},
      {"two triangles crossing", "6 4\n0 0\n4 0\n2 4\n0 3\n4 3\n2 -1\n1 2 3\n3 2 1\n4 6 5\n5 6 4",
       kListed, false, kSuperposed, 0, 0, 6, 0, -1, 0, 2},
      {"a vertex on a foreign edge",
       "6 4\n0 0\n4 0\n4 4\n4 2\n8 1\n8 3\n1 2 3\n3 2 1\n4 5 6\n6 5 4", kListed, false, kSuperposed,
       0, 0, 2, 0, -1, 0, 2},
      {"T-junction", "7 3\n" + kTwoSquares + "1 1/2\n1 2 5 4\n2 3 6 5 7\n1 4 5 6 3 2", kListed,
       false, kOpen, 0, 3, 2, 0, -1, 0, 1},
      {"T-junction, both sides know it",
       "7 3\n" + kTwoSquares + "1 1/2\n1 2 7 5 4\n2 3 6 5 7\n1 4 5 6 3 2", kListed, false, kValid,
       0, 0, 0, 0, 0, 0, 1},
      {"overlap from a common vertex", "5 4\n0 0\n4 0\n0 4\n2 0\n0 -2\n1 2 3\n3 2 1\n1 5 4\n4 5 1",
       kListed, false, kSuperposed, 0, 0, 2, 0, -1, 0, 1},
      {"two ids for one place", "6 4\n0 0\n1 0\n0 1\n0 0\n-1 0\n0 -1\n1 2 3\n3 2 1\n4 5 6\n6 5 4",
       kListed, false, kSuperposed, 0, 0, 4, 0, -1, 0, 2},
      {"two ids for one place, merged",
       "6 4\n0 0\n1 0\n0 1\n0 0\n-1 0\n0 -1\n1 2 3\n3 2 1\n4 5 6\n6 5 4", kListed, true, kValid, 0,
       0, 0, 0, 0, 0, 1},
      {"faces crossing exactly at vertices",
       "8 4\n0 0\n4 0\n4 4\n0 4\n2 0\n6 2\n2 4\n9 9\n"
       "1 5 2 3 7 4\n4 7 3 2 5 1\n5 6 7\n7 6 5",
       kListed, false, kSuperposed, 0, 0, 2, 0, -1, 0, 1},
  };
}

std::vector<SmallMap> nesting_cases() {
  return {
      {"island", "8 4\n" + kRing + "1 2 3 4\n4 3 2 1\n5 6 7 8\n8 7 6 5", kListed, false, kValid, 0,
       0, 0, 0, 0, 0, 2},
      {"island without its outer cycle", "8 3\n" + kRing + "1 2 3 4\n4 3 2 1\n5 6 7 8", kListed,
       false, kOpen, 0, 4, 0, 0, -1, 0, 2},
      {"island, outer cycles inferred", "8 2\n" + kRing + "1 2 3 4\n5 6 7 8", kInfer, false, kValid,
       0, 0, 0, 0, 0, 0, 2},
      {"nested, outer cycles ignored", "8 2\n" + kRing + "1 2 3 4\n5 6 7 8", kIgnore, false,
       kSuperposed, 0, 0, 0, 0, 0, 1, 2},
      {"island among ignored outer cycles", "8 3\n" + kRing + "1 2 3 4\n5 6 7 8\n8 7 6 5", kIgnore,
       false, kValid, 0, 0, 0, 0, 0, 0, 2},
      {"frame and hole with nothing in it", "8 3\n" + kRing + "1 2 3 4\n4 3 2 1\n8 7 6 5", kListed,
       false, kOpen, 0, 4, 0, 0, -1, 0, 2},
      {"three islands deep",
       "12 6\n" + kRing +
           "4 4\n5 4\n5 5\n4 5\n1 2 3 4\n4 3 2 1\n5 6 7 8\n8 7 6 5\n"
           "9 10 11 12\n12 11 10 9",
       kListed, false, kValid, 0, 0, 0, 0, 0, 0, 3},
      {"a slit outside its face, ignored outer cycle as long as the face",
       "4 1\n1 0\n2 2\n0 2\n0 1\n4 1 2 4 3", kIgnore, false, kSuperposed, 0, 0, 0, 1, 1, 0, 1},
      {"nested twice, ignored",
       "12 3\n" + kRing + "4 4\n5 4\n5 5\n4 5\n1 2 3 4\n5 6 7 8\n9 10 11 12", kIgnore, false,
       kSuperposed, 0, 0, 0, 0, 0, 2, 3},
  };
}

std::vector<SmallMap> pinch_cases() {
  return {
      {"butterfly, one outer cycle", "5 3\n" + kButterfly + "1 2 3\n3 4 5\n1 3 5 4 3 2", kListed,
       false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"butterfly, two outer cycles", "5 4\n" + kButterfly + "1 2 3\n3 4 5\n3 2 1\n5 4 3", kListed,
       false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"butterfly, both wings in one cycle", "5 2\n" + kButterfly + "1 2 3 4 5 3\n1 3 5 4 3 2",
       kListed, false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"butterfly, one wing turned", "5 2\n" + kButterfly + "1 2 3 5 4 3\n1 3 4 5 3 2", kListed,
       false, kSuperposed, 0, 0, 0, 0, 3, 0, 1},
      {"beyond 2^53",
       "3 2\n9007199254740993 0\n9007199254740994 0\n9007199254740993 1\n1 2 3\n3 2 1", kListed,
       false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"touching by a fraction", "6 4\n0 0\n3 1\n0 1\n1 1/3\n2 0\n3 0\n1 2 3\n3 2 1\n4 5 6\n6 5 4",
       kListed, false, kSuperposed, 0, 0, 2, 0, -1, 0, 2},
  };
}

// A square 1-5 with vertex 2 on its lower side, and a triangle 2 6 7 inside of it.
const std::string kTouch = "0 0\n5 0\n10 0\n10 10\n0 10\n7 4\n3 4\n";
// The same with vertices 2 and 5 on two sides, and a diamond 2 7 5 8 between them.
const std::string kTouchTwice = "0 0\n5 0\n10 0\n10 10\n5 10\n0 10\n7 5\n3 5\n";
// Triangles 1 4 2, 2 5 3 and 3 6 1 around the triangle 1 2 3.
const std::string kThreeAround = "0 0\n4 0\n2 3\n2 -2\n5 3\n-1 3\n";
// Two neighbours 1 2 3 4 5 and 2 6 7 4 8 that bulge over each other between vertices 2 and 4.
const std::string kLens = "0 0\n10 0\n12 5\n10 10\n0 10\n20 0\n20 10\n8 5\n";

std::vector<SmallMap> touching_cases() {
  const std::string shell = "1 2 3 4 5\n", outer = "5 4 3 2 1";
  return {
      {"hole that touches its shell", "7 4\n" + kTouch + shell + "7 6 2\n2 6 7\n" + outer, kListed,
       false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"hole that touches its shell, in one cycle",
       "7 3\n" + kTouch + "1 2 7 6 2 3 4 5\n2 6 7\n" + outer, kListed, false, kValid, 0, 0, 0, 0, 0,
       0, 1},
      {"hole that touches its shell, not listed", "7 3\n" + kTouch + shell + "2 6 7\n" + outer,
       kListed, false, kOpen, 0, 3, 0, 0, -1, 0, 1},
      {"hole that touches its shell, inferred", "7 2\n" + kTouch + shell + "2 6 7", kInfer, false,
       kValid, 0, 0, 0, 0, 0, 0, 1},
      {"hole that touches its shell, outer boundary ignored",
       "7 3\n" + kTouch + shell + "7 6 2\n2 6 7", kIgnore, false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"hole along an edge of its shell", "7 4\n" + kTouch + shell + "2 1 7\n1 2 7\n" + outer,
       kListed, false, kNotPlanar, 2, 0, 0, 0, -1, 0, 1},
      {"hole that touches its shell, turned", "7 4\n" + kTouch + shell + "2 6 7\n7 6 2\n" + outer,
       kListed, false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"hole that touches its shell twice",
       "8 4\n" + kTouchTwice + "1 2 3 4 5 6\n2 8 5 7\n2 7 5 8\n6 5 4 3 2 1", kListed, false, kValid,
       0, 0, 0, 0, 0, 0, 1},
      {"two holes, one that touches the shell and the other one",
       "9 6\n" + kTouch + "7 8\n3 8\n" + shell + "7 6 2\n2 6 7\n7 9 8\n7 8 9\n" + outer, kListed,
       false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"three around a piece of the outside",
       "6 6\n" + kThreeAround + "1 4 2\n2 5 3\n3 6 1\n2 4 1\n3 5 2\n1 6 3", kListed, false, kValid,
       0, 0, 0, 0, 0, 0, 1},
      {"three around a piece of the outside, inferred",
       "6 3\n" + kThreeAround + "1 4 2\n2 5 3\n3 6 1", kInfer, false, kValid, 0, 0, 0, 0, 0, 0, 1},
      {"three around a hole that is filled",
       "6 5\n" + kThreeAround + "1 4 2\n2 5 3\n3 6 1\n1 2 3\n1 6 3 5 2 4", kListed, false, kValid,
       0, 0, 0, 0, 0, 0, 1},
      {"two shells around one hole",
       "8 5\n" + kTouchTwice + "1 2 8 5 6\n2 3 4 5 7\n2 8 5 7\n2 7 5 8\n6 5 4 3 2 1", kListed,
       false, kNotPlanar, 4, 0, 0, 0, -1, 0, 1},
  };
}

std::vector<SmallMap> overlapping_cases() {
  const std::string both = "1 2 3 4 5\n2 6 7 4 8\n", outer = "5 4 7 6 2 1";
  return {
      {"neighbours over each other", "8 3\n" + kLens + both + outer, kListed, false, kOpen, 0, 4, 0,
       0, -1, 0, 1},
      {"neighbours over each other, inferred", "8 3\n" + kLens + both + outer, kInfer, false, kOpen,
       0, 4, 0, 0, -1, 0, 1},
      {"neighbours over each other, ignored", "8 3\n" + kLens + both + outer, kIgnore, false,
       kSuperposed, 0, 0, 0, 0, 1, 0, 1},
      {"island over the border of its hole, inferred",
       "9 4\n" + kRing + "7 4\n1 2 3 4\n4 3 2 1\n8 7 6 5\n5 6 9 7 8", kInfer, false, kOpen, 0, 3, 0,
       0, -1, 0, 2},
      {"neighbours over each other, and the border of the overlap",
       "8 4\n" + kLens + both + outer + "\n3 2 8 4", kListed, false, kSuperposed, 0, 0, 0, 0, 3, 0,
       1},
  };
}

}  // namespace

void PrintTo(const SmallMap& map, std::ostream* out) { *out << map.name; }

const std::vector<SmallMap>& small_maps() {
  static const std::vector<SmallMap> kAll = [] {
    std::vector<SmallMap> all = simple_cases();
    for (const auto& more : {crossing_cases(), nesting_cases(), pinch_cases(), touching_cases(),
                             overlapping_cases()}) {
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  }();
  return kAll;
}

TestMap parse_map(const std::string& text) {
  TestMap map;
  std::istringstream in(text);
  std::size_t points = 0;
  std::size_t cycles = 0;
  in >> points >> cycles;
  for (std::string x, y; points > 0 && in >> x >> y; --points) {
    map.add_point(BigRational(x), BigRational(y));
  }
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream corners(line);
    Cycle& cycle = map.cycles.emplace_back();
    for (std::uint32_t v = 0; corners >> v;) cycle.push_back(v - 1);
  }
  return map;
}

}  // namespace plumb::testing
