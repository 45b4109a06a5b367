// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/repair_json.hpp>
#include <seamwright/plugin/report/repair_table.hpp>

namespace seamwright::python {

namespace {

/// The result of a repair, with the given model and the options.
struct RepairReport {
  occ::Model given;
  occ::RepairReport report;
  occ::RepairOptions options;
};

/// Edges by their numbers. An empty list means all defects in the options, so an empty sequence is
/// refused and only None selects all defects.
std::vector<int> edgesOf(const py::object& edges) {
  if (edges.is_none()) return {};
  std::vector<int> numbers = wholeNumbers("edges", edges);
  if (numbers.empty())
    throw py::value_error("edges is " + shown(edges) +
                          ": name one at least, or None for all defects");
  return numbers;
}

/// None gives infinity (any distance); "auto" gives nothing (by the sizes of faces).
std::optional<double> maxMoveOf(const py::object& max_move_mm) {
  if (max_move_mm.is_none()) return std::numeric_limits<double>::infinity();
  if (py::isinstance<py::str>(max_move_mm) && max_move_mm.cast<std::string>() == "auto") return {};
  return argument<double>("max_move_mm", max_move_mm, "a number, None or 'auto'");
}

RepairReport repairModel(const occ::Model& model, const py::object& target,
                         const py::object& profile, const py::object& gap_mm,
                         const py::object& angle_deg, const py::object& curvature_rel,
                         const py::object& flat_radius_mm, const py::object& crease_deg,
                         const py::object& max_move_mm, const py::object& fairness,
                         const py::object& keep_curvature, const py::object& max_time_s,
                         const py::object& edges, const py::object& fixed_faces,
                         const py::object& match_mm, const py::object& sew,
                         const py::object& convert_analytic, const py::object& jobs,
                         const py::object& progress) {
  occ::RepairOptions options;
  options.order = targetOrder(target);
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  options.max_move_mm = maxMoveOf(max_move_mm);
  options.fairness = numberOf("fairness", fairness);
  options.keep_curvature = flagOf("keep_curvature", keep_curvature);
  options.max_time_s = optionalNumber("max_time_s", max_time_s).value_or(options.max_time_s);
  options.edges = edgesOf(edges);
  options.fixed_faces = wholeNumbers("fixed_faces", fixed_faces);
  options.match_mm = optionalNumber("match_mm", match_mm).value_or(options.match_mm);
  options.sew = flagOf("sew", sew);
  options.convert_analytic = flagOf("convert_analytic", convert_analytic);
  options.jobs = wholeNumber("jobs", jobs);
  return longCall(progress, [&](const occ::Progress& report) {
    return RepairReport{model, occ::repair(model, options, report), options};
  });
}

py::object repairDict(const RepairReport& repair) {
  return plainObject(report::toJson(repair.report, repair.options));
}

py::object writeRepaired(const RepairReport& repair, const py::object& path,
                         const py::object& overwrite, const py::object& overwrite_source,
                         const py::object& progress) {
  const ResultToWrite result{
      repair.report.model,
      !repair.report.changed(),
      {report::judgeOf(repair.report, repair.options),
       report::countsOf(repair.report.after, repair.report.model), &repair.given}};
  return writeResult(result, {path, overwrite, overwrite_source, progress});
}

std::string shortly(const RepairReport& repair) {
  const report::RepairSummary summary = report::summarize(repair.report);
  return "<RepairReport: " + std::to_string(summary.repaired) + " of " +
         std::to_string(summary.treated) + " seams repaired, " +
         std::to_string(summary.defects_after) + " defects left>";
}

/// A property that reads a list of the JSON.
auto listed(const char* type, const char* key) {
  return [=](const RepairReport& repair) { return resultsOf(type, repairDict(repair)[key]); };
}

using ReportClass = py::class_<RepairReport>;

void bindOutcome(ReportClass& type) {
  type.def_property_readonly(
          "model", [](const RepairReport& repair) { return repair.report.model; },
          "The repaired model: same faces, edges and solids, in the same order unless edges were "
          "sewn.")
      .def_property_readonly(
          "before", [](const RepairReport& repair) { return repair.report.before; },
          "The Report of the model as it was.")
      .def_property_readonly(
          "after", [](const RepairReport& repair) { return repair.report.after; },
          "The Report of the repaired model.")
      .def_property_readonly(
          "changed", [](const RepairReport& repair) { return repair.report.changed(); },
          "Some face moved, or edges were sewn.")
      .def_property_readonly(
          "passed", [](const RepairReport& repair) { return repair.report.after.passed(); },
          "No seam is a defect any more.");
}

void bindDetails(ReportClass& type) {
  type.def_property_readonly("seams", listed("SeamRepair", "seams"), "All seams: SeamRepairs.")
      .def_property_readonly("moves", listed("FaceMove", "moves"),
                             "The faces that moved: FaceMoves; surface tells what became of the "
                             "face's curvature.")
      .def_property_readonly("edge_moves", listed("EdgeMove", "edge_moves"),
                             "Edges that got new pcurves on faces that stay: EdgeMoves.")
      .def_property_readonly("converted", listed("FaceConversion", "converted"),
                             "Faces that became splines: FaceConversions.")
      .def_property_readonly(
          "summary",
          [](const RepairReport& repair) {
            return resultOf("RepairSummary",
                            plainObject(report::toJson(report::summarize(repair.report))));
          },
          "The counts: a RepairSummary.");
}

void bindTexts(ReportClass& type) {
  type.def("to_dict", &repairDict, "All but the model as a plain dict with the keys of the JSON.")
      .def(
          "to_json",
          [](const RepairReport& repair) {
            return report::toLine(report::toJson(repair.report, repair.options));
          },
          "The report as one line of JSON, schema seamwright.repair/1.")
      .def(
          "to_table",
          [](const RepairReport& repair) { return readable(report::toTable(repair.report)); },
          "The report as text for people.")
      .def("write", &writeRepaired, write_result_doc, py::arg("path"), py::kw_only(),
           py::arg("overwrite") = false, py::arg("overwrite_source") = false,
           py::arg("progress") = py::none())
      .def("__repr__", &shortly);
}

constexpr const char* repair_doc =
    R"(Moves spline faces, with the least bending, until the seams chosen are smooth: a
RepairReport.

Proves it, or leaves them as they were. The model is not changed.

target: 'G1' or 'G2'. Tolerances, jobs and progress as in analyze(). max_move_mm: no point of a
face moves further; None: any distance; 'auto': a hundredth of the size of the face and twice the
largest gap of its seams to be repaired. fairness: how many times as much as before the mean
curvature of a face may vary, at least 1. keep_curvature: a seam that is G2 stays G2, even if the
target is G1. max_time_s: no more repairs are tried after this time, what was repaired is kept;
None: no limit. edges: numbers of the edges, from 1, whose seams are treated; None: all defects.
fixed_faces: numbers of faces that stay.
match_mm: also free edges no further apart than this; 0: none. sew: such edges become one where
they meet within the gap tolerance. convert_analytic: planes, cylinders and the like may become
splines where they have to move. ValueError for bad arguments, with name and value.)";

}  // namespace

void bindRepair(py::module_& module) {
  const std::string doc = std::string("The result of Model.repair().") + copies_doc;
  ReportClass type(module, "RepairReport", py::module_local(), doc.c_str());
  bindOutcome(type);
  bindDetails(type);
  bindTexts(type);
  bindCopies(type);
  py::class_<occ::Model> model(module.attr("Model"));
  model.def("repair", &repairModel, repair_doc, py::kw_only(), py::arg("target") = "G1",
            py::arg("profile") = "default", py::arg("gap_mm") = py::none(),
            py::arg("angle_deg") = py::none(), py::arg("curvature_rel") = py::none(),
            py::arg("flat_radius_mm") = py::none(), py::arg("crease_deg") = py::none(),
            py::arg("max_move_mm") = "auto", py::arg("fairness") = occ::RepairOptions{}.fairness,
            py::arg("keep_curvature") = false, py::arg("max_time_s") = py::none(),
            py::arg("edges") = py::none(), py::arg("fixed_faces") = py::tuple(),
            py::arg("match_mm") = 0.0, py::arg("sew") = true, py::arg("convert_analytic") = false,
            py::arg("jobs") = 0, py::arg("progress") = py::none());
}

}  // namespace seamwright::python
