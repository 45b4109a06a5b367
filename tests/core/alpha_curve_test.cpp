// SPDX-License-Identifier: LGPL-2.1-or-later
// Alpha-curves against their basis in powers of t, data of 60 digits, equations of their joints and
// integrals by quadrature. C8.1 to C8.7 are statements of docs/theory/curves.md.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <seamwright/core/spline/alpha_curve.hpp>
#include <seamwright/core/spline/alpha_surface.hpp>

#include "alphas.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::uniform;
using test::Vec;
using testing::HasSubstr;

/// Text 002 (3), the power form.
Eigen::Vector4d byPowers(double a, double t) {
  const double t2 = t * t, t3 = t2 * t, t4 = t3 * t, t5 = t4 * t;
  return {
      1 - 5 * a * t + 10 * (2 * a - 1) * t2 + 10 * (2 - 3 * a) * t3 + 5 * (4 * a - 3) * t4 +
          (4 - 5 * a) * t5,
      5 * a * t + 5 * (1 - 4 * a) * t2 + 10 * (3 * a - 1) * t3 + 5 * (1 - 4 * a) * t4 + 5 * a * t5,
      5 * t2 - 10 * t3 + 5 * (1 + a) * t4 - 5 * a * t5, 5 * (1 - a) * t4 + (5 * a - 4) * t5};
}

Vec direct(const AlphaCurve& curve, double t) {
  return curve.poles.transpose() * byPowers(curve.a, t);
}

AlphaCurve polygonOf(const json& points, double a) {
  AlphaCurve curve;
  for (int i = 0; i < 4; ++i) curve.poles.row(i) = test::vector(points[i]).transpose();
  curve.a = a;
  return curve;
}

/// The next curve of a join, with free poles that go on.
AlphaCurve next(const AlphaCurve& given, const AlphaCurveJoin& join, std::mt19937_64& random) {
  AlphaCurve result = test::randomAlphaCurve(random);
  result.a = join.next_a;
  const Poles poles = alphaJoinPoles(given, join);
  for (Eigen::Index i = poles.rows(); i < 4; ++i) result.poles.row(i) += poles.bottomRows<1>();
  result.poles.topRows(poles.rows()) = poles;
  return result;
}

AlphaCurveJoin randomJoin(int order, std::mt19937_64& random) {
  return {order,
          uniform(0.5, 1.5, random),
          uniform(-1, 1, random),
          uniform(0.5, 2, random),
          uniform(0.5, 2, random),
          uniform(0.1, 1, random)};
}

TEST(AlphaCurve, Identity1TheBasisIsPositiveAndSumsToOne) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 3000; ++i) {
    const double a = i % 10 == 0 ? 0 : i % 10 == 1 ? 1 : uniform(0, 1, random);
    const double t = i % 7 == 0 ? 0 : i % 7 == 1 ? 1 : uniform(0, 1, random);
    const Eigen::Vector4d b = alphaBasis(a, t);
    EXPECT_LE((b - byPowers(a, t)).cwiseAbs().maxCoeff(), 1e-14) << a << " " << t;
    EXPECT_GE(b.minCoeff(), 0);
    EXPECT_NEAR(b.sum(), 1, 1e-15);
    EXPECT_LE((b - alphaBasis(a, 1 - t).reverse()).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(AlphaCurve, Identity2TheQuinticIsTheSameCurve) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    AlphaCurve curve = test::randomAlphaCurve(random);
    if (i % 10 == 0) curve.a = 0;
    if (i % 10 == 1) curve.a = 1;
    if (i % 10 == 2) curve.poles.row(2) = curve.poles.row(1);
    const BezierCurve quintic = alphaCurveBezier(curve);
    ASSERT_EQ(quintic.degree(), 5);
    EXPECT_FALSE(quintic.isRational());
    for (int k = 0; k <= 10; ++k)
      EXPECT_LE((quintic.point(k / 10.0) - direct(curve, k / 10.0)).norm(), 1e-13);
    AlphaCurve back = curve;
    back.poles = curve.poles.colwise().reverse().eval();
    EXPECT_LE((alphaCurveBezier(back).poles() - quintic.reversed().poles()).cwiseAbs().maxCoeff(),
              1e-15);
  }
}

TEST(AlphaCurve, CurvesAndSurfacesOfTheDataFile) {
  int curves = 0, surfaces = 0;
  for (const json& entry : test::casesOf("alpha_curves.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const json &in = entry["in"], &out = entry["out"];
    if (in["kind"] == "curve") {
      ++curves;
      const AlphaCurve curve = polygonOf(in["P"], in["alpha"]);
      const BezierCurve quintic = alphaCurveBezier(curve);
      const double scale = 1 + curve.poles.cwiseAbs().maxCoeff();
      for (int i = 0; i < 6; ++i)
        EXPECT_LE((quintic.poles().row(i).transpose() - test::vector(out["quintic"][i])).norm(),
                  1e-15 * scale);
      const double t = in["t"];
      EXPECT_LE((quintic.point(t) - test::vector(out["value"])).norm(), 1e-14 * scale);
      for (const auto& [name, end] : {std::pair{"d0", 0.0}, std::pair{"d1", 1.0}})
        for (int k = 1; k <= 3; ++k) {
          const Vec derivative = quintic.derivatives(end, 3).row(k).transpose();
          EXPECT_LE((derivative - test::vector(out[name][k - 1])).norm(), 1e-12 * scale)
              << name << k;
        }
      // The curve is linear in its shape.
      AlphaCurve low = curve, high = curve;
      low.a = 0;
      high.a = 1;
      const Vec change = alphaCurveBezier(high).point(t) - alphaCurveBezier(low).point(t);
      EXPECT_LE((change - test::vector(out["dr_dalpha"])).norm(), 1e-14 * scale);
    } else {
      ++surfaces;
      AlphaSurface surface;
      for (int i = 0; i < 16; ++i)
        surface.poles.row(i) = test::vector(in["P"][i / 4][i % 4]).transpose();
      surface.a_u = in["alpha_u"];
      surface.a_v = in["alpha_v"];
      const BezierPatch patch = alphaSurfacePatch(surface);
      const Poles poles = patch.poles();
      for (int i = 0; i < 36; ++i)
        EXPECT_LE((poles.row(i).transpose() - test::vector(out["biquintic"][i / 6][i % 6])).norm(),
                  1e-14);
      EXPECT_LE((patch.point(in["u"], in["v"]) - test::vector(out["value"])).norm(), 1e-14);
    }
  }
  EXPECT_GE(curves, 6);
  EXPECT_GE(surfaces, 4);
}

/// Of 400 heights above a plane along the quintic that those of the four poles make, at any shape.
int meetings(const Eigen::Vector4d& heights, double a) {
  Eigen::VectorXd along(401);
  for (int k = 0; k <= 400; ++k) along(k) = heights.dot(byPowers(a, k / 400.0));
  return test::signChanges(along);
}

TEST(AlphaCurve, Identity3NoPlaneMeetsItMoreOftenThanThePolygon) {
  std::mt19937_64 random(testSeed());
  int outside = 0, most = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector4d heights =
        Eigen::Vector4d::NullaryExpr([&] { return uniform(-1, 1, random); });
    const int polygon = test::signChanges(heights);
    const int curve = meetings(heights, uniform(0, 1, random));
    EXPECT_LE(curve, polygon);
    most = std::max(most, curve);
    outside += meetings(heights, 2) > polygon;
  }
  EXPECT_EQ(most, 3);
  EXPECT_GT(outside, 0) << "beyond a = 1 the claim is false, so this test can fail";
}

TEST(AlphaCurve, ItIsCloserToThePolygonTheLargerTheShape) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    // A convex arch: the area below it grows with the shape, up to that below the polygon.
    AlphaCurve curve;
    curve.poles << 0, 0, 0, uniform(-0.5, 0.8, random), uniform(0.5, 2, random), 0,
        uniform(1.2, 2.5, random), uniform(0.5, 2, random), 0, 2, 0, 0;
    const auto area = [](const Poles& x) {
      double twice = 0;
      for (Eigen::Index k = 0; k + 1 < x.rows(); ++k)
        twice += x(k + 1, 0) * x(k, 1) - x(k, 0) * x(k + 1, 1);
      return twice / 2;
    };
    double before = 0;
    for (const double a : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      curve.a = a;
      Poles points(201, 3);
      for (int k = 0; k <= 200; ++k)
        points.row(k) = alphaCurveBezier(curve).point(k / 200.0).transpose();
      EXPECT_GT(area(points), before);
      before = area(points);
    }
    EXPECT_LT(before, area(curve.poles));
    Poles cubic(201, 3);
    for (int k = 0; k <= 200; ++k)
      cubic.row(k) = BezierCurve(Poles(curve.poles)).point(k / 200.0).transpose();
    EXPECT_GT(before, area(cubic)) << "with a = 1 it is closer than the cubic Bezier curve";
  }
}

TEST(AlphaCurve, ShapeZeroAndTheCubic) {
  AlphaCurve curve;
  curve.poles << 0, 0, 0, 1, 3, 0, 4, 2, 1, 5, 0, 0;
  curve.a = 0;
  const CurveDerivatives x = alphaCurveBezier(curve).derivatives(0, 2);
  EXPECT_EQ(x.row(1).norm(), 0) << "C8.2: for a = 0 no tangent along the first leg";
  const Vec middle = (curve.poles.row(1) + curve.poles.row(2)).transpose() / 2;
  EXPECT_LE(x.row(2).transpose().normalized().cross(middle.normalized()).norm(), 1e-15);
  const Eigen::Vector4d b = alphaBasis(0, 0.3);
  EXPECT_EQ(b(1), b(2)) << "C8.2: the functions are dependent";
  // No shape gives the cubic Bezier curve: its quintic has poles 2 and 3 apart.
  const BezierCurve cubic = BezierCurve(Poles(curve.poles)).elevated().elevated();
  EXPECT_GT((cubic.poles().row(3) - cubic.poles().row(2)).norm(), 0.5);
  for (const double a : {0.0, 0.3, 1.0}) {
    curve.a = a;
    const Poles poles = alphaCurveBezier(curve).poles();
    EXPECT_EQ(poles.row(2), poles.row(3));
  }
}

TEST(AlphaCurve, JoinsOfTheDataFile) {
  int count = 0;
  for (const json& entry : test::casesOf("alpha_joins.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const json &in = entry["in"], &out = entry["out"];
    const std::string kind = in["kind"];
    const AlphaCurve given = polygonOf(in["P"], in["a1"]);
    AlphaCurveJoin join;
    join.order = kind[1] - '0';
    join.beta1 = in["beta1"];
    if (kind == "G2") join.beta2 = in["beta2"];
    if (kind == "G3") join.beta2 = std::numeric_limits<double>::denorm_min();  // not read
    join.length = in["h1"];
    join.next_length = in["h2"];
    join.next_a = in["a2"];
    const Poles poles = alphaJoinPoles(given, join);
    ASSERT_EQ(poles.rows(), static_cast<Eigen::Index>(out["Q"].size()));
    const double scale = 1 + poles.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < poles.rows(); ++i)
      EXPECT_LE((poles.row(i).transpose() - test::vector(out["Q"][i])).norm(), 1e-12 * scale);
    ++count;
    if (join.order == 1) continue;
    AlphaCurve after = given;
    after.a = join.next_a;
    after.poles.topRows<3>() = poles;
    const CurveDerivatives x = test::byCommon(alphaCurveBezier(given), 1, join.length, 3),
                           y = test::byCommon(alphaCurveBezier(after), 0, join.next_length, 3);
    if (kind == "C2") {
      const Vec left = y.row(3) - x.row(3) - out["w31"].get<double>() * x.row(1) -
                       out["w32"].get<double>() * x.row(2);
      EXPECT_LE(left.norm(), 1e-11 * (1 + y.row(3).norm() + x.row(3).norm()));
    }
    if (kind == "G3") {
      const Vec betas(join.beta1, out["beta2"], out["beta3"]);
      EXPECT_LE(test::misfit(x, y, betas), 1e-11);
      EXPECT_LE((test::thirdOrderBetas(join.beta1, join.length, join.next_length) - betas).norm(),
                1e-13 * betas.norm());
    }
  }
  EXPECT_EQ(count, 30);
}

TEST(AlphaCurve, Identity4TheJointHasItsOrder) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 2000; ++i) {
    const int order = 1 + i % 3;
    const AlphaCurve given = test::randomAlphaCurve(random);
    const AlphaCurveJoin join = randomJoin(order, random);
    const AlphaCurve after = next(given, join, random);
    const BezierCurve a = alphaCurveBezier(given), b = alphaCurveBezier(after);
    const Vec betas = order == 3 ? test::thirdOrderBetas(join.beta1, join.length, join.next_length)
                                 : Vec(join.beta1, join.beta2, 0);
    EXPECT_LE(test::misfit(test::byCommon(a, 1, join.length, order),
                           test::byCommon(b, 0, join.next_length, order), betas),
              1e-11)
        << i;
    const CurveJoint joint = measureJoint(a, b, order);
    if (joint.sizes[1] == 0 || (given.poles.row(3) - given.poles.row(2)).norm() < 0.05) continue;
    for (int k = 0; k <= order; ++k)
      EXPECT_LE(joint.differences[k], 1e-9 * std::max(1.0, joint.sizes[k])) << k;
    // The pole of the highest order by 1e-6 of the size of its neighbours, across the tangent.
    AlphaCurve moved = after;
    const int last = std::min(order, 2);
    const Vec tangent = a.derivatives(1, 1).row(1).transpose().normalized();
    const double size = (after.poles.row(last) - after.poles.row(0)).norm();
    moved.poles.row(last) += 1e-6 * size * tangent.unitOrthogonal().transpose();
    const CurveJoint broken = measureJoint(a, alphaCurveBezier(moved), order);
    EXPECT_GT(broken.differences[last], 100 * joint.differences[last]) << i;
    ContinuityTolerance tight;
    tight.gap_mm = tight.angle_rad = tight.curvature_rel = 1e-8;
    EXPECT_EQ(orderReached(joint, tight), order);
    EXPECT_LT(orderReached(broken, tight), order) << i;
  }
}

TEST(AlphaCurve, Identity5CurvatureAndTorsionAreContinuousAndG3IsNotReached) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    const AlphaCurve given = test::randomAlphaCurve(random);
    AlphaCurveJoin join = randomJoin(2, random);
    if (i % 2 == 0) {
      join.beta1 = 1;
      join.beta2 = 0;
    }
    const BezierCurve a = alphaCurveBezier(given), b = alphaCurveBezier(next(given, join, random));
    const CurveDerivatives x = test::byCommon(a, 1, join.length, 3);
    const Vec first = x.row(1).transpose(), second = x.row(2).transpose();
    const double speed = first.norm(), kappa = first.cross(second).norm() / std::pow(speed, 3);
    if (speed < 0.1 || kappa < 1e-3) continue;
    for (const auto& [curve, t] : {std::pair{&a, 1.0}, std::pair{&b, 0.0}}) {
      const CurveDerivatives d = curve->derivatives(t, 3);
      const Vec d1 = d.row(1), d2 = d.row(2), d3 = d.row(3);
      EXPECT_LE(std::abs(d1.cross(d2).dot(d3)), 1e-12 * d1.norm() * d2.norm() * d3.norm())
          << "no torsion";
    }
    const double h = join.length, k = join.next_length, b1 = join.beta1;
    const double excess = std::abs(3 * b1 * join.beta2 + 6 * b1 * b1 * (b1 / h + 1 / k));
    const double jump = excess * kappa / (b1 * b1 * b1 * speed);
    const CurveJoint joint = measureJoint(a, b, 3);
    EXPECT_NEAR(joint.differences[2], 0, 1e-10 * (1 + kappa));
    EXPECT_NEAR(joint.differences[3], jump, 1e-8 * (1 + joint.sizes[3]))
        << "jump of the change of curvature";
    EXPECT_GT(jump, 0) << "C8.5: G2 is not G3 by itself";
    join.beta2 = test::thirdOrderBetas(b1, h, k)(1);
    const CurveJoint third = measureJoint(a, alphaCurveBezier(next(given, join, random)), 3);
    EXPECT_NEAR(third.differences[3], 0, 1e-8 * (1 + third.sizes[3]));
  }
}

TEST(AlphaCurve, AStraightEndIsTheException) {
  std::mt19937_64 random(testSeed());
  AlphaCurve given = test::randomAlphaCurve(random);
  given.poles.row(1) = given.poles.row(3) - 2.5 * (given.poles.row(3) - given.poles.row(2));
  const AlphaCurveJoin join{2, 1, 0, 1, 1.5, 0.4};
  const CurveJoint joint =
      measureJoint(alphaCurveBezier(given), alphaCurveBezier(next(given, join, random)), 3);
  EXPECT_NEAR(joint.differences[3], 0, 1e-10);
}

TEST(AlphaCurve, JoinsFollowAffineMapsAndScales) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const AlphaCurve given = test::randomAlphaCurve(random);
    const AlphaCurveJoin join = randomJoin(1 + i % 3, random);
    const double scale = test::logUniform(random, -6, 6);
    const Eigen::Matrix3d map =
        scale * (Eigen::Matrix3d::Identity() + 0.3 * test::randomRotation(random));
    AlphaCurve mapped = given;
    mapped.poles = given.poles * map.transpose();
    const Poles expected = alphaJoinPoles(given, join) * map.transpose(),
                poles = alphaJoinPoles(mapped, join);
    EXPECT_LE((poles - expected).cwiseAbs().maxCoeff(),
              1e-13 * (scale + expected.cwiseAbs().maxCoeff()));
    // The common parameter has no unit of its own.
    AlphaCurveJoin slower = join;
    slower.length *= 8;
    slower.next_length *= 8;
    slower.beta2 /= 8;
    EXPECT_LE((alphaJoinPoles(given, slower) - alphaJoinPoles(given, join)).cwiseAbs().maxCoeff(),
              1e-12 * (1 + alphaJoinPoles(given, join).cwiseAbs().maxCoeff()));
  }
}

/// The integral of |X^(k)|^2 with five Gauss points: exact to degree 9.
double energyByPoints(const AlphaCurve::Polygon& poles, double a, int k) {
  constexpr std::array nodes = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array weights = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  Poles quintic(6, 3);  // by hand, for any a
  const Eigen::RowVector3d middle = (poles.row(1) + poles.row(2)) / 2;
  quintic << poles.row(0), (1 - a) * poles.row(0) + a * poles.row(1), middle, middle,
      a * poles.row(2) + (1 - a) * poles.row(3), poles.row(3);
  const BezierCurve curve(quintic);
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    for (const double sign : {-1.0, 1.0}) {
      if (i == 0 && sign > 0) continue;
      sum += weights[i] / 2 * curve.derivatives((1 + sign * nodes[i]) / 2, k).row(k).squaredNorm();
    }
  return sum;
}

TEST(AlphaCurve, EnergiesOfTheDataFile) {
  int count = 0;
  for (const json& entry : test::casesOf("alpha_energies.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const AlphaCurve curve = polygonOf(entry["in"]["P"], 1);
    for (int k = 1; k <= 3; ++k) {
      const json& out = entry["out"][std::to_string(k)];
      const AlphaOptimum optimum =
          energyOptimalAlpha(curve.poles, static_cast<AlphaEnergy>(k), 0, 1);
      EXPECT_NEAR(optimum.free_a, out["alpha_raw"].get<double>(),
                  1e-12 * (1 + std::abs(optimum.free_a)));
      EXPECT_NEAR(optimum.a, out["alpha"].get<double>(), 1e-12);
      EXPECT_NEAR(optimum.energy, out["E"].get<double>(), 1e-12 * optimum.energy);
      EXPECT_FALSE(optimum.any);
      ++count;
    }
  }
  EXPECT_EQ(count, 24);
}

TEST(AlphaCurve, Identity6NoShapeHasLess) {
  std::mt19937_64 random(testSeed());
  int clamped = 0;
  for (int i = 0; i < 900; ++i) {
    const int k = 1 + i % 3;
    const auto energy = static_cast<AlphaEnergy>(k);
    const AlphaCurve::Polygon poles = test::randomAlphaCurve(random).poles;
    const AlphaOptimum optimum = energyOptimalAlpha(poles, energy);
    const double least = energyByPoints(poles, optimum.a, k);
    EXPECT_NEAR(optimum.energy, least, 1e-12 * least);
    for (const double a : {0.05, 0.2, 0.4, 0.6, 0.8, 1.0})
      EXPECT_GE(energyByPoints(poles, a, k), least * (1 - 1e-13));
    clamped += optimum.a != optimum.free_a;
    // A quadratic: its central difference is its derivative.
    const double free_least = energyByPoints(poles, optimum.free_a, k);
    const double up = energyByPoints(poles, optimum.free_a + 1, k),
                 down = energyByPoints(poles, optimum.free_a - 1, k);
    EXPECT_NEAR(up - down, 0, 1e-11 * (up + down));
    EXPECT_GT(up, free_least);
    // [TuYanXu2022] has the other sign, which is not a minimum.
    const double printed = energyByPoints(poles, -optimum.free_a, k);
    if (std::abs(optimum.free_a) > 0.01) {
      EXPECT_GT(printed, free_least * (1 + 1e-9)) << "C8.7: the sign in print";
    }
  }
  EXPECT_GT(clamped, 20);
}

/// free_a of the matrices in print for k = 3 ([TuYanXu2022]), with that entry (P_2, P_3) and the
/// right sign.
double printedThird(const AlphaCurve::Polygon& poles, double entry) {
  Eigen::Matrix4d X, Y;
  X << -5, 8, 4, -2, 0, -3, -6, 4, 0, 0, -3, entry, 0, 0, 0, -5;
  Y << 4, -8, -1, 1, 0, 4, 1, -1, 0, 0, 4, -8, 0, 0, 0, 4;
  return -0.5 * (poles.transpose() * X * poles).trace() / (poles.transpose() * Y * poles).trace();
}

TEST(AlphaCurve, ThePrintedMatrixHasAnErrorInOneEntry) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const AlphaCurve::Polygon poles = test::randomAlphaCurve(random).poles;
    const double a = energyOptimalAlpha(poles, AlphaEnergy::CurvatureVariation).free_a;
    EXPECT_NEAR(printedThird(poles, 8), a, 1e-11);
    EXPECT_GT(std::abs(printedThird(poles, 6) - a), 1e-6) << "C8.7: the entry in print";
  }
}

TEST(AlphaCurve, EnergyOfDegeneratePolygonsAndSizes) {
  AlphaCurve::Polygon poles;
  poles << 1, 2, 3, 1, 2, 3, 4, 5, 6, 4, 5, 6;
  const AlphaOptimum any = energyOptimalAlpha(poles, AlphaEnergy::Length, 0.1, 0.7);
  EXPECT_TRUE(any.any);
  EXPECT_EQ(any.a, 0.7);
  EXPECT_NEAR(any.energy, energyByPoints(poles, 0.3, 1), 1e-12 * any.energy);
  const AlphaCurve::Polygon point = AlphaCurve::Polygon::Ones();
  EXPECT_EQ(energyOptimalAlpha(point, AlphaEnergy::Curvature).energy, 0);
  std::mt19937_64 random(testSeed());
  const AlphaCurve::Polygon given = test::randomAlphaCurve(random).poles;
  const double a = energyOptimalAlpha(given, AlphaEnergy::Curvature).free_a;
  for (const int exponent : {-900, -300, 300, 900}) {
    const AlphaCurve::Polygon scaled = std::ldexp(1.0, exponent) * given;
    EXPECT_EQ(energyOptimalAlpha(scaled, AlphaEnergy::Curvature).free_a, a) << exponent;
  }
  AlphaCurve::Polygon far = given;
  far.rowwise() += Eigen::RowVector3d(1e6, -1e6, 1e6);
  EXPECT_NEAR(energyOptimalAlpha(far, AlphaEnergy::Curvature).free_a, a, 1e-8);
}

TEST(AlphaCurve, RefusesBadCurvesAndJoins) {
  std::mt19937_64 random(testSeed());
  const AlphaCurve given = test::randomAlphaCurve(random);
  const AlphaCurveJoin good = randomJoin(2, random);
  const auto with = [&](auto change) {
    AlphaCurve curve = given;
    AlphaCurveJoin join = good;
    change(curve, join);
    return test::complaint([&] { alphaJoinPoles(curve, join); });
  };
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(with([](auto&, auto&) {}), "nothing was refused");
  EXPECT_THAT(with([](auto&, auto& j) { j.order = 0; }), HasSubstr("order 0"));
  EXPECT_THAT(with([](auto&, auto& j) { j.order = 4; }), HasSubstr("order 4"));
  EXPECT_THAT(with([](auto&, auto& j) { j.beta1 = -2; }), HasSubstr("beta1 is -2"));
  EXPECT_THAT(with([&](auto&, auto& j) { j.beta2 = nan; }), HasSubstr("beta2 is nan"));
  EXPECT_THAT(with([](auto&, auto& j) { j.length = 0; }), HasSubstr("length is 0"));
  EXPECT_THAT(with([&](auto&, auto& j) { j.next_length = inf; }), HasSubstr("next_length is inf"));
  EXPECT_THAT(with([](auto&, auto& j) { j.next_a = 0; }), HasSubstr("next_a is 0"));
  EXPECT_THAT(with([](auto& c, auto&) { c.a = 1.25; }), HasSubstr("a is 1.25"));
  EXPECT_THAT(with([](auto& c, auto&) { c.a = 0; }), HasSubstr("a is 0")) << "C8.4: a > 0";
  EXPECT_THAT(with([&](auto& c, auto&) { c.poles(2, 1) = nan; }), HasSubstr("pole 2 is ("));
  EXPECT_THAT(with([](auto& c, auto&) { c.poles.row(2) = c.poles.row(3).eval(); }),
              HasSubstr("poles 2 and 3 are the same"));
  for (const AlphaCurveJoin& far :
       {AlphaCurveJoin{2, 1e200}, AlphaCurveJoin{1, 1, 0, 1e-10, 1e308},
        AlphaCurveJoin{3, 1, 0, 1e-300}, AlphaCurveJoin{2, 1, 1e308, 1, 1e10}})
    EXPECT_THAT(test::complaint([&] { alphaJoinPoles(given, far); }),
                HasSubstr("of the next one comes out as ("))
        << far.beta1;
  EXPECT_NO_THROW(alphaJoinPoles(given, {1, 1e200})) << "order 1 has no square of beta1";
  AlphaCurve odd = given;
  odd.a = -0.5;
  EXPECT_THAT(test::complaint([&] { alphaCurveBezier(odd); }), HasSubstr("a is -0.5"));
  odd = given;
  odd.poles(0, 0) = inf;
  EXPECT_THAT(test::complaint([&] { alphaCurveBezier(odd); }), HasSubstr("pole 0 is (inf"));
  EXPECT_THAT(test::complaint([&] { alphaBasis(2, 0.5); }), HasSubstr("a is 2"));
  EXPECT_THAT(test::complaint([&] { alphaBasis(0.5, nan); }), HasSubstr("t is nan"));
  const auto energy = [&](double low, double high) {
    return test::complaint(
        [&] { energyOptimalAlpha(given.poles, AlphaEnergy::Length, low, high); });
  };
  EXPECT_THAT(energy(-0.1, 1), HasSubstr("a_min is -0.1"));
  EXPECT_THAT(energy(0.5, 0.4), HasSubstr("a_max is 0.4"));
  EXPECT_THAT(energy(0.5, nan), HasSubstr("a_max is nan"));
  EXPECT_THAT(test::complaint([&] { energyOptimalAlpha(odd.poles, AlphaEnergy::Length); }),
              HasSubstr("pole 0"));
}

}  // namespace
}  // namespace seamwright
