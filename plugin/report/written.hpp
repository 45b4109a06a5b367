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

/// What is counted in a changed model, in memory and in its file.
struct ModelCounts {
  int edges = 0;
  int faces = 0;
  int open_edges = 0;
  int seams = 0;                    ///< of those that were looked at
  int defects = 0;                  ///< seams that do not meet the target
  std::vector<int> without_length;  ///< numbers of edges that have no curve in space, ascending
  std::vector<occ::SeamResult> defect_seams = {};  ///< those that do not meet the target
  std::set<FacePair> neighbours = {};              ///< faces with an edge in common
};

/// \param model the one that the report is about
ModelCounts countsOf(const occ::Report& report, const occ::Model& model);

/// The file of a changed model, and what was found there when it was read back.
struct WrittenModel {
  std::filesystem::path path;
  occ::Format format = occ::Format::Step;
  ModelCounts found;
  /// Seams that are defects in the file, between faces that have fewer in memory, or smaller ones:
  /// of a higher level, or by a tenth. None where faces have other numbers. Numbers of the file.
  std::vector<occ::SeamResult> only_in_file = {};
  /// Of those: how many are defects too where the model before the change is written and read.
  /// Nothing where that was not looked at.
  std::optional<int> spoilt_by_writing = {};
  /// Of those: the seams that the change made worse. Between their faces the model before the
  /// change has fewer or smaller defects, in memory and, written and read, in its file. None where
  /// that was not looked at.
  std::vector<occ::SeamResult> worse = {};

  /// It has no more defects and no more open edges.
  bool isAsGoodAs(const ModelCounts& memory) const {
    return found.defects <= memory.defects && found.open_edges <= memory.open_edges;
  }

  /// What the file has otherwise than the model in memory, in one line that begins "read back", and
  /// which seams are defects in the file alone; empty if nothing.
  std::string differences(const ModelCounts& memory) const;
};

/// What is counted in the model of a file.
using Judge = std::function<ModelCounts(const occ::Model&, const occ::Progress&)>;

/// What the file of a changed model is judged by.
struct FileJudge {
  Judge count;
  ModelCounts memory;  ///< what is counted in the model that is written
  const occ::Model* given =
      nullptr;  ///< the model before the change; null: what writing alone spoils is not looked for
};

struct FileProgress {
  occ::Progress writing, checking;  ///< one goes on after the other, from 0 on each time
};

struct JudgedFile {
  occ::WriteReport report;
  WrittenModel model;
};

/// Writes a changed model. The file is read back and judged while it waits beside its place.
/// Readers of STEP join what is nearer than the accuracy that a file states, which spoils seams
/// between short edges. So where a STEP file has defects that the model in memory has not, one that
/// states a tenth of the accuracy is tried, and the better one is kept; a note says so.
/// \param accepted called with what is kept while it waits; what it throws is passed on, and
/// nothing is written then.
/// \throws occ::ModelError, also where the file can't be read back: it does not take its place
/// then; occ::Cancelled.
JudgedFile writeJudged(const occ::Model& model, const std::filesystem::path& target,
                       occ::WriteOptions how, const FileJudge& judge, const FileProgress& progress,
                       const std::function<void(const WrittenModel&)>& accepted = {});

/// {path, format, edges, faces, open_edges, defects, only_in_file, spoilt_by_writing}; null where
/// nothing was written.
nlohmann::ordered_json toJson(const std::optional<WrittenModel>& written);

}  // namespace seamwright::report
