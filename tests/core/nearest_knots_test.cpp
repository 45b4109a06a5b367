// SPDX-License-Identifier: LGPL-2.1-or-later
// Joins of surfaces with different degrees, knots and parameters along the seam.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <tuple>

#include "spline_surfaces.hpp"
#include "support/random.hpp"

#include <seamwright/core/bspline/refinement.hpp>
#include <seamwright/core/seam/bspline_side.hpp>

namespace seamwright {
namespace {

using test::largestDifference, test::strip, test::StripShape, test::turned, test::Vec;

constexpr PatchEdge edges[] = {PatchEdge::U0, PatchEdge::U1, PatchEdge::V0, PatchEdge::V1};

std::vector<double>& knotsAlong(JoinSide& side) {
  return along(side.edge) == SurfaceDirection::V ? side.surface.knots_v : side.surface.knots_u;
}

/// The same surface over first..last along the seam.
void setRange(JoinSide& side, double first, double last) {
  for (double& knot : knotsAlong(side)) knot = first + knot * (last - first);
}

/// The same surface, run backwards along the seam.
void turnBack(JoinSide& side) {
  const bool by_v = along(side.edge) == SurfaceDirection::V;
  BSplineSurface& s = side.surface;
  const BSplineSurface given = s;
  const int nu = s.countU(), nv = s.countV();
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j)
      s.poles.row(i * nv + j) = given.poles.row(by_v ? i * nv + nv - 1 - j : (nu - 1 - i) * nv + j);
  std::vector<double>& knots = knotsAlong(side);
  const double sum = knots.front() + knots.back();
  std::ranges::reverse(knots);
  for (double& knot : knots) knot = sum - knot;
  side.reversed = !side.reversed;
}

std::vector<double> randomKnots(int degree, std::mt19937_64& random) {
  std::uniform_real_distribution<double> place(0.02, 0.98);
  std::uniform_int_distribution<int> number(0, 4), repeats(1, degree);
  std::vector<double> knots;
  for (int k = number(random); k > 0; --k) {
    const double knot = std::round(32 * place(random)) / 32;  // so that some coincide
    if (std::ranges::count(knots, knot) == 0) knots.insert(knots.end(), repeats(random), knot);
  }
  std::ranges::sort(knots);
  return knots;
}

struct Pair {
  JoinSide a, b;
};

/// Sides of different degrees, knots, ranges, edges and senses that nearly meet.
Pair randomPair(std::mt19937_64& random, bool rational = false) {
  std::uniform_int_distribution<int> degree(2, 4), edge(0, 3), coin(0, 1);
  std::uniform_real_distribution<double> begin(-3, 3), end(4, 50);
  Pair pair;
  for (JoinSide* side : {&pair.a, &pair.b}) {
    const int along = degree(random);
    side->edge = edges[edge(random)];
    side->surface = turned(strip({3, along, randomKnots(along, random), rational},
                                 side == &pair.a ? -1 : 1, 0.05, random),
                           side->edge);
    setRange(*side, begin(random), end(random));
    if (coin(random) == 1) turnBack(*side);
  }
  return pair;
}

void expectJoined(const NearestJoin& join, const Pair& given, int order) {
  ContinuityTolerance tight;
  tight.gap_mm = 1e-10;
  tight.angle_rad = 1e-9;
  tight.curvature_rel = 1e-7;
  const SeamFigures figures = encloseSeam(seamSide(join.a, given.a.edge, given.a.reversed),
                                          seamSide(join.b, given.b.edge, given.b.reversed), tight);
  EXPECT_TRUE(figures.certified);
  EXPECT_LT(figures.gap_mm->upper.value(), 1e-10);
  EXPECT_LT(figures.angle_rad->upper.value(), 1e-9);
  if (order == 2) {
    EXPECT_LT(figures.curvature_per_mm->upper.value(), 1e-6);
  }
}

void expectNear(const NearestJoin& join, const NearestJoin& other, double tolerance) {
  ASSERT_EQ(join.a.poles.rows(), other.a.poles.rows());
  ASSERT_EQ(join.b.poles.rows(), other.b.poles.rows());
  EXPECT_LT(largestDifference(join.a, other.a), tolerance);
  EXPECT_LT(largestDifference(join.b, other.b), tolerance);
}

TEST(NearestKnots, AnyDegreesKnotsRangesAndSensesJoin) {
  std::mt19937_64 random(testSeed());
  int not_found = 0;  // of rational sides with weights that are far from each other
  for (int round = 0; round < 36; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const int order = 1 + round % 2;
    const bool rational = round / 6 % 3 == 2;
    Pair pair = randomPair(random, rational);
    pair.a.moves = round / 2 % 3 != 1;
    pair.b.moves = round / 2 % 3 != 2;
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    if (rational && join.status != NearestStatus::Joined) {
      ++not_found;
      continue;
    }
    ASSERT_EQ(join.status, NearestStatus::Joined);
    expectJoined(join, pair, order);
    for (const auto& [side, surface, change] :
         {std::tuple(pair.a, join.a, join.change_a), std::tuple(pair.b, join.b, join.change_b)}) {
      JoinSide after = side;
      after.surface = surface;
      if (!side.moves) {
        EXPECT_EQ(surface, side.surface);
        EXPECT_TRUE(change.added_knots.empty());
        continue;
      }
      JoinSide before = side;
      for (int k = 0; k < change.raised_degree; ++k)
        before.surface = elevated(before.surface, along(side.edge));
      EXPECT_EQ(withKnots(before.surface, along(side.edge), change.added_knots).knots_u,
                surface.knots_u);
      EXPECT_EQ(withKnots(before.surface, along(side.edge), change.added_knots).knots_v,
                surface.knots_v);
    }
  }
  EXPECT_LE(not_found, 3);
}

TEST(NearestKnots, AnotherRangeOfOneSideChangesNoPole) {  // (7)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 12; ++round) {
    Pair pair = randomPair(random);
    const NearestJoin join = nearestJoin(pair.a, pair.b);
    for (double& knot : knotsAlong(pair.b)) knot = 1000 + 0.37 * knot;
    const NearestJoin other = nearestJoin(pair.a, pair.b);
    expectNear(join, other, 1e-9);
    ASSERT_EQ(join.change_b.added_knots.size(), other.change_b.added_knots.size());
    for (std::size_t i = 0; i < join.change_b.added_knots.size(); ++i)
      EXPECT_NEAR(1000 + 0.37 * join.change_b.added_knots[i], other.change_b.added_knots[i], 1e-12);
  }
}

/// The sum of squared moves from a surface to the result, over the poles of the result.
double squaredMove(const JoinSide& side, const BSplineSurface& joined, const SeamChange& change) {
  BSplineSurface before = side.surface;
  for (int k = 0; k < change.raised_degree; ++k) before = elevated(before, along(side.edge));
  before = withKnots(before, along(side.edge), change.added_knots);
  return (before.poles - joined.poles).squaredNorm();
}

TEST(NearestKnots, KnotsInsertedBeforehand) {  // (7)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const Pair given = randomPair(random);
    const NearestJoin join = nearestJoin(given.a, given.b);
    EXPECT_NEAR(
        join.cost,
        squaredMove(given.a, join.a, join.change_a) + squaredMove(given.b, join.b, join.change_b),
        1e-9 * join.cost);
    // Those of the other side: the same join.
    Pair pair = given;
    for (int k = 0; k < join.change_a.raised_degree; ++k)
      pair.a.surface = elevated(pair.a.surface, along(pair.a.edge));
    pair.a.surface = withKnots(pair.a.surface, along(pair.a.edge), join.change_a.added_knots);
    const NearestJoin same = nearestJoin(pair.a, pair.b);
    EXPECT_TRUE(same.change_a.added_knots.empty());
    expectNear(join, same, 1e-10);
    // Further ones: the coarse result is one of the joins among which the finer one is the nearest.
    const double range = knotsAlong(pair.a).back() - knotsAlong(pair.a).front(),
                 knot = knotsAlong(pair.a).front() + 0.41 * range;
    pair.a.surface = withKnots(pair.a.surface, along(pair.a.edge), {knot});
    const NearestJoin finer = nearestJoin(pair.a, pair.b);
    ASSERT_NE(finer.status, NearestStatus::Infeasible);
    const BSplineSurface coarse_a = withKnots(join.a, along(given.a.edge), {knot});
    const double other_knot =
        finer.change_b.added_knots.size() > join.change_b.added_knots.size()
            ? *std::ranges::find_if(
                  finer.change_b.added_knots,
                  [&](double k) { return std::ranges::count(join.change_b.added_knots, k) == 0; })
            : 0;
    const BSplineSurface coarse_b = withKnots(join.b, along(given.b.edge), {other_knot});
    EXPECT_LE(finer.cost,
              (squaredMove(pair.a, coarse_a, {}) + squaredMove(given.b, coarse_b, finer.change_b)) *
                  (1 + 1e-9));
  }
}

TEST(NearestKnots, SwappingTheSidesChangesNoPole) {  // (5)
  std::mt19937_64 random(testSeed());
  int elsewhere = 0;  // searches that end in another local minimum
  for (int round = 0; round < 24; ++round) {
    const Pair pair = randomPair(random);
    const NearestJoin join = nearestJoin(pair.a, pair.b), other = nearestJoin(pair.b, pair.a);
    if (std::abs(join.cost - other.cost) > 1e-6 * join.cost) {
      ++elsewhere;
      continue;
    }
    NearestJoin swapped = join;
    swapped.a = other.b;
    swapped.b = other.a;
    expectNear(join, swapped, 1e-8);
    EXPECT_EQ(join.change_a.added_knots, other.change_b.added_knots);
  }
  EXPECT_LE(elsewhere, 2);
}

TEST(NearestKnots, KnotsThatNearlyCoincideAreOne) {
  std::mt19937_64 random(testSeed());
  std::uniform_int_distribution<int> repeats(1, 3);
  for (int round = 0; round < 36; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double off = std::array{0.0, 1e-15, -1e-15, 1e-12, -1e-12, 4e-10}[round % 6];
    const int in_a = repeats(random), in_b = repeats(random), order = 1 + round / 6 % 2;
    const std::vector<double> of_a(in_a, 0.3), of_b(in_b, 0.3 + off);
    Pair pair{{strip({3, 3, of_a}, -1, 0.05, random)}, {strip({3, 3, of_b}, 1, 0.05, random)}};
    pair.a.moves = round / 12 != 1;
    pair.b.moves = round / 12 != 2;
    if (round % 5 == 0) setRange(pair.b, 100, 101);
    const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = order});
    ASSERT_EQ(join.status, NearestStatus::Joined);
    expectJoined(join, pair, order);
    for (const BSplineSurface* surface : {&join.a, &join.b})
      for (std::size_t k = 1; k < surface->knots_v.size(); ++k)
        if (const double span = surface->knots_v[k] - surface->knots_v[k - 1]; span != 0) {
          EXPECT_GT(span, 0.2);
        }
    const double moved = std::max(join.change_a.moved_knots, join.change_b.moved_knots);
    EXPECT_NEAR(moved, std::abs(off) > 1e-13 ? std::abs(off) : 0, 1e-13);
    EXPECT_EQ(join.change_a.added_knots.size(), pair.a.moves ? std::max(0, in_b - in_a) : 0);
    EXPECT_EQ(join.change_b.added_knots.size(), pair.b.moves ? std::max(0, in_a - in_b) : 0);
  }
}

TEST(NearestKnots, SidesThatAgreeKeepKnotsAndFixedBits) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3, {0.2, 0.6}}, -1, 0.05, random)},
      b{strip({3, 3, {0.2, 0.6}}, 1, 0.05, random)};
  const NearestJoin join = nearestJoin(a, b);
  for (double& knot : b.surface.knots_v) knot *= 2;
  const NearestJoin other = nearestJoin(a, b);
  EXPECT_EQ(join.a, other.a);
  EXPECT_EQ(join.b.poles, other.b.poles);
  EXPECT_EQ(other.b.knots_v, b.surface.knots_v);
  EXPECT_TRUE(other.change_a.added_knots.empty() && other.change_b.added_knots.empty());
}

TEST(NearestKnots, UnchangedWhereTheJoinHoldsOverOtherKnots) {
  std::mt19937_64 random(testSeed());
  Pair pair = randomPair(random);
  const NearestJoin join = nearestJoin(pair.a, pair.b, {.order = 2});
  pair.a.surface = join.a;
  pair.b.surface = elevated(join.b, along(pair.b.edge));
  const double middle = (knotsAlong(pair.a).front() + knotsAlong(pair.a).back()) / 2;
  pair.a.surface = withKnots(pair.a.surface, along(pair.a.edge), {middle});
  const NearestJoin again = nearestJoin(pair.a, pair.b, {.order = 2});
  EXPECT_EQ(again.status, NearestStatus::Unchanged);
  EXPECT_EQ(again.a, pair.a.surface);
  EXPECT_EQ(again.b, pair.b.surface);
}

TEST(NearestKnots, PolesThatStay) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3, {0.25, 0.75}}, -1, 0.05, random)},
      b{strip({3, 4, {0.5}}, 1, 0.05, random)};
  a.edge = PatchEdge::U0;
  const int columns = a.surface.countV();
  a.fixed.assign(a.surface.poles.rows(), false);
  // Position and first derivatives along the seam at its begin.
  for (const int row : {0, 1}) a.fixed[row * columns] = a.fixed[row * columns + 1] = true;
  const NearestJoin join = nearestJoin(a, b);
  ASSERT_EQ(join.status, NearestStatus::Joined);
  const BSplineSurface before = withKnots(elevated(a.surface, SurfaceDirection::V),
                                          SurfaceDirection::V, join.change_a.added_knots);
  for (const int row : {0, 1})
    for (const int column : {0, 1})
      EXPECT_EQ(join.a.poles.row(row * before.countV() + column),
                before.poles.row(row * before.countV() + column));
  EXPECT_EQ(join.a.poles.row(0), a.surface.poles.row(0));
  // A pole between others that move: all new poles near it depend on these.
  a.fixed.assign(a.surface.poles.rows(), false);
  a.fixed[columns + 2] = true;
  EXPECT_THAT([&] { nearestJoin(a, b); },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::HasSubstr("pole 2 along the seam, 1 across it, of surface a")));
  // Rows behind those of the join never move.
  a.fixed.assign(a.surface.poles.rows(), false);
  a.fixed[2 * columns + 2] = true;
  EXPECT_EQ(nearestJoin(a, b).status, NearestStatus::Joined);
  // All poles stay: only b moves, as if a did not.
  a.fixed.assign(a.surface.poles.rows(), true);
  const NearestJoin all = nearestJoin(a, b);
  a.moves = false;
  EXPECT_EQ(all.b, nearestJoin(a, b).b);
}

/// The matrix from given poles to those of the degree and knots that a side got along v.
Eigen::MatrixXd sharesOf(const BSplineSurface& given, const SeamChange& change) {
  const int count = given.countV();
  Eigen::MatrixXd shares;
  for (int j = 0; j < count; ++j) {
    BSplineSurface unit = given;
    unit.poles.leftCols<3>().setZero();
    for (int i = 0; i < given.countU(); ++i) unit.poles(i * count + j, 0) = 1;
    for (int k = 0; k < change.raised_degree; ++k) unit = elevated(unit, SurfaceDirection::V);
    unit = withKnots(unit, SurfaceDirection::V, change.added_knots);
    shares.conservativeResize(unit.countV(), j + 1);
    shares.col(j) = unit.poles.col(0).head(unit.countV());
  }
  return shares;
}

// A pole stays if the new poles that depend on fixed ones alone determine it.
TEST(NearestKnots, PolesThatCannotStayAreRefused) {
  std::mt19937_64 random(testSeed());
  int kept = 0, refused = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const int degree = 2 + round % 3, columns_b = 2 + round / 3 % 4;
    JoinSide a{strip({3, degree, randomKnots(degree, random)}, -1, 0.02, random)};
    JoinSide b{strip({3, columns_b, randomKnots(columns_b, random)}, 1, 0.02, random)};
    const Eigen::MatrixXd shares = sharesOf(a.surface, nearestJoin(a, b).change_a);
    const int columns = a.surface.countV();
    a.fixed.assign(a.surface.poles.rows(), false);
    std::bernoulli_distribution often(0.6);
    for (int j = 0; j < columns; ++j) a.fixed[columns + j] = often(random);
    Eigen::MatrixXd staying(0, columns);
    for (Eigen::Index i = 0; i < shares.rows(); ++i) {
      bool stays = true;
      for (int j = 0; j < columns; ++j)
        stays = stays && (shares(i, j) == 0 || a.fixed[columns + j]);
      if (!stays) continue;
      staying.conservativeResize(staying.rows() + 1, Eigen::NoChange);
      staying.bottomRows(1) = shares.row(i);
    }
    const auto rankWith = [&](int j) {
      Eigen::MatrixXd more(staying.rows() + 1, columns);
      more << staying, Eigen::RowVectorXd::Unit(columns, j);
      return more.fullPivLu().rank();
    };
    bool determined = true;
    for (int j = 0; j < columns; ++j)
      if (a.fixed[columns + j])
        determined = determined && staying.rows() > 0 && rankWith(j) == staying.fullPivLu().rank();
    if (determined) {
      EXPECT_NO_THROW(nearestJoin(a, b, {.max_iterations = 0}));
    } else {
      EXPECT_THROW(nearestJoin(a, b, {.max_iterations = 0}), std::invalid_argument);
    }
    ++(determined ? kept : refused);
  }
  EXPECT_GT(kept, 8);
  EXPECT_GT(refused, 8);
}

TEST(NearestKnots, WeightsAreMeansOfThoseGiven) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3, {0.25}}, -1, 0.05, random)}, b{strip({3, 3, {0.5}}, 1, 0.05, random)};
  const NearestJoin plain = nearestJoin(a, b);
  a.weights = Eigen::VectorXd::Ones(a.surface.poles.rows());
  expectNear(plain, nearestJoin(a, b), 1e-12);
  a.weights.setConstant(1e6);
  const NearestJoin join = nearestJoin(a, b);
  EXPECT_LT(squaredMove(a, join.a, join.change_a), 1e-8);
  // Halves of the range with other weights: the poles over the costly half move less.
  for (Eigen::Index i = 0; i < a.weights.size(); ++i)
    a.weights(i) = i % a.surface.countV() < 2 ? 1e6 : 1;
  const NearestJoin half = nearestJoin(a, b);
  const BSplineSurface before =
      withKnots(a.surface, SurfaceDirection::V, half.change_a.added_knots);
  EXPECT_LT((half.a.poles.row(0) - before.poles.row(0)).norm(), 1e-5);
  EXPECT_GT((half.a.poles - before.poles).rowwise().norm().maxCoeff(), 1e-3);
}

/// The same surface with the parameter t = c u / (1 - u + c u) along v.
BSplineSurface atOtherSpeed(const BSplineSurface& surface, double c) {
  BSplineSurface result = surface;
  for (double& knot : result.knots_v) knot = knot / (c * (1 - knot) + knot);
  const int nv = surface.countV();
  for (Eigen::Index i = 0; i < surface.poles.rows(); ++i)
    for (int k = 1; k <= surface.degree_v; ++k)
      result.poles.row(i) *= 1 + (c - 1) * result.knots_v[i % nv + k];
  return result;
}

TEST(NearestKnots, ALinearRationalParameterIsFound) {
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 16; ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double c = test::logUniform(random, -0.5, 0.5);
    const std::vector<double> of_a = {0.25}, of_b = {0.5};
    StripShape left{3, 3, of_a}, right{3, 3, round % 2 ? of_b : of_a};
    JoinSide a{strip(left, -1, 0.05, random)}, b{strip(right, 1, 0.05, random)};
    if (round / 4 % 2) {  // both rational, the seams with the same weights
      const std::vector<double> weights = {1, 1.2, 0.9, 1.1, 1};
      if (round % 2) continue;
      for (JoinSide* side : {&a, &b})
        for (Eigen::Index i = 0; i < side->surface.poles.rows(); ++i)
          side->surface.poles.row(i) *= weights[i % 5];
    }
    a.moves = round / 2 % 2 == 0;
    const NearestJoin plain = nearestJoin(a, b);
    ASSERT_EQ(plain.status, NearestStatus::Joined);
    const BSplineSurface given = b.surface;
    b.surface = atOtherSpeed(given, c);
    for (const double u : {0.0, 0.2, 0.7, 1.0})
      ASSERT_LT((jet(b.surface, 0.3, u).p - jet(given, 0.3, c * u / (1 - u + c * u)).p).norm(),
                1e-12);
    const NearestJoin join = nearestJoin(a, b);
    ASSERT_EQ(join.status, NearestStatus::Joined);
    ASSERT_TRUE(join.parameter_of_b);
    for (const double t : {0.0, 0.3, 0.6, 1.0}) {
      const double of_b_there = join.parameter_of_b->at(t);
      EXPECT_NEAR(t, c * of_b_there / (1 - of_b_there + c * of_b_there), 1e-12);
      const SurfaceJet p = jet(join.a, 0, t), q = jet(join.b, 0, of_b_there);
      EXPECT_LT((p.p - q.p).norm(), 1e-11);
      EXPECT_LT(p.u.cross(p.v).normalized().cross(q.u.cross(q.v).normalized()).norm(), 1e-10);
      EXPECT_LT((jet(plain.b, 0.2, t).p - jet(join.b, 0.2, of_b_there).p).norm(), 1e-6);
    }
    b.surface = given;
    EXPECT_FALSE(nearestJoin(a, b).parameter_of_b);
  }
}

TEST(NearestKnots, ASideAtAnotherSpeedThatStaysKeepsEveryBit) {
  std::mt19937_64 random(testSeed());
  JoinSide a{strip({3, 3, {0.25}}, -1, 0.05, random)}, b{strip({3, 3}, 1, 0.05, random)};
  b.surface = atOtherSpeed(b.surface, 1.7);
  b.fixed.assign(b.surface.poles.rows(), false);
  b.fixed[0] = b.fixed[4] = true;
  const NearestJoin join = nearestJoin(a, b);
  ASSERT_EQ(join.status, NearestStatus::Joined);
  ASSERT_TRUE(join.parameter_of_b);
  EXPECT_EQ(join.b.poles.row(0), b.surface.poles.row(0));
  EXPECT_EQ(join.b.poles.row(join.b.countV()), b.surface.poles.row(4));
  EXPECT_EQ(
      join.b.poles.bottomRows(10),
      withKnots(b.surface, SurfaceDirection::V, join.change_b.added_knots).poles.bottomRows(10));
  b.moves = false;
  EXPECT_EQ(nearestJoin(a, b).b, b.surface);
}

}  // namespace
}  // namespace seamwright
