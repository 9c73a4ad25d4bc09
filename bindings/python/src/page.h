// Pages that show an object in a browser, and in a notebook.
#pragma once

#include <string>

#include "plumb/base/context.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/nef2.h"
#include "plumb/space/nef3.h"
#include "plumb/surface/surface.h"
#include "set_grammar.h"

namespace plumb::python {

// Each returns a complete page, which loads nothing.
std::string page_of(Context& context, const Nef3& set, const std::string& title);
std::string page_of(Context& context, const Nef2& set, const std::string& title);
std::string page_of(Context& context, const MapReport& report, const std::string& title);
std::string page_of(Context& context, const SurfaceDivision& division, const std::string& title);

/// Returns a frame that shows a page inside another page.
std::string frame_of(const std::string& page);

/// Binds to_html() and the view in notebooks.
template <class T>
void def_page(nb::class_<T>& c) {
  def_run(
      c, "to_html",
      +[](Context& k, const T& object, const std::string& title) {
        return page_of(k, object, title);
      },
      "Return an HTML page that shows the object and does not load other files.", "title"_a = "");
  c.def(
      "_repr_html_",
      [](const T& object) {
        return run(CallLimits{1, std::nullopt, std::nullopt, nb::none()},
                   [&](Context& k) { return frame_of(page_of(k, object, "")); });
      },
      "Return the HTML text that a notebook shows for the object.");
}

}  // namespace plumb::python
