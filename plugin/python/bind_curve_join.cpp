// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <vector>

namespace seamwright::python {

namespace {

Eigen::MatrixXd matrixOf(const py::object& beta) {
  return betaMatrix(numbersOf("beta", beta));
}

Eigen::VectorXd composedOf(const py::object& beta, const py::object& first) {
  return composedBeta(numbersOf("beta", beta), numbersOf("first", first));
}

Eigen::VectorXd inverseOf(const py::object& beta) {
  return inverseBeta(numbersOf("beta", beta));
}

Eigen::VectorXd reversedOf(const py::object& beta) {
  return reversedBeta(numbersOf("beta", beta));
}

py::dict betaFitOf(const BezierCurve& a, const BezierCurve& b, const py::object& order,
                   const py::object& length) {
  std::optional<double> length_mm;
  if (!length.is_none()) length_mm = argument<double>("length_mm", length, "a number");
  const BetaFit fit = fitBeta(a, b, argument<int>("order", order, "a whole number"), length_mm);
  py::dict dict;
  dict["beta"] = fit.beta;
  dict["defects"] = fit.defects;
  dict["lower"] = fit.lower;
  dict["upper"] = fit.upper;
  dict["length_mm"] = fit.length_mm;
  return dict;
}

CurveJoinRule ruleOf(const py::object& beta, const py::object& length,
                     const py::object& next_length, const py::object& scale) {
  CurveJoinRule rule;
  rule.beta = numbersOf("beta", beta);
  rule.length = argument<double>("length", length, "a number");
  rule.next_length = argument<double>("next_length", next_length, "a number");
  if (scale.is_none()) return rule;
  rule.scale = numbersOf("scale", scale);
  if (rule.scale.size() == 0)
    throw py::value_error("scale is " + shown(scale) + ": n + 1 numbers are needed");
  return rule;
}

py::tuple nextPolesOf(const BezierCurve& a, const py::object& degree, const py::object& beta,
                      const py::object& length, const py::object& next_length,
                      const py::object& scale) {
  const HomogeneousPoles poles = nextPoles(a, argument<int>("degree", degree, "a whole number"),
                                           ruleOf(beta, length, next_length, scale));
  return py::make_tuple(affinePoles(poles), Eigen::VectorXd(poles.col(3)));
}

BezierCurve joinedCurveOf(const BezierCurve& a, const BezierCurve& b, const py::object& beta,
                          const py::object& length, const py::object& next_length,
                          const py::object& scale, const py::object& keep_end) {
  if (!PyBool_Check(keep_end.ptr()))
    throw py::value_error("keep_end is " + shown(keep_end) + ": True or False is needed");
  return joinedCurve(a, b, ruleOf(beta, length, next_length, scale), keep_end.cast<bool>());
}

BezierCurve bridgeOf(const BezierCurve& a, const BezierCurve& b, const py::object& beta,
                     const py::object& beta_end) {
  return bridgeCurve(a, b, numbersOf("beta", beta), numbersOf("beta_end", beta_end));
}

void bindBetas(py::module_& module) {
  module.def("beta_matrix", &matrixOf, py::arg("beta"),
             "The matrix B (n+1, n+1) of partial Bell polynomials of beta_1 .. beta_n: two curves "
             "join G^n iff "
             "the derivatives of the one that leaves are B times those of the one that arrives.");
  module.def("composed_beta", &composedOf, py::arg("beta"), py::arg("first"),
             "The betas whose matrix is beta_matrix(beta) @ beta_matrix(first).");
  module.def("inverse_beta", &inverseOf, py::arg("beta"),
             "The betas of the inverse matrix: the sides' roles exchanged.");
  module.def("reversed_beta", &reversedOf, py::arg("beta"),
             "The betas of the same joint passed backwards: both curves reversed and exchanged.");
  module.def("fit_beta", &betaFitOf, py::arg("a"), py::arg("b"), py::arg("order") = 2,
             py::kw_only(), py::arg("length_mm") = py::none(),
             "How the end of a BezierCurve and the beginning of another join: a dict of beta (none "
             "for a cusp "
             "or where a tangent is lost), defects, lower, upper and length_mm.\n\n"
             "defects[k] is |c_k of b - c_k of a| L^(k-1), with c_k the derivatives by arc length; "
             "it lies for "
             "certain within lower[k] and upper[k], so lower[k] > 0 proves that the joint is not "
             "G^k. L is "
             "length_mm, None: the shorter chord.");
}

}  // namespace

void bindCurveJoin(py::module_& module) {
  bindBetas(module);
  module.def(
      "next_poles", &nextPolesOf, py::arg("a"), py::arg("degree"), py::arg("beta"), py::kw_only(),
      py::arg("length") = 1.0, py::arg("next_length") = 1.0, py::arg("scale") = py::none(),
      "The first n+1 poles (n+1, 3) and weights (n+1,) of a curve of that degree that goes on "
      "where a "
      "BezierCurve ends, with beta_1 .. beta_n; its other poles are free.\n\n"
      "length and next_length are those of the curves in their common parameter; scale are value "
      "and "
      "derivatives e_0 .. e_n of the factor between the homogeneous curves, None: 1, 0, .., 0. "
      "ValueError for what makes no join, or a weight that comes out not positive.");
  module.def(
      "joined_curve", &joinedCurveOf, py::arg("a"), py::arg("b"), py::arg("beta"), py::kw_only(),
      py::arg("length") = 1.0, py::arg("next_length") = 1.0, py::arg("scale") = py::none(),
      py::arg("keep_end") = true,
      "The BezierCurve b with its first n+1 poles replaced by next_poles(). It is first elevated "
      "to "
      "degree 2n+1, so that its own end stays as it is to order n; with keep_end=False only to n.");
  module.def("bridge_curve", &bridgeOf, py::arg("a"), py::arg("b"), py::arg("beta"),
             py::arg("beta_end"),
             "The BezierCurve of lowest degree from the end of a to the beginning of b, both "
             "polynomial, that "
             "joins a with beta_1 .. beta_n and b with beta_end_1 .. beta_end_m: degree n+m+1.");
}

}  // namespace seamwright::python
