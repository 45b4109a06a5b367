// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <sstream>
#include <stdexcept>

#include <seamwright/core/surface/judge.hpp>

namespace seamwright {

void SurfaceTolerance::validate() const {
  std::ostringstream text;
  if (!(fairness >= 1) || !std::isfinite(fairness))
    text << "fairness is " << fairness << ": it must be a finite number, 1 or larger";
  else if (!(visible_per_mm >= 0) || !std::isfinite(visible_per_mm))
    text << "visible variation is " << visible_per_mm
         << " per mm: it must be finite and not negative";
  else
    return;
  throw std::invalid_argument(text.str());
}

double visibleVariation(double angle_rad, double size_mm) {
  return 3 * angle_rad / size_mm;
}

SurfaceVerdict judgeSurface(const SurfaceChange& change, const SurfaceTolerance& tolerance) {
  const double allowed =
      tolerance.fairness * change.before.variation_per_mm + tolerance.visible_per_mm;
  std::ostringstream text;
  if (!(change.after.variation_per_mm <= allowed)) {
    text << "its mean curvature varies by " << change.after.variation_per_mm
         << " per mm along a line, before by " << change.before.variation_per_mm;
    return {true, text.str()};
  }
  const int more = change.after.inflections - change.before.inflections;
  constexpr int lines_with_one = 5;
  if (lines_with_one * more > change.after.lines) {
    text << "it has " << more << " more inflections along " << change.after.lines << " lines";
    return {true, text.str()};
  }
  return {};
}

}  // namespace seamwright
