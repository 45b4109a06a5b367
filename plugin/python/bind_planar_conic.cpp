// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/conic.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>

namespace seamwright::python {

namespace {

PlanarConic makeConic(const py::object& start, const py::object& corner, const py::object& end,
                      const py::object& weight) {
  const PlanarConic conic{.start = planarPointOf("start", start),
                          .corner = planarPointOf("corner", corner),
                          .end = planarPointOf("end", end),
                          .weight = positiveNumber("weight", weight)};
  if (conic.corner == conic.start || conic.corner == conic.end)
    throw py::value_error("corner is " + shown(corner) + ": it must differ from start and end");
  return conic;
}

const char* kindName(ConicCurvature kind) {
  switch (kind) {
    case ConicCurvature::Monotone:
      return "monotone";
    case ConicCurvature::OneMaximum:
      return "one maximum";
    case ConicCurvature::OneMinimum:
      return "one minimum";
    case ConicCurvature::MaximumAndMinimum:
      break;
  }
  return "maximum and minimum";
}

py::list conicList(const std::vector<PlanarConic>& conics) {
  return py::cast(conics);
}

py::tuple twoConicsOf(const py::object& start, const py::object& apex, const py::object& end,
                      const py::object& start_curvature_per_mm,
                      const py::object& end_curvature_per_mm, const py::object& start_share,
                      const py::object& end_share) {
  const auto [first, second] = twoConics(
      {.start = planarPointOf("start", start),
       .apex = planarPointOf("apex", apex),
       .end = planarPointOf("end", end),
       .start_curvature_per_mm = parameter("start_curvature_per_mm", start_curvature_per_mm),
       .end_curvature_per_mm = parameter("end_curvature_per_mm", end_curvature_per_mm),
       .start_share = parameter("start_share", start_share),
       .end_share = parameter("end_share", end_share)});
  return py::make_tuple(first, second);
}

py::list conicsOfArcs(const py::object& arcs) {
  return conicList(conicsOf(arcsOf("arcs", arcs)));
}

bool areArcs(const py::object& value) {
  if (py::isinstance<ArcChain>(value)) return true;
  return isSequence(value) && py::len(value) > 0 && py::isinstance<PlanarArc>(value[py::int_(0)]);
}

/// Conics of a sequence; arcs of a sequence or a chain, or of a result with one, as conics.
std::vector<PlanarConic> conicChainOf(const py::object& value) {
  const py::object conics = itemOrSelf(value, "conics");
  const py::object chain = itemOrSelf(conics, "chain");
  if (areArcs(chain)) return conicsOf(arcsOf("chain", chain));
  return piecesOf<PlanarConic>("chain", conics, "a PlanarConic");
}

/// Whether the given chain is closed, where the caller does not say it.
bool chainIsClosed(const py::object& value, const py::object& closed) {
  if (!closed.is_none()) return flagOf("closed", closed);
  const py::object chain = itemOrSelf(value, "chain");
  return py::isinstance<ArcChain>(chain) && chain.cast<const ArcChain&>().closed();
}

py::object g2ConicsOf(const py::object& chain, const py::object& closed,
                      const py::object& start_curvature_per_mm, const py::object& gap_mm,
                      const py::object& angle_rad) {
  const std::vector<PlanarConic> conics = conicChainOf(chain);
  const G2ConicOptions options{
      .closed = chainIsClosed(chain, closed),
      .start_curvature_per_mm = optionalNumber("start_curvature_per_mm", start_curvature_per_mm),
      .gap_mm = numberOf("gap_mm", gap_mm),
      .angle_rad = numberOf("angle_rad", angle_rad)};
  const G2Conics result = [&] {
    const py::gil_scoped_release release;
    return g2Conics(conics, options);
  }();
  py::dict dict;
  dict["conics"] = conicList(result.conics);
  dict["curve"] = bezierSpline(result.conics, options.closed);
  dict["g1_joints"] = result.g1_joints;
  dict["divisions"] = result.divisions;
  dict["least_weight"] = result.least_weight;
  dict["largest_weight"] = result.largest_weight;
  dict["largest_move_mm"] = result.largest_move_mm;
  return resultOf("G2Conics", dict);
}

py::tuple conicState(const PlanarConic& c) {
  const auto pair = [](const Eigen::Vector2d& v) { return py::make_tuple(v.x(), v.y()); };
  return py::make_tuple(pair(c.start), pair(c.corner), pair(c.end), c.weight);
}

PlanarConic conicFrom(const py::tuple& state) {
  return makeConic(state[0], state[1], state[2], state[3]);
}

std::string shownConic(const PlanarConic& c) {
  return "<PlanarConic of weight " + shown(py::float_(c.weight)) + " that turns by " +
         shown(py::float_(c.turn_rad())) + " rad>";
}

void bindConic(py::module_& module) {
  py::class_<PlanarConic> type(module, "PlanarConic", py::module_local(),
                               R"(A segment of a conic: the quadratic with the weights 1, weight, 1.

start, corner, end: (2,) in mm; the tangents at the ends meet at the corner. A weight below 1 gives
an ellipse, 1 a parabola, above 1 a hyperbola. The parameter is t, 0 .. 1. ValueError for numbers
that are not finite, a weight that is not positive, and a corner at an end. Source:
docs/theory/planar.md P7.1 to P7.3.
)");
  type.def(py::init(&makeConic), py::arg("start"), py::arg("corner"), py::arg("end"),
           py::arg("weight") = 1.0)
      .def_static(
          "from_arc",
          [](const py::object& arc) {
            return conicOf(objectOf<PlanarArc>("arc", arc, "a PlanarArc"));
          },
          py::arg("arc"), "The same points. ValueError for an arc that turns by pi or more.")
      .def_property_readonly(
          "start", [](const PlanarConic& c) { return c.start; }, "(2,), in mm.")
      .def_property_readonly(
          "corner", [](const PlanarConic& c) { return c.corner; }, "(2,), in mm.")
      .def_property_readonly(
          "end", [](const PlanarConic& c) { return c.end; }, "(2,), in mm.")
      .def_property_readonly(
          "weight", [](const PlanarConic& c) { return c.weight; },
          "Of the corner, beside 1 at both ends: below 1 an ellipse, 1 a parabola, above 1 a "
          "hyperbola.")
      .def_property_readonly("turn_rad", &PlanarConic::turn_rad,
                             "The angle by which the tangent turns, above 0 to the left.")
      .def_property_readonly("length_mm", &PlanarConic::length_mm,
                             R"(The arc length, enclosed to 1e-10 of it.

arc_length() of bezier_curve() states bounds. Source: docs/theory/curves.md C1.5.
)")
      .def_property_readonly(
          "curvature_kind", [](const PlanarConic& c) { return kindName(curvatureKind(c)); },
          R"(The extrema of the size of the curvature inside, up to rounding.

Source: docs/theory/planar.md P7.3. It is 'monotone', 'one maximum', 'one
minimum' or 'maximum and minimum'.)")
      .def(
          "reversed", [](const PlanarConic& c) { return reversed(c); },
          "The same points backwards.")
      .def(
          "halves",
          [](const PlanarConic& c) {
            const auto [first, second] = halves(c);
            return py::make_tuple(first, second);
          },
          "The pieces before and after t = 1/2, where the tangent has the direction of the chord.")
      .def(
          "bezier_curve", [](const PlanarConic& c) { return bezierCurve(c); },
          "The same points as a BezierCurve in the plane z = 0.")
      .def(py::pickle(&conicState, &conicFrom))
      .def("__repr__", &shownConic);
  bindEvaluation(type, "t");
  bindEquality(type);
}

}  // namespace

void bindPlanarConic(py::module_& module) {
  bindConic(module);
  module.def("two_conics", &twoConicsOf, py::arg("start"), py::arg("apex"), py::arg("end"),
             py::arg("start_curvature_per_mm"), py::arg("end_curvature_per_mm"), py::kw_only(),
             py::arg("start_share") = 0.5, py::arg("end_share") = 0.5,
             R"(The two PlanarConics between two points that join G2 and have given end curvatures.

start, apex, end: (2,) in mm; both end tangents pass through the apex. The tangent at the joint cuts
start-apex and end-apex in the shares of their lengths, seen from start and end. ValueError for
numbers that are not finite, points on a line, shares outside of (0, 1), and curvatures that have
not the sign of the turn. Source: docs/theory/planar.md P7.1; [Yang2004].
)");
  module.def("conics_of_arcs", &conicsOfArcs, py::arg("arcs"),
             R"(Arcs as PlanarConics: the same points.

arcs: PlanarArcs, an ArcChain, or a result with one. An arc that turns by 2 pi / 3 or more becomes
several conics. Source: docs/theory/planar.md P1.3.
)");
  module.def("g2_conics", &g2ConicsOf, py::arg("chain"), py::kw_only(),
             py::arg("closed") = py::none(), py::arg("start_curvature_per_mm") = py::none(),
             py::arg("gap_mm") = 1e-9, py::arg("angle_rad") = 1e-9,
             R"(A G1 chain of conics or arcs made G2: G2Conics.

chain: PlanarConics, an ArcChain, or a result with one, such as that of biarc_spline(). closed,
None: as the ArcChain, otherwise False. The joints stay where they are; their tangents are rotated
and the weights adapted. Where the turn changes its sign a joint stays G1. gap_mm and angle_rad: a
chain whose segments are further apart, or whose tangents differ more, is refused.
start_curvature_per_mm: of an open chain; None: that of the first segment. ValueError with the
joint. Source: docs/theory/planar.md P7.2; [Yang2004].
)");
}

}  // namespace seamwright::python
