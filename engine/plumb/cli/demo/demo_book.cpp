#include "plumb/cli/demo/demo_book.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <string_view>
#include <system_error>
#include <utility>

#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

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

/// A page of its own inside this one, made when it is asked for: many at once would be too much for
/// a browser.
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

namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json demo_json(const std::string& page,
                                 const std::vector<DemoChapter>& chapters) {
  nlohmann::ordered_json json{{"page", page}, {"steps", nullptr}, {"pictures", nullptr}};
  for (const DemoChapter& chapter : chapters) {
    for (const DemoStep& step : chapter.steps) {
      json["steps"].push_back(
          {{"chapter", chapter.title}, {"what", step.what}, {"seconds", step.seconds}});
    }
    for (const DemoPicture& p : chapter.pictures) {
      json["pictures"].push_back({{"chapter", chapter.title},
                                  {"title", p.title},
                                  {"file", p.file},
                                  {"caption", p.caption}});
    }
  }
  return json;
}

}  // namespace

DemoBook::DemoBook(fs::path directory, Session& session)
    : directory_(std::move(directory)), session_(session) {
  std::error_code error;
  fs::create_directories(directory_, error);
  if (error) throw Error(ErrorCode::CannotWrite, error.message(), {directory_.string()});
}

/// $PLUMB_ROOT, else where this program was built from.
std::string DemoBook::bundled(const std::string& file) {
  const char* const root = std::getenv("PLUMB_ROOT");
  const bool is_set = root != nullptr && *root != '\0';
  return (fs::path(is_set ? root : PLUMB_SOURCE_DIR) / "corpus" / file).string();
}

void DemoBook::chapter(std::string title, std::string claim) {
  session_.begin("chapter");
  chapters_.push_back({std::move(title), std::move(claim)});
}

void DemoBook::step(const std::string& what) {
  const auto now = Clock::now();
  chapters_.back().steps.push_back(
      {what, std::chrono::duration<double>(now - step_start_).count()});
  step_start_ = now;
}

void DemoBook::write(const std::string& name, std::string bytes) {
  session_.outputs().add((directory_ / name).string(),
                         [bytes = std::move(bytes)](std::ostream& out) { out << bytes; });
}

void DemoBook::add(DemoPicture picture) {
  write(picture.file, picture.svg);
  if (!picture.page.empty()) {
    write(fs::path(picture.file).replace_extension(".html").string(), picture.page);
  }
  chapters_.back().pictures.push_back(std::move(picture));
}

std::string in_full(const Rational& value) {
  constexpr std::size_t kShort = 40;
  std::string exact = format_exact(value);
  if (exact.size() <= kShort) return exact;
  return "about " + format_double(nearest_double(value)) + ", exactly " + exact;
}

void DemoBook::finish() {
  session_.outputs().add((directory_ / "index.html").string(),
                         [this](std::ostream& out) { write_demo_page(out, chapters_); });
  session_.outputs().add("-", [this](std::ostream& out) {
    const std::string page = (directory_ / "index.html").string();
    if (session_.options().json) {
      out << demo_json(page, chapters_).dump() << '\n';
      return;
    }
    write_demo_steps(out, chapters_);
    out << "open " << page << '\n';
  });
  session_.deliver();
}

}  // namespace plumb::cli
