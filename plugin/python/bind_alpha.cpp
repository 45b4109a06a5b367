// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <seamwright/core/spline/alpha_join_condition.hpp>
#include <seamwright/core/spline/alpha_spline.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/parameters.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

double numberOr(const char* name, const py::object& value, double otherwise) {
  return optionalNumber(name, value).value_or(otherwise);
}

/// A shape, from a number or from a result that has it.
double shapeOf(const char* name, const py::object& value) {
  return numberOf(name, itemOrSelf(value, "a"));
}

std::vector<double> listOrNone(const char* name, const py::object& value) {
  if (value.is_none()) return {};
  return listOf(name, value);
}

AlphaCurve::Polygon polygonOf(const py::object& poles) {
  const Poles rows = rowsOf("poles", poles, "(4, 3)");
  if (rows.rows() != 4)
    throw py::value_error("poles have shape (" + std::to_string(rows.rows()) +
                          ", 3): (4, 3) is needed");
  return rows;
}

AlphaSurface alphaSurfaceOf(const py::object& given, const py::object& a_u, const py::object& a_v,
                            const std::string& prefix = "") {
  const std::string name = prefix + "net";
  const Array net = arrayOf(name, given);
  AlphaSurface surface;
  const Poles rows = polesOf(name, net, 3, "(4, 4, 3)");
  if (net.shape(0) != 4 || net.shape(1) != 4)
    throw py::value_error(name + " has shape " + shapeText(net) + ": (4, 4, 3) is needed");
  surface.poles = rows;
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

Array basisOf(const py::object& a, const py::object& t) {
  const double shape = shapeOf("a", a);
  const Parameters at("t", t);
  return valuesOf(at.shape(), {4}, [&](py::ssize_t i) { return alphaBasis(shape, at[i]); });
}

BezierCurve alphaCurveOf(const py::object& poles, const py::object& a) {
  return alphaCurveBezier({polygonOf(poles), shapeOf("a", a)});
}

Poles joinPolesOf(const py::object& poles, const py::object& a, const py::object& next_a,
                  const py::object& order, const py::object& beta1, const py::object& beta2,
                  const py::object& length, const py::object& next_length) {
  const AlphaCurve given{polygonOf(poles), shapeOf("a", a)};
  return alphaJoinPoles(
      given, {wholeNumber("order", order), numberOf("beta1", beta1), numberOf("beta2", beta2),
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

py::object optimumOf(const py::object& poles, const py::object& energy, const py::object& a_min,
                     const py::object& a_max) {
  const AlphaOptimum optimum = energyOptimalAlpha(
      polygonOf(poles), energyOf(energy), numberOf("a_min", a_min), numberOf("a_max", a_max));
  py::dict dict;
  dict["a"] = optimum.a;
  dict["free_a"] = optimum.free_a;
  dict["energy"] = optimum.energy;
  dict["any"] = optimum.any;
  return resultOf("AlphaOptimum", dict);
}

BezierSpline alphaSplineOf(const py::object& polygon, const py::object& a, const py::object& order,
                           const py::object& lengths, const py::object& beta1,
                           const py::object& beta2, const py::object& closed) {
  AlphaSplineShape shape;
  shape.order = wholeNumber("order", order);
  shape.a = listOrNone("a", a);
  shape.lengths = listOrNone("lengths", lengths);
  shape.beta1 = listOrNone("beta1", beta1);
  shape.beta2 = listOrNone("beta2", beta2);
  shape.closed = flagOf("closed", closed);
  return bezierSpline(alphaSpline(rowsOf("polygon", polygon), shape));
}

BezierPatch patchOf(const py::object& net, const py::object& a_u, const py::object& a_v) {
  return alphaSurfacePatch(alphaSurfaceOf(net, a_u, a_v));
}

Array alphaRowsOf(const py::object& net, const py::object& a_u, const py::object& a_v,
                  const py::object& next_a_u, const py::object& next_a_v, const py::object& order,
                  const py::object& beta1, const py::object& beta2, const py::object& length,
                  const py::object& next_length) {
  const AlphaSurface surface = alphaSurfaceOf(net, a_u, a_v);
  return netOf(alphaJoinRows(
      surface,
      {wholeNumber("order", order), numberOf("beta1", beta1), numberOf("beta2", beta2),
       numberOf("length", length), numberOf("next_length", next_length),
       numberOr("next_a_u", next_a_u, surface.a_u), numberOr("next_a_v", next_a_v, surface.a_v)}));
}

py::object alphaConditionOf(const py::object& net, const py::object& a_u, const py::object& a_v,
                            const py::object& next_a_v) {
  const AlphaSurface surface = alphaSurfaceOf(net, a_u, a_v);
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
  return resultOf("AlphaSeamCondition", dict);
}

Array slidingRowsOf(const py::object& net, const py::object& a_u, const py::object& a_v,
                    const py::object& alpha, const py::object& beta0, const py::object& beta1,
                    const py::object& next_a_u, const py::object& next_a_v) {
  const AlphaSurface surface = alphaSurfaceOf(net, a_u, a_v);
  return netOf(alphaSlidingRows(surface, numberOr("next_a_u", next_a_u, surface.a_u),
                                numberOr("next_a_v", next_a_v, surface.a_v),
                                numberOf("alpha", alpha), numberOf("beta0", beta0),
                                numberOf("beta1", beta1)));
}

py::object fitOf(const py::object& net, const py::object& a_u, const py::object& a_v,
                 const py::object& next_net, const py::object& next_a_u, const py::object& next_a_v,
                 const py::object& length, const py::object& next_length) {
  const AlphaSeamFit fit = alphaSeamFit(
      alphaSurfaceOf(net, a_u, a_v), alphaSurfaceOf(next_net, next_a_u, next_a_v, "next_"),
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
  return resultOf("AlphaSeamFit", dict);
}

py::object nearestOf(const py::object& net, const py::object& a_u, const py::object& a_v,
                     const py::object& next_net, const py::object& next_a_u,
                     const py::object& next_a_v, const py::object& order,
                     const py::object& parametric, const py::object& length,
                     const py::object& next_length) {
  const auto near = alphaNearestJoin(
      alphaSurfaceOf(net, a_u, a_v), alphaSurfaceOf(next_net, next_a_u, next_a_v, "next_"),
      {wholeNumber("order", order), flagOf("parametric", parametric), numberOf("length", length),
       numberOf("next_length", next_length)});
  if (!near) return py::none();
  py::dict dict;
  dict["net"] = netOf(near->given.poles);
  dict["next_net"] = netOf(near->next.poles);
  dict["beta1"] = near->beta1;
  dict["beta2"] = near->beta2;
  dict["cost"] = near->cost_given;
  dict["next_cost"] = near->cost_next;
  return resultOf("AlphaNearestJoin", dict);
}

void bindCurves(py::module_& module) {
  module.def("alpha_basis", &basisOf, py::arg("a"), py::arg("t"),
             "The four functions (4,) of an alpha-curve of shape a at t, both in [0, 1]; for an "
             "array t of shape s, s + (4,).");
  module.def("alpha_curve", &alphaCurveOf, py::arg("poles"), py::arg("a") = 1.0,
             "The alpha-curve of four poles (4, 3) with a shape in [0, 1] or an AlphaOptimum, "
             "exactly, as a BezierCurve of degree 5. With a = 1 it is closest to its polygon.");
  module.def("alpha_join_poles", &joinPolesOf, py::arg("poles"), py::arg("a"), py::kw_only(),
             py::arg("next_a") = py::none(), py::arg("order") = 1, py::arg("beta1") = 1.0,
             py::arg("beta2") = 0.0, py::arg("length") = 1.0, py::arg("next_length") = 1.0,
             R"(The first poles of the alpha-curve that goes on, (2, 3) or with order 2 or 3 (3, 3).

C^order with beta1 = 1 and beta2 = 0, else G^order. With order 3 beta2 is not read. next_a of None
is a.)");
  module.def("energy_optimal_alpha", &optimumOf, py::arg("poles"), py::arg("energy") = "curvature",
             py::kw_only(), py::arg("a_min") = 0.05, py::arg("a_max") = 1.0,
             R"(The shape of least energy of four poles (4, 3): an AlphaOptimum.

energy: the integral of the square of the first ('length'), second ('curvature') or third derivative
('curvature variation'). a_min, a_max: bounds of the shape.)");
  module.def("alpha_spline", &alphaSplineOf, py::arg("polygon"), py::arg("a"), py::kw_only(),
             py::arg("order") = 2, py::arg("lengths") = py::none(), py::arg("beta1") = py::none(),
             py::arg("beta2") = py::none(), py::arg("closed") = false,
             R"(The BezierSpline of alpha-curves of a control polygon (n, 3), joined to that order.

a has a shape for each of n segments; the polygon has n + 3 poles, with order 1 2 n + 2, closed n or
2 n. lengths are those of the segments, None: 1; beta1 and beta2 those of the joints, None: 1 and 0,
which is C^order. ValueError where shapes are too small for a joint: with order 2 and beta2 = 0 they
are to be above 1/2, with order 3 above 2/3.)");
}

void bindSurfaces(py::module_& module) {
  module.def("alpha_surface", &patchOf, py::arg("net"), py::arg("a_u") = 1.0, py::arg("a_v") = 1.0,
             "The alpha-surface of a net (4, 4, 3) with shapes in [0, 1], exactly, as a "
             "BezierPatch of degrees 5, 5.");
  module.def("alpha_join_rows", &alphaRowsOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
             py::kw_only(), py::arg("next_a_u") = py::none(), py::arg("next_a_v") = py::none(),
             py::arg("order") = 1, py::arg("beta1") = 1.0, py::arg("beta2") = 0.0,
             py::arg("length") = 1.0, py::arg("next_length") = 1.0,
             R"(The first rows of the net of the alpha-surface that goes on at u = 1.

(2, 4, 3) or with order 2 or 3 (3, 4, 3); C^order with beta1 = 1 and beta2 = 0, else G^order.)");
  module.def("alpha_seam_condition", &alphaConditionOf, py::arg("net"), py::arg("a_u"),
             py::arg("a_v"), py::arg("next_a_v") = py::none(),
             "Which alpha-surfaces of shape next_a_v along the seam can go on at u = 1: an "
             "AlphaSeamCondition.");
  module.def("alpha_sliding_rows", &slidingRowsOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
             py::arg("alpha"), py::arg("beta0"), py::arg("beta1"), py::kw_only(),
             py::arg("next_a_u") = py::none(), py::arg("next_a_v") = py::none(),
             R"(The first two rows, (2, 4, 3), of the net with Y_u = alpha X_u + beta X_v at u = 1.

beta is linear from beta0 to beta1. ValueError for what is not in first_rows of
alpha_seam_condition.)");
}

void bindSeams(py::module_& module) {
  module.def("fit_alpha_seam", &fitOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
             py::arg("next_net"), py::arg("next_a_u"), py::arg("next_a_v"), py::kw_only(),
             py::arg("length") = 1.0, py::arg("next_length") = 1.0,
             "How two alpha-surfaces meet at u = 1 and u = 0 with constant betas: an "
             "AlphaSeamFit.");
  module.def("alpha_nearest_join", &nearestOf, py::arg("net"), py::arg("a_u"), py::arg("a_v"),
             py::arg("next_net"), py::arg("next_a_u"), py::arg("next_a_v"), py::kw_only(),
             py::arg("order") = 1, py::arg("parametric") = false, py::arg("length") = 1.0,
             py::arg("next_length") = 1.0,
             R"(The nearest nets of two alpha-surfaces that join: an AlphaNearestJoin.

They join with G^order, or C^order if parametric. The first net moves only where it allows no join.
None where the next surface runs backwards.)");
}

}  // namespace

void bindAlpha(py::module_& module) {
  bindCurves(module);
  bindSurfaces(module);
  bindSeams(module);
}

}  // namespace seamwright::python
