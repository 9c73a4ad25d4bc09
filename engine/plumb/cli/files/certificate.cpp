#include "plumb/cli/files/certificate.h"

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>

#include "plumb/base/nef_set.h"
#include "plumb/cli/files/witness.h"
#include "plumb/io/map_report_io.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/rational_point.h"

namespace plumb::cli {
namespace {

using Members = nlohmann::ordered_json;

constexpr int kCertificateVersion = 1;

Members exact_place(const RationalPoint3& p) {
  return Members::array({format_exact(p.x), format_exact(p.y), format_exact(p.z)});
}
Members exact_place(const RationalPoint2& p) {
  return Members::array({format_exact(p.x), format_exact(p.y)});
}

/// Whether the checker can find the defect in the file. The checker knows only the listed cycles.
/// For the checker, an edge without a twin is a defect only if every outer boundary must be listed.
bool has_certificate(const MapDefect& defect, const MapCheckOptions& options,
                     std::size_t listed_cycles) {
  switch (defect.kind) {
    case DefectKind::Duplicate:
    case DefectKind::Twin:
      return std::all_of(defect.cycles.begin(), defect.cycles.end(),
                         [&](std::uint32_t cycle) { return cycle < listed_cycles; });
    case DefectKind::Open:
      return options.outer == OuterRule::Listed;
    case DefectKind::Crossing:
      return defect.edges.size() == 2 && defect.point;
    default:
      return false;
  }
}

/// Names the ends of an edge by their numbers and their exact coordinates.
Members edge_members(const MapEdge& edge, const Map& map) {
  Members points = Members::array();
  for (const std::uint32_t v : {edge.from, edge.to}) {
    points.push_back(exact_place(map.points.exact(v)));
  }
  return {{"vertices", {edge.from + 1, edge.to + 1}}, {"points", points}};
}

Members defect_members(const MapDefect& defect, const MapReport& report) {
  Members edges = Members::array();
  for (const MapEdge& edge : defect.edges) edges.push_back(edge_members(edge, report.map));
  Members members{{"defect", name_of(defect.kind)}, {"edges", edges}};
  if (defect.kind == DefectKind::Crossing) members["point"] = exact_place(*defect.point);
  return members;
}

}  // namespace

void CertificateOption::open(Session& session) {
  if (!is_given()) return;
  session.outputs().add(file_, [this](std::ostream& out) {
    Members certificate{{"plumb_certificate", kCertificateVersion}, {"claims", claims_}};
    if (!reason_.empty()) certificate["reason"] = reason_;
    out << certificate.dump() << '\n';
  });
}

void CertificateOption::prove(const std::string& claim, Members members) {
  Members whole{{"claim", claim}};
  whole.update(members);
  claims_.push_back(std::move(whole));
}

void certify_map(const MapReport& report, const MapCheckOptions& options, std::size_t listed_cycles,
                 const CommonOptions& common, CertificateOption& certificate) {
  if (report.verdict == MapVerdict::Valid) {
    certificate.explain("the map is valid");
    return;
  }
  const auto defect =
      std::find_if(report.defects.begin(), report.defects.end(),
                   [&](const auto& d) { return has_certificate(d, options, listed_cycles); });
  if (defect == report.defects.end()) {
    certificate.explain("no described defect can be checked by itself");
    return;
  }
  Members members = defect_members(*defect, report);
  members["exact_decimals"] = common.exact_decimals;
  members["merge_vertices"] = options.merge_vertices || options.name_places;
  certificate.prove("map has a defect", std::move(members));
}

namespace {

/// The facts that the checker must know about the reading of the solids.
Members reading(const SolidInput& input, const Session& session) {
  return {{"rule", input.winding_rule()}, {"exact_decimals", session.options().exact_decimals}};
}

/// Whether the checker can read the solids in the same way as the command.
bool can_certify(const SolidInput& input, CertificateOption& certificate) {
  if (!certificate.is_given()) return false;
  if (!input.reads_windings()) {
    certificate.explain("an option changes the mesh before it is read as a set");
  }
  return input.reads_windings();
}

}  // namespace

void certify_comparison(const Nef3& a, const Nef3& b, const SolidInput& input, Session& session,
                        CertificateOption& certificate) {
  if (!can_certify(input, certificate)) return;
  Context& context = session.context();
  certificate.explain("what is not claimed has no certificate");
  const auto claim_point = [&](const std::string& claim, const Nef3& where) {
    const auto point = inner_point(where, context);
    if (!point) return;
    Members members = reading(input, session);
    members["point"] = exact_place(*point);
    certificate.prove(claim, std::move(members));
  };
  claim_point("A is not a subset of B", boolean_op(a, b, kDifference, context));
  claim_point("B is not a subset of A", boolean_op(b, a, kDifference, context));
  claim_point("A and B meet", boolean_op(a, b, kIntersection, context));
  if (const auto plane = separating_plane(a, b, context)) {
    Members members = reading(input, session);
    members["plane"] = exact_place(plane->normal);
    members["plane"].push_back(format_exact(plane->offset));
    certificate.prove("A and B do not meet", std::move(members));
  }
}

void certify_not_convex(const Nef3& set, const SolidInput& input, Session& session,
                        CertificateOption& certificate) {
  if (!can_certify(input, certificate)) return;
  const auto segment = leaving_segment(set, session.context());
  if (!segment) {
    certificate.explain("no segment was found that leaves the set strictly");
    return;
  }
  Members members = reading(input, session);
  members["segment"] = Members::array({exact_place(segment->from)});
  members["segment"].push_back(exact_place(segment->to));
  members["outside"] = exact_place(segment->outside);
  certificate.prove("A is not convex", std::move(members));
}

}  // namespace plumb::cli
