// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <seamwright/occ_adapter/fill/fill.hpp>
#include <string>

namespace seamwright::report {

/// {id, length_mm, has_corners, longest, sides: [{edges, faces, length_mm}]}.
nlohmann::ordered_json toJson(const occ::Hole& hole);

/// What came of a fill: {filled, reached, reason, target, tolerance, largest_gap_mm, largest_angle_deg, faces, regular, sides, corners,
/// outer, inner, time_s}; lengths in mm, angles in degrees, seams as in an analysis.
nlohmann::ordered_json toJson(const occ::FillHoleReport& report, const occ::FillHoleOptions& options);

/// The hole in a few words: "hole 2: 4 sides, 31.4 mm".
std::string shortly(const occ::Hole& hole);

/// What came of a fill, for people.
std::string toTable(const occ::FillHoleReport& report, const occ::FillHoleOptions& options);

}  // namespace seamwright::report
