// SPDX-License-Identifier: LGPL-2.1-or-later
#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::angleBetween;
using test::number;
using test::uniform;

/// A polygon that turns by less than 1 rad at each point.
PlanarPoints randomWalk(Eigen::Index count, std::mt19937_64& random) {
  PlanarPoints points(count, 2);
  Eigen::RowVector2d at(uniform(random, -5, 5), uniform(random, -5, 5));
  double direction = uniform(random, -3, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    points.row(i) = at;
    direction += uniform(random, -0.9, 0.9);
    at += uniform(random, 0.5, 2) * Eigen::RowVector2d(std::cos(direction), std::sin(direction));
  }
  return points;
}

/// Points around (0, 0). \param spread of the distances and of the angles between them.
PlanarPoints randomRing(Eigen::Index count, std::mt19937_64& random, double spread = 0.2) {
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double angle = 2 * pi * (static_cast<double>(i) + uniform(random, -spread, spread)) /
                         static_cast<double>(count);
    points.row(i) = 5 * (1 + uniform(random, -spread, spread)) *
                    Eigen::RowVector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

/// What a rule minimises, from directions at the points.
double objective(const PlanarPoints& points, const TangentOptions& options,
                 const std::vector<double>& directions) {
  double sum = 0;
  const Eigen::Index segments = points.rows() - (options.closed ? 0 : 1);
  for (Eigen::Index s = 0; s < segments; ++s) {
    const Eigen::Index next = (s + 1) % points.rows();
    const HermiteEnds ends{.start = points.row(s).transpose(),
                           .start_direction_rad = directions[s],
                           .end = points.row(next).transpose(),
                           .end_direction_rad = directions[next]};
    const ChordAngles angles = chordAngles(ends);
    const double a = angles.alpha_rad, b = angles.beta_rad, l = angles.chord_mm;
    switch (options.rule) {
      case TangentRule::NearCircles:
        sum += (a - b) * (a - b);
        break;
      case TangentRule::LinearEnergy:
        sum += (a * a + b * b) / l + options.lambda * (a - b) * (a - b) / l;
        break;
      case TangentRule::Energy: {
        const Biarc arcs = biarc(ends, 0.5);
        sum += bendingEnergy_per_mm({arcs.first, arcs.second});
        break;
      }
    }
  }
  return sum;
}

/// Whether no free direction can be changed for the better.
void expectLeast(const PlanarPoints& points, const TangentOptions& options) {
  const std::vector<double> found = tangentsAt(points, options).directions_rad;
  const double least = objective(points, options, found);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i == 0 && (options.start_direction_rad || options.rule == TangentRule::NearCircles) &&
        !options.closed)
      continue;
    if (i + 1 == found.size() && !options.closed &&
        (options.end_direction_rad || options.rule == TangentRule::NearCircles))
      continue;
    constexpr double h = 1e-4;
    std::vector<double> changed = found;
    changed[i] = found[i] + h;
    const double above = objective(points, options, changed);
    changed[i] = found[i] - h;
    const double below = objective(points, options, changed);
    EXPECT_GE(above, least * (1 - 1e-12)) << "point " << i;
    EXPECT_GE(below, least * (1 - 1e-12)) << "point " << i;
    EXPECT_LT(std::abs(above - below) / (2 * h), 1e-6 * (1 + least)) << "point " << i;
  }
}

// Identity (1).
TEST(BiarcSpline, TangentsMinimiseWhatTheRuleNames) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const Eigen::Index count = 2 + static_cast<Eigen::Index>(random() % 9);
    for (const TangentRule rule :
         {TangentRule::NearCircles, TangentRule::LinearEnergy, TangentRule::Energy}) {
      TangentOptions options{.rule = rule, .lambda = uniform(random, 0, 3)};
      const PlanarPoints points = randomWalk(count, random);
      if (rule != TangentRule::NearCircles) expectLeast(points, options);
      const auto along = [&](Eigen::Index a, Eigen::Index b) {
        return std::atan2(points(b, 1) - points(a, 1), points(b, 0) - points(a, 0));
      };
      options.start_direction_rad = along(0, 1) + uniform(random, -0.4, 0.4);
      options.end_direction_rad = along(count - 2, count - 1) + uniform(random, -0.4, 0.4);
      if (rule == TangentRule::NearCircles) continue;  // errors of the ends do not decay
      expectLeast(points, options);
    }
  }
}

TEST(BiarcSpline, TangentsOfRingsMinimiseWhatTheRuleNames) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const Eigen::Index count = 3 + 2 * static_cast<Eigen::Index>(random() % 5);
    const PlanarPoints points = randomRing(count, random);
    for (const TangentRule rule : {TangentRule::LinearEnergy, TangentRule::Energy})
      expectLeast(points, {.rule = rule, .closed = true});
    expectLeast(randomRing(count, random, 0.02),
                {.rule = TangentRule::NearCircles, .closed = true});
  }
}

TEST(BiarcSpline, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("biarc_splines.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const PlanarPoints points = test::planarPoints(in["P"]);
    TangentOptions options{.closed = in["closed"].get<bool>()};
    if (in["algorithm"] == "tridiag")
      options.rule = TangentRule::NearCircles;
    else
      options.lambda = number(in["lambda"]);
    if (!options.closed) {
      options.start_direction_rad = number(in["theta0"]);
      options.end_direction_rad = number(in["thetan"]);
    }
    const BiarcSpline found = biarcSpline(points, options);
    for (std::size_t i = 0; i < out["theta"].size(); ++i)
      EXPECT_LT(angleBetween(found.directions_rad[i], number(out["theta"][i])), 1e-13);
    ASSERT_EQ(found.arcs.size(), 2 * out["biarcs"].size());
    for (std::size_t s = 0; s < out["biarcs"].size(); ++s) {
      const nlohmann::json& expected = out["biarcs"][s];
      EXPECT_LT((found.arcs[2 * s + 1].start - test::planarVector(expected["joint"])).norm(),
                1e-12);
      EXPECT_NEAR(found.arcs[2 * s].curvature_per_mm, number(expected["k1"]), 1e-12);
      EXPECT_NEAR(found.arcs[2 * s + 1].curvature_per_mm, number(expected["k2"]), 1e-12);
    }
  }
}

// Identity (2).
TEST(BiarcSpline, PointsOnACircleGetItsTangents) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const Eigen::Index count = 5 + static_cast<Eigen::Index>(random() % 6);
    const double radius = uniform(random, 0.5, 9);
    PlanarPoints even(count, 2), uneven(count, 2);
    double angle = uniform(random, 0, 6);
    for (Eigen::Index k = 0; k < count; ++k) {
      const double regular = 2 * pi * static_cast<double>(k) / static_cast<double>(count);
      even.row(k) = radius * Eigen::RowVector2d(std::cos(regular), std::sin(regular));
      uneven.row(k) = radius * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
      angle += uniform(random, 0.1, 0.5);
    }
    const auto expectTangents = [](const PlanarPoints& points, const TangentOptions& options) {
      const std::vector<double> found = tangentsAt(points, options).directions_rad;
      for (Eigen::Index k = 0; k < points.rows(); ++k)
        EXPECT_LT(angleBetween(found[k], std::atan2(points(k, 0), -points(k, 1))), 1e-12);
    };
    for (const TangentRule rule : {TangentRule::LinearEnergy, TangentRule::Energy})
      expectTangents(even, {.rule = rule, .closed = true});
    expectTangents(uneven, {.rule = TangentRule::NearCircles,
                            .start_direction_rad = std::atan2(uneven(0, 0), -uneven(0, 1))});
    expectTangents(uneven, {.rule = TangentRule::NearCircles});
  }
}

// Identity (3).
TEST(BiarcSpline, ReversedAndMovedPointsGiveReversedAndMovedTangents) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const PlanarPoints points = randomWalk(8, random);
    for (const TangentRule rule : {TangentRule::LinearEnergy, TangentRule::Energy}) {
      const std::vector<double> found = tangentsAt(points, {.rule = rule}).directions_rad;
      const PlanarPoints back = points.colwise().reverse();
      const std::vector<double> reversed = tangentsAt(back, {.rule = rule}).directions_rad;
      const double turn = uniform(random, -3, 3), scale = uniform(random, 0.01, 100);
      Eigen::Matrix2d rotation;
      rotation << std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn);
      PlanarPoints moved = scale * points * rotation.transpose();
      moved.rowwise() += Eigen::RowVector2d(3, -4);
      const std::vector<double> of_moved = tangentsAt(moved, {.rule = rule}).directions_rad;
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_LT(angleBetween(reversed[found.size() - 1 - k], found[k] + pi), 1e-11);
        EXPECT_LT(angleBetween(of_moved[k], found[k] + turn), 1e-11);
      }
    }
  }
}

TEST(BiarcSpline, EnergyIsBelowTheLinearOne) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 50; ++i) {
    const PlanarPoints points = randomWalk(9, random);
    const double linear = biarcSpline(points).energy_per_mm;
    const double least = biarcSpline(points, {.rule = TangentRule::Energy}).energy_per_mm;
    EXPECT_LE(least, linear * (1 + 1e-14));
  }
}

TEST(BiarcSpline, BezierFormRunsThroughThePointsWithoutGaps) {
  std::mt19937_64 random(testSeed());
  for (const bool closed : {false, true}) {
    const PlanarPoints points = closed ? randomRing(7, random) : randomWalk(7, random);
    const BiarcSpline arcs = biarcSpline(points, {.closed = closed});
    const BezierSpline curve = bezierSpline(arcs.arcs, closed, 1e-10);
    requireValid(curve);
    const CurveDerivatives start = derivatives(curve, 0, 1);
    EXPECT_EQ(start.row(0).head<2>(), points.row(0));
    EXPECT_GE(measureJoints(curve, 1).size(), arcs.arcs.size() - 1);
    for (const CurveJoint& joint : measureJoints(curve, 1)) EXPECT_EQ(orderReached(joint, {}), 1);
  }
}

TEST(BiarcSpline, InvalidInputIsNamed) {
  const PlanarPoints one = PlanarPoints::Zero(1, 2);
  PlanarPoints points(4, 2);
  points << 0, 0, 1, 0, 2, 1, 3, 1;
  EXPECT_THROW(tangentsAt(one), std::invalid_argument);
  EXPECT_THROW(tangentsAt(points, {.lambda = -1}), std::invalid_argument);
  EXPECT_THROW(tangentsAt(points, {.closed = true, .start_direction_rad = 0.0}),
               std::invalid_argument);
  EXPECT_THROW(tangentsAt(points, {.start_direction_rad = 3.0}), std::domain_error);
  PlanarPoints twice = points;
  twice.row(2) = twice.row(1);
  EXPECT_THROW(tangentsAt(twice), std::invalid_argument);
  twice.row(2) = twice.row(0);
  EXPECT_THROW(tangentsAt(twice), std::domain_error);
  twice(2, 0) = std::nan("");
  EXPECT_THROW(tangentsAt(twice), std::invalid_argument);
  PlanarPoints square(4, 2);
  square << 0, 0, 1, 0, 1, 1, 0, 1;
  EXPECT_THROW(tangentsAt(square, {.rule = TangentRule::NearCircles, .closed = true}),
               std::domain_error);
}

}  // namespace
}  // namespace seamwright
