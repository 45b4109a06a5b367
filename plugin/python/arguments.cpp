// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

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

double numberOf(const char* name, const py::object& value, double otherwise) {
  return value.is_none() ? otherwise : argument<double>(name, value, "a number");
}

}  // namespace

Eigen::VectorXd numbersOf(const std::string& name, const py::object& value) {
  const auto numbers = argument<std::vector<double>>(name.c_str(), value, "a sequence of numbers");
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

bool isReal(const py::handle& value) {
  if (PyBool_Check(value.ptr()) || PyComplex_Check(value.ptr()) || PyUnicode_Check(value.ptr()))
    return false;
  if (!py::hasattr(value, "dtype")) return true;
  const auto kind = py::cast<std::string>(value.attr("dtype").attr("kind"));
  return std::string("iuf").find(kind) != std::string::npos &&
         py::cast<int>(value.attr("ndim")) == 0;
}

ContinuityTolerance toleranceOf(const ToleranceArguments& given) {
  const ContinuityTolerance usual = profileOf(given.profile);
  return {numberOf("gap_mm", given.gap_mm, usual.gap_mm),
          radians_per_degree *
              numberOf("angle_deg", given.angle_deg, usual.angle_rad / radians_per_degree),
          numberOf("curvature_rel", given.curvature_rel, usual.curvature_rel),
          numberOf("flat_radius_mm", given.flat_radius_mm, usual.flat_radius_mm),
          radians_per_degree *
              numberOf("crease_deg", given.crease_deg, usual.crease_rad / radians_per_degree)};
}

Level levelOf(const py::object& value) {
  if (const auto level = levelFromName(argument<std::string>("level", value, "a name")))
    return *level;
  throw py::value_error("level " + shown(value) + ": known are G0, G1, G2 and G3");
}

int orderOf(const py::object& target) {
  const auto name = argument<std::string>("target", target, "a name");
  if (name == "G1") return 1;
  if (name == "G2") return 2;
  throw py::value_error("target " + shown(target) + ": known are G1 and G2");
}

bool flagOf(const char* name, const py::object& value) {
  if (!PyBool_Check(value.ptr()))
    throw py::value_error(std::string(name) + " is " + shown(value) + ": True or False is needed");
  return value.cast<bool>();
}

std::vector<int> wholeNumbers(const char* name, const py::object& value) {
  const bool is_text = PyUnicode_Check(value.ptr()) || PyBytes_Check(value.ptr());
  const bool one_dimension = !py::hasattr(value, "ndim") || py::cast<int>(value.attr("ndim")) == 1;
  if (is_text || !one_dimension || !py::isinstance<py::iterable>(value))
    throw py::value_error(std::string(name) + " is " + shown(value) +
                          ": a sequence of whole numbers is needed");
  std::vector<int> numbers;
  for (const py::handle item : value)
    numbers.push_back(
        argument<int>(name, py::reinterpret_borrow<py::object>(item), "a whole number"));
  return numbers;
}

std::vector<double> each(const char* name, const py::object& value, Eigen::Index count) {
  constexpr const char* kind = "a number or a sequence of numbers";
  if (py::isinstance<py::float_>(value) || py::isinstance<py::int_>(value))
    return std::vector<double>(static_cast<std::size_t>(count),
                               argument<double>(name, value, kind));
  return argument<std::vector<double>>(name, value, kind);
}

}  // namespace seamwright::python
