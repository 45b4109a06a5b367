// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace seamwright {

/// What the user accepts. Comments are the inequality each field enters.
struct ContinuityTolerance {
  double gap_mm = 0.01;                           ///< G0: distance of the sides <= gap_mm
  double angle_rad = 0.1 * 0.017453292519943295;  ///< G1: angle of the tangent planes <= angle_rad
  double curvature_rel = 0.02;  ///< G2: relativeDifference(), G3: relativeChange() <= curvature_rel
  double flat_radius_mm = 1e5;  ///< flat: largest absolute normal curvature < 1 / flat_radius_mm
  double crease_rad =
      5 * 0.017453292519943295;  ///< a design edge: angle of the tangent planes > crease_rad

  /// \throws std::invalid_argument with name and value of the first field that is not finite,
  /// negative, or (flat radius) zero, or if crease_rad < angle_rad or an angle is above 90 degrees.
  void validate() const;
};

/// What a kind of work usually accepts, by name. Flat radius and crease angle are the same in all.
struct ToleranceProfile {
  std::string_view name;
  std::string_view purpose;
  ContinuityTolerance tolerance;
};

/// "default", "class-a" and "vda", in this order. Conventions, not standards: see docs/seams.md.
const std::array<ToleranceProfile, 3>& toleranceProfiles();

/// The tolerances of the profile of that name; nothing for another name.
std::optional<ContinuityTolerance> toleranceProfile(std::string_view name);

}  // namespace seamwright
