// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/model/format.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>
#include <string>
#include <vector>

namespace seamwright::report {

/// What is counted in a changed model, in memory and in its file.
struct ModelCounts {
  int edges = 0;
  int faces = 0;
  int open_edges = 0;
  int seams = 0;                    ///< of those that were looked at
  int defects = 0;                  ///< seams that do not meet the target
  std::vector<int> without_length;  ///< numbers of edges that have no curve in space, ascending
};

/// \param model the one that the report is about
ModelCounts countsOf(const occ::Report& report, const occ::Model& model);

/// The file of a changed model, and what was found there when it was read back.
struct WrittenModel {
  std::filesystem::path path;
  occ::Format format = occ::Format::Step;
  ModelCounts found;

  /// It has no more defects and no more open edges.
  bool isAsGoodAs(const ModelCounts& memory) const {
    return found.defects <= memory.defects && found.open_edges <= memory.open_edges;
  }

  /// What the file has otherwise than the model in memory, in one line that begins "read back"; empty if nothing.
  std::string differences(const ModelCounts& memory) const;
};

/// What is counted in the model of a file.
using Judge = std::function<ModelCounts(const occ::Model&, const occ::Progress&)>;

/// Reads a new file back, which waits beside its place \p output, and judges it.
/// \throws occ::ModelError where it can't be read back: it is not to take its place then.
WrittenModel readBack(const std::filesystem::path& waiting, const std::filesystem::path& output,
                      const Judge& judge, const occ::Progress& progress);

/// {path, format, edges, faces, open_edges, defects}; null where nothing was written.
nlohmann::ordered_json toJson(const std::optional<WrittenModel>& written);

}  // namespace seamwright::report
