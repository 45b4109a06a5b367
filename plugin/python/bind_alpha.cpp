// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <seamwright/core/spline/alpha_join_condition.hpp>
#include <seamwright/core/spline/alpha_spline.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

double numberOf(const char* name, const py::object& value) {
  return argument<double>(name, value, "a number");
}

double numberOr(const char* name, const py::object& value, double otherwise) {
  return value.is_none() ? otherwise : numberOf(name, value);
}

int requiredWhole(const char* name, const py::object& value) {
  return argument<int>(name, value, "a whole number");
}

std::vector<double> listOf(const char* name, const py::object& value) {
  if (value.is_none()) return {};
  return argument<std::vector<double>>(name, value, "a sequence of numbers");
}

AlphaCurve::Polygon polygonOf(const Array& poles) {
  const Poles rows = polesOf(poles, 2, "(4, 3)");
  if (rows.rows() != 4)
    throw py::value_error("poles have shape (" + std::to_string(rows.rows()) +
                          ", 3): (4, 3) is needed");
  return rows;
}

AlphaSurface surfaceOf(const Array& net, const py::object& a_u, const py::object& a_v,
                       const std::string& prefix = "") {
  const Poles poles = polesOf(net, 3, "(4, 4, 3)");
  if (net.shape(0) != 4 || net.shape(1) != 4)
    throw py::value_error("poles have shape (" + std::to_string(net.shape(0)) + ", " +
                          std::to_string(net.shape(1)) + ", 3): (4, 4, 3) is needed");
  AlphaSurface surface;
  surface.poles = poles;
  surface.a_u = numberOf((prefix + "a_u").c_str(), a_u);
  surface.a_v = numberOf((prefix + "a_v").c_str(), a_v);
  return surface;
}

/// Rows of four poles as an array (rows, 4, 3).
Array netOf(const Poles& rows) {
  Array result({rows.rows() / 4, Eigen::Index{4}, Eigen::Index{3}});
  Eigen::Map<Poles>(result.mutable_data(), rows.rows(), 3) = rows;
  return result;
}

Eigen::Vector4d basisOf(const py::object& a, const py::object& t) {
  return alphaBasis(numberOf("a", a), numberOf("t", t));
}

BezierCurve curveOf(const Array& poles, const py::object& a) {
  return alphaCurveBezier({polygonOf(poles), numberOf("a", a)});
}

Poles joinPolesOf(const Array& poles, const py::object& a, const py::object& next_a,
                  const py::object& order, const py::object& beta1, const py::object& beta2,
                  const py::object& length, const py::object& next_length) {
  const AlphaCurve given{polygonOf(poles), numberOf("a", a)};
  return alphaJoinPoles(
      given, {requiredWhole("order", order), numberOf("beta1", beta1), numberOf("beta2", beta2),
              numberOf("length", length), numberOf("next_length", next_length),
              numberOr("next_a", next_a, given.a)});
}

AlphaEnergy energyOf(const py::object& value) {
  const std::pair<const char*, AlphaEnergy> known[] = {
      {"length", AlphaEnergy::Length},
      {"curvature", AlphaEnergy::Curvature},
      {"curvature variation", AlphaEnergy::CurvatureVariation}};
  for (const auto& [name, energy] : known)
    if (value.equal(py::str(name))) return energy;
  throw py::value_error("energy is " + shown(value) +
                        ": known are 'length', 'curvature' and 'curvature variation'");
}

py::dict optimumOf(const Array& poles, const py::object& energy, const py::object& a_min,
                   const py::object& a_max) {
  const AlphaOptimum optimum = energyOptimalAlpha(
      polygonOf(poles), energyOf(energy), numberOf("a_min", a_min), numberOf("a_max", a_max));
  py::dict dict;
  dict["a"] = optimum.a;
  dict["free_a"] = optimum.free_a;
  dict["energy"] = optimum.energy;
  dict["any"] = optimum.any;
  return dict;
}

BezierSpline splineOf(const Array& polygon, const py::object& a, const py::object& order,
                      const py::object& lengths, const py::object& beta1, const py::object& beta2,
                      const py::object& closed) {
  AlphaSplineShape shape;
  shape.order = requiredWhole("order", order);
  shape.a = listOf("a", a);
  shape.lengths = listOf("lengths", lengths);
  shape.beta1 = listOf("beta1", beta1);
  shape.beta2 = listOf("beta2", beta2);
  shape.closed = flagOf("closed", closed);
  return bezierSpline(alphaSpline(polesOf(polygon, 2, "(n, 3)"), shape));
}

BezierPatch patchOf(const Array& net, const py::object& a_u, const py::object& a_v) {
  return alphaSurfacePatch(surfaceOf(net, a_u, a_v));
}

Array joinRowsOf(const Array& net, const py::object& a_u, const py::object& a_v,
                 const py::object& next_a_u, const py::object& next_a_v, const py::object& order,
                 const py::object& beta1, const py::object& beta2, const py::object& length,
                 const py::object& next_length) {
  const AlphaSurface surface = surfaceOf(net, a_u, a_v);
  return netOf(alphaJoinRows(
      surface,
      {requiredWhole("order", order), numberOf("beta1", beta1), numberOf("beta2", beta2),
       numberOf("length", length), numberOf("next_length", next_length),
       numberOr("next_a_u", next_a_u, surface.a_u), numberOr("next_a_v", next_a_v, surface.a_v)}));
}

py::dict conditionOf(const Array& net, const py::object& a_u, const py::object& a_v,
                     const py::object& next_a_v) {
  const AlphaSurface surface = surfaceOf(net, a_u, a_v);
  const AlphaSeamCondition condition =
      alphaSeamCondition(surface, numberOr("next_a_v", next_a_v, surface.a_v));
  py::dict dict;
  dict["any_net"] = condition.any_net;
  dict["order"] = condition.order;
  dict["g1"] = condition.g1;
  dict["defects_mm"] = condition.defects_mm;
  dict["noise_mm"] = condition.noise_mm;
  dict["first_rows"] = Eigen::MatrixXd(condition.first_rows.transpose());
  dict["singular"] = condition.singular;
  dict["rank_noise"] = condition.rank_noise;
  return dict;
}

Array slidingRowsOf(const Array& net, const py::object& a_u, const py::object& a_v,
                    const py::object& alpha, const py::object& beta0, const py::object& beta1,
                    const py::object& next_a_u, const py::object& next_a_v) {
  const AlphaSurface surface = surfaceOf(net, a_u, a_v);
  return netOf(alphaSlidingRows(surface, numberOr("next_a_u", next_a_u, surface.a_u),
                                numberOr("next_a_v", next_a_v, surface.a_v),
                                numberOf("alpha", alpha), numberOf("beta0", beta0),
                                numberOf("beta1", beta1)));
}

py::dict fitOf(const Array& net, const py::object& a_u, const py::object& a_v,
               const Array& next_net, const py::object& next_a_u, const py::object& next_a_v,
               const py::object& length, const py::object& next_length) {
  const AlphaSeamFit fit =
      alphaSeamFit(surfaceOf(net, a_u, a_v), surfaceOf(next_net, next_a_u, next_a_v, "next_"),
                   numberOf("length", length), numberOf("next_length", next_length));
  py::dict dict;
  dict["parametric_order"] = fit.parametric_order;
  dict["geometric_order"] = fit.geometric_order;
  dict["beta1"] = fit.beta1;
  dict["beta2"] = fit.beta2;
  dict["gap_mm"] = fit.gap_mm;
  dict["first"] = fit.first;
  dict["second"] = fit.second;
  dict["c_first"] = fit.c_first;
  dict["c_second"] = fit.c_second;
  dict["noise"] = fit.noise;
  return dict;
}

py::object nearestOf(const Array& net, const py::object& a_u, const py::object& a_v,
                     const Array& next_net, const py::object& next_a_u, const py::object& next_a_v,
                     const py::object& order, const py::object& parametric,
                     const py::object& length, const py::object& next_length) {
  const auto near =
      alphaNearestJoin(surfaceOf(net, a_u, a_v), surfaceOf(next_net, next_a_u, next_a_v, "next_"),
                       {requiredWhole("order", order), flagOf("parametric", parametric),
                        numberOf("length", length), numberOf("next_length", next_length)});
  if (!near) return py::none();
  py::dict dict;
  dict["net"] = netOf(near->given.poles);
  dict["next_net"] = netOf(near->next.poles);
  dict["beta1"] = near->beta1;
  dict["beta2"] = near->beta2;
  dict["cost"] = near->cost_given;
  dict["next_cost"] = near->cost_next;
  return dict;
}

void bindCurves(py::module_& module) {
  module.def("alpha_basis", &basisOf, py::arg("a"), py::arg("t"),
             "The four functions of an alpha-curve of shape a at t, both in [0, 1].");
  module.def(
      "alpha_curve", &curveOf, py::arg("poles"), py::arg("a") = 1.0,
      "The alpha-curve of four poles (4, 3) with a shape in [0, 1], exactly, as a BezierCurve of "
      "degree 5. With a = 1 it is closest to its polygon.");
  module.def(
      "alpha_join_poles", &joinPolesOf, py::arg("poles"), py::arg("a"), py::kw_only(),
      py::arg("next_a") = py::none(), py::arg("order") = 1, py::arg("beta1") = 1.0,
      py::arg("beta2") = 0.0, py::arg("length") = 1.0, py::arg("next_length") = 1.0,
      "The first poles, (2, 3) or with order 2 or 3 (3, 3), of the alpha-curve that goes on; "
      "C^order with beta1 = 1 and beta2 = 0, else G^order. With order 3 beta2 is not read. next_a "
      "of None is a.");
  module.def(
      "energy_optimal_alpha", &optimumOf, py::arg("poles"), py::arg("energy") = "curvature",
      py::kw_only(), py::arg("a_min") = 0.05, py::arg("a_max") = 1.0,
      "The shape of least energy, the integral of the square of the first ('length'), second "
      "('curvature') or third derivative ('curvature variation'), as a dict of a, within the "
      "bounds, free_a, without them, energy, and any: the shape makes no difference.");
  module.def(
      "alpha_spline", &splineOf, py::arg("polygon"), py::arg("a"), py::kw_only(),
      py::arg("order") = 2, py::arg("lengths") = py::none(), py::arg("beta1") = py::none(),
      py::arg("beta2") = py::none(), py::arg("closed") = false,
      "The BezierSpline of alpha-curves of a control polygon, joined to that order. a has a shape "
      "for "
      "each of n segments; the polygon has n + 3 poles, with order 1 2 n + 2, closed n or 2 n. "
      "lengths are those of the segments, None: 1; beta1 and beta2 those of the joints, None: 1 "
      "and "
      "0, which is C^order. ValueError where shapes are too small for a joint: with order 2 and "
      "beta2 = 0 they are to be above 1/2, with order 3 above 2/3.");
}

void bindSurfaces(py::module_& module) {
  module.def(
      "alpha_surface", &patchOf, py::arg("net"), py::arg("a_u") = 1.0, py::arg("a_v") = 1.0,
      "The alpha-surface of a net (4, 4, 3) with shapes in [0, 1], exactly, as a BezierPatch of "
      "degrees 5, 5.");
  module.def(
      "alpha_join_rows", &joinRowsOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"), py::kw_only(),
      py::arg("next_a_u") = py::none(), py::arg("next_a_v") = py::none(), py::arg("order") = 1,
      py::arg("beta1") = 1.0, py::arg("beta2") = 0.0, py::arg("length") = 1.0,
      py::arg("next_length") = 1.0,
      "The first rows, (2, 4, 3) or with order 2 or 3 (3, 4, 3), of the net of the alpha-surface "
      "that goes on at u = 1; C^order with beta1 = 1 and beta2 = 0, else G^order.");
  module.def(
      "alpha_seam_condition", &conditionOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
      py::arg("next_a_v") = py::none(),
      "Which alpha-surfaces of shape next_a_v along the seam can go on at u = 1: a dict of "
      "any_net, "
      "order (the largest n <= 2 of C^n, and of G^n with constant betas; -1: none), g1, defects_mm "
      "of the rows 3, 2, 1 with noise_mm, and first_rows, all (alpha, beta(0), beta(1)) of "
      "G1 joins with linear beta as rows of a basis, from the singular values and rank_noise.");
  module.def(
      "alpha_sliding_rows", &slidingRowsOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
      py::arg("alpha"), py::arg("beta0"), py::arg("beta1"), py::kw_only(),
      py::arg("next_a_u") = py::none(), py::arg("next_a_v") = py::none(),
      "The first two rows, (2, 4, 3), of the net with Y_u = alpha X_u + beta X_v at u = 1, beta "
      "linear from beta0 to beta1. ValueError for what is not in first_rows of "
      "alpha_seam_condition.");
  module.def("alpha_seam_fit", &fitOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
             py::arg("next_net"), py::arg("next_a_u"), py::arg("next_a_v"), py::kw_only(),
             py::arg("length") = 1.0, py::arg("next_length") = 1.0,
             "How two alpha-surfaces meet at u = 1 and u = 0 with constant betas: a dict of "
             "parametric_order, geometric_order, beta1, beta2, gap_mm and the relative residuals.");
  module.def(
      "alpha_nearest_join", &nearestOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
      py::arg("next_net"), py::arg("next_a_u"), py::arg("next_a_v"), py::kw_only(),
      py::arg("order") = 1, py::arg("parametric") = false, py::arg("length") = 1.0,
      py::arg("next_length") = 1.0,
      "The nearest nets of two alpha-surfaces that join with G^order, or C^order if parametric: a "
      "dict of net, which moves only where it allows no join, next_net, beta1, beta2, cost and "
      "next_cost (sums of squared moves). None where the next surface runs backwards.");
}

}  // namespace

void bindAlpha(py::module_& module) {
  bindCurves(module);
  bindSurfaces(module);
}

}  // namespace seamwright::python
