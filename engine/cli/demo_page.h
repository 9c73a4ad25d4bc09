// The page that `plumb demo` leaves behind.
#pragma once

#include <ostream>
#include <string>
#include <vector>

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

}  // namespace plumb::cli
