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

/// The counts of a fill in memory: seams are the new ones, defects are the new seams that do not
/// certainly reach the target.
ModelCounts countsOf(const occ::FillHoleReport& report, const occ::FillHoleOptions& options);

/// The counts of the file of a fill, by an analysis of the seams of the new faces.
/// \param model as read back from the file
ModelCounts countsOf(const occ::Report& found, const occ::Model& model,
                     const occ::FillHoleOptions& options);

/// Counts in a file the seams of the new faces. Counts the seams of all faces if the file does not
/// have the faces of the model in memory, or if the model was not filled. Both arguments must
/// outlive the result.
Judge judgeOf(const occ::FillHoleReport& report, const occ::FillHoleOptions& options);

/// The report as the object "seamwright.fill/1" (docs/fill-1.schema.json), lengths in mm, angles in
/// degrees.
/// \param given the model as it was read. \param output nothing if the model was not written.
nlohmann::ordered_json toJson(const occ::FillHoleReport& report,
                              const occ::FillHoleOptions& options, const occ::ModelFacts& given,
                              const std::optional<WrittenModel>& output = {});

/// The hole in a few words: "Hole2: 4 sides, 31.4 mm around (10, 0, 5)".
std::string shortly(const occ::Hole& hole);

/// The result as text: a row for each new seam, those that miss the target first, then the largest
/// figures and the verdict.
std::string toTable(const occ::FillHoleReport& report, const occ::FillHoleOptions& options,
                    const std::optional<WrittenModel>& output = {});

}  // namespace seamwright::report
