// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <seamwright/core/bezier/frenet.hpp>

#include "curves.hpp"
#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::Vec;

constexpr int cases = 2000;

BezierCurve randomCurve(int degree, bool rational, std::mt19937_64& random) {
  Poles poles(degree + 1, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(degree + 1);
  for (int i = 0; i <= degree; ++i) {
    poles.row(i) = test::randomVector(random).transpose();
    if (rational) weights(i) = test::logUniform(random, -0.5, 0.5);
  }
  return {poles, weights};
}

BezierCurve mapped(const BezierCurve& curve, const Eigen::Matrix3d& matrix, const Vec& shift) {
  const Poles poles = (curve.poles() * matrix.transpose()).rowwise() + shift.transpose();
  return {poles, curve.weights()};
}

/// Helix (r cos t, r sin t, b t).
CurveDerivatives helix(double r, double b, double t, int order) {
  CurveDerivatives x = test::circle(r, t, order);
  x(0, 2) = b * t;
  x(1, 2) = b;
  return x;
}

struct Figures {
  Vec T, N, B;
  double kappa, tau, kappa_s;
};

Figures figures(const FrenetFrame& frame) {
  EXPECT_EQ(frame.kind, CurvePoint::Regular);
  const Vec none = Vec::Constant(std::nan(""));
  const double no = std::nan("");
  return {frame.tangent.value_or(none),      frame.normal.value_or(none),
          frame.binormal.value_or(none),     frame.curvature_per_mm.value_or(no),
          frame.torsion_per_mm.value_or(no), frame.curvature_change_per_mm2.value_or(no)};
}

/// How much relative errors of X' and X'' count in the direction of X' x X'': 1 / sin of their
/// angle.
double condition(const CurveDerivatives& x) {
  const Vec d1 = x.row(1), d2 = x.row(2);
  return d1.norm() * d2.norm() / d1.cross(d2).norm();
}

TEST(Frenet, AgreesWithTheDataTo40Digits) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/frenet.json");
  const json data = json::parse(file);
  ASSERT_EQ(data["cases"].size(), 8u);
  for (const json& entry : data["cases"]) {
    SCOPED_TRACE(entry["name"]);
    const json& out = entry["out"];
    const BezierCurve curve = test::bezierCurve(entry["in"]["points"], entry["in"]["weights"]);
    const FrenetFrame frame = frenetFrame(curve, entry["in"]["t"]);
    const Figures f = figures(frame);
    const double kappa = out["kappa"], tau = out["tau"], kappa_s = out["dkappa_ds"];
    const double bound = 1e-14 * std::max(10.0, condition(curve.derivatives(entry["in"]["t"], 2)));
    EXPECT_NEAR(frame.speed, out["speed"], 1e-14 * frame.speed);
    EXPECT_LT((f.T - test::vector(out["T"])).norm(), 1e-14);
    EXPECT_LT((f.N - test::vector(out["N"])).norm(), bound);
    EXPECT_LT((f.B - test::vector(out["B"])).norm(), bound);
    EXPECT_NEAR(f.kappa, kappa, 1e-13 * kappa);
    EXPECT_NEAR(f.tau, tau, 1e-13 * (1 + std::abs(tau)));
    EXPECT_NEAR(f.kappa_s, kappa_s, 1e-13 * (1 + std::abs(kappa_s)));
  }
}

TEST(Frenet, Identity1SerretByDifferences) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const BezierCurve curve = randomCurve(3 + i % 5, i % 2 == 1, random);
    const double t = 0.1 + 0.8 * i / cases, h = 2e-4;
    const CurveDerivatives x = curve.derivatives(t, 2);
    // Where the frame turns fast, differences say little.
    if (condition(x) > 3 || x.row(2).norm() > 10 * x.row(1).norm()) continue;
    const Figures f = figures(frenetFrame(curve, t));
    const auto at = [&](double s) { return figures(frenetFrame(curve, t + s)); };
    const Figures a = at(-2 * h), b = at(-h), c = at(h), d = at(2 * h);
    const double step = 12 * h * x.row(1).norm();
    const auto rate = [&](auto member) {
      return ((a.*member - d.*member) + 8 * (c.*member - b.*member)) / step;
    };
    const double size = 1 + std::pow(f.kappa + std::abs(f.tau), 5);
    EXPECT_LT((Vec(rate(&Figures::T)) - f.kappa * f.N).norm(), 1e-7 * size) << i;
    EXPECT_LT((Vec(rate(&Figures::N)) + f.kappa * f.T - f.tau * f.B).norm(), 1e-7 * size) << i;
    EXPECT_LT((Vec(rate(&Figures::B)) + f.tau * f.N).norm(), 1e-7 * size) << i;
    EXPECT_NEAR(rate(&Figures::kappa), f.kappa_s, 1e-7 * size) << i;
  }
}

TEST(Frenet, Identity2CircleAndHelix) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const double r = test::logUniform(random, -3, 4),
                 b = i % 3 == 0 ? 0 : (i % 2 ? 1 : -1) * r * test::logUniform(random, -2, 2);
    const double t = 0.01 * i, square = r * r + b * b;
    const Figures f = figures(frenetFrame(helix(r, b, t, 3)));
    EXPECT_NEAR(f.kappa * square / r, 1, 1e-14);
    EXPECT_NEAR(f.tau * square / r, b / r, 1e-12 * (1 + std::abs(b / r)));
    EXPECT_NEAR(f.kappa_s * square, 0, 1e-12);
    EXPECT_LT((f.N - Vec(-std::cos(t), -std::sin(t), 0)).norm(), 1e-13 * (1 + std::abs(b) / r));
    const Vec B = Vec(b * std::sin(t), -b * std::cos(t), r) / std::sqrt(square);
    EXPECT_LT((f.B - B).norm(), 1e-13 * (1 + std::abs(b) / r));
  }
}

TEST(Frenet, Identity3IndependentOfTheParameter) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const CurveDerivatives x = test::randomDerivatives(3, random);
    const double bound = 1e-12 * std::pow(condition(x), 2) * (1 + x.norm());
    const Figures f = figures(frenetFrame(x)), g = figures(frenetFrame(test::reparametrised(
                                                   x, test::randomParameter(3, random))));
    CurveDerivatives y = x;
    y.row(1) *= -1;
    y.row(3) *= -1;
    const Figures back = figures(frenetFrame(y));
    EXPECT_LT((f.T - g.T).norm() + (f.N - g.N).norm() + (f.B - g.B).norm(), bound);
    EXPECT_LT((f.T + back.T).norm() + (f.N - back.N).norm() + (f.B + back.B).norm(), bound);
    const double size = 1 + std::pow(f.kappa, 2) + std::abs(f.tau) + std::abs(f.kappa_s);
    EXPECT_NEAR(f.kappa, g.kappa, 10 * bound * size);
    EXPECT_NEAR(f.tau, g.tau, 10 * bound * size);
    EXPECT_NEAR(f.kappa_s, g.kappa_s, 10 * bound * size);
    EXPECT_EQ(f.kappa, back.kappa);
    EXPECT_EQ(f.tau, back.tau);
    EXPECT_EQ(f.kappa_s, -back.kappa_s);
  }
}

TEST(Frenet, Identity4FollowsMotionScaleAndMirror) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const BezierCurve curve = randomCurve(3 + i % 4, i % 2 == 1, random);
    const double t = static_cast<double>(i) / cases, scale = test::logUniform(random, -6, 6);
    const CurveDerivatives x = curve.derivatives(t, 3);
    if (condition(x) > 100) continue;
    const Eigen::Matrix3d turn = test::randomRotation(random);
    Eigen::Matrix3d mirror = turn;
    mirror.col(0) *= -1;
    const Figures f = figures(frenetFrame(curve, t));
    const double bound = 1e-11 *
                         (1 + x.row(2).norm() / x.row(1).squaredNorm() +
                          x.row(3).norm() / std::pow(x.row(1).norm(), 3)) *
                         condition(x);
    const Figures g =
        figures(frenetFrame(mapped(curve, scale * turn, scale * test::randomVector(random)), t));
    EXPECT_LT((turn * f.T - g.T).norm() + (turn * f.N - g.N).norm() + (turn * f.B - g.B).norm(),
              bound)
        << i;
    EXPECT_NEAR(f.kappa, scale * g.kappa, bound * (1 + f.kappa)) << i;
    EXPECT_NEAR(f.tau, scale * g.tau, bound * (1 + f.kappa + std::abs(f.tau) / f.kappa)) << i;
    EXPECT_NEAR(f.kappa_s, scale * scale * g.kappa_s,
                bound * (1 + f.kappa * f.kappa + std::abs(f.kappa_s)))
        << i;
    const Figures m = figures(frenetFrame(mapped(curve, mirror, Vec::Zero()), t));
    EXPECT_LT((mirror * f.N - m.N).norm() + (mirror * f.B + m.B).norm(), bound) << i;
    EXPECT_NEAR(f.tau, -m.tau, bound * (1 + f.kappa + std::abs(f.tau) / f.kappa)) << i;
  }
}

// As printed the denominator is the vector itself, without bars: no unit vector comes of it.
TEST(Frenet, PrintedNormalLacksTheNorm) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const CurveDerivatives x = test::randomDerivatives(3, random);
    const Vec d1 = x.row(1), d2 = x.row(2);
    const Vec vector = d1.squaredNorm() * d2 - d1.dot(d2) * d1;
    const Vec printed = vector.cwiseQuotient(vector), N = figures(frenetFrame(x)).N;
    EXPECT_NEAR(printed.norm(), std::sqrt(3.0), 1e-15);
    EXPECT_LT((vector / vector.norm() - N).norm(), 1e-13 * condition(x));
    EXPECT_NEAR(N.norm(), 1, 1e-15);
  }
}

// Poles are whole numbers on a line, so the curvature is zero but for rounding of the evaluation.
TEST(Frenet, LinesHaveNoCurvatureAndAlmostLinesHave) {
  std::mt19937_64 random(testSeed());
  std::uniform_int_distribution<int> whole(-9, 9);
  int regular = 0;
  for (int i = 0; i < cases; ++i) {
    const int degree = 2 + i % 7;
    const Vec p(100 * whole(random), whole(random), whole(random)),
        q(1 + std::abs(whole(random)), whole(random), whole(random));
    Poles poles(degree + 1, 3);
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(degree + 1);
    for (int k = 0; k <= degree; ++k) {
      poles.row(k) = (p + (20 * k + whole(random)) * q).transpose();
      if (i % 2) weights(k) = 10 + whole(random);
    }
    const double t = static_cast<double>(i) / cases;
    const FrenetFrame frame = frenetFrame(BezierCurve(poles, weights), t);
    ASSERT_EQ(frame.kind, CurvePoint::Inflection) << i;
    EXPECT_LT((*frame.tangent - q.normalized()).norm(), 1e-12);
    EXPECT_EQ(frame.curvature_per_mm, 0.0);
    EXPECT_FALSE(frame.normal || frame.binormal || frame.torsion_per_mm ||
                 frame.curvature_change_per_mm2);
    poles.row(1) += 1e-6 * poles.row(1).norm() * q.unitOrthogonal().transpose();
    regular += frenetFrame(BezierCurve(poles, weights), t).kind == CurvePoint::Regular;
  }
  EXPECT_GT(regular, 9 * cases / 10);  // not where the moved pole counts for nothing
}

TEST(Frenet, CuspsHaveTheTangentOfTheFirstDerivative) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0;  // X'(1/2) = 0, X''(1/2) = (0, -6, 0)
  const FrenetFrame cusp = frenetFrame(BezierCurve(poles), 0.5);
  EXPECT_EQ(cusp.kind, CurvePoint::Cusp);
  EXPECT_EQ(*cusp.tangent, Vec(0, -1, 0));
  EXPECT_FALSE(cusp.curvature_per_mm || cusp.normal);
  poles.row(1) += Eigen::RowVector3d(0, 0, 1e-6);
  EXPECT_EQ(frenetFrame(BezierCurve(poles), 0.5).kind, CurvePoint::Regular);
  Poles end(5, 3);
  end << 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 5, 7, 7, 7;
  const FrenetFrame late = frenetFrame(BezierCurve(end), 0);
  EXPECT_EQ(late.kind, CurvePoint::Cusp);
  EXPECT_EQ(*late.tangent, Vec(0, 0, 1));
  const FrenetFrame point = frenetFrame(BezierCurve(Poles::Constant(4, 3, 0.1)), 0.3);
  EXPECT_EQ(point.kind, CurvePoint::Point);
  EXPECT_FALSE(point.tangent);
}

TEST(Frenet, SurvivesExtremeSpeeds) {
  const Figures plain = figures(frenetFrame(helix(2, 1, 0.4, 3)));
  for (const double speed : {1e-90, 1e-30, 1e30, 1e90}) {
    CurveDerivatives x = helix(2, 1, 0.4, 3);
    for (int k = 1; k <= 3; ++k) x.row(k) *= std::pow(speed, k);
    const Figures f = figures(frenetFrame(x));
    EXPECT_NEAR(f.kappa, plain.kappa, 1e-14);
    EXPECT_NEAR(f.tau, plain.tau, 1e-14);
    EXPECT_NEAR(f.kappa_s, plain.kappa_s, 1e-14);
  }
}

// Orders above 3 are not needed here, and beyond the range of a double.
TEST(Frenet, HighDegreesAndSizes) {
  for (const auto& [degree, size] :
       {std::pair{165, 1.0}, std::pair{100, 1e150}, std::pair{25, 1e290}, std::pair{250, 1.0}}) {
    Poles poles(degree + 1, 3);
    for (int i = 0; i <= degree; ++i)
      poles.row(i) = size * Eigen::RowVector3d(i, static_cast<double>(i) * i / degree, std::cos(i));
    const BezierCurve curve(poles);
    const FrenetFrame frame = frenetFrame(curve, 0.4);
    EXPECT_EQ(frame.kind, CurvePoint::Regular) << degree;
    EXPECT_EQ(rotationMinimizingFrames(curve, {0.4}).size(), 1u);
  }
  Poles poles(9, 3);  // X' = 0 to order 6 at the end
  poles.setOnes();
  poles.bottomRows<2>() << 1, 1, 3, 7, 7, 7;
  const FrenetFrame late = frenetFrame(BezierCurve(poles), 0);
  EXPECT_EQ(late.kind, CurvePoint::Cusp);
  EXPECT_EQ(*late.tangent, Vec(0, 0, 1));
}

TEST(Frenet, TorsionOfAnySize) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 2, 0, 2, 0, 1, 3, 3, 0;
  const Figures plain = figures(frenetFrame(BezierCurve(poles), 0.3));
  for (const int exponent : {-560, -540, 540, 660}) {
    const double size = std::ldexp(1.0, exponent);
    const FrenetFrame frame = frenetFrame(BezierCurve(size * poles), 0.3);
    EXPECT_NEAR(frame.torsion_per_mm.value() * size, plain.tau, 1e-13) << exponent;
    EXPECT_NEAR(frame.curvature_per_mm.value() * size, plain.kappa, 1e-13) << exponent;
    if (exponent < 0) {
      EXPECT_FALSE(frame.curvature_change_per_mm2) << "beyond the range of a double";
    } else {
      EXPECT_EQ(frame.curvature_change_per_mm2.value(), 0) << exponent;
    }
  }
}

TEST(Frenet, FewDerivativesAndBadOnes) {
  const CurveDerivatives x = helix(2, 1, 0.4, 3);
  const FrenetFrame first = frenetFrame(x.topRows(2));
  EXPECT_TRUE(first.tangent && !first.normal && !first.curvature_per_mm);
  const FrenetFrame second = frenetFrame(x.topRows(3));
  EXPECT_TRUE(second.normal && !second.torsion_per_mm && !second.curvature_change_per_mm2);
  EXPECT_EQ(frenetFrame(x, 10).kind, CurvePoint::Cusp);
  EXPECT_EQ(frenetFrame(x, 0, 10).kind, CurvePoint::Inflection);
  const auto message = [](auto call) {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message([&] { frenetFrame(x.topRows(1)); }), testing::HasSubstr("1 rows"));
  EXPECT_THAT(message([&] { frenetFrame(x, -1); }), testing::HasSubstr("noise is -1"));
  EXPECT_THAT(message([&] { frenetFrame(x, 0, std::nan("")); }),
              testing::HasSubstr("noise is nan"));
  CurveDerivatives bad = x;
  bad(2, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(message([&] { frenetFrame(bad); }),
              testing::HasSubstr("coordinate 1 of derivative 2 is inf"));
  EXPECT_THAT(message([&] { frenetFrame(BezierCurve(Poles::Zero(2, 3)), std::nan("")); }),
              testing::HasSubstr("parameter is nan"));
}

std::vector<double> evenly(int steps, double first = 0, double last = 1) {
  std::vector<double> t;
  for (int i = 0; i <= steps; ++i) t.push_back(first + (last - first) * i / steps);
  return t;
}

/// The integral of torsion by arc length, by Simpson's rule: by so much the Frenet frame turns
/// against one that does not.
double totalTorsion(const BezierCurve& curve, int steps) {
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const FrenetFrame frame = frenetFrame(curve, static_cast<double>(i) / steps);
    sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * frame.torsion_per_mm.value() * frame.speed;
  }
  return sum / (3 * steps);
}

/// The angle from the frame's normal to the moving one at the end, both starting as one.
double twist(const BezierCurve& curve, int steps) {
  const auto frames = rotationMinimizingFrames(curve, evenly(steps), frenetFrame(curve, 0).normal);
  const FrenetFrame end = frenetFrame(curve, 1);
  return std::atan2(frames.back().normal.dot(*end.binormal), frames.back().normal.dot(*end.normal));
}

TEST(MovingFrame, TurnsAgainstFrenetByTheTotalTorsionWithFourthOrder) {
  std::mt19937_64 random(testSeed());
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    Poles poles(4, 3);
    poles << 0, 0, 0, 1, 0, 0, 1.5, 1, 0, 1.5, 1.5, 1;
    for (int k = 0; k < 4; ++k) poles.row(k) += 0.1 * test::randomVector(random).transpose();
    const BezierCurve curve(poles, Eigen::Vector4d(1, i % 2 ? 1.3 : 1, 0.9, 1));
    const double wanted = -totalTorsion(curve, 2000);
    const auto error = [&](int steps) {
      return std::abs(std::remainder(twist(curve, steps) - wanted, 2 * std::numbers::pi));
    };
    EXPECT_LT(error(400), 1e-9) << i;
    if (error(20) > 1e-7) {
      EXPECT_NEAR(std::log2(error(20) / error(40)), 4, 0.5) << i;
      ++seen;
    }
  }
  EXPECT_GT(seen, 30);
}

TEST(MovingFrame, FramesAreOrthonormalAndFollowMotions) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const BezierCurve curve = randomCurve(3 + i % 4, i % 2 == 1, random);
    const Vec normal = test::randomVector(random);
    const Eigen::Matrix3d turn = test::randomRotation(random);
    const auto frames = rotationMinimizingFrames(curve, evenly(50), normal);
    const auto moved =
        rotationMinimizingFrames(mapped(curve, 3 * turn, Vec(1, 2, 3)), evenly(50), turn * normal);
    ASSERT_EQ(frames.size(), 51u);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const MovingFrame& f = frames[k];
      Eigen::Matrix3d matrix;
      matrix << f.tangent, f.normal, f.binormal;
      EXPECT_LT((matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      EXPECT_NEAR(matrix.determinant(), 1, 1e-14);
      EXPECT_LT((turn * f.normal - moved[k].normal).norm(), 1e-9) << i;
      EXPECT_EQ(f.point, curve.point(f.t));
    }
    EXPECT_GT(frames[0].normal.dot(normal), 0);
    EXPECT_NEAR(frames[0].normal.dot(normal.cross(frames[0].tangent)), 0, 1e-14 * normal.norm());
  }
}

// A planar S: the Frenet normal jumps to the other side at the inflection, the moving one does not.
TEST(MovingFrame, GoesThroughInflectionsAndStraightPieces) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 2, 0, 2, -2, 0, 3, 0, 0;
  for (const MovingFrame& f : rotationMinimizingFrames(BezierCurve(poles), evenly(7), Vec(0, 0, 1)))
    EXPECT_LT((f.normal - Vec(0, 0, 1)).norm(), 1e-15);
  EXPECT_LT((*frenetFrame(BezierCurve(poles), 0.2).binormal +
             *frenetFrame(BezierCurve(poles), 0.8).binormal)
                .norm(),
            1e-15);
  Poles line(3, 3);
  line << 0, 0, 0, 1, 1, 1, 5, 5, 5;
  const auto frames = rotationMinimizingFrames(BezierCurve(line), evenly(5));
  for (const MovingFrame& f : frames) EXPECT_LT((f.normal - frames[0].normal).norm(), 1e-15);
}

// A closed curve whose ends are one point, in a single step; and a curve with a half turn in a
// step.
TEST(MovingFrame, LongStepsAreHalved) {
  Poles loop(5, 3);
  loop << 0, 0, 0, 4, 0, 0, 2, 5, 1, -4, 0, 0, 0, 0, 0;
  const BezierCurve curve(loop);
  const Vec coarse = rotationMinimizingFrames(curve, {0, 1}, Vec(0, 0, 1)).back().normal;
  const Vec fine = rotationMinimizingFrames(curve, evenly(4000), Vec(0, 0, 1)).back().normal;
  EXPECT_LT((coarse - fine).norm(), 0.1);
  EXPECT_LT(
      (rotationMinimizingFrames(curve, evenly(200), Vec(0, 0, 1)).back().normal - fine).norm(),
      1e-7);
}

TEST(MovingFrame, RefusesBadPlacesAndNormals) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0;
  const BezierCurve cusp(poles);
  const auto message = [&](const std::vector<double>& t, std::optional<Vec> normal = std::nullopt) {
    try {
      rotationMinimizingFrames(cusp, t, normal);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(message({0, 0.5}), testing::HasSubstr("cusp at parameter 0.5"));
  EXPECT_THAT(message({0, 0.2, 0.2}), testing::HasSubstr("parameter 2 is 0.2"));
  EXPECT_THAT(message({0, std::nan("")}), testing::HasSubstr("parameter 1 is nan"));
  EXPECT_THAT(message({0}, Vec(1, 1, 0)), testing::HasSubstr("must not lie along it"));
  EXPECT_THAT(message({0}, Vec::Zero()), testing::HasSubstr("must not lie along it"));
  EXPECT_THAT(message({0}, Vec(0, std::nan(""), 0)),
              testing::HasSubstr("coordinate 1 of the normal is nan"));
  EXPECT_THAT(message({0.1, 0.3}), testing::IsEmpty());
  EXPECT_THAT(message({0, 1}), testing::HasSubstr("cusp at parameter 0.5"));
  EXPECT_THAT(message({0.41, 0.62}), testing::HasSubstr("cusp at parameter 0.5"));
  EXPECT_TRUE(rotationMinimizingFrames(cusp, {}).empty());
}

}  // namespace
}  // namespace seamwright
