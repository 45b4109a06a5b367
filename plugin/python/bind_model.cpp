// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <numbers>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/report/csv.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <sstream>

namespace seamwright::python {

namespace {

occ::Model readFile(const std::filesystem::path& path, const py::object& progress) {
  return longCall(progress,
                  [&](const occ::Progress& report) { return occ::readModel(path, report); });
}

py::dict writeFile(const occ::Model& model, const std::filesystem::path& path, bool overwrite,
                   bool overwrite_source, bool afresh, const py::object& progress) {
  const occ::WriteReport written = longCall(progress, [&](const occ::Progress& report) {
    return occ::writeModel(model, path, {overwrite, overwrite_source, afresh, false, {}}, report);
  });
  return plainDict(written);
}

occ::Report analyzeModel(const occ::Model& model, const py::object& profile,
                         const py::object& gap_mm, const py::object& angle_deg,
                         const py::object& curvature_rel, const py::object& flat_radius_mm,
                         const py::object& crease_deg, const py::object& level,
                         const py::object& match_mm, const py::object& jobs,
                         const py::object& progress) {
  occ::AnalyzeOptions options;
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  options.level = levelOf(level);
  if (!match_mm.is_none()) options.match_mm = argument<double>("match_mm", match_mm, "a number");
  options.jobs = argument<int>("jobs", jobs, "a whole number");
  return longCall(
      progress, [&](const occ::Progress& report) { return occ::analyze(model, options, report); });
}

py::dict profiles() {
  py::dict all;
  for (const ToleranceProfile& profile : toleranceProfiles()) {
    const ContinuityTolerance& tolerance = profile.tolerance;
    py::dict figures;
    figures["gap_mm"] = tolerance.gap_mm;
    figures["angle_deg"] = tolerance.angle_rad / radians_per_degree;
    figures["curvature_rel"] = tolerance.curvature_rel;
    figures["flat_radius_mm"] = tolerance.flat_radius_mm;
    figures["crease_deg"] = tolerance.crease_rad / radians_per_degree;
    all[py::str(std::string(profile.name))] = figures;
  }
  return all;
}

/// The name of a file decoded as Python does it, so that Python can open the file again.
py::str fileName(const std::string& name) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeFSDefaultAndSize(name.data(), static_cast<Py_ssize_t>(name.size())));
}

py::object reportDict(const occ::Report& report) {
  return plainObject(report::toJson(report));
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
    entry["layers"] = attribute.layers;
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

/// Like py::register_local_exception, except that the message may quote the name of a file with any
/// bytes.
void bindModelError(py::module_& module) {
  static py::handle type = py::exception<occ::ModelError>(module, "ModelError").release();
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const occ::ModelError& error) {
      PyErr_SetObject(type.ptr(), readable(error.what()).ptr());
    }
  });
}

void bindReport(py::module_& module) {
  py::class_<occ::Report>(module, "Report", py::module_local(),
                          "The seams of a model with figures and verdicts.")
      .def_property_readonly("passed", &occ::Report::passed, "No seam is a defect.")
      .def_property_readonly(
          "seams",
          [](const occ::Report& report) { return py::object(reportDict(report)["seams"]); },
          "The seams as a list of dicts with the keys of the JSON.")
      .def("__len__", [](const occ::Report& report) { return report.seams.size(); })
      .def("to_dict", &reportDict, "The report as a plain dict with the keys of the JSON.")
      .def("to_json", &report::toJsonLine,
           "The report as one line of JSON, schema seamwright.analysis/1.")
      .def(
          "to_csv",
          [](const occ::Report& report) {
            return readable(report::csvHeader() + report::csvRows(report));
          },
          "The report as CSV, a line for each seam.")
      .def(
          "to_table", [](const occ::Report& report) { return readable(report::toTable(report)); },
          "The report as text for people.");
}

}  // namespace

void bindModel(py::module_& module) {
  bindModelError(module);
  py::register_local_exception<occ::Cancelled>(module, "Cancelled");
  bindReport(module);
  module.attr("PROFILES") = profiles();
  py::class_<occ::Model>(module, "Model", py::module_local(),
                         "A shape with what its file says about it; lengths in mm.")
      .def_property_readonly(
          "path", [](const occ::Model& model) { return fileName(model.path); },
          "The file as it was named; empty for a shape from memory.")
      .def_readonly("format", &occ::Model::format)
      .def_readonly("length_unit", &occ::Model::length_unit,
                    "The unit of the file; the shape is in mm.")
      .def_readonly("notes", &occ::Model::notes)
      .def_readonly("read_s", &occ::Model::read_s)
      .def_property_readonly("face_count", &occ::Model::faceCount)
      .def_property_readonly("edge_count", &occ::Model::edgeCount)
      .def_property_readonly(
          "attributes", &attributes,
          "Names, colours and layers of the file: a list of {kind, index, name, color, layers}.")
      .def("analyze", &analyzeModel, py::kw_only(), py::arg("profile") = "default",
           py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
           py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
           py::arg("crease_deg") = py::none(), py::arg("level") = "G1", py::arg("match_mm") = 0.0,
           py::arg("jobs") = 0, py::arg("progress") = py::none(),
           "Measures and judges every seam. Returns a Report.\n\n"
           "A tolerance that is None is that of the profile, see PROFILES. level: what a seam must "
           "reach, "
           "'G0' to 'G3'. match_mm: measure also between free edges no further apart than this; 0: "
           "between "
           "none. jobs: threads; 0: one for each processor.")
      .def(
          "write", &writeFile, py::arg("path"), py::kw_only(), py::arg("overwrite") = false,
          py::arg("overwrite_source") = false, py::arg("afresh") = false,
          py::arg("progress") = py::none(),
          "Writes a STEP, IGES or BREP file, told by the extension: .step, .stp, .iges, .igs, "
          ".brep, .brp, "
          ".bin (binary BREP).\n\n"
          "A model of a STEP or IGES file is written with that file's structure, names, colours, "
          "layers and "
          "length unit; afresh, and from memory: of shape and attributes alone. An existing file "
          "needs "
          "overwrite=True, the file that was read overwrite_source=True. Returns a dict of format, "
          "followed_source, changed_faces, changed_edges, changed_vertices and notes. Raises "
          "ModelError; "
          "the file is then what it was.");
  module.def("read", &readFile, py::arg("path"), py::arg("progress") = py::none(),
             "Reads a STEP, IGES or BREP file, told by its content, in a process of its own. "
             "Returns a Model.");
  module.def("_model_from_binary", [](const std::string& bytes) {
    std::istringstream stream(bytes);
    return occ::modelFromShape(occ::readBinaryShape(stream));
  });
  module.def("_model_from_text", [](const std::string& text) {
    std::istringstream stream(text);
    return occ::modelFromShape(occ::readTextShape(stream));
  });
  module.def("_binary_from_model", [](const occ::Model& model) {
    return py::bytes(written(occ::writeBinaryShape, model));
  });
  module.def("_text_from_model",
             [](const occ::Model& model) { return written(occ::writeTextShape, model); });
}

}  // namespace seamwright::python
