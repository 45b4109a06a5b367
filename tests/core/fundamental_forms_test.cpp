// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>
#include <seamwright/core/differential/fundamental_forms.hpp>

#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using test::Vec;

constexpr int cases = 500;

SurfaceJet randomJet(std::mt19937_64& random) {
  SurfaceJet jet;
  do {
    jet.u = test::randomVector(random);
    jet.v = test::randomVector(random);
  } while (jet.u.cross(jet.v).norm() < 0.1);
  jet.p = test::randomVector(random);
  jet.uu = test::randomVector(random);
  jet.uv = test::randomVector(random);
  jet.vv = test::randomVector(random);
  jet.uuu = test::randomVector(random);
  jet.uuv = test::randomVector(random);
  jet.uvv = test::randomVector(random);
  jet.vvv = test::randomVector(random);
  return jet;
}

Eigen::Matrix3d tensorOf(const SurfaceJet& jet) {
  return curvatureTensor(jet, *unitNormal(jet));
}

TEST(CurvatureTensor, Identity1TangentAndSymmetric) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const Eigen::Matrix3d W = tensorOf(jet);
    const double scale = W.norm();
    EXPECT_LT((W * *unitNormal(jet)).norm(), 1e-13 * scale);
    EXPECT_LT((W - W.transpose()).norm(), 1e-14 * scale);
  }
}

TEST(CurvatureTensor, Identity2ChangesSignWithTheNormal) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const Eigen::Matrix3d W = tensorOf(jet);
    EXPECT_LT((W + curvatureTensor(jet, -*unitNormal(jet))).norm(), 1e-14 * W.norm());
    EXPECT_LT((W + tensorOf(test::flipped(jet))).norm(), 1e-12 * W.norm());
  }
}

TEST(CurvatureTensor, Identities3And4TraceAndProductAreThoseOfTheForms) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const Vec n = *unitNormal(jet);
    const auto [E, F, G] = firstForm(jet);
    const auto [L, M, N] = secondForm(jet, n);
    const double det = E * G - F * F;
    const PrincipalCurvatures k = principalCurvatures(jet, n);
    const double scale = std::max(std::abs(k.k1), std::abs(k.k2));
    EXPECT_NEAR(tensorOf(jet).trace(), (E * N - 2 * F * M + G * L) / det, 1e-11 * scale);
    EXPECT_NEAR(k.k1 + k.k2, (E * N - 2 * F * M + G * L) / det, 1e-11 * scale);
    EXPECT_NEAR(k.k1 * k.k2, (L * N - M * M) / det, 1e-11 * scale * scale);
    EXPECT_GE(k.k1, k.k2);
    EXPECT_NEAR(k.direction1.dot(tensorOf(jet) * k.direction1), k.k1, 1e-12 * scale);
    EXPECT_NEAR(k.direction1.dot(k.direction2), 0, 1e-14);
  }
}

TEST(CurvatureTensor, Identity5DoesNotDependOnTheParametrisation) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const SurfaceJet other = test::reparametrised(jet, test::randomJacobian(random), random);
    EXPECT_LT((tensorOf(jet) - tensorOf(other)).norm(), 1e-9 * tensorOf(jet).norm())
        << "case " << i;
  }
}

TEST(CurvatureTensor, Identity6FollowsRotationAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const Eigen::Matrix3d R = test::randomRotation(random);
    const double s = test::logUniform(random, -6, 6);
    const Eigen::Matrix3d W = tensorOf(jet);
    EXPECT_LT((tensorOf(test::mapped(jet, R)) - R * W * R.transpose()).norm(), 1e-12 * W.norm());
    EXPECT_LT((s * tensorOf(test::mapped(jet, s * Eigen::Matrix3d::Identity())) - W).norm(),
              1e-12 * W.norm());
  }
}

TEST(CurvatureTensor, KeepsItsAccuracyWherePartialsAreNearlyParallel) {
  // A unit sphere in sheared parameters: X_v is X_u but for one part in a million, E G - F^2 loses
  // 12 digits.
  SurfaceJet sheared;
  const SurfaceJet x = test::sphere(1, 0.3, 0.2);
  const double e = 1e-6;
  sheared.u = x.u;
  sheared.v = x.u + e * x.v;
  sheared.uu = x.uu;
  sheared.uv = x.uu + e * x.uv;
  sheared.vv = x.uu + 2 * e * x.uv + e * e * x.vv;
  const PrincipalCurvatures k = principalCurvatures(sheared, *unitNormal(sheared));
  EXPECT_NEAR(k.k1, -1, 1e-3);
  EXPECT_NEAR(k.k2, -1, 1e-3);
}

TEST(CurvatureTensor, SurvivesExtremeParameterSpeeds) {
  for (const double speed : {1e-150, 1e-100, 1e100, 1e150}) {
    SurfaceJet jet = test::cylinder(10, 0.7, 1);
    jet.u *= speed;
    jet.uu *= speed * speed;
    if (jet.uu.norm() == 0 || !jet.uu.allFinite()) continue;
    const PrincipalCurvatures k = principalCurvatures(jet, *unitNormal(jet));
    EXPECT_NEAR(k.k1, 0, 1e-15) << speed;
    EXPECT_NEAR(k.k2, -0.1, 1e-14) << speed;
  }
}

TEST(PrincipalCurvatures, AgreeWithClosedForms) {
  const auto curvatures = [](const SurfaceJet& jet) {
    return principalCurvatures(jet, *unitNormal(jet));
  };
  for (const double u : {-2.0, 0.1, 1.3})
    for (const double v : {-1.1, 0.0, 0.9}) {
      const PrincipalCurvatures c = curvatures(test::cylinder(4, u, v));
      EXPECT_NEAR(c.k1, 0, 1e-15);
      EXPECT_NEAR(c.k2, -0.25, 1e-15);
      EXPECT_NEAR(std::abs(c.direction1.z()), 1, 1e-15);
      const PrincipalCurvatures s = curvatures(test::sphere(5, u, v));
      EXPECT_NEAR(s.k1, -0.2, 1e-14);
      EXPECT_NEAR(s.k2, -0.2, 1e-14);
      const PrincipalCurvatures t = curvatures(test::torus(7, 2, u, v));
      EXPECT_NEAR(t.k2, -0.5, 1e-14);
      EXPECT_NEAR(t.k1, -std::cos(v) / (7 + 2 * std::cos(v)), 1e-14);
      const double distance = v + 3;
      const PrincipalCurvatures k = curvatures(test::cone(0.5, u, distance));
      EXPECT_NEAR(std::max(std::abs(k.k1), std::abs(k.k2)), 1 / (distance * std::tan(0.5)), 1e-14);
      EXPECT_NEAR(std::min(std::abs(k.k1), std::abs(k.k2)), 0, 1e-15);
    }
}

/// The tangent direction at an angle from X_u.
Vec tangentDirection(const SurfaceJet& jet, double angle_rad) {
  const Vec along = jet.u.normalized();
  return std::cos(angle_rad) * along + std::sin(angle_rad) * unitNormal(jet)->cross(along);
}

Vec randomTangent(const SurfaceJet& jet, std::mt19937_64& random) {
  return tangentDirection(jet, std::uniform_real_distribution<double>(0, 6.3)(random));
}

TEST(CurvatureChange, Identity1ChangesSignWithTheNormalAndWithTheDirection) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const Vec n = *unitNormal(jet), d = randomTangent(jet, random);
    const double change = curvatureChange(jet, n, d);
    EXPECT_DOUBLE_EQ(curvatureChange(jet, -n, d), -change);
    EXPECT_DOUBLE_EQ(curvatureChange(jet, n, -d), -change);
  }
}

TEST(CurvatureChange, Identity2DoesNotDependOnTheParametrisation) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const Vec n = *unitNormal(jet), d = randomTangent(jet, random);
    const SurfaceJet other = test::reparametrised(jet, test::randomJacobian(random), random);
    const double change = curvatureChange(jet, n, d);
    EXPECT_NEAR(curvatureChange(other, n, d), change, 1e-7 * (1 + std::abs(change)))
        << "case " << i;
  }
}

TEST(CurvatureChange, Identity3FollowsMotionAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const SurfaceJet jet = randomJet(random);
    const Vec n = *unitNormal(jet), d = randomTangent(jet, random);
    const double change = curvatureChange(jet, n, d);
    const Eigen::Matrix3d R = test::randomRotation(random);
    const double noise = 1e-10 * (1 + std::abs(change));
    EXPECT_NEAR(curvatureChange(test::mapped(jet, R, test::randomVector(random)), R * n, R * d),
                change, noise);
    const double s = test::logUniform(random, -6, 6);
    EXPECT_NEAR(s * s * curvatureChange(test::mapped(jet, s * Eigen::Matrix3d::Identity()), n, d),
                change, noise);
  }
}

TEST(CurvatureChange, Identity4SpheresAndCylindersDoNotChange) {
  std::mt19937_64 random(testSeed());
  for (const double u : {-2.0, 0.1, 1.3})
    for (const double v : {-1.1, 0.0, 0.9})
      for (const double angle : {0.0, 0.4, 1.6, 2.9})
        for (const SurfaceJet& exact : {test::sphere(5, u, v), test::cylinder(4, u, v)}) {
          const Vec n = *unitNormal(exact), d = tangentDirection(exact, angle);
          EXPECT_NEAR(curvatureChange(exact, n, d), 0, 1e-15);
          const SurfaceJet other =
              test::reparametrised(exact, test::randomJacobian(random), random);
          EXPECT_NEAR(curvatureChange(other, n, d), 0, 1e-9);
        }
}

TEST(CurvatureChange, Identity5ConeAndTorus) {
  for (const double u : {-2.0, 0.1, 1.3})
    for (const double v : {-1.1, 0.0, 0.9, 2.8})
      for (const double angle : {0.0, 0.4, 1.6, 2.9, -1.0}) {
        const double share = 3 * std::pow(std::cos(angle), 2) * std::sin(angle);
        const SurfaceJet torus = test::torus(7, 2, u, v);
        const double w = 7 + 2 * std::cos(v);
        // Outward normal: k = -cos(v) / w; X_u, X_v and the normal are right-handed, s = 2 v.
        EXPECT_NEAR(curvatureChange(torus, *unitNormal(torus), tangentDirection(torus, angle)),
                    share * 7 * std::sin(v) / (2 * w * w), 1e-15);
        const double a = 0.5, s = v + 3;
        const SurfaceJet cone = test::cone(a, u, s);
        EXPECT_NEAR(curvatureChange(cone, *unitNormal(cone), tangentDirection(cone, angle)),
                    share / (s * s * std::tan(a)), 1e-14);
      }
}

TEST(CurvatureChange, Identity6GraphOverItsTangentPlane) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const Vec k = test::randomVector(random);
    Eigen::Vector4d c;
    c << test::randomVector(random), test::randomVector(random).x();
    const SurfaceJet graph = test::withCubic(test::quadric(k.x(), k.y(), k.z()), c);
    const double angle = 0.1 * i, x = std::cos(angle), y = std::sin(angle);
    const double wanted =
        c(0) * x * x * x + 3 * c(1) * x * x * y + 3 * c(2) * x * y * y + c(3) * y * y * y;
    EXPECT_NEAR(curvatureChange(graph, Vec::UnitZ(), {x, y, 0}), wanted, 1e-13);
    const SurfaceJet other = test::reparametrised(graph, test::randomJacobian(random), random);
    EXPECT_NEAR(curvatureChange(other, Vec::UnitZ(), {x, y, 0}), wanted,
                1e-7 * (1 + std::abs(wanted)));
  }
  // z = c x^3.
  EXPECT_DOUBLE_EQ(curvatureChange(test::withCubic(test::quadric(0, 0, 0), {6 * 0.7, 0, 0, 0}),
                                   Vec::UnitZ(), Vec::UnitX()),
                   6 * 0.7);
}

TEST(CurvatureChange, IsTheDerivativeOfTheCurvatureOfThePlaneSection) {
  // The section of the cone through its axis-free normal plane, by bisection in space and
  // differences: no partials at all.
  const double a = 0.5, s = 2, angle = 0.7;
  const SurfaceJet cone = test::cone(a, 0.3, s);
  const Vec n = *unitNormal(cone), d = tangentDirection(cone, angle);
  const auto height = [&](double x) {
    const auto outside = [&](double h) {
      const Vec p = cone.p + x * d + h * n;
      return std::hypot(p.x(), p.y()) - p.z() * std::tan(a);
    };
    double low = -0.5, high = 0.5;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      ((outside(middle) > 0) == (outside(high) > 0) ? high : low) = middle;
    }
    return 0.5 * (low + high);
  };
  const double h = 0.01;
  const double third =
      (height(2 * h) - 2 * height(h) + 2 * height(-h) - height(-2 * h)) / (2 * h * h * h);
  EXPECT_NEAR(curvatureChange(cone, n, d), third, 2e-4);
  EXPECT_GT(std::abs(third), 0.05);
}

TEST(CurvatureChange, SurvivesExtremeParameterSpeeds) {
  const SurfaceJet cone = test::cone(0.5, 0.3, 2);
  for (const double speed : {1e-100, 1e-80, 1e80, 1e100}) {
    SurfaceJet fast = cone;
    fast.u *= speed;
    fast.uv *= speed;
    fast.uu *= speed * speed;
    fast.uuv *= speed * speed;
    fast.uuu *= speed * speed * speed;
    const Vec n = *unitNormal(cone), d = tangentDirection(cone, 0.7);
    EXPECT_NEAR(curvatureChange(fast, n, d), curvatureChange(cone, n, d), 1e-14) << speed;
  }
}

TEST(Degeneracy, NamesAPoleAnApexAndWhatIsNotFinite) {
  EXPECT_EQ(degeneracy(test::cone(0.5, 1, 0)), Degeneracy::VanishingNormal);
  EXPECT_EQ(degeneracy(test::sphere(10, 1, 1.57), {1e-12, 1e-12}), Degeneracy::None);
  // At the pole cos(pi/2) is 6e-17 instead of 0: rounding gives a direction, the noise says that it
  // means nothing.
  const SurfaceJet pole = test::sphere(10, 1, std::acos(0.0));
  EXPECT_EQ(degeneracy(pole, {1e-13, 1e-13}), Degeneracy::VanishingNormal);
  EXPECT_FALSE(unitNormal(pole, {1e-13, 1e-13}).has_value());
  SurfaceJet broken = test::cylinder(1, 0, 0);
  broken.uv.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(degeneracy(broken), Degeneracy::NotFinite);
  broken.uv.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(degeneracy(broken), Degeneracy::NotFinite);
  EXPECT_EQ(name(Degeneracy::VanishingNormal), "vanishing normal");
  EXPECT_EQ(name(Degeneracy::NotFinite), "not finite");
  EXPECT_EQ(name(Degeneracy::None), "none");
}

TEST(PlaneTensor, SpectralNormIsTheLargestAbsoluteEigenvalue) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const Eigen::Matrix2d basis =
        Eigen::Rotation2Dd(test::randomVector(random).x()).toRotationMatrix();
    const double a = test::randomVector(random).x(), b = test::randomVector(random).x();
    const Eigen::Matrix2d m = basis * Eigen::Vector2d(a, b).asDiagonal() * basis.transpose();
    EXPECT_NEAR((PlaneTensor{m(0, 0), m(0, 1), m(1, 1)}.spectralNorm()),
                std::max(std::abs(a), std::abs(b)), 1e-14);
  }
}

}  // namespace
}  // namespace seamwright
