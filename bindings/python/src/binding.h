// What all bindings of the Python module share: how numbers, points and arrays come in and go out,
// and how an operation runs.
//
//  - Numbers. Python's int, float and Fraction, and NumPy's scalars, are read exactly. Rational
//    goes out as fractions.Fraction.
//  - Arrays. Arrays of the right type and layout are read where they lie. Others are converted by
//    plumb/_arrays.py, which refuses what a conversion would change. Arrays that go out own their
//    memory, so that they outlive the object that they came from.
//  - Operations. def_run() binds a function whose first parameter is a Context. It adds the
//    keywords threads, timeout, memory_limit and progress, and releases the GIL while the function
//    runs. If a signal handler of Python or the callback raises an exception, the operation is
//    cancelled and the exception reaches the caller.
//
// An argument that cannot be converted keeps the exception, and require() throws it. A type caster
// must not throw, and "incompatible function arguments" would not say that a coordinate is NaN.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "plumb/base/arithmetic_watch.h"
#include "plumb/base/context.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational.h"

namespace plumb {
class Nef2;
class Nef3;
}  // namespace plumb

namespace plumb::python {

namespace nb = nanobind;
using namespace nb::literals;

using Path = std::filesystem::path;

// --- arguments --------------------------------------------------------------------------------

/// An exact number. Accepts int, float, Fraction and NumPy's scalars.
struct Number {
  Rational value;
  std::exception_ptr problem;
};

/// A point or vector with exact coordinates: a sequence of N numbers.
template <std::size_t N>
struct Exact {
  std::array<Rational, N> value;
  std::exception_ptr problem;
};

/// An array of numbers of type T with `Columns` columns; one dimension if there is one column.
template <class T, std::size_t Columns>
struct ArrayIn {
  using Array =
      std::conditional_t<Columns == 1,
                         nb::ndarray<const T, nb::shape<-1>, nb::c_contig, nb::device::cpu>,
                         nb::ndarray<const T, nb::shape<-1, static_cast<nb::ssize_t>(Columns)>,
                                     nb::c_contig, nb::device::cpu>>;
  Array array;
  std::exception_ptr problem;

  std::span<const T> span() const { return {array.data(), array.size()}; }
};
using Coordinates2 = ArrayIn<double, 2>;
using Coordinates3 = ArrayIn<double, 3>;
using Triangles = ArrayIn<std::uint32_t, 3>;
using Indices = ArrayIn<std::uint32_t, 1>;

/// An array that goes out, with `Columns` columns.
template <class T, std::size_t Columns>
struct ArrayOut {
  /// What the array holds; a bool is a byte, 0 or 1.
  using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;
  std::vector<Stored> values;
};

/// A dict from the names of things to their numbers.
using CountsOut = nb::typed<nb::dict, nb::str, nb::int_>;

/// Throws what went wrong when an argument was converted.
template <class T>
void require(const T& argument) {
  if constexpr (requires { argument.problem; }) {
    if (argument.problem) std::rethrow_exception(argument.problem);
  }
}
template <class T>
void require(const std::vector<T>& arguments) {
  for (const T& argument : arguments) require(argument);
}
template <class T>
void require(const std::optional<T>& argument) {
  if (argument) require(*argument);
}

/// Throws TypeError, or Error{NotFinite} for NaN and infinities.
Rational rational_of(nb::handle number);
/// Throws as rational_of() does, and TypeError unless `sequence` has as many members.
void rationals_of(nb::handle sequence, std::span<Rational> result);
/// Returns a fractions.Fraction.
nb::object fraction_of(const Rational& number);
/// Calls a function of plumb/_arrays.py.
nb::object converted_array(const char* function, nb::handle array, std::size_t columns);

// --- operations -------------------------------------------------------------------------------

/// The limits of a call, as the keywords of a method give them.
struct CallLimits {
  unsigned threads;
  std::optional<double> timeout;
  std::optional<std::uint64_t> memory_limit;
  nb::object progress;

  /// Throws Error{BadArgument} if the time limit is not positive.
  Limits limits() const;
};

/// Watches a running operation for signals, and reports its progress.
class Watcher {
 public:
  explicit Watcher(nb::object progress) : progress_(std::move(progress)) {}
  std::stop_token token() const { return stop_.get_token(); }
  /// Returns the callback of the context; an empty one if nobody wants to know.
  ProgressCallback callback();
  /// Throws the exception that stopped the operation, if there is one. Requires the GIL.
  void rethrow() const {
    if (problem_) std::rethrow_exception(problem_);
  }

 private:
  void look(std::string_view phase, std::uint64_t done, std::uint64_t total);

  nb::object progress_;
  std::stop_source stop_;
  std::exception_ptr problem_;
};

/// Calls f without the GIL.
template <class F>
auto without_gil(F&& f) {
  const nb::gil_scoped_release release;
  return f();
}

/// Calls f with a context, without the GIL. The function has to return a value.
template <class F>
auto run(const CallLimits& call, F&& f) {
  Watcher watcher(call.progress);
  Context context(call.limits(), watcher.token(), watcher.callback(), call.threads);
  const ArithmeticWatch watch(context);
  // A signal that came too late to stop the operation is not lost either.
  const auto finish = [&watcher](auto result) {
    watcher.rethrow();
    return result;
  };
  try {
    return finish(without_gil([&] { return f(context); }));
  } catch (const Error& error) {
    if (error.code() == ErrorCode::Cancelled) watcher.rethrow();
    throw;
  }
}

/// Returns a text that lives as long as the module.
inline const char* kept(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text)).c_str();
}

/// Returns the docstring of a function that def_run() binds.
inline const char* with_limits(const char* doc) {
  return kept(std::string(doc) +
              "\n\n"
              "Every operation accepts these keywords: threads (the number of threads), timeout "
              "(in seconds), memory_limit (in bytes) and progress (a function that is called with "
              "phase, done and total).");
}

template <class R, class... A>
auto with_context(R (*f)(Context&, A...)) {
  return [f](A... arguments, unsigned threads, std::optional<double> timeout,
             std::optional<std::uint64_t> memory_limit, nb::object progress) {
    (require(arguments), ...);
    return run(CallLimits{threads, timeout, memory_limit, std::move(progress)},
               [&](Context& context) { return f(context, arguments...); });
  };
}

/// Binds a method that runs an operation.
template <class Class, class R, class... A, class... Extra>
void def_run(Class& c, const char* name, R (*f)(Context&, A...), const char* doc,
             const Extra&... extra) {
  c.def(name, with_context(f), extra..., nb::kw_only(), "threads"_a = 1U, "timeout"_a = nb::none(),
        "memory_limit"_a = nb::none(), "progress"_a = nb::none(), with_limits(doc));
}

/// Binds a static method that runs an operation.
template <class Class, class R, class... A, class... Extra>
void def_run_static(Class& c, const char* name, R (*f)(Context&, A...), const char* doc,
                    const Extra&... extra) {
  c.def_static(name, with_context(f), extra..., nb::kw_only(), "threads"_a = 1U,
               "timeout"_a = nb::none(), "memory_limit"_a = nb::none(), "progress"_a = nb::none(),
               with_limits(doc));
}

/// Calls `warnings.warn(text, plumb.FileWarning)` for each text.
void warn(const std::vector<std::string>& texts);
/// Logs each text to the logger "plumb" with the level INFO.
void note(const std::vector<std::string>& texts);

/// Returns a message of the engine with the options of the program as keywords of Python.
std::string python_words(std::string message);

// --- the parts of the module, each in a file of its own ------------------------------------------

void bind_errors(nb::module_& m);
void bind_solid(nb::module_& m);
void bind_plane(nb::module_& m);
void bind_sphere(nb::module_& m);
void bind_map(nb::module_& m);
void bind_surface(nb::module_& m);
void bind_models(nb::module_& m);
void bind_layer(nb::module_& m);
void bind_meshes(nb::module_& m);
/// Add the methods of model.cpp to the classes.
void def_models(nb::class_<Nef3>& c);
void def_models(nb::class_<Nef2>& c);

}  // namespace plumb::python

// --- type casters -----------------------------------------------------------------------------

namespace nanobind::detail {

/// A path: a str, or an object with __fspath__().
template <>
struct type_caster<std::filesystem::path> {
  NB_TYPE_CASTER(std::filesystem::path, const_name("str | os.PathLike[str]"))
  bool from_python(handle source, std::uint32_t, cleanup_list*) noexcept {
    const object path = steal(PyOS_FSPath(source.ptr()));
    if (path.is_valid() && PyUnicode_Check(path.ptr())) {
      const object bytes = steal(PyUnicode_EncodeFSDefault(path.ptr()));
      if (bytes.is_valid()) {
        value = PyBytes_AsString(bytes.ptr());
        return true;
      }
    }
    PyErr_Clear();
    return false;
  }
};

template <>
struct type_caster<plumb::python::Number> {
  NB_TYPE_CASTER(plumb::python::Number, const_name("int | float | fractions.Fraction"))
  bool from_python(handle source, std::uint32_t, cleanup_list*) noexcept {
    try {
      value.value = plumb::python::rational_of(source);
    } catch (...) {
      value.problem = std::current_exception();
    }
    return true;
  }
};

template <std::size_t N>
struct type_caster<plumb::python::Exact<N>> {
  NB_TYPE_CASTER(plumb::python::Exact<N>,
                 const_name("collections.abc.Sequence[int | float | fractions.Fraction]"))
  bool from_python(handle source, std::uint32_t, cleanup_list*) noexcept {
    try {
      plumb::python::rationals_of(source, value.value);
    } catch (...) {
      value.problem = std::current_exception();
    }
    return true;
  }
};

template <class T, std::size_t Columns>
struct type_caster<plumb::python::ArrayIn<T, Columns>> {
  using In = plumb::python::ArrayIn<T, Columns>;
  NB_TYPE_CASTER(In, const_name("numpy.typing.ArrayLike"))
  bool from_python(handle source, std::uint32_t, cleanup_list* cleanup) noexcept {
    try {
      if (take(source, cleanup)) return true;
      const char* function = std::is_floating_point_v<T> ? "coordinates" : "indices";
      const object converted = plumb::python::converted_array(function, source, Columns);
      if (!take(converted, cleanup)) raise_type_error("The array cannot be read.");
    } catch (...) {
      value.problem = std::current_exception();
    }
    return true;
  }

 private:
  bool take(handle source, cleanup_list* cleanup) {
    make_caster<typename In::Array> caster;
    if (!caster.from_python(source, 0, cleanup)) return false;
    value.array = std::move(caster.value);
    return true;
  }
};

template <class T, std::size_t Columns>
struct type_caster<plumb::python::ArrayOut<T, Columns>> {
  using Out = plumb::python::ArrayOut<T, Columns>;
  using Array =
      std::conditional_t<Columns == 1, ndarray<numpy, T, shape<-1>>,
                         ndarray<numpy, T, shape<-1, static_cast<nanobind::ssize_t>(Columns)>>>;
  using ArrayCaster = make_caster<Array>;
  using Value = Out;
  static constexpr auto Name = ArrayCaster::Name;
  template <class>
  using Cast = Out;
  template <class>
  static constexpr bool can_cast() {
    return false;
  }
  static handle from_cpp(const Out& out, rv_policy policy, cleanup_list* cleanup) {
    return from_cpp(Out(out), policy, cleanup);
  }
  static handle from_cpp(Out&& out, rv_policy, cleanup_list* cleanup) {
    using Values = decltype(out.values);
    auto* const kept = new Values(std::move(out.values));
    const capsule owner(kept, [](void* p) noexcept { delete static_cast<Values*>(p); });
    const std::size_t shape[2] = {kept->size() / Columns, Columns};
    const Array array(reinterpret_cast<T*>(kept->data()), Columns == 1 ? 1 : 2, shape, owner);
    return ArrayCaster::from_cpp(array, rv_policy::reference, cleanup);
  }
};

template <>
struct type_caster<plumb::Rational> {
  using Value = plumb::Rational;
  static constexpr auto Name = const_name("fractions.Fraction");
  template <class>
  using Cast = plumb::Rational;
  static handle from_cpp(const plumb::Rational& number, rv_policy, cleanup_list*) {
    return plumb::python::fraction_of(number).release();
  }
};

}  // namespace nanobind::detail
