// AMF: volumes are those of a tetrahedron, times what units, scales and copies must give; places of
// instances are computed here.
#include "plumb/io/mesh/amf.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "expect_refusals.h"
#include "plumb/io/mesh/threemf_archive.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/solid_io.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational.h"
#include "threemf_archives.h"

namespace plumb::testing::amf_test {
namespace {

class Amf : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_threemf()) GTEST_SKIP() << "built without libzip and expat";
  }
};

MeshFile read(const std::string& bytes, bool attributes = false) {
  Context context;
  ReadOptions options{"some.file"};
  options.attributes = attributes;
  return read_amf(bytes, options, context);
}

/// A tetrahedron with the corners 0, x, y and z. Line 2 has the vertices, line 4 the triangles.
std::string object(int id, const std::string& of_volume = "", const std::string& in_volume = "") {
  std::string text = "<object id=\"" + std::to_string(id) + "\"><mesh>\n<vertices>";
  for (const auto& [x, y, z] : {std::array{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    text += "<vertex><coordinates><x>" + std::to_string(x) + "</x><y>" + std::to_string(y) +
            "</y><z>" + std::to_string(z) + "</z></coordinates></vertex>";
  }
  text += "</vertices>\n<volume" + of_volume + ">" + in_volume + "\n";
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    text += "<triangle><v1>" + std::to_string(a) + "</v1><v2>" + std::to_string(b) + "</v2><v3>" +
            std::to_string(c) + "</v3></triangle>";
  }
  return text + "</volume></mesh></object>";
}

std::string amf(const std::string& contents, const std::string& unit = "millimeter") {
  return "<amf unit=\"" + unit + "\">" + contents + "</amf>";
}

std::string constellation(int id, const std::string& instances) {
  return "<constellation id=\"" + std::to_string(id) + "\">" + instances + "</constellation>";
}

std::string instance(int object, const std::string& placement = "") {
  return "<instance objectid=\"" + std::to_string(object) + "\">" + placement + "</instance>";
}

Rational volume_of(const std::string& bytes) {
  const MeshFile file = read(bytes);
  return *Nef3::from_mesh(file.mesh).volume();
}

/// Whether the solid contains a point in the interior of the tetrahedron after a map.
bool contains(const std::string& bytes, const RationalPoint3& p) {
  return Nef3::from_mesh(read(bytes).mesh).contains(p);
}

TEST_F(Amf, ObjectsHaveTheUnitOfTheFile) {
  const Rational sixth = Rational(1) / 6;
  const auto cubed = [](const Rational& x) { return x * x * x; };
  EXPECT_EQ(volume_of(amf(object(0))), sixth);
  EXPECT_EQ(volume_of("<amf>" + object(0) + "</amf>"), sixth);
  EXPECT_EQ(volume_of(amf(object(0), "inch")), sixth * cubed(Rational(127) / 5));
  EXPECT_EQ(volume_of(amf(object(0), "feet")), sixth * cubed(Rational(1524) / 5));
  EXPECT_EQ(volume_of(amf(object(0), "meter")), sixth * cubed(1000));
  EXPECT_EQ(volume_of(amf(object(0), "micron")), sixth / cubed(1000));
  EXPECT_EQ(read(amf(object(0), "inch")).notes,
            std::vector<std::string>{"the unit is the inch; the coordinates are scaled to "
                                     "millimetres"});
}

TEST_F(Amf, ConstellationsPlaceObjects) {
  // SolidWorks writes one instance that moves nothing; Slic3r uses the id of an object again.
  EXPECT_EQ(volume_of(amf(object(7) + constellation(0, instance(7)))), Rational(1) / 6);
  EXPECT_EQ(volume_of(amf(object(0) + object(1) + constellation(1, instance(0)))), Rational(1) / 6)
      << "object 1 is placed by itself, at the place of the copy of object 0";
  const std::string moved = "<deltax>5</deltax><deltay>-2</deltay><deltaz>0.5</deltaz>";
  const std::string two = amf(object(0) + constellation(0, instance(0) + instance(0, moved)));
  EXPECT_EQ(volume_of(two), Rational(1) / 3);
  EXPECT_TRUE(contains(two, {Rational(51) / 10, Rational(-19) / 10, Rational(6) / 10}));
  EXPECT_EQ(volume_of(amf(object(0) + constellation(1, instance(0) + instance(0, moved)) +
                          constellation(2, instance(1) + instance(1, "<deltaz>9</deltaz>")))),
            Rational(2) / 3);
  EXPECT_EQ(volume_of(amf(object(0) + constellation(0, instance(0, moved)), "inch")),
            volume_of(amf(object(0), "inch")));
}

TEST_F(Amf, RotationsAreAboutXThenYThenZ) {
  // The corner x goes to -z about y; the corner y goes to z about x.
  const auto turned = [](const std::string& angles, const RationalPoint3& p) {
    return contains(amf(object(0) + constellation(0, instance(0, angles))), p);
  };
  const Rational tenth = Rational(1) / 10;
  EXPECT_TRUE(turned("<rx>90</rx>", {tenth, -tenth, tenth}));
  EXPECT_TRUE(turned("<ry>90</ry>", {tenth, tenth, -tenth}));
  EXPECT_TRUE(turned("<rz>90</rz>", {-tenth, tenth, tenth}));
  // (x, y, z) to (x, -z, y), then to (y, -z, -x), then to (z, y, -x).
  EXPECT_TRUE(turned("<rx>90</rx><ry>90</ry><rz>90</rz>", {tenth * 2, tenth * 3, -tenth}));
  EXPECT_EQ(volume_of(amf(object(0) + constellation(0, instance(0, "<rz>30</rz>")))),
            Rational(1) / 6);
  // Slic3r writes scales and mirrors.
  EXPECT_EQ(volume_of(amf(object(0) +
                          constellation(0, instance(0, "<scale>2</scale><scalex>3</scalex>")))),
            Rational(4));
  EXPECT_TRUE(turned("<mirrorx>-1</mirrorx><mirrory>1</mirrory>", {-tenth, tenth, tenth}));
  EXPECT_TRUE(turned("<mirrorx>1</mirrorx><mirrory>1</mirrory><mirrorz>1</mirrorz>",
                     {tenth, tenth, tenth}));
}

// Slic3r and its descendants write radians with nine digits: a right angle is exact.
TEST_F(Amf, Slic3rWritesRadians) {
  const Rational tenth = Rational(1) / 10;
  for (const std::string metadata : {R"(<metadata type="cad">Slic3r 1.3.0</metadata>)",
                                     R"(<metadata type="cad">PrusaSlicer 2.6.0</metadata>)",
                                     R"(<metadata type="slic3rpe_amf_version">5</metadata>)"}) {
    const std::string text =
        amf(metadata + object(0) + constellation(0, instance(0, "<rz>1.57079633</rz>")));
    EXPECT_TRUE(contains(text, {-tenth, tenth, tenth})) << metadata;
    EXPECT_FALSE(contains(text, {tenth, tenth, tenth})) << metadata;
    EXPECT_EQ(volume_of(text), Rational(1) / 6) << metadata;
  }
  const std::string other = amf(R"(<metadata type="cad">OpenSCAD</metadata>)" + object(0) +
                                constellation(0, instance(0, "<rz>90</rz>")));
  EXPECT_TRUE(contains(other, {-tenth, tenth, tenth}));
  // All settings of a program may be in one text.
  const std::string settings = "<metadata type=\"slic3r.config\">" + std::string(3U << 20U, 'x');
  EXPECT_EQ(volume_of(amf(settings + "</metadata>" + object(0))), Rational(1) / 6);
}

TEST_F(Amf, VolumesThatAreNoPartsAreLeftOut) {
  for (const auto& [of, in, warning] :
       {std::tuple(" type=\"support\"", "", "support volumes"),
        std::tuple("", "<metadata type=\"slic3r.modifier\">1</metadata>", "modifier volumes"),
        std::tuple("", "<metadata type=\"slic3r.volume_type\">SupportBlocker</metadata>",
                   "support blockers")}) {
    const MeshFile file = read(amf(object(0) + object(1, of, in)));
    EXPECT_EQ(file.mesh.face_count(), 4U);
    ASSERT_EQ(file.warnings.size(), 1U);
    EXPECT_NE(file.warnings[0].find(warning), std::string::npos);
  }
  std::string curved = amf(object(0));
  curved.insert(curved.find("</vertex>"), "<normal><nx>0</nx><ny>0</ny><nz>1</nz></normal>");
  EXPECT_NE(read(curved).warnings.at(0).find("curvature"), std::string::npos);
}

TEST_F(Amf, ColoursAndNamesAreKept) {
  const std::string red = "<color><r>1</r><g>0</g><b>0</b></color>";
  const std::string material =
      "<material id=\"3\"><metadata type=\"name\">rubber</metadata>" + red + "</material>";
  std::string text = amf(object(0, " materialid=\"3\"") + material);
  text.insert(text.find("</triangle>"), "<color><r>0</r><g>0.5</g><b>0</b><a>0.25</a></color>");
  text.insert(text.find("<mesh>"), "<metadata type=\"name\">part</metadata>");
  const MeshFile file = read(text, true);
  const MeshAttributes& all = file.attributes;
  ASSERT_EQ(all.face_material.size(), 4U);
  EXPECT_EQ(all.materials[all.face_material[0]].color, (std::array{0.0, 0.5, 0.0, 0.25}));
  EXPECT_EQ(all.materials[all.face_material[1]].color, (std::array{1.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(all.materials[all.face_material[3]].name, "rubber");
  ASSERT_EQ(all.face_group.size(), 4U);
  EXPECT_EQ(all.groups[all.face_group[2]], "part");
  EXPECT_TRUE(read(text).attributes.empty());
  const MeshFile volume = read(amf(object(0, "", red)), true);
  EXPECT_EQ(volume.attributes.materials.at(0).color, (std::array{1.0, 0.0, 0.0, 1.0}));
}

TEST_F(Amf, FilesCanBePackedAndHaveAnyName) {
  const std::string text = "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n" + amf(object(0));
  EXPECT_TRUE(begins_like_amf(text));
  EXPECT_FALSE(begins_like_amf("<amfora>") || begins_like_amf("a <amf >") || begins_like_amf(""));
  EXPECT_EQ(guess_mesh_format(text), MeshFormat::Amf);
  EXPECT_EQ(mesh_format_of("a.amf"), MeshFormat::Amf);
  EXPECT_EQ(volume_of(zip_of({{"folder/part.amf", text}})), Rational(1) / 6);
  EXPECT_EQ(volume_of(zip_of({{"part", text}})), Rational(1) / 6);
  std::ostringstream out;
  EXPECT_THROW(write_mesh(out, read(text).mesh, MeshFormat::Amf), Error);
  EXPECT_THROW(write_mesh_file("a.amf", read(text).mesh), Error);
}

TEST_F(Amf, RefusesBrokenFiles) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = amf(object(0));
    return text.replace(text.find(from), from.size(), to);
  };
  expect_refusals(
      {{"another root", "<svg/>", 1, 1, "'svg', not an amf"},
       {"unclosed", "<amf><object id=\"0\">\n", 2, 1, "no element found"},
       {"a document type", "<!DOCTYPE amf>\n<amf/>", 1, 14, "DOCTYPE"},
       {"a unit", amf("", "parsec"), 1, 1, "'parsec'"},
       {"no id", "<amf>\n<object/></amf>", 2, 1, "object needs a whole number id"},
       {"an id twice", amf(object(0) + "\n" + object(0)), 5, 1, "a second object"},
       {"a corner", changed("<v3>1</v3>", "<v3>4</v3>"), 4, 41, "v3 is vertex 4"},
       {"a corner that is no number", changed("<v3>1</v3>", "<v3>x</v3>"), 4, 36,
        "v3 is 'x', not a whole number"},
       {"a missing corner", changed("<v3>1</v3>", ""), 4, 31, "lacks v3"},
       {"a coordinate", changed("<x>1</x>", "<x>nan</x>"), 2, 106, "x: expected a number"},
       {"a missing coordinate", changed("<x>1</x>", ""), 2, 130, "lacks one of x, y and z"},
       {"no such object", amf(object(0) + "\n" + constellation(1, instance(7))), 5, 23,
        "no object 7"},
       {"a scale of 0", amf(object(0) + constellation(1, instance(0, "<scale>0</scale>"))), 4, 291,
        "flat"},
       {"a cycle", amf(object(0) + constellation(1, instance(2)) + constellation(2, instance(1))),
        0, 0, "constellation 1 contains itself"},
       {"a constellation of itself",
        amf(object(0) + "\n" + constellation(1, instance(2)) + constellation(2, instance(2))), 5,
        95, "contains itself"}},
      [](const std::string& bytes) { static_cast<void>(read(bytes)); });
}

}  // namespace
}  // namespace plumb::testing::amf_test
