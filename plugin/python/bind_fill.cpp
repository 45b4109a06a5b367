// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <optional>
#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/core/fill/ring_fill.hpp>
#include <seamwright/core/fill/three_sided_fill.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <string>

namespace seamwright::python {

namespace {

constexpr const char* side_kinds =
    "a BezierCurve, (BezierCurve, cross-boundary derivative[, bend]) or (BezierPatch, edge[, "
    "reversed]) is "
    "needed";

/// The side of a patch, from (patch, edge) or (patch, edge, reversed).
FillSide neighbourSide(const std::string& name, const py::tuple& value) {
  const bool against =
      value.size() == 3 && flagOf((name + ": reversed").c_str(), py::object(value[2]));
  return fillSide(value[0].cast<const BezierPatch&>(),
                  patchEdgeOf((name + ": edge").c_str(), value[1]), against);
}

bool isCurve(const py::handle& value) {
  return py::isinstance<BezierCurve>(value) || py::isinstance<BSplineCurve>(value) ||
         py::isinstance<BezierSpline>(value);
}

/// The side of a curve with fields, from (curve, cross[, bend]).
FillSide fieldSide(const std::string& name, const py::tuple& value) {
  FillSide side{bezierCurveOf(name, value[0]), rowsOf(name + ": cross", value[1])};
  if (value.size() == 3) side.bend = rowsOf(name + ": bend", value[2]);
  return side;
}

FillSide sideOf(const std::string& name, const py::object& value) {
  if (isCurve(value)) return {bezierCurveOf(name, value)};
  if (py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value)) {
    const py::tuple parts(value);
    const bool fits = parts.size() == 2 || parts.size() == 3;
    if (fits && py::isinstance<BezierPatch>(parts[0])) return neighbourSide(name, parts);
    if (fits && isCurve(parts[0])) return fieldSide(name, parts);
  }
  throw py::value_error(name + " is " + shown(value) + ": " + side_kinds);
}

SpokeLaw lawOf(const py::object& value) {
  const auto name = argument<std::string>("law", value, "a name");
  if (name == "linear") return SpokeLaw::Linear;
  if (name == "quadratic") return SpokeLaw::Quadratic;
  if (name == "g2") return SpokeLaw::G2;
  throw py::value_error("law is " + shown(value) + ": linear, quadratic or g2 is needed");
}

py::object ratioResult(const ConnectionFunctions& connection) {
  py::dict dict;
  dict["alpha"] = connection.alpha;
  dict["beta"] = connection.beta;
  return resultOf("G1Connection", dict);
}

py::dict cornerDict(const FillCorner& corner) {
  py::dict dict;
  dict["angle_rad"] = corner.angle_rad;
  dict["plane_angle_rad"] = corner.plane_angle_rad;
  dict["twist_defect_mm"] = corner.twist_defect_mm;
  dict["exact"] = corner.exact;
  dict["angle_bound_rad"] = corner.angle_bound_rad;
  return dict;
}

py::list cornerList(const std::vector<FillCorner>& corners) {
  py::list list;
  for (const FillCorner& corner : corners) list.append(cornerDict(corner));
  return list;
}

/// \param given  a sequence, but not as py::sequence, whose iterator releases each item before it
/// is used.
std::vector<FillSide> sidesOf(const py::object& given) {
  if (!isSequence(given))
    throw py::value_error("sides is " + shown(given) + ": a sequence is needed");
  std::vector<FillSide> sides;
  for (const py::handle side : given)
    sides.push_back(
        sideOf("side " + std::to_string(sides.size()), py::reinterpret_borrow<py::object>(side)));
  return sides;
}

py::object fillResult(const NSidedFill& fill) {
  py::list sides;
  for (const std::optional<FillSideJoin>& join : fill.sides) {
    if (join)
      sides.append(py::make_tuple(ratioResult((*join)[0]), ratioResult((*join)[1])));
    else
      sides.append(py::none());
  }
  py::dict dict;
  dict["patches"] = fill.patches;
  dict["spoke"] = ratioResult(fill.spoke);
  dict["sides"] = sides;
  dict["corners"] = cornerList(fill.corners);
  dict["fairness_mm2"] = fill.fairness_mm2;
  dict["regular"] = fill.regular;
  dict["spoke_scale"] = fill.spoke_scale;
  dict["curvature_jump_per_mm"] = fill.curvature_jump_per_mm;
  return resultOf("NSidedFill", dict);
}

py::object ringFillOf(const py::object& given, const py::object& law,
                      const py::object& fairness_order, const py::object& corner_tolerance_rad,
                      const py::object& curvature_degrees) {
  const std::vector<FillSide> sides = sidesOf(given);
  const RingFillOptions options{lawOf(law), wholeNumber("fairness_order", fairness_order),
                                numberOf("corner_tolerance_rad", corner_tolerance_rad),
                                optionalWhole("curvature_degrees", curvature_degrees)};
  const RingFill fill = [&] {
    const py::gil_scoped_release release;
    return ringFill(sides, options);
  }();
  py::dict dict;
  dict["patches"] = fill.patches;
  dict["corners"] = cornerList(fill.corners);
  dict["fairness_mm2"] = fill.fairness_mm2;
  dict["regular"] = fill.regular;
  dict["spoke_scale"] = fill.spoke_scale;
  dict["curvature_jump_per_mm"] = fill.curvature_jump_per_mm;
  dict["spoke_jump_per_mm"] = fill.spoke_jump_per_mm;
  return resultOf("RingFill", dict);
}

py::object threeSidedFillOf(const py::object& given, const py::object& fairness_order,
                            const py::object& corner_tolerance_rad) {
  const std::vector<FillSide> sides = sidesOf(given);
  const ThreeSidedFillOptions options{wholeNumber("fairness_order", fairness_order),
                                      numberOf("corner_tolerance_rad", corner_tolerance_rad)};
  const ThreeSidedFill fill = [&] {
    const py::gil_scoped_release release;
    return threeSidedFill(sides, options);
  }();
  py::list joins;
  for (const std::optional<ConnectionFunctions>& join : fill.sides)
    joins.append(join ? py::object(ratioResult(*join)) : py::none());
  py::dict dict;
  dict["triangles"] = fill.triangles;
  dict["sides"] = joins;
  dict["corners"] = cornerList(fill.corners);
  dict["fairness_mm2"] = fill.fairness_mm2;
  dict["regular"] = fill.regular;
  return resultOf("ThreeSidedFill", dict);
}

py::object nSidedFillOf(const py::object& given, const py::object& law,
                        const py::object& fairness_order, const py::object& corner_tolerance_rad,
                        const py::object& curvature_degrees) {
  const std::vector<FillSide> sides = sidesOf(given);
  FillOptions options;
  options.law = lawOf(law);
  options.fairness_order = wholeNumber("fairness_order", fairness_order);
  options.corner_tolerance_rad = numberOf("corner_tolerance_rad", corner_tolerance_rad);
  options.curvature_degrees = optionalWhole("curvature_degrees", curvature_degrees);
  const NSidedFill fill = [&] {
    const py::gil_scoped_release release;
    return nSidedFill(sides, options);
  }();
  return fillResult(fill);
}

constexpr const char* n_sided_fill_doc =
    R"(Fills a hole of 3 to 12 sides with as many patches, which meet each other and the
surroundings with G1, exactly.

sides: in order, with the hole to the left, each beginning where the one before ends. A side is
  (patch, edge[, reversed])   the patch beyond it and that patch's edge, reversed if the hole runs
                              against the edge's own sense;
  (curve, cross[, bend])      a BezierCurve and Bernstein coefficients (m, 3) of a field that spans
                              with the curve's tangent the
                              tangent planes to be met; it points out of the hole. bend, of the
                              same shape: the second derivative of
                              the surface beyond along it, for curvature;
  curve                       a BezierCurve: position alone.
law: "linear", patches of degree 4 for cubic sides; "quadratic", degree 5; or "g2", degree 6, in
which the patches meet each other with G2.
fairness_order: order 2 or 3 of the differences of poles whose sum of squares is least.
corner_tolerance_rad: largest angle, up to 0.1, between the tangent planes of two sides at their
corner, beyond rounding.
curvature_degrees: None, or a number from 0 to 6 by which the degree is raised: jumps of curvature
are made small.

Returns an NSidedFill:
  patches          BezierPatches; patch k has corner k, where side k begins, at (1, 1) and the
                   centre at (0, 0). Its edge v1 is the first
                   half of side k, u1 the second half of side k - 1; u0 and v0 are spokes, u0 that
                   of v0 of patch k + 1
  spoke            a G1Connection {alpha, beta}, Bernstein coefficients: the connection of patch k
                   + 1 to patch k
  sides            for each side None, or {alpha, beta} for both halves: the connection of the fill
                   to the neighbour
  corners          for each {angle_rad, plane_angle_rad, twist_defect_mm, exact, angle_bound_rad}.
                   exact: the tangent planes are met; else
                   the fill leaves them, on the halves of the sides next to the corner, by at most
                   the bound
  fairness_mm2     sum of the squared differences
  regular          it is proved that no normal vanishes or turns back
  spoke_scale      None, or the prescribed length of the spokes' beginnings, where fairness alone
                   gave no regular patches
  curvature_jump_per_mm  None, or the largest jump of normal curvature found at parameters along all
                         edges

ValueError, with side or corner and number, for holes that do not close, angles of pi and more,
tangent planes that contradict each other in a corner, cross-boundary derivatives parallel to
their edge, and rational sides.)";

constexpr const char* three_sided_fill_doc =
    R"(Fills a hole of three sides with three triangles around a centre, which meet each other and
the surroundings with G1, exactly.

sides: as for n_sided_fill().
fairness_order: order 2 or 3 of the derivatives whose sum of squares, over their poles, is least.
corner_tolerance_rad: as for n_sided_fill().

Returns a ThreeSidedFill:
  triangles        BezierTriangles of degree 5 for cubic sides with cubic fields; triangle k has
                   side k as edge l2, from corner k to the
                   next, and the centre as P2. Its edges l1, from the centre, and l0, to it, are
                   spokes
  sides            for each side None, or {alpha, beta}: the connection of the fill, in the
                   direction to the centre, to the neighbour
  corners          as for n_sided_fill(); neighbours need not agree about their mixed derivatives,
                   twist_defect_mm is 0
  fairness_mm2     the sum
  regular          it is proved that no normal vanishes or turns back

ValueError, with side or corner and number, as for n_sided_fill().)";

constexpr const char* ring_fill_doc =
    R"(Fills a hole of four sides, of which corners may be smooth or reflex, with five patches: a
ring of four around a fifth.

Arguments are as for n_sided_fill(), the default of fairness_order excepted. law is "linear" or
"g2", in which the patches meet each other with G2.

Returns a RingFill:
  patches          BezierPatches; patch k < 4 has side k as edge u1, spokes to corners k and k + 1
                   as v0 and v1, and as u0 an edge of
                   patch 4: v0, u1, v1 and u0, those two against their sense
  corners          for each {angle_rad, plane_angle_rad, twist_defect_mm, exact, angle_bound_rad};
                   angles are within 0 and 2 pi
  fairness_mm2, regular, curvature_jump_per_mm   as for n_sided_fill()
  spoke_scale      the length of the ends of spokes that was taken: 1 unless only others gave
                   regular patches, with law "g2" the fairest of five
  spoke_jump_per_mm  None, or with law "g2" about the largest jump of curvature that is left on
                     spokes, beside their corners: rounding if the neighbours of each corner are
                     parts of one surface

ValueError, with side or corner and number, as for n_sided_fill(), and for corners that turn by
less than 0.01 rad but more than rounding.)";

}  // namespace

void bindFill(py::module_& module) {
  module.def("n_sided_fill", &nSidedFillOf, n_sided_fill_doc, py::arg("sides"), py::kw_only(),
             py::arg("law") = "linear", py::arg("fairness_order") = 3,
             py::arg("corner_tolerance_rad") = 0.0, py::arg("curvature_degrees") = py::none());
  module.def("three_sided_fill", &threeSidedFillOf, three_sided_fill_doc, py::arg("sides"),
             py::kw_only(), py::arg("fairness_order") = 3, py::arg("corner_tolerance_rad") = 0.0);
  module.def("ring_fill", &ringFillOf, ring_fill_doc, py::arg("sides"), py::kw_only(),
             py::arg("law") = "linear", py::arg("fairness_order") = 2,
             py::arg("corner_tolerance_rad") = 0.0, py::arg("curvature_degrees") = py::none());
}

}  // namespace seamwright::python
