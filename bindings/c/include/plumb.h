/* The C interface of plumb (C99, and C++). docs/c.md explains it with a complete example.
 *
 * Handles. Objects are opaque and are released by plumb_<type>_free(), which accepts a null
 * pointer. Sets and reports never change after they were made, so several threads may read one
 * object at the same time. Some functions change an object, for example by adding an attribute to a
 * mesh. Such a function takes a pointer to this object that is not const. During such a call, no
 * other thread may use the object.
 *
 * Results. A function that can fail returns a plumb_status: PLUMB_OK, or the reason of the failure.
 * A result is written through a pointer. If the function fails, a handle that it should have made
 * is a null pointer, and all other results have no meaning. A function without a status cannot
 * fail. If it gets a null pointer or an index out of range, it returns 0, false or a null pointer.
 *
 * Errors. The last parameter of a function that can fail is `plumb_error **error`. It may be null.
 * On failure it receives an error object with a message and, for texts, file, line and column. The
 * caller releases it by plumb_error_free(). On success it receives a null pointer. No C++ exception
 * leaves a function, and plumb never ends the process. (The library GMP ends the process if malloc
 * refuses memory for a number; see docs/c.md.)
 *
 * Contexts. The parameter `context` contains limits, the number of threads, the request to stop and
 * a progress callback. If it is null, nothing is limited. The limits apply to each call separately.
 *
 * Arrays. Functions read input arrays in place. The arrays are not needed after the call. A pointer
 * that a function returns is valid until the handle that owns the data is released. Sizes count
 * elements, not bytes, unless stated otherwise. An array of size 0 may be a null pointer.
 * Coordinates are stored x y z x y z ..., indices count from 0.
 *
 * Numbers. A double stands for its exact value. Fractions are passed as texts such as "1/3". The
 * type plumb_numbers is a list of exact numbers. If a double is not finite, a function returns
 * PLUMB_NOT_FINITE.
 *
 * Structs. The first member of most structs is struct_size. The caller sets it to the sizeof of the
 * struct that it was compiled with, so that later versions can append members. The macros
 * PLUMB_..._INIT set struct_size, and set the other members to their defaults. A pointer to options
 * may be null, which stands for the defaults.
 *
 * Stability. Within one PLUMB_ABI_VERSION, functions, constants and members of structs are never
 * removed or changed; new ones may be added. Texts of messages may change. */
#ifndef PLUMB_C_PLUMB_H
#define PLUMB_C_PLUMB_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(PLUMB_C_BUILDING)
#define PLUMB_API __declspec(dllexport)
#elif defined(__GNUC__) || defined(__clang__)
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

/** Returns the PLUMB_ABI_VERSION with which the library was compiled. A program can compare it with
 * the PLUMB_ABI_VERSION of this header. */
PLUMB_API int plumb_abi_version(void);
/** Returns the version of the library as text, such as "0.1.0". */
PLUMB_API const char* plumb_version(void);

/** PLUMB_OK, or one of the constants below. Later versions may add constants. */
typedef int plumb_status;
/** The values of plumb_status. The values 1xx concern texts and files, 2xx limits and cancellation,
 * 3xx arguments, and 4xx the process. */
enum plumb_status_code {
  PLUMB_OK = 0,                    /**< The function has done what it promises. */
  PLUMB_CANNOT_OPEN = 100,         /**< A file cannot be read. */
  PLUMB_CANNOT_WRITE = 101,        /**< A file cannot be written. */
  PLUMB_NOT_TEXT = 102,            /**< A byte of a text is not text. */
  PLUMB_SYNTAX = 103,              /**< A text does not follow the rules of its format. */
  PLUMB_NUMBER_OUT_OF_RANGE = 104, /**< A number is too long, or beyond the largest double. */
  PLUMB_COUNT_MISMATCH = 105,      /**< A count that a file states is wrong. */
  PLUMB_BAD_INDEX = 106,           /**< An index is out of range. */
  PLUMB_DEGENERATE_FACE = 107,     /**< A face has too few different corners. */
  PLUMB_UNKNOWN_FORMAT = 108,      /**< A format is unknown, or does not suit the purpose. */
  PLUMB_USAGE = 109,               /**< Options contradict each other. */
  PLUMB_CLOSED_PIPE = 110,         /**< The reader of the output closed the pipe; see docs/c.md. */
  PLUMB_BAD_SHAPE = 111,           /**< A mesh is open, a ring has too few corners, or the like. */
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

/** The reason why a function failed. */
typedef struct plumb_error plumb_error;

/** Returns the status that the function returned. */
PLUMB_API plumb_status plumb_error_status(const plumb_error* error);
/** Returns a sentence for a human reader, without the position. The result is null only if
 * `error` is null. */
PLUMB_API const char* plumb_error_message(const plumb_error* error);
/** Returns "FILE:LINE:COLUMN: MESSAGE", where unknown parts of the position are omitted. */
PLUMB_API const char* plumb_error_text(const plumb_error* error);
/** Returns the name of the text in which the error occurred; empty if it did not occur in a
 * text. */
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

/** A callback that receives the name of a phase, the number of steps done, and the total number of
 * steps (0 if unknown). It is called at most 20 times a second, on the thread that runs the
 * operation. The callback must return; it must not throw an exception or call longjmp(). It may
 * call plumb_context_cancel(). */
typedef void (*plumb_progress)(const char* phase, uint64_t done, uint64_t total, void* user_data);

/** Makes a context with the default limits: 16 GiB of memory, no time limit, numbers of at most
 * 1100 digits, and one thread. */
PLUMB_API plumb_status plumb_context_new(plumb_context** out, plumb_error** error);
/** Releases a context. No call may be using it. */
PLUMB_API void plumb_context_free(plumb_context* context);
/** Sets the greatest number of bytes of working memory that one call may use. plumb estimates the
 * working memory of a call. */
PLUMB_API plumb_status plumb_context_set_memory_limit(plumb_context* context, uint64_t bytes,
                                                      plumb_error** error);
/** Sets the time in seconds that one call may take. The value 0 means that there is no limit.
 * Refuses numbers that are negative or not finite. */
PLUMB_API plumb_status plumb_context_set_time_limit(plumb_context* context, double seconds,
                                                    plumb_error** error);
/** Sets the greatest number of digits, and the greatest absolute decimal exponent, of a number in
 * a text. */
PLUMB_API plumb_status plumb_context_set_number_limits(plumb_context* context, uint32_t digits,
                                                       uint32_t exponent, plumb_error** error);
/** Sets the number of threads that a call may use, which is at least 1. Results do not depend on
 * this number. */
PLUMB_API plumb_status plumb_context_set_threads(plumb_context* context, uint32_t threads,
                                                 plumb_error** error);
/** Sets the progress callback. A null pointer removes it. */
PLUMB_API plumb_status plumb_context_set_progress(plumb_context* context, plumb_progress progress,
                                                  void* user_data, plumb_error** error);
/** Requests that all present and later calls with this context stop. They return PLUMB_CANCELLED.
 * May be called on any thread and in a signal handler, even while calls use
 * the context. */
PLUMB_API void plumb_context_cancel(plumb_context* context);
/** Whether plumb_context_cancel() was called since the context was made or reset. */
PLUMB_API bool plumb_context_is_cancelled(const plumb_context* context);
/** Removes the request to stop. No other call may use the context at the same time, including
 * plumb_context_cancel(). */
PLUMB_API plumb_status plumb_context_reset(plumb_context* context, plumb_error** error);

/* ---- bytes, notes, indices, numbers --------------------------------------------------------- */

/** Bytes of a file or a text. A zero byte, which is not counted, follows the last byte. */
typedef struct plumb_bytes plumb_bytes;
PLUMB_API const char* plumb_bytes_data(const plumb_bytes* bytes); /**< Returns the bytes. */
PLUMB_API size_t plumb_bytes_size(const plumb_bytes* bytes); /**< Returns the number of bytes. */
PLUMB_API void plumb_bytes_free(plumb_bytes* bytes);         /**< Releases the bytes. */

/** Sentences for a human reader about a file that was read or written, for example about lost
 * contents. */
typedef struct plumb_notes plumb_notes;
PLUMB_API size_t plumb_notes_count(const plumb_notes* notes); /**< Returns the number of notes. */
/** Returns note i. */
PLUMB_API const char* plumb_notes_text(const plumb_notes* notes, size_t i);
/** Whether note i is a warning: it reports lost geometry, so that a user should see it. */
PLUMB_API bool plumb_notes_is_warning(const plumb_notes* notes, size_t i);
PLUMB_API void plumb_notes_free(plumb_notes* notes); /**< Releases the notes. */

/** A list of 32-bit integers. */
typedef struct plumb_indices plumb_indices;
/** Returns the integers. */
PLUMB_API const uint32_t* plumb_indices_data(const plumb_indices* indices);
/** Returns the number of integers. */
PLUMB_API size_t plumb_indices_count(const plumb_indices* indices);
PLUMB_API void plumb_indices_free(plumb_indices* indices); /**< Releases the list. */

/** A list of exact numbers. */
typedef struct plumb_numbers plumb_numbers;
/** Makes the list of the exact values of doubles. */
PLUMB_API plumb_status plumb_numbers_from_doubles(const double* values, size_t count,
                                                  plumb_numbers** out, plumb_error** error);
/** Makes a list from texts such as "-3", "1/3", "0.1" (which is exactly a tenth) or "2.5e-3". The
 * position of an error names the text, as in "number 2". The context limits digits and
 * exponents. */
PLUMB_API plumb_status plumb_numbers_from_texts(const char* const* texts, size_t count,
                                                plumb_numbers** out, const plumb_context* context,
                                                plumb_error** error);
/** Returns the number of exact numbers in the list. */
PLUMB_API size_t plumb_numbers_count(const plumb_numbers* numbers);
/** Returns number i as "p/q" in lowest terms, or "p". */
PLUMB_API const char* plumb_numbers_exact(const plumb_numbers* numbers, size_t i);
/** Returns the double that is nearest to number i. If the number lies beyond the largest double,
 * returns an infinity. */
PLUMB_API double plumb_numbers_nearest(const plumb_numbers* numbers, size_t i);
PLUMB_API void plumb_numbers_free(plumb_numbers* numbers); /**< Releases the list. */

/* ---- constants and small structs ------------------------------------------------------------ */

/** Boolean functions of two sets, for plumb_<set>_combine(). The four low bits state which points
 * belong to the result. Bit 0 stands for the points in neither set, and bit 1 for the points only
 * in the first set. Bit 2 stands for the points only in the second set, and bit 3 for the points in
 * both sets. All 16 values are allowed. If PLUMB_REGULARIZED is added, the result is replaced by
 * the closure of its interior. */
enum plumb_operation {
  PLUMB_UNION = 14,
  PLUMB_INTERSECTION = 8,
  PLUMB_DIFFERENCE = 2,
  PLUMB_SYMMETRIC_DIFFERENCE = 6,
  PLUMB_REGULARIZED = 16
};

/** The winding numbers that count as inside. */
enum plumb_rule {
  /** For solids: the positive numbers. Components that are inside out are flipped first. For sets
   * of the plane and for surfaces: the odd numbers. */
  PLUMB_RULE_DEFAULT = 0,
  PLUMB_RULE_NONZERO = 1,
  PLUMB_RULE_EVEN_ODD = 2,
  PLUMB_RULE_POSITIVE = 3
};

/** The cell that contains a point. */
typedef struct plumb_location {
  int32_t dimension; /**< 0: vertex, 1: edge, 2: facet or face, 3: volume. */
  uint32_t index;    /**< The index of the cell among the cells of this dimension. */
  bool is_inside;    /**< Whether the point belongs to the set. */
} plumb_location;

/** Options for reading a text. */
typedef struct plumb_read_options {
  size_t struct_size; /**< sizeof(plumb_read_options). */
  /** The name of the text in messages. Its extension determines the format. If it is null, the
   * first bytes of the text determine the format. Functions that read a file by its path ignore
   * this member. */
  const char* name;
  /** Whether decimals are read exactly, for example 0.1 as 1/10. Otherwise they are rounded to the
   * nearest doubles. */
  bool exact_decimals;
  /** 1 if a mesh gets the attributes of its file, otherwise 0. For solids, use
   * plumb_solid_options::keep instead. The type is size_t and not bool, because programs that were
   * compiled for an older version have padding with unknown contents at the place of a bool. */
  size_t attributes;
} plumb_read_options;
#define PLUMB_READ_OPTIONS_INIT \
  { sizeof(plumb_read_options), NULL, false, 0 }

/** Options for writing a set as a file whose coordinates are doubles. */
typedef struct plumb_write_options {
  size_t struct_size; /**< sizeof(plumb_write_options). */
  /** Whether coordinates are rounded to the nearest numbers even if faces or edges then cross.
   * Otherwise they are rounded so that the shapes in the file are valid. */
  bool raw;
  /** The step of a grid: one positive number, or null. Coordinates of sets of the plane are rounded
   * to multiples of the step. If `grid` is null, they are rounded to doubles. The step has no
   * effect on solids. */
  const plumb_numbers* grid;
} plumb_write_options;
#define PLUMB_WRITE_OPTIONS_INIT \
  { sizeof(plumb_write_options), false, NULL }

/** States whether a face with the same corners as an earlier face is kept or dropped. */
enum plumb_doubled { PLUMB_DOUBLED_KEEP = 0, PLUMB_DOUBLED_IF_BETTER = 1, PLUMB_DOUBLED_DROP = 2 };

/** Options for the repair of a mesh. By default, nothing is repaired. */
typedef struct plumb_repair_options {
  size_t struct_size; /**< sizeof(plumb_repair_options). */
  double weld;        /**< Points whose distance is at most this value are merged. */
  int doubled;        /**< A constant of plumb_doubled. */
  /** Whether faces whose orientation disagrees with their neighbours are flipped. */
  bool reorient;
  uint32_t fill_holes; /**< Holes with at most this number of edges are filled. */
  /** A hole with more edges is also filled if the diagonal of the box around its vertices is at
   * most this length. */
  double fill_holes_below;
} plumb_repair_options;
#define PLUMB_REPAIR_OPTIONS_INIT \
  { sizeof(plumb_repair_options), 0.0, 0, false, 0, 0.0 }

/** Selects the attributes that a solid keeps from its mesh. If a solid keeps attributes, the mesh
 * is its source (plumb_solid_source_count()). */
enum plumb_keep {
  PLUMB_KEEP_DEFAULT = 0, /**< All attributes of a plumb_mesh, but no attributes of a file. */
  PLUMB_KEEP_NONE = 1,    /**< No attributes. Then attributes cost no time and no memory. */
  PLUMB_KEEP_COLOURS = 2, /**< Materials, and the channel "color". */
  PLUMB_KEEP_IDS = 3,     /**< Ids of faces, and groups. */
  /** All attributes. A mesh in memory becomes a source even if it has no attributes. Then the faces
   * of a result state from which faces of the mesh they come. */
  PLUMB_KEEP_ALL = 4
};

/** Options for making a solid from a mesh. */
typedef struct plumb_solid_options {
  size_t struct_size; /**< sizeof(plumb_solid_options). */
  int rule;           /**< A constant of plumb_rule. */
  bool surface;       /**< Whether the set is the union of the facets. Then the mesh may be open. */
  /** Whether a file whose faces enclose nothing is accepted, as the empty set. */
  bool may_be_empty;
  const plumb_repair_options* repair; /**< How the mesh is repaired first; null means no repair. */
  int keep;                           /**< A constant of plumb_keep. */
  /** The name that a mesh in memory has as a source; may be null. A mesh from a file has the name
   * of the file. */
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
 * options->name. `notes` may be null. Otherwise it receives notes about contents that are not in
 * the mesh. */
PLUMB_API plumb_status plumb_mesh_read(const char* bytes, size_t size,
                                       const plumb_read_options* options, plumb_mesh** out,
                                       plumb_notes** notes, const plumb_context* context,
                                       plumb_error** error);
/** Reads a file. The path "-" stands for standard input. */
PLUMB_API plumb_status plumb_mesh_read_file(const char* path, const plumb_read_options* options,
                                            plumb_mesh** out, plumb_notes** notes,
                                            const plumb_context* context, plumb_error** error);
/** Writes the mesh as "off", "off-exact", "obj", "stl", "stl-binary", "ply", "ply-text", "glb" or
 * "3mf". STL, GLB and 3MF need triangles. Attributes of the mesh that the format cannot represent
 * are left out, and plumb_mesh_lost_attributes() names them. For "obj", the bytes have only the
 * names of materials. Their colours and textures belong in a second file, which
 * plumb_mesh_write_file() writes. */
PLUMB_API plumb_status plumb_mesh_write(const plumb_mesh* mesh, const char* format,
                                        plumb_bytes** out, plumb_error** error);
/** Writes a file. If writing fails, no incomplete file remains. If `format` is null, the extension
 * determines it. If faces have materials, the material library of an OBJ file is written beside it
 * as .mtl. */
PLUMB_API plumb_status plumb_mesh_write_file(const plumb_mesh* mesh, const char* path,
                                             const char* format, plumb_error** error);
/** Returns the number of points. */
PLUMB_API size_t plumb_mesh_point_count(const plumb_mesh* mesh);
/** Returns the number of faces. */
PLUMB_API size_t plumb_mesh_face_count(const plumb_mesh* mesh);
/** Returns the number of corners of all faces. */
PLUMB_API size_t plumb_mesh_corner_count(const plumb_mesh* mesh);
/** Returns 3 * plumb_mesh_point_count() coordinates, rounded to the nearest doubles. */
PLUMB_API const double* plumb_mesh_points(const plumb_mesh* mesh);
/** Returns plumb_mesh_face_count() + 1 offsets in plumb_mesh_corners(). */
PLUMB_API const uint32_t* plumb_mesh_face_begin(const plumb_mesh* mesh);
/** Returns the corners of all faces, which are indices of points. If all faces are triangles, each
 * face has three of them. */
PLUMB_API const uint32_t* plumb_mesh_corners(const plumb_mesh* mesh);
/** Returns, for each face, the facet of the solid from which the face was made. Returns null if the
 * mesh was not made from a solid. */
PLUMB_API const uint32_t* plumb_mesh_facets(const plumb_mesh* mesh);
/** Returns the three exact coordinates of a point. */
PLUMB_API plumb_status plumb_mesh_exact_point(const plumb_mesh* mesh, size_t point,
                                              plumb_numbers** out, plumb_error** error);
/** Makes a mesh of triangles: every face with more than three corners is cut into triangles. The
 * triangles have the attributes of their faces. */
PLUMB_API plumb_status plumb_mesh_triangulate(const plumb_mesh* mesh, plumb_mesh** out,
                                              const plumb_context* context, plumb_error** error);
/** The repairs that plumb_mesh_repair() made. A member of the type uint64_t is the number of the
 * points, faces or other things that its comment describes. */
typedef struct plumb_repair_report {
  size_t struct_size; /**< sizeof(plumb_repair_report). */
  uint64_t equal;     /**< Points whose coordinates were equal to those of an earlier point. */
  uint64_t welded;    /**< Positions that were moved to another position. */
  double farthest;    /**< The largest distance by which a point moved. */
  uint64_t unused;    /**< Points that were dropped because no face uses them. */
  uint64_t trimmed;   /**< Faces that lost corners. */
  /** Faces that were dropped because they had fewer than three corners left. */
  uint64_t degenerate;
  /** Faces that were dropped because they had the corners of an earlier face. */
  uint64_t doubled;
  uint64_t flipped; /**< Faces that were flipped because of their neighbours. */
  uint64_t turned;  /**< Components that were flipped because they were inside out. */
  uint64_t filled;  /**< Holes that were filled. */
  uint64_t added;   /**< Faces that were added in these holes. */
  uint64_t holes;   /**< Chains of edges along which faces are still missing. */
  bool is_closed;   /**< Whether the mesh is closed afterwards. */
} plumb_repair_report;
#define PLUMB_REPAIR_REPORT_INIT \
  { sizeof(plumb_repair_report), 0, 0, 0.0, 0, 0, 0, 0, 0, 0, 0, 0, 0, false }
/** Makes the repaired mesh. Faces keep their material, group, id and the numbers at their corners.
 * If a face is flipped, its normals (the channel "normal" of width 3) are negated. Faces added in
 * holes have PLUMB_NONE as their material, group and id; their numbers are 1 in the channel "color"
 * and 0 in all other channels. `report` and `notes` may be null. */
PLUMB_API plumb_status plumb_mesh_repair(const plumb_mesh* mesh,
                                         const plumb_repair_options* options, plumb_mesh** out,
                                         plumb_repair_report* report, plumb_notes** notes,
                                         const plumb_context* context, plumb_error** error);
/** Finds repair options with which plumb_solid_from_mesh() accepts the mesh. If several repairs are
 * possible, the function chooses the repair that changes least. If no repair suffices, *found is
 * set to false. */
PLUMB_API plumb_status plumb_mesh_find_repair(const plumb_mesh* mesh, plumb_repair_options* options,
                                              bool* found, const plumb_context* context,
                                              plumb_error** error);
PLUMB_API void plumb_mesh_free(plumb_mesh* mesh); /**< Releases a mesh. */

/** The result of plumb_mesh_check(). */
typedef struct plumb_mesh_report plumb_mesh_report;
/** Examines whether a mesh is closed, whether it crosses itself, and which of its faces have
 * defects. At most max_listed crossings are listed, but all are counted. Crossings are searched for
 * in closed meshes only. */
PLUMB_API plumb_status plumb_mesh_check(const plumb_mesh* mesh, uint64_t max_listed,
                                        plumb_mesh_report** out, const plumb_context* context,
                                        plumb_error** error);
/** Lists of a plumb_mesh_report. */
enum plumb_mesh_list {
  PLUMB_MESH_DEGENERATE = 0, /**< Faces without area. */
  PLUMB_MESH_TRIMMED = 1,    /**< Faces with repeated corners or spikes. */
  PLUMB_MESH_NOT_PLANAR = 2, /**< Faces that are not planar. */
  PLUMB_MESH_NOT_SIMPLE = 3, /**< Faces that are not simple polygons. */
  PLUMB_MESH_DOUBLED = 4,    /**< Pairs of a face and an earlier face with the same boundary. */
  PLUMB_MESH_CROSSINGS = 5,  /**< Pairs of faces that cross. */
  PLUMB_MESH_FLIPPED = 6,    /**< Faces whose orientation disagrees with their neighbours. */
  /** For each component that has only one side, such as a Moebius strip: one of its faces. */
  PLUMB_MESH_ONE_SIDED = 7,
  PLUMB_MESH_INSIDE_OUT = 8, /**< A face of each component of negative volume. */
  PLUMB_MESH_BORDERS = 9,    /**< Vertices of all borders; see plumb_mesh_report_chains(). */
  PLUMB_MESH_HOLES = 10      /**< Vertices of all holes; see plumb_mesh_report_chains(). */
};
/** Returns a list, and its number of entries (two for each pair) through `count`. */
PLUMB_API const uint32_t* plumb_mesh_report_list(const plumb_mesh_report* report, int list,
                                                 size_t* count);
/** Returns the offsets at which the chains of PLUMB_MESH_BORDERS or PLUMB_MESH_HOLES begin in the
 * list. `count` receives the number of chains. There is one more offset, which is the size of the
 * list. */
PLUMB_API const uint32_t* plumb_mesh_report_chains(const plumb_mesh_report* report, int list,
                                                   size_t* count);
/** Whether the mesh has no borders. */
PLUMB_API bool plumb_mesh_report_is_closed(const plumb_mesh_report* report);
/** Returns the number of pairs of faces that cross. */
PLUMB_API uint64_t plumb_mesh_report_crossing_count(const plumb_mesh_report* report);
PLUMB_API void plumb_mesh_report_free(plumb_mesh_report* report); /**< Releases a report. */

/** Whether the mesh is the surface of one convex body. `failing` receives pairs: a face, and a
 * vertex on the outer side of this face. `reflex_edges` and `failing` may be null. */
PLUMB_API plumb_status plumb_mesh_convexity(const plumb_mesh* mesh, bool* is_convex,
                                            uint64_t* reflex_edges, plumb_indices** failing,
                                            const plumb_context* context, plumb_error** error);

/* ---- attributes of meshes ------------------------------------------------------------------- */

/* A mesh can have attributes: materials, groups and ids of faces, and channels. A channel is a list
 * of numbers at corners, such as colours and texture coordinates. If a solid keeps the attributes
 * of its mesh (plumb_solid_options::keep), the mesh becomes a source of the solid. The results of
 * Booleans and affine maps of this solid have the same source. For each face of a result, the
 * function plumb_solid_to_mesh_with_attributes() finds the face of a source that contains it. It
 * also interpolates the channels. docs/attributes.md states the rules. */

/** The entry of a face that has no material, group, id or source. */
#define PLUMB_NONE 0xffffffffU

/** A material that faces refer to. */
typedef struct plumb_material {
  size_t struct_size;  /**< sizeof(plumb_material). */
  const char* name;    /**< The name. Null stands for an empty name. */
  bool has_color;      /**< Whether `color` has a meaning. */
  double color[4];     /**< Red, green, blue and opacity, each from 0 to 1. */
  const char* texture; /**< The name of a texture file. Null stands for none. */
} plumb_material;
#define PLUMB_MATERIAL_INIT \
  { sizeof(plumb_material), NULL, false, {0.0, 0.0, 0.0, 1.0}, NULL }

/** Appends a material to a mesh. `index` receives the index of the material, and may be null. */
PLUMB_API plumb_status plumb_mesh_add_material(plumb_mesh* mesh, const plumb_material* material,
                                               uint32_t* index, plumb_error** error);
/** Returns the number of materials of the mesh. */
PLUMB_API size_t plumb_mesh_material_count(const plumb_mesh* mesh);
/** Fills `material` with material i. The texts of `material` are never null. They are valid until
 * the mesh gets another material or is released. */
PLUMB_API plumb_status plumb_mesh_material(const plumb_mesh* mesh, size_t i,
                                           plumb_material* material, plumb_error** error);
/** Appends a group with this name to a mesh. `index` receives the index of the group, and may be
 * null. */
PLUMB_API plumb_status plumb_mesh_add_group(plumb_mesh* mesh, const char* name, uint32_t* index,
                                            plumb_error** error);
/** Returns the number of groups of the mesh. */
PLUMB_API size_t plumb_mesh_group_count(const plumb_mesh* mesh);
/** Returns the name of group i. */
PLUMB_API const char* plumb_mesh_group(const plumb_mesh* mesh, size_t i);

/** Values that each face of a mesh has. */
enum plumb_face_values {
  PLUMB_FACE_MATERIAL = 0, /**< The index of its material, or PLUMB_NONE. */
  PLUMB_FACE_GROUP = 1,    /**< The index of its group, or PLUMB_NONE. */
  PLUMB_FACE_ID = 2,       /**< An id that the caller chose, or PLUMB_NONE. */
  /** The source of the solid from which the face was made, or PLUMB_NONE. */
  PLUMB_FACE_SOURCE = 3,
  PLUMB_FACE_SOURCE_FACE = 4, /**< The face of this source, or PLUMB_NONE. */
  /** 1 if this face and the face of the source have opposite orientations, else 0. */
  PLUMB_FACE_IS_FLIPPED = 5
};
/** Sets the materials, the groups or the ids of all faces. `count` is the number of faces. If
 * `values` is null and `count` is 0, the values are removed. If a value is not the index of a
 * material or group of the mesh, the function returns PLUMB_BAD_INDEX. Only PLUMB_FACE_MATERIAL,
 * PLUMB_FACE_GROUP and PLUMB_FACE_ID can be set. */
PLUMB_API plumb_status plumb_mesh_set_face_values(plumb_mesh* mesh, int which,
                                                  const uint32_t* values, size_t count,
                                                  plumb_error** error);
/** Returns one value for each face; null if the mesh has no such values. `which` is a constant of
 * plumb_face_values. Only meshes that plumb_solid_to_mesh_with_attributes() made have values for
 * PLUMB_FACE_SOURCE and the following constants. */
PLUMB_API const uint32_t* plumb_mesh_face_values(const plumb_mesh* mesh, int which);

/** States whether the values of a channel are listed for corners or for points. */
enum plumb_channel_place {
  PLUMB_PER_CORNER = 0, /**< For each corner of each face, in the order of plumb_mesh_corners(). */
  PLUMB_PER_POINT = 1   /**< For each point. All corners at the point get the same values. */
};
/** Sets a channel, which has `width` numbers for each corner or for each point. `place` is a
 * constant of plumb_channel_place, and `count` is the number of all corners or of all points. If
 * the mesh already has a channel with this name, it is replaced. If `values` is null and `count` is
 * 0, the channel is removed. Files use the names "color" (3 or 4 numbers from 0 to 1), "normal"
 * (3), "texcoord_0", "texcoord_1" and so on (2). */
PLUMB_API plumb_status plumb_mesh_set_channel(plumb_mesh* mesh, const char* name, uint32_t width,
                                              int place, const double* values, size_t count,
                                              plumb_error** error);
/** Returns the number of channels of the mesh. */
PLUMB_API size_t plumb_mesh_channel_count(const plumb_mesh* mesh);
/** Returns the name of channel i. */
PLUMB_API const char* plumb_mesh_channel_name(const plumb_mesh* mesh, size_t i);
/** Returns the width of channel i: the number of its values at each corner. */
PLUMB_API uint32_t plumb_mesh_channel_width(const plumb_mesh* mesh, size_t i);
/** Returns the numbers of channel i: its width times plumb_mesh_corner_count(), in the order of
 * plumb_mesh_corners(). */
PLUMB_API const double* plumb_mesh_channel_values(const plumb_mesh* mesh, size_t i);
/** Returns a sentence that names the attributes of the mesh that this format cannot represent.
 * Returns an empty text if the format can represent all of them. The formats are those of
 * plumb_mesh_write(). */
PLUMB_API plumb_status plumb_mesh_lost_attributes(const plumb_mesh* mesh, const char* format,
                                                  plumb_bytes** out, plumb_error** error);

/* ---- solids --------------------------------------------------------------------------------- */

/** A Nef polyhedron: any set of points of space that can be made from half-spaces by unions,
 * intersections and complements. */
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
 * plumb_mesh_from_triangles(). If the mesh is open, the function returns PLUMB_BAD_SHAPE;
 * plumb_mesh_check() finds the borders. */
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
/** Makes the solid that a mesh bounds. By default, the solid keeps the attributes of the mesh
 * (plumb_solid_options::keep). */
PLUMB_API plumb_status plumb_solid_from_mesh(const plumb_mesh* mesh,
                                             const plumb_solid_options* options, plumb_solid** out,
                                             const plumb_context* context, plumb_error** error);
/** Makes the half-space a x + b y + c z + d < 0, or <= 0 if is_closed is true. `plane` contains the
 * four numbers a, b, c, d. */
PLUMB_API plumb_status plumb_solid_half_space(const plumb_numbers* plane, bool is_closed,
                                              plumb_solid** out, plumb_error** error);
/** Makes the points of the plane a x + b y + c z + d = 0. */
PLUMB_API plumb_status plumb_solid_plane(const plumb_numbers* plane, plumb_solid** out,
                                         plumb_error** error);
/** Makes the intersection of half-spaces. `planes` has 4 * count doubles; `is_closed` has `count`
 * entries. If `is_closed` is null, all half-spaces are closed. */
PLUMB_API plumb_status plumb_solid_from_half_spaces(const double* planes, const bool* is_closed,
                                                    size_t count, plumb_solid** out,
                                                    const plumb_context* context,
                                                    plumb_error** error);
/** Reads half-spaces from a file with lines `a b c d closed` or `a b c d open`, and makes their
 * intersection. */
PLUMB_API plumb_status plumb_solid_read_half_spaces_file(const char* path,
                                                         const plumb_read_options* options,
                                                         plumb_solid** out,
                                                         const plumb_context* context,
                                                         plumb_error** error);
/** Makes a set of points. `points` contains three numbers for each point. */
PLUMB_API plumb_status plumb_solid_points(const plumb_numbers* points, plumb_solid** out,
                                          const plumb_context* context, plumb_error** error);
/** Makes the union of the segments from each point to the next one. */
PLUMB_API plumb_status plumb_solid_polyline(const plumb_numbers* points, plumb_solid** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the closed polygon with these corners, which must lie in one plane. */
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
/** Reads a file. The path "-" stands for standard input. */
PLUMB_API plumb_status plumb_solid_read_file(const char* path, const plumb_read_options* reading,
                                             const plumb_solid_options* options, plumb_solid** out,
                                             plumb_notes** notes, const plumb_context* context,
                                             plumb_error** error);
/** Writes "off", "off-exact", "obj", "stl", "stl-binary", "ply", "ply-text", "glb", "3mf" or "nef".
 * Only .nef represents every set; for other formats, `notes` receives notes about everything that
 * the file does not represent. Equal sets give equal .nef files only after plumb_solid_canonical().
 * Files of meshes contain the attributes of the sources that the format can represent; see
 * plumb_mesh_write(). */
PLUMB_API plumb_status plumb_solid_write(const plumb_solid* solid, const char* format,
                                         const plumb_write_options* options, plumb_bytes** out,
                                         plumb_notes** notes, const plumb_context* context,
                                         plumb_error** error);
/** Writes a file. If writing fails, no incomplete file remains. If `format` is null, the extension
 * determines it. If sources have materials, the material library of an OBJ file is written beside
 * it as .mtl. */
PLUMB_API plumb_status plumb_solid_write_file(const plumb_solid* solid, const char* path,
                                              const char* format,
                                              const plumb_write_options* options,
                                              plumb_notes** notes, const plumb_context* context,
                                              plumb_error** error);
/** Draws the solid as "html", "svg", "glb" or "png". `title` may be null. */
PLUMB_API plumb_status plumb_solid_draw(const plumb_solid* solid, const char* format,
                                        const char* title, plumb_bytes** out,
                                        const plumb_context* context, plumb_error** error);
/** Draws several solids, each in a colour of its own. Each solid is moved away from the middle of
 * all solids by `apart` times its distance from this middle. */
PLUMB_API plumb_status plumb_solid_draw_many(const plumb_solid* const* solids, size_t count,
                                             double apart, const char* format, const char* title,
                                             plumb_bytes** out, const plumb_context* context,
                                             plumb_error** error);

/** Options for making a mesh from a solid. */
typedef struct plumb_to_mesh_options {
  size_t struct_size; /**< sizeof(plumb_to_mesh_options). */
  /** Whether a planar facet becomes one polygon. Otherwise all facets are triangulated. */
  bool polygons;
  bool split_vertices; /**< Whether each cone at a vertex gets a point of its own. */
  /** Whether coordinates are rounded to floats. They are stored as doubles. */
  bool floats;
  /** Whether points are rounded to the nearest doubles, and plumb_mesh_exact_point() returns the
   * exact points. Otherwise points are rounded so that the rounded mesh is valid. */
  bool exact;
  /** 1 if points are rounded to the nearest doubles, even if faces then cross; otherwise 0. The
   * points are the same as with `exact`, but exact points are not computed. Computing them can
   * triple the time. The type is size_t and not bool, because programs that were compiled for an
   * older version have padding with unknown contents at the place of a bool. */
  size_t nearest;
} plumb_to_mesh_options;
#define PLUMB_TO_MESH_OPTIONS_INIT \
  { sizeof(plumb_to_mesh_options), false, false, false, false, 0 }
/** A report on the rounding of a mesh, and on the cells of the solid that the mesh does not
 * represent. Integer members except struct_size count the things that their comments describe. */
typedef struct plumb_to_mesh_report {
  size_t struct_size;        /**< sizeof(plumb_to_mesh_report). */
  uint64_t rounded_vertices; /**< Vertices whose coordinates were rounded. */
  uint32_t rounds;           /**< Rounds of repair; 0 if the mesh was valid without repair. */
  uint32_t coarse_rounds;    /**< Rounds that used a coarser grid. */
  uint64_t damaged_faces;    /**< Faces that rounding to the nearest numbers damages. */
  double largest_move;       /**< A bound for the distance from the exact boundary. */
  bool changes_topology;     /**< Whether thin parts or gaps vanished. */
  /** Cells of the set outside the closed solid, which the mesh omits. */
  uint64_t dropped;
  /** Cells inside the closed solid that do not belong to the set. */
  uint64_t filled;
  uint64_t closed;                /**< Cells of the boundary that do not belong to the set. */
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

/** Determines how the boundary of a solid is divided into faces. A facet of the boundary consists
 * of parts, each of which lies in one triangle of a source. */
enum plumb_pieces {
  /** Neighbouring parts of a facet become one face under two conditions. They have the same source,
   * material, group and id. For each channel, a single affine function describes the values on all
   * of them. */
  PLUMB_PIECES_SAME_ATTRIBUTES = 0,
  PLUMB_PIECES_APART = 1, /**< Each face lies in one triangle of a source. */
  /** Parts become one face under the conditions of the first constant, and only if they also lie in
   * one face of a source. */
  PLUMB_PIECES_SAME_FACE = 2
};
/** Options for making a mesh with attributes from a solid. */
typedef struct plumb_attribute_options {
  size_t struct_size; /**< sizeof(plumb_attribute_options). */
  int pieces;         /**< A constant of plumb_pieces. */
  /** Whether a planar face stays a polygon. Otherwise all faces are triangulated. */
  bool polygons;
  bool floats; /**< Whether coordinates are rounded to floats. They are stored as doubles. */
} plumb_attribute_options;
#define PLUMB_ATTRIBUTE_OPTIONS_INIT \
  { sizeof(plumb_attribute_options), 0, false, false }
/** Makes the mesh of the boundary of the solid, valid after rounding, with the attributes of the
 * sources of the solid. The list of materials consists of the materials of the first source, then
 * the materials of the second source, and so on. The list of groups is made in the same way. Faces
 * are in ascending order of PLUMB_FACE_SOURCE, and faces without a source come last. Channels with
 * the same name become one channel, whose width is the greatest of their widths. Values that a
 * source lacks are set to 1 in the channel "color", and to 0 in all other channels. Fails with
 * PLUMB_BAD_ARGUMENT if the solid is unbounded. `options` and `report` may be null. */
PLUMB_API plumb_status plumb_solid_to_mesh_with_attributes(
    const plumb_solid* solid, const plumb_attribute_options* options, plumb_mesh** out,
    plumb_to_mesh_report* report, const plumb_context* context, plumb_error** error);
/** Makes the same solid with a single source, which replaces all its sources: a mesh with
 * attributes. The faces of the mesh should lie on the boundary of the solid. `name` may be null. */
PLUMB_API plumb_status plumb_solid_with_source(const plumb_solid* solid, const plumb_mesh* mesh,
                                               const char* name, plumb_solid** out,
                                               plumb_error** error);
/** The attributes of the boundary of a half-space. */
typedef struct plumb_plane_source {
  size_t struct_size;             /**< sizeof(plumb_plane_source). */
  const char* name;               /**< The name of the source. Null stands for an empty name. */
  const plumb_material* material; /**< The material of the cuts. Null stands for none. */
  const char* group;              /**< The group of the cuts. Null stands for none. */
  uint32_t id;                    /**< The id of the cuts, or PLUMB_NONE. */
} plumb_plane_source;
#define PLUMB_PLANE_SOURCE_INIT \
  { sizeof(plumb_plane_source), NULL, NULL, NULL, PLUMB_NONE }
/** Makes a half-space as plumb_solid_half_space() does. The boundary of the half-space is a source
 * of the solid. This source has one face, face 0. Faces of results that the half-space cuts have
 * the attributes of this face. If `source` is null, the face has no attributes. */
PLUMB_API plumb_status plumb_solid_half_space_with_source(const plumb_numbers* plane,
                                                          bool is_closed,
                                                          const plumb_plane_source* source,
                                                          plumb_solid** out, plumb_error** error);
/** Returns the number of sources of the solid. The sources are the meshes with attributes from
 * which it was made, in the order of the operands. */
PLUMB_API size_t plumb_solid_source_count(const plumb_solid* solid);
/** Returns the name of source i, which is the name of its file, or
 * plumb_solid_options::source_name. */
PLUMB_API const char* plumb_solid_source_name(const plumb_solid* solid, size_t i);

/** Makes the result of a Boolean operation on two sets. `operation` is a value of
 * plumb_operation. */
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
/** Makes the union of any number of sets. The union of no sets is empty. */
PLUMB_API plumb_status plumb_solid_union_of(const plumb_solid* const* solids, size_t count,
                                            plumb_solid** out, const plumb_context* context,
                                            plumb_error** error);
/** Makes the intersection of any number of sets. The intersection of no sets is the whole
 * space. */
PLUMB_API plumb_status plumb_solid_intersection_of(const plumb_solid* const* solids, size_t count,
                                                   plumb_solid** out, const plumb_context* context,
                                                   plumb_error** error);
/** Makes the value of an expression such as "(A + B) * !C". The operators are the union (+), the
 * intersection (*), the difference (-), the symmetric difference (^), the complement (!) and the
 * Minkowski sum (@), which binds more tightly than the intersection. names[i] is the name of
 * solids[i]. */
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
/** Makes the canonical form of the solid: the same set, with its cells in an order that depends
 * only on the set. */
PLUMB_API plumb_status plumb_solid_canonical(const plumb_solid* solid, plumb_solid** out,
                                             const plumb_context* context, plumb_error** error);
/** The part of space that is given by a plane a x + b y + c z + d = 0. */
enum plumb_section {
  PLUMB_SECTION_CLOSED_BELOW = 0, /**< a x + b y + c z + d <= 0. */
  PLUMB_SECTION_OPEN_BELOW = 1,   /**< a x + b y + c z + d < 0. */
  PLUMB_SECTION_PLANE = 2         /**< The plane. */
};
/** Makes the result of a Boolean operation on the solid and a part of space that is given by a
 * plane. `plane` contains four numbers, and `section` is a constant of plumb_section. */
PLUMB_API plumb_status plumb_solid_section(const plumb_solid* solid, const plumb_numbers* plane,
                                           int section, int operation, plumb_solid** out,
                                           const plumb_context* context, plumb_error** error);
/** Makes the image of the solid under an invertible affine map. `map` contains 12 numbers: for each
 * of the three coordinates, a row of the matrix and the component of the translation. */
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
  size_t bytes;          /**< The memory in bytes, which copies share. */
  bool is_empty;         /**< Whether the set has no point. */
  bool is_whole;         /**< Whether the set is the whole space. */
  bool is_bounded;       /**< Whether a ball contains the set. */
  bool is_closed;        /**< Whether the set contains its boundary. */
  bool is_open;          /**< Whether the set contains no point of its boundary. */
  bool is_simple;        /**< Whether the boundary is a 2-manifold. */
  bool is_convex;        /**< Whether the set contains the segment between any two of its points. */
} plumb_solid_info;
#define PLUMB_SOLID_INFO_INIT \
  { sizeof(plumb_solid_info), 0, 0, 0, 0, 0, 0, false, false, false, false, false, false, false }
/** Fills `info`. O(n) expected time. */
PLUMB_API plumb_status plumb_solid_describe(const plumb_solid* solid, plumb_solid_info* info,
                                            plumb_error** error);
PLUMB_API bool plumb_solid_is_empty(
    const plumb_solid* solid); /**< Whether the solid has no point. O(1). */
PLUMB_API bool plumb_solid_is_whole(
    const plumb_solid* solid); /**< Whether the solid is the whole space. O(1). */
/** Whether a and b are the same set. */
PLUMB_API plumb_status plumb_solid_equals(const plumb_solid* a, const plumb_solid* b, bool* out,
                                          plumb_error** error);
/** Whether every point of a is in b. */
PLUMB_API plumb_status plumb_solid_is_subset(const plumb_solid* a, const plumb_solid* b, bool* out,
                                             const plumb_context* context, plumb_error** error);
/** Sets inside[i] to whether point i belongs to the solid. `xyz` has 3 * count doubles. */
PLUMB_API plumb_status plumb_solid_contains(const plumb_solid* solid, const double* xyz,
                                            size_t count, bool* inside,
                                            const plumb_context* context, plumb_error** error);
/** Sets locations[i] to the cell that contains point i. `points` contains three numbers for each
 * point, and `locations` has `count` entries. */
PLUMB_API plumb_status plumb_solid_locate(const plumb_solid* solid, const plumb_numbers* points,
                                          plumb_location* locations, size_t count,
                                          const plumb_context* context, plumb_error** error);
/** Finds the first cell on a ray that belongs to the solid. `ray` contains the three coordinates of
 * the origin, and the three components of the direction. If `to_boundary` is true, the function
 * instead finds the first vertex, edge or facet, whether or not it belongs to the solid. If the ray
 * meets no such cell, *is_hit is set to false and *point to null. Otherwise *point receives the
 * three coordinates of the first point of the cell on the ray. */
PLUMB_API plumb_status plumb_solid_shoot(const plumb_solid* solid, const plumb_numbers* ray,
                                         bool to_boundary, bool* is_hit, plumb_location* location,
                                         plumb_numbers** point, const plumb_context* context,
                                         plumb_error** error);
/** Returns the exact volume as a list of one number. The list is empty if the volume is
 * infinite. */
PLUMB_API plumb_status plumb_solid_volume(const plumb_solid* solid, plumb_numbers** out,
                                          const plumb_context* context, plumb_error** error);
/** Returns the exact centroid as a list of three numbers. The list is empty if the volume is 0 or
 * infinite. */
PLUMB_API plumb_status plumb_solid_centroid(const plumb_solid* solid, plumb_numbers** out,
                                            const plumb_context* context, plumb_error** error);
/** Returns the area of the boundary, with a relative error below 2^-50. If the area is infinite,
 * returns infinity. */
PLUMB_API plumb_status plumb_solid_surface_area(const plumb_solid* solid, double* out,
                                                const plumb_context* context, plumb_error** error);
/** Whether the solid is convex, with evidence. `reflex_edges` receives the number of reflex edges.
 * `failing` receives pairs: a facet, and a vertex on the outer side of this facet. `reflex_edges`
 * and `failing` may be null. */
PLUMB_API plumb_status plumb_solid_convexity(const plumb_solid* solid, bool* is_convex,
                                             uint64_t* reflex_edges, plumb_indices** failing,
                                             const plumb_context* context, plumb_error** error);
/** Checks every invariant from scratch. If all invariants hold, *flaw is set to null. Otherwise
 * *flaw receives a text that names the invariant that does not hold, and the place. */
PLUMB_API plumb_status plumb_solid_audit(const plumb_solid* solid, plumb_bytes** flaw,
                                         const plumb_context* context, plumb_error** error);

/** A list of solids. */
typedef struct plumb_solid_list plumb_solid_list;
/** The methods of plumb_solid_decompose(). */
enum plumb_decomposition {
  PLUMB_DECOMPOSE_BEST = 0, /**< The result of the two other methods that has fewer pieces. */
  PLUMB_DECOMPOSE_CUTS = 1, /**< Cuts along planes through reflex edges. */
  PLUMB_DECOMPOSE_WALLS = 2 /**< Cuts along vertical walls through reflex edges. */
};
/** Cuts the solid into convex pieces. Every point of the solid belongs to exactly one piece. If
 * `is_closed` is true, the closures of the pieces are returned instead. The pieces have the sources
 * of the solid (plumb_solid_with_source()); faces on cuts have no source. */
PLUMB_API plumb_status plumb_solid_decompose(const plumb_solid* solid, int method, bool is_closed,
                                             plumb_solid_list** out, const plumb_context* context,
                                             plumb_error** error);
/** Returns the number of solids. */
PLUMB_API size_t plumb_solid_list_count(const plumb_solid_list* list);
/** Returns solid i, which the list owns. plumb_solid_copy() makes a handle that is valid even after
 * the list was released. */
PLUMB_API const plumb_solid* plumb_solid_list_at(const plumb_solid_list* list, size_t i);
/** Releases the list and its solids. */
PLUMB_API void plumb_solid_list_free(plumb_solid_list* list);

/* ---- sets of the plane ---------------------------------------------------------------------- */

/** A Nef polyhedron of the plane: a set of polygons, lines and points, each of which may or may not
 * contain its boundary. */
typedef struct plumb_plane_set plumb_plane_set;

/** Makes the set without points. */
PLUMB_API plumb_status plumb_plane_set_empty(plumb_plane_set** out, plumb_error** error);
/** Makes the whole plane. */
PLUMB_API plumb_status plumb_plane_set_whole(plumb_plane_set** out, plumb_error** error);
/** Makes another handle of the same set. O(1). */
PLUMB_API plumb_status plumb_plane_set_copy(const plumb_plane_set* set, plumb_plane_set** out,
                                            plumb_error** error);
PLUMB_API void plumb_plane_set_free(plumb_plane_set* set); /**< Releases a set. */
/** Makes the half-plane a x + b y + c < 0, or <= 0 if is_closed is true. `line` contains the three
 * numbers a, b, c. */
PLUMB_API plumb_status plumb_plane_set_half_plane(const plumb_numbers* line, bool is_closed,
                                                  plumb_plane_set** out, plumb_error** error);
/** Makes the line a x + b y + c = 0. `line` contains the three numbers a, b, c. */
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
/** Makes the set that one closed chain of points bounds. `points` contains two numbers for each
 * point. The direction of the chain does not matter. */
PLUMB_API plumb_status plumb_plane_set_polygon(const plumb_numbers* points, bool is_closed,
                                               plumb_plane_set** out, const plumb_context* context,
                                               plumb_error** error);
/** Makes the union of the segments between consecutive points of open chains. The arrays are those
 * of plumb_plane_set_polygons(). A chain of one point adds this point to the set. */
PLUMB_API plumb_status plumb_plane_set_polylines(const double* xy, size_t point_count,
                                                 const uint32_t* chain_begin, size_t chain_count,
                                                 const uint32_t* corners, size_t corner_count,
                                                 plumb_plane_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** Makes a set of points. `points` contains two numbers for each point. */
PLUMB_API plumb_status plumb_plane_set_points(const plumb_numbers* points, plumb_plane_set** out,
                                              const plumb_context* context, plumb_error** error);
/** Reads WKT, GeoJSON, WKB or .nef2 from memory. The extension of options->name determines the
 * format. If there is no name, the first bytes determine the format. `notes` may be null. */
PLUMB_API plumb_status plumb_plane_set_read(const char* bytes, size_t size,
                                            const plumb_read_options* options,
                                            plumb_plane_set** out, plumb_notes** notes,
                                            const plumb_context* context, plumb_error** error);
/** Reads a file. The path "-" stands for standard input. */
PLUMB_API plumb_status plumb_plane_set_read_file(const char* path,
                                                 const plumb_read_options* options,
                                                 plumb_plane_set** out, plumb_notes** notes,
                                                 const plumb_context* context, plumb_error** error);
/** Writes "wkt", "geojson", "wkb", "dxf" or "nef2". Only .nef2 represents every set; for other
 * formats, `notes` receives notes about everything that the file does not represent. */
PLUMB_API plumb_status plumb_plane_set_write(const plumb_plane_set* set, const char* format,
                                             const plumb_write_options* options, plumb_bytes** out,
                                             plumb_notes** notes, const plumb_context* context,
                                             plumb_error** error);
/** Writes a file. If writing fails, no incomplete file remains. If `format` is null, the extension
 * determines it. */
PLUMB_API plumb_status plumb_plane_set_write_file(const plumb_plane_set* set, const char* path,
                                                  const char* format,
                                                  const plumb_write_options* options,
                                                  plumb_notes** notes, const plumb_context* context,
                                                  plumb_error** error);
/** Draws the set as "svg", "html", "glb" or "png". `title` may be null. */
PLUMB_API plumb_status plumb_plane_set_draw(const plumb_plane_set* set, const char* format,
                                            const char* title, plumb_bytes** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the result of a Boolean operation on two sets. `operation` is a value of
 * plumb_operation. */
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
/** Makes the set of the points in a but not in b. */
PLUMB_API plumb_status plumb_plane_set_difference(const plumb_plane_set* a,
                                                  const plumb_plane_set* b, plumb_plane_set** out,
                                                  const plumb_context* context,
                                                  plumb_error** error);
/** Makes the set of the points in exactly one of a and b. */
PLUMB_API plumb_status plumb_plane_set_symmetric_difference(const plumb_plane_set* a,
                                                            const plumb_plane_set* b,
                                                            plumb_plane_set** out,
                                                            const plumb_context* context,
                                                            plumb_error** error);
/** Makes the union of any number of sets. The union of no sets is empty. */
PLUMB_API plumb_status plumb_plane_set_union_of(const plumb_plane_set* const* sets, size_t count,
                                                plumb_plane_set** out, const plumb_context* context,
                                                plumb_error** error);
/** Makes the intersection of any number of sets. The intersection of no sets is the whole
 * plane. */
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
    const plumb_plane_set* set); /**< Whether the set is the whole plane. O(1). */
/** Whether a and b are the same set. */
PLUMB_API plumb_status plumb_plane_set_equals(const plumb_plane_set* a, const plumb_plane_set* b,
                                              bool* out, plumb_error** error);
/** Whether every point of a is in b. */
PLUMB_API plumb_status plumb_plane_set_is_subset(const plumb_plane_set* a, const plumb_plane_set* b,
                                                 bool* out, const plumb_context* context,
                                                 plumb_error** error);
/** Checks every invariant from scratch; see plumb_solid_audit(). */
PLUMB_API plumb_status plumb_plane_set_audit(const plumb_plane_set* set, plumb_bytes** flaw,
                                             const plumb_context* context, plumb_error** error);
/** Makes the image of the set under an invertible affine map. `map` contains 6 numbers: for each of
 * the two coordinates, a row of the matrix and the component of the translation. */
PLUMB_API plumb_status plumb_plane_set_transform(const plumb_plane_set* set,
                                                 const plumb_numbers* map, plumb_plane_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** A report on the changes made by rounding. Distances are measured in the maximum norm. Integer
 * members except struct_size count the things that their comments describe. */
typedef struct plumb_rounding_report {
  size_t struct_size;     /**< sizeof(plumb_rounding_report). */
  size_t vertices_moved;  /**< Vertices that were not rounded to the nearest numbers. */
  size_t vertices_merged; /**< Vertices that were rounded to the same point as another vertex. */
  size_t edges_bent;      /**< Edges that got new corners. */
  /** Pieces of edges that were left out, because the same face is on both sides. */
  size_t edges_folded;
  size_t collapsed;    /**< Faces of which nothing remained. */
  double largest_move; /**< A bound for the distance by which any point moved. */
} plumb_rounding_report;
#define PLUMB_ROUNDING_REPORT_INIT \
  { sizeof(plumb_rounding_report), 0, 0, 0, 0, 0, 0.0 }
/** Makes the closure of the set, rounded to doubles or to a grid. If `step` is null, coordinates
 * become doubles. Otherwise `step` is a list of one positive number, and coordinates become the
 * doubles nearest to multiples of this number. After rounding, edges still meet only at common
 * ends. Unbounded parts are left out. `report` may be null. */
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
  size_t bytes;        /**< The memory in bytes, which copies share. */
  bool is_empty;       /**< Whether the set has no point. */
  bool is_whole;       /**< Whether the set is the whole plane. */
  bool is_bounded;     /**< Whether a disk contains the set. */
  bool is_closed;      /**< Whether the set contains its boundary. */
  bool is_open;        /**< Whether the set contains no point of its boundary. */
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
/** Sets locations[i] to the cell that contains point i. `points` contains two numbers for each
 * point, and `locations` has `count` entries. */
PLUMB_API plumb_status plumb_plane_set_locate(const plumb_plane_set* set,
                                              const plumb_numbers* points,
                                              plumb_location* locations, size_t count,
                                              const plumb_context* context, plumb_error** error);
/** Finds the first cell on a ray; see plumb_solid_shoot(). `ray` contains the two coordinates of
 * the origin and the two components of the direction. */
PLUMB_API plumb_status plumb_plane_set_shoot(const plumb_plane_set* set, const plumb_numbers* ray,
                                             bool to_boundary, bool* is_hit,
                                             plumb_location* location, plumb_numbers** point,
                                             const plumb_context* context, plumb_error** error);
/** Returns the exact area as a list of one number. The list is empty if the area is infinite. */
PLUMB_API plumb_status plumb_plane_set_area(const plumb_plane_set* set, plumb_numbers** out,
                                            const plumb_context* context, plumb_error** error);
/** Whether the set is convex. `reflex_corners` receives the number of reflex corners, and `parts`
 * receives the number of connected components. Both pointers may be null. */
PLUMB_API plumb_status plumb_plane_set_convexity(const plumb_plane_set* set, bool* is_convex,
                                                 uint64_t* reflex_corners, uint64_t* parts,
                                                 const plumb_context* context, plumb_error** error);

/** The closure of a set as polygons, lines and points in arrays. */
typedef struct plumb_shapes plumb_shapes;
/** Lists the bounded parts of the closure of a set. plumb_shapes_exact_point() returns exact
 * coordinates, and plumb_shapes_points() returns coordinates that are rounded to doubles. For a set
 * that plumb_plane_set_round() made, both are equal. */
PLUMB_API plumb_status plumb_plane_set_shapes(const plumb_plane_set* set, plumb_shapes** out,
                                              const plumb_context* context, plumb_error** error);
PLUMB_API size_t plumb_shapes_point_count(const plumb_shapes* shapes);   /**< Points. */
PLUMB_API size_t plumb_shapes_polygon_count(const plumb_shapes* shapes); /**< Polygons. */
/** Rings of all polygons. */
PLUMB_API size_t plumb_shapes_ring_count(const plumb_shapes* shapes);
PLUMB_API size_t plumb_shapes_line_count(const plumb_shapes* shapes);   /**< Lines. */
PLUMB_API size_t plumb_shapes_single_count(const plumb_shapes* shapes); /**< Isolated points. */
/** Returns 2 * plumb_shapes_point_count() coordinates, rounded to the nearest doubles. */
PLUMB_API const double* plumb_shapes_points(const plumb_shapes* shapes);
/** Returns the index of the first ring of each polygon, followed by the number of rings. The outer
 * ring of a polygon comes first and runs counter-clockwise. */
PLUMB_API const uint32_t* plumb_shapes_polygon_begin(const plumb_shapes* shapes);
/** Returns the offset of each ring in plumb_shapes_ring_corners(), followed by the number of
 * corners. */
PLUMB_API const uint32_t* plumb_shapes_ring_begin(const plumb_shapes* shapes);
/** Returns the corners of all rings, which are indices of points. */
PLUMB_API const uint32_t* plumb_shapes_ring_corners(const plumb_shapes* shapes);
/** Returns the offset of each line in plumb_shapes_line_corners(), followed by the number of
 * corners. */
PLUMB_API const uint32_t* plumb_shapes_line_begin(const plumb_shapes* shapes);
/** Returns the corners of all lines, which are indices of points. */
PLUMB_API const uint32_t* plumb_shapes_line_corners(const plumb_shapes* shapes);
/** Returns the isolated points, as indices of points. */
PLUMB_API const uint32_t* plumb_shapes_singles(const plumb_shapes* shapes);
/** Returns the two exact coordinates of a point. */
PLUMB_API plumb_status plumb_shapes_exact_point(const plumb_shapes* shapes, size_t point,
                                                plumb_numbers** out, plumb_error** error);
PLUMB_API void plumb_shapes_free(plumb_shapes* shapes); /**< Releases the arrays. */

/** A list of sets of the plane. */
typedef struct plumb_plane_set_list plumb_plane_set_list;
/** The methods of plumb_plane_set_decompose(). */
enum plumb_partition {
  PLUMB_PARTITION_BEST = 0, /**< The result of the other methods that has the fewest pieces. */
  PLUMB_PARTITION_CUTS = 1, /**< Prolongs sides at reflex corners. */
  /** Cuts along diagonals between vertices; for bounded faces only. */
  PLUMB_PARTITION_DIAGONALS = 2,
  /** Makes the fewest pieces that diagonals can make; for bounded faces with one boundary loop and
   * at most 500 corners only. */
  PLUMB_PARTITION_OPTIMAL = 3
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
/** Releases the list and its sets. */
PLUMB_API void plumb_plane_set_list_free(plumb_plane_set_list* list);

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
/** Makes the intersection of the half-spheres around directions. `normals` contains three numbers
 * for each direction. The half-spheres are closed if is_closed is true, and open otherwise. */
PLUMB_API plumb_status plumb_sphere_set_half_spheres(const plumb_numbers* normals, bool is_closed,
                                                     plumb_sphere_set** out,
                                                     const plumb_context* context,
                                                     plumb_error** error);
/** Makes the great circle of all directions that are orthogonal to `normal`. */
PLUMB_API plumb_status plumb_sphere_set_circle(const plumb_numbers* normal, plumb_sphere_set** out,
                                               plumb_error** error);
/** Makes the region to the left of the closed chain of shortest arcs between corners. */
PLUMB_API plumb_status plumb_sphere_set_polygon(const plumb_numbers* corners, bool is_closed,
                                                plumb_sphere_set** out, plumb_error** error);
/** Makes the shortest arc between two directions. `ends` contains six numbers, three for each
 * direction. */
PLUMB_API plumb_status plumb_sphere_set_arc(const plumb_numbers* ends, bool is_closed,
                                            plumb_sphere_set** out, plumb_error** error);
/** Makes a set of directions. */
PLUMB_API plumb_status plumb_sphere_set_points(const plumb_numbers* directions,
                                               plumb_sphere_set** out, const plumb_context* context,
                                               plumb_error** error);
/** Makes the result of a Boolean operation on two sets. `operation` is a value of
 * plumb_operation. */
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
/** Makes the set of the points in a but not in b. */
PLUMB_API plumb_status plumb_sphere_set_difference(const plumb_sphere_set* a,
                                                   const plumb_sphere_set* b,
                                                   plumb_sphere_set** out,
                                                   const plumb_context* context,
                                                   plumb_error** error);
/** Makes the set of the points in exactly one of a and b. */
PLUMB_API plumb_status plumb_sphere_set_symmetric_difference(const plumb_sphere_set* a,
                                                             const plumb_sphere_set* b,
                                                             plumb_sphere_set** out,
                                                             const plumb_context* context,
                                                             plumb_error** error);
/** Makes the union of any number of sets. The union of no sets is empty. */
PLUMB_API plumb_status plumb_sphere_set_union_of(const plumb_sphere_set* const* sets, size_t count,
                                                 plumb_sphere_set** out,
                                                 const plumb_context* context, plumb_error** error);
/** Makes the intersection of any number of sets. The intersection of no sets is the whole
 * sphere. */
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
    const plumb_sphere_set* set); /**< Whether the set is the whole sphere. O(1). */
/** Whether a and b are the same set. */
PLUMB_API plumb_status plumb_sphere_set_equals(const plumb_sphere_set* a, const plumb_sphere_set* b,
                                               bool* out, plumb_error** error);
/** Whether every point of a is in b. */
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
  size_t bytes;        /**< The memory in bytes, which copies share. */
  bool is_empty;       /**< Whether the set has no direction. */
  bool is_whole;       /**< Whether the set is the whole sphere. */
  bool is_closed;      /**< Whether the set contains its boundary. */
  bool is_open;        /**< Whether the set contains no point of its boundary. */
} plumb_sphere_set_info;
#define PLUMB_SPHERE_SET_INFO_INIT \
  { sizeof(plumb_sphere_set_info), 0, 0, 0, 0, 0, false, false, false, false }
/** Fills `info`. O(n). */
PLUMB_API plumb_status plumb_sphere_set_describe(const plumb_sphere_set* set,
                                                 plumb_sphere_set_info* info, plumb_error** error);
/** Sets locations[i] to the cell that contains direction i: a point (dimension 0), arc (1) or face
 * (2). `directions` contains three numbers for each direction, and `locations` has `count`
 * entries. */
PLUMB_API plumb_status plumb_sphere_set_locate(const plumb_sphere_set* set,
                                               const plumb_numbers* directions,
                                               plumb_location* locations, size_t count,
                                               const plumb_context* context, plumb_error** error);
/** Walks along a great circle, and finds the first cell on the walk that belongs to the set; see
 * plumb_solid_shoot(). `walk` contains six numbers, three for each of two directions. The walk
 * starts at the first direction, takes the shorter way to the second direction, and continues along
 * the circle until it returns to the start. */
PLUMB_API plumb_status plumb_sphere_set_shoot(const plumb_sphere_set* set,
                                              const plumb_numbers* walk, bool to_boundary,
                                              bool* is_hit, plumb_location* location,
                                              plumb_numbers** point, const plumb_context* context,
                                              plumb_error** error);

/* ---- maps ----------------------------------------------------------------------------------- */

/** A map as a user lists it: points, and cycles of indices of points. plumb_map_check() decides
 * whether it is a planar subdivision. */
typedef struct plumb_map plumb_map;

/** Makes a map. Cycle c has the corners corners[cycle_begin[c]] to corners[cycle_begin[c + 1] - 1];
 * cycle_begin has cycle_count + 1 entries, from 0 to corner_count. */
PLUMB_API plumb_status plumb_map_from_cycles(const double* xy, size_t point_count,
                                             const uint32_t* cycle_begin, size_t cycle_count,
                                             const uint32_t* corners, size_t corner_count,
                                             plumb_map** out, plumb_error** error);
/** Makes a map whose points have exact coordinates. `points` contains two numbers for each point.
 * The other arrays are those of plumb_map_from_cycles(). */
PLUMB_API plumb_status plumb_map_from_exact_cycles(const plumb_numbers* points,
                                                   const uint32_t* cycle_begin, size_t cycle_count,
                                                   const uint32_t* corners, size_t corner_count,
                                                   plumb_map** out, plumb_error** error);
/** Reads the text of a map from memory. */
PLUMB_API plumb_status plumb_map_read(const char* text, size_t size,
                                      const plumb_read_options* options, plumb_map** out,
                                      const plumb_context* context, plumb_error** error);
/** Reads a map from a file. The file contains a map, or polygons in WKT, GeoJSON or WKB that cover
 * an area. *is_polygons receives true if it contains polygons. `is_polygons` and `notes` may be
 * null. Polygons do not list outer boundaries, so such a map must be checked with
 * PLUMB_OUTER_INFER. */
PLUMB_API plumb_status plumb_map_read_file(const char* path, const plumb_read_options* options,
                                           plumb_map** out, bool* is_polygons, plumb_notes** notes,
                                           const plumb_context* context, plumb_error** error);
/** Writes the text of a map, without loss. */
PLUMB_API plumb_status plumb_map_write(const plumb_map* map, plumb_bytes** out,
                                       plumb_error** error);
/** Returns the number of listed points. */
PLUMB_API size_t plumb_map_point_count(const plumb_map* map);
/** Returns the number of listed cycles. */
PLUMB_API size_t plumb_map_cycle_count(const plumb_map* map);
/** Returns the coordinates x y of all points, rounded to the nearest doubles. */
PLUMB_API const double* plumb_map_points(const plumb_map* map);
/** The offset of each cycle. */
PLUMB_API const uint32_t* plumb_map_cycle_begin(const plumb_map* map);
/** The corners of all cycles. */
PLUMB_API const uint32_t* plumb_map_corners(const plumb_map* map);
PLUMB_API void plumb_map_free(plumb_map* map); /**< Releases a map. */

/** The requirement on the outer boundaries of components. */
enum plumb_outer {
  PLUMB_OUTER_LISTED = 0, /**< Outer boundaries must be listed, clockwise. */
  PLUMB_OUTER_INFER = 1,  /**< Missing outer boundaries are added. */
  PLUMB_OUTER_IGNORE = 2  /**< Outer boundaries may be missing. */
};
/** Options of plumb_map_check(). */
typedef struct plumb_map_options {
  size_t struct_size;   /**< sizeof(plumb_map_options). */
  int outer;            /**< A constant of plumb_outer. */
  bool merge_vertices;  /**< Whether vertices with equal coordinates are merged first. */
  bool name_places;     /**< Whether hints name vertices by coordinates instead of numbers. */
  uint64_t max_defects; /**< The greatest number of defects that are described. */
} plumb_map_options;
#define PLUMB_MAP_OPTIONS_INIT \
  { sizeof(plumb_map_options), 0, false, false, 1000 }
/** The verdict on a map. */
enum plumb_verdict {
  PLUMB_MAP_VALID = 0,      /**< A planar subdivision. */
  PLUMB_MAP_NOT_PLANAR = 1, /**< A directed edge is used twice. */
  /** A directed edge lacks its twin, the same edge in the opposite direction. */
  PLUMB_MAP_OPEN = 2,
  PLUMB_MAP_SUPERPOSED = 3 /**< Edges cross, or regions overlap. */
};
/** The kinds of defects. */
enum plumb_defect_kind {
  PLUMB_DEFECT_DUPLICATE = 0, /**< A directed edge is used more than once. */
  PLUMB_DEFECT_OPEN = 1,      /**< A directed edge lacks its twin. */
  PLUMB_DEFECT_CROSSING = 2,  /**< Two edges have a common point that is not a common vertex. */
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
  size_t vertices;    /**< The number of listed vertices. */
  size_t edges;       /**< The number of undirected edges. */
  size_t cycles;      /**< The number of cycles, including those that were added. */
  size_t components;  /**< The number of connected components. */
  size_t regions;     /**< Regions of a valid map, including the unbounded region; otherwise 0. */
  /** The number of duplicate defects. This and the following counts also include the defects that
   * are not described. */
  uint64_t duplicate;
  uint64_t open;     /**< The number of open defects. */
  uint64_t crossing; /**< The number of crossing defects. */
  uint64_t twin;     /**< The number of twin defects. */
  /** The number of mixed defects; known only if `duplicate`, `open` and `crossing` are 0. */
  uint64_t mixed;
  uint64_t nested; /**< The number of nested defects. */
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
  const uint32_t* cycles; /**< The cycles at which the defect occurs. */
  size_t cycle_count;     /**< The number of these cycles. */
  const uint32_t* edges;  /**< The edges at which the defect occurs, as pairs of vertices. */
  size_t edge_count;      /**< The number of these edges. */
  /** The exact x-coordinate of the defect as "p/q"; null if the defect has no point. */
  const char* x;
  const char* y;    /**< The exact y-coordinate, in the same form. */
  double near_x;    /**< The double nearest to x. */
  double near_y;    /**< The double nearest to y. */
  const char* hint; /**< What is wrong and how to correct it. */
} plumb_map_defect;
#define PLUMB_MAP_DEFECT_INIT \
  { sizeof(plumb_map_defect), 0, NULL, 0, NULL, 0, NULL, NULL, 0, 0, NULL }
/** Returns the number of described defects. */
PLUMB_API size_t plumb_map_report_defect_count(const plumb_map_report* report);
/** Fills `defect` with defect i. */
PLUMB_API plumb_status plumb_map_report_defect(const plumb_map_report* report, size_t i,
                                               plumb_map_defect* defect, plumb_error** error);
/** Returns the warnings, which the report owns. A warning reports something unusual that is not a
 * defect. */
PLUMB_API const plumb_notes* plumb_map_report_warnings(const plumb_map_report* report);
/** Returns the cycles that bound region i of a valid map. If i > 0, the outer cycle comes first.
 * The cycles of the holes follow. `count` receives the number of cycles. */
PLUMB_API const uint32_t* plumb_map_report_region(const plumb_map_report* report, size_t i,
                                                  size_t* count);
/** Writes the report as "text", "json", "geojson", "svg", "html", "glb" or "png". `title` is for
 * pictures and may be null. */
PLUMB_API plumb_status plumb_map_report_write(const plumb_map_report* report, const char* format,
                                              const char* title, plumb_bytes** out,
                                              plumb_error** error);
/** Makes the checked map. In this map, vertices are merged and outer cycles are added if the
 * options of the check asked for it. */
PLUMB_API plumb_status plumb_map_report_map(const plumb_map_report* report, plumb_map** out,
                                            plumb_error** error);
/** Makes the union of some regions of a valid map. `chosen` has an entry for each region, which is
 * true if the region belongs to the union. */
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
/** Returns two indices for each face: the region of the first map and the region of the second map
 * that contain the face. */
PLUMB_API const uint32_t* plumb_overlay_regions(const plumb_overlay* overlay);
/** Returns the exact areas of all faces. The entry of an unbounded face is 0. */
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

/** Polygons on a triangle mesh. A scene can be changed, and is the input for the division of a
 * surface. */
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
/** Writes the scene as JSON. `model` is the path of the file that contains the mesh. This path is
 * written into the scene. */
PLUMB_API plumb_status plumb_scene_write(const plumb_scene* scene, const char* model,
                                         plumb_bytes** out, plumb_error** error);
/** Adds a point of a face. `weights` contains two numbers: the barycentric weights u and v of the
 * second and the third corner of the face. *index receives the index of the point. */
PLUMB_API plumb_status plumb_scene_add_point(plumb_scene* scene, uint32_t face,
                                             const plumb_numbers* weights, uint32_t* index,
                                             plumb_error** error);
/** Adds the closed polygon through points, which are joined by geodesics. Fails with
 * PLUMB_BAD_SHAPE if no path joins two consecutive points. *index receives the index of the
 * polygon. */
PLUMB_API plumb_status plumb_scene_add_polygon(plumb_scene* scene, const uint32_t* points,
                                               size_t count, uint32_t* index,
                                               const plumb_context* context, plumb_error** error);
/** Adds the shape that is the sum of the given polygons. If a scene has no shapes, each polygon
 * counts as a shape. */
PLUMB_API plumb_status plumb_scene_add_shape(plumb_scene* scene, const uint32_t* polygons,
                                             size_t count, uint32_t* index, plumb_error** error);
/** Sets the face that determines where labels are 0: at the first corner of this face, the label of
 * every shape is 0. */
PLUMB_API plumb_status plumb_scene_set_outside(plumb_scene* scene, uint32_t face,
                                               plumb_error** error);
/** Makes all shapes separate the surface. If a shape does not separate the surface, the function
 * adds loops around handles to the shape. *added receives the number of these loops; `added` may be
 * null. */
PLUMB_API plumb_status plumb_scene_separate(plumb_scene* scene, size_t* added,
                                            const plumb_context* context, plumb_error** error);
/** A polyline on a surface. */
typedef struct plumb_path plumb_path;
/** Selects the kind of path that is traced. */
typedef enum plumb_path_choice {
  PLUMB_PATH_LOCAL = 0,   /**< A locally shortest path, which is found fast. */
  PLUMB_PATH_SHORTEST = 1 /**< No other path is shorter by more than 2^-40 of its length. */
} plumb_path_choice;
/** Traces a geodesic between two points of the scene. If the points lie on different components,
 * the path has no points. */
PLUMB_API plumb_status plumb_scene_trace(const plumb_scene* scene, uint32_t from, uint32_t to,
                                         plumb_path_choice choice, plumb_path** out,
                                         const plumb_context* context, plumb_error** error);
PLUMB_API size_t plumb_path_count(const plumb_path* path); /**< Returns the number of points. */
PLUMB_API const double* plumb_path_points(const plumb_path* path); /**< Rounded coordinates. */
/** Returns the face of each segment. There is one segment fewer than points. */
PLUMB_API const uint32_t* plumb_path_faces(const plumb_path* path);
PLUMB_API double plumb_path_length(const plumb_path* path); /**< Returns the rounded length. */
PLUMB_API void plumb_path_free(plumb_path* path);           /**< Releases a path. */
PLUMB_API size_t plumb_scene_polygon_count(const plumb_scene* scene); /**< Polygons. */
PLUMB_API void plumb_scene_free(plumb_scene* scene);                  /**< Releases a scene. */

/** A surface that polygons divide into cells. */
typedef struct plumb_surface plumb_surface;
/** A label: the number of times that a shape winds around a cell. */
typedef struct plumb_label {
  uint32_t shape; /**< The shape. */
  int32_t value;  /**< The number, which is not 0. */
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
/** Returns the labels of a cell, in ascending order of shapes. `count` receives the number of
 * labels. */
PLUMB_API const plumb_label* plumb_surface_labels(const plumb_surface* surface, size_t cell,
                                                  size_t* count);
/** Returns the rounded area of a cell. */
PLUMB_API double plumb_surface_area(const plumb_surface* surface, size_t cell);
/** Returns pairs of neighbouring cells. `count` receives the number of pairs. */
PLUMB_API const uint32_t* plumb_surface_neighbours(const plumb_surface* surface, size_t* count);
/** Finds whether a shape separates the surface. *over_integers receives true if the shape has
 * integer labels, and *modulo_2 receives true if it has labels modulo 2. */
PLUMB_API plumb_status plumb_surface_separates(const plumb_surface* surface, size_t shape,
                                               bool* over_integers, bool* modulo_2,
                                               plumb_error** error);
/** Makes the triangles of the divided surface. *cells receives the cell of each triangle. */
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
 * or s0, s1, ... `rule` states which labels count as inside; by default, these are the odd
 * labels. */
PLUMB_API plumb_status plumb_surface_evaluate(const plumb_surface* surface, const char* expression,
                                              int rule, plumb_region** out,
                                              const plumb_context* context, plumb_error** error);
PLUMB_API size_t plumb_region_cell_count(const plumb_region* region); /**< Selected cells. */
/** Polygons around the selected cells. */
PLUMB_API size_t plumb_region_loop_count(const plumb_region* region);
/** The rounded area of the selected cells. */
PLUMB_API double plumb_region_area(const plumb_region* region);
/** Whether a cell is selected. */
PLUMB_API bool plumb_region_has(const plumb_region* region, size_t cell);
/** Makes a scene for further operations. Its only shape is the region. */
PLUMB_API plumb_status plumb_region_to_scene(const plumb_region* region, plumb_scene** out,
                                             plumb_error** error);
PLUMB_API void plumb_region_free(plumb_region* region); /**< Releases a region. */

/** Writes the triangles of cells as "obj", "ply" or "glb", or their graph as "dot". `region` must
 * be a region of this surface. If it is null, all cells are written. */
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

/** Whether the arithmetic of this process satisfies the assumptions of exact predicates. `notes`
 * may be null. Otherwise it receives warnings about violated assumptions, and notes about unusual
 * settings. */
PLUMB_API plumb_status plumb_self_test(bool* is_ok, plumb_notes** notes, plumb_error** error);

/* ---- models --------------------------------------------------------------------------------- */

/** Makes the closed box with these side lengths. If is_centred is true, its centre is the origin.
 * Otherwise its lowest corner is the origin. */
PLUMB_API plumb_status plumb_solid_box(const double size[3], bool is_centred, plumb_solid** out,
                                       const plumb_context* context, plumb_error** error);
/** Makes a ball around the origin. Its equator has `chords` corners. The ball is exactly convex. */
PLUMB_API plumb_status plumb_solid_sphere(double radius, uint32_t chords, plumb_solid** out,
                                          const plumb_context* context, plumb_error** error);
/** Makes a cylinder along the z-axis, or a cone or a frustum if the radii differ. */
PLUMB_API plumb_status plumb_solid_cylinder(double height, double bottom_radius, double top_radius,
                                            uint32_t chords, bool is_centred, plumb_solid** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes a torus around the z-axis. `radius` is the distance of the centre of the tube from the
 * axis. */
PLUMB_API plumb_status plumb_solid_torus(double radius, double tube_radius, uint32_t chords,
                                         uint32_t tube_chords, plumb_solid** out,
                                         const plumb_context* context, plumb_error** error);
/** Makes the exact convex hull of points. `xyz` has 3 * count doubles. */
PLUMB_API plumb_status plumb_solid_hull(const double* xyz, size_t count, plumb_solid** out,
                                        const plumb_context* context, plumb_error** error);
/** Makes the convex hull of exact points. `points` contains three numbers for each point. */
PLUMB_API plumb_status plumb_solid_hull_exact(const plumb_numbers* points, plumb_solid** out,
                                              const plumb_context* context, plumb_error** error);
/** Makes the convex hull of the union of several bounded solids, as a closed solid. */
PLUMB_API plumb_status plumb_solid_hull_of(const plumb_solid* const* solids, size_t count,
                                           plumb_solid** out, const plumb_context* context,
                                           plumb_error** error);
/** Makes the closed regular polygon with `chords` corners that is inscribed in a circle around the
 * origin. */
PLUMB_API plumb_status plumb_plane_set_disk(double radius, uint32_t chords, plumb_plane_set** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the convex hull of points of the plane. `xy` has 2 * count doubles. */
PLUMB_API plumb_status plumb_plane_set_hull(const double* xy, size_t count, plumb_plane_set** out,
                                            const plumb_context* context, plumb_error** error);
/** Makes the convex hull of exact points. `points` contains two numbers for each point. */
PLUMB_API plumb_status plumb_plane_set_hull_exact(const plumb_numbers* points,
                                                  plumb_plane_set** out,
                                                  const plumb_context* context,
                                                  plumb_error** error);
/** Makes the convex hull of the union of several bounded sets, as a closed set. */
PLUMB_API plumb_status plumb_plane_set_hull_of(const plumb_plane_set* const* sets, size_t count,
                                               plumb_plane_set** out, const plumb_context* context,
                                               plumb_error** error);

/** Options of plumb_plane_set_extrude(). */
typedef struct plumb_extrusion {
  size_t struct_size; /**< sizeof(plumb_extrusion). */
  double height;      /**< The height, which must be positive. */
  /** Whether the solid extends from -height / 2 to height / 2 instead of from 0 to height. */
  bool is_centred;
  double twist;    /**< The angle in degrees by which the top is turned clockwise. */
  uint32_t layers; /**< The number of layers of equal height; at least 1. */
  double scale[2]; /**< Factors of x and y at the top. */
} plumb_extrusion;
#define PLUMB_EXTRUSION_INIT                                  \
  {                                                           \
    sizeof(plumb_extrusion), 1.0, false, 0.0, 1, { 1.0, 1.0 } \
  }
/** Makes the closed solid between an outline at the bottom and its image at the top. */
PLUMB_API plumb_status plumb_plane_set_extrude(const plumb_plane_set* outline,
                                               const plumb_extrusion* options, plumb_solid** out,
                                               const plumb_context* context, plumb_error** error);
/** Makes the closed solid that an outline sweeps when it turns around the z-axis. First, the y-axis
 * of the outline is placed on the z-axis. `angle` is the angle of the turn in degrees, which is
 * divided into `steps` equal steps. */
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
/** Grows the closure of the solid if `distance` is positive, and shrinks it if `distance` is
 * negative.
 * The ball of the offset is replaced by a polyhedron: an octahedron whose faces were subdivided
 * `rounds` times (at most 7), with its corners on the sphere. */
PLUMB_API plumb_status plumb_solid_offset(const plumb_solid* solid, double distance,
                                          uint32_t rounds, plumb_solid** out,
                                          const plumb_context* context, plumb_error** error);
/** Finds nearest points of the closures of two solids. The list *out receives seven numbers: the
 * square of the distance, the nearest point of a, and the nearest point of b. The entries cells[0]
 * and cells[1] receive the cells of a and b that contain these points; `cells` may be null. */
PLUMB_API plumb_status plumb_solid_distance(const plumb_solid* a, const plumb_solid* b,
                                            plumb_numbers** out, plumb_location cells[2],
                                            const plumb_context* context, plumb_error** error);
/** Makes the connected components of the solid. */
PLUMB_API plumb_status plumb_solid_components(const plumb_solid* solid, plumb_solid_list** out,
                                              const plumb_context* context, plumb_error** error);
/** Sets *genus to the number of handles of the boundary. If the boundary is not a closed surface,
 * *is_surface is set to false and *genus to 0. */
PLUMB_API plumb_status plumb_solid_genus(const plumb_solid* solid, bool* is_surface,
                                         uint64_t* genus, plumb_error** error);
/** Returns the bounding box as six numbers: the least coordinates, and then the greatest
 * coordinates. The list is empty if the solid is empty. */
PLUMB_API plumb_status plumb_solid_bounding_box(const plumb_solid* solid, plumb_numbers** out,
                                                plumb_error** error);

/** Returns the rotation about an axis through the origin, as 12 numbers for
 * plumb_solid_transform(). Its matrix is exactly orthogonal. A rotation about a coordinate axis by
 * a multiple of 90 degrees is exact; other rotations have a small error in the angle. */
PLUMB_API plumb_status plumb_numbers_rotation(const double axis[3], double degrees,
                                              plumb_numbers** out, plumb_error** error);
/** Returns the scaling along the axes by three factors, as 12 numbers. */
PLUMB_API plumb_status plumb_numbers_scaling(const plumb_numbers* factors, plumb_numbers** out,
                                             plumb_error** error);
/** Returns the reflection in the plane through the origin with the given normal, as 12 numbers. */
PLUMB_API plumb_status plumb_numbers_reflection(const plumb_numbers* normal, plumb_numbers** out,
                                                plumb_error** error);
/** Returns the scaling after which the bounding box of a solid has the given sizes, as 12 numbers.
 * Along an axis whose entry in `size` is 0, the factor is 1. If the entry of this axis in
 * `is_automatic` is true, the factor is instead the greatest factor of the other axes.
 * `is_automatic` may be
 * null. */
PLUMB_API plumb_status plumb_numbers_resizing(const plumb_solid* solid, const plumb_numbers* size,
                                              const bool is_automatic[3], plumb_numbers** out,
                                              plumb_error** error);

/** The shape of an offset at a convex corner. */
enum plumb_join {
  PLUMB_JOIN_ROUND = 0, /**< A polygon inscribed in the arc around the corner. */
  /** The moved edges are prolonged until they meet; beyond the mitre limit, the join is square. */
  PLUMB_JOIN_MITRE = 1,
  /** The moved edges are cut off at the distance of the offset from the corner. */
  PLUMB_JOIN_SQUARE = 2,
  PLUMB_JOIN_BEVEL = 3 /**< A segment between the ends of the moved edges. */
};
/** Options of plumb_plane_set_offset(): the treatment of corners. */
typedef struct plumb_offset_options {
  size_t struct_size; /**< sizeof(plumb_offset_options). */
  int join;           /**< A constant of plumb_join. */
  /** The greatest length of a mitre, divided by the distance of the offset; at least 1. */
  double mitre_limit;
  /** The greatest distance of an arc from its chords; 0 stands for a thousandth of the distance. */
  double chord_error;
  /** The number of chords of a full circle. If this number is 0, chord_error determines the
   * chords. */
  uint32_t circle_segments;
} plumb_offset_options;
#define PLUMB_OFFSET_OPTIONS_INIT \
  { sizeof(plumb_offset_options), 0, 2.0, 0.0, 0 }
/** Grows the closure of the set if `distance` is positive, and shrinks it if `distance` is
 * negative. */
PLUMB_API plumb_status plumb_plane_set_offset(const plumb_plane_set* set, double distance,
                                              const plumb_offset_options* options,
                                              plumb_plane_set** out, const plumb_context* context,
                                              plumb_error** error);
/** Makes the closure of a bounded set with fewer corners. A corner and its two neighbours form a
 * triangle. A corner is removed only under three conditions. The area of its triangle is at most
 * `tolerance`. More than the fraction `kept` of all removable corners is left. No point of a border
 * moves farther than `within`. Infinity means that there is no bound. Coordinates are rounded to
 * doubles. If `moved` is not null, it receives a bound for the distance by which borders have
 * moved. */
PLUMB_API plumb_status plumb_plane_set_simplify(const plumb_plane_set* set, double tolerance,
                                                double kept, double within, plumb_plane_set** out,
                                                double* moved, const plumb_context* context,
                                                plumb_error** error);
/** A report on the changes that a simplification has made. Integer members except struct_size count
 * the things that their comments describe. */
typedef struct plumb_simplify_report {
  size_t struct_size;      /**< sizeof(plumb_simplify_report). */
  uint64_t corners_before; /**< The corners of the original borders. */
  uint64_t corners_after;  /**< The corners of the simplified borders. */
  /** Corners of a layer that cannot be removed because three or more borders meet there. For a set
   * of the plane, this number is 0. */
  uint64_t fixed;
  /** Corners that the bounds allow the function to remove. They are kept for another reason: their
   * triangle contains another corner, or a ring would collapse. */
  uint64_t blocked;
  /** Overlaps of features of a layer, which went to the first feature. For a set of the plane, this
   * number is 0. */
  uint64_t overlaps;
  double borders_moved; /**< A bound for the distance by which borders have moved. */
  double
      rounding_moved; /**< A bound for the distance by which rounding has moved borders before. */
} plumb_simplify_report;
#define PLUMB_SIMPLIFY_REPORT_INIT \
  { sizeof(plumb_simplify_report), 0, 0, 0, 0, 0, 0.0, 0.0 }
/** Does the same as plumb_plane_set_simplify(), and fills a report, which may be null. */
PLUMB_API plumb_status plumb_plane_set_simplify_with_report(
    const plumb_plane_set* set, double tolerance, double kept, double within, plumb_plane_set** out,
    plumb_simplify_report* report, const plumb_context* context, plumb_error** error);
/** Finds nearest points of the closures of two sets. The list *out receives five numbers: the
 * square of the distance, the nearest point of a, and the nearest point of b. The entries cells[0]
 * and cells[1] receive the cells of a and b that contain these points; `cells` may be null. */
PLUMB_API plumb_status plumb_plane_set_distance(const plumb_plane_set* a, const plumb_plane_set* b,
                                                plumb_numbers** out, plumb_location cells[2],
                                                const plumb_context* context, plumb_error** error);
/** Makes { a + b : a in A, b in B }. */
PLUMB_API plumb_status plumb_plane_set_minkowski_sum(const plumb_plane_set* a,
                                                     const plumb_plane_set* b,
                                                     plumb_plane_set** out,
                                                     const plumb_context* context,
                                                     plumb_error** error);

/** Rounds the coordinates of a bounded set to doubles, and makes the constrained Delaunay
 * triangulation of the result. The result is a mesh whose points have z = 0. */
PLUMB_API plumb_status plumb_plane_set_triangulate(const plumb_plane_set* set, plumb_mesh** out,
                                                   const plumb_context* context,
                                                   plumb_error** error);
/** Makes the Delaunay triangulation of points. `xy` has 2 * count doubles. The points of the mesh
 * are the given points, with z = 0. */
PLUMB_API plumb_status plumb_mesh_delaunay(const double* xy, size_t count, plumb_mesh** out,
                                           const plumb_context* context, plumb_error** error);

/** States which files a model of OpenSCAD may import. */
enum plumb_imports {
  PLUMB_IMPORTS_BELOW = 0,   /**< Files in the folder of the model, and in folders below it. */
  PLUMB_IMPORTS_NONE = 1,    /**< No files: imports are refused. */
  PLUMB_IMPORTS_ANYWHERE = 2 /**< All files. */
};
/** Evaluates a flattened model of OpenSCAD (.csg) in memory. If the model is a set of space, *solid
 * receives this set and *set is null. If it is a set of the plane, *set receives this set and
 * *solid is null. If the model has no geometry, both are null. The colours of a model become
 * materials of the sources of the solid. */
PLUMB_API plumb_status plumb_csg_read(const char* bytes, size_t size,
                                      const plumb_read_options* options, int imports,
                                      plumb_solid** solid, plumb_plane_set** set,
                                      plumb_notes** notes, const plumb_context* context,
                                      plumb_error** error);
/** Evaluates a model in a file, like plumb_csg_read(). */
PLUMB_API plumb_status plumb_csg_read_file(const char* path, const plumb_read_options* options,
                                           int imports, plumb_solid** solid, plumb_plane_set** set,
                                           plumb_notes** notes, const plumb_context* context,
                                           plumb_error** error);

/* ---- layers --------------------------------------------------------------------------------- */

/** Features with ids, properties and polygons, such as countries. */
typedef struct plumb_layer plumb_layer;
/** Reads GeoJSON, TopoJSON, WKT or WKB. `object` is the name of an object of TopoJSON; null stands
 * for the first object. */
PLUMB_API plumb_status plumb_layer_read(const char* bytes, size_t size,
                                        const plumb_read_options* options, const char* object,
                                        plumb_layer** out, plumb_notes** notes,
                                        const plumb_context* context, plumb_error** error);
/** Reads a file. The path "-" stands for standard input. */
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
/** Divides a set into the parts that the features of a layer cover. Each part becomes a feature
 * with the id and the properties of the feature that covers it. A part that several features cover
 * is assigned to the first of them. Parts that no feature covers form the last feature, which has
 * no id. */
PLUMB_API plumb_status plumb_layer_parts(const plumb_layer* layer, const plumb_plane_set* set,
                                         plumb_layer** out, const plumb_context* context,
                                         plumb_error** error);
/** Makes a layer of all features of `first`, followed by all features of `second`. */
PLUMB_API plumb_status plumb_layer_join(const plumb_layer* first, const plumb_layer* second,
                                        plumb_layer** out, const plumb_context* context,
                                        plumb_error** error);
/** Writes "geojson", "topojson" or "wkt". */
PLUMB_API plumb_status plumb_layer_write(const plumb_layer* layer, const char* format,
                                         plumb_bytes** out, const plumb_context* context,
                                         plumb_error** error);
/** Writes a file. If writing fails, no incomplete file remains. If `format` is null, the extension
 * determines it. */
PLUMB_API plumb_status plumb_layer_write_file(const plumb_layer* layer, const char* path,
                                              const char* format, const plumb_context* context,
                                              plumb_error** error);
PLUMB_API size_t plumb_layer_feature_count(const plumb_layer* layer); /**< Returns the features. */
/** Returns the id of a feature as a JSON text, which is empty if the feature has no id. */
PLUMB_API plumb_status plumb_layer_id(const plumb_layer* layer, size_t feature, plumb_bytes** out,
                                      plumb_error** error);
/** Returns the properties of a feature as a JSON text, which is empty if the feature has no
 * properties. */
PLUMB_API plumb_status plumb_layer_properties(const plumb_layer* layer, size_t feature,
                                              plumb_bytes** out, plumb_error** error);
/** Returns the name of the coordinate reference system that the file of the layer states, or an
 * empty text. Operations pass it on, and GeoJSON is written with it. Coordinates are never
 * converted. */
PLUMB_API plumb_status plumb_layer_crs(const plumb_layer* layer, plumb_bytes** out,
                                       plumb_error** error);
/** Finds the feature whose id is `id_or_name`. If there is none, finds the feature whose property
 * "name" or "NAME" is `id_or_name`. Fails with PLUMB_BAD_ARGUMENT if no feature or more than one
 * feature is found. */
PLUMB_API plumb_status plumb_layer_find(const plumb_layer* layer, const char* id_or_name,
                                        uint32_t* feature, plumb_error** error);
PLUMB_API void plumb_layer_free(plumb_layer* layer); /**< Releases a layer. */

/** Selects the feature that gets an overlap or a gap. */
enum plumb_owner {
  /** The feature with the longest common border with the region. */
  PLUMB_OWNER_LONGEST_BORDER = 0,
  PLUMB_OWNER_LARGEST = 1,  /**< The feature with the largest area. */
  PLUMB_OWNER_SMALLEST = 2, /**< The feature with the smallest area. */
  PLUMB_OWNER_FIRST = 3,    /**< The feature that comes first in the layer. */
  /** The feature with the lowest id. Ids that are numbers are lower than ids that are texts.
   * Numbers are ordered by value, and texts by their bytes. Features without an id come last. */
  PLUMB_OWNER_LOWEST_ID = 4
};
/** The kinds of regions in a plumb_layer_report. */
enum plumb_layer_region_kind {
  PLUMB_LAYER_OVERLAP = 0, /**< A region that several features cover. */
  PLUMB_LAYER_GAP = 1,     /**< A narrow region that no feature covers. */
  PLUMB_LAYER_HOLE = 2,    /**< A wide region that no feature covers. Such a region is no defect. */
  /** A point at which the border of a feature crosses itself, or edges on which it lies twice. */
  PLUMB_LAYER_CROSSING = 3,
  /** A ring that is listed as a hole, but lies outside of the outer ring or in another hole. */
  PLUMB_LAYER_NESTING = 4
};
/** The overlaps, gaps, holes, crossings and nestings that plumb_layer_check() or
 * plumb_layer_repair() found. */
typedef struct plumb_layer_report plumb_layer_report;
/** Makes the layer without overlaps and gaps. `owner` is a constant of plumb_owner. An enclosed
 * region that no feature covers is a gap if it is narrower than `gaps_below`; a negative number
 * stands for 1/10000 of the diagonal of the layer. If `gaps_below` is negative, narrow regions that
 * look like small lakes are not gaps. `report` may be null. */
PLUMB_API plumb_status plumb_layer_repair(const plumb_layer* layer, int owner, double gaps_below,
                                          plumb_layer** out, plumb_layer_report** report,
                                          const plumb_context* context, plumb_error** error);
/** Makes the report of the overlaps, gaps, holes, crossings and nestings of a layer. The regions of
 * the report have no owners. */
PLUMB_API plumb_status plumb_layer_check(const plumb_layer* layer, double gaps_below,
                                         plumb_layer_report** out, const plumb_context* context,
                                         plumb_error** error);
/** Options of plumb_layer_repair_with() and plumb_layer_check_with(). */
typedef struct plumb_layer_options {
  size_t struct_size; /**< sizeof(plumb_layer_options). */
  int owner;          /**< A constant of plumb_owner. */
  /** Whether gaps that open to the outside or into a hole stay as they are. */
  bool enclosed_only;
  double gaps_below; /**< The bound for the widths of gaps; see plumb_layer_repair(). */
  /** For PLUMB_OWNER_FIRST: ranks[f] is the rank of feature f. Of the features that may get a
   * region, the feature with the least rank gets it. If ranks are equal, the feature that comes
   * first in the layer gets it. If `ranks` is null, all ranks are equal. */
  const uint32_t* ranks;
  size_t rank_count; /**< The number of ranks, which is 0 or the number of features. */
  /** Pairs of features, which are applied before the rule `owner`. If both features of a pair may
   * get a region, the second feature of the pair is left out. But if this would leave out all
   * features, no feature is left out. */
  const uint32_t* preferences;
  size_t preference_count; /**< The number of pairs; `preferences` has twice as many entries. */
} plumb_layer_options;
#define PLUMB_LAYER_OPTIONS_INIT \
  { sizeof(plumb_layer_options), 0, false, -1.0, NULL, 0, NULL, 0 }
/** Does the same as plumb_layer_repair(), with options, which may be null. */
PLUMB_API plumb_status plumb_layer_repair_with(const plumb_layer* layer,
                                               const plumb_layer_options* options,
                                               plumb_layer** out, plumb_layer_report** report,
                                               const plumb_context* context, plumb_error** error);
/** Does the same as plumb_layer_check(), with options, which may be null. Only `enclosed_only` and
 * `gaps_below` matter. */
PLUMB_API plumb_status plumb_layer_check_with(const plumb_layer* layer,
                                              const plumb_layer_options* options,
                                              plumb_layer_report** out,
                                              const plumb_context* context, plumb_error** error);
/** Makes a layer with one feature for each group. groups[f] is the group of feature f, which is
 * less than group_count. If groups[f] is 0xffffffff, feature f is left out. `count` is the number
 * of features. */
PLUMB_API plumb_status plumb_layer_dissolve(const plumb_layer* layer, const uint32_t* groups,
                                            size_t count, size_t group_count, plumb_layer** out,
                                            const plumb_context* context, plumb_error** error);
/** Selects the pairs that plumb_layer_overlay() keeps. One feature of a pair can be missing. */
enum plumb_overlay_pairs {
  PLUMB_PAIRS_ALL = 0,       /**< All pairs. */
  PLUMB_PAIRS_FIRST = 1,     /**< Pairs with a feature of the first layer. */
  PLUMB_PAIRS_BOTH = 2,      /**< Pairs with features of both layers. */
  PLUMB_PAIRS_FIRST_ONLY = 3 /**< Pairs with a feature of the first layer only. */
};
/** Makes a layer with a feature for each pair of overlapping features of two layers. A part of a
 * feature that no feature of the other layer covers forms a pair with a missing feature. `pairs`
 * receives the two features of each pair; 0xffffffff stands for a missing feature. */
PLUMB_API plumb_status plumb_layer_overlay(const plumb_layer* first, const plumb_layer* second,
                                           int kept, plumb_layer** out, plumb_indices** pairs,
                                           const plumb_context* context, plumb_error** error);
/** Makes the layer with fewer corners on its borders. The result is a coverage: features do not
 * overlap. A corner and its two neighbours form a triangle. A corner is removed only under two
 * conditions. The area of its triangle is at most `tolerance`, which may be infinite. More than the
 * fraction `kept` of all removable corners is left. */
PLUMB_API plumb_status plumb_layer_simplify(const plumb_layer* layer, double tolerance, double kept,
                                            plumb_layer** out, const plumb_context* context,
                                            plumb_error** error);
/** Does the same as plumb_layer_simplify(), with two additions. No point of a border moves farther
 * than `within`, which may be infinite. The function fills a report, which may be null. */
PLUMB_API plumb_status plumb_layer_simplify_with_report(
    const plumb_layer* layer, double tolerance, double kept, double within, plumb_layer** out,
    plumb_simplify_report* report, const plumb_context* context, plumb_error** error);
/** Returns the number of regions of a report. */
PLUMB_API size_t plumb_layer_report_count(const plumb_layer_report* report);
/** Whether the layer has overlaps, gaps, crossings or nestings. */
PLUMB_API bool plumb_layer_report_has_defects(const plumb_layer_report* report);
/** Returns the kind of region i, a constant of plumb_layer_region_kind; -1 if there is none. */
PLUMB_API int plumb_layer_report_kind(const plumb_layer_report* report, size_t i);
/** Whether region i is a gap that opens to the outside or into a hole. */
PLUMB_API bool plumb_layer_report_is_open(const plumb_layer_report* report, size_t i);
/** Returns the exact area of region i as a list of one number. */
PLUMB_API plumb_status plumb_layer_report_area(const plumb_layer_report* report, size_t i,
                                               plumb_numbers** out, plumb_error** error);
/** Returns twice the area divided by the perimeter of region i. */
PLUMB_API double plumb_layer_report_width(const plumb_layer_report* report, size_t i);
/** Stores a place to look at in `xy`: the point of a crossing, or a corner of another region.
 * Returns false if there is no such region, or if rounding leaves nothing of it. */
PLUMB_API bool plumb_layer_report_place(const plumb_layer_report* report, size_t i, double xy[2]);
/** Returns the features of region i. `count` receives the number of features. */
PLUMB_API const uint32_t* plumb_layer_report_features(const plumb_layer_report* report, size_t i,
                                                      size_t* count);
/** Returns the feature that gets region i, or 0xffffffff if no feature gets it. */
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
