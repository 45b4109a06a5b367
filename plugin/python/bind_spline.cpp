// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/operators.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/knot_curve.hpp>
#include <seamwright/core/spline/g2_spline.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/joint.hpp>
#include <seamwright/plugin/python/parameters.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

HomogeneousPoles homogeneousOf(const py::object& poles, const py::object& weights) {
  const Array array = arrayOf("poles", poles);
  return homogeneousPoles(polesOf("poles", array, 2, "(count, 3)"), weightsOf(weights, array));
}

constexpr int kMostJointOrder = 100;  // bounds the time: measuring a joint takes order^3 steps

BSplineCurve makeBSplineCurve(const py::object& degree, const py::object& knots,
                              const py::object& poles, const py::object& weights) {
  BSplineCurve curve{wholeNumber("degree", degree), listOf("knots", knots),
                     homogeneousOf(poles, weights)};
  requireValid(curve);
  return curve;
}

BezierSpline makeSpline(const py::object& degree, const py::object& knots, const py::object& poles,
                        const py::object& weights, const py::object& closed) {
  BezierSpline spline{wholeNumber("degree", degree), listOf("knots", knots),
                      homogeneousOf(poles, weights), flagOf("closed", closed)};
  requireValid(spline);
  return spline;
}

template <class Curve>
Array derivativesOf(const Curve& curve, const py::object& t, const py::object& order) {
  const Parameters at("t", t);
  const int highest = derivativeOrder(order);
  return valuesOf(at.shape(), {highest + 1, 3},
                  [&](py::ssize_t i) { return derivatives(curve, at[i], highest); });
}

template <class Curve>
Array pointOf(const Curve& curve, const py::object& t) {
  const Parameters at("t", t);
  return valuesOf(at.shape(), {3}, [&](py::ssize_t i) { return derivatives(curve, at[i], 0); });
}

py::list jointsOf(const BezierSpline& spline, const py::object& order, const py::object& profile,
                  const py::object& gap_mm, const py::object& angle_deg,
                  const py::object& curvature_rel, const py::object& flat_radius_mm) {
  const ContinuityTolerance tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, noCrease()});
  py::list list;
  const int highest = derivativeOrder(order, kMostJointOrder);
  for (const CurveJoint& joint : measureJoints(spline, highest))
    list.append(jointResult(joint, tolerance));
  return list;
}

/// Curves of one segment each.
std::vector<BezierCurve> segmentsOf(const py::object& value) {
  if (!isSequence(value))
    throw py::value_error("segments is " + shown(value) + ": a sequence of curves is needed");
  std::vector<BezierCurve> segments;
  for (const py::handle item : value)
    segments.push_back(bezierCurveOf("segment " + std::to_string(segments.size()),
                                     py::reinterpret_borrow<py::object>(item)));
  return segments;
}

BezierSpline joinedSegments(const py::object& segments, const py::object& knots,
                            const py::object& closed, const py::object& gap_mm) {
  return bezierSpline(segmentsOf(segments), listOf("knots", knots), flagOf("closed", closed),
                      numberOf("gap_mm", gap_mm));
}

BSplineCurve toBSpline(const BezierSpline& spline, const py::object& order) {
  return bsplineCurve(spline,
                      order.is_none() ? continuity(spline) : wholeNumber("continuity", order));
}

/// A clamped curve from the numbers of a FreeCAD curve, over the whole range of that curve.
BSplineCurve clampedOf(int degree, std::vector<double> knots, std::vector<int> multiplicities,
                       const py::object& poles, const py::object& weights, bool periodic) {
  const KnotCurve curve{degree, std::move(knots), std::move(multiplicities),
                        homogeneousOf(poles, weights), periodic};
  const auto [first, last] = rangeOf(curve);
  return clampedCurve(curve, first, last);
}

BezierSpline directOf(const py::object& vertices, const py::object& alpha, const py::object& omega,
                      const py::object& closed) {
  const Poles rows = rowsOf("vertices", vertices, "(count, 3)");
  const bool around = flagOf("closed", closed);
  const Eigen::Index edges = around ? rows.rows() : std::max<Eigen::Index>(rows.rows() - 1, 0);
  return directG2Spline({rows, around, each("alpha", alpha, edges), each("omega", omega, edges)});
}

BezierSpline gammaOf(const py::object& vertices, const py::object& lengths, const py::object& gamma,
                     const py::object& closed) {
  const Poles rows = rowsOf("vertices", vertices, "(count, 3)");
  const bool around = flagOf("closed", closed);
  const Eigen::Index segments = around ? rows.rows() : std::max<Eigen::Index>(rows.rows() - 3, 0);
  return gammaSpline(
      {rows, around, each("lengths", lengths, segments), each("gamma", gamma, segments)});
}

/// Members that both types of curve have.
template <class Curve>
void bindNumbers(py::class_<Curve>& type, const char* knots_doc) {
  type.def_property_readonly(
          "degree", [](const Curve& c) { return c.degree; }, "Of the polynomials between knots.")
      .def_property_readonly(
          "knots", [](const Curve& c) { return c.knots; }, knots_doc)
      .def_property_readonly(
          "poles", [](const Curve& c) { return affinePoles(c.poles); }, "(count, 3), in mm.")
      .def_property_readonly(
          "weights", [](const Curve& c) { return Eigen::VectorXd(c.poles.col(3)); }, "(count,).")
      .def_property_readonly(
          "is_rational", [](const Curve& c) { return isRational(c.poles); },
          "Whether the weights differ.")
      .def("point", &pointOf<Curve>, py::arg("t"),
           "The point (3,) at t; for an array of shape s, points s + (3,).")
      .def("derivatives", &derivativesOf<Curve>, py::arg("t"), py::arg("order"),
           "Point and derivatives to that order, at most 1000: (order+1, 3); for an array t of "
           "shape s, s + (order+1, 3). At a knot those of what follows.")
      .def(py::self == py::self)
      .attr("__hash__") = py::none();
}

void bindBSplineCurve(py::class_<BSplineCurve>& type) {
  type.def(py::init(&makeBSplineCurve), py::arg("degree"), py::arg("knots"), py::arg("poles"),
           py::arg("weights") = py::none())
      .def_static(
          "from_bezier",
          [](const py::object& curve) {
            return splineCurve(objectOf<BezierCurve>("curve", curve, "a BezierCurve"));
          },
          py::arg("curve"), "The same curve with knots 0 and 1.")
      .def(
          "bezier_spline",
          [](const BSplineCurve& c, const py::object& closed) {
            return bezierSpline(c, flagOf("closed", closed));
          },
          py::arg("closed") = false,
          "Its Bézier segments; closed: its end is its beginning, "
          "bitwise.")
      .def(py::pickle(
          [](const BSplineCurve& c) {
            return py::make_tuple(c.degree, c.knots, homogeneousArray(c.poles));
          },
          [](const py::tuple& state) {
            BSplineCurve curve{state[0].cast<int>(), state[1].cast<std::vector<double>>(),
                               homogeneousRows(state[2].cast<Array>())};
            requireValid(curve);
            return curve;
          }))
      .def("__repr__", [](const BSplineCurve& c) {
        return "<BSplineCurve of degree " + std::to_string(c.degree) + " with " +
               std::to_string(c.count()) + " poles>";
      });
  bindNumbers(type,
              "Flat: each knot is repeated by its multiplicity, degree + 1 times at both ends.");
}

void bindSegments(py::class_<BezierSpline>& type) {
  type.def_property_readonly(
          "closed", [](const BezierSpline& s) { return s.closed; },
          "The end is the beginning, and a joint.")
      .def_property_readonly("segments", &BezierSpline::segments, "How many there are.")
      .def(
          "segment",
          [](const BezierSpline& s, const py::object& i) {
            return segment(s, wholeNumber("i", i));
          },
          py::arg("i"), "Segment i as a BezierCurve, its parameter 0..1.")
      .def("measure_joints", &jointsOf, py::arg("order") = 3, py::kw_only(),
           py::arg("profile") = "default", py::arg("gap_mm") = py::none(),
           py::arg("angle_deg") = py::none(), py::arg("curvature_rel") = py::none(),
           py::arg("flat_radius_mm") = py::none(),
           "To an order of at most 100. The joints at the inner knots, then that of a closed "
           "spline's end with its beginning: CurveJoints as for measure_joint.")
      .def(
          "continuity",
          [](const BezierSpline& s, const py::object& around) {
            return continuity(s, flagOf("around", around));
          },
          py::arg("around") = false,
          "The order, up to degree - 1, to which derivatives by the parameter agree at every inner "
          "knot; around: from a closed spline's end to its beginning as well; -1 if it is not "
          "closed or its weights there differ.")
      .def("to_bspline", &toBSpline, py::arg("continuity") = py::none(),
           "The same curve as a BSplineCurve with inner knots of multiplicity degree - "
           "continuity; None: as continuity() finds. ValueError where a derivative up to that "
           "order jumps, with knot, order and jump.");
}

void bindBezierSpline(py::class_<BezierSpline>& type) {
  type.def(py::init(&makeSpline), py::arg("degree"), py::arg("knots"), py::arg("poles"),
           py::arg("weights") = py::none(), py::arg("closed") = false)
      .def_static("from_segments", &joinedSegments, py::arg("segments"), py::arg("knots"),
                  py::arg("closed") = false, py::arg("gap_mm") = 0.0,
                  "Joins BezierCurves whose ends are at most gap_mm apart, raised to the highest "
                  "of their degrees.")
      .def(py::pickle(
          [](const BezierSpline& s) {
            return py::make_tuple(s.degree, s.knots, homogeneousArray(s.poles), s.closed);
          },
          [](const py::tuple& state) {
            BezierSpline spline{state[0].cast<int>(), state[1].cast<std::vector<double>>(),
                                homogeneousRows(state[2].cast<Array>()), state[3].cast<bool>()};
            requireValid(spline);
            return spline;
          }))
      .def("__repr__", [](const BezierSpline& s) {
        return "<BezierSpline of degree " + std::to_string(s.degree) + " with " +
               std::to_string(s.segments()) + " segments" + (s.closed ? ", closed>" : ">");
      });
  bindSegments(type);
  bindNumbers(type,
              "The ends of the segments, each once: segment i runs from knots[i] to knots[i + 1].");
}

}  // namespace

void bindSpline(py::module_& module) {
  py::class_<BSplineCurve> curve(
      module, "BSplineCurve", py::module_local(),
      "A (rational) B-spline curve with clamped ends: degree, flat knots, poles (count, 3) in mm, "
      "weights (count,) or None. ValueError, with index and value, for numbers that make no "
      "curve.");
  py::class_<BezierSpline> spline(
      module, "BezierSpline", py::module_local(),
      "Bézier segments of one degree end to end: segment i over knots[i] to knots[i+1] with the "
      "poles i degree to (i+1) degree, in mm; weights or None; closed: the end is the beginning, "
      "and a joint. ValueError, with index and value, for numbers that make no spline.");
  bindBSplineCurve(curve);
  bindBezierSpline(spline);
  module.def("_clamped_curve", &clampedOf, py::arg("degree"), py::arg("knots"),
             py::arg("multiplicities"), py::arg("poles"), py::arg("weights"), py::arg("periodic"));
  module.def(
      "direct_g2_spline", &directOf, py::arg("vertices"), py::arg("alpha"), py::arg("omega"),
      py::arg("closed") = false,
      R"(The cubic BezierSpline with inner poles on the edges of a polygon whose joints are G2.

vertices: (count, 3) in mm. alpha and omega, a number or one for each edge, are the shares of the
edge before them. closed: a segment on each edge. Open: on all but the first and last edge; the
curve runs from the first vertex to the last.)");
  module.def("gamma_spline", &gammaOf, py::arg("vertices"), py::arg("lengths") = 1.0,
             py::arg("gamma") = 1.0, py::arg("closed") = false,
             R"(The direct G2 spline that is C1 for segments of these lengths in the parameter.

vertices: (count, 3) in mm. lengths: a number, or one for each segment. gamma, likewise, gamma[i]
where segment i begins: 1 is the C2 B-spline, 0 the polygon, larger ones pull away from it.)");
}

}  // namespace seamwright::python
