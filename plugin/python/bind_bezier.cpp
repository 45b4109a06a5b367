// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <iterator>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/parameters.hpp>
#include <string>
#include <utility>

namespace py = pybind11;

namespace seamwright::python {

namespace {

BezierCurve makeCurve(const py::object& poles, const py::object& weights) {
  const Array array = arrayOf("poles", poles);
  return {polesOf("poles", array, 2, "(n+1, 3)"), weightsOf(weights, array)};
}

BezierPatch makePatch(const py::object& poles, const py::object& weights) {
  const Array array = arrayOf("poles", poles);
  const Poles rows = polesOf("poles", array, 3, "(m+1, n+1, 3)");
  const int m = static_cast<int>(array.shape(0)) - 1;
  const int n = static_cast<int>(array.shape(1)) - 1;
  return {m, n, rows, weightsOf(weights, array)};
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

Poles jetRows(const CurveJet& jet) {
  Poles rows(4, 3);
  rows << jet.p.transpose(), jet.d1.transpose(), jet.d2.transpose(), jet.d3.transpose();
  return rows;
}

Array curveJet(const BezierCurve& curve, const py::object& t) {
  const Parameters at("t", t);
  return valuesOf(at.shape(), {4, 3}, [&](py::ssize_t i) { return jetRows(curve.jet(at[i])); });
}

Array curvePoint(const BezierCurve& curve, const py::object& t) {
  const Parameters at("t", t);
  return valuesOf(at.shape(), {3}, [&](py::ssize_t i) { return curve.point(at[i]); });
}

Array curveDerivatives(const BezierCurve& curve, const py::object& t, const py::object& order) {
  const Parameters at("t", t);
  const int highest = derivativeOrder(order);
  return valuesOf(at.shape(), {highest + 1, 3},
                  [&](py::ssize_t i) { return Poles(curve.derivatives(at[i], highest)); });
}

std::pair<BezierCurve, BezierCurve> curveParts(const BezierCurve& curve, const py::object& t) {
  return curve.split(parameter("t", t));
}

std::pair<BezierPatch, BezierPatch> patchParts(const BezierPatch& patch, const py::object& t) {
  return patch.splitU(parameter("t", t));
}

Array patchPoint(const BezierPatch& patch, const py::object& u, const py::object& v) {
  const ParameterPairs at("u", u, "v", v);
  return valuesOf(at.first.shape(), {3},
                  [&](py::ssize_t i) { return patch.point(at.first[i], at.second[i]); });
}

py::object patchJet(const BezierPatch& patch, const py::object& u, const py::object& v) {
  const ParameterPairs at("u", u, "v", v);
  return objectsAt(at.first, [&](py::ssize_t i) { return patch.jet(at.first[i], at.second[i]); });
}

constexpr Eigen::Vector3d SurfaceJet::*jet_members[] = {
    &SurfaceJet::p,  &SurfaceJet::u,   &SurfaceJet::v,   &SurfaceJet::uu,  &SurfaceJet::uv,
    &SurfaceJet::vv, &SurfaceJet::uuu, &SurfaceJet::uuv, &SurfaceJet::uvv, &SurfaceJet::vvv};

Array jetState(const SurfaceJet& jet) {
  Array state({std::size(jet_members), std::size_t{3}});
  for (std::size_t k = 0; k < std::size(jet_members); ++k)
    Eigen::Map<Eigen::Vector3d>(state.mutable_data() + 3 * k) = jet.*jet_members[k];
  return state;
}

SurfaceJet jetFrom(const Array& state) {
  const Poles rows = polesOf("state", state, 2, "(10, 3)");
  if (rows.rows() != std::size(jet_members)) throw py::value_error("state of another class");
  SurfaceJet jet;
  for (std::size_t k = 0; k < std::size(jet_members); ++k)
    jet.*jet_members[k] = rows.row(static_cast<Eigen::Index>(k)).transpose();
  return jet;
}

void bindJet(py::module_& module) {
  py::class_<SurfaceJet>(
      module, "SurfaceJet", py::module_local(),
      "Point and partial derivatives of a surface at one (u, v), to third order: p, u, v, uu, uv, "
      "vv, uuu, uuv, uvv, vvv, each (3,) in mm.")
      .def(py::init<>())
      .def(py::pickle(&jetState, &jetFrom))
      .def("__repr__",
           [](const SurfaceJet& jet) {
             return "<SurfaceJet at " + py::cast<std::string>(py::str(py::cast(jet.p))) + ">";
           })
      .def_readwrite("p", &SurfaceJet::p, "The point X(u, v), (3,) in mm.")
      .def_readwrite("u", &SurfaceJet::u, "The derivative of X by u, (3,).")
      .def_readwrite("v", &SurfaceJet::v, "The derivative of X by v, (3,).")
      .def_readwrite("uu", &SurfaceJet::uu, "The second derivative of X by u, (3,).")
      .def_readwrite("uv", &SurfaceJet::uv, "The twist: the derivative of X by u and v, (3,).")
      .def_readwrite("vv", &SurfaceJet::vv, "The second derivative of X by v, (3,).")
      .def_readwrite("uuu", &SurfaceJet::uuu, "The third derivative of X by u, (3,).")
      .def_readwrite("uuv", &SurfaceJet::uuv, "The derivative of X twice by u and once by v, (3,).")
      .def_readwrite("uvv", &SurfaceJet::uvv, "The derivative of X once by u and twice by v, (3,).")
      .def_readwrite("vvv", &SurfaceJet::vvv, "The third derivative of X by v, (3,).");
}

void bindCurve(py::module_& module) {
  py::class_<BezierCurve>(
      module, "BezierCurve", py::module_local(),
      R"(A (rational) Bézier curve on [0, 1]: poles (n+1, 3) in mm, weights (n+1,) or None.

ValueError, with index and value, for a pole that is not finite and a weight that is not
positive.)")
      .def(py::init(&makeCurve), py::arg("poles"), py::arg("weights") = py::none())
      .def_property_readonly("degree", &BezierCurve::degree, "n: the number of poles minus 1.")
      .def_property_readonly("is_rational", &BezierCurve::isRational, "Whether the weights differ.")
      .def_property_readonly("poles", &BezierCurve::poles, "(n+1, 3), in mm.")
      .def_property_readonly("weights", &BezierCurve::weights, "(n+1,).")
      .def("point", &curvePoint, py::arg("t"),
           "The point (3,) at t; for an array of shape s, points s + (3,).")
      .def("jet", &curveJet, py::arg("t"),
           "Point and derivatives to third order, (4, 3); for an array of shape s, s + (4, 3).")
      .def("derivatives", &curveDerivatives, py::arg("t"), py::arg("order"),
           "Point and derivatives to that order, at most 1000: (order+1, 3); for an array t of "
           "shape s, s + (order+1, 3).")
      .def("reversed", &BezierCurve::reversed, "The same curve run backwards.")
      .def("elevated", &BezierCurve::elevated, "The same curve with one degree more.")
      .def("split", &curveParts, py::arg("t"), "The pieces over [0, t] and [t, 1].")
      .def(py::pickle(
          [](const BezierCurve& curve) { return homogeneousArray(curve.homogeneousPoles()); },
          [](const Array& state) { return BezierCurve::fromHomogeneous(homogeneousRows(state)); }))
      .def("__repr__",
           [](const BezierCurve& curve) {
             return "<BezierCurve of degree " + std::to_string(curve.degree()) +
                    (curve.isRational() ? ", rational>" : ">");
           })
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

void bindPatch(py::module_& module) {
  py::class_<BezierPatch>(
      module, "BezierPatch", py::module_local(),
      R"(A (rational) tensor-product Bézier patch on [0, 1]^2: poles (m+1, n+1, 3) in mm, weights
(m+1, n+1) or None.

ValueError, with index and value, for a pole that is not finite and a weight that is not
positive.)")
      .def(py::init(&makePatch), py::arg("poles"), py::arg("weights") = py::none())
      .def_property_readonly("degree_u", &BezierPatch::degreeU, "m: in the direction u.")
      .def_property_readonly("degree_v", &BezierPatch::degreeV, "n: in the direction v.")
      .def_property_readonly("is_rational", &BezierPatch::isRational, "Whether the weights differ.")
      .def_property_readonly("poles", &netPoles, "(m+1, n+1, 3), in mm.")
      .def_property_readonly("weights", &netWeights, "(m+1, n+1).")
      .def("point", &patchPoint, py::arg("u"), py::arg("v"),
           "The point (3,) at (u, v); arrays broadcast to a shape s: points s + (3,).")
      .def("jet", &patchJet, py::arg("u"), py::arg("v"),
           "Point and partials to third order, a SurfaceJet; for arrays an array of them.")
      .def("transposed", &BezierPatch::transposed, "The same patch with u and v exchanged.")
      .def("reversed_u", &BezierPatch::reversedU, "X(1 - u, v).")
      .def("split_u", &patchParts, py::arg("t"), "The pieces over u in [0, t] and [t, 1].")
      .def(
          "iso_curve_u",
          [](const BezierPatch& patch, const py::object& u) {
            return patch.isoCurveU(parameter("u", u));
          },
          py::arg("u"), "The BezierCurve at constant u.")
      .def(py::pickle(
          [](const BezierPatch& patch) {
            return py::make_tuple(patch.degreeU(), patch.degreeV(),
                                  homogeneousArray(patch.homogeneousPoles()));
          },
          [](const py::tuple& state) {
            return BezierPatch::fromHomogeneous(state[0].cast<int>(), state[1].cast<int>(),
                                                homogeneousRows(state[2].cast<Array>()));
          }))
      .def("__repr__",
           [](const BezierPatch& patch) {
             return "<BezierPatch of degrees " + std::to_string(patch.degreeU()) + " by " +
                    std::to_string(patch.degreeV()) + (patch.isRational() ? ", rational>" : ">");
           })
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

}  // namespace

void bindBezier(py::module_& module) {
  bindJet(module);
  bindCurve(module);
  bindPatch(module);
}

}  // namespace seamwright::python
