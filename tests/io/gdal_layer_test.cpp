// Layers through GDAL and back. Skipped if plumb is built without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/layer_io.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::gdal_layer_test {
namespace {

using Json = nlohmann::json;

/// A file in the folder of temporary files, removed at the end.
class GdalFile {
 public:
  explicit GdalFile(const std::string& name)
      : path_((std::filesystem::path(::testing::TempDir()) / name).string()) {}
  ~GdalFile() { std::filesystem::remove(path_); }
  GdalFile(const GdalFile&) = delete;
  GdalFile& operator=(const GdalFile&) = delete;
  const std::string& path() const { return path_; }
  void write(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

 private:
  std::string path_;
};

/// Two features with coordinates that need all digits of doubles, a hole, and no geometry.
const std::string kText =
    R"({"type":"FeatureCollection","crs":{"type":"name","properties":)"
    R"({"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)"
    R"({"type":"Feature","id":7,"properties":{"name":"\u00e9","n":9007199254740993,)"
    R"("x":0.1,"ok":true,"none":null,"list":[1,2]},"geometry":{"type":"Polygon",)"
    R"("coordinates":[[[0.1,0.2],[1e300,0.30000000000000004],[1,1e-300],[0.1,0.2]],)"
    R"([[0.2,0.2],[0.3,0.2],[0.3,0.3],[0.2,0.2]]]}},)"
    R"({"type":"Feature","id":3,"properties":{"n":-1},"geometry":null}]})";

std::string package_of(const LayerFile& file) {
  std::ostringstream out;
  write_layer_gpkg(out, file.layer, file.crs);
  return out.str();
}

class GdalLayers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!is_read_by_gdal("x.gpkg")) GTEST_SKIP() << "built without GDAL";
  }
};

TEST_F(GdalLayers, PackagesKeepCoordinatesIdsPropertiesAndTheSystem) {
  const LayerFile before = read_layer(kText);
  EXPECT_EQ(before.crs, "urn:ogc:def:crs:EPSG::2056");
  const GdalFile file("gdal_layer_test_1.gpkg");
  file.write(package_of(before));
  const LayerFile after = read_layer_file(file.path());
  EXPECT_EQ(after.crs, before.crs);
  ASSERT_EQ(after.layer.feature_count(), 2U);
  // Rows of a table are sorted by their ids.
  EXPECT_EQ(after.layer.id(0), "3");
  EXPECT_EQ(after.layer.id(1), "7");
  EXPECT_EQ(after.layer.ring_count(), 2U);
  ASSERT_EQ(after.layer.ring_corners.size(), before.layer.ring_corners.size());
  for (std::size_t i = 0; i < before.layer.ring_corners.size(); ++i) {
    const Point2 p = before.layer.points.approx(before.layer.ring_corners[i]);
    const Point2 q = after.layer.points.approx(after.layer.ring_corners[i]);
    EXPECT_EQ(p.x, q.x);
    EXPECT_EQ(p.y, q.y);
  }
  const Json properties = Json::parse(after.layer.properties(1));
  EXPECT_EQ(properties["n"], 9007199254740993);
  EXPECT_EQ(properties["x"], 0.1);
  EXPECT_EQ(properties["ok"], true);
  EXPECT_EQ(properties["name"], "\u00e9");
  EXPECT_EQ(properties["list"], "[1,2]");
  EXPECT_TRUE(properties["none"].is_null());
}

TEST_F(GdalLayers, FlatGeobufKeepsIdsAsAColumnAndTheOrder) {
  std::string features;
  for (const int at : {90, 0, 50}) {
    const std::string x = std::to_string(at), y = std::to_string(at + 1);
    features += (features.empty() ? "" : ",") +
                (R"({"type":"Feature","id":)" + x + R"(,"properties":null,"geometry":{"type":)") +
                R"("Polygon","coordinates":[[[)" + x + ",0],[" + y + ",0],[" + x + ",1],[" + x +
                ",0]]]}}";
  }
  const LayerFile before =
      read_layer(R"({"type":"FeatureCollection","features":[)" + features + "]}");
  std::ostringstream out;
  write_layer_fgb(out, before.layer, "");
  const GdalFile file("gdal_layer_test_2.fgb");
  file.write(out.str());
  const LayerFile after = read_layer_file(file.path());
  ASSERT_EQ(after.layer.feature_count(), 3U);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_EQ(after.layer.id(f), "");
    const Json properties = Json::parse(after.layer.properties(f));
    EXPECT_EQ(properties["id"], Json::parse(before.layer.id(f)));
  }
}

TEST_F(GdalLayers, FlatGeobufRefusesFeaturesThatItWouldLose) {
  std::ostringstream out;
  EXPECT_THROW(write_layer_fgb(out, read_layer(kText).layer, ""), Error);
  EXPECT_EQ(out.str(), "");
}

TEST_F(GdalLayers, TheSameLayerGivesTheSameBytes) {
  const LayerFile file = read_layer(kText);
  EXPECT_TRUE(package_of(file) == package_of(file));
}

TEST_F(GdalLayers, IdsThatAreNoNumbersAreAColumn) {
  const LayerFile before = read_layer(
      R"({"type":"FeatureCollection","features":[{"type":"Feature","id":"a","properties":null,)"
      R"("geometry":null},{"type":"Feature","id":"b","properties":null,"geometry":null}]})");
  const GdalFile file("gdal_layer_test_3.gpkg");
  file.write(package_of(before));
  const LayerFile after = read_layer_file(file.path());
  ASSERT_EQ(after.layer.feature_count(), 2U);
  EXPECT_EQ(after.layer.properties(1), R"({"id":"b"})");
}

void expect_refused(const std::string& path, ErrorCode code) {
  try {
    static_cast<void>(read_layer_file(path));
    ADD_FAILURE() << path;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_EQ(error.place().file, path);
  }
}

TEST_F(GdalLayers, RefusesWhatIsNoFileOfTheFormat) {
  const GdalFile file("gdal_layer_test_4.gpkg");
  const std::string bytes = package_of(read_layer(kText));
  for (const std::size_t size : {std::size_t{0}, std::size_t{50}, std::size_t{4096}}) {
    file.write(bytes.substr(0, size));
    expect_refused(file.path(), ErrorCode::Syntax);
  }
  // Another format of GDAL behind the extension, which names a file elsewhere.
  file.write(
      "<OGRVRTDataSource><OGRVRTLayer name=\"a\"><SrcDataSource>/etc/passwd"
      "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>");
  expect_refused(file.path(), ErrorCode::Syntax);
  expect_refused("/vsicurl/http://localhost/a.gpkg", ErrorCode::CannotOpen);
  expect_refused("GPKG:" + file.path(), ErrorCode::CannotOpen);
  expect_refused("no/such/file.gpkg", ErrorCode::CannotOpen);
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST_F(GdalLayers, ShapefilesKeepCoordinatesAndTheSystemAndNameTheirLosses) {
  const LayerFile before = read_layer(
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":)"
      R"({"name":"urn:ogc:def:crs:EPSG::2056"}},"features":[)"
      R"({"type":"Feature","id":"a","properties":{"a name that is long":")" +
      std::string(300, 'x') +
      R"(","small":1e-20,"n":9007199254740993,"e":"\u00e9"},)"
      R"("geometry":{"type":"Polygon","coordinates":[[[0.1,0.2],[1,0.30000000000000004],)"
      R"([1e10,7.1],[0.1,0.2]]]}},{"type":"Feature","id":"b","properties":{},"geometry":null}]})");
  const Shapefile files = layer_shapefile(before.layer, before.crs);
  std::string notes;
  for (const std::string& note : files.notes) notes += note + '\n';
  EXPECT_EQ(notes,
            "shortened: names of properties of more than 10 bytes (1)\n"
            "cut: texts of more than 254 bytes (1)\n"
            "rounded: numbers that need more than 15 digits behind the point (1)\n");
  const GdalFile shp("gdal_layer_test_6.shp"), shx("gdal_layer_test_6.shx"),
      dbf("gdal_layer_test_6.dbf"), prj("gdal_layer_test_6.prj"), cpg("gdal_layer_test_6.cpg");
  write_bytes(shp.path(), files.shp);
  write_bytes(shx.path(), files.shx);
  write_bytes(dbf.path(), files.dbf);
  write_bytes(prj.path(), files.prj);
  write_bytes(cpg.path(), files.cpg);
  const LayerFile after = read_layer_file(shp.path());
  EXPECT_EQ(after.crs, before.crs);
  ASSERT_EQ(after.layer.feature_count(), 2U);
  EXPECT_EQ(after.layer.polygon_count(), 1U);
  const Json properties = Json::parse(after.layer.properties(0));
  EXPECT_EQ(properties["id"], "a");
  EXPECT_EQ(properties["n"], 9007199254740993);
  EXPECT_EQ(properties["e"], "\u00e9");
  std::vector<std::pair<double, double>> was, is;
  for (const std::uint32_t c : before.layer.ring(0)) {
    was.emplace_back(before.layer.points.approx(c).x, before.layer.points.approx(c).y);
  }
  for (const std::uint32_t c : after.layer.ring(0)) {
    is.emplace_back(after.layer.points.approx(c).x, after.layer.points.approx(c).y);
  }
  std::sort(was.begin(), was.end());
  std::sort(is.begin(), is.end());
  EXPECT_EQ(was, is);
}

TEST_F(GdalLayers, MemoryIsLimited) {
  const GdalFile file("gdal_layer_test_5.gpkg");
  file.write(package_of(read_layer(kText)));
  Limits limits;
  limits.max_memory_bytes = 100;
  Context context(limits);
  EXPECT_THROW(static_cast<void>(read_layer_file(file.path(), {}, context)), Error);
}

TEST(LayersWithoutGdal, AreRefusedWithTheWay) {
  if (is_read_by_gdal("x.gpkg")) GTEST_SKIP() << "built with GDAL";
  std::ostringstream out;
  EXPECT_THROW(write_layer_gpkg(out, Layer(), ""), Error);
  EXPECT_THROW(write_layer_fgb(out, Layer(), ""), Error);
  EXPECT_THROW(static_cast<void>(layer_shapefile(Layer(), "")), Error);
  EXPECT_EQ(out.str(), "");
  expect_refused("x.gpkg", ErrorCode::UnknownFormat);
}

}  // namespace
}  // namespace plumb::testing::gdal_layer_test
