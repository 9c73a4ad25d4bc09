/* The C interface of plumb (C99, and C++). docs/c.md explains it with a complete example.
 *
 * Handles. Objects are opaque and are released by plumb_<type>_free(), which accepts a null
 * pointer. A set and a report never change after they were made, so several threads may read one
 * object at the same time. What changes an object, such as a mesh that gets attributes, takes a
 * pointer that is not const, and then no other thread may use the object.
 *
 * Results. A function that can fail returns a plumb_status: PLUMB_OK, or the reason of the failure.
 * A result is written through a pointer. If the function fails, a handle that it should have made
 * is a null pointer, and other results have no meaning. Functions without a status cannot fail; for
 * a null pointer or an index out of range they return 0, false or a null pointer.
 *
 * Errors. The last parameter of a function that can fail is `plumb_error **error`. It may be null.
 * On failure it receives an error object with a message and, for texts, file, line and column. The
 * caller releases it by plumb_error_free(). On success it receives a null pointer. No C++ exception
 * leaves a function, and plumb never ends the process. (GMP does if malloc refuses memory for a
 * number; docs/c.md.)
 *
 * Contexts. The parameter `context` holds limits, the number of threads, the request to stop and a
 * progress callback. It may be null: then nothing is limited. Limits hold for each call by itself.
 *
 * Arrays. Inputs are read where they lie and are not needed after the call. A pointer that a
 * function returns is valid until the handle that owns the data is released. Sizes count elements,
 * not bytes, unless stated otherwise. An array of size 0 may be a null pointer. Coordinates are
 * stored x y z x y z ..., indices count from 0.
 *
 * Numbers. A double stands for its exact value. Fractions are texts such as "1/3"; plumb_numbers is
 * a list of exact numbers. A double that is not finite gives PLUMB_NOT_FINITE.
 *
 * Structs. The first member of most structs is struct_size. The caller sets it to the sizeof of the
 * struct that it was compiled with, so that later versions can append members. The macros
 * PLUMB_..._INIT set it and the defaults. A pointer to options may be null: all defaults.
 *
 * Stability. Within one PLUMB_ABI_VERSION, functions, constants and members of structs are never
 * removed or changed; new ones may be added. Texts of messages may change. */
#ifndef PLUMB_C_PLUMB_H
#define PLUMB_C_PLUMB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__) || defined(__clang__)
#define PLUMB_API __attribute__((visibility("default")))
#else
#define PLUMB_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- version and status --------------------------------------------------------------------- */

/** The version of the binary interface that this header describes. */
#define PLUMB_ABI_VERSION 1

/** Returns the PLUMB_ABI_VERSION of the library, for a comparison with that of the header. */
PLUMB_API int plumb_abi_version(void);
/** Returns the version of the library as text, such as "0.1.0". */
PLUMB_API const char* plumb_version(void);

/** PLUMB_OK, or one of the constants below. Later versions may add constants. */
typedef int plumb_status;
/** The values of plumb_status. 1xx concern texts and files, 2xx limits, 3xx arguments, 4xx the
 * process. */
enum plumb_status_code {
  PLUMB_OK = 0,                    /**< The function has done what it promises. */
  PLUMB_CANNOT_OPEN = 100,         /**< A file cannot be read. */
  PLUMB_CANNOT_WRITE = 101,        /**< A file cannot be written. */
  PLUMB_NOT_TEXT = 102,            /**< A byte of a text is not text. */
  PLUMB_SYNTAX = 103,              /**< A text does not follow the rules of its format. */
  PLUMB_NUMBER_OUT_OF_RANGE = 104, /**< A number is too long, or beyond the largest double. */
  PLUMB_COUNT_MISMATCH = 105,      /**< A file states a count and has another one. */
  PLUMB_BAD_INDEX = 106,           /**< An index is out of range. */
  PLUMB_DEGENERATE_FACE = 107,     /**< A face has too few different corners. */
  PLUMB_UNKNOWN_FORMAT = 108,      /**< There is no format of this name, or not for this purpose. */
  PLUMB_USAGE = 109,               /**< Options contradict each other. */
  PLUMB_CLOSED_PIPE = 110,         /**< The reader of the output closed the pipe; see docs/c.md. */
  PLUMB_BAD_SHAPE = 111,           /**< A mesh is open, a ring is not closed, or the like. */
  PLUMB_RESOURCE_LIMIT = 200,      /**< A limit of the context is exceeded. */
  PLUMB_CANCELLED = 201,           /**< plumb_context_cancel() was called. */
  PLUMB_NOT_FINITE = 300,          /**< A double is infinite or not a number. */
  PLUMB_BAD_ARGUMENT = 301,        /**< An argument is null or makes no sense. */
  PLUMB_OUT_OF_MEMORY = 400,       /**< The system refused memory. */
  PLUMB_INTERNAL = 401             /**< A bug in plumb, whatever the arguments were. */
};

/** Returns a name such as "bad shape" for a status; "unknown status" for any other number. */
PLUMB_API const char* plumb_status_name(plumb_status status);

/* ---- errors --------------------------------------------------------------------------------- */

/** Why a function failed. */
typedef struct plumb_error plumb_error;

/** Returns the status that the function returned. */
PLUMB_API plumb_status plumb_error_status(const plumb_error* error);
/** Returns a sentence for people, without the place. Never null for an error. */
PLUMB_API const char* plumb_error_message(const plumb_error* error);
/** Returns "FILE:LINE:COLUMN: MESSAGE", with as much of the place as is known. */
PLUMB_API const char* plumb_error_text(const plumb_error* error);
/** Returns the name of the text that the error is about; empty if it is about none. */
PLUMB_API const char* plumb_error_file(const plumb_error* error);
/** Returns the line, from 1; 0 if unknown. */
PLUMB_API size_t plumb_error_line(const plumb_error* error);
/** Returns the column in bytes, from 1; 0 if unknown. */
PLUMB_API size_t plumb_error_column(const plumb_error* error);
/** Releases an error. */
PLUMB_API void plumb_error_free(plumb_error* error);

/* ---- contexts ------------------------------------------------------------------------------- */

/** Limits, threads, the request to stop and the progress callback of operations. Several calls may
 * use one context at the same time, as long as nobody changes it. */
typedef struct plumb_context plumb_context;

/** Called at most 20 times a second, on the thread that runs the operation, with the name of a
 * phase, the steps done, and the steps in all (0 if unknown). It must return: it may neither throw
 * an exception nor jump out. It may call plumb_context_cancel(). */
typedef void (*plumb_progress)(const char* phase, uint64_t done, uint64_t total, void* user_data);

/** Makes a context: 16 GiB, no time limit, numbers of at most 1100 digits, one thread. */
PLUMB_API plumb_status plumb_context_new(plumb_context** out, plumb_error** error);
/** Releases a context. No call may be using it. */
PLUMB_API void plumb_context_free(plumb_context* context);
/** Sets the greatest number of bytes of working memory, as plumb estimates it, of one call. */
PLUMB_API plumb_status plumb_context_set_memory_limit(plumb_context* context, uint64_t bytes,
                                                      plumb_error** error);
/** Sets the time that one call may take; 0 means any. Refuses negative and non-finite numbers. */
PLUMB_API plumb_status plumb_context_set_time_limit(plumb_context* context, double seconds,
                                                    plumb_error** error);
/** Sets the greatest number of digits, and the greatest absolute decimal exponent, of a number in
 * a text. */
PLUMB_API plumb_status plumb_context_set_number_limits(plumb_context* context, uint32_t digits,
                                                       uint32_t exponent, plumb_error** error);
/** Sets how many threads a call may use; at least 1. Results do not depend on it. */
PLUMB_API plumb_status plumb_context_set_threads(plumb_context* context, uint32_t threads,
                                                 plumb_error** error);
/** Sets the progress callback; null removes it. */
PLUMB_API plumb_status plumb_context_set_progress(plumb_context* context, plumb_progress progress,
                                                  void* user_data, plumb_error** error);
/** Asks all calls that use the context to stop, now and later: they return PLUMB_CANCELLED. May be
 * called on any thread and in a signal handler, while calls use the context. */
PLUMB_API void plumb_context_cancel(plumb_context* context);
/** Whether plumb_context_cancel() was called since the context was made or reset. */
PLUMB_API bool plumb_context_is_cancelled(const plumb_context* context);
/** Forgets the request to stop. No call may be using the context, and none may be cancelling. */
PLUMB_API plumb_status plumb_context_reset(plumb_context* context, plumb_error** error);

/* ---- bytes, notes, indices, numbers --------------------------------------------------------- */

/** Bytes of a file or a text. A zero byte follows the last one and does not count. */
typedef struct plumb_bytes plumb_bytes;
PLUMB_API const char* plumb_bytes_data(const plumb_bytes* bytes); /**< Returns the bytes. */
PLUMB_API size_t plumb_bytes_size(const plumb_bytes* bytes);      /**< Returns their number. */
PLUMB_API void plumb_bytes_free(plumb_bytes* bytes);              /**< Releases the bytes. */

/** Sentences for people about what was read or written. */
typedef struct plumb_notes plumb_notes;
PLUMB_API size_t plumb_notes_count(const plumb_notes* notes); /**< Returns their number. */
/** Returns note i. */
PLUMB_API const char* plumb_notes_text(const plumb_notes* notes, size_t i);
/** Whether note i tells of geometry that was lost, so that people should see it. */
PLUMB_API bool plumb_notes_is_warning(const plumb_notes* notes, size_t i);
PLUMB_API void plumb_notes_free(plumb_notes* notes); /**< Releases the notes. */

/** A list of 32-bit integers. */
typedef struct plumb_indices plumb_indices;
PLUMB_API const uint32_t* plumb_indices_data(const plumb_indices* indices); /**< Returns them. */
PLUMB_API size_t plumb_indices_count(const plumb_indices* indices); /**< Returns their number. */
PLUMB_API void plumb_indices_free(plumb_indices* indices);          /**< Releases the list. */

/** A list of exact numbers. */
typedef struct plumb_numbers plumb_numbers;
/** Makes the list of the exact values of doubles. */
PLUMB_API plumb_status plumb_numbers_from_doubles(const double* values, size_t count,
                                                  plumb_numbers** out, plumb_error** error);
/** Makes a list from texts: "-3", "1/3", "0.1" (a tenth, exactly) or "2.5e-3". The place of an
 * error names the text, such as "number 2". The context limits digits and exponents. */
PLUMB_API plumb_status plumb_numbers_from_texts(const char* const* texts, size_t count,
                                                plumb_numbers** out, const plumb_context* context,
                                                plumb_error** error);
PLUMB_API size_t plumb_numbers_count(const plumb_numbers* numbers); /**< Returns their number. */
/** Returns number i as "p/q" in lowest terms, or "p". */
PLUMB_API const char* plumb_numbers_exact(const plumb_numbers* numbers, size_t i);
/** Returns the double that is nearest to number i; an infinity beyond the largest double. */
PLUMB_API double plumb_numbers_nearest(const plumb_numbers* numbers, size_t i);
PLUMB_API void plumb_numbers_free(plumb_numbers* numbers); /**< Releases the list. */

/* ---- constants and small structs ------------------------------------------------------------ */

/** Boolean functions of two sets, for plumb_<set>_combine(). The four low bits say whether a point
 * belongs to the result: bit 0 if it is in neither set, bit 1 if it is in the first only, bit 2 if
 * it is in the second only, bit 3 if it is in both. Any of the 16 functions may be passed.
 * PLUMB_REGULARIZED may be added: the result is then the closure of its interior. */
enum plumb_operation {
  PLUMB_UNION = 14,
  PLUMB_INTERSECTION = 8,
  PLUMB_DIFFERENCE = 2,
  PLUMB_SYMMETRIC_DIFFERENCE = 6,
  PLUMB_REGULARIZED = 16
};

/** Which winding numbers count as inside. */
enum plumb_rule {
  /** Solids: the positive ones, after components that are inside out were turned. Sets of the plane
   * and surfaces: the odd ones. */
  PLUMB_RULE_DEFAULT = 0,
  PLUMB_RULE_NONZERO = 1,
  PLUMB_RULE_EVEN_ODD = 2,
  PLUMB_RULE_POSITIVE = 3
};

/** The cell that contains a point. */
typedef struct plumb_location {
  int32_t dimension; /**< 0 vertex, 1 edge, 2 facet or face, 3 volume. */
  uint32_t index;    /**< Which one of this dimension. */
  bool is_inside;    /**< Whether the point belongs to the set. */
} plumb_location;

/** How a text is read. */
typedef struct plumb_read_options {
  size_t struct_size; /**< sizeof(plumb_read_options). */
  /** The name of the text in messages; its extension chooses the format. Null: the first bytes
   * choose it. Files that are read by path ignore it. */
  const char* name;
  bool exact_decimals; /**< Whether 0.1 means 1/10, not the nearest double. */
  /** Whether a mesh gets the attributes of its file: 1, or 0. Solids have plumb_solid_options::keep
   * instead. It is no bool, which would lie where older callers have padding. */
  size_t attributes;
} plumb_read_options;
#define PLUMB_READ_OPTIONS_INIT \
  { sizeof(plumb_read_options), NULL, false, 0 }

/** How a set is written as a file of doubles. */
typedef struct plumb_write_options {
  size_t struct_size; /**< sizeof(plumb_write_options). */
  /** Whether coordinates become the nearest numbers even if faces or edges then cross. Otherwise
   * they become numbers with which the file is valid. */
  bool raw;
  /** One positive number: coordinates of the plane are rounded to its multiples. Null: to doubles.
   * Solids have no grid. */
  const plumb_numbers* grid;
} plumb_write_options;
#define PLUMB_WRITE_OPTIONS_INIT \
  { sizeof(plumb_write_options), false, NULL }

/** What happens to faces that have the corners of an earlier face. */
enum plumb_doubled { PLUMB_DOUBLED_KEEP = 0, PLUMB_DOUBLED_IF_BETTER = 1, PLUMB_DOUBLED_DROP = 2 };

/** How a mesh is mended. By default nothing is done. */
typedef struct plumb_repair_options {
  size_t struct_size;  /**< sizeof(plumb_repair_options). */
  double weld;         /**< Points at most this far apart become one. */
  int doubled;         /**< A constant of plumb_doubled. */
  bool reorient;       /**< Whether faces that disagree with their neighbours are turned. */
  uint32_t fill_holes; /**< Holes with at most so many edges are filled. */
  /** Holes are also filled if the box of their vertices has a diagonal of at most this length. */
  double fill_holes_below;
} plumb_repair_options;
#define PLUMB_REPAIR_OPTIONS_INIT \
  { sizeof(plumb_repair_options), 0.0, 0, false, 0, 0.0 }

/** Which attributes of a mesh its solid keeps. A solid that keeps attributes has the mesh as its
 * source (plumb_solid_source_count()). */
enum plumb_keep {
  PLUMB_KEEP_DEFAULT = 0, /**< All attributes of a plumb_mesh that has any; none of a file. */
  PLUMB_KEEP_NONE = 1,    /**< No attributes. Nothing is paid for them. */
  PLUMB_KEEP_COLOURS = 2, /**< Materials, and the channel "color". */
  PLUMB_KEEP_IDS = 3,     /**< Ids of faces, and groups. */
  /** All attributes. A mesh in memory becomes a source even if it has no attributes, so that the
   * faces of a result can be traced to the faces of the mesh. */
  PLUMB_KEEP_ALL = 4
};

/** How a mesh becomes a solid. */
typedef struct plumb_solid_options {
  size_t struct_size; /**< sizeof(plumb_solid_options). */
  int rule;           /**< A constant of plumb_rule. */
  bool surface;       /**< Whether the set is the union of the facets; the mesh may be open. */
  bool may_be_empty;  /**< Whether a file of faces that enclose nothing is read as the empty set. */
  const plumb_repair_options* repair; /**< How the mesh is mended first; null: not at all. */
  int keep;                           /**< A constant of plumb_keep. */
  /** The name of a mesh in memory as a source; may be null. A file has its own name. */
  const char* source_name;
} plumb_solid_options;
#define PLUMB_SOLID_OPTIONS_INIT \
  { sizeof(plumb_solid_options), 0, false, false, NULL, PLUMB_KEEP_DEFAULT, NULL }

/* ---- meshes --------------------------------------------------------------------------------- */

/** A mesh of polygons over shared points. It need not be closed. */
typedef struct plumb_mesh plumb_mesh;

/** Makes a mesh of triangles. `xyz` has 3 * point_count doubles; `triangles` has 3 * triangle_count
 * indices of points, counter-clockwise seen from outside. */
PLUMB_API plumb_status plumb_mesh_from_triangles(const double* xyz, size_t point_count,
                                                 const uint32_t* triangles, size_t triangle_count,
                                                 plumb_mesh** out, plumb_error** error);
/** Makes a mesh of polygons. Face f has the corners corners[face_begin[f]] to
 * corners[face_begin[f + 1] - 1]; face_begin has face_count + 1 entries, from 0 to corner_count. */
PLUMB_API plumb_status plumb_mesh_from_polygons(const double* xyz, size_t point_count,
                                                const uint32_t* face_begin, size_t face_count,
                                                const uint32_t* corners, size_t corner_count,
                                                plumb_mesh** out, plumb_error** error);
/** Reads OFF, OBJ, STL, PLY, glTF or 3MF from memory. A glTF text may refer to files beside
 * options->name. `notes` may be null; otherwise it receives what the mesh does not hold. */
PLUMB_API plumb_status plumb_mesh_read(const char* bytes, size_t size,
                                       const plumb_read_options* options, plumb_mesh** out,
                                       plumb_notes** notes, const plumb_context* context,
                                       plumb_error** error);
/** Reads a file; "-" is standard input. */
PLUMB_API plumb_status plumb_mesh_read_file(const char* path, const plumb_read_options* options,
                                            plumb_mesh** out, plumb_notes** notes,
                                            const plumb_context* context, plumb_error** error);
/** Writes the mesh as "off", "off-exact", "obj", "stl", "stl-binary", "ply", "ply-text", "glb" or
 * "3mf". STL, GLB and 3MF need triangles. The bytes have those attributes of the mesh that the
 * format holds; plumb_mesh_lost_attributes() names the others. Colours and textures of materials
 * are not in "obj", which has only their names: they belong in a second file, which
 * plumb_mesh_write_file() writes. */
PLUMB_API plumb_status plumb_mesh_write(const plumb_mesh* mesh, const char* format,
                                        plumb_bytes** out, plumb_error** error);
/** Writes a file, which is complete or absent. `format` may be null: the extension chooses it. If
 * faces have materials, the material library of an OBJ file is written beside it as .mtl. */
PLUMB_API plumb_status plumb_mesh_write_file(const plumb_mesh* mesh, const char* path,
                                             const char* format, plumb_error** error);
PLUMB_API size_t plumb_mesh_point_count(const plumb_mesh* mesh);  /**< Returns the points. */
PLUMB_API size_t plumb_mesh_face_count(const plumb_mesh* mesh);   /**< Returns the faces. */
PLUMB_API size_t plumb_mesh_corner_count(const plumb_mesh* mesh); /**< Corners of all faces. */
/** Returns 3 * plumb_mesh_point_count() coordinates; the nearest doubles of exact points. */
PLUMB_API const double* plumb_mesh_points(const plumb_mesh* mesh);
/** Returns plumb_mesh_face_count() + 1 offsets in plumb_mesh_corners(). */
PLUMB_API const uint32_t* plumb_mesh_face_begin(const plumb_mesh* mesh);
/** Returns the corners of all faces. If all faces are triangles, these are three for each. */
PLUMB_API const uint32_t* plumb_mesh_corners(const plumb_mesh* mesh);
/** Returns, for each face, the facet of the solid that it was made from; null if the mesh was not
 * made from a solid. */
PLUMB_API const uint32_t* plumb_mesh_facets(const plumb_mesh* mesh);
/** Returns the three exact coordinates of a point. */
PLUMB_API plumb_status plumb_mesh_exact_point(const plumb_mesh* mesh, size_t point,
                                              plumb_numbers** out, plumb_error** error);
/** Makes the mesh with every face of more than three corners cut into triangles, without
 * attributes. */
PLUMB_API plumb_status plumb_mesh_triangulate(const plumb_mesh* mesh, plumb_mesh** out,
                                              const plumb_context* context, plumb_error** error);
/** What plumb_mesh_repair() did. */
typedef struct plumb_repair_report {
  size_t struct_size;  /**< sizeof(plumb_repair_report). */
  uint64_t equal;      /**< Points that had the coordinates of an earlier one. */
  uint64_t welded;     /**< Places that moved onto another one. */
  double farthest;     /**< How far they moved at most. */
  uint64_t unused;     /**< Points that were dropped because no face uses them. */
  uint64_t trimmed;    /**< Faces that lost corners. */
  uint64_t degenerate; /**< Faces that were dropped: fewer than three corners were left. */
  uint64_t doubled;    /**< Faces that were dropped because they were there twice. */
  uint64_t flipped;    /**< Faces that were turned. */
  uint64_t turned;     /**< Components that were turned. */
  uint64_t filled;     /**< Holes that were filled. */
  uint64_t added;      /**< Faces in them. */
  uint64_t holes;      /**< Chains of edges along which faces are still missing. */
  bool is_closed;      /**< Whether the mesh is closed afterwards. */
} plumb_repair_report;
#define PLUMB_REPAIR_REPORT_INIT \
  { sizeof(plumb_repair_report), 0, 0, 0.0, 0, 0, 0, 0, 0, 0, 0, 0, 0, false }
/** Makes the mended mesh, without attributes. (plumb_solid_options::repair mends a mesh whose
 * attributes its solid keeps.) `report` and `notes` may be null. */
PLUMB_API plumb_status plumb_mesh_repair(const plumb_mesh* mesh,
                                         const plumb_repair_options* options, plumb_mesh** out,
                                         plumb_repair_report* report, plumb_notes** notes,
                                         const plumb_context* context, plumb_error** error);
/** Finds how a mesh must be mended so that plumb_solid_from_mesh() accepts it, changing as little
 * as possible. Sets *found to false if nothing helps. */
PLUMB_API plumb_status plumb_mesh_find_repair(const plumb_mesh* mesh, plumb_repair_options* options,
                                              bool* found, const plumb_context* context,
                                              plumb_error** error);
PLUMB_API void plumb_mesh_free(plumb_mesh* mesh); /**< Releases a mesh. */

/** What was found in a mesh. */
typedef struct plumb_mesh_report plumb_mesh_report;
/** Examines a mesh: is it closed, does it cross itself, which faces are degenerate? At most
 * max_listed crossings are listed; all are counted. Crossings are sought in closed meshes only. */
PLUMB_API plumb_status plumb_mesh_check(const plumb_mesh* mesh, uint64_t max_listed,
                                        plumb_mesh_report** out, const plumb_context* context,
                                        plumb_error** error);
/** Lists of a plumb_mesh_report. */
enum plumb_mesh_list {
  PLUMB_MESH_DEGENERATE = 0, /**< Faces without area. */
  PLUMB_MESH_TRIMMED = 1,    /**< Faces with repeated corners or spikes. */
  PLUMB_MESH_NOT_PLANAR = 2, /**< Faces that are not planar. */
  PLUMB_MESH_NOT_SIMPLE = 3, /**< Faces that are no simple polygons. */
  PLUMB_MESH_DOUBLED = 4,    /**< Pairs: a face, and an earlier one with the same boundary. */
  PLUMB_MESH_CROSSINGS = 5,  /**< Pairs of faces that cross. */
  PLUMB_MESH_FLIPPED = 6,    /**< Faces that disagree with their neighbours. */
  PLUMB_MESH_ONE_SIDED = 7,  /**< A face of each component that has one side only. */
  PLUMB_MESH_INSIDE_OUT = 8, /**< A face of each component of negative volume. */
  PLUMB_MESH_BORDERS = 9,    /**< Vertices of all borders; see plumb_mesh_report_chains(). */
  PLUMB_MESH_HOLES = 10      /**< Vertices of all holes; see plumb_mesh_report_chains(). */
};
/** Returns a list, and its number of entries (two for each pair) through `count`. */
PLUMB_API const uint32_t* plumb_mesh_report_list(const plumb_mesh_report* report, int list,
                                                 size_t* count);
/** Returns where each chain of PLUMB_MESH_BORDERS or PLUMB_MESH_HOLES begins in its list, and
 * the number of chains through `count`; there is one offset more than there are chains. */
PLUMB_API const uint32_t* plumb_mesh_report_chains(const plumb_mesh_report* report, int list,
                                                   size_t* count);
PLUMB_API bool plumb_mesh_report_is_closed(const plumb_mesh_report* report); /**< No borders? */
/** Returns how many pairs of faces cross. */
PLUMB_API uint64_t plumb_mesh_report_crossing_count(const plumb_mesh_report* report);
PLUMB_API void plumb_mesh_report_free(plumb_mesh_report* report); /**< Releases a report. */

/** Whether the mesh is the surface of one convex body. `reflex_edges` and `failing` may be null;
 * `failing` receives pairs of a face and a vertex on its outer side. */
PLUMB_API plumb_status plumb_mesh_convexity(const plumb_mesh* mesh, bool* is_convex,
                                            uint64_t* reflex_edges, plumb_indices** failing,
                                            const plumb_context* context, plumb_error** error);

/* ---- attributes of meshes ------------------------------------------------------------------- */

/* A mesh can carry materials, groups and ids of faces, and channels: numbers at corners, such as
 * colours and texture coordinates. A solid that keeps them (plumb_solid_options::keep) has the mesh
 * as a source, and so have all results of Booleans and affine maps of it.
 * plumb_solid_to_mesh_with_attributes() finds for each face the source that it is a part of, and
 * interpolates the channels. docs/attributes.md states the rules. */

/** The entry of a face that has no material, group, id or source. */
#define PLUMB_NONE 0xffffffffU

/** A material that faces refer to. */
typedef struct plumb_material {
  size_t struct_size;  /**< sizeof(plumb_material). */
  const char* name;    /**< Its name. Null stands for an empty name. */
  bool has_color;      /**< Whether `color` has a meaning. */
  double color[4];     /**< Red, green, blue and opacity, each from 0 to 1. */
  const char* texture; /**< The name of a texture file. Null stands for none. */
} plumb_material;
#define PLUMB_MATERIAL_INIT \
  { sizeof(plumb_material), NULL, false, {0.0, 0.0, 0.0, 1.0}, NULL }

/** Appends a material to a mesh. `index` receives its index, and may be null. */
PLUMB_API plumb_status plumb_mesh_add_material(plumb_mesh* mesh, const plumb_material* material,
                                               uint32_t* index, plumb_error** error);
/** Returns how many materials the mesh has. */
PLUMB_API size_t plumb_mesh_material_count(const plumb_mesh* mesh);
/** Fills `material` with material i. Its texts, which are never null, are valid until the mesh gets
 * another material or is released. */
PLUMB_API plumb_status plumb_mesh_material(const plumb_mesh* mesh, size_t i,
                                           plumb_material* material, plumb_error** error);
/** Appends a group of a name to a mesh. `index` receives its index, and may be null. */
PLUMB_API plumb_status plumb_mesh_add_group(plumb_mesh* mesh, const char* name, uint32_t* index,
                                            plumb_error** error);
/** Returns how many groups the mesh has. */
PLUMB_API size_t plumb_mesh_group_count(const plumb_mesh* mesh);
/** Returns the name of group i. */
PLUMB_API const char* plumb_mesh_group(const plumb_mesh* mesh, size_t i);

/** Values that each face of a mesh has. */
enum plumb_face_values {
  PLUMB_FACE_MATERIAL = 0,    /**< The index of its material, or PLUMB_NONE. */
  PLUMB_FACE_GROUP = 1,       /**< The index of its group, or PLUMB_NONE. */
  PLUMB_FACE_ID = 2,          /**< An id that the caller chose, or PLUMB_NONE. */
  PLUMB_FACE_SOURCE = 3,      /**< The source of the solid it comes from, or PLUMB_NONE. */
  PLUMB_FACE_SOURCE_FACE = 4, /**< The face of this source, or PLUMB_NONE. */
  PLUMB_FACE_IS_FLIPPED = 5   /**< 1 if it and this face have opposite sides, else 0. */
};
/** Sets the materials, the groups or the ids of all faces. `count` is the number of faces. If
 * `values` is null and `count` is 0, they are removed. A value that is no index of a material or a
 * group of the mesh gives PLUMB_BAD_INDEX. The other constants are results only. */
PLUMB_API plumb_status plumb_mesh_set_face_values(plumb_mesh* mesh, int which,
                                                  const uint32_t* values, size_t count,
                                                  plumb_error** error);
/** Returns plumb_mesh_face_count() values of a constant of plumb_face_values; null if the mesh has
 * none. Those from PLUMB_FACE_SOURCE on belong to meshes that
 * plumb_solid_to_mesh_with_attributes() made. */
PLUMB_API const uint32_t* plumb_mesh_face_values(const plumb_mesh* mesh, int which);

/** What a channel has numbers for. */
enum plumb_channel_place {
  PLUMB_PER_CORNER = 0, /**< For each corner of each face, in the order of plumb_mesh_corners(). */
  PLUMB_PER_POINT = 1   /**< For each point: all corners at it have the same numbers. */
};
/** Sets the channel of a name: `width` numbers for each of `count` corners or points, as `place`
 * says. `count` is the number of all corners or of all points. A channel of this name is replaced;
 * if `values` is null and `count` is 0, it is removed. Files use the names "color" (3 or 4 numbers
 * from 0 to 1), "normal" (3), "texcoord_0", "texcoord_1" and so on (2). */
PLUMB_API plumb_status plumb_mesh_set_channel(plumb_mesh* mesh, const char* name, uint32_t width,
                                              int place, const double* values, size_t count,
                                              plumb_error** error);
/** Returns how many channels the mesh has. */
PLUMB_API size_t plumb_mesh_channel_count(const plumb_mesh* mesh);
/** Returns the name of channel i. */
PLUMB_API const char* plumb_mesh_channel_name(const plumb_mesh* mesh, size_t i);
/** Returns how many numbers channel i has for each corner. */
PLUMB_API uint32_t plumb_mesh_channel_width(const plumb_mesh* mesh, size_t i);
/** Returns the numbers of channel i: its width times plumb_mesh_corner_count(), in the order of
 * plumb_mesh_corners(). */
PLUMB_API const double* plumb_mesh_channel_values(const plumb_mesh* mesh, size_t i);
/** Returns a sentence that names the attributes of the mesh that a file of this format does not
 * hold; an empty text if it holds all of them. The formats are those of plumb_mesh_write(). */
PLUMB_API plumb_status plumb_mesh_lost_attributes(const plumb_mesh* mesh, const char* format,
                                                  plumb_bytes** out, plumb_error** error);

/* ---- solids --------------------------------------------------------------------------------- */

/** A Nef polyhedron: any set of space that is made from half-spaces by unions, intersections and
 * complements. */
typedef struct plumb_solid plumb_solid;

/** Makes the set without points. */
PLUMB_API plumb_status plumb_solid_empty(plumb_solid** out, plumb_error** error);
/** Makes the whole space. */
PLUMB_API plumb_status plumb_solid_whole(plumb_solid** out, plumb_error** error);
/** Makes another handle of the same set. O(1). */
PLUMB_API plumb_status plumb_solid_copy(const plumb_solid* solid, plumb_solid** out,
                                        plumb_error** error);
PLUMB_API void plumb_solid_free(plumb_solid* solid); /**< Releases a solid. */

/** Makes the solid that closed triangles bound. The arrays are those of
 * plumb_mesh_from_triangles(). An open mesh gives PLUMB_BAD_SHAPE; plumb_mesh_check() tells
 * where. */
PLUMB_API plumb_status plumb_solid_from_triangles(const double* xyz, size_t point_count,
                                                  const uint32_t* triangles, size_t triangle_count,
                                                  const plumb_solid_options* options,
                                                  plumb_solid** out, const plumb_context* context,
                                                  plumb_error** error);
/** Makes the solid that closed polygons bound. The arrays are those of
 * plumb_mesh_from_polygons(). */
PLUMB_API plumb_status plumb_solid_from_polygons(const double* xyz, size_t point_count,
                                                 const uint32_t* face_begin, size_t face_count,
                                                 const uint32_t* corners, size_t corner_count,
                                                 const plumb_solid_options* options,
                                                 plumb_solid** out, const plumb_context* context,
                                                 plumb_error** error);
/** Makes the solid that a mesh bounds. If the mesh has attributes, the solid keeps them, unless
 * options->keep says otherwise. */
PLUMB_API plumb_status plumb_solid_from_mesh(const plumb_mesh* mesh,
                                             const plumb_solid_options* options, plumb_solid** out,
                                             const plumb_context* context, plumb_error** error);
/** Makes the half-space a x + b y + c z + d < 0, or <= 0 if it is closed, of four numbers. */
PLUMB_API plumb_status plumb_solid_half_space(const plumb_numbers* plane, bool is_closed,
                                              plumb_solid** out, plumb_error** error);
/** Makes the points of the plane a x + b y + c z + d = 0. */
PLUMB_API plumb_status plumb_solid_plane(const plumb_numbers* plane, plumb_solid** out,
                                         plumb_error** error);
/** Makes the intersection of half-spaces. `planes` has 4 * count doubles; `is_closed` has `count`
 * entries, and may be null: all are closed. */
PLUMB_API plumb_status plumb_solid_from_half_spaces(const double* planes, const bool* is_closed,
                                                    size_t count, plumb_solid** out,
                                                    const plumb_context* context,
                                                    plumb_error** error);
/** Reads half-spaces, lines `a b c d closed` or `a b c d open`, and makes their intersection. */
PLUMB_API plumb_status plumb_solid_read_half_spaces_file(const char* path,
                                                         const plumb_read_options* options,
                                                         plumb_solid** out,
                                                         const plumb_context* context,
                                                         plumb_error** error);
/** Makes a set of points, of three numbers each. */
PLUMB_API plumb_status plumb_solid_points(const plumb_numbers* points, plumb_solid** out,
                                          const plumb_context* context, plumb_error** error);
/** Makes the union of the segments from each point to the next one. */
PLUMB_API plumb_status plumb_solid_polyline(const plumb_numbers* points, plumb_solid** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the closed planar polygon with these corners. */
PLUMB_API plumb_status plumb_solid_facet(const plumb_numbers* corners, plumb_solid** out,
                                         const plumb_context* context, plumb_error** error);
/** Makes a ball of 8 * 4^rounds triangles around the origin; rounds is at most 7. */
PLUMB_API plumb_status plumb_solid_ball(double radius, uint32_t rounds, plumb_solid** out,
                                        plumb_error** error);

/** Reads OFF, OBJ, STL, PLY, glTF, 3MF or .nef from memory; see plumb_mesh_read(). */
PLUMB_API plumb_status plumb_solid_read(const char* bytes, size_t size,
                                        const plumb_read_options* reading,
                                        const plumb_solid_options* options, plumb_solid** out,
                                        plumb_notes** notes, const plumb_context* context,
                                        plumb_error** error);
/** Reads a file; "-" is standard input. */
PLUMB_API plumb_status plumb_solid_read_file(const char* path, const plumb_read_options* reading,
                                             const plumb_solid_options* options, plumb_solid** out,
                                             plumb_notes** notes, const plumb_context* context,
                                             plumb_error** error);
/** Writes "off", "off-exact", "obj", "stl", "stl-binary", "ply", "ply-text", "glb", "3mf" or
 * "nef". Only .nef holds every set; `notes` tells what else a file does not hold. Equal sets give
 * the same .nef only after plumb_solid_canonical(). Meshes have those attributes of the sources
 * that the format holds; see plumb_mesh_write(). */
PLUMB_API plumb_status plumb_solid_write(const plumb_solid* solid, const char* format,
                                         const plumb_write_options* options, plumb_bytes** out,
                                         plumb_notes** notes, const plumb_context* context,
                                         plumb_error** error);
/** Writes a file, which is complete or absent. `format` may be null: the extension chooses it. If
 * sources have materials, the material library of an OBJ file is written beside it as .mtl. */
PLUMB_API plumb_status plumb_solid_write_file(const plumb_solid* solid, const char* path,
                                              const char* format,
                                              const plumb_write_options* options,
                                              plumb_notes** notes, const plumb_context* context,
                                              plumb_error** error);
/** Draws the solid as "html", "svg", "glb" or "png". `title` may be null. */
PLUMB_API plumb_status plumb_solid_draw(const plumb_solid* solid, const char* format,
                                        const char* title, plumb_bytes** out,
                                        const plumb_context* context, plumb_error** error);
/** Draws several solids, each in a colour of its own, moved apart by `apart` times their
 * distances. */
PLUMB_API plumb_status plumb_solid_draw_many(const plumb_solid* const* solids, size_t count,
                                             double apart, const char* format, const char* title,
                                             plumb_bytes** out, const plumb_context* context,
                                             plumb_error** error);

/** How a solid becomes a mesh. */
typedef struct plumb_to_mesh_options {
  size_t struct_size;  /**< sizeof(plumb_to_mesh_options). */
  bool polygons;       /**< Whether planar facets stay polygons; otherwise all are triangles. */
  bool split_vertices; /**< Whether each cone at a vertex gets a point of its own. */
  bool floats;         /**< Whether coordinates become floats, stored as doubles. */
  /** Whether the mesh is exact: points are the nearest doubles, and plumb_mesh_exact_point() gives
   * the exact ones. Otherwise the mesh is valid after rounding. */
  bool exact;
  /** Whether points are the nearest doubles, even if faces then cross: 1, or 0. The points are those
   * of `exact`; the mesh does not have the exact ones, whose computation can triple the time. It is
   * no bool, which would lie where older callers have padding. */
  size_t nearest;
} plumb_to_mesh_options;
#define PLUMB_TO_MESH_OPTIONS_INIT \
  { sizeof(plumb_to_mesh_options), false, false, false, false, 0 }
/** What plumb_solid_to_mesh() did, and what the mesh does not represent. */
typedef struct plumb_to_mesh_report {
  size_t struct_size;             /**< sizeof(plumb_to_mesh_report). */
  uint64_t rounded_vertices;      /**< Vertices whose coordinates were rounded. */
  uint32_t rounds;                /**< Rounds of repair; 0: the nearest numbers are valid. */
  uint32_t coarse_rounds;         /**< Rounds that rounded more coarsely. */
  uint64_t damaged_faces;         /**< Faces that rounding to the nearest numbers damages. */
  double largest_move;            /**< A bound for the distance from the exact boundary. */
  bool changes_topology;          /**< Whether thin parts or gaps vanished. */
  uint64_t dropped;               /**< Cells of the set outside of the solid: left out. */
  uint64_t filled;                /**< Cells inside of the solid that the set lacks. */
  uint64_t closed;                /**< Cells of the boundary that the set lacks. */
  uint64_t non_manifold_edges;    /**< Edges with more than two faces. */
  uint64_t non_manifold_vertices; /**< Vertices with more than one cone. */
} plumb_to_mesh_report;
#define PLUMB_TO_MESH_REPORT_INIT \
  { sizeof(plumb_to_mesh_report), 0, 0, 0, 0, 0.0, false, 0, 0, 0, 0, 0 }
/** Makes the mesh of the boundary of the solid. Fails with PLUMB_BAD_ARGUMENT if the solid is
 * unbounded. `options` and `report` may be null. */
PLUMB_API plumb_status plumb_solid_to_mesh(const plumb_solid* solid,
                                           const plumb_to_mesh_options* options, plumb_mesh** out,
                                           plumb_to_mesh_report* report,
                                           const plumb_context* context, plumb_error** error);

/** How the parts of faces of sources become faces of a mesh. */
enum plumb_pieces {
  /** Parts of a facet are one face if they have the same source, material, group and id, and if
   * each channel is the same affine function on them. */
  PLUMB_PIECES_SAME_ATTRIBUTES = 0,
  PLUMB_PIECES_APART = 1,    /**< Each face lies in one triangle of a source. */
  PLUMB_PIECES_SAME_FACE = 2 /**< As the first, and each face lies in one face of a source. */
};
/** How a solid becomes a mesh with attributes. */
typedef struct plumb_attribute_options {
  size_t struct_size; /**< sizeof(plumb_attribute_options). */
  int pieces;         /**< A constant of plumb_pieces. */
  bool polygons;      /**< Whether planar parts stay polygons; otherwise all are triangles. */
  bool floats;        /**< Whether coordinates become floats, stored as doubles. */
} plumb_attribute_options;
#define PLUMB_ATTRIBUTE_OPTIONS_INIT \
  { sizeof(plumb_attribute_options), 0, false, false }
/** Makes the mesh of the boundary of the solid, valid after rounding, with the attributes of the
 * sources of the solid. Materials and groups of all sources follow each other. Faces are in
 * ascending order of PLUMB_FACE_SOURCE; those without a source are last. Channels of the same name
 * become one, of the greatest width; numbers that a source does not have are 0, and 1 in the
 * channel "color". Fails with PLUMB_BAD_ARGUMENT if the solid is unbounded. `options` and `report`
 * may be null. */
PLUMB_API plumb_status plumb_solid_to_mesh_with_attributes(
    const plumb_solid* solid, const plumb_attribute_options* options, plumb_mesh** out,
    plumb_to_mesh_report* report, const plumb_context* context, plumb_error** error);
/** Makes the same solid with one source, in place of those that it has: a mesh with attributes,
 * whose faces lie where the boundary of the solid lies. `name` may be null. */
PLUMB_API plumb_status plumb_solid_with_source(const plumb_solid* solid, const plumb_mesh* mesh,
                                               const char* name, plumb_solid** out,
                                               plumb_error** error);
/** Returns how many sources the solid has: the meshes with attributes from which it was made, in
 * the order of the operands. */
PLUMB_API size_t plumb_solid_source_count(const plumb_solid* solid);
/** Returns the name of source i: that of its file, or plumb_solid_options::source_name. */
PLUMB_API const char* plumb_solid_source_name(const plumb_solid* solid, size_t i);

/** Makes the set of an operation of two sets; see plumb_operation. */
PLUMB_API plumb_status plumb_solid_combine(const plumb_solid* a, const plumb_solid* b,
                                           int operation, plumb_solid** out,
                                           const plumb_context* context, plumb_error** error);
/** Makes the set of the points in a or b. */
PLUMB_API plumb_status plumb_solid_union(const plumb_solid* a, const plumb_solid* b,
                                         plumb_solid** out, const plumb_context* context,
                                         plumb_error** error);
/** Makes the set of the points in a and b. */
PLUMB_API plumb_status plumb_solid_intersection(const plumb_solid* a, const plumb_solid* b,
                                                plumb_solid** out, const plumb_context* context,
                                                plumb_error** error);
/** Makes the set of the points in a but not in b. */
PLUMB_API plumb_status plumb_solid_difference(const plumb_solid* a, const plumb_solid* b,
                                              plumb_solid** out, const plumb_context* context,
                                              plumb_error** error);
/** Makes the set of the points in exactly one of a and b. */
PLUMB_API plumb_status plumb_solid_symmetric_difference(const plumb_solid* a, const plumb_solid* b,
                                                        plumb_solid** out,
                                                        const plumb_context* context,
                                                        plumb_error** error);
/** Makes the union of any number of sets; of none: the empty set. */
PLUMB_API plumb_status plumb_solid_union_of(const plumb_solid* const* solids, size_t count,
                                            plumb_solid** out, const plumb_context* context,
                                            plumb_error** error);
/** Makes the intersection of any number of sets; of none: the whole space. */
PLUMB_API plumb_status plumb_solid_intersection_of(const plumb_solid* const* solids, size_t count,
                                                   plumb_solid** out, const plumb_context* context,
                                                   plumb_error** error);
/** Makes the value of an expression such as "(A + B) * !C": + union, * intersection, - difference,
 * ^ symmetric difference, ! complement. names[i] is the name of solids[i]. */
PLUMB_API plumb_status plumb_solid_evaluate(const char* expression, const char* const* names,
                                            const plumb_solid* const* solids, size_t count,
                                            plumb_solid** out, const plumb_context* context,
                                            plumb_error** error);
/** Makes the complement. */
PLUMB_API plumb_status plumb_solid_complement(const plumb_solid* solid, plumb_solid** out,
                                              const plumb_context* context, plumb_error** error);
/** Makes the set without its boundary. */
PLUMB_API plumb_status plumb_solid_interior(const plumb_solid* solid, plumb_solid** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the set with its boundary. */
PLUMB_API plumb_status plumb_solid_closure(const plumb_solid* solid, plumb_solid** out,
                                           const plumb_context* context, plumb_error** error);
/** Makes the boundary. */
PLUMB_API plumb_status plumb_solid_boundary(const plumb_solid* solid, plumb_solid** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the interior of the complement. */
PLUMB_API plumb_status plumb_solid_exterior(const plumb_solid* solid, plumb_solid** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the closure of the interior. */
PLUMB_API plumb_status plumb_solid_regularization(const plumb_solid* solid, plumb_solid** out,
                                                  const plumb_context* context,
                                                  plumb_error** error);
/** Makes the same set with its cells in the one order that depends on the set alone. */
PLUMB_API plumb_status plumb_solid_canonical(const plumb_solid* solid, plumb_solid** out,
                                             const plumb_context* context, plumb_error** error);
/** The part of space that a plane a x + b y + c z + d = 0 stands for. */
enum plumb_section {
  PLUMB_SECTION_CLOSED_BELOW = 0, /**< a x + b y + c z + d <= 0. */
  PLUMB_SECTION_OPEN_BELOW = 1,   /**< a x + b y + c z + d < 0. */
  PLUMB_SECTION_PLANE = 2         /**< The plane. */
};
/** Combines the solid with a part of space that a plane of four numbers bounds. */
PLUMB_API plumb_status plumb_solid_section(const plumb_solid* solid, const plumb_numbers* plane,
                                           int section, int operation, plumb_solid** out,
                                           const plumb_context* context, plumb_error** error);
/** Makes the image under an invertible affine map, of 12 numbers: three rows of the matrix, each
 * followed by the translation of its coordinate. */
PLUMB_API plumb_status plumb_solid_transform(const plumb_solid* solid, const plumb_numbers* map,
                                             plumb_solid** out, const plumb_context* context,
                                             plumb_error** error);
/** Makes { a + b : a in A, b in B }. */
PLUMB_API plumb_status plumb_solid_minkowski_sum(const plumb_solid* a, const plumb_solid* b,
                                                 plumb_solid** out, const plumb_context* context,
                                                 plumb_error** error);
/** Makes { x : x + b in A for all b in B }. */
PLUMB_API plumb_status plumb_solid_minkowski_erosion(const plumb_solid* a, const plumb_solid* b,
                                                     plumb_solid** out,
                                                     const plumb_context* context,
                                                     plumb_error** error);

/** Facts about a solid. */
typedef struct plumb_solid_info {
  size_t struct_size;    /**< sizeof(plumb_solid_info). */
  size_t vertices;       /**< Vertices, without those of the frame of an unbounded set. */
  size_t edges;          /**< Edges. */
  size_t facets;         /**< Facets. */
  size_t volumes;        /**< Volumes, bounded or not. */
  size_t marked_volumes; /**< Volumes that belong to the set. */
  size_t bytes;          /**< Memory; copies share it. */
  bool is_empty;         /**< Whether there is no point. */
  bool is_whole;         /**< Whether all of space belongs to it. */
  bool is_bounded;       /**< Whether a ball contains it. */
  bool is_closed;        /**< Whether it contains its boundary. */
  bool is_open;          /**< Whether it contains no point of its boundary. */
  bool is_simple;        /**< Whether the boundary is a 2-manifold. */
  bool is_convex;        /**< Whether it contains the segment between any two of its points. */
} plumb_solid_info;
#define PLUMB_SOLID_INFO_INIT \
  { sizeof(plumb_solid_info), 0, 0, 0, 0, 0, 0, false, false, false, false, false, false, false }
/** Fills `info`. O(n) expected time. */
PLUMB_API plumb_status plumb_solid_describe(const plumb_solid* solid, plumb_solid_info* info,
                                            plumb_error** error);
PLUMB_API bool plumb_solid_is_empty(
    const plumb_solid* solid); /**< Whether it has no point. O(1). */
PLUMB_API bool plumb_solid_is_whole(
    const plumb_solid* solid); /**< Whether it is all space. O(1). */
/** Whether both are the same set. */
PLUMB_API plumb_status plumb_solid_equals(const plumb_solid* a, const plumb_solid* b, bool* out,
                                          plumb_error** error);
/** Whether every point of a is in b. */
PLUMB_API plumb_status plumb_solid_is_subset(const plumb_solid* a, const plumb_solid* b, bool* out,
                                             const plumb_context* context, plumb_error** error);
/** Sets inside[i] to whether point i belongs to the solid. `xyz` has 3 * count doubles. */
PLUMB_API plumb_status plumb_solid_contains(const plumb_solid* solid, const double* xyz,
                                            size_t count, bool* inside,
                                            const plumb_context* context, plumb_error** error);
/** Sets locations[i] to the cell that contains point i. `points` has three numbers for each, and
 * `locations` has `count` entries. */
PLUMB_API plumb_status plumb_solid_locate(const plumb_solid* solid, const plumb_numbers* points,
                                          plumb_location* locations, size_t count,
                                          const plumb_context* context, plumb_error** error);
/** Finds the first cell that belongs to the solid on a ray: three numbers of its origin, and three
 * of its direction. If `to_boundary`, finds the first vertex, edge or facet instead. If the ray
 * meets nothing, *is_hit becomes false and *point null. Otherwise *point has the three coordinates
 * of the first point. */
PLUMB_API plumb_status plumb_solid_shoot(const plumb_solid* solid, const plumb_numbers* ray,
                                         bool to_boundary, bool* is_hit, plumb_location* location,
                                         plumb_numbers** point, const plumb_context* context,
                                         plumb_error** error);
/** Returns the exact volume, one number; none if it is infinite. */
PLUMB_API plumb_status plumb_solid_volume(const plumb_solid* solid, plumb_numbers** out,
                                          const plumb_context* context, plumb_error** error);
/** Returns the exact centroid, three numbers; none if the volume is 0 or infinite. */
PLUMB_API plumb_status plumb_solid_centroid(const plumb_solid* solid, plumb_numbers** out,
                                            const plumb_context* context, plumb_error** error);
/** Returns the area of the boundary, with a relative error below 2^-50; an infinity if it is
 * infinite. */
PLUMB_API plumb_status plumb_solid_surface_area(const plumb_solid* solid, double* out,
                                                const plumb_context* context, plumb_error** error);
/** Whether the solid is convex, with evidence: the number of reflex edges, and pairs of a facet and
 * a vertex on its outer side. `reflex_edges` and `failing` may be null. */
PLUMB_API plumb_status plumb_solid_convexity(const plumb_solid* solid, bool* is_convex,
                                             uint64_t* reflex_edges, plumb_indices** failing,
                                             const plumb_context* context, plumb_error** error);
/** Checks every invariant from scratch. *flaw becomes null if all hold; otherwise it says what does
 * not hold, and where. */
PLUMB_API plumb_status plumb_solid_audit(const plumb_solid* solid, plumb_bytes** flaw,
                                         const plumb_context* context, plumb_error** error);

/** A list of solids. */
typedef struct plumb_solid_list plumb_solid_list;
/** How plumb_solid_decompose() cuts. */
enum plumb_decomposition {
  PLUMB_DECOMPOSE_BEST = 0, /**< The method that gives fewer pieces. */
  PLUMB_DECOMPOSE_CUTS = 1, /**< Along planes through reflex edges. */
  PLUMB_DECOMPOSE_WALLS = 2 /**< Along vertical walls through reflex edges. */
};
/** Cuts the solid into convex pieces. Every point belongs to one piece; if `is_closed`, the
 * closures of the pieces are returned. */
PLUMB_API plumb_status plumb_solid_decompose(const plumb_solid* solid, int method, bool is_closed,
                                             plumb_solid_list** out, const plumb_context* context,
                                             plumb_error** error);
PLUMB_API size_t plumb_solid_list_count(const plumb_solid_list* list); /**< Returns the number. */
/** Returns solid i, which the list owns; plumb_solid_copy() makes one that outlives the list. */
PLUMB_API const plumb_solid* plumb_solid_list_at(const plumb_solid_list* list, size_t i);
PLUMB_API void plumb_solid_list_free(plumb_solid_list* list); /**< Releases list and solids. */

/* ---- sets of the plane ---------------------------------------------------------------------- */

/** A Nef polyhedron of the plane: polygons, lines and points, each with or without its boundary. */
typedef struct plumb_plane_set plumb_plane_set;

/** Makes the set without points. */
PLUMB_API plumb_status plumb_plane_set_empty(plumb_plane_set** out, plumb_error** error);
/** Makes the whole plane. */
PLUMB_API plumb_status plumb_plane_set_whole(plumb_plane_set** out, plumb_error** error);
/** Makes another handle of the same set. O(1). */
PLUMB_API plumb_status plumb_plane_set_copy(const plumb_plane_set* set, plumb_plane_set** out,
                                            plumb_error** error);
PLUMB_API void plumb_plane_set_free(plumb_plane_set* set); /**< Releases a set. */
/** Makes the half-plane a x + b y + c < 0, or <= 0 if it is closed, of three numbers. */
PLUMB_API plumb_status plumb_plane_set_half_plane(const plumb_numbers* line, bool is_closed,
                                                  plumb_plane_set** out, plumb_error** error);
/** Makes the line a x + b y + c = 0. */
PLUMB_API plumb_status plumb_plane_set_line(const plumb_numbers* line, plumb_plane_set** out,
                                            plumb_error** error);
/** Makes the set that closed chains of points bound. `xy` has 2 * point_count doubles. Chain c has
 * the points corners[chain_begin[c]] to corners[chain_begin[c + 1] - 1]; chain_begin has
 * chain_count + 1 entries, from 0 to corner_count. `rule` is a constant of plumb_rule. */
PLUMB_API plumb_status plumb_plane_set_polygons(const double* xy, size_t point_count,
                                                const uint32_t* chain_begin, size_t chain_count,
                                                const uint32_t* corners, size_t corner_count,
                                                int rule, bool is_closed, plumb_plane_set** out,
                                                const plumb_context* context, plumb_error** error);
/** Makes the set that one closed chain bounds, of two numbers for each point. The direction does
 * not matter. */
PLUMB_API plumb_status plumb_plane_set_polygon(const plumb_numbers* points, bool is_closed,
                                               plumb_plane_set** out, const plumb_context* context,
                                               plumb_error** error);
/** Makes the union of the segments between consecutive points of open chains. The arrays are those
 * of plumb_plane_set_polygons(); a chain of one point is this point. */
PLUMB_API plumb_status plumb_plane_set_polylines(const double* xy, size_t point_count,
                                                 const uint32_t* chain_begin, size_t chain_count,
                                                 const uint32_t* corners, size_t corner_count,
                                                 plumb_plane_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** Makes a set of points, of two numbers each. */
PLUMB_API plumb_status plumb_plane_set_points(const plumb_numbers* points, plumb_plane_set** out,
                                              const plumb_context* context, plumb_error** error);
/** Reads WKT, GeoJSON, WKB or .nef2 from memory. The extension of options->name chooses the
 * format, else the first bytes. `notes` may be null. */
PLUMB_API plumb_status plumb_plane_set_read(const char* bytes, size_t size,
                                            const plumb_read_options* options,
                                            plumb_plane_set** out, plumb_notes** notes,
                                            const plumb_context* context, plumb_error** error);
/** Reads a file; "-" is standard input. */
PLUMB_API plumb_status plumb_plane_set_read_file(const char* path,
                                                 const plumb_read_options* options,
                                                 plumb_plane_set** out, plumb_notes** notes,
                                                 const plumb_context* context, plumb_error** error);
/** Writes "wkt", "geojson", "wkb", "dxf" or "nef2". Only .nef2 holds every set; `notes` tells what
 * else a file does not hold. */
PLUMB_API plumb_status plumb_plane_set_write(const plumb_plane_set* set, const char* format,
                                             const plumb_write_options* options, plumb_bytes** out,
                                             plumb_notes** notes, const plumb_context* context,
                                             plumb_error** error);
/** Writes a file, which is complete or absent. `format` may be null: the extension chooses it. */
PLUMB_API plumb_status plumb_plane_set_write_file(const plumb_plane_set* set, const char* path,
                                                  const char* format,
                                                  const plumb_write_options* options,
                                                  plumb_notes** notes, const plumb_context* context,
                                                  plumb_error** error);
/** Draws the set as "svg", "html", "glb" or "png". `title` may be null. */
PLUMB_API plumb_status plumb_plane_set_draw(const plumb_plane_set* set, const char* format,
                                            const char* title, plumb_bytes** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the set of an operation of two sets; see plumb_operation. */
PLUMB_API plumb_status plumb_plane_set_combine(const plumb_plane_set* a, const plumb_plane_set* b,
                                               int operation, plumb_plane_set** out,
                                               const plumb_context* context, plumb_error** error);
/** Makes the union. */
PLUMB_API plumb_status plumb_plane_set_union(const plumb_plane_set* a, const plumb_plane_set* b,
                                             plumb_plane_set** out, const plumb_context* context,
                                             plumb_error** error);
/** Makes the intersection. */
PLUMB_API plumb_status plumb_plane_set_intersection(const plumb_plane_set* a,
                                                    const plumb_plane_set* b, plumb_plane_set** out,
                                                    const plumb_context* context,
                                                    plumb_error** error);
/** Makes the set of what is in a but not in b. */
PLUMB_API plumb_status plumb_plane_set_difference(const plumb_plane_set* a,
                                                  const plumb_plane_set* b, plumb_plane_set** out,
                                                  const plumb_context* context,
                                                  plumb_error** error);
/** Makes the set of what is in exactly one of a and b. */
PLUMB_API plumb_status plumb_plane_set_symmetric_difference(const plumb_plane_set* a,
                                                            const plumb_plane_set* b,
                                                            plumb_plane_set** out,
                                                            const plumb_context* context,
                                                            plumb_error** error);
/** Makes the union of any number of sets; of none: the empty set. */
PLUMB_API plumb_status plumb_plane_set_union_of(const plumb_plane_set* const* sets, size_t count,
                                                plumb_plane_set** out, const plumb_context* context,
                                                plumb_error** error);
/** Makes the intersection of any number of sets; of none: the plane. */
PLUMB_API plumb_status plumb_plane_set_intersection_of(const plumb_plane_set* const* sets,
                                                       size_t count, plumb_plane_set** out,
                                                       const plumb_context* context,
                                                       plumb_error** error);
/** Makes the complement. */
PLUMB_API plumb_status plumb_plane_set_complement(const plumb_plane_set* set, plumb_plane_set** out,
                                                  const plumb_context* context,
                                                  plumb_error** error);
/** Makes the set without its boundary. */
PLUMB_API plumb_status plumb_plane_set_interior(const plumb_plane_set* set, plumb_plane_set** out,
                                                const plumb_context* context, plumb_error** error);
/** Makes the set with its boundary. */
PLUMB_API plumb_status plumb_plane_set_closure(const plumb_plane_set* set, plumb_plane_set** out,
                                               const plumb_context* context, plumb_error** error);
/** Makes the boundary. */
PLUMB_API plumb_status plumb_plane_set_boundary(const plumb_plane_set* set, plumb_plane_set** out,
                                                const plumb_context* context, plumb_error** error);
/** Makes the interior of the complement. */
PLUMB_API plumb_status plumb_plane_set_exterior(const plumb_plane_set* set, plumb_plane_set** out,
                                                const plumb_context* context, plumb_error** error);
/** Makes the closure of the interior. */
PLUMB_API plumb_status plumb_plane_set_regularization(const plumb_plane_set* set,
                                                      plumb_plane_set** out,
                                                      const plumb_context* context,
                                                      plumb_error** error);
PLUMB_API bool plumb_plane_set_is_empty(
    const plumb_plane_set* set); /**< Whether the set is empty. O(1). */
PLUMB_API bool plumb_plane_set_is_whole(
    const plumb_plane_set* set); /**< Whether it is the plane. O(1). */
/** Whether both are the same set. */
PLUMB_API plumb_status plumb_plane_set_equals(const plumb_plane_set* a, const plumb_plane_set* b,
                                              bool* out, plumb_error** error);
/** Whether all of a is in b. */
PLUMB_API plumb_status plumb_plane_set_is_subset(const plumb_plane_set* a, const plumb_plane_set* b,
                                                 bool* out, const plumb_context* context,
                                                 plumb_error** error);
/** Checks every invariant from scratch; see plumb_solid_audit(). */
PLUMB_API plumb_status plumb_plane_set_audit(const plumb_plane_set* set, plumb_bytes** flaw,
                                             const plumb_context* context, plumb_error** error);
/** Makes the image under an invertible affine map, of 6 numbers: two rows of the matrix, each
 * followed by the translation of its coordinate. */
PLUMB_API plumb_status plumb_plane_set_transform(const plumb_plane_set* set,
                                                 const plumb_numbers* map, plumb_plane_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** What rounding changed. Distances are those of the maximum norm. */
typedef struct plumb_rounding_report {
  size_t struct_size;     /**< sizeof(plumb_rounding_report). */
  size_t vertices_moved;  /**< Vertices that are not at their nearest numbers. */
  size_t vertices_merged; /**< Vertices that fell on another one. */
  size_t edges_bent;      /**< Edges that have corners where they had none. */
  size_t edges_folded;    /**< Pieces of edges that were left out: the same face on both sides. */
  size_t collapsed;       /**< Faces of which nothing is left. */
  double largest_move;    /**< A bound for the distance that a point moved. */
} plumb_rounding_report;
#define PLUMB_ROUNDING_REPORT_INIT \
  { sizeof(plumb_rounding_report), 0, 0, 0, 0, 0, 0.0 }
/** Makes the closure of the set with coordinates that are doubles, or the nearest doubles of
 * multiples of a step: `step` is one positive number, or null. The result is valid: edges meet only
 * in common ends. Unbounded parts are left out. `report` may be null. */
PLUMB_API plumb_status plumb_plane_set_round(const plumb_plane_set* set, const plumb_numbers* step,
                                             plumb_plane_set** out, plumb_rounding_report* report,
                                             const plumb_context* context, plumb_error** error);
/** Facts about a set of the plane. */
typedef struct plumb_plane_set_info {
  size_t struct_size;  /**< sizeof(plumb_plane_set_info). */
  size_t vertices;     /**< Vertices. */
  size_t edges;        /**< Segments, rays and lines. */
  size_t faces;        /**< Faces, bounded or not. */
  size_t marked_faces; /**< Faces that belong to the set. */
  size_t bytes;        /**< Memory; copies share it. */
  bool is_empty;       /**< Whether there is no point. */
  bool is_whole;       /**< Whether it is the plane. */
  bool is_bounded;     /**< Whether a disk contains it. */
  bool is_closed;      /**< Whether it contains its boundary. */
  bool is_open;        /**< Whether it contains no point of its boundary. */
} plumb_plane_set_info;
#define PLUMB_PLANE_SET_INFO_INIT \
  { sizeof(plumb_plane_set_info), 0, 0, 0, 0, 0, false, false, false, false, false }
/** Fills `info`. O(n). */
PLUMB_API plumb_status plumb_plane_set_describe(const plumb_plane_set* set,
                                                plumb_plane_set_info* info, plumb_error** error);
/** Sets inside[i] to whether point i belongs to the set. `xy` has 2 * count doubles. */
PLUMB_API plumb_status plumb_plane_set_contains(const plumb_plane_set* set, const double* xy,
                                                size_t count, bool* inside,
                                                const plumb_context* context, plumb_error** error);
/** Sets locations[i] to the cell that contains point i. `points` has two numbers for each, and
 * `locations` has `count` entries. */
PLUMB_API plumb_status plumb_plane_set_locate(const plumb_plane_set* set,
                                              const plumb_numbers* points,
                                              plumb_location* locations, size_t count,
                                              const plumb_context* context, plumb_error** error);
/** Finds the first cell on a ray of two numbers and two numbers; see plumb_solid_shoot(). */
PLUMB_API plumb_status plumb_plane_set_shoot(const plumb_plane_set* set, const plumb_numbers* ray,
                                             bool to_boundary, bool* is_hit,
                                             plumb_location* location, plumb_numbers** point,
                                             const plumb_context* context, plumb_error** error);
/** Returns the exact area, one number; none if it is infinite. */
PLUMB_API plumb_status plumb_plane_set_area(const plumb_plane_set* set, plumb_numbers** out,
                                            const plumb_context* context, plumb_error** error);
/** Whether the set is convex. `reflex_corners` and `parts`, the number of connected components, may
 * be null. */
PLUMB_API plumb_status plumb_plane_set_convexity(const plumb_plane_set* set, bool* is_convex,
                                                 uint64_t* reflex_corners, uint64_t* parts,
                                                 const plumb_context* context, plumb_error** error);

/** The closure of a set as polygons, lines and points in arrays. */
typedef struct plumb_shapes plumb_shapes;
/** Lists the bounded parts of the closure of a set. Coordinates that are no doubles are exact in
 * plumb_shapes_exact_point() and rounded in plumb_shapes_points(); after plumb_plane_set_round()
 * all are doubles. */
PLUMB_API plumb_status plumb_plane_set_shapes(const plumb_plane_set* set, plumb_shapes** out,
                                              const plumb_context* context, plumb_error** error);
PLUMB_API size_t plumb_shapes_point_count(const plumb_shapes* shapes);   /**< Points. */
PLUMB_API size_t plumb_shapes_polygon_count(const plumb_shapes* shapes); /**< Polygons. */
PLUMB_API size_t plumb_shapes_ring_count(const plumb_shapes* shapes);    /**< Rings of them all. */
PLUMB_API size_t plumb_shapes_line_count(const plumb_shapes* shapes);    /**< Lines. */
PLUMB_API size_t plumb_shapes_single_count(const plumb_shapes* shapes);  /**< Isolated points. */
/** Returns 2 * plumb_shapes_point_count() coordinates, rounded to the nearest doubles. */
PLUMB_API const double* plumb_shapes_points(const plumb_shapes* shapes);
/** Returns the first ring of each polygon, and the number of rings. The outer ring comes first and
 * runs counter-clockwise. */
PLUMB_API const uint32_t* plumb_shapes_polygon_begin(const plumb_shapes* shapes);
/** Returns the offset of each ring in plumb_shapes_ring_corners(), and the number of corners. */
PLUMB_API const uint32_t* plumb_shapes_ring_begin(const plumb_shapes* shapes);
/** Returns the corners of all rings, which are indices of points. */
PLUMB_API const uint32_t* plumb_shapes_ring_corners(const plumb_shapes* shapes);
/** Returns the offset of each line in plumb_shapes_line_corners(), and the number of corners. */
PLUMB_API const uint32_t* plumb_shapes_line_begin(const plumb_shapes* shapes);
/** Returns the corners of all lines, which are indices of points. */
PLUMB_API const uint32_t* plumb_shapes_line_corners(const plumb_shapes* shapes);
/** Returns the isolated points. */
PLUMB_API const uint32_t* plumb_shapes_singles(const plumb_shapes* shapes);
/** Returns the two exact coordinates of a point. */
PLUMB_API plumb_status plumb_shapes_exact_point(const plumb_shapes* shapes, size_t point,
                                                plumb_numbers** out, plumb_error** error);
PLUMB_API void plumb_shapes_free(plumb_shapes* shapes); /**< Releases the arrays. */

/** A list of sets of the plane. */
typedef struct plumb_plane_set_list plumb_plane_set_list;
/** How plumb_plane_set_decompose() cuts. */
enum plumb_partition {
  PLUMB_PARTITION_BEST = 0,      /**< The method that gives the fewest pieces. */
  PLUMB_PARTITION_CUTS = 1,      /**< Prolongs sides at reflex corners. */
  PLUMB_PARTITION_DIAGONALS = 2, /**< Between vertices; bounded faces only. */
  PLUMB_PARTITION_OPTIMAL = 3    /**< The fewest that diagonals can make; simple faces only. */
};
/** Cuts the set into convex pieces; see plumb_solid_decompose(). */
PLUMB_API plumb_status plumb_plane_set_decompose(const plumb_plane_set* set, int method,
                                                 bool is_closed, plumb_plane_set_list** out,
                                                 const plumb_context* context, plumb_error** error);
/** Returns the number of sets. */
PLUMB_API size_t plumb_plane_set_list_count(const plumb_plane_set_list* list);
/** Returns set i, which the list owns. */
PLUMB_API const plumb_plane_set* plumb_plane_set_list_at(const plumb_plane_set_list* list,
                                                         size_t i);
PLUMB_API void plumb_plane_set_list_free(plumb_plane_set_list* list); /**< Releases all of it. */

/* ---- sets of the sphere --------------------------------------------------------------------- */

/** A set of directions. A direction is a vector of three numbers, not all 0; its length has no
 * meaning. */
typedef struct plumb_sphere_set plumb_sphere_set;

/** Makes the set without directions. */
PLUMB_API plumb_status plumb_sphere_set_empty(plumb_sphere_set** out, plumb_error** error);
/** Makes the whole sphere. */
PLUMB_API plumb_status plumb_sphere_set_whole(plumb_sphere_set** out, plumb_error** error);
/** Makes another handle of the same set. O(1). */
PLUMB_API plumb_status plumb_sphere_set_copy(const plumb_sphere_set* set, plumb_sphere_set** out,
                                             plumb_error** error);
PLUMB_API void plumb_sphere_set_free(plumb_sphere_set* set); /**< Releases a set. */
/** Makes the intersection of the half-spheres around directions, of three numbers each: open half
 * spheres, or closed ones. */
PLUMB_API plumb_status plumb_sphere_set_half_spheres(const plumb_numbers* normals, bool is_closed,
                                                     plumb_sphere_set** out,
                                                     const plumb_context* context,
                                                     plumb_error** error);
/** Makes the great circle around a direction. */
PLUMB_API plumb_status plumb_sphere_set_circle(const plumb_numbers* normal, plumb_sphere_set** out,
                                               plumb_error** error);
/** Makes the region to the left of the closed chain of shortest arcs between corners. */
PLUMB_API plumb_status plumb_sphere_set_polygon(const plumb_numbers* corners, bool is_closed,
                                                plumb_sphere_set** out, plumb_error** error);
/** Makes the shortest arc between two directions, of six numbers. */
PLUMB_API plumb_status plumb_sphere_set_arc(const plumb_numbers* ends, bool is_closed,
                                            plumb_sphere_set** out, plumb_error** error);
/** Makes a set of directions. */
PLUMB_API plumb_status plumb_sphere_set_points(const plumb_numbers* directions,
                                               plumb_sphere_set** out, const plumb_context* context,
                                               plumb_error** error);
/** Makes the set of an operation of two sets; see plumb_operation. */
PLUMB_API plumb_status plumb_sphere_set_combine(const plumb_sphere_set* a,
                                                const plumb_sphere_set* b, int operation,
                                                plumb_sphere_set** out,
                                                const plumb_context* context, plumb_error** error);
/** Makes the union. */
PLUMB_API plumb_status plumb_sphere_set_union(const plumb_sphere_set* a, const plumb_sphere_set* b,
                                              plumb_sphere_set** out, const plumb_context* context,
                                              plumb_error** error);
/** Makes the intersection. */
PLUMB_API plumb_status plumb_sphere_set_intersection(const plumb_sphere_set* a,
                                                     const plumb_sphere_set* b,
                                                     plumb_sphere_set** out,
                                                     const plumb_context* context,
                                                     plumb_error** error);
/** Makes the set of what is in a but not in b. */
PLUMB_API plumb_status plumb_sphere_set_difference(const plumb_sphere_set* a,
                                                   const plumb_sphere_set* b,
                                                   plumb_sphere_set** out,
                                                   const plumb_context* context,
                                                   plumb_error** error);
/** Makes the set of what is in exactly one of a and b. */
PLUMB_API plumb_status plumb_sphere_set_symmetric_difference(const plumb_sphere_set* a,
                                                             const plumb_sphere_set* b,
                                                             plumb_sphere_set** out,
                                                             const plumb_context* context,
                                                             plumb_error** error);
/** Makes the union of any number of sets; of none: the empty set. */
PLUMB_API plumb_status plumb_sphere_set_union_of(const plumb_sphere_set* const* sets, size_t count,
                                                 plumb_sphere_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** Makes the intersection of any number of sets; of none: the sphere. */
PLUMB_API plumb_status plumb_sphere_set_intersection_of(const plumb_sphere_set* const* sets,
                                                        size_t count, plumb_sphere_set** out,
                                                        const plumb_context* context,
                                                        plumb_error** error);
/** Makes the complement. */
PLUMB_API plumb_status plumb_sphere_set_complement(const plumb_sphere_set* set,
                                                   plumb_sphere_set** out,
                                                   const plumb_context* context,
                                                   plumb_error** error);
/** Makes the set without its boundary. */
PLUMB_API plumb_status plumb_sphere_set_interior(const plumb_sphere_set* set,
                                                 plumb_sphere_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** Makes the set with its boundary. */
PLUMB_API plumb_status plumb_sphere_set_closure(const plumb_sphere_set* set, plumb_sphere_set** out,
                                                const plumb_context* context, plumb_error** error);
/** Makes the boundary. */
PLUMB_API plumb_status plumb_sphere_set_boundary(const plumb_sphere_set* set,
                                                 plumb_sphere_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** Makes the interior of the complement. */
PLUMB_API plumb_status plumb_sphere_set_exterior(const plumb_sphere_set* set,
                                                 plumb_sphere_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** Makes the closure of the interior. */
PLUMB_API plumb_status plumb_sphere_set_regularization(const plumb_sphere_set* set,
                                                       plumb_sphere_set** out,
                                                       const plumb_context* context,
                                                       plumb_error** error);
PLUMB_API bool plumb_sphere_set_is_empty(
    const plumb_sphere_set* set); /**< Whether the set is empty. O(1). */
PLUMB_API bool plumb_sphere_set_is_whole(
    const plumb_sphere_set* set); /**< Whether it is the sphere. O(1). */
/** Whether both are the same set. */
PLUMB_API plumb_status plumb_sphere_set_equals(const plumb_sphere_set* a, const plumb_sphere_set* b,
                                               bool* out, plumb_error** error);
/** Whether all of a is in b. */
PLUMB_API plumb_status plumb_sphere_set_is_subset(const plumb_sphere_set* a,
                                                  const plumb_sphere_set* b, bool* out,
                                                  const plumb_context* context,
                                                  plumb_error** error);
/** Checks every invariant from scratch; see plumb_solid_audit(). */
PLUMB_API plumb_status plumb_sphere_set_audit(const plumb_sphere_set* set, plumb_bytes** flaw,
                                              const plumb_context* context, plumb_error** error);
/** Facts about a set of the sphere. */
typedef struct plumb_sphere_set_info {
  size_t struct_size;  /**< sizeof(plumb_sphere_set_info). */
  size_t points;       /**< Ends of arcs, and isolated points. */
  size_t arcs;         /**< Arcs and circles. */
  size_t faces;        /**< Faces. */
  size_t marked_faces; /**< Faces that belong to the set. */
  size_t bytes;        /**< Memory; copies share it. */
  bool is_empty;       /**< Whether there is no direction. */
  bool is_whole;       /**< Whether it is the sphere. */
  bool is_closed;      /**< Whether it contains its boundary. */
  bool is_open;        /**< Whether it contains no point of its boundary. */
} plumb_sphere_set_info;
#define PLUMB_SPHERE_SET_INFO_INIT \
  { sizeof(plumb_sphere_set_info), 0, 0, 0, 0, 0, false, false, false, false }
/** Fills `info`. O(n). */
PLUMB_API plumb_status plumb_sphere_set_describe(const plumb_sphere_set* set,
                                                 plumb_sphere_set_info* info, plumb_error** error);
/** Sets locations[i] to the cell that contains direction i: a point (dimension 0), arc (1) or face
 * (2). `directions` has three numbers for each, and `locations` has `count` entries. */
PLUMB_API plumb_status plumb_sphere_set_locate(const plumb_sphere_set* set,
                                               const plumb_numbers* directions,
                                               plumb_location* locations, size_t count,
                                               const plumb_context* context, plumb_error** error);
/** Walks along a great circle from a direction the shorter way to another one, of six numbers, and
 * on. Finds the first cell that belongs to the set; see plumb_solid_shoot(). */
PLUMB_API plumb_status plumb_sphere_set_shoot(const plumb_sphere_set* set,
                                              const plumb_numbers* walk, bool to_boundary,
                                              bool* is_hit, plumb_location* location,
                                              plumb_numbers** point, const plumb_context* context,
                                              plumb_error** error);

/* ---- maps ----------------------------------------------------------------------------------- */

/** Points, and cycles of indices of points, as a user lists them: perhaps a planar subdivision. */
typedef struct plumb_map plumb_map;

/** Makes a map. Cycle c has the corners corners[cycle_begin[c]] to corners[cycle_begin[c + 1] - 1];
 * cycle_begin has cycle_count + 1 entries, from 0 to corner_count. */
PLUMB_API plumb_status plumb_map_from_cycles(const double* xy, size_t point_count,
                                             const uint32_t* cycle_begin, size_t cycle_count,
                                             const uint32_t* corners, size_t corner_count,
                                             plumb_map** out, plumb_error** error);
/** Makes a map of exact points, two numbers for each. The other arrays are the same. */
PLUMB_API plumb_status plumb_map_from_exact_cycles(const plumb_numbers* points,
                                                   const uint32_t* cycle_begin, size_t cycle_count,
                                                   const uint32_t* corners, size_t corner_count,
                                                   plumb_map** out, plumb_error** error);
/** Reads the text of a map from memory. */
PLUMB_API plumb_status plumb_map_read(const char* text, size_t size,
                                      const plumb_read_options* options, plumb_map** out,
                                      const plumb_context* context, plumb_error** error);
/** Reads a file: a map, or polygons in WKT, GeoJSON or WKB that cover an area. *is_polygons tells
 * which; it and `notes` may be null. Maps of polygons lack outer boundaries:
 * PLUMB_OUTER_INFER. */
PLUMB_API plumb_status plumb_map_read_file(const char* path, const plumb_read_options* options,
                                           plumb_map** out, bool* is_polygons, plumb_notes** notes,
                                           const plumb_context* context, plumb_error** error);
/** Writes the text of a map, without loss. */
PLUMB_API plumb_status plumb_map_write(const plumb_map* map, plumb_bytes** out,
                                       plumb_error** error);
PLUMB_API size_t plumb_map_point_count(const plumb_map* map);   /**< Returns the points. */
PLUMB_API size_t plumb_map_cycle_count(const plumb_map* map);   /**< Returns the cycles. */
PLUMB_API const double* plumb_map_points(const plumb_map* map); /**< Rounded coordinates x y. */
PLUMB_API const uint32_t* plumb_map_cycle_begin(const plumb_map* map); /**< Offsets of cycles. */
PLUMB_API const uint32_t* plumb_map_corners(const plumb_map* map);     /**< Corners of all. */
PLUMB_API void plumb_map_free(plumb_map* map);                         /**< Releases a map. */

/** What is required of outer boundaries of components. */
enum plumb_outer {
  PLUMB_OUTER_LISTED = 0, /**< They are listed, clockwise. */
  PLUMB_OUTER_INFER = 1,  /**< Those that are missing are added. */
  PLUMB_OUTER_IGNORE = 2  /**< They may be missing. */
};
/** How a map is checked. */
typedef struct plumb_map_options {
  size_t struct_size;   /**< sizeof(plumb_map_options). */
  int outer;            /**< A constant of plumb_outer. */
  bool merge_vertices;  /**< Whether vertices with equal coordinates become one first. */
  bool name_places;     /**< Whether hints name vertices by coordinates instead of numbers. */
  uint64_t max_defects; /**< The greatest number of defects that are described. */
} plumb_map_options;
#define PLUMB_MAP_OPTIONS_INIT \
  { sizeof(plumb_map_options), 0, false, false, 1000 }
/** The verdict on a map. */
enum plumb_verdict {
  PLUMB_MAP_VALID = 0,      /**< A planar subdivision. */
  PLUMB_MAP_NOT_PLANAR = 1, /**< A directed edge is used twice. */
  PLUMB_MAP_OPEN = 2,       /**< An edge lacks its other side. */
  PLUMB_MAP_SUPERPOSED = 3  /**< Edges cross, or regions overlap. */
};
/** The kinds of defects. */
enum plumb_defect_kind {
  PLUMB_DEFECT_DUPLICATE = 0, /**< A directed edge is used more than once. */
  PLUMB_DEFECT_OPEN = 1,      /**< A directed edge lacks its twin. */
  PLUMB_DEFECT_CROSSING = 2,  /**< Two edges share a point that is no common vertex. */
  PLUMB_DEFECT_TWIN = 3,      /**< A cycle uses an edge in both directions. */
  PLUMB_DEFECT_MIXED = 4,     /**< A face is not bounded by the listed cycles as required. */
  PLUMB_DEFECT_NESTED = 5     /**< A component inside a face lacks its outer boundary. */
};
/** The result of a check. */
typedef struct plumb_map_report plumb_map_report;
/** Decides exactly whether a map is a planar subdivision. A defective map is a result, not an
 * error. */
PLUMB_API plumb_status plumb_map_check(const plumb_map* map, const plumb_map_options* options,
                                       plumb_map_report** out, const plumb_context* context,
                                       plumb_error** error);
/** Counts of a report. */
typedef struct plumb_map_counts {
  size_t struct_size; /**< sizeof(plumb_map_counts). */
  int verdict;        /**< A constant of plumb_verdict. */
  size_t vertices;    /**< Listed vertices. */
  size_t edges;       /**< Undirected edges. */
  size_t cycles;      /**< Cycles, with those that were added. */
  size_t components;  /**< Connected components. */
  size_t regions;     /**< Regions of a valid map, with the unbounded one; else 0. */
  uint64_t duplicate; /**< Defects of each kind, described or not. */
  uint64_t open;      /**< See above. */
  uint64_t crossing;  /**< See above. */
  uint64_t twin;      /**< See above. */
  uint64_t mixed;     /**< See above; only known if the first three are 0. */
  uint64_t nested;    /**< See above. */
} plumb_map_counts;
#define PLUMB_MAP_COUNTS_INIT \
  { sizeof(plumb_map_counts), 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
/** Fills `counts`. */
PLUMB_API plumb_status plumb_map_report_count(const plumb_map_report* report,
                                              plumb_map_counts* counts, plumb_error** error);
/** Returns the verdict; PLUMB_MAP_VALID for a null pointer. */
PLUMB_API int plumb_map_report_verdict(const plumb_map_report* report);
/** A described defect. The report owns the arrays and texts. */
typedef struct plumb_map_defect {
  size_t struct_size;     /**< sizeof(plumb_map_defect). */
  int kind;               /**< A constant of plumb_defect_kind. */
  const uint32_t* cycles; /**< The cycles at which it occurs. */
  size_t cycle_count;     /**< Their number. */
  const uint32_t* edges;  /**< The edges at which it occurs: pairs of vertices. */
  size_t edge_count;      /**< Their number. */
  const char* x;          /**< The exact place as "p/q"; null if it has none. */
  const char* y;          /**< The same. */
  double near_x;          /**< The nearest double of x. */
  double near_y;          /**< The same. */
  const char* hint;       /**< What is wrong and how to correct it. */
} plumb_map_defect;
#define PLUMB_MAP_DEFECT_INIT \
  { sizeof(plumb_map_defect), 0, NULL, 0, NULL, 0, NULL, NULL, 0, 0, NULL }
PLUMB_API size_t plumb_map_report_defect_count(const plumb_map_report* report); /**< Described. */
/** Fills `defect` with defect i. */
PLUMB_API plumb_status plumb_map_report_defect(const plumb_map_report* report, size_t i,
                                               plumb_map_defect* defect, plumb_error** error);
/** Returns the warnings, which the report owns: things that are unusual but no defects. */
PLUMB_API const plumb_notes* plumb_map_report_warnings(const plumb_map_report* report);
/** Returns the cycles that bound region i of a valid map: the outer one first, if i > 0, then the
 * holes. `count` receives their number. */
PLUMB_API const uint32_t* plumb_map_report_region(const plumb_map_report* report, size_t i,
                                                  size_t* count);
/** Writes the report as "text", "json", "geojson", "svg", "html", "glb" or "png". `title` is for
 * pictures and may be null. */
PLUMB_API plumb_status plumb_map_report_write(const plumb_map_report* report, const char* format,
                                              const char* title, plumb_bytes** out,
                                              plumb_error** error);
/** Makes the map as it was checked, after vertices were merged and cycles were added. */
PLUMB_API plumb_status plumb_map_report_map(const plumb_map_report* report, plumb_map** out,
                                            plumb_error** error);
/** Makes the set of the regions of a valid map whose entry in `chosen` is true. `chosen` has an
 * entry for each region. */
PLUMB_API plumb_status plumb_map_report_to_set(const plumb_map_report* report, const bool* chosen,
                                               size_t count, bool is_closed, plumb_plane_set** out,
                                               const plumb_context* context, plumb_error** error);
PLUMB_API void plumb_map_report_free(plumb_map_report* report); /**< Releases a report. */

/** A planar subdivision as a half-edge structure. The half-edges 2 e and 2 e + 1 are twins. */
typedef struct plumb_dcel plumb_dcel;
/** Makes the structure of a valid map. Face f is region f. */
PLUMB_API plumb_status plumb_map_report_dcel(const plumb_map_report* report, plumb_dcel** out,
                                             plumb_error** error);
PLUMB_API size_t plumb_dcel_vertex_count(const plumb_dcel* dcel);   /**< Returns the vertices. */
PLUMB_API size_t plumb_dcel_halfedge_count(const plumb_dcel* dcel); /**< Returns the half-edges. */
PLUMB_API size_t plumb_dcel_face_count(const plumb_dcel* dcel);     /**< Returns the faces. */
PLUMB_API const double* plumb_dcel_points(const plumb_dcel* dcel);  /**< Rounded x y of vertices. */
PLUMB_API const uint32_t* plumb_dcel_origin(const plumb_dcel* dcel); /**< Start of half-edges. */
PLUMB_API const uint32_t* plumb_dcel_next(const plumb_dcel* dcel);   /**< Next around the face. */
PLUMB_API const uint32_t* plumb_dcel_prev(const plumb_dcel* dcel); /**< Previous around the face. */
PLUMB_API const uint32_t* plumb_dcel_face(const plumb_dcel* dcel); /**< Face on the left. */
/** Returns a half-edge that leaves each vertex; UINT32_MAX at isolated vertices. */
PLUMB_API const uint32_t* plumb_dcel_leaving(const plumb_dcel* dcel);
PLUMB_API void plumb_dcel_free(plumb_dcel* dcel); /**< Releases a structure. */

/** The subdivision of the plane by the edges of two valid maps. */
typedef struct plumb_overlay plumb_overlay;
/** Overlays two valid maps exactly. The reports may be released afterwards. */
PLUMB_API plumb_status plumb_overlay_new(const plumb_map_report* first,
                                         const plumb_map_report* second, plumb_overlay** out,
                                         const plumb_context* context, plumb_error** error);
PLUMB_API size_t plumb_overlay_face_count(const plumb_overlay* overlay); /**< Returns the faces. */
/** Returns the region of the first map, and that of the second map, that contain each face. */
PLUMB_API const uint32_t* plumb_overlay_regions(const plumb_overlay* overlay);
/** Returns the exact areas of all faces; 0 for unbounded ones. */
PLUMB_API plumb_status plumb_overlay_areas(const plumb_overlay* overlay, plumb_numbers** out,
                                           plumb_error** error);
/** Makes the half-edge structure of the overlay, with the same faces. */
PLUMB_API plumb_status plumb_overlay_dcel(const plumb_overlay* overlay, plumb_dcel** out,
                                          plumb_error** error);
/** Writes the overlay as "text", "json", "geojson", "svg" or "html". `options` is for GeoJSON. */
PLUMB_API plumb_status plumb_overlay_write(const plumb_overlay* overlay, const char* format,
                                           const plumb_write_options* options, const char* title,
                                           plumb_bytes** out, const plumb_context* context,
                                           plumb_error** error);
PLUMB_API void plumb_overlay_free(plumb_overlay* overlay); /**< Releases an overlay. */

/* ---- surfaces ------------------------------------------------------------------------------- */

/** Polygons on a triangle mesh, before the surface is divided. A scene can be changed. */
typedef struct plumb_scene plumb_scene;

/** Makes a scene without polygons on an orientable 2-manifold of triangles; see
 * plumb_mesh_from_triangles(). */
PLUMB_API plumb_status plumb_scene_new(const double* xyz, size_t point_count,
                                       const uint32_t* triangles, size_t triangle_count,
                                       plumb_scene** out, plumb_error** error);
/** Reads a scene file with its mesh and its drawings. */
PLUMB_API plumb_status plumb_scene_read_file(const char* path, const plumb_read_options* options,
                                             plumb_scene** out, plumb_notes** notes,
                                             const plumb_context* context, plumb_error** error);
/** Writes the scene as JSON. `model` is the path of its mesh, as a reader shall find it. */
PLUMB_API plumb_status plumb_scene_write(const plumb_scene* scene, const char* model,
                                         plumb_bytes** out, plumb_error** error);
/** Adds a point with the weights u, v of the second and third corner of a face. Weights are the
 * two numbers of `weights`. *index receives its index. */
PLUMB_API plumb_status plumb_scene_add_point(plumb_scene* scene, uint32_t face,
                                             const plumb_numbers* weights, uint32_t* index,
                                             plumb_error** error);
/** Adds the closed polygon through points, which are joined by geodesics. Fails with
 * PLUMB_BAD_SHAPE if no path joins two of them. *index receives its index. */
PLUMB_API plumb_status plumb_scene_add_polygon(plumb_scene* scene, const uint32_t* points,
                                               size_t count, uint32_t* index,
                                               const plumb_context* context, plumb_error** error);
/** Adds the shape that is the sum of polygons. Without shapes, each polygon is one. */
PLUMB_API plumb_status plumb_scene_add_shape(plumb_scene* scene, const uint32_t* polygons,
                                             size_t count, uint32_t* index, plumb_error** error);
/** Sets the face at whose first corner all labels are 0. */
PLUMB_API plumb_status plumb_scene_set_outside(plumb_scene* scene, uint32_t face,
                                               plumb_error** error);
/** Adds loops around handles to shapes that do not separate the surface, so that they do. *added
 * receives their number, and may be null. */
PLUMB_API plumb_status plumb_scene_separate(plumb_scene* scene, size_t* added,
                                            const plumb_context* context, plumb_error** error);
/** A polyline on a surface. */
typedef struct plumb_path plumb_path;
/** Which path is traced. */
typedef enum plumb_path_choice {
  PLUMB_PATH_LOCAL = 0,   /**< A locally shortest path, which is found fast. */
  PLUMB_PATH_SHORTEST = 1 /**< No other path is shorter by more than 2^-40 of its length. */
} plumb_path_choice;
/** Traces a geodesic between two points of the scene. A path between different components has no
 * points. */
PLUMB_API plumb_status plumb_scene_trace(const plumb_scene* scene, uint32_t from, uint32_t to,
                                         plumb_path_choice choice, plumb_path** out,
                                         const plumb_context* context, plumb_error** error);
PLUMB_API size_t plumb_path_count(const plumb_path* path); /**< Returns the number of points. */
PLUMB_API const double* plumb_path_points(const plumb_path* path); /**< Rounded coordinates. */
/** Returns the face of each segment, one fewer than points. */
PLUMB_API const uint32_t* plumb_path_faces(const plumb_path* path);
PLUMB_API double plumb_path_length(const plumb_path* path); /**< Returns the rounded length. */
PLUMB_API void plumb_path_free(plumb_path* path);           /**< Releases a path. */
PLUMB_API size_t plumb_scene_polygon_count(const plumb_scene* scene); /**< Polygons. */
PLUMB_API void plumb_scene_free(plumb_scene* scene);                  /**< Releases a scene. */

/** A surface that polygons divide into cells. */
typedef struct plumb_surface plumb_surface;
/** How often a shape winds around a cell. */
typedef struct plumb_label {
  uint32_t shape; /**< The shape. */
  int32_t value;  /**< Not 0. */
} plumb_label;
/** Divides the surface of a scene. */
PLUMB_API plumb_status plumb_surface_divide(const plumb_scene* scene, plumb_surface** out,
                                            const plumb_context* context, plumb_error** error);
/** Counts of a surface. */
typedef struct plumb_surface_info {
  size_t struct_size; /**< sizeof(plumb_surface_info). */
  size_t triangles;   /**< Faces of the mesh. */
  size_t segments;    /**< Segments of polygons. */
  size_t crossings;   /**< Points where polygons meet. */
  size_t cells;       /**< Cells. */
  size_t cell_edges;  /**< Pairs of neighbouring cells. */
  size_t shapes;      /**< Shapes. */
} plumb_surface_info;
#define PLUMB_SURFACE_INFO_INIT \
  { sizeof(plumb_surface_info), 0, 0, 0, 0, 0, 0 }
/** Fills `info`. */
PLUMB_API plumb_status plumb_surface_describe(const plumb_surface* surface,
                                              plumb_surface_info* info, plumb_error** error);
/** Returns the labels of a cell, ascending by shape, and their number through `count`. */
PLUMB_API const plumb_label* plumb_surface_labels(const plumb_surface* surface, size_t cell,
                                                  size_t* count);
/** Returns the rounded area of a cell. */
PLUMB_API double plumb_surface_area(const plumb_surface* surface, size_t cell);
/** Returns pairs of neighbouring cells, and the number of pairs through `count`. */
PLUMB_API const uint32_t* plumb_surface_neighbours(const plumb_surface* surface, size_t* count);
/** Whether a shape separates the surface: over the integers, and modulo 2. A shape that does not
 * has no labels. */
PLUMB_API plumb_status plumb_surface_separates(const plumb_surface* surface, size_t shape,
                                               bool* over_integers, bool* modulo_2,
                                               plumb_error** error);
/** Makes the triangles of the divided surface, and the cell of each. */
PLUMB_API plumb_status plumb_surface_triangulate(const plumb_surface* surface, plumb_mesh** out,
                                                 plumb_indices** cells,
                                                 const plumb_context* context, plumb_error** error);
/** Checks every invariant from scratch; see plumb_solid_audit(). */
PLUMB_API plumb_status plumb_surface_audit(const plumb_surface* surface, plumb_bytes** flaw,
                                           plumb_error** error);
PLUMB_API void plumb_surface_free(plumb_surface* surface); /**< Releases a surface. */

/** Cells of a surface that an expression selects, and the polygons around them. */
typedef struct plumb_region plumb_region;
/** Selects the cells for which an expression such as "A * !B" holds. Shapes are called A, B, C, ...
 * or s0, s1, ... `rule` says which labels are inside; the default is the odd ones. */
PLUMB_API plumb_status plumb_surface_evaluate(const plumb_surface* surface, const char* expression,
                                              int rule, plumb_region** out,
                                              const plumb_context* context, plumb_error** error);
PLUMB_API size_t plumb_region_cell_count(const plumb_region* region); /**< Selected cells. */
PLUMB_API size_t plumb_region_loop_count(const plumb_region* region); /**< Polygons around them. */
PLUMB_API double plumb_region_area(const plumb_region* region);       /**< Their rounded area. */
PLUMB_API bool plumb_region_has(const plumb_region* region, size_t cell); /**< Is it selected? */
/** Makes a scene of one shape, the region, for further operations. */
PLUMB_API plumb_status plumb_region_to_scene(const plumb_region* region, plumb_scene** out,
                                             plumb_error** error);
PLUMB_API void plumb_region_free(plumb_region* region); /**< Releases a region. */

/** Writes the triangles of cells as "obj", "ply" or "glb", or their graph as "dot". `region` may be
 * null: all cells. It must be one of this surface. */
PLUMB_API plumb_status plumb_surface_write(const plumb_surface* surface, const plumb_region* region,
                                           const char* format, plumb_bytes** out,
                                           const plumb_context* context, plumb_error** error);
/** Draws a layer, "polygons", "slices", "cells", "labels" or "result", as "html", "svg", "glb" or
 * "png". The layer "result" needs a region; `title` may be null. */
PLUMB_API plumb_status plumb_surface_draw(const plumb_surface* surface, const plumb_region* region,
                                          const char* layer, const char* format, const char* title,
                                          plumb_bytes** out, const plumb_context* context,
                                          plumb_error** error);

/* ---- the environment ------------------------------------------------------------------------ */

/** Whether the arithmetic of this process is what exact predicates need. `notes` may be null;
 * warnings in it say what is wrong, notes what is unusual. */
PLUMB_API plumb_status plumb_self_test(bool* is_ok, plumb_notes** notes, plumb_error** error);

/* ---- models --------------------------------------------------------------------------------- */

/** Makes the closed box with these side lengths, from the origin or around it. */
PLUMB_API plumb_status plumb_solid_box(const double size[3], bool is_centred, plumb_solid** out,
                                       const plumb_context* context, plumb_error** error);
/** Makes a ball around the origin whose equator has `chords` corners. It is convex exactly. */
PLUMB_API plumb_status plumb_solid_sphere(double radius, uint32_t chords, plumb_solid** out,
                                          const plumb_context* context, plumb_error** error);
/** Makes a cylinder along the z-axis, or a cone or a frustum if the radii differ. */
PLUMB_API plumb_status plumb_solid_cylinder(double height, double bottom_radius, double top_radius,
                                            uint32_t chords, bool is_centred, plumb_solid** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes a torus around the z-axis; `radius` is that of the centre of the tube. */
PLUMB_API plumb_status plumb_solid_torus(double radius, double tube_radius, uint32_t chords,
                                         uint32_t tube_chords, plumb_solid** out,
                                         const plumb_context* context, plumb_error** error);
/** Makes the convex hull of points, exactly. `xyz` has 3 * count doubles. */
PLUMB_API plumb_status plumb_solid_hull(const double* xyz, size_t count, plumb_solid** out,
                                        const plumb_context* context, plumb_error** error);
/** Makes the convex hull of points of three exact numbers each. */
PLUMB_API plumb_status plumb_solid_hull_exact(const plumb_numbers* points, plumb_solid** out,
                                              const plumb_context* context, plumb_error** error);
/** Makes the convex hull of the closures of bounded solids together. */
PLUMB_API plumb_status plumb_solid_hull_of(const plumb_solid* const* solids, size_t count,
                                           plumb_solid** out, const plumb_context* context,
                                           plumb_error** error);
/** Makes the closed regular polygon in a circle around the origin. */
PLUMB_API plumb_status plumb_plane_set_disk(double radius, uint32_t chords, plumb_plane_set** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the convex hull of points of the plane. `xy` has 2 * count doubles. */
PLUMB_API plumb_status plumb_plane_set_hull(const double* xy, size_t count, plumb_plane_set** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the convex hull of points of two exact numbers each. */
PLUMB_API plumb_status plumb_plane_set_hull_exact(const plumb_numbers* points,
                                                  plumb_plane_set** out,
                                                  const plumb_context* context,
                                                  plumb_error** error);
/** Makes the convex hull of the closures of bounded sets together. */
PLUMB_API plumb_status plumb_plane_set_hull_of(const plumb_plane_set* const* sets, size_t count,
                                               plumb_plane_set** out, const plumb_context* context,
                                               plumb_error** error);

/** How plumb_plane_set_extrude() sweeps. */
typedef struct plumb_extrusion {
  size_t struct_size; /**< sizeof(plumb_extrusion). */
  double height;      /**< The height; positive. */
  bool is_centred;    /**< Whether z runs from -height / 2 instead of 0. */
  double twist;       /**< The angle in degrees by which the top is turned clockwise. */
  uint32_t layers;    /**< Steps of equal height; at least 1. */
  double scale[2];    /**< Factors of x and y at the top. */
} plumb_extrusion;
#define PLUMB_EXTRUSION_INIT                                  \
  {                                                           \
    sizeof(plumb_extrusion), 1.0, false, 0.0, 1, { 1.0, 1.0 } \
  }
/** Makes the closed solid between an outline at the bottom and its image at the top. */
PLUMB_API plumb_status plumb_plane_set_extrude(const plumb_plane_set* outline,
                                               const plumb_extrusion* options, plumb_solid** out,
                                               const plumb_context* context, plumb_error** error);
/** Makes the closed solid that an outline sweeps when it turns around the z-axis by an angle in
 * degrees, in equal steps. Its y-axis becomes the z-axis. */
PLUMB_API plumb_status plumb_plane_set_revolve(const plumb_plane_set* outline, double angle,
                                               uint32_t steps, plumb_solid** out,
                                               const plumb_context* context, plumb_error** error);
/** Makes, for each of the heights, the set of the points (x, y) for which (x, y, height) belongs to
 * the solid. */
PLUMB_API plumb_status plumb_solid_slices(const plumb_solid* solid, const plumb_numbers* heights,
                                          plumb_plane_set_list** out, const plumb_context* context,
                                          plumb_error** error);
/** Makes the closure of the projection of the solid along the z-axis. */
PLUMB_API plumb_status plumb_solid_shadow(const plumb_solid* solid, plumb_plane_set** out,
                                          const plumb_context* context, plumb_error** error);
/** Makes the closure of the solid, grown by a distance or shrunk by a negative one. An octahedron
 * whose faces are divided `rounds` times, at most 7, stands for the ball. */
PLUMB_API plumb_status plumb_solid_offset(const plumb_solid* solid, double distance,
                                          uint32_t rounds, plumb_solid** out,
                                          const plumb_context* context, plumb_error** error);
/** Finds nearest points of the closures of two solids. Returns seven numbers: the square of the
 * distance, the point of a, the point of b. Sets cells[0] and cells[1] to the cells of a and b with
 * these points; `cells` may be null. */
PLUMB_API plumb_status plumb_solid_distance(const plumb_solid* a, const plumb_solid* b,
                                            plumb_numbers** out, plumb_location cells[2],
                                            const plumb_context* context, plumb_error** error);
/** Makes the connected parts of the solid. */
PLUMB_API plumb_status plumb_solid_components(const plumb_solid* solid, plumb_solid_list** out,
                                              const plumb_context* context, plumb_error** error);
/** Sets *genus to the number of handles of the boundary. Sets *is_surface to false if the boundary
 * is no closed surface; then *genus is 0. */
PLUMB_API plumb_status plumb_solid_genus(const plumb_solid* solid, bool* is_surface,
                                         uint64_t* genus, plumb_error** error);
/** Returns six numbers: the least coordinates, then the greatest ones; none if the solid is
 * empty. */
PLUMB_API plumb_status plumb_solid_bounding_box(const plumb_solid* solid, plumb_numbers** out,
                                                plumb_error** error);

/** Returns the rotation about an axis through the origin, 12 numbers for plumb_solid_transform().
 * It is exactly orthogonal, and exact for multiples of 90 degrees about a coordinate axis. */
PLUMB_API plumb_status plumb_numbers_rotation(const double axis[3], double degrees,
                                              plumb_numbers** out, plumb_error** error);
/** Returns the scaling along the axes by three factors, 12 numbers. */
PLUMB_API plumb_status plumb_numbers_scaling(const plumb_numbers* factors, plumb_numbers** out,
                                             plumb_error** error);
/** Returns the reflection at the plane through the origin with a normal, 12 numbers. */
PLUMB_API plumb_status plumb_numbers_reflection(const plumb_numbers* normal, plumb_numbers** out,
                                                plumb_error** error);
/** Returns the scaling that gives the bounding box of a solid three sizes, 12 numbers. An axis with
 * the size 0 keeps its size, or gets the greatest factor of the others if `is_automatic` says so;
 * `is_automatic` may be null. */
PLUMB_API plumb_status plumb_numbers_resizing(const plumb_solid* solid, const plumb_numbers* size,
                                              const bool is_automatic[3], plumb_numbers** out,
                                              plumb_error** error);

/** The shape of an offset at a convex corner. */
enum plumb_join {
  PLUMB_JOIN_ROUND = 0,  /**< A polygon in the arc around the corner. */
  PLUMB_JOIN_MITRE = 1,  /**< The moved edges, prolonged; square beyond the mitre limit. */
  PLUMB_JOIN_SQUARE = 2, /**< Cut off at the distance from the corner. */
  PLUMB_JOIN_BEVEL = 3   /**< A segment between the ends of the moved edges. */
};
/** How plumb_plane_set_offset() treats corners. */
typedef struct plumb_offset_options {
  size_t struct_size;       /**< sizeof(plumb_offset_options). */
  int join;                 /**< A constant of plumb_join. */
  double mitre_limit;       /**< The greatest length of a mitre in distances; at least 1. */
  double chord_error;       /**< Of arcs; 0 stands for a thousandth of the distance. */
  uint32_t circle_segments; /**< Chords of a full circle; 0: chord_error decides. */
} plumb_offset_options;
#define PLUMB_OFFSET_OPTIONS_INIT \
  { sizeof(plumb_offset_options), 0, 2.0, 0.0, 0 }
/** Makes the closure of the set, grown by a distance or shrunk by a negative one. */
PLUMB_API plumb_status plumb_plane_set_offset(const plumb_plane_set* set, double distance,
                                              const plumb_offset_options* options,
                                              plumb_plane_set** out, const plumb_context* context,
                                              plumb_error** error);
/** Makes the closure of a bounded set with fewer corners. Corners are removed while their triangle
 * has at most the area `tolerance`, while more than the part `kept` of the corners is left, and while
 * no point of a border moves farther than `within`. Infinity sets no bound. Coordinates become
 * doubles. If `moved` is not null, it receives a bound for how far borders have moved. */
PLUMB_API plumb_status plumb_plane_set_simplify(const plumb_plane_set* set, double tolerance,
                                                double kept, double within, plumb_plane_set** out,
                                                double* moved, const plumb_context* context,
                                                plumb_error** error);
/** Finds nearest points of the closures of two sets. Returns five numbers: the square of the
 * distance, the point of a, the point of b. Sets cells[0] and cells[1] to the cells of a and b with
 * these points; `cells` may be null. */
PLUMB_API plumb_status plumb_plane_set_distance(const plumb_plane_set* a, const plumb_plane_set* b,
                                                plumb_numbers** out, plumb_location cells[2],
                                                const plumb_context* context, plumb_error** error);
/** Makes { a + b : a in A, b in B }. */
PLUMB_API plumb_status plumb_plane_set_minkowski_sum(const plumb_plane_set* a,
                                                     const plumb_plane_set* b,
                                                     plumb_plane_set** out,
                                                     const plumb_context* context,
                                                     plumb_error** error);

/** Makes triangles that cover a bounded set after its coordinates were rounded to doubles: a
 * constrained Delaunay triangulation, as a mesh whose points have z = 0. */
PLUMB_API plumb_status plumb_plane_set_triangulate(const plumb_plane_set* set, plumb_mesh** out,
                                                   const plumb_context* context,
                                                   plumb_error** error);
/** Makes the Delaunay triangulation of points. `xy` has 2 * count doubles. The points of the mesh
 * are the points given, with z = 0. */
PLUMB_API plumb_status plumb_mesh_delaunay(const double* xy, size_t count, plumb_mesh** out,
                                           const plumb_context* context, plumb_error** error);

/** Where the files that a model of OpenSCAD imports may lie. */
enum plumb_imports {
  PLUMB_IMPORTS_BELOW = 0,   /**< In the folder of the model, or below it. */
  PLUMB_IMPORTS_NONE = 1,    /**< Nowhere: imports are refused. */
  PLUMB_IMPORTS_ANYWHERE = 2 /**< Anywhere. */
};
/** Evaluates a flattened model of OpenSCAD (.csg) in memory. *solid becomes its set of space, or
 * *set its set of the plane, and the other becomes null; both do if the model has no geometry.
 * The colours of a solid model are materials of its sources. */
PLUMB_API plumb_status plumb_csg_read(const char* bytes, size_t size,
                                      const plumb_read_options* options, int imports,
                                      plumb_solid** solid, plumb_plane_set** set,
                                      plumb_notes** notes, const plumb_context* context,
                                      plumb_error** error);
/** Does the same for a file. */
PLUMB_API plumb_status plumb_csg_read_file(const char* path, const plumb_read_options* options,
                                           int imports, plumb_solid** solid, plumb_plane_set** set,
                                           plumb_notes** notes, const plumb_context* context,
                                           plumb_error** error);

/* ---- layers --------------------------------------------------------------------------------- */

/** Features with ids, properties and polygons, such as countries. */
typedef struct plumb_layer plumb_layer;
/** Reads GeoJSON, TopoJSON, WKT or WKB. `object` names an object of TopoJSON; null: the first one. */
PLUMB_API plumb_status plumb_layer_read(const char* bytes, size_t size,
                                        const plumb_read_options* options, const char* object,
                                        plumb_layer** out, plumb_notes** notes,
                                        const plumb_context* context, plumb_error** error);
/** Reads a file; "-" is standard input. */
PLUMB_API plumb_status plumb_layer_read_file(const char* path, const char* object,
                                             plumb_layer** out, plumb_notes** notes,
                                             const plumb_context* context, plumb_error** error);
/** Makes the Voronoi cells of sites in a box. `xy` has 2 * count doubles, and `box` has the four
 * numbers x, y of its lower left and upper right corners. Feature i is the cell of site i. */
PLUMB_API plumb_status plumb_layer_voronoi(const double* xy, size_t count, const double box[4],
                                           plumb_layer** out, const plumb_context* context,
                                           plumb_error** error);
/** Makes a feature of each bounded face of a set, rounded to doubles. */
PLUMB_API plumb_status plumb_layer_of_faces(const plumb_plane_set* set, plumb_layer** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the parts of a set that come from the features of a layer, with their ids and properties.
 * Where several features cover a part, it belongs to the first one. Parts of the set that no feature
 * covers are the last feature, without an id. */
PLUMB_API plumb_status plumb_layer_parts(const plumb_layer* layer, const plumb_plane_set* set,
                                         plumb_layer** out, const plumb_context* context,
                                         plumb_error** error);
/** Makes a layer of the features of `first` and then those of `second`. */
PLUMB_API plumb_status plumb_layer_join(const plumb_layer* first, const plumb_layer* second,
                                        plumb_layer** out, const plumb_context* context,
                                        plumb_error** error);
/** Writes "geojson", "topojson" or "wkt". */
PLUMB_API plumb_status plumb_layer_write(const plumb_layer* layer, const char* format,
                                         plumb_bytes** out, const plumb_context* context,
                                         plumb_error** error);
/** Writes a file, which is complete or absent. `format` may be null: the extension chooses it. */
PLUMB_API plumb_status plumb_layer_write_file(const plumb_layer* layer, const char* path,
                                              const char* format, const plumb_context* context,
                                              plumb_error** error);
PLUMB_API size_t plumb_layer_feature_count(const plumb_layer* layer); /**< Returns the features. */
/** Makes the id of a feature, as a JSON text; empty if it has none. */
PLUMB_API plumb_status plumb_layer_id(const plumb_layer* layer, size_t feature, plumb_bytes** out,
                                      plumb_error** error);
/** Makes the properties of a feature, as a JSON text; empty if it has none. */
PLUMB_API plumb_status plumb_layer_properties(const plumb_layer* layer, size_t feature,
                                              plumb_bytes** out, plumb_error** error);
PLUMB_API void plumb_layer_free(plumb_layer* layer); /**< Releases a layer. */

/** Which feature gets an overlap or a gap. */
enum plumb_owner {
  PLUMB_OWNER_LONGEST_BORDER = 0, /**< The one with the longest common border with the region. */
  PLUMB_OWNER_LARGEST = 1,        /**< The one with the largest area. */
  PLUMB_OWNER_SMALLEST = 2,       /**< The one with the smallest area. */
  PLUMB_OWNER_FIRST = 3           /**< The one that comes first. */
};
/** The kinds of regions in a plumb_layer_report. */
enum plumb_layer_region_kind {
  PLUMB_LAYER_OVERLAP = 0, /**< Several features cover it. */
  PLUMB_LAYER_GAP = 1,     /**< No feature covers it, and it is narrow. */
  PLUMB_LAYER_HOLE = 2     /**< No feature covers it, and it is wide: no defect. */
};
/** What a repair has found. */
typedef struct plumb_layer_report plumb_layer_report;
/** Makes the layer without overlaps and gaps. `owner` is a constant of plumb_owner. An enclosed
 * region that no feature covers is a gap if it is narrower than `gaps_below`; a negative number
 * stands for 1/10000 of the diagonal of the layer, and leaves small lakes out. `report` may be
 * null. */
PLUMB_API plumb_status plumb_layer_repair(const plumb_layer* layer, int owner, double gaps_below,
                                          plumb_layer** out, plumb_layer_report** report,
                                          const plumb_context* context, plumb_error** error);
/** Makes the report of the overlaps, gaps and holes of a layer, without owners. */
PLUMB_API plumb_status plumb_layer_check(const plumb_layer* layer, double gaps_below,
                                         plumb_layer_report** out, const plumb_context* context,
                                         plumb_error** error);
/** Makes a layer with a feature for each group. groups[f] is the group of feature f, less than
 * group_count, or 0xffffffff: the feature is left out. `count` is the number of features. */
PLUMB_API plumb_status plumb_layer_dissolve(const plumb_layer* layer, const uint32_t* groups,
                                            size_t count, size_t group_count, plumb_layer** out,
                                            const plumb_context* context, plumb_error** error);
/** Which pairs plumb_layer_overlay() keeps. */
enum plumb_overlay_pairs {
  PLUMB_PAIRS_ALL = 0,       /**< What any of the layers covers. */
  PLUMB_PAIRS_FIRST = 1,     /**< What the first layer covers. */
  PLUMB_PAIRS_BOTH = 2,      /**< What both layers cover. */
  PLUMB_PAIRS_FIRST_ONLY = 3 /**< What the first layer covers and the second one does not. */
};
/** Makes a layer with a feature for each pair of features of two layers that have common points.
 * `pairs` receives the two features of each pair; 0xffffffff stands for a missing one. */
PLUMB_API plumb_status plumb_layer_overlay(const plumb_layer* first, const plumb_layer* second,
                                           int kept, plumb_layer** out, plumb_indices** pairs,
                                           const plumb_context* context, plumb_error** error);
/** Makes the layer with fewer corners on its borders; it stays a coverage. Corners are removed
 * while their triangle has at most the area `tolerance` (which may be infinite), and while more
 * than the part `kept` of the removable corners is left. */
PLUMB_API plumb_status plumb_layer_simplify(const plumb_layer* layer, double tolerance, double kept,
                                            plumb_layer** out, const plumb_context* context,
                                            plumb_error** error);
PLUMB_API size_t plumb_layer_report_count(const plumb_layer_report* report); /**< Its regions. */
/** Whether there were overlaps or gaps. */
PLUMB_API bool plumb_layer_report_has_defects(const plumb_layer_report* report);
/** Returns the kind of region i, a constant of plumb_layer_region_kind; -1 if there is none. */
PLUMB_API int plumb_layer_report_kind(const plumb_layer_report* report, size_t i);
/** Returns the exact area of region i, one number. */
PLUMB_API plumb_status plumb_layer_report_area(const plumb_layer_report* report, size_t i,
                                               plumb_numbers** out, plumb_error** error);
/** Returns twice the area divided by the perimeter of region i. */
PLUMB_API double plumb_layer_report_width(const plumb_layer_report* report, size_t i);
/** Returns the features of region i, and their number through `count`. */
PLUMB_API const uint32_t* plumb_layer_report_features(const plumb_layer_report* report, size_t i,
                                                      size_t* count);
/** Returns the feature that got region i; 0xffffffff if none did. */
PLUMB_API uint32_t plumb_layer_report_owner(const plumb_layer_report* report, size_t i);
/** Writes the report as "text", "json" or "geojson". `layer` is the layer before the repair. */
PLUMB_API plumb_status plumb_layer_report_write(const plumb_layer_report* report,
                                                const plumb_layer* layer, const char* format,
                                                plumb_bytes** out, const plumb_context* context,
                                                plumb_error** error);
PLUMB_API void plumb_layer_report_free(plumb_layer_report* report); /**< Releases a report. */

#ifdef __cplusplus
}
#endif

#endif
