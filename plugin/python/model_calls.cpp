// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pybind11/stl.h>

#include <algorithm>
#include <seamwright/plugin/python/arguments.hpp>
#include <seamwright/plugin/python/model_calls.hpp>
#include <seamwright/plugin/python/results.hpp>
#include <seamwright/plugin/report/json.hpp>

namespace seamwright::python {

namespace {

/// Makes progress monotonic, because a file is read back before its writing ends and the share
/// would fall.
occ::Progress rising(const occ::Progress& progress) {
  return [&progress, highest = 0.0](double share) mutable {
    highest = std::max(highest, share);
    return !progress || progress(highest);
  };
}

}  // namespace

occ::Progress progressOf(const py::object& callable, std::exception_ptr& raised) {
  return [&callable, &raised](double share) {
    const py::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (callable.is_none()) return true;
      const py::object answer = callable(share);
      return answer.is_none() || py::bool_(answer);
    } catch (const py::error_already_set&) {
      raised = std::current_exception();
      return false;
    }
  };
}

py::dict writeItems(const occ::WriteReport& written) {
  py::dict dict;
  dict["format"] = std::string(occ::name(written.format));
  dict["followed_source"] = written.followed_source;
  dict["changed_faces"] = written.changed_faces;
  dict["changed_edges"] = written.changed_edges;
  dict["changed_vertices"] = written.changed_vertices;
  dict["notes"] = written.notes;
  return dict;
}

py::object writeResult(const ResultToWrite& result, const WriteArguments& arguments) {
  constexpr double written_by = 0.5;  // of the progress bar: checking takes about as long
  const std::filesystem::path path = pathOf("path", arguments.path);
  const occ::WriteOptions how = {
      .overwrite = flagOf("overwrite", arguments.overwrite),
      .overwrite_source = flagOf("overwrite_source", arguments.overwrite_source),
      .unchanged = result.unchanged};
  const report::JudgedFile written = longCall(arguments.progress, [&](const occ::Progress& share) {
    const occ::Progress shown = rising(share);
    return report::writeJudged(
        result.model, path, how, result.judge,
        {occ::partOf(shown, 0, written_by), occ::partOf(shown, written_by, 1)});
  });
  py::dict items = writeItems(written.report);
  items["output"] = plainObject(report::toJson(written.model));
  items["differences"] = written.model.differences(result.judge.memory);
  return resultOf("CheckedWriteResult", items);
}

py::object plainObject(const nlohmann::ordered_json& json) {
  return py::module_::import("json").attr("loads")(report::toLine(json));
}

py::str readable(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

}  // namespace seamwright::python
