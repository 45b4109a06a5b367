// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <string>

/// What the calls on models share.
namespace seamwright::python {

namespace py = pybind11;

/// Calls a Python callable from a thread without the GIL. An answer that is false to Python, other
/// than None, asks the work to stop; so do Ctrl-C and what the callable raises, also when asked for
/// its truth, which is kept in \p raised. Both arguments have to outlive it.
occ::Progress progressOf(const py::object& callable, std::exception_ptr& raised);

/// Does long work without the GIL: work(progress). What the callable raises is raised, however the
/// work took being stopped.
template <class Work>
auto longCall(const py::object& callable, const Work& work) {
  std::exception_ptr raised;
  const occ::Progress progress = progressOf(callable, raised);
  try {
    auto result = [&] {
      const py::gil_scoped_release release;
      return work(progress);
    }();
    if (raised) std::rethrow_exception(raised);
    return result;
  } catch (const occ::Cancelled&) {
    if (raised) std::rethrow_exception(raised);
    throw;
  }
}

/// {format, followed_source, changed_faces, changed_edges, changed_vertices, notes}.
py::dict plainDict(const occ::WriteReport& written);

/// A model that was changed, and how its file is judged.
struct ResultToWrite {
  const occ::Model& model;
  bool unchanged = false;  ///< as of occ::WriteOptions
  report::FileJudge judge;
};

struct ResultTarget {
  const std::filesystem::path& path;
  bool overwrite = false;
  bool overwrite_source = false;
};

constexpr const char* write_result_doc =
    "Writes the model as Model.write() does, but reads the file back and analyses it as the result "
    "was "
    "judged, before it takes its "
    "place.\n\n"
    "Returns the dict of Model.write() and output {path, format, edges, faces, open_edges, "
    "defects} as found "
    "in the file, and "
    "differences: a line of what is otherwise there than in the model, mostly empty. Raises "
    "ModelError also "
    "where the file can't be "
    "read back; nothing is written then.";

/// What write_result_doc says.
py::dict writeResult(const ResultToWrite& result, const ResultTarget& target,
                     const py::object& progress);

/// Dicts, lists, numbers, texts and None.
py::object plainObject(const nlohmann::ordered_json& json);

/// Text that quotes the name of a file, which may hold any byte; what is no UTF-8 is replaced.
py::str readable(const std::string& text);

}  // namespace seamwright::python
