// SPDX-License-Identifier: LGPL-2.1-or-later
// Nearest joins known to 40 digits (tests/data/nearest_joins.json, made with multi-precision
// arithmetic).
#include <gmock/gmock.h>

#include <fstream>

#include "spline_surfaces.hpp"
#include "support/random.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::number, test::patch;

std::vector<json> cases(const std::string& kind) {
  std::ifstream file(SEAMWRIGHT_TEST_DATA "/nearest_joins.json");
  std::vector<json> found;
  const json data = json::parse(file);
  for (const json& entry : data["cases"])
    if (entry["kind"] == kind) found.push_back(entry);
  return found;
}

Eigen::VectorXd coefficients(const json& list) {
  Eigen::VectorXd result(std::ssize(list));
  for (Eigen::Index i = 0; i < result.size(); ++i) result(i) = number(list[i]);
  return result;
}

void expectNear(const Eigen::VectorXd& value, const json& wanted) {
  const Eigen::VectorXd exact = coefficients(wanted);
  ASSERT_EQ(value.size(), exact.size());
  EXPECT_LT((value - exact).norm(), 1e-11 * (1 + exact.norm()));
}

/// Row i of poles counted by u.
void expectRow(const BSplineSurface& surface, int i, const json& wanted) {
  ASSERT_EQ(surface.countV(), std::ssize(wanted));
  for (int j = 0; j < surface.countV(); ++j)
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(surface.poles(static_cast<Eigen::Index>(i) * surface.countV() + j, d),
                  number(wanted[j][d]), 2e-11);
}

/// P ends at the seam, Q begins there.
JoinSide ofP(const json& entry) {
  return {splineSurface(patch(entry["input"]["P"])), PatchEdge::U1};
}
JoinSide ofQ(const json& entry) {
  return {splineSurface(patch(entry["input"]["Q"])), PatchEdge::U0};
}

TEST(NearestOracle, RowAfterRowAsInTheData) {
  ASSERT_EQ(cases("min_change").size(), 2u);
  for (const json& entry : cases("min_change")) {
    JoinSide p = ofP(entry), q = ofQ(entry);
    p.moves = false;
    const NearestJoin first = nearestJoin(p, q);
    EXPECT_EQ(first.status, NearestStatus::Joined);
    expectNear(first.connection.alpha, entry["expected"]["alpha"]);
    expectNear(first.connection.beta, entry["expected"]["beta"]);
    expectRow(first.b, 1, entry["expected"]["row1"]);

    q.surface = first.b;
    q.fixed.assign(q.surface.poles.rows(), false);
    std::fill_n(q.fixed.begin(), 2 * q.surface.countV(), true);
    const NearestJoin second = nearestJoin(p, q, {.order = 2});
    EXPECT_EQ(second.status, NearestStatus::Joined);
    expectNear(second.connection.alpha, entry["expected"]["alpha"]);
    expectNear(second.connection.p, entry["expected"]["p"]);
    expectNear(second.connection.q, entry["expected"]["q"]);
    expectRow(second.b, 2, entry["expected"]["row2"]);
    EXPECT_EQ(second.b.poles.topRows(2 * q.surface.countV()),
              first.b.poles.topRows(2 * q.surface.countV()));
  }
}

TEST(NearestOracle, BothRowsAtOnce) {
  ASSERT_EQ(cases("min_change_joint").size(), 2u);
  for (const json& entry : cases("min_change_joint")) {
    JoinSide p = ofP(entry), q = ofQ(entry);
    p.moves = false;
    const int columns = q.surface.countV();
    q.weights = Eigen::VectorXd::Ones(q.surface.poles.rows());
    q.weights.segment(columns, columns).setConstant(number(entry["input"]["w1"]));
    q.weights.segment(2L * columns, columns).setConstant(number(entry["input"]["w2"]));
    // The seam of Q is that of P already, as far as the data say, so its weight does not count.
    const NearestJoin join = nearestJoin(p, q, {.order = 2});
    EXPECT_EQ(join.status, NearestStatus::Joined);
    expectNear(join.connection.alpha, entry["expected"]["alpha"]);
    expectNear(join.connection.beta, entry["expected"]["beta"]);
    expectNear(join.connection.p, entry["expected"]["p"]);
    expectNear(join.connection.q, entry["expected"]["q"]);
    expectRow(join.b, 1, entry["expected"]["row1"]);
    expectRow(join.b, 2, entry["expected"]["row2"]);
    EXPECT_NEAR(join.cost, number(entry["expected"]["cost"]), 1e-12);
    EXPECT_EQ(join.a, p.surface);
  }
}

TEST(NearestOracle, BothSidesForAConnectionThatIsHeld) {
  ASSERT_EQ(cases("symmetric_g1").size(), 2u);
  for (const json& entry : cases("symmetric_g1")) {
    // Weight 1 of the seam of each side makes 2 of both.
    const JoinSide p = ofP(entry), q = ofQ(entry);
    ConnectionFunctions held;
    held.alpha = coefficients(entry["input"]["alpha"]);
    held.beta = coefficients(entry["input"]["beta"]);
    const NearestJoin join = nearestJoin(p, q, {.held = held});
    EXPECT_EQ(join.status, NearestStatus::Joined);
    expectRow(join.a, p.surface.countU() - 2, entry["expected"]["P_row_m1"]);
    expectRow(join.a, p.surface.countU() - 1, entry["expected"]["seam"]);
    expectRow(join.b, 0, entry["expected"]["seam"]);
    expectRow(join.b, 1, entry["expected"]["Q_row1"]);
  }
}

TEST(NearestOracle, ASeamWithKnots) {
  ASSERT_EQ(cases("bspline_g1").size(), 1u);
  const json entry = cases("bspline_g1")[0];
  BSplineSurface given;
  given.degree_u = entry["input"]["m"];
  given.degree_v = entry["input"]["t_degree"];
  given.knots_u = test::clampedKnots(given.degree_u);
  given.knots_v = entry["input"]["t_knots"].get<std::vector<double>>();
  for (const json& row : entry["input"]["P"])
    for (const json& pole : row) {
      given.poles.conservativeResize(given.poles.rows() + 1, 4);
      given.poles.bottomRows(1) << number(pole[0]), number(pole[1]), number(pole[2]), 1;
    }
  JoinSide p{withRaisedKnots(given, SurfaceDirection::V, 1), PatchEdge::U1};
  p.moves = false;
  std::mt19937_64 random(testSeed());
  const int l = entry["input"]["l"];
  JoinSide q{test::strip({l, given.degree_v, {0.25, 0.25, 0.5, 0.5}}, 1, 1, random), PatchEdge::U0};
  ASSERT_EQ(q.surface.knots_v, entry["expected"]["t_knots_Q"].get<std::vector<double>>());
  ConnectionFunctions held;
  held.alpha = coefficients(entry["input"]["alpha"]);
  held.beta = coefficients(entry["input"]["beta"]);
  const NearestJoin join = nearestJoin(p, q, {.held = held});
  EXPECT_EQ(join.status, NearestStatus::Joined);
  expectRow(join.b, 0, entry["expected"]["row0"]);
  expectRow(join.b, 1, entry["expected"]["row1"]);
}

}  // namespace
}  // namespace seamwright
