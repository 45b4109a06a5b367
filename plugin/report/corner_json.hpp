// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/plugin/report/written.hpp>
#include <string>

namespace seamwright::report {

/// "patches" or "opencascade".
const char* fillerName(occ::CornerFiller filler);

/// Counts the seams of the new faces. Counts the seams of all faces if a model does not have the
/// faces of the model in memory. Both arguments must outlive the result.
Judge judgeOf(const occ::CornerFillet& fillet, const occ::CornerFilletOptions& options);

/// The report as the object "seamwright.corner/1" (docs/corner-1.schema.json), lengths in mm,
/// angles in degrees.
/// \param given the model as it was read. \param output nothing if the model was not written.
nlohmann::ordered_json toJson(const occ::CornerFillet& fillet, const ContinuityTolerance& tolerance,
                              int vertex, const occ::ModelFacts& given,
                              const std::optional<WrittenModel>& output = {});

/// The result as text. \param memory the counts that \p output is compared with.
std::string toTable(const occ::CornerFillet& fillet, const ModelCounts& memory,
                    const std::optional<WrittenModel>& output);

}  // namespace seamwright::report
