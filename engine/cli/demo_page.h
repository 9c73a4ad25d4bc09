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

/// One line a step, with its time.
void write_demo_steps(std::ostream& out, const std::vector<DemoStep>& steps);

/// One self-contained HTML file: pictures inlined, nothing loaded from anywhere.
void write_demo_page(std::ostream& out, const std::vector<DemoStep>& steps,
                     const std::vector<DemoPicture>& pictures);

}  // namespace plumb::cli
