#include "peer_report.h"

#include <fmt/core.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "../complexity/cpu_time.h"
#include "../report/report.h"

namespace plumb::bench {
namespace {

using Json = nlohmann::ordered_json;

/// What the other library has freed is put in order now: the next allocation would do it, and be
/// charged with it.
PeerRun after_tidying(const std::function<PeerRun()>& run) {
  malloc_trim(0);
  return run();
}

/// What one library did in all rounds.
struct Runs {
  std::vector<PeerRun> runs;

  double least(double PeerRun::*value) const {
    return runs.empty() ? 0 : std::ranges::min(runs, {}, value).*value;
  }
  Json to_json() const {
    Json json{{"seconds", least(&PeerRun::seconds)}};
    if (runs.empty()) return json;
    json["answer"] = runs.back().answer;
    if (runs.back().megabytes > 0) json["megabytes"] = least(&PeerRun::megabytes);
    return json;
  }
};

/// The first round whose answers differ; of all when none do.
std::size_t first_difference(const Runs& ours, const Runs& theirs, double tolerance) {
  const auto do_agree = [&](const PeerRun& a, const PeerRun& b) {
    return std::fabs(a.answer - b.answer) <= tolerance * std::fabs(a.answer);
  };
  const auto found = std::ranges::mismatch(ours.runs, theirs.runs, do_agree);
  return static_cast<std::size_t>(found.in1 - ours.runs.begin());
}

Json ratios(const Runs& ours, const Runs& theirs, double PeerRun::*value) {
  std::vector<double> values;
  for (std::size_t i = 0; i < theirs.runs.size(); ++i) {
    values.push_back(ours.runs[i].*value / theirs.runs[i].*value);
  }
  return spread(std::move(values));
}

}  // namespace

void PeerOptions::add_to(CLI::App& app) {
  app.add_option("--rounds", rounds,
                 fmt::format("of plumb and the peer in turn (default {})", rounds));
  app.add_option("--json", json, "write the comparisons there");
}
void PeerOptions::add_most_to(CLI::App& app) {
  app.add_option("--most", most, "percent of the full sizes (default 100)");
}
void PeerOptions::add_jobs_to(CLI::App& app, const std::string& names) {
  app.add_option("jobs", jobs, names + "; default: all");
}

bool PeerOptions::wants(std::string_view job) const {
  return jobs.empty() || std::ranges::find(jobs, job) != jobs.end();
}

std::size_t PeerOptions::size(std::size_t full) const {
  return std::max(std::size_t{10},
                  static_cast<std::size_t>(static_cast<double>(full) * most / 100));
}

PeerReport::PeerReport(std::string_view title)
    : json_{{"title", title}, {"versions", Json::object()}, {"comparisons", Json::array()}} {}

void PeerReport::use(std::string_view library, std::string_view version) {
  json_["versions"][std::string(library)] = version;
  fmt::print("{} {}\n", library, version);
}

void PeerReport::compare(const PeerJob& job, const std::function<PeerRun()>& ours,
                         const std::function<PeerRun()>& theirs) {
  Runs own, other;
  std::string failure, failed;
  for (int i = 0; i < job.rounds && failure.empty(); ++i) {
    failed = "plumb";
    try {
      own.runs.push_back(after_tidying(ours));
      failed = "the peer";
      other.runs.push_back(after_tidying(theirs));
    } catch (const std::exception& error) {
      failure = error.what();
    }
  }
  Json& json = json_["comparisons"].emplace_back(Json{{"job", job.name},
                                                      {"input", job.input},
                                                      {"peer", job.peer},
                                                      {"measure", job.measure},
                                                      {"tolerance", job.tolerance},
                                                      {"rounds", job.rounds}});
  json["plumb"] = own.to_json();
  json["other"] = other.to_json();
  fmt::print("{:30} {:26} {:22} plumb {:9.4f} s  peer {:9.4f} s", job.name, job.input, job.peer,
             own.least(&PeerRun::seconds), other.least(&PeerRun::seconds));
  if (!other.runs.empty()) {
    json["ratio"] = ratios(own, other, &PeerRun::seconds);
    fmt::print("  ratio {}", spread_text(json["ratio"]));
    if (own.runs.back().megabytes > 0 && other.runs.back().megabytes > 0) {
      json["memory_ratio"] = ratios(own, other, &PeerRun::megabytes);
      fmt::print("  memory {}", spread_text(json["memory_ratio"]));
    }
  }
  if (!failure.empty()) {
    json["failure"] = failure;
    json["verdict"] = failed + " failed";
    fmt::print("  FAILED, {}: {}\n", failed, failure);
  } else if (const std::size_t i = first_difference(own, other, job.tolerance);
             i < own.runs.size()) {
    const double a = own.runs[i].answer, b = other.runs[i].answer;
    json["plumb"]["answer"] = a;
    json["other"]["answer"] = b;
    json["verdict"] = "answers differ";
    fmt::print("  ANSWERS DIFFER, {}: {} and {}\n", job.measure, a, b);
  } else {
    json["verdict"] = "agree";
    fmt::print("\n");
  }
  agree_ = agree_ && json["verdict"] == "agree";
  std::fflush(stdout);
}

void PeerReport::judge(const Judgement& j) {
  json_["judged"].push_back(
      {{"peer", j.peer},
       {"input", j.input},
       {"plumb", j.ours},
       {"other", j.theirs},
       {"verdict", j.is_ours_right ? "the peer is wrong" : "plumb is wrong"}});
  agree_ = agree_ && j.is_ours_right;
}

void PeerReport::judged_of(std::size_t inputs) { json_["judged_of"] = inputs; }

int PeerReport::finish(const std::string& file) const {
  return write_json(file, json_, agree_ ? 0 : 1);
}

PeerRun timed_run(const std::function<void()>& work, const std::function<double()>& answer) {
  const double start = cpu_seconds();
  work();
  const double seconds = cpu_seconds() - start;
  return {seconds, answer(), 0};
}

}  // namespace plumb::bench
