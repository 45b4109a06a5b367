// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/match/match_sides.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <string>

namespace seamwright::report {

/// Counts the seams of the face that was matched. \param order the highest of its sides.
Judge judgeOf(int face, int order, const occ::SideMatchOptions& options);

/// The report as the object "seamwright.match/1" (docs/match-1.schema.json), lengths in mm, angles
/// in degrees.
/// \param given the model as it was read. \param output nothing if the model was not written.
nlohmann::ordered_json toJson(const occ::SideMatchReport& match, int face,
                              const occ::SideMatchOptions& options, const occ::ModelFacts& given,
                              const std::optional<WrittenModel>& output = {});

/// The keys "seams" and "moves" of that object.
nlohmann::ordered_json seamsJson(const occ::SideMatchReport& match,
                                 const ContinuityTolerance& tolerance);
nlohmann::ordered_json movesJson(const std::vector<occ::FaceMove>& moves);

/// The result as text: a row for each seam, then the moved faces, the file and the verdict.
/// \param memory the counts that \p output is compared with.
std::string toTable(const occ::SideMatchReport& match, const ContinuityTolerance& tolerance,
                    const ModelCounts& memory, const std::optional<WrittenModel>& output);

}  // namespace seamwright::report
