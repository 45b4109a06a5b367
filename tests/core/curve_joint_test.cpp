// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <limits>
#include <numbers>
#include <seamwright/core/seam/curve_joint.hpp>

#include "curves.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::Vec;

constexpr int cases = 300;

std::vector<json> casesOf(const std::string& name) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/" + name);
  const json data = json::parse(file);
  return {data["cases"].begin(), data["cases"].end()};
}

/// The same place passed in the other sense.
CurveEnd reversed(CurveEnd end) {
  for (Eigen::Index k = 1; k < end.derivatives.rows(); k += 2) end.derivatives.row(k) *= -1;
  return end;
}

CurveEnd mapped(const CurveEnd& end, const Eigen::Matrix3d& map, const Vec& translation) {
  CurveEnd result = end;
  result.derivatives = end.derivatives * map.transpose();
  result.derivatives.row(0) += translation.transpose();
  return result;
}

void expectSame(const CurveJoint& x, const CurveJoint& y, double noise, int i) {
  ASSERT_TRUE(x.gap_mm && y.gap_mm && x.angle_rad && y.angle_rad) << i;
  EXPECT_NEAR(*x.gap_mm, *y.gap_mm, noise) << i;
  EXPECT_NEAR(*x.angle_rad, *y.angle_rad, noise) << i;
  ASSERT_EQ(x.differences.size(), y.differences.size()) << i;
  for (std::size_t k = 0; k < x.differences.size(); ++k) {
    EXPECT_NEAR(x.differences[k], y.differences[k], noise * (1 + y.differences[k]))
        << i << " order " << k;
    if (k > 0) {  // sizes[0] depends on the origin
      EXPECT_NEAR(x.sizes[k], y.sizes[k], noise * (1 + y.sizes[k])) << i << " order " << k;
    }
  }
}

TEST(CurveJoint, Identity1SwapAndReversal) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const CurveEnd a{test::randomDerivatives(5, random)}, b{test::randomDerivatives(5, random)};
    expectSame(measureJoint(reversed(b), reversed(a)), measureJoint(a, b), 1e-13, i);
  }
}

TEST(CurveJoint, Identity2MotionAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const CurveEnd a{test::randomDerivatives(5, random)}, b{test::randomDerivatives(5, random)};
    const CurveJoint plain = measureJoint(a, b);
    const Eigen::Matrix3d R = test::randomRotation(random);
    const Vec t = test::randomVector(random);
    expectSame(measureJoint(mapped(a, R, t), mapped(b, R, t)), plain, 1e-10, i);
    const double s = test::logUniform(random, -4, 4);
    const Eigen::Matrix3d S = s * Eigen::Matrix3d::Identity();
    CurveJoint scaled = measureJoint(mapped(a, S, s * t), mapped(b, S, s * t));
    for (int k = 2; k <= 5; ++k)
      EXPECT_NEAR(relativeDifference(scaled, k, 1e5 * s), relativeDifference(plain, k, 1e5), 1e-10);
    *scaled.gap_mm /= s;
    for (int k = 0; k <= 5; ++k) {
      scaled.differences[k] *= std::pow(s, k - 1);
      scaled.sizes[k] *= std::pow(s, k - 1);
    }
    expectSame(scaled, plain, 1e-9, i);
  }
}

TEST(CurveJoint, Identity3ReparametrisationChangesNothing) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const CurveEnd a{test::randomDerivatives(5, random)}, b{test::randomDerivatives(5, random)};
    const CurveEnd other{test::reparametrised(b.derivatives, test::randomParameter(5, random))};
    expectSame(measureJoint(a, other), measureJoint(a, b), 1e-6, i);
  }
}

TEST(CurveJoint, Identity4HalvesOfOneCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const int degree = 2 + i % 5;
    Poles poles(degree + 1, 3);
    Eigen::VectorXd weights(degree + 1);
    for (int k = 0; k <= degree; ++k) {
      poles.row(k) = (Vec(3.0 * k, 0, 0) + test::randomVector(random)).transpose();
      weights(k) = test::logUniform(random, -0.2, 0.2);
    }
    const auto [left, right] = BezierCurve(poles, weights).split(0.2 + 0.6 * i / cases);
    const int order = 7;
    const CurveJoint halves = measureJoint(left, right, order);
    for (int k = 2; k <= order; ++k)
      EXPECT_LT(relativeDifference(halves, k, 1e5), 1e-7) << i << " order " << k;
    EXPECT_EQ(orderReached(halves, {}), order);
    const CurveEnd end{left.derivatives(1, order)};
    const CurveEnd other{
        test::reparametrised(end.derivatives, test::randomParameter(order, random))};
    EXPECT_EQ(orderReached(measureJoint(end, other), {}), order) << i;
  }
}

TEST(CurveJoint, Identity5ArcThenClothoidIsG2AndNotG3) {
  std::mt19937_64 random(testSeed());
  for (const double r : {0.5, 10.0, 3000.0})
    for (const double rate : {1.0, 0.03, -1.0}) {
      const double c = rate / (r * r);
      const CurveEnd arc{test::clothoid(1 / r, 0, 4)};
      CurveEnd clothoid{test::clothoid(1 / r, c, 4)};
      if (rate > 0.5)
        clothoid.derivatives =
            test::reparametrised(clothoid.derivatives, r * test::randomParameter(4, random));
      const CurveJoint joint = measureJoint(arc, clothoid);
      for (const int k : {0, 1, 2}) EXPECT_NEAR(joint.differences[k], 0, 1e-14);
      EXPECT_NEAR(joint.differences[3], std::abs(c), 1e-12 * std::abs(c));
      EXPECT_EQ(orderReached(joint, {}), 2);
      // |c_3| = sqrt(kappa^4 + kappa_s^2) of the clothoid is the larger one.
      EXPECT_NEAR(relativeDifference(joint, 3, 1e5), std::abs(rate) / std::hypot(1, rate), 1e-12);
      const CurveJoint itself = measureJoint(CurveEnd{test::clothoid(1 / r, c, 4)}, clothoid);
      EXPECT_EQ(orderReached(itself, {}), 4);
    }
}

TEST(CurveJoint, Identity6ArcsDifferByTheirCurvatures) {
  for (const double R : {10.0, 10.1, 20.0, 1e4}) {
    const CurveJoint joint =
        measureJoint({test::clothoid(0.1, 0, 3)}, {test::clothoid(1 / R, 0, 3)});
    EXPECT_NEAR(joint.differences[2], std::abs(0.1 - 1 / R), 1e-15);
    EXPECT_NEAR(relativeDifference(joint, 2, 1e5), std::abs(1 - 10 / R), 1e-13);
    EXPECT_EQ(orderReached(joint, {}), R < 10.15 ? 3 : 1);
  }
}

TEST(CurveJoint, Identity7ACuspTurnsByAHalfTurn) {
  const CurveEnd arc{test::circle(3, 0.2, 4)};
  const CurveJoint cusp = measureJoint(arc, reversed(arc));
  EXPECT_NEAR(*cusp.angle_rad, std::numbers::pi, 1e-14);
  EXPECT_NEAR(cusp.differences[1], 2, 1e-14);
  EXPECT_EQ(orderReached(cusp, {}), 0);
}

bool hasPositiveWeights(const json& weights) {
  return std::ranges::all_of(weights, [](const json& weight) { return test::number(weight) > 0; });
}

TEST(CurveJoint, OracleOfSixtyDigits) {
  const std::vector<json> all = casesOf("curve_joints.json");
  int compared = 0;
  for (const json& entry : all) {
    SCOPED_TRACE(entry["name"].get<std::string>() + " " + entry["in"]["note"].get<std::string>());
    const json &in = entry["in"], &out = entry["out"];
    if (!hasPositiveWeights(in["left_weights"]) || !hasPositiveWeights(in["right_weights"]))
      continue;
    ++compared;
    const CurveJoint joint =
        measureJoint(test::bezierCurve(in["left"], in["left_weights"]),
                     test::bezierCurve(in["right"], in["right_weights"]), in["nmax"].get<int>());
    ASSERT_EQ(joint.differences.size(), out["defect"].size());
    const double L = in["L"];
    double size = 1;
    for (std::size_t k = 0; k < joint.differences.size(); ++k) {
      size = std::max({size, test::vector(out["cl"][k]).norm(), test::vector(out["cr"][k]).norm()});
      const double wanted =
          out["defect"][k].get<double>() / std::pow(L, static_cast<double>(k) - 1);
      // The tail of "exact" curves in the file is rounded to double.
      EXPECT_NEAR(joint.differences[k], wanted, 1e-10 * size) << "order " << k;
    }
    for (std::size_t k = 0; k < joint.differences.size(); ++k) {
      const double larger =
          std::max(test::vector(out["cl"][k]).norm(), test::vector(out["cr"][k]).norm());
      EXPECT_NEAR(joint.sizes[k], larger, 1e-10 * size) << "order " << k;
    }
    ContinuityTolerance tight;
    tight.gap_mm = tight.angle_rad = tight.curvature_rel = 1e-7;
    const bool exact = in["note"].get<std::string>().find("exact") != std::string::npos;
    if (exact) {
      EXPECT_EQ(orderReached(joint, tight), out["order_at_1e-7"].get<int>());
    }
  }
  EXPECT_GE(compared, 18);
}

TEST(CurveJoint, RationalJoinsReachTheOrderTheyWereBuiltFor) {
  int built = 0;
  for (const json& entry : casesOf("rational_curve_joins.json")) {
    SCOPED_TRACE(entry["id"].get<std::string>());
    const auto fromHomogeneous = [](const json& rows, int count) -> std::optional<BezierCurve> {
      Poles poles(count, 3);
      Eigen::VectorXd weights(count);
      for (int i = 0; i < count; ++i) {
        const json& row = rows[std::min<std::size_t>(i, rows.size() - 1)];
        weights(i) = test::number(row[3]);
        if (weights(i) <= 0) return std::nullopt;  // such curves are refused
        // Poles that the join leaves free go on beyond the last one.
        const int beyond = std::max(0, i - static_cast<int>(rows.size()) + 1);
        poles.row(i) = (test::vector(row) / weights(i) + beyond * Vec(1, 2, -0.5)).transpose();
      }
      return BezierCurve(poles, weights);
    };
    const auto& given = entry["input"]["Q_hom"];
    const int order = entry["input"]["order"], degree = entry["input"]["degree_bar"];
    const auto a = fromHomogeneous(given, static_cast<int>(given.size()));
    const auto b = fromHomogeneous(entry["expected"]["control_points_hom"], degree + 1);
    if (!a || !b) continue;
    ++built;
    const CurveJoint joint = measureJoint(*a, *b, order);
    for (int k = 0; k <= order; ++k)
      EXPECT_LT(joint.differences[k], 1e-9 * (1 + joint.sizes[k])) << k;
    EXPECT_EQ(orderReached(joint, {}), order);
    const double kappa = test::number(entry["expected"]["curvature"]);
    if (order >= 2) {
      EXPECT_NEAR(joint.sizes[2], kappa, 1e-12);
    }
    if (order >= 3) {
      const double c3 = Vec(kappa * kappa, test::number(entry["expected"]["dcurvature_ds"]),
                            kappa * test::number(entry["expected"]["torsion"]))
                            .norm();
      EXPECT_NEAR(joint.sizes[3], c3, 1e-11);
    }
  }
  EXPECT_GE(built, 5);
}

/// A straight line along x by its arc length, to fourth order, with these second, third and fourth
/// derivatives in y.
CurveEnd nearlyStraight(double second, double third, double fourth) {
  CurveDerivatives x = CurveDerivatives::Zero(5, 3);
  x(1, 0) = 1;
  x.col(1) << 0, 0, second, third, fourth;
  return {x};
}

TEST(CurveJoint, WhereAllBendingVanishesRoundingCountsForNothing) {
  const CurveEnd straight = nearlyStraight(0, 0, 0);
  EXPECT_EQ(orderReached(measureJoint(straight, nearlyStraight(9e-6, 9e-9, 9e-12)), {}), 4);
  EXPECT_EQ(orderReached(measureJoint(straight, nearlyStraight(9e-6, 9e-9, 2e-11)), {}), 3);
  EXPECT_EQ(orderReached(measureJoint(straight, nearlyStraight(9e-6, 1.1e-8, 9e-12)), {}), 2);
  EXPECT_EQ(orderReached(measureJoint(straight, nearlyStraight(1.1e-5, 0, 0)), {}), 1);
  // An inflection: c_2 and c_4 vanish, the scale is that of c_3.
  const CurveEnd inflection = nearlyStraight(0, 0.02, 0);
  EXPECT_EQ(orderReached(measureJoint(inflection, nearlyStraight(1e-12, 0.02, 1e-10)), {}), 4);
  EXPECT_EQ(orderReached(measureJoint(inflection, nearlyStraight(0, 0.02, 1e-3)), {}), 3);
  EXPECT_EQ(orderReached(measureJoint(inflection, straight), {}), 2);
}

TEST(CurveJoint, ClimbsByTheTolerances) {
  CurveEnd a{test::clothoid(0.1, 0.003, 4)}, b = a;
  b.derivatives.row(0) << 0, 0.011, 0;
  EXPECT_EQ(orderReached(measureJoint(a, b), {}), -1);
  b.derivatives.row(0) << 0, 0.009, 0;
  EXPECT_EQ(orderReached(measureJoint(a, b), {}), 4);
  const double turn = 0.11 * std::numbers::pi / 180;
  const CurveEnd turned =
      mapped(a, Eigen::AngleAxisd(turn, Vec::UnitZ()).toRotationMatrix(), Vec::Zero());
  EXPECT_NEAR(*measureJoint(a, turned).angle_rad, turn, 1e-15);
  EXPECT_EQ(orderReached(measureJoint(a, turned), {}), 0);
  EXPECT_EQ(orderReached(measureJoint(a, {test::clothoid(0.1021, 0.003, 4)}), {}), 1);
  EXPECT_EQ(orderReached(measureJoint({a.derivatives.topRows(2)}, a), {}), 1)
      << "the lower order of both";
  EXPECT_EQ(measureJoint(a, {a.derivatives.topRows(3)}).differences.size(), 3u);
  EXPECT_EQ(orderReached(measureJoint({a.derivatives.topRows(1)}, a), {}), 0);
}

TEST(CurveJoint, DegenerateEndsHaveNoFiguresBeyondTheGap) {
  const CurveEnd good{test::circle(2, 0, 3)};
  CurveEnd still = good;
  still.derivatives.row(1).setConstant(1e-13);
  still.speed_noise = 1e-12;
  const CurveJoint joint = measureJoint(good, still);
  EXPECT_EQ(joint.gap_mm, 0.0);
  EXPECT_FALSE(joint.angle_rad.has_value());
  EXPECT_TRUE(joint.differences.empty());
  EXPECT_EQ(orderReached(joint, {}), 0);
  CurveEnd nowhere = good;
  nowhere.derivatives(0, 2) = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(measureJoint(good, nowhere).gap_mm.has_value());
  EXPECT_EQ(orderReached(measureJoint(good, nowhere), {}), -1);
  Poles cusp(4, 3);
  cusp << 1, 1, 1, 1, 1, 1, 2, 3, 1, 4, 4, 4;
  const BezierCurve collapsed(cusp);
  EXPECT_FALSE(measureJoint(collapsed.reversed(), collapsed, 3).angle_rad.has_value());
  EXPECT_THROW(measureJoint({CurveDerivatives(0, 3)}, good), std::invalid_argument);
  ContinuityTolerance bad;
  bad.gap_mm = -1;
  EXPECT_THROW(orderReached(joint, bad), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
