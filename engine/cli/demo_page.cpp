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
figure img { width: 100%; height: auto; border: 1px solid #ccc; }
figure.small img { max-width: 37.5rem; }
.sheet { overflow-x: auto; }
.sheet img { min-width: 50rem; box-sizing: border-box; }
figure iframe { width: 100%; height: min(80vh, 40rem); border: 1px solid #ccc; display: block; }
figure button { font: inherit; margin: 0.5rem 0; padding: 0.3rem 1rem; cursor: pointer; }
figcaption { color: #444; overflow-wrap: anywhere; }
td { padding: 0.1rem 1rem 0.1rem 0; vertical-align: top; overflow-wrap: anywhere; }
td.time { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<h1>plumb demo</h1>
<p>Real county regions, checked exactly: is every point of the plane covered once? Sets of the plane, open
or closed along every edge, combined exactly. Two maps laid over each other: areas add up to the last digit.
Two solids, united, intersected and subtracted: volumes add up to the last digit.
Solids cut into convex pieces: none twice, nothing lost.
Polygons on a torus and on the bunny: the cells they make, how often each winds around them, what a Boolean selects.</p>
)";

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else if (c == '"') {
      html += "&quot;";
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

/// An SVG file as an address: pictures keep their styles and ids to themselves that way.
std::string data_uri(std::string_view svg) {
  static constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri = "data:image/svg+xml,";
  for (const char c : svg) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte > 0x20 && byte < 0x7F &&
                          std::string_view("\"#%<>&\\^`{|}").find(c) == std::string_view::npos;
    if (is_plain || c == ' ') {
      uri += c;
    } else {
      uri += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  return uri;
}

/// A page of its own inside this one, made when it is asked for: many at once would be too much for a browser.
constexpr std::string_view kTurning = R"(<script>
for (const button of document.querySelectorAll('figure button')) button.addEventListener('click', () => {
  const frame = document.createElement('iframe');
  frame.title = button.title;
  frame.srcdoc = button.dataset.page;
  button.previousElementSibling.replaceWith(frame);
  button.remove();
});
</script>
)";

void write_picture(std::ostream& out, const DemoPicture& picture) {
  const std::string title = escaped(picture.title);
  const bool is_wide =
      !picture.is_small;  // its text would be too small on a phone: there it scrolls
  out << "<h2>" << title << "</h2>\n<figure"
      << (is_wide ? ">\n<div class=\"sheet\">" : " class=\"small\">\n") << "<img alt=\"" << title
      << "\" src=\"" << data_uri(picture.svg) << "\">" << (is_wide ? "</div>\n" : "\n");
  if (!picture.page.empty()) {
    out << "<button title=\"" << title << "\" data-page=\"" << escaped(picture.page)
        << "\">Turn it around</button>\n";
  }
  out << "<figcaption>" << escaped(picture.caption) << " (<a href=\"" << picture.file << "\">"
      << picture.file << "</a>)</figcaption>\n</figure>\n";
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
  out << kTurning << "</body>\n</html>\n";
}

}  // namespace plumb::cli
