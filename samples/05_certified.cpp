// SPDX-License-Identifier: LGPL-2.1-or-later
// Is a seam of two Bézier patches G1, at every point of it? The core alone: no files, no
// OpenCASCADE.
//
// Both patches have degree 4 along the seam x = 0. Patch a is level, z = 0. The slope of patch b
// across the seam is 0.002 times (4 v (1 - v) (1 - 2 v)^2). It is zero at v = 0, 1/2 and 1, where a
// coarse check would put its points. It is largest, 0.0005, at (1 -+ sqrt(1/2)) / 2 between them.
// So the angle is atan(0.0005) = 0.0286479 degrees.
#include <cmath>
#include <iostream>
#include <numbers>

#include <seamwright/core/seam/judge.hpp>
#include <seamwright/core/seam/patch_side.hpp>

using seamwright::BezierPatch;
using seamwright::PatchEdge;

/// A patch of degree 1 across the seam and 4 along it. x goes from \p from to \p to; the poles at
/// both ends have the given heights.
BezierPatch strip(double from, double to, const double (&heights_from)[5],
                  const double (&heights_to)[5]) {
  seamwright::Poles poles(10, 3);
  for (int j = 0; j < 5; ++j) {
    poles.row(j) << from, 0.25 * j, heights_from[j];
    poles.row(5 + j) << to, 0.25 * j, heights_to[j];
  }
  return {1, 4, poles};
}

int main() {
  constexpr double level[5] = {0, 0, 0, 0, 0};
  // 4 v (1 - v) (1 - 2 v)^2 has the Bernstein coefficients 0, 1, -4/3, 1, 0.
  constexpr double bent[5] = {0, 0.002, -0.002 * 4 / 3, 0.002, 0};
  const BezierPatch a = strip(-1, 0, level, level), b = strip(0, 1, level, bent);

  const seamwright::SeamSide left = seamSide(a, PatchEdge::U1), right = seamSide(b, PatchEdge::U0);
  for (const double accepted_deg : {0.05, 0.01}) {
    seamwright::ContinuityTolerance tolerance;
    tolerance.angle_rad = accepted_deg * std::numbers::pi / 180;
    const seamwright::SeamFigures seam = encloseSeam(left, right, tolerance);
    const seamwright::Verdict verdict = judge(seam, tolerance, seamwright::Level::G1);

    const seamwright::Figure angle = seam.angle_rad.value();
    constexpr double degrees = 180 / std::numbers::pi;
    std::cout << "accepted " << accepted_deg << ": angle " << degrees * angle.lower << " to "
              << degrees * angle.upper.value_or(HUGE_VAL) << " deg, " << name(verdict.level) << ", "
              << name(verdict.seam_class) << (verdict.certain ? ", certain\n" : ", not certain\n");
  }
}
