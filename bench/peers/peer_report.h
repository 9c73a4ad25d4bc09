// What a peer program finds out: plumb and another library on the same input, in turn, their
// answers compared.
//
// Main flow of a peer program:
//  1. PeerOptions: what it was asked for
//  2. report.use(NAME, VERSION) of every library
//  3. report.compare(...) of every job: plumb and the peer in turn, `rounds` times over; the
//     answers of every round compared
//  4. report.judge(...) of an answer that a third opinion, by brute force, has been had on
//  5. return report.finish(FILE): the JSON that bench/run gathers, and the exit status
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace plumb::bench {

/// What peer programs may be told.
struct PeerOptions {
  int rounds = 3;                 ///< of plumb and the peer in turn
  std::string json;               ///< file for the comparisons; empty: none
  double most = 100;              ///< percent of the full sizes
  std::vector<std::string> jobs;  ///< none: all

  void add_to(CLI::App& app);  ///< --rounds, --json
  void add_most_to(CLI::App& app);
  void add_jobs_to(CLI::App& app, const std::string& names);

  bool wants(std::string_view job) const;
  std::size_t size(std::size_t full) const;  ///< ten at least
};

/// One run of one library.
struct PeerRun {
  double seconds = 0;    ///< CPU time of the operation alone
  double answer = 0;     ///< a figure of the result
  double megabytes = 0;  ///< largest resident set of its process; 0: it had none of its own
};

struct PeerJob {
  std::string name;   ///< the operation
  std::string input;  ///< enough to make it again
  std::string peer;   ///< which library, and which part of it
  std::string measure = "area";
  double tolerance = 0;  ///< of the answers' difference, beside plumb's: for libraries that round
  int rounds = 3;
};

class PeerReport {
 public:
  explicit PeerReport(std::string_view title);

  void use(std::string_view library, std::string_view version);

  /// Either may throw std::exception: a failure, which is no agreement.
  void compare(const PeerJob& job, const std::function<PeerRun()>& ours,
               const std::function<PeerRun()>& theirs);

  /// An input on which the two differ and what a third, brute-force opinion says of them.
  struct Judgement {
    std::string peer;
    std::string input;
    std::string ours;
    std::string theirs;
    bool is_ours_right;
  };
  void judge(const Judgement& judgement);
  /// How many inputs judge() has been asked to judge of, those with equal answers included.
  void judged_of(std::size_t inputs);

  /// Writes the JSON unless the name is empty. 0: all agree but for answers known to be wrong of
  /// the peer; 1: others differ, or one of the two failed; 2: the file cannot be written.
  int finish(const std::string& file) const;

 private:
  nlohmann::ordered_json json_;
  bool agree_ = true;
};

/// CPU time of `work`; its answer is not timed.
PeerRun timed_run(const std::function<void()>& work, const std::function<double()>& answer);

}  // namespace plumb::bench
