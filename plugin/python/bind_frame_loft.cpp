// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <seamwright/core/blend/frame_sheet.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/blend.hpp>
#include <seamwright/plugin/python/curves.hpp>
#include <seamwright/plugin/python/edges.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/planar.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/python/surfaces.hpp>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::python {

namespace {

constexpr NamedValue<SheetSide> sheet_sides[] = {{"start", SheetSide::Start},
                                                 {"end", SheetSide::End}};

/// Frames and their range.
struct GivenFrames {
  FrameFunction frame;
  Interval omegas;
  std::optional<KeyedSplineBlend> blend;  ///< if the frames are those of one
};

/// A Python callable as frames, to be called without the GIL.
FrameFunction calledFrames(const py::object& callable) {
  return [callable](double omega) {
    const py::gil_scoped_acquire acquire;
    return bezierSplineOf("the frame at omega " + std::string(py::repr(py::float_(omega))),
                          callable(omega));
  };
}

GivenFrames givenFrames(const py::object& frames, const py::object& omegas) {
  GivenFrames given;
  if (py::isinstance<KeyedSplineBlend>(frames)) {
    given.blend = frames.cast<const KeyedSplineBlend&>();
    given.frame = [blend = given.blend->blend](double omega) {
      return blend.frameAt(omega).spline;
    };
    given.omegas = {given.blend->omegas.front(), given.blend->omegas.back()};
  } else if (PyCallable_Check(frames.ptr()) != 0) {
    given.frame = calledFrames(frames);
  } else {
    throw py::type_error("frames is " + shown(frames) +
                         ": a SplineBlend or a callable that returns the curve at omega is needed");
  }
  if (omegas.is_none() && given.blend) return given;
  const auto range = listOf("omegas", omegas);
  if (range.size() != 2)
    throw py::value_error("omegas is " + shown(omegas) + ": two numbers are needed");
  given.omegas = {range[0], range[1]};
  return given;
}

std::vector<double> inside(const std::vector<double>& values, const Interval& range) {
  std::vector<double> result;
  for (const double value : values)
    if (value > range.lower && value < range.upper) result.push_back(value);
  return result;
}

/// The inner keys of a blend, or nothing.
std::vector<double> innerKeys(const GivenFrames& given) {
  if (!given.blend) return {};
  return inside(given.blend->omegas, given.omegas);
}

/// Where frames of a blend have kinks by omega: at the inner keys of C0.
std::vector<double> innerKinks(const GivenFrames& given) {
  const bool has_kinks =
      given.blend && given.blend->options.continuity == KeyInterpolation::Continuity::C0;
  return has_kinks ? innerKeys(given) : std::vector<double>{};
}

std::optional<FrameDerivativeBound> derivativeBoundOf(const py::object& value) {
  if (value.is_none()) return std::nullopt;
  if (!py::isinstance<py::tuple>(value) || py::len(value) != 2)
    throw py::value_error("derivative_bound is " + shown(value) +
                          ": a pair (order, size) is needed");
  const auto pair = py::reinterpret_borrow<py::tuple>(value);
  return FrameDerivativeBound{wholeNumber("derivative_bound[0]", pair[0]),
                              numberOf("derivative_bound[1]", pair[1])};
}

/// The keywords of FrameLoftOptions.
struct LoftArguments {
  const py::object& order;
  const py::object& tolerance_mm;
  const py::object& stations;
  const py::object& kinks;
  const py::object& first_spans;
  const py::object& max_spans;
  const py::object& checks;
  const py::object& derivative_bound;

  FrameLoftOptions options(const GivenFrames& given) const {
    FrameLoftOptions result;
    result.order = wholeNumber("order", order);
    if (given.blend) result.joint_orders = given.blend->blend.orders();
    for (int& joint_order : result.joint_orders) joint_order = std::min(joint_order, result.order);
    result.tolerance_mm = numberOf("tolerance_mm", tolerance_mm);
    result.stations = stations.is_none() ? innerKeys(given) : listOf("stations", stations);
    result.kinks = kinks.is_none() ? innerKinks(given) : listOf("kinks", kinks);
    result.first_spans = wholeNumber("first_spans", first_spans);
    result.max_spans = wholeNumber("max_spans", max_spans);
    result.checks = wholeNumber("checks", checks);
    result.derivative_bound = derivativeBoundOf(derivative_bound);
    return result;
  }
};

py::object frameLoftResult(const FrameLoft& loft) {
  py::dict dict;
  dict["surface"] = loft.surface;
  dict["smooth_frames"] = loft.smooth_frames;
  dict["spans"] = loft.spans;
  dict["frames"] = loft.frames;
  dict["distance_mm"] = loft.distance_mm;
  dict["distance_at"] = loft.distance_at;
  dict["proven_mm"] = loft.proven_mm;
  dict["reached"] = loft.reached;
  dict["ratios_positive"] = loft.ratios_positive;
  return resultOf("FrameLoft", dict);
}

py::object frameLoftOf(const py::object& frames, const py::object& omegas, const py::object& order,
                       const py::object& tolerance_mm, const py::object& stations,
                       const py::object& kinks, const py::object& closed,
                       const py::object& first_spans, const py::object& max_spans,
                       const py::object& checks, const py::object& derivative_bound,
                       const py::object& progress) {
  const GivenFrames given = givenFrames(frames, omegas);
  FrameLoftOptions options = LoftArguments{order,       tolerance_mm, stations, kinks,
                                           first_spans, max_spans,    checks,   derivative_bound}
                                 .options(given);
  options.closed = flagOf("closed", closed);
  return frameLoftResult(longCall(progress, [&](const Progress& share) {
    options.progress = share;
    return frameLoft(given.frame, given.omegas, options);
  }));
}

py::object edgeRibbonOf(const py::object& surface, const py::object& edge, const py::object& side,
                        const py::object& rate, const py::object& reversed,
                        const py::object& closed) {
  const FrameRibbon ribbon = edgeRibbon(splineSurfaceOf("surface", itemOrSelf(surface, "surface")),
                                        patchEdgeOf("edge", edge), flagOf("reversed", reversed),
                                        choiceOf("side", side, sheet_sides), numberOf("rate", rate),
                                        flagOf("closed", closed));
  py::dict dict;
  dict["position"] = ribbon.position;
  dict["first"] = ribbon.first;
  dict["second"] = ribbon.second;
  return resultOf("FrameRibbon", dict);
}

FrameRibbon ribbonOf(const std::string& name, const py::object& value) {
  const auto part = [&](const char* key) {
    if (!py::isinstance<py::dict>(value) || !value.contains(key))
      throw py::type_error(name + " is " + shown(value) +
                           ": a FrameRibbon, with position, first and second, is needed");
    return bezierSplineOf(name + "." + key, value[key]);
  };
  return {part("position"), part("first"), part("second")};
}

/// A ribbon, or a pair of a ribbon and an order.
std::optional<SheetEnd> sheetEndOf(const std::string& name, const py::object& value) {
  if (value.is_none()) return std::nullopt;
  if (!py::isinstance<py::tuple>(value)) return SheetEnd{ribbonOf(name, value), 2};
  const auto pair = py::reinterpret_borrow<py::tuple>(value);
  if (pair.size() != 2)
    throw py::value_error(name + " is " + shown(value) +
                          ": a FrameRibbon, or a pair of it and an order, is needed");
  const std::string order = name + "[1]";
  return SheetEnd{ribbonOf(name + "[0]", pair[0]), wholeNumber(order.c_str(), pair[1])};
}

py::object frameSheetOf(const py::object& frames, const py::object& omegas, const py::object& start,
                        const py::object& end, const py::object& order,
                        const py::object& tolerance_mm, const py::object& stations,
                        const py::object& kinks, const py::object& first_spans,
                        const py::object& max_spans, const py::object& checks,
                        const py::object& derivative_bound, const py::object& progress) {
  const GivenFrames given = givenFrames(frames, omegas);
  FrameLoftOptions options = LoftArguments{order,       tolerance_mm, stations, kinks,
                                           first_spans, max_spans,    checks,   derivative_bound}
                                 .options(given);
  const auto first = sheetEndOf("start", start), last = sheetEndOf("end", end);
  return frameLoftResult(longCall(progress, [&](const Progress& share) {
    options.progress = share;
    return frameSheet(given.frame, given.omegas, first, last, options);
  }));
}

double evenRateOf(const py::object& frames, const py::object& omegas, const py::object& ribbon,
                  const py::object& side, const py::object& share) {
  const GivenFrames given = givenFrames(frames, omegas);
  const FrameRibbon neighbour = ribbonOf("ribbon", ribbon);
  const SheetSide at = choiceOf("side", side, sheet_sides);
  const double outermost = numberOf("share", share);
  const py::gil_scoped_release release;
  return evenRate(given.frame, given.omegas, neighbour, at, outermost);
}

void bindSheets(py::module_& module) {
  module.def("edge_ribbon", &edgeRibbonOf, py::arg("surface"), py::arg("edge"), py::arg("side"),
             py::arg("rate") = 1.0, py::kw_only(), py::arg("reversed") = false,
             py::arg("closed") = false,
             R"(How a sheet continues a surface beyond an edge: a FrameRibbon.

surface: a BezierPatch or a BSplineSurface without weights. edge: 'u0', 'u1', 'v0' or 'v1'. side:
'start', the sheet leaves the surface; 'end', it arrives. rate: the parameter across the edge by
omega. reversed: the ribbon runs against the edge. closed: the edge is a closed curve.)");
  module.def("frame_sheet", &frameSheetOf, py::arg("frames"), py::arg("omegas") = py::none(),
             py::kw_only(), py::arg("start") = py::none(), py::arg("end") = py::none(),
             py::arg("order") = 2, py::arg("tolerance_mm") = 1e-3, py::arg("stations") = py::none(),
             py::arg("kinks") = py::none(), py::arg("first_spans") = 4, py::arg("max_spans") = 256,
             py::arg("checks") = 4, py::arg("derivative_bound") = py::none(),
             py::arg("progress") = py::none(),
             R"(The surface through frames that meets neighbours at its ends: a FrameLoft.

start, end: a FrameRibbon, or a pair of it and the order, 0 to 2, to which the sheet meets it; None:
a free end, of which there is one at most. Other arguments as for frame_loft().)");
  module.def("even_rate", &evenRateOf, py::arg("frames"), py::arg("omegas"), py::arg("ribbon"),
             py::arg("side"), py::arg("share") = 0.125,
             R"(The rate for edge_ribbon() at which frames leave or reach their end evenly.

ribbon: a FrameRibbon of rate 1. share: of omega at that end, over which the movement of the poles
is averaged. Other arguments as for frame_loft() and edge_ribbon().)");
}

}  // namespace

void bindFrameLoft(py::module_& module) {
  module.def("frame_loft", &frameLoftOf, py::arg("frames"), py::arg("omegas") = py::none(),
             py::kw_only(), py::arg("order") = 2, py::arg("tolerance_mm") = 1e-3,
             py::arg("stations") = py::none(), py::arg("kinks") = py::none(),
             py::arg("closed") = false, py::arg("first_spans") = 4, py::arg("max_spans") = 256,
             py::arg("checks") = 4, py::arg("derivative_bound") = py::none(),
             py::arg("progress") = py::none(),
             R"(The surface through frames, G^order across the lines of joints: a FrameLoft.

Across a joint that a SplineBlend keeps at a lower order, it has that order.
frames: a SplineBlend, or a callable that returns the curve at omega; all have the same degree and
number of segments. omegas: the range (first, last); None: that of the SplineBlend. Spans are halved
while a frame is farther than tolerance_mm from its iso-curve, up to max_spans. stations: omegas at
which the iso-curve is the frame; kinks: across which frames are continuous only; None: the inner
keys of the SplineBlend, and its kinks. closed: the last frame is the first one. checks: frames that
are compared in a span. derivative_bound: (k, size of the k-th derivative of poles by omega), by
which the distance is proven. progress: as for Model.analyze(). ValueError, with index and value,
for bad arguments and frames that differ in structure.)");
  bindSheets(module);
}

}  // namespace seamwright::python
