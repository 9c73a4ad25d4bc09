// Exceptions of the engine as exceptions of Python (plumb/_errors.py).
#include "binding.h"
#include "plumb/space/from_mesh.h"

namespace plumb::python {
namespace {

nb::object exception_class(const char* name) {
  return nb::module_::import_("plumb._errors").attr(name);
}

nb::object made(const nb::object& type, const Error& error) {
  const TextPlace& place = error.place();
  return type(static_cast<int>(error.code()), python_words(error.message()), place.file, place.line,
              place.column, python_words(error.what()));
}

void raise(const Error& error) {
  const nb::object type = exception_class("Error");
  PyErr_SetObject(type.ptr(), made(type, error).ptr());
}

void raise(const OpenMesh& error) {
  const MeshReport& report = error.report();
  const nb::object type = exception_class("OpenMesh");
  const nb::object raised = made(type, error);
  raised.attr("borders") = report.borders;
  raised.attr("holes") = report.holes;
  raised.attr("flipped") = report.flipped;
  raised.attr("one_sided") = report.one_sided;
  PyErr_SetObject(type.ptr(), raised.ptr());
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const OpenMesh& error) {
    raise(error);
  } catch (const Error& error) {
    raise(error);
  } catch (const BrokenInvariant& broken) {
    PyErr_SetString(exception_class("BrokenInvariant").ptr(), broken.what());
  }
}

}  // namespace

std::string python_words(std::string message) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kWords{{
      {"the time limit was reached", "the time limit was reached (raise timeout)"},
      {"left under the memory limit", "left under the memory limit (raise memory_limit)"},
      {"--merge-vertices", "merge_vertices=True"},
      {"--surface", "surface=True"},
  }};
  for (const auto& [option, keyword] : kWords) {
    for (std::size_t at = message.find(option); at != std::string::npos;
         at = message.find(option, at + keyword.size())) {
      message.replace(at, option.size(), keyword);
    }
  }
  return message;
}

void bind_errors(nb::module_&) { nb::register_exception_translator(translate); }

}  // namespace plumb::python
