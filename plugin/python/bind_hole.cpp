// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <numbers>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/fill/repaired_fill.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/report/fill_json.hpp>
#include <seamwright/plugin/report/json.hpp>

namespace seamwright::python {

namespace {

/// The result of a fill, with its options.
struct FillReport {
  occ::FillHoleReport report;
  occ::FillHoleOptions options;
  occ::ModelFacts given;

  nlohmann::ordered_json json() const { return report::toJson(report, options, given); }
};

std::vector<occ::Hole> holesOf(const occ::Model& model, double corner_rad, double gap_mm) {
  return occ::findHoles(model.shape, {corner_rad, gap_mm}).holes;
}

py::list holes(const occ::Model& model, const py::object& corner_deg, const py::object& gap_mm) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  const double corner_rad = radians_per_degree * numberOf("corner_deg", corner_deg);
  for (const occ::Hole& hole : holesOf(model, corner_rad, numberOf("gap_mm", gap_mm)))
    all.push_back(report::toJson(hole));
  return resultsOf("Hole", plainObject(all));
}

Level targetLevel(const py::object& target) {
  const std::optional<Level> level =
      levelFromName(argument<std::string>("target", target, "a text"));
  if (!level)
    throw py::value_error("target is " + shown(target) + ": it must be 'G0', 'G1' or 'G2'");
  return *level;
}

/// A hole by its id, or one of the Holes that holes() returned.
occ::Hole holeOf(const occ::Model& model, const py::object& given,
                 const occ::FillHoleOptions& options) {
  const py::object number = itemOrSelf(given, "id");
  const std::vector<occ::Hole> all = holesOf(model, options.corner_rad, options.tolerance.gap_mm);
  if (number.is_none() && all.size() == 1) return all.front();
  if (all.empty()) throw py::value_error("the model has no hole");
  if (number.is_none())
    throw py::value_error("hole is None and the model has " + std::to_string(all.size()) +
                          " holes: name one of them, or a face");
  const auto hole = std::ranges::find(all, wholeNumber("hole", number), &occ::Hole::id);
  if (hole == all.end())
    throw py::value_error("hole is " + shown(number) + ": the model has " +
                          std::to_string(all.size()));
  return *hole;
}

FillReport fillModel(const occ::Model& model, const py::object& hole, const py::object& face,
                     const py::object& target, const py::object& gap_mm,
                     const py::object& angle_deg, const py::object& curvature_rel,
                     const py::object& corner_deg, const py::object& keep_anyway,
                     const py::object& repair_first, const py::object& jobs,
                     const py::object& progress) {
  const bool repair = flagOf("repair_first", repair_first);
  occ::FillHoleOptions options;
  options.target = targetLevel(target);
  options.tolerance.gap_mm = numberOf("gap_mm", gap_mm);
  options.setAngle(radians_per_degree * numberOf("angle_deg", angle_deg));
  options.tolerance.curvature_rel = numberOf("curvature_rel", curvature_rel);
  options.corner_rad = radians_per_degree * numberOf("corner_deg", corner_deg);
  options.keep_anyway = flagOf("keep_anyway", keep_anyway);
  options.jobs = wholeNumber("jobs", jobs);
  options.validate();
  if (!hole.is_none() && !face.is_none())
    throw py::value_error("hole and face are both given: name one of them");
  if (!face.is_none()) {
    const std::vector<int> numbers = wholeNumbersOrOne("face", face);
    return longCall(progress, [&](const occ::Progress& report) {
      const auto replace = repair ? occ::repairedAndReplacedFaces : occ::replaceFaces;
      return FillReport{replace(model, numbers, options, report), options, occ::factsOf(model)};
    });
  }
  const occ::Hole found = holeOf(model, hole, options);
  return longCall(progress, [&](const occ::Progress& report) {
    return FillReport{repair ? occ::repairedAndFilledHole(model, found, options, report)
                             : occ::fillHole(model, found, options, report),
                      options, occ::factsOf(model)};
  });
}

py::object fillReportDict(const FillReport& fill) {
  return plainObject(fill.json());
}

py::object writeFilled(const FillReport& fill, const py::object& path, const py::object& overwrite,
                       const py::object& overwrite_source, const py::object& progress) {
  const report::Judge judge = report::judgeOf(fill.report, fill.options);
  const report::ModelCounts memory = [&] {
    const py::gil_scoped_release release;
    return fill.report.filled ? report::countsOf(fill.report, fill.options)
                              : judge(fill.report.model, {});
  }();
  return writeResult({fill.report.model, !fill.report.filled, {judge, memory}},
                     {path, overwrite, overwrite_source, progress});
}

/// A property that reads a value of the JSON.
auto valueNamed(const char* key) {
  return [=](const FillReport& fill) { return py::object(fillReportDict(fill)[key]); };
}

using FillClass = py::class_<FillReport>;

void bindFillOutcome(FillClass& type) {
  type.def_property_readonly(
          "model", [](const FillReport& fill) { return fill.report.model; },
          "The model with the fill, or as it was.")
      .def_property_readonly(
          "filled", [](const FillReport& fill) { return fill.report.filled; },
          "The fill is in the model.")
      .def_property_readonly(
          "reached", [](const FillReport& fill) { return fill.report.reached; },
          "Every new seam certainly reaches the target.")
      .def_property_readonly(
          "reason", [](const FillReport& fill) { return textOf(fill.report.reason); },
          "Why the target is not reached; empty if it is.")
      .def_property_readonly(
          "reason_code", [](const FillReport& fill) { return codeOf(fill.report.reason.fault); },
          "The code of the reason, see docs/fill.md; empty if the target is reached.")
      .def_property_readonly(
          "method", [](const FillReport& fill) { return name(fill.report.method); },
          "What the fill consists of: 'surface', 'patches' or 'graph'; empty if nothing was built.")
      .def_property_readonly("around", valueNamed("around"),
                             "With repair_first what was repaired around the hole, as a dict with "
                             "the keys of the JSON: edges, treated, repaired, left, "
                             "largest_move_mm, used; otherwise None.")
      .def_property_readonly("causes", valueNamed("causes"),
                             "The causes that the reason names, as dicts with the keys of the "
                             "JSON: code, numbers, edges, point_mm.");
}

void bindFillFigures(FillClass& type) {
  type.def_property_readonly("largest_angle_deg", valueNamed("largest_angle_deg"),
                             "Bound of the angle over all new seams; None: not known.")
      .def_property_readonly("largest_gap_mm", valueNamed("largest_gap_mm"),
                             "Bound of the gap over all new seams; None: not known.")
      .def_property_readonly("largest_curvature_rel", valueNamed("largest_curvature_rel"),
                             "Bound of the relative difference of curvature over all new seams; "
                             "None: not known.")
      .def_property_readonly(
          "curvature_per_mm", [](const FillReport& fill) { return fill.report.curvature_per_mm; },
          "The largest normal curvature at points of the new faces; None if there are none.")
      .def_property_readonly(
          "around_curvature_per_mm",
          [](const FillReport& fill) { return fill.report.around_curvature_per_mm; },
          "The same of the faces beside the fill; None if it was not kept.")
      .def_property_readonly(
          "both_ways_per_mm", [](const FillReport& fill) { return fill.report.both_ways_per_mm; },
          "The smaller one of the largest mean curvatures to either side of the new faces: large "
          "in dents and waves; None if the fill was not kept.")
      .def_property_readonly(
          "waves", [](const FillReport& fill) { return fill.report.waves(); },
          "both_ways_per_mm over around_curvature_per_mm, if that is 2 or more; else None. Such a "
          "fill has dents or waves, whatever its seams.")
      .def_property_readonly(
          "removed_curvature_per_mm",
          [](const FillReport& fill) { return fill.report.removed_curvature_per_mm; },
          "The same of the faces that were taken out; None if none was.")
      .def_property_readonly(
          "curvature_jump_per_mm",
          [](const FillReport& fill) { return fill.report.curvature_jump_per_mm; },
          "The largest jump of normal curvature as the fill was built, against neighbours as they "
          "were fitted, at parameters along the seams; None where it was not made small: with the "
          "target G0, with G1 in high degrees.");
}

void bindFillTexts(FillClass& type) {
  type.def("to_dict", &fillReportDict,
           "All but the model as a plain dict with the keys of the JSON.")
      .def(
          "to_json", [](const FillReport& fill) { return report::toLine(fill.json()); },
          "The report as one line of JSON, schema seamwright.fill/1.")
      .def(
          "to_table",
          [](const FillReport& fill) {
            return readable(report::toTable(fill.report, fill.options));
          },
          "The report as text for people.")
      .def("write", &writeFilled, write_result_doc, py::arg("path"), py::kw_only(),
           py::arg("overwrite") = false, py::arg("overwrite_source") = false,
           py::arg("progress") = py::none())
      .def("__repr__", [](const FillReport& fill) {
        return "<FillReport: " + std::string(fill.report.filled ? "filled" : "not filled") + ", " +
               (fill.report.reached ? "reached" : "not reached") + ">";
      });
}

constexpr const char* holes_doc =
    R"(The closed loops of free edges: a list of Holes. The boundary of an open shell is one of
them, mostly the longest.

corner_deg: sides end where the tangent turns by more. gap_mm: ends of edges nearer than this are
one.)";

constexpr const char* fill_doc =
    R"(Fills a hole with faces that are tangent to their surroundings: a FillReport.

One face fills the hole if one surface continues across it; otherwise patches do, or a trimmed
spline over a plane. See docs/fill.md.

The faces are sewn in and every new seam is measured. The model is not changed.

hole: a Hole of holes() or its id; None: the only one. face: number of a face, from 1, that is
taken out and replaced, or a sequence of numbers of faces that are replaced together. target: 'G0',
'G1' or 'G2', and tolerances: what every new seam has to reach for the fill to be kept. corner_deg:
as in holes(). keep_anyway: keep it if it misses that. repair_first: the seams that end at the hole,
between the faces around it, are repaired before, for the same target and tolerances. jobs and
progress as in analyze().
ValueError for bad arguments, with name and value.)";

}  // namespace

void bindHole(py::module_& module) {
  const std::string doc = std::string("The result of Model.fill().") + copies_doc;
  FillClass type(module, "FillReport", py::module_local(), doc.c_str());
  bindFillOutcome(type);
  bindFillFigures(type);
  bindFillTexts(type);
  bindCopies(type);
  const occ::FillHoleOptions defaults;
  py::class_<occ::Model> model(module.attr("Model"));
  model.def("holes", &holes, holes_doc, py::kw_only(), py::arg("corner_deg") = 15.0,
            py::arg("gap_mm") = defaults.tolerance.gap_mm);
  model.def("fill", &fillModel, fill_doc, py::kw_only(), py::arg("hole") = py::none(),
            py::arg("face") = py::none(), py::arg("target") = "G1",
            py::arg("gap_mm") = defaults.tolerance.gap_mm, py::arg("angle_deg") = 0.01,
            py::arg("curvature_rel") = defaults.tolerance.curvature_rel,
            py::arg("corner_deg") = 15.0, py::arg("keep_anyway") = false,
            py::arg("repair_first") = false, py::arg("jobs") = 0, py::arg("progress") = py::none());
}

}  // namespace seamwright::python
