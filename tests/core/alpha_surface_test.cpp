// SPDX-License-Identifier: LGPL-2.1-or-later
// Alpha-surfaces against their basis, and their joins against rows known to 60 digits and against
// derivatives.
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <seamwright/core/join/condition/condition.hpp>
#include <seamwright/core/spline/alpha_surface.hpp>

#include "joins.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::uniform;
using testing::HasSubstr;

Eigen::Vector4d basis(double t, double a) {
  const double s = 1 - t;
  return {std::pow(s, 5) + 5 * (1 - a) * std::pow(s, 4) * t,
          5 * a * std::pow(s, 4) * t + 5 * s * s * t * t,
          5 * s * s * t * t + 5 * a * s * std::pow(t, 4),
          5 * (1 - a) * s * std::pow(t, 4) + std::pow(t, 5)};
}

/// A net of 10 mm whose rows have X_0 + X_3 = X_1 + X_2 if asked for.
AlphaSurface randomSurface(bool balanced, std::mt19937_64& random) {
  AlphaSurface surface;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      surface.poles.row(4 * i + j) << 3 * i + uniform(-0.5, 0.5, random),
          3 * j + uniform(-0.5, 0.5, random), uniform(-1, 1, random);
  if (balanced)
    for (int i = 0; i < 4; ++i)
      surface.poles.row(4 * i + 3) =
          surface.poles.row(4 * i + 1) + surface.poles.row(4 * i + 2) - surface.poles.row(4 * i);
  surface.a_u = uniform(0.2, 1, random);
  surface.a_v = uniform(0.2, 1, random);
  return surface;
}

AlphaSurface next(const AlphaSurface& given, const AlphaJoin& join, std::mt19937_64& random) {
  AlphaSurface result = randomSurface(false, random);
  const Poles rows = alphaJoinRows(given, join);
  result.poles.topRows(rows.rows()) = rows;
  result.a_u = join.next_a_u;
  result.a_v = join.next_a_v;
  return result;
}

AlphaJoin randomJoin(int order, double a_v, std::mt19937_64& random) {
  AlphaJoin join;
  join.order = order;
  join.beta1 = uniform(0.5, 1.5, random);
  join.beta2 = uniform(-1, 1, random);
  join.length = uniform(0.5, 2, random);
  join.next_length = uniform(0.5, 2, random);
  join.next_a_u = uniform(0.2, 1, random);
  join.next_a_v = a_v;
  return join;
}

TEST(AlphaSurface, ThePatchIsTheSurface) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 100; ++run) {
    AlphaSurface surface = randomSurface(false, random);
    if (run % 10 == 0) surface.a_u = 0;
    const BezierPatch patch = alphaSurfacePatch(surface);
    EXPECT_FALSE(patch.isRational());
    const double u = uniform(0, 1, random), v = uniform(0, 1, random);
    const Eigen::Vector4d b = basis(u, surface.a_u), c = basis(v, surface.a_v);
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) point += b(i) * c(j) * surface.poles.row(4 * i + j).transpose();
    EXPECT_LE((patch.point(u, v) - point).norm(), 1e-13);
  }
}

TEST(AlphaSurface, RowsOfTheDataFile) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/alpha_surface_joins.json");
  const json data = json::parse(file);
  int count = 0;
  for (const json& entry : data["cases"]) {
    const json& in = entry["in"];
    const std::string kind = in["kind"];
    AlphaSurface given;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        given.poles.row(4 * i + j) = test::vector(in["P"][i][j]).transpose();
    given.a_u = in["au1"];
    given.a_v = in["av1"];
    AlphaJoin join;
    join.order = kind == "special" ? 2 : kind[1] - '0';
    join.beta1 = in["beta1"];
    join.beta2 = kind == "G3" ? 0 : in["beta2"].get<double>();
    join.length = in["h1"];
    join.next_length = in["h2"];
    join.next_a_u = in["au2"];
    join.next_a_v = in["av2"];
    const Poles rows = alphaJoinRows(given, join);
    const json& expected = entry["out"]["Q"];
    ASSERT_EQ(rows.rows(), 4 * static_cast<Eigen::Index>(expected.size())) << entry["name"];
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      const Eigen::Vector3d pole = test::vector(expected[k / 4][k % 4]);
      EXPECT_LE((rows.row(k).transpose() - pole).norm(), 1e-12 * rows.cwiseAbs().maxCoeff())
          << entry["name"];
    }
    ++count;
  }
  EXPECT_EQ(count, 36);
}

TEST(AlphaSurface, DerivativesByTheCommonParameter) {
  std::mt19937_64 random(testSeed());
  for (int run = 0; run < 120; ++run) {
    const int order = run % 3 + 1;
    const bool reshaped = run % 4 == 0;
    const AlphaSurface given = randomSurface(reshaped, random);
    const AlphaJoin join =
        randomJoin(order, reshaped ? uniform(0.3, 1, random) : given.a_v, random);
    const BezierPatch before = alphaSurfacePatch(given),
                      after = alphaSurfacePatch(next(given, join, random));
    const double h = join.length, k = join.next_length, b = join.beta1;
    const double b2 = order == 3 ? -2 * b * (b / h + 1 / k) : join.beta2,
                 b3 = 12 * b * b / h * (b / h + 1 / k);
    for (int i = 0; i <= 7; ++i) {
      const SurfaceJet x = before.jet(1, i / 7.0), y = after.jet(0, i / 7.0);
      EXPECT_LE((y.p - x.p).norm(), 1e-12);
      EXPECT_LE((y.u / k - b * x.u / h).norm(), 1e-11);
      if (order >= 2) {
        EXPECT_LE((y.uu / (k * k) - b * b * x.uu / (h * h) - b2 * x.u / h).norm(), 1e-9);
      }
      if (order == 3) {
        const Eigen::Vector3d third =
            b * b * b * x.uuu / (h * h * h) + 3 * b * b2 * x.uu / (h * h) + b3 * x.u / h;
        EXPECT_LE((y.uuu / (k * k * k) - third).norm(), 1e-8);
      }
    }
    const JoinCondition condition =
        joinCondition(ribbon(before, PatchEdge::U1, false, Across::OutOf),
                      ribbon(after, PatchEdge::U0, false, Across::Into));
    EXPECT_EQ(condition.verdict, JoinVerdict::G1);
    EXPECT_EQ(condition.g2(), order >= 2);
  }
}

TEST(AlphaSurface, OnesAndZerosContinueParametrically) {
  std::mt19937_64 random(testSeed());
  const AlphaSurface given = randomSurface(false, random);
  AlphaJoin join;
  join.order = 2;
  join.next_a_v = given.a_v;
  join.next_a_u = 0.5;
  EXPECT_EQ(joinCondition(ribbon(alphaSurfacePatch(given), PatchEdge::U1, false, Across::OutOf),
                          ribbon(alphaSurfacePatch(next(given, join, random)), PatchEdge::U0, false,
                                 Across::Into))
                .parametric_order,
            2);
}

std::string refusal(const AlphaSurface& given, const AlphaJoin& join) {
  try {
    alphaJoinRows(given, join);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(AlphaSurface, RefusesBadJoins) {
  std::mt19937_64 random(testSeed());
  const AlphaSurface given = randomSurface(false, random);
  const AlphaJoin good = randomJoin(2, given.a_v, random);
  const auto with = [&](auto change) {
    AlphaJoin join = good;
    change(join);
    return refusal(given, join);
  };
  EXPECT_EQ(refusal(given, good), "nothing was refused");
  EXPECT_THAT(with([](AlphaJoin& j) { j.order = 4; }), HasSubstr("order 4"));
  EXPECT_THAT(with([](AlphaJoin& j) { j.beta1 = 0; }), HasSubstr("beta1 is 0"));
  EXPECT_THAT(with([](AlphaJoin& j) { j.beta2 = std::nan(""); }), HasSubstr("beta2 is nan"));
  EXPECT_THAT(with([](AlphaJoin& j) { j.length = -1; }), HasSubstr("length is -1"));
  EXPECT_THAT(with([](AlphaJoin& j) { j.next_a_u = 0; }), HasSubstr("next_a_u is 0"));
  EXPECT_THAT(with([](AlphaJoin& j) { j.next_a_v = 0.123; }), HasSubstr("row 0 misses it by "));
  AlphaSurface odd = given;
  odd.a_u = 1.5;
  EXPECT_THROW(alphaSurfacePatch(odd), std::invalid_argument);
  odd = given;
  odd.poles(5, 1) = std::nan("");
  EXPECT_THAT(refusal(odd, good), HasSubstr("pole 1, 1 is not finite"));
  EXPECT_THROW(alphaSurfacePatch(odd), std::invalid_argument);
  odd = given;
  odd.poles.middleRows<4>(8) = odd.poles.bottomRows<4>();
  EXPECT_THAT(refusal(odd, good), HasSubstr("rows 2 and 3 are the same"));
}

}  // namespace
}  // namespace seamwright
