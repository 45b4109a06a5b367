// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <numbers>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/report/csv.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <sstream>

namespace py = pybind11;

namespace seamwright::python {

namespace {

/// Calls a Python callable from a thread without the GIL; also lets Ctrl-C through.
occ::Progress progressOf(const py::object& callable) {
  return [&callable](double share) {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return callable.is_none() || !callable(share).is(py::bool_(false));
  };
}

occ::Model readFile(const std::filesystem::path& path, const py::object& progress) {
  const occ::Progress report = progressOf(progress);
  const py::gil_scoped_release release;
  return occ::readModel(path, report);
}

occ::Report analyzeModel(const occ::Model& model, double gap_mm, double angle_deg, double curvature_rel,
                         double flat_radius_mm, double crease_deg, const std::string& level, int jobs,
                         const py::object& progress) {
  occ::AnalyzeOptions options;
  constexpr double radians_per_degree = std::numbers::pi / 180;
  options.tolerance = {gap_mm, angle_deg * radians_per_degree, curvature_rel, flat_radius_mm,
                       crease_deg * radians_per_degree};
  const std::optional<Level> wanted = levelFromName(level);
  if (!wanted) throw py::value_error("level '" + level + "': known are G0, G1, G2 and G3");
  options.level = *wanted;
  options.jobs = jobs;
  const occ::Progress report = progressOf(progress);
  const py::gil_scoped_release release;
  return occ::analyze(model, options, report);
}

py::object toDict(const occ::Report& report) {
  return py::module_::import("json").attr("loads")(report::toJsonLine(report));
}

py::list attributes(const occ::Model& model) {
  py::list list;
  for (const occ::ShapeAttribute& attribute : model.attributes) {
    py::dict entry;
    constexpr std::array names = {"Compound", "CompSolid", "Solid",  "Shell", "Face",
                                  "Wire",     "Edge",      "Vertex", "Shape"};
    entry["kind"] = names.at(static_cast<std::size_t>(attribute.kind));
    entry["index"] = attribute.index;
    entry["name"] = attribute.name;
    entry["color"] = attribute.color;
    list.append(std::move(entry));
  }
  return list;
}

template <class Write>
std::string written(const Write& write, const occ::Model& model) {
  std::ostringstream stream;
  write(model.shape, stream);
  return stream.str();
}

void bindReport(py::module_& module) {
  py::class_<occ::Report>(module, "Report", py::module_local(),
                          "The seams of a model with figures and verdicts.")
      .def_property_readonly("passed", &occ::Report::passed, "No seam is a defect.")
      .def_property_readonly(
          "seams", [](const occ::Report& report) { return py::object(toDict(report)["seams"]); },
          "The seams as a list of dicts with the keys of the JSON.")
      .def("__len__", [](const occ::Report& report) { return report.seams.size(); })
      .def("to_dict", &toDict, "The report as a plain dict with the keys of the JSON.")
      .def("to_json", &report::toJsonLine, "The report as one line of JSON, schema seamwright.analysis/1.")
      .def("to_csv", [](const occ::Report& report) { return report::csvHeader() + report::csvRows(report); })
      .def("to_table", &report::toTable, "The report as text for people.");
}

}  // namespace

void bindModel(py::module_& module) {
  py::register_local_exception<occ::ModelError>(module, "ModelError");
  py::register_local_exception<occ::Cancelled>(module, "Cancelled");
  bindReport(module);
  const ContinuityTolerance defaults;
  constexpr double degrees_per_radian = 180 / std::numbers::pi;
  py::class_<occ::Model>(module, "Model", py::module_local(),
                         "A shape with what its file says about it; lengths in mm.")
      .def_readonly("path", &occ::Model::path)
      .def_readonly("format", &occ::Model::format)
      .def_readonly("length_unit", &occ::Model::length_unit, "The unit of the file; the shape is in mm.")
      .def_readonly("notes", &occ::Model::notes)
      .def_readonly("read_s", &occ::Model::read_s)
      .def_property_readonly("face_count", &occ::Model::faceCount)
      .def_property_readonly("edge_count", &occ::Model::edgeCount)
      .def_property_readonly("attributes", &attributes,
                             "Names and colours of the file: a list of {kind, index, name, color}.")
      .def("analyze", &analyzeModel, py::kw_only(), py::arg("gap_mm") = defaults.gap_mm,
           py::arg("angle_deg") = defaults.angle_rad * degrees_per_radian,
           py::arg("curvature_rel") = defaults.curvature_rel,
           py::arg("flat_radius_mm") = defaults.flat_radius_mm,
           py::arg("crease_deg") = defaults.crease_rad * degrees_per_radian, py::arg("level") = "G1",
           py::arg("jobs") = 0, py::arg("progress") = py::none(),
           "Measures and judges every seam. Returns a Report.");
  module.def(
      "read", &readFile, py::arg("path"), py::arg("progress") = py::none(),
      "Reads a STEP, IGES or BREP file, told by its content, in a process of its own. Returns a Model.");
  module.def("_model_from_binary", [](const std::string& bytes) {
    std::istringstream stream(bytes);
    return occ::modelFromShape(occ::readBinaryShape(stream));
  });
  module.def("_model_from_text", [](const std::string& text) {
    std::istringstream stream(text);
    return occ::modelFromShape(occ::readTextShape(stream));
  });
  module.def("_binary_from_model",
             [](const occ::Model& model) { return py::bytes(written(occ::writeBinaryShape, model)); });
  module.def("_text_from_model", [](const occ::Model& model) { return written(occ::writeTextShape, model); });
}

}  // namespace seamwright::python
