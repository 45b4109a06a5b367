// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <seamwright/occ_adapter/blend/blend_surface.hpp>
#include <seamwright/occ_adapter/blend/side_ribbon.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/report/blend_surface_json.hpp>
#include <seamwright/plugin/report/json.hpp>

namespace seamwright::python {

namespace {

/// A new face beside a model, with the tolerances that judged its seams.
struct BlendedSurface {
  occ::BlendSurfaceReport report;
  occ::Model model;
  ContinuityTolerance tolerance;
};

int orderOf(const char* name, const py::object& value) {
  const auto level = argument<std::string>(name, value, "a name");
  for (int order = 0; order <= 3; ++order)
    if (level == "G" + std::to_string(order)) return order;
  throw py::value_error(std::string(name) + " " + shown(value) + ": known are G0, G1, G2 and G3");
}

/// The arguments of one end.
struct EndArguments {
  const py::object& edges;
  const py::object& faces;
  const py::object& order;
};

occ::BlendEnd endOf(const std::string& name, const EndArguments& given) {
  return {.side = {.edges = wholeNumbersOrOne(name.c_str(), given.edges),
                   .faces = wholeNumbersOrOne((name + "_faces").c_str(), given.faces)},
          .order = orderOf((name + "_order").c_str(), given.order)};
}

/// \param order of both lateral boundaries, or a dict of orders by an edge of each.
occ::LateralChoice lateralOf(const py::object& edges, const py::object& faces,
                             const py::object& order) {
  occ::LateralChoice lateral{.edges = wholeNumbersOrOne("lateral", edges),
                             .faces = wholeNumbersOrOne("lateral_faces", faces)};
  if (!py::isinstance<py::dict>(order)) {
    lateral.order = orderOf("lateral_order", order);
    return lateral;
  }
  for (const auto& [edge, own] : order.cast<py::dict>())
    lateral.orders[wholeNumber("lateral_order", py::reinterpret_borrow<py::object>(edge))] =
        orderOf("lateral_order", py::reinterpret_borrow<py::object>(own));
  return lateral;
}

BlendedSurface withModel(occ::BlendSurfaceReport report, const ContinuityTolerance& tolerance) {
  BlendedSurface result{std::move(report), {}, tolerance};
  result.model = occ::modelFromShape(result.report.shape);
  return result;
}

BlendedSurface blendSurface(const occ::Model& model, const py::object& start, const py::object& end,
                            const py::object& start_faces, const py::object& end_faces,
                            const py::object& start_order, const py::object& end_order,
                            const py::object& start_tension, const py::object& end_tension,
                            const py::object& flip, const py::object& lateral,
                            const py::object& lateral_faces, const py::object& lateral_order,
                            const py::object& profile, const py::object& gap_mm,
                            const py::object& angle_deg, const py::object& curvature_rel,
                            const py::object& flat_radius_mm, const py::object& crease_deg,
                            const py::object& progress) {
  occ::BlendEnd first = endOf("start", {start, start_faces, start_order}),
                second = endOf("end", {end, end_faces, end_order});
  first.tension = numberOf("start_tension", start_tension);
  second.tension = numberOf("end_tension", end_tension);
  occ::BlendSurfaceOptions options;
  options.flip = flagOf("flip", flip);
  options.lateral = lateralOf(lateral, lateral_faces, lateral_order);
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  return longCall(progress, [&](const occ::Progress& report) {
    return withModel(occ::blendSurface(model.shape, first, second, options, report),
                     options.tolerance);
  });
}

BlendedSurface extendSurface(const occ::Model& model, const py::object& edges,
                             const py::object& length_mm, const py::object& to,
                             const py::object& faces, const py::object& order,
                             const py::object& profile, const py::object& gap_mm,
                             const py::object& angle_deg, const py::object& curvature_rel,
                             const py::object& flat_radius_mm, const py::object& crease_deg,
                             const py::object& progress) {
  const occ::BlendEnd side{.side = {.edges = wholeNumbersOrOne("edges", edges),
                                    .faces = wholeNumbersOrOne("faces", faces)},
                           .order = orderOf("order", order)};
  if (length_mm.is_none() == to.is_none())
    throw py::value_error("length_mm or to: exactly one of them is needed");
  const double length = length_mm.is_none() ? 0 : numberOf("length_mm", length_mm);
  const bool is_length = to.is_none();
  const int face = is_length ? 0 : wholeNumber("to", to);
  occ::BlendSurfaceOptions options;
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  return longCall(progress, [&](const occ::Progress& report) {
    return withModel(is_length ? occ::extendSurface(model.shape, side, length, options, report)
                               : occ::extendSurfaceTo(model.shape, side, face, options, report),
                     options.tolerance);
  });
}

py::list seamsOf(const std::vector<occ::BlendSeam>& seams, const ContinuityTolerance& tolerance) {
  py::list list;
  for (const occ::BlendSeam& seam : seams)
    list.append(resultOf("Seam", plainObject(report::toJson(seam.result, tolerance))));
  return list;
}

py::list seamsOf(const BlendedSurface& result) {
  return seamsOf(result.report.seams, result.tolerance);
}

py::object sideRibbon(const occ::Model& model, const py::object& edges, const py::object& depth_mm,
                      const py::object& faces, const py::object& order, const py::object& profile,
                      const py::object& gap_mm, const py::object& angle_deg,
                      const py::object& curvature_rel, const py::object& flat_radius_mm,
                      const py::object& crease_deg, const py::object& progress) {
  const occ::BlendEnd side{.side = {.edges = wholeNumbersOrOne("edges", edges),
                                    .faces = wholeNumbersOrOne("faces", faces)},
                           .order = orderOf("order", order)};
  const double depth = numberOf("depth_mm", depth_mm);
  occ::BlendSurfaceOptions options;
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  const occ::SideRibbon ribbon = longCall(progress, [&](const occ::Progress& report) {
    return occ::sideRibbon(model.shape, side, depth, options, report);
  });
  py::dict dict;
  dict["surface"] = ribbon.surface;
  dict["edge"] = "v1";
  dict["edges"] = ribbon.side.edges;
  dict["faces"] = ribbon.side.faces;
  dict["length_mm"] = ribbon.side.length_mm;
  dict["seams"] = seamsOf(ribbon.seams, options.tolerance);
  dict["reached"] = ribbon.reached;
  dict["reason"] = ribbon.side.reason;
  return resultOf("SideRibbon", dict);
}

py::dict blendDict(const BlendedSurface& result) {
  py::dict dict;
  dict["reached"] = result.report.reached;
  dict["spans"] = result.report.spans;
  dict["fold"] = plainObject(report::foldJson(result.report));
  dict["to"] = plainObject(report::extensionJson(result.report));
  dict["sides"] = plainObject(report::sidesJson(result.report));
  dict["laterals"] = plainObject(report::lateralsJson(result.report));
  py::list seams;
  for (const py::handle seam : seamsOf(result)) seams.append(seam.attr("to_dict")());
  dict["seams"] = seams;
  return dict;
}

void bindResult(py::module_& module) {
  const std::string doc =
      std::string("The result of Model.blend_surface() and Model.extend_surface().") + copies_doc;
  py::class_<BlendedSurface> type(module, "BlendedSurface", py::module_local(), doc.c_str());
  bindCopies(type);
  type.def_property_readonly(
          "reached", [](const BlendedSurface& result) { return result.report.reached; },
          "Every seam with a side certainly has the level of its end.")
      .def_property_readonly(
          "surface", [](const BlendedSurface& result) { return result.report.surface; },
          "The new surface, a BSplineSurface: u runs along the sides, v from start to end.")
      .def_property_readonly("seams", py::overload_cast<const BlendedSurface&>(&seamsOf),
                             "The Seams between the new face and the sides; the number of the new "
                             "face is 0, the others are those of the model.")
      .def_property_readonly(
          "spans", [](const BlendedSurface& result) { return result.report.spans; },
          "Spans of the surface along the sides.")
      .def_property_readonly(
          "sides",
          [](const BlendedSurface& result) {
            return plainObject(report::sidesJson(result.report));
          },
          "A dict for each side: side, edges, faces, length_mm, covered_mm by seams, target, and "
          "the reason why seams do not cover it, empty if they do.")
      .def_property_readonly(
          "laterals",
          [](const BlendedSurface& result) {
            return plainObject(report::lateralsJson(result.report));
          },
          "A dict for each given lateral boundary: edges, faces beside, length_mm, distance_mm, "
          "the largest from the boundary to the edges, covered_mm by seams with these faces, "
          "target, and the reason why it falls short, empty if it does not.")
      .def_property_readonly(
          "fold",
          [](const BlendedSurface& result) { return plainObject(report::foldJson(result.report)); },
          "Where the surface turns over, nearest to the start: distance_mm and point_mm; None if "
          "it "
          "does not.")
      .def_property_readonly(
          "to",
          [](const BlendedSurface& result) {
            return plainObject(report::extensionJson(result.report));
          },
          "Of an extension up to a face: face, least_mm and most_mm, the lengths of the lines "
          "across, and distance_mm, the largest from the new edges to the face; otherwise None.")
      .def_readonly("model", &BlendedSurface::model, "The model with the new face, its last one.")
      .def("to_dict", &blendDict, "All but surface and model as a plain dict.")
      .def("__repr__", [](const BlendedSurface& result) {
        return std::string("<BlendedSurface ") +
               (result.report.reached ? "reached" : "not reached") + ": " +
               std::to_string(result.report.surface.countU()) + " x " +
               std::to_string(result.report.surface.countV()) + " poles>";
      });
}

constexpr const char* blend_surface_doc =
    R"(Makes a surface between two sides of the model: a BlendedSurface.

start, end: an edge, or the edges of a chain, numbers from 1. Edges are free, or start_faces and
end_faces name the faces to continue. start_order, end_order: 'G0' to 'G3', how the surface joins
each side. start_tension, end_tension: how far the surface keeps its direction, as multiples of the
distance between the sides. flip: the end runs in the other direction than that in which the
surface is less twisted. lateral: the edges of one or two chains, from an end of start to an end of
end, along which the lateral boundaries run. lateral_order: 'G0', or 'G1' or 'G2' to the faces
beside them, which lateral_faces names for edges that bound two faces; a dict {edge: order} gives
each boundary its own, by one of its edges. Tolerances and progress as in analyze().
ValueError for bad arguments, with name and value. The model is not changed.)";

constexpr const char* extend_surface_doc =
    R"(Continues the surface of a side over a length, or up to a face: a BlendedSurface.

edges: an edge, or the edges of a chain, numbers from 1. to: a face that trims the extension,
instead of a length. Edges are free, or faces names the faces to
continue. order: 'G1' (ruled), 'G2' or 'G3'. Tolerances and progress as in analyze(). ValueError for
bad arguments, with name and value. The model is not changed.)";

constexpr const char* side_ribbon_doc =
    R"(A side of the model as a spline surface inside of it, for constructions from surfaces: a
SideRibbon.

edges: an edge, or the edges of a chain, numbers from 1, of trimmed or whole faces. Edges are free,
or faces names the faces beside. depth_mm: how deep the ribbon is. order: 'G1' (ruled), 'G2' or
'G3', the derivatives that it has in common with the faces at the side. Tolerances and progress as
in analyze(). ValueError for bad arguments, with name and value.)";

}  // namespace

void bindBlendSurface(py::module_& module) {
  bindResult(module);
  py::class_<occ::Model> model(module.attr("Model"));
  const py::tuple none;
  model
      .def("blend_surface", &blendSurface, blend_surface_doc, py::arg("start"), py::arg("end"),
           py::kw_only(), py::arg("start_faces") = none, py::arg("end_faces") = none,
           py::arg("start_order") = "G2", py::arg("end_order") = "G2",
           py::arg("start_tension") = 1.0, py::arg("end_tension") = 1.0, py::arg("flip") = false,
           py::arg("lateral") = none, py::arg("lateral_faces") = none,
           py::arg("lateral_order") = "G0", py::arg("profile") = "default",
           py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
           py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
           py::arg("crease_deg") = py::none(), py::arg("progress") = py::none())
      .def("side_ribbon", &sideRibbon, side_ribbon_doc, py::arg("edges"), py::arg("depth_mm"),
           py::kw_only(), py::arg("faces") = none, py::arg("order") = "G2",
           py::arg("profile") = "default", py::arg("gap_mm") = py::none(),
           py::arg("angle_deg") = py::none(), py::arg("curvature_rel") = py::none(),
           py::arg("flat_radius_mm") = py::none(), py::arg("crease_deg") = py::none(),
           py::arg("progress") = py::none())
      .def("extend_surface", &extendSurface, extend_surface_doc, py::arg("edges"),
           py::arg("length_mm") = py::none(), py::kw_only(), py::arg("to") = py::none(),
           py::arg("faces") = none, py::arg("order") = "G2", py::arg("profile") = "default",
           py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
           py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
           py::arg("crease_deg") = py::none(), py::arg("progress") = py::none());
}

}  // namespace seamwright::python
