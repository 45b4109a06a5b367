// SPDX-License-Identifier: LGPL-2.1-or-later
// Joins of alpha-surfaces that are fitted, and the nearest ones: against what was built, neighbours
// and the data of 60 digits.
#include <gmock/gmock.h>

#include <array>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/spline/alpha_join_condition.hpp>

#include "alphas.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::balance;
using test::randomSurface;
using test::uniform;
using test::Vec;
using testing::HasSubstr;

AlphaJoin randomJoin(int order, double a_v, std::mt19937_64& random) {
  return {order,
          uniform(0.5, 1.5, random),
          uniform(-1, 1, random),
          uniform(0.5, 2, random),
          uniform(0.5, 2, random),
          uniform(0.2, 1, random),
          a_v};
}

TEST(AlphaJoinCondition, Identity7TheFitFindsWhatWasBuilt) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 800; ++i) {
    AlphaSurface given = randomSurface(random);
    const int order = 1 + i % 2;
    balance(given, 2);
    AlphaJoin join = randomJoin(order, i % 3 ? given.a_v : uniform(0.2, 1, random), random);
    if (i % 5 == 0) {
      join.beta1 = 1;
      join.beta2 = 0;
    }
    AlphaSurface next = randomSurface(random);
    next.a_u = join.next_a_u;
    next.a_v = join.next_a_v;
    const Poles rows = alphaJoinRows(given, join);
    next.poles.topRows(rows.rows()) = rows;
    const auto fitted = [&](const AlphaSurface& surface) {
      return alphaSeamFit(given, surface, join.length, join.next_length);
    };
    const AlphaSeamFit fit = fitted(next);
    EXPECT_EQ(fit.geometric_order, order) << i;
    EXPECT_EQ(fit.parametric_order, i % 5 ? 0 : order) << i;
    EXPECT_NEAR(fit.beta1, join.beta1, 1e-12);
    if (order == 2) {
      EXPECT_NEAR(fit.beta2, join.beta2, 1e-9);
    }
    for (int row = 0; row <= order; ++row) {
      AlphaSurface moved = next;
      moved.poles.row(4 * row + 1 + i % 2) += Eigen::RowVector3d(0.3, -0.5, 0.8) * 1e-5;
      EXPECT_EQ(fitted(moved).geometric_order, row - 1) << i;
    }
  }
}

TEST(AlphaJoinCondition, JoinsOfTheDataFile) {
  int special = 0, count = 0;
  for (const json& entry : test::casesOf("alpha_surface_joins.json")) {
    SCOPED_TRACE(entry["name"].get<std::string>());
    const json &in = entry["in"], &expected = entry["out"]["Q"];
    const std::string kind = in["kind"];
    AlphaSurface given, next;
    for (int k = 0; k < 16; ++k)
      given.poles.row(k) = test::vector(in["P"][k / 4][k % 4]).transpose();
    for (std::size_t k = 0; k < 4 * expected.size(); ++k)
      next.poles.row(static_cast<Eigen::Index>(k)) =
          test::vector(expected[k / 4][k % 4]).transpose();
    given.a_u = in["au1"];
    given.a_v = in["av1"];
    next.a_u = in["au2"];
    next.a_v = in["av2"];
    const int order = kind == "special" ? 2 : std::min(kind[1] - '0', 2);
    EXPECT_EQ(alphaSeamCondition(given, next.a_v).order, 2);
    const AlphaSeamFit fit = alphaSeamFit(given, next, in["h1"], in["h2"]);
    EXPECT_EQ(fit.geometric_order, order);
    EXPECT_NEAR(fit.beta1, in["beta1"].get<double>(), 1e-11 * (1 + fit.beta1));
    AlphaNearestOptions options{order, false, in["h1"], in["h2"]};
    const auto near = alphaNearestJoin(given, next, options);
    ASSERT_TRUE(near.has_value());
    EXPECT_LE(std::sqrt(near->cost_next), 1e-9 * (1 + next.poles.cwiseAbs().maxCoeff()))
        << "nothing moves";
    EXPECT_EQ(near->cost_given, 0);
    special += kind == "special";
    ++count;
  }
  EXPECT_EQ(count, 36);
  EXPECT_GE(special, 3);
}

/// The cost of a join with these betas.
double costOf(const AlphaSurface& given, const AlphaSurface& next, const AlphaNearestOptions& o,
              double beta1, double beta2) {
  const Poles rows =
      alphaJoinRows(given, {o.order, beta1, beta2, o.length, o.next_length, next.a_u, next.a_v});
  return (rows - next.poles.topRows(rows.rows())).squaredNorm();
}

TEST(AlphaJoinCondition, Identity8NothingIsNearer) {
  std::mt19937_64 random(testSeed());
  int none = 0;
  for (int i = 0; i < 600; ++i) {
    AlphaSurface given = randomSurface(random), next = randomSurface(random);
    next.poles.col(0).array() += 9;
    if (i % 3 == 0) next.a_v = given.a_v;
    AlphaNearestOptions options{1 + i % 2, false, uniform(0.5, 2, random), uniform(0.5, 2, random)};
    const auto near = alphaNearestJoin(given, next, options);
    if (!near) {
      ++none;
      const AlphaSurface kept = next.a_v == given.a_v ? given : alphaBalanced(given, 1);
      options.order = 1;
      double before = costOf(kept, next, options, 1e-3, 0);
      for (const double beta1 : {0.01, 0.1, 1.0, 10.0}) {
        EXPECT_GT(costOf(kept, next, options, beta1, 0), before) << "the nearest is beta1 = 0";
        before = costOf(kept, next, options, beta1, 0);
      }
      continue;
    }
    EXPECT_EQ(
        alphaSeamFit(near->given, near->next, options.length, options.next_length).geometric_order,
        options.order);
    EXPECT_EQ(near->cost_given == 0, next.a_v == given.a_v);
    const double least = costOf(near->given, next, options, near->beta1, near->beta2);
    EXPECT_NEAR(near->cost_next, least, 1e-9 * (1 + least));
    for (int k = 0; k < 40; ++k) {
      const double spread = k % 2 ? 1 : 1e-3;
      const double beta1 = near->beta1 * std::exp(spread * uniform(-1, 1, random));
      const double beta2 = near->beta2 + spread * uniform(-5, 5, random);
      EXPECT_GE(costOf(near->given, next, options, beta1, beta2), least * (1 - 1e-12)) << i;
    }
    options.parametric = true;
    const auto plain = alphaNearestJoin(given, next, options);
    EXPECT_EQ(alphaSeamFit(plain->given, plain->next, options.length, options.next_length)
                  .parametric_order,
              options.order);
    EXPECT_GE(plain->cost_next, near->cost_next * (1 - 1e-12));
    options.order = 0;
    const auto edge = alphaNearestJoin(given, next, options);
    EXPECT_LE(alphaSeamFit(edge->given, edge->next).gap_mm, 1e-13 * 20);
    EXPECT_LE(edge->cost_next, plain->cost_next);
    const auto again = alphaNearestJoin(
        near->given, near->next, {options.order = 1, false, options.length, options.next_length});
    EXPECT_EQ(again->cost_given, 0);
    EXPECT_LE(again->cost_next, 1e-22 * next.poles.squaredNorm()) << "what joins stays";
  }
  EXPECT_LT(none, 60);
}

/// The cost at this beta1 with the best beta2: of a parabola.
double costOf(const AlphaSurface& given, const AlphaSurface& next, const AlphaNearestOptions& o,
              double beta1) {
  if (o.order == 1) return costOf(given, next, o, beta1, 0);
  const double unit = (1 + beta1 * beta1) / o.next_length;
  const double left = costOf(given, next, o, beta1, -unit),
               middle = costOf(given, next, o, beta1, 0),
               right = costOf(given, next, o, beta1, unit);
  const double bend = left - 2 * middle + right, slope = (right - left) / 2;
  return middle - slope * slope / (2 * bend);
}

/// Nets whose join has a local minimum at a beta1 > 0 that is costlier than those next to 0.
std::pair<AlphaSurface, AlphaSurface> withLocalMinimum() {
  AlphaSurface given, next;
  const double x[] = {0, 1, 2, 3}, z[] = {0, 1, 0, 0}, next_x[] = {3, 2.9375, 3, 6},
               next_z[] = {0, 0, 0.7, 0};
  for (int k = 0; k < 16; ++k) {
    given.poles.row(k) << x[k / 4], k % 4, z[k / 4];
    next.poles.row(k) << next_x[k / 4], k % 4, next_z[k / 4];
  }
  given.a_u = given.a_v = next.a_u = next.a_v = 0.5;
  return {given, next};
}

TEST(AlphaJoinCondition, Identity8NorNextToBetaZero) {
  std::mt19937_64 random(testSeed());
  int none = 0, costlier = 0;
  for (int i = 0; i < 1500; ++i) {
    AlphaSurface given = randomSurface(random), next = randomSurface(random);
    for (int k = 0; k < 16; ++k) next.poles.row(k) += 2 * test::randomVector(random).transpose();
    next.poles.col(0).array() += uniform(0, 9, random);
    if (i % 6 == 1) {
      std::tie(given, next) = withLocalMinimum();
      for (int k = 0; k < 16; ++k)
        next.poles.row(k) += 0.1 * test::randomVector(random).transpose();
    }
    next.a_v = given.a_v;
    const AlphaNearestOptions options{1 + i % 2, false, uniform(0.5, 2, random),
                                      uniform(0.5, 2, random)};
    const double limit = costOf(given, next, options, 1e-9);
    double least = limit;
    bool dips = false;
    double before = limit;
    for (double beta1 = 1e-4; beta1 < 100; beta1 *= 1.1) {
      const double cost = costOf(given, next, options, beta1);
      least = std::min(least, cost);
      dips = dips || cost < before * (1 - 1e-9);
      before = cost;
    }
    const auto near = alphaNearestJoin(given, next, options);
    if (near) {
      EXPECT_LE(near->cost_next, least * (1 + 1e-9)) << i;
      EXPECT_LE(near->cost_next, limit * (1 + 1e-9)) << i;
    } else {
      EXPECT_GE(least, limit * (1 - 1e-6)) << i << ": no beta1 is nearer than those next to 0";
      ++none;
      costlier += dips;
    }
  }
  EXPECT_GT(none, 50);
  EXPECT_GT(costlier, 2) << "with a local minimum that is costlier";
}

TEST(AlphaJoinCondition, ALocalMinimumIsNotTheNearest) {
  const auto [given, next] = withLocalMinimum();
  const AlphaNearestOptions options{2};
  EXPECT_LT(costOf(given, next, options, 0.32), costOf(given, next, options, 0.2))
      << "one is there";
  EXPECT_LT(costOf(given, next, options, 0.32), costOf(given, next, options, 0.4));
  EXPECT_LT(costOf(given, next, options, 1e-6), costOf(given, next, options, 0.32));
  EXPECT_FALSE(alphaNearestJoin(given, next, options).has_value());
}

TEST(AlphaJoinCondition, SizesAndLengthsBeyondSquares) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    AlphaSurface given = randomSurface(random), next = randomSurface(random);
    next.poles.col(0).array() += 9;
    if (i % 2) next.a_v = given.a_v;
    const AlphaNearestOptions options{1 + i % 2};
    const auto plain = alphaNearestJoin(given, next, options);
    const AlphaSeamFit fit = alphaSeamFit(given, next);
    for (const int exponent : {-560, 560}) {
      AlphaSurface far_given = given, far_next = next;
      far_given.poles *= std::ldexp(1.0, exponent);
      far_next.poles *= std::ldexp(1.0, exponent);
      const auto far = alphaNearestJoin(far_given, far_next, options);
      ASSERT_EQ(far.has_value(), plain.has_value()) << i;
      EXPECT_EQ(alphaSeamCondition(far_given, next.a_v).order,
                alphaSeamCondition(given, next.a_v).order);
      EXPECT_EQ(alphaSeamFit(far_given, far_next).first, fit.first);
      EXPECT_EQ(alphaSeamFit(far_given, far_next).beta2, fit.beta2);
      if (!far) continue;
      EXPECT_EQ(far->beta1, plain->beta1);
      EXPECT_EQ(far->beta2, plain->beta2);
      const AlphaSeamFit joined = alphaSeamFit(far->given, far->next);
      EXPECT_EQ(joined.geometric_order, options.order) << i;
    }
    // Betas go with the lengths: h / k and h / k^2.
    const AlphaSeamFit slow = alphaSeamFit(given, next, 1e-300, 1),
                       fast = alphaSeamFit(given, next, 1e100, 1e-50);
    EXPECT_NEAR(slow.beta1, 1e-300 * fit.beta1, 1e-314);
    EXPECT_NEAR(slow.beta2 / 1e-300, fit.beta2, 1e-13 * std::abs(fit.beta2));
    EXPECT_NEAR(fast.beta2 / 1e200, fit.beta2, 1e-13 * std::abs(fit.beta2));
    EXPECT_NEAR(slow.second, fit.second, 1e-14);
    EXPECT_EQ(slow.parametric_order, fit.gap_mm > fit.noise[0] ? -1 : 0);
    if (!plain) continue;
    const auto other = alphaNearestJoin(given, next, {options.order, false, 1e100, 1e-50});
    EXPECT_NEAR(other->beta1 / 1e150, plain->beta1, 1e-12 * plain->beta1);
    EXPECT_LE((other->next.poles - plain->next.poles).norm(), 1e-11 * plain->next.poles.norm());
  }
  const AlphaSurface given = randomSurface(random);
  AlphaSurface next = randomSurface(random);
  next.a_v = given.a_v;
  EXPECT_THAT(test::complaint([&] { alphaSeamFit(given, next, 1, 1e-300); }),
              HasSubstr("beta2 comes out as"));
  EXPECT_THAT(test::complaint([&] {
                alphaJoinRows(given, {2, 1e200, 0, 1, 1, 1, given.a_v});
              }),
              HasSubstr("pole 8 of the next one comes out as ("));
}

TEST(AlphaJoinCondition, AFamilyIsNoJoinWhereTheEdgesCannotMeet) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 100; ++i) {
    AlphaSurface given = randomSurface(random);
    // X_u is balanced, the edge is not: a first row of another shape exists, an edge does not.
    for (int j = 0; j < 4; ++j)
      given.poles.row(8 + j) = given.poles.row(12 + j) - Eigen::RowVector3d(3, 0, 0);
    const AlphaSeamCondition condition = alphaSeamCondition(given, given.a_v > 0.6 ? 0.3 : 0.9);
    EXPECT_EQ(condition.order, -1);
    ASSERT_EQ(condition.first_rows.cols(), 1);
    EXPECT_NE(condition.first_rows(0, 0), 0);
    EXPECT_FALSE(condition.g1);
  }
}

TEST(AlphaJoinCondition, AFoldHasNoNearestJoin) {
  std::mt19937_64 random(testSeed());
  const AlphaSurface given = randomSurface(random);
  AlphaSurface back = given;
  back.poles = given.poles.colwise().reverse().eval();
  for (int j = 0; j < 4; ++j) back.poles.row(j) = given.poles.row(12 + j);
  for (int j = 0; j < 4; ++j) back.poles.row(4 + j) = given.poles.row(8 + j);
  EXPECT_FALSE(alphaNearestJoin(given, back).has_value());
  EXPECT_EQ(alphaSeamFit(given, back).geometric_order, 0);
}

TEST(AlphaJoinCondition, MotionsScalesAndReversal) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    AlphaSurface given = randomSurface(random), next = randomSurface(random);
    next.poles.col(0).array() += 9;
    const double scale = test::logUniform(random, -4, 4);
    const Eigen::Matrix3d map = scale * test::randomRotation(random);
    AlphaSurface given2 = given, next2 = next, given3 = given, next3 = next;
    given2.poles = given.poles * map.transpose();
    next2.poles = next.poles * map.transpose();
    for (int k = 0; k < 16; ++k) {
      given3.poles.row(k) = given.poles.row(4 * (k / 4) + 3 - k % 4);
      next3.poles.row(k) = next.poles.row(4 * (k / 4) + 3 - k % 4);
    }
    const AlphaNearestOptions options{2};
    const auto plain = alphaNearestJoin(given, next, options);
    for (const auto& [a, b, unit] :
         {std::tuple{&given2, &next2, scale}, std::tuple{&given3, &next3, 1.0}}) {
      const auto other = alphaNearestJoin(*a, *b, options);
      ASSERT_EQ(other.has_value(), plain.has_value());
      if (!other) continue;
      EXPECT_NEAR(other->beta1, plain->beta1, 1e-9 * plain->beta1);
      EXPECT_NEAR(other->beta2, plain->beta2, 1e-8 * (1 + std::abs(plain->beta2)));
      EXPECT_NEAR(other->cost_next, unit * unit * plain->cost_next,
                  1e-9 * unit * unit * (1 + plain->cost_next));
      const auto defects = alphaSeamCondition(*a, next.a_v).defects_mm;
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(defects[k], unit * alphaSeamCondition(given, next.a_v).defects_mm[k],
                    1e-12 * unit);
    }
  }
}

TEST(AlphaJoinCondition, RefusesBadSurfaces) {
  std::mt19937_64 random(testSeed());
  const AlphaSurface given = randomSurface(random);
  const auto with = [&](auto change) {
    AlphaSurface surface = given;
    change(surface);
    return test::complaint([&] { alphaSeamCondition(surface, 0.5); });
  };
  EXPECT_EQ(with([](auto&) {}), "nothing was refused");
  EXPECT_THAT(with([](auto& s) { s.a_u = 0; }), HasSubstr("a_u is 0"));
  EXPECT_THAT(with([](auto& s) { s.a_v = 2; }), HasSubstr("a_v is 2"));
  EXPECT_THAT(with([](auto& s) { s.poles(6, 0) = std::nan(""); }),
              HasSubstr("pole 1, 2 is not finite"));
  EXPECT_THAT(with([](auto& s) {
                s.poles.template middleRows<4>(8) = s.poles.template bottomRows<4>().eval();
              }),
              HasSubstr("rows 2 and 3 are the same"));
  EXPECT_THAT(with([](auto& s) { s.poles.template bottomRows<4>().setOnes(); }),
              HasSubstr("row 3 is one point"));
  EXPECT_THAT(test::complaint([&] { alphaSeamCondition(given, 0); }), HasSubstr("next_a_v is 0"));
  EXPECT_THAT(test::complaint([&] { alphaBalanced(given, 3); }), HasSubstr("order 3"));
  EXPECT_THAT(test::complaint([&] { alphaSeamFit(given, given, -1); }), HasSubstr("length is -1"));
  EXPECT_THAT(test::complaint([&] { alphaNearestJoin(given, given, {4}); }), HasSubstr("order 4"));
  EXPECT_THAT(test::complaint([&] { alphaSlidingRows(given, 1, given.a_v, -1, 0, 0); }),
              HasSubstr("alpha is -1"));
  EXPECT_THAT(test::complaint([&] { alphaSlidingRows(given, 1, 0.99, 1, 0, 0); }),
              HasSubstr("a_v and next_a_v differ"));
}

}  // namespace
}  // namespace seamwright
