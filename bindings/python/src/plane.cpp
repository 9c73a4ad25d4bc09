// plumb.PlaneSet: sets of the plane (Nef2).
//
// The grammar of all sets is in set_grammar.h. The .nef2 file of the canonical form
// (plane_canonical.h) is what hashing and pickling use.
// Tests: tests/test_plane.py, tests/test_laws.py.
#include "page.h"
#include "plane_canonical.h"
#include "plane_traits.h"
#include "plumb/convex/plane_convexity.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text/files.h"
#include "plumb/plane/plane_arrays.h"

namespace plumb::python {
namespace {

using Ring = std::vector<Exact<2>>;

PointTable2 table_of(const std::vector<Ring>& chains, std::vector<std::uint32_t>& corners,
                     std::vector<std::uint32_t>& begin) {
  PointTable2 points;
  begin = {0};
  for (const Ring& chain : chains) {
    for (const Exact<2>& p : chain) {
      corners.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p.value[0], p.value[1]);
    }
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return points;
}

Nef2 polygons(Context& context, const std::vector<Ring>& rings, const std::string& rule,
              bool closed) {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> begin;
  const PointTable2 points = table_of(rings, corners, begin);
  return Nef2::polygons(points, corners, begin, winding_rule(rule), boundary_of(closed), context);
}

Nef2 polylines(Context& context, const std::vector<Ring>& chains) {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> begin;
  const PointTable2 points = table_of(chains, corners, begin);
  return Nef2::polylines(points, corners, begin, context);
}

Nef2 from_rings(Context& context, const Coordinates2& points, const Indices& ring_begin,
                const std::string& rule, bool closed) {
  const PointTable2 table = points_of(points.span());
  std::vector<std::uint32_t> corners(table.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = i;
  const std::span<const std::uint32_t> begin = ring_begin.span();
  bool rises = !begin.empty() && begin.front() == 0 && begin.back() == corners.size();
  for (std::size_t i = 1; i < begin.size(); ++i) rises = rises && begin[i - 1] <= begin[i];
  if (!rises) {
    throw Error(ErrorCode::BadArgument, "ring_begin must rise from 0 to the number of points");
  }
  return Nef2::polygons(table, corners, begin, winding_rule(rule), boundary_of(closed), context);
}

Nef2 box(Context& context, const Exact<2>& low, const Exact<2>& high, bool closed) {
  const Rational& x0 = low.value[0];
  const Rational& y0 = low.value[1];
  const Rational& x1 = high.value[0];
  const Rational& y1 = high.value[1];
  if (x0 > x1 || y0 > y1) return Nef2::empty();
  PointTable2 points;
  points.push_back(x0, y0);
  points.push_back(x1, y0);
  points.push_back(x1, y1);
  points.push_back(x0, y1);
  const std::array<std::uint32_t, 4> corners{0, 1, 2, 3};
  const std::array<std::uint32_t, 2> begin{0, 4};
  return Nef2::polygons(points, corners, begin, WindingRule::NonZero, boundary_of(closed), context);
}

Line2 line_of(const Exact<3>& p) {
  return Line2::from_coefficients(p.value[0], p.value[1], p.value[2]);
}

AffineMap2 plane_map_of(const std::vector<Exact<3>>& rows) {
  if (rows.size() != 2) throw Error(ErrorCode::BadArgument, "the matrix must have two rows");
  const auto& x = rows[0].value;
  const auto& y = rows[1].value;
  return {x[0], x[1], x[2], y[0], y[1], y[2]};
}

Nef2 translated(Context& context, const Nef2& set, const Exact<2>& by) {
  AffineMap2 map;
  map.x0 = by.value[0];
  map.y0 = by.value[1];
  return set.transformed(map, context);
}

CountsOut plane_counts(const Nef2& set) {
  const PlaneCounts n = set.counts();
  CountsOut result;
  result["vertices"] = n.vertices;
  result["edges"] = n.edges;
  result["faces"] = n.faces;
  result["marked_faces"] = n.marked_faces;
  return result;
}

ArrayOut<bool, 1> contains_points(Context& context, const Nef2& set, const Coordinates2& points) {
  const std::span<const double> xy = points.span();
  std::vector<std::uint8_t> marks;
  marks.reserve(xy.size() / 2);
  for (std::size_t i = 0; i < xy.size(); i += 2) {
    marks.push_back(set.contains(Point2{xy[i], xy[i + 1]}, context) ? 1 : 0);
    if (i % 2048 == 0) context.checkpoint("locate", i, xy.size());
  }
  return {std::move(marks)};
}

// --- files ------------------------------------------------------------------------------------

PlaneFormat plane_format(const std::string& name) {
  if (name == "wkt") return PlaneFormat::Wkt;
  if (name == "geojson") return PlaneFormat::GeoJson;
  if (name == "nef2") return PlaneFormat::Nef2;
  if (name == "wkb") return PlaneFormat::Wkb;
  if (name == "dxf") return PlaneFormat::Dxf;
  if (name == "svg") return PlaneFormat::Svg;
  throw Error(ErrorCode::UnknownFormat, "no format for sets of the plane is named '" + name + "'");
}

PlaneFormat format_for(const std::string& path, const std::optional<std::string>& name) {
  if (name) return plane_format(*name);
  if (const auto format = plane_format_of(path)) return *format;
  throw Error(ErrorCode::UnknownFormat,
              "the extension of " + path + " names no format for sets of the plane");
}

PlaneWriteOptions write_options(const std::string& rounding, const std::optional<Number>& grid) {
  PlaneWriteOptions options;
  if (rounding == "nearest") {
    options.rounding = OutputRounding::Nearest;
  } else if (rounding != "valid") {
    throw Error(ErrorCode::BadArgument,
                "rounding must be 'valid' or 'nearest', not '" + rounding + "'");
  }
  if (grid) options.grid = grid->value;
  return options;
}

std::string canonical_bytes(Context& context, const Nef2& set) {
  const PlaneText text(canonical(set, context), PlaneFormat::Nef2, context);
  return written([&](std::ostream& out) { text.write(out, context); });
}

Nef2 from_bytes(Context& context, const std::string& bytes) {
  ReadOptions options;
  options.name = "data";
  return read_plane_set(bytes, guess_plane_format(bytes), options, context).set;
}

void def_plane_files(nb::class_<Nef2>& c) {
  c.def_static(
      "read",
      [](const Path& path, const std::optional<std::string>& format, bool exact_decimals,
         unsigned threads, std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        std::optional<PlaneFormat> chosen;
        if (format) chosen = plane_format(*format);
        ReadOptions options;
        options.exact_decimals = exact_decimals;
        PlaneRead read =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
                [&](Context& k) { return read_plane_set_file(path.string(), chosen, options, k); });
        note(read.notes);
        warn(read.warnings);
        return std::move(read.set);
      },
      "path"_a, "format"_a = nb::none(), "exact_decimals"_a = false, nb::kw_only(),
      "threads"_a = 1U, "timeout"_a = nb::none(), "memory_limit"_a = nb::none(),
      "progress"_a = nb::none(),
      with_limits("Read a set from WKT, GeoJSON, WKB or .nef2. The format is `format` if it is "
                  "given. Otherwise the extension or the contents of the file determine it."));
  c.def(
      "write",
      [](const Nef2& set, const Path& path, const std::optional<std::string>& format,
         const std::string& rounding, const std::optional<Number>& grid, unsigned threads,
         std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        require(grid);
        const PlaneFormat chosen = format_for(path.string(), format);
        const PlaneWriteOptions options = write_options(rounding, grid);
        const PlaneLosses losses =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)}, [&](Context& k) {
              const PlaneText text(set, chosen, options, k);
              OutputFile file(path.string());
              text.write(file.stream(), k);
              file.finish();
              file.commit();
              return text.losses();
            });
        warn(losses.sentences());
        const std::string closing = losses.closing();
        if (!closing.empty()) note({closing});
      },
      "path"_a, "format"_a = nb::none(), "rounding"_a = "valid", "grid"_a = nb::none(),
      nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(), "memory_limit"_a = nb::none(),
      "progress"_a = nb::none(),
      with_limits(
          "Write the set as WKT, GeoJSON, WKB or DXF, or exactly as .nef2. If `grid` is given, "
          "coordinates are rounded to multiples of it. If writing fails, no incomplete file "
          "remains. A FileWarning reports properties of the set that the file does not "
          "represent."));
  c.def(
      "to_wkt",
      [](const Nef2& set, const std::string& rounding, const std::optional<Number>& grid,
         unsigned threads, std::optional<double> timeout, std::optional<std::uint64_t> memory_limit,
         nb::object progress) {
        require(grid);
        const PlaneWriteOptions options = write_options(rounding, grid);
        const auto [wkt, losses] =
            run(CallLimits{threads, timeout, memory_limit, std::move(progress)}, [&](Context& k) {
              const PlaneText text(set, PlaneFormat::Wkt, options, k);
              return std::pair(written([&](std::ostream& out) { text.write(out, k); }),
                               text.losses().sentences());
            });
        warn(losses);
        return wkt;
      },
      "rounding"_a = "valid", "grid"_a = nb::none(), nb::kw_only(), "threads"_a = 1U,
      "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
      with_limits("Return the closure of the set as WKT. A FileWarning reports properties of the "
                  "set that the text does not represent."));
}

// --- the class --------------------------------------------------------------------------------

void def_plane_makers(nb::class_<Nef2>& c) {
  def_run_static(
      c, "polygon",
      +[](Context& k, const Ring& ring, bool closed) {
        return polygons(k, {ring}, "nonzero", closed);
      },
      "Return the set that one closed chain of exact points bounds. The direction of the chain "
      "does not matter.",
      "points"_a, "closed"_a = true);
  def_run_static(c, "polygons", &polygons,
                 "Return the set that closed chains of exact points bound under a winding rule: "
                 "'positive', 'nonzero' or 'evenodd'.",
                 "rings"_a, "rule"_a = "evenodd", "closed"_a = true);
  def_run_static(c, "from_rings", &from_rings,
                 "Return the set that rings bound. points: float64 (n, 2). ring_begin: uint32 "
                 "(rings + 1,), the first point of each ring.",
                 "points"_a, "ring_begin"_a, "rule"_a = "evenodd", "closed"_a = true);
  def_run_static(c, "box", &box, "Return the rectangle between two exact corners.", "low"_a,
                 "high"_a, "closed"_a = true);
  def_run_static(
      c, "half_plane",
      +[](Context&, const Exact<3>& line, bool closed) {
        return Nef2::half_plane(line_of(line), boundary_of(closed));
      },
      "Return the points with a x + b y + c <= 0, or < 0 if not `closed`.", "line"_a,
      "closed"_a = true);
  def_run_static(
      c, "line", +[](Context&, const Exact<3>& line) { return Nef2::line(line_of(line)); },
      "Return the points with a x + b y + c = 0.", "line"_a);
  def_run_static(
      c, "polyline", +[](Context& k, const Ring& points) { return polylines(k, {points}); },
      "Return the union of the closed segments from each exact point to the next.", "points"_a);
  def_run_static(
      c, "points",
      +[](Context& k, const Ring& points) {
        PointTable2 table;
        for (const Exact<2>& p : points) table.push_back(p.value[0], p.value[1]);
        return Nef2::points(table, k);
      },
      "Return the set of these exact points.", "points"_a);
}

void def_plane_operations(nb::class_<Nef2>& c) {
  c.def("counts", &plane_counts, "Return the numbers of vertices, edges and faces.");
  c.def("is_bounded", &Nef2::is_bounded, "Whether the set lies in some disk.");
  def_run(
      c, "area", +[](Context& k, const Nef2& set) { return set.area(k); },
      "Return the exact area as a Fraction, or None if it is infinite.");
  def_run(c, "contains_points", &contains_points,
          "Return for each point, a row of a float64 array (n, 2), whether it belongs to the set: "
          "bool (n,).",
          "points"_a);
  def_run(
      c, "transformed",
      +[](Context& k, const Nef2& set, const std::vector<Exact<3>>& rows) {
        return set.transformed(plane_map_of(rows), k);
      },
      "Return the exact image under an invertible affine map, which is given by two rows (a, b, "
      "c).",
      "matrix"_a);
  def_run(c, "translated", &translated, "Return the set moved by an exact vector.", "by"_a);
  def_run(
      c, "is_convex",
      +[](Context& k, const Nef2& set) { return convexity_of_set(set, k).is_convex; },
      "Whether the set contains the segment between any two of its points.");
  def_run(
      c, "decompose",
      +[](Context& k, const Nef2& set, bool closed) {
        PartitionOptions options;
        options.closed = closed;
        return decompose(set, options, k).pieces;
      },
      "Return the convex parts of the set. If `closed` is true, return their closures.",
      "closed"_a = false);
}

}  // namespace

void bind_plane(nb::module_& m) {
  nb::class_<Nef2> c(m, "PlaneSet",
                     "A set of points of the plane that can be made from half-planes by unions, "
                     "intersections and complements. It may be bounded or unbounded, open or "
                     "closed, and may have slits and isolated points. The set is immutable and "
                     "exact.");
  def_set(c);
  def_bytes(c, &canonical_bytes, &from_bytes);
  def_plane_makers(c);
  def_plane_operations(c);
  def_models(c);
  def_plane_files(c);
  def_page(c);
}

}  // namespace plumb::python
