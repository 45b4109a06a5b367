// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <random>
#include <seamwright/core/blend/lateral_sheet.hpp>
#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/core/bspline/curve.hpp>

#include "support/random.hpp"

namespace seamwright {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Eigen::MatrixXd drawn(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& random) {
  return Eigen::MatrixXd::NullaryExpr(
      rows, columns, [&] { return std::uniform_real_distribution<double>(-1, 1)(random); });
}

const std::vector<double> inner = {0.2, 0.45, 0.45, 0.8};

std::vector<double> clamped(int degree, const std::vector<double>& inside) {
  std::vector<double> knots(degree + 1, 0);
  knots.insert(knots.end(), inside.begin(), inside.end());
  knots.insert(knots.end(), degree + 1, 1);
  return knots;
}

/// A sheet of degree 5 along over those knots, a polynomial across.
BSplineSurface sheetOf(int degree_across, std::mt19937_64& random) {
  BSplineSurface sheet;
  sheet.degree_u = 5;
  sheet.degree_v = degree_across;
  sheet.knots_u = clamped(5, inner);
  sheet.knots_v = clamped(degree_across, {});
  sheet.poles.setOnes(sheet.countU() * sheet.countV(), 4);
  sheet.poles.leftCols<3>() = drawn(sheet.poles.rows(), 3, random);
  return sheet;
}

double difference(const SurfaceJet& a, const SurfaceJet& b) {
  double sum = 0;
  for (const auto part : {&SurfaceJet::p, &SurfaceJet::u, &SurfaceJet::v, &SurfaceJet::uu,
                          &SurfaceJet::uv, &SurfaceJet::vv})
    sum += (a.*part - b.*part).norm();
  return sum;
}

CurveDerivatives across(int degree, const std::vector<double>& knots, const Eigen::MatrixXd& poles,
                        double v, int order) {
  BSplineCurve curve{degree, knots, HomogeneousPoles::Ones(poles.rows(), 4)};
  curve.poles.leftCols<3>() = poles;
  return derivatives(curve, v, order);
}

TEST(LateralSheet, Identity1SplinesWithZeroEndsAreReproduced) {
  std::mt19937_64 random(testSeed());
  for (int degree = 2; degree <= 7; ++degree)
    for (int first = 0; first <= 4; ++first)
      for (int last = 0; last <= 4; ++last) {
        const std::vector<double> knots = clamped(degree, {0.1, 0.2, 0.25, 0.5, 0.5, 0.7, 0.9});
        const ZeroEndInterpolation interpolation(degree, knots, first, last);
        const Eigen::Index count = static_cast<Eigen::Index>(knots.size()) - degree - 1;
        Eigen::MatrixXd poles = drawn(count, 3, random);
        poles.topRows(first).setZero();
        poles.bottomRows(last).setZero();
        Eigen::MatrixXd values(interpolation.parameters().size(), 3);
        for (Eigen::Index i = 0; i < values.rows(); ++i)
          values.row(i) = across(degree, knots, poles, interpolation.parameters()[i], 0);
        EXPECT_LT((interpolation.poles(values) - poles).norm(), 1e-11);
      }
}

TEST(LateralSheet, Identity2KnotsAcrossChangeNothing) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 5; ++degree) {
    const BSplineSurface sheet = sheetOf(degree, random);
    const BSplineSurface finer = withKnotsAcross(sheet, 5, clamped(5, inner));
    EXPECT_EQ(finer.degree_v, 5);
    EXPECT_EQ(finer.knots_v, clamped(5, inner));
    EXPECT_TRUE((finer.poles.col(3).array() == 1).all());
    for (const double u : {0.0, 0.3, 1.0})
      for (const double v : {0.0, 0.1, 0.6, 1.0})
        EXPECT_LT(difference(jet(finer, u, v), jet(sheet, u, v)), 1e-10);
  }
}

/// All constructions, with what they do at the boundary that they change.
TEST(LateralSheet, Identities3To6OneBoundaryMovesAndTheOtherStays) {
  std::mt19937_64 random(testSeed());
  const BSplineSurface sheet = withKnotsAcross(sheetOf(4, random), 5, clamped(5, inner));
  Eigen::MatrixXd poles = drawn(sheet.countV(), 3, random);
  poles.topRows(3).setZero();     // up to the second derivative
  poles.bottomRows(2).setZero();  // up to the first
  for (const LateralSide side : {LateralSide::First, LateralSide::Last}) {
    const double here = side == LateralSide::First ? 0 : 1;
    const BSplineSurface displaced = displacedBoundary(sheet, side, poles),
                         turned = turnedBoundary(sheet, side, poles),
                         bent = bentBoundary(sheet, side, poles);
    for (int i = 0; i <= 20; ++i) {
      const double v = i / 20.0;
      const Eigen::Vector3d moved = across(5, sheet.knots_v, poles, v, 0).row(0).transpose();
      const SurfaceJet before = jet(sheet, here, v);
      EXPECT_LT((jet(displaced, here, v).p - before.p - moved).norm(), 1e-12);
      EXPECT_LT((jet(turned, here, v).p - before.p).norm(), 1e-12);
      EXPECT_LT((jet(turned, here, v).u - before.u - moved).norm(), 1e-10);
      EXPECT_LT((jet(bent, here, v).p - before.p).norm(), 1e-12);
      EXPECT_LT((jet(bent, here, v).u - before.u).norm(), 1e-10);
      EXPECT_LT((jet(bent, here, v).uu - before.uu - moved).norm(), 1e-8);
      for (const BSplineSurface& changed : {displaced, turned, bent}) {
        EXPECT_LT(difference(jet(changed, 1 - here, v), jet(sheet, 1 - here, v)), 1e-10);
        // (4) at the ends across, by u everywhere.
        EXPECT_LT(difference(jet(changed, v, 0), jet(sheet, v, 0)), 1e-10);
        EXPECT_LT((jet(changed, v, 1).v - jet(sheet, v, 1).v).norm(), 1e-11);
      }
    }
    EXPECT_GT((jet(displaced, 0.5, 1).vv - jet(sheet, 0.5, 1).vv).norm(), 1e-3);
  }
}

TEST(LateralSheet, BadInputIsRefused) {
  std::mt19937_64 random(testSeed());
  const auto refused = [](const std::string& text) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(text));
  };
  const BSplineSurface sheet = sheetOf(3, random);
  EXPECT_THAT([&] { ZeroEndInterpolation(3, clamped(3, {}), 2, 2); }, refused("no pole is left"));
  EXPECT_THAT([&] { ZeroEndInterpolation(3, clamped(3, {}), -1, 2); }, refused("-1 and 2"));
  EXPECT_THAT([&] { withKnotsAcross(sheet, 2, clamped(2, {})); }, refused("degree across is 2"));
  EXPECT_THAT([&] { displacedBoundary(sheet, LateralSide::First, Eigen::MatrixXd(3, 3)); },
              refused("the displacement is 3 by 3: 4 by 3 is needed"));
  BSplineSurface low = sheet;
  low.degree_u = 2;
  low.knots_u = clamped(2, {});
  low.poles.conservativeResize(12, 4);
  EXPECT_THAT([&] { turnedBoundary(low, LateralSide::Last, Eigen::MatrixXd(4, 3)); },
              refused("the degree along is 2: at least 4 is needed"));
  BSplineSurface longer = sheet;
  for (double& knot : longer.knots_v) knot *= 2;
  EXPECT_THAT([&] { displacedBoundary(longer, LateralSide::First, Eigen::MatrixXd(4, 3)); },
              refused("not 0 to 1"));
}

}  // namespace
}  // namespace seamwright
