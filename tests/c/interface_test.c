/* Checks of every function of plumb.h, in C99; interface_test.cpp compiles the same file as C++.
 *
 * The program runs in the root of the repository and gets a folder for files as its argument. Laws
 * are checked on small shapes whose volumes, areas and counts are known by hand; failures are
 * checked for status, message and place. tests/c/every_function.py fails if a function of the
 * header does not occur here. */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <plumb.h>
#include <pthread.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static int failures = 0;
static plumb_error* error = NULL; /* Of the last call. */
static const char* folder = ".";

#define CHECK(condition)                                             \
  do {                                                               \
    if (!(condition)) {                                              \
      ++failures;                                                    \
      printf("%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
    }                                                                \
  } while (0)

/* The call succeeds. */
#define OK(call) check_ok((call), __LINE__)
static void check_ok(plumb_status status, int line) {
  if (status == PLUMB_OK && error == NULL) return;
  printf("%s:%d: status %d: %s\n", __FILE__, line, status,
         error != NULL ? plumb_error_text(error) : "no error object");
  ++failures;
  plumb_error_free(error);
  error = NULL;
}

/* The call fails with a status, and with an error object that says the same and has a message. */
#define FAILS(call, expected) check_fails((call), (expected), NULL, __LINE__)
#define FAILS_WITH(call, expected, part) check_fails((call), (expected), (part), __LINE__)
static void check_fails(plumb_status status, plumb_status expected, const char* part, int line) {
  if (status != expected || error == NULL || plumb_error_status(error) != expected ||
      strlen(plumb_error_message(error)) == 0 ||
      (part != NULL && strstr(plumb_error_text(error), part) == NULL)) {
    printf("%s:%d: status %d instead of %d: %s\n", __FILE__, line, status, expected,
           error != NULL ? plumb_error_text(error) : "no error object");
    ++failures;
  }
  plumb_error_free(error);
  error = NULL;
}

/* ---- shapes --------------------------------------------------------------------------------- */

static const double kCube[24] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                                 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
static const uint32_t kTriangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                        2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
static const uint32_t kSquares[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                      2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const uint32_t kSquareBegin[7] = {0, 4, 8, 12, 16, 20, 24};

static plumb_numbers* numbers(const char* text) { /* "1 -2/3 0.5" */
  char copy[1024];
  const char* texts[64];
  size_t count = 0;
  plumb_numbers* result = NULL;
  char* word;
  strcpy(copy, text);
  for (word = strtok(copy, " "); word != NULL; word = strtok(NULL, " ")) texts[count++] = word;
  OK(plumb_numbers_from_texts(texts, count, &result, NULL, &error));
  return result;
}

static plumb_solid* cube_at(double x, double y, double z) {
  double xyz[24];
  plumb_solid* cube = NULL;
  size_t i;
  for (i = 0; i < 24; i += 3) {
    xyz[i] = kCube[i] + x;
    xyz[i + 1] = kCube[i + 1] + y;
    xyz[i + 2] = kCube[i + 2] + z;
  }
  OK(plumb_solid_from_triangles(xyz, 8, kTriangles, 12, NULL, &cube, NULL, &error));
  return cube;
}

static bool has_volume(const plumb_solid* solid, const char* expected) {
  plumb_numbers* volume = NULL;
  bool is_right;
  OK(plumb_solid_volume(solid, &volume, NULL, &error));
  is_right = plumb_numbers_count(volume) == 1 && !strcmp(plumb_numbers_exact(volume, 0), expected);
  if (!is_right) printf("volume %s\n", plumb_numbers_exact(volume, 0));
  plumb_numbers_free(volume);
  return is_right;
}

static bool same(const plumb_solid* a, const plumb_solid* b) {
  bool is_equal = false;
  OK(plumb_solid_equals(a, b, &is_equal, &error));
  return is_equal;
}

static plumb_plane_set* square_at(const char* corners) {
  plumb_numbers* points = numbers(corners);
  plumb_plane_set* set = NULL;
  OK(plumb_plane_set_polygon(points, true, &set, NULL, &error));
  plumb_numbers_free(points);
  return set;
}

static bool has_area(const plumb_plane_set* set, const char* expected) {
  plumb_numbers* area = NULL;
  bool is_right;
  OK(plumb_plane_set_area(set, &area, NULL, &error));
  is_right = plumb_numbers_count(area) == 1 && !strcmp(plumb_numbers_exact(area, 0), expected);
  if (!is_right) printf("area %s\n", plumb_numbers_exact(area, 0));
  plumb_numbers_free(area);
  return is_right;
}

static const char* path_of(const char* name) { /* Valid until the next call. */
  static char path[1024];
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

static bool begins(const plumb_bytes* bytes, const char* text) {
  return plumb_bytes_size(bytes) >= strlen(text) &&
         memcmp(plumb_bytes_data(bytes), text, strlen(text)) == 0;
}

/* ---- versions, values, errors --------------------------------------------------------------- */

static void test_versions(void) {
  static const plumb_status all[] = {0,   100, 101, 102, 103, 104, 105, 106, 107, 108,
                                     109, 110, 111, 200, 201, 300, 301, 400, 401};
  bool is_ok = false;
  plumb_notes* notes = NULL;
  size_t i, j;
  CHECK(plumb_abi_version() == PLUMB_ABI_VERSION);
  CHECK(strchr(plumb_version(), '.') != NULL);
  for (i = 0; i < sizeof all / sizeof *all; ++i) {
    for (j = 0; j < i; ++j) {
      CHECK(strcmp(plumb_status_name(all[i]), plumb_status_name(all[j])) != 0);
    }
    CHECK(strcmp(plumb_status_name(all[i]), "unknown status") != 0);
  }
  CHECK(strcmp(plumb_status_name(12345), "unknown status") == 0);
  OK(plumb_self_test(&is_ok, &notes, &error));
  CHECK(is_ok);
  for (i = 0; i < plumb_notes_count(notes); ++i) CHECK(!plumb_notes_is_warning(notes, i));
  plumb_notes_free(notes);
  FAILS(plumb_self_test(NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
}

static void test_numbers(void) {
  const double doubles[3] = {0.1, -2.5, 1e300};
  const double bad[2] = {0, INFINITY};
  const double nan_only[1] = {NAN};
  const char* texts[2] = {"1", "2x"};
  const char* too_long[1] = {"1234567890123456789012345678901234567890"};
  const char* null_text[1] = {NULL};
  plumb_context* context = NULL;
  plumb_numbers* list = numbers("-3 6/4 0.1 2.5e-3 1e400");
  CHECK(plumb_numbers_count(list) == 5);
  CHECK(!strcmp(plumb_numbers_exact(list, 0), "-3"));
  CHECK(!strcmp(plumb_numbers_exact(list, 1), "3/2"));
  CHECK(!strcmp(plumb_numbers_exact(list, 2), "1/10"));
  CHECK(!strcmp(plumb_numbers_exact(list, 3), "1/400"));
  CHECK(plumb_numbers_nearest(list, 2) == 0.1);
  CHECK(isinf(plumb_numbers_nearest(list, 4)));
  CHECK(plumb_numbers_exact(list, 5) == NULL && plumb_numbers_nearest(list, 5) == 0);
  plumb_numbers_free(list);
  OK(plumb_numbers_from_doubles(doubles, 3, &list, &error));
  CHECK(!strcmp(plumb_numbers_exact(list, 0), "3602879701896397/36028797018963968"));
  CHECK(!strcmp(plumb_numbers_exact(list, 1), "-5/2"));
  CHECK(plumb_numbers_nearest(list, 2) == 1e300);
  plumb_numbers_free(list);
  OK(plumb_numbers_from_doubles(NULL, 0, &list, &error));
  CHECK(plumb_numbers_count(list) == 0);
  plumb_numbers_free(list);

  list = (plumb_numbers*)&list;
  FAILS_WITH(plumb_numbers_from_doubles(bad, 2, &list, &error), PLUMB_NOT_FINITE, "values[1]");
  CHECK(list == NULL);
  FAILS(plumb_numbers_from_doubles(nan_only, 1, &list, &error), PLUMB_NOT_FINITE);
  FAILS(plumb_numbers_from_doubles(NULL, 1, &list, &error), PLUMB_BAD_ARGUMENT);
  FAILS_WITH(plumb_numbers_from_doubles(doubles, 1, NULL, &error), PLUMB_BAD_ARGUMENT,
             "out is a null pointer");
  CHECK(plumb_numbers_from_texts(texts, 2, &list, NULL, &error) == PLUMB_SYNTAX);
  CHECK(!strcmp(plumb_error_file(error), "number 1"));
  CHECK(plumb_error_line(error) == 1 && plumb_error_column(error) >= 1);
  CHECK(strstr(plumb_error_text(error), plumb_error_message(error)) != NULL);
  plumb_error_free(error);
  error = NULL;
  FAILS(plumb_numbers_from_texts(null_text, 1, &list, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_context_new(&context, &error));
  OK(plumb_context_set_number_limits(context, 5, 10, &error));
  FAILS(plumb_numbers_from_texts(too_long, 1, &list, context, &error), PLUMB_NUMBER_OUT_OF_RANGE);
  plumb_context_free(context);
  /* Without an error object the status is the same. */
  CHECK(plumb_numbers_from_texts(texts, 2, &list, NULL, NULL) == PLUMB_SYNTAX);
}

/* All accessors and destructors accept null pointers. */
static void test_null(void) {
  size_t count = 7;
  plumb_error_free(NULL);
  CHECK(plumb_error_status(NULL) == PLUMB_OK && plumb_error_message(NULL) == NULL);
  CHECK(plumb_error_text(NULL) == NULL && plumb_error_file(NULL) == NULL);
  CHECK(plumb_error_line(NULL) == 0 && plumb_error_column(NULL) == 0);
  plumb_context_free(NULL);
  plumb_context_cancel(NULL);
  CHECK(!plumb_context_is_cancelled(NULL));
  plumb_bytes_free(NULL);
  CHECK(plumb_bytes_data(NULL) == NULL && plumb_bytes_size(NULL) == 0);
  plumb_notes_free(NULL);
  CHECK(plumb_notes_count(NULL) == 0 && plumb_notes_text(NULL, 0) == NULL);
  CHECK(!plumb_notes_is_warning(NULL, 0));
  plumb_indices_free(NULL);
  CHECK(plumb_indices_data(NULL) == NULL && plumb_indices_count(NULL) == 0);
  plumb_numbers_free(NULL);
  plumb_mesh_free(NULL);
  CHECK(plumb_mesh_point_count(NULL) == 0 && plumb_mesh_points(NULL) == NULL);
  CHECK(plumb_mesh_material_count(NULL) == 0 && plumb_mesh_group_count(NULL) == 0);
  CHECK(plumb_mesh_group(NULL, 0) == NULL && plumb_mesh_face_values(NULL, 0) == NULL);
  CHECK(plumb_mesh_channel_count(NULL) == 0 && plumb_mesh_channel_name(NULL, 0) == NULL);
  CHECK(plumb_mesh_channel_width(NULL, 0) == 0 && plumb_mesh_channel_values(NULL, 0) == NULL);
  CHECK(plumb_solid_source_count(NULL) == 0 && plumb_solid_source_name(NULL, 0) == NULL);
  plumb_mesh_report_free(NULL);
  CHECK(plumb_mesh_report_list(NULL, 0, &count) == NULL && count == 0);
  plumb_solid_free(NULL);
  CHECK(!plumb_solid_is_empty(NULL));
  plumb_solid_list_free(NULL);
  CHECK(plumb_solid_list_at(NULL, 0) == NULL);
  plumb_plane_set_free(NULL);
  plumb_plane_set_list_free(NULL);
  plumb_shapes_free(NULL);
  plumb_sphere_set_free(NULL);
  plumb_map_free(NULL);
  plumb_map_report_free(NULL);
  CHECK(plumb_map_report_warnings(NULL) == NULL);
  plumb_dcel_free(NULL);
  plumb_overlay_free(NULL);
  plumb_scene_free(NULL);
  plumb_path_free(NULL);
  plumb_surface_free(NULL);
  plumb_region_free(NULL);
}

/* ---- contexts ------------------------------------------------------------------------------- */

typedef struct Progress {
  uint64_t calls;
  plumb_context* cancelled; /* Null: only count. */
} Progress;

static void on_progress(const char* phase, uint64_t done, uint64_t total, void* user_data) {
  Progress* progress = (Progress*)user_data;
  CHECK(phase != NULL);
  CHECK(total == 0 || done <= total);
  ++progress->calls;
  if (progress->cancelled != NULL) plumb_context_cancel(progress->cancelled);
}

/* Takes some seconds if nobody stops it. */
static plumb_status long_operation(const plumb_context* context) {
  plumb_solid *ball = NULL, *sum = NULL;
  plumb_status status;
  OK(plumb_solid_ball(1.0, 6, &ball, &error));
  status = plumb_solid_minkowski_sum(ball, ball, &sum, context, &error);
  CHECK((sum == NULL) == (status != PLUMB_OK));
  plumb_solid_free(ball);
  plumb_solid_free(sum);
  return status;
}

static void* cancel_later(void* context) {
  const struct timespec pause = {0, 50 * 1000 * 1000};
  nanosleep(&pause, NULL);
  plumb_context_cancel((plumb_context*)context);
  return NULL;
}

static plumb_context* signalled = NULL;
static void on_signal(int number) {
  (void)number;
  plumb_context_cancel(signalled);
}

/* Windows has no signal for a thread: there the handler runs in the thread that raises it. */
static void* raise_later(void* thread) {
  const struct timespec pause = {0, 50 * 1000 * 1000};
  nanosleep(&pause, NULL);
#ifdef _WIN32
  (void)thread;
  raise(SIGINT);
#else
  pthread_kill(*(pthread_t*)thread, SIGINT);
#endif
  return NULL;
}

static void test_context(void) {
  Progress progress = {0, NULL};
  plumb_context* context = NULL;
  plumb_solid *cube = cube_at(0, 0, 0), *result = NULL;
  pthread_t thread, self = pthread_self();
  OK(plumb_context_new(&context, &error));
  CHECK(!plumb_context_is_cancelled(context));
  FAILS(plumb_context_set_time_limit(context, -1, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_context_set_time_limit(context, NAN, &error), PLUMB_NOT_FINITE);
  FAILS(plumb_context_set_threads(context, 0, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_context_set_memory_limit(NULL, 1, &error), PLUMB_BAD_ARGUMENT);

  OK(plumb_context_set_progress(context, on_progress, &progress, &error));
  OK(plumb_context_set_threads(context, 2, &error));
  OK(plumb_solid_union(cube, cube, &result, context, &error));
  CHECK(same(result, cube));
  plumb_solid_free(result);

  /* The callback cancels the operation that calls it. */
  progress.cancelled = context;
  FAILS(long_operation(context), PLUMB_CANCELLED);
  CHECK(progress.calls > 0 && plumb_context_is_cancelled(context));
  /* A stop stays requested, even for operations of no time. */
  FAILS(plumb_solid_complement(cube, &result, context, &error), PLUMB_CANCELLED);
  CHECK(result == NULL);
  OK(plumb_context_reset(context, &error));
  OK(plumb_context_set_progress(context, NULL, NULL, &error));
  OK(plumb_solid_complement(cube, &result, context, &error));
  plumb_solid_free(result);

  /* Another thread cancels. */
  CHECK(pthread_create(&thread, NULL, cancel_later, context) == 0);
  FAILS(long_operation(context), PLUMB_CANCELLED);
  pthread_join(thread, NULL);
  OK(plumb_context_reset(context, &error));

  /* A signal handler cancels. */
  signalled = context;
  signal(SIGINT, on_signal);
  CHECK(pthread_create(&thread, NULL, raise_later, &self) == 0);
  FAILS(long_operation(context), PLUMB_CANCELLED);
  pthread_join(thread, NULL);
  OK(plumb_context_reset(context, &error));

  OK(plumb_context_set_time_limit(context, 0.05, &error));
  FAILS(long_operation(context), PLUMB_RESOURCE_LIMIT);
  OK(plumb_context_set_time_limit(context, 0, &error));
  OK(plumb_context_set_memory_limit(context, 1000, &error));
  FAILS(plumb_solid_read_file("corpus/solids/ball.off", NULL, NULL, &result, NULL, context, &error),
        PLUMB_RESOURCE_LIMIT);
  plumb_context_free(context);
  plumb_solid_free(cube);
}

/* ---- meshes --------------------------------------------------------------------------------- */

static void test_mesh_arrays(void) {
  const uint32_t bad_index[3] = {0, 1, 8}, bad_begin[3] = {0, 4, 3};
  double not_finite[24];
  plumb_mesh *mesh = NULL, *triangles = NULL;
  plumb_numbers* point = NULL;
  bool is_convex = false;
  uint64_t reflex = 1;
  plumb_indices* failing = NULL;
  OK(plumb_mesh_from_polygons(kCube, 8, kSquareBegin, 6, kSquares, 24, &mesh, &error));
  CHECK(plumb_mesh_point_count(mesh) == 8 && plumb_mesh_face_count(mesh) == 6);
  CHECK(plumb_mesh_corner_count(mesh) == 24 && plumb_mesh_facets(mesh) == NULL);
  CHECK(memcmp(plumb_mesh_points(mesh), kCube, sizeof kCube) == 0);
  CHECK(memcmp(plumb_mesh_corners(mesh), kSquares, sizeof kSquares) == 0);
  CHECK(memcmp(plumb_mesh_face_begin(mesh), kSquareBegin, sizeof kSquareBegin) == 0);
  OK(plumb_mesh_exact_point(mesh, 7, &point, &error));
  CHECK(plumb_numbers_count(point) == 3 && !strcmp(plumb_numbers_exact(point, 2), "1"));
  plumb_numbers_free(point);
  FAILS(plumb_mesh_exact_point(mesh, 8, &point, &error), PLUMB_BAD_INDEX);
  OK(plumb_mesh_triangulate(mesh, &triangles, NULL, &error));
  CHECK(plumb_mesh_face_count(triangles) == 12 && plumb_mesh_corner_count(triangles) == 36);
  OK(plumb_mesh_convexity(triangles, &is_convex, &reflex, &failing, NULL, &error));
  CHECK(is_convex && reflex == 0 && plumb_indices_count(failing) == 0);
  plumb_indices_free(failing);
  plumb_mesh_free(triangles);
  plumb_mesh_free(mesh);

  FAILS(plumb_mesh_from_triangles(kCube, 8, bad_index, 1, &mesh, &error), PLUMB_BAD_INDEX);
  CHECK(mesh == NULL);
  FAILS(plumb_mesh_from_polygons(kCube, 8, bad_begin, 2, kSquares, 3, &mesh, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS_WITH(plumb_mesh_from_triangles(NULL, 8, kTriangles, 12, &mesh, &error), PLUMB_BAD_ARGUMENT,
             "xyz is a null pointer");
  FAILS(plumb_mesh_from_triangles(kCube, SIZE_MAX, kTriangles, 12, &mesh, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_mesh_from_triangles(kCube, 8, kTriangles, SIZE_MAX, &mesh, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_mesh_from_polygons(kCube, 8, bad_begin, SIZE_MAX, kSquares, 3, &mesh, &error),
        PLUMB_BAD_ARGUMENT);
  memcpy(not_finite, kCube, sizeof kCube);
  not_finite[20] = NAN;
  FAILS_WITH(plumb_mesh_from_triangles(not_finite, 8, kTriangles, 12, &mesh, &error),
             PLUMB_NOT_FINITE, "xyz[20]");
  OK(plumb_mesh_from_triangles(NULL, 0, NULL, 0, &mesh, &error));
  CHECK(plumb_mesh_face_count(mesh) == 0);
  plumb_mesh_free(mesh);
}

static void test_mesh_files(void) {
  static const char* const formats[] = {"off",        "off-exact", "obj",     "stl",
                                        "stl-binary", "ply",       "ply-text"};
  plumb_read_options reading = PLUMB_READ_OPTIONS_INIT;
  plumb_mesh *mesh = NULL, *again = NULL;
  plumb_bytes* bytes = NULL;
  plumb_notes* notes = NULL;
  size_t i;
  OK(plumb_mesh_from_triangles(kCube, 8, kTriangles, 12, &mesh, &error));
  for (i = 0; i < sizeof formats / sizeof *formats; ++i) {
    OK(plumb_mesh_write(mesh, formats[i], &bytes, &error));
    OK(plumb_mesh_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), NULL, &again, &notes, NULL,
                       &error));
    CHECK(plumb_mesh_face_count(again) == 12 && plumb_mesh_point_count(again) == 8);
    plumb_notes_free(notes);
    plumb_mesh_free(again);
    plumb_bytes_free(bytes);
  }
  OK(plumb_mesh_write_file(mesh, path_of("cube.off"), NULL, &error));
  OK(plumb_mesh_read_file(path_of("cube.off"), NULL, &again, NULL, NULL, &error));
  CHECK(memcmp(plumb_mesh_points(again), kCube, sizeof kCube) == 0);
  plumb_mesh_free(again);
  OK(plumb_mesh_write_file(mesh, path_of("cube.unknown"), "ply", &error));
  FAILS(plumb_mesh_write_file(mesh, path_of("cube.unknown"), NULL, &error), PLUMB_UNKNOWN_FORMAT);
  FAILS(plumb_mesh_write_file(mesh, path_of("no-such-folder/cube.off"), NULL, &error),
        PLUMB_CANNOT_WRITE);
  FAILS(plumb_mesh_write(mesh, "gltf", &bytes, &error), PLUMB_UNKNOWN_FORMAT);
  FAILS(plumb_mesh_write(mesh, NULL, &bytes, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_mesh_read_file(path_of("no-such-file.off"), NULL, &again, NULL, NULL, &error),
        PLUMB_CANNOT_OPEN);
  reading.name = "broken.off";
  CHECK(plumb_mesh_read("OFF\n1 0 0\n0 0 x\n", 16, &reading, &again, &notes, NULL, &error) ==
        PLUMB_SYNTAX);
  CHECK(again == NULL && notes == NULL);
  CHECK(!strcmp(plumb_error_file(error), "broken.off"));
  CHECK(plumb_error_line(error) == 3 && plumb_error_column(error) == 5);
  plumb_error_free(error);
  error = NULL;
  plumb_mesh_free(mesh);
}

static void test_mesh_defects(void) {
  plumb_mesh *open = NULL, *closed = NULL;
  plumb_mesh_report* report = NULL;
  plumb_repair_options options = PLUMB_REPAIR_OPTIONS_INIT;
  plumb_repair_report told = PLUMB_REPAIR_REPORT_INIT;
  plumb_solid_options solid_options = PLUMB_SOLID_OPTIONS_INIT;
  plumb_solid* solid = NULL;
  plumb_notes* notes = NULL;
  size_t count = 0;
  const uint32_t *begin, *list;
  bool found = false;
  OK(plumb_mesh_from_polygons(kCube, 8, kSquareBegin, 5, kSquares, 20, &open, &error));
  OK(plumb_mesh_check(open, 10, &report, NULL, &error));
  CHECK(!plumb_mesh_report_is_closed(report) && plumb_mesh_report_crossing_count(report) == 0);
  list = plumb_mesh_report_list(report, PLUMB_MESH_HOLES, &count);
  CHECK(list != NULL && count == 4);
  begin = plumb_mesh_report_chains(report, PLUMB_MESH_HOLES, &count);
  CHECK(count == 1 && begin[0] == 0 && begin[1] == 4);
  CHECK(plumb_mesh_report_list(report, 11, &count) == NULL && count == 0);
  CHECK(plumb_mesh_report_list(report, -1, NULL) == NULL);
  plumb_mesh_report_free(report);

  FAILS(plumb_solid_from_mesh(open, NULL, &solid, NULL, &error), PLUMB_BAD_SHAPE);
  OK(plumb_mesh_find_repair(open, &options, &found, NULL, &error));
  CHECK(found && options.fill_holes == 4);
  OK(plumb_mesh_repair(open, &options, &closed, &told, &notes, NULL, &error));
  CHECK(told.is_closed && told.filled == 1 && told.holes == 0 && plumb_notes_count(notes) > 0);
  CHECK(plumb_notes_text(notes, 0) != NULL);
  plumb_notes_free(notes);
  OK(plumb_solid_from_mesh(closed, NULL, &solid, NULL, &error));
  CHECK(has_volume(solid, "1"));
  plumb_solid_free(solid);
  solid_options.repair = &options;
  OK(plumb_solid_from_polygons(kCube, 8, kSquareBegin, 5, kSquares, 20, &solid_options, &solid,
                               NULL, &error));
  CHECK(has_volume(solid, "1"));
  plumb_solid_free(solid);
  plumb_mesh_free(closed);
  options.weld = NAN;
  FAILS(plumb_mesh_repair(open, &options, &closed, NULL, NULL, NULL, &error), PLUMB_NOT_FINITE);
  CHECK(closed == NULL);
  options.weld = 0;
  options.doubled = 9;
  FAILS(plumb_mesh_repair(open, &options, &closed, NULL, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  options.struct_size = 0;
  FAILS_WITH(plumb_mesh_repair(open, &options, &closed, NULL, NULL, NULL, &error),
             PLUMB_BAD_ARGUMENT, "struct_size");
  plumb_mesh_free(open);
}

/* Faces of less than three corners, and chains without corners, harm nothing. */
static void test_degenerate_arrays(void) {
  const uint32_t begin[10] = {0, 0, 1, 3, 7, 11, 15, 19, 23, 27};
  const uint32_t chains[4] = {0, 0, 3, 3};
  const uint32_t ids[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  uint32_t corners[27] = {0, 0, 1};
  plumb_mesh *mesh = NULL, *mended = NULL;
  plumb_mesh_report* report = NULL;
  plumb_repair_report told = PLUMB_REPAIR_REPORT_INIT;
  plumb_solid* solid = NULL;
  plumb_plane_set* set = NULL;
  plumb_bytes* bytes = NULL;
  bool is_convex = true;
  size_t count = 0;
  memcpy(corners + 3, kSquares, sizeof kSquares);
  OK(plumb_mesh_from_polygons(kCube, 8, begin, 9, corners, 27, &mesh, &error));
  OK(plumb_mesh_check(mesh, 10, &report, NULL, &error));
  CHECK(plumb_mesh_report_is_closed(report));
  CHECK(plumb_mesh_report_list(report, PLUMB_MESH_DEGENERATE, &count) != NULL && count == 3);
  plumb_mesh_report_free(report);
  OK(plumb_mesh_set_face_values(mesh, PLUMB_FACE_ID, ids, 9, &error));
  OK(plumb_mesh_triangulate(mesh, &mended, NULL, &error));
  count = plumb_mesh_face_count(mended);
  CHECK(plumb_mesh_face_values(mended, PLUMB_FACE_ID)[count - 1] == 9);
  CHECK(plumb_mesh_face_values(mended, PLUMB_FACE_ID)[count - 2] == 9);
  plumb_mesh_free(mended);
  OK(plumb_mesh_repair(mesh, NULL, &mended, &told, NULL, NULL, &error));
  CHECK(told.degenerate == 3 && plumb_mesh_face_count(mended) == 6);
  CHECK(plumb_mesh_face_values(mended, PLUMB_FACE_ID)[0] == 4);
  plumb_mesh_free(mended);
  OK(plumb_mesh_convexity(mesh, &is_convex, NULL, NULL, NULL, &error));
  OK(plumb_mesh_write(mesh, "off", &bytes, &error));
  plumb_bytes_free(bytes);
  OK(plumb_solid_from_mesh(mesh, NULL, &solid, NULL, &error));
  CHECK(has_volume(solid, "1"));
  plumb_solid_free(solid);
  plumb_mesh_free(mesh);
  OK(plumb_plane_set_polygons(kCube, 12, chains, 3, kTriangles, 3, 0, true, &set, NULL, &error));
  CHECK(!plumb_plane_set_is_empty(set));
  plumb_plane_set_free(set);
  OK(plumb_plane_set_polylines(kCube, 12, chains, 3, kTriangles, 3, &set, NULL, &error));
  plumb_plane_set_free(set);
}

/* ---- solids --------------------------------------------------------------------------------- */

static void test_solid_algebra(void) {
  plumb_solid *a = cube_at(0, 0, 0), *b = cube_at(0.5, 0, 0), *far_away = cube_at(5, 0, 0);
  plumb_solid *both = NULL, *common = NULL, *rest = NULL, *either = NULL, *x = NULL, *y = NULL;
  const plumb_solid* three[3];
  const char* names[2] = {"A", "B"};
  const char* null_names[2] = {NULL, NULL};
  bool answer = false;
  OK(plumb_solid_union(a, far_away, &both, NULL, &error));
  CHECK(has_volume(both, "2"));
  plumb_solid_free(both);
  OK(plumb_solid_union(a, b, &both, NULL, &error));
  OK(plumb_solid_intersection(a, b, &common, NULL, &error));
  OK(plumb_solid_difference(a, b, &rest, NULL, &error));
  OK(plumb_solid_symmetric_difference(a, b, &either, NULL, &error));
  CHECK(has_volume(both, "3/2") && has_volume(common, "1/2") && has_volume(rest, "1/2") &&
        has_volume(either, "1"));

  /* A ^ B = (A + B) - (A * B). */
  OK(plumb_solid_combine(both, common, PLUMB_DIFFERENCE, &x, NULL, &error));
  CHECK(same(x, either) && !same(x, both));
  plumb_solid_free(x);
  three[0] = a;
  three[1] = b;
  OK(plumb_solid_evaluate("(A + B) - A * B", names, three, 2, &x, NULL, &error));
  CHECK(same(x, either));
  plumb_solid_free(x);
  plumb_solid* sum = NULL;
  OK(plumb_solid_evaluate("A @ B", names, three, 2, &x, NULL, &error));
  OK(plumb_solid_minkowski_sum(a, b, &sum, NULL, &error));
  CHECK(same(x, sum));
  plumb_solid_free(sum);
  plumb_solid_free(x);
  FAILS(plumb_solid_evaluate("A + C", names, three, 2, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_solid_evaluate("A +", names, three, 2, &x, NULL, &error), PLUMB_SYNTAX);
  FAILS(plumb_solid_evaluate("A", null_names, three, 2, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_solid_combine(a, b, 32, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS_WITH(plumb_solid_union(a, NULL, &x, NULL, &error), PLUMB_BAD_ARGUMENT,
             "b is a null pointer");
  CHECK(x == NULL);

  /* De Morgan; the difference lacks a facet, which regularization gives back. */
  OK(plumb_solid_complement(a, &x, NULL, &error));
  OK(plumb_solid_union(x, b, &y, NULL, &error));
  plumb_solid_free(x);
  OK(plumb_solid_complement(y, &x, NULL, &error));
  CHECK(same(x, rest));
  plumb_solid_free(x);
  plumb_solid_free(y);
  OK(plumb_solid_combine(a, b, PLUMB_DIFFERENCE | PLUMB_REGULARIZED, &x, NULL, &error));
  OK(plumb_solid_regularization(rest, &y, NULL, &error));
  CHECK(same(x, y) && !same(x, rest));
  plumb_solid_free(x);
  plumb_solid_free(y);

  /* Closure, interior and boundary; exterior. */
  OK(plumb_solid_interior(a, &x, NULL, &error));
  OK(plumb_solid_boundary(a, &y, NULL, &error));
  OK(plumb_solid_is_subset(x, a, &answer, NULL, &error));
  CHECK(answer);
  OK(plumb_solid_is_subset(a, x, &answer, NULL, &error));
  CHECK(!answer);
  plumb_solid_free(common);
  OK(plumb_solid_union(x, y, &common, NULL, &error));
  CHECK(same(common, a));
  plumb_solid_free(common);
  OK(plumb_solid_closure(x, &common, NULL, &error));
  CHECK(same(common, a));
  plumb_solid_free(common);
  plumb_solid_free(x);
  OK(plumb_solid_exterior(a, &x, NULL, &error));
  OK(plumb_solid_union(x, a, &common, NULL, &error));
  CHECK(plumb_solid_is_whole(common) && !plumb_solid_is_empty(common));
  plumb_solid_free(common);
  plumb_solid_free(x);
  plumb_solid_free(y);

  three[2] = far_away;
  OK(plumb_solid_union_of(three, 3, &x, NULL, &error));
  CHECK(has_volume(x, "5/2"));
  plumb_solid_free(x);
  OK(plumb_solid_intersection_of(three, 3, &x, NULL, &error));
  CHECK(plumb_solid_is_empty(x));
  plumb_solid_free(x);
  OK(plumb_solid_union_of(NULL, 0, &x, NULL, &error));
  OK(plumb_solid_empty(&y, &error));
  CHECK(same(x, y));
  plumb_solid_free(x);
  plumb_solid_free(y);
  OK(plumb_solid_intersection_of(NULL, 0, &x, NULL, &error));
  OK(plumb_solid_whole(&y, &error));
  CHECK(same(x, y));
  plumb_solid_free(x);
  plumb_solid_free(y);
  three[1] = NULL;
  FAILS(plumb_solid_union_of(three, 3, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_solid_copy(either, &x, &error));
  plumb_solid_free(either);
  CHECK(has_volume(x, "1"));
  plumb_solid_free(x);
  plumb_solid_free(a);
  plumb_solid_free(b);
  plumb_solid_free(far_away);
  plumb_solid_free(both);
  plumb_solid_free(rest);
}

static void test_solid_makers(void) {
  /* The octahedron |x| + |y| + |z| <= 1. */
  double planes[32];
  bool closed[8] = {true, true, true, true, true, true, true, false};
  plumb_solid *x = NULL, *y = NULL, *z = NULL;
  plumb_solid_info info = PLUMB_SOLID_INFO_INIT;
  plumb_numbers* n = NULL;
  size_t i;
  for (i = 0; i < 8; ++i) {
    planes[4 * i] = (i & 1) ? 1 : -1;
    planes[4 * i + 1] = (i & 2) ? 1 : -1;
    planes[4 * i + 2] = (i & 4) ? 1 : -1;
    planes[4 * i + 3] = -1;
  }
  OK(plumb_solid_from_half_spaces(planes, NULL, 8, &x, NULL, &error));
  CHECK(has_volume(x, "4/3"));
  OK(plumb_solid_ball(1.0, 0, &y, &error));
  CHECK(same(x, y));
  plumb_solid_free(y);
  OK(plumb_solid_from_half_spaces(planes, closed, 8, &y, NULL, &error));
  CHECK(has_volume(y, "4/3") && !same(x, y));
  plumb_solid_free(y);
  planes[5] = INFINITY;
  FAILS(plumb_solid_from_half_spaces(planes, NULL, 8, &y, NULL, &error), PLUMB_NOT_FINITE);
  OK(plumb_solid_read_half_spaces_file("corpus/solids/octahedron.txt", NULL, &y, NULL, &error));
  OK(plumb_solid_describe(y, &info, &error));
  CHECK(info.facets == 8 && info.vertices == 6 && info.is_convex && info.is_simple);
  plumb_solid_free(y);
  plumb_solid_free(x);
  FAILS(plumb_solid_ball(NAN, 0, &x, &error), PLUMB_NOT_FINITE);
  FAILS(plumb_solid_ball(-1, 0, &x, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_solid_ball(1, 8, &x, &error), PLUMB_RESOURCE_LIMIT);

  /* A half-space and the opposite one meet in their plane. */
  n = numbers("1 0 0 -1/3");
  OK(plumb_solid_half_space(n, true, &x, &error));
  OK(plumb_solid_plane(n, &z, &error));
  plumb_numbers_free(n);
  n = numbers("-3 0 0 1");
  OK(plumb_solid_half_space(n, true, &y, &error));
  plumb_numbers_free(n);
  OK(plumb_solid_describe(x, &info, &error));
  CHECK(!info.is_bounded && info.is_closed && !info.is_open && !info.is_empty && !info.is_whole &&
        info.marked_volumes == 1 && info.volumes == 2 && info.facets == 1 && info.edges == 0 &&
        info.bytes > 0);
  OK(plumb_solid_volume(x, &n, NULL, &error));
  CHECK(plumb_numbers_count(n) == 0);
  plumb_numbers_free(n);
  {
    plumb_solid* meet = NULL;
    OK(plumb_solid_intersection(x, y, &meet, NULL, &error));
    CHECK(same(meet, z));
    plumb_solid_free(meet);
  }
  plumb_solid_free(x);
  plumb_solid_free(y);
  plumb_solid_free(z);
  n = numbers("0 0 0 1");
  FAILS(plumb_solid_half_space(n, true, &x, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_solid_points(n, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_numbers_free(n);

  /* Points, segments and facets. */
  n = numbers("0 0 0 1 0 0 1 1 0 0 1 0");
  OK(plumb_solid_points(n, &x, NULL, &error));
  OK(plumb_solid_describe(x, &info, &error));
  CHECK(info.vertices == 4 && info.edges == 0);
  OK(plumb_solid_polyline(n, &y, NULL, &error));
  OK(plumb_solid_describe(y, &info, &error));
  CHECK(info.vertices == 4 && info.edges == 3);
  OK(plumb_solid_facet(n, &z, NULL, &error));
  OK(plumb_solid_describe(z, &info, &error));
  CHECK(info.facets == 1 && info.edges == 4);
  {
    bool is_in = false;
    OK(plumb_solid_is_subset(x, y, &is_in, NULL, &error));
    CHECK(is_in);
    OK(plumb_solid_is_subset(y, z, &is_in, NULL, &error));
    CHECK(is_in);
    OK(plumb_solid_is_subset(z, y, &is_in, NULL, &error));
    CHECK(!is_in);
  }
  plumb_numbers_free(n);
  plumb_solid_free(x);
  plumb_solid_free(y);
  plumb_solid_free(z);
  n = numbers("0 0 0 1 0 0 1 1 0 0 1 1");
  FAILS(plumb_solid_facet(n, &x, NULL, &error), PLUMB_BAD_SHAPE);
  plumb_numbers_free(n);
}

static void test_solid_questions(void) {
  const double points[9] = {0.5, 0.5, 0.5, 1, 1, 1, 2, 0, 0};
  const double bad[3] = {0, NAN, 0};
  bool inside[3] = {false, false, true};
  bool is_hit = false, is_convex = false;
  double area = 0;
  uint64_t reflex = 9;
  plumb_location at[4];
  plumb_numbers *n = NULL, *point = NULL;
  plumb_indices* failing = NULL;
  plumb_bytes* flaw = NULL;
  plumb_solid *cube = cube_at(0, 0, 0), *block = NULL, *x = NULL;
  OK(plumb_solid_contains(cube, points, 3, inside, NULL, &error));
  CHECK(inside[0] && inside[1] && !inside[2]);
  FAILS(plumb_solid_contains(cube, bad, 1, inside, NULL, &error), PLUMB_NOT_FINITE);
  FAILS(plumb_solid_contains(cube, points, 3, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  n = numbers("0 0 0 1/3 0 0 1/3 1/3 0 1/3 1/3 1/3");
  OK(plumb_solid_locate(cube, n, at, 4, NULL, &error));
  CHECK(at[0].dimension == 0 && at[1].dimension == 1 && at[2].dimension == 2 &&
        at[3].dimension == 3);
  CHECK(at[0].is_inside && at[3].is_inside);
  FAILS(plumb_solid_locate(cube, n, at, 3, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_numbers_free(n);

  n = numbers("1/3 1/3 -7 0 0 1");
  OK(plumb_solid_shoot(cube, n, false, &is_hit, at, &point, NULL, &error));
  CHECK(is_hit && at[0].dimension == 2 && at[0].is_inside);
  CHECK(!strcmp(plumb_numbers_exact(point, 0), "1/3") &&
        !strcmp(plumb_numbers_exact(point, 2), "0"));
  plumb_numbers_free(point);
  OK(plumb_solid_interior(cube, &x, NULL, &error));
  OK(plumb_solid_shoot(x, n, true, &is_hit, at, NULL, NULL, &error));
  CHECK(is_hit && at[0].dimension == 2 && !at[0].is_inside);
  plumb_solid_free(x);
  plumb_numbers_free(n);
  n = numbers("1/3 1/3 -7 0 0 -1");
  OK(plumb_solid_shoot(cube, n, false, &is_hit, NULL, &point, NULL, &error));
  CHECK(!is_hit && point == NULL);
  plumb_numbers_free(n);
  n = numbers("1/3 1/3 -7 0 0 0");
  FAILS(plumb_solid_shoot(cube, n, false, &is_hit, NULL, &point, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_numbers_free(n);

  OK(plumb_solid_centroid(cube, &n, NULL, &error));
  CHECK(plumb_numbers_count(n) == 3 && !strcmp(plumb_numbers_exact(n, 1), "1/2"));
  plumb_numbers_free(n);
  OK(plumb_solid_surface_area(cube, &area, NULL, &error));
  CHECK(area == 6);
  OK(plumb_solid_whole(&x, &error));
  OK(plumb_solid_centroid(x, &n, NULL, &error));
  CHECK(plumb_numbers_count(n) == 0);
  plumb_numbers_free(n);
  plumb_solid_free(x);

  OK(plumb_solid_read_file("corpus/solids/l-block.off", NULL, NULL, &block, NULL, NULL, &error));
  OK(plumb_solid_convexity(block, &is_convex, &reflex, &failing, NULL, &error));
  CHECK(!is_convex && reflex == 1 && plumb_indices_count(failing) == 4);
  CHECK(plumb_indices_data(failing) != NULL);
  plumb_indices_free(failing);
  OK(plumb_solid_convexity(cube, &is_convex, NULL, NULL, NULL, &error));
  CHECK(is_convex);
  OK(plumb_solid_audit(block, &flaw, NULL, &error));
  CHECK(flaw == NULL);
  plumb_solid_free(block);
  plumb_solid_free(cube);
}

static void test_solid_changes(void) {
  plumb_solid *cube = cube_at(0, 0, 0), *ball = NULL, *x = NULL, *y = NULL, *block = NULL;
  plumb_solid_list* pieces = NULL;
  plumb_numbers* n = numbers("0 0 1 -1/4");
  size_t i;
  int method;
  OK(plumb_solid_section(cube, n, PLUMB_SECTION_CLOSED_BELOW, PLUMB_INTERSECTION, &x, NULL,
                         &error));
  CHECK(has_volume(x, "1/4"));
  plumb_solid_free(x);
  OK(plumb_solid_section(cube, n, PLUMB_SECTION_OPEN_BELOW, PLUMB_DIFFERENCE | PLUMB_REGULARIZED,
                         &x, NULL, &error));
  CHECK(has_volume(x, "3/4"));
  plumb_solid_free(x);
  OK(plumb_solid_section(cube, n, PLUMB_SECTION_PLANE, PLUMB_INTERSECTION, &x, NULL, &error));
  CHECK(has_volume(x, "0") && !plumb_solid_is_empty(x));
  plumb_solid_free(x);
  FAILS(plumb_solid_section(cube, n, 3, PLUMB_UNION, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_numbers_free(n);

  n = numbers("2 0 0 1/3 0 3 0 0 0 0 1 0");
  OK(plumb_solid_transform(cube, n, &x, NULL, &error));
  CHECK(has_volume(x, "6"));
  plumb_numbers_free(n);
  n = numbers("1/2 0 0 -1/6 0 1/3 0 0 0 0 1 0");
  OK(plumb_solid_transform(x, n, &y, NULL, &error));
  CHECK(same(y, cube));
  plumb_solid_free(x);
  plumb_solid_free(y);
  plumb_numbers_free(n);
  n = numbers("1 0 0 0 0 1 0 0 1 1 0 0");
  FAILS(plumb_solid_transform(cube, n, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_numbers_free(n);

  /* Erosion undoes the sum of convex bodies. */
  OK(plumb_solid_minkowski_sum(cube, cube, &x, NULL, &error));
  CHECK(has_volume(x, "8"));
  OK(plumb_solid_minkowski_erosion(x, cube, &y, NULL, &error));
  CHECK(same(y, cube));
  plumb_solid_free(x);
  plumb_solid_free(y);
  OK(plumb_solid_whole(&x, &error));
  FAILS(plumb_solid_minkowski_sum(cube, x, &y, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_solid_free(x);

  /* The union of the convex pieces is the set. */
  OK(plumb_solid_read_file("corpus/solids/l-block.off", NULL, NULL, &block, NULL, NULL, &error));
  for (method = PLUMB_DECOMPOSE_BEST; method <= PLUMB_DECOMPOSE_WALLS; ++method) {
    plumb_solid_info info = PLUMB_SOLID_INFO_INIT;
    OK(plumb_solid_decompose(block, method, method == PLUMB_DECOMPOSE_CUTS, &pieces, NULL, &error));
    CHECK(plumb_solid_list_count(pieces) == 2);
    OK(plumb_solid_empty(&x, &error));
    for (i = 0; i < plumb_solid_list_count(pieces); ++i) {
      OK(plumb_solid_describe(plumb_solid_list_at(pieces, i), &info, &error));
      CHECK(info.is_convex);
      OK(plumb_solid_union(x, plumb_solid_list_at(pieces, i), &y, NULL, &error));
      plumb_solid_free(x);
      x = y;
    }
    CHECK(same(x, block));
    CHECK(plumb_solid_list_at(pieces, 2) == NULL);
    plumb_solid_free(x);
    plumb_solid_list_free(pieces);
  }
  FAILS(plumb_solid_decompose(block, 3, false, &pieces, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_solid_ball(1, 1, &ball, &error));
  plumb_solid_free(ball);
  plumb_solid_free(block);
  plumb_solid_free(cube);
}

static void test_solid_files(void) {
  static const char* const formats[] = {"off",        "off-exact", "obj",      "stl",
                                        "stl-binary", "ply",       "ply-text", "nef"};
  plumb_write_options writing = PLUMB_WRITE_OPTIONS_INIT;
  plumb_solid_options options = PLUMB_SOLID_OPTIONS_INIT;
  plumb_read_options reading = PLUMB_READ_OPTIONS_INIT;
  plumb_solid *a = cube_at(0, 0, 0), *b = cube_at(0.25, 0.25, 0.25);
  plumb_solid *x = NULL, *y = NULL, *z = NULL;
  plumb_bytes *bytes = NULL, *other = NULL;
  plumb_notes* notes = NULL;
  plumb_numbers* step = numbers("1/8");
  size_t i;
  OK(plumb_solid_difference(a, b, &x, NULL, &error));
  for (i = 0; i < sizeof formats / sizeof *formats; ++i) {
    OK(plumb_solid_write(x, formats[i], NULL, &bytes, &notes, NULL, &error));
    OK(plumb_solid_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), NULL, NULL, &y, NULL,
                        NULL, &error));
    CHECK(has_volume(y, "37/64"));
    /* Only .nef tells that facets do not belong to the difference. */
    CHECK(same(x, y) == !strcmp(formats[i], "nef"));
    CHECK((plumb_notes_count(notes) == 0) == !strcmp(formats[i], "nef"));
    plumb_solid_free(y);
    plumb_bytes_free(bytes);
    plumb_notes_free(notes);
  }
  /* Canonical bytes depend on the set alone. */
  OK(plumb_solid_complement(x, &y, NULL, &error));
  OK(plumb_solid_complement(y, &z, NULL, &error));
  plumb_solid_free(y);
  OK(plumb_solid_canonical(z, &y, NULL, &error));
  OK(plumb_solid_write(y, "nef", NULL, &bytes, NULL, NULL, &error));
  plumb_solid_free(y);
  plumb_solid_free(z);
  OK(plumb_solid_canonical(x, &y, NULL, &error));
  OK(plumb_solid_write(y, "nef", NULL, &other, NULL, NULL, &error));
  CHECK(plumb_bytes_size(bytes) == plumb_bytes_size(other) &&
        memcmp(plumb_bytes_data(bytes), plumb_bytes_data(other), plumb_bytes_size(bytes)) == 0);
  plumb_solid_free(y);
  plumb_bytes_free(bytes);
  plumb_bytes_free(other);

  OK(plumb_solid_write_file(x, path_of("difference.nef"), NULL, NULL, &notes, NULL, &error));
  plumb_notes_free(notes);
  OK(plumb_solid_read_file(path_of("difference.nef"), &reading, &options, &y, &notes, NULL,
                           &error));
  CHECK(same(x, y));
  plumb_notes_free(notes);
  plumb_solid_free(y);
  writing.raw = true;
  OK(plumb_solid_write_file(x, path_of("difference.mesh"), "off", &writing, NULL, NULL, &error));
  writing.grid = step;
  FAILS(plumb_solid_write(x, "off", &writing, &bytes, NULL, NULL, &error), PLUMB_USAGE);
  FAILS(plumb_solid_write(x, "gltf", NULL, &bytes, NULL, NULL, &error), PLUMB_UNKNOWN_FORMAT);
  FAILS(plumb_solid_write_file(x, path_of("x.xyz"), NULL, NULL, NULL, NULL, &error),
        PLUMB_UNKNOWN_FORMAT);
  FAILS(plumb_solid_read_file(path_of("none.off"), NULL, NULL, &y, NULL, NULL, &error),
        PLUMB_CANNOT_OPEN);
  reading.name = "half.nef";
  FAILS_WITH(plumb_solid_read("plumb-nef3 1\n", 13, &reading, NULL, &y, NULL, NULL, &error),
             PLUMB_COUNT_MISMATCH, "half.nef:2:");
  options.rule = 9;
  FAILS(plumb_solid_read("OFF\n0 0 0\n", 10, NULL, &options, &y, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  options.rule = PLUMB_RULE_EVEN_ODD;
  options.surface = true;
  OK(plumb_solid_from_triangles(kCube, 8, kTriangles, 11, &options, &y, NULL, &error));
  CHECK(has_volume(y, "0") && !plumb_solid_is_empty(y));
  plumb_solid_free(y);
  plumb_numbers_free(step);
  plumb_solid_free(a);
  plumb_solid_free(b);
  plumb_solid_free(x);
}

static void test_solid_meshes(void) {
  plumb_to_mesh_options options = PLUMB_TO_MESH_OPTIONS_INIT;
  plumb_to_mesh_report report = PLUMB_TO_MESH_REPORT_INIT;
  plumb_solid *a = cube_at(0, 0, 0), *x = NULL, *y = NULL;
  plumb_mesh *mesh = NULL, *rounded = NULL;
  plumb_numbers *n = numbers("1/3 0 0 0 0 1 0 0 0 0 1 0"), *point = NULL;
  OK(plumb_solid_to_mesh(a, NULL, &mesh, NULL, NULL, &error));
  CHECK(plumb_mesh_face_count(mesh) == 12 && plumb_mesh_facets(mesh) != NULL);
  OK(plumb_solid_from_mesh(mesh, NULL, &x, NULL, &error));
  CHECK(same(x, a));
  plumb_solid_free(x);
  plumb_mesh_free(mesh);
  OK(plumb_solid_transform(a, n, &x, NULL, &error));
  options.polygons = true;
  OK(plumb_solid_to_mesh(x, &options, &mesh, &report, NULL, &error));
  CHECK(report.rounded_vertices == 4 && report.rounds == 0 && report.dropped == 0);
  CHECK(report.largest_move > 0 && report.largest_move < 1e-15 && !report.changes_topology);
  plumb_mesh_free(mesh);
  /* The exact mesh gives the set back. */
  options.exact = true;
  OK(plumb_solid_to_mesh(x, &options, &mesh, &report, NULL, &error));
  CHECK(plumb_mesh_face_count(mesh) >= 6);
  OK(plumb_solid_from_mesh(mesh, NULL, &y, NULL, &error));
  CHECK(same(x, y));
  {
    size_t i, thirds = 0;
    for (i = 0; i < plumb_mesh_point_count(mesh); ++i) {
      OK(plumb_mesh_exact_point(mesh, i, &point, &error));
      if (!strcmp(plumb_numbers_exact(point, 0), "1/3")) ++thirds;
      plumb_numbers_free(point);
    }
    CHECK(thirds == 4);
  }
  /* The nearest doubles are the same without the exact points, and for callers of the older
   * struct. */
  options.exact = false;
  options.nearest = 1;
  report.rounded_vertices = 0;
  OK(plumb_solid_to_mesh(x, &options, &rounded, &report, NULL, &error));
  CHECK(report.rounded_vertices == 4 && report.rounds == 0);
  CHECK(plumb_mesh_point_count(rounded) == plumb_mesh_point_count(mesh));
  CHECK(!memcmp(plumb_mesh_points(rounded), plumb_mesh_points(mesh),
                3 * plumb_mesh_point_count(mesh) * sizeof(double)));
  CHECK(plumb_mesh_corner_count(rounded) == plumb_mesh_corner_count(mesh));
  CHECK(!memcmp(plumb_mesh_corners(rounded), plumb_mesh_corners(mesh),
                plumb_mesh_corner_count(mesh) * sizeof(uint32_t)));
  {
    size_t i, thirds = 0;
    for (i = 0; i < plumb_mesh_point_count(rounded); ++i) {
      OK(plumb_mesh_exact_point(rounded, i, &point, &error));
      if (!strcmp(plumb_numbers_exact(point, 0), "1/3")) ++thirds;
      plumb_numbers_free(point);
    }
    CHECK(thirds == 0);
  }
  plumb_mesh_free(rounded);
  plumb_mesh_free(mesh);
  plumb_solid_free(y);
  options.struct_size = offsetof(plumb_to_mesh_options, nearest);
  OK(plumb_solid_to_mesh(x, &options, &mesh, &report, NULL, &error));
  CHECK(report.largest_move > 0);
  plumb_mesh_free(mesh);
  options.struct_size = sizeof options;
  options.floats = true;
  FAILS(plumb_solid_to_mesh(x, &options, &mesh, &report, NULL, &error), PLUMB_USAGE);
  options.nearest = 0;
  options.exact = true;
  FAILS(plumb_solid_to_mesh(x, &options, &mesh, &report, NULL, &error), PLUMB_USAGE);
  options.exact = false;
  OK(plumb_solid_to_mesh(x, &options, &mesh, &report, NULL, &error));
  {
    size_t i;
    for (i = 0; i < 3 * plumb_mesh_point_count(mesh); ++i) {
      CHECK(plumb_mesh_points(mesh)[i] == (double)(float)plumb_mesh_points(mesh)[i]);
    }
  }
  plumb_mesh_free(mesh);
  plumb_solid_free(x);
  OK(plumb_solid_complement(a, &x, NULL, &error));
  FAILS(plumb_solid_to_mesh(x, NULL, &mesh, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  CHECK(mesh == NULL);
  plumb_solid_free(x);
  plumb_solid_free(a);
  plumb_numbers_free(n);
}

/* ---- attributes ----------------------------------------------------------------------------- */

/* A cube of squares with one material, two groups, the ids 10 to 15, and two channels: the places
 * of the corners, and their first two coordinates. */
static plumb_mesh* painted_cube(double shift, const char* name, double red) {
  static const uint32_t zeros[6] = {0, 0, 0, 0, 0, 0}, groups[6] = {0, 0, 1, 1, 1, PLUMB_NONE};
  static const uint32_t ids[6] = {10, 11, 12, 13, 14, 15};
  double xyz[24], uv[48];
  plumb_material material = PLUMB_MATERIAL_INIT;
  plumb_mesh* mesh = NULL;
  uint32_t index = 7;
  size_t i;
  for (i = 0; i < 24; ++i) xyz[i] = kCube[i] + shift;
  for (i = 0; i < 48; ++i) uv[i] = xyz[3 * kSquares[i / 2] + i % 2];
  OK(plumb_mesh_from_polygons(xyz, 8, kSquareBegin, 6, kSquares, 24, &mesh, &error));
  material.name = name;
  material.has_color = true;
  material.color[0] = red;
  OK(plumb_mesh_add_material(mesh, &material, &index, &error));
  CHECK(index == 0);
  OK(plumb_mesh_add_group(mesh, "flat", NULL, &error));
  OK(plumb_mesh_add_group(mesh, "steep", &index, &error));
  CHECK(index == 1);
  OK(plumb_mesh_set_face_values(mesh, PLUMB_FACE_MATERIAL, zeros, 6, &error));
  OK(plumb_mesh_set_face_values(mesh, PLUMB_FACE_GROUP, groups, 6, &error));
  OK(plumb_mesh_set_face_values(mesh, PLUMB_FACE_ID, ids, 6, &error));
  OK(plumb_mesh_set_channel(mesh, "place", 3, PLUMB_PER_POINT, xyz, 8, &error));
  OK(plumb_mesh_set_channel(mesh, "texcoord_0", 2, PLUMB_PER_CORNER, uv, 24, &error));
  return mesh;
}

static const double* channel_called(const plumb_mesh* mesh, const char* name, uint32_t width) {
  size_t i;
  for (i = 0; i < plumb_mesh_channel_count(mesh); ++i) {
    if (strcmp(plumb_mesh_channel_name(mesh, i), name)) continue;
    CHECK(plumb_mesh_channel_width(mesh, i) == width);
    return plumb_mesh_channel_values(mesh, i);
  }
  return NULL;
}

static double area_of(const plumb_mesh* mesh, size_t face) { /* Of a face parallel to two axes. */
  const double* xyz = plumb_mesh_points(mesh);
  const uint32_t* begin = plumb_mesh_face_begin(mesh) + face;
  const uint32_t* corners = plumb_mesh_corners(mesh);
  double sum[3] = {0, 0, 0};
  uint32_t c, k;
  for (c = begin[0]; c < begin[1]; ++c) {
    const double* p = xyz + 3 * corners[c];
    const double* q = xyz + 3 * corners[c + 1 < begin[1] ? c + 1 : begin[0]];
    for (k = 0; k < 3; ++k)
      sum[k] += p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
  }
  return (fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2])) / 2;
}

/* Each face lies in the plane of its source face and has its values; channels that are coordinates
 * have those of each corner. The sources are painted cubes, the second half a unit farther. */
static void check_painted(const plumb_mesh* mesh, double first_area, double second_area) {
  const double shift[2] = {0, 0.5};
  const uint32_t* source = plumb_mesh_face_values(mesh, PLUMB_FACE_SOURCE);
  const uint32_t* face = plumb_mesh_face_values(mesh, PLUMB_FACE_SOURCE_FACE);
  const uint32_t* flipped = plumb_mesh_face_values(mesh, PLUMB_FACE_IS_FLIPPED);
  const uint32_t* material = plumb_mesh_face_values(mesh, PLUMB_FACE_MATERIAL);
  const uint32_t* group = plumb_mesh_face_values(mesh, PLUMB_FACE_GROUP);
  const uint32_t* id = plumb_mesh_face_values(mesh, PLUMB_FACE_ID);
  const double *place = channel_called(mesh, "place", 3),
               *uv = channel_called(mesh, "texcoord_0", 2);
  const uint32_t *begin = plumb_mesh_face_begin(mesh), *corners = plumb_mesh_corners(mesh);
  const double* xyz = plumb_mesh_points(mesh);
  double area[2] = {0, 0};
  size_t f;
  uint32_t c, k;
  if (!source || !face || !flipped || !material || !group || !id || !place || !uv) {
    CHECK(false && "all arrays are there");
    return;
  }
  for (f = 0; f < plumb_mesh_face_count(mesh); ++f) {
    CHECK(source[f] < 2 && face[f] < 6 && (f == 0 || source[f - 1] <= source[f]));
    if (source[f] > 1 || face[f] > 5) return;
    CHECK(flipped[f] == source[f] && material[f] == source[f] && id[f] == 10 + face[f]);
    CHECK(group[f] == (face[f] == 5 ? PLUMB_NONE : 2 * source[f] + (face[f] > 1)));
    area[source[f]] += area_of(mesh, f);
    for (c = begin[f]; c < begin[f + 1]; ++c) {
      const double* p = xyz + 3 * corners[c];
      CHECK(memcmp(place + 3 * c, p, 3 * sizeof *p) == 0);
      CHECK(memcmp(uv + 2 * c, p, 2 * sizeof *p) == 0);
      for (k = 0; k < 3; ++k) { /* The coordinate that the square has in common. */
        const uint32_t* square = kSquares + 4 * face[f];
        const double level = kCube[3 * square[0] + k];
        if (level != kCube[3 * square[1] + k] || level != kCube[3 * square[2] + k]) continue;
        CHECK(p[k] == level + shift[source[f]]);
      }
    }
  }
  CHECK(area[0] == first_area && area[1] == second_area);
}

static plumb_solid* painted_difference(void) {
  plumb_mesh *red = painted_cube(0, "red", 1), *blue = painted_cube(0.5, "blue", 0);
  plumb_solid *a = NULL, *b = NULL, *both = NULL;
  plumb_solid_options options = PLUMB_SOLID_OPTIONS_INIT;
  OK(plumb_solid_from_mesh(red, NULL, &a, NULL, &error));
  options.source_name = "second";
  OK(plumb_solid_from_mesh(blue, &options, &b, NULL, &error));
  plumb_mesh_free(red); /* The solid has its own copy. */
  plumb_mesh_free(blue);
  OK(plumb_solid_difference(a, b, &both, NULL, &error));
  plumb_solid_free(a);
  plumb_solid_free(b);
  return both;
}

static void test_attributes_of_solids(void) {
  plumb_attribute_options options = PLUMB_ATTRIBUTE_OPTIONS_INIT;
  plumb_to_mesh_report report = PLUMB_TO_MESH_REPORT_INIT;
  plumb_material material = PLUMB_MATERIAL_INIT;
  plumb_solid *both = painted_difference(), *x = NULL, *y = NULL;
  plumb_mesh *mesh = NULL, *joined = NULL;
  plumb_numbers* n = numbers("1 0 0 1/3 0 1 0 0 0 0 1 0");
  size_t i;
  CHECK(plumb_solid_source_count(both) == 2);
  CHECK(!strcmp(plumb_solid_source_name(both, 0), ""));
  CHECK(!strcmp(plumb_solid_source_name(both, 1), "second"));
  CHECK(plumb_solid_source_name(both, 2) == NULL);
  for (i = 0; i < 6; ++i) {
    options.pieces = (int)(i % 3);
    options.polygons = i > 2;
    OK(plumb_solid_to_mesh_with_attributes(both, &options, &mesh, &report, NULL, &error));
    CHECK(report.rounded_vertices == 0 && report.dropped == 0);
    check_painted(mesh, 5.25, 0.75);
    if (options.pieces == PLUMB_PIECES_SAME_FACE && options.polygons) {
      /* Three whole squares, three squares of the cut, and three squares without a quarter. */
      CHECK(plumb_mesh_face_count(mesh) == 9);
      CHECK(plumb_mesh_corner_count(mesh) == 3 * 4 + 3 * 4 + 3 * 6);
    }
    plumb_mesh_free(mesh);
  }
  OK(plumb_solid_to_mesh_with_attributes(both, NULL, &mesh, NULL, NULL, &error));
  check_painted(mesh, 5.25, 0.75);
  CHECK(plumb_mesh_facets(mesh) == NULL && plumb_mesh_material_count(mesh) == 2);
  CHECK(plumb_mesh_group_count(mesh) == 4 && !strcmp(plumb_mesh_group(mesh, 3), "steep"));
  OK(plumb_mesh_material(mesh, 1, &material, &error));
  CHECK(!strcmp(material.name, "blue") && material.has_color && material.color[0] == 0);
  CHECK(material.color[3] == 1 && !strcmp(material.texture, ""));
  plumb_mesh_free(mesh);

  /* A map moves the faces; what belongs to them stays. */
  OK(plumb_solid_transform(both, n, &x, NULL, &error));
  OK(plumb_solid_to_mesh_with_attributes(x, NULL, &mesh, &report, NULL, &error));
  CHECK(report.rounded_vertices > 0 && plumb_solid_source_count(x) == 2);
  {
    const double* place = channel_called(mesh, "place", 3);
    for (i = 0; i < plumb_mesh_corner_count(mesh); ++i) {
      const double* p = plumb_mesh_points(mesh) + 3 * plumb_mesh_corners(mesh)[i];
      CHECK(fabs(place[3 * i] + 1.0 / 3 - p[0]) < 1e-15 && place[3 * i + 1] == p[1]);
    }
  }
  plumb_mesh_free(mesh);
  plumb_solid_free(x);

  /* Floats, and what is refused. */
  options.pieces = PLUMB_PIECES_SAME_ATTRIBUTES;
  options.floats = true;
  FAILS(plumb_solid_to_mesh_with_attributes(both, &options, &mesh, NULL, NULL, &error),
        PLUMB_USAGE);
  options.polygons = false;
  OK(plumb_solid_to_mesh_with_attributes(both, &options, &mesh, NULL, NULL, &error));
  check_painted(mesh, 5.25, 0.75);
  options.pieces = 3;
  FAILS_WITH(plumb_solid_to_mesh_with_attributes(both, &options, &joined, NULL, NULL, &error),
             PLUMB_BAD_ARGUMENT, "plumb_pieces");
  CHECK(joined == NULL);
  OK(plumb_solid_complement(both, &x, NULL, &error));
  FAILS(plumb_solid_to_mesh_with_attributes(x, NULL, &joined, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  plumb_solid_free(x);

  /* A mesh that has sources is a source as any other. */
  x = cube_at(0, 0, 0);
  CHECK(plumb_solid_source_count(x) == 0);
  FAILS(plumb_solid_with_source(x, NULL, "again", &y, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_solid_with_source(x, mesh, "again", &y, &error));
  CHECK(plumb_solid_source_count(y) == 1 && !strcmp(plumb_solid_source_name(y, 0), "again"));
  OK(plumb_solid_to_mesh_with_attributes(y, NULL, &joined, NULL, NULL, &error));
  for (i = 0; i < plumb_mesh_face_count(joined); ++i) {
    const uint32_t* source = plumb_mesh_face_values(joined, PLUMB_FACE_SOURCE);
    const uint32_t* id = plumb_mesh_face_values(joined, PLUMB_FACE_ID);
    CHECK((source[i] == PLUMB_NONE) == (id[i] == PLUMB_NONE));
  }
  plumb_mesh_free(joined);
  plumb_mesh_free(mesh);
  plumb_solid_free(x);
  plumb_solid_free(y);
  plumb_solid_free(both);
  plumb_numbers_free(n);
}

/* The cuts of a half-space are its face 0, with its material, group and id. */
static void test_sources_of_half_spaces(void) {
  const double level[] = {0, 0, 2, -1};
  plumb_numbers* n = NULL;
  plumb_plane_source source = PLUMB_PLANE_SOURCE_INIT;
  plumb_material material = PLUMB_MATERIAL_INIT;
  plumb_solid *cube = cube_at(0, 0, 0), *half = NULL, *cut = NULL;
  plumb_mesh* mesh = NULL;
  size_t i, faces_of_cut = 0;
  material.name = "end grain";
  source.name = "saw";
  source.material = &material;
  source.group = "cuts";
  source.id = 77;
  OK(plumb_numbers_from_doubles(level, 4, &n, &error));
  FAILS(plumb_solid_half_space_with_source(NULL, true, &source, &half, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_solid_half_space_with_source(n, false, &source, &half, &error));
  CHECK(plumb_solid_source_count(half) == 1 && !strcmp(plumb_solid_source_name(half, 0), "saw"));
  OK(plumb_solid_combine(cube, half, PLUMB_INTERSECTION, &cut, NULL, &error));
  OK(plumb_solid_to_mesh_with_attributes(cut, NULL, &mesh, NULL, NULL, &error));
  CHECK(plumb_mesh_material_count(mesh) == 1 && plumb_mesh_group_count(mesh) == 1);
  CHECK(!strcmp(plumb_mesh_group(mesh, 0), "cuts"));
  for (i = 0; i < plumb_mesh_face_count(mesh); ++i) {
    const bool is_cut = plumb_mesh_face_values(mesh, PLUMB_FACE_SOURCE)[i] == 0;
    const uint32_t* corner = plumb_mesh_corners(mesh) + 3 * i;
    size_t k, on_level = 0;
    for (k = 0; k < 3; ++k) on_level += plumb_mesh_points(mesh)[3 * corner[k] + 2] == 0.5;
    faces_of_cut += is_cut;
    CHECK(is_cut == (on_level == 3));
    CHECK(plumb_mesh_face_values(mesh, PLUMB_FACE_ID)[i] == (is_cut ? 77 : PLUMB_NONE));
    CHECK(plumb_mesh_face_values(mesh, PLUMB_FACE_GROUP)[i] == (is_cut ? 0 : PLUMB_NONE));
    CHECK(plumb_mesh_face_values(mesh, PLUMB_FACE_MATERIAL)[i] == (is_cut ? 0 : PLUMB_NONE));
  }
  CHECK(faces_of_cut == 2);
  plumb_mesh_free(mesh);
  plumb_solid_free(cut);
  plumb_solid_free(half);
  OK(plumb_solid_half_space_with_source(n, true, NULL, &half, &error));
  CHECK(plumb_solid_source_count(half) == 1);
  plumb_solid_free(half);
  plumb_solid_free(cube);
  plumb_numbers_free(n);
}

static size_t sources_of(const plumb_mesh* mesh, const plumb_solid_options* options) {
  plumb_solid* solid = NULL;
  size_t count;
  OK(plumb_solid_from_mesh(mesh, options, &solid, NULL, &error));
  count = plumb_solid_source_count(solid);
  plumb_solid_free(solid);
  return count;
}

static void test_kept_attributes(void) {
  static const double shift = 1e-9;
  plumb_repair_options repair = PLUMB_REPAIR_OPTIONS_INIT;
  plumb_solid_options options = PLUMB_SOLID_OPTIONS_INIT;
  plumb_mesh *mesh = painted_cube(0, "red", 1), *plain = NULL, *made = NULL;
  plumb_solid* solid = NULL;
  size_t i;
  OK(plumb_mesh_from_triangles(kCube, 8, kTriangles, 12, &plain, &error));
  CHECK(sources_of(mesh, NULL) == 1 && sources_of(plain, NULL) == 0);
  for (options.keep = PLUMB_KEEP_NONE; options.keep <= PLUMB_KEEP_ALL; ++options.keep) {
    CHECK(sources_of(mesh, &options) == (options.keep == PLUMB_KEEP_NONE ? 0 : 1));
    CHECK(sources_of(plain, &options) == (options.keep == PLUMB_KEEP_ALL ? 1 : 0));
  }
  FAILS_WITH(plumb_solid_from_mesh(mesh, &options, &solid, NULL, &error), PLUMB_BAD_ARGUMENT,
             "plumb_keep");
  /* A caller that does not know the member has what was there before it. */
  options.struct_size = offsetof(plumb_solid_options, keep);
  CHECK(sources_of(mesh, &options) == 1);
  options.struct_size = sizeof options;

  options.keep = PLUMB_KEEP_IDS;
  OK(plumb_solid_from_mesh(mesh, &options, &solid, NULL, &error));
  OK(plumb_solid_to_mesh_with_attributes(solid, NULL, &made, NULL, NULL, &error));
  CHECK(plumb_mesh_channel_count(made) == 0 && plumb_mesh_material_count(made) == 0);
  CHECK(plumb_mesh_face_values(made, PLUMB_FACE_ID) != NULL && plumb_mesh_group_count(made) == 2);
  plumb_mesh_free(made);
  plumb_solid_free(solid);

  /* Faces without attributes can be traced, too: triangles to triangles. */
  options.keep = PLUMB_KEEP_ALL;
  options.source_name = "box";
  OK(plumb_solid_from_triangles(kCube, 8, kTriangles, 12, &options, &solid, NULL, &error));
  CHECK(!strcmp(plumb_solid_source_name(solid, 0), "box"));
  OK(plumb_solid_to_mesh_with_attributes(solid, NULL, &made, NULL, NULL, &error));
  CHECK(plumb_mesh_face_values(made, PLUMB_FACE_MATERIAL) == NULL);
  for (i = 0; i < plumb_mesh_face_count(made); ++i) {
    CHECK(plumb_mesh_face_values(made, PLUMB_FACE_SOURCE)[i] == 0);
    CHECK(plumb_mesh_face_values(made, PLUMB_FACE_SOURCE_FACE)[i] < 12);
  }
  plumb_mesh_free(made);
  plumb_solid_free(solid);
  plumb_mesh_free(plain);

  /* Points that are welded move faces; these still find their source. */
  {
    double xyz[72];
    uint32_t corners[24];
    const uint32_t ids[6] = {5, 4, 3, 2, 1, 0};
    for (i = 0; i < 72; ++i) xyz[i] = kCube[3 * kSquares[i / 3] + i % 3] + (i % 7 == 0 ? shift : 0);
    for (i = 0; i < 24; ++i) corners[i] = (uint32_t)i;
    OK(plumb_mesh_from_polygons(xyz, 24, kSquareBegin, 6, corners, 24, &plain, &error));
    OK(plumb_mesh_set_face_values(plain, PLUMB_FACE_ID, ids, 6, &error));
    FAILS(plumb_solid_from_mesh(plain, NULL, &solid, NULL, &error), PLUMB_BAD_SHAPE);
    repair.weld = 1e-8;
    options.repair = &repair;
    OK(plumb_solid_from_mesh(plain, &options, &solid, NULL, &error));
    OK(plumb_solid_to_mesh_with_attributes(solid, NULL, &made, NULL, NULL, &error));
    for (i = 0; i < plumb_mesh_face_count(made); ++i) {
      const uint32_t from = plumb_mesh_face_values(made, PLUMB_FACE_SOURCE_FACE)[i];
      CHECK(from < 6 && plumb_mesh_face_values(made, PLUMB_FACE_ID)[i] == 5 - from);
    }
    plumb_mesh_free(made);
    plumb_solid_free(solid);
    plumb_mesh_free(plain);
  }
  plumb_mesh_free(mesh);
}

static void test_attribute_arrays(void) {
  const uint32_t values[6] = {0, 1, 0, PLUMB_NONE, 0, 0};
  const double channel[24] = {0}, bad[24] = {0, NAN};
  plumb_material material = PLUMB_MATERIAL_INIT;
  plumb_mesh* mesh = painted_cube(0, "red", 1);
  FAILS_WITH(plumb_mesh_set_face_values(mesh, PLUMB_FACE_MATERIAL, values, 6, &error),
             PLUMB_BAD_INDEX, "values[1]");
  CHECK(plumb_mesh_face_values(mesh, PLUMB_FACE_MATERIAL)[1] == 0);
  material.texture = "wood.png";
  OK(plumb_mesh_add_material(mesh, &material, NULL, &error));
  OK(plumb_mesh_set_face_values(mesh, PLUMB_FACE_MATERIAL, values, 6, &error));
  CHECK(memcmp(plumb_mesh_face_values(mesh, PLUMB_FACE_MATERIAL), values, sizeof values) == 0);
  OK(plumb_mesh_material(mesh, 1, &material, &error));
  CHECK(!material.has_color && !strcmp(material.texture, "wood.png") && material.name[0] == 0);
  FAILS(plumb_mesh_material(mesh, 2, &material, &error), PLUMB_BAD_INDEX);
  FAILS(plumb_mesh_material(mesh, 0, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS_WITH(plumb_mesh_set_face_values(mesh, PLUMB_FACE_ID, values, 5, &error), PLUMB_BAD_ARGUMENT,
             "6 faces");
  FAILS(plumb_mesh_set_face_values(mesh, PLUMB_FACE_SOURCE, values, 6, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_mesh_set_face_values(mesh, PLUMB_FACE_ID, NULL, 6, &error), PLUMB_BAD_ARGUMENT);
  CHECK(plumb_mesh_face_values(mesh, PLUMB_FACE_SOURCE) == NULL);
  CHECK(plumb_mesh_face_values(mesh, -1) == NULL && plumb_mesh_face_values(mesh, 6) == NULL);
  OK(plumb_mesh_set_face_values(mesh, PLUMB_FACE_ID, NULL, 0, &error));
  CHECK(plumb_mesh_face_values(mesh, PLUMB_FACE_ID) == NULL);
  material.has_color = true;
  material.color[2] = 1.5;
  FAILS(plumb_mesh_add_material(mesh, &material, NULL, &error), PLUMB_BAD_ARGUMENT);
  material.color[2] = NAN;
  FAILS(plumb_mesh_add_material(mesh, &material, NULL, &error), PLUMB_NOT_FINITE);
  FAILS(plumb_mesh_add_material(NULL, &material, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_mesh_add_group(mesh, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);

  CHECK(plumb_mesh_channel_count(mesh) == 2 && plumb_mesh_channel_name(mesh, 2) == NULL);
  CHECK(plumb_mesh_channel_width(mesh, 2) == 0 && plumb_mesh_channel_values(mesh, 2) == NULL);
  FAILS_WITH(plumb_mesh_set_channel(mesh, "place", 1, PLUMB_PER_CORNER, channel, 8, &error),
             PLUMB_BAD_ARGUMENT, "24 corners");
  FAILS_WITH(plumb_mesh_set_channel(mesh, "place", 3, PLUMB_PER_POINT, channel, 24, &error),
             PLUMB_BAD_ARGUMENT, "8 points");
  FAILS(plumb_mesh_set_channel(mesh, "place", 0, PLUMB_PER_CORNER, channel, 24, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_mesh_set_channel(mesh, "place", 1, 2, channel, 24, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_mesh_set_channel(mesh, "", 1, PLUMB_PER_CORNER, channel, 24, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS_WITH(plumb_mesh_set_channel(mesh, "place", 1, PLUMB_PER_CORNER, bad, 24, &error),
             PLUMB_NOT_FINITE, "values[1]");
  CHECK(channel_called(mesh, "place", 3) != NULL); /* Failures change nothing. */
  OK(plumb_mesh_set_channel(mesh, "place", 1, PLUMB_PER_CORNER, channel, 24, &error));
  CHECK(plumb_mesh_channel_count(mesh) == 2 && channel_called(mesh, "place", 1)[23] == 0);
  OK(plumb_mesh_set_channel(mesh, "place", 1, PLUMB_PER_CORNER, NULL, 0, &error));
  CHECK(plumb_mesh_channel_count(mesh) == 1 && channel_called(mesh, "place", 1) == NULL);
  plumb_mesh_free(mesh);
}

static bool has_note(const plumb_notes* notes, const char* part) {
  size_t i;
  for (i = 0; i < plumb_notes_count(notes); ++i) {
    if (strstr(plumb_notes_text(notes, i), part) != NULL) return true;
  }
  return false;
}

static void test_attribute_files(void) {
  plumb_read_options reading = PLUMB_READ_OPTIONS_INIT;
  plumb_solid_options options = PLUMB_SOLID_OPTIONS_INIT;
  plumb_material material = PLUMB_MATERIAL_INIT;
  plumb_mesh *mesh = painted_cube(0, "red", 1), *again = NULL;
  plumb_solid *both = painted_difference(), *solid = NULL;
  plumb_bytes* bytes = NULL;
  plumb_notes* notes = NULL;
  size_t i;
  /* PLY holds ids; the sentence names what it does not hold. */
  OK(plumb_mesh_lost_attributes(mesh, "ply", &bytes, &error));
  CHECK(strstr(plumb_bytes_data(bytes), "groups") != NULL);
  plumb_bytes_free(bytes);
  FAILS(plumb_mesh_lost_attributes(mesh, "gltf", &bytes, &error), PLUMB_UNKNOWN_FORMAT);
  OK(plumb_mesh_write(mesh, "ply", &bytes, &error));
  OK(plumb_mesh_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), NULL, &again, NULL, NULL,
                     &error));
  CHECK(plumb_mesh_face_values(again, PLUMB_FACE_ID) == NULL);
  plumb_mesh_free(again);
  reading.attributes = 1;
  OK(plumb_mesh_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), &reading, &again, NULL, NULL,
                     &error));
  for (i = 0; i < 6; ++i) CHECK(plumb_mesh_face_values(again, PLUMB_FACE_ID)[i] == 10 + i);
  CHECK(memcmp(channel_called(again, "texcoord_0", 2), channel_called(mesh, "texcoord_0", 2),
               48 * sizeof(double)) == 0);
  plumb_mesh_free(again);
  /* Solids of files keep attributes if they are asked to. */
  for (options.keep = PLUMB_KEEP_DEFAULT; options.keep <= PLUMB_KEEP_ALL; ++options.keep) {
    const bool keeps = options.keep == PLUMB_KEEP_IDS || options.keep == PLUMB_KEEP_ALL;
    reading.name = "cube.ply";
    OK(plumb_solid_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), &reading, &options,
                        &solid, NULL, NULL, &error));
    OK(plumb_solid_to_mesh_with_attributes(solid, NULL, &again, NULL, NULL, &error));
    CHECK((plumb_mesh_face_values(again, PLUMB_FACE_ID) != NULL) == keeps);
    CHECK((channel_called(again, "texcoord_0", 2) != NULL) == (options.keep == PLUMB_KEEP_ALL));
    CHECK(!keeps || !strcmp(plumb_solid_source_name(solid, 0), "cube.ply"));
    plumb_mesh_free(again);
    plumb_solid_free(solid);
  }
  plumb_bytes_free(bytes);
  options.keep = PLUMB_KEEP_ALL;

  /* OBJ has its materials in a library beside it, of meshes and of solids. */
  for (i = 0; i < 2; ++i) {
    if (i == 0) {
      OK(plumb_mesh_write_file(mesh, path_of("painted.obj"), NULL, &error));
    } else {
      remove(path_of("painted.mtl"));
      OK(plumb_solid_write_file(both, path_of("painted.obj"), NULL, NULL, &notes, NULL, &error));
      CHECK(has_note(notes, "ids of faces")); /* They are no part of OBJ. */
      plumb_notes_free(notes);
    }
    OK(plumb_mesh_read_file(path_of("painted.obj"), &reading, &again, NULL, NULL, &error));
    CHECK(plumb_mesh_material_count(again) == 1 + i);
    OK(plumb_mesh_material(again, 0, &material, &error));
    CHECK(!strcmp(material.name, "red") && material.has_color && material.color[0] == 1);
    plumb_mesh_free(again);
  }
  OK(plumb_solid_read_file(path_of("painted.obj"), NULL, &options, &solid, NULL, NULL, &error));
  CHECK(plumb_solid_source_count(solid) == 1 && has_volume(solid, "7/8"));
  plumb_solid_free(solid);
  /* What .nef loses is told. */
  OK(plumb_solid_write(both, "nef", NULL, &bytes, &notes, NULL, &error));
  CHECK(plumb_notes_count(notes) == 1 && has_note(notes, "colours"));
  plumb_notes_free(notes);
  plumb_bytes_free(bytes);
  plumb_mesh_free(mesh);
  plumb_solid_free(both);
}

static void test_solid_pictures(void) {
  static const char* const formats[4] = {"html", "svg", "glb", "png"};
  static const char* const starts[4] = {"<!DOCTYPE html>", "<?xml", "glTF", "\x89PNG"};
  plumb_solid *a = cube_at(0, 0, 0), *b = cube_at(2, 0, 0);
  const plumb_solid* both[2];
  plumb_bytes* bytes = NULL;
  size_t i;
  both[0] = a;
  both[1] = b;
  for (i = 0; i < 4; ++i) {
    OK(plumb_solid_draw(a, formats[i], "A cube", &bytes, NULL, &error));
    CHECK(begins(bytes, starts[i]) || begins(bytes, "<!doctype html>") || begins(bytes, "<svg"));
    plumb_bytes_free(bytes);
    OK(plumb_solid_draw_many(both, 2, 0.5, formats[i], NULL, &bytes, NULL, &error));
    CHECK(plumb_bytes_size(bytes) > 100);
    plumb_bytes_free(bytes);
  }
  FAILS(plumb_solid_draw(a, "gif", NULL, &bytes, NULL, &error), PLUMB_UNKNOWN_FORMAT);
  FAILS(plumb_solid_draw_many(both, 2, -1, "html", NULL, &bytes, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_solid_free(a);
  plumb_solid_free(b);
}

/* ---- sets of the plane ---------------------------------------------------------------------- */

static bool same_plane(const plumb_plane_set* a, const plumb_plane_set* b) {
  bool is_equal = false;
  OK(plumb_plane_set_equals(a, b, &is_equal, &error));
  return is_equal;
}

static void test_plane_algebra(void) {
  plumb_plane_set *a = square_at("0 0 1 0 1 1 0 1"), *b = square_at("1/3 0 4/3 0 4/3 1 1/3 1");
  plumb_plane_set *x = NULL, *y = NULL, *z = NULL;
  const plumb_plane_set* two[2];
  plumb_plane_set_info info = PLUMB_PLANE_SET_INFO_INIT;
  bool answer = false;
  plumb_bytes* flaw = NULL;
  two[0] = a;
  two[1] = b;
  OK(plumb_plane_set_union(a, b, &x, NULL, &error));
  CHECK(has_area(x, "4/3"));
  OK(plumb_plane_set_union_of(two, 2, &y, NULL, &error));
  CHECK(same_plane(x, y));
  plumb_plane_set_free(y);
  OK(plumb_plane_set_intersection(a, b, &y, NULL, &error));
  CHECK(has_area(y, "2/3"));
  OK(plumb_plane_set_difference(x, y, &z, NULL, &error));
  plumb_plane_set_free(x);
  OK(plumb_plane_set_symmetric_difference(a, b, &x, NULL, &error));
  CHECK(same_plane(x, z) && has_area(x, "2/3"));
  plumb_plane_set_free(z);
  OK(plumb_plane_set_intersection_of(two, 2, &z, NULL, &error));
  CHECK(same_plane(y, z));
  OK(plumb_plane_set_is_subset(z, a, &answer, NULL, &error));
  CHECK(answer);
  plumb_plane_set_free(x);
  plumb_plane_set_free(y);
  plumb_plane_set_free(z);
  OK(plumb_plane_set_combine(a, b, PLUMB_DIFFERENCE | PLUMB_REGULARIZED, &x, NULL, &error));
  OK(plumb_plane_set_describe(x, &info, &error));
  CHECK(info.is_closed && info.is_bounded && !info.is_open && info.vertices == 4 &&
        info.edges == 4 && info.faces == 2 && info.marked_faces == 1 && info.bytes > 0);
  plumb_plane_set_free(x);
  OK(plumb_plane_set_interior(a, &x, NULL, &error));
  OK(plumb_plane_set_boundary(a, &y, NULL, &error));
  OK(plumb_plane_set_union(x, y, &z, NULL, &error));
  CHECK(same_plane(z, a) && !same_plane(x, a));
  plumb_plane_set_free(z);
  OK(plumb_plane_set_closure(x, &z, NULL, &error));
  CHECK(same_plane(z, a));
  plumb_plane_set_free(z);
  OK(plumb_plane_set_regularization(y, &z, NULL, &error));
  CHECK(plumb_plane_set_is_empty(z));
  plumb_plane_set_free(z);
  OK(plumb_plane_set_exterior(a, &z, NULL, &error));
  plumb_plane_set_free(x);
  OK(plumb_plane_set_complement(a, &x, NULL, &error));
  CHECK(same_plane(x, z));
  OK(plumb_plane_set_audit(x, &flaw, NULL, &error));
  CHECK(flaw == NULL);
  plumb_plane_set_free(x);
  plumb_plane_set_free(y);
  plumb_plane_set_free(z);
  OK(plumb_plane_set_copy(a, &x, &error));
  CHECK(same_plane(x, a));
  plumb_plane_set_free(x);
  OK(plumb_plane_set_empty(&x, &error));
  OK(plumb_plane_set_whole(&y, &error));
  OK(plumb_plane_set_complement(x, &z, NULL, &error));
  CHECK(same_plane(y, z) && plumb_plane_set_is_whole(z));
  plumb_plane_set_free(x);
  plumb_plane_set_free(y);
  plumb_plane_set_free(z);
  plumb_plane_set_free(a);
  plumb_plane_set_free(b);
}

static void test_plane_makers(void) {
  /* A square with a square hole, as two chains. */
  const double xy[16] = {0, 0, 4, 0, 4, 4, 0, 4, 1, 1, 3, 1, 3, 3, 1, 3};
  const uint32_t corners[8] = {0, 1, 2, 3, 4, 5, 6, 7}, begin[3] = {0, 4, 8};
  const uint32_t bad_corners[4] = {0, 1, 8, 2}, bad_begin[3] = {0, 5, 4};
  plumb_plane_set *x = NULL, *y = NULL, *z = NULL;
  plumb_numbers* n = NULL;
  plumb_plane_set_info info = PLUMB_PLANE_SET_INFO_INIT;
  OK(plumb_plane_set_polygons(xy, 8, begin, 2, corners, 8, PLUMB_RULE_DEFAULT, true, &x, NULL,
                              &error));
  CHECK(has_area(x, "12"));
  plumb_plane_set_free(x);
  OK(plumb_plane_set_polygons(xy, 8, begin, 2, corners, 8, PLUMB_RULE_NONZERO, false, &x, NULL,
                              &error));
  CHECK(has_area(x, "16"));
  plumb_plane_set_free(x);
  OK(plumb_plane_set_polylines(xy, 8, begin, 2, corners, 8, &x, NULL, &error));
  OK(plumb_plane_set_describe(x, &info, &error));
  CHECK(info.edges == 6 && info.vertices == 8 && info.marked_faces == 0);
  plumb_plane_set_free(x);
  FAILS(plumb_plane_set_polygons(xy, 8, begin, 1, bad_corners, 4, 0, true, &x, NULL, &error),
        PLUMB_BAD_INDEX);
  FAILS(plumb_plane_set_polylines(xy, 8, bad_begin, 2, corners, 4, &x, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_plane_set_polygons(xy, 8, begin, 2, corners, 8, 7, true, &x, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  n = numbers("1 1 -1/2");
  OK(plumb_plane_set_half_plane(n, true, &x, &error));
  OK(plumb_plane_set_line(n, &y, &error));
  plumb_numbers_free(n);
  n = numbers("-2 -2 1");
  OK(plumb_plane_set_half_plane(n, true, &z, &error));
  plumb_numbers_free(n);
  {
    plumb_plane_set* meet = NULL;
    OK(plumb_plane_set_intersection(x, z, &meet, NULL, &error));
    CHECK(same_plane(meet, y));
    plumb_plane_set_free(meet);
  }
  OK(plumb_plane_set_area(x, &n, NULL, &error));
  CHECK(plumb_numbers_count(n) == 0);
  plumb_numbers_free(n);
  plumb_plane_set_free(x);
  plumb_plane_set_free(y);
  plumb_plane_set_free(z);
  n = numbers("0 0 1");
  FAILS(plumb_plane_set_line(n, &x, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_plane_set_points(n, &x, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_numbers_free(n);
  n = numbers("0 0 1/7 0 0 0");
  OK(plumb_plane_set_points(n, &x, NULL, &error));
  OK(plumb_plane_set_describe(x, &info, &error));
  CHECK(info.vertices == 2 && info.is_closed);
  plumb_plane_set_free(x);
  plumb_numbers_free(n);
}

static void test_plane_questions(void) {
  const double points[4] = {0.5, 0.5, 2, 2};
  bool inside[2] = {false, true}, is_hit = false, is_convex = true;
  uint64_t reflex = 0, parts = 0;
  plumb_location at[3];
  plumb_plane_set *a = square_at("0 0 2 0 2 1 1 1 1 2 0 2"), *x = NULL, *y = NULL;
  plumb_numbers *n = numbers("0 0 1/3 0 1/3 1/3"), *point = NULL;
  plumb_plane_set_list* list = NULL;
  size_t i, count;
  int method;
  OK(plumb_plane_set_contains(a, points, 2, inside, NULL, &error));
  CHECK(inside[0] && !inside[1]);
  OK(plumb_plane_set_locate(a, n, at, 3, NULL, &error));
  CHECK(at[0].dimension == 0 && at[1].dimension == 1 && at[2].dimension == 2 && at[2].is_inside);
  plumb_numbers_free(n);
  n = numbers("-1 1/3 1 0");
  OK(plumb_plane_set_shoot(a, n, true, &is_hit, at, &point, NULL, &error));
  CHECK(is_hit && at[0].dimension == 1 && !strcmp(plumb_numbers_exact(point, 1), "1/3"));
  plumb_numbers_free(point);
  plumb_numbers_free(n);
  OK(plumb_plane_set_convexity(a, &is_convex, &reflex, &parts, NULL, &error));
  CHECK(!is_convex && reflex == 1 && parts == 1);
  for (method = PLUMB_PARTITION_BEST; method <= PLUMB_PARTITION_OPTIMAL; ++method) {
    OK(plumb_plane_set_decompose(a, method, false, &list, NULL, &error));
    count = plumb_plane_set_list_count(list);
    CHECK(count == 2 || (method == PLUMB_PARTITION_DIAGONALS && count == 3));
    OK(plumb_plane_set_empty(&x, &error));
    for (i = 0; i < plumb_plane_set_list_count(list); ++i) {
      OK(plumb_plane_set_union(x, plumb_plane_set_list_at(list, i), &y, NULL, &error));
      plumb_plane_set_free(x);
      x = y;
    }
    CHECK(same_plane(x, a));
    plumb_plane_set_free(x);
    plumb_plane_set_list_free(list);
  }
  FAILS(plumb_plane_set_decompose(a, 4, false, &list, NULL, &error), PLUMB_BAD_ARGUMENT);
  n = numbers("0 -1 0 1 0 0");
  OK(plumb_plane_set_transform(a, n, &x, NULL, &error));
  CHECK(has_area(x, "3") && !same_plane(x, a));
  plumb_numbers_free(n);
  n = numbers("0 1 0 -1 0 0");
  OK(plumb_plane_set_transform(x, n, &y, NULL, &error));
  CHECK(same_plane(y, a));
  plumb_numbers_free(n);
  plumb_plane_set_free(x);
  plumb_plane_set_free(y);
  plumb_plane_set_free(a);
}

static void test_plane_files(void) {
  static const char* const formats[3] = {"wkt", "geojson", "nef2"};
  static const char* const pictures[4] = {"svg", "html", "glb", "png"};
  plumb_read_options reading = PLUMB_READ_OPTIONS_INIT;
  plumb_write_options writing = PLUMB_WRITE_OPTIONS_INIT;
  plumb_rounding_report report = PLUMB_ROUNDING_REPORT_INIT;
  plumb_plane_set *a = square_at("0 0 1/3 0 1/3 1 0 1"), *x = NULL;
  plumb_shapes* shapes = NULL;
  plumb_bytes* bytes = NULL;
  plumb_notes* notes = NULL;
  plumb_numbers *n = numbers("1/4"), *point = NULL;
  size_t i;
  for (i = 0; i < 3; ++i) {
    OK(plumb_plane_set_write(a, formats[i], NULL, &bytes, &notes, NULL, &error));
    OK(plumb_plane_set_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), NULL, &x, NULL, NULL,
                            &error));
    CHECK(same_plane(x, a) == (i == 2));
    plumb_plane_set_free(x);
    plumb_bytes_free(bytes);
    plumb_notes_free(notes);
  }
  for (i = 0; i < 4; ++i) {
    OK(plumb_plane_set_draw(a, pictures[i], "A rectangle", &bytes, NULL, &error));
    CHECK(plumb_bytes_size(bytes) > 100);
    plumb_bytes_free(bytes);
  }
  OK(plumb_plane_set_round(a, n, &x, &report, NULL, &error));
  CHECK(has_area(x, "1/4") && report.largest_move >= 1. / 12 && report.largest_move < 0.13);
  plumb_plane_set_free(x);
  writing.grid = n;
  OK(plumb_plane_set_write(a, "wkt", &writing, &bytes, NULL, NULL, &error));
  CHECK(strstr(plumb_bytes_data(bytes), "0.25") != NULL);
  plumb_bytes_free(bytes);
  writing.raw = true;
  FAILS(plumb_plane_set_write(a, "wkt", &writing, &bytes, NULL, NULL, &error), PLUMB_USAGE);
  FAILS(plumb_plane_set_write(a, "svg", NULL, &bytes, NULL, NULL, &error), PLUMB_UNKNOWN_FORMAT);
  OK(plumb_plane_set_write_file(a, path_of("set.nef2"), NULL, NULL, NULL, NULL, &error));
  OK(plumb_plane_set_read_file(path_of("set.nef2"), NULL, &x, &notes, NULL, &error));
  CHECK(same_plane(x, a));
  plumb_plane_set_free(x);
  plumb_notes_free(notes);
  FAILS(plumb_plane_set_write_file(a, path_of("set.png"), NULL, NULL, NULL, NULL, &error),
        PLUMB_UNKNOWN_FORMAT);
  reading.name = "bad.wkt";
  FAILS_WITH(plumb_plane_set_read("POLYGON((0 0, 1 x))", 19, &reading, &x, NULL, NULL, &error),
             PLUMB_SYNTAX, "bad.wkt:1:");
  reading.exact_decimals = true;
  OK(plumb_plane_set_read("POLYGON((0 0,0.1 0,0.1 1,0 1,0 0))", 34, &reading, &x, NULL, NULL,
                          &error));
  CHECK(has_area(x, "1/10"));
  plumb_plane_set_free(x);

  OK(plumb_plane_set_read_file("corpus/plane/frame.geojson", NULL, &x, NULL, NULL, &error));
  plumb_plane_set_free(x);
  OK(plumb_plane_set_shapes(a, &shapes, NULL, &error));
  CHECK(plumb_shapes_point_count(shapes) == 4 && plumb_shapes_polygon_count(shapes) == 1);
  CHECK(plumb_shapes_ring_count(shapes) == 1 && plumb_shapes_line_count(shapes) == 0);
  CHECK(plumb_shapes_single_count(shapes) == 0 && plumb_shapes_points(shapes) != NULL);
  CHECK(plumb_shapes_polygon_begin(shapes)[1] == 1 && plumb_shapes_ring_begin(shapes)[1] == 4);
  CHECK(plumb_shapes_line_begin(shapes)[0] == 0);
  {
    size_t thirds = 0;
    for (i = 0; i < 4; ++i) {
      CHECK(plumb_shapes_ring_corners(shapes)[i] < 4);
      OK(plumb_shapes_exact_point(shapes, i, &point, &error));
      if (!strcmp(plumb_numbers_exact(point, 0), "1/3")) ++thirds;
      plumb_numbers_free(point);
    }
    CHECK(thirds == 2);
  }
  FAILS(plumb_shapes_exact_point(shapes, 4, &point, &error), PLUMB_BAD_INDEX);
  plumb_shapes_free(shapes);
  {
    const double xy[6] = {0, 0, 1, 0, 5, 5};
    const uint32_t corners[3] = {0, 1, 2}, begin[3] = {0, 2, 3};
    OK(plumb_plane_set_polylines(xy, 3, begin, 2, corners, 3, &x, NULL, &error));
    OK(plumb_plane_set_shapes(x, &shapes, NULL, &error));
    CHECK(plumb_shapes_line_count(shapes) == 1 && plumb_shapes_single_count(shapes) == 1);
    CHECK(plumb_shapes_points(shapes)[2 * plumb_shapes_singles(shapes)[0]] == 5);
    CHECK(plumb_shapes_line_corners(shapes)[0] != plumb_shapes_line_corners(shapes)[1]);
    plumb_shapes_free(shapes);
    plumb_plane_set_free(x);
  }
  plumb_numbers_free(n);
  plumb_plane_set_free(a);
}

/* ---- sets of the sphere --------------------------------------------------------------------- */

static bool same_sphere(const plumb_sphere_set* a, const plumb_sphere_set* b) {
  bool is_equal = false;
  OK(plumb_sphere_set_equals(a, b, &is_equal, &error));
  return is_equal;
}

static void test_sphere(void) {
  plumb_numbers *axes = numbers("1 0 0 0 1 0 0 0 1"), *n = NULL, *point = NULL;
  plumb_sphere_set *octant = NULL, *x = NULL, *y = NULL, *z = NULL;
  const plumb_sphere_set* two[2];
  plumb_sphere_set_info info = PLUMB_SPHERE_SET_INFO_INIT;
  plumb_location at[2];
  plumb_bytes* flaw = NULL;
  bool answer = false;
  OK(plumb_sphere_set_half_spheres(axes, true, &octant, NULL, &error));
  OK(plumb_sphere_set_polygon(axes, true, &x, &error));
  CHECK(same_sphere(octant, x));
  plumb_sphere_set_free(x);
  OK(plumb_sphere_set_describe(octant, &info, &error));
  CHECK(info.points == 3 && info.arcs == 3 && info.faces == 2 && info.marked_faces == 1);
  CHECK(info.is_closed && !info.is_open && !info.is_empty && !info.is_whole && info.bytes > 0);
  OK(plumb_sphere_set_interior(octant, &x, NULL, &error));
  OK(plumb_sphere_set_boundary(octant, &y, NULL, &error));
  OK(plumb_sphere_set_union(x, y, &z, NULL, &error));
  CHECK(same_sphere(z, octant));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_difference(octant, y, &z, NULL, &error));
  CHECK(same_sphere(z, x));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_closure(x, &z, NULL, &error));
  CHECK(same_sphere(z, octant));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_regularization(y, &z, NULL, &error));
  CHECK(plumb_sphere_set_is_empty(z));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_intersection(octant, x, &z, NULL, &error));
  CHECK(same_sphere(z, x));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_symmetric_difference(octant, x, &z, NULL, &error));
  CHECK(same_sphere(z, y));
  plumb_sphere_set_free(z);
  two[0] = x;
  two[1] = y;
  OK(plumb_sphere_set_union_of(two, 2, &z, NULL, &error));
  CHECK(same_sphere(z, octant));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_intersection_of(two, 2, &z, NULL, &error));
  CHECK(plumb_sphere_set_is_empty(z));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_combine(x, y, PLUMB_UNION | PLUMB_REGULARIZED, &z, NULL, &error));
  CHECK(same_sphere(z, octant));
  plumb_sphere_set_free(z);
  OK(plumb_sphere_set_is_subset(x, octant, &answer, NULL, &error));
  CHECK(answer);
  plumb_sphere_set_free(x);
  plumb_sphere_set_free(y);
  OK(plumb_sphere_set_exterior(octant, &x, NULL, &error));
  OK(plumb_sphere_set_complement(octant, &y, NULL, &error));
  CHECK(same_sphere(x, y));
  OK(plumb_sphere_set_audit(x, &flaw, NULL, &error));
  CHECK(flaw == NULL);
  plumb_sphere_set_free(x);
  plumb_sphere_set_free(y);

  FAILS(plumb_sphere_set_locate(octant, axes, at, 2, NULL, &error), PLUMB_BAD_ARGUMENT);
  n = numbers("1 1 1 -1 0 0");
  OK(plumb_sphere_set_locate(octant, n, at, 2, NULL, &error));
  CHECK(at[0].dimension == 2 && at[0].is_inside && !at[1].is_inside);
  plumb_numbers_free(n);
  n = numbers("-1 1/2 1/2 0 1 1");
  OK(plumb_sphere_set_shoot(octant, n, false, &answer, at, &point, NULL, &error));
  CHECK(answer && at[0].dimension == 1 && plumb_numbers_count(point) == 3);
  CHECK(!strcmp(plumb_numbers_exact(point, 0), "0"));
  plumb_numbers_free(point);
  plumb_numbers_free(n);
  n = numbers("0 0 0");
  FAILS(plumb_sphere_set_circle(n, &x, &error), PLUMB_BAD_ARGUMENT);
  plumb_numbers_free(n);
  n = numbers("0 0 1");
  OK(plumb_sphere_set_circle(n, &x, &error));
  OK(plumb_sphere_set_describe(x, &info, &error));
  CHECK(info.arcs == 1 && info.faces == 2 && info.marked_faces == 0);
  plumb_numbers_free(n);
  n = numbers("1 0 0 0 1 0");
  OK(plumb_sphere_set_arc(n, true, &y, &error));
  OK(plumb_sphere_set_is_subset(y, x, &answer, NULL, &error));
  CHECK(answer);
  plumb_sphere_set_free(x);
  OK(plumb_sphere_set_points(n, &x, NULL, &error));
  OK(plumb_sphere_set_is_subset(x, y, &answer, NULL, &error));
  CHECK(answer);
  plumb_numbers_free(n);
  plumb_sphere_set_free(x);
  plumb_sphere_set_free(y);
  OK(plumb_sphere_set_empty(&x, &error));
  OK(plumb_sphere_set_whole(&y, &error));
  OK(plumb_sphere_set_copy(y, &z, &error));
  CHECK(plumb_sphere_set_is_whole(z) && !same_sphere(x, z));
  plumb_sphere_set_free(x);
  plumb_sphere_set_free(y);
  plumb_sphere_set_free(z);
  plumb_sphere_set_free(octant);
  plumb_numbers_free(axes);
}

/* ---- maps ----------------------------------------------------------------------------------- */

/* Two unit squares side by side, and the outer boundary. */
static const double kMapPoints[12] = {0, 0, 1, 0, 2, 0, 2, 1, 1, 1, 0, 1};
static const uint32_t kMapCorners[14] = {0, 1, 4, 5, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0};
static const uint32_t kMapBegin[4] = {0, 4, 8, 14};

static plumb_map_report* valid_report(void) {
  plumb_map* map = NULL;
  plumb_map_report* report = NULL;
  OK(plumb_map_from_cycles(kMapPoints, 6, kMapBegin, 3, kMapCorners, 14, &map, &error));
  OK(plumb_map_check(map, NULL, &report, NULL, &error));
  plumb_map_free(map);
  return report;
}

static void test_map(void) {
  static const char* const formats[7] = {"text", "json", "geojson", "svg", "html", "glb", "png"};
  plumb_read_options reading = PLUMB_READ_OPTIONS_INIT;
  plumb_map *map = NULL, *again = NULL;
  plumb_map_report* report = valid_report();
  plumb_map_counts counts = PLUMB_MAP_COUNTS_INIT;
  plumb_bytes* bytes = NULL;
  plumb_dcel* dcel = NULL;
  plumb_plane_set* set = NULL;
  plumb_notes* notes = NULL;
  const bool chosen[3] = {false, true, true};
  bool is_polygons = true;
  size_t i, count = 0;
  OK(plumb_map_report_count(report, &counts, &error));
  CHECK(counts.verdict == PLUMB_MAP_VALID && plumb_map_report_verdict(report) == PLUMB_MAP_VALID);
  CHECK(counts.vertices == 6 && counts.edges == 7 && counts.cycles == 3 && counts.components == 1 &&
        counts.regions == 3 && counts.open == 0);
  CHECK(plumb_map_report_region(report, 0, &count)[0] == 2 && count == 1);
  CHECK(plumb_map_report_region(report, 2, &count)[0] == 1 && count == 1);
  CHECK(plumb_map_report_region(report, 3, &count) == NULL && count == 0);
  CHECK(plumb_notes_count(plumb_map_report_warnings(report)) == 0);
  for (i = 0; i < 7; ++i) {
    OK(plumb_map_report_write(report, formats[i], "Two squares", &bytes, &error));
    CHECK(plumb_bytes_size(bytes) > 30);
    plumb_bytes_free(bytes);
  }
  FAILS(plumb_map_report_write(report, "gif", NULL, &bytes, &error), PLUMB_UNKNOWN_FORMAT);
  OK(plumb_map_report_to_set(report, chosen, 3, true, &set, NULL, &error));
  CHECK(has_area(set, "2"));
  plumb_plane_set_free(set);
  FAILS(plumb_map_report_to_set(report, chosen, 2, true, &set, NULL, &error), PLUMB_BAD_ARGUMENT);

  OK(plumb_map_report_dcel(report, &dcel, &error));
  CHECK(plumb_dcel_vertex_count(dcel) == 6 && plumb_dcel_halfedge_count(dcel) == 14 &&
        plumb_dcel_face_count(dcel) == 3);
  for (i = 0; i < 14; ++i) {
    const uint32_t *next = plumb_dcel_next(dcel), *origin = plumb_dcel_origin(dcel);
    CHECK(plumb_dcel_prev(dcel)[next[i]] == i);
    CHECK(origin[next[i]] == origin[i ^ 1]); /* The next half-edge begins where this one ends. */
    CHECK(plumb_dcel_face(dcel)[next[i]] == plumb_dcel_face(dcel)[i]);
  }
  for (i = 0; i < 6; ++i) {
    CHECK(plumb_dcel_origin(dcel)[plumb_dcel_leaving(dcel)[i]] == i);
    CHECK(plumb_dcel_points(dcel)[2 * i] == kMapPoints[2 * i]);
  }
  plumb_dcel_free(dcel);

  OK(plumb_map_report_map(report, &map, &error));
  CHECK(plumb_map_point_count(map) == 6 && plumb_map_cycle_count(map) == 3);
  CHECK(memcmp(plumb_map_points(map), kMapPoints, sizeof kMapPoints) == 0);
  CHECK(memcmp(plumb_map_corners(map), kMapCorners, sizeof kMapCorners) == 0);
  CHECK(memcmp(plumb_map_cycle_begin(map), kMapBegin, sizeof kMapBegin) == 0);
  OK(plumb_map_write(map, &bytes, &error));
  OK(plumb_map_read(plumb_bytes_data(bytes), plumb_bytes_size(bytes), NULL, &again, NULL, &error));
  CHECK(memcmp(plumb_map_corners(again), kMapCorners, sizeof kMapCorners) == 0);
  plumb_map_free(again);
  plumb_bytes_free(bytes);
  plumb_map_free(map);
  reading.name = "bad.map";
  FAILS_WITH(plumb_map_read("1 0\n0 zero\n", 11, &reading, &map, NULL, &error), PLUMB_SYNTAX,
             "bad.map:2:3");
  OK(plumb_map_read_file("corpus/maps/us-states.clean.map", NULL, &map, &is_polygons, &notes, NULL,
                         &error));
  CHECK(!is_polygons && plumb_map_cycle_count(map) > 40);
  plumb_notes_free(notes);
  plumb_map_free(map);
  FAILS(plumb_map_from_cycles(kMapPoints, 5, kMapBegin, 3, kMapCorners, 14, &map, &error),
        PLUMB_BAD_INDEX);
  FAILS(plumb_map_from_cycles(kMapPoints, 6, kMapBegin, 2, kMapCorners, 14, &map, &error),
        PLUMB_BAD_ARGUMENT);
  plumb_map_report_free(report);
}

static void test_map_defects(void) {
  plumb_numbers* points = numbers("0 0 1 0 1 1 0 1");
  const uint32_t bow_tie[8] = {0, 2, 1, 3, 3, 1, 2, 0}, begin[3] = {0, 4, 8};
  plumb_map* map = NULL;
  plumb_map_report* report = NULL;
  plumb_map_options options = PLUMB_MAP_OPTIONS_INIT;
  plumb_map_defect defect = PLUMB_MAP_DEFECT_INIT;
  plumb_map_counts counts = PLUMB_MAP_COUNTS_INIT;
  plumb_dcel* dcel = NULL;
  size_t i;
  bool crosses = false;
  OK(plumb_map_from_exact_cycles(points, begin, 2, bow_tie, 8, &map, &error));
  OK(plumb_map_check(map, NULL, &report, NULL, &error));
  OK(plumb_map_report_count(report, &counts, &error));
  CHECK(counts.verdict == PLUMB_MAP_SUPERPOSED && counts.crossing == 1 && counts.regions == 0);
  for (i = 0; i < plumb_map_report_defect_count(report); ++i) {
    OK(plumb_map_report_defect(report, i, &defect, &error));
    if (defect.kind != PLUMB_DEFECT_CROSSING) continue;
    crosses = true;
    CHECK(!strcmp(defect.x, "1/2") && !strcmp(defect.y, "1/2") && defect.near_x == 0.5 &&
          defect.near_y == 0.5);
    CHECK(defect.edge_count == 2 && defect.edges[0] < 4 && defect.cycle_count >= 1 &&
          defect.cycles[0] < 2 && strlen(defect.hint) > 0);
  }
  CHECK(crosses);
  FAILS(plumb_map_report_defect(report, 99, &defect, &error), PLUMB_BAD_INDEX);
  FAILS(plumb_map_report_dcel(report, &dcel, &error), PLUMB_BAD_ARGUMENT);
  plumb_map_report_free(report);
  options.outer = 5;
  FAILS(plumb_map_check(map, &options, &report, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_map_free(map);
  /* Without its outer boundary a map is open, unless that is inferred. */
  OK(plumb_map_from_cycles(kMapPoints, 6, kMapBegin, 2, kMapCorners, 8, &map, &error));
  OK(plumb_map_check(map, NULL, &report, NULL, &error));
  CHECK(plumb_map_report_verdict(report) == PLUMB_MAP_OPEN);
  plumb_map_report_free(report);
  options.outer = PLUMB_OUTER_INFER;
  OK(plumb_map_check(map, &options, &report, NULL, &error));
  CHECK(plumb_map_report_verdict(report) == PLUMB_MAP_VALID);
  CHECK(plumb_notes_count(plumb_map_report_warnings(report)) == 1);
  plumb_map_report_free(report);
  plumb_map_free(map);
  plumb_numbers_free(points);
}

static void test_overlay(void) {
  static const char* const formats[5] = {"text", "json", "geojson", "svg", "html"};
  double shifted[12];
  plumb_map* map = NULL;
  plumb_map_report *first = valid_report(), *second = NULL;
  plumb_overlay* overlay = NULL;
  plumb_numbers* areas = NULL;
  plumb_dcel* dcel = NULL;
  plumb_bytes* bytes = NULL;
  size_t i, faces;
  double common = 0;
  for (i = 0; i < 12; ++i) shifted[i] = kMapPoints[i] + (i % 2 == 0 ? 0.5 : 0);
  OK(plumb_map_from_cycles(shifted, 6, kMapBegin, 3, kMapCorners, 14, &map, &error));
  OK(plumb_map_check(map, NULL, &second, NULL, &error));
  plumb_map_free(map);
  OK(plumb_overlay_new(first, second, &overlay, NULL, &error));
  plumb_map_report_free(first);
  plumb_map_report_free(second);
  faces = plumb_overlay_face_count(overlay);
  CHECK(faces == 6); /* Five strips and the outside. */
  OK(plumb_overlay_areas(overlay, &areas, &error));
  CHECK(plumb_numbers_count(areas) == faces);
  for (i = 0; i < faces; ++i) {
    const uint32_t* regions = plumb_overlay_regions(overlay) + 2 * i;
    if (regions[0] != 0 && regions[1] != 0) common += plumb_numbers_nearest(areas, i);
  }
  CHECK(common == 1.5);
  plumb_numbers_free(areas);
  OK(plumb_overlay_dcel(overlay, &dcel, &error));
  CHECK(plumb_dcel_face_count(dcel) == faces);
  /* Euler: the overlay is connected. */
  CHECK(plumb_dcel_vertex_count(dcel) + faces == plumb_dcel_halfedge_count(dcel) / 2 + 2);
  plumb_dcel_free(dcel);
  for (i = 0; i < 5; ++i) {
    OK(plumb_overlay_write(overlay, formats[i], NULL, "A over B", &bytes, NULL, &error));
    CHECK(plumb_bytes_size(bytes) > 30);
    plumb_bytes_free(bytes);
  }
  FAILS(plumb_overlay_write(overlay, "wkt", NULL, NULL, &bytes, NULL, &error),
        PLUMB_UNKNOWN_FORMAT);
  plumb_overlay_free(overlay);
}

/* ---- surfaces ------------------------------------------------------------------------------- */

static uint32_t add_point(plumb_scene* scene, uint32_t face, const char* weights) {
  plumb_numbers* n = numbers(weights);
  uint32_t index = 0;
  OK(plumb_scene_add_point(scene, face, n, &index, &error));
  plumb_numbers_free(n);
  return index;
}

/* Two triangles on the top of the cube: 9/128 each, and 1/128 in common. */
static plumb_scene* two_triangles(void) {
  plumb_scene* scene = NULL;
  uint32_t points[3], index = 9;
  OK(plumb_scene_new(kCube, 8, kTriangles, 12, &scene, &error));
  points[0] = add_point(scene, 2, "1/8 1/8");
  points[1] = add_point(scene, 2, "1/2 1/8");
  points[2] = add_point(scene, 2, "1/8 1/2");
  OK(plumb_scene_add_polygon(scene, points, 3, &index, NULL, &error));
  CHECK(index == 0);
  points[0] = add_point(scene, 2, "1/4 1/4");
  points[1] = add_point(scene, 2, "5/8 1/4");
  points[2] = add_point(scene, 2, "1/4 5/8");
  OK(plumb_scene_add_polygon(scene, points, 3, &index, NULL, &error));
  CHECK(index == 1 && plumb_scene_polygon_count(scene) == 2);
  OK(plumb_scene_set_outside(scene, 0, &error));
  return scene;
}

static void test_surface(void) {
  static const char* const layers[5] = {"polygons", "slices", "cells", "labels", "result"};
  static const char* const files[4] = {"obj", "ply", "glb", "dot"};
  static const char* const pictures[4] = {"html", "svg", "glb", "png"};
  plumb_scene *scene = two_triangles(), *result = NULL;
  plumb_surface *surface = NULL, *again = NULL;
  plumb_region* region = NULL;
  plumb_surface_info info = PLUMB_SURFACE_INFO_INIT;
  plumb_mesh* mesh = NULL;
  plumb_indices* cells = NULL;
  plumb_bytes* bytes = NULL;
  bool over_integers = false, modulo_2 = false;
  size_t i, count = 0, doubly = 0, selected = 0;
  double total = 0;
  OK(plumb_surface_divide(scene, &surface, NULL, &error));
  OK(plumb_surface_describe(surface, &info, &error));
  CHECK(info.triangles == 12 && info.cells == 4 && info.crossings == 2 && info.shapes == 2);
  for (i = 0; i < info.cells; ++i) {
    const plumb_label* labels = plumb_surface_labels(surface, i, &count);
    total += plumb_surface_area(surface, i);
    if (count != 2) continue;
    ++doubly;
    CHECK(labels[0].shape == 0 && labels[0].value == 1 && labels[1].shape == 1);
    CHECK(plumb_surface_area(surface, i) == 1. / 128);
  }
  CHECK(doubly == 1 && fabs(total - 6) < 1e-12);
  CHECK(plumb_surface_labels(surface, 4, &count) == NULL && count == 0);
  CHECK(plumb_surface_neighbours(surface, &count) != NULL && count == info.cell_edges);
  OK(plumb_surface_separates(surface, 1, &over_integers, &modulo_2, &error));
  CHECK(over_integers && modulo_2);
  FAILS(plumb_surface_separates(surface, 2, NULL, NULL, &error), PLUMB_BAD_INDEX);
  OK(plumb_surface_audit(surface, &bytes, &error));
  CHECK(bytes == NULL);
  OK(plumb_surface_triangulate(surface, &mesh, &cells, NULL, &error));
  CHECK(plumb_mesh_face_count(mesh) == plumb_indices_count(cells));
  plumb_mesh_free(mesh);
  plumb_indices_free(cells);

  OK(plumb_surface_evaluate(surface, "A + B", PLUMB_RULE_DEFAULT, &region, NULL, &error));
  CHECK(plumb_region_cell_count(region) == 3 && plumb_region_loop_count(region) == 1);
  CHECK(fabs(plumb_region_area(region) - 17. / 128) < 1e-15);
  for (i = 0; i < 5; ++i) selected += plumb_region_has(region, i);
  CHECK(selected == 3);
  OK(plumb_region_to_scene(region, &result, &error));
  OK(plumb_surface_divide(result, &again, NULL, &error));
  OK(plumb_surface_describe(again, &info, &error));
  CHECK(info.cells == 2 && info.shapes == 1);
  FAILS(plumb_surface_write(again, region, "obj", &bytes, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_surface_free(again);
  for (i = 0; i < 4; ++i) {
    OK(plumb_surface_write(surface, i % 2 ? region : NULL, files[i], &bytes, NULL, &error));
    CHECK(plumb_bytes_size(bytes) > 30);
    plumb_bytes_free(bytes);
    OK(plumb_surface_draw(surface, region, layers[i + 1], pictures[i], "Triangles", &bytes, NULL,
                          &error));
    CHECK(plumb_bytes_size(bytes) > 100);
    plumb_bytes_free(bytes);
  }
  FAILS(plumb_surface_draw(surface, NULL, "result", "html", NULL, &bytes, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_surface_draw(surface, NULL, "colours", "html", NULL, &bytes, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_surface_write(surface, NULL, "stl", &bytes, NULL, &error), PLUMB_UNKNOWN_FORMAT);
  /* The region lives longer than its surface. */
  plumb_surface_free(surface);
  plumb_scene_free(result);
  OK(plumb_region_to_scene(region, &result, &error));
  CHECK(plumb_scene_polygon_count(result) == 1);
  OK(plumb_scene_write(result, "cube.off", &bytes, &error));
  CHECK(begins(bytes, "{"));
  plumb_bytes_free(bytes);
  /* JSON cannot name a file whose path is not UTF-8. */
  FAILS_WITH(plumb_scene_write(result, "\xff.off", &bytes, &error), PLUMB_BAD_ARGUMENT, "UTF-8");
  plumb_scene_free(result);
  plumb_region_free(region);
  plumb_scene_free(scene);
}

static void test_scene(void) {
  const uint32_t one[1] = {0}, bad[1] = {7};
  plumb_scene* scene = two_triangles();
  plumb_surface* surface = NULL;
  plumb_region* region = NULL;
  plumb_notes* notes = NULL;
  plumb_numbers* n = numbers("2 0");
  plumb_path* path = NULL;
  uint32_t index = 0, top, bottom;
  size_t added = 9;
  FAILS(plumb_scene_add_point(scene, 12, n, &index, &error), PLUMB_BAD_INDEX);
  FAILS(plumb_scene_add_point(scene, 0, n, &index, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_scene_add_polygon(scene, bad, 1, &index, NULL, &error), PLUMB_BAD_INDEX);
  FAILS(plumb_scene_add_polygon(scene, NULL, 0, &index, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_scene_add_shape(scene, bad, 1, &index, &error), PLUMB_BAD_INDEX);
  FAILS(plumb_scene_set_outside(scene, 12, &error), PLUMB_BAD_INDEX);
  plumb_numbers_free(n);
  /* From the middle of the top to the middle of the bottom: over one side, 1/2 + 1 + 1/2. */
  top = add_point(scene, 2, "0 1/2");
  bottom = add_point(scene, 0, "0 1/2");
  OK(plumb_scene_trace(scene, top, bottom, PLUMB_PATH_LOCAL, &path, NULL, &error));
  {
    const double* p = plumb_path_points(path);
    double length = 0;
    size_t i, points = plumb_path_count(path);
    CHECK(points >= 4 && plumb_path_faces(path) != NULL);
    for (i = 0; i + 1 < points; ++i) {
      length += sqrt(pow(p[3 * i + 3] - p[3 * i], 2) + pow(p[3 * i + 4] - p[3 * i + 1], 2) +
                     pow(p[3 * i + 5] - p[3 * i + 2], 2));
      CHECK(plumb_path_faces(path)[i] < 12);
    }
    CHECK(fabs(length - 2) < 1e-12);
    CHECK(fabs(plumb_path_length(path) - length) < 1e-12);
  }
  plumb_path_free(path);
  OK(plumb_scene_trace(scene, top, bottom, PLUMB_PATH_SHORTEST, &path, NULL, &error));
  CHECK(fabs(plumb_path_length(path) - 2) < 1e-12);
  plumb_path_free(path);
  FAILS(plumb_scene_trace(scene, top, 99, PLUMB_PATH_LOCAL, &path, NULL, &error), PLUMB_BAD_INDEX);
  OK(plumb_scene_add_shape(scene, one, 1, &index, &error));
  CHECK(index == 0);
  OK(plumb_scene_separate(scene, &added, NULL, &error));
  CHECK(added == 0);
  OK(plumb_surface_divide(scene, &surface, NULL, &error));
  FAILS(plumb_surface_evaluate(surface, "B", PLUMB_RULE_DEFAULT, &region, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  plumb_surface_free(surface);
  plumb_scene_free(scene);

  /* A loop around a handle separates the torus only with another one. */
  OK(plumb_scene_read_file("corpus/scenes/torus-loops.json", NULL, &scene, &notes, NULL, &error));
  plumb_notes_free(notes);
  OK(plumb_scene_separate(scene, &added, NULL, &error));
  CHECK(added > 0);
  OK(plumb_surface_divide(scene, &surface, NULL, &error));
  {
    plumb_surface_info info = PLUMB_SURFACE_INFO_INIT;
    bool separates = false;
    size_t shape;
    OK(plumb_surface_describe(surface, &info, &error));
    for (shape = 0; shape < info.shapes; ++shape) {
      OK(plumb_surface_separates(surface, shape, &separates, NULL, &error));
      CHECK(separates);
    }
  }
  plumb_surface_free(surface);
  plumb_scene_free(scene);
  FAILS(plumb_scene_read_file(path_of("none.json"), NULL, &scene, NULL, NULL, &error),
        PLUMB_CANNOT_OPEN);
  FAILS(plumb_scene_new(kCube, 8, kTriangles, 12, NULL, &error), PLUMB_BAD_ARGUMENT);
}

/* ---- models --------------------------------------------------------------------------------- */

static plumb_solid* box_of(double x, double y, double z) {
  const double size[3] = {x, y, z};
  plumb_solid* box = NULL;
  OK(plumb_solid_box(size, false, &box, NULL, &error));
  return box;
}

static void test_primitives(void) {
  const double size[3] = {2, 2, 2}, flat[3] = {1, 0, 1}, nan_size[3] = {1, NAN, 1};
  plumb_solid *a = box_of(1, 2, 3), *solid = NULL;
  uint64_t handles = 7;
  bool is_surface = false;
  CHECK(has_volume(a, "6"));
  OK(plumb_solid_genus(a, &is_surface, &handles, &error));
  CHECK(is_surface && handles == 0);
  plumb_solid_free(a);
  OK(plumb_solid_box(size, true, &solid, NULL, &error));
  CHECK(has_volume(solid, "8"));
  plumb_solid_free(solid);
  FAILS(plumb_solid_box(flat, false, &solid, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_solid_box(nan_size, false, &solid, NULL, &error), PLUMB_NOT_FINITE);
  FAILS(plumb_solid_box(NULL, false, &solid, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_solid_cylinder(3, 2, 2, 4, true, &solid, NULL, &error)); /* Two triangles of area 4. */
  CHECK(has_volume(solid, "24"));
  plumb_solid_free(solid);
  OK(plumb_solid_cylinder(3, 2, 0, 4, false, &solid, NULL, &error));
  CHECK(has_volume(solid, "8"));
  plumb_solid_free(solid);
  OK(plumb_solid_sphere(1, 8, &solid, NULL, &error));
  {
    plumb_solid_info info = PLUMB_SOLID_INFO_INIT;
    OK(plumb_solid_describe(solid, &info, &error));
    CHECK(info.is_convex && info.vertices == 32);
  }
  plumb_solid_free(solid);
  FAILS(plumb_solid_sphere(-1, 8, &solid, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_solid_torus(3, 1, 4, 4, &solid, NULL, &error));
  OK(plumb_solid_genus(solid, &is_surface, &handles, &error));
  CHECK(is_surface && handles == 1);
  plumb_solid_free(solid);
  OK(plumb_solid_whole(&solid, &error));
  OK(plumb_solid_genus(solid, &is_surface, &handles, &error));
  CHECK(!is_surface && handles == 0);
  plumb_solid_free(solid);
}

static void test_hulls(void) {
  plumb_solid *cube = cube_at(0, 0, 0), *far = cube_at(4, 0, 0), *hull = NULL;
  const plumb_solid* both[2];
  plumb_plane_set *square = square_at("0 0 1 0 1 1 0 1"), *other = square_at("0 4 1 4 1 5 0 5");
  plumb_plane_set* flat = NULL;
  const plumb_plane_set* squares[2];
  plumb_numbers* n = numbers("0 0 0 1/3 0 0 0 1/3 0 0 0 1/3");
  const double xy[8] = {0, 0, 1, 0, 1, 1, 0, 1};
  both[0] = cube;
  both[1] = far;
  squares[0] = square;
  squares[1] = other;
  OK(plumb_solid_hull(kCube, 8, &hull, NULL, &error));
  CHECK(same(hull, cube));
  plumb_solid_free(hull);
  OK(plumb_solid_hull_exact(n, &hull, NULL, &error));
  CHECK(has_volume(hull, "1/162"));
  plumb_solid_free(hull);
  OK(plumb_solid_hull_of(both, 2, &hull, NULL, &error));
  CHECK(has_volume(hull, "5"));
  plumb_solid_free(hull);
  plumb_numbers_free(n);
  OK(plumb_plane_set_hull(xy, 4, &flat, NULL, &error));
  CHECK(has_area(flat, "1"));
  plumb_plane_set_free(flat);
  n = numbers("0 0 1/2 0 0 1/2");
  OK(plumb_plane_set_hull_exact(n, &flat, NULL, &error));
  CHECK(has_area(flat, "1/8"));
  plumb_plane_set_free(flat);
  plumb_numbers_free(n);
  OK(plumb_plane_set_hull_of(squares, 2, &flat, NULL, &error));
  CHECK(has_area(flat, "5"));
  plumb_plane_set_free(flat);
  plumb_plane_set_free(square);
  plumb_plane_set_free(other);
  plumb_solid_free(cube);
  plumb_solid_free(far);
}

static void test_extrusions(void) {
  plumb_plane_set *square = square_at("1 0 3 0 3 2 1 2"), *shadow = NULL, *disk = NULL;
  plumb_plane_set_list* slices = NULL;
  plumb_extrusion tall = PLUMB_EXTRUSION_INIT;
  plumb_solid* solid = NULL;
  plumb_numbers *heights = numbers("0 1/3 9"), *box = NULL;
  bool is_equal = false;
  tall.height = 5;
  OK(plumb_plane_set_extrude(square, &tall, &solid, NULL, &error));
  CHECK(has_volume(solid, "20"));
  OK(plumb_solid_slices(solid, heights, &slices, NULL, &error));
  CHECK(plumb_plane_set_list_count(slices) == 3);
  OK(plumb_plane_set_equals(plumb_plane_set_list_at(slices, 1), square, &is_equal, &error));
  CHECK(is_equal && plumb_plane_set_is_empty(plumb_plane_set_list_at(slices, 2)));
  OK(plumb_solid_shadow(solid, &shadow, NULL, &error));
  OK(plumb_plane_set_equals(shadow, square, &is_equal, &error));
  CHECK(is_equal);
  OK(plumb_solid_bounding_box(solid, &box, &error));
  CHECK(plumb_numbers_count(box) == 6 && plumb_numbers_nearest(box, 5) == 5);
  plumb_numbers_free(box);
  plumb_plane_set_free(shadow);
  plumb_plane_set_list_free(slices);
  plumb_numbers_free(heights);
  plumb_solid_free(solid);
  tall.height = -1;
  FAILS(plumb_plane_set_extrude(square, &tall, &solid, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_plane_set_revolve(square, 360, 4, &solid, NULL, &error)); /* 2 (2 * 9 - 2 * 1). */
  CHECK(has_volume(solid, "32"));
  plumb_solid_free(solid);
  OK(plumb_plane_set_disk(2, 4, &disk, NULL, &error));
  CHECK(has_area(disk, "8"));
  FAILS(plumb_plane_set_revolve(disk, 360, 4, &solid, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_plane_set_free(disk);
  plumb_plane_set_free(square);
  OK(plumb_solid_empty(&solid, &error));
  OK(plumb_solid_bounding_box(solid, &box, &error));
  CHECK(plumb_numbers_count(box) == 0);
  plumb_numbers_free(box);
  plumb_solid_free(solid);
}

static void test_parts_and_maps(void) {
  plumb_solid *a = cube_at(0, 0, 0), *b = cube_at(3, 0, 0), *both = NULL, *moved = NULL;
  plumb_solid_list* parts = NULL;
  plumb_numbers *map = NULL, *n = NULL;
  const double axis[3] = {0, 0, 1}, skew[3] = {1, 2, 3}, nowhere[3] = {0, 0, 0};
  const bool automatic[3] = {false, true, true};
  OK(plumb_solid_union(a, b, &both, NULL, &error));
  OK(plumb_solid_components(both, &parts, NULL, &error));
  CHECK(plumb_solid_list_count(parts) == 2 && same(plumb_solid_list_at(parts, 0), a));
  plumb_solid_list_free(parts);
  OK(plumb_numbers_rotation(axis, 90, &map, &error));
  CHECK(plumb_numbers_count(map) == 12 && !strcmp(plumb_numbers_exact(map, 1), "-1"));
  plumb_numbers_free(map);
  OK(plumb_numbers_rotation(skew, 40, &map, &error));
  OK(plumb_solid_transform(a, map, &moved, NULL, &error));
  CHECK(has_volume(moved, "1"));
  plumb_solid_free(moved);
  plumb_numbers_free(map);
  FAILS(plumb_numbers_rotation(nowhere, 40, &map, &error), PLUMB_BAD_ARGUMENT);
  n = numbers("2 1/3 1");
  OK(plumb_numbers_scaling(n, &map, &error));
  OK(plumb_solid_transform(a, map, &moved, NULL, &error));
  CHECK(has_volume(moved, "2/3"));
  plumb_solid_free(moved);
  plumb_numbers_free(map);
  OK(plumb_numbers_reflection(n, &map, &error));
  plumb_numbers_free(map);
  plumb_numbers_free(n);
  n = numbers("8 0 0");
  OK(plumb_numbers_resizing(both, n, automatic, &map, &error));
  OK(plumb_solid_transform(both, map, &moved, NULL, &error));
  CHECK(has_volume(moved, "16"));
  plumb_solid_free(moved);
  plumb_numbers_free(map);
  OK(plumb_numbers_resizing(both, n, NULL, &map, &error));
  CHECK(!strcmp(plumb_numbers_exact(map, 5), "1"));
  plumb_numbers_free(map);
  plumb_numbers_free(n);
  plumb_solid_free(a);
  plumb_solid_free(b);
  plumb_solid_free(both);
}

static void test_solid_offsets_and_distances(void) {
  plumb_solid *a = cube_at(0, 0, 0), *b = cube_at(3, 5, 0), *grown = NULL, *none = NULL;
  plumb_plane_set *square = square_at("0 0 2 0 2 2 0 2"), *other = square_at("5 6 7 6 7 8 5 8");
  plumb_numbers* found = NULL;
  plumb_location cells[2];
  OK(plumb_solid_distance(a, b, &found, cells, NULL, &error));
  CHECK(plumb_numbers_count(found) == 7 && !strcmp(plumb_numbers_exact(found, 0), "20"));
  CHECK(plumb_numbers_nearest(found, 1) == 1 && plumb_numbers_nearest(found, 4) == 3);
  CHECK(cells[0].dimension <= 1 && cells[0].is_inside && cells[1].dimension <= 1);
  plumb_numbers_free(found);
  OK(plumb_plane_set_distance(square, other, &found, cells, NULL, &error));
  CHECK(plumb_numbers_count(found) == 5 && !strcmp(plumb_numbers_exact(found, 0), "25"));
  CHECK(cells[0].dimension == 0 && cells[1].dimension == 0);
  plumb_numbers_free(found);
  OK(plumb_solid_empty(&none, &error));
  FAILS(plumb_solid_distance(a, none, &found, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_solid_offset(a, 1, 0, &grown, NULL, &error));
  OK(plumb_solid_distance(grown, b, &found, NULL, NULL, &error));
  CHECK(plumb_numbers_nearest(found, 0) < 20);
  plumb_numbers_free(found);
  plumb_solid_free(grown);
  FAILS(plumb_solid_offset(a, 1, 8, &grown, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_solid_offset(a, NAN, 1, &grown, NULL, &error), PLUMB_NOT_FINITE);
  plumb_solid_free(none);
  plumb_solid_free(a);
  plumb_solid_free(b);
  plumb_plane_set_free(square);
  plumb_plane_set_free(other);
}

static void test_offsets(void) {
  plumb_plane_set *square = square_at("0 0 2 0 2 2 0 2"), *grown = NULL, *sum = NULL;
  plumb_offset_options options = PLUMB_OFFSET_OPTIONS_INIT;
  options.join = PLUMB_JOIN_MITRE;
  OK(plumb_plane_set_offset(square, 1, &options, &grown, NULL, &error));
  CHECK(has_area(grown, "16"));
  OK(plumb_plane_set_minkowski_sum(square, grown, &sum, NULL, &error));
  CHECK(has_area(sum, "36"));
  plumb_plane_set_free(sum);
  plumb_plane_set_free(grown);
  options.join = 9;
  FAILS(plumb_plane_set_offset(square, 1, &options, &grown, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_plane_set_offset(square, NAN, NULL, &grown, NULL, &error), PLUMB_NOT_FINITE);
  plumb_plane_set_free(square);
}

/* A small tooth goes if its area is allowed; the square below it stays. */
static void test_simplify(void) {
  plumb_plane_set *toothed = square_at("0 0 8 0 8 8 5 8 4 8.5 3 8 0 8"), *simple = NULL;
  double moved = -1;
  OK(plumb_plane_set_simplify(toothed, 0.5, 0, INFINITY, &simple, &moved, NULL, &error));
  CHECK(has_area(simple, "64") && moved >= 0.5 && moved < 1); /* A bound. */
  plumb_plane_set_free(simple);
  OK(plumb_plane_set_simplify(toothed, 0.5, 0, 0.25, &simple, NULL, NULL, &error));
  CHECK(has_area(simple, "129/2"));
  plumb_plane_set_free(simple);
  FAILS(plumb_plane_set_simplify(toothed, -1, 0, 1, &simple, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_plane_set_simplify(toothed, NAN, 0, 1, &simple, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_plane_set_simplify(toothed, 1, 2, 1, &simple, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  CHECK(simple == NULL);
  plumb_plane_set_free(toothed);
}

static void test_triangles(void) {
  const double xy[10] = {0, 0, 1, 0, 1, 1, 0, 1, .5, .5};
  const double bad[2] = {0, INFINITY};
  plumb_plane_set *square = square_at("0 0 2 0 2 2 0 2"), *whole = NULL;
  plumb_mesh* mesh = NULL;
  OK(plumb_plane_set_triangulate(square, &mesh, NULL, &error));
  CHECK(plumb_mesh_point_count(mesh) == 4 && plumb_mesh_face_count(mesh) == 2);
  plumb_mesh_free(mesh);
  plumb_plane_set_free(square);
  OK(plumb_plane_set_whole(&whole, &error));
  FAILS(plumb_plane_set_triangulate(whole, &mesh, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_plane_set_free(whole);
  OK(plumb_mesh_delaunay(xy, 5, &mesh, NULL, &error));
  CHECK(plumb_mesh_face_count(mesh) == 4);
  plumb_mesh_free(mesh);
  FAILS(plumb_mesh_delaunay(bad, 1, &mesh, NULL, &error), PLUMB_NOT_FINITE);
}

static void test_csg(void) {
  const char text[] = "difference() { cube(size = 2); cube(size = 1); }";
  const char flat[] = "square(size = 3);";
  const char red[] = "color([1, 0, 0, 1]) { cube(size = 2); }";
  const char bad[] = "cube(size = 1);\nfrob();";
  const char import[] = "import(file = \"none.off\");";
  plumb_solid* solid = NULL;
  plumb_plane_set* set = NULL;
  plumb_notes* notes = NULL;
  OK(plumb_csg_read(text, sizeof text - 1, NULL, PLUMB_IMPORTS_NONE, &solid, &set, &notes, NULL,
                    &error));
  CHECK(set == NULL && has_volume(solid, "7") && notes != NULL);
  plumb_notes_free(notes);
  plumb_solid_free(solid);
  OK(plumb_csg_read(red, sizeof red - 1, NULL, PLUMB_IMPORTS_NONE, &solid, &set, NULL, NULL,
                    &error));
  {
    plumb_mesh* mesh = NULL;
    plumb_material material = PLUMB_MATERIAL_INIT;
    OK(plumb_solid_to_mesh_with_attributes(solid, NULL, &mesh, NULL, NULL, &error));
    CHECK(plumb_mesh_face_values(mesh, PLUMB_FACE_MATERIAL)[0] == 0);
    OK(plumb_mesh_material(mesh, 0, &material, &error));
    CHECK(material.has_color && material.color[0] == 1 && material.color[1] == 0);
    plumb_mesh_free(mesh);
  }
  plumb_solid_free(solid);
  OK(plumb_csg_read(flat, sizeof flat - 1, NULL, PLUMB_IMPORTS_NONE, &solid, &set, NULL, NULL,
                    &error));
  CHECK(solid == NULL && has_area(set, "9"));
  plumb_plane_set_free(set);
  OK(plumb_csg_read("", 0, NULL, PLUMB_IMPORTS_NONE, &solid, &set, NULL, NULL, &error));
  CHECK(solid == NULL && set == NULL);
  FAILS_WITH(plumb_csg_read(bad, sizeof bad - 1, NULL, PLUMB_IMPORTS_NONE, &solid, &set, NULL, NULL,
                            &error),
             PLUMB_UNKNOWN_FORMAT, ":2:1: ");
  FAILS(plumb_csg_read(import, sizeof import - 1, NULL, PLUMB_IMPORTS_NONE, &solid, &set, NULL,
                       NULL, &error),
        PLUMB_CANNOT_OPEN);
  FAILS(plumb_csg_read(text, sizeof text - 1, NULL, 8, &solid, &set, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_csg_read_file(path_of("none.csg"), NULL, PLUMB_IMPORTS_BELOW, &solid, &set, NULL,
                            NULL, &error),
        PLUMB_CANNOT_OPEN);
}

/* ---- layers --------------------------------------------------------------------------------- */

static const char kLayer[] =
    "{\"type\":\"FeatureCollection\",\"features\":["
    "{\"type\":\"Feature\",\"id\":\"a\",\"properties\":{\"n\":1},\"geometry\":"
    "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},"
    "{\"type\":\"Feature\",\"properties\":null,\"geometry\":"
    "{\"type\":\"Polygon\",\"coordinates\":[[[3,0],[8,0],[8,4],[3,4],[3,0]]]}}]}";

static void test_cells(void) {
  const double sites[4] = {0, 0, 4, 0}, box[4] = {-1, -1, 5, 1}, flat[4] = {0, 0, 0, 1};
  plumb_plane_set *square = square_at("0 0 2 0 2 2 0 2"), *lines = NULL, *faces = NULL;
  plumb_layer* layer = NULL;
  OK(plumb_layer_voronoi(sites, 2, box, &layer, NULL, &error));
  CHECK(plumb_layer_feature_count(layer) == 2);
  plumb_layer_free(layer);
  FAILS(plumb_layer_voronoi(sites, 2, flat, &layer, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_plane_set_boundary(square, &lines, NULL, &error));
  OK(plumb_plane_set_complement(lines, &faces, NULL, &error));
  OK(plumb_layer_of_faces(faces, &layer, NULL, &error));
  CHECK(plumb_layer_feature_count(layer) == 1);
  plumb_layer_free(layer);
  plumb_plane_set_free(square);
  plumb_plane_set_free(lines);
  plumb_plane_set_free(faces);
}

static void test_layer_operations(void) {
  plumb_layer *layer = NULL, *result = NULL;
  plumb_layer_report* report = NULL;
  plumb_indices* pairs = NULL;
  plumb_plane_set* square = square_at("2 0 20 0 20 4 2 4");
  const uint32_t groups[2] = {0, 0};
  OK(plumb_layer_read(kLayer, sizeof kLayer - 1, NULL, NULL, &layer, NULL, NULL, &error));
  OK(plumb_layer_parts(layer, square, &result, NULL, &error));
  CHECK(plumb_layer_feature_count(result) == 3);
  plumb_layer_free(result);
  OK(plumb_layer_join(layer, layer, &result, NULL, &error));
  CHECK(plumb_layer_feature_count(result) == 4);
  plumb_layer_free(result);
  plumb_plane_set_free(square);
  OK(plumb_layer_check(layer, -1, &report, NULL, &error));
  CHECK(plumb_layer_report_has_defects(report));
  CHECK(plumb_layer_report_owner(report, 0) == 0xffffffffU);
  plumb_layer_report_free(report);
  OK(plumb_layer_dissolve(layer, groups, 2, 1, &result, NULL, &error));
  CHECK(plumb_layer_feature_count(result) == 1);
  plumb_layer_free(result);
  FAILS(plumb_layer_dissolve(layer, groups, 1, 1, &result, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_layer_overlay(layer, layer, PLUMB_PAIRS_BOTH, &result, &pairs, NULL, &error));
  CHECK(2 * plumb_layer_feature_count(result) == plumb_indices_count(pairs));
  plumb_indices_free(pairs);
  plumb_layer_free(result);
  FAILS(plumb_layer_overlay(layer, layer, 9, &result, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_layer_simplify(layer, INFINITY, 0.5, &result, NULL, &error));
  CHECK(plumb_layer_feature_count(result) == 2);
  plumb_layer_free(result);
  FAILS(plumb_layer_simplify(layer, 1, 2, &result, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_layer_free(layer);
}

static void test_layer(void) {
  plumb_layer *layer = NULL, *repaired = NULL;
  plumb_layer_report* report = NULL;
  plumb_notes* notes = NULL;
  plumb_bytes* text = NULL;
  plumb_numbers* area = NULL;
  size_t count = 0;
  OK(plumb_layer_read(kLayer, sizeof kLayer - 1, NULL, NULL, &layer, &notes, NULL, &error));
  plumb_notes_free(notes);
  CHECK(plumb_layer_feature_count(layer) == 2);
  OK(plumb_layer_id(layer, 0, &text, &error));
  CHECK(!strcmp(plumb_bytes_data(text), "\"a\""));
  plumb_bytes_free(text);
  OK(plumb_layer_properties(layer, 0, &text, &error));
  CHECK(!strcmp(plumb_bytes_data(text), "{\"n\":1}"));
  plumb_bytes_free(text);
  FAILS(plumb_layer_id(layer, 2, &text, &error), PLUMB_BAD_INDEX);
  OK(plumb_layer_repair(layer, PLUMB_OWNER_SMALLEST, -1, &repaired, &report, NULL, &error));
  CHECK(plumb_layer_report_has_defects(report) && plumb_layer_report_count(report) == 1);
  CHECK(plumb_layer_report_kind(report, 0) == PLUMB_LAYER_OVERLAP);
  CHECK(plumb_layer_report_kind(report, 1) == -1);
  CHECK(plumb_layer_report_owner(report, 0) == 0);
  CHECK(plumb_layer_report_width(report, 0) == 0.8); /* 2 * 4 / 10. */
  CHECK(plumb_layer_report_features(report, 0, &count) != NULL && count == 2);
  OK(plumb_layer_report_area(report, 0, &area, &error));
  CHECK(!strcmp(plumb_numbers_exact(area, 0), "4"));
  plumb_numbers_free(area);
  FAILS(plumb_layer_report_area(report, 1, &area, &error), PLUMB_BAD_INDEX);
  OK(plumb_layer_report_write(report, layer, "json", &text, NULL, &error));
  CHECK(plumb_bytes_data(text)[0] == '{');
  plumb_bytes_free(text);
  FAILS(plumb_layer_report_write(report, layer, "pdf", &text, NULL, &error), PLUMB_UNKNOWN_FORMAT);
  OK(plumb_layer_write_file(repaired, path_of("layer.geojson"), NULL, NULL, &error));
  FAILS(plumb_layer_write_file(repaired, path_of("layer.shp"), NULL, NULL, &error),
        PLUMB_UNKNOWN_FORMAT);
  plumb_layer_free(layer);
  plumb_layer_report_free(report);
  OK(plumb_layer_read_file(path_of("layer.geojson"), NULL, &layer, NULL, NULL, &error));
  plumb_layer_free(repaired);
  OK(plumb_layer_repair(layer, PLUMB_OWNER_FIRST, 0, &repaired, &report, NULL, &error));
  CHECK(!plumb_layer_report_has_defects(report));
  OK(plumb_layer_write(repaired, "geojson", &text, NULL, &error));
  CHECK(strstr(plumb_bytes_data(text), "FeatureCollection") != NULL);
  plumb_bytes_free(text);
  plumb_layer_report_free(report);
  plumb_layer_free(repaired);
  OK(plumb_layer_write(layer, "topojson", &text, NULL, &error));
  CHECK(strstr(plumb_bytes_data(text), "Topology") != NULL);
  plumb_bytes_free(text);
  FAILS(plumb_layer_write(layer, "shp", &text, NULL, &error), PLUMB_UNKNOWN_FORMAT);
  FAILS(plumb_layer_repair(layer, 9, -1, &repaired, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_layer_repair(layer, 0, NAN, &repaired, NULL, NULL, &error), PLUMB_NOT_FINITE);
  plumb_layer_free(layer);
  FAILS_WITH(plumb_layer_read("{", 1, NULL, NULL, &layer, NULL, NULL, &error), PLUMB_SYNTAX, ":1:");
}

/* A bow tie, and the name of a coordinate reference system. */
static const char kBowTie[] =
    "{\"type\":\"FeatureCollection\",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"EPSG:"
    "2056\"}},"
    "\"features\":[{\"type\":\"Feature\",\"properties\":null,\"geometry\":"
    "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[2,2],[2,0],[0,2],[0,0]]]}}]}";

/* A hole that lies outside of its polygon. */
static const char kStrayHole[] =
    "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[4,4],[0,4],[0,0]],"
    "[[6,1],[8,1],[8,2],[6,1]]]}";

static void test_layer_nesting(void) {
  plumb_layer* layer = NULL;
  plumb_layer_report* report = NULL;
  double at[2] = {0, 0};
  OK(plumb_layer_read(kStrayHole, sizeof kStrayHole - 1, NULL, NULL, &layer, NULL, NULL, &error));
  OK(plumb_layer_check(layer, -1, &report, NULL, &error));
  CHECK(plumb_layer_report_has_defects(report) && plumb_layer_report_count(report) == 1);
  CHECK(plumb_layer_report_kind(report, 0) == PLUMB_LAYER_NESTING);
  CHECK(plumb_layer_report_place(report, 0, at) && at[0] == 6 && at[1] == 1);
  plumb_layer_report_free(report);
  plumb_layer_free(layer);
}

static void test_layer_crossing(void) {
  plumb_layer *layer = NULL, *result = NULL, *repaired = NULL;
  plumb_layer_report* report = NULL;
  plumb_bytes* text = NULL;
  double at[2] = {0, 0};
  OK(plumb_layer_read(kBowTie, sizeof kBowTie - 1, NULL, NULL, &layer, NULL, NULL, &error));
  OK(plumb_layer_crs(layer, &text, &error));
  CHECK(!strcmp(plumb_bytes_data(text), "EPSG:2056"));
  plumb_bytes_free(text);
  FAILS(plumb_layer_crs(NULL, &text, &error), PLUMB_BAD_ARGUMENT);
  OK(plumb_layer_repair(layer, PLUMB_OWNER_FIRST, -1, &repaired, &report, NULL, &error));
  CHECK(plumb_layer_report_has_defects(report) && plumb_layer_report_count(report) == 1);
  CHECK(plumb_layer_report_kind(report, 0) == PLUMB_LAYER_CROSSING);
  CHECK(plumb_layer_report_place(report, 0, at) && at[0] == 1 && at[1] == 1);
  CHECK(!plumb_layer_report_place(report, 1, at) && !plumb_layer_report_place(report, 0, NULL));
  OK(plumb_layer_report_write(report, layer, "geojson", &text, NULL, &error));
  CHECK(strstr(plumb_bytes_data(text), "EPSG:2056") && strstr(plumb_bytes_data(text), "Point"));
  plumb_bytes_free(text);
  plumb_layer_report_free(report);
  OK(plumb_layer_overlay(repaired, layer, PLUMB_PAIRS_ALL, &result, NULL, NULL, &error));
  OK(plumb_layer_write(result, "geojson", &text, NULL, &error));
  CHECK(strstr(plumb_bytes_data(text), "\"crs\"") && strstr(plumb_bytes_data(text), "EPSG:2056"));
  plumb_bytes_free(text);
  plumb_layer_free(result);
  plumb_layer_free(repaired);
  plumb_layer_free(layer);
}

/* Two squares, and between them a slit that opens to the outside at both ends. */
static const char kSlit[] =
    "{\"type\":\"FeatureCollection\",\"features\":["
    "{\"type\":\"Feature\",\"id\":9,\"properties\":{\"name\":\"west\"},\"geometry\":"
    "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}},"
    "{\"type\":\"Feature\",\"id\":2,\"properties\":{\"name\":\"east\"},\"geometry\":"
    "{\"type\":\"Polygon\",\"coordinates\":[[[4.0625,0],[8,0],[8,4],[4.0625,4],[4.0625,0]]]}}]}";

/* Returns the feature that gets the slit; -1 if the report has another number of regions than 1. */
static int owner_of_slit(const plumb_layer* layer, const plumb_layer_options* options) {
  plumb_layer* repaired = NULL;
  plumb_layer_report* report = NULL;
  int owner = -1;
  OK(plumb_layer_repair_with(layer, options, &repaired, &report, NULL, &error));
  if (plumb_layer_report_count(report) == 1) {
    CHECK(plumb_layer_report_kind(report, 0) == PLUMB_LAYER_GAP);
    CHECK(plumb_layer_report_is_open(report, 0) && !plumb_layer_report_is_open(report, 1));
    owner = (int)plumb_layer_report_owner(report, 0);
  }
  plumb_layer_free(repaired);
  plumb_layer_report_free(report);
  return owner;
}

static void test_layer_options(void) {
  const uint32_t ranks[2] = {1, 0}, east_first[2] = {1, 0}, unknown[2] = {0, 2};
  plumb_layer_options options = PLUMB_LAYER_OPTIONS_INIT, bad;
  plumb_layer *layer = NULL, *repaired = NULL;
  plumb_layer_report* report = NULL;
  uint32_t east = 9;
  OK(plumb_layer_read(kSlit, sizeof kSlit - 1, NULL, NULL, &layer, NULL, NULL, &error));
  options.gaps_below = 0.25;
  CHECK(owner_of_slit(layer, &options) == 0); /* Both borders are equally long. */
  options.owner = PLUMB_OWNER_LOWEST_ID;
  CHECK(owner_of_slit(layer, &options) == 1);
  OK(plumb_layer_repair(layer, PLUMB_OWNER_LOWEST_ID, 0.25, &repaired, &report, NULL, &error));
  CHECK(plumb_layer_report_owner(report, 0) == 1);
  plumb_layer_free(repaired);
  plumb_layer_report_free(report);
  options.owner = PLUMB_OWNER_FIRST;
  CHECK(owner_of_slit(layer, &options) == 0);
  options.ranks = ranks;
  options.rank_count = 2;
  CHECK(owner_of_slit(layer, &options) == 1);
  bad = options;
  bad.owner = PLUMB_OWNER_LARGEST;
  FAILS(plumb_layer_repair_with(layer, &bad, &repaired, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  bad = options;
  bad.rank_count = 1;
  FAILS(plumb_layer_repair_with(layer, &bad, &repaired, NULL, NULL, &error), PLUMB_BAD_ARGUMENT);
  options.owner = PLUMB_OWNER_LARGEST;
  options.rank_count = 0;
  CHECK(owner_of_slit(layer, &options) == 0);
  options.preferences = east_first;
  options.preference_count = 1;
  CHECK(owner_of_slit(layer, &options) == 1);
  OK(plumb_layer_find(layer, "east", &east, &error));
  CHECK(east == 1);
  OK(plumb_layer_find(layer, "9", &east, &error));
  CHECK(east == 0);
  FAILS(plumb_layer_find(layer, "north", &east, &error), PLUMB_BAD_ARGUMENT);
  FAILS(plumb_layer_find(layer, NULL, &east, &error), PLUMB_BAD_ARGUMENT);
  options.preferences = unknown;
  FAILS(plumb_layer_repair_with(layer, &options, &repaired, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  options.preference_count = SIZE_MAX;
  FAILS(plumb_layer_repair_with(layer, &options, &repaired, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  options.preference_count = 0;
  OK(plumb_layer_check_with(layer, &options, &report, NULL, &error));
  CHECK(plumb_layer_report_is_open(report, 0) && plumb_layer_report_has_defects(report));
  CHECK(plumb_layer_report_owner(report, 0) == 0xffffffffU);
  plumb_layer_report_free(report);
  options.enclosed_only = true;
  CHECK(owner_of_slit(layer, &options) == -1);
  OK(plumb_layer_check_with(layer, &options, &report, NULL, &error));
  CHECK(!plumb_layer_report_has_defects(report));
  plumb_layer_report_free(report);
  options.struct_size = 1;
  FAILS(plumb_layer_check_with(layer, &options, &report, NULL, &error), PLUMB_BAD_ARGUMENT);
  plumb_layer_free(layer);
}

static void test_simplify_reports(void) {
  plumb_plane_set *toothed = square_at("0 0 8 0 8 8 5 8 4 8.5 3 8 0 8"), *simple = NULL;
  plumb_simplify_report report = PLUMB_SIMPLIFY_REPORT_INIT;
  plumb_layer *layer = NULL, *result = NULL;
  OK(plumb_plane_set_simplify_with_report(toothed, 0.5, 0, INFINITY, &simple, &report, NULL,
                                          &error));
  CHECK(report.corners_before == 7 && report.corners_after == 4 && report.fixed == 0);
  CHECK(report.borders_moved >= 0.5 && report.borders_moved < 1 && report.rounding_moved == 0);
  CHECK(has_area(simple, "64"));
  plumb_plane_set_free(simple);
  OK(plumb_layer_of_faces(toothed, &layer, NULL, &error));
  OK(plumb_layer_simplify_with_report(layer, 0.5, 0, INFINITY, &result, &report, NULL, &error));
  CHECK(report.corners_before == 7 && report.corners_after == 4 && report.overlaps == 0);
  plumb_layer_free(result);
  OK(plumb_layer_simplify_with_report(layer, 0.5, 0, 0.25, &result, &report, NULL, &error));
  CHECK(report.corners_after > 4 && report.borders_moved <= 0.25);
  plumb_layer_free(result);
  OK(plumb_layer_simplify_with_report(layer, 0.5, 0, 0.25, &result, NULL, NULL, &error));
  plumb_layer_free(result);
  report.struct_size = 0;
  FAILS(plumb_layer_simplify_with_report(layer, 0.5, 0, 0.25, &result, &report, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  FAILS(plumb_plane_set_simplify_with_report(toothed, 1, 2, 1, &simple, NULL, NULL, &error),
        PLUMB_BAD_ARGUMENT);
  plumb_layer_free(layer);
  plumb_plane_set_free(toothed);
}

int main(int count, char** arguments) {
  if (count > 1) folder = arguments[1];
  test_versions();
  test_numbers();
  test_null();
  test_context();
  test_mesh_arrays();
  test_mesh_files();
  test_mesh_defects();
  test_degenerate_arrays();
  test_solid_algebra();
  test_solid_makers();
  test_solid_questions();
  test_solid_changes();
  test_solid_files();
  test_solid_meshes();
  test_attribute_arrays();
  test_attributes_of_solids();
  test_sources_of_half_spaces();
  test_kept_attributes();
  test_attribute_files();
  test_solid_pictures();
  test_plane_algebra();
  test_plane_makers();
  test_plane_questions();
  test_plane_files();
  test_sphere();
  test_map();
  test_map_defects();
  test_overlay();
  test_surface();
  test_scene();
  test_primitives();
  test_hulls();
  test_extrusions();
  test_parts_and_maps();
  test_solid_offsets_and_distances();
  test_offsets();
  test_simplify();
  test_triangles();
  test_csg();
  test_cells();
  test_layer();
  test_layer_crossing();
  test_layer_nesting();
  test_layer_operations();
  test_layer_options();
  test_simplify_reports();
  printf("%d failed\n", failures);
  return failures == 0 ? 0 : 1;
}
