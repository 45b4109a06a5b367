// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/convert/nearest.hpp>

namespace seamwright::occ {

double nearestPlace(const FaceStrip& path, const Eigen::Vector3d& p, double start, double low, double high) {
  double s = std::clamp(start, low, high);
  PathPoint at = path.trace(s);
  double distance = (p - at.p).squaredNorm();
  constexpr int most_steps = 60, most_halvings = 10;
  for (int i = 0; i < most_steps; ++i) {
    const double full = (p - at.p).dot(at.d) / at.d.squaredNorm();
    if (!std::isfinite(full)) return s;
    bool downhill = false;
    for (double step = full; !downhill && std::abs(step) >= std::ldexp(std::abs(full), -most_halvings);
         step /= 2) {
      const double next = std::clamp(s + step, low, high);
      if (std::abs(next - s) < 1e-13) return next;
      const PathPoint there = path.trace(next);
      const double closer = (p - there.p).squaredNorm();
      if (!(closer < distance)) continue;
      downhill = true;
      s = next;
      at = there;
      distance = closer;
    }
    if (!downhill) return s;
  }
  return s;
}

}  // namespace seamwright::occ
