// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <numbers>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string_view>

namespace seamwright::report {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

std::string_view name(occ::SeamKind kind);
using seamwright::name;

/// Counts and maxima of a report.
struct Summary {
  std::map<Level, int> by_level;  ///< every level has an entry
  int smooth = 0;
  int defects = 0;
  int creases = 0;
  int uncertified = 0;
  double max_gap_mm = 0;
  double max_angle_rad = 0;
};

Summary summarize(const occ::Report& report);

}  // namespace seamwright::report
