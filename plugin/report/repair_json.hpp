// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/plugin/report/written.hpp>

namespace seamwright::report {

/// Counts and the largest move of a repair.
struct RepairSummary {
  int seams = 0;
  int treated = 0;
  int repaired = 0;          ///< of those treated
  int left = 0;              ///< of those treated: left unrepaired
  int wants_conversion = 0;  ///< of those not treated, see occ::SeamRepair
  int sewn = 0;
  int lowered = 0;  ///< of those not treated: at a lower level than before, which the target allows
  int defects_before = 0;
  int defects_after = 0;
  double largest_move_mm = 0;
  int worse_faces = 0;  ///< of the moved faces: less fair than before
  bool changed = false;
  bool passed = false;  ///< no seam is a defect
};

/// Whether a seam that was not treated has a lower level than before, because a neighbour was
/// repaired. The level that was asked for is preserved.
bool isLowered(const occ::SeamRepair& seam);

RepairSummary summarize(const occ::RepairReport& report);

/// Counts in a file the seams of the analysis that judges the repair. If in memory no two faces
/// have both a common edge and a matched seam, such matched seams of the file are left out: edges
/// that were sewn and then continue apart would match again. Both arguments must outlive the
/// result.
Judge judgeOf(const occ::RepairReport& report, const occ::RepairOptions& options);

nlohmann::ordered_json toJson(const RepairSummary& summary);
nlohmann::ordered_json toJson(const occ::SeamRepair& seam, const ContinuityTolerance& tolerance);
/// Angles in degrees; surface is null if it could not be measured.
nlohmann::ordered_json toJson(const occ::FaceMove& move);
nlohmann::ordered_json toJson(const occ::EdgeMove& move);
nlohmann::ordered_json toJson(const occ::FaceConversion& conversion);

/// The report as the object "seamwright.repair/1" (docs/repair-1.schema.json), lengths in mm,
/// angles in degrees.
/// \param output nothing if the model was not written.
nlohmann::ordered_json toJson(const occ::RepairReport& report, const occ::RepairOptions& options,
                              const std::optional<WrittenModel>& output = {});

}  // namespace seamwright::report
