// Every allocation of C++ is refused once: the call in which that happens returns
// PLUMB_OUT_OF_MEMORY, the same calls succeed the next time, and nothing leaks.
//
// operator new counts what is asked for and refuses request number `refused`. A scenario is a
// function that calls the interface and stops at the first failure. It runs with refused = 1, 2, 3
// and so on, until no request is refused, and after each run as many blocks are in use as before.
//
// GMP and MPFR allocate by malloc, which this test does not refuse. No scenario writes JSON: an
// object that nlohmann-json 3.11.2 makes of a list in braces leaks if memory is refused in the
// middle.
#include <plumb.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace {

std::uint64_t requests = 0;  // Since the last run began.
std::uint64_t refused = 0;   // Which one is refused; 0: none.
std::int64_t in_use = 0;

void* allocate(std::size_t size, std::size_t alignment) noexcept {
  if (++requests == refused) return nullptr;
  if (size == 0) size = 1;
  void* const block =
      alignment == 0
          ? std::malloc(size)
          : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (block != nullptr) ++in_use;
  return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment = 0) {
  void* const block = allocate(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void release(void* block) noexcept {
  if (block != nullptr) --in_use;
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size); }
void* operator new[](std::size_t size) { return allocate_or_throw(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, 0); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, 0); }
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { release(block); }

namespace {

/// Releases a handle at the end of a scenario.
template <class Handle, void (*Free)(Handle*)>
class Owned {
 public:
  Owned() = default;
  ~Owned() { Free(handle_); }
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  Handle** out() { return &handle_; }
  operator Handle*() const { return handle_; }

 private:
  Handle* handle_ = nullptr;
};
using Solid = Owned<plumb_solid, plumb_solid_free>;
using Solids = Owned<plumb_solid_list, plumb_solid_list_free>;
using PlaneSet = Owned<plumb_plane_set, plumb_plane_set_free>;
using SphereSet = Owned<plumb_sphere_set, plumb_sphere_set_free>;
using Numbers = Owned<plumb_numbers, plumb_numbers_free>;
using Mesh = Owned<plumb_mesh, plumb_mesh_free>;
using Bytes = Owned<plumb_bytes, plumb_bytes_free>;
using Notes = Owned<plumb_notes, plumb_notes_free>;
using Context = Owned<plumb_context, plumb_context_free>;
using Map = Owned<plumb_map, plumb_map_free>;
using MapReport = Owned<plumb_map_report, plumb_map_report_free>;
using Overlay = Owned<plumb_overlay, plumb_overlay_free>;
using Scene = Owned<plumb_scene, plumb_scene_free>;
using Surface = Owned<plumb_surface, plumb_surface_free>;
using Region = Owned<plumb_region, plumb_region_free>;
using Layer = Owned<plumb_layer, plumb_layer_free>;
using LayerReport = Owned<plumb_layer_report, plumb_layer_report_free>;
using PlaneSets = Owned<plumb_plane_set_list, plumb_plane_set_list_free>;
using Error = Owned<plumb_error, plumb_error_free>;

// Calls the interface, checks that a failure has an error object, and stops the scenario at it.
#define TRY(call)                                                          \
  do {                                                                     \
    Error error;                                                           \
    plumb_error** const report = error.out();                              \
    const plumb_status status = call;                                      \
    if ((status == PLUMB_OK) != (error == nullptr)) return PLUMB_INTERNAL; \
    if (status != plumb_error_status(error)) return PLUMB_INTERNAL;        \
    if (status != PLUMB_OK) return status;                                 \
  } while (false)

constexpr double kCube[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                              0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
constexpr double kOther[24] = {.5, .5, .5, 2, .5, .5, .5, 2, .5, 2, 2, .5,
                               .5, .5, 2,  2, .5, 2,  .5, 2, 2,  2, 2, 2};
constexpr std::uint32_t kTriangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                          2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};

plumb_status difference_to_file() {
  Context context;
  Solid a, b, difference, again;
  Bytes bytes;
  Notes notes;
  Numbers volume;
  TRY(plumb_context_new(context.out(), report));
  TRY(plumb_solid_from_triangles(kCube, 8, kTriangles, 12, nullptr, a.out(), context, report));
  TRY(plumb_solid_from_triangles(kOther, 8, kTriangles, 12, nullptr, b.out(), context, report));
  TRY(plumb_solid_difference(a, b, difference.out(), context, report));
  TRY(plumb_solid_write(difference, "nef", nullptr, bytes.out(), notes.out(), context, report));
  TRY(plumb_solid_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), nullptr, nullptr,
                       again.out(), nullptr, context, report));
  TRY(plumb_solid_volume(again, volume.out(), context, report));
  return PLUMB_OK;
}

plumb_status mesh_and_pieces() {
  Solid a, b, both;
  Solids pieces;
  Mesh mesh;
  Bytes bytes;
  TRY(plumb_solid_from_triangles(kCube, 8, kTriangles, 12, nullptr, a.out(), nullptr, report));
  TRY(plumb_solid_from_triangles(kOther, 8, kTriangles, 12, nullptr, b.out(), nullptr, report));
  TRY(plumb_solid_union(a, b, both.out(), nullptr, report));
  TRY(plumb_solid_decompose(both, PLUMB_DECOMPOSE_CUTS, true, pieces.out(), nullptr, report));
  TRY(plumb_solid_to_mesh(both, nullptr, mesh.out(), nullptr, nullptr, report));
  TRY(plumb_mesh_write(mesh, "obj", bytes.out(), report));
  return PLUMB_OK;
}

plumb_status questions() {
  Solid cube;
  Numbers ray, point;
  const char* const texts[6] = {"1/3", "1/3", "-7", "0", "0", "1"};
  const double points[6] = {.5, .5, .5, 2, 2, 2};
  bool inside[2], is_hit = false;
  plumb_solid_info info = PLUMB_SOLID_INFO_INIT;
  TRY(plumb_solid_from_triangles(kCube, 8, kTriangles, 12, nullptr, cube.out(), nullptr, report));
  TRY(plumb_numbers_from_texts(texts, 6, ray.out(), nullptr, report));
  TRY(plumb_solid_contains(cube, points, 2, inside, nullptr, report));
  TRY(plumb_solid_shoot(cube, ray, false, &is_hit, nullptr, point.out(), nullptr, report));
  TRY(plumb_solid_describe(cube, &info, report));
  return PLUMB_OK;
}

plumb_status plane_sets() {
  PlaneSet a, b, both, simple;
  Bytes bytes;
  Notes notes;
  Numbers area;
  constexpr char kFirst[] = "POLYGON((0 0,3 0,3 1,0 1,0 0))";
  constexpr char kSecond[] = "POLYGON((1 -1,2 -1,2 3,1 0.5,1 -1))";
  TRY(plumb_plane_set_read(kFirst, sizeof kFirst - 1, nullptr, a.out(), notes.out(), nullptr,
                           report));
  TRY(plumb_plane_set_read(kSecond, sizeof kSecond - 1, nullptr, b.out(), nullptr, nullptr,
                           report));
  TRY(plumb_plane_set_symmetric_difference(a, b, both.out(), nullptr, report));
  TRY(plumb_plane_set_simplify(both, 0.01, 0, 1, simple.out(), nullptr, nullptr, report));
  TRY(plumb_plane_set_area(both, area.out(), nullptr, report));
  TRY(plumb_plane_set_write(both, "geojson", nullptr, bytes.out(), nullptr, nullptr, report));
  return PLUMB_OK;
}

plumb_status sphere_sets() {
  SphereSet octant, inside;
  Numbers axes;
  const double numbers[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  TRY(plumb_numbers_from_doubles(numbers, 9, axes.out(), report));
  TRY(plumb_sphere_set_half_spheres(axes, true, octant.out(), nullptr, report));
  TRY(plumb_sphere_set_interior(octant, inside.out(), nullptr, report));
  return PLUMB_OK;
}

plumb_status maps() {
  constexpr double kPoints[12] = {0, 0, 1, 0, 2, 0, 2, 1, 1, 1, 0, 1};
  constexpr std::uint32_t kCorners[14] = {0, 1, 4, 5, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0};
  constexpr std::uint32_t kBegin[4] = {0, 4, 8, 14};
  Map map;
  MapReport found;
  Overlay overlay;
  Bytes text, picture;
  TRY(plumb_map_from_cycles(kPoints, 6, kBegin, 3, kCorners, 14, map.out(), report));
  TRY(plumb_map_check(map, nullptr, found.out(), nullptr, report));
  TRY(plumb_map_report_write(found, "text", nullptr, text.out(), report));
  TRY(plumb_overlay_new(found, found, overlay.out(), nullptr, report));
  TRY(plumb_overlay_write(overlay, "svg", nullptr, nullptr, picture.out(), nullptr, report));
  return PLUMB_OK;
}

plumb_status surfaces() {
  Scene scene;
  Surface surface;
  Region region;
  constexpr double kWeights[3][2] = {{.125, .125}, {.5, .125}, {.125, .5}};
  std::uint32_t points[3], polygon = 0;
  TRY(plumb_scene_new(kCube, 8, kTriangles, 12, scene.out(), report));
  for (std::size_t i = 0; i < 3; ++i) {
    Numbers weights;
    TRY(plumb_numbers_from_doubles(kWeights[i], 2, weights.out(), report));
    TRY(plumb_scene_add_point(scene, 2, weights, &points[i], report));
  }
  TRY(plumb_scene_add_polygon(scene, points, 3, &polygon, nullptr, report));
  TRY(plumb_surface_divide(scene, surface.out(), nullptr, report));
  TRY(plumb_surface_evaluate(surface, "A", PLUMB_RULE_DEFAULT, region.out(), nullptr, report));
  return PLUMB_OK;
}

plumb_status models() {
  Solid solid, hull, swollen;
  Solids parts;
  PlaneSet flat, grown;
  PlaneSets slices;
  Numbers heights, apart, flat_apart;
  Notes notes;
  constexpr char kModel[] =
      "difference() { cube(size = 2); group() { cylinder(h = 5, r1 = 1, r2 = 1, $fn = 3); } }";
  const double height = 0.5;
  TRY(plumb_csg_read(kModel, sizeof kModel - 1, nullptr, PLUMB_IMPORTS_NONE, solid.out(),
                     flat.out(), notes.out(), nullptr, report));
  TRY(plumb_solid_components(solid, parts.out(), nullptr, report));
  TRY(plumb_solid_offset(solid, 0.25, 0, swollen.out(), nullptr, report));
  TRY(plumb_solid_distance(solid, swollen, apart.out(), nullptr, nullptr, report));
  TRY(plumb_numbers_from_doubles(&height, 1, heights.out(), report));
  TRY(plumb_solid_slices(solid, heights, slices.out(), nullptr, report));
  TRY(plumb_plane_set_offset(plumb_plane_set_list_at(slices, 0), 0.25, nullptr, grown.out(),
                             nullptr, report));
  TRY(plumb_plane_set_distance(grown, plumb_plane_set_list_at(slices, 0), flat_apart.out(), nullptr,
                               nullptr, report));
  TRY(plumb_solid_hull(kCube, 8, hull.out(), nullptr, report));
  return PLUMB_OK;
}

plumb_status layers() {
  constexpr char kFeatures[] =
      R"({"type":"FeatureCollection","features":[{"type":"Feature","id":1,"properties":{},)"
      R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[2,0],[0,2],[0,0]]]}},)"
      R"({"type":"Feature","id":2,"properties":{},)"
      R"("geometry":{"type":"Polygon","coordinates":[[[1,0],[3,0],[1,2],[1,0]]]}}]})";
  constexpr std::uint32_t kPairs[] = {1, 0};
  Layer layer, repaired, again, simple;
  LayerReport found, checked;
  Bytes text;
  plumb_layer_options options = PLUMB_LAYER_OPTIONS_INIT;
  plumb_simplify_report simplified = PLUMB_SIMPLIFY_REPORT_INIT;
  std::uint32_t feature = 0;
  TRY(plumb_layer_read(kFeatures, sizeof kFeatures - 1, nullptr, nullptr, layer.out(), nullptr,
                       nullptr, report));
  TRY(plumb_layer_repair(layer, PLUMB_OWNER_LARGEST, -1, repaired.out(), found.out(), nullptr,
                         report));
  TRY(plumb_layer_report_write(found, layer, "text", text.out(), nullptr, report));
  options.owner = PLUMB_OWNER_LOWEST_ID;
  options.preferences = kPairs;
  options.preference_count = 1;
  TRY(plumb_layer_find(layer, "2", &feature, report));
  TRY(plumb_layer_repair_with(layer, &options, again.out(), nullptr, nullptr, report));
  TRY(plumb_layer_check_with(layer, &options, checked.out(), nullptr, report));
  TRY(plumb_layer_simplify_with_report(again, 1, 0, 1, simple.out(), &simplified, nullptr, report));
  return PLUMB_OK;
}

plumb_status attributes() {
  Mesh mesh, made, read;
  Solid a, b, both, traced;
  Bytes bytes, lost;
  double numbers[36] = {};
  plumb_material material = PLUMB_MATERIAL_INIT;
  plumb_read_options reading = PLUMB_READ_OPTIONS_INIT;
  std::uint32_t zeros[12] = {};
  TRY(plumb_mesh_from_triangles(kCube, 8, kTriangles, 12, mesh.out(), report));
  material.name = "a name that is longer than what a string has inside";
  TRY(plumb_mesh_add_material(mesh, &material, nullptr, report));
  TRY(plumb_mesh_add_group(mesh, material.name, nullptr, report));
  TRY(plumb_mesh_set_face_values(mesh, PLUMB_FACE_MATERIAL, zeros, 12, report));
  TRY(plumb_mesh_set_channel(mesh, "normal", 3, PLUMB_PER_POINT, kCube, 8, report));
  TRY(plumb_mesh_set_channel(mesh, "normal", 1, PLUMB_PER_CORNER, numbers, 36, report));
  TRY(plumb_mesh_material(mesh, 0, &material, report));
  TRY(plumb_solid_from_mesh(mesh, nullptr, a.out(), nullptr, report));
  TRY(plumb_solid_with_source(a, mesh, material.name, traced.out(), report));
  TRY(plumb_solid_from_triangles(kOther, 8, kTriangles, 12, nullptr, b.out(), nullptr, report));
  TRY(plumb_solid_difference(a, b, both.out(), nullptr, report));
  TRY(plumb_solid_to_mesh_with_attributes(both, nullptr, made.out(), nullptr, nullptr, report));
  TRY(plumb_mesh_lost_attributes(made, "ply", lost.out(), report));
  TRY(plumb_mesh_write(made, "ply", bytes.out(), report));
  reading.attributes = 1;
  TRY(plumb_mesh_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), &reading, read.out(),
                      nullptr, nullptr, report));
  return plumb_mesh_channel_count(read) == 1 ? PLUMB_OK : PLUMB_INTERNAL;
}

/// Refuses each request of a scenario once. Returns whether all is well.
bool survives(const char* name, plumb_status (*scenario)()) {
  constexpr std::uint64_t kMost = 100000;
  refused = 0;
  if (scenario() != PLUMB_OK) return false;  // This run also makes what is made once.
  for (std::uint64_t n = 1; n < kMost; ++n) {
    const std::int64_t before = in_use;
    requests = 0;
    refused = n;
    const plumb_status status = scenario();
    const bool was_refused = requests >= n;
    refused = 0;
    // What the engine can do without may be refused without a failure.
    if (status != PLUMB_OUT_OF_MEMORY && status != PLUMB_OK) {
      std::printf("%s: status %d after refusal %lu\n", name, status, static_cast<unsigned long>(n));
      return false;
    }
    if (in_use != before) {
      std::printf("%s: %ld blocks leak after refusal %lu\n", name,
                  static_cast<long>(in_use - before), static_cast<unsigned long>(n));
      return false;
    }
    if (!was_refused) {
      std::printf("%s: %lu allocations\n", name, static_cast<unsigned long>(n - 1));
      return n > 10 && status == PLUMB_OK;
    }
  }
  return false;
}

/// An exception that nobody expects is a bug in plumb, whose text the caller gets. A callback that
/// breaks its promise not to throw stands for such a bug.
bool reports_bugs() {
  Context context;
  Solid ball, sum;
  Error error;
  const plumb_progress bug = [](const char*, std::uint64_t, std::uint64_t, void*) {
    throw std::logic_error("a bug");
  };
  plumb_context_new(context.out(), nullptr);
  plumb_context_set_progress(context, bug, nullptr, nullptr);
  plumb_solid_ball(1, 6, ball.out(), nullptr);
  const plumb_status status =
      plumb_solid_minkowski_sum(ball, ball, sum.out(), context, error.out());
  return status == PLUMB_INTERNAL && sum == nullptr &&
         std::string(plumb_error_message(error)) == "a bug";
}

}  // namespace

int main() {
  bool is_well = survives("difference_to_file", difference_to_file);
  is_well &= survives("mesh_and_pieces", mesh_and_pieces);
  is_well &= survives("questions", questions);
  is_well &= survives("plane_sets", plane_sets);
  is_well &= survives("sphere_sets", sphere_sets);
  is_well &= survives("maps", maps);
  is_well &= survives("surfaces", surfaces);
  is_well &= survives("models", models);
  is_well &= survives("attributes", attributes);
  is_well &= survives("layers", layers);
  is_well &= reports_bugs();
  return is_well ? 0 : 1;
}
