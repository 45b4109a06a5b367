// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/fair/function_spline.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/fairness.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

std::optional<EndSlopes> endSlopesOf(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  const Eigen::Vector2d slopes = planarPointOf("slopes", value);
  return EndSlopes{.start = slopes.x(), .end = slopes.y()};
}

/// The spline through points, or the one that a result holds.
FunctionSpline functionSplineOf(const py::object& points, const py::object& slopes) {
  const py::object spline = itemOrSelf(points, "spline");
  const PlanarPoints rows = planarPointsOf("points", itemOrSelf(spline, "points_mm"));
  const py::object own = itemOrSelf(spline, "slopes");
  if (own.is(spline)) return functionSpline(rows, endSlopesOf(slopes));
  if (!slopes.is_none())
    throw py::value_error("slopes are " + shown(slopes) +
                          ", but points are a spline, which has its own");
  return functionSpline(rows, endSlopesOf(own));
}

py::object functionSplineResult(const FunctionSpline& spline) {
  py::dict dict;
  dict["points_mm"] = spline.points;
  dict["slopes"] = py::none();
  if (spline.slopes) dict["slopes"] = py::make_tuple(spline.slopes->start, spline.slopes->end);
  dict["second_per_mm"] = spline.second_per_mm;
  dict["third_jumps_per_mm2"] = thirdJumps_per_mm2(spline);
  dict["curve"] = bsplineCurve(spline);
  return resultOf("FunctionSpline", dict);
}

py::object functionFairnessResult(const FunctionFairness& fairness) {
  py::dict dict;
  dict["bending_per_mm"] = fairness.bending_per_mm;
  dict["jumps_per_mm2"] = fairness.jumps_per_mm2;
  dict["curvature"] = curveFairnessResult(fairness.curve);
  return resultOf("FunctionFairness", dict);
}

template <class Fair>
py::object fairedFunctionResult(const Fair& fair) {
  const FairedFunction faired = [&] {
    const py::gil_scoped_release release;
    return fair();
  }();
  py::dict dict;
  dict["spline"] = functionSplineResult(faired.spline);
  dict["curve"] = bsplineCurve(faired.spline);
  dict["moved_mm"] = faired.moved_mm;
  dict["before"] = functionFairnessResult(faired.before);
  dict["after"] = functionFairnessResult(faired.after);
  dict["steps"] = faired.steps;
  dict["added_extrema"] = faired.addedExtrema();
  dict["added_inflections"] = faired.addedInflections();
  return resultOf("FairedFunction", dict);
}

py::object functionSplineThrough(const py::object& points, const py::object& slopes) {
  return functionSplineResult(functionSplineOf(points, slopes));
}

py::object functionFairnessOf(const py::object& points, const py::object& slopes) {
  return functionFairnessResult(fairnessOf(functionSplineOf(points, slopes)));
}

py::object correctFunctionAtOf(const py::object& points, const py::object& index,
                               const py::object& limit_mm, const py::object& slopes) {
  const FunctionSpline spline = functionSplineOf(points, slopes);
  const double limit = limit_mm.is_none() ? HUGE_VAL : numberOf("limit_mm", limit_mm);
  return functionSplineResult(correctedAt(spline, wholeNumber("index", index), limit));
}

py::object correctFunctionOf(const py::object& points, const py::object& tolerance_mm,
                             const py::object& slopes) {
  const FunctionSpline spline = functionSplineOf(points, slopes);
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  return fairedFunctionResult([&] { return correctFunction(spline, tolerance); });
}

py::object reboundedOf(const py::object& points, const py::object& slopes) {
  return functionSplineResult(rebounded(functionSplineOf(points, slopes)));
}

py::object reboundFunctionOf(const py::object& points, const py::object& tolerance_mm,
                             const py::object& slopes, const py::object& most_rebounds) {
  const FunctionSpline spline = functionSplineOf(points, slopes);
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  const ReboundOptions options{.most_rebounds = wholeNumber("most_rebounds", most_rebounds)};
  return fairedFunctionResult([&] { return reboundFunction(spline, tolerance, options); });
}

py::object polishFunctionOf(const py::object& points, const py::object& tolerance_mm) {
  const FunctionSpline spline = functionSplineOf(points, py::none());
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  return fairedFunctionResult([&] { return polishFunction(spline, tolerance); });
}

Eigen::VectorXd polishedPolesOf(const py::object& ordinates_mm, const py::object& steps) {
  const int count = wholeNumber("steps", steps);
  return polishedPoles(numbersOf("ordinates_mm", ordinates_mm), count);
}

void bindFunctionFairing(py::module_& module) {
  module.def("correct_function_at", &correctFunctionAtOf, py::arg("points"), py::arg("index"),
             py::arg("limit_mm") = py::none(), py::kw_only(), py::arg("slopes") = py::none(),
             R"(The FunctionSpline whose third derivative does not jump at a point between the ends.

points, slopes: as of function_spline(). The ordinate of the point becomes the value of the spline
that omits it. limit_mm: its largest move; None: none. ValueError for another index and a limit that
is negative. Source: docs/theory/planar.md P12.2.
)");
  module.def("correct_function", &correctFunctionOf, py::arg("points"), py::arg("tolerance_mm"),
             py::kw_only(), py::arg("slopes") = py::none(),
             R"(A spline y(x) corrected where its third derivative jumps most: a FairedFunction.

points, slopes: as of function_spline(). Each correction moves one ordinate to where the bending is
least. The bending does not grow, no value changes by more than tolerance_mm, and a tolerance of 0
changes nothing. ValueError for a tolerance that is negative or not finite. Source:
docs/theory/planar.md P12.2.
)");
  module.def("rebounded", &reboundedOf, py::arg("points"), py::kw_only(),
             py::arg("slopes") = py::none(),
             R"(The FunctionSpline after one rebound.

points, slopes: as of function_spline(). The spline through the values in the middle of each piece
gives the new ordinates; ends and slopes stay. Source: docs/theory/planar.md P12.3.
)");
  module.def(
      "rebound_function", &reboundFunctionOf, py::arg("points"), py::arg("tolerance_mm"),
      py::kw_only(), py::arg("slopes") = py::none(), py::arg("most_rebounds") = 3,
      R"(A spline y(x) after rebounds, through its own values between points: a FairedFunction.

points, slopes: as of function_spline(). Rebounds end with their number or the tolerance; many of
them leave a single cubic or a line. The bending does not grow. ValueError for a tolerance that is
negative or not finite, and a negative number. Source: docs/theory/planar.md P12.3.
)");
  module.def("polish_function", &polishFunctionOf, py::arg("points"), py::arg("tolerance_mm"),
             R"(A spline y(x) with natural ends after iterative polishing: a FairedFunction.

points: as of function_spline(), with equal distances in x. It is the uniform cubic B-spline with
the fewest iterations that stay within tolerance_mm. The bending does not grow. ValueError for
slopes, unequal distances, and a tolerance that is negative or not finite. Source:
docs/theory/planar.md P12.4.
)");
  module.def("polished_poles", &polishedPolesOf, py::arg("ordinates_mm"), py::arg("steps"),
             R"(Ordinates of the poles of a uniform cubic B-spline after iterations: (count,) in mm.

Each of the steps adds to the poles what the spline misses of ordinates_mm, (count,); without steps
they are those ordinates. ValueError for a negative number of steps. Source: docs/theory/planar.md
P12.4.
)");
}

}  // namespace

void bindFunctionSpline(py::module_& module) {
  module.def("function_spline", &functionSplineThrough, py::arg("points"), py::kw_only(),
             py::arg("slopes") = py::none(),
             R"(The cubic spline y(x) through points: a FunctionSpline.

points: (x, y), (count, 2) in mm, with increasing x; or a FunctionSpline or FairedFunction. slopes:
dy/dx at both ends; None: natural ends, without curvature. ValueError for fewer than 2 points,
numbers that are not finite, and x that does not increase, with the index. Source:
docs/theory/planar.md P12.1; [deBoor2001].
)");
  module.def("function_fairness", &functionFairnessOf, py::arg("points"), py::kw_only(),
             py::arg("slopes") = py::none(),
             R"(How fair the cubic spline y(x) through points is: a FunctionFairness.

points, slopes: as of function_spline(). Source: docs/theory/planar.md P12.2.
)");
  bindFunctionFairing(module);
}

}  // namespace seamwright::python
