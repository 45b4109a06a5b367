// SPDX-License-Identifier: LGPL-2.1-or-later
#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::angleBetween;
using test::endsWith;
using test::number;
using test::planarVector;
using test::uniform;
using ::testing::HasSubstr;

constexpr int cases = 500;

PlanarArc randomArc(std::mt19937_64& random) {
  return {.start = Eigen::Vector2d(uniform(random, -9, 9), uniform(random, -9, 9)),
          .direction_rad = uniform(random, -4, 4),
          .curvature_per_mm = random() % 4 == 0 ? 0 : uniform(random, -1, 1),
          .length_mm = uniform(random, 0.1, 6)};
}

// The closed form of a point against quadrature of the direction.
TEST(PlanarArc, PointIsTheIntegralOfTheDirection) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const PlanarArc arc = randomArc(random);
    const double s = uniform(random, 0, arc.length_mm);
    const auto direction = [&](double u) { return arc.directionAt_rad(u); };
    EXPECT_LT((arc.point(s) - test::integrated(arc.start, direction, s)).norm(), 1e-12);
  }
}

// Identity (1).
TEST(PlanarArc, ThroughTwoPointsEndsAtTheSecond) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const HermiteEnds ends = test::randomEnds(random);
    const PlanarArc arc = arcThrough(ends.start, ends.start_direction_rad, ends.end);
    EXPECT_LT((arc.end() - ends.end).norm(), 1e-12 * std::max(1.0, arc.length_mm));
    EXPECT_LE(std::abs(arc.sweep_rad()), 2 * pi + 1e-12);
    EXPECT_GT(arc.length_mm, 0);
  }
}

TEST(PlanarArc, ReversedRunsThroughTheSamePoints) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const PlanarArc arc = randomArc(random), back = reversed(arc);
    const double s = uniform(random, 0, arc.length_mm);
    EXPECT_LT((back.point(arc.length_mm - s) - arc.point(s)).norm(), 1e-13 * 30);
  }
}

// Identity (2).
TEST(PlanarArc, OffsetMovesEachPointAlongItsNormal) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const PlanarArc arc = randomArc(random);
    const double distance = uniform(random, -0.9, 0.9), share = uniform(random, 0, 1);
    const PlanarArc parallel = offset(arc, distance);
    const double s = share * arc.length_mm;
    const double normal = arc.direction_rad + arc.curvature_per_mm * s + pi / 2;
    const Eigen::Vector2d expected =
        arc.point(s) + distance * Eigen::Vector2d(std::cos(normal), std::sin(normal));
    EXPECT_LT((parallel.point(share * parallel.length_mm) - expected).norm(), 1e-13 * 40);
  }
}

TEST(PlanarArc, OffsetBeyondTheCentreIsRefused) {
  const PlanarArc arc = {.curvature_per_mm = 0.5, .length_mm = 1};
  EXPECT_THROW(offset(arc, 2), std::domain_error);
  EXPECT_NO_THROW(offset(arc, 1.99));
  EXPECT_NO_THROW(offset(arc, -100));
}

// Identity (3), and the count of curves.
TEST(PlanarArc, CurvesLieOnTheCircle) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const PlanarArc arc = randomArc(random);
    const std::vector<BezierCurve> curves = bezierCurves(arc);
    EXPECT_EQ(curves.size(), std::max(1.0, std::ceil(std::abs(arc.sweep_rad()) / (2 * pi / 3))));
    EXPECT_EQ(curves.front().point(0), Eigen::Vector3d(arc.start.x(), arc.start.y(), 0));
    for (std::size_t k = 0; k + 1 < curves.size(); ++k)
      EXPECT_EQ(curves[k].point(1), curves[k + 1].point(0));
    if (arc.curvature_per_mm == 0) continue;
    const double radius = 1 / arc.curvature_per_mm;
    const double normal = arc.direction_rad + pi / 2;
    const Eigen::Vector2d centre =
        arc.start + radius * Eigen::Vector2d(std::cos(normal), std::sin(normal));
    for (const BezierCurve& curve : curves)
      for (const double t : {0.0, 0.21, 0.5, 0.93, 1.0})
        EXPECT_NEAR((curve.point(t).head<2>() - centre).norm(), std::abs(radius),
                    1e-13 * (std::abs(radius) + 20));
  }
}

TEST(PlanarArc, InvalidInputIsNamed) {
  const Eigen::Vector2d p(1, 2), q(3, 4);
  EXPECT_THROW(arcThrough(p, 0, p), std::invalid_argument);
  EXPECT_THROW(arcThrough(p, std::nan(""), q), std::invalid_argument);
  EXPECT_THROW(arcThrough(p, 0, Eigen::Vector2d(INFINITY, 0)), std::invalid_argument);
}

void expectJoins(const HermiteEnds& ends, const Biarc& found) {
  // Long arcs multiply the rounding of their directions.
  const double size = 10 + found.first.length_mm + found.second.length_mm;
  EXPECT_EQ(found.first.start, ends.start);
  EXPECT_LT((found.first.end() - found.joint()).norm(), 4e-15 * size);
  EXPECT_LT((found.second.end() - ends.end).norm(), 4e-15 * size);
  EXPECT_LT(angleBetween(found.first.endDirection_rad(), found.second.direction_rad), 1e-13);
  EXPECT_LT(angleBetween(found.second.endDirection_rad(), ends.end_direction_rad), 1e-13);
  EXPECT_GT(found.first.length_mm, 0);
  EXPECT_GT(found.second.length_mm, 0);
}

// Identities (1) and (2), flat and straight ones among them.
TEST(Biarc, JoinsTheEndsWithOneTangent) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    HermiteEnds ends = test::randomEnds(random);
    const double chord = std::atan2(ends.end.y() - ends.start.y(), ends.end.x() - ends.start.x());
    if (i % 5 == 0) ends.start_direction_rad = chord;
    if (i % 7 == 0) ends.end_direction_rad = chord + 1e-6 * uniform(random, -1, 1);
    if (i % 11 == 0) ends.end_direction_rad = ends.start_direction_rad;
    const ChordAngles angles = chordAngles(ends);
    if (std::abs(angles.alpha_rad + angles.beta_rad) > 6.2) continue;
    expectJoins(ends, biarc(ends, uniform(random, 0.01, 0.99)));
  }
}

TEST(Biarc, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("biarcs.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json &in = entry["in"], &out = entry["out"];
    const HermiteEnds ends{.start = planarVector(in["P0"]),
                           .start_direction_rad = number(in["theta0"]),
                           .end = planarVector(in["P1"]),
                           .end_direction_rad = number(in["theta1"])};
    const ChordAngles angles = chordAngles(ends);
    EXPECT_NEAR(angles.alpha_rad, number(out["alpha"]), 1e-15 * 4);
    EXPECT_NEAR(angles.beta_rad, number(out["beta"]), 1e-15 * 4);
    double x = in.contains("x") ? number(in["x"]) : 0;
    if (in.contains("rule")) {
      const std::map<std::string, BiarcRule> rules = {{"equal_chord", BiarcRule::EqualChords},
                                                      {"parallel", BiarcRule::Parallel},
                                                      {"min_dr", BiarcRule::LeastRadiusDifference}};
      x = biarcParameter(ends, rules.at(in["rule"].get<std::string>())).value();
    }
    EXPECT_NEAR(x, number(out["x"]), 1e-14);
    const Biarc found = biarc(ends, x);
    // Long arcs multiply the rounding of their directions.
    const double size = 1 + number(out["len1"]) + number(out["len2"]);
    const auto near = [size](double value, double expected) {
      EXPECT_NEAR(value, expected, 1e-14 * size);
    };
    near(found.first.curvature_per_mm, number(out["k1"]));
    near(found.second.curvature_per_mm, number(out["k2"]));
    near(found.first.length_mm, number(out["len1"]));
    near(found.second.length_mm, number(out["len2"]));
    near(found.first.sweep_rad(), number(out["sweep1"]));
    near((found.joint() - planarVector(out["joint"])).norm(), 0);
    EXPECT_EQ(found.isConvex(), out["convex"].get<bool>());
    std::vector<BezierCurve> curves = bezierCurves(found.first);
    for (const BezierCurve& curve : bezierCurves(found.second)) curves.push_back(curve);
    ASSERT_EQ(curves.size(), out["bezier"].size());
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector2d pole = curves[i].poles().row(k).head<2>().transpose();
        near((pole - planarVector(out["bezier"][i]["points"][k])).norm(), 0);
        near(curves[i].weights()(k), number(out["bezier"][i]["weights"][k]));
      }
  }
}

// Identity (3).
TEST(Biarc, ReversedAndMirroredEndsGiveReversedAndMirroredBiarcs) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const HermiteEnds ends = test::randomEnds(random);
    const ChordAngles angles = chordAngles(ends);
    if (std::abs(angles.alpha_rad + angles.beta_rad) > 6) continue;
    const double x = uniform(random, 0.05, 0.95);
    const Biarc found = biarc(ends, x);
    const Biarc back = biarc({.start = ends.end,
                              .start_direction_rad = ends.end_direction_rad + pi,
                              .end = ends.start,
                              .end_direction_rad = ends.start_direction_rad + pi},
                             1 - x);
    const double size = 10 + found.first.length_mm + found.second.length_mm;
    EXPECT_LT((back.joint() - found.joint()).norm(), 1e-13 * size);
    EXPECT_NEAR(back.first.curvature_per_mm, -found.second.curvature_per_mm, 1e-12);
    const auto mirror = [](const Eigen::Vector2d& p) { return Eigen::Vector2d(p.x(), -p.y()); };
    const Biarc mirrored = biarc({.start = mirror(ends.start),
                                  .start_direction_rad = -ends.start_direction_rad,
                                  .end = mirror(ends.end),
                                  .end_direction_rad = -ends.end_direction_rad},
                                 x);
    EXPECT_LT((mirrored.joint() - mirror(found.joint())).norm(), 1e-13 * size);
    EXPECT_NEAR(mirrored.first.curvature_per_mm, -found.first.curvature_per_mm, 1e-12);
  }
}

// Identity (4), by every rule.
TEST(Biarc, EndsOnACircleGiveTheCircle) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < cases; ++i) {
    const double half = uniform(random, -1.5, 1.5), chord = uniform(random, 0.1, 9);
    const double curvature = 2 * std::sin(half) / chord;
    const HermiteEnds ends = endsWith(half, half, chord);
    for (const BiarcRule rule : {BiarcRule::Default, BiarcRule::EqualChords, BiarcRule::Parallel,
                                 BiarcRule::LeastRadiusDifference, BiarcRule::LeastCurvature}) {
      const Biarc found = biarc(ends, rule);
      EXPECT_NEAR(found.first.curvature_per_mm, curvature, 1e-13 * (1 + std::abs(curvature)));
      EXPECT_NEAR(found.second.curvature_per_mm, curvature, 1e-13 * (1 + std::abs(curvature)));
    }
  }
}

// Identity (5): what a rule minimises, compared with all other biarcs of the family.
class BiarcRules : public ::testing::TestWithParam<std::pair<double, double>> {
 protected:
  /// The least value of a figure over the family, or over its convex part.
  template <class FigureOf>
  double least(const FigureOf& figure, bool only_convex) const {
    double smallest = INFINITY;
    constexpr int count = 20'000;
    for (int i = 1; i < count; ++i) {
      const Biarc found = biarc(ends_, static_cast<double>(i) / count);
      if (only_convex && !found.isConvex()) continue;
      smallest = std::min(smallest, figure(found));
    }
    return smallest;
  }
  bool isCShape() const { return GetParam().first * GetParam().second > 0; }

  HermiteEnds ends_ = endsWith(GetParam().first, GetParam().second, 2);
};

TEST_P(BiarcRules, EqualChordsHaveTheLeastDifferenceOfCurvature) {
  const auto difference = [](const Biarc& found) {
    return std::abs(found.first.curvature_per_mm - found.second.curvature_per_mm);
  };
  const Biarc found = biarc(ends_, BiarcRule::EqualChords);
  EXPECT_LE(difference(found), least(difference, false) + 1e-12);
  EXPECT_NEAR((found.joint() - ends_.start).norm(), (found.joint() - ends_.end).norm(), 1e-13);
}

TEST_P(BiarcRules, ParallelTangentIsParallelToTheChord) {
  if (!isCShape()) {
    EXPECT_FALSE(biarcParameter(ends_, BiarcRule::Parallel).has_value());
    EXPECT_THROW(biarc(ends_, BiarcRule::Parallel), std::domain_error);
    return;
  }
  const Biarc found = biarc(ends_, BiarcRule::Parallel);
  EXPECT_LT(angleBetween(found.second.direction_rad, 0), 1e-14);
  EXPECT_TRUE(found.isConvex());
}

TEST_P(BiarcRules, RadiiDifferLeast) {
  const std::optional<double> x = biarcParameter(ends_, BiarcRule::LeastRadiusDifference);
  const double ratio = GetParam().second / GetParam().first;
  EXPECT_EQ(x.has_value(), ratio > 1.0 / 3 && ratio < 3);
  if (!x) return;
  const auto difference = [](const Biarc& found) {
    return std::abs(1 / found.first.curvature_per_mm - 1 / found.second.curvature_per_mm);
  };
  EXPECT_LE(difference(biarc(ends_, *x)), least(difference, true) * (1 + 1e-9) + 1e-12);
}

TEST_P(BiarcRules, CurvatureIsLeast) {
  const auto sum = [](const Biarc& found) {
    return std::abs(found.first.curvature_per_mm) + std::abs(found.second.curvature_per_mm);
  };
  // The convex biarcs are an open set, with the chosen one at its end.
  EXPECT_LE(sum(biarc(ends_, BiarcRule::LeastCurvature)), least(sum, isCShape()) + 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Angles, BiarcRules,
                         ::testing::Values(std::pair(0.4, 0.7), std::pair(0.7, 0.4),
                                           std::pair(0.2, 0.9), std::pair(-0.5, -0.9),
                                           std::pair(0.5, -0.3), std::pair(-0.2, 0.8),
                                           std::pair(0.6, -0.6), std::pair(1.2, 0.9)));

TEST(Biarc, InvalidInputIsNamed) {
  const HermiteEnds ends = endsWith(0.3, 0.4);
  for (const double x : {0.0, 1.0, -0.5, 1.5, std::nan("")})
    EXPECT_THROW(biarc(ends, x), std::invalid_argument);
  EXPECT_THROW(biarc(endsWith(pi, pi), 0.5), std::domain_error);
  EXPECT_THROW(biarc(endsWith(0.3, 0.4, 0), 0.5), std::invalid_argument);
  EXPECT_THROW(biarc(endsWith(std::nan(""), 0.4), 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
