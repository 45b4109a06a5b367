// SPDX-License-Identifier: LGPL-2.1-or-later
// How do two Bézier patches meet? The core alone: no files, no OpenCASCADE.
//
// Patch a is the plane z = 0 for 0 <= x <= 1; patch b continues it as z = 0.25 (x - 1)^2 for 1 <= x
// <= 2. They share the line x = 1 and its tangent plane. Across it the normal curvature jumps from
// 0 to 0.5 / mm.
#include <array>
#include <iostream>
#include <vector>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/seam/judge.hpp>
#include <seamwright/core/seam/survey.hpp>

using seamwright::BezierPatch;
using seamwright::SidePoint;

int main() {
  seamwright::Poles flat(6, 3),
      bent(6, 3);  // degree 2 in u, 1 in v: row i (n + 1) + j is the pole P[i][j]
  flat << 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 0.5, 1, 0, 1, 0, 0, 1, 1, 0;
  bent << 1, 0, 0, 1, 1, 0, 1.5, 0, 0, 1.5, 1, 0, 2, 0, 0.25, 2, 1, 0.25;
  const BezierPatch a(2, 1, flat), b(2, 1, bent);

  // The seam runs along u = 1 of a and u = 0 of b, both in the direction of v; a lies to its left,
  // b to its right.
  const auto pair_at = [&](double v) {
    const SidePoint left{a.jet(1, v), a.noise(), a.jet(1, v).v, true};
    const SidePoint right{b.jet(0, v), b.noise(), b.jet(0, v).v, false};
    return seamwright::measurePair(left, right);
  };
  const seamwright::ContinuityTolerance tolerance;
  const seamwright::SeamFigures seam =
      seamwright::surveySeam(pair_at, std::array{0.0, 1.0}, tolerance);
  const seamwright::Verdict verdict = seamwright::judge(seam, tolerance, seamwright::Level::G1);

  std::cout << "gap " << seam.gap_mm.value().lower << " mm, angle " << seam.angle_rad.value().lower
            << " rad, curvature difference " << seam.curvature_per_mm.value().lower
            << " / mm: " << seamwright::name(verdict.level) << ", "
            << seamwright::name(verdict.seam_class) << "\n";
}
