// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <seamwright/core/blend/hermite_sheet.hpp>
#include <seamwright/core/bspline/collocation.hpp>
#include <seamwright/core/bspline/curve.hpp>

#include "support/random.hpp"

namespace seamwright {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

double drawn(std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(-1, 1)(random);
}

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& random) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return drawn(random); });
}

/// Clamped knots with inner ones of several multiplicities.
std::vector<double> knotsOf(int degree, std::mt19937_64& random) {
  std::vector<double> knots(degree + 1, 0);
  double at = 0;
  for (int i = 0; i < 5; ++i) {
    at += 1.5 + drawn(random);
    knots.insert(knots.end(), 1 + i % degree, at);
  }
  knots.insert(knots.end(), degree + 1, at + 1);
  return knots;
}

BSplineCurve curveOf(int degree, const std::vector<double>& knots, const Eigen::MatrixXd& poles) {
  BSplineCurve curve{degree, knots, HomogeneousPoles::Ones(poles.rows(), 4)};
  curve.poles.leftCols<3>() = poles;
  return curve;
}

TEST(GrevilleInterpolation, Identity1PolynomialsAreReproduced) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 7; ++degree) {
    const GrevilleInterpolation interpolation(degree, knotsOf(degree, random));
    const Eigen::MatrixXd coefficients = randomMatrix(degree + 1, 3, random);
    const auto polynomial = [&](double t) {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (int k = degree; k >= 0; --k)
        sum = sum * (t / interpolation.knots().back()) + coefficients.row(k);
      return sum;
    };
    Eigen::MatrixXd values(interpolation.parameters().size(), 3);
    for (Eigen::Index i = 0; i < values.rows(); ++i)
      values.row(i) = polynomial(interpolation.parameters()[i]);
    const BSplineCurve curve = curveOf(degree, interpolation.knots(), interpolation.poles(values));
    for (int i = 0; i <= 40; ++i) {
      const double t = interpolation.knots().back() * i / 40;
      EXPECT_LT((derivatives(curve, t, 0).row(0) - polynomial(t)).norm(), 1e-12) << degree;
    }
  }
}

TEST(GrevilleInterpolation, Identity2ValuesAreMetAtTheParameters) {
  std::mt19937_64 random(testSeed());
  for (int degree = 1; degree <= 7; ++degree)
    for (const SplineClosure closure : {SplineClosure::Open, SplineClosure::Periodic}) {
      // At the closing point of a periodic spline there is one more knot.
      const GrevilleInterpolation interpolation(degree, knotsOf(degree, random), closure);
      if (closure == SplineClosure::Periodic && degree % 2 == 0) continue;
      const auto count = static_cast<Eigen::Index>(interpolation.parameters().size());
      const Eigen::MatrixXd values = randomMatrix(count, 3, random);
      const BSplineCurve curve =
          curveOf(degree, interpolation.knots(), interpolation.poles(values));
      for (Eigen::Index i = 0; i < count; ++i)
        EXPECT_LT(
            (derivatives(curve, interpolation.parameters()[i], 0).row(0) - values.row(i)).norm(),
            1e-10)
            << degree << " " << i;
    }
}

TEST(GrevilleInterpolation, Identity3PeriodicSplinesAreSmoothAcrossTheEnds) {
  std::mt19937_64 random(testSeed());
  for (const int degree : {1, 3, 5, 7}) {
    const GrevilleInterpolation interpolation(degree, knotsOf(degree, random),
                                              SplineClosure::Periodic);
    EXPECT_EQ(interpolation.parameters().size() + degree,
              interpolation.knots().size() - degree - 1);
    const Eigen::MatrixXd values =
        randomMatrix(static_cast<Eigen::Index>(interpolation.parameters().size()), 3, random);
    const BSplineCurve curve = curveOf(degree, interpolation.knots(), interpolation.poles(values));
    const CurveDerivatives first = derivatives(curve, 0, degree - 1),
                           last = derivatives(curve, curve.knots.back(), degree - 1);
    for (int k = 0; k < degree; ++k)
      EXPECT_LT((first.row(k) - last.row(k)).norm(), 1e-8 * (1 + first.row(k).norm()))
          << degree << " " << k;
  }
}

TEST(GrevilleInterpolation, ACircleIsMetToTheSixthOrder) {
  double before = 0;
  for (const int spans : {16, 32}) {
    std::vector<double> knots(6, 0);
    for (int i = 1; i < spans; ++i) knots.push_back(static_cast<double>(i) / spans);
    knots.insert(knots.end(), 6, 1);
    const GrevilleInterpolation interpolation(5, knots, SplineClosure::Periodic);
    const auto point = [](double t) {
      return Eigen::RowVector3d(std::cos(2 * M_PI * t), std::sin(2 * M_PI * t), 0);
    };
    Eigen::MatrixXd values(interpolation.parameters().size(), 3);
    for (Eigen::Index i = 0; i < values.rows(); ++i)
      values.row(i) = point(interpolation.parameters()[i]);
    const BSplineCurve curve = curveOf(5, knots, interpolation.poles(values));
    double error = 0;
    for (int i = 0; i < 1000; ++i)
      error = std::max(error, (derivatives(curve, i / 1e3, 0).row(0) - point(i / 1e3)).norm());
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / error), 6, 0.5);
    }
    before = error;
  }
}

SheetRibbon randomRibbon(int order, int degree, const std::vector<double>& knots,
                         std::mt19937_64& random) {
  SheetRibbon ribbon{.degree = degree, .knots = knots, .derivatives = {}};
  const auto count = static_cast<Eigen::Index>(knots.size()) - degree - 1;
  for (int k = 0; k <= order; ++k) ribbon.derivatives.emplace_back(randomMatrix(count, 3, random));
  return ribbon;
}

Eigen::Vector3d partialByV(const SurfaceJet& jet, int order) {
  return order == 0 ? jet.p : order == 1 ? jet.v : order == 2 ? jet.vv : jet.vvv;
}

TEST(HermiteSheet, Identity1PartialsAreThoseOfTheRibbons) {
  std::mt19937_64 random(testSeed());
  for (int m = 0; m <= 3; ++m)
    for (int n = 0; n <= 3; ++n) {
      const int degree = 1 + (m + n) % 5;
      const std::vector<double> knots = knotsOf(degree, random);
      const std::array<SheetRibbon, 2> ends = {randomRibbon(m, degree, knots, random),
                                               randomRibbon(n, degree, knots, random)};
      const BSplineSurface sheet = hermiteSheet(ends[0], ends[1]);
      EXPECT_EQ(sheet.degree_v, m + n + 1);
      for (int end = 0; end < 2; ++end)
        for (int k = 0; k <= ends[end].order(); ++k)
          for (int i = 0; i <= 20; ++i) {
            const double u = knots.back() * i / 20;
            const Eigen::Vector3d expected =
                derivatives(curveOf(degree, knots, ends[end].derivatives[k]), u, 0).row(0);
            EXPECT_LT((partialByV(jet(sheet, u, end), k) - expected).norm(), 1e-11)
                << m << n << " end " << end << " order " << k;
          }
    }
}

/// The ribbon of a surface at an end of v.
SheetRibbon ribbonOf(const BSplineSurface& surface, int end, int order) {
  const GrevilleInterpolation interpolation(surface.degree_u, surface.knots_u);
  SheetRibbon ribbon{.degree = surface.degree_u, .knots = surface.knots_u, .derivatives = {}};
  for (int k = 0; k <= order; ++k) {
    Eigen::MatrixXd values(surface.countU(), 3);
    for (Eigen::Index i = 0; i < values.rows(); ++i)
      values.row(i) = partialByV(jet(surface, interpolation.parameters()[i], end), k).transpose();
    ribbon.derivatives.emplace_back(interpolation.poles(values));
  }
  return ribbon;
}

TEST(HermiteSheet, Identity2SurfacesOfThatDegreeAreReproduced) {
  std::mt19937_64 random(testSeed());
  for (int m = 0; m <= 3; ++m)
    for (int n = 0; n <= 3; ++n) {
      BSplineSurface surface;
      surface.degree_u = 3;
      surface.degree_v = m + n + 1;
      surface.knots_u = knotsOf(3, random);
      surface.knots_v.assign(m + n + 2, 0);
      surface.knots_v.insert(surface.knots_v.end(), m + n + 2, 1);
      surface.poles.setOnes(static_cast<Eigen::Index>(surface.countU()) * (m + n + 2), 4);
      surface.poles.leftCols<3>() = randomMatrix(surface.poles.rows(), 3, random);
      const BSplineSurface sheet = hermiteSheet(ribbonOf(surface, 0, m), ribbonOf(surface, 1, n));
      EXPECT_LT((sheet.poles - surface.poles).cwiseAbs().maxCoeff(), 1e-11) << m << n;
    }
}

TEST(HermiteSheet, Identity3SwappedEndsReverseTheSheet) {
  std::mt19937_64 random(testSeed());
  const std::vector<double> knots = knotsOf(3, random);
  const SheetRibbon start = randomRibbon(3, 3, knots, random),
                    end = randomRibbon(2, 3, knots, random);
  const auto negated = [](SheetRibbon ribbon) {
    for (int k = 1; k <= ribbon.order(); k += 2) ribbon.derivatives[k] *= -1;
    return ribbon;
  };
  const BSplineSurface sheet = hermiteSheet(start, end),
                       swapped = hermiteSheet(negated(end), negated(start));
  for (int i = 0; i <= 10; ++i)
    EXPECT_LT((jet(sheet, 1, i / 10.0).p - jet(swapped, 1, 1 - i / 10.0).p).norm(), 1e-12);
}

TEST(TaylorSheet, Identity4HigherPartialsVanish) {
  std::mt19937_64 random(testSeed());
  const SheetRibbon start = randomRibbon(2, 4, knotsOf(4, random), random);
  const BSplineSurface sheet = taylorSheet(start);
  EXPECT_EQ(sheet.degree_v, 2);
  for (int i = 0; i <= 10; ++i) {
    const double u = start.knots.back() * i / 10;
    const SurfaceJet from = jet(sheet, u, 0), to = jet(sheet, u, 1);
    EXPECT_LT((from.p + from.v + from.vv / 2 - to.p).norm(), 1e-12);
    EXPECT_LT((from.vv - to.vv).norm(), 1e-11);
  }
}

TEST(HermiteSheet, BadRibbonsAreRefused) {
  std::mt19937_64 random(testSeed());
  const SheetRibbon good = randomRibbon(1, 3, knotsOf(3, random), random);
  SheetRibbon other = good, empty = good, broken = good;
  for (double& knot : other.knots) knot *= 2;
  empty.derivatives.clear();
  broken.derivatives[1](2, 1) = std::nan("");
  const auto refused = [](const char* text) {
    return ThrowsMessage<std::invalid_argument>(HasSubstr(text));
  };
  EXPECT_THAT([&] { hermiteSheet(good, other); }, refused("differ in degree or knots"));
  EXPECT_THAT([&] { hermiteSheet(empty, good); }, refused("start: it has no position"));
  EXPECT_THAT([&] { hermiteSheet(good, broken); }, refused("end, derivative 1"));
  EXPECT_THAT([&] { taylorSheet(randomRibbon(0, 3, good.knots, random)); },
              refused("no derivative"));
}

}  // namespace
}  // namespace seamwright
