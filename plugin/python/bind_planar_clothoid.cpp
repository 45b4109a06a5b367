// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/planar/clothoid_fit.hpp>
#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

Clothoid makeClothoid(const py::object& start, const py::object& direction_rad,
                      const py::object& curvature_per_mm, const py::object& curvature_slope_per_mm2,
                      const py::object& length_mm) {
  const Clothoid curve{
      .start = planarPointOf("start", start),
      .direction_rad = parameter("direction_rad", direction_rad),
      .curvature_per_mm = parameter("curvature_per_mm", curvature_per_mm),
      .curvature_slope_per_mm2 = parameter("curvature_slope_per_mm2", curvature_slope_per_mm2),
      .length_mm = positiveNumber("length_mm", length_mm)};
  requireTurn(std::abs(curve.curvature_per_mm * curve.length_mm) +
              std::abs(curve.curvature_slope_per_mm2) * curve.length_mm * curve.length_mm / 2);
  return curve;
}

ClothoidChain makeClothoidChain(const py::object& pieces, const py::object& closed,
                                const py::object& gap_mm) {
  const auto clothoids = piecesOf<Clothoid>("pieces", pieces, "a Clothoid");
  const bool around = flagOf("closed", closed);
  requireJoined("pieces", clothoids, around, numberOf("gap_mm", gap_mm));
  return {clothoids, around};
}

/// A chain of clothoids as quintics. Gaps were judged when the chain was made.
py::object quinticsOf(const ClothoidChain& chain, const py::object& tolerance_mm) {
  return splineWithinResult(bezierSpline(chain.pieces(), parameter("tolerance_mm", tolerance_mm),
                                         chain.closed(), HUGE_VAL));
}

Clothoid clothoidOf(const py::object& start, const py::object& start_direction_rad,
                    const py::object& end, const py::object& end_direction_rad) {
  return clothoid(hermiteEndsOf(start, start_direction_rad, end, end_direction_rad));
}

/// What holds at an end: a direction or a curvature, not both.
ClothoidEnd clothoidEndOf(const std::string& side, const py::object& direction_rad,
                          const py::object& curvature_per_mm) {
  const std::string direction = side + "_direction_rad", curvature = side + "_curvature_per_mm";
  if (!direction_rad.is_none() && !curvature_per_mm.is_none())
    throw py::value_error(direction + " is " + shown(direction_rad) + " and " + curvature + " is " +
                          shown(curvature_per_mm) + ": only one can be given");
  ClothoidEnd end;
  if (!direction_rad.is_none()) end.direction_rad = parameter(direction.c_str(), direction_rad);
  if (!curvature_per_mm.is_none())
    end.curvature_per_mm = parameter(curvature.c_str(), curvature_per_mm);
  return end;
}

py::object clothoidSplineOf(const py::object& points, const py::object& closed,
                            const py::object& start_direction_rad,
                            const py::object& end_direction_rad,
                            const py::object& start_curvature_per_mm,
                            const py::object& end_curvature_per_mm) {
  const PlanarPoints rows = planarPointsOf("points", points);
  const bool around = flagOf("closed", closed);
  for (const py::object* given :
       {&start_direction_rad, &end_direction_rad, &start_curvature_per_mm, &end_curvature_per_mm})
    if (around && !given->is_none())
      throw py::value_error("closed is True: a closed curve has no ends with " + shown(*given));
  const ClothoidSplineOptions options{
      .closed = around,
      .start = clothoidEndOf("start", start_direction_rad, start_curvature_per_mm),
      .end = clothoidEndOf("end", end_direction_rad, end_curvature_per_mm)};
  const ClothoidSpline spline = [&] {
    const py::gil_scoped_release release;
    return clothoidSpline(rows, options);
  }();
  py::dict dict;
  dict["chain"] = ClothoidChain(spline.pieces, spline.closed);
  dict["directions_rad"] = arrayOfNumbers(spline.directions_rad);
  dict["steps"] = spline.steps;
  dict["curvature_jump_per_mm"] = spline.curvature_jump_per_mm;
  return resultOf("ClothoidSpline", dict);
}

py::object fitClothoidsOf(const py::object& curve, const py::object& tolerance_mm,
                          const py::object& corner_rad, const py::object& progress) {
  const BezierSpline spline = bezierSplineOf("curve", curve);
  const ClothoidFitOptions options{.tolerance_mm = parameter("tolerance_mm", tolerance_mm),
                                   .corner_rad = parameter("corner_rad", corner_rad)};
  const ClothoidFit fit = longCall(
      progress, [&](const Progress& share) { return fitClothoids(spline, options, share); });
  py::dict dict;
  dict["chain"] = ClothoidChain(fit.pieces, fit.closed);
  dict["corners"] = py::tuple(py::cast(fit.corners));
  dict["distance_mm"] = fit.distance_mm;
  return resultOf("ClothoidFit", dict);
}

const char* const quintics_doc =
    R"(A quintic BezierSpline in the plane z = 0 with the arc length as parameter: a SplineWithin.

No point is further than distance_mm <= tolerance_mm from the point of the same arc length, up to
rounding. ValueError for a tolerance that is not positive and finite, and if more than 100000
segments would be needed. Source: docs/theory/planar.md P4.3.
)";

void bindClothoid(py::module_& module) {
  py::class_<Clothoid> type(module, "Clothoid", py::module_local(),
                            R"(A piece of a clothoid: its curvature is linear in the arc length.

start: (2,) in mm. direction_rad and curvature_per_mm: there. curvature_slope_per_mm2: change of the
curvature by arc length. The parameter is the arc length s_mm, 0 .. length_mm. ValueError for
numbers that are not finite, a length that is not positive and a turn by more than 10000 rad.
Source: docs/theory/planar.md P4.1.
)");
  type.def(py::init(&makeClothoid), py::arg("start"), py::arg("direction_rad"),
           py::arg("curvature_per_mm"), py::arg("curvature_slope_per_mm2"), py::arg("length_mm"))
      .def_property_readonly(
          "start", [](const Clothoid& c) { return c.start; }, "(2,), in mm.")
      .def_property_readonly("end", &Clothoid::end, "(2,), in mm.")
      .def_property_readonly(
          "direction_rad", [](const Clothoid& c) { return c.direction_rad; },
          "Of the tangent at the start, against the first axis.")
      .def_property_readonly(
          "end_direction_rad", [](const Clothoid& c) { return c.directionAt_rad(c.length_mm); },
          "Of the tangent at the end; turns of 2 pi count.")
      .def_property_readonly(
          "curvature_per_mm", [](const Clothoid& c) { return c.curvature_per_mm; },
          "At the start; above 0 it turns to the left.")
      .def_property_readonly(
          "end_curvature_per_mm",
          [](const Clothoid& c) { return c.curvatureAt_per_mm(c.length_mm); }, "At the end.")
      .def_property_readonly(
          "curvature_slope_per_mm2", [](const Clothoid& c) { return c.curvature_slope_per_mm2; },
          "Change of the curvature by arc length.")
      .def_property_readonly(
          "length_mm", [](const Clothoid& c) { return c.length_mm; }, "The arc length.")
      .def(
          "reversed", [](const Clothoid& c) { return reversed(c); }, "The same points backwards.")
      .def(
          "bezier_spline",
          [](const Clothoid& c, const py::object& tolerance_mm) {
            return quinticsOf(ClothoidChain({c}, false), tolerance_mm);
          },
          py::arg("tolerance_mm"), quintics_doc)
      .def(py::pickle(
          [](const Clothoid& c) {
            return py::make_tuple(py::make_tuple(c.start.x(), c.start.y()), c.direction_rad,
                                  c.curvature_per_mm, c.curvature_slope_per_mm2, c.length_mm);
          },
          [](const py::tuple& state) {
            return makeClothoid(state[0], state[1], state[2], state[3], state[4]);
          }))
      .def("__repr__", [](const Clothoid& c) {
        return "<Clothoid of " + shown(py::float_(c.length_mm)) + " mm, curvature " +
               shown(py::float_(c.curvature_per_mm)) + " to " +
               shown(py::float_(c.curvatureAt_per_mm(c.length_mm))) + " / mm>";
      });
  bindEvaluation(type, "s_mm");
  bindEquality(type);
}

void bindClothoidChain(py::module_& module) {
  py::class_<ClothoidChain> type(module, "ClothoidChain", py::module_local(),
                                 R"(Clothoids end to end; the parameter is the arc length s_mm.

pieces: Clothoids, in order. closed: the end is the start. gap_mm: how far a piece may begin from
the end of the one before. ValueError for a larger gap, with the index;
TypeError for other items.)");
  type.def(py::init(&makeClothoidChain), py::arg("pieces"), py::arg("closed") = false,
           py::arg("gap_mm") = 1e-9)
      .def_property_readonly(
          "pieces", [](const ClothoidChain& c) { return c.pieces(); }, "The Clothoids, in order.")
      .def_property_readonly(
          "closed", [](const ClothoidChain& c) { return c.closed(); }, "The end is the start.")
      .def_property_readonly(
          "length_mm", [](const ClothoidChain& c) { return c.length_mm(); },
          "The sum of the arc lengths.")
      .def("bezier_spline", &quinticsOf, py::arg("tolerance_mm"), quintics_doc)
      .def("__len__", [](const ClothoidChain& c) { return c.pieces().size(); })
      .def(py::pickle([](const ClothoidChain& c) { return py::make_tuple(c.pieces(), c.closed()); },
                      [](const py::tuple& state) {
                        return makeClothoidChain(state[0], state[1], py::float_(HUGE_VAL));
                      }))
      .def("__repr__", [](const ClothoidChain& c) {
        return "<ClothoidChain of " + std::to_string(c.pieces().size()) + " pieces, " +
               shown(py::float_(c.length_mm())) + " mm" + (c.closed() ? ", closed>" : ">");
      });
  bindEvaluation(type, "s_mm");
  bindEquality(type);
}

}  // namespace

void bindPlanarClothoid(py::module_& module) {
  bindClothoid(module);
  bindClothoidChain(module);
  module.def("clothoid", &clothoidOf, py::arg("start"), py::arg("start_direction_rad"),
             py::arg("end"), py::arg("end_direction_rad"),
             R"(The Clothoid between two points with directions.

start, end: (2,) in mm. Of all clothoids between the ends it is the one whose directions stay
nearest to that of the chord. ValueError for numbers that are not finite, equal points, and tangents
that both point against the chord so closely that it would be longer than 1e8 chords. Source:
docs/theory/planar.md P4.2; [BertolazziFrego2015].
)");
  module.def("clothoid_spline", &clothoidSplineOf, py::arg("points"), py::kw_only(),
             py::arg("closed") = false, py::arg("start_direction_rad") = py::none(),
             py::arg("end_direction_rad") = py::none(),
             py::arg("start_curvature_per_mm") = py::none(),
             py::arg("end_curvature_per_mm") = py::none(),
             R"(The G2 spline of one clothoid between neighbouring points: a ClothoidSpline.

points: (count, 2) in mm. At an open end a direction or a curvature may be given; None: curvature 0.
The curvature is continuous and linear between the points. ValueError as for planar_tangents(), and
if the steps do not converge, with the jump of curvature that is left: then points have to be
inserted. Source: docs/theory/planar.md P4.4.
)");
  module.def("fit_clothoids", &fitClothoidsOf, py::arg("curve"), py::arg("tolerance_mm") = 0.01,
             py::kw_only(), py::arg("corner_rad") = 1e-3, py::arg("progress") = py::none(),
             R"(Clothoids within a tolerance of a curve in the plane z = 0: a ClothoidFit.

The distance is proven in both directions. The chain is G2 between corners. Lines and arcs of the
curve stay lines and arcs with a clothoid between neighbours. progress: as for Model.analyze().
ValueError as for fit_arcs(). Source: docs/theory/planar.md P4.4 to P4.6.
)");
}

}  // namespace seamwright::python
