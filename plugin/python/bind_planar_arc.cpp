// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/arc_fit.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/planar/sampled_chain.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

PlanarArc makeArc(const py::object& start, const py::object& direction_rad,
                  const py::object& curvature_per_mm, const py::object& length_mm) {
  const PlanarArc arc{.start = planarPointOf("start", start),
                      .direction_rad = parameter("direction_rad", direction_rad),
                      .curvature_per_mm = parameter("curvature_per_mm", curvature_per_mm),
                      .length_mm = positiveNumber("length_mm", length_mm)};
  requireTurn(arc.sweep_rad());
  return arc;
}

std::vector<int> cornersOf(const py::object& value, std::size_t arcs) {
  const std::vector<int> corners = wholeNumbers("corners", value);
  for (const int corner : corners)
    if (corner < 0 || static_cast<std::size_t>(corner) >= arcs)
      throw py::value_error("corners has the value " + std::to_string(corner) + ": the chain has " +
                            std::to_string(arcs) + " arcs");
  return corners;
}

ArcChain makeArcChain(const py::object& arcs, const py::object& closed, const py::object& corners,
                      const py::object& gap_mm) {
  const std::vector<PlanarArc> pieces = arcsOf("arcs", arcs);
  const bool around = flagOf("closed", closed);
  requireJoined("arcs", pieces, around, numberOf("gap_mm", gap_mm));
  return {pieces, around, cornersOf(corners, pieces.size())};
}

PlanarArc arcThroughOf(const py::object& start, const py::object& direction_rad,
                       const py::object& end) {
  return arcThrough(planarPointOf("start", start), parameter("direction_rad", direction_rad),
                    planarPointOf("end", end));
}

PlanarArc offsetArc(const PlanarArc& arc, const py::object& distance_mm) {
  return offset(arc, parameter("distance_mm", distance_mm));
}

ArcChain offsetChain(const ArcChain& chain, const py::object& distance_mm) {
  const double distance = parameter("distance_mm", distance_mm);
  if (distance == 0) return chain;
  const ArcFit fit{.arcs = chain.pieces(), .corners = chain.corners(), .closed = chain.closed()};
  return {offset(fit, distance), chain.closed()};
}

py::object fitArcsOf(const py::object& curve, const py::object& tolerance_mm,
                     const py::object& corner_rad, const py::object& progress) {
  const BezierSpline spline = bezierSplineOf("curve", curve);
  const ArcFitOptions options{.tolerance_mm = parameter("tolerance_mm", tolerance_mm),
                              .corner_rad = parameter("corner_rad", corner_rad)};
  const ArcFit fit =
      longCall(progress, [&](const Progress& share) { return fitArcs(spline, options, share); });
  const ArcChain chain(fit.arcs, fit.closed, fit.corners);
  py::dict dict;
  dict["chain"] = chain;
  dict["curve"] = exactSpline(chain);
  dict["distance_mm"] = fit.distance_mm;
  dict["least_arcs"] = fit.least_arcs;
  return resultOf("ArcFit", dict);
}

std::vector<Eigen::Index> pointCornersOf(const py::object& points, const py::object& closed,
                                         const py::object& corner_rad, const py::object& error_mm) {
  return pointCorners(planarPointsOf("points", points),
                      {.closed = flagOf("closed", closed),
                       .corner_rad = parameter("corner_rad", corner_rad),
                       .error_mm = parameter("error_mm", error_mm)});
}

py::object sampledArcsOf(const py::object& points, const py::object& closed,
                         const py::object& tolerance_mm) {
  const PlanarPoints rows = planarPointsOf("points", points);
  const SampledChainOptions options{.closed = flagOf("closed", closed),
                                    .tolerance_mm = positiveNumber("tolerance_mm", tolerance_mm)};
  const auto sampled = [&] {
    const py::gil_scoped_release release;
    return sampledChain(rows, options);
  }();
  if (!sampled) return py::none();
  const ArcChain chain(sampled->arcs, sampled->closed, sampled->corners);
  py::dict dict;
  dict["chain"] = chain;
  dict["curve"] = exactSpline(chain);
  dict["distance_mm"] = sampled->distance_mm;
  return resultOf("SampledArcs", dict);
}

void bindArc(py::module_& module) {
  py::class_<PlanarArc> type(module, "PlanarArc", py::module_local(),
                             R"(An arc in the plane, or a line: curvature 0.

start: (2,) in mm. direction_rad: of the tangent there, against the first axis. curvature_per_mm:
above 0 turns to the left. The parameter is the arc length s_mm, 0 .. length_mm. ValueError for
numbers that are not finite, a length that is not positive and a turn by more than 10000 rad.
Source: docs/theory/planar.md P1.1.
)");
  type.def(py::init(&makeArc), py::arg("start"), py::arg("direction_rad"),
           py::arg("curvature_per_mm"), py::arg("length_mm"))
      .def_property_readonly(
          "start", [](const PlanarArc& a) { return a.start; }, "(2,), in mm.")
      .def_property_readonly("end", &PlanarArc::end, "(2,), in mm.")
      .def_property_readonly(
          "direction_rad", [](const PlanarArc& a) { return a.direction_rad; },
          "Of the tangent at the start, against the first axis.")
      .def_property_readonly("end_direction_rad", &PlanarArc::endDirection_rad,
                             "Of the tangent at the end; direction_rad plus sweep_rad.")
      .def_property_readonly(
          "curvature_per_mm", [](const PlanarArc& a) { return a.curvature_per_mm; },
          "Above 0 it turns to the left; 0: a line.")
      .def_property_readonly(
          "length_mm", [](const PlanarArc& a) { return a.length_mm; }, "The arc length.")
      .def_property_readonly("sweep_rad", &PlanarArc::sweep_rad,
                             "The angle by which the tangent turns, above 0 to the left.")
      .def(
          "reversed", [](const PlanarArc& a) { return reversed(a); }, "The same points backwards.")
      .def("offset", &offsetArc, py::arg("distance_mm"),
           "The parallel arc at a distance to the left, below 0 to the right. ValueError if it "
           "reaches the centre.")
      .def(
          "bezier_spline", [](const PlanarArc& a) { return exactSpline(ArcChain({a}, false)); },
          R"(The same points as rational quadratics in the plane z = 0.

Source: docs/theory/planar.md P1.3. The knots are arc lengths.)")
      .def(py::pickle(
          [](const PlanarArc& a) {
            return py::make_tuple(py::make_tuple(a.start.x(), a.start.y()), a.direction_rad,
                                  a.curvature_per_mm, a.length_mm);
          },
          [](const py::tuple& state) { return makeArc(state[0], state[1], state[2], state[3]); }))
      .def("__repr__", [](const PlanarArc& a) {
        return "<PlanarArc of " + shown(py::float_(a.length_mm)) + " mm, curvature " +
               shown(py::float_(a.curvature_per_mm)) + " / mm>";
      });
  bindEvaluation(type, "s_mm");
  bindEquality(type);
}

void bindArcChain(py::module_& module) {
  py::class_<ArcChain> type(module, "ArcChain", py::module_local(),
                            R"(Arcs and lines end to end; the parameter is the arc length s_mm.

arcs: PlanarArcs, in order. closed: the end is the start. corners: indices of arcs that begin at a
corner. gap_mm: how far an arc may begin from the end of the one before. ValueError for a larger
gap, with the index; TypeError for other items.)");
  type.def(py::init(&makeArcChain), py::arg("arcs"), py::arg("closed") = false,
           py::arg("corners") = py::tuple(), py::arg("gap_mm") = 1e-9)
      .def_property_readonly(
          "arcs", [](const ArcChain& c) { return c.pieces(); }, "The PlanarArcs, in order.")
      .def_property_readonly(
          "closed", [](const ArcChain& c) { return c.closed(); }, "The end is the start.")
      .def_property_readonly(
          "corners", [](const ArcChain& c) { return c.corners(); },
          "Indices of arcs that begin at a corner.")
      .def_property_readonly(
          "length_mm", [](const ArcChain& c) { return c.length_mm(); },
          "The sum of the arc lengths.")
      .def_property_readonly(
          "energy_per_mm", [](const ArcChain& c) { return bendingEnergy_per_mm(c.pieces()); },
          "The integral of the squared curvature by arc length.")
      .def("offset", &offsetChain, py::arg("distance_mm"),
           R"(The chain at a distance to the left, below 0 to the right, exactly.

Corners on the outside become arcs around them. ValueError if the offset reaches the centre of an
arc or is on the inside of a corner, with the index. Parts that cross each other stay.)")
      .def("bezier_spline", &exactSpline,
           R"(The same points as rational quadratics in the plane z = 0.

Source: docs/theory/planar.md P1.3. The knots are arc lengths.)")
      .def("__len__", [](const ArcChain& c) { return c.pieces().size(); })
      .def(py::pickle(
          [](const ArcChain& c) { return py::make_tuple(c.pieces(), c.closed(), c.corners()); },
          [](const py::tuple& state) {
            return makeArcChain(state[0], state[1], state[2], py::float_(HUGE_VAL));
          }))
      .def("__repr__", [](const ArcChain& c) {
        return "<ArcChain of " + std::to_string(c.pieces().size()) + " arcs, " +
               shown(py::float_(c.length_mm())) + " mm" + (c.closed() ? ", closed>" : ">");
      });
  bindEvaluation(type, "s_mm");
  bindEquality(type);
}

void bindSamples(py::module_& module) {
  const PointCornerOptions corner_defaults;
  module.def("point_corners", &pointCornersOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = false, py::arg("corner_rad") = corner_defaults.corner_rad,
             py::arg("error_mm") = corner_defaults.error_mm,
             R"(The indices of points at which a sampled curve has a corner, ascending.

points: (count, 2) in mm. There the polygon turns by more than corner_rad, and five times as much as
at the nearest points before and after it that turn by less; eight times if few points lie on each
of its sides up to the next corner. error_mm: by how much points may be off. Ends of open curves do
not count. ValueError for fewer than 3 points, numbers that are not finite and equal neighbours.
)");
  const SampledChainOptions defaults;
  module.def("sampled_arcs", &sampledArcsOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = defaults.closed, py::arg("tolerance_mm") = defaults.tolerance_mm,
             R"(The fewest lines and arcs whose samples the points are: SampledArcs, or None.

points: (count, 2) in mm, of lines and arcs up to errors of 2/5 of the tolerance along each axis.
The chain is G1 between corners; these may lie between points at equal steps. No point is further
from it than distance_mm. An arc needs three points of its own, a line two. None if there is no such
chain. ValueError for numbers that are not finite and equal neighbours. Source:
docs/theory/planar.md P9.6.
)");
}

}  // namespace

void bindPlanarArc(py::module_& module) {
  bindArc(module);
  bindArcChain(module);
  bindSamples(module);
  module.def("arc_through", &arcThroughOf, py::arg("start"), py::arg("direction_rad"),
             py::arg("end"),
             R"(The PlanarArc from a point with a direction there to another point.

start, end: (2,) in mm. It turns by at most 2 pi. ValueError for numbers that are not finite and
equal points. Source: docs/theory/planar.md P1.2.
)");
  module.def(
      "fit_arcs", &fitArcsOf, py::arg("curve"), py::arg("tolerance_mm") = 0.01, py::kw_only(),
      py::arg("corner_rad") = 1e-3, py::arg("progress") = py::none(),
      R"(Arcs and lines within a tolerance of a curve of any class in the plane z = 0: an ArcFit.

The distance is proven in both directions. The chain is G1; a joint of the curve that turns by more
than corner_rad stays a corner, unless it joins sides of a polygon that a smooth curve within the
tolerance explains. A closed BezierSpline gives a closed chain. ValueError for a
tolerance or an angle that makes no sense, a pole outside of the plane, a curve that stops or turns
back (with the parameter), and a tolerance below the rounding of the curve. progress: as for
Model.analyze(). Source: docs/theory/planar.md P9.1, P9.2, P9.4, P9.5.
)");
}

}  // namespace seamwright::python
