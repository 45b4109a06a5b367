// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <seamwright/core/angle.hpp>
#include <seamwright/core/seam/judge.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace seamwright::python {

namespace py = pybind11;

/// The repr of a value on one line, shortened in the middle if it is long.
std::string shown(const py::object& value);

/// Whether the value may be a real number: not complex, not a boolean, not text, not an array of
/// one or more dimensions.
bool isReal(const py::handle& value);

/// Whether the value is True or False, also of numpy.
bool isFlag(const py::handle& value);

/// Whether the value is a number of Python or numpy, or an array of numbers without dimensions.
bool isNumber(const py::handle& value);

/// Whether the value has items by index: neither text nor an array without dimensions.
bool isSequence(const py::handle& value);

/// The value of a keyword; ValueError with name and value if it has another type. Other numbers are
/// not converted to integers. Booleans and complex numbers are not converted to real numbers or
/// sequences of real numbers.
template <class T>
T argument(const char* name, const py::object& value, const char* kind) {
  const auto refuse = [&] {
    throw py::value_error(std::string(name) + " is " + shown(value) + ": " + kind + " is needed");
  };
  if (isFlag(value)) refuse();
  if constexpr (std::is_floating_point_v<T>)
    if (!isReal(value)) refuse();
  if constexpr (std::is_same_v<T, std::vector<double>>) {
    const bool one_dimension =
        !py::hasattr(value, "ndim") || py::cast<int>(value.attr("ndim")) == 1;
    if (!py::isinstance<py::sequence>(value) || !one_dimension) refuse();
    for (const py::handle item : value)
      if (!isReal(item)) refuse();
  }
  try {
    if constexpr (std::is_integral_v<T>) {
      const auto index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
      if (!index) PyErr_Clear();
      if (!index) refuse();
      return index.template cast<T>();
    }
    return value.cast<T>();
  } catch (const py::cast_error&) {
    refuse();
    throw;
  }
}

inline double numberOf(const char* name, const py::object& value) {
  return argument<double>(name, value, "a number");
}

inline int wholeNumber(const char* name, const py::object& value) {
  return argument<int>(name, value, "a whole number");
}

/// A finite number.
double parameter(const char* name, const py::object& value);

/// Nothing for None.
std::optional<double> optionalNumber(const char* name, const py::object& value);
std::optional<int> optionalWhole(const char* name, const py::object& value);

/// The numbers of a sequence.
Eigen::VectorXd numbersOf(const std::string& name, const py::object& value);
std::vector<double> listOf(const char* name, const py::object& value);

/// Three numbers.
Eigen::Vector3d vectorOf(const char* name, const py::object& value);

/// A single number repeated \p count times, or the numbers of a sequence of any length.
std::vector<double> each(const char* name, const py::object& value, Eigen::Index count);

/// True or False; ValueError for anything else.
bool flagOf(const char* name, const py::object& value);

/// The numbers of a sequence of integers.
std::vector<int> wholeNumbers(const char* name, const py::object& value);

/// A single integer, or the numbers of a sequence of integers.
std::vector<int> wholeNumbersOrOne(const char* name, const py::object& value);

/// The name of a file; TypeError for anything else.
std::filesystem::path pathOf(const char* name, const py::object& value);

/// An object of a bound class; TypeError, which names the argument, for anything else.
/// \param kind "a BezierCurve"
template <class Type>
const Type& objectOf(const std::string& name, const py::handle& value, const char* kind) {
  if (!py::isinstance<Type>(value))
    throw py::type_error(name + " is " + shown(py::reinterpret_borrow<py::object>(value)) + ": " +
                         kind + " is needed");
  return value.cast<const Type&>();
}

/// Tolerances as keywords: each is a number, or None for the profile's.
struct ToleranceArguments {
  const py::object& profile;
  const py::object& gap_mm;
  const py::object& angle_deg;
  const py::object& curvature_rel;
  const py::object& flat_radius_mm;
  const py::object& crease_deg;
};

/// The crease angle if there are no creases, as at the joints of curves: every tolerance is below
/// it.
inline py::object noCrease() {
  return py::float_(90.0);
}

ContinuityTolerance toleranceOf(const ToleranceArguments& arguments);
Level levelOf(const py::object& value);

/// The order of contact of the keyword target: 1 for "G1", 2 for "G2".
int targetOrder(const py::object& target);

}  // namespace seamwright::python
