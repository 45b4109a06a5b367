// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/spiral.hpp>

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

HermiteEnds endsOf(const nlohmann::json& in) {
  return {.start = planarVector(in["P0"]),
          .start_direction_rad = number(in["theta0"]),
          .end = planarVector(in["P1"]),
          .end_direction_rad = number(in["theta1"])};
}

/// C-shaped ends with a turn of at most pi, to either side.
HermiteEnds randomCShape(std::mt19937_64& random) {
  const double turn = uniform(random, 0.05, 3.1), share = uniform(random, 0.1, 0.9);
  const double side = random() % 2 == 0 ? 1 : -1;
  HermiteEnds ends =
      endsWith(side * turn * share, side * turn * (1 - share), uniform(random, 0.1, 20));
  const double angle = uniform(random, -3, 3);
  ends.end = ends.end.x() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  ends.start_direction_rad += angle;
  ends.end_direction_rad += angle;
  const Eigen::Vector2d shift(uniform(random, -5, 5), uniform(random, -5, 5));
  ends.start += shift;
  ends.end += shift;
  return ends;
}

void expectChain(const std::vector<PlanarArc>& arcs, const HermiteEnds& ends) {
  double length = 0;
  for (const PlanarArc& arc : arcs) length += arc.length_mm;
  const double size = 10 + length;
  EXPECT_EQ(arcs.front().start, ends.start);
  EXPECT_LT(angleBetween(arcs.front().direction_rad, ends.start_direction_rad), 1e-12);
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i) {
    EXPECT_LT((arcs[i].end() - arcs[i + 1].start).norm(), 1e-14 * size);
    EXPECT_LT(angleBetween(arcs[i].endDirection_rad(), arcs[i + 1].direction_rad), 1e-12);
  }
  EXPECT_LT((arcs.back().end() - ends.end).norm(), 1e-12 * size);
  EXPECT_LT(angleBetween(arcs.back().endDirection_rad(), ends.end_direction_rad), 1e-12);
}

// Identity (1).
TEST(EulerArcs, MeetTheEndsWithCurvaturesInArithmeticProgression) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const HermiteEnds ends =
        endsWith(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, 0.1, 9));
    const int count = 2 + static_cast<int>(random() % 20);
    const std::vector<PlanarArc> arcs = eulerArcs(ends, count);
    ASSERT_EQ(arcs.size(), static_cast<std::size_t>(count));
    expectChain(arcs, ends);
    const double unit = 1e-11 / ends.end.norm();
    for (int j = 1; j + 1 < count; ++j) {
      EXPECT_DOUBLE_EQ(arcs[j].length_mm, arcs[0].length_mm);
      EXPECT_NEAR(arcs[j + 1].curvature_per_mm - arcs[j].curvature_per_mm,
                  arcs[j].curvature_per_mm - arcs[j - 1].curvature_per_mm, unit);
    }
  }
}

TEST(EulerArcs, AgreeWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("euler_arcs.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const nlohmann::json& out = entry["out"];
    const std::vector<PlanarArc> arcs = eulerArcs(endsOf(entry["in"]), entry["in"]["n"].get<int>());
    EXPECT_NEAR(arcs[0].curvature_per_mm, number(out["k0"]), 1e-13);
    EXPECT_NEAR(arcs[1].curvature_per_mm - arcs[0].curvature_per_mm, number(out["delta"]), 1e-13);
    for (std::size_t j = 0; j < arcs.size(); ++j)
      EXPECT_LT((arcs[j].start - planarVector(out["joints"][j])).norm(), 1e-12);
  }
}

TEST(EulerArcs, ApproachTheClothoidQuadratically) {
  const HermiteEnds ends = endsWith(0.9, -0.4, 3);
  const Clothoid limit = clothoid(ends);
  const auto error = [&](int count) {
    return std::abs(eulerArcs(ends, count).front().length_mm * count - limit.length_mm);
  };
  EXPECT_NEAR(error(16) / error(32), 4, 0.1);
  EXPECT_NEAR(error(32) / error(64), 4, 0.03);
}

TEST(EulerArcs, OneArcNeedsEndsOnACircle) {
  EXPECT_EQ(eulerArcs(endsWith(0.4, 0.4), 1).size(), 1U);
  EXPECT_THROW(eulerArcs(endsWith(0.4, 0.5), 1), std::domain_error);
  EXPECT_THROW(eulerArcs(endsWith(0.4, 0.5), 0), std::invalid_argument);
}

// Identity (2).
TEST(LogSpiral, MeetsTheEnds) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 500; ++i) {
    const HermiteEnds ends = randomCShape(random);
    const LogSpiral found = logSpiral(ends);
    const double size = 10 + (ends.end - ends.start).norm() * (1 + std::abs(found.growth));
    EXPECT_LT((found.end() - ends.end).norm(), 1e-13 * size);
    EXPECT_LT(angleBetween(found.direction_rad + (found.radius_mm < 0 ? -1 : 1) * found.turn_rad,
                           ends.end_direction_rad),
              1e-12);
  }
}

// Points by quadrature of the tangent over the arc length: ds = R du.
TEST(LogSpiral, PointIsTheIntegralOfTheTangent) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const LogSpiral found = logSpiral(randomCShape(random));
    const double side = found.radius_mm < 0 ? -1 : 1, u = uniform(random, 0, found.turn_rad);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    constexpr int panels = 20'000;
    for (int k = 0; k < panels; ++k) {
      const double v = u * (k + 0.5) / panels, angle = found.direction_rad + side * v;
      sum += std::abs(found.radiusAt_mm(v)) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    const Eigen::Vector2d expected = found.start + sum * u / panels;
    EXPECT_LT((found.point(u) - expected).norm(), 1e-7 * (1 + (expected - found.start).norm()));
    EXPECT_NEAR(found.directionAt_rad(u), found.direction_rad + side * u, 1e-14);
  }
}

// The sum of the radii by the turned angle.
TEST(LogSpiral, LengthIsTheIntegralOfTheRadius) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const LogSpiral found = logSpiral(randomCShape(random));
    double sum = 0;
    constexpr int panels = 20'000;
    for (int k = 0; k < panels; ++k)
      sum += std::abs(found.radiusAt_mm(found.turn_rad * (k + 0.5) / panels));
    EXPECT_NEAR(sum * found.turn_rad / panels / found.length_mm(), 1, 1e-7);
  }
  EXPECT_NEAR((LogSpiral{.radius_mm = -2, .turn_rad = 0.5}.length_mm()), 1, 1e-15);
}

// Identity (3).
TEST(LogSpiral, EndsOnACircleGiveTheCircle) {
  for (const double half : {1e-3, 0.3, 1.2, -0.7}) {
    const LogSpiral found = logSpiral(endsWith(half, half, 2));
    EXPECT_NEAR(found.growth * found.turn_rad, 0, 1e-12);
    EXPECT_NEAR(found.radius_mm, 1 / std::sin(half), 1e-9 / std::abs(half));
  }
}

// Identity (4).
TEST(LogSpiral, AngleBetweenTangentAndPoleIsConstant) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    const LogSpiral found = logSpiral(randomCShape(random));
    const double side = found.radius_mm < 0 ? -1 : 1;
    const auto angle = [&](double u) {
      const Eigen::Vector2d to_pole = found.pole() - found.point(u);
      return std::atan2(to_pole.y(), to_pole.x()) - (found.direction_rad + side * u);
    };
    for (const double share : {0.3, 0.7, 1.0})
      EXPECT_LT(angleBetween(angle(share * found.turn_rad), angle(0)), 1e-10);
    // Its cotangent is -growth for a spiral that turns to the left.
    const double size = std::hypot(1, found.growth);
    EXPECT_LT(std::abs(std::cos(angle(0)) + side * found.growth * std::sin(angle(0))), 1e-9 * size);
  }
}

TEST(LogSpiral, AgreesWithHighPrecision) {
  for (const nlohmann::json& entry : test::splineCases("log_spirals.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const HermiteEnds ends = endsOf(entry["in"]);
    const nlohmann::json &spiral = entry["out"]["spiral"], &arc = entry["out"]["arc"];
    const auto near = [](double value, double expected) {
      EXPECT_NEAR(value, expected, 1e-11 * std::max(1.0, std::abs(expected)));
    };
    const LogSpiral found = logSpiral(ends);
    near(found.growth, number(spiral["lambda"]));
    near(found.radius_mm, number(spiral["R0"]));
    const int count = entry["in"]["n"].get<int>();
    const std::vector<PlanarArc> arcs = logArcs(ends, count);
    ASSERT_EQ(arcs.size(), static_cast<std::size_t>(count));
    near(1 / arcs[0].curvature_per_mm, number(arc["R0"]));
    near(arcs[0].curvature_per_mm / arcs[1].curvature_per_mm, number(arc["rho"]));
    for (int j = 0; j < count; ++j)
      near((arcs[j].start - planarVector(arc["joints"][j])).norm(), 0);
    const SplineWithin spline = bezierSpline(found, number(spiral["bezier_tol"]));
    EXPECT_EQ(spline.curve.segments(), spiral["pieces"].get<int>());
  }
}

// Identity (5).
TEST(LogArcs, MeetTheEndsWithRadiiInGeometricProgression) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 300; ++i) {
    const HermiteEnds ends = randomCShape(random);
    const int count = leastLogArcs(ends) + static_cast<int>(random() % 12);
    const std::vector<PlanarArc> arcs = logArcs(ends, count);
    expectChain(arcs, ends);
    for (int j = 1; j + 1 < count; ++j) {
      const double before = arcs[j - 1].curvature_per_mm / arcs[j].curvature_per_mm;
      const double after = arcs[j].curvature_per_mm / arcs[j + 1].curvature_per_mm;
      EXPECT_NEAR(after / before, 1, 1e-11);
      EXPECT_NEAR(arcs[j].sweep_rad(), arcs[0].sweep_rad(), 1e-13);
    }
  }
}

TEST(LogArcs, ApproachTheSpiral) {
  const HermiteEnds ends = endsWith(0.5, 0.9, 3);
  const LogSpiral limit = logSpiral(ends);
  double before = INFINITY;
  for (const int count : {8, 16, 32, 64}) {
    const std::vector<PlanarArc> arcs = logArcs(ends, count);
    const double error =
        (arcs[static_cast<std::size_t>(count / 2)].start - limit.point(limit.turn_rad / 2)).norm();
    EXPECT_LT(error, before / 3);
    before = error;
  }
}

// With one arc fewer than leastLogArcs() the first arc alone turns too far for the smaller angle.
TEST(LogArcs, TooFewAreRefusedWithTheLeastNumber) {
  const HermiteEnds ends = endsWith(0.1, 0.75);
  EXPECT_EQ(leastLogArcs(ends), 5);
  try {
    logArcs(ends, 4);
    FAIL();
  } catch (const std::domain_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("at least 5"));
  }
}

// Identity (6): dense evaluation of both curves.
TEST(LogSpiral, SplineKeepsItsDistance) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 60; ++i) {
    const LogSpiral found = logSpiral(randomCShape(random));
    const double tolerance = std::pow(10, uniform(random, -8, -1));
    const SplineWithin spline = bezierSpline(found, tolerance);
    EXPECT_LE(spline.distance_mm, tolerance);
    for (int k = 0; k <= 200; ++k) {
      const double u = found.turn_rad * k / 200;
      const Eigen::Vector2d point = derivatives(spline.curve, u, 0).row(0).head<2>().transpose();
      EXPECT_LE((point - found.point(u)).norm(), spline.distance_mm + 1e-12);
    }
    for (const CurveJoint& joint : measureJoints(spline.curve, 2))
      EXPECT_EQ(orderReached(joint, {}), 2);
  }
}

// The largest ratio of radii is 1e12 = e^27.63: beside it both ways, to growing and to falling
// radii.
TEST(LogSpiral, RadiiDifferByAtMostTheFactorThatIsStated) {
  for (const double sign : {-1.0, 1.0}) {
    const auto endsOf = [](const Eigen::Vector2d& end, double turn_rad) {
      return HermiteEnds{.end = end, .end_direction_rad = turn_rad};
    };
    const auto spiral = [&](double growth) {
      const LogSpiral wanted{.radius_mm = 1, .growth = sign * growth / 2, .turn_rad = 2};
      return logSpiral(endsOf(wanted.point(2), 2));
    };
    EXPECT_NEAR(spiral(27.5).growth * 2, sign * 27.5, 1e-6);
    EXPECT_THROW(spiral(27.7), std::domain_error);
    const auto arcs = [&](double growth) {
      const int count = 4;
      Eigen::Vector2d at = Eigen::Vector2d::Zero();
      for (int i = 0; i < count; ++i)
        at = PlanarArc{.start = at,
                       .direction_rad = 0.5 * i,
                       .curvature_per_mm = std::exp(-sign * growth * i / (count - 1)),
                       .length_mm = 0.5 * std::exp(sign * growth * i / (count - 1))}
                 .end();
      return logArcs(endsOf(at, 0.5 * count), count);
    };
    const std::vector<PlanarArc> found = arcs(27.5);
    EXPECT_NEAR(std::log(found.front().curvature_per_mm / found.back().curvature_per_mm),
                sign * 27.5, 1e-6);
    EXPECT_THROW(arcs(27.7), std::domain_error);
  }
}

TEST(LogSpiral, InvalidEndsAreNamed) {
  EXPECT_THROW(logSpiral(endsWith(0.4, -0.3)), std::domain_error);
  EXPECT_THROW(logSpiral(endsWith(0, 0.3)), std::domain_error);
  EXPECT_THROW(logSpiral(endsWith(2, 2)), std::domain_error);
  EXPECT_THROW(logSpiral(endsWith(1e-9, 1)), std::domain_error);
  EXPECT_THROW(logSpiral(endsWith(0.3, 0.2, 0)), std::invalid_argument);
  EXPECT_THROW(leastLogArcs(endsWith(1e-9, 1)), std::domain_error);
  EXPECT_THROW(bezierSpline(logSpiral(endsWith(0.3, 0.2)), 0), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
