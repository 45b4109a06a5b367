// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <array>
#include <chrono>
#include <limits>

#include "spline_surfaces.hpp"
#include "support/random.hpp"

#include <seamwright/core/seam/bspline_side.hpp>

namespace seamwright {
namespace {

using test::largestDifference, test::strip, test::StripShape, test::turned, test::Vec;

constexpr std::array edges = {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1};

/// Two strips left and right of a seam, with the sides that move: 0 both, 1 only b, 2 only a.
struct Pair {
  JoinSide a, b;
};

Pair randomPair(const StripShape& left, const StripShape& right, int still,
                std::mt19937_64& random) {
  std::uniform_int_distribution<int> edge(0, 3);
  Pair pair;
  pair.a.edge = edges[edge(random)];
  pair.b.edge = edges[edge(random)];
  pair.a.surface = turned(strip(left, -1, 0.1, random), pair.a.edge);
  pair.b.surface = turned(strip(right, 1, 0.1, random), pair.b.edge);
  pair.a.moves = still != 1;
  pair.b.moves = still != 2;
  return pair;
}

/// \param rounding 1 for polynomial rows of even length and weight.
void expectJoined(const NearestJoin& join, const Pair& given, int order, double rounding = 1) {
  ContinuityTolerance tight;
  tight.gap_mm = 1e-10;
  tight.angle_rad = 1e-10;
  tight.curvature_rel = 1e-9;
  const SeamFigures figures = encloseSeam(seamSide(join.a, given.a.edge, given.a.reversed),
                                          seamSide(join.b, given.b.edge, given.b.reversed), tight,
                                          {.curvature_change = order == 3});
  EXPECT_TRUE(figures.certified);
  EXPECT_FALSE(figures.fold_at);
  EXPECT_LT(figures.gap_mm->upper.value(), 1e-9);
  EXPECT_LT(figures.angle_rad->upper.value(), 1e-10 * rounding);
  if (order >= 2) {
    EXPECT_LT(figures.curvature_per_mm->upper.value(), 1e-9 * rounding);
  }
  if (order == 3) {
    EXPECT_LT(figures.curvature_change_per_mm2->upper.value(), 1e-8 * rounding);
  }
  EXPECT_LT(join.residual, 1e-13 * rounding);
}

/// Coefficients of a product in Bernstein form; vectors one a row.
Poles product(const Eigen::VectorXd& f, const Poles& x) {
  const auto p = static_cast<int>(f.size()) - 1, q = static_cast<int>(x.rows()) - 1;
  Poles result = Poles::Zero(p + q + 1, 3);
  for (int i = 0; i <= p; ++i)
    for (int j = 0; j <= q; ++j)
      result.row(i + j) +=
          test::choose(p, i) * test::choose(q, j) / test::choose(p + q, i + j) * f(i) * x.row(j);
  return result;
}

Eigen::VectorXd product(const Eigen::VectorXd& f, const Eigen::VectorXd& g) {
  Poles x = Poles::Zero(g.size(), 3);
  x.col(0) = g;
  return product(f, x).col(0);
}

Poles raised(const Poles& x, int degree) {
  return product(Eigen::VectorXd::Ones(degree + 2 - x.rows()), x);
}

Poles derivative(const Poles& x) {
  const Eigen::Index n = x.rows() - 1;
  return static_cast<double>(n) * (x.bottomRows(n) - x.topRows(n));
}

/// Rows 0 to 3 of poles of a patch without inner knots, counted from the edge u = 0.
using Rows = std::array<Poles, 4>;

Rows rowsOf(const BSplineSurface& surface) {
  Rows rows;
  const int columns = surface.countV();
  for (int i = 0; i < 4; ++i)
    rows[i] =
        surface.poles.middleRows(static_cast<Eigen::Index>(i) * columns, columns).leftCols<3>();
  return rows;
}

/// The rows of b that ConnectionFunctions's equations of the natural degrees ask for, by products
/// of polynomials. Source: docs/theory/surfaces.md S3.1.
Rows continued(const Rows& p, int across_a, int across_b, const ConnectionFunctions& c, int order) {
  const double m = across_a, l = across_b;
  const auto n = static_cast<int>(p[0].rows()) - 1;
  const Poles out = m * (p[0] - p[1]), second = m * (m - 1) * (p[0] - 2 * p[1] + p[2]);
  const Poles along = derivative(p[0]);
  Rows q;
  q[0] = p[0];
  const Poles first_derivative =
      raised(product(c.alpha, out), n) + raised(product(c.beta, along), n);
  q[1] = q[0] + first_derivative / l;
  if (order == 1) return q;
  Poles by_s2 = raised(product(product(c.alpha, c.alpha), second), n) +
                raised(product(c.p, out), n) + raised(product(c.q, along), n);
  by_s2 += 2 * raised(product(product(c.alpha, c.beta), derivative(out)), n);
  if (n > 1) by_s2 += raised(product(product(c.beta, c.beta), derivative(along)), n);
  q[2] = 2 * q[1] - q[0] + by_s2 / (l * (l - 1));
  if (order == 2) return q;
  const Poles third = -m * (m - 1) * (m - 2) * (p[3] - 3 * p[2] + 3 * p[1] - p[0]);
  const Eigen::VectorXd alpha_2 = product(c.alpha, c.alpha), beta_2 = product(c.beta, c.beta);
  Poles by_s3 = raised(product(product(alpha_2, c.alpha), third), n) +
                raised(product(c.h, out), n) + raised(product(c.k, along), n);
  by_s3 += 3 * raised(product(product(alpha_2, c.beta), derivative(second)), n);
  by_s3 += 3 * raised(product(product(c.alpha, c.p), second), n);
  by_s3 += 3 * raised(product(product(c.alpha, c.q), derivative(out)), n);
  by_s3 += 3 * raised(product(product(c.beta, c.p), derivative(out)), n);
  if (n > 1) {
    by_s3 += 3 * raised(product(product(c.alpha, beta_2), derivative(derivative(out))), n);
    by_s3 += 3 * raised(product(product(c.beta, c.q), derivative(along)), n);
  }
  if (n > 2) by_s3 += raised(product(product(beta_2, c.beta), derivative(derivative(along))), n);
  q[3] = 3 * q[2] - 3 * q[1] + q[0] + by_s3 / (l * (l - 1) * (l - 2));
  return q;
}

double squaredMove(const Rows& from, const Rows& to, int order) {
  double sum = 0;
  for (int i = 0; i <= order; ++i) sum += (to[i] - from[i]).squaredNorm();
  return sum;
}

Rows moved(const Rows& rows, double size, std::mt19937_64& random) {
  Rows result = rows;
  for (Poles& row : result)
    for (Eigen::Index j = 0; j < row.rows(); ++j)
      row.row(j) += size * test::randomVector(random).transpose();
  return result;
}

ConnectionFunctions moved(const ConnectionFunctions& connection, double size,
                          std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  ConnectionFunctions result = connection;
  for (Eigen::VectorXd* f :
       {&result.alpha, &result.beta, &result.p, &result.q, &result.h, &result.k})
    for (double& coefficient : *f) coefficient += size * normal(random);
  return result;
}

TEST(NearestJoin, HoldsAlongTheWholeSeamAndIsNearest) {  // (1), (2)
  std::mt19937_64 random(testSeed());
  std::uniform_int_distribution<int> across(3, 5);
  for (int round = 0; round < 240; ++round) {
    const int order = 1 + round % 3, still = round / 3 % 3, along = 2 + round / 9 % 6;
    const StripShape left{across(random), along}, right{across(random), along};
    const Pair pair = randomPair(left, right, still, random);
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    SCOPED_TRACE("round " + std::to_string(round));
    ASSERT_EQ(join.status, NearestStatus::Joined);
    EXPECT_LT(join.stationarity, 1e-10);
    expectJoined(join, pair, order);
    EXPECT_EQ(join.a == pair.a.surface, still == 1);
    EXPECT_EQ(join.b == pair.b.surface, still == 2);
  }
}

// The joins near the result, built from rows of a and connection functions by another way, are all
// farther.
TEST(NearestJoin, NoJoinNearbyIsNearer) {  // (2)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 60; ++round) {
    const int order = 1 + round % 3, along = 2 + round / 6 % 6;
    const bool both = round / 3 % 2;
    const StripShape shape{3, along};
    JoinSide a{strip(shape, -1, 0.1, random)}, b{strip(shape, 1, 0.1, random)};
    a.moves = both;
    const NearestJoin join = nearestJoin(a, b, {.order = order});
    const Rows at_a = rowsOf(a.surface), at_b = rowsOf(b.surface), to_a = rowsOf(join.a);
    const auto cost = [&](const Rows& rows, const ConnectionFunctions& connection) {
      return squaredMove(at_a, rows, order) +
             squaredMove(at_b, continued(rows, 3, 3, connection, order), order);
    };
    const double least = cost(to_a, join.connection);
    EXPECT_NEAR(join.cost, least, 1e-10 * least);
    for (int k = 0; k < 10; ++k) {
      const double size = 1e-4;
      const Rows rows = both ? moved(to_a, size, random) : to_a;
      const ConnectionFunctions connection = moved(join.connection, size, random);
      Rows opposite = to_a;
      for (int i = 0; i < 4; ++i) opposite[i] = 2 * to_a[i] - rows[i];
      ConnectionFunctions against = join.connection;
      for (const auto f :
           {&ConnectionFunctions::alpha, &ConnectionFunctions::beta, &ConnectionFunctions::p,
            &ConnectionFunctions::q, &ConnectionFunctions::h, &ConnectionFunctions::k})
        against.*f = 2 * join.connection.*f - connection.*f;
      const double one = cost(rows, connection) - least, other = cost(opposite, against) - least;
      EXPECT_GT(one, 0);
      EXPECT_GT(other, 0);
      // A slope would make a difference of first order, 1e-4.
      EXPECT_LT(std::abs(one - other), 0.1 * (one + other));
    }
  }
}

TEST(NearestJoin,
     AHeldConnectionNearbyCostsMore) {  // (2), with weights, fixed poles, rational surfaces and
                                        // knots
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> weight(0.2, 5);
  for (int round = 0; round < 48; ++round) {
    const int order = 1 + round % 2;
    const bool rational = round / 2 % 2, knots = round / 4 % 2;
    const StripShape shape{3, 3, knots ? std::vector<double>{0.4, 0.4, 0.4} : std::vector<double>{},
                           rational};
    Pair pair = randomPair(shape, shape, round / 8 % 3, random);
    for (JoinSide* side : {&pair.a, &pair.b}) {
      side->weights.resize(side->surface.poles.rows());
      for (double& w : side->weights) w = weight(random);
      side->fixed.assign(side->surface.poles.rows(), false);
    }
    // A pole of a that stays, unless b does: then three conditions may ask for a negative alpha.
    const SurfaceDirection across =
        along(pair.a.edge) == SurfaceDirection::U ? SurfaceDirection::V : SurfaceDirection::U;
    const int columns = pair.a.surface.countV();
    const bool at_end = pair.a.edge == PatchEdge::U1 || pair.a.edge == PatchEdge::V1;
    const int row = pair.b.moves ? round % 3 : 3, from_begin = at_end ? 3 - row : row;
    pair.a.fixed[across == SurfaceDirection::U ? from_begin * columns + 1 : columns + from_begin] =
        true;
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    SCOPED_TRACE("round " + std::to_string(round));
    ASSERT_EQ(join.status, NearestStatus::Joined);
    expectJoined(join, pair, order, 10);
    for (int k = 0; k < 4; ++k) {
      ConnectionFunctions held = moved(join.connection, 1e-3, random);
      held.e0.setOnes();
      if (rational) {
        held.e1 = (join.connection.e1.array() / join.connection.e0(0) + 1e-4 * (k - 1.5)).matrix();
        held.e2 = join.connection.e2 / join.connection.e0(0);
        held.e3 = join.connection.e3 / join.connection.e0(0);
      }
      const NearestJoin other = nearestJoin(pair.a, pair.b, {.order = order, .held = held});
      if (other.status == NearestStatus::Infeasible)
        continue;  // the fixed pole asks for the connection
      EXPECT_EQ(other.status, NearestStatus::Joined);
      EXPECT_GT(other.cost, join.cost * (1 - 1e-12));
    }
  }
}

TEST(NearestJoin, RigidMotionAndScaleMoveTheResultLikewise) {  // (3)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 24; ++round) {
    const int order = 1 + round % 3;
    const StripShape shape{3, 3, {}, round / 2 % 2 == 1};
    Pair pair = randomPair(shape, shape, round / 4 % 3, random);
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    const double scale = test::logUniform(random, -3, 3);
    const Eigen::Matrix3d map = scale * test::randomRotation(random);
    const Vec translation = 10 * scale * test::randomVector(random);
    for (JoinSide* side : {&pair.a, &pair.b})
      side->surface = test::mapped(side->surface, map, translation);
    const NearestJoin other = nearestJoin(pair.a, pair.b, {.order = order});
    EXPECT_EQ(other.status, NearestStatus::Joined);
    EXPECT_LT(largestDifference(other.a, test::mapped(join.a, map, translation)), 1e-9 * scale);
    EXPECT_LT(largestDifference(other.b, test::mapped(join.b, map, translation)), 1e-9 * scale);
    EXPECT_NEAR(other.largest_move_mm, scale * join.largest_move_mm, 1e-9 * scale);
    EXPECT_NEAR(other.cost, scale * scale * join.cost, 1e-9 * scale * scale * join.cost);
    EXPECT_NEAR(other.connection.alpha(0), join.connection.alpha(0), 1e-9);
  }
}

TEST(NearestJoin, ReversalOfTheSeamChangesNoPole) {  // (4)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 24; ++round) {
    const int order = 1 + round % 3;
    const StripShape shape{
        3, 3, round / 4 % 2 ? std::vector<double>{0.3, 0.3, 0.3} : std::vector<double>{}};
    Pair pair = randomPair(shape, shape, round / 8 % 3, random);
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    pair.a.reversed = pair.b.reversed = true;
    const NearestJoin other = nearestJoin(pair.a, pair.b, {.order = order});
    EXPECT_LT(largestDifference(join.a, other.a), 1e-10);
    EXPECT_LT(largestDifference(join.b, other.b), 1e-10);
    EXPECT_LT((join.connection.beta + other.connection.beta.reverse()).norm(), 1e-10);
    EXPECT_LT((join.connection.q + other.connection.q.reverse()).norm(), 1e-9);
    EXPECT_LT((join.connection.p - other.connection.p).norm(), 1e-9);
  }
}

TEST(NearestJoin, SwappingTheSidesChangesNoPole) {  // (5)
  std::mt19937_64 random(testSeed());
  int elsewhere = 0;  // searches for G3 that end in another local minimum
  for (int round = 0; round < 24; ++round) {
    const int order = 1 + round % 3;
    const StripShape shape{3, 4, {}, round / 2 % 2 == 1};
    Pair pair = randomPair(shape, {4, 4, {}, shape.rational}, round / 4 % 3, random);
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    const NearestJoin other = nearestJoin(pair.b, pair.a, {.order = order});
    if (order == 3 && std::abs(join.cost - other.cost) > 1e-6 * join.cost) {
      ++elsewhere;
      continue;
    }
    // Weights of b count relative to the seam of a, which scales all alike.
    EXPECT_LT(largestDifference(join.a, other.b), 1e-9);
    EXPECT_LT(largestDifference(join.b, other.a), 1e-9);
    const double alpha = join.connection.alpha(0);
    EXPECT_NEAR(other.connection.alpha(0), 1 / alpha, 1e-9);
    EXPECT_LT((other.connection.beta - join.connection.beta / alpha).norm(), 1e-9);
  }
  EXPECT_LE(elsewhere, 2);
}

TEST(NearestJoin, ASecondCallChangesNothing) {  // (6)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 72; ++round) {
    const int order = 1 + round % 3;
    const StripShape shape{3, 3 + round % 3,
                           round / 4 % 2 ? std::vector<double>{0.3, 0.7} : std::vector<double>{},
                           round / 2 % 2 == 1};
    Pair pair = randomPair(shape, shape, round / 8 % 3, random);
    const Vec far = 1000 * test::randomVector(random);
    for (JoinSide* side : {&pair.a, &pair.b})
      side->surface = test::mapped(side->surface, Eigen::Matrix3d::Identity(), far);
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    ASSERT_EQ(join.status, NearestStatus::Joined);
    pair.a.surface = join.a;
    pair.b.surface = join.b;
    const NearestJoin again = nearestJoin(pair.a, pair.b, {.order = order});
    EXPECT_EQ(again.status, NearestStatus::Unchanged);
    EXPECT_EQ(again.a, join.a);
    EXPECT_EQ(again.b, join.b);
    EXPECT_EQ(again.largest_move_mm, 0);
    EXPECT_LT((again.connection.alpha - join.connection.alpha).norm(), 1e-9);
    pair.a.moves = pair.b.moves = false;
    EXPECT_EQ(nearestJoin(pair.a, pair.b, {.order = 1}).status, NearestStatus::Unchanged);
  }
}

TEST(NearestJoin, AJoinOfHigherDegreeIsLeftAsItIs) {  // (6)
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3}, -1, 0.1, random)}, b{strip({3, 5}, 1, 0.1, random)};
  a.surface = elevated(elevated(a.surface, SurfaceDirection::V), SurfaceDirection::V);
  a.moves = false;
  ConnectionFunctions held;
  held.alpha = Eigen::Vector3d(0.9, 1.1, 1);
  held.beta = Eigen::Vector3d(0.1, -0.2, 0.2);
  const NearestJoin join = nearestJoin(a, b, {.held = held});
  ASSERT_EQ(join.status, NearestStatus::Joined);
  b.surface = join.b;
  a.moves = true;
  const NearestJoin again = nearestJoin(a, b);
  EXPECT_EQ(again.status, NearestStatus::Unchanged);
  EXPECT_EQ(again.b, b.surface);
  EXPECT_EQ(again.connection.alpha.size(), 3);
  EXPECT_NEAR(again.connection.alpha(1), 1.1, 1e-10);
}

TEST(NearestJoin, HigherDegreesOfTheConnectionMoveNoFarther) {
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 20; ++round) {
    const int order = 1 + round % 3;
    Pair pair = randomPair({3, 3}, {3, 3}, round / 2 % 3, random);
    for (JoinSide* side : {&pair.a, &pair.b})
      for (int k = 0; k < 2 * order; ++k)
        side->surface = elevated(side->surface, along(side->edge));
    const NearestJoin natural = nearestJoin(pair.a, pair.b, {.order = order});
    const NearestJoin higher = nearestJoin(
        pair.a, pair.b,
        {.order = order, .degree_alpha = 1, .degree_beta = 2, .degree_p = 2, .degree_q = 3});
    EXPECT_EQ(higher.status, NearestStatus::Joined);
    EXPECT_LE(higher.cost, natural.cost * (1 + 1e-12));
    expectJoined(higher, pair, order, 10);
  }
}

}  // namespace
}  // namespace seamwright
