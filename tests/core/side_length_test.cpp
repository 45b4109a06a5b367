// SPDX-License-Identifier: LGPL-2.1-or-later
// Lengths of intervals of a side, across knot lines too.
#include <gtest/gtest.h>

#include <seamwright/core/seam/side_length.hpp>

#include "seam_sides.hpp"

using namespace seamwright;
using test::bezierDirection, test::linePath, test::splineOf, test::Vec;

namespace {

/// The x axis as a side whose speed changes at u = 1/2 from \p slow to \p fast.
SeamSide twoSpeeds(double slow, double fast) {
  const double middle = slow / 2, end = middle + fast / 2;
  std::vector<Vec> poles;
  for (const double x : {0.0, middle, end})
    for (const double y : {0.0, 1.0}) poles.push_back(Vec(x, y, 0));
  const SplineDirection u{1, {0, 0, 0.5, 1, 1}, 0};
  const auto surface =
      std::make_shared<SplineEvaluator>(u, bezierDirection(1), poles, std::vector<double>{});
  return {splineOf(linePath(0, 0.5, 1, 0.5)), splineEvaluator(surface)};
}

}  // namespace

// The true length lies in the bounds, wherever the knot line is in the interval.
TEST(SideLength, BoundsAcrossAKnotLine) {
  for (const auto& [slow, fast] : {std::pair(1.0, 1000.0), std::pair(1000.0, 1.0)}) {
    const SeamSide side = twoSpeeds(slow, fast);
    const SideEvaluator evaluator(side);
    const SideLength lengths(evaluator);
    for (const double width : {0x1p-2, 0x1p-20, 0x1p-31})  // below 2^-30 intervals are not cut
      for (const double before : {0.0, 0.01, 0.5, 0.99, 1.0}) {
        const double from = 0.5 - before * width, to = from + width;
        const double length = (0.5 - from) * slow + (to - 0.5) * fast;
        const Interval bounds = lengths.of(from, to);
        EXPECT_LE(bounds.lower, length) << width << " " << before;
        EXPECT_GE(bounds.upper, length) << width << " " << before;
      }
  }
}
