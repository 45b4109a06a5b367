// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/model/format.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/model/write.hpp>
#include <seamwright/occ_adapter/progress.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::report {

using FacePair = std::pair<int, int>;

/// The faces beside a seam, ascending.
FacePair facesOf(const occ::SeamResult& seam);

/// Counts of a changed model, in memory or in its file.
struct ModelCounts {
  int edges = 0;
  int faces = 0;
  int open_edges = 0;
  int seams = 0;                    ///< those that were analysed
  int defects = 0;                  ///< seams that do not meet the target
  std::vector<int> without_length;  ///< numbers of edges that have no curve in space, ascending
  std::vector<occ::SeamResult> defect_seams = {};  ///< those that do not meet the target
  std::set<FacePair> neighbours = {};              ///< faces with an edge in common
};

/// \param model the model that the report is about
ModelCounts countsOf(const occ::Report& report, const occ::Model& model);

/// The file of a changed model, and the counts found when it was read back.
struct WrittenModel {
  std::filesystem::path path;
  occ::Format format = occ::Format::Step;
  ModelCounts found;
  /// Seams that are defects in the file, between faces that have fewer or smaller defects in
  /// memory. Smaller means at a higher level, or with a figure smaller by a tenth. Empty if faces
  /// have other numbers in the file. Numbered as in the file.
  std::vector<occ::SeamResult> only_in_file = {};
  /// How many of these are also defects if the model before the change is written and read back.
  /// Nothing if that was not checked.
  std::optional<int> spoilt_by_writing = {};
  /// Those of only_in_file that the change made worse. Between their faces the model before the
  /// change has fewer or smaller defects, both in memory and in its file when written and read
  /// back. Empty if that was not checked.
  std::vector<occ::SeamResult> worse = {};

  /// Whether the file has no more defects and no more free edges than the model in memory.
  bool isAsGoodAs(const ModelCounts& memory) const {
    return found.defects <= memory.defects && found.open_edges <= memory.open_edges;
  }

  /// The differences between the file and the model in memory, in one line that begins "read back",
  /// and the seams that are defects only in the file. Empty if there are none.
  std::string differences(const ModelCounts& memory) const;
};

/// Counts the model of a file.
using Judge = std::function<ModelCounts(const occ::Model&, const occ::Progress&)>;

/// The criteria for the file of a changed model.
struct FileJudge {
  Judge count;
  ModelCounts memory;  ///< counts of the model that is written
  const occ::Model* given =
      nullptr;  ///< the model before the change; null: defects by writing alone are not found
};

struct FileProgress {
  occ::Progress writing, checking;  ///< called in turn, each starting from 0
};

struct JudgedFile {
  occ::WriteReport report;
  WrittenModel model;
};

/// Writes a changed model. The file is read back and judged under a temporary name before it
/// replaces the target. Readers of STEP join what is nearer than the accuracy that a file states,
/// which breaks seams between short edges. If a STEP file has defects that the model in memory does
/// not have, a file that states a tenth of the accuracy is therefore tried, and the better one is
/// kept; a note says so.
/// \param accepted called before the target is replaced, with the file that is kept. If it throws,
/// the exception is passed on and nothing is written.
/// \throws occ::ModelError, also if the file cannot be read back: the target is then not replaced;
/// occ::Cancelled.
JudgedFile writeJudged(const occ::Model& model, const std::filesystem::path& target,
                       occ::WriteOptions how, const FileJudge& judge, const FileProgress& progress,
                       const std::function<void(const WrittenModel&)>& accepted = {});

/// {path, format, edges, faces, open_edges, defects, only_in_file, spoilt_by_writing}; null if
/// nothing was written.
nlohmann::ordered_json toJson(const std::optional<WrittenModel>& written);

}  // namespace seamwright::report
