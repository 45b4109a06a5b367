// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <chrono>
#include <limits>

#include "spline_surfaces.hpp"
#include "support/random.hpp"

#include <seamwright/core/seam/bspline_side.hpp>

namespace seamwright {
namespace {

using test::strip, test::StripShape, test::Vec;

std::vector<double> evenKnots(int spans) {
  std::vector<double> knots;
  for (int k = 1; k < spans; ++k) knots.push_back(static_cast<double>(k) / spans);
  return knots;
}

void expectJoined(const NearestJoin& join, int order) {
  ContinuityTolerance tight;
  tight.angle_rad = 1e-10;
  tight.curvature_rel = 1e-9;
  const SeamFigures figures =
      encloseSeam(seamSide(join.a, PatchEdge::U0), seamSide(join.b, PatchEdge::U0), tight);
  EXPECT_LT(figures.angle_rad->upper.value(), 1e-10);
  if (order == 2) {
    EXPECT_LT(figures.curvature_per_mm->upper.value(), 1e-8);
  }
}

/// Largest jump of the degree-th derivative of the edge u = 0 at these simple knots, in mm, by
/// one-sided jets.
double roughness(const BSplineSurface& surface, const std::vector<double>& knots) {
  double largest = 0;
  for (const double knot : knots)
    largest = std::max(
        largest,
        (jet(surface, 0, knot).vvv - jet(surface, 0, std::nextafter(knot, 0.0)).vvv).norm());
  return largest;
}

TEST(NearestJoinKnots, SimpleKnotsAskForBetaZeroOrASmootherSeam) {
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 36; ++round) {
    const int order = 1 + round % 2;
    const std::vector<double> knots = {0.2, 0.5, 0.6};
    JoinSide a{strip({3, 3, knots}, -1, 0.1, random)}, b{strip({3, 3, knots}, 1, 0.1, random)};
    a.moves = round / 2 % 3 != 1;
    b.moves = round / 2 % 3 != 2;
    const NearestJoin join = nearestJoin(a, b, {.order = order});
    EXPECT_EQ(join.status, NearestStatus::Joined);
    if (!a.moves || !b.moves || roughness(join.a, knots) > 1e-8) {
      EXPECT_EQ(join.connection.beta.norm(), 0);
      EXPECT_EQ(join.connection.q.norm(), 0);
    }
    EXPECT_LT(join.stationarity, 1e-10);
    expectJoined(join, order);
  }
}

TEST(NearestJoinKnots, AtOneSimpleKnotALinearBetaVanishes) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3, {0.25}}, -1, 0.1, random)}, b{strip({3, 3, {0.25}}, 1, 0.1, random)};
  a.moves = false;
  const NearestJoin join = nearestJoin(a, b);
  EXPECT_EQ(join.status, NearestStatus::Joined);
  EXPECT_GT(join.connection.beta.norm(), 1e-4);
  EXPECT_NEAR(0.75 * join.connection.beta(0) + 0.25 * join.connection.beta(1), 0, 1e-15);
  expectJoined(join, 1);
}

TEST(NearestJoinKnots, RaisedKnotsLeaveBetaFree) {
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 18; ++round) {
    const int order = 1 + round % 2;
    JoinSide a{strip({3, 4, {0.2, 0.5, 0.6}}, -1, 0.1, random)};
    JoinSide b{strip({3, 4, {0.2, 0.5, 0.6}}, 1, 0.1, random)};
    for (JoinSide* side : {&a, &b})
      side->surface = withRaisedKnots(side->surface, along(side->edge), order);
    a.moves = round / 2 % 3 != 1;
    b.moves = round / 2 % 3 != 2;
    const NearestJoin join = nearestJoin(a, b, {.order = order});
    ConnectionFunctions straight;
    straight.alpha = join.connection.alpha;
    straight.p = join.connection.p;
    const NearestJoin held = nearestJoin(a, b, {.order = order, .held = straight});
    EXPECT_EQ(join.status, NearestStatus::Joined);
    EXPECT_GT(join.connection.beta.norm(), 1e-4);
    EXPECT_LT(join.cost, held.cost);
    EXPECT_LT(join.stationarity, 1e-10);
    expectJoined(join, order);
  }
}

// A seam that is nearly straight and even has knots that cost little to smooth; a shear across them
// costs much without beta.
TEST(NearestJoinKnots, TheSeamBecomesSmootherWhereThatIsNearer) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3, {0.3, 0.6}}, -1, 1e-5, random)},
      b{strip({3, 3, {0.3, 0.6}}, 1, 1e-5, random)};
  for (int i = 1; i < 4; ++i)
    for (int j = 0; j < b.surface.countV(); ++j) {
      // Along the seam: v' = v + shear u, kept on the surface z(x, y) of the strips.
      auto pole = b.surface.poles.row(static_cast<Eigen::Index>(i) * b.surface.countV() + j);
      pole(1) += 0.8 * i;
      pole(2) = 0.05 * pole(0) * pole(0) + 0.03 * pole(1) * pole(1) - 0.04 * pole(0) * pole(1);
    }
  const NearestJoin join = nearestJoin(a, b);
  EXPECT_EQ(join.status, NearestStatus::Joined);
  EXPECT_GT(join.connection.beta.norm(), 0.1);
  EXPECT_LT(join.largest_move_mm, 0.3);
  EXPECT_LT(roughness(join.a, {0.3, 0.6}), 1e-8);
  expectJoined(join, 1);
}

TEST(NearestJoinFixed, FixedPolesKeepEveryBit) {
  std::mt19937_64 random(testSeed());
  std::bernoulli_distribution often(0.3);
  int joined = 0;
  for (int round = 0; round < 60; ++round) {
    const int order = 1 + round % 2;
    JoinSide a{strip({3, 5}, -1, 0.05, random)}, b{strip({3, 5}, 1, 0.05, random)};
    for (JoinSide* side : {&a, &b})
      for (Eigen::Index i = 0; i < side->surface.poles.rows(); ++i)
        side->fixed.push_back(side == &a && often(random));
    const NearestJoin join = nearestJoin(a, b, {.order = order});
    for (std::size_t i = 0; i < a.fixed.size(); ++i)
      if (a.fixed[i]) {
        EXPECT_EQ(join.a.poles.row(static_cast<Eigen::Index>(i)),
                  a.surface.poles.row(static_cast<Eigen::Index>(i)));
      }
    EXPECT_EQ(join.status, NearestStatus::Joined);
    expectJoined(join, order);
    joined += join.status == NearestStatus::Joined;
  }
  EXPECT_EQ(joined, 60);
}

TEST(NearestJoinFixed, CornersThatStayAskForTheConnection) {
  // The poles of the first (and last) column stay on both sides, which continue each other there in
  // C^order: alpha = 1, all else 0.
  for (const bool both_ends : {false, true})
    for (const int order : {1, 2}) {
      std::mt19937_64 random(testSeed());
      JoinSide a{strip({3, 4}, -1, 0.05, random)}, b{strip({3, 4}, 1, 0.05, random)};
      for (JoinSide* side : {&a, &b}) side->fixed.assign(side->surface.poles.rows(), false);
      for (Eigen::Index row = 0; row <= order; ++row)
        for (const Eigen::Index column : {0L, both_ends ? 4L : 0L}) {
          a.fixed[5 * row + column] = b.fixed[5 * row + column] = true;
          b.surface.poles.row(5 * row + column) =
              2 * a.surface.poles.row(column) - a.surface.poles.row(5 * row + column);
          if (row == 2)
            b.surface.poles.row(10 + column) = 4 * a.surface.poles.row(column) -
                                               4 * a.surface.poles.row(5 + column) +
                                               a.surface.poles.row(10 + column);
        }
      const NearestJoin join = nearestJoin(a, b, {.order = order});
      EXPECT_EQ(join.status, NearestStatus::Joined);
      EXPECT_NEAR(join.connection.alpha(0), 1, 1e-12);
      EXPECT_EQ(join.connection.beta(0), 0);
      EXPECT_NEAR(join.connection.p(0), 0, 1e-12);
      EXPECT_EQ(join.connection.q(0), 0);
      EXPECT_LT(join.largest_move_mm, 1);
      EXPECT_LT(join.stationarity, 1e-10);
      expectJoined(join, order);
    }
}

// Cross derivatives that stay and are nearly parallel: beta would turn the seam's tangent into
// them.
TEST(NearestJoinFixed, AJoinWithoutTangentPlaneIsNone) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 4}, -1, 0.05, random)}, b{strip({3, 4}, 1, 0.05, random)};
  for (JoinSide* side : {&a, &b}) {
    side->fixed.assign(side->surface.poles.rows(), false);
    side->fixed[0] = side->fixed[5] = true;
  }
  b.surface.poles.row(0) = a.surface.poles.row(0);
  b.surface.poles.row(5) = 2 * a.surface.poles.row(0) - a.surface.poles.row(5);
  b.surface.poles(5, 2) += 1e-6;
  const NearestJoin join = nearestJoin(a, b);
  EXPECT_EQ(join.status, NearestStatus::Infeasible);
  EXPECT_EQ(join.a, a.surface);
}

TEST(NearestJoinFixed, WhatCannotJoinIsReturnedAsGiven) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3}, -1, 0.1, random)}, b{strip({3, 3}, 1, 0.1, random)};
  const auto expectInfeasible = [](const JoinSide& one, const JoinSide& other) {
    for (const int order : {1, 2}) {
      const NearestJoin join = nearestJoin(one, other, {.order = order});
      EXPECT_EQ(join.status, NearestStatus::Infeasible);
      EXPECT_GT(join.residual, 1e-4);
      EXPECT_EQ(join.a, one.surface);
      EXPECT_EQ(join.b, other.surface);
      EXPECT_EQ(join.largest_move_mm, 0);
    }
  };
  a.moves = b.moves = false;
  expectInfeasible(a, b);
  // Seams that are apart and stay.
  a.moves = b.moves = true;
  for (JoinSide* side : {&a, &b}) {
    side->fixed.assign(side->surface.poles.rows(), false);
    std::fill_n(side->fixed.begin(), 4, true);
  }
  expectInfeasible(a, b);
  // One seam, but the row behind it stays on both sides.
  b.surface.poles.topRows(4) = a.surface.poles.topRows(4);
  for (JoinSide* side : {&a, &b}) std::fill_n(side->fixed.begin(), 8, true);
  expectInfeasible(a, b);
}

// The seam of b is one point, which a would have to shrink to.
TEST(NearestJoinRegular, AnEdgeThatWouldCollapseIsRefused) {
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 60; ++round) {
    JoinSide a{strip({1 + round % 4, 2 + round % 3}, -1, 0.3, random)};
    JoinSide b{strip({1 + round / 4 % 4, 2 + round % 3}, 1, 0.3, random)};
    b.surface.poles.topRows(b.surface.countV()).rowwise() = b.surface.poles.row(0).eval();
    b.moves = false;
    const NearestJoin join = nearestJoin(a, b, {.order = 1 + round / 2 % 2});
    EXPECT_EQ(join.status, NearestStatus::Infeasible) << "round " << round;
    EXPECT_EQ(join.a, a.surface);
  }
}

// The end v = 1 of one side is a point, so that its cross derivative is 0 there and that of the
// other would have to lie along the seam.
TEST(NearestJoinRegular, ACornerThatWouldCollapseIsRefused) {
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 24; ++round) {
    const StripShape shape{3, 2 + round / 4 % 3};
    JoinSide a{strip(shape, -1, 0.1, random)}, b{strip(shape, 1, 0.1, random)};
    const bool in_a = round % 2 == 0;
    JoinSide& still = in_a ? a : b;
    for (int i = 1; i <= 3; ++i)
      still.surface.poles.row((i + 1) * still.surface.countV() - 1) =
          still.surface.poles.row(still.surface.countV() - 1);
    still.moves = false;
    const NearestJoin join = nearestJoin(a, b, {.order = 1 + round / 2 % 2});
    EXPECT_EQ(join.status, NearestStatus::Infeasible) << "round " << round;
    EXPECT_EQ(join.a, a.surface);
    EXPECT_EQ(join.b, b.surface);
  }
}

// Surfaces so small and so far away that rounding of their poles is a share of their size.
TEST(NearestJoinRegular, NothingIsClaimedWhereRoundingHidesTheJoin) {
  std::mt19937_64 random(testSeed());
  for (const double size : {1e-7, 1e-6, 1e-4, 1e-2, 1.0}) {
    JoinSide a{strip({3, 3}, -1, 0.1, random)}, b{strip({3, 3}, 1, 0.1, random)};
    for (JoinSide* side : {&a, &b})
      side->surface =
          test::mapped(side->surface, size / 10 * Eigen::Matrix3d::Identity(), Vec(1e6, 1e6, 1e6));
    const NearestJoin join = nearestJoin(a, b);
    EXPECT_EQ(join.status, size < 1e-3 ? NearestStatus::Infeasible : NearestStatus::Joined) << size;
    if (join.status == NearestStatus::Joined) {
      EXPECT_LT(join.residual, 1e-6);
    }
  }
}

TEST(NearestJoinRegular, WeightsStayPositive) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> weight(0.1, 6);
  int refused = 0;
  for (int round = 0; round < 120; ++round) {
    JoinSide a{strip({3, 2 + round % 3}, -1, 0.3, random)},
        b{strip({3, 2 + round % 3}, 1, 0.3, random)};
    for (JoinSide* side : {&a, &b})
      for (Eigen::Index i = 0; i < side->surface.poles.rows(); ++i)
        side->surface.poles.row(i) *= weight(random) / side->surface.poles(i, 3);
    a.moves = false;
    const NearestJoin join = nearestJoin(a, b, {.order = 1 + round / 3 % 2});
    EXPECT_GT(join.b.poles.col(3).minCoeff(), 0) << "round " << round;
    refused += join.status == NearestStatus::Infeasible;
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 60);
}

TEST(NearestJoinRegular, UnchangedIsSaidOfJoinsOnly) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3}, -1, 0.1, random)}, b{strip({3, 3}, 1, 0.1, random)};
  // A surface that folds back onto itself: all equations hold, with alpha = -1.
  EXPECT_NE(nearestJoin(a, a).status, NearestStatus::Unchanged);
  // One whose rows lie along a straight seam: alpha = 0.
  JoinSide flat = a, line = b;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      flat.surface.poles.row(4 * i + j) << -3 * i, 3 * j, 0, 1;
      line.surface.poles.row(4 * i + j) << 0, 3 * j + i, 0, 1;
    }
  EXPECT_NE(nearestJoin(flat, line).status, NearestStatus::Unchanged);
  const NearestJoin join = nearestJoin(a, b);
  a.surface = join.a;
  b.surface = join.b;
  EXPECT_EQ(nearestJoin(a, b).status, NearestStatus::Unchanged);
  for (const Eigen::Index pole : {1, 5}) {  // of the seam, and of the row behind it
    JoinSide other = b;
    other.surface.poles(pole, 2) += 1e-9;
    EXPECT_NE(nearestJoin(a, other).status, NearestStatus::Unchanged) << pole;
  }
}

TEST(NearestJoinAlpha, DoesNotFallBelowItsShare) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3}, -1, 0.02, random)}, b{strip({3, 3}, -1, 0.02, random)};  // a fold
  a.moves = false;
  const NearestJoin join = nearestJoin(a, b, {.smallest_alpha = 0.2});
  EXPECT_EQ(join.status, NearestStatus::Joined);
  EXPECT_NEAR(join.connection.alpha(0), 0.2, 0.02);
  EXPECT_LT(join.stationarity, 1e-10);
  expectJoined(join, 1);
}

TEST(NearestJoinSize, TimeAndRefusal) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3, evenKnots(60)}, -1, 0.001, random)},
      b{strip({3, 3, evenKnots(60)}, 1, 0.001, random)};
  const auto start = std::chrono::steady_clock::now();
  const NearestJoin join = nearestJoin(a, b, {.order = 2});
  EXPECT_EQ(join.status, NearestStatus::Joined);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
  EXPECT_LT(join.residual, 1e-12);
  a.surface = strip({3, 3, evenKnots(2000)}, -1, 0.01, random);
  b.surface = strip({3, 3, evenKnots(2000)}, 1, 0.01, random);
  EXPECT_THAT([&] { nearestJoin(a, b, {.order = 2}); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("2003 poles")));
}

TEST(NearestJoinErrors, NameTheOffendingNumber) {
  using testing::HasSubstr, testing::ThrowsMessage;
  std::mt19937_64 random(testSeed());
  const JoinSide a{strip({3, 3}, -1, 0.1, random)}, b{strip({3, 3}, 1, 0.1, random)};
  const auto expectRefused = [&](const JoinSide& other, const NearestOptions& options,
                                 const char* text) {
    EXPECT_THAT([&] { nearestJoin(a, other, options); },
                ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused(b, {.order = 4}, "order is 4");
  expectRefused(b, {.degree_alpha = -1}, "alpha is -1");
  expectRefused(b, {.order = 2, .degree_q = 7}, "q is 7");
  expectRefused(b, {.smallest_alpha = 0}, "smallest_alpha is 0");
  expectRefused(b, {.smallest_alpha = nan}, "smallest_alpha is nan");
  expectRefused(b, {.max_iterations = -1}, "max_iterations is -1");
  const auto held = [](auto change) {
    NearestOptions options;
    options.held = ConnectionFunctions{};
    change(*options.held);
    return options;
  };
  expectRefused(b, held([](ConnectionFunctions& c) { c.alpha(0) = -1; }),
                "coefficient 0 of alpha is -1");
  expectRefused(b, held([](ConnectionFunctions& c) { c.beta(0) = nan; }), "beta");
  expectRefused(b, held([](ConnectionFunctions& c) { c.e0(0) = 2; }), "e0");
  expectRefused(b, held([](ConnectionFunctions& c) { c.e1(0) = 2; }), "e1");
  expectRefused(b, held([](ConnectionFunctions& c) { c.gamma(0) = 2; }), "gamma");
  expectRefused(b, held([](ConnectionFunctions& c) { c.alpha.resize(0); }), "alpha is -1");
  JoinSide other = b;
  other.weights = Eigen::VectorXd::Ones(3);
  expectRefused(other, {}, "weights of surface b are 3");
  other.weights = Eigen::VectorXd::Ones(16);
  other.weights(2) = 0;
  expectRefused(other, {}, "weight 2 of a move of surface b is 0");
  other = b;
  other.fixed = {true};
  expectRefused(other, {}, "fixed poles of surface b are 1");
  other = b;
  other.surface.poles(1, 0) = nan;
  expectRefused(other, {}, "pole 1 is not finite");
  other = b;
  other.surface.poles.middleRows(4, 4) = other.surface.poles.topRows(4);
  JoinSide same{other.surface};
  EXPECT_THAT([&] { nearestJoin(same, b); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("surface a has no extent")));
  other.surface.poles.rowwise() = other.surface.poles.row(0).eval();
  EXPECT_THROW(nearestJoin(other, other), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
