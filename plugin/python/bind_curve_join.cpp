// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/join/curve/joint_length.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <vector>

namespace seamwright::python {

namespace {

/// Betas, from a sequence or from a result that has them.
Eigen::VectorXd betasOf(const char* name, const py::object& value) {
  return numbersOf(name, itemOrSelf(value, "beta"));
}

Eigen::MatrixXd matrixOf(const py::object& beta) {
  return betaMatrix(betasOf("beta", beta));
}

Eigen::VectorXd composedOf(const py::object& beta, const py::object& first) {
  return composedBeta(betasOf("beta", beta), betasOf("first", first));
}

Eigen::VectorXd inverseOf(const py::object& beta) {
  return inverseBeta(betasOf("beta", beta));
}

Eigen::VectorXd reversedOf(const py::object& beta) {
  return reversedBeta(betasOf("beta", beta));
}

/// beta_k of a by b from that of their segments: t_a = h_a s_a and t_b = h_b s_b.
Eigen::VectorXd byParameters(Eigen::VectorXd beta, double length_a, double length_b) {
  if (length_a == 1 && length_b == 1) return beta;
  double factor = length_a;
  for (Eigen::Index k = 0; k < beta.size(); ++k) beta(k) *= factor /= length_b;
  return beta;
}

py::object betaFitOf(const py::object& a, const py::object& b, const py::object& order,
                     const py::object& length) {
  const CurveSegments curve_a(curveOf("a", a)), curve_b(curveOf("b", b));
  const CurveSegments::Part &last = curve_a.parts().back(), &first = curve_b.parts().front();
  std::optional<double> length_mm = optionalNumber("length_mm", length);
  const int highest = wholeNumber("order", order);
  // The length of a joint is that of the whole curves, not of the segments that meet.
  if (!length_mm && curve_a.parts().size() + curve_b.parts().size() > 2)
    length_mm = jointLength(extentOf(curve_a.poles()), extentOf(curve_b.poles()));
  const BetaFit fit = fitBeta(last.curve, first.curve, highest, length_mm);
  py::dict dict;
  dict["beta"] = byParameters(fit.beta, last.length, first.length);
  dict["defects"] = fit.defects;
  dict["lower"] = fit.lower;
  dict["upper"] = fit.upper;
  dict["length_mm"] = fit.length_mm;
  return resultOf("BetaFit", dict);
}

/// The end of a curve: its last segment, and the length of that in the curve's parameter.
CurveSegments::Part endOf(const py::object& a) {
  return CurveSegments(curveOf("a", a)).parts().back();
}

/// \param unit  length of the segment in the parameter of the given curve.
CurveJoinRule ruleOf(const py::object& beta, const py::object& length,
                     const py::object& next_length, const py::object& scale, double unit) {
  CurveJoinRule rule;
  rule.beta = betasOf("beta", beta);
  rule.length = unit * numberOf("length", length);
  rule.next_length = numberOf("next_length", next_length);
  if (scale.is_none()) return rule;
  rule.scale = numbersOf("scale", scale);
  if (rule.scale.size() == 0)
    throw py::value_error("scale is " + shown(scale) + ": n + 1 numbers are needed");
  return rule;
}

py::tuple curveJoinPoles(const py::object& a, const py::object& degree, const py::object& beta,
                         const py::object& length, const py::object& next_length,
                         const py::object& scale) {
  const CurveSegments::Part end = endOf(a);
  const HomogeneousPoles poles = nextPoles(end.curve, wholeNumber("degree", degree),
                                           ruleOf(beta, length, next_length, scale, end.length));
  return py::make_tuple(affinePoles(poles), Eigen::VectorXd(poles.col(3)));
}

BezierCurve joinedCurveOf(const py::object& a, const py::object& b, const py::object& beta,
                          const py::object& length, const py::object& next_length,
                          const py::object& scale, const py::object& keep_end) {
  const CurveSegments::Part end = endOf(a);
  return joinedCurve(end.curve, bezierCurveOf("b", b),
                     ruleOf(beta, length, next_length, scale, end.length),
                     flagOf("keep_end", keep_end));
}

/// Betas are by the parameters of the given curves; those of the core by 0..1 of the segments.
BezierCurve bridgeOf(const py::object& a, const py::object& b, const py::object& beta,
                     const py::object& beta_end) {
  const CurveSegments::Part end = endOf(a);
  const CurveSegments::Part begin = CurveSegments(curveOf("b", b)).parts().front();
  return bridgeCurve(end.curve, begin.curve, byParameters(betasOf("beta", beta), 1 / end.length, 1),
                     byParameters(betasOf("beta_end", beta_end), 1, 1 / begin.length));
}

void bindBetas(py::module_& module) {
  module.def("beta_matrix", &matrixOf, py::arg("beta"),
             R"(The matrix B (n+1, n+1) of partial Bell polynomials of beta_1 .. beta_n.

Two curves join G^n iff the derivatives of the one that leaves are B times those of the one that
arrives. beta here and below: a sequence, or a result that has one. ValueError, with index and
value, for betas that are not finite and beta_1 <= 0.)");
  module.def("composed_beta", &composedOf, py::arg("beta"), py::arg("first"),
             "The betas whose matrix is beta_matrix(beta) @ beta_matrix(first).");
  module.def("inverse_beta", &inverseOf, py::arg("beta"),
             "The betas of the inverse matrix: the sides' roles exchanged.");
  module.def("reversed_beta", &reversedOf, py::arg("beta"),
             "The betas of the same joint passed backwards: both curves reversed and exchanged.");
  module.def("fit_beta", &betaFitOf, py::arg("a"), py::arg("b"), py::arg("order") = 2,
             py::kw_only(), py::arg("length_mm") = py::none(),
             R"(How the end of a and the beginning of b, curves of any class, join: a BetaFit.

beta, by the parameters of the curves, is empty for a cusp or where a tangent is lost. defects[k] is
|c_k of b - c_k of a| L^(k-1), with c_k the derivatives by arc length; it lies for certain within
lower[k] and upper[k], so lower[k] > 0 proves that the joint is not G^k. L is length_mm, None: the
shorter chord. TypeError for anything but a curve; ValueError for an order outside 0..30.)");
}

void bindConstruction(py::module_& module) {
  const char* poles_doc =
      R"(The first n+1 poles (n+1, 3) and weights (n+1,) of a curve of that degree that goes on
where a ends.

a: a curve of any class. beta: beta_1 .. beta_n; the other poles are free. length and next_length
are those of the curves in their common parameter, of a spline a factor of its parameter; scale
are value and derivatives e_0 .. e_n of the factor between the homogeneous curves, None: 1, 0, ..,
0. ValueError for what makes no join, or a weight that comes out not positive.)";
  const char* joined_doc =
      R"(The BezierCurve b with its first n+1 poles replaced by those of curve_join_poles().

It is first elevated to degree 2n+1, so that its own end stays as it is to order n; with
keep_end=False only to n. a: a curve of any class; b: one of a single segment.)";
  const char* bridge_doc =
      R"(The BezierCurve of lowest degree from the end of a to the beginning of b, both polynomial.

It joins a with beta_1 .. beta_n and b with beta_end_1 .. beta_end_m: degree n+m+1. a, b: curves of
any class.)";
  module.def("curve_join_poles", &curveJoinPoles, py::arg("a"), py::arg("degree"), py::arg("beta"),
             py::kw_only(), py::arg("length") = 1.0, py::arg("next_length") = 1.0,
             py::arg("scale") = py::none(), poles_doc);
  module.def("curve_joined", &joinedCurveOf, py::arg("a"), py::arg("b"), py::arg("beta"),
             py::kw_only(), py::arg("length") = 1.0, py::arg("next_length") = 1.0,
             py::arg("scale") = py::none(), py::arg("keep_end") = true, joined_doc);
  module.def("curve_blend", &bridgeOf, py::arg("a"), py::arg("b"), py::arg("beta"),
             py::arg("beta_end"), bridge_doc);
}

}  // namespace

void bindCurveJoin(py::module_& module) {
  bindBetas(module);
  bindConstruction(module);
}

}  // namespace seamwright::python
