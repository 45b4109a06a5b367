// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <seamwright/core/join/curve/nearest_curve.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

/// A curve whose poles can move: a BezierSpline becomes a BSplineCurve.
Curve movableCurve(const char* name, const py::object& value) {
  Curve curve = curveOf(name, value);
  if (const auto* spline = std::get_if<BezierSpline>(&curve))
    curve = bsplineCurve(*spline, continuity(*spline));
  return curve;
}

Eigen::Index countOf(const Curve& curve) {
  if (const auto* bezier = std::get_if<BezierCurve>(&curve)) return bezier->degree() + 1;
  return std::get<BSplineCurve>(curve).count();
}

/// Indices of poles, from a sequence of indices (negative ones count from the end) or from a mask
/// with one boolean per pole.
std::vector<Eigen::Index> fixedPoles(const std::string& name, const py::object& value,
                                     Eigen::Index count) {
  const auto array = py::array::ensure(value);
  const auto refuse = [&](const std::string& found) {
    PyErr_Clear();
    throw py::value_error(name + " is " + shown(value) + ": " + found + "; the curve has " +
                          std::to_string(count) +
                          " poles, and indices of them or one boolean a pole are needed");
  };
  if (!array || array.ndim() != 1) refuse("not a sequence of one dimension");
  std::vector<Eigen::Index> result;
  if (array.dtype().kind() == 'b') {
    if (array.shape(0) != count) refuse(std::to_string(array.shape(0)) + " booleans");
    const auto mask = array.cast<std::vector<bool>>();
    for (Eigen::Index i = 0; i < count; ++i)
      if (mask[static_cast<std::size_t>(i)]) result.push_back(i);
    return result;
  }
  if (array.shape(0) > 0 && array.dtype().kind() != 'i' && array.dtype().kind() != 'u')
    refuse("not whole numbers");
  for (const auto index : array.cast<std::vector<Eigen::Index>>()) {
    if (index < -count || index >= count) refuse("no pole " + std::to_string(index));
    result.push_back(index < 0 ? index + count : index);
  }
  return result;
}

Eigen::VectorXd costsOf(const Curve& curve, const std::string& side, const py::object& costs,
                        const py::object& fixed) {
  Eigen::VectorXd result;
  const Eigen::Index count = countOf(curve);
  if (!costs.is_none()) result = numbersOf("costs_" + side, costs);
  if (!costs.is_none() && result.size() != count)
    throw py::value_error("costs_" + side + " has " + std::to_string(result.size()) +
                          " numbers, the curve " + std::to_string(count) +
                          " poles: one a pole is needed");
  if (fixed.is_none()) return result;
  if (result.size() == 0) result = Eigen::VectorXd::Ones(count);
  for (const Eigen::Index index : fixedPoles("fixed_" + side, fixed, count))
    result(index) = std::numeric_limits<double>::infinity();
  return result;
}

NearestCurveJoinOptions::Moves curveMovesOf(const py::object& value) {
  const auto name = argument<std::string>("moves", value, "'both', 'a' or 'b'");
  if (name == "both") return NearestCurveJoinOptions::Moves::Both;
  if (name == "a") return NearestCurveJoinOptions::Moves::A;
  if (name == "b") return NearestCurveJoinOptions::Moves::B;
  throw py::value_error("moves is " + shown(value) + ": 'both', 'a' or 'b' is needed");
}

const char* statusName(NearestCurveStatus status) {
  switch (status) {
    case NearestCurveStatus::Solved:
      return "solved";
    case NearestCurveStatus::Infeasible:
      return "infeasible";
    case NearestCurveStatus::NotConverged:
      return "not converged";
  }
  return "";
}

template <class Type>
py::object joinOf(const Type& a, const Type& b, const NearestCurveJoinOptions& options) {
  const auto join = [&] {
    const py::gil_scoped_release release;
    return nearestJoin(a, b, options);
  }();
  py::dict result;
  result["a"] = join.a;
  result["b"] = join.b;
  result["beta"] = join.beta;
  result["status"] = statusName(join.status);
  result["cost"] = join.cost;
  result["largest_move_mm"] = join.largest_move_mm;
  result["residual"] = join.residual;
  result["gradient"] = join.gradient;
  result["iterations"] = join.iterations;
  result["reason"] = join.reason;
  return resultOf("NearestCurveJoin", result);
}

BSplineCurve splineOf(const Curve& curve) {
  if (const auto* bezier = std::get_if<BezierCurve>(&curve)) return splineCurve(*bezier);
  return std::get<BSplineCurve>(curve);
}

py::object nearestCurveJoinOf(const py::object& given_a, const py::object& given_b,
                              const py::object& order, const py::object& moves,
                              const py::object& costs_a, const py::object& costs_b,
                              const py::object& fixed_a, const py::object& fixed_b,
                              const py::object& beta, const py::object& max_iterations) {
  const Curve a = movableCurve("a", given_a), b = movableCurve("b", given_b);
  NearestCurveJoinOptions options;
  options.order = wholeNumber("order", order);
  options.moves = curveMovesOf(moves);
  options.costs_a = costsOf(a, "a", costs_a, fixed_a);
  options.costs_b = costsOf(b, "b", costs_b, fixed_b);
  if (!beta.is_none()) options.beta = numbersOf("beta", itemOrSelf(beta, "beta"));
  options.max_iterations = wholeNumber("max_iterations", max_iterations);
  const auto *bezier_a = std::get_if<BezierCurve>(&a), *bezier_b = std::get_if<BezierCurve>(&b);
  if (bezier_a && bezier_b) return joinOf(*bezier_a, *bezier_b, options);
  return joinOf(splineOf(a), splineOf(b), options);
}

}  // namespace

void bindNearestCurve(py::module_& module) {
  module.def(
      "curve_nearest_join", &nearestCurveJoinOf, py::arg("a"), py::arg("b"), py::arg("order") = 1,
      py::kw_only(), py::arg("moves") = "both", py::arg("costs_a") = py::none(),
      py::arg("costs_b") = py::none(), py::arg("fixed_a") = py::none(),
      py::arg("fixed_b") = py::none(), py::arg("beta") = py::none(),
      py::arg("max_iterations") = 100,
      R"(Moves poles of two curves as little as possible so that they join: a NearestCurveJoin.

The last order + 1 poles of a, the first of b, or both (moves: 'a', 'b', 'both') move, so that the
curves join with G^order exactly where a ends and b begins. a, b: curves of any class; a
BezierSpline becomes the BSplineCurve of to_bspline(), and of a BezierCurve and a BSplineCurve
both come back as BSplineCurve.

costs_a, costs_b: the weight of the squared move of each pole, one number a pole. fixed_a,
fixed_b: indices of poles that stay, -1 being the last, or one boolean a pole. beta:
beta_1..beta_n to be used instead of those that are found, or a result that has them. TypeError
for anything but a curve; ValueError for other bad arguments.)");
}

}  // namespace seamwright::python
