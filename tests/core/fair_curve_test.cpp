// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>

#include <seamwright/core/fair/fair_curve.hpp>

#include "noisy_curves.hpp"
#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::largestDistance_mm;
using test::noisyCurve;
using test::number;
using test::randomKnots;
using test::splineOf;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Identities (1) and (2).
TEST(FairCurve, MovesWithinTheToleranceAndIsFairer) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 40; ++i) {
    const int degree = 2 + static_cast<int>(random() % 5);
    const bool planar = i % 2 == 0;
    const BSplineCurve curve =
        noisyCurve(degree, degree + 4 + static_cast<int>(random() % 30), planar, 0.02, random);
    const auto ends = static_cast<HeldEnds>(i % 4);
    const double tolerance = 0.03;
    const FairedCurve found = fairCurve(curve, tolerance, {.ends = ends});
    EXPECT_LE(found.moved_mm, tolerance);
    EXPECT_LE(largestDistance_mm(curve, found.curve), found.moved_mm * (1 + 1e-9));
    EXPECT_LT(found.after.energy, found.before.energy);
    EXPECT_EQ(found.curve.knots, curve.knots);
    const int held = i % 4;
    EXPECT_EQ(found.curve.poles.topRows(held), curve.poles.topRows(held));
    EXPECT_EQ(found.curve.poles.bottomRows(held), curve.poles.bottomRows(held));
    EXPECT_EQ(fairCurve(curve, 0, {.ends = ends}).curve, curve);
  }
}

TEST(FairCurve, LosesTheWavesOfItsNoise) {
  std::mt19937_64 random(testSeed());
  for (const bool planar : {true, false}) {
    const BSplineCurve curve = noisyCurve(4, 60, planar, 0.002, random);
    const FairedCurve found = fairCurve(curve, 0.01, {.ends = HeldEnds::Position});
    EXPECT_GT(found.before.extrema, 20);
    EXPECT_LT(found.after.extrema, 8);
    EXPECT_LT(found.after.energy, 0.1 * found.before.energy);
  }
}

/// Knots whose distances differ up to 8000 times make the rounding of the gradient large.
std::vector<double> unevenKnots(int degree, int count, std::mt19937_64& random) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  double at = 0;
  for (int i = 0; i < count - degree; ++i) {
    at += std::exp(uniform(random, -9, 0));
    const int times = i + 1 == count - degree ? degree + 1 : 1;
    knots.insert(knots.end(), static_cast<std::size_t>(times), at);
  }
  return knots;
}

// The steps end before the most that are taken, so (5) and (9) hold.
TEST(FairCurve, EndsOverUnevenKnots) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const int degree = 2 + i % 5, count = degree + 4 + static_cast<int>(random() % 70);
    BSplineCurve curve = noisyCurve(degree, count, i % 2 == 0, 0, random);
    const double noise_mm = std::exp(uniform(random, -8, -1));
    for (Eigen::Index k = 0; k < count; ++k)
      for (int c = 0; c < (i % 2 == 0 ? 2 : 3); ++c)
        curve.poles(k, c) += uniform(random, -noise_mm, noise_mm);
    curve.knots = unevenKnots(degree, count, random);
    const double tolerance_mm = noise_mm * std::exp(uniform(random, 0, 3));
    const FairedCurve found =
        fairCurve(curve, tolerance_mm, {.ends = static_cast<HeldEnds>(random() % 4)});
    EXPECT_LT(found.steps, 60) << i;
    EXPECT_LE(found.moved_mm, tolerance_mm);
  }
}

// Beside a large smoothing the equations of a curve of one span are singular.
TEST(FairCurve, OfOneSpanIsFairer) {
  Poles poles(4, 3);
  poles << 0, 0, 0, 1, 2, 0, 2, -2, 0, 3, 0, 1;
  const BSplineCurve curve = splineOf(3, {0, 0, 0, 0, 1, 1, 1, 1}, poles);
  for (const double tolerance : {1e-3, 0.1}) {
    const FairedCurve found = fairCurve(curve, tolerance);
    EXPECT_LE(largestDistance_mm(curve, found.curve), found.moved_mm * (1 + 1e-9));
    EXPECT_LE(found.moved_mm, tolerance);
    EXPECT_GT(found.moved_mm, 0.9 * tolerance);
    EXPECT_LT(found.after.energy, found.before.energy);
  }
}

// Identity (3).
TEST(FairCurve, AParabolaStays) {
  std::mt19937_64 random(testSeed());
  for (const int degree : {3, 4, 5}) {
    const std::vector<double> knots = randomKnots(degree, 12, random);
    // Interpolates the parabola: the smoothing spline of exact data is the data.
    std::vector<double> parameters;
    Poles points(60, 3);
    for (int k = 0; k < 60; ++k) {
      const double t = knots.back() * k / 59;
      parameters.push_back(t);
      points.row(k) << t, 0.3 * t * t - t, 2 - t * t;
    }
    const BSplineCurve curve = smoothingSpline(degree, knots, parameters, points, 1e-3);
    for (int k = 0; k < 60; ++k)
      EXPECT_LT((derivatives(curve, parameters[k], 0) - points.row(k)).norm(), 1e-8);
    EXPECT_LT(largestDistance_mm(fairCurve(curve, 0.1).curve, curve), 1e-6);
  }
}

// Identity (4).
TEST(FairCurve, FollowsMotionAndScale) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 10; ++i) {
    const BSplineCurve curve = noisyCurve(3, 20, false, 0.05, random);
    const double scale = std::exp2(static_cast<int>(random() % 9) - 4);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(uniform(random, -3, 3), Eigen::Vector3d(1, 2, 3).normalized())
            .toRotationMatrix();
    BSplineCurve other = curve;
    other.poles.leftCols<3>() = scale * curve.poles.leftCols<3>() * turn;
    other.poles.leftCols<3>().rowwise() += Eigen::RowVector3d(1, -2, 0.5);
    BSplineCurve wanted = fairCurve(curve, 0.04).curve;
    wanted.poles.leftCols<3>() = scale * wanted.poles.leftCols<3>() * turn;
    wanted.poles.leftCols<3>().rowwise() += Eigen::RowVector3d(1, -2, 0.5);
    EXPECT_LT(largestDistance_mm(fairCurve(other, 0.04 * scale).curve, wanted), 0.001 * scale);
  }
}

// Identity (5).
TEST(FairCurve, ALargerToleranceGivesASmallerEnergy) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 10; ++i) {
    const BSplineCurve curve = noisyCurve(3 + i % 3, 25, i % 2 == 0, 0.05, random);
    double energy = INFINITY;
    for (const double tolerance : {0.001, 0.01, 0.1, 1.0, 100.0}) {
      const FairedCurve found = fairCurve(curve, tolerance);
      EXPECT_LT(found.after.energy, energy * (1 + 1e-9));
      energy = found.after.energy;
      if (tolerance > 0.05) continue;
      EXPECT_GT(found.moved_mm, 0.98 * tolerance);
    }
  }
}

/// The poles whose noise is within the bounds have at least the least energy.
TEST(FairCurve, HasAtMostTheEnergyOfTheCurveWithoutNoise) {
  std::mt19937_64 random(testSeed());
  for (const bool planar : {true, false}) {
    for (const int degree : {2, 3, 5}) {
      const double noise_mm = 0.01;
      const BSplineCurve smooth = noisyCurve(degree, 600, planar, 0, random);
      BSplineCurve noisy = smooth;
      for (Eigen::Index i = 1; i + 1 < noisy.poles.rows(); ++i)
        for (int k = 0; k < (planar ? 2 : 3); ++k)
          noisy.poles(i, k) += uniform(random, -noise_mm, noise_mm);
      const FairedCurve found = fairCurve(noisy, std::sqrt(3) * noise_mm);
      EXPECT_LE(found.after.energy, fairnessOf(smooth).energy * (1 + 1e-4));
      EXPECT_GT(found.smoothing, 0);
    }
  }
}

// Identity (6), and the knots of the given cases.
TEST(SmoothingSpline, AgreesWithHighPrecision) {
  int cases = 0;
  for (const nlohmann::json& entry : test::splineCases("spline_fairing.json")) {
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    if (in["kind"] != "energy") continue;
    SCOPED_TRACE(entry["name"].get<std::string>());
    ++cases;
    std::vector<double> knots, parameters;
    for (const nlohmann::json& knot : in["knots"]) knots.push_back(number(knot));
    for (const nlohmann::json& t : in["t"]) parameters.push_back(number(t));
    const PlanarPoints planar = test::planarPoints(in["Q"]);
    Poles points = Poles::Zero(planar.rows(), 3);
    points.leftCols<2>() = planar;
    const BSplineCurve found = smoothingSpline(3, knots, parameters, points, number(in["lambda"]),
                                               in["fix_ends"].get<bool>());
    const PlanarPoints wanted = test::planarPoints(out["d"]);
    EXPECT_LT((found.poles.leftCols<2>() - wanted).cwiseAbs().maxCoeff(), 1e-10);
  }
  EXPECT_GT(cases, 4);
}

// Identity (7).
TEST(FairedAtKnot, AgreesWithHighPrecision) {
  int cases = 0;
  for (const nlohmann::json& entry : test::splineCases("spline_fairing.json")) {
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    if (in["kind"] != "knot") continue;
    SCOPED_TRACE(entry["name"].get<std::string>());
    ++cases;
    std::vector<double> knots;
    for (const nlohmann::json& knot : in["knots"]) knots.push_back(number(knot));
    const PlanarPoints planar = test::planarPoints(in["d"]);
    Poles poles = Poles::Zero(planar.rows(), 3);
    poles.leftCols<2>() = planar;
    const BSplineCurve curve = splineOf(3, knots, poles);
    const int j = in["j"].get<int>();
    BSplineCurve wanted = curve;
    wanted.poles.row(j - 2).head<2>() = test::planarVector(out["d_hat"]).transpose();
    EXPECT_LT((fairedAtKnot(curve, j).poles - wanted.poles).norm(), 1e-12);
    wanted.poles.row(j - 2).head<2>() = test::planarVector(out["d_limited"]).transpose();
    EXPECT_LT((fairedAtKnot(curve, j, number(in["delta"])).poles - wanted.poles).norm(), 1e-12);
  }
  EXPECT_GT(cases, 4);
}

TEST(FairedAtKnot, TheThirdDerivativeIsContinuousAndOtherPolesStay) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const BSplineCurve curve = noisyCurve(3, 15, i % 2 == 0, 0.3, random);
    const int j = 4 + static_cast<int>(random() % 11);
    const BSplineCurve found = fairedAtKnot(curve, j);
    const double t = curve.knots[j], h = 1e-3;
    const Eigen::RowVector3d right = derivatives(found, t + h, 3).row(3);
    const Eigen::RowVector3d left = derivatives(found, t - h, 3).row(3);
    EXPECT_LT((right - left).norm(), 1e-9 * (1 + right.norm()));
    for (int k = 0; k < 15; ++k) EXPECT_EQ(found.poles.row(k) == curve.poles.row(k), k != j - 2);
  }
}

// Identity (8).
TEST(FairKnots, JumpsFallWithinTheTolerance) {
  std::mt19937_64 random(testSeed());
  const auto jumps = [](const BSplineCurve& curve) {
    double sum = 0;
    for (int j = 4; j < curve.count(); ++j) {
      const double t = curve.knots[j], h = 1e-6;
      const CurveDerivatives right = derivatives(curve, t + h, 3),
                             left = derivatives(curve, t - h, 3);
      sum += (right.row(3) - left.row(3)).norm() / std::pow(right.row(1).norm(), 3);
    }
    return sum;
  };
  for (int i = 0; i < 20; ++i) {
    const BSplineCurve curve = noisyCurve(3, 40, i % 2 == 0, 0.02, random);
    const auto ends = static_cast<HeldEnds>(i % 4);
    const FairedCurve found = fairKnots(curve, 0.03, {.ends = ends});
    EXPECT_LE(found.moved_mm, 0.03);
    EXPECT_LE(largestDistance_mm(curve, found.curve), 0.03);
    EXPECT_LT(jumps(found.curve), 0.7 * jumps(curve));
    EXPECT_EQ(found.curve.poles.topRows(i % 4), curve.poles.topRows(i % 4));
    EXPECT_EQ(fairKnots(curve, 0).curve, curve);
  }
}

TEST(FairCurve, RefusesWhatItCantFair) {
  std::mt19937_64 random(testSeed());
  const BSplineCurve curve = noisyCurve(3, 8, true, 0.1, random);
  const auto refused = [](const auto& call, const char* text) {
    EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  for (const double bad : {-1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    refused([&] { fairCurve(curve, bad); }, "the tolerance is");
    refused([&] { fairKnots(curve, bad); }, "the tolerance is");
  }
  BSplineCurve rational = curve;
  rational.poles.row(2) *= 2;
  refused([&] { fairCurve(rational, 0.1); }, "a rational curve");
  BSplineCurve line = splineOf(1, {0, 0, 1, 1}, Poles::Random(2, 3));
  refused([&] { fairCurve(line, 0.1); }, "degree 1");
  refused([&] { fairKnots(noisyCurve(4, 9, true, 0.1, random), 0.1); }, "degree 4");
  refused([&] { fairedAtKnot(curve, 3); }, "knot 3 is not a simple knot");
  refused([&] { smoothingSpline(3, curve.knots, {0, 99}, Poles::Zero(2, 3), 1); }, "parameter 1");
  refused([&] { smoothingSpline(3, curve.knots, {0, 1}, Poles::Zero(2, 3), 0); }, "smoothing is 0");
  EXPECT_THAT(
      [&] {
        smoothingSpline(3, curve.knots, {0, 1}, Poles::Zero(2, 3), 1);
      },
      ThrowsMessage<std::domain_error>(HasSubstr("singular")));
}

}  // namespace
}  // namespace seamwright
