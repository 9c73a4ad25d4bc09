// OpenSCAD's flattened models: what is read, what is refused and where, and which files a model may
// import.
#include "plumb/io/csg_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "plumb/csg/evaluate.h"
#include "plumb/model/primitives.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb::testing::csg_reader_test {
namespace {

namespace fs = std::filesystem;

CsgTree tree_of(const std::string& text) { return read_csg("m.csg", text).tree; }

std::vector<CsgKind> kinds_of(const CsgTree& tree) {
  std::vector<CsgKind> kinds;
  for (const CsgTree::Node& node : tree.nodes) kinds.push_back(node.kind);
  return kinds;
}

std::vector<double> numbers_of(const std::string& text) {
  const CsgTree tree = tree_of(text);
  const auto numbers = tree.numbers_of(tree.nodes.at(1));
  return {numbers.begin(), numbers.end()};
}

Rational volume_of(const std::string& text) { return *evaluate(tree_of(text)).solid.volume(); }

void expect_refusal(const std::string& text, ErrorCode code, const std::string& message) {
  try {
    static_cast<void>(read_csg("m.csg", text));
    ADD_FAILURE() << "accepted: " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << text << ": " << error.what();
    EXPECT_EQ(std::string(error.what()).find(message), 0U) << text << ": " << error.what();
  }
}

TEST(CsgReader, NestsNodes) {
  const CsgTree tree = tree_of(
      "group() {\n  union() { cube(); sphere(); }\n  difference();\n}\nhull() { group(); }\n");
  EXPECT_EQ(kinds_of(tree),
            (std::vector{CsgKind::Root, CsgKind::Group, CsgKind::Union, CsgKind::Cube,
                         CsgKind::Sphere, CsgKind::Difference, CsgKind::Hull, CsgKind::Group}));
  std::vector<std::uint32_t> ends;
  for (const CsgTree::Node& node : tree.nodes) ends.push_back(node.end);
  EXPECT_EQ(ends, (std::vector<std::uint32_t>{8, 6, 5, 4, 5, 6, 8, 8}));
  EXPECT_EQ(tree.nodes[5].line, 3U);
  EXPECT_EQ(tree.nodes[5].column, 3U);
}

TEST(CsgReader, ParametersHaveNamesPlacesAndDefaults) {
  EXPECT_EQ(numbers_of("cube(size = [1, 2.5, -3e2], center = true);"),
            (std::vector<double>{1, 2.5, -300, 1}));
  EXPECT_EQ(numbers_of("cube(size = 4);"), (std::vector<double>{4, 4, 4, 0}));
  EXPECT_EQ(numbers_of("cube([1,2,3]);"), (std::vector<double>{1, 2, 3, 0}));
  EXPECT_EQ(numbers_of("cube(size = undef);"), (std::vector<double>{1, 1, 1, 0}));
  EXPECT_EQ(numbers_of("cylinder(h = 5, r1 = 1, r2 = 0, $fn = 7);"),
            (std::vector<double>{5, 1, 0, 0, 7, 12, 2}));
  EXPECT_EQ(numbers_of("sphere($fa = 0, $fs = -1, r = 3);"),
            (std::vector<double>{3, 0, 0.01, 0.01}));
  // The number of chords that OpenSCAD makes: nan is no bound, and inf leaves five.
  EXPECT_EQ(numbers_of("sphere($fa = nan, $fs = 2, r = 3);"),
            (std::vector<double>{3, 0, 1e-200, 2}));
  EXPECT_EQ(numbers_of("sphere($fa = nan, $fs = nan, r = 3);"),
            (std::vector<double>{3, 0, 1e200, 1e-200}));
  EXPECT_EQ(numbers_of("sphere($fa = inf, $fs = 2, r = 3);"),
            (std::vector<double>{3, 0, 1e200, 2}));
  EXPECT_EQ(numbers_of("offset(delta = -2, chamfer = true);"),
            (std::vector<double>{-2, 2, 0, 12, 2}));
  EXPECT_EQ(numbers_of("multmatrix([[1, 2, 3, 4], [5, 6, 7, 8], [9, 10, 11, 12], [0, 0, 0, 1]]);"),
            (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  EXPECT_EQ(numbers_of("linear_extrude(height = 2, scale = 3, twist = 90, slices = 8);"),
            (std::vector<double>{2, 0, 90, 8, 3, 3, 0, 12, 2}));
}

TEST(CsgReader, ColoursAreVectorsNamesOrDigits) {
  EXPECT_EQ(numbers_of("color([0.25, 0.5, 1]);"), (std::vector{0.25, 0.5, 1.0, 1.0}));
  EXPECT_EQ(numbers_of("color(c = [-1, -1, -1, 0.3]);"), (std::vector{-1.0, -1.0, -1.0, 0.3}));
  EXPECT_EQ(numbers_of("color(\"Red\");"), (std::vector{1.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(numbers_of("color(\"aliceblue\", alpha = 0.5);"),
            (std::vector{240 / 255.0, 248 / 255.0, 1.0, 0.5}));
  EXPECT_EQ(numbers_of("color(c = \"YellowGreen\");"),
            (std::vector{154 / 255.0, 205 / 255.0, 50 / 255.0, 1.0}));
  EXPECT_EQ(numbers_of("color(\"#0F8\");"), (std::vector{0.0, 1.0, 8 / 15.0, 1.0}));
  EXPECT_EQ(numbers_of("color(\"#00ff8833\");"), (std::vector{0.0, 1.0, 136 / 255.0, 0.2}));
  EXPECT_TRUE(numbers_of("color();").empty());
  EXPECT_TRUE(numbers_of("color(undef);").empty());
}

TEST(CsgReader, UnknownColoursAreNoColoursWithANote) {
  for (const std::string name : {"reddish", "#12345", "#ggg", "#", "", "re"}) {
    SCOPED_TRACE(name);
    const CsgRead read = read_csg("m.csg", "color(\"" + name + "\") { cube(); }");
    EXPECT_EQ(read.tree.nodes.at(1).number_count, 0U);
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_NE(read.notes[0].find("is unknown"), std::string::npos) << read.notes[0];
  }
  expect_refusal("color([1, \"x\"]);", ErrorCode::BadArgument, "m.csg:1:11: expected a number");
  expect_refusal("color(\"red\", alpha = \"x\");", ErrorCode::BadArgument,
                 "m.csg:1:22: expected a number");
}

TEST(CsgReader, CommentsBlanksAndLineBreaksMayStandAnywhere) {
  EXPECT_EQ(volume_of("\xef\xbb\xbf// c\r\n cube /* ( */ (\n size // x\n =[1,\t2,3 ,],)\n;;"),
            Rational(6));
}

TEST(CsgReader, NumbersAreTheNearestDoubles) {
  EXPECT_EQ(numbers_of("cube(size = [.1, +1E-3, 1e-400]);"), (std::vector<double>{.1, .001, 0, 0}));
}

TEST(CsgReader, ModifiersLeaveNodesOutAndChooseTheRoot) {
  EXPECT_EQ(volume_of("cube(size = 2); *cube(size = 9); %group() { cube(size = 9); }"),
            Rational(8));
  EXPECT_EQ(volume_of("#cube(size = 2);"), Rational(8));
  EXPECT_EQ(volume_of("cube(size = 9); group() { !union() { cube(size = 2); } cube(size = 5); }"),
            Rational(8));
  EXPECT_EQ(volume_of("cube(size = 3); *group() { !cube(size = 2); }"), Rational(27));
}

// OpenSCAD writes braces around all children, but people leave them out around one.
TEST(CsgReader, OneChildNeedsNoBraces) {
  const std::string move = "multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) ";
  EXPECT_EQ(volume_of("difference() { cube(size = 2); " + move + "cube(size = 2); }"), Rational(4));
  EXPECT_EQ(volume_of(move + "color([1,0,0]) group() cube(size = 2); cube(size = 2);"),
            Rational(12));
  EXPECT_EQ(volume_of(move + "union() { cube(size = 1); cube(size = 2); } cube(size = 1);"),
            Rational(9));
  EXPECT_EQ(volume_of("union() #" + move + "cube(size = 2); *group() cube(size = 5);"),
            Rational(8));
  expect_refusal("group() group()", ErrorCode::Syntax, "m.csg:1:16: expected ';' or '{'");
  expect_refusal("group() }", ErrorCode::Syntax, "m.csg:1:9: expected ';' or '{', found '}'");
  expect_refusal("{ group() cube(); ", ErrorCode::Syntax, "m.csg:1:1: expected a node");
  expect_refusal("group() { group() cube(); ", ErrorCode::Syntax,
                 "m.csg:1:27: expected '}', found the end");
  std::string nested;
  for (int i = 0; i < 1000000; ++i) nested += "group()";
  EXPECT_EQ(volume_of(nested + "cube(size = 2);"), Rational(8));
}

TEST(CsgReader, PolyhedraLookOutward) {
  const std::string points = "points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]";
  EXPECT_EQ(volume_of("polyhedron(" + points + ", faces = [[0,1,2],[0,3,1],[0,2,3],[1,3,2]]);"),
            Rational(1) / Rational(6));
}

TEST(CsgReader, UnknownParametersAreNamedOnce) {
  const CsgRead read = read_csg("m.csg", "cube(size = 1, foo = 2); cube(foo = 3);");
  EXPECT_EQ(read.notes, std::vector<std::string>{"the parameter 'foo' of cube is passed over"});
}

TEST(CsgReader, RefusesAtThePlace) {
  expect_refusal("cube();\n  text(text = \"a\", direction = \"up\");", ErrorCode::BadArgument,
                 "m.csg:2:3: the direction of text() is 'up'");
  expect_refusal("surface(center = true);", ErrorCode::BadArgument,
                 "m.csg:1:1: surface needs the name of a file");
  expect_refusal("roof() { square(); }", ErrorCode::UnknownFormat, "m.csg:1:1: 'roof' is no node");
  expect_refusal("cube(", ErrorCode::Syntax,
                 "m.csg:1:6: expected a parameter or ')', found the end");
  expect_refusal("group() {\ncube();", ErrorCode::Syntax, "m.csg:2:8: expected '}', found the end");
  expect_refusal("}", ErrorCode::Syntax, "m.csg:1:1: expected a node, found '}'");
  expect_refusal("cube() sphere();", ErrorCode::Syntax,
                 "m.csg:1:8: expected ';' or '{', found 'sphere'");
  expect_refusal("cube(size = [1, 2);", ErrorCode::Syntax, "m.csg:1:18: expected ',' or ']'");
  expect_refusal("cube(size = abc);", ErrorCode::Syntax, "m.csg:1:13: expected a number, a vector");
  expect_refusal("cube(size = 1x);", ErrorCode::Syntax, "m.csg:1:13: ");
  expect_refusal("cube(size = 1e999);", ErrorCode::NumberOutOfRange, "m.csg:1:13: ");
  expect_refusal("offset(r = inf) square();", ErrorCode::NumberOutOfRange,
                 "m.csg:1:12: the number is not finite");
  expect_refusal("polygon(points = [[1, -nan], [1, 1], [2, 2]]);", ErrorCode::NumberOutOfRange,
                 "m.csg:1:23: ");
  expect_refusal("cube(size = infinite);", ErrorCode::Syntax, "m.csg:1:13: ");
  expect_refusal("cube(size = \"a\");", ErrorCode::BadArgument, "m.csg:1:13: expected a vector");
  expect_refusal("sphere(r = [1]);", ErrorCode::BadArgument, "m.csg:1:12: expected a number");
  expect_refusal("multmatrix();", ErrorCode::BadArgument, "m.csg:1:1: multmatrix needs a matrix");
  expect_refusal("multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,0]]);", ErrorCode::BadArgument,
                 "m.csg:1:12: the last number of the matrix is 0");
  expect_refusal("linear_extrude(height = 1, v = [1, 0]) square();", ErrorCode::BadArgument,
                 "m.csg:1:32: v must have three numbers");
  expect_refusal("polygon(points = [[0,0],[1,0],[0,1]], paths = [[0, 1, 3]]);", ErrorCode::BadIndex,
                 "m.csg:1:55: there is no point of this number");
  expect_refusal("polygon(points = [[0,0]], paths = [[0.5]]);", ErrorCode::BadIndex,
                 "m.csg:1:37: ");
  expect_refusal("/* no end", ErrorCode::Syntax, "m.csg:1:1: this comment does not end");
  expect_refusal("import(file = \"a", ErrorCode::Syntax, "m.csg:1:15: this text does not end");
  expect_refusal("import(file = \"a\x01\");", ErrorCode::NotText, "m.csg:1:17: ");
  expect_refusal("cube(size = " + std::string(100, '[') + ");", ErrorCode::Syntax,
                 "m.csg:1:77: vectors are nested too deep");
}

// OpenSCAD 2021.01 gives the same volumes and writes such models.
TEST(CsgReader, NodesWithNumbersThatAreNotFiniteGiveNothing) {
  for (const std::string text :
       {"cube(size = inf);", "cube(size = [1, -nan, 2]);", "sphere(r = -inf);",
        "cylinder(h = 1, r1 = inf, r2 = 1);", "linear_extrude(height = 1) circle(r = nan);",
        "linear_extrude(height = 1) square(size = [inf, 1]);",
        "multmatrix([[nan, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) cube(size = 2);"}) {
    const CsgRead read = read_csg("m.csg", "difference() { cube(size = 3); " + text + " }");
    EXPECT_EQ(evaluate(read.tree).solid.volume(), Rational(27)) << text;
    ASSERT_EQ(read.warnings.size(), 1U) << text;
    EXPECT_NE(read.warnings[0].find("a number is not finite, so it gives nothing"),
              std::string::npos);
  }
  const CsgRead read = read_csg("m.csg", "cylinder(h = 1, r1 = 2, r2 = 2, $fn = inf);");
  EXPECT_EQ(evaluate(read.tree).solid.volume(),
            evaluate(tree_of("cylinder(h = 1, r1 = 2, r2 = 2, $fn = 3);")).solid.volume());
  EXPECT_EQ(read.warnings,
            std::vector<std::string>{"1:1: cylinder: $fn is not finite, so it counts as 3"});
}

// OpenSCAD 2021.01 gives the same volumes and areas.
TEST(CsgReader, UnusualParametersMeanWhatTheyMeanInOpenScad) {
  const std::string affine = "[1,0,0,2],[0,1,0,4],[0,0,1,6]";
  const CsgRead projective = read_csg("m.csg", "multmatrix([" + affine + ",[0.5,0,0,2]]) cube(2);");
  EXPECT_EQ(evaluate(projective.tree).solid.volume(), Rational(1));
  EXPECT_EQ(projective.notes,
            std::vector<std::string>{
                "the first three numbers of the last row of a matrix have no effect"});
  EXPECT_EQ(evaluate(tree_of("polygon(points = [[0,0],[4,0],[4,4]], paths = []);")).shape.area(),
            Rational(8));
  const std::string text = "text(text = \"a\nb\", size = 0);";
  EXPECT_EQ(tree_of(text + " cube();").nodes.back().line, 2U);
}

TEST(CsgReader, OpenPolyhedraInHullsAreTheirPoints) {
  const std::string open =
      "polyhedron(points = [[0,0,0],[4,0,0],[0,4,0],[9,9,9]], faces = [[0,1,2]]);";
  const std::string cube = "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,3],[0,0,0,1]]) cube(1);";
  EXPECT_EQ(volume_of("hull() {" + open + cube + "}"), Rational(52, 3));
  EXPECT_EQ(volume_of("hull() { group() { multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) "
                      "color(\"red\") " +
                      open + "} " + cube + "}"),
            Rational(52, 3));
  EXPECT_TRUE(evaluate(tree_of("hull() " + open)).solid.is_empty());
  // Outside of hulls it is no solid.
  EXPECT_THROW(static_cast<void>(volume_of(open + "hull() {" + open + cube + "}")), Error);
  EXPECT_THROW(
      static_cast<void>(volume_of("hull() { difference() {" + open + cube + "} cube(); }")), Error);
}

// Parameters of versions of OpenSCAD after 2021.01.
TEST(CsgReader, ExtrusionsHaveDirectionsAndStarts) {
  const CsgResult sheared =
      evaluate(tree_of("linear_extrude(height = 5, v = [0.6, 0, 0.8], center = true) square(2);"));
  EXPECT_EQ(sheared.solid.volume(), Rational(16));
  EXPECT_TRUE(sheared.solid.contains(RationalPoint3{Rational(-3, 2), 1, Rational(-2)}));
  EXPECT_FALSE(sheared.solid.contains(RationalPoint3{Rational(-3, 2), 1, 2}));
  const auto turn = [](const std::string& parameters) {
    return evaluate(tree_of("rotate_extrude(" + parameters + ", $fn = 8) square([2, 1]);")).solid;
  };
  EXPECT_EQ(turn("angle = 90, start = 0"), turn("angle = 90"));
  EXPECT_EQ(turn("angle = 360, start = 180"), turn("angle = 360"));
  EXPECT_TRUE(turn("angle = 90, start = 90").contains(Point3{-1, 1, 0}));
  EXPECT_FALSE(turn("angle = 90, start = 90").contains(Point3{1, 1, 0}));
}

TEST(CsgReader, AMillionNestedGroupsAreRead) {
  constexpr std::size_t kDepth = 1000000;
  std::string text;
  for (std::size_t i = 0; i < kDepth; ++i) text += "group(){";
  EXPECT_THROW(tree_of(text), Error);  // Nothing closes them.
  const std::string closed = text + "cube();" + std::string(kDepth, '}');
  const CsgTree tree = tree_of(closed);
  EXPECT_EQ(tree.nodes.size(), kDepth + 2);
  EXPECT_EQ(evaluate(tree).solid.volume(), Rational(1));
}

TEST(CsgReader, HugeNumbersStayExact) {
  EXPECT_EQ(volume_of("cube(size = [1e308, 1e308, 1e308]);"),
            Rational(1e308) * Rational(1e308) * Rational(1e308));
  expect_refusal("cube(size = [1e309, 1, 1]);", ErrorCode::NumberOutOfRange, "m.csg:1:14: ");
}

TEST(CsgReader, LimitsOfMemoryHaveTheName) {
  Limits limits;
  limits.max_memory_bytes = 100000;
  Context context(limits);
  std::string text;
  for (int i = 0; i < 10000; ++i) text += "cube();\n";
  try {
    static_cast<void>(read_csg("m.csg", text, {}, context));
    FAIL() << "the limit is exceeded";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
  }
}

// ---------------------------------------------------------------- imports

/// A folder with a model, a mesh beside it, and one beside the folder.
class CsgImportsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    top_ = fs::path(::testing::TempDir()) / ("csg_imports_" + name);
    fs::remove_all(top_);
    fs::create_directories(top_ / "model" / "parts");
    for (const char* place : {"model/near.off", "model/parts/near.off", "far.off"}) {
      fs::copy_file("corpus/csg/pyramid.off", top_ / place);
    }
  }
  void TearDown() override { fs::remove_all(top_); }

  CsgRead read(const std::string& file, CsgImports imports = CsgImports::BelowModel) {
    const std::string model = (top_ / "model" / "m.csg").string();
    return read_csg(model, "import(file = \"" + file + "\");", {imports, false});
  }
  void expect_refused(const std::string& file, CsgImports imports = CsgImports::BelowModel) {
    try {
      static_cast<void>(read(file, imports));
      ADD_FAILURE() << "accepted: " << file;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::CannotOpen) << error.what();
      EXPECT_EQ(error.place().line, 1U);
      EXPECT_EQ(std::string(error.what()).find("OFF"), std::string::npos) << error.what();
    }
  }

  fs::path top_;
};

TEST_F(CsgImportsTest, FilesBelowTheModelAreRead) {
  EXPECT_EQ(evaluate(read("near.off").tree).solid.volume(), Rational(1));
  EXPECT_EQ(evaluate(read("parts/../parts/near.off").tree).solid.volume(), Rational(1));
}

TEST_F(CsgImportsTest, OtherFilesAreRefused) {
  expect_refused("../far.off");
  expect_refused((top_ / "far.off").string());
  fs::create_symlink(top_ / "far.off", top_ / "model" / "link.off");
  expect_refused("link.off");
  fs::create_directory_symlink(top_, top_ / "model" / "up");
  expect_refused("up/far.off");
  expect_refused("near.off", CsgImports::None);
  expect_refused("missing.off");
}

TEST_F(CsgImportsTest, OptionAllowsOtherFiles) {
  EXPECT_EQ(evaluate(read("../far.off", CsgImports::Anywhere).tree).solid.volume(), Rational(1));
}

TEST_F(CsgImportsTest, ErrorsOfImportedFilesNameBothPlaces) {
  std::ofstream(top_ / "model" / "bad.off") << "OFF\n1 0 0\n0 0 x\n";
  try {
    static_cast<void>(read("bad.off"));
    FAIL() << "the file is not valid";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("m.csg:1:1: import: "), std::string::npos) << text;
    EXPECT_NE(text.find("bad.off:3:5: "), std::string::npos) << text;
  }
}

// OpenSCAD refuses these polyhedra in Booleans, because some of their faces are flipped.
TEST(CsgReader, FlippedFacesOfPolyhedraAreTurned) {
  const std::string points = "polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = ";
  const CsgResult tetrahedron = evaluate(tree_of(points + "[[0,1,2],[0,1,3],[1,2,3],[2,0,3]]);"));
  EXPECT_EQ(tetrahedron.solid.volume(), Rational(1) / 6);
  ASSERT_EQ(tetrahedron.notes.size(), 1U);
  EXPECT_NE(tetrahedron.notes[0].find("1 face is oriented opposite"), std::string::npos);
  // A face is missing, and one of the others is flipped.
  EXPECT_THROW(evaluate(tree_of(points + "[[0,1,3],[3,2,1],[2,0,3]]);")), Error);
}

// Layer "a" has a square of side 2 at (4, 6), layer "b" one of side 1; layer "open" has a line.
TEST_F(CsgImportsTest, LayersOfDrawingsAreSelectedMovedAndScaled) {
  std::ofstream drawing(top_ / "model" / "plan.dxf");
  const auto add_square = [&drawing](const char* layer, int x, int y, int side) {
    drawing << "0\nLWPOLYLINE\n8\n" << layer << "\n70\n1\n";
    for (const auto& [i, j] :
         {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
      drawing << "10\n" << x + i * side << "\n20\n" << y + j * side << '\n';
    }
  };
  drawing << "0\nSECTION\n2\nENTITIES\n";
  add_square("a", 4, 6, 2);
  add_square("b", 10, 10, 1);
  drawing << "0\nLINE\n8\nopen\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n";
  drawing.close();
  const auto shape = [this](const std::string& parameters) {
    const std::string model = (top_ / "model" / "m.csg").string();
    const std::string text = "import(file = \"plan.dxf\", " + parameters + ");";
    return evaluate(read_csg(model, text, {CsgImports::BelowModel, false}).tree).shape;
  };
  EXPECT_EQ(shape("layer = \"a\"").area(), Rational(4));
  EXPECT_EQ(shape("layer = \"b\"").area(), Rational(1));
  EXPECT_TRUE(shape("layer = \"none\"").is_empty());
  EXPECT_EQ(shape("layer = \"\"").area(), Rational(5));  // The line of layer "open" is no area.
  const Nef2 moved = shape("layer = \"a\", origin = [4, 5], scale = 3");
  EXPECT_EQ(moved.area(), Rational(36));
  EXPECT_TRUE(moved.contains(RationalPoint2{0, 3}) && moved.contains(RationalPoint2{6, 9}));
  EXPECT_THROW(static_cast<void>(shape("layer = \"a\", scale = 0")), Error);
  // Two nodes may import different layers of one file.
  const std::string both =
      "import(file = \"plan.dxf\", layer = \"a\"); import(file = \"plan.dxf\", layer = \"b\");";
  const std::string model = (top_ / "model" / "m.csg").string();
  EXPECT_EQ(evaluate(read_csg(model, both, {CsgImports::BelowModel, false}).tree).shape.area(),
            Rational(5));
}

// OpenSCAD 2021.01 gives the same volumes. It scales the drawing and the top of the solid.
TEST_F(CsgImportsTest, ExtrusionsNameDrawings) {
  std::ofstream drawing(top_ / "model" / "plan.dxf");
  drawing << "0\nSECTION\n2\nENTITIES\n";
  for (const auto& [layer, x] : {std::pair("a", 0), std::pair("b", 10)}) {
    drawing << "0\nLWPOLYLINE\n8\n" << layer << "\n70\n1\n";
    for (const auto& [i, j] :
         {std::pair(0, 0), std::pair(2, 0), std::pair(2, 3), std::pair(0, 3)}) {
      drawing << "10\n" << x + i << "\n20\n" << j << '\n';
    }
  }
  drawing << "0\nENDSEC\n0\nEOF\n";
  drawing.close();
  const auto read = [this](const std::string& text) {
    return read_csg((top_ / "model" / "m.csg").string(), text, {CsgImports::BelowModel, false});
  };
  const auto volume = [&](const std::string& text) {
    return *evaluate(read(text).tree).solid.volume();
  };
  const std::string linear = "linear_extrude(file = \"plan.dxf\", layer = ";
  EXPECT_EQ(volume(linear + "\"\", height = 4, scale = [1, 1]);"), Rational(48));
  EXPECT_EQ(volume(linear + "\"b\", height = 4, scale = [1, 1]);"), Rational(24));
  EXPECT_EQ(volume(linear + "\"b\", origin = [5, 0], height = 3, scale = [2, 2]);"), Rational(168));
  const Nef3 centred = evaluate(read(linear + "\"b\", height = 4, center = true);").tree).solid;
  EXPECT_TRUE(centred.contains(RationalPoint3{10, 0, -2}));
  // Four steps of a quarter turn: a square with a square hole.
  EXPECT_NEAR(
      nearest_double(volume("rotate_extrude(file = \"plan.dxf\", layer = \"b\", origin = [0, "
                            "0], scale = 1, angle = 360, $fn = 4);")),
      3 * 2 * (144 - 100), 1e-9);
  // A child beside the drawing does not count; the drawing must lie below the model.
  const CsgRead both =
      read(linear + "\"b\", height = 4) { square(50); group() { cube(9); } } cube(1);");
  EXPECT_EQ(evaluate(both.tree).solid.volume(), Rational(25));
  EXPECT_EQ(both.notes,
            std::vector<std::string>{"the children of extrusions that name a file left out"});
  EXPECT_EQ(volume("linear_extrude(file = \"\", height = 2) square(3);"), Rational(18));
  EXPECT_THROW(static_cast<void>(read("linear_extrude(file = \"../plan.dxf\", height = 2);")),
               Error);
}

TEST_F(CsgImportsTest, DrawingsInSvgCanBeCentred) {
  std::ofstream(top_ / "model" / "plan.svg")
      << "<svg width='20mm' height='10mm' viewBox='0 0 40 20'><rect x='2' y='4' width='8' "
         "height='6'/></svg>";
  const auto shape = [this](const std::string& center) {
    const std::string text = "import(file = \"plan.svg\", center = " + center + ");";
    const std::string model = (top_ / "model" / "m.csg").string();
    return evaluate(read_csg(model, text, {CsgImports::BelowModel, false}).tree).shape;
  };
  EXPECT_EQ(shape("false"), rectangle({4, 3}, Placement::Corner).transformed({1, 0, 1, 0, 1, 5}));
  EXPECT_EQ(shape("true"), rectangle({4, 3}, Placement::Centred));
}

// OpenSCAD 2021.01 gives the same areas.
TEST_F(CsgImportsTest, DrawingsAreReadAsOpenScadReadsThem) {
  const auto area = [this](const std::string& entities, const std::string& parameters) {
    std::ofstream(top_ / "model" / "plan.dxf") << "0\nSECTION\n2\nENTITIES\n"
                                               << entities << "0\nENDSEC\n0\nEOF\n";
    const std::string model = (top_ / "model" / "m.csg").string();
    const std::string text = "import(file = \"plan.dxf\", layer = \"\", " + parameters + ");";
    const CsgRead read = read_csg(model, text, {CsgImports::BelowModel, false});
    return nearest_double(evaluate(read.tree).shape.area().value());
  };
  // Two sides of a triangle: a straight line closes them.
  const std::string sides =
      "0\nLINE\n10\n0\n20\n0\n11\n4\n21\n0\n0\nLINE\n10\n4\n20\n0\n11\n4\n21\n3\n";
  EXPECT_EQ(area(sides, "scale = 1"), 6);
  // A hexagon of radius 1, and a half of a hexagon with a line.
  const std::string circle = "0\nCIRCLE\n10\n0\n20\n0\n40\n1\n";
  EXPECT_NEAR(area(circle, "$fn = 6"), 3 * std::sqrt(3) / 2, 1e-12);
  EXPECT_NEAR(area(circle, "$fn = 4, scale = 3"), 18, 1e-12);
  EXPECT_NEAR(area(circle, "$fn = 0, $fa = 90, $fs = 9"),
              5 * std::sin(0.4 * 3.14159265358979323846) / 2, 1e-12);
  const std::string arc = "0\nARC\n10\n0\n20\n0\n40\n1\n50\n90\n51\n270\n";
  EXPECT_NEAR(area(arc, "$fn = 6"), 3 * std::sqrt(3) / 4, 1e-12);
  // A hatch is no line.
  const std::string hatch =
      "0\nHATCH\n91\n1\n92\n2\n72\n0\n73\n1\n93\n3\n10\n0\n20\n0\n10\n9\n20\n0\n10\n9\n20\n9\n";
  EXPECT_EQ(area(sides + hatch, "scale = 1"), 6);
}

TEST_F(CsgImportsTest, SurfacesAreFieldsOfHeights) {
  std::ofstream(top_ / "model" / "field.dat") << "# heights\n1 2\n\n3 2\n";
  std::ofstream(top_ / "model" / "bad.dat") << "1 2\n1 x\n";
  std::ofstream(top_ / "model" / "row.dat") << "1 2 3\n";
  const std::string model = (top_ / "model" / "m.csg").string();
  const auto read = [&](const std::string& text) {
    return read_csg(model, text, {CsgImports::BelowModel, false});
  };
  const CsgRead both = read(
      "surface(file = \"field.dat\", center = true);\n"
      "multmatrix([[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]])"
      " surface(\"field.dat\", invert = true, timestamp = 3);");
  EXPECT_EQ(both.notes, std::vector<std::string>());
  const Nef3 solid = evaluate(both.tree).solid;
  EXPECT_EQ(solid.volume(), Rational(4));  // The mean height is 2, and the bottom is at 0.
  EXPECT_TRUE(solid.contains(Point3{-0.5, -0.5, 1}) && solid.contains(Point3{5, 1, 3}));
  EXPECT_EQ(read("surface(\"row.dat\");").notes.size(), 1U);
  try {
    static_cast<void>(read("surface(\"bad.dat\");"));
    FAIL() << "the file is not valid";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("m.csg:1:1: surface: "), std::string::npos) << text;
    EXPECT_NE(text.find("bad.dat:2:3: "), std::string::npos) << text;
  }
}

// The areas are those of OpenSCAD 2021.01, which rounds coordinates to multiples of 2^-16. Arcs of
// a quarter turn would have 1.25, 2.5, 1.5, 2.5 and 1.25 chords.
TEST(CsgReader, OffsetsHaveTheChordsOfOpenScad) {
  const std::string square = "square(size = [10, 10], center = false);";
  const std::string angle =
      "polygon(points = [[0, 0], [10, 0], [10, 3], [3, 3], [3, 10], [0, 10]], paths = undef);";
  const std::vector<std::tuple<std::string, std::string, double>> cases{
      {"r = 1, $fn = 0, $fa = 12, $fs = 2", square, 142},
      {"r = 1, $fn = 10, $fa = 12, $fs = 2", square, 142.793605},
      {"r = -0.5, $fn = 6, $fa = 12, $fs = 2", angle, 32.125},
      {"r = -1, $fn = 10, $fa = 12, $fs = 2", angle, 15.3016},
      {"r = -1, $fn = 0, $fa = 12, $fs = 2", angle, 15.5}};
  for (const auto& [options, shape, area] : cases) {
    const CsgRead read = read_csg("m", "offset(" + options + ") { " + shape + " }");
    EXPECT_NEAR(nearest_double(evaluate(read.tree).shape.area().value()), area, 1e-4) << options;
  }
}

TEST(CsgReader, ReadsTheCorpus) {
  const CsgRead bracket = read_csg_file("corpus/csg/bracket.csg");
  const Nef3 solid = evaluate(bracket.tree).solid;
  EXPECT_TRUE(solid.is_simple());
  EXPECT_EQ(solid.counts().marked_volumes, 1U);
  EXPECT_EQ(bracket.notes.size(), 1U);  // The modifier %.
  EXPECT_EQ(evaluate(read_csg_file("corpus/csg/imports.csg").tree).solid.volume(), Rational(2));
  const CsgResult gasket = evaluate(read_csg_file("corpus/csg/gasket.csg").tree);
  EXPECT_EQ(gasket.dimension, CsgDimension::Plane);
  // A rectangle with rounded corners, without an ellipse and two disks.
  const double area = nearest_double(gasket.shape.area().value());
  EXPECT_NEAR(area, 46 * 26 - (4 - 3.1415) * 9 - 3.1415 * (12 * 12 + 2 * 4), 10);
}

}  // namespace
}  // namespace plumb::testing::csg_reader_test
