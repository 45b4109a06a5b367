// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/knot_curve.hpp>
#include <seamwright/core/spline/g2_spline.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/joint.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

HomogeneousPoles homogeneousOf(const Array& poles, const std::optional<Array>& weights) {
  const Poles rows = polesOf(poles, 2, "(count, 3)");
  return homogeneousPoles(
      rows, weights ? weightsOf(*weights, poles) : Eigen::VectorXd::Ones(rows.rows()));
}

constexpr int kMostOrder = 1000;      // bounds the time: the quotient rule takes order^2 steps
constexpr int kMostJointOrder = 100;  // bounds the time: measuring a joint takes order^3 steps

/// \throws ValueError for an order above \p most.
int orderOf(int order, int most) {
  if (order > most)
    throw py::value_error("order " + std::to_string(order) + ": it must be within " +
                          std::to_string(most));
  return order;
}

int wholeNumber(const char* name, const py::object& value) {
  return argument<int>(name, value, "a whole number");
}

BSplineCurve makeBSplineCurve(const py::object& degree, std::vector<double> knots,
                              const Array& poles, const std::optional<Array>& weights) {
  BSplineCurve curve{wholeNumber("degree", degree), std::move(knots),
                     homogeneousOf(poles, weights)};
  requireValid(curve);
  return curve;
}

BezierSpline makeSpline(const py::object& degree, std::vector<double> knots, const Array& poles,
                        const std::optional<Array>& weights, bool closed) {
  BezierSpline spline{wholeNumber("degree", degree), std::move(knots),
                      homogeneousOf(poles, weights), closed};
  requireValid(spline);
  return spline;
}

template <class Curve>
CurveDerivatives derivativesOf(const Curve& curve, double t, int order) {
  return derivatives(curve, parameter("t", t), orderOf(order, kMostOrder));
}

py::list jointsOf(const BezierSpline& spline, const py::object& order, const py::object& profile,
                  const py::object& gap_mm, const py::object& angle_deg,
                  const py::object& curvature_rel, const py::object& flat_radius_mm) {
  const ContinuityTolerance tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, noCrease()});
  py::list list;
  const int asked = orderOf(wholeNumber("order", order), kMostJointOrder);
  for (const CurveJoint& joint : measureJoints(spline, asked))
    list.append(jointDict(joint, tolerance));
  return list;
}

/// A clamped curve from the numbers of a FreeCAD curve, over the whole range of that curve.
BSplineCurve clampedOf(int degree, std::vector<double> knots, std::vector<int> multiplicities,
                       const Array& poles, const std::optional<Array>& weights, bool periodic) {
  const KnotCurve curve{degree, std::move(knots), std::move(multiplicities),
                        homogeneousOf(poles, weights), periodic};
  const auto [first, last] = rangeOf(curve);
  return clampedCurve(curve, first, last);
}

BezierSpline directOf(const Array& vertices, const py::object& alpha, const py::object& omega,
                      bool closed) {
  const Poles rows = polesOf(vertices, 2, "(count, 3)");
  const Eigen::Index edges = closed ? rows.rows() : std::max<Eigen::Index>(rows.rows() - 1, 0);
  return directG2Spline({rows, closed, each("alpha", alpha, edges), each("omega", omega, edges)});
}

BezierSpline gammaOf(const Array& vertices, const py::object& lengths, const py::object& gamma,
                     bool closed) {
  const Poles rows = polesOf(vertices, 2, "(count, 3)");
  const Eigen::Index segments = closed ? rows.rows() : std::max<Eigen::Index>(rows.rows() - 3, 0);
  return gammaSpline(
      {rows, closed, each("lengths", lengths, segments), each("gamma", gamma, segments)});
}

/// Members that both types of curve have.
template <class Curve>
void bindNumbers(py::class_<Curve>& type) {
  type.def_property_readonly("degree", [](const Curve& c) { return c.degree; })
      .def_property_readonly("knots", [](const Curve& c) { return c.knots; })
      .def_property_readonly("poles", [](const Curve& c) { return affinePoles(c.poles); })
      .def_property_readonly("weights",
                             [](const Curve& c) { return Eigen::VectorXd(c.poles.col(3)); })
      .def_property_readonly("is_rational", [](const Curve& c) { return isRational(c.poles); })
      .def(
          "point",
          [](const Curve& c, double t) { return Eigen::Vector3d(derivativesOf(c, t, 0).row(0)); },
          py::arg("t"))
      .def("derivatives", &derivativesOf<Curve>, py::arg("t"), py::arg("order"),
           "Point and derivatives to that order, at most 1000: (order+1, 3). At a knot those of "
           "what follows.")
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

}  // namespace

void bindSpline(py::module_& module) {
  py::class_<BSplineCurve> curve(
      module, "BSplineCurve", py::module_local(),
      "A (rational) B-spline curve with clamped ends: degree, flat knots, poles "
      "(count, 3), weights (count,) or None.");
  py::class_<BezierSpline> spline(
      module, "BezierSpline", py::module_local(),
      "Bézier segments of one degree end to end: segment i over knots[i] to "
      "knots[i+1] with the poles i degree to (i+1) degree; weights or None; "
      "closed: the end is the beginning, and a joint.");
  curve
      .def(py::init(&makeBSplineCurve), py::arg("degree"), py::arg("knots"), py::arg("poles"),
           py::arg("weights") = py::none())
      .def_static("from_bezier", &splineCurve, py::arg("curve"),
                  "The same curve with knots 0 and 1.")
      .def(
          "bezier_spline",
          [](const BSplineCurve& c, bool closed) { return bezierSpline(c, closed); },
          py::arg("closed") = false,
          "Its Bézier segments; closed: its end is its beginning, bit by bit.");
  bindNumbers(curve);
  spline
      .def(py::init(&makeSpline), py::arg("degree"), py::arg("knots"), py::arg("poles"),
           py::arg("weights") = py::none(), py::arg("closed") = false)
      .def_static(
          "from_segments",
          [](const std::vector<BezierCurve>& segments, const std::vector<double>& knots,
             bool closed, double gap_mm) { return bezierSpline(segments, knots, closed, gap_mm); },
          py::arg("segments"), py::arg("knots"), py::arg("closed") = false, py::arg("gap_mm") = 0.0,
          "Joins BezierCurves whose ends are at most gap_mm apart, raised to the highest of their "
          "degrees.")
      .def_property_readonly("closed", [](const BezierSpline& s) { return s.closed; })
      .def_property_readonly("segments", &BezierSpline::segments, "How many there are.")
      .def("segment", &segment, py::arg("i"), "Segment i as a BezierCurve, its parameter 0..1.")
      .def("measure_joints", &jointsOf, py::arg("order") = 3, py::kw_only(),
           py::arg("profile") = "default", py::arg("gap_mm") = py::none(),
           py::arg("angle_deg") = py::none(), py::arg("curvature_rel") = py::none(),
           py::arg("flat_radius_mm") = py::none(),
           "To an order of at most 100. The joints at the inner knots, then that of a closed "
           "spline's end "
           "with its beginning: dicts as of "
           "measure_joint.")
      .def("continuity", &continuity, py::arg("around") = false,
           "The order, up to degree - 1, to which derivatives by the parameter agree at every "
           "inner knot; "
           "around: from a closed spline's end to its beginning as well; -1 if it is not closed or "
           "its "
           "weights "
           "there differ.")
      .def(
          "to_bspline",
          [](const BezierSpline& s, const py::object& order) {
            return bsplineCurve(s,
                                order.is_none() ? continuity(s) : wholeNumber("continuity", order));
          },
          py::arg("continuity") = py::none(),
          "The same curve as a BSplineCurve with inner knots of multiplicity degree - continuity; "
          "None: as "
          "continuity() finds. ValueError where a derivative up to that order jumps, with knot, "
          "order and "
          "jump.");
  bindNumbers(spline);
  module.def("_clamped_curve", &clampedOf, py::arg("degree"), py::arg("knots"),
             py::arg("multiplicities"), py::arg("poles"), py::arg("weights"), py::arg("periodic"));
  module.def("direct_g2_spline", &directOf, py::arg("vertices"), py::arg("alpha"), py::arg("omega"),
             py::arg("closed") = false,
             "The cubic BezierSpline with inner poles on the edges of a polygon whose joints are "
             "G2: alpha and "
             "omega, a number or one for each edge, are the shares of the edge before them. "
             "Closed: a segment "
             "on each edge. Open: on all but the first and last edge; the curve runs from the "
             "first vertex to "
             "the last.");
  module.def("gamma_spline", &gammaOf, py::arg("vertices"), py::arg("lengths") = 1.0,
             py::arg("gamma") = 1.0, py::arg("closed") = false,
             "The direct G2 spline that is C1 for segments of these lengths in the parameter: a "
             "number, or one "
             "for each segment. gamma, likewise, gamma[i] where segment i begins: 1 is the C2 "
             "B-spline, 0 the "
             "polygon, larger ones pull away from it.");
}

}  // namespace seamwright::python
