// Hints are followed. For every change that a hint can ask for there is a map that provokes it. The
// change is made as the words say, without a look at the map, until the check finds nothing more.
// A hint is understood by its words alone (Follower), so a hint that cannot be followed fails here.
#include "plumb/plane/check/map_hints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "plane/checked.h"
#include "plumb/testing/map_defects.h"
#include "plumb/testing/map_families.h"
#include "plumb/testing/small_maps.h"

namespace plumb::testing::map_hints_test {

/// A vertex that is to be moved, where a hint says no more than that, and its new place.
struct Move {
  std::uint32_t vertex;
  int x, y;
};

struct HintCase {
  std::string name;
  std::string text;  ///< A map that provokes the hint.
  std::string hint;  ///< What the first hints say, as a regular expression.
  OuterRule outer = OuterRule::Listed;
  std::optional<Move> move = std::nullopt;
  std::string cut = "";  ///< The map after an overlap is cut off.
};

void PrintTo(const HintCase& one, std::ostream* out) { *out << one.name; }

Cycle vertices_of(const std::string& text) {
  Cycle vertices;
  std::istringstream in(text);
  for (std::uint32_t v = 0; in >> v;) vertices.push_back(v - 1);
  return vertices;
}

std::size_t face_of(const std::string& text) { return std::stoul(text) - 1; }

// A list of vertices in a hint.
const std::string kList = R"((\d+(?: \d+)*))";

/// Makes the change that a hint asks for.
class Follower {
 public:
  Follower(TestMap& map, OracleOptions& options, const HintCase& given)
      : map_(map), options_(options), given_(given) {}

  /// Whether the hint asks for a change; a hint may ask to mend something else first.
  bool follow(const MapDefect& defect) {
    defect_ = &defect;
    if (says("mend the .* first")) return false;
    return add_cycle() || change_path() || insert_vertices() || merge() || split() || remove() ||
           reverse() || move();
  }

 private:
  bool says(const std::string& words) {
    return std::regex_search(defect_->hint, words_, std::regex(words));
  }
  std::string word(std::size_t i) const { return words_[i].str(); }

  bool add_cycle() {
    if (!says("list the (?:clockwise cycle|missing face) " + kList + "$")) return false;
    map_.cycles.push_back(vertices_of(word(1)));
    return true;
  }

  static bool begins_with(const Cycle& cycle, const Cycle& path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (cycle[i % cycle.size()] != path[i]) return false;
    }
    return path.size() <= cycle.size() + 1;
  }

  // "2 8 4 instead of 2 3 4 in face 1"
  bool change_path() {
    if (!says(kList + " instead of " + kList + R"( in face (\d+)$)")) return false;
    const Cycle path = vertices_of(word(1)), old = vertices_of(word(2));
    Cycle& cycle = map_.cycles.at(face_of(word(3)));
    std::size_t turns = 0;
    for (; !begins_with(cycle, old) && turns < cycle.size(); ++turns) {
      std::rotate(cycle.begin(), cycle.begin() + 1, cycle.end());
    }
    if (turns == cycle.size()) return false;
    // A path that goes all the way round ends with the first corner.
    const std::size_t length = std::min(old.size(), cycle.size());
    cycle.erase(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(length));
    cycle.insert(cycle.begin(), path.begin(), path.end());
    if (says("list " + kList + " as a face, and")) map_.cycles.push_back(vertices_of(word(1)));
    return true;
  }

  void insert_into(Cycle& cycle, std::uint32_t from, std::uint32_t to, Cycle between) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::uint32_t u = cycle[i], v = cycle[(i + 1) % cycle.size()];
      if (std::minmax(u, v) != std::minmax(from, to)) continue;
      const bool ascends = map_.points[u] < map_.points[v];
      std::ranges::sort(between, [&](std::uint32_t p, std::uint32_t q) {
        return ascends ? map_.points[p] < map_.points[q] : map_.points[q] < map_.points[p];
      });
      cycle.insert(cycle.begin() + static_cast<std::ptrdiff_t>(i) + 1, between.begin(),
                   between.end());
      return;
    }
  }

  // Whether a vertex lies inside an edge.
  bool lies_on(std::uint32_t v, const MapEdge& e) const {
    const ExactPoint &p = map_.points[e.from], &q = map_.points[e.to], &r = map_.points[v];
    const bool is_collinear = (q.x - p.x) * (r.y - p.y) == (q.y - p.y) * (r.x - p.x);
    return is_collinear && std::min(p, q) < r && r < std::max(p, q);
  }

  bool insert_vertices() {
    if (says(R"(edge (\d+)-(\d+) is covered by ([\d-]+); insert .* into face (\d+)$)")) {
      std::string path = word(3);
      std::ranges::replace(path, '-', ' ');
      const Cycle all = vertices_of(path);
      insert_into(map_.cycles.at(face_of(word(4))), all.front(), all.back(),
                  Cycle(all.begin() + 1, all.end() - 1));
      return true;
    }
    if (says(R"(part of edge (\d+)-(\d+); insert vertex (\d+)(?: and (\d+))? into face (\d+)$)")) {
      const Cycle inserted = vertices_of(word(3) + " " + word(4));
      insert_into(map_.cycles.at(face_of(word(5))), vertices_of(word(1))[0],
                  vertices_of(word(2))[0], inserted);
      return true;
    }
    if (!says("insert it into the faces there$|insert the vertices of each into the other$")) {
      return false;
    }
    const std::vector<MapEdge> edges = defect_->edges;
    for (const auto& [edge, other] : {std::pair(edges[0], edges[1]), {edges[1], edges[0]}}) {
      Cycle inside;
      for (const std::uint32_t v : {other.from, other.to}) {
        if (lies_on(v, edge)) inside.push_back(v);
      }
      for (Cycle& cycle : map_.cycles) insert_into(cycle, edge.from, edge.to, inside);
    }
    return true;
  }

  bool merge() {
    if (!says("or --merge-vertices$")) return false;
    options_.merge_vertices = true;
    return true;
  }

  bool split() {
    if (!says(R"(^face (\d+) .*; list )" + kList + " and " + kList + "$")) return false;
    map_.cycles.at(face_of(word(1))) = vertices_of(word(2));
    map_.cycles.push_back(vertices_of(word(3)));
    return true;
  }

  bool remove() {
    if (!says(R"(remove face (\d+)$)") && !says(R"(face (\d+) runs clockwise, .*; remove it$)") &&
        !says(R"(^face (\d+) .* remove the face$)")) {
      return false;
    }
    map_.cycles.erase(map_.cycles.begin() + static_cast<std::ptrdiff_t>(face_of(word(1))));
    return true;
  }

  bool reverse() {
    if (says("reverse each of them$")) {
      for (Cycle& cycle : map_.cycles) std::ranges::reverse(cycle);
      return true;
    }
    if (!says(R"(face (\d+) (?:runs the wrong way|is listed the wrong way).* reverse it$)")) {
      return false;
    }
    std::ranges::reverse(map_.cycles.at(face_of(word(1))));
    return true;
  }

  bool move() {
    if (says("move a vertex") && given_.move) {
      map_.points.at(given_.move->vertex - 1) = {given_.move->x, given_.move->y};
      return true;
    }
    if (!says("cut the overlap off one of them$") || given_.cut.empty()) return false;
    map_ = parse_map(given_.cut);
    return true;
  }

  TestMap& map_;
  OracleOptions& options_;
  const HintCase& given_;
  const MapDefect* defect_ = nullptr;
  std::smatch words_;
};

std::string hints_of(const MapReport& report) {
  std::string text;
  for (const MapDefect& defect : report.defects) text += defect.hint + "\n";
  return text;
}

/// Follows the first hint that asks for a change, again and again. Returns whether that leads to a
/// valid map; the report on any other is in `left`.
bool leads_to_a_valid_map(TestMap map, OracleOptions options, const HintCase& given,
                          std::string& left) {
  for (int step = 0; step < 12; ++step) {
    const MapReport report = checked(map, options);
    left = hints_of(report) + to_text(map);
    if (report.verdict == MapVerdict::Valid) return true;
    Follower follower(map, options, given);
    const bool followed = std::ranges::any_of(
        report.defects, [&](const MapDefect& defect) { return follower.follow(defect); });
    if (!followed) return false;
  }
  return false;
}

const std::string kTwoSquares = "0 0\n1 0\n2 0\n0 1\n1 1\n2 1\n";
const std::string kRing = "0 0\n9 0\n9 9\n0 9\n3 3\n6 3\n6 6\n3 6\n";
const std::string kTouch = "0 0\n5 0\n10 0\n10 10\n0 10\n7 4\n3 4\n";
const std::string kLens = "0 0\n10 0\n12 5\n10 10\n0 10\n20 0\n20 10\n8 5\n";
const std::string kLensFaces = "1 2 3 4 5\n2 6 7 4 8\n";
const std::string kTriangle = "0 0\n9 0\n0 9\n1 1\n";
const std::string kInstead =
    "regions 1 and 2 overlap between vertices 2 and 4; let both follow one "
    "line, for example 2 8 4 instead of 2 3 4 in face 1";
// Two squares, one of which has a corner in the other.
const std::string kCorner = "0 0\n4 0\n6 3\n0 4\n5 0\n9 0\n9 4\n5 4\n";
// The same, cut at the border of the second one.
const std::string kCut =
    "10 3\n0 0\n4 0\n5 3/2\n5 19/6\n0 4\n5 0\n9 0\n9 4\n5 4\n6 3\n"
    "1 2 3 4 5\n6 7 8 9 4 3\n5 4 9 8 7 6 3 2 1";

const std::vector<HintCase>& cases() {
  static const std::vector<HintCase> kAll = {
      {"gap", "6 2\n" + kTwoSquares + "1 2 5 4\n1 4 5 6 3 2", "gap of 4 edges in the coverage"},
      {"outer_boundary", "3 1\n0 0\n1 0\n0 1\n1 2 3", "missing outer boundary of 3 edges"},
      {"island", "8 3\n" + kRing + "1 2 3 4\n4 3 2 1\n5 6 7 8",
       "regions 1 and 3 overlap, as region 3 lies inside region 1; to cut a hole for it"},
      {"touching_island", "7 3\n" + kTouch + "1 2 3 4 5\n2 6 7\n5 4 3 2 1",
       "regions 1 and 2 overlap, as region 2 lies inside region 1; to cut a hole for it"},
      {"island_that_touches_twice", "6 3\n0 0\n4 0\n4 4\n0 4\n2 1\n2 3\n1 2 3 4\n1 5 3 6\n4 3 2 1",
       "regions 1 and 2 overlap, as region 2 lies inside region 1; to cut a hole for it"},
      {"filler_over_its_hole", "9 4\n" + kRing + "7 4\n1 2 3 4\n4 3 2 1\n8 7 6 5\n5 6 9 7 8",
       "regions 1 and 4 overlap between vertices 6 and 7"},
      {"lens", "8 3\n" + kLens + kLensFaces + "5 4 7 6 2 1", kInstead},
      {"lens_without_outer_boundary", "8 2\n" + kLens + kLensFaces,
       "mend the overlap at edge [0-9-]+ first"},
      {"lens_and_its_border", "8 4\n" + kLens + kLensFaces + "5 4 7 6 2 1\n3 2 8 4",
       "face 4 runs clockwise, but is neither a hole nor an outer boundary; remove it"},
      {"lens_with_two_outer_boundaries",
       "8 4\n" + kLens + "1 2 3 4 5\n5 4 3 2 1\n2 6 7 4 8\n8 4 7 6 2",
       "regions 1 and 3 overlap between vertices 2 and 4"},
      {"two_versions_of_a_border",
       "10 3\n0 0\n10 0\n12 3\n8 7\n10 10\n0 10\n20 0\n20 10\n12 7\n8 3\n"
       "1 2 3 4 5 6\n2 7 8 5 9 10\n6 5 8 7 2 1",
       "regions 1 and 2 overlap between vertices 2 and 5; let both follow one line"},
      {"t_junction", "7 3\n" + kTwoSquares + "1 1/2\n1 2 5 4\n2 3 6 5 7\n1 4 5 6 3 2",
       "T-junction, edge 2-5 is covered by 2-7-5; insert the vertices between into face 1"},
      {"part_of_an_edge", "7 3\n" + kTwoSquares + "1 1/2\n1 2 7 5 4\n2 3 6 5\n1 4 5 6 3 2",
       "T-junction, it is a part of edge 2-5; insert vertex 7 into face 2"},
      {"equal_coordinates",
       "8 3\n0 0\n1 0\n1 1\n0 1\n1 0\n2 0\n2 1\n1 1\n1 2 3 4\n5 6 7 8\n1 4 3 7 6 2",
       "whose ends have equal coordinates; use the same vertices, or --merge-vertices"},
      {"edge_of_length_zero", "5 2\n0 0\n1 0\n1 1\n0 1\n1 0\n1 2 5 3 4\n4 3 2 1",
       "its ends are one point; use one vertex for both, or --merge-vertices"},
      {"listed_twice", "3 3\n0 0\n1 0\n0 1\n1 2 3\n2 3 1\n3 2 1",
       "they are the same cycle; remove face 2"},
      {"flipped_face", "6 3\n" + kTwoSquares + "1 2 5 4\n2 5 6 3\n1 4 5 6 3 2",
       "face 2 runs the wrong way; reverse it"},
      {"flipped_outer_boundary", "6 3\n" + kTwoSquares + "1 2 5 4\n2 3 6 5\n1 2 3 6 5 4",
       "face 3 runs the wrong way; reverse it"},
      {"region_along_the_border_of_another",
       "6 3\n0 0\n4 0\n4 2\n4 4\n0 4\n0 2\n1 2 3 4 5 6\n1 2 3 6\n6 5 4 3 2 1",
       "regions 1 and 2 overlap; let both follow one line, for example 6 3 instead of 6 1 2 3 in "
       "face 1"},
      {"stray_clockwise_face", "6 4\n" + kTwoSquares + "1 2 5 4\n2 3 6 5\n1 4 5 6 3 2\n1 4 5 2",
       "face 4 runs clockwise, but is neither a hole nor an outer boundary; remove it"},
      {"face_run_twice", "3 2\n0 0\n1 0\n0 1\n1 2 3 1 2 3\n3 2 1",
       "face 1 uses the directed edge 1-2 more than once: run along it once, 1 instead of 1 2 3 1 "
       "in face 1"},
      {"corner_in_a_neighbour", "8 4\n" + kCorner + "1 2 3 4\n4 3 2 1\n5 6 7 8\n8 7 6 5",
       "cross, so regions 1 and 3 overlap there: move a vertex, or cut the overlap off one of them",
       OuterRule::Listed, Move{3, 4, 3}},
      {"overlap_to_be_cut", "8 2\n" + kCorner + "1 2 3 4\n5 6 7 8",
       "regions 1 and 2 overlap between vertices 2 and 4; cut the overlap off one of them",
       OuterRule::Listed, std::nullopt, kCut},
      {"bow_tie", "4 2\n0 0\n2 2\n2 0\n0 2\n1 2 3 4\n4 3 2 1",
       "edges 1-2 and 3-4 cross: move a vertex", OuterRule::Listed, Move{2, 1, -1}},
      {"bow_tie_without_outside", "4 1\n0 0\n2 2\n2 0\n0 2\n1 2 3 4",
       "this border crosses itself; mend the crossing of edges 1-2 and 3-4 first",
       OuterRule::Listed, Move{2, 1, -1}},
      {"vertex_on_an_edge", "6 4\n0 0\n4 0\n4 4\n4 2\n8 1\n8 3\n1 2 3\n3 2 1\n4 5 6\n6 5 4",
       "vertex 4 lies inside one of them; insert it into the faces there"},
      {"edges_over_each_other", "5 4\n0 0\n4 0\n0 4\n2 0\n0 -2\n1 2 3\n3 2 1\n1 5 4\n4 5 1",
       "overlap from vertex 1 on: insert the vertices of each into the other"},
      {"two_ids_for_one_place", "6 4\n0 0\n1 0\n0 1\n0 0\n-1 0\n0 -1\n1 2 3\n3 2 1\n4 5 6\n6 5 4",
       "meet at two vertices with equal coordinates: use one vertex, or --merge-vertices"},
      {"spike", "4 2\n" + kTriangle + "1 4 1 2 3\n3 2 1",
       "remove the spike, 1 instead of 1 4 1 in face 1"},
      {"bridge", "8 3\n" + kRing + "1 5 8 7 6 5 1 2 3 4\n5 6 7 8\n4 3 2 1",
       "split the face; list 5 8 7 6 as a face, and 1 instead of 1 5 8 7 6 5 1 in face 1|split the "
       "face; list 1 2 3 4 as a face"},
      {"no_area_but_a_tree", "5 3\n" + kTriangle + "2 1\n1 2 3\n3 2 1\n1 4 5 4", "remove the face"},
      {"all_turned", "6 3\n" + kTwoSquares + "4 5 2 1\n5 6 3 2\n2 3 6 5 4 1",
       "all faces of this component are listed the wrong way round: reverse each of them"},
      {"one_wing_turned", "5 2\n0 0\n2 0\n1 1\n3 3\n-1 3\n1 2 3 5 4 3\n1 3 4 5 3 2",
       "split it at vertex 3; list"},
      {"nested", "8 2\n" + kRing + "1 2 3 4\n5 6 7 8",
       "face 2 lies inside face 1, whose hole is not listed: list the clockwise cycle",
       OuterRule::Ignore},
  };
  return kAll;
}

class Hints : public ::testing::TestWithParam<HintCase> {};

TEST_P(Hints, LeadToAValidMap) {
  const HintCase& given = GetParam();
  const TestMap map = parse_map(given.text);
  const OracleOptions options{given.outer, false};
  const std::string hints = hints_of(checked(map, options));
  EXPECT_TRUE(std::regex_search(hints, std::regex(given.hint))) << hints;
  std::string left;
  EXPECT_TRUE(leads_to_a_valid_map(map, options, given, left)) << left;
}

INSTANTIATE_TEST_SUITE_P(MapHints, Hints, ::testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.name; });

/// The hints for one defect of a kind that says what to change, in all families of maps.
TEST(Hints, OfSeededDefectsLeadToValidMaps) {
  int followed = 0;
  for (const std::string defect :
       {"drop-face", "drop-outer", "duplicate-face", "flip-face", "flip-all", "t-junction",
        "island-open", "far-island-open", "spike", "alias-vertex", "lens"}) {
    for (const MapFamily& family : map_families()) {
      for (const DefectPlace place : {DefectPlace{0, 0}, DefectPlace{7, 1}, DefectPlace{19, 2}}) {
        const TestMap map = map_defect_maker(defect).make(family.make(3), place).map;
        // Of a long cycle, a hint names only a dozen vertices.
        if (hints_of(checked(map)).find("...") != std::string::npos) continue;
        ++followed;
        std::string left;
        EXPECT_TRUE(leads_to_a_valid_map(map, {}, {}, left))
            << defect << " in " << family.name << ", cycle " << place.cycle << "\n"
            << left;
      }
    }
  }
  EXPECT_GT(followed, 150);
}

/// Wherever two faces bulge over each other, the check says which, and between which vertices.
TEST(Hints, NameBothRegionsOfASliver) {
  for (const MapFamily& family : map_families()) {
    const TestMap valid = family.make(12);
    for (std::uint32_t c = 0; c < valid.cycles.size(); ++c) {
      const Cycle& cycle = valid.cycles[c];
      const std::uint32_t u = cycle[0], v = cycle[1];
      const auto has_back = [&](const Cycle& other) {
        for (std::size_t i = 0; i < other.size(); ++i) {
          if (other[i] == v && other[(i + 1) % other.size()] == u) return true;
        }
        return false;
      };
      const auto d = static_cast<std::size_t>(std::ranges::find_if(valid.cycles, has_back) -
                                              valid.cycles.begin());
      const bool are_regions =
          doubled_area(valid, cycle) > 0 && doubled_area(valid, valid.cycles[d]) > 0;
      if (!are_regions) continue;
      const std::size_t low = std::min<std::size_t>(c, d), high = std::max<std::size_t>(c, d);
      const std::string expected = "regions " + std::to_string(low + 1) + " and " +
                                   std::to_string(high + 1) + " overlap between vertices " +
                                   std::to_string(std::min(u, v) + 1) + " and " +
                                   std::to_string(std::max(u, v) + 1) + ";";
      const MapReport report = checked(map_defect_maker("lens").make(valid, {c, 0}).map);
      ASSERT_EQ(report.defects.size(), 4U);
      for (const MapDefect& defect : report.defects) {
        EXPECT_NE(defect.hint.find(expected), std::string::npos) << defect.hint;
      }
    }
  }
}

/// Three squares over each other: every two of them are said to overlap, and nothing is said to be
/// missing.
TEST(Hints, NameAllPairsOfThreeRegionsOverEachOther) {
  const std::string squares =
      "12 3\n0 0\n6 0\n6 6\n0 6\n3 1\n9 1\n9 7\n3 7\n2 3\n8 3\n8 9\n2 9\n"
      "1 2 3 4\n5 6 7 8\n9 10 11 12";
  const std::string hints = hints_of(checked(parse_map(squares)));
  for (const std::string pair : {"1 and 2", "1 and 3", "2 and 3"}) {
    EXPECT_NE(hints.find("regions " + pair + " overlap"), std::string::npos) << hints;
  }
  EXPECT_EQ(hints.find("missing outer boundary"), std::string::npos) << hints;
  EXPECT_EQ(hints.find("gap of"), std::string::npos) << hints;
}

/// Squares with sides on one line, a part of which both have.
TEST(Hints, NameRegionsThatOverlapAlongAPartOfAnEdge) {
  const std::string squares = "8 2\n0 0\n6 0\n6 4\n0 4\n3 0\n9 0\n9 2\n3 2\n1 2 3 4\n5 6 7 8";
  const std::string hints = hints_of(checked(parse_map(squares)));
  EXPECT_NE(hints.find("regions 1 and 2 overlap"), std::string::npos) << hints;
  EXPECT_EQ(hints.find("list the clockwise cycle"), std::string::npos) << hints;
}

/// Where edges cross far more often than there are edges, nothing is derived from orientations.
TEST(Hints, StayGeneralForVeryManyCrossings) {
  TestMap map;
  for (int i = 0; i < 40; ++i) {
    const auto v = static_cast<std::uint32_t>(map.points.size());
    map.add_point(i, -100);
    map.add_point(i + BigRational(1, 2), -100);
    map.add_point(i, 100);
    map.add_point(-100, i);
    map.add_point(100, i);
    map.add_point(-100, i + BigRational(1, 2));
    map.cycles.push_back({v, v + 1, v + 2});
    map.cycles.push_back({v + 3, v + 4, v + 5});
  }
  const MapReport report = checked(map);
  EXPECT_GT(report.counts.crossing, 5000U);
  const std::string hints = hints_of(report);
  EXPECT_EQ(hints.find("missing outer boundary"), std::string::npos);
  EXPECT_NE(hints.find("mend the crossings first"), std::string::npos);
}

}  // namespace plumb::testing::map_hints_test
