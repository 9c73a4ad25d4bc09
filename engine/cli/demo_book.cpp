#include "demo_book.h"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <ostream>
#include <system_error>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/io/text_output.h"
#include "plumb/predicates/rounding.h"

namespace plumb::cli {
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
