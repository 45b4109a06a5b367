// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <string>

namespace seamwright::report {

/// {id, length_mm, centre_mm, has_corners, longest, sides: [{edges, faces, length_mm}]}.
nlohmann::ordered_json toJson(const occ::Hole& hole);

/// What a fill has in memory: seams are the new ones, defects those of them that do not surely
/// reach the target.
ModelCounts countsOf(const occ::FillHoleReport& report, const occ::FillHoleOptions& options);

/// What its file has, by an analysis of the seams of the new faces.
/// \param model the one that was found in the file
ModelCounts countsOf(const occ::Report& found, const occ::Model& model,
                     const occ::FillHoleOptions& options);

/// Counts in a file the seams of the new faces; of all faces, where it does not have those of the
/// model in memory, or that was not filled. Both arguments have to outlive it.
Judge judgeOf(const occ::FillHoleReport& report, const occ::FillHoleOptions& options);

/// The report as the object "seamwright.fill/1" (docs/fill-1.schema.json), lengths in mm, angles in
/// degrees.
/// \param given the model as it was read. \param output nothing where the model was not written.
nlohmann::ordered_json toJson(const occ::FillHoleReport& report,
                              const occ::FillHoleOptions& options, const occ::ModelFacts& given,
                              const std::optional<WrittenModel>& output = {});

/// The hole in a few words: "Hole2: 4 sides, 31.4 mm around (10, 0, 5)".
std::string shortly(const occ::Hole& hole);

/// For people: a row for each new seam, those that miss the target first, then the largest figures
/// and the verdict.
std::string toTable(const occ::FillHoleReport& report, const occ::FillHoleOptions& options,
                    const std::optional<WrittenModel>& output = {});

}  // namespace seamwright::report
