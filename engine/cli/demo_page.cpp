#include "demo_page.h"

#include <cstdio>
#include <string_view>

namespace plumb::cli {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>plumb demo</title>
<style>
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 75rem; padding: 0 1rem; }
figure { margin: 2rem 0; }
figure svg { width: 100%; height: auto; border: 1px solid #ccc; }
figcaption { color: #444; }
td { padding: 0.1rem 1rem 0.1rem 0; vertical-align: top; }
td.time { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<h1>plumb demo</h1>
<p>Real county regions, checked exactly: is every point of the plane covered once?</p>
)";

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else {
      html += c;
    }
  }
  return html;
}

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", seconds * 1000);
  return text;
}

/// An SVG file without what may stand only at the start of a file.
std::string_view inline_svg(std::string_view svg) {
  const std::size_t start = svg.find("<svg");
  return start == svg.npos ? svg : svg.substr(start);
}

void write_picture(std::ostream& out, const DemoPicture& picture) {
  out << "<h2>" << escaped(picture.title) << "</h2>\n<figure>\n"
      << inline_svg(picture.svg) << "\n<figcaption>" << escaped(picture.caption) << " (<a href=\""
      << picture.file << "\">" << picture.file << "</a>)</figcaption>\n</figure>\n";
}

}  // namespace

void write_demo_steps(std::ostream& out, const std::vector<DemoStep>& steps) {
  for (const DemoStep& step : steps) {
    const std::string time = milliseconds(step.seconds);
    out << std::string(time.size() < 10 ? 10 - time.size() : 0, ' ') << time << "  " << step.what
        << '\n';
  }
}

void write_demo_page(std::ostream& out, const std::vector<DemoStep>& steps,
                     const std::vector<DemoPicture>& pictures) {
  out << kHead << "<table>\n";
  for (const DemoStep& step : steps) {
    out << "<tr><td class=\"time\">" << milliseconds(step.seconds) << "</td><td>"
        << escaped(step.what) << "</td></tr>\n";
  }
  out << "</table>\n";
  for (const DemoPicture& picture : pictures) write_picture(out, picture);
  out << "</body>\n</html>\n";
}

}  // namespace plumb::cli
