#include "oracle/rounding_check.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "generate/rounding_scenes.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/plane/query/plane_locator.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/segment2.h"

namespace plumb::testing {
namespace {

using Segments = std::vector<RationalSegment2>;

std::string text_of_point(const RationalPoint2& p) {
  return decimal_text(p.x, 20) + ' ' + decimal_text(p.y, 20);
}

/// Returns the bounded edges with exact ends. `kept_only` leaves out edges inside a face, but for
/// marked edges inside faces that are not marked.
Segments edges_of(const PlaneComplex& c, bool kept_only) {
  Segments segments;
  for (std::size_t i = 0; i < c.edge_count(); ++i) {
    const HalfedgeId h = first_half(EdgeId(i));
    const VertexId a = c.dcel.origin(h), b = c.dcel.target(h);
    if (c.is_at_infinity(a) || c.is_at_infinity(b)) continue;
    const FaceId above = c.dcel.face(h);
    const bool is_line = c.mark(EdgeId(i)) && !c.mark(above);
    if (kept_only && above == c.dcel.face(twin(h)) && !is_line) continue;
    segments.push_back({exact(c.points, c.vertex_point[a]), exact(c.points, c.vertex_point[b])});
  }
  return segments;
}

/// Whether a segment meets the square of all points within `distance` of p (maximum norm).
bool meets_square(const RationalSegment2& s, const RationalPoint2& p, const Rational& distance) {
  Rational low = 0, high = 1;
  const auto clip = [&](const Rational& start, const Rational& change, const Rational& centre) {
    const Rational a = centre - distance - start, b = centre + distance - start;
    if (change.is_zero()) return a.sign() <= 0 && b.sign() >= 0;
    const Rational t = a / change, u = b / change;
    low = std::max(low, std::min(t, u));
    high = std::min(high, std::max(t, u));
    return low <= high;
  };
  return clip(s.source.x, s.target.x - s.source.x, p.x) &&
         clip(s.source.y, s.target.y - s.source.y, p.y);
}

bool is_near(const Segments& segments, const RationalPoint2& p, const Rational& distance) {
  return std::any_of(segments.begin(), segments.end(),
                     [&](const RationalSegment2& s) { return meets_square(s, p, distance); });
}

RationalPoint2 point_on(const RationalSegment2& s, const Rational& t) {
  return {s.source.x + t * (s.target.x - s.source.x), s.source.y + t * (s.target.y - s.source.y)};
}

/// Returns the first point of `from`, at ends and quarters, that is not near `to`, or "".
std::string first_far_point(const Segments& from, const Segments& to, const Rational& distance) {
  for (const RationalSegment2& s : from) {
    for (int quarter = 0; quarter <= 4; ++quarter) {
      const RationalPoint2 p = point_on(s, Rational(quarter) / 4);
      if (!is_near(to, p, distance)) return text_of_point(p);
    }
  }
  return "";
}

/// Returns points all over the scene, many of them near vertices.
std::vector<RationalPoint2> sample_points(const PlaneComplex& c) {
  std::vector<RationalPoint2> samples;
  const std::size_t step = std::max<std::size_t>(1, c.vertex_count() / 6);
  for (std::size_t v = 0; v < c.vertex_count(); v += step) {
    const RationalPoint2 p = exact(c.points, c.vertex_point[v]);
    for (std::size_t w = v; w < c.vertex_count(); w += step) {
      const RationalPoint2 q = exact(c.points, c.vertex_point[w]);
      samples.push_back({(p.x * 2 + q.x) / 3, (p.y * 3 + q.y * 2) / 5});
    }
  }
  return samples;
}

/// Returns a point far from all exact edges whose face is not the one before, or "".
std::string wrong_label(const PlaneComplex& before, const RoundedSubdivision& rounded,
                        const Segments& edges, const Rational& distance) {
  const PlaneLocator old_place(before), new_place(rounded.complex);
  for (const RationalPoint2& p : sample_points(before)) {
    if (is_near(edges, p, distance)) continue;
    const PlaneLocation was = old_place.locate(p), is = new_place.locate(p);
    if (!was.face.is_valid()) continue;  // On an isolated vertex.
    if (!is.face.is_valid() && !is.vertex.is_valid()) return text_of_point(p) + " is on an edge";
    if (!is.face.is_valid()) continue;
    const bool is_left_out = before.has_frame() && is_unbounded(before, was.face);
    const FaceId expected = is_left_out ? FaceId(0) : was.face;
    if (rounded.exact_face[is.face] != expected) return text_of_point(p) + " has another face";
  }
  return "";
}

std::string equal_neighbours(const RoundedSubdivision& rounded) {
  const PlaneComplex& c = rounded.complex;
  for (std::size_t i = 0; i < c.edge_count(); ++i) {
    const HalfedgeId h = first_half(EdgeId(i));
    const FaceId above = rounded.exact_face[c.dcel.face(h)];
    const FaceId below = rounded.exact_face[c.dcel.face(twin(h))];
    if (above == below && !c.mark(EdgeId(i))) return "an edge between equal faces";
  }
  return "";
}

}  // namespace

std::string invalid_doubles(const PlaneComplex& c) {
  if (c.has_frame()) return "there is a frame";
  for (const std::uint32_t p : c.vertex_point) {
    if (p >= c.points.inputs.size() || !c.points.inputs.is_double(p)) {
      return "a vertex is not at doubles";
    }
  }
  const auto at = [&c](VertexId v) { return c.points.inputs.approx(c.vertex_point[v]); };
  std::vector<Segment2> segments;
  for (std::size_t i = 0; i < c.edge_count(); ++i) {
    const HalfedgeId h = first_half(EdgeId(i));
    segments.push_back({at(c.dcel.origin(h)), at(c.dcel.target(h))});
    if (segments.back().source == segments.back().target) return "an edge without length";
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      const SegmentRelation how = relation(segments[i], segments[j]);
      if (how != SegmentRelation::Disjoint && how != SegmentRelation::ShareEndpoint) {
        return "edges " + std::to_string(i) + " and " + std::to_string(j) + " meet";
      }
    }
    for (std::size_t v = 0; v < c.vertex_count(); ++v) {
      if (place_on(segments[i], at(VertexId(v))) == PlaceOnSegment::Inside) {
        return "a vertex lies inside an edge";
      }
    }
  }
  for (std::size_t v = 0; v < c.vertex_count(); ++v) {
    for (std::size_t w = v + 1; w < c.vertex_count(); ++w) {
      if (at(VertexId(v)) == at(VertexId(w))) return "two vertices at one place";
    }
  }
  if (const auto flaw = audit(c, AuditForm::Any)) return flaw->invariant + " at " + flaw->place;
  return "";
}

std::string rounding_disagreement(const PlaneComplex& before, const RoundedSubdivision& rounded) {
  if (std::string wrong = invalid_doubles(rounded.complex); !wrong.empty()) return wrong;
  if (rounded.exact_face.size() != rounded.complex.face_count()) return "faces without labels";
  if (rounded.exact_face[FaceId(0)] != FaceId(0)) return "the outside has another face";
  const PlaneRoundingReport& report = rounded.report;
  const Rational distance = exact_rational(report.largest_move);
  const Segments old_edges = edges_of(before, false), new_edges = edges_of(rounded.complex, false);
  if (const std::string p = first_far_point(new_edges, old_edges, distance); !p.empty()) {
    return "the result is too far from the exact edges at " + p;
  }
  const bool is_whole = report.collapsed + report.edges_folded + report.vertices_merged == 0;
  if (is_whole) {
    const Segments kept = before.has_frame() ? Segments() : edges_of(before, true);
    if (const std::string p = first_far_point(kept, new_edges, distance); !p.empty()) {
      return "an exact edge is too far from the result at " + p;
    }
  }
  if (const std::string p = wrong_label(before, rounded, old_edges, distance); !p.empty()) return p;
  return "";
}

namespace {

std::string again(const RoundedSubdivision& rounded, const RoundedSubdivision& twice) {
  if (twice.report.is_changed() || twice.report.largest_move != 0) return "not idempotent";
  if (twice.complex.vertex_point != rounded.complex.vertex_point ||
      twice.complex.marks != rounded.complex.marks) {
    return "rounded twice, a subdivision changes";
  }
  return "";
}

std::string set_disagreement(const PlaneComplex& complex, const std::optional<Rational>& step) {
  const Nef2 set = Nef2::from_complex(complex).closure();
  const RoundedSet rounded = step ? round_to_grid(set, *step) : round_to_doubles(set);
  if (const auto flaw = rounded.set.audit()) return "set: " + flaw->invariant;
  if (std::string wrong = invalid_doubles(rounded.set.complex()); !wrong.empty()) {
    return "set: " + wrong;
  }
  if (!rounded.set.is_closed()) return "set: not closed";
  const RoundedSet twice = step ? round_to_grid(rounded.set, *step) : round_to_doubles(rounded.set);
  return twice.set == rounded.set ? "" : "set: not idempotent";
}

/// Returns a step for which the scene is neither one pixel nor finer than its grid.
Rational step_for(const PlaneComplex& complex, std::uint8_t byte) {
  Rational largest = 0;
  for (const std::uint32_t p : complex.vertex_point) {
    const RationalPoint2 at = exact(complex.points, p);
    largest = std::max({largest, abs(at.x), abs(at.y)});
  }
  if (largest.is_zero()) return 1;
  return largest / ((byte & 3U) == 0 ? 1000 : 1 + byte % 50);
}

std::string rounded_disagreement(const PlaneComplex& complex, const std::optional<Rational>& step) {
  const auto round = [&step](const PlaneComplex& c) {
    return step ? round_to_grid(c, *step) : round_to_doubles(c);
  };
  const RoundedSubdivision rounded = round(complex);
  if (std::string wrong = rounding_disagreement(complex, rounded); !wrong.empty()) return wrong;
  if (rounded.report.largest_move != 0) {
    if (std::string wrong = equal_neighbours(rounded); !wrong.empty()) return wrong;
  }
  if (std::string wrong = again(rounded, round(rounded.complex)); !wrong.empty()) return wrong;
  return set_disagreement(complex, step);
}

}  // namespace

std::string rounding_of_program_disagreement(std::span<const std::uint8_t> program) {
  if (program.size() < kRoundingRecord) return "";
  const PlaneComplex complex = rounding_scene(program);
  if (std::string wrong = rounded_disagreement(complex, {}); !wrong.empty()) return wrong;
  const std::string wrong = rounded_disagreement(complex, step_for(complex, program[5]));
  return wrong.empty() ? wrong : "grid: " + wrong;
}

}  // namespace plumb::testing
