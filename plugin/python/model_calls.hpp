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

/// Helpers that the calls on models share.
namespace seamwright::python {

namespace py = pybind11;

/// Calls a Python callable from a thread without the GIL. An answer that is false in Python, other
/// than None, stops the work. So do Ctrl-C and an exception of the callable or of the truth test of
/// its answer; the exception is kept in \p raised. Both arguments must outlive the result.
occ::Progress progressOf(const py::object& callable, std::exception_ptr& raised);

/// Runs work(progress) without the GIL. An exception of the callable is raised again, whether the
/// stopped work returned or threw.
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

/// The items of a WriteResult of seamwright/results.py.
py::dict writeItems(const occ::WriteReport& written);

/// A changed model, and the criteria for its file.
struct ResultToWrite {
  const occ::Model& model;
  bool unchanged = false;  ///< as for occ::WriteOptions
  report::FileJudge judge;
};

/// The arguments of every write().
struct WriteArguments {
  const py::object& path;
  const py::object& overwrite;
  const py::object& overwrite_source;
  const py::object& progress;
};

constexpr const char* write_result_doc =
    R"(Writes the model as Model.write() does, but reads the file back and analyses it before it
takes its place.

The analysis is the one by which the result was judged. Returns a CheckedWriteResult: what
Model.write() returns; output, what was found in the file; and differences, one line that says how
the file differs from the model, or an empty string. Raises ModelError also if the file can't be
read back; nothing is written then.)";

/// Does what write_result_doc describes.
py::object writeResult(const ResultToWrite& result, const WriteArguments& arguments);

/// The JSON as Python dicts, lists, numbers, strings and None.
py::object plainObject(const nlohmann::ordered_json& json);

/// Text that quotes the name of a file, which may contain any byte. Bytes that are not UTF-8 are
/// replaced.
py::str readable(const std::string& text);

/// What follows the first sentence of the description of a result that copy copies and pickle
/// refuses.
constexpr const char* copies_doc =
    R"(

copy and deepcopy give the same result, as it never changes. pickle raises TypeError, because a
result holds a model and the state that write() needs: pickle to_dict() and model instead.)";

/// Defines how copy and pickle treat a result that holds a model: see copies_doc.
template <class Result>
void bindCopies(pybind11::class_<Result>& type) {
  type.def("__copy__", [](const py::object& result) { return result; })
      .def(
          "__deepcopy__", [](const py::object& result, const py::object&) { return result; },
          py::arg("memo"))
      .def(
          "__reduce_ex__",
          [](const py::object& result, int) -> py::object {
            const auto name = py::type::of(result).attr("__name__").cast<std::string>();
            throw py::type_error("a " + name +
                                 " can't be pickled, as it holds a model and the state that write()"
                                 " needs: pickle its to_dict() and its model instead");
          },
          py::arg("protocol"));
}

}  // namespace seamwright::python
