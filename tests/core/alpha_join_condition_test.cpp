// SPDX-License-Identifier: LGPL-2.1-or-later
// Which alpha-surfaces can join: against linear algebra of the basis itself, jets of the patches,
// and the data of 60 digits.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <array>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/spline/alpha_join_condition.hpp>

#include "alphas.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::balance;
using test::randomSurface;
using test::uniform;
using test::Vec;
using testing::HasSubstr;

/// Values of the basis at nine parameters.
Eigen::Matrix<double, 9, 4> collocation(double a) {
  Eigen::Matrix<double, 9, 4> values;
  for (int k = 0; k < 9; ++k) values.row(k) = alphaBasis(a, k / 8.0).transpose();
  return values;
}

TEST(AlphaJoinCondition, CurvesOfTwoShapesAreTheBalancedOnes) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double a = uniform(0.1, 1, random), c = i % 2 ? uniform(0.1, 1, random) : a;
    Eigen::Matrix<double, 9, 8> both;
    both << collocation(a), collocation(c);
    Eigen::FullPivLU<Eigen::MatrixXd> lu(both);
    lu.setThreshold(1e-9);
    if (c != a && std::abs(c - a) < 1e-3) continue;
    EXPECT_EQ(lu.rank(), a == c ? 4 : 5) << "spaces of 4 that share 3";
    if (a == c) continue;
    for (const Eigen::VectorXd& x :
         {Eigen::VectorXd(lu.kernel().col(0)), Eigen::VectorXd(lu.kernel().col(2))})
      EXPECT_NEAR(x(0) + x(3) - x(1) - x(2), 0, 1e-8 * x.norm() / std::abs(c - a));
  }
}

TEST(AlphaJoinCondition, Identity1WhichOrdersThereAre) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    AlphaSurface given = randomSurface(random);
    EXPECT_TRUE(alphaSeamCondition(given, given.a_v).any_net);
    EXPECT_EQ(alphaSeamCondition(given, given.a_v).order, 2);
    const double c = uniform(0.1, 1, random);
    EXPECT_EQ(alphaSeamCondition(given, c).order, -1) << "no general net";
    const int order = i % 3;
    balance(given, order);
    const AlphaSeamCondition condition = alphaSeamCondition(given, c);
    EXPECT_EQ(condition.order, order);
    EXPECT_FALSE(condition.any_net);
    AlphaSurface moved = given;
    moved.poles(4 * (3 - order) + 1, 2) += 1e-6 * 10;
    EXPECT_EQ(alphaSeamCondition(moved, c).order, order - 1);
    EXPECT_NEAR(alphaSeamCondition(moved, c).defects_mm[order], 1e-5, 1e-14);
  }
}

TEST(AlphaJoinCondition, Identity2AllowedIsBuiltForbiddenRefused) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 600; ++i) {
    AlphaSurface given = randomSurface(random);
    const int balanced = i % 4 - 1;
    balance(given, balanced);
    AlphaJoin join;
    join.next_a_v = i % 8 < 4 ? uniform(0.1, 1, random) : given.a_v;
    join.next_a_u = uniform(0.2, 1, random);
    join.beta1 = uniform(0.5, 1.5, random);
    join.beta2 = uniform(-1, 1, random);
    const int possible = alphaSeamCondition(given, join.next_a_v).order;
    for (join.order = 1; join.order <= 2; ++join.order) {
      const std::string said = test::complaint([&] { alphaJoinRows(given, join); });
      EXPECT_EQ(said == "nothing was refused", join.order <= possible) << said;
    }
  }
}

/// The family by brute force: unknown alpha, beta(0), beta(1) and the row of Y_u, equations at nine
/// parameters.
Eigen::Index bruteDimension(const AlphaSurface& given, double next_a_v) {
  const BezierPatch patch = alphaSurfacePatch(given);
  Eigen::Matrix<double, 27, 15> equations = Eigen::Matrix<double, 27, 15>::Zero();
  for (int k = 0; k < 9; ++k) {
    const double v = k / 8.0;
    const SurfaceJet jet = patch.jet(1, v);
    equations.block<3, 1>(3 * k, 0) = jet.u;
    equations.block<3, 1>(3 * k, 1) = (1 - v) * jet.v;
    equations.block<3, 1>(3 * k, 2) = v * jet.v;
    for (int j = 0; j < 4; ++j)
      equations.block<3, 3>(3 * k, 3 + 3 * j) =
          -alphaBasis(next_a_v, v)(j) * Eigen::Matrix3d::Identity();
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(equations);
  qr.setThreshold(1e-10);
  return 15 - qr.rank();
}

TEST(AlphaJoinCondition, Identity3FamiliesOfGeneralNets) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    AlphaSurface given = randomSurface(random);
    const int balanced = i % 3 - 1;
    balance(given, balanced);
    const AlphaSeamCondition same = alphaSeamCondition(given, given.a_v);
    ASSERT_EQ(same.first_rows.cols(), 1);
    EXPECT_TRUE(same.g1);
    EXPECT_LE(same.first_rows.col(0).tail<2>().norm(), 1e-10 * same.first_rows.col(0).norm());
    const double c = uniform(0.1, 1, random);
    if (std::abs(c - given.a_v) < 0.01) continue;
    const AlphaSeamCondition other = alphaSeamCondition(given, c);
    EXPECT_EQ(other.first_rows.cols(), balanced == 1 ? 1 : 0);
    EXPECT_EQ(other.g1, balanced == 1);
    if (i < 60) {
      EXPECT_EQ(bruteDimension(given, given.a_v), 1);
      EXPECT_EQ(bruteDimension(given, c), other.first_rows.cols());
    }
  }
}

/// A net with this row 3.
AlphaSurface withEdge(double a, const Vec& x0, const Vec& x1, const Vec& x2, const Vec& x3,
                      std::mt19937_64& random) {
  AlphaSurface surface = randomSurface(random);
  surface.poles.bottomRows<4>() << x0.transpose(), x1.transpose(), x2.transpose(), x3.transpose();
  surface.a_v = a;
  return surface;
}

/// The three curved boundaries along which an edge of shape a lets the derivative slide; of X_v's
/// coefficients A, B, 0, C, D.
AlphaSurface curvedEdge(int kind, std::mt19937_64& random) {
  const Vec A = Vec(0, 1, 0) + 0.3 * test::randomVector(random),
            D = Vec(0, 1, 0) + 0.3 * test::randomVector(random);
  const double a = kind == 0 ? 2.0 / 3 : kind == 1 ? 0.8 : 1;
  const Vec B = kind == 2 ? Vec(-(A + D) / 4) : Vec((A - D) / 4);
  const Vec C = kind == 0 ? Vec(-B) : kind == 1 ? Vec::Zero() : B;
  const Vec x0 = test::randomVector(random), x3 = x0 + A + B + C + D;
  return withEdge(a, x0, x0 + A / a, x3 - D / a, x3, random);
}

TEST(AlphaJoinCondition, Identity4CurvedBoundariesThatSlide) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 150; ++i) {
    const AlphaSurface given = curvedEdge(i % 3, random);
    const AlphaSeamCondition condition = alphaSeamCondition(given, given.a_v);
    ASSERT_EQ(condition.first_rows.cols(), 2) << i % 3;
    EXPECT_TRUE(condition.g1);
    if (i < 30) {
      EXPECT_EQ(bruteDimension(given, given.a_v), 2);
    }
    // The edge is curved, so straight boundaries are not the only ones.
    const CurveDerivatives x = alphaSurfacePatch(given).isoCurveU(1).derivatives(0.3, 2);
    EXPECT_GT(Vec(x.row(1)).cross(Vec(x.row(2))).norm(), 1e-3);
    AlphaSurface moved = given;
    moved.poles(13, 0) += 1e-6;
    EXPECT_EQ(alphaSeamCondition(moved, given.a_v).first_rows.cols(), 1);
    AlphaSurface other = given;
    other.a_v = given.a_v - 0.05;
    EXPECT_EQ(alphaSeamCondition(other, other.a_v).first_rows.cols(), 1)
        << "each belongs to one shape";
  }
}

/// What A, B, C, D of an edge of shape a fulfil, coordinate by coordinate, that slides with
/// beta(0), beta(1): equations (i) and (ii) of beta X_v, and that q_2 = q_3 of the edge itself is
/// the middle of its inner poles. If its rank is 3 all four are parallel.
double thirdSingularValue(double a, double beta0, double beta1) {
  Eigen::Matrix<double, 3, 4> equations;
  equations << 0, beta1, -beta0, 0,  //
      beta1 - 5 * (1 - a) * beta0, 4 * beta0 - 2 * a * beta1, 4 * beta1 - 2 * a * beta0,
      beta0 - 5 * (1 - a) * beta1,  //
      -(1 - a), a, -a, 1 - a;
  equations.rowwise().normalize();
  return Eigen::JacobiSVD<Eigen::MatrixXd>(equations).singularValues()(2);
}

TEST(AlphaJoinCondition, NoOtherCurvedBoundarySlides) {
  const double right = std::acos(0.0);
  const std::array<std::pair<double, double>, 4> known = {
      {{2.0 / 3, 1.5 * right}, {0.8, 0}, {0.8, right}, {1, 0.5 * right}}};
  for (const auto& [a, turn] : known)
    EXPECT_LE(thirdSingularValue(a, std::cos(turn), std::sin(turn)), 1e-15);
  for (int i = 1; i <= 200; ++i)
    for (int k = 0; k < 400; ++k) {
      const double a = i / 200.0, turn = 2 * right * k / 400;
      double nearest = 1;
      for (const auto& [shape, angle] : known)
        for (const double around : {-2 * right, 0.0, 2 * right})
          nearest = std::min(nearest, std::hypot(a - shape, turn - angle - around));
      EXPECT_GT(thirdSingularValue(a, std::cos(turn), std::sin(turn)),
                nearest < 0.2 ? 0.05 * nearest : 0.01)
          << a << " " << turn;
    }
}

TEST(AlphaJoinCondition, StraightBoundariesSlide) {
  std::mt19937_64 random(testSeed());
  int slides = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec along = test::randomVector(random), x0 = test::randomVector(random);
    // The straight edge x0 + f(v) along, f of the shape: B and C are parallel to each other.
    const AlphaSurface given =
        withEdge(uniform(0.3, 1, random), x0, x0 + uniform(0.2, 0.4, random) * along,
                 x0 + uniform(0.6, 0.8, random) * along, x0 + along, random);
    const AlphaSeamCondition condition = alphaSeamCondition(given, given.a_v);
    EXPECT_GE(condition.first_rows.cols(), 1);
    EXPECT_EQ(condition.first_rows.cols(), bruteDimension(given, given.a_v));
    slides += condition.first_rows.cols() > 1;
  }
  RecordProperty("slides", slides);
}

TEST(AlphaJoinCondition, Identity5SlidingRowsHoldTheEquation) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 150; ++i) {
    const AlphaSurface given = curvedEdge(i % 3, random);
    const AlphaSeamCondition condition = alphaSeamCondition(given, given.a_v);
    Vec functions =
        condition.first_rows * Eigen::Vector2d(uniform(-1, 1, random), uniform(-1, 1, random));
    if (functions(0) < 0) functions *= -1;
    AlphaSurface next = randomSurface(random);
    next.a_v = given.a_v;
    next.poles.topRows<8>() =
        alphaSlidingRows(given, next.a_u, next.a_v, functions(0), functions(1), functions(2));
    const BezierPatch before = alphaSurfacePatch(given), after = alphaSurfacePatch(next);
    const double size = functions.norm() * 10;
    for (int k = 0; k <= 8; ++k) {
      const double v = k / 8.0;
      const SurfaceJet x = before.jet(1, v), y = after.jet(0, v);
      const double beta = (1 - v) * functions(1) + v * functions(2);
      EXPECT_LE((y.p - x.p).norm(), 1e-13);
      EXPECT_LE((y.u - functions(0) * x.u - beta * x.v).norm(), 1e-12 * (1 + size));
    }
    EXPECT_EQ(joinCondition(ribbon(before, PatchEdge::U1, false, Across::OutOf),
                            ribbon(after, PatchEdge::U0, false, Across::Into))
                  .verdict,
              JoinVerdict::G1);
    if (std::abs(functions(1)) + std::abs(functions(2)) > 0.1 * functions.norm()) {
      EXPECT_EQ(alphaSeamFit(given, next).geometric_order, 0) << "it slides";
    }
    EXPECT_THAT(test::complaint([&] {
                  alphaSlidingRows(given, 1, given.a_v, functions(0), functions(1) + 0.5,
                                   functions(2) + 0.3);
                }),
                HasSubstr("is not the derivative of an alpha-surface"));
  }
  // Different shapes along the seam, rows 3 and 2 balanced: the same as alphaJoinRows().
  AlphaSurface given = randomSurface(random);
  balance(given, 1);
  AlphaJoin join;
  join.next_a_v = 0.77;
  join.beta1 = 1.3;
  EXPECT_LE((alphaSlidingRows(given, 1, 0.77, 1.3, 0, 0) - alphaJoinRows(given, join))
                .cwiseAbs()
                .maxCoeff(),
            1e-13);
}

TEST(AlphaJoinCondition, Identity6NearestBalancedRows) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const AlphaSurface given = randomSurface(random);
    const int order = i % 3;
    const AlphaSurface near = alphaBalanced(given, order);
    EXPECT_EQ(near.poles.topRows(4 * (3 - order)), given.poles.topRows(4 * (3 - order)));
    EXPECT_EQ(alphaSeamCondition(near, 0.123).order, order);
    // The move is square to every move that keeps rows balanced.
    const AlphaSurface::Net move = near.poles - given.poles;
    for (int k = 0; k < 20; ++k) {
      AlphaSurface other = randomSurface(random);
      balance(other, order);
      AlphaSurface::Net difference = AlphaSurface::Net::Zero();
      difference.bottomRows(4 * (order + 1)) =
          (other.poles - near.poles).bottomRows(4 * (order + 1));
      EXPECT_NEAR(move.cwiseProduct(difference).sum(), 0,
                  1e-12 * (1 + move.norm() * difference.norm()));
    }
  }
}

}  // namespace
}  // namespace seamwright
