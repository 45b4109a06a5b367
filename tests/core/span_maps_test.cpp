// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/fair/span_maps.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

#include "noisy_curves.hpp"

namespace seamwright {
namespace {

TEST(BezierMap, MakesTheBezierPolesOfTheCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 30; ++i) {
    const int degree = 1 + i % 7;
    BSplineCurve curve = test::noisyCurve(degree, degree + 9, false, 1, random);
    // A knot of a multiplicity of up to the degree.
    for (int k = 1; k < 1 + static_cast<int>(random() % degree); ++k)
      curve.knots[degree + 2 + k] = curve.knots[degree + 2];
    std::sort(curve.knots.begin(), curve.knots.end());
    const BezierSpline wanted = bezierSpline(curve);
    Eigen::Index first = 0;
    for (int span = degree; span < curve.count(); ++span) {
      if (curve.knots[span] == curve.knots[span + 1]) continue;
      const Eigen::MatrixXd map = bezierMap(degree, curve.knots, span);
      EXPECT_GE(map.minCoeff(), 0);
      EXPECT_LT((map.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-14 * degree);
      const Eigen::MatrixXd found = map * curve.poles.middleRows(span - degree, degree + 1);
      EXPECT_LT((found - wanted.poles.middleRows(first, degree + 1)).cwiseAbs().maxCoeff(), 1e-12);
      first += degree;
    }
    EXPECT_EQ(first + 1, wanted.poles.rows());
  }
}

TEST(BernsteinDerivatives, AreThoseOfBezierCurves) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 8; ++degree) {
    Poles poles(degree + 1, 3);
    for (Eigen::Index i = 0; i < poles.size(); ++i)
      poles(i / 3, i % 3) = test::uniform(random, -1, 1);
    const double t = test::uniform(random, 0, 1);
    const Eigen::MatrixXd found = bernsteinDerivatives(degree, t) * poles;
    const Eigen::MatrixXd wanted = BezierCurve(poles).derivatives(t, 3);
    EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), 1e-11);
  }
}

}  // namespace
}  // namespace seamwright
