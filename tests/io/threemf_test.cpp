// 3MF: placements are compared with maps of points in rationals that are computed here, volumes of
// sets with determinants, and written files with what the Core Specification requires.
#include "plumb/io/mesh/threemf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "expect_refusals.h"
#include "mesh_checks.h"
#include "plumb/io/mesh/threemf_archive.h"
#include "plumb/io/solid_io.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/space_measure.h"
#include "threemf_archives.h"

namespace plumb::threemf_test {
namespace {

using testing::kThreeMfTetrahedron;
using testing::threemf_model;
using testing::threemf_object;
using testing::threemf_of;
using testing::zip_of;

/// All tests need the libraries.
class ThreeMf : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_threemf()) GTEST_SKIP() << "built without libzip and expat";
  }
};

MeshFile read(const std::string& bytes, bool exact_decimals = false, Limits limits = {}) {
  Context context(limits);
  return read_threemf(bytes, {"some.file", exact_decimals}, context);
}

const std::string kObject = threemf_object(1, kThreeMfTetrahedron);

std::string item(const std::string& transform = "", int object = 1) {
  const std::string placed = transform.empty() ? "" : " transform=\"" + transform + "\"";
  return "<item objectid=\"" + std::to_string(object) + "\"" + placed + "/>";
}

RationalPoint3 point_of(const PolygonMesh& mesh, std::uint32_t i) {
  for (const auto& [index, p] : mesh.exact) {
    if (index == i) return p;
  }
  const Point3& p = mesh.points[i];
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

Rational volume_of(const std::string& bytes) {
  const Nef3 set = read_solid("a.3mf", bytes).set;
  return marked_volume(set.complex()).value();
}

bool has_sentence(const std::vector<std::string>& sentences, const std::string& part) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& each) { return each.find(part) != each.npos; });
}

TEST_F(ThreeMf, reads_an_item_without_a_transform_as_it_is) {
  const MeshFile file = read(threemf_of(threemf_model(kObject, item())));
  EXPECT_TRUE(testing::is_same(file.mesh, testing::tetrahedron()));
  EXPECT_TRUE(file.notes.empty());
  EXPECT_TRUE(file.warnings.empty());
}

/// The image of (x, y, z) under the twelve numbers of a transform, as the specification defines it.
RationalPoint3 image(const std::array<Rational, 12>& m, const RationalPoint3& p) {
  return {m[0] * p.x + m[3] * p.y + m[6] * p.z + m[9], m[1] * p.x + m[4] * p.y + m[7] * p.z + m[10],
          m[2] * p.x + m[5] * p.y + m[8] * p.z + m[11]};
}

TEST_F(ThreeMf, applies_transforms_exactly) {
  const std::string text = "0.8 0.6 0 -0.6 0.8 0.25 0 0 -1.1 120.1 99.7 1e-9";
  std::array<Rational, 12> m;
  std::istringstream words(text);
  for (Rational& entry : m) {
    double value = 0;
    words >> value;
    entry = Rational(value);
  }
  const PolygonMesh mesh = read(threemf_of(threemf_model(kObject, item(text)))).mesh;
  const PolygonMesh plain = testing::tetrahedron();
  ASSERT_EQ(mesh.points.size(), plain.points.size());
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(point_of(mesh, i), image(m, point_of(plain, i)));
  const Rational determinant = m[8] * (m[0] * m[4] - m[1] * m[3]);
  EXPECT_EQ(volume_of(threemf_of(threemf_model(kObject, item(text)))), -determinant / 6);
}

TEST_F(ThreeMf, a_mirror_turns_triangles_around) {
  const PolygonMesh mesh =
      read(threemf_of(threemf_model(kObject, item("-1 0 0 0 1 0 0 0 1 0 0 0")))).mesh;
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}));
}

TEST_F(ThreeMf, composes_the_transforms_of_components) {
  const std::string inner =
      "<components><component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 "
      "5 0 0\"/></components>";
  const std::string outer =
      "<components><component objectid=\"2\" transform=\"2 0 0 0 1 0 0 0 1 "
      "0 0 7\"/><component objectid=\"1\"/></components>";
  const std::string resources = kObject + threemf_object(2, inner) + threemf_object(3, outer);
  const PolygonMesh mesh =
      read(threemf_of(threemf_model(resources, item("1 0 0 0 1 0 0 0 1 0 100 0", 3)))).mesh;
  ASSERT_EQ(mesh.points.size(), 8U);
  // (1, 0, 0) is turned to (0, 1, 0), moved to (5, 1, 0), stretched to (10, 1, 0), and moved twice.
  EXPECT_EQ(mesh.points[1], (Point3{10, 101, 7}));
  EXPECT_EQ(mesh.points[2], (Point3{8, 100, 7}));
  EXPECT_EQ(mesh.points[5], (Point3{1, 100, 0}));
}

TEST_F(ThreeMf, overlapping_items_unite) {
  const std::string bytes =
      threemf_of(threemf_model(kObject, item() + item() + item("1 0 0 0 1 0 0 0 1 5 0 0")));
  EXPECT_EQ(volume_of(bytes), Rational(1, 3));
}

TEST_F(ThreeMf, scales_units_exactly) {
  const auto volume = [](const std::string& unit) {
    return volume_of(threemf_of(
        threemf_model(kObject, item("1 0 0 0 1 0 0 0 1 3 0 0"), "unit=\"" + unit + "\"")));
  };
  const auto cube = [](const Rational& side) { return side * side * side / 6; };
  EXPECT_EQ(volume("micron"), cube(Rational(1, 1000)));
  EXPECT_EQ(volume("millimeter"), cube(1));
  EXPECT_EQ(volume("centimeter"), cube(10));
  EXPECT_EQ(volume("inch"), cube(Rational(127, 5)));
  EXPECT_EQ(volume("foot"), cube(Rational(1524, 5)));
  EXPECT_EQ(volume("meter"), cube(1000));
  const MeshFile file =
      read(threemf_of(threemf_model(kObject, item("1 0 0 0 1 0 0 0 1 3 0 0"), "unit=\"inch\"")));
  EXPECT_EQ(point_of(file.mesh, 0), (RationalPoint3{Rational(381, 5), 0, 0}));
  EXPECT_TRUE(has_sentence(file.notes, "the inch"));
}

TEST_F(ThreeMf, reads_decimals_exactly_on_request) {
  std::string object = kObject;
  object.replace(object.find("x=\"1\""), 5, "x=\"0.1\"");
  const std::string bytes = threemf_of(threemf_model(object, item("0.1 0 0 0 1 0 0 0 1 0.3 0 0")));
  EXPECT_EQ(point_of(read(bytes, true).mesh, 1).x, Rational(31, 100));
  EXPECT_EQ(point_of(read(bytes).mesh, 1).x, Rational(0.1) * Rational(0.1) + Rational(0.3));
}

TEST_F(ThreeMf, reads_objects_of_other_parts) {
  const std::string other =
      threemf_model(threemf_object(7, kThreeMfTetrahedron) +
                        threemf_object(8, "<components><component objectid=\"7\"/></components>"),
                    item("", 7), "unit=\"centimeter\"");
  const std::string place =
      "<component p:path=\"/3D/Objects/a%20b.model\" objectid=\"8\" "
      "transform=\"1 0 0 0 1 0 0 0 1 2 0 0\"/>";
  const std::string bytes =
      threemf_of(threemf_model(threemf_object(1, "<components>" + place + place + "</components>"),
                               item(), "requiredextensions=\"p\""),
                 {{"3D/Objects/a b.model", other}});
  const MeshFile file = read(bytes);
  ASSERT_EQ(file.mesh.points.size(), 8U);
  EXPECT_EQ(file.mesh.points[1], (Point3{12, 0, 0}));  // One centimetre and two millimetres.
}

TEST_F(ThreeMf, leaves_out_what_slicers_do_not_print) {
  const std::string two =
      "<components><component objectid=\"1\"/><component objectid=\"2\" "
      "transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"/></components>";
  const std::string resources =
      kObject + threemf_object(2, kThreeMfTetrahedron) + threemf_object(3, two);
  const std::string bambu =
      "<config><object id=\"3\"><metadata key=\"name\" value=\"x\"/><part id=\"1\" "
      "subtype=\"normal_part\"/><part id=\"2\" subtype=\"negative_part\"/></object></config>";
  const MeshFile parts = read(threemf_of(threemf_model(resources, item("", 3)),
                                         {{"Metadata/model_settings.config", bambu}}));
  EXPECT_TRUE(testing::is_same(parts.mesh, testing::tetrahedron()));
  EXPECT_TRUE(has_sentence(parts.warnings, "negative volumes"));

  const auto prusa = [](const std::string& kind) {
    return "<config><object id=\"1\"><volume firstid=\"0\" lastid=\"2\"><metadata type=\"volume\" "
           "key=\"volume_type\" value=\"ModelPart\"/></volume><volume firstid=\"3\" "
           "lastid=\"3\"><metadata type=\"volume\" " +
           kind + "/></volume></object></config>";
  };
  for (const std::string kind :
       {"key=\"volume_type\" value=\"SupportBlocker\"", "key=\"modifier\" value=\"1\""}) {
    const MeshFile ranges = read(threemf_of(threemf_model(kObject, item()),
                                            {{"Metadata/Slic3r_PE_model.config", prusa(kind)}}));
    EXPECT_EQ(ranges.mesh.face_count(), 3U) << kind;
    EXPECT_EQ(ranges.warnings.size(), 1U);
  }
  const std::string cura =
      "<item objectid=\"1\"><metadatagroup><metadata name=\"cura:support_mesh\">True</metadata>"
      "<metadata name=\"cura:infill_mesh\">True</metadata></metadatagroup></item>";
  const MeshFile items = read(threemf_of(threemf_model(kObject, item() + cura + item())));
  EXPECT_EQ(items.mesh.face_count(), 8U);
  EXPECT_TRUE(has_sentence(items.warnings, "support volumes"));

  const std::string support = threemf_object(2, kThreeMfTetrahedron, "type=\"support\"");
  const MeshFile objects = read(threemf_of(threemf_model(kObject + support, item() + item("", 2))));
  EXPECT_EQ(objects.mesh.face_count(), 4U);
  EXPECT_TRUE(has_sentence(objects.warnings, "support objects"));
}

TEST_F(ThreeMf, names_what_it_does_not_read) {
  const std::string beams =
      "<b:beamlattice xmlns:b=\"urn:b\"><b:beams><b:beam v1=\"0\"/>"
      "</b:beams></b:beamlattice></mesh>";
  std::string object = kObject;
  object.replace(object.find("</mesh>"), 7, beams);
  const MeshFile file = read(threemf_of(
      threemf_model("<basematerials id=\"5\"><base name=\"a\"/></basematerials><odd/>" + object,
                    item()),
      {{"Metadata/thumbnail.png", "x"}, {"Metadata/project.config", "x"}, {"notes.txt", "x"}}));
  for (const char* what : {"materials and colours", "elements 'odd'", "pictures",
                           "settings of slicers", "other files"}) {
    EXPECT_TRUE(has_sentence(file.notes, what)) << what;
  }
  EXPECT_TRUE(has_sentence(file.warnings, "beam lattices"));
}

// ---------------------------------------------------------------- looks

const std::string kLookSpaces =
    "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
    "xmlns:t=\"http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07\"";

/// Reads a model with its attributes.
MeshFile read_looks(const std::string& resources, const std::string& items, Limits limits = {}) {
  Context context(limits);
  ReadOptions options{"some.file"};
  options.attributes = true;
  return read_threemf(threemf_of(threemf_model(resources, items, kLookSpaces)), options, context);
}

/// Returns the tetrahedron with attributes of its four triangles, and more behind them.
std::string tetrahedron_with(const std::array<std::string, 4>& attributes,
                             const std::string& more = "") {
  std::string mesh = kThreeMfTetrahedron;
  std::size_t at = 0;
  for (const std::string& each : attributes) {
    at = mesh.find("/>", mesh.find("<triangle ", at + 1));
    mesh.insert(at, " " + each);
  }
  return mesh.insert(mesh.find("</mesh>"), more);
}

const std::string kTwoMaterials =
    "<basematerials id=\"5\"><base name=\"Red\" displaycolor=\"#FF0000\"/>"
    "<base name=\"Glass\" displaycolor=\"#0000FF33\"/></basematerials>"
    "<m:colorgroup id=\"6\"><m:color color=\"#00ff00\"/><m:color color=\"#00000066\"/>"
    "</m:colorgroup>";

using Rgba = std::array<double, 4>;

/// The colour of a corner of a face: that of the material times that of the corner.
std::optional<Rgba> color_at(const MeshFile& file, std::size_t face, std::size_t corner) {
  const MeshAttributes& all = file.attributes;
  std::optional<Rgba> color;
  if (!all.face_material.empty() && all.face_material[face] != MeshAttributes::kNone) {
    color = all.materials[all.face_material[face]].color;
  }
  for (const MeshChannel& channel : all.channels) {
    if (channel.name != "color") continue;
    if (!color) color = Rgba{1, 1, 1, 1};
    for (std::size_t k = 0; k < channel.width; ++k) {
      (*color)[k] *= channel.values[(3 * face + corner) * channel.width + k];
    }
  }
  return color;
}

TEST_F(ThreeMf, reads_materials_and_colours) {
  const std::string object =
      threemf_object(1,
                     tetrahedron_with({"pid=\"5\" p1=\"1\"", "",
                                       "pid=\"6\" p1=\"0\" p2=\"1\" p3=\"0\"", "p1=\"0\""}),
                     "pid=\"5\" pindex=\"0\"");
  const MeshFile file = read_looks(kTwoMaterials + object, item());
  EXPECT_TRUE(file.notes.empty());
  ASSERT_EQ(file.attributes.face_material.size(), 4U);
  EXPECT_EQ(file.attributes.materials[file.attributes.face_material[0]].name, "Glass");
  EXPECT_EQ(file.attributes.materials[file.attributes.face_material[1]].name, "Red");
  EXPECT_EQ(file.attributes.materials[file.attributes.face_material[3]].name, "Red");
  EXPECT_EQ(color_at(file, 0, 2), (Rgba{0, 0, 1, 0.2}));
  EXPECT_EQ(color_at(file, 1, 0), (Rgba{1, 0, 0, 1}));
  EXPECT_EQ(file.attributes.face_material[2], MeshAttributes::kNone);
  EXPECT_EQ(color_at(file, 2, 0), (Rgba{0, 1, 0, 1}));
  EXPECT_EQ(color_at(file, 2, 1), (Rgba{0, 0, 0, 0.4}));
  EXPECT_EQ(color_at(file, 2, 2), (Rgba{0, 1, 0, 1}));
  EXPECT_TRUE(read(threemf_of(threemf_model(kTwoMaterials + object, item(), kLookSpaces)))
                  .attributes.empty());
}

TEST_F(ThreeMf, a_mirror_turns_the_colours_of_corners) {
  const std::string object =
      threemf_object(1, tetrahedron_with({"", "pid=\"6\" p1=\"0\" p2=\"0\" p3=\"1\"", "", ""}));
  const std::string mirror = item("-1 0 0 0 1 0 0 0 1 0 0 0");
  const MeshFile file = read_looks(kTwoMaterials + object, item() + mirror);
  ASSERT_EQ(file.mesh.face_count(), 8U);
  for (std::size_t f = 0; f < 8; ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      // Triangle 1 has the corners 0, 1 and 3; the last one, at the top, is black.
      const bool is_top = file.mesh.points[file.mesh.face(f)[i]].z == 1;
      const Rgba expected = f % 4 != 1 ? Rgba{1, 1, 1, 1}
                            : is_top   ? Rgba{0, 0, 0, 0.4}
                                       : Rgba{0, 1, 0, 1};
      EXPECT_EQ(color_at(file, f, i), expected) << f << ' ' << i;
    }
  }
}

TEST_F(ThreeMf, names_of_objects_and_sets_of_triangles_are_groups) {
  const std::string sets =
      "<t:trianglesets><t:triangleset name=\"top\" identifier=\"a\"><t:refrange startindex=\"2\" "
      "endindex=\"3\"/></t:triangleset><t:triangleset name=\"low\" identifier=\"b\">"
      "<t:ref index=\"0\"/><t:ref index=\"2\"/></t:triangleset></t:trianglesets>";
  const std::string inner = threemf_object(1, tetrahedron_with({"", "", "", ""}, sets));
  const std::string outer = threemf_object(
      2, "<components><component objectid=\"1\"/></components>", "name=\"Part &lt;1&gt;\"");
  const MeshFile file = read_looks(inner + outer, item("", 2) + item("", 1));
  std::vector<std::string> names;
  for (const std::uint32_t g : file.attributes.face_group) {
    names.push_back(g == MeshAttributes::kNone ? "-" : file.attributes.groups[g]);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"low", "Part <1>", "top", "top", "low", "-", "top", "top"}));
}

TEST_F(ThreeMf, what_is_wrong_with_looks_is_named) {
  struct Case {
    std::string resources;
    std::string triangle;
    std::string note;
  };
  const std::vector<Case> cases{
      {"", "pid=\"9\" p1=\"0\"", "references to materials that are not read"},
      {kTwoMaterials, "pid=\"5\" p1=\"2\"", "references to materials that are not read"},
      {kTwoMaterials, "pid=\"5\" p1=\"-1\"", "references to materials that are not read"},
      {kTwoMaterials, "pid=\"5\" p1=\"4294967296\"", "references to materials that are not read"},
      {kTwoMaterials, "pid=\"6\" p1=\"0\" p2=\"x\"", "references to materials that are not read"},
      {kTwoMaterials, "p1=\"0\"", "references to materials that are not read"},
      {"<m:colorgroup id=\"1\"><m:color color=\"red\"/></m:colorgroup>", "",
       "colours that are not #RRGGBB"},
      {"<m:colorgroup id=\"1\"><m:color color=\"#ggffff\"/></m:colorgroup>", "",
       "colours that are not #RRGGBB"},
      {"<m:colorgroup><m:color color=\"#ffffff\"/></m:colorgroup>", "", "without an id"},
      {kTwoMaterials + kTwoMaterials, "", "with the id of another one"},
      {"<m:texture2dgroup id=\"8\" texid=\"7\"/>", "pid=\"8\" p1=\"0\"", "textures"},
      {"", "paint_color=\"8\"", "colours painted in slicers"}};
  for (const Case& each : cases) {
    SCOPED_TRACE(each.resources + each.triangle);
    const std::string object = threemf_object(3, tetrahedron_with({each.triangle, "", "", ""}));
    const MeshFile file = read_looks(each.resources + object, item("", 3));
    EXPECT_EQ(file.mesh.face_count(), 4U);
    EXPECT_TRUE(has_sentence(file.notes, each.note));
  }
  const std::string overlapping = [] {
    std::string sets = "<t:trianglesets><t:triangleset name=\"a\" identifier=\"a\">";
    for (int i = 0; i < 100; ++i) sets += "<t:refrange startindex=\"0\" endindex=\"3\"/>";
    return sets + "<t:ref index=\"4\"/></t:triangleset></t:trianglesets>";
  }();
  const std::string object = threemf_object(1, tetrahedron_with({"", "", "", ""}, overlapping));
  const MeshFile file = read_looks(object, item());
  EXPECT_TRUE(has_sentence(file.notes, "sets of triangles that overlap"));
  EXPECT_TRUE(has_sentence(file.notes, "sets of triangles that there are not"));
}

TEST_F(ThreeMf, looks_are_charged) {
  std::string colors = "<m:colorgroup id=\"6\">";
  for (int i = 0; i < 50'000; ++i) colors += "<m:color color=\"#00ff00\"/>";
  Limits limits;
  limits.max_memory_bytes = std::uint64_t{4} << 20U;
  try {
    read_looks(colors + "</m:colorgroup>" + kObject, item(), limits);
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    EXPECT_EQ(error.place().line, 2U) << error.what();
  }
}

TEST_F(ThreeMf, reads_the_looks_that_it_wrote) {
  const PolygonMesh mesh = testing::tetrahedron();
  MeshAttributes all;
  all.materials = {{"a & \"b\" <c>", Rgba{1, 0, 0.2, 1}, {}},
                   {"", Rgba{0, 1, 0, 0.4}, {}},
                   {"bad \xff\n", Rgba{0, 0, 0, 1}, {}}};
  all.face_material = {0, 1, 2, MeshAttributes::kNone};
  all.groups = {"one", "two"};
  all.face_group = {1, MeshAttributes::kNone, 1, 1};
  MeshFile original;
  for (const bool has_corners : {false, true}) {
    SCOPED_TRACE(has_corners);
    if (has_corners) {
      std::vector<double> values(48, 1);
      for (std::size_t i = 36; i < 48; ++i) values[i] = static_cast<double>(i % 6) / 5;
      for (std::size_t i = 12; i < 16; ++i) values[i] = 0;  // A corner of a face with a material.
      all.channels = {{"color", 4, values}};
    }
    original.attributes = all;
    std::ostringstream out;
    write_threemf(out, mesh, all);
    Context context;
    ReadOptions options{"some.file"};
    options.attributes = true;
    const MeshFile copy = read_threemf(out.str(), options, context);
    EXPECT_TRUE(copy.notes.empty());
    EXPECT_TRUE(testing::is_same(copy.mesh, mesh));
    for (std::size_t f = 0; f < 4; ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(color_at(copy, f, i), color_at(original, f, i)) << f << ' ' << i;
      }
    }
    EXPECT_EQ(copy.attributes.groups, (std::vector<std::string>{"two"}));
    EXPECT_EQ(copy.attributes.face_group,
              (std::vector<std::uint32_t>{0, MeshAttributes::kNone, 0, 0}));
    ASSERT_FALSE(copy.attributes.face_material.empty());
    EXPECT_EQ(copy.attributes.materials[copy.attributes.face_material[0]].name,
              all.materials[0].name);
    EXPECT_EQ(copy.attributes.materials[copy.attributes.face_material[2]].name, "bad __");
  }
}

TEST_F(ThreeMf, places_objects_of_a_file_without_items) {
  const std::string parent = "<components><component objectid=\"1\"/></components>";
  const MeshFile file = read(threemf_of(threemf_model(kObject + threemf_object(2, parent), "")));
  EXPECT_EQ(file.mesh.face_count(), 4U);
  EXPECT_TRUE(has_sentence(file.notes, "no build items"));
}

TEST_F(ThreeMf, leaves_out_triangles_with_two_equal_corners) {
  std::string object = kObject;
  object.replace(object.find("v1=\"0\" v2=\"2\""), 13, "v1=\"2\" v2=\"2\"");
  const MeshFile file = read(threemf_of(threemf_model(object, item())));
  EXPECT_EQ(file.mesh.face_count(), 3U);
  EXPECT_EQ(file.faces_left_out, 1U);
}

// ---------------------------------------------------------------- refusals

/// A file and where it is wrong. A line of 0 means that the whole archive is meant.
struct Refusal {
  std::string name;
  std::string bytes;
  std::string part;
  std::size_t line, column;
  std::string message;
};

std::vector<Refusal> refusals() {
  const std::string root = "3D/3dmodel.model";
  const auto model = [&](const std::string& name, const std::string& resources,
                         const std::string& items, std::size_t line, std::size_t column,
                         const std::string& message) {
    return Refusal{name, threemf_of(threemf_model(resources, items)), root, line, column, message};
  };
  const auto changed_object = [](const std::string& from, const std::string& to) {
    std::string object = kObject;
    return object.replace(object.find(from), from.size(), to);
  };
  const std::string own = "<components><component objectid=\"1\"/></components>";
  return {
      {"no archive", "PK\x03\x04 nothing", "", 0, 0, "ZIP archive"},
      {"an archive cut short", threemf_of(threemf_model(kObject, item())).substr(0, 300), "", 0, 0,
       "ZIP archive"},
      {"another archive", zip_of({{"a.txt", "x"}}), "", 0, 0, "no 3D model"},
      {"no model", zip_of({{"_rels/.rels", testing::kThreeMfRelationships}}), "", 0, 0,
       "lacks the part '3D/3dmodel.model'"},
      {"another root", threemf_of("<html/>"), root, 1, 1, "root element is 'html'"},
      {"no XML", threemf_of("solid"), root, 1, 1, "syntax error"},
      {"a model of another name space", threemf_of("\n<model>"), root, 2, 1,
       "'model', not the model"},
      {"unclosed", threemf_of(threemf_model("<a>\n", "")), root, 3, 3, "mismatched tag"},
      {"a document type", threemf_of("<?xml version=\"1.0\"?>\n<!DOCTYPE a [<!ENTITY b \"c\">]>"),
       root, 2, 13, "DOCTYPE"},
      {"an extension",
       threemf_of(threemf_model(kObject, item(), "xmlns:q=\"urn:q\" requiredextensions=\"p q\"")),
       root, 1, 1, "'q' (urn:q)"},
      {"an extension without a name space",
       threemf_of(threemf_model(kObject, item(), "requiredextensions=\"z\"")), root, 1, 1, "'z'"},
      {"a unit", threemf_of(threemf_model(kObject, item(), "unit=\"mile\"")), root, 1, 1, "'mile'"},
      model("no id", "<object>", item(), 2, 12, "lacks the attribute id"),
      model("an id", "<object id=\"-1\">", item(), 2, 12, "not a whole number"),
      model("a second object", kObject + "\n" + kObject, item(), 3, 1, "a second object"),
      model("a vertex without z", changed_object(" z=\"0\"", ""), item(), 2, 44, "attribute z"),
      model("a number", changed_object("x=\"0\"", "x=\"1,5\""), item(), 2, 44, "x: expected"),
      model("two numbers", changed_object("x=\"0\"", "x=\"1 5\""), item(), 2, 44, "no number"),
      model("no finite number", changed_object("x=\"0\"", "x=\"nan\""), item(), 2, 44, "'nan'"),
      model("a far number", changed_object("x=\"0\"", "x=\"1e999\""), item(), 2, 44, "largest"),
      model("a corner", changed_object("v1=\"0\"", "v1=\"4\""), item(), 2, 174, "has 4 vertices"),
      model("a missing object", kObject, item("", 5), 3, 8, "no object 5"),
      model("a part", kObject, "<item objectid=\"1\" p:path=\"/no.model\"/>", 0, 0, "'no.model'"),
      model("an object in itself", threemf_object(1, own), item(), 2, 40, "contains itself"),
      model("a mesh and components", threemf_object(1, kThreeMfTetrahedron + own), item(), 2, 371,
            "a mesh and components"),
      model("eleven numbers", kObject, item("1 0 0 0 1 0 0 0 1 0 0"), 3, 8, "12 numbers"),
      model("thirteen numbers", kObject, item("1 0 0 0 1 0 0 0 1 0 0 0 0"), 3, 8, "12 numbers"),
      model("a flat transform", kObject, item("1 0 0 2 0 0 0 0 1 0 0 0"), 3, 8, "singular"),
      {"settings",
       threemf_of(threemf_model(kObject, item()),
                  {{"Metadata/model_settings.config", "<config>\n<object/></config>"}}),
       "Metadata/model_settings.config", 2, 1, "id is ''"},
  };
}

TEST_F(ThreeMf, refuses_malformed_files_with_their_place) {
  for (const Refusal& refusal : refusals()) {
    SCOPED_TRACE(refusal.name);
    try {
      read(refusal.bytes);
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      const std::string file = refusal.line == 0 ? "some.file" : "some.file(" + refusal.part + ")";
      EXPECT_EQ(error.place().file, file) << error.what();
      EXPECT_EQ(error.place().line, refusal.line) << error.what();
      EXPECT_EQ(error.place().column, refusal.column) << error.what();
      EXPECT_NE(error.message().find(refusal.message), std::string::npos) << error.what();
      EXPECT_LT(error.message().size(), 200U);
    }
  }
}

void expect_limit(const std::string& bytes, const std::string& message, Limits limits = {}) {
  try {
    read(bytes, false, limits);
    ADD_FAILURE() << "was read: " << message;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit) << error.what();
    EXPECT_EQ(error.place().file.substr(0, 9), "some.file") << error.what();
    EXPECT_NE(error.message().find(message), std::string::npos) << error.what();
  }
}

TEST_F(ThreeMf, bombs_end_at_limits) {
  // Sixteen times the billion laughs of components: 2^60 placements.
  std::string doubled = kObject;
  for (int id = 2; id <= 61; ++id) {
    const std::string part = "<component objectid=\"" + std::to_string(id - 1) + "\"/>";
    doubled += threemf_object(id, "<components>" + part + part + "</components>");
  }
  Limits small;
  small.max_memory_bytes = 64U << 20U;
  expect_limit(threemf_of(threemf_model(doubled, item("", 61))), "memory", small);
  std::string empty = doubled;
  empty.erase(empty.find("<mesh>"), kThreeMfTetrahedron.size());
  expect_limit(threemf_of(threemf_model(empty, item("", 61))), "2^20");

  std::string chain = kObject;
  for (int id = 2; id <= 80; ++id) {
    chain += threemf_object(
        id, "<components><component objectid=\"" + std::to_string(id - 1) + "\"/></components>");
  }
  expect_limit(threemf_of(threemf_model(chain, item("", 80))), "nested more than 64");

  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<a>";
  expect_limit(threemf_of(threemf_model(deep, "")), "nested more than 256");
  expect_limit(threemf_of(threemf_model("<a b=\"" + std::string(3U << 20U, 'x') + "\"/>", "")),
               "1 MiB");
  std::string names;
  for (int i = 0; i < 5000; ++i) names += "<name" + std::to_string(i) + "/>";
  expect_limit(threemf_of(threemf_model(names, "")), "different names");
  expect_limit(threemf_of(threemf_model(std::string(100U << 20U, ' '), "")), "times its own size");
}

// ---------------------------------------------------------------- writing

std::string written(const PolygonMesh& mesh) {
  std::ostringstream out;
  write_threemf(out, mesh);
  return out.str();
}

TEST_F(ThreeMf, reads_what_it_wrote) {
  PolygonMesh mesh = testing::awkward_mesh();
  mesh = testing::mesh_of(mesh.points, {{0, 1, 2}, {2, 1, 3}, {4, 0, 3}});
  const MeshFile copy = read(written(mesh));
  EXPECT_TRUE(testing::is_same(copy.mesh, mesh));
  EXPECT_TRUE(copy.notes.empty());
  EXPECT_TRUE(copy.warnings.empty());
  EXPECT_EQ(written(mesh), written(mesh));
  const MeshFile none = read(written({}));
  EXPECT_EQ(none.mesh.face_count(), 0U);
  EXPECT_TRUE(none.notes.empty());
}

TEST_F(ThreeMf, the_archive_states_no_time) {
  const std::string bytes = written(testing::tetrahedron());
  // A local header: signature, version, flags, method, then time and date. 33 is 1980-01-01.
  ASSERT_EQ(bytes.substr(0, 4), "PK\x03\x04");
  EXPECT_EQ(bytes.substr(10, 4), std::string("\0\0\x21\0", 4));
}

TEST_F(ThreeMf, needs_triangles) {
  EXPECT_THROW(
      written(testing::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}})),
      Error);
}

TEST(ThreeMfLibraries, a_build_without_them_names_their_packages) {
  if (has_threemf()) GTEST_SKIP() << "built with libzip and expat";
  try {
    read("PK\x03\x04");
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("libzip-dev"), std::string::npos);
    EXPECT_NE(error.message().find("libexpat1-dev"), std::string::npos);
  }
}

}  // namespace
}  // namespace plumb::threemf_test
