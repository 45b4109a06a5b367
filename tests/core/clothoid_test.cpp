// SPDX-License-Identifier: LGPL-2.1-or-later
#include <iomanip>

#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/planar/clothoid_phase.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::angleBetween;
using test::endsWith;
using test::number;
using test::planarVector;
using test::uniform;

/// Ends whose tangents do not both point against the chord.
HermiteEnds randomShortEnds(std::mt19937_64& random) {
  while (true) {
    const HermiteEnds ends = test::randomEnds(random);
    const ChordAngles angles = chordAngles(ends);
    if (std::abs(angles.alpha_rad + angles.beta_rad) < 5.5) return ends;
  }
}

TEST(Clothoid, PointIsTheIntegralOfTheDirection) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const Clothoid curve{.start = Eigen::Vector2d(uniform(random, -5, 5), uniform(random, -5, 5)),
                         .direction_rad = uniform(random, -4, 4),
                         .curvature_per_mm = uniform(random, -2, 2),
                         .curvature_slope_per_mm2 = uniform(random, -2, 2),
                         .length_mm = uniform(random, 0.1, 5)};
    const double s = uniform(random, 0, curve.length_mm);
    const auto direction = [&](double u) {
      return curve.direction_rad + curve.curvature_per_mm * u +
             curve.curvature_slope_per_mm2 * u * u / 2;
    };
    EXPECT_LT((curve.point(s) - test::integrated(curve.start, direction, s)).norm(), 1e-13);
  }
}

TEST(Clothoid, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("clothoids.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const Clothoid found = clothoid({.start = planarVector(in["P0"]),
                                     .start_direction_rad = number(in["theta0"]),
                                     .end = planarVector(in["P1"]),
                                     .end_direction_rad = number(in["theta1"])});
    const double length = number(out["L"]);
    EXPECT_NEAR(found.length_mm, length, 1e-14 * length * length);
    EXPECT_NEAR(found.curvature_per_mm, number(out["k0"]), 1e-13);
    EXPECT_NEAR(found.curvatureAt_per_mm(found.length_mm), number(out["k1"]), 1e-13);
    EXPECT_NEAR(found.curvature_slope_per_mm2, number(out["gamma"]), 1e-13);
    EXPECT_LT((found.point(found.length_mm / 2) - planarVector(out["mid"])).norm(),
              1e-14 * (1 + length * length));
    const SplineWithin spline = bezierSpline({found}, number(in["tol"]), false, 1e-9);
    EXPECT_EQ(spline.curve.segments(), out["pieces"].get<int>());
    EXPECT_NEAR(spline.distance_mm, number(out["bound"]), 1e-9 * number(out["bound"]));
  }
}

/// PhaseEnd with 80 bits.
struct LongEnd {
  long double height = 0, height_slope = 0, width = 0;
};

LongEnd longEnd(const Phase& phase, long double a) {
  // Boole's rule; the phase turns by at most 0.1 rad on a panel, so the error is below 1e-17.
  constexpr int panels = 400;
  constexpr std::array<int, 5> weights = {7, 32, 12, 32, 7};
  LongEnd sum;
  for (int i = 0; i < panels; ++i)
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const long double t = (i + static_cast<long double>(k) / 4) / panels;
      const long double weight = weights[k] / (90.0L * panels);
      const long double at = (a * t + phase.change - a) * t + phase.start;
      sum.height += weight * std::sin(at);
      sum.height_slope += weight * (t * t - t) * std::cos(at);
      sum.width += weight * std::cos(at);
    }
  return sum;
}

// docs/theory/planar.md P4.2: over the whole square of angles, with its borders, its diagonals and
// small angles.
TEST(Clothoid, FindsTheLeastRootInFewSteps) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 2000; ++i) {
    const double size = i % 4 == 1 ? std::pow(10, uniform(random, -17, 0)) : 1;
    const double start = size * uniform(random, -pi, pi);
    double end = size * uniform(random, -pi, pi);
    if (i % 4 == 2) end = std::clamp(start + 1e-9 * end, -pi, pi);
    if (i % 4 == 3) end = std::clamp(-start + 1e-9 * end, -pi, pi);
    const Phase phase{.start = start, .change = end - start};
    if (std::abs(phase.change) > 6.2) continue;
    SCOPED_TRACE(testing::Message() << std::setprecision(17) << start << " and " << end);
    const PhaseRoot found = rootOf(phase);
    EXPECT_LE(found.steps, 4);
    long double exact = found.a;
    LongEnd there = longEnd(phase, exact);
    for (int step = 0; step < 2; ++step) {
      exact -= there.height / there.height_slope;
      there = longEnd(phase, exact);
    }
    const auto apart = static_cast<double>(std::abs(exact - found.a));
    EXPECT_LE(apart, 1e-14 * (std::abs(start) + std::abs(end)));
    EXPECT_NEAR(found.width, static_cast<double>(there.width), 2e-15);
    EXPECT_GT(found.width, 0);
    // Another root nearer to 0 has its end behind its start.
    const auto at = [&](int k) { return phase.end(0.999 * found.a * k / 100); };
    for (int k = -99; k <= 100; ++k)
      if (at(k - 1).height * at(k).height < 0) {
        ASSERT_LT(at(k).width, 0) << k;
      }
  }
}

// Identity (1).
TEST(Clothoid, MeetsBothEnds) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 1000; ++i) {
    HermiteEnds ends = randomShortEnds(random);
    if (i % 10 == 0) ends.end_direction_rad = ends.start_direction_rad;
    const Clothoid found = clothoid(ends);
    const double chord = (ends.end - ends.start).norm();
    const double size = found.length_mm * found.length_mm / chord;
    EXPECT_LT((found.end() - ends.end).norm(), 8e-15 * (size + 10));
    EXPECT_LT(angleBetween(found.directionAt_rad(found.length_mm), ends.end_direction_rad), 1e-13);
  }
}

// Identity (2).
TEST(Clothoid, EndsOnACircleGiveItsArc) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const double half = i == 0 ? 0 : uniform(random, -2.5, 2.5), chord = uniform(random, 0.1, 9);
    const Clothoid found = clothoid(endsWith(half, half, chord));
    EXPECT_NEAR(found.curvature_per_mm, 2 * std::sin(half) / chord, 1e-13 / chord);
    EXPECT_NEAR(found.curvature_slope_per_mm2, 0, 1e-13 / (chord * chord));
    EXPECT_NEAR(found.length_mm, chord * (half == 0 ? 1 : half / std::sin(half)), 1e-12 * chord);
  }
}

// Identity (3).
TEST(Clothoid, ReversedMirroredAndScaledEndsChangeItAlong) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const HermiteEnds ends = randomShortEnds(random);
    const Clothoid found = clothoid(ends);
    const Clothoid back = clothoid({.start = ends.end,
                                    .start_direction_rad = ends.end_direction_rad + pi,
                                    .end = ends.start,
                                    .end_direction_rad = ends.start_direction_rad + pi});
    const Clothoid turned = reversed(found);
    const double unit = 1e-12 * (1 + std::abs(found.curvature_per_mm));
    EXPECT_NEAR(back.curvature_per_mm, turned.curvature_per_mm, unit);
    EXPECT_NEAR(back.curvature_slope_per_mm2, found.curvature_slope_per_mm2, unit);
    const auto mirror = [](const Eigen::Vector2d& p) { return Eigen::Vector2d(p.x(), -p.y()); };
    const Clothoid mirrored = clothoid({.start = mirror(ends.start),
                                        .start_direction_rad = -ends.start_direction_rad,
                                        .end = mirror(ends.end),
                                        .end_direction_rad = -ends.end_direction_rad});
    EXPECT_NEAR(mirrored.curvature_per_mm, -found.curvature_per_mm, unit);
    const double scale = uniform(random, 0.01, 100);
    const Clothoid scaled = clothoid({.start = scale * ends.start,
                                      .start_direction_rad = ends.start_direction_rad,
                                      .end = scale * ends.end,
                                      .end_direction_rad = ends.end_direction_rad});
    EXPECT_NEAR(scaled.length_mm, scale * found.length_mm, 1e-12 * scale * found.length_mm);
    EXPECT_NEAR(scale * scaled.curvature_per_mm, found.curvature_per_mm, unit);
  }
}

// Identity (4).
TEST(Clothoid, AnglesAgainstTheChordShowHowTheCurvatureChanges) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const ChordAngles angles = chordAngles(randomShortEnds(random));
    const Clothoid found = clothoid(endsWith(angles.alpha_rad, angles.beta_rad));
    const double sum = angles.beta_rad - angles.alpha_rad;
    if (std::abs(sum) < 1e-9) continue;
    EXPECT_GT(sum * found.curvature_slope_per_mm2, 0);
  }
}

// Identity (5): dense evaluation of both curves.
TEST(Clothoid, SplineKeepsItsDistance) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const Clothoid found = clothoid(randomShortEnds(random));
    const double tolerance = std::pow(10, uniform(random, -9, -1));
    const SplineWithin spline = bezierSpline({found}, tolerance, false, 1e-9);
    EXPECT_LE(spline.distance_mm, tolerance);
    const double rounding = 1e-13 * (10 + found.length_mm * found.length_mm);
    double largest = 0;
    for (int k = 0; k <= 300; ++k) {
      const double s = found.length_mm * k / 300;
      const Eigen::Vector2d on_spline =
          derivatives(spline.curve, s, 0).row(0).head<2>().transpose();
      largest = std::max(largest, (on_spline - found.point(s)).norm());
    }
    EXPECT_LE(largest, spline.distance_mm + rounding);
    for (const CurveJoint& joint : measureJoints(spline.curve, 2))
      EXPECT_EQ(orderReached(joint, {}), 2);
  }
}

TEST(Clothoid, InvalidInputIsNamed) {
  EXPECT_THROW(clothoid(endsWith(0.1, 0.2, 0)), std::invalid_argument);
  EXPECT_THROW(clothoid(endsWith(std::nan(""), 0.2)), std::invalid_argument);
  EXPECT_THROW(clothoid(endsWith(pi, pi)), std::domain_error);
  const Clothoid found = clothoid(endsWith(0.3, 0.2));
  EXPECT_THROW(bezierSpline({found}, 0, false, 0), std::invalid_argument);
  EXPECT_THROW(bezierSpline({found}, std::nan(""), false, 0), std::invalid_argument);
  EXPECT_THROW(bezierSpline(std::vector<Clothoid>{}, 1, false, 0), std::invalid_argument);
  EXPECT_THROW(bezierSpline({found}, 1e-60, false, 0), std::domain_error);
}

}  // namespace
}  // namespace seamwright
