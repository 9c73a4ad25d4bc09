// What the readers and writers of mesh files have in common: a collector of points and faces that
// charges a context, the welding of equal vertices, and lines of text.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/lines.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// Collects a mesh. Strings given to it must outlive it. Limits are thrown without a place; readers
/// add it (input_cursors.h).
class MeshCollector {
 public:
  explicit MeshCollector(Context& context) : context_(context) {}

  /// Reserves memory for so many points and faces, charged at once. Requires counts that the size
  /// of the file supports.
  void expect(std::uint32_t points, std::uint32_t faces);

  std::uint32_t point_count() const { return static_cast<std::uint32_t>(mesh_.points.size()); }
  std::size_t face_count() const { return mesh_.face_count(); }
  /// Returns the mesh that has been collected so far.
  const PolygonMesh& mesh() const { return mesh_; }

  /// Adds a point. Requires finite coordinates. Negative zeros become zeros.
  void add_point(const Point3& p) {
    if (mesh_.points.size() == charged_points_) charge_points();
    mesh_.points.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  }
  void add_point(const ReadNumber& x, const ReadNumber& y, const ReadNumber& z) {
    if (x.is_double() && y.is_double() && z.is_double()) {
      add_point({x.as_double(), y.as_double(), z.as_double()});
    } else {
      add_exact_point({x.exact(), y.exact(), z.exact()});
    }
  }

  /// Adds a vertex of which a coordinate is not finite, as the point 0 0 0.
  void add_missing_point();
  /// Returns such a vertex if a face of three different corners uses it. Cost: O(n) if there are
  /// such vertices.
  std::optional<std::uint32_t> needed_missing_point() const;

  /// Adds the next corner of the face that end_face() ends.
  void add_corner(std::uint32_t vertex) {
    if (mesh_.corners.size() == charged_corners_) charge_corners();
    mesh_.corners.push_back(vertex);
  }
  /// Ends a face. The mesh has it as the file lists it, even if it repeats a corner or has fewer
  /// than three corners: real files have such faces, and complex_of_mesh() reports them.
  void end_face();

  /// Notes something in the file that no mesh holds, named as in "normals of vertices". It is
  /// reported once.
  void pass_over(std::string_view what) { add_once(what, passed_); }
  /// Does the same for geometry, which the mesh lacks; the report is a warning.
  void leave_out(std::string_view geometry) { add_once(geometry, left_out_); }

  /// Returns the mesh, with a note and a warning about the skipped contents.
  MeshFile take();
  /// Forgets everything and releases the memory that was charged.
  void clear();

 private:
  static void add_once(std::string_view what, std::vector<std::string_view>& list) {
    if (std::find(list.begin(), list.end(), what) == list.end()) list.push_back(what);
  }
  void add_exact_point(const RationalPoint3& p);
  void charge(std::uint64_t bytes) {
    context_.charge_memory(bytes, "the mesh");
    charged_bytes_ += bytes;
  }
  void charge_points();
  void charge_corners();

  Context& context_;
  PolygonMesh mesh_;
  std::vector<std::string_view> passed_;
  std::vector<std::string_view> left_out_;
  std::vector<std::uint32_t> missing_;  // Vertices that are not finite.
  std::uint64_t charged_bytes_ = 0;
  std::uint64_t charged_points_ = 0;
  std::uint64_t charged_corners_ = 0;
  std::uint64_t charged_faces_ = 0;
};

// Welding: vertices at one place become one, for formats that list the corners of every triangle.

/// Makes equal vertices one, exactly, and leaves out the faces that then have a vertex twice in a
/// row and the vertices that no face has. Vertices are in order of their first use by a face.
/// Returns how many faces were left out. Expected cost: O(n). Charges its working memory while it
/// runs. Throws the errors of the Context. If `kept` is not null, it receives the faces that were
/// kept.
std::size_t weld_vertices(PolygonMesh& mesh, Context& context,
                          std::vector<std::uint32_t>* kept = nullptr);

// What the writers of mesh formats have in common.

/// Writes "x y z", as format_double() does.
void write_coordinates(TextOutput& out, const Point3& p);

/// Writes a line for a face: how many corners, and the corners numbered from 0.
void write_face_line(TextOutput& out, std::span<const std::uint32_t> face);

/// Writes a line for each face: how many corners, and the corners numbered from 0.
void write_face_lines(TextOutput& out, const PolygonMesh& mesh);

/// Throws Error{NumberOutOfRange} if a vertex lies beyond the largest double. For writers that
/// round.
void require_doubles(const PolygonMesh& mesh);

/// Does the same as write_mesh() without a context. The threads of the context make the text of OFF
/// and OBJ.
void write_mesh(std::ostream& out, const PolygonMesh& mesh, MeshFormat format, Context& context);

/// Throws Error{BadArgument} if a face is no triangle.
void require_triangles(const PolygonMesh& mesh);

}  // namespace plumb
