// SPDX-License-Identifier: LGPL-2.1-or-later
// Which alpha-surfaces can join: against linear algebra of the basis itself, jets of the patches, and the data of 60 digits.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <array>
#include <seamwright/core/join/condition.hpp>
#include <seamwright/core/spline/alpha_join_condition.hpp>

#include "alphas.hpp"

namespace seamwright {
namespace {

using nlohmann::json;
using test::uniform;
using test::Vec;
using testing::HasSubstr;

AlphaSurface randomSurface(std::mt19937_64& random) {
  AlphaSurface surface;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      surface.poles.row(4 * i + j) =
          Eigen::RowVector3d(3 * i, 3 * j, 0) + test::randomVector(random).transpose();
  surface.a_u = uniform(0.2, 1, random);
  surface.a_v = uniform(0.2, 1, random);
  return surface;
}

/// Rows 3 .. 3 - order with X_0 + X_3 = X_1 + X_2.
void balance(AlphaSurface& surface, int order) {
  for (int i = 3; i >= 3 - order; --i)
    surface.poles.row(4 * i + 3) =
        surface.poles.row(4 * i + 1) + surface.poles.row(4 * i + 2) - surface.poles.row(4 * i);
}

/// Values of the basis at nine parameters.
Eigen::Matrix<double, 9, 4> collocation(double a) {
  Eigen::Matrix<double, 9, 4> values;
  for (int k = 0; k < 9; ++k) values.row(k) = alphaBasis(a, k / 8.0).transpose();
  return values;
}

TEST(AlphaJoinCondition, CurvesOfTwoShapesAreTheBalancedOnes) {
  std::mt19937_64 random(331);
  for (int i = 0; i < 200; ++i) {
    const double a = uniform(0.1, 1, random), c = i % 2 ? uniform(0.1, 1, random) : a;
    Eigen::Matrix<double, 9, 8> both;
    both << collocation(a), collocation(c);
    Eigen::FullPivLU<Eigen::MatrixXd> lu(both);
    lu.setThreshold(1e-9);
    if (c != a && std::abs(c - a) < 1e-3) continue;
    EXPECT_EQ(lu.rank(), a == c ? 4 : 5) << "spaces of 4 that share 3";
    if (a == c) continue;
    for (const Eigen::VectorXd& x :
         {Eigen::VectorXd(lu.kernel().col(0)), Eigen::VectorXd(lu.kernel().col(2))})
      EXPECT_NEAR(x(0) + x(3) - x(1) - x(2), 0, 1e-8 * x.norm() / std::abs(c - a));
  }
}

TEST(AlphaJoinCondition, Identity1WhichOrdersThereAre) {
  std::mt19937_64 random(332);
  for (int i = 0; i < 1000; ++i) {
    AlphaSurface given = randomSurface(random);
    EXPECT_TRUE(alphaSeamCondition(given, given.a_v).any_net);
    EXPECT_EQ(alphaSeamCondition(given, given.a_v).order, 2);
    const double c = uniform(0.1, 1, random);
    EXPECT_EQ(alphaSeamCondition(given, c).order, -1) << "no general net";
    const int order = i % 3;
    balance(given, order);
    const AlphaSeamCondition condition = alphaSeamCondition(given, c);
    EXPECT_EQ(condition.order, order);
    EXPECT_FALSE(condition.any_net);
    AlphaSurface moved = given;
    moved.poles(4 * (3 - order) + 1, 2) += 1e-6 * 10;
    EXPECT_EQ(alphaSeamCondition(moved, c).order, order - 1);
    EXPECT_NEAR(alphaSeamCondition(moved, c).defects_mm[order], 1e-5, 1e-14);
  }
}

TEST(AlphaJoinCondition, Identity2AllowedIsBuiltForbiddenRefused) {
  std::mt19937_64 random(333);
  for (int i = 0; i < 600; ++i) {
    AlphaSurface given = randomSurface(random);
    const int balanced = i % 4 - 1;
    balance(given, balanced);
    AlphaJoin join;
    join.next_a_v = i % 8 < 4 ? uniform(0.1, 1, random) : given.a_v;
    join.next_a_u = uniform(0.2, 1, random);
    join.beta1 = uniform(0.5, 1.5, random);
    join.beta2 = uniform(-1, 1, random);
    const int possible = alphaSeamCondition(given, join.next_a_v).order;
    for (join.order = 1; join.order <= 2; ++join.order) {
      const std::string said = test::complaint([&] { alphaJoinRows(given, join); });
      EXPECT_EQ(said == "nothing was refused", join.order <= possible) << said;
    }
  }
}

/// The family by brute force: unknown alpha, beta(0), beta(1) and the row of Y_u, equations at nine parameters.
Eigen::Index bruteDimension(const AlphaSurface& given, double next_a_v) {
  const BezierPatch patch = alphaSurfacePatch(given);
  Eigen::Matrix<double, 27, 15> equations = Eigen::Matrix<double, 27, 15>::Zero();
  for (int k = 0; k < 9; ++k) {
    const double v = k / 8.0;
    const SurfaceJet jet = patch.jet(1, v);
    equations.block<3, 1>(3 * k, 0) = jet.u;
    equations.block<3, 1>(3 * k, 1) = (1 - v) * jet.v;
    equations.block<3, 1>(3 * k, 2) = v * jet.v;
    for (int j = 0; j < 4; ++j)
      equations.block<3, 3>(3 * k, 3 + 3 * j) = -alphaBasis(next_a_v, v)(j) * Eigen::Matrix3d::Identity();
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(equations);
  qr.setThreshold(1e-10);
  return 15 - qr.rank();
}

TEST(AlphaJoinCondition, Identity3FamiliesOfGeneralNets) {
  std::mt19937_64 random(334);
  for (int i = 0; i < 500; ++i) {
    AlphaSurface given = randomSurface(random);
    const int balanced = i % 3 - 1;
    balance(given, balanced);
    const AlphaSeamCondition same = alphaSeamCondition(given, given.a_v);
    ASSERT_EQ(same.first_rows.cols(), 1);
    EXPECT_TRUE(same.g1);
    EXPECT_LE(same.first_rows.col(0).tail<2>().norm(), 1e-10 * same.first_rows.col(0).norm());
    const double c = uniform(0.1, 1, random);
    if (std::abs(c - given.a_v) < 0.01) continue;
    const AlphaSeamCondition other = alphaSeamCondition(given, c);
    EXPECT_EQ(other.first_rows.cols(), balanced == 1 ? 1 : 0);
    EXPECT_EQ(other.g1, balanced == 1);
    if (i < 60) {
      EXPECT_EQ(bruteDimension(given, given.a_v), 1);
      EXPECT_EQ(bruteDimension(given, c), other.first_rows.cols());
    }
  }
}

/// A net with this row 3.
AlphaSurface withEdge(double a, const Vec& x0, const Vec& x1, const Vec& x2, const Vec& x3,
                      std::mt19937_64& random) {
  AlphaSurface surface = randomSurface(random);
  surface.poles.bottomRows<4>() << x0.transpose(), x1.transpose(), x2.transpose(), x3.transpose();
  surface.a_v = a;
  return surface;
}

/// The three curved boundaries along which an edge of shape a lets the derivative slide; of X_v's coefficients A, B, 0, C, D.
AlphaSurface curvedEdge(int kind, std::mt19937_64& random) {
  const Vec A = Vec(0, 1, 0) + 0.3 * test::randomVector(random),
            D = Vec(0, 1, 0) + 0.3 * test::randomVector(random);
  const double a = kind == 0 ? 2.0 / 3 : kind == 1 ? 0.8 : 1;
  const Vec B = kind == 2 ? Vec(-(A + D) / 4) : Vec((A - D) / 4);
  const Vec C = kind == 0 ? Vec(-B) : kind == 1 ? Vec::Zero() : B;
  const Vec x0 = test::randomVector(random), x3 = x0 + A + B + C + D;
  return withEdge(a, x0, x0 + A / a, x3 - D / a, x3, random);
}

TEST(AlphaJoinCondition, Identity4CurvedBoundariesThatSlide) {
  std::mt19937_64 random(335);
  for (int i = 0; i < 150; ++i) {
    const AlphaSurface given = curvedEdge(i % 3, random);
    const AlphaSeamCondition condition = alphaSeamCondition(given, given.a_v);
    ASSERT_EQ(condition.first_rows.cols(), 2) << i % 3;
    EXPECT_TRUE(condition.g1);
    if (i < 30) {
      EXPECT_EQ(bruteDimension(given, given.a_v), 2);
    }
    // The edge is curved, so straight boundaries are not the only ones.
    const CurveDerivatives x = alphaSurfacePatch(given).isoCurveU(1).derivatives(0.3, 2);
    EXPECT_GT(Vec(x.row(1)).cross(Vec(x.row(2))).norm(), 1e-3);
    AlphaSurface moved = given;
    moved.poles(13, 0) += 1e-6;
    EXPECT_EQ(alphaSeamCondition(moved, given.a_v).first_rows.cols(), 1);
    AlphaSurface other = given;
    other.a_v = given.a_v - 0.05;
    EXPECT_EQ(alphaSeamCondition(other, other.a_v).first_rows.cols(), 1) << "each belongs to one shape";
  }
}

/// What A, B, C, D of an edge of shape a fulfil, coordinate by coordinate, that slides with beta(0), beta(1): equations (i) and (ii)
/// of beta X_v, and that q_2 = q_3 of the edge itself is the middle of its inner poles. If its rank is 3 all four are parallel.
double thirdSingularValue(double a, double beta0, double beta1) {
  Eigen::Matrix<double, 3, 4> equations;
  equations << 0, beta1, -beta0, 0,  //
      beta1 - 5 * (1 - a) * beta0, 4 * beta0 - 2 * a * beta1, 4 * beta1 - 2 * a * beta0,
      beta0 - 5 * (1 - a) * beta1,  //
      -(1 - a), a, -a, 1 - a;
  equations.rowwise().normalize();
  return Eigen::JacobiSVD<Eigen::MatrixXd>(equations).singularValues()(2);
}

TEST(AlphaJoinCondition, NoOtherCurvedBoundarySlides) {
  const double right = std::acos(0.0);
  const std::array<std::pair<double, double>, 4> known = {
      {{2.0 / 3, 1.5 * right}, {0.8, 0}, {0.8, right}, {1, 0.5 * right}}};
  for (const auto& [a, turn] : known) EXPECT_LE(thirdSingularValue(a, std::cos(turn), std::sin(turn)), 1e-15);
  for (int i = 1; i <= 200; ++i)
    for (int k = 0; k < 400; ++k) {
      const double a = i / 200.0, turn = 2 * right * k / 400;
      double nearest = 1;
      for (const auto& [shape, angle] : known)
        for (const double around : {-2 * right, 0.0, 2 * right})
          nearest = std::min(nearest, std::hypot(a - shape, turn - angle - around));
      EXPECT_GT(thirdSingularValue(a, std::cos(turn), std::sin(turn)), nearest < 0.2 ? 0.05 * nearest : 0.01)
          << a << " " << turn;
    }
}

TEST(AlphaJoinCondition, StraightBoundariesSlide) {
  std::mt19937_64 random(336);
  int slides = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec along = test::randomVector(random), x0 = test::randomVector(random);
    // The straight edge x0 + f(v) along, f of the shape: B and C are parallel to each other.
    const AlphaSurface given = withEdge(uniform(0.3, 1, random), x0, x0 + uniform(0.2, 0.4, random) * along,
                                        x0 + uniform(0.6, 0.8, random) * along, x0 + along, random);
    const AlphaSeamCondition condition = alphaSeamCondition(given, given.a_v);
    EXPECT_GE(condition.first_rows.cols(), 1);
    EXPECT_EQ(condition.first_rows.cols(), bruteDimension(given, given.a_v));
    slides += condition.first_rows.cols() > 1;
  }
  RecordProperty("slides", slides);
}

TEST(AlphaJoinCondition, Identity5SlidingRowsHoldTheEquation) {
  std::mt19937_64 random(337);
  for (int i = 0; i < 150; ++i) {
    const AlphaSurface given = curvedEdge(i % 3, random);
    const AlphaSeamCondition condition = alphaSeamCondition(given, given.a_v);
    Vec functions = condition.first_rows * Eigen::Vector2d(uniform(-1, 1, random), uniform(-1, 1, random));
    if (functions(0) < 0) functions *= -1;
    AlphaSurface next = randomSurface(random);
    next.a_v = given.a_v;
    next.poles.topRows<8>() =
        alphaSlidingRows(given, next.a_u, next.a_v, functions(0), functions(1), functions(2));
    const BezierPatch before = alphaSurfacePatch(given), after = alphaSurfacePatch(next);
    const double size = functions.norm() * 10;
    for (int k = 0; k <= 8; ++k) {
      const double v = k / 8.0;
      const SurfaceJet x = before.jet(1, v), y = after.jet(0, v);
      const double beta = (1 - v) * functions(1) + v * functions(2);
      EXPECT_LE((y.p - x.p).norm(), 1e-13);
      EXPECT_LE((y.u - functions(0) * x.u - beta * x.v).norm(), 1e-12 * (1 + size));
    }
    EXPECT_EQ(joinCondition(ribbon(before, PatchEdge::U1, false, Across::OutOf),
                            ribbon(after, PatchEdge::U0, false, Across::Into))
                  .verdict,
              JoinVerdict::G1);
    if (std::abs(functions(1)) + std::abs(functions(2)) > 0.1 * functions.norm()) {
      EXPECT_EQ(alphaSeamFit(given, next).geometric_order, 0) << "it slides";
    }
    EXPECT_THAT(test::complaint([&] {
                  alphaSlidingRows(given, 1, given.a_v, functions(0), functions(1) + 0.5, functions(2) + 0.3);
                }),
                HasSubstr("is not the derivative of an alpha-surface"));
  }
  // Different shapes along the seam, rows 3 and 2 balanced: the same as alphaJoinRows().
  AlphaSurface given = randomSurface(random);
  balance(given, 1);
  AlphaJoin join;
  join.next_a_v = 0.77;
  join.beta1 = 1.3;
  EXPECT_LE((alphaSlidingRows(given, 1, 0.77, 1.3, 0, 0) - alphaJoinRows(given, join)).cwiseAbs().maxCoeff(),
            1e-13);
}

TEST(AlphaJoinCondition, Identity6NearestBalancedRows) {
  std::mt19937_64 random(338);
  for (int i = 0; i < 200; ++i) {
    const AlphaSurface given = randomSurface(random);
    const int order = i % 3;
    const AlphaSurface near = alphaBalanced(given, order);
    EXPECT_EQ(near.poles.topRows(4 * (3 - order)), given.poles.topRows(4 * (3 - order)));
    EXPECT_EQ(alphaSeamCondition(near, 0.123).order, order);
    // The move is square to every move that keeps rows balanced.
    const AlphaSurface::Net move = near.poles - given.poles;
    for (int k = 0; k < 20; ++k) {
      AlphaSurface other = randomSurface(random);
      balance(other, order);
      AlphaSurface::Net difference = AlphaSurface::Net::Zero();
      difference.bottomRows(4 * (order + 1)) = (other.poles - near.poles).bottomRows(4 * (order + 1));
      EXPECT_NEAR(move.cwiseProduct(difference).sum(), 0, 1e-12 * (1 + move.norm() * difference.norm()));
    }
  }
}

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
  std::mt19937_64 random(339);
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
    for (int k = 0; k < 16; ++k) given.poles.row(k) = test::vector(in["P"][k / 4][k % 4]).transpose();
    for (std::size_t k = 0; k < 4 * expected.size(); ++k)
      next.poles.row(static_cast<Eigen::Index>(k)) = test::vector(expected[k / 4][k % 4]).transpose();
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
    EXPECT_LE(std::sqrt(near->cost_next), 1e-9 * (1 + next.poles.cwiseAbs().maxCoeff())) << "nothing moves";
    EXPECT_EQ(near->cost_given, 0);
    special += kind == "special";
    ++count;
  }
  EXPECT_EQ(count, 36);
  EXPECT_GE(special, 3);
}

/// The cost of a join with these betas.
double costOf(const AlphaSurface& given, const AlphaSurface& next, const AlphaNearestOptions& o, double beta1,
              double beta2) {
  const Poles rows =
      alphaJoinRows(given, {o.order, beta1, beta2, o.length, o.next_length, next.a_u, next.a_v});
  return (rows - next.poles.topRows(rows.rows())).squaredNorm();
}

TEST(AlphaJoinCondition, Identity8NothingIsNearer) {
  std::mt19937_64 random(340);
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
    EXPECT_EQ(alphaSeamFit(near->given, near->next, options.length, options.next_length).geometric_order,
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
    EXPECT_EQ(alphaSeamFit(plain->given, plain->next, options.length, options.next_length).parametric_order,
              options.order);
    EXPECT_GE(plain->cost_next, near->cost_next * (1 - 1e-12));
    options.order = 0;
    const auto edge = alphaNearestJoin(given, next, options);
    EXPECT_LE(alphaSeamFit(edge->given, edge->next).gap_mm, 1e-13 * 20);
    EXPECT_LE(edge->cost_next, plain->cost_next);
    const auto again = alphaNearestJoin(near->given, near->next,
                                        {options.order = 1, false, options.length, options.next_length});
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
  const double left = costOf(given, next, o, beta1, -unit), middle = costOf(given, next, o, beta1, 0),
               right = costOf(given, next, o, beta1, unit);
  const double bend = left - 2 * middle + right, slope = (right - left) / 2;
  return middle - slope * slope / (2 * bend);
}

/// Nets whose join has a local minimum at a beta1 > 0 that is dearer than those next to 0.
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
  std::mt19937_64 random(344);
  int none = 0, dearer = 0;
  for (int i = 0; i < 1500; ++i) {
    AlphaSurface given = randomSurface(random), next = randomSurface(random);
    for (int k = 0; k < 16; ++k) next.poles.row(k) += 2 * test::randomVector(random).transpose();
    next.poles.col(0).array() += uniform(0, 9, random);
    if (i % 6 == 1) {
      std::tie(given, next) = withLocalMinimum();
      for (int k = 0; k < 16; ++k) next.poles.row(k) += 0.1 * test::randomVector(random).transpose();
    }
    next.a_v = given.a_v;
    const AlphaNearestOptions options{1 + i % 2, false, uniform(0.5, 2, random), uniform(0.5, 2, random)};
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
      dearer += dips;
    }
  }
  EXPECT_GT(none, 50);
  EXPECT_GT(dearer, 2) << "with a local minimum that is dearer";
}

TEST(AlphaJoinCondition, ALocalMinimumIsNotTheNearest) {
  const auto [given, next] = withLocalMinimum();
  const AlphaNearestOptions options{2};
  EXPECT_LT(costOf(given, next, options, 0.32), costOf(given, next, options, 0.2)) << "one is there";
  EXPECT_LT(costOf(given, next, options, 0.32), costOf(given, next, options, 0.4));
  EXPECT_LT(costOf(given, next, options, 1e-6), costOf(given, next, options, 0.32));
  EXPECT_FALSE(alphaNearestJoin(given, next, options).has_value());
}

TEST(AlphaJoinCondition, SizesAndLengthsBeyondSquares) {
  std::mt19937_64 random(345);
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
      EXPECT_EQ(alphaSeamCondition(far_given, next.a_v).order, alphaSeamCondition(given, next.a_v).order);
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
  std::mt19937_64 random(346);
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
  std::mt19937_64 random(341);
  const AlphaSurface given = randomSurface(random);
  AlphaSurface back = given;
  back.poles = given.poles.colwise().reverse().eval();
  for (int j = 0; j < 4; ++j) back.poles.row(j) = given.poles.row(12 + j);
  for (int j = 0; j < 4; ++j) back.poles.row(4 + j) = given.poles.row(8 + j);
  EXPECT_FALSE(alphaNearestJoin(given, back).has_value());
  EXPECT_EQ(alphaSeamFit(given, back).geometric_order, 0);
}

TEST(AlphaJoinCondition, MotionsScalesAndReversal) {
  std::mt19937_64 random(342);
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
    for (const auto& [a, b, unit] : {std::tuple{&given2, &next2, scale}, std::tuple{&given3, &next3, 1.0}}) {
      const auto other = alphaNearestJoin(*a, *b, options);
      ASSERT_EQ(other.has_value(), plain.has_value());
      if (!other) continue;
      EXPECT_NEAR(other->beta1, plain->beta1, 1e-9 * plain->beta1);
      EXPECT_NEAR(other->beta2, plain->beta2, 1e-8 * (1 + std::abs(plain->beta2)));
      EXPECT_NEAR(other->cost_next, unit * unit * plain->cost_next,
                  1e-9 * unit * unit * (1 + plain->cost_next));
      const auto defects = alphaSeamCondition(*a, next.a_v).defects_mm;
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(defects[k], unit * alphaSeamCondition(given, next.a_v).defects_mm[k], 1e-12 * unit);
    }
  }
}

TEST(AlphaJoinCondition, Refusals) {
  std::mt19937_64 random(343);
  const AlphaSurface given = randomSurface(random);
  const auto with = [&](auto change) {
    AlphaSurface surface = given;
    change(surface);
    return test::complaint([&] { alphaSeamCondition(surface, 0.5); });
  };
  EXPECT_EQ(with([](auto&) {}), "nothing was refused");
  EXPECT_THAT(with([](auto& s) { s.a_u = 0; }), HasSubstr("a_u is 0"));
  EXPECT_THAT(with([](auto& s) { s.a_v = 2; }), HasSubstr("a_v is 2"));
  EXPECT_THAT(with([](auto& s) { s.poles(6, 0) = std::nan(""); }), HasSubstr("pole 1, 2 is not finite"));
  EXPECT_THAT(
      with([](auto& s) { s.poles.template middleRows<4>(8) = s.poles.template bottomRows<4>().eval(); }),
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
