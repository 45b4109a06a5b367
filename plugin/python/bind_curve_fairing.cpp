// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/fair/polish_curve.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/fairness.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

bool isPlanar(const CurveSegments& curve) {
  return (curve.poles().col(2).array() == 0).all();
}

/// Intervals of a segment in the parameter of the whole curve.
void addIntervals(py::list& list, const std::vector<Interval>& found,
                  const CurveSegments::Part& part) {
  for (const Interval& interval : found)
    list.append(py::make_tuple(part.whole(interval.lower), part.whole(interval.upper)));
}

py::object curvatureProfileOf(const py::object& given) {
  const CurveSegments curve(curveOf("curve", given));
  const bool planar = isPlanar(curve);
  py::list extrema, inflections, undecided_extrema, undecided_inflections;
  for (const CurveSegments::Part& part : curve.parts()) {
    const CurvatureProfile profile =
        planar ? planarCurvatureProfile(part.curve) : spaceCurvatureProfile(part.curve);
    for (const CurvatureExtremum& extremum : profile.extrema) {
      py::dict entry;
      entry["lower"] = part.whole(extremum.parameters.lower);
      entry["upper"] = part.whole(extremum.parameters.upper);
      entry["maximum"] = extremum.maximum;
      entry["curvature_per_mm"] = extremum.curvature_per_mm;
      extrema.append(entry);
    }
    addIntervals(inflections, profile.inflections, part);
    addIntervals(undecided_extrema, profile.undecided_extrema, part);
    addIntervals(undecided_inflections, profile.undecided_inflections, part);
  }
  py::dict dict;
  dict["extrema"] = extrema;
  dict["inflections"] = inflections;
  dict["undecided_extrema"] = undecided_extrema;
  dict["undecided_inflections"] = undecided_inflections;
  dict["monotone"] = extrema.empty() && undecided_extrema.empty();
  dict["signed"] = planar;
  return resultOf("CurvatureProfile", dict);
}

py::object curveFairnessOf(const py::object& curve) {
  return curveFairnessResult(fairnessOf(bsplineCurveOf("curve", curve)));
}

/// \param fair  fairCurve() or fairKnots().
template <class Fair>
py::object fairedCurveResult(const py::object& curve, const py::object& tolerance_mm,
                             const py::object& ends, const Fair& fair) {
  const BSplineCurve spline = bsplineCurveOf("curve", curve);
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  const CurveFairingOptions options{.ends = choiceOf("ends", ends, held_ends)};
  const FairedCurve faired = [&] {
    const py::gil_scoped_release release;
    return fair(spline, tolerance, options);
  }();
  py::dict dict;
  dict["curve"] = faired.curve;
  dict["moved_mm"] = faired.moved_mm;
  dict["smoothing"] = faired.smoothing;
  dict["before"] = curveFairnessResult(faired.before);
  dict["after"] = curveFairnessResult(faired.after);
  dict["steps"] = faired.steps;
  return resultOf("FairedCurve", dict);
}

py::object fairCurveOf(const py::object& curve, const py::object& tolerance_mm,
                       const py::object& ends) {
  return fairedCurveResult(curve, tolerance_mm, ends,
                           [](const auto&... arguments) { return fairCurve(arguments...); });
}

py::object fairKnotsOf(const py::object& curve, const py::object& tolerance_mm,
                       const py::object& ends) {
  return fairedCurveResult(curve, tolerance_mm, ends,
                           [](const auto&... arguments) { return fairKnots(arguments...); });
}

py::object polishCurveOf(const py::object& curve, const py::object& tolerance_mm,
                         const py::object& ends) {
  const BSplineCurve spline = bsplineCurveOf("curve", curve);
  const double tolerance = numberOf("tolerance_mm", tolerance_mm);
  const CurveFairingOptions options{.ends = choiceOf("ends", ends, held_ends)};
  const PolishedCurve polished = [&] {
    const py::gil_scoped_release release;
    return polishCurve(spline, tolerance, options);
  }();
  py::dict dict;
  dict["curve"] = polished.curve;
  dict["moved_mm"] = polished.moved_mm;
  dict["before"] = curveFairnessResult(polished.before);
  dict["after"] = curveFairnessResult(polished.after);
  dict["variation_before_per_mm3"] = polished.variation_before_per_mm3;
  dict["variation_after_per_mm3"] = polished.variation_after_per_mm3;
  dict["weight_per_mm5"] = polished.weight_per_mm5;
  dict["steps"] = polished.steps;
  return resultOf("PolishedCurve", dict);
}

BSplineCurve fairedAtKnotOf(const py::object& curve, const py::object& index,
                            const py::object& limit_mm) {
  const BSplineCurve spline = bsplineCurveOf("curve", curve);
  const int knot = wholeNumber("index", index);
  if (limit_mm.is_none()) return fairedAtKnot(spline, knot);
  return fairedAtKnot(spline, knot, numberOf("limit_mm", limit_mm));
}

BSplineCurve smoothingSplineOf(const py::object& points, const py::object& parameters,
                               const py::object& knots, const py::object& smoothing,
                               const py::object& degree, const py::object& ends_fixed) {
  const Poles rows = rowsOf("points", points, "(count, 3)");
  const std::vector<double> at = listOf("parameters", parameters), flat = listOf("knots", knots);
  const double weight = numberOf("smoothing", smoothing);
  const int order = wholeNumber("degree", degree);
  const bool fixed = flagOf("ends_fixed", ends_fixed);
  const py::gil_scoped_release release;
  return smoothingSpline(order, flat, at, rows, weight, fixed);
}

void bindWholeCurves(py::module_& module) {
  module.def("curvature_profile", &curvatureProfileOf, py::arg("curve"),
             R"(Where the curvature of a curve has extrema and changes its sign: a CurvatureProfile.

curve: of any class. In the plane z = 0 the curvature is signed, above 0 to the left; in space it is
not negative. Outside of the intervals the curvature certainly grows or falls throughout a segment;
joints of a spline are not judged, curve_fairness() counts extrema there. ValueError for a curve
that may stop, with the parameter within the segment. Source: docs/theory/planar.md P8.1 to P8.3.
)");
  module.def("curve_fairness", &curveFairnessOf, py::arg("curve"),
             R"(How fair a polynomial curve of any class is, of degree 2 or more: a CurveFairness.

ValueError for a rational curve and for a degree of 1.)");
  module.def("fair_curve", &fairCurveOf, py::arg("curve"), py::arg("tolerance_mm"), py::kw_only(),
             py::arg("ends") = "position",
             R"(The fairest curve with the same knots that moves no point by more: a FairedCurve.

curve: polynomial, of any class, planar or in space. The energy is least while each Bézier pole of
the difference stays within tolerance_mm, so every place may move as far; smoothing is the weight of
the energy against the squared distance in the mean. ends: 'nothing', 'position', 'tangent'
(position and first derivative) or 'curvature' (up to the second) stay, bitwise. The energy does not
grow; a tolerance of 0 returns the curve. ValueError for a tolerance that is negative or not finite,
and as for curve_fairness(). Source: docs/theory/planar.md P11.4.
)");
  module.def("polish_curve", &polishCurveOf, py::arg("curve"), py::arg("tolerance_mm"),
             py::kw_only(), py::arg("ends") = "position",
             R"(The curve with the same knots whose curvature varies least: a PolishedCurve.

curve: polynomial, of any class and of degree 3 or more, planar or in space, with continuous
curvature. Unlike that of fair_curve() the energy, the integral of (dk/ds)^2 + (k t)^2 by arc
length, does not depend on the parametrisation: arcs and lines have 0. No point moves by more than
tolerance_mm, the energy does not grow, and a tolerance of 0 returns the curve. ends: as for
fair_curve(); they join G0, G1 or G2 as before. It is a local minimum. ValueError for a tolerance
that is negative or not finite, rational curves, lower degrees, knots at which the curvature may
jump, and curves that stop. Source: docs/theory/planar.md P11.3, P13.4.
)");
}

}  // namespace

void bindCurveFairing(py::module_& module) {
  bindWholeCurves(module);
  module.def("fair_at_knots", &fairKnotsOf, py::arg("curve"), py::arg("tolerance_mm"),
             py::kw_only(), py::arg("ends") = "position",
             R"(A cubic curve faired at its worst knots, one after the other: a FairedCurve.

No pole, and so no point, moves by more than tolerance_mm. ends: as for fair_curve(). ValueError for
another degree, and as for fair_curve(). Source: docs/theory/planar.md P11.2; [Farin2002].
)");
  module.def(
      "fair_at_knot", &fairedAtKnotOf, py::arg("curve"), py::arg("index"),
      py::arg("limit_mm") = py::none(),
      R"(A cubic BSplineCurve whose third derivative does not jump at a knot, by one pole's move.

index: of a simple knot in the flat knots, with three knots on each side. limit_mm: the largest move
of the pole; None: none. ValueError for other knots and degrees. Source: docs/theory/planar.md
P11.2; [Farin2002].
)");
  module.def(
      "smoothing_spline", &smoothingSplineOf, py::arg("points"), py::arg("parameters"),
      py::arg("knots"), py::arg("smoothing"), py::kw_only(), py::arg("degree") = 3,
      py::arg("ends_fixed") = false,
      R"(The BSplineCurve P with the least sum of |P(t_k) - Q_k|^2 plus smoothing times energy.

points: Q, (count, 3) in mm. parameters: t, one for each point. knots: flat, of a curve of that
degree. The energy is the integral of |P'''|^2. ends_fixed: the curve begins and ends at the first
and the last point. ValueError for numbers that do not match, parameters outside of the knots, a
smoothing that is not positive, and singular equations. Source: docs/theory/planar.md P11.1.
)");
}

}  // namespace seamwright::python
