// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <string>
#include <utility>

namespace py = pybind11;

namespace seamwright::python {

namespace {

BezierCurve makeCurve(const Array& poles, const std::optional<Array>& weights) {
  const Poles rows = polesOf(poles, 2, "(n+1, 3)");
  return weights ? BezierCurve(rows, weightsOf(*weights, poles)) : BezierCurve(rows);
}

BezierPatch makePatch(const Array& poles, const std::optional<Array>& weights) {
  const Poles rows = polesOf(poles, 3, "(m+1, n+1, 3)");
  const int m = static_cast<int>(poles.shape(0)) - 1;
  const int n = static_cast<int>(poles.shape(1)) - 1;
  return weights ? BezierPatch(m, n, rows, weightsOf(*weights, poles)) : BezierPatch(m, n, rows);
}

Array netPoles(const BezierPatch& patch) {
  const Poles poles = patch.poles();
  Array result({patch.degreeU() + 1, patch.degreeV() + 1, 3});
  Eigen::Map<Poles>(result.mutable_data(), poles.rows(), 3) = poles;
  return result;
}

Array netWeights(const BezierPatch& patch) {
  Array result({patch.degreeU() + 1, patch.degreeV() + 1});
  Eigen::Map<Eigen::VectorXd>(result.mutable_data(), result.size()) = patch.weights();
  return result;
}

Poles curveJet(const BezierCurve& curve, double t) {
  const CurveJet jet = curve.jet(parameter("t", t));
  Poles rows(4, 3);
  rows << jet.p.transpose(), jet.d1.transpose(), jet.d2.transpose(), jet.d3.transpose();
  return rows;
}

Eigen::Vector3d curvePoint(const BezierCurve& curve, double t) {
  return curve.point(parameter("t", t));
}

Poles curveDerivatives(const BezierCurve& curve, double t, int order) {
  constexpr int most = 1000;  // bounds the time: the quotient rule takes order^2 steps
  if (order > most)
    throw py::value_error("order " + std::to_string(order) + ": it must be within " +
                          std::to_string(most));
  return curve.derivatives(parameter("t", t), order);
}

std::pair<BezierCurve, BezierCurve> curveParts(const BezierCurve& curve, double t) {
  return curve.split(parameter("t", t));
}

std::pair<BezierPatch, BezierPatch> patchParts(const BezierPatch& patch, double t) {
  return patch.splitU(parameter("t", t));
}

Eigen::Vector3d patchPoint(const BezierPatch& patch, double u, double v) {
  return patch.point(parameter("u", u), parameter("v", v));
}

SurfaceJet patchJet(const BezierPatch& patch, double u, double v) {
  return patch.jet(parameter("u", u), parameter("v", v));
}

void bindJet(py::module_& module) {
  py::class_<SurfaceJet>(
      module, "SurfaceJet", py::module_local(),
      "Point and partial derivatives of a surface at one (u, v), to third order.")
      .def(py::init<>())
      .def_readwrite("p", &SurfaceJet::p)
      .def_readwrite("u", &SurfaceJet::u)
      .def_readwrite("v", &SurfaceJet::v)
      .def_readwrite("uu", &SurfaceJet::uu)
      .def_readwrite("uv", &SurfaceJet::uv)
      .def_readwrite("vv", &SurfaceJet::vv)
      .def_readwrite("uuu", &SurfaceJet::uuu)
      .def_readwrite("uuv", &SurfaceJet::uuv)
      .def_readwrite("uvv", &SurfaceJet::uvv)
      .def_readwrite("vvv", &SurfaceJet::vvv);
}

}  // namespace

void bindBezier(py::module_& module) {
  bindJet(module);
  py::class_<BezierCurve>(
      module, "BezierCurve", py::module_local(),
      "A (rational) Bézier curve on [0, 1]: poles (n+1, 3), weights (n+1,) or None.")
      .def(py::init(&makeCurve), py::arg("poles"), py::arg("weights") = py::none())
      .def_property_readonly("degree", &BezierCurve::degree)
      .def_property_readonly("is_rational", &BezierCurve::isRational)
      .def_property_readonly("poles", &BezierCurve::poles)
      .def_property_readonly("weights", &BezierCurve::weights)
      .def("point", &curvePoint, py::arg("t"))
      .def("jet", &curveJet, py::arg("t"), "Point and derivatives to third order, (4, 3).")
      .def("derivatives", &curveDerivatives, py::arg("t"), py::arg("order"),
           "Point and derivatives to that order, at most 1000: (order+1, 3).")
      .def("reversed", &BezierCurve::reversed, "The same curve run backwards.")
      .def("elevated", &BezierCurve::elevated, "The same curve with one degree more.")
      .def("split", &curveParts, py::arg("t"), "The pieces over [0, t] and [t, 1].")
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
  py::class_<BezierPatch>(
      module, "BezierPatch", py::module_local(),
      "A (rational) tensor-product Bézier patch on [0, 1]^2: poles (m+1, n+1, 3), "
      "weights (m+1, n+1) or None.")
      .def(py::init(&makePatch), py::arg("poles"), py::arg("weights") = py::none())
      .def_property_readonly("degree_u", &BezierPatch::degreeU)
      .def_property_readonly("degree_v", &BezierPatch::degreeV)
      .def_property_readonly("is_rational", &BezierPatch::isRational)
      .def_property_readonly("poles", &netPoles)
      .def_property_readonly("weights", &netWeights)
      .def("point", &patchPoint, py::arg("u"), py::arg("v"))
      .def("jet", &patchJet, py::arg("u"), py::arg("v"),
           "Point and partials to third order, a SurfaceJet.")
      .def("transposed", &BezierPatch::transposed, "The same patch with u and v exchanged.")
      .def("reversed_u", &BezierPatch::reversedU, "X(1 - u, v).")
      .def("split_u", &patchParts, py::arg("t"), "The pieces over u in [0, t] and [t, 1].")
      .def("iso_curve_u", &BezierPatch::isoCurveU, py::arg("u"), "The curve u = const.")
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

}  // namespace seamwright::python
