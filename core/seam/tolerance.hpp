// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <seamwright/core/angle.hpp>

namespace seamwright {

/// The tolerances of the user. The comment of each field is the inequality in which it occurs.
struct ContinuityTolerance {
  double gap_mm = 0.01;                         ///< G0: distance of the sides <= gap_mm
  double angle_rad = 0.1 * radians_per_degree;  ///< G1: angle of the tangent planes <= angle_rad
  double curvature_rel = 0.02;  ///< G2: relativeDifference(), G3: relativeChange() <= curvature_rel
  double flat_radius_mm = 1e5;  ///< flat: largest absolute normal curvature < 1 / flat_radius_mm
  double crease_rad = 5 * radians_per_degree;  ///< crease: angle of the tangent planes > crease_rad

  /// \throws std::invalid_argument with name and value of the first field that is not finite, is
  /// negative, or is zero (flat radius only); also if crease_rad < angle_rad or an angle is above
  /// 90 degrees.
  void validate() const;
};

/// The tolerances that are usual for a kind of work, by name. All profiles have the same flat
/// radius and crease angle.
struct ToleranceProfile {
  std::string_view name;
  std::string_view purpose;
  ContinuityTolerance tolerance;
};

/// The profiles "default", "class-a" and "vda", in this order. They are conventions, not standards:
/// see docs/seams.md.
const std::array<ToleranceProfile, 3>& toleranceProfiles();

/// The tolerances of the profile with that name; nothing for another name.
std::optional<ContinuityTolerance> toleranceProfile(std::string_view name);

}  // namespace seamwright
