// The book that `plumb demo` writes: files in a directory, the steps that made them, and one page
// with all of it.
#pragma once

#include <chrono>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "plumb/cli/session/session.h"
#include "plumb/predicates/rational.h"

namespace plumb::cli {

/// A step that was done, with its time.
struct DemoStep {
  std::string what;
  double seconds = 0;
};

/// A picture of a chapter.
struct DemoPicture {
  std::string title;
  std::string file;  ///< Name of the file beside the page.
  std::string caption;
  std::string svg;
  bool is_small = false;  ///< Whether it need not fill the page.
  std::string page = {};  ///< HTML that shows it turning; empty if there is none.
};

/// One capability: the steps with their times, and pictures of the results.
struct DemoChapter {
  std::string title;
  std::string claim;  ///< A sentence that states what its figures show.
  std::vector<DemoStep> steps = {};
  std::vector<DemoPicture> pictures = {};

  double seconds() const;
};

/// Writes the title of each chapter, then one line a step, with its time.
void write_demo_steps(std::ostream& out, const std::vector<DemoChapter>& chapters);

/// Writes one self-contained HTML file: pictures are part of it, and nothing is loaded from
/// elsewhere.
void write_demo_page(std::ostream& out, const std::vector<DemoChapter>& chapters);

// The book itself.

/// Collects chapters and writes their files.
class DemoBook {
 public:
  /// Creates the directory. Throws Error{CannotWrite}.
  DemoBook(std::filesystem::path directory, Session& session);

  Session& session() { return session_; }
  /// Returns the path of a file of the bundled data.
  static std::string bundled(const std::string& file);

  /// Begins a chapter, to which all that follows belongs. Required before the first step.
  void chapter(std::string title, std::string claim);
  /// Records the work since the last step, and the time that it took.
  void step(const std::string& what);
  void write(const std::string& name, std::string bytes);
  /// Adds a picture for the page and as a file of its own, together with the page that shows it
  /// turning.
  void add(DemoPicture picture);
  /// Writes index.html, and the list of steps on standard output.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path directory_;
  Session& session_;
  Clock::time_point step_start_ = Clock::now();
  std::vector<DemoChapter> chapters_;
};

/// Returns a number as exact text of any length. A long number is also given rounded.
std::string in_full(const Rational& value);

/// Adds the chapter on solids.
void demonstrate_solids(DemoBook& book);
/// Adds the chapter on models of OpenSCAD.
void demonstrate_models(DemoBook& book);
/// Adds the chapter on convex pieces.
void demonstrate_convex(DemoBook& book);
/// Adds the chapter on polygons drawn on meshes.
void demonstrate_surfaces(DemoBook& book);

}  // namespace plumb::cli
