// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/model/format.hpp>
#include <string>

namespace seamwright::report {

/// What is counted in a changed model, in memory and in its file.
struct ModelCounts {
  int edges = 0;
  int faces = 0;
  int open_edges = 0;
  int seams = 0;    ///< of those that were looked at
  int defects = 0;  ///< seams that do not meet the target
};

ModelCounts countsOf(const occ::Report& report);

/// The file of a changed model, and what was found there when it was read back.
struct WrittenModel {
  std::filesystem::path path;
  occ::Format format = occ::Format::Step;
  ModelCounts found;

  /// What the file has otherwise than the model in memory, in one line that begins "read back"; empty if nothing.
  std::string differences(const ModelCounts& memory) const;
};

/// {path, format, edges, faces, open_edges, defects}; null where nothing was written.
nlohmann::ordered_json toJson(const std::optional<WrittenModel>& written);

}  // namespace seamwright::report
