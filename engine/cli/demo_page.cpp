#include "demo_page.h"

#include <cstddef>
#include <cstdio>
#include <numeric>
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
h2 { margin: 3rem 0 0.5rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr)); gap: 1.5rem; }
.pictures { margin-top: 1rem; align-items: start; }
figure { margin: 0; min-width: 0; }
figure.wide { grid-column: 1 / -1; }
figure img { width: 100%; height: auto; border: 1px solid #ccc; box-sizing: border-box; display: block; }
.sheet { overflow-x: auto; }
.sheet img { min-width: 50rem; }
figure iframe { width: 100%; height: min(80vh, 40rem); border: 1px solid #ccc; box-sizing: border-box; display: block; }
figure button { font: inherit; margin: 0.5rem 0 0; padding: 0.3rem 1rem; cursor: pointer; }
figcaption { color: #444; margin-top: 0.3rem; overflow-wrap: anywhere; }
table { border-spacing: 0; }
td { padding: 0.1rem 1rem 0.1rem 0; vertical-align: top; overflow-wrap: anywhere; }
td.time { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<h1>plumb demo</h1>
<p>What plumb does, on real data, with the time each step took here. Solids and surfaces can be turned around.</p>
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
  out << (is_wide ? "<figure class=\"wide\">\n<div class=\"sheet\">" : "<figure>\n")
      << "<img alt=\"" << title << "\" src=\"" << data_uri(picture.svg) << "\">"
      << (is_wide ? "</div>\n" : "\n");
  if (!picture.page.empty()) {
    out << "<button title=\"" << title << "\" data-page=\"" << escaped(picture.page)
        << "\">Turn it around</button>\n";
  }
  out << "<figcaption>" << escaped(picture.caption) << " (<a href=\"" << picture.file << "\">"
      << picture.file << "</a>)</figcaption>\n</figure>\n";
}

void write_row(std::ostream& out, double seconds, const std::string& html) {
  out << "<tr><td class=\"time\">" << milliseconds(seconds) << "</td><td>" << html
      << "</td></tr>\n";
}

/// What there is, and how long each took in all.
void write_contents(std::ostream& out, const std::vector<DemoChapter>& chapters) {
  out << "<table>\n";
  for (std::size_t i = 0; i < chapters.size(); ++i) {
    write_row(out, chapters[i].seconds(),
              "<a href=\"#chapter-" + std::to_string(i) + "\">" + escaped(chapters[i].title) +
                  "</a>: " + escaped(chapters[i].claim));
  }
  out << "</table>\n";
}

void write_chapter(std::ostream& out, const DemoChapter& chapter, std::size_t number) {
  out << "<h2 id=\"chapter-" << number << "\">" << escaped(chapter.title) << "</h2>\n<p>"
      << escaped(chapter.claim) << "</p>\n<table>\n";
  for (const DemoStep& step : chapter.steps) write_row(out, step.seconds, escaped(step.what));
  out << "</table>\n<div class=\"pictures\">\n";
  for (const DemoPicture& picture : chapter.pictures) write_picture(out, picture);
  out << "</div>\n";
}

}  // namespace

double DemoChapter::seconds() const {
  return std::accumulate(steps.begin(), steps.end(), 0.0,
                         [](double sum, const DemoStep& step) { return sum + step.seconds; });
}

void write_demo_steps(std::ostream& out, const std::vector<DemoChapter>& chapters) {
  for (const DemoChapter& chapter : chapters) {
    out << chapter.title << '\n';
    for (const DemoStep& step : chapter.steps) {
      const std::string time = milliseconds(step.seconds);
      out << std::string(time.size() < 10 ? 10 - time.size() : 0, ' ') << time << "  " << step.what
          << '\n';
    }
  }
}

void write_demo_page(std::ostream& out, const std::vector<DemoChapter>& chapters) {
  out << kHead;
  write_contents(out, chapters);
  for (std::size_t i = 0; i < chapters.size(); ++i) write_chapter(out, chapters[i], i);
  out << kTurning << "</body>\n</html>\n";
}

}  // namespace plumb::cli
