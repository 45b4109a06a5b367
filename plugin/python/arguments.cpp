// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <regex>

#include <seamwright/plugin/python/arguments.hpp>

namespace seamwright::python {

namespace {

ContinuityTolerance profileOf(const py::object& value) {
  const auto name = argument<std::string>("profile", value, "a name");
  if (const auto tolerance = toleranceProfile(name)) return *tolerance;
  std::string known;
  for (const ToleranceProfile& profile : toleranceProfiles())
    known += (known.empty() ? "" : ", ") + std::string(profile.name);
  throw py::value_error("profile " + shown(value) + ": known are " + known);
}

/// The kind of numbers in an array or a number of numpy without dimensions; '-' for others.
char singleKind(const py::handle& value) {
  if (!py::hasattr(value, "dtype") || !py::hasattr(value, "ndim")) return '-';
  if (py::cast<int>(value.attr("ndim")) != 0) return '-';
  return py::cast<std::string>(value.attr("dtype").attr("kind")).front();
}

bool isText(const py::handle& value) {
  return PyUnicode_Check(value.ptr()) || PyBytes_Check(value.ptr());
}

/// Whether the value is a sequence, a set or an iterator; text and dicts are not.
bool hasItems(const py::handle& value) {
  return !isText(value) && !PyDict_Check(value.ptr()) && py::isinstance<py::iterable>(value);
}

}  // namespace

std::string shown(const py::object& value) {
  std::string text = py::cast<std::string>(py::repr(value));
  text = std::regex_replace(text, std::regex("\\s+"), " ");
  // A choice: what fits on a line of a terminal beside the rest of a message.
  constexpr std::size_t longest = 120, part = 50;
  if (text.size() <= longest) return text;
  return text.substr(0, part) + " ... " + text.substr(text.size() - part);
}

bool isFlag(const py::handle& value) {
  return PyBool_Check(value.ptr()) || singleKind(value) == 'b';
}

bool isNumber(const py::handle& value) {
  if (isFlag(value)) return false;
  if (PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr())) return true;
  return std::string("iuf").find(singleKind(value)) != std::string::npos;
}

bool isSequence(const py::handle& value) {
  return hasItems(value) && py::isinstance<py::sequence>(value);
}

double parameter(const char* name, const py::object& value) {
  const double number = numberOf(name, value);
  if (!std::isfinite(number))
    throw py::value_error(std::string(name) + " is " + shown(py::float_(number)) +
                          ": it must be finite");
  return number;
}

std::optional<double> optionalNumber(const char* name, const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return numberOf(name, value);
}

std::optional<int> optionalWhole(const char* name, const py::object& value) {
  if (value.is_none()) return std::nullopt;
  return wholeNumber(name, value);
}

std::vector<double> listOf(const char* name, const py::object& value) {
  return argument<std::vector<double>>(name, value, "a sequence of numbers");
}

Eigen::Vector3d vectorOf(const char* name, const py::object& value) {
  constexpr const char* kind = "a sequence of three numbers";
  const auto numbers = argument<std::vector<double>>(name, value, kind);
  if (numbers.size() != 3)
    throw py::value_error(std::string(name) + " is " + shown(value) + ": " + kind + " is needed");
  return {numbers[0], numbers[1], numbers[2]};
}

std::filesystem::path pathOf(const char* name, const py::object& value) {
  try {
    return value.cast<std::filesystem::path>();
  } catch (const py::cast_error&) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " is " + shown(value) +
                         ": the name of a file is needed");
  }
}

Eigen::VectorXd numbersOf(const std::string& name, const py::object& value) {
  const auto numbers = argument<std::vector<double>>(name.c_str(), value, "a sequence of numbers");
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

bool isReal(const py::handle& value) {
  if (isFlag(value) || PyComplex_Check(value.ptr()) || PyUnicode_Check(value.ptr())) return false;
  return !py::hasattr(value, "dtype") || isNumber(value);
}

ContinuityTolerance toleranceOf(const ToleranceArguments& given) {
  const ContinuityTolerance usual = profileOf(given.profile);
  const auto number = [](const char* name, const py::object& value, double otherwise) {
    return optionalNumber(name, value).value_or(otherwise);
  };
  return {number("gap_mm", given.gap_mm, usual.gap_mm),
          radians_per_degree *
              number("angle_deg", given.angle_deg, usual.angle_rad / radians_per_degree),
          number("curvature_rel", given.curvature_rel, usual.curvature_rel),
          number("flat_radius_mm", given.flat_radius_mm, usual.flat_radius_mm),
          radians_per_degree *
              number("crease_deg", given.crease_deg, usual.crease_rad / radians_per_degree)};
}

Level levelOf(const py::object& value) {
  if (const auto level = levelFromName(argument<std::string>("level", value, "a name")))
    return *level;
  throw py::value_error("level " + shown(value) + ": known are G0, G1, G2 and G3");
}

int targetOrder(const py::object& target) {
  const auto name = argument<std::string>("target", target, "a name");
  if (name == "G1") return 1;
  if (name == "G2") return 2;
  throw py::value_error("target " + shown(target) + ": known are G1 and G2");
}

bool flagOf(const char* name, const py::object& value) {
  if (!isFlag(value))
    throw py::value_error(std::string(name) + " is " + shown(value) + ": True or False is needed");
  return PyObject_IsTrue(value.ptr()) == 1;
}

std::vector<int> wholeNumbers(const char* name, const py::object& value) {
  const bool one_dimension = !py::hasattr(value, "ndim") || py::cast<int>(value.attr("ndim")) == 1;
  if (!one_dimension || !hasItems(value))
    throw py::value_error(std::string(name) + " is " + shown(value) +
                          ": a sequence of whole numbers is needed");
  std::vector<int> numbers;
  for (const py::handle item : value)
    numbers.push_back(
        argument<int>(name, py::reinterpret_borrow<py::object>(item), "a whole number"));
  return numbers;
}

std::vector<int> wholeNumbersOrOne(const char* name, const py::object& value) {
  if (hasItems(value)) return wholeNumbers(name, value);
  return {argument<int>(name, value, "a whole number or a sequence of whole numbers")};
}

std::vector<double> each(const char* name, const py::object& value, Eigen::Index count) {
  constexpr const char* kind = "a number or a sequence of numbers";
  if (isNumber(value))
    return std::vector<double>(static_cast<std::size_t>(count),
                               argument<double>(name, value, kind));
  return argument<std::vector<double>>(name, value, kind);
}

}  // namespace seamwright::python
