// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <seamwright/core/blend/frame_loft.hpp>
#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/differential/arc_length.hpp>
#include <seamwright/core/seam/bspline_side.hpp>
#include <seamwright/core/seam/patch_side.hpp>
#include <seamwright/core/seam/triangle_side.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/joint.hpp>
#include <seamwright/plugin/python/poles.hpp>
#include <seamwright/plugin/report/numbers.hpp>
#include <string>
#include <vector>

namespace seamwright::python {

namespace {

SeamSide sideOf(const char* name, const py::object& patch, const char* edge_name,
                const py::object& edge, bool reversed) {
  if (py::isinstance<BezierTriangle>(patch))
    return seamSide(py::cast<const BezierTriangle&>(patch), triangleEdgeOf(edge_name, edge),
                    reversed);
  if (py::isinstance<BezierPatch>(patch))
    return seamSide(py::cast<const BezierPatch&>(patch), patchEdgeOf(edge_name, edge), reversed);
  if (py::isinstance<BSplineSurface>(patch))
    return seamSide(py::cast<const BSplineSurface&>(patch), patchEdgeOf(edge_name, edge), reversed);
  throw py::type_error(std::string(name) + " is " + shown(patch) +
                       ": a BezierPatch, a BezierTriangle or a BSplineSurface is needed");
}

py::object figureDict(const std::optional<Figure>& figure, double factor = 1) {
  if (!figure) return py::none();
  py::dict dict;
  dict["lower"] = factor * figure->lower;
  dict["upper"] = figure->upper ? py::cast(factor * *figure->upper) : py::none();
  dict["at"] = figure->at;
  return dict;
}

py::list degenerateList(const std::vector<DegeneratePoint>& points) {
  py::list list;
  for (const DegeneratePoint& point : points) {
    py::dict entry;
    entry["at"] = point.at;
    entry["side_a"] = name(point.side_a);
    entry["side_b"] = name(point.side_b);
    list.append(std::move(entry));
  }
  return list;
}

py::list intervalList(const LeftOut& left_out) {
  py::list list;
  for (const Interval& interval : left_out.intervals) {
    py::list ends;
    ends.append(interval.lower);
    ends.append(interval.upper);
    list.append(std::move(ends));
  }
  return list;
}

py::dict leftOutDict(const SeamFigures& figures) {
  py::dict dict;
  dict["angle_deg"] = intervalList(figures.angle_left_out);
  dict["curvature_per_mm"] = intervalList(figures.curvature_left_out);
  dict["curvature_rel"] = intervalList(figures.curvature_left_out);
  return dict;
}

py::object enclosedSeam(const SeamFigures& figures, const ContinuityTolerance& tolerance,
                        const Verdict& verdict) {
  occ::SeamResult result;
  result.figures = figures;
  result.verdict = verdict;
  result.note = remarksOn(figures, tolerance);
  py::dict dict;
  dict["gap_mm"] = figureDict(figures.gap_mm);
  dict["angle_deg"] = figureDict(figures.angle_rad, degrees_per_radian);
  dict["curvature_per_mm"] = figureDict(figures.curvature_per_mm);
  dict["curvature_rel"] = figureDict(figures.curvature_rel);
  dict["curvature_change_per_mm2"] = figureDict(figures.curvature_change_per_mm2);
  dict["curvature_change_rel"] = figureDict(figures.curvature_change_rel);
  dict["left_out"] = leftOutDict(figures);
  dict["level"] = name(verdict.level);
  dict["class"] = name(verdict.seam_class);
  dict["certified"] = verdict.certain;
  dict["degenerate"] = degenerateList(figures.degenerate);
  dict["note"] = report::noteOf(result, tolerance);
  return resultOf("EnclosedSeam", dict);
}

py::object encloseSeamOf(const py::object& a, const py::object& edge_a, const py::object& b,
                         const py::object& edge_b, const py::object& reversed,
                         const py::object& level, const py::object& profile,
                         const py::object& gap_mm, const py::object& angle_deg,
                         const py::object& curvature_rel, const py::object& flat_radius_mm,
                         const py::object& crease_deg) {
  const SeamSide side_a = sideOf("patch_a", a, "edge_a", edge_a, false);
  const SeamSide side_b = sideOf("patch_b", b, "edge_b", edge_b, flagOf("reversed", reversed));
  const ContinuityTolerance tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  const Level required = levelOf(level);
  SeamFigures figures;
  {
    const py::gil_scoped_release release;
    figures = encloseSeam(side_a, side_b, tolerance, {.curvature_change = required == Level::G3});
  }
  return enclosedSeam(figures, tolerance, judge(figures, tolerance, required));
}

SurfaceDirection lineDirectionOf(const py::object& value) {
  const auto name = argument<std::string>("direction", value, "u or v");
  if (name == "u") return SurfaceDirection::U;
  if (name == "v") return SurfaceDirection::V;
  throw py::value_error("direction is " + shown(value) + ": u or v is needed");
}

py::list encloseKnotLinesOf(const py::object& given, const py::object& direction,
                            const py::object& closed, const py::object& level,
                            const py::object& profile, const py::object& gap_mm,
                            const py::object& angle_deg, const py::object& curvature_rel,
                            const py::object& flat_radius_mm, const py::object& crease_deg) {
  const auto& surface =
      objectOf<BSplineSurface>("surface", itemOrSelf(given, "surface"), "a BSplineSurface");
  const SurfaceDirection along = lineDirectionOf(direction);
  const bool around = flagOf("closed", closed);
  const ContinuityTolerance tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  const Level required = levelOf(level);
  const std::vector<KnotLine> lines = [&] {
    const py::gil_scoped_release release;
    return encloseKnotLines(surface, along, tolerance, around,
                            {.curvature_change = required == Level::G3});
  }();
  py::list list;
  for (const KnotLine& line : lines) {
    py::dict dict;
    dict["knot"] = line.knot;
    dict["seam"] = enclosedSeam(line.figures, tolerance, judge(line.figures, tolerance, required));
    list.append(resultOf("KnotLine", dict));
  }
  return list;
}

py::object measureJointOf(const py::object& a, const py::object& b, const py::object& order,
                          const py::object& profile, const py::object& gap_mm,
                          const py::object& angle_deg, const py::object& curvature_rel,
                          const py::object& flat_radius_mm) {
  const ContinuityTolerance tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, noCrease()});
  // Derivatives by arc length do not depend on the parameter, so those of the segments are enough.
  const BezierCurve last = CurveSegments(curveOf("a", a)).parts().back().curve,
                    first = CurveSegments(curveOf("b", b)).parts().front().curve;
  return jointResult(measureJoint(last, first, wholeNumber("order", order)), tolerance);
}

py::object arcLengthDerivativesOf(const py::object& derivatives, const py::object& speed_noise) {
  return py::cast(arcLengthDerivatives(rowsOf("derivatives", derivatives, "(n+1, 3)"),
                                       numberOf("speed_noise", speed_noise)));
}

}  // namespace

void bindSeam(py::module_& module) {
  module.def("enclose_seam", &encloseSeamOf, py::arg("patch_a"), py::arg("edge_a"),
             py::arg("patch_b"), py::arg("edge_b"), py::kw_only(), py::arg("reversed") = false,
             py::arg("level") = "G1", py::arg("profile") = "default",
             py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
             py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
             py::arg("crease_deg") = py::none(),
             R"(Encloses and judges the seam of two surfaces along an edge of each: an EnclosedSeam.

Edges: 'u0', 'u1', 'v0' or 'v1' of a BezierPatch or a BSplineSurface, 'l0' (from P1 to P2), 'l1' (P2
to P0) or 'l2' (P0 to P1) of a BezierTriangle. Points correspond by the parameter along the edge;
reversed: by 1 minus it on b. level and tolerances are those of Model.analyze(); the change of
curvature is enclosed for level 'G3'.
TypeError for another class of surface; ValueError for other bad arguments.)");
  module.def("enclose_knot_lines", &encloseKnotLinesOf, py::arg("surface"),
             py::arg("direction") = "u", py::kw_only(), py::arg("closed") = false,
             py::arg("level") = "G2", py::arg("profile") = "default",
             py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
             py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
             py::arg("crease_deg") = py::none(),
             R"(Encloses and judges a surface along each inner knot of a direction: KnotLines.

surface: a BSplineSurface, or a result that has one, such as a FrameLoft. direction: 'u' or 'v'.
closed: also where the end meets the beginning, as the last line. Other arguments as for
enclose_seam().)");
  module.def("arc_length_derivatives", &arcLengthDerivativesOf, py::arg("derivatives"),
             py::arg("speed_noise") = 0.0,
             "Derivatives by arc length (n+1, 3) from those by any parameter, row k of order k in "
             "mm; None where the speed is no larger than speed_noise.");
  module.def("measure_joint", &measureJointOf, py::arg("a"), py::arg("b"), py::arg("order") = 3,
             py::kw_only(), py::arg("profile") = "default", py::arg("gap_mm") = py::none(),
             py::arg("angle_deg") = py::none(), py::arg("curvature_rel") = py::none(),
             py::arg("flat_radius_mm") = py::none(),
             R"(How the end of a meets the beginning of b, curves of any class, to that order: a
CurveJoint.

The tolerances, as in Model.analyze(), decide about order_reached alone. TypeError for anything
but a curve; ValueError for a negative order and bad tolerances.)");
}

}  // namespace seamwright::python
