// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

constexpr NamedValue<BiarcRule> biarc_rules[] = {
    {"default", BiarcRule::Default},
    {"equal chords", BiarcRule::EqualChords},
    {"parallel", BiarcRule::Parallel},
    {"least radius difference", BiarcRule::LeastRadiusDifference},
    {"least curvature", BiarcRule::LeastCurvature}};

constexpr NamedValue<TangentRule> tangent_rules[] = {{"near circles", TangentRule::NearCircles},
                                                     {"linear energy", TangentRule::LinearEnergy},
                                                     {"energy", TangentRule::Energy}};

py::object biarcResult(const Biarc& arcs, double x) {
  py::dict dict;
  dict["chain"] = ArcChain({arcs.first, arcs.second}, false);
  dict["joint_mm"] = arcs.joint();
  dict["x"] = x;
  dict["is_convex"] = arcs.isConvex();
  return resultOf("Biarc", dict);
}

py::object biarcOf(const py::object& start, const py::object& start_direction_rad,
                   const py::object& end, const py::object& end_direction_rad,
                   const py::object& rule, const py::object& x) {
  const HermiteEnds ends = hermiteEndsOf(start, start_direction_rad, end, end_direction_rad);
  if (!x.is_none()) {
    if (!rule.is_none())
      throw py::value_error("x is " + shown(x) + ": it has no meaning with a rule");
    const double share = numberOf("x", x);
    return biarcResult(biarc(ends, share), share);
  }
  const BiarcRule chosen =
      rule.is_none() ? BiarcRule::Default : choiceOf("rule", rule, biarc_rules);
  const Biarc arcs = biarc(ends, chosen);
  return biarcResult(arcs, biarcParameter(ends, chosen).value());
}

TangentOptions tangentOptions(const py::object& closed, const py::object& tangents,
                              const py::object& variation, const py::object& start_direction_rad,
                              const py::object& end_direction_rad) {
  return {.rule = choiceOf("tangents", tangents, tangent_rules),
          .lambda = numberOf("variation", variation),
          .closed = flagOf("closed", closed),
          .start_direction_rad = optionalNumber("start_direction_rad", start_direction_rad),
          .end_direction_rad = optionalNumber("end_direction_rad", end_direction_rad)};
}

py::object planarTangentsOf(const py::object& points, const py::object& closed,
                            const py::object& tangents, const py::object& variation,
                            const py::object& start_direction_rad,
                            const py::object& end_direction_rad) {
  const PlanarPoints rows = planarPointsOf("points", points);
  const TangentOptions options =
      tangentOptions(closed, tangents, variation, start_direction_rad, end_direction_rad);
  const Tangents found = [&] {
    const py::gil_scoped_release release;
    return tangentsAt(rows, options);
  }();
  py::dict dict;
  dict["directions_rad"] = arrayOfNumbers(found.directions_rad);
  dict["steps"] = found.steps;
  return resultOf("PlanarTangents", dict);
}

py::object biarcSplineOf(const py::object& points, const py::object& closed,
                         const py::object& tangents, const py::object& variation,
                         const py::object& start_direction_rad, const py::object& end_direction_rad,
                         const py::object& rule) {
  const PlanarPoints rows = planarPointsOf("points", points);
  const TangentOptions options =
      tangentOptions(closed, tangents, variation, start_direction_rad, end_direction_rad);
  const BiarcRule chosen = choiceOf("rule", rule, biarc_rules);
  const BiarcSpline spline = [&] {
    const py::gil_scoped_release release;
    return biarcSpline(rows, options, chosen);
  }();
  const ArcChain chain(spline.arcs, spline.closed);
  py::dict dict;
  dict["chain"] = chain;
  dict["curve"] = exactSpline(chain);
  dict["directions_rad"] = arrayOfNumbers(spline.directions_rad);
  dict["energy_per_mm"] = spline.energy_per_mm;
  return resultOf("BiarcSpline", dict);
}

}  // namespace

void bindPlanarBiarc(py::module_& module) {
  module.def(
      "biarc", &biarcOf, py::arg("start"), py::arg("start_direction_rad"), py::arg("end"),
      py::arg("end_direction_rad"), py::kw_only(), py::arg("rule") = py::none(),
      py::arg("x") = py::none(),
      R"(Two arcs with one tangent at their joint between two points with directions: a Biarc.

start, end: (2,) in mm. x in (0, 1) chooses one biarc of the family: 0 puts the joint at the start.
rule chooses x: 'equal chords', x = 1/2; 'parallel', the joint's tangent has the direction of the
chord; 'least radius difference'; 'least curvature', the least |k1| + |k2|. None or 'default':
'parallel' if both tangents lie on one side of the chord, otherwise 'equal chords'. ValueError for
bad arguments, where a rule does not apply, and if both tangents point against the chord. Source:
docs/theory/planar.md P2.1 to P2.3.
)");
  module.def("planar_tangents", &planarTangentsOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = false, py::arg("tangents") = "linear energy",
             py::arg("variation") = 1.0, py::arg("start_direction_rad") = py::none(),
             py::arg("end_direction_rad") = py::none(),
             R"(Directions at points for biarcs between neighbours: PlanarTangents.

points: (count, 2) in mm. tangents is what they minimise: 'linear energy', the linearised bending
energy, with a weight variation >= 0 of the difference between the arcs; 'energy', the bending
energy of the biarcs; 'near circles', the sum of (alpha - beta)^2. The directions at the ends of an
open curve are free unless they are given. The time is linear in count. ValueError for fewer than 2
points (closed: 3), numbers that are not finite, equal neighbours, a reversal at a point and too
large angles, with the index. Source: docs/theory/planar.md P3.1 to P3.3.
)");
  module.def("biarc_spline", &biarcSplineOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = false, py::arg("tangents") = "linear energy",
             py::arg("variation") = 1.0, py::arg("start_direction_rad") = py::none(),
             py::arg("end_direction_rad") = py::none(), py::arg("rule") = "equal chords",
             R"(The G1 spline of two arcs between neighbouring points: a BiarcSpline.

points: (count, 2) in mm. rule: as for biarc(); the others: as for planar_tangents(). ValueError as
for both. Source: docs/theory/planar.md P2.1, P3.1 to P3.3.
)");
}

}  // namespace seamwright::python
