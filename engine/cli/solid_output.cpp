#include "solid_output.h"

#include "format_choice.h"
#include "number_argument.h"
#include "plumb/base/error.h"
#include "plumb/io/text_output.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/space_measure.h"

namespace plumb::cli {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json solid_json(const Nef3& set) {
  const SpaceCounts counts = set.counts();
  const std::optional<Rational> volume = marked_volume(set.complex());
  Json volume_json = nullptr;
  if (volume) volume_json = {{"exact", format_exact(*volume)}, {"double", nearest_double(*volume)}};
  return {{"vertices", counts.vertices},
          {"edges", counts.edges},
          {"facets", counts.facets},
          {"volumes", counts.volumes},
          {"marked_volumes", counts.marked_volumes},
          {"bounded", set.is_bounded()},
          {"empty", set.is_empty()},
          {"simple", set.is_simple()},
          {"convex", set.is_convex()},
          {"volume", volume_json}};
}

void write_solid_info(std::ostream& out, const Nef3& set) {
  const SpaceCounts counts = set.counts();
  out << counts.vertices << " vertices, " << counts.edges << " edges, " << counts.facets
      << " facets, " << counts.volumes << " volumes (" << counts.marked_volumes << " marked)\n"
      << (set.is_bounded() ? "bounded" : "unbounded") << (set.is_empty() ? ", empty" : "")
      << (set.is_simple() ? ", simple" : ", not simple")
      << (set.is_convex() ? ", convex\n" : ", not convex\n");
  const std::optional<Rational> volume = marked_volume(set.complex());
  if (volume) out << "volume " << readable(*volume) << '\n';
}

void SolidOutput::open(Session& session) {
  const CommonOptions& common = session.options();
  const auto formats = solid_formats();
  if (common.out == "-" && common.format.empty()) {
    throw Error(ErrorCode::Usage, "-o - needs --format " + names_of(formats));
  }
  format_ = common.format.empty() ? (common.out.empty() ? format_named(formats, "nef")
                                                        : format_of_file(formats, common.out))
                                  : format_named(formats, common.format);
  if (!common.out.empty() || !common.format.empty() || !common.json) {
    path_ = common.out.empty() ? "-" : common.out;
    session.outputs().add(path_, [this](std::ostream& out) { text_->write(out); });
  }
  if (common.json) {
    session.outputs().add("-", [this](std::ostream& out) { out << json_.dump() << '\n'; });
  }
}

void SolidOutput::prepare(const Nef3& set, bool strict, Session& session) {
  if (session.options().json) json_ = solid_json(set);
  if (path_.empty()) return;
  try {
    text_.emplace(set, format_, session.context());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::CannotWrite) throw;
    throw Error(error.code(), error.message(), {name()});
  }
  if (!strict || text_->losses().empty()) return;
  throw Error(ErrorCode::CannotWrite, "--strict: " + text_->losses().front(), {name()});
}

void SolidOutput::deliver(Session& session) {
  session.finish_progress();
  session.outputs().deliver();
  if (!text_) return;
  for (const std::string& loss : text_->losses()) session.note(name() + ": warning: " + loss);
}

}  // namespace plumb::cli
