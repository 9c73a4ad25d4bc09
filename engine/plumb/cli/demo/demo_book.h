// The page that `plumb demo` leaves behind.
#pragma once

#include <chrono>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "plumb/cli/session/session.h"
#include "plumb/predicates/rational.h"

namespace plumb::cli {

struct DemoStep {
  std::string what;
  double seconds = 0;
};

struct DemoPicture {
  std::string title;
  std::string file;  ///< beside the page
  std::string caption;
  std::string svg;
  bool is_small = false;  ///< need not fill the page
  std::string page = {};  ///< HTML, to turn it around; empty: none
};

/// One capability: what was done, with times, and pictures of it.
struct DemoChapter {
  std::string title;
  std::string claim;  ///< what its figures show, in a sentence
  std::vector<DemoStep> steps = {};
  std::vector<DemoPicture> pictures = {};

  double seconds() const;
};

/// The title of each chapter, then one line a step, with its time.
void write_demo_steps(std::ostream& out, const std::vector<DemoChapter>& chapters);

/// One self-contained HTML file: pictures inlined, nothing loaded from anywhere.
void write_demo_page(std::ostream& out, const std::vector<DemoChapter>& chapters);

// What `plumb demo` leaves behind: files in a directory, the steps that made them, one page with
// all of it.

class DemoBook {
 public:
  /// Makes the directory. Errors: CannotWrite.
  DemoBook(std::filesystem::path directory, Session& session);

  Session& session() { return session_; }
  /// A file of the bundled data.
  static std::string bundled(const std::string& file);

  /// What follows belongs to it. There is one before the first step.
  void chapter(std::string title, std::string claim);
  /// Says what was done since the last step, and how long it took.
  void step(const std::string& what);
  void write(const std::string& name, std::string bytes);
  /// A picture for the page, and a file of its own; the same for what turns it around.
  void add(DemoPicture picture);
  /// index.html and the list of steps on standard output.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path directory_;
  Session& session_;
  Clock::time_point step_start_ = Clock::now();
  std::vector<DemoChapter> chapters_;
};

/// A number as text: exactly, whatever its length; a long one also rounded.
std::string in_full(const Rational& value);

/// The chapter on solids.
void demonstrate_solids(DemoBook& book);
/// The chapter on convex pieces.
void demonstrate_convex(DemoBook& book);
/// The chapter on polygons drawn on meshes.
void demonstrate_surfaces(DemoBook& book);

}  // namespace plumb::cli
