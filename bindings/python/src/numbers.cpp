// Exact numbers and arrays between Python and C++.
#include <gmp.h>

#include "binding.h"

namespace plumb::python {
namespace {

nb::object import_once(const char* module, const char* name) {
  return nb::module_::import_(module).attr(name);
}

void set_from_int(mpz_ptr result, nb::handle number) {
  int overflow = 0;
  const long small = PyLong_AsLongAndOverflow(number.ptr(), &overflow);
  if (overflow == 0) {
    if (small == -1 && PyErr_Occurred() != nullptr) throw nb::python_error();
    mpz_set_si(result, small);
    return;
  }
  const auto digits = nb::steal<nb::str>(PyNumber_ToBase(number.ptr(), 16));
  if (!digits.is_valid()) throw nb::python_error();
  mpz_set_str(result, digits.c_str(), 0);  // The text begins with 0x or -0x.
}

Integer integer_of(nb::handle number) {
  Integer result;
  const auto index = nb::steal<nb::object>(PyNumber_Index(number.ptr()));
  if (!index.is_valid()) throw nb::python_error();
  mpz_t value;
  mpz_init(value);
  set_from_int(value, index);
  result = Integer(value);
  mpz_clear(value);
  return result;
}

nb::object int_of(mpz_srcptr number) {
  if (mpz_fits_slong_p(number) != 0) {
    return nb::steal<nb::object>(PyLong_FromLong(mpz_get_si(number)));
  }
  std::string digits(mpz_sizeinbase(number, 16) + 2, '\0');
  mpz_get_str(digits.data(), 16, number);
  return nb::steal<nb::object>(PyLong_FromString(digits.c_str(), nullptr, 16));
}

bool is_float(nb::handle number) { return PyFloat_Check(number.ptr()); }

}  // namespace

Rational rational_of(nb::handle number) {
  if (PyLong_Check(number.ptr())) return Rational(integer_of(number));
  if (is_float(number)) return Rational(PyFloat_AsDouble(number.ptr()));
  if (nb::hasattr(number, "numerator") && nb::hasattr(number, "denominator")) {
    return Rational(integer_of(number.attr("numerator")), integer_of(number.attr("denominator")));
  }
  if (nb::hasattr(number, "as_integer_ratio") && nb::hasattr(number, "__float__")) {
    const double rounded = nb::cast<double>(nb::float_(number));
    if (!(rounded - rounded == 0)) return Rational(rounded);  // Throws Error{NotFinite}.
    const nb::tuple ratio(number.attr("as_integer_ratio")());
    return Rational(integer_of(ratio[0]), integer_of(ratio[1]));
  }
  nb::raise_type_error("An exact number is needed: int, float or Fraction.");
}

void rationals_of(nb::handle sequence, std::span<Rational> result) {
  if (!nb::hasattr(sequence, "__len__") || nb::len(sequence) != result.size()) {
    const std::string text = std::to_string(result.size());
    nb::raise_type_error("A sequence of %s numbers is needed.", text.c_str());
  }
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = rational_of(sequence[i]);
}

nb::object fraction_of(const Rational& number) {
  static const nb::handle fraction = import_once("fractions", "Fraction").release();
  return fraction(int_of(mpq_numref(number.mpq())), int_of(mpq_denref(number.mpq())));
}

nb::object converted_array(const char* function, nb::handle array, std::size_t columns) {
  return import_once("plumb._arrays", function)(array, columns);
}

void warn(const std::vector<std::string>& texts) {
  if (texts.empty()) return;
  const nb::object category = import_once("plumb._errors", "FileWarning");
  for (const std::string& text : texts) {
    if (PyErr_WarnEx(category.ptr(), text.c_str(), 1) != 0) throw nb::python_error();
  }
}

void note(const std::vector<std::string>& texts) {
  if (texts.empty()) return;
  const nb::object logger = import_once("logging", "getLogger")("plumb");
  for (const std::string& text : texts) logger.attr("info")("%s", text);
}

}  // namespace plumb::python
