// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <string>
#include <string_view>

namespace seamwright::report {

std::string_view name(occ::SeamKind kind);
using seamwright::name;

/// Counts and maxima of a report.
struct Summary {
  std::map<Level, int> by_level;  ///< every level has an entry
  int smooth = 0;
  int defects = 0;
  int creases = 0;
  int uncertified = 0;       ///< seams whose verdict is not certain
  int matched = 0;           ///< seams of two free edges
  double max_gap_mm = 0;     ///< largest seen
  double max_angle_rad = 0;  ///< largest seen
};

Summary summarize(const occ::Report& report);

/// An angle that was given in degrees, without the rounding of its conversion to radians and back:
/// its nearest number of 14 digits.
double givenDegrees(double angle_rad);

/// The remarks on a seam: its own note, and why its verdict is not certain or a bound up to G2 is
/// missing.
std::string noteOf(const occ::SeamResult& seam, const ContinuityTolerance& tolerance);

}  // namespace seamwright::report
