// SPDX-License-Identifier: LGPL-2.1-or-later
#include <numeric>

#include <seamwright/core/planar/clothoid_spline.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fair_points.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using std::numbers::pi;
using test::angleBetween;
using test::uniform;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Eigen::Index;
using Corners = std::vector<Index>;

/// Of an airfoil of NACA's four digits, from the trailing edge over the upper side and back.
struct Foil {
  double camber = 0, camber_at = 0.4, thickness = 0.12;
  bool sharp = true;
  int points = 35;  ///< of each side
  double chord_mm = 100;
  double grid_mm = 1e-3;  ///< coordinates are rounded to it
};

Eigen::RowVector2d foilPoint(const Foil& foil, double x, double side) {
  const double last = foil.sharp ? -0.1036 : -0.1015, p = foil.camber_at, m = foil.camber;
  const double y =
      5 * foil.thickness *
      (0.2969 * std::sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 + x * last))));
  const double mean = x < p ? m / (p * p) * (2 * p * x - x * x)
                            : m / ((1 - p) * (1 - p)) * (1 - 2 * p + 2 * p * x - x * x);
  const double slope = x < p ? 2 * m / (p * p) * (p - x) : 2 * m / ((1 - p) * (1 - p)) * (p - x);
  const double turn = std::atan(slope);
  const Eigen::RowVector2d point(x - side * y * std::sin(turn), mean + side * y * std::cos(turn));
  return (point * foil.chord_mm / foil.grid_mm).array().round() * foil.grid_mm;
}

/// A sharp trailing edge is the first point only.
PlanarPoints foilPoints(const Foil& foil) {
  const int n = foil.points, count = 2 * n - (foil.sharp ? 2 : 1);
  PlanarPoints points(count, 2);
  for (int i = 0; i < count; ++i) {
    const int k = std::abs(n - 1 - i);
    points.row(i) = foilPoint(foil, (1 - std::cos(pi * k / (n - 1))) / 2, i < n ? 1 : -1);
  }
  return points;
}

PlanarPoints noisyEllipse(Index count, double noise_mm, std::mt19937_64& random) {
  PlanarPoints points(count, 2);
  for (Index i = 0; i < count; ++i) {
    const double t = 2 * pi * double(i) / double(count);
    points.row(i) << 50 * std::cos(t) + uniform(random, -noise_mm, noise_mm),
        30 * std::sin(t) + uniform(random, -noise_mm, noise_mm);
  }
  return points;
}

/// Points of a chain by the trapezoidal rule over its direction, which takes no code of Clothoid
/// but its five numbers.
PlanarPoints sampled(const std::vector<Clothoid>& chain, int samples) {
  PlanarPoints result(std::ssize(chain) * samples, 2);
  Index row = 0;
  for (const Clothoid& piece : chain) {
    constexpr int steps = 50;
    Eigen::RowVector2d at = piece.start.transpose();
    const double ds = piece.length_mm / (samples * steps);
    const auto tangent = [&](double s) {
      const double angle = piece.direction_rad + piece.curvature_per_mm * s +
                           piece.curvature_slope_per_mm2 * s * s / 2;
      return Eigen::RowVector2d(std::cos(angle), std::sin(angle));
    };
    for (int i = 0; i < samples; ++i) {
      result.row(row++) = at;
      for (int k = 0; k < steps; ++k) {
        const double s = (i * steps + k) * ds;
        at += ds * (tangent(s) + tangent(s + ds)) / 2;
      }
    }
  }
  return result;
}

/// Changes of the sign of the turns of a polygon, except for turns that are rounding.
int turnsToTheOtherSide(const PlanarPoints& points, bool closed) {
  const Index n = points.rows();
  int changes = 0, first = 0, last = 0;
  for (Index i = closed ? 0 : 1; i < n - (closed ? 0 : 1); ++i) {
    const Eigen::RowVector2d a = points.row(i) - points.row((i + n - 1) % n);
    const Eigen::RowVector2d b = points.row((i + 1) % n) - points.row(i);
    const double turn = (a.x() * b.y() - a.y() * b.x()) / (a.norm() * b.norm());
    if (std::abs(turn) < 1e-10) continue;
    const int sign = turn > 0 ? 1 : -1;
    if (first == 0) first = sign;
    changes += last != 0 && sign != last;
    last = sign;
  }
  return changes + (closed && last != first);
}

FairedClothoids fairAll(const PlanarPoints& points, double tolerance_mm, bool closed) {
  return fairClothoids(
      points, Eigen::VectorXd::Constant(points.rows(), tolerance_mm),
      {.closed = closed,
       .corners = pointCorners(points, {.closed = closed, .error_mm = tolerance_mm})});
}

// Identity (1): closed forms and a dense sample.
TEST(ClothoidFigures, AgreeWithADenseSample) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 5; ++i) {
    const PlanarPoints points = noisyEllipse(14, 1, random);
    const std::vector<Clothoid> chain = clothoidSpline(points, {.closed = true}).pieces;
    const ClothoidFigures found = figuresOf(chain, true);
    const PlanarPoints dense = sampled(chain, 200);
    const Index n = dense.rows();
    double length = 0, energy = 0, variation = 0;
    const Eigen::VectorXd curvatures = pointCurvatures_per_mm(dense, true);
    for (Index k = 0; k < n; ++k) {
      const double ds = (dense.row((k + 1) % n) - dense.row(k)).norm();
      length += ds;
      energy += curvatures(k) * curvatures(k) * ds;
      variation += std::pow(curvatures((k + 1) % n) - curvatures(k), 2) / ds;
    }
    EXPECT_NEAR(found.length_mm, length, 1e-4 * length);
    EXPECT_NEAR(found.energy_per_mm, energy, 1e-2 * energy);
    EXPECT_NEAR(found.variation_per_mm3, variation, 3e-2 * variation);
    EXPECT_EQ(found.inflections, turnsToTheOtherSide(dense, true));
  }
}

// Identities (2) and (3).
TEST(FairClothoids, StayWithinTheTolerancesAndAreFairer) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 12; ++i) {
    const Index count = 20 + Index(random() % 60);
    const bool closed = i % 2 == 0;
    const PlanarPoints points =
        noisyEllipse(count, 0.02, random).topRows(closed ? count : count / 2);
    Eigen::VectorXd tolerances(points.rows());
    for (double& tolerance : tolerances)
      tolerance = random() % 5 == 0 ? 0 : uniform(random, 0.5, 2) * 0.02;
    const FairedClothoids found = fairClothoids(points, tolerances, {.closed = closed});
    const Eigen::VectorXd moves = (found.points - points).rowwise().norm();
    for (Index k = 0; k < points.rows(); ++k) {
      EXPECT_LE(moves(k), tolerances(k)) << k;
      if (tolerances(k) > 0) continue;
      EXPECT_EQ(found.points.row(k), points.row(k)) << k;
    }
    EXPECT_EQ(found.moved_mm, moves.maxCoeff());
    ASSERT_TRUE(found.before);
    EXPECT_LT(found.after.variation_per_mm3, found.before->variation_per_mm3);
    EXPECT_LE(found.after.inflections, found.before->inflections);
    for (std::size_t k = 0; k < found.pieces.size(); ++k)
      EXPECT_EQ(found.pieces[k].start, found.points.row(Index(k)).transpose());
  }
}

// What fairPoints() leaves: clothoids through its points turn to the other side.
TEST(FairClothoids, OfAnAirfoilHaveNoInflectionThatTheFairedPointsDoNotHave) {
  int of_points = 0;
  for (const double thickness : {0.06, 0.12})
    for (const double camber : {0.0, 0.02})
      for (const int count : {18, 35, 60})
        for (const double tolerance : {0.01, 0.05}) {
          const PlanarPoints points =
              foilPoints({.camber = camber, .thickness = thickness, .points = count});
          const FairedClothoids found = fairAll(points, tolerance, true);
          EXPECT_EQ(found.corners, Corners{0});
          EXPECT_LE(found.after.inflections, found.point_inflections);
          EXPECT_LE(found.moved_mm, tolerance);
          // A closed sample of one run: the corner itself turns to the same side.
          if (camber > 0) continue;
          EXPECT_EQ(turnsToTheOtherSide(sampled(found.pieces, 40), true), 0);
          const FairedPoints faired = fairPoints(
              points, Eigen::VectorXd::Constant(points.rows(), tolerance), {.closed = true});
          of_points += turnsToTheOtherSide(
              sampled(clothoidSpline(faired.points, {.closed = true}).pieces, 40), true);
        }
  EXPECT_GT(of_points, 50);
}

// The curvature of the sides is a thousandth of that of the nose, beside which points may move by
// more than their distances.
TEST(FairClothoids, OfAnAirfoilHaveFewExtremaWithAnyTolerance) {
  for (const double tolerance : {0.005, 0.02, 0.1, 0.5}) {
    const FairedClothoids found =
        fairAll(foilPoints({.camber = 0.03, .thickness = 0.08, .points = 25}), tolerance, true);
    EXPECT_LE(found.after.extrema, 4) << tolerance;
    EXPECT_GT(found.moved_mm, 0) << tolerance;
    EXPECT_LE(found.moved_mm, tolerance);
  }
}

// Identity (4).
TEST(FairClothoids, KeepCorners) {
  for (const bool sharp : {true, false}) {
    const PlanarPoints points = foilPoints({.sharp = sharp});
    const FairedClothoids found = fairAll(points, 0.05, true);
    EXPECT_EQ(found.corners, sharp ? Corners{0} : (Corners{0, points.rows() - 1}));
    const std::size_t count = found.pieces.size();
    for (const Index corner : found.corners) {
      EXPECT_EQ(found.points.row(corner), points.row(corner));
      const Clothoid& before = found.pieces[(std::size_t(corner) + count - 1) % count];
      EXPECT_GT(angleBetween(before.directionAt_rad(before.length_mm),
                             found.pieces[std::size_t(corner)].direction_rad),
                1);
    }
  }
}

/// How far a chain turns from the exact outline within its first and its last 5 %, in degrees: the
/// hooks at its ends, by chords of dense points.
double hooks_deg(const std::vector<Clothoid>& chain, const Foil& foil) {
  const PlanarPoints dense = sampled(chain, 20);
  double largest = 0;
  for (Index i = 1; i < dense.rows(); ++i) {
    const Eigen::RowVector2d chord = dense.row(i) - dense.row(i - 1);
    const double x = dense(i, 0) / foil.chord_mm, h = 1e-4;
    if (x < 0.95 || x > 1) continue;
    const double side = chord.x() < 0 ? 1 : -1;
    const Eigen::RowVector2d exact =
        side * (foilPoint(foil, x - h, side) - foilPoint(foil, x, side));
    const double turn = std::atan2(exact.x() * chord.y() - exact.y() * chord.x(), exact.dot(chord));
    largest = std::max(largest, std::abs(turn) * 180 / pi);
  }
  return largest;
}

// Identity (5), and (2) for ends that are free.
TEST(FairClothoids, WithFreeEndsHaveNoHooks) {
  std::mt19937_64 random(testSeed());
  constexpr double tolerance = 0.1;
  double of_held = 0, of_free = 0;
  for (int i = 0; i < 12; ++i) {
    const Foil foil = {.camber = i % 2 * 0.02, .sharp = false, .points = 40, .grid_mm = 1e-9};
    PlanarPoints points = foilPoints(foil);
    for (Index k = 0; k < points.rows(); ++k)
      points.row(k) +=
          Eigen::RowVector2d(uniform(random, -0.02, 0.02), uniform(random, -0.06, 0.06));
    // Ends that were read too high, on both sides.
    for (const Index end : {Index{0}, points.rows() - 1}) points(end, 1) += 0.06;
    const Eigen::VectorXd tolerances = Eigen::VectorXd::Constant(points.rows(), tolerance);
    const FairedClothoids held = fairClothoids(points, tolerances);
    const FairedClothoids free = fairClothoids(points, tolerances, {.ends_fixed = false});
    for (const Index end : {Index{0}, points.rows() - 1}) {
      EXPECT_EQ(held.points.row(end), points.row(end));
      EXPECT_NE(free.points.row(end), points.row(end));
    }
    EXPECT_LE((free.points - points).rowwise().norm().maxCoeff(), tolerance);
    // Fewer extrema may cost variation.
    if (free.after.extrema >= held.after.extrema) {
      EXPECT_LE(free.after.variation_per_mm3, held.after.variation_per_mm3 * 1.01);
    }
    EXPECT_LE(free.after.inflections, held.after.inflections);
    of_held += hooks_deg(held.pieces, foil) / 12;
    of_free += hooks_deg(free.pieces, foil) / 12;
  }
  EXPECT_GT(of_held, 5 * of_free);
}

TEST(FairClothoids, WithFreeEndsHaveTheirCorners) {
  PlanarPoints points(21, 2);
  for (Index i = 0; i < 21; ++i)
    points.row(i) << double(i), 0.02 * double(i % 2) + (i < 10 ? double(i) : 20.0 - double(i));
  const Eigen::VectorXd tolerances = Eigen::VectorXd::Constant(21, 0.03);
  const FairedClothoids found =
      fairClothoids(points, tolerances, {.corners = {10}, .ends_fixed = false});
  EXPECT_EQ(found.points.row(10), points.row(10));
  EXPECT_NE(found.points.row(0), points.row(0));
  EXPECT_NE(found.points.row(20), points.row(20));
  EXPECT_LE((found.points - points).rowwise().norm().maxCoeff(), 0.03);
}

// An airfoil of 200 mm with a tolerance of 0.5 mm, which is more than the distance of points.
TEST(FairClothoids, MayHaveAToleranceAboveTheSpacing) {
  const Foil foil = {
      .camber = 0.02, .camber_at = 0.35, .thickness = 0.08, .points = 61, .chord_mm = 200};
  const FairedClothoids found = fairAll(foilPoints(foil), 0.5, true);
  EXPECT_EQ(found.corners, Corners{0});
  EXPECT_EQ(found.after.inflections, 0);
  EXPECT_EQ(turnsToTheOtherSide(sampled(found.pieces, 40), true), 0);
}

// Identity (3).
TEST(FairClothoids, PointsOfACircleStay) {
  std::mt19937_64 random(testSeed());
  for (const bool closed : {true, false}) {
    PlanarPoints points(30, 2);
    for (Index i = 0; i < 30; ++i)
      points.row(i) =
          7 * unitVector((closed ? 2 * pi : 3) * (double(i) + uniform(random, -0.3, 0.3)) / 30)
                  .transpose();
    const FairedClothoids found = fairAll(points, 0.1, closed);
    EXPECT_EQ(found.points, points);
    EXPECT_EQ(found.after.extrema + found.after.inflections, 0);
  }
}

TEST(FairClothoids, WithoutToleranceAreTheInput) {
  const PlanarPoints points = foilPoints({});
  const FairedClothoids found = fairAll(points, 0, true);
  EXPECT_EQ(found.points, points);
  ASSERT_TRUE(found.before);
  EXPECT_EQ(found.after.variation_per_mm3, found.before->variation_per_mm3);
  EXPECT_EQ(found.moved_mm, 0);
}

TEST(FairClothoids, KeepInflectionsThatAreNoErrors) {
  std::mt19937_64 random(testSeed());
  PlanarPoints points(30, 2);
  for (Index i = 0; i < 30; ++i)
    points.row(i) << 5 * double(i), 10 * std::sin(0.5 * double(i)) + uniform(random, -0.05, 0.05);
  const FairedClothoids found = fairAll(points, 0.06, false);
  EXPECT_EQ(found.after.inflections, 4);
  EXPECT_LE(found.after.extrema, 5);
}

TEST(FairClothoids, RefuseInvalidInput) {
  const PlanarPoints points = foilPoints({});
  const Eigen::VectorXd tolerances = Eigen::VectorXd::Constant(points.rows(), 0.1);
  const auto refused = [&](const Eigen::VectorXd& given, const Corners& corners, const char* text) {
    EXPECT_THAT([&] { fairClothoids(points, given, {.closed = true, .corners = corners}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  refused(Eigen::VectorXd::Zero(9), {}, "9 tolerances for 68 points");
  refused(-tolerances, {}, "the tolerance of point 0 is");
  refused(tolerances, {3, 3}, "corner 3 of 68 points");
  refused(tolerances, {68}, "corner 68 of 68 points");
}

TEST(PointCorners, AreFoundInOutlines) {
  // A rectangle with ten points on each side.
  PlanarPoints rectangle(40, 2);
  for (Index i = 0; i < 10; ++i) {
    const double t = double(i);
    rectangle.row(i) << t, 0;
    rectangle.row(10 + i) << 10, t / 2;
    rectangle.row(20 + i) << 10 - t, 5;
    rectangle.row(30 + i) << 0, 5 - t / 2;
  }
  EXPECT_EQ(pointCorners(rectangle, {.closed = true}), (Corners{0, 10, 20, 30}));
  EXPECT_EQ(pointCorners(rectangle, {.closed = true, .error_mm = 0.02}), (Corners{0, 10, 20, 30}));
  EXPECT_EQ(pointCorners(rectangle), (Corners{10, 20, 30}));
}

// Identity (1).
TEST(PointCorners, SmoothCurvesHaveNone) {
  std::mt19937_64 random(testSeed());
  for (const Index count : {3, 4, 5, 7, 40})
    EXPECT_TRUE(pointCorners(noisyEllipse(count, 0, random), {.closed = true}).empty()) << count;
  for (const double noise_mm : {0.01, 0.1})
    EXPECT_TRUE(
        pointCorners(noisyEllipse(400, noise_mm, random), {.closed = true, .error_mm = noise_mm})
            .empty());
  for (const int count : {10, 18, 60})
    EXPECT_TRUE(pointCorners(foilPoints({.points = count})).empty()) << count;
}

// Identities (2) and (3).
TEST(PointCorners, FollowMotionAndReversal) {
  const PlanarPoints points = foilPoints({.sharp = false});
  const Eigen::Matrix2d motion = 0.3 * Eigen::Rotation2Dd(1).toRotationMatrix();
  EXPECT_EQ(pointCorners(points * motion, {.closed = true}), (Corners{0, points.rows() - 1}));
  EXPECT_EQ(pointCorners(points.colwise().reverse(), {.closed = true}),
            (Corners{0, points.rows() - 1}));
}

// Walks from each point to a distant one would take minutes.
TEST(PointCorners, OfManyPointsAreFound) {
  constexpr Index count = 200000;
  PlanarPoints stairs(count, 2), tiny(count, 2);
  for (Index i = 0; i < count; ++i) {
    stairs.row(i) << double((i + 1) / 2), double(i / 2);
    const double turn_rad = 2 * pi * double(i) / double(count);
    tiny.row(i) << 1e-3 * std::cos(turn_rad), 1e-3 * std::sin(turn_rad);
  }
  EXPECT_TRUE(pointCorners(tiny, {.closed = true, .error_mm = 0.01}).empty());
  // The steps turn by 90 degrees.
  Corners inside(static_cast<std::size_t>(count - 2));
  std::iota(inside.begin(), inside.end(), Index{1});
  EXPECT_EQ(pointCorners(stairs, {.error_mm = 0.01}), inside);
}

}  // namespace
}  // namespace seamwright
