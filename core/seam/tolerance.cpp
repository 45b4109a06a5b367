// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/angle.hpp>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {

namespace {

constexpr double degree = radians_per_degree;

}  // namespace

const std::array<ToleranceProfile, 3>& toleranceProfiles() {
  static constexpr std::array<ToleranceProfile, 3> profiles = {
      {{"default",
        "mechanical parts",
        {.gap_mm = 0.01, .angle_rad = 0.1 * degree, .curvature_rel = 0.02}},
       {"class-a",
        "visible surfaces, judged by their reflections",
        {.gap_mm = 0.001, .angle_rad = 0.01 * degree, .curvature_rel = 0.02}},
       {"vda",
        "exchange of surfaces between CAD systems",
        {.gap_mm = 0.02, .angle_rad = 0.1 * degree, .curvature_rel = 0.1}}}};
  return profiles;
}

std::optional<ContinuityTolerance> toleranceProfile(std::string_view name) {
  for (const ToleranceProfile& profile : toleranceProfiles())
    if (profile.name == name) return profile.tolerance;
  return std::nullopt;
}

}  // namespace seamwright
