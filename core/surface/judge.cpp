// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/surface/judge.hpp>

namespace seamwright {

void SurfaceTolerance::validate() const {
  if (!(fairness >= 1) || !std::isfinite(fairness))
    throw std::invalid_argument(
        fmt::format("fairness is {:.6g}: it must be a finite number, 1 or larger", fairness));
  if (!(visible_per_mm >= 0) || !std::isfinite(visible_per_mm))
    throw std::invalid_argument(fmt::format(
        "visible variation is {:.6g} per mm: it must be finite and not negative", visible_per_mm));
}

double visibleVariation(double angle_rad, double size_mm) {
  return 3 * angle_rad / size_mm;
}

SurfaceFault judgeSurface(const SurfaceChange& change, const SurfaceTolerance& tolerance) {
  const double allowed =
      tolerance.fairness * change.before.variation_per_mm + tolerance.visible_per_mm;
  if (!(change.after.variation_per_mm <= allowed)) return SurfaceFault::Variation;
  const int more = change.after.inflections - change.before.inflections;
  // A choice: a few new inflections are noise of nearly straight lines, which nobody sees.
  constexpr int lines_with_one = 5;
  return lines_with_one * more > change.after.lines ? SurfaceFault::Inflections
                                                    : SurfaceFault::None;
}

}  // namespace seamwright
