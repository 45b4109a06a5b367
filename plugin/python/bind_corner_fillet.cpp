// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/report/corner_json.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/reason_json.hpp>
#include <string>

namespace seamwright::python {

namespace {

struct CornerFilletResult {
  occ::CornerFillet fillet;
  occ::CornerFilletOptions options;
  int vertex = 0;
  occ::ModelFacts given;
};

/// Lengths by edge, from one number for all edges or from a dict by edge.
std::map<int, double> lengths(const char* name, const py::object& value,
                              const std::vector<int>& edges) {
  std::map<int, double> result;
  if (!py::isinstance<py::dict>(value)) {
    const auto length = argument<double>(name, value, "a number or a dict of numbers by edge");
    for (const int edge : edges) result[edge] = length;
    return result;
  }
  for (const auto& [key, item] : py::cast<py::dict>(value)) {
    const auto edge = argument<int>(name, py::reinterpret_borrow<py::object>(key),
                                    "the number of an edge as key");
    const std::string item_name = std::string(name) + "[" + std::to_string(edge) + "]";
    result[edge] =
        argument<double>(item_name.c_str(), py::reinterpret_borrow<py::object>(item), "a number");
  }
  return result;
}

/// Reports corners that are not supported, and radii and setbacks without room, as bad arguments in
/// Python. The ValueError has the attribute reason_code.
template <class Work>
auto valueErrors(const Work& work) {
  try {
    return work();
  } catch (const occ::CornerRefused& refused) {
    const py::object error = py::handle(PyExc_ValueError)(refused.what());
    error.attr("reason_code") = occ::codeOf(refused.reason().fault);
    PyErr_SetObject(PyExc_ValueError, error.ptr());
    throw py::error_already_set();
  }
}

std::vector<int> cornerEdges(const occ::Model& model, const py::object& vertex) {
  const int number = argument<int>("vertex", vertex, "the number of a vertex");
  return valueErrors([&] { return occ::cornerEdges(model, number); });
}

CornerFilletResult cornerFillet(const occ::Model& model, const py::object& vertex,
                                const py::object& radii_mm, const py::object& setbacks_mm,
                                const py::object& section_mm, const py::object& profile,
                                const py::object& gap_mm, const py::object& angle_deg,
                                const py::object& patches_only, const py::object& jobs,
                                const py::object& progress) {
  const std::vector<int> edges = cornerEdges(model, vertex);
  occ::CornerFilletOptions options;
  options.radii_mm = lengths("radii_mm", radii_mm, edges);
  if (!setbacks_mm.is_none()) options.setbacks_mm = lengths("setbacks_mm", setbacks_mm, edges);
  options.section_mm = numberOf("section_mm", section_mm);
  const py::none profiles_own;
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, profiles_own, profiles_own, profiles_own});
  options.tolerance.crease_rad =
      std::max(options.tolerance.crease_rad, options.tolerance.angle_rad);
  options.patches_only = flagOf("patches_only", patches_only);
  options.jobs = wholeNumber("jobs", jobs);
  const int number = argument<int>("vertex", vertex, "the number of a vertex");
  return valueErrors([&] {
    return longCall(progress, [&](const occ::Progress& report) {
      return CornerFilletResult{occ::cornerFillet(model, number, options, report), options, number,
                                occ::factsOf(model)};
    });
  });
}

nlohmann::ordered_json jsonOf(const CornerFilletResult& result) {
  return report::toJson(result.fillet, result.options.tolerance, result.vertex, result.given);
}

py::object cornerFilletDict(const CornerFilletResult& result) {
  return plainObject(jsonOf(result));
}

std::string toTable(const CornerFilletResult& result) {
  const report::ModelCounts memory =
      report::judgeOf(result.fillet, result.options)(result.fillet.model, {});
  return report::toTable(result.fillet, memory, std::nullopt);
}

py::object writeRounded(const CornerFilletResult& result, const py::object& path,
                        const py::object& overwrite, const py::object& overwrite_source,
                        const py::object& keep_anyway, const py::object& progress) {
  if (!result.fillet.met() && !flagOf("keep_anyway", keep_anyway))
    throw py::value_error("the corner falls short and is not written without keep_anyway=True: " +
                          result.fillet.shortfall.text);
  const report::Judge judge = report::judgeOf(result.fillet, result.options);
  const report::ModelCounts memory = [&] {
    const py::gil_scoped_release release;
    return judge(result.fillet.model, {});
  }();
  return writeResult({result.fillet.model, false, {judge, memory}},
                     {path, overwrite, overwrite_source, progress});
}

constexpr const char* corner_fillet_doc =
    R"(Rounds the edges that meet at a vertex, each with a radius of its own, and closes the
corner with G1 patches.

vertex: its number, from 1; corner_edges(vertex) names the edges, counter-clockwise seen from
outside.
radii_mm: a number for all edges, or a dict of numbers by edge, all edges of the vertex.
setbacks_mm: where the fillets end, from the vertex along the edge; a number, or a dict of some
edges; 0 and the others are chosen.
section_mm: the largest distance of the patches' sides from the cylinders between planes.
profile, gap_mm, angle_deg: what the new seams must meet, as in analyze().
patches_only: where patches fail or fall short and no setback is given, the corner is filled by
OpenCASCADE if that is better (filled_by); not with patches_only.

Returns a CornerFillet; the model is not changed. It has a model even if met is False; write()
then needs keep_anyway=True. Supported are 3 to 6 edges, convex or concave, of a solid, between
planes or curved faces that are not tangent to each other. ValueError, with numbers and a
reason_code, for others, and where there is no room.)";

/// What the corner falls short of, and what fills it.
void bindVerdict(py::class_<CornerFilletResult>& type) {
  type.def_property_readonly(
          "shortfall",
          [](const CornerFilletResult& result) { return result.fillet.shortfall.text; },
          "Which of these does not hold, with numbers; empty where met.")
      .def_property_readonly(
          "shortfall_code",
          [](const CornerFilletResult& result) {
            return occ::codeOf(result.fillet.shortfall.fault);
          },
          "Code of the shortfall: see docs/corner_fillet.md. Empty where met.")
      .def_property_readonly(
          "shortfall_facts",
          [](const CornerFilletResult& result) {
            return resultOf("ReasonFacts", plainObject(report::factsJson(result.fillet.shortfall)));
          },
          "Numbers and location of the shortfall: ReasonFacts.")
      .def_property_readonly(
          "filled_by",
          [](const CornerFilletResult& result) { return report::fillerName(result.fillet.filler); },
          "What closes the corner between the fillets: patches or opencascade.")
      .def_property_readonly(
          "patches_shortfall",
          [](const CornerFilletResult& result) { return result.fillet.patches_shortfall.text; },
          "Why patches do not fill the corner; empty where they do.");
}

void bindCornerResult(py::module_& module) {
  const std::string write_corner_doc =
      std::string(write_result_doc) +
      " ValueError for a corner that is not met, unless keep_anyway.";
  const std::string doc = std::string("The result of Model.corner_fillet().") + copies_doc;
  py::class_<CornerFilletResult> type(module, "CornerFillet", py::module_local(), doc.c_str());
  bindCopies(type);
  bindVerdict(type);
  type.def_property_readonly(
          "model", [](const CornerFilletResult& result) { return result.fillet.model; },
          "The new model.")
      .def_property_readonly(
          "met", [](const CornerFilletResult& result) { return result.fillet.met(); },
          "The solid is valid, patches are regular, the new seams meet the tolerance, proven.")
      .def_property_readonly(
          "patches", [](const CornerFilletResult& result) { return result.fillet.fill.patches; },
          "BezierPatches of the corner, as n_sided_fill() orders them; none if OpenCASCADE fills "
          "it.")
      .def("to_dict", &cornerFilletDict,
           "All but the model and the patches as a plain dict with the keys of the JSON; seams "
           "also with what they are between: spoke (two patches), section (patch and fillet), "
           "spring (patch and face), contact (fillet and face), fillets (two fillets).")
      .def(
          "to_json",
          [](const CornerFilletResult& result) { return report::toLine(jsonOf(result)); },
          "The report as one line of JSON, schema seamwright.corner/1.")
      .def(
          "to_table", [](const CornerFilletResult& result) { return readable(toTable(result)); },
          "The report as text for people.")
      .def("write", &writeRounded, write_corner_doc.c_str(), py::arg("path"), py::kw_only(),
           py::arg("overwrite") = false, py::arg("overwrite_source") = false,
           py::arg("keep_anyway") = false, py::arg("progress") = py::none())
      .def("__repr__", [](const CornerFilletResult& result) {
        return "<CornerFillet of " + std::to_string(result.fillet.edges.size()) + " edges: " +
               (result.fillet.met() ? "met" : "not met, " + result.fillet.shortfall.text) + ">";
      });
}

}  // namespace

void bindCornerFillet(py::module_& module) {
  bindCornerResult(module);
  py::class_<occ::Model> model(module.attr("Model"));
  model.def("corner_edges", &cornerEdges, py::arg("vertex"),
            "Numbers of the edges at a vertex, counter-clockwise seen from outside. ValueError as "
            "corner_fillet().");
  model.def("corner_fillet", &cornerFillet, corner_fillet_doc, py::arg("vertex"),
            py::arg("radii_mm"), py::kw_only(), py::arg("setbacks_mm") = py::none(),
            py::arg("section_mm") = 1e-6, py::arg("profile") = "default",
            py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
            py::arg("patches_only") = false, py::arg("jobs") = 0, py::arg("progress") = py::none());
}

}  // namespace seamwright::python
