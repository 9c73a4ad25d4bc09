/* Materials and texture coordinates through a difference, in C: each face of the result says which
 * face of which input it is a part of. examples/attributes.cpp does the same in C++. */
#include <plumb.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static plumb_error* error = NULL; /* Of the last call. */

/* Ends the program at the first failure. */
static void check(plumb_status status) {
  if (status == PLUMB_OK) return;
  fprintf(stderr, "%s\n", plumb_error_text(error));
  exit(1);
}

/* A box with one material, and the coordinates x and y as texture coordinates. */
static plumb_solid* painted_box(const char* name, double low, double high) {
  static const uint32_t begin[7] = {0, 4, 8, 12, 16, 20, 24}, of_face[6] = {0, 0, 0, 0, 0, 0};
  static const uint32_t corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                       2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  plumb_material material = PLUMB_MATERIAL_INIT;
  plumb_solid_options options = PLUMB_SOLID_OPTIONS_INIT;
  double xyz[24], uv[16];
  plumb_mesh* mesh = NULL;
  plumb_solid* solid = NULL;
  int v, k;
  for (v = 0; v < 8; ++v) {
    for (k = 0; k < 3; ++k) xyz[3 * v + k] = (v >> k) % 2 == 0 ? low : high;
    uv[2 * v] = xyz[3 * v];
    uv[2 * v + 1] = xyz[3 * v + 1];
  }
  check(plumb_mesh_from_polygons(xyz, 8, begin, 6, corners, 24, &mesh, &error));
  material.name = name;
  check(plumb_mesh_add_material(mesh, &material, NULL, &error));
  check(plumb_mesh_set_face_values(mesh, PLUMB_FACE_MATERIAL, of_face, 6, &error));
  check(plumb_mesh_set_channel(mesh, "texcoord_0", 2, PLUMB_PER_POINT, uv, 8, &error));
  options.source_name = name;
  check(plumb_solid_from_mesh(mesh, &options, &solid, NULL, &error));
  plumb_mesh_free(mesh);
  return solid;
}

static void print_sources(const plumb_solid* solid, const plumb_mesh* made) {
  const uint32_t* source = plumb_mesh_face_values(made, PLUMB_FACE_SOURCE);
  const uint32_t* flipped = plumb_mesh_face_values(made, PLUMB_FACE_IS_FLIPPED);
  size_t s, f;
  for (s = 0; s < plumb_solid_source_count(solid); ++s) {
    size_t faces = 0, turned = 0;
    for (f = 0; f < plumb_mesh_face_count(made); ++f) {
      if (source[f] != s) continue;
      ++faces;
      turned += flipped[f];
    }
    printf("%s: %lu triangles, %s\n", plumb_solid_source_name(solid, s), (unsigned long)faces,
           turned == faces ? "flipped" : "as they were");
  }
}

static int has_right_texture(const plumb_mesh* made) {
  const double* uv = plumb_mesh_channel_values(made, 0);
  size_t c;
  for (c = 0; c < plumb_mesh_corner_count(made); ++c) {
    const double* p = plumb_mesh_points(made) + 3 * plumb_mesh_corners(made)[c];
    if (uv[2 * c] != p[0] || uv[2 * c + 1] != p[1]) return 0;
  }
  return 1;
}

int main(void) {
  plumb_solid *red = painted_box("red", 0, 2), *blue = painted_box("blue", 1, 3), *rest = NULL;
  plumb_mesh* made = NULL;
  check(plumb_solid_difference(red, blue, &rest, NULL, &error));
  check(plumb_solid_to_mesh_with_attributes(rest, NULL, &made, NULL, NULL, &error));
  print_sources(rest, made);
  printf("texture coordinates are right: %s\n", has_right_texture(made) ? "yes" : "no");
  plumb_mesh_free(made);
  plumb_solid_free(rest);
  plumb_solid_free(blue);
  plumb_solid_free(red);
  return 0;
}
