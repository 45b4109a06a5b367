// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/planar/spiral.hpp>
#include <seamwright/core/planar/spiral_ends.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

LogSpiral makeLogSpiral(const py::object& start, const py::object& direction_rad,
                        const py::object& radius_mm, const py::object& growth,
                        const py::object& turn_rad) {
  const LogSpiral spiral{.start = planarPointOf("start", start),
                         .direction_rad = parameter("direction_rad", direction_rad),
                         .radius_mm = parameter("radius_mm", radius_mm),
                         .growth = parameter("growth", growth),
                         .turn_rad = positiveNumber("turn_rad", turn_rad)};
  requireTurn(spiral.turn_rad);
  const double last_mm = spiral.radiusAt_mm(spiral.turn_rad);
  if (spiral.radius_mm == 0 || last_mm == 0 || !std::isfinite(last_mm))
    throw py::value_error("radius_mm is " + shown(radius_mm) + ", and " +
                          shown(py::float_(last_mm)) +
                          " at the end: it must be finite and must not be 0");
  return spiral;
}

LogSpiral logSpiralOf(const py::object& start, const py::object& start_direction_rad,
                      const py::object& end, const py::object& end_direction_rad) {
  return logSpiral(hermiteEndsOf(start, start_direction_rad, end, end_direction_rad));
}

/// A choice that bounds the memory of a chain: an arc has 40 bytes.
constexpr int most_arcs = 1'000'000;

int arcCount(const py::object& value) {
  const int count = wholeNumber("count", value);
  if (count > most_arcs)
    throw py::value_error("count is " + std::to_string(count) + ": at most " +
                          std::to_string(most_arcs) + " is possible");
  return count;
}

ArcChain eulerArcsOf(const py::object& start, const py::object& start_direction_rad,
                     const py::object& end, const py::object& end_direction_rad,
                     const py::object& count) {
  return {
      eulerArcs(hermiteEndsOf(start, start_direction_rad, end, end_direction_rad), arcCount(count)),
      false};
}

ArcChain logArcsOf(const py::object& start, const py::object& start_direction_rad,
                   const py::object& end, const py::object& end_direction_rad,
                   const py::object& count) {
  const HermiteEnds ends = hermiteEndsOf(start, start_direction_rad, end, end_direction_rad);
  return {logArcs(ends, count.is_none() ? leastLogArcs(ends) : arcCount(count)), false};
}

const char* spiralKindName(SpiralKind kind) {
  switch (kind) {
    case SpiralKind::Undecided:
      return "undecided";
    case SpiralKind::Nothing:
      return "nothing";
    case SpiralKind::Arc:
      return "arc";
    case SpiralKind::Biarc:
      return "biarc";
    case SpiralKind::Rising:
      return "rising";
    case SpiralKind::Falling:
      break;
  }
  return "falling";
}

py::object signedFigureResult(const SignedFigure& figure) {
  py::dict dict;
  dict["value"] = figure.value;
  dict["rounding"] = figure.rounding;
  dict["sign"] = figure.sign();
  return resultOf("SignedFigure", dict);
}

py::object spiralCertificateOf(const py::object& start, const py::object& start_direction_rad,
                               const py::object& start_curvature_per_mm, const py::object& end,
                               const py::object& end_direction_rad,
                               const py::object& end_curvature_per_mm) {
  const SpiralCertificate found = spiralCertificate(
      {.ends = hermiteEndsOf(start, start_direction_rad, end, end_direction_rad),
       .start_curvature_per_mm = parameter("start_curvature_per_mm", start_curvature_per_mm),
       .end_curvature_per_mm = parameter("end_curvature_per_mm", end_curvature_per_mm)});
  py::dict dict;
  dict["kind"] = spiralKindName(found.kind);
  dict["start_angle_rad"] = found.start_angle_rad;
  dict["end_angle_rad"] = found.end_angle_rad;
  dict["turn_rad"] = signedFigureResult(found.turn_rad);
  dict["start_excess"] = signedFigureResult(found.start_excess);
  dict["end_excess"] = signedFigureResult(found.end_excess);
  dict["separation"] = signedFigureResult(found.separation);
  return resultOf("SpiralCertificate", dict);
}

py::tuple bilensOf(const py::object& start, const py::object& start_direction_rad,
                   const py::object& end, const py::object& end_direction_rad) {
  const Interval bounds =
      bilens_rad(hermiteEndsOf(start, start_direction_rad, end, end_direction_rad));
  return py::make_tuple(bounds.lower, bounds.upper);
}

py::object turnThroughOf(const py::object& start, const py::object& end, const py::object& points) {
  // The turn depends on the positions of the ends alone.
  const HermiteEnds ends{.start = planarPointOf("start", start), .end = planarPointOf("end", end)};
  const Array given = arrayOf("points", points);
  if (given.ndim() == 1) return py::float_(turnThrough_rad(ends, planarPointOf("points", points)));
  const PlanarPoints rows = planarPointsOf("points", points);
  Eigen::VectorXd turns(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) turns(i) = turnThrough_rad(ends, rows.row(i));
  return py::cast(turns);
}

void bindSpiralEnds(py::module_& module) {
  module.def("spiral_certificate", &spiralCertificateOf, py::arg("start"),
             py::arg("start_direction_rad"), py::arg("start_curvature_per_mm"), py::arg("end"),
             py::arg("end_direction_rad"), py::arg("end_curvature_per_mm"),
             R"(Which spirals, curves of monotone curvature, join two ends: a SpiralCertificate.

start, end: (2,) in mm. Curvatures above 0 turn to the left. It is about short spirals, whose
tangents are nowhere opposite to the chord. The signs of Vogt and Kneser decide, and each states its
rounding. ValueError for numbers that are not finite and equal points. Source: docs/theory/planar.md
P8.4, P8.5; [Kurnosenko2010].
)");
  module.def("bilens_rad", &bilensOf, py::arg("start"), py::arg("start_direction_rad"),
             py::arg("end"), py::arg("end_direction_rad"),
             R"(The turns through points of short spirals between two ends: (lower, upper).

start, end: (2,) in mm. Every point of a short spiral has a turn_through_rad() between them.
ValueError for numbers that are not finite and equal points. Source: docs/theory/planar.md P8.6.
)");
  module.def(
      "turn_through_rad", &turnThroughOf, py::arg("start"), py::arg("end"), py::arg("points"),
      R"(The turn from the direction start to point to the direction point to end, in [-pi, pi].

start, end: (2,) in mm. points: one, (2,), or (count, 2) for an array. It is half of the turn of the
arc through the three points. ValueError for numbers that are not finite, equal ends, and a point
that is an end. Source: docs/theory/planar.md P8.6.
)");
}

void bindLogSpiral(py::module_& module) {
  py::class_<LogSpiral> type(module, "LogSpiral", py::module_local(),
                             R"(A piece of a logarithmic spiral.

start: (2,) in mm. direction_rad: of the tangent there. The radius of curvature is radius_mm times
exp(growth u) after the tangent has turned by u; radius_mm above 0 turns to the left. The parameter
is the turn u_rad, 0 .. turn_rad. ValueError for numbers that are not finite, a radius of 0, and a
turn that is not in (0, 10000]. Source: docs/theory/planar.md P6.1.
)");
  type.def(py::init(&makeLogSpiral), py::arg("start"), py::arg("direction_rad"),
           py::arg("radius_mm"), py::arg("growth"), py::arg("turn_rad"))
      .def_property_readonly(
          "start", [](const LogSpiral& s) { return s.start; }, "(2,), in mm.")
      .def_property_readonly("end", &LogSpiral::end, "(2,), in mm.")
      .def_property_readonly("pole", &LogSpiral::pole,
                             "(2,), in mm: the point around which it turns.")
      .def_property_readonly(
          "direction_rad", [](const LogSpiral& s) { return s.direction_rad; },
          "Of the tangent at the start, against the first axis.")
      .def_property_readonly(
          "end_direction_rad", [](const LogSpiral& s) { return s.directionAt_rad(s.turn_rad); },
          "Of the tangent at the end; turns of 2 pi count.")
      .def_property_readonly(
          "radius_mm", [](const LogSpiral& s) { return s.radius_mm; },
          "The radius of curvature at the start; above 0 it turns to the left.")
      .def_property_readonly(
          "growth", [](const LogSpiral& s) { return s.growth; },
          "Change of the logarithm of the radius, per radian.")
      .def_property_readonly(
          "turn_rad", [](const LogSpiral& s) { return s.turn_rad; },
          "The angle by which the tangent turns, above 0 in either sense.")
      .def_property_readonly("length_mm", &LogSpiral::length_mm, "The arc length.")
      .def(
          "bezier_spline",
          [](const LogSpiral& s, const py::object& tolerance_mm) {
            return splineWithinResult(bezierSpline(s, parameter("tolerance_mm", tolerance_mm)));
          },
          py::arg("tolerance_mm"),
          R"(A quintic BezierSpline in the plane z = 0 with the turn as parameter: a SplineWithin.

No point is further than distance_mm <= tolerance_mm from the point of the same turn, up to
rounding. ValueError for a tolerance that is not positive and finite, and if more than 100000
segments would be needed. Source: docs/theory/planar.md P6.4.
)")
      .def(py::pickle(
          [](const LogSpiral& s) {
            return py::make_tuple(py::make_tuple(s.start.x(), s.start.y()), s.direction_rad,
                                  s.radius_mm, s.growth, s.turn_rad);
          },
          [](const py::tuple& state) {
            return makeLogSpiral(state[0], state[1], state[2], state[3], state[4]);
          }))
      .def("__repr__", [](const LogSpiral& s) {
        return "<LogSpiral that turns by " + shown(py::float_(s.turn_rad)) + " rad, radius " +
               shown(py::float_(s.radius_mm)) + " to " +
               shown(py::float_(s.radiusAt_mm(s.turn_rad))) + " mm>";
      });
  bindEvaluation(type, "u_rad");
  bindEquality(type);
}

}  // namespace

void bindPlanarSpiral(py::module_& module) {
  bindLogSpiral(module);
  bindSpiralEnds(module);
  module.def("log_spiral", &logSpiralOf, py::arg("start"), py::arg("start_direction_rad"),
             py::arg("end"), py::arg("end_direction_rad"),
             R"(The LogSpiral between two points with directions that form a C-shape.

start, end: (2,) in mm. ValueError for numbers that are not finite, equal points, tangents on both
sides of the chord, a turn above pi, and radii that differ by more than the factor 1e12, as at the
angles 0.01 and 1.5 against the chord. Source: docs/theory/planar.md P6.2; [Yang2014].
)");
  module.def("euler_arcs", &eulerArcsOf, py::arg("start"), py::arg("start_direction_rad"),
             py::arg("end"), py::arg("end_direction_rad"), py::arg("count"),
             R"(Arcs of one length whose curvatures are an arithmetic progression: an ArcChain, G1.

start, end: (2,) in mm. count: of the arcs, at least 2; 1 for ends on a circle. For many arcs the
chain approaches the clothoid of the ends, with an error of order 1 / count^2. ValueError where no
such arcs exist near the clothoid, and as for clothoid(). Source: docs/theory/planar.md P5.1.
)");
  module.def("log_arcs", &logArcsOf, py::arg("start"), py::arg("start_direction_rad"),
             py::arg("end"), py::arg("end_direction_rad"), py::arg("count") = py::none(),
             R"(Arcs of one sweep whose radii are a geometric progression: an ArcChain, G1.

start, end: (2,) in mm, with directions of a C-shape. count: of the arcs; None: the fewest possible.
ValueError for fewer, with the least number, and as for log_spiral(). Source: docs/theory/planar.md
P6.3; [Yang2014].
)");
}

}  // namespace seamwright::python
