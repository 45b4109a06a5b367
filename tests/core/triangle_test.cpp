// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <seamwright/core/bezier/triangle.hpp>

#include "triangles.hpp"

namespace seamwright {
namespace {

using test::Vec;

TEST(BezierTriangle, PointsEqualTheDefinition) {
  std::mt19937_64 random(41);
  for (int degree = 0; degree <= 8; ++degree)
    for (const bool rational : {false, true}) {
      const BezierTriangle triangle = test::randomTriangle(degree, rational, random);
      EXPECT_EQ(triangle.degree(), degree);
      for (int i = 0; i < 5; ++i) {
        const Barycentric l = test::randomBarycentric(random);
        EXPECT_LT((triangle.point(l(0), l(1)) - test::exactPoint(triangle, l)).norm(), 1e-14) << degree;
      }
      EXPECT_EQ(triangle.point(1, 0), triangle.pole(degree, 0));
      EXPECT_EQ(triangle.point(0, 1), triangle.pole(0, degree));
      EXPECT_EQ(triangle.point(0, 0), triangle.pole(0, 0));
    }
}

}  // namespace
}  // namespace seamwright
