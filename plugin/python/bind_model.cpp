// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <numbers>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/model/read.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/bindings.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/report_state.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/report/csv.hpp>
#include <seamwright/plugin/report/json.hpp>
#include <seamwright/plugin/report/table.hpp>
#include <sstream>

namespace seamwright::python {

namespace {

occ::Model readFile(const py::object& path, const py::object& progress) {
  const std::filesystem::path file = pathOf("path", path);
  return longCall(progress,
                  [&](const occ::Progress& report) { return occ::readModel(file, report); });
}

py::object writeFile(const occ::Model& model, const py::object& path, const py::object& overwrite,
                     const py::object& overwrite_source, const py::object& afresh,
                     const py::object& progress) {
  const std::filesystem::path file = pathOf("path", path);
  const occ::WriteOptions how = {.overwrite = flagOf("overwrite", overwrite),
                                 .overwrite_source = flagOf("overwrite_source", overwrite_source),
                                 .afresh = flagOf("afresh", afresh)};
  const occ::WriteReport written = longCall(progress, [&](const occ::Progress& report) {
    return occ::writeModel(model, file, how, report);
  });
  return resultOf("WriteResult", writeItems(written));
}

occ::Report analyzeModel(const occ::Model& model, const py::object& profile,
                         const py::object& gap_mm, const py::object& angle_deg,
                         const py::object& curvature_rel, const py::object& flat_radius_mm,
                         const py::object& crease_deg, const py::object& level,
                         const py::object& match_mm, const py::object& verdict_only,
                         const py::object& jobs, const py::object& progress) {
  occ::AnalyzeOptions options;
  options.tolerance =
      toleranceOf({profile, gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg});
  options.level = levelOf(level);
  options.match_mm = optionalNumber("match_mm", match_mm).value_or(options.match_mm);
  options.figures = !flagOf("verdict_only", verdict_only);
  options.jobs = wholeNumber("jobs", jobs);
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

py::object seamsOf(const occ::Report& report) {
  return resultsOf("Seam", reportDict(report)["seams"]);
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
    list.append(resultOf("ShapeAttribute", entry));
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
/// bytes. Geometry that can't be computed with is a bad argument.
void bindModelError(py::module_& module) {
  static py::handle type = py::exception<occ::ModelError>(module, "ModelError").release();
  type.attr("__doc__") =
      "A file or shape that can't be read, used or written. The message names the file, and says "
      "what is wrong and what to do.";
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const occ::ModelError& error) {
      PyErr_SetObject(type.ptr(), readable(error.what()).ptr());
    } catch (const occ::GeometryError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}

void bindReport(py::module_& module) {
  py::class_<occ::Report>(module, "Report", py::module_local(),
                          "The seams of a model with figures and verdicts.")
      .def_property_readonly("passed", &occ::Report::passed, "No seam is a defect.")
      .def_property_readonly("seams", &seamsOf,
                             "The Seams, in the order of the JSON; a new list each time.")
      .def("__len__", [](const occ::Report& report) { return report.seams.size(); })
      .def(py::pickle([](const occ::Report& report) { return stateOf(report); }, &reportFrom))
      .def("__copy__", [](const occ::Report& report) { return report; })
      .def(
          "__deepcopy__", [](const occ::Report& report, const py::object&) { return report; },
          py::arg("memo"))
      .def("__repr__",
           [](const occ::Report& report) {
             return "<Report of " + std::to_string(report.seams.size()) +
                    " seams: " + (report.passed() ? "passed>" : "failed>");
           })
      .def("to_dict", &reportDict, "The report as a plain dict with the keys of the JSON.")
      .def("to_json", &report::toJsonLine, py::call_guard<py::gil_scoped_release>(),
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

/// Everything that a model holds; the shape in the binary format.
py::tuple modelState(const occ::Model& model) {
  py::list parts;
  for (const occ::ShapeAttribute& part : model.attributes)
    parts.append(py::make_tuple(static_cast<int>(part.kind), part.index, part.name, part.color,
                                part.layers));
  return py::make_tuple(py::bytes(written(occ::writeBinaryShape, model)), py::bytes(model.path),
                        model.format, model.length_unit, parts, model.notes, model.read_s);
}

occ::Model modelFrom(const py::tuple& state) {
  std::istringstream stream(state[0].cast<std::string>());
  occ::Model model;
  model.shape = occ::readBinaryShape(stream);  // may have curves alone
  if (model.shape.IsNull()) throw occ::ModelError(occ::ModelErrc::NoShapes, {}, "is a null shape");
  model.path = state[1].cast<std::string>();
  model.format = state[2].cast<std::string>();
  model.length_unit = state[3].cast<std::string>();
  for (const py::handle item : state[4].cast<py::list>()) {
    const auto part = item.cast<py::tuple>();
    model.attributes.push_back(
        {static_cast<decltype(occ::ShapeAttribute::kind)>(part[0].cast<int>()), part[1].cast<int>(),
         part[2].cast<std::string>(), part[3].cast<std::optional<std::array<double, 3>>>(),
         part[4].cast<std::vector<std::string>>()});
  }
  model.notes = state[5].cast<std::vector<std::string>>();
  model.read_s = state[6].cast<double>();
  return model;
}

void bindFacts(py::class_<occ::Model>& type) {
  type.def_property_readonly(
          "path", [](const occ::Model& model) { return fileName(model.path); },
          "The file as it was named; empty for a shape from memory.")
      .def_readonly("format", &occ::Model::format,
                    "'STEP', 'IGES', 'BREP' (text), 'binary BREP', or 'memory' for a shape that "
                    "was not read.")
      .def_readonly("length_unit", &occ::Model::length_unit,
                    "The unit of the file; the shape is in mm.")
      .def_readonly("notes", &occ::Model::notes,
                    "What a user should know of the file, such as faces that could not be made: a "
                    "list of texts.")
      .def_readonly("read_s", &occ::Model::read_s, "Seconds that reading took.")
      .def_property_readonly("face_count", &occ::Model::faceCount,
                             "How many faces there are; they are numbered from 1.")
      .def_property_readonly("edge_count", &occ::Model::edgeCount,
                             "How many edges there are; they are numbered from 1.")
      .def_property_readonly("attributes", &attributes,
                             "Names, colours and layers of the file: a list of ShapeAttributes.")
      .def("__copy__", [](const occ::Model& model) { return model; })
      .def(
          "__deepcopy__", [](const occ::Model& model, const py::object&) { return model; },
          py::arg("memo"))
      .def(py::pickle(&modelState, &modelFrom))
      .def("__repr__", [](const occ::Model& model) {
        return "<Model of " + std::to_string(model.faceCount()) + " faces, " + model.format + ">";
      });
}

constexpr const char* analyze_doc =
    R"(Measures and judges every seam: a Report. The model is not changed.

gap_mm, angle_deg, curvature_rel, flat_radius_mm, crease_deg: tolerances; None: that of the
profile, a key of PROFILES. level: what a seam must reach, 'G0' to 'G3'. match_mm: measure also
between free edges no further apart than this; 0: between none. verdict_only: stop at certain
verdicts; figures may then have wide bounds. jobs: threads; 0: one for each processor. progress: a
callable that gets the share done, 0..1; the call raises Cancelled where it returns what is false,
other than None. ValueError for bad arguments, with name and value.)";

constexpr const char* read_doc =
    R"(Reads a STEP, IGES or BREP file, recognised by its content, in a process of its own: a Model.

Raises ModelError for a bad file, TypeError for a path that is not the name of a file.)";

constexpr const char* write_doc =
    R"(Writes a STEP, IGES or BREP file; the extension gives the format: .step, .stp, .iges, .igs,
.brep, .brp, .bin (binary BREP).

A model of a STEP or IGES file is written with that file's structure, names, colours, layers and
length unit; afresh, and from memory: of shape and attributes alone. An existing file needs
overwrite=True, the file that was read overwrite_source=True. Returns a WriteResult. Raises
ModelError; the file is then what it was.)";

void bindCalls(py::class_<occ::Model>& type) {
  type.def("analyze", &analyzeModel, analyze_doc, py::kw_only(), py::arg("profile") = "default",
           py::arg("gap_mm") = py::none(), py::arg("angle_deg") = py::none(),
           py::arg("curvature_rel") = py::none(), py::arg("flat_radius_mm") = py::none(),
           py::arg("crease_deg") = py::none(), py::arg("level") = "G1", py::arg("match_mm") = 0.0,
           py::arg("verdict_only") = false, py::arg("jobs") = 0, py::arg("progress") = py::none())
      .def("write", &writeFile, write_doc, py::arg("path"), py::kw_only(),
           py::arg("overwrite") = false, py::arg("overwrite_source") = false,
           py::arg("afresh") = false, py::arg("progress") = py::none());
}

/// Shapes as bytes and text, for the bridge to FreeCAD.
void bindExchange(py::module_& module) {
  // Other threads, such as that of FreeCAD's window, go on meanwhile.
  const py::call_guard<py::gil_scoped_release> unlocked;
  module.def(
      "_model_from_binary",
      [](const std::string& bytes) {
        std::istringstream stream(bytes);
        return occ::modelFromShape(occ::readBinaryShape(stream));
      },
      unlocked);
  module.def(
      "_model_from_text",
      [](const std::string& text) {
        std::istringstream stream(text);
        return occ::modelFromShape(occ::readTextShape(stream));
      },
      unlocked);
  module.def("_binary_from_model", [](const occ::Model& model) {
    return py::bytes(written(occ::writeBinaryShape, model));
  });
  module.def("_text_from_model",
             [](const occ::Model& model) { return written(occ::writeTextShape, model); });
}

}  // namespace

void bindModel(py::module_& module) {
  bindModelError(module);
  py::register_local_exception<occ::Cancelled>(module, "Cancelled").attr("__doc__") =
      "A call was stopped: its callable progress returned a value that is false in Python, other "
      "than None. Nothing was changed or written.";
  bindReport(module);
  module.attr("PROFILES") = profiles();
  py::class_<occ::Model> type(module, "Model", py::module_local(),
                              "A shape with what its file says about it; lengths in mm.");
  bindFacts(type);
  bindCalls(type);
  module.def("read", &readFile, py::arg("path"), py::arg("progress") = py::none(), read_doc);
  bindExchange(module);
}

}  // namespace seamwright::python
