// SPDX-License-Identifier: LGPL-2.1-or-later
// Conditions of joins against coefficients known to 40 digits, against joins made to fail, and
// under the maps that must not matter.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numbers>
#include <seamwright/core/join/condition/condition.hpp>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::beginningAtU0;
using test::endingAtU1;
using test::function;
using test::gentlePatch;
using test::Join;
using test::mapped;
using test::randomJoin;
using test::uniform;
using test::value;
using test::whole;
using testing::HasSubstr;

/// Largest difference relative to the largest expected value, or to the size given where that is
/// larger.
double error(const Eigen::VectorXd& found, const Eigen::VectorXd& expected, double size = 0) {
  if (found.size() != expected.size()) return std::numeric_limits<double>::infinity();
  return (found - expected).cwiseAbs().maxCoeff() / std::max(expected.cwiseAbs().maxCoeff(), size);
}

/// Product of the sizes of the fields, from a relative residual.
double scaleOf(const JoinResidual& residual) {
  return residual.relative > 0 ? residual.coefficients.cwiseAbs().maxCoeff() / residual.relative
                               : 1;
}

// The data files.

TEST(JoinConditionData, TangentPlaneConditionsOfPatches) {
  for (const json& entry : test::dataCases("tensor_joins.json", "test")) {
    const BezierPatch P = test::patch(entry["input"]["P"]), Q = test::patch(entry["input"]["Q"]);
    const JoinCondition found = joinCondition(endingAtU1(P), beginningAtU0(Q));
    const double mnl = P.degreeU() * P.degreeV() * Q.degreeU();
    EXPECT_LE(
        error(found.tangent_plane.coefficients / mnl, function(entry["expected"]["triple_coeffs"]),
              scaleOf(found.tangent_plane) / mnl),
        1e-14)
        << entry["id"];
    const bool g1 = entry["expected"]["g1"], fold = entry["expected"]["fold"];
    EXPECT_EQ(found.verdict, g1     ? JoinVerdict::G1
                             : fold ? JoinVerdict::Fold
                                    : JoinVerdict::NotG1)
        << entry["id"] << " " << name(found.verdict) << " " << found.tangent_plane.relative
        << " noise " << found.tangent_plane.noise << " position " << found.position.relative
        << " noise " << found.position.noise;
  }
}

TEST(JoinConditionData, TangentPlaneConditionsOfRationalPatches) {
  for (const json& entry : test::dataCases("tensor_joins.json", "rational_test")) {
    const BezierPatch P = test::patch(entry["input"]["P_hom"]),
                      Q = test::patch(entry["input"]["Q_hom"]);
    const JoinCondition found = joinCondition(endingAtU1(P), beginningAtU0(Q));
    // det[X, Y, P_s, Q_s] with P_s = m (P - R), Q_s = l (S - Q): -m l times det[X, Y, R, S] where Q
    // = e P.
    const double ml = P.degreeU() * Q.degreeU();
    const double weight = std::max(endingAtU1(P).position.col(3).maxCoeff(),
                                   beginningAtU0(Q).position.col(3).maxCoeff());
    const Eigen::VectorXd expected =
        -ml * function(entry["expected"]["det4_coeffs"]) / std::pow(weight, 4);
    EXPECT_LE(error(found.tangent_plane.coefficients, expected, scaleOf(found.tangent_plane)),
              1e-14)
        << entry["id"];
    EXPECT_EQ(found.verdict == JoinVerdict::G1, entry["expected"]["g1"].get<bool>()) << entry["id"];
    EXPECT_TRUE(found.position.holds) << found.position.relative << " " << found.position.noise;
    const Eigen::VectorXd e = function(entry["expected"]["e"]);
    const ConnectionFit fit = fitConnection(endingAtU1(P), beginningAtU0(Q));
    for (const double t : {0.0, 0.3, 1.0})
      EXPECT_NEAR(value(fit.connection.e0, t), value(e, t), 1e-13);
    // Made with alpha e a polynomial, so alpha is none.
    EXPECT_FALSE(fit.found);
    EXPECT_THAT(fit.note, HasSubstr(entry["expected"]["g1"].get<bool>() ? "the join is G1, but"
                                                                        : "the join is not G1"));
  }
}

TEST(JoinConditionData, TrianglesThatDoNotJoin) {
  for (const json& entry : test::dataCases("triangle_joins.json", "tri_test")) {
    const BezierTriangle T0 = test::triangle(entry["input"]["T0"]),
                         T1 = test::triangle(entry["input"]["T1"]);
    const JoinCondition found = joinCondition(ribbon(T1, TriangleEdge::L0, false, Across::OutOf),
                                              ribbon(T0, TriangleEdge::L0, false, Across::Into));
    // det(P_s, P_t, Q_s) = det(n z1, n a, -n z0) = n^3 det(z0, a, z1).
    const double n3 = std::pow(T0.degree(), 3);
    EXPECT_LE(
        error(found.tangent_plane.coefficients / n3, function(entry["expected"]["triple_coeffs"])),
        1e-12);
    EXPECT_EQ(found.verdict, JoinVerdict::NotG1);
  }
}

TEST(JoinConditionData, FitsFindTheConnection) {
  for (const json& entry : test::dataCases("tensor_joins.json", "fit")) {
    const Ribbon a = endingAtU1(test::patch(entry["input"]["P"])),
                 b = beginningAtU0(test::patch(entry["input"]["Q"]));
    const auto expectFound = [&](const ConnectionFit& fit) {
      EXPECT_TRUE(fit.found) << fit.note;
      EXPECT_LE(error(fit.connection.alpha, function(entry["expected"]["alpha"])), 1e-12);
      EXPECT_LE(error(fit.connection.beta, function(entry["expected"]["beta"])), 1e-12);
    };
    expectFound(fitConnection(a, b,
                              {.alpha_degree = entry["input"]["deg_alpha"].get<int>(),
                               .beta_degree = entry["input"]["deg_beta"].get<int>()}));
    expectFound(fitConnection(a, b));
  }
}

TEST(JoinConditionData, JumpsOfCurvatureAreThoseOfTheData) {
  for (const json& entry : test::dataCases("curvature_jumps.json", "g2_measure")) {
    const Ribbon a = endingAtU1(test::patch(entry["input"]["P"])),
                 b = beginningAtU0(test::patch(entry["input"]["Q"]));
    const ConnectionFit fit = fitConnection(a, b);
    ASSERT_TRUE(fit.found) << fit.note;
    const JoinCondition found = joinCondition(a, b, {.connection = fit.connection});
    EXPECT_EQ(found.verdict, JoinVerdict::G1);
    EXPECT_FALSE(found.g2());
    EXPECT_FALSE(joinCondition(a, b).g2());
    for (const json& sample : entry["expected"]["samples"]) {
      // The condition is |N_P| times the jump times |N_Q|^2 / |P_t|^2.
      const double t = test::number(sample["t"]);
      const auto at = [t](const HomogeneousPoles& rows) -> Eigen::Vector3d {
        return value(rows, t).head<3>();
      };
      const Eigen::Index n = a.position.rows() - 1;
      const Eigen::Vector3d along = at(HomogeneousPoles(
          static_cast<double>(n) * (a.position.bottomRows(n) - a.position.topRows(n))));
      const Eigen::Vector3d normal_a = at(a.first).cross(along),
                            normal_b = at(b.first).cross(along);
      const double jump = value(found.curvature->coefficients, t) / normal_a.norm() *
                          along.squaredNorm() / normal_b.squaredNorm();
      EXPECT_NEAR(jump, test::number(sample["delta_kappa_perp"]), 1e-9 * std::abs(jump) + 1e-13);
    }
  }
}

// Joins that were constructed, of any pairing.

constexpr int joins = 3000;

TEST(JoinCondition, Identity1ConstructedJoinsHold) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < joins; ++run) {
    const Join join = randomJoin(run, random);
    const JoinCondition found = joinCondition(join.a, join.b);
    ASSERT_EQ(found.verdict, JoinVerdict::G1) << run << " residual " << found.tangent_plane.relative
                                              << " noise " << found.tangent_plane.noise;
    EXPECT_LE(found.tangent_plane.relative, 1e-13) << run;
    EXPECT_LE(found.tangent_plane.noise, 1e-10) << run;
    EXPECT_LE(found.angle_bound_rad, run % 4 == 3 ? 5e-9 : 1e-10)
        << run;  // every fourth one is rational
    EXPECT_GE(found.parametric_order, 0);
    if (join.order >= 2) {
      EXPECT_TRUE(found.g2()) << run << " " << found.curvature->relative << " noise "
                              << found.curvature->noise;
      const JoinCondition given = joinCondition(join.a, join.b, {.connection = join.connection});
      EXPECT_TRUE(given.g2()) << run;
      if (join.order < 3 || !found.curvature_change) continue;
      EXPECT_TRUE(found.g3()) << run << " " << found.curvature_change->relative << " noise "
                              << found.curvature_change->noise;
      EXPECT_TRUE(given.g3()) << run << " " << given.curvature_change->relative << " noise "
                              << given.curvature_change->noise;
    } else if (join.a.second.norm() + join.b.second.norm() > 1) {
      EXPECT_FALSE(found.g2()) << run;
    }
  }
}

TEST(JoinCondition, Identity1NegativeAlphaIsAFold) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 300; ++run) {
    Join join = randomJoin(run, random);
    join.b.first = -join.b.first;
    EXPECT_EQ(joinCondition(join.a, join.b).verdict, JoinVerdict::Fold) << run;
  }
}

TEST(JoinCondition, Identity2OneMovedPoleEndsIt) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < joins; ++run) {
    const BezierPatch a =
        gentlePatch(whole(2, 6, random), whole(1, 6, random), run % 4 == 0, random);
    const int k = whole(0, 2, random), l = whole(2, 6, random);
    const ConnectionFunctions c = test::randomConnection(k, whole(0, k + 1, random), random);
    std::optional<BezierPatch> b;
    try {
      b = continuation(endingAtU1(a), c, 2, l);
    } catch (const std::invalid_argument&) {
      continue;
    }
    Poles poles = b->poles();
    const int row = whole(0, 2, random), pole = whole(0, b->degreeV(), random);
    poles(static_cast<Eigen::Index>(row) * (b->degreeV() + 1) + pole, 2) +=
        1e-5;  // the patch is 10 mm
    const JoinCondition found = joinCondition(
        endingAtU1(a), beginningAtU0(BezierPatch(l, b->degreeV(), poles, b->weights())));
    if (row < 2)
      EXPECT_EQ(found.verdict, JoinVerdict::NotG1) << run << " row " << row;
    else
      EXPECT_EQ(found.verdict, JoinVerdict::G1) << run;
    EXPECT_FALSE(found.g2()) << run << " row " << row << " "
                             << (found.curvature ? found.curvature->relative : 0) << " noise "
                             << (found.curvature ? found.curvature->noise : 0);
    EXPECT_EQ(found.parametric_order >= 0, row > 0) << run;
  }
}

TEST(JoinCondition, Identity2OneMovedPoleOfRow3EndsG3) {
  std::mt19937_64 random(testSeed());
  int tried = 0;
  for (int run = 0; run < 300; ++run) {
    const BezierPatch a =
        gentlePatch(whole(3, 6, random), whole(1, 4, random), run % 4 == 0, random);
    const int l = whole(3, 6, random);
    const ConnectionFunctions c = test::randomConnection(0, whole(0, 1, random), random);
    const auto b = test::built([&] { return continuation(endingAtU1(a), c, 3, l); });
    if (!b) continue;
    ++tried;
    EXPECT_TRUE(joinCondition(endingAtU1(a), beginningAtU0(*b)).g3()) << run;
    Poles poles = b->poles();
    poles(3L * (b->degreeV() + 1) + whole(0, b->degreeV(), random), 2) += 1e-5;  // of 10 mm
    const JoinCondition found = joinCondition(
        endingAtU1(a), beginningAtU0(BezierPatch(l, b->degreeV(), poles, b->weights())));
    EXPECT_TRUE(found.g2()) << run;
    EXPECT_FALSE(found.g3()) << run << " " << found.curvature_change->relative << " noise "
                             << found.curvature_change->noise;
  }
  EXPECT_GT(tried, 150);
}

Ribbon backwards(Ribbon ribbon) {
  for (HomogeneousPoles* part : ribbon.parts()) *part = part->colwise().reverse().eval();
  return ribbon;
}

TEST(JoinCondition, Identity3ReversingTheSeamChangesNoVerdict) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 400; ++run) {
    const Join join = randomJoin(run, random);
    const Ribbon other = run % 2 ? join.b : randomJoin(run, random).b;
    const JoinCondition found = joinCondition(join.a, other),
                        turned = joinCondition(backwards(join.a), backwards(other));
    EXPECT_EQ(found.verdict, turned.verdict) << run;
    EXPECT_EQ(found.g2(), turned.g2()) << run;
    EXPECT_EQ(found.g3(), turned.g3()) << run;
    EXPECT_NEAR(found.tangent_plane.relative, turned.tangent_plane.relative,
                1e-2 * found.tangent_plane.relative + 1e-13);
  }
}

TEST(JoinCondition, Identity3MotionsAndScalesChangeNoVerdict) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 400; ++run) {
    const Join join = randomJoin(run, random);
    const Ribbon other =
        run % 2 ? join.b : randomJoin(run, random).b;  // of every other one nothing holds
    const Eigen::Matrix3d linear = test::logUniform(random, -3, 3) * test::randomRotation(random);
    const Eigen::RowVector3d translation =
        10 * linear.col(0).norm() * test::randomVector(random).transpose();
    const JoinCondition found = joinCondition(join.a, other),
                        moved = joinCondition(mapped(join.a, linear, translation),
                                              mapped(other, linear, translation));
    EXPECT_EQ(found.verdict, moved.verdict) << run;
    EXPECT_EQ(found.parametric_order, moved.parametric_order) << run;
    EXPECT_EQ(found.g2(), moved.g2()) << run;
    EXPECT_EQ(found.g3(), moved.g3()) << run;
    if (found.singular_at) continue;
    EXPECT_NEAR(found.angle_bound_rad, moved.angle_bound_rad, 1e-2 * found.angle_bound_rad + 1e-9)
        << run;
  }
}

/// The normal of a side at t, by the quotient rule and with its own seam.
Eigen::Vector3d normalAt(const Ribbon& ribbon, double t) {
  const Eigen::Vector4d h = value(ribbon.position, t);
  const auto first = [&](const HomogeneousPoles& derivative) -> Eigen::Vector3d {
    const Eigen::Vector4d h1 = value(derivative, t);
    return (h.head<3>() * -h1(3) / h(3) + h1.head<3>()) / h(3);
  };
  const Eigen::Index n = ribbon.position.rows() - 1;
  return first(ribbon.first)
      .cross(first(static_cast<double>(n) *
                   (ribbon.position.bottomRows(n) - ribbon.position.topRows(n))));
}

double angleAt(const Ribbon& a, const Ribbon& b, double t) {
  const Eigen::Vector3d normal_a = normalAt(a, t), normal_b = normalAt(b, t);
  return std::atan2(normal_a.cross(normal_b).norm(), normal_a.dot(normal_b));
}

TEST(JoinCondition, Identity4TheBoundOfTheAngleIsOne) {
  std::mt19937_64 random(testSeed());
  int bounded = 0;
  for (int run = 0; run < 400; ++run) {
    Join join = randomJoin(run, random);
    const double off = run % 10 == 0 ? 0 : test::logUniform(random, -8, -1);  // 0: all is rounding
    join.b.first.leftCols<3>() +=
        off * HomogeneousPoles::Random(join.b.first.rows(), 4).leftCols<3>();
    const JoinCondition found = joinCondition(join.a, join.b);
    double largest = 0;
    for (int i = 0; i <= 20; ++i) largest = std::max(largest, angleAt(join.a, join.b, i / 20.0));
    EXPECT_GE(found.angle_bound_rad, largest) << run;
    if (found.angle_bound_rad < 100 * largest) ++bounded;
  }
  EXPECT_GE(bounded, 300);
}

TEST(JoinCondition, Identity4TheBoundOfTheAngleIsOneWhereSeamsDiffer) {
  std::mt19937_64 random(testSeed());
  int bounded = 0;
  for (int run = 0; run < 400; ++run) {
    Join join = randomJoin(run, random);
    const double off = test::logUniform(random, -8, 0);
    join.b.position.leftCols<3>() +=
        off * HomogeneousPoles::Random(join.b.position.rows(), 4).leftCols<3>();
    const JoinConditionOptions options{.tolerance =
                                           run % 2 ? std::optional<double>(off) : std::nullopt};
    const JoinCondition found = joinCondition(join.a, join.b, options);
    double largest = 0;
    for (int i = 0; i <= 20; ++i) largest = std::max(largest, angleAt(join.a, join.b, i / 20.0));
    EXPECT_GE(found.angle_bound_rad, largest) << run;
    if (found.angle_bound_rad < 100 * largest) ++bounded;
  }
  EXPECT_GE(bounded, 300);
}

TEST(JoinCondition, NoGapIsAboveItsBound) {
  std::mt19937_64 random(testSeed());
  const auto pointAt = [](const Ribbon& ribbon, double t) -> Eigen::Vector3d {
    const Eigen::Vector4d h = value(ribbon.position, t);
    return h.head<3>() / h(3);
  };
  for (int run = 0; run < 200; ++run) {
    const int n = whole(1, 4, random);
    const Ribbon a = endingAtU1(gentlePatch(2, n, true, random));
    Ribbon b = a;
    b.position.leftCols<3>() += 0.1 * HomogeneousPoles::Random(n + 1, 4).leftCols<3>();
    double largest = 0;
    for (int i = 0; i <= 50; ++i)
      largest = std::max(largest, (pointAt(a, i / 50.0) - pointAt(b, i / 50.0)).norm());
    const double bound = joinCondition(a, b).gap_bound_mm;
    EXPECT_GE(bound, largest * (1 - 1e-12)) << run;
    EXPECT_LE(bound, 16 * largest) << run;  // weights from 0.5 to 2, which count squared
  }
}

/// The planes z = 0 and, beyond a seam that rises by 0.3 mm, z = f(y): Q_s lies in the first plane,
/// Q_t does not.
TEST(JoinCondition, Identity4SeamsThatLeanAgainstEachOther) {
  Poles flat(16, 3), waved(16, 3);
  const Eigen::Vector4d height(0, 0.3, -0.3, 0);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      flat.row(4 * i + j) << i, j, 0;
      waved.row(4 * i + j) << i + 3, j, height(j);
    }
  const JoinCondition found =
      joinCondition(endingAtU1(BezierPatch(3, 3, flat)), beginningAtU0(BezierPatch(3, 3, waved)));
  EXPECT_EQ(found.verdict, JoinVerdict::NotG1);
  const double steepest = std::atan(0.3);  // dz/dy at y = 0, where it is largest but for the middle
  EXPECT_GE(found.angle_bound_rad, steepest);
  EXPECT_LE(found.angle_bound_rad, 1.1 * steepest);
}

TEST(JoinCondition, SidesWithoutTangentPlaneAreSingular) {
  std::mt19937_64 random(testSeed());
  const BezierPatch a = gentlePatch(3, 3, false, random);
  const Ribbon given = endingAtU1(a), next = beginningAtU0(continuation(given, {}, 1, 2));
  Ribbon none = given, corner = given, inside = given;
  none.first.setZero();
  corner.first.row(3).setZero();
  // (2 t - 1)^2 along z, and nothing else across
  inside.first = HomogeneousPoles::Zero(3, 4);
  inside.first.col(2) << 1, -1, 1;
  EXPECT_EQ(joinCondition(none, next).verdict, JoinVerdict::Singular);
  EXPECT_EQ(joinCondition(given, none).verdict, JoinVerdict::Singular);
  EXPECT_EQ(joinCondition(corner, next).verdict, JoinVerdict::Singular);
  EXPECT_NEAR(joinCondition(corner, next).singular_at.value(), 1, 1e-6);
  EXPECT_EQ(joinCondition(inside, next).verdict, JoinVerdict::Singular);
  EXPECT_NEAR(joinCondition(inside, next).singular_at.value(), 0.5, 1e-3);
}

TEST(JoinCondition, ParametricOrders) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 60; ++run) {
    const BezierPatch patch =
        gentlePatch(3, 4, run % 2 == 1, random);  // with weights so even that they stay positive
    const Ribbon a =
        endingAtU1(BezierPatch(3, 4, patch.poles(), patch.weights().array().pow(0.03)));
    const auto order = [&](const ConnectionFunctions& c, int built) {
      return joinCondition(a, beginningAtU0(continuation(a, c, built, 4))).parametric_order;
    };
    ConnectionFunctions scaled, bent_weights;  // of the weights alone
    scaled.e0 = bent_weights.e0 = Eigen::Vector2d(1, 1.25);
    bent_weights.e1(0) = 0.125;
    bent_weights.e2(0) = -0.0625;
    EXPECT_EQ(order({}, 2), 2);
    EXPECT_EQ(order({}, 1), 1);
    EXPECT_EQ(order(scaled, 2), 2);
    EXPECT_EQ(order(bent_weights, 2), 2);
    ConnectionFunctions faster, bent;
    faster.alpha(0) = 1.001;
    bent.p(0) = 0.001;
    EXPECT_EQ(order(faster, 2), 0);
    EXPECT_EQ(order(bent, 2), 1);
  }
}

TEST(JoinCondition, SizesNearTheEndsOfDoublesChangeNothing) {
  std::mt19937_64 random(testSeed());
  for (const double size : {1e-100, 1e-20, 1e20, 1e100})
    for (int run = 0; run < 20; ++run) {
      const Join join = randomJoin(run, random);
      const auto weighed = [&](Ribbon ribbon) {
        ribbon = mapped(ribbon, size * Eigen::Matrix3d::Identity(), Eigen::RowVector3d::Zero());
        for (HomogeneousPoles* part : ribbon.parts()) *part *= 1 / size;
        return ribbon;
      };
      const JoinCondition found = joinCondition(weighed(join.a), weighed(join.b));
      EXPECT_EQ(found.verdict, JoinVerdict::G1) << size;
      EXPECT_TRUE(found.g2() || join.order == 1) << size;
      EXPECT_TRUE(fitConnection(weighed(join.a), weighed(join.b)).found) << size;
    }
}

TEST(JoinCondition, ToleranceIsTheCallers) {
  std::mt19937_64 random(testSeed());
  const Ribbon a = endingAtU1(gentlePatch(3, 3, false, random));
  Ribbon b = beginningAtU0(continuation(a, {}, 2, 3));
  b.first(1, 2) += 1e-4;
  EXPECT_EQ(joinCondition(a, b).verdict, JoinVerdict::NotG1);
  EXPECT_EQ(joinCondition(a, b, {.tolerance = 1e-3}).verdict, JoinVerdict::G1);
  EXPECT_THROW(joinCondition(a, b, {.tolerance = -1}), std::invalid_argument);
  Ribbon high = a;
  high.first = HomogeneousPoles::Ones(32, 4);
  EXPECT_THROW(joinCondition(a, high), std::invalid_argument);
  b.position(0, 3) = 0;
  EXPECT_THROW(joinCondition(a, b), std::invalid_argument);
  b.position(0, 3) = std::nan("");
  EXPECT_THROW(joinCondition(a, b), std::invalid_argument);
}

/// Planes of 3 mm that meet with that slope of the second one, so far from the origin.
std::pair<BezierPatch, BezierPatch> crease(double slope, double far) {
  Poles flat(16, 3), inclined(16, 3);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      flat.row(4 * i + j) << i, j, 0;
      inclined.row(4 * i + j) << i + 3, j, slope * i;
    }
  return {BezierPatch(3, 3, flat.array() + far), BezierPatch(3, 3, inclined.array() + far)};
}

TEST(JoinCondition, WhatNoiseHidesDoesNotHold) {
  for (const double far : {0.0, 1e3, 1e6, 1e9, 1e12, 1e13, 1e14, 1e15})
    for (const double slope : {0.0, 0.1, 1.0}) {
      const auto [first, second] = crease(slope, far);
      const Ribbon a = endingAtU1(first), b = beginningAtU0(second);
      const JoinCondition found = joinCondition(a, b);
      const ConnectionFit fit = fitConnection(a, b, {.order = 2});
      if (slope > 0) {
        EXPECT_NE(found.verdict, JoinVerdict::G1) << far << " " << slope;
        EXPECT_LE(found.parametric_order, 0) << far << " " << slope;
        EXPECT_FALSE(fit.found) << far << " " << slope;
        EXPECT_GE(found.angle_bound_rad, std::atan(slope)) << far;
      }
      if (slope == 0 && far < 1e8) {
        EXPECT_TRUE(found.g2()) << far << " noise " << found.tangent_plane.noise;
        EXPECT_EQ(found.parametric_order, 2) << far;
        EXPECT_TRUE(fit.found) << far << " " << fit.note;
      }
      if (far >= 1e14) {
        EXPECT_EQ(found.verdict, JoinVerdict::Singular) << far;
        EXPECT_EQ(found.parametric_order, -1) << far;
        EXPECT_THAT(fit.note, HasSubstr("cannot be decided")) << far;
      }
    }
}

TEST(JoinCondition, FunctionsOfAGivenConnectionAreChecked) {
  std::mt19937_64 random(testSeed());
  const Ribbon a = endingAtU1(gentlePatch(3, 3, false, random)),
               b = beginningAtU0(continuation(a, {}, 2, 3));
  const auto messageWith = [&](const ConnectionFunctions& c) -> std::string {
    try {
      joinCondition(a, b, {.connection = c});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0, 0.0}) {
    ConnectionFunctions c;
    c.alpha = Eigen::Vector2d(1, bad);
    EXPECT_THAT(messageWith(c), HasSubstr("alpha ")) << bad;
  }
  ConnectionFunctions none, unbounded;
  none.beta.resize(0);
  unbounded.beta(0) = -std::numeric_limits<double>::infinity();
  EXPECT_THAT(messageWith(none), HasSubstr("beta has no coefficient"));
  EXPECT_THAT(messageWith(unbounded), HasSubstr("beta has coefficient 0 = -inf"));
  EXPECT_EQ(messageWith({}), "accepted");
}

}  // namespace
}  // namespace seamwright
