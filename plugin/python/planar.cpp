// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

Eigen::Vector2d planarPointOf(const char* name, const py::object& value) {
  constexpr const char* kind = "a sequence of two numbers";
  const auto numbers = argument<std::vector<double>>(name, value, kind);
  if (numbers.size() != 2)
    throw py::value_error(std::string(name) + " is " + shown(value) + ": " + kind + " is needed");
  const Eigen::Vector2d point(numbers[0], numbers[1]);
  if (!point.allFinite())
    throw py::value_error(std::string(name) + " is " + shown(value) + ": it must be finite");
  return point;
}

PlanarPoints planarPointsOf(const char* name, const py::handle& value) {
  const Array array = arrayOf(name, value);
  if (array.ndim() != 2 || array.shape(1) != 2)
    throw py::value_error(std::string(name) + " have shape " + shapeText(array) +
                          ": (count, 2) is needed");
  return Eigen::Map<const PlanarPoints>(array.data(), array.shape(0), 2);
}

HermiteEnds hermiteEndsOf(const py::object& start, const py::object& start_direction_rad,
                          const py::object& end, const py::object& end_direction_rad) {
  return {.start = planarPointOf("start", start),
          .start_direction_rad = parameter("start_direction_rad", start_direction_rad),
          .end = planarPointOf("end", end),
          .end_direction_rad = parameter("end_direction_rad", end_direction_rad)};
}

Eigen::VectorXd arrayOfNumbers(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

py::object splineWithinResult(const SplineWithin& spline) {
  py::dict dict;
  dict["curve"] = spline.curve;
  dict["distance_mm"] = spline.distance_mm;
  return resultOf("SplineWithin", dict);
}

double positiveNumber(const char* name, const py::object& value) {
  const double number = parameter(name, value);
  if (!(number > 0))
    throw py::value_error(std::string(name) + " is " + shown(py::float_(number)) +
                          ": it must be positive");
  return number;
}

void requireTurn(double turn_rad) {
  if (!(std::abs(turn_rad) <= most_turn_rad))
    throw py::value_error("the curve turns by " + shown(py::float_(turn_rad)) +
                          " rad: at most 10000 is possible");
}

BezierSpline exactSpline(const ArcChain& chain) {
  // Gaps were judged when the chain was made.
  return bezierSpline(chain.pieces(), chain.closed(), HUGE_VAL);
}

std::vector<PlanarArc> arcsOf(const char* name, const py::object& value) {
  const py::object chain = itemOrSelf(value, "chain");
  if (py::isinstance<ArcChain>(chain)) return chain.cast<const ArcChain&>().pieces();
  return piecesOf<PlanarArc>(name, value, "a PlanarArc");
}

Parameters parametersWithin(const char* name, const py::object& value, double last) {
  Parameters at(name, value);
  for (py::ssize_t i = 0; i < at.size(); ++i)
    if (!(at[i] >= 0 && at[i] <= last))
      throw py::value_error(std::string(name) + (at.isSingle() ? " is " : " has the value ") +
                            shown(py::float_(at[i])) + ": the curve has 0 .. " +
                            shown(py::float_(last)));
  return at;
}

}  // namespace seamwright::python
