// SPDX-License-Identifier: LGPL-2.1-or-later
// Networks of surfaces that nearly join.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <limits>
#include <numeric>

#include "joins.hpp"
#include "networks.hpp"
#include "support/random.hpp"

#include <seamwright/core/seam/bspline_side.hpp>

namespace seamwright {
namespace {

using test::ball, test::disturb, test::fan, test::grid, test::joined, test::largestDifference,
    test::mapped, test::Net, test::regularFan, test::Vec;

Net withSurfaces(Net net, const NetworkResult& result) {
  for (std::size_t i = 0; i < net.surfaces.size(); ++i)
    net.surfaces[i].surface = result.surfaces[i];
  return net;
}

SeamFigures figures(const NetworkResult& result, const NetworkSeam& seam) {
  ContinuityTolerance tight;
  tight.gap_mm = tight.angle_rad = 1e-8;  // 6e-7 degrees
  tight.curvature_rel = 1e-6;
  return encloseSeam(seamSide(result.surfaces[seam.surfaces[0]], seam.edges[0]),
                     seamSide(result.surfaces[seam.surfaces[1]], seam.edges[1], seam.reversed),
                     tight);
}

void expectJoins(const NetworkResult& result, const Net& net, std::size_t i) {
  const NetworkSeam& seam = net.seams[i];
  SCOPED_TRACE("seam " + std::to_string(i));
  EXPECT_EQ(result.seams[i].order, seam.order);
  const SeamFigures found = figures(result, seam);
  ASSERT_TRUE(found.certified);
  EXPECT_FALSE(found.fold_at);
  EXPECT_LT(found.gap_mm->upper.value(), 1e-9);
  EXPECT_LT(found.angle_rad->upper.value(), 1e-8);
  if (seam.order == 2) {
    EXPECT_LT(found.curvature_per_mm->upper.value(), 1e-7);
  }
  EXPECT_LT(result.seams[i].residual, 1e-12);
}

/// All seams, and a stationary move.
void expectJoined(const NetworkResult& result, const Net& net) {
  for (const SeamJoin& seam : result.seams) EXPECT_EQ(seam.why, "");
  ASSERT_EQ(result.status, NetworkStatus::Joined);
  EXPECT_LT(result.stationarity, 1e-9);
  for (std::size_t i = 0; i < net.seams.size(); ++i) expectJoins(result, net, i);
}

Net irregularFan(int valence, std::mt19937_64& random) {
  std::uniform_real_distribution<double> turn(-0.25, 0.25), size(8, 12), offset(-2, 2);
  std::vector<Eigen::Vector2d> r, w;
  for (int i = 0; i < valence; ++i) {
    const double angle = 2 * std::numbers::pi * (i + turn(random)) / valence, length = size(random);
    r.emplace_back(length * std::cos(angle), length * std::sin(angle));
    w.emplace_back(offset(random), offset(random));
  }
  return fan(r, w, true, random);
}

/// The faces 0 to count - 1 of a fan, which seams do not surround.
Net openFan(const Net& closed, int count) {
  Net net;
  net.surfaces.assign(closed.surfaces.begin(), closed.surfaces.begin() + count);
  net.seams.assign(closed.seams.begin(), closed.seams.begin() + count - 1);
  return net;
}

double squaredLength(const NetworkResult& a, const NetworkResult& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.surfaces.size(); ++i)
    sum += (a.surfaces[i].poles - b.surfaces[i].poles).squaredNorm();
  return sum;
}

/// Largest distance of poles, after the same change of a's surfaces.
double distance(const NetworkResult& a, const NetworkResult& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.surfaces.size(); ++i)
    largest = std::max(largest, largestDifference(a.surfaces[i], b.surfaces[i]));
  return largest;
}

// What is smooth already has connection functions of the form sought, and is left alone bitwise.
TEST(Network, SmoothNetworksAreLeftAlone) {
  std::mt19937_64 random(testSeed());
  std::vector<Net> nets = {grid(3, 4, 1, random), grid(3, 3, 3, random, 2), ball(20)};
  for (const int valence : {3, 4, 5, 6, 7}) {
    nets.push_back(regularFan(valence, random));
    nets.push_back(irregularFan(valence, random));
  }
  for (const Net& net : nets) {
    const NetworkResult result = joined(net);
    EXPECT_EQ(result.status, NetworkStatus::Unchanged);
    for (std::size_t i = 0; i < net.surfaces.size(); ++i)
      EXPECT_EQ(result.surfaces[i], net.surfaces[i].surface);
    for (std::size_t i = 0; i < net.seams.size(); ++i) expectJoins(result, net, i);
  }
}

struct Repaired {
  int seams = 0, near = 0;  ///< all, and those whose surfaces move by three times the noise at most
};

void repair(Net net, double noise, std::mt19937_64& random, Repaired& count) {
  disturb(net, noise, net.seams[0].order + 1, random);
  const NetworkResult result = joined(net);
  expectJoined(result, net);
  for (const NetworkSeam& seam : net.seams) {
    ++count.seams;
    if (std::max(result.moves_mm[seam.surfaces[0]], result.moves_mm[seam.surfaces[1]]) <= 3 * noise)
      ++count.near;
  }
  if (testing::Test::HasFailure()) return;
  const NetworkResult again = joined(withSurfaces(net, result));  // (5)
  EXPECT_EQ(again.status, NetworkStatus::Unchanged);
  EXPECT_EQ(distance(again, result), 0);
}

TEST(Network, GridsAreRepaired) {  // (1), (5)
  std::mt19937_64 random(testSeed());
  Repaired count;
  for (const double noise : {0.001, 0.01, 0.1})
    for (const int order : {1, 2})
      for (const int spans : {1, 3}) {
        // Poles at the seams of three spans are 1 mm apart: noise of 0.1 mm is 0.1 rad there.
        const double least = spans == 3 ? 0.3 * noise : noise;
        repair(grid(2, 2, spans, random, order), least, random, count);
        repair(grid(3, 4, spans, random, order), least, random, count);
      }
  EXPECT_EQ(count.seams, 12 * (4 + 17));
  EXPECT_GE(count.near, 0.95 * count.seams);
}

TEST(Network, StarsAreRepaired) {  // (1), (5)
  std::mt19937_64 random(testSeed());
  Repaired count;
  for (const double noise : {0.001, 0.01, 0.1}) {
    for (const int valence : {3, 4, 5, 6}) {
      repair(regularFan(valence, random), noise, random, count);
      repair(openFan(regularFan(valence + 1, random), valence), noise, random, count);
    }
    repair(ball(20), noise, random, count);
  }
  EXPECT_GE(count.near, 0.95 * count.seams);
}

// Where ratios differ from end to end, degree 4 along the seams is enough; without it the move is
// many times the noise.
TEST(Network, IrregularStarsAreRaised) {  // (1), (5)
  std::mt19937_64 random(testSeed());
  Repaired count;
  for (const int valence : {3, 5, 6, 7})
    for (int round = 0; round < 3; ++round)
      repair(irregularFan(valence, random), 0.01, random, count);
  EXPECT_GE(count.near, 0.95 * count.seams);

  Net net = irregularFan(5, random);
  disturb(net, 0.01, 2, random);
  const NetworkResult raised = joined(net), natural = joined(net, {.raise = false});
  EXPECT_EQ(raised.surfaces[0].degree_u, 4);
  EXPECT_EQ(natural.surfaces[0].degree_u, 3);
  EXPECT_EQ(
      natural.status == NetworkStatus::Joined || natural.status == NetworkStatus::NotConverged,
      true);
  EXPECT_GT(natural.largest_move_mm, 2 * raised.largest_move_mm);

  for (NetworkSurface& surface : net.surfaces)
    surface.fixed.assign(static_cast<std::size_t>(surface.surface.poles.rows()), false);
  const NetworkResult named = joined(net);
  for (std::size_t s = 0; s < net.surfaces.size(); ++s)
    EXPECT_EQ(named.surfaces[s].poles, raised.surfaces[s].poles) << "no pole is fixed";
}

// One pole moved by 1e-6 of the size is seen, and mended.
TEST(Network, SmallDefectsAreSeen) {
  std::mt19937_64 random(testSeed());
  Net net = grid(3, 3, 1, random);
  net.surfaces[4].surface.poles(5, 2) += 1e-5;
  const NetworkResult result = joined(net);
  EXPECT_EQ(result.status, NetworkStatus::Joined);
  EXPECT_GT(result.largest_move_mm, 1e-7);
  EXPECT_LT(result.largest_move_mm, 1e-5);
}

// Two surfaces: the move of nearestJoin().
TEST(Network, OneSeamIsANearestJoin) {  // (2)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 40; ++round) {
    const int order = 1 + round % 2;
    Net net = grid(2, 1, 1, random, order);
    disturb(net, 0.05, order + 1, random);
    const NetworkResult result = joined(net);
    ASSERT_EQ(result.status, NetworkStatus::Joined);
    const NearestJoin join =
        nearestJoin({net.surfaces[0].surface, PatchEdge::U1},
                    {net.surfaces[1].surface, PatchEdge::U0}, {.order = order});
    ASSERT_EQ(join.status, NearestStatus::Joined);
    EXPECT_NEAR(result.cost, join.cost, 1e-7 * join.cost);
    EXPECT_LT(largestDifference(result.surfaces[0], join.a), 1e-4 * join.largest_move_mm);
    EXPECT_NEAR(result.seams[0].connection.alpha(0) / result.seams[0].connection.gamma(0),
                join.connection.alpha(0), 1e-5);
  }
}

// Another solution with the same connection functions, reached from elsewhere: the way to it is
// orthogonal to the move.
TEST(Network, MoveIsOrthogonalToTheSolutions) {  // (2)
  std::mt19937_64 random(testSeed());
  std::vector<Net> nets = {grid(3, 3, 2, random), grid(3, 2, 1, random, 2), regularFan(5, random),
                           ball(20)};
  for (Net net : nets) {
    disturb(net, 0.05, 3, random);
    const NetworkResult result = joined(net);
    ASSERT_EQ(result.status, NetworkStatus::Joined);
    Net elsewhere = net;
    disturb(elsewhere, 0.5, 3, random);
    for (std::size_t i = 0; i < net.seams.size(); ++i)
      elsewhere.seams[i].held = result.seams[i].connection;
    const NetworkResult other = joined(elsewhere);
    ASSERT_EQ(other.status, NetworkStatus::Joined);
    double product = 0;
    for (std::size_t i = 0; i < net.surfaces.size(); ++i)
      product += (net.surfaces[i].surface.poles - result.surfaces[i].poles)
                     .cwiseProduct(other.surfaces[i].poles - result.surfaces[i].poles)
                     .sum();
    EXPECT_LT(std::abs(product), 1e-9 * std::sqrt(result.cost * squaredLength(other, result)));
  }
}

// The search ends where the cost would fall by 1e-10 of it or less, which leaves poles open by more
// where it is all but flat.
TEST(Network, RigidMotionAndScale) {  // (3)
  std::mt19937_64 random(testSeed());
  for (Net net : {grid(3, 3, 1, random), grid(2, 3, 2, random, 2), regularFan(5, random),
                  irregularFan(5, random), ball(20)}) {
    disturb(net, 0.02, 2, random);
    const NetworkResult result = joined(net);
    ASSERT_EQ(result.status, NetworkStatus::Joined);
    for (const double scale : {1e-3, 1.0, 1e3}) {
      const Eigen::Matrix3d linear = scale * Eigen::Quaterniond::UnitRandom().toRotationMatrix();
      const Vec offset = 50 * scale * test::randomVector(random);
      Net moved = net;
      for (NetworkSurface& surface : moved.surfaces)
        surface.surface = mapped(surface.surface, linear, offset);
      const NetworkResult of_moved = joined(moved);
      ASSERT_EQ(of_moved.status, NetworkStatus::Joined);
      EXPECT_NEAR(of_moved.cost / (scale * scale), result.cost, 1e-6 * result.cost);
      for (std::size_t i = 0; i < net.surfaces.size(); ++i)
        EXPECT_LT(
            largestDifference(of_moved.surfaces[i], mapped(result.surfaces[i], linear, offset)),
            1e-2 * scale * result.largest_move_mm);
    }
  }
}

/// The same surface with the edge named otherwise: v run backwards, or u and v exchanged.
BSplineSurface backwards(const BSplineSurface& surface) {
  BSplineSurface result = surface;
  const int rows = surface.countU(), columns = surface.countV();
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      result.poles.row(static_cast<Eigen::Index>(i) * columns + columns - 1 - j) =
          surface.poles.row(static_cast<Eigen::Index>(i) * columns + j);
  for (std::size_t k = 0; k < surface.knots_v.size(); ++k)
    result.knots_v[k] = surface.knots_v.front() + surface.knots_v.back() -
                        surface.knots_v[surface.knots_v.size() - 1 - k];
  return result;
}

TEST(Network, OrderSidesAndSensesDoNotMatter) {  // (4)
  std::mt19937_64 random(testSeed());
  for (Net net : {grid(3, 3, 2, random), grid(2, 3, 1, random, 2), regularFan(5, random),
                  irregularFan(6, random), ball(20)}) {
    disturb(net, 0.02, 2, random);
    const NetworkResult result = joined(net);
    ASSERT_EQ(result.status, NetworkStatus::Joined);

    std::vector<int> order(net.surfaces.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    Net other = net;
    std::vector<bool> turned;
    for (std::size_t i = 0; i < order.size(); ++i) {
      turned.push_back(i % 2 == 0);
      other.surfaces[order[i]] = net.surfaces[i];
      if (turned[i]) other.surfaces[order[i]].surface = backwards(net.surfaces[i].surface);
    }
    for (std::size_t k = 0; k < net.seams.size(); ++k) {
      NetworkSeam& seam = other.seams[k];
      for (int side = 0; side < 2; ++side) {
        if (turned[seam.surfaces[side]]) {
          PatchEdge& edge = seam.edges[side];
          if (edge == PatchEdge::V0 || edge == PatchEdge::V1)
            edge = edge == PatchEdge::V0 ? PatchEdge::V1 : PatchEdge::V0;
          else
            seam.reversed = !seam.reversed;
        }
        seam.surfaces[side] = order[seam.surfaces[side]];
      }
      if (k % 3 == 0) {
        std::swap(seam.surfaces[0], seam.surfaces[1]);
        std::swap(seam.edges[0], seam.edges[1]);
      }
    }
    std::shuffle(other.seams.begin(), other.seams.end(), random);
    const NetworkResult of_other = joined(other);
    ASSERT_EQ(of_other.status, NetworkStatus::Joined);
    EXPECT_NEAR(of_other.cost, result.cost, 1e-6 * result.cost);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const BSplineSurface& found = of_other.surfaces[order[i]];
      EXPECT_LT(largestDifference(turned[i] ? backwards(found) : found, result.surfaces[i]),
                1e-2 * result.largest_move_mm);
    }
  }
}

TEST(Network, WhatIsFixedStays) {  // (6)
  std::mt19937_64 random(testSeed());
  for (int round = 0; round < 12; ++round) {
    Net net = grid(3, 3, 1 + round % 2, random, 1 + round / 2 % 2);
    const Net smooth = net;
    disturb(net, 0.02, 3, random);
    // Faces that stay, alone, side by side, and across a corner.
    for (const int face : round % 3 == 0   ? std::vector{4}
                          : round % 3 == 1 ? std::vector{0, 1}
                                           : std::vector{0, 4}) {
      net.surfaces[face] = smooth.surfaces[face];
      net.surfaces[face].moves = false;
    }
    // The far corner pole of face 8, which no seam needs.
    net.surfaces[8].fixed.assign(net.surfaces[8].surface.poles.rows(), false);
    net.surfaces[8].fixed.back() = true;
    const NetworkResult result = joined(net);
    expectJoined(result, net);
    for (std::size_t i = 0; i < net.surfaces.size(); ++i) {
      if (!net.surfaces[i].moves) {
        EXPECT_EQ(result.surfaces[i], net.surfaces[i].surface);
      }
    }
    EXPECT_EQ(result.surfaces[8].poles.bottomRows(1), net.surfaces[8].surface.poles.bottomRows(1));
  }
}

// A row of three faces, of which the first two join: they still do when the seam between them is
// given.
TEST(Network, SmoothSeamsAreKept) {
  std::mt19937_64 random(testSeed());
  Net net = grid(3, 1, 1, random, 2);  // the rows that both seams need overlap
  Net disturbed = net;
  disturbed.seams.erase(disturbed.seams.begin());
  disturb(disturbed, 0.05, 1, random);
  disturbed.seams = net.seams;
  const NetworkResult result = joined(disturbed);
  expectJoined(result, disturbed);
  EXPECT_NE(result.surfaces[1], disturbed.surfaces[1].surface);

  Net alone = disturbed;
  alone.seams.erase(alone.seams.begin());
  const NetworkResult without = joined(alone);
  EXPECT_LT(without.cost, result.cost);
}

TEST(Network, ContradictionsAreLeftOut) {
  std::mt19937_64 random(testSeed());
  Net net = grid(3, 3, 1, random);
  const Net smooth = net;
  disturb(net, 0.01, 2, random);
  for (const int face : {0, 1}) {
    net.surfaces[face] = smooth.surfaces[face];
    net.surfaces[face].moves = false;
  }
  // A kink between two faces that stay.
  BSplineSurface& kinked = net.surfaces[1].surface;
  for (int i = 0; i < 4; ++i) kinked.poles(4 * i + 1, 2) += 0.5;
  const NetworkResult result = joined(net);
  EXPECT_EQ(result.status, NetworkStatus::Partly);
  int left = 0;
  for (std::size_t i = 0; i < net.seams.size(); ++i) {
    if (result.seams[i].status == SeamStatus::Left) {
      ++left;
      EXPECT_FALSE(result.seams[i].why.empty());
      EXPECT_GT(result.seams[i].residual, 1e-3);
    } else {
      expectJoins(result, net, i);
    }
  }
  EXPECT_EQ(result.seams[0].status, SeamStatus::Left);
  EXPECT_LE(left, 2);
  EXPECT_EQ(result.surfaces[1], kinked);
}

TEST(Network, NoCurvatureAtStars) {
  std::mt19937_64 random(testSeed());
  Net net = regularFan(5, random);
  for (NetworkSeam& seam : net.seams) seam.order = 2;
  disturb(net, 0.01, 2, random);
  const NetworkResult result = joined(net);
  EXPECT_EQ(result.status, NetworkStatus::Partly);
  for (std::size_t i = 0; i < net.seams.size(); ++i) {
    EXPECT_EQ(result.seams[i].status, SeamStatus::Joined);
    EXPECT_EQ(result.seams[i].order, 1);
    EXPECT_THAT(result.seams[i].why, testing::HasSubstr("G1 instead of G2"));
    EXPECT_LT(figures(result, net.seams[i]).angle_rad->upper.value(), 1e-8);
  }
}

// Weights: what is costly moves less.
TEST(Network, HeavyPolesMoveLess) {
  std::mt19937_64 random(testSeed());
  Net net = grid(2, 2, 1, random);
  disturb(net, 0.05, 2, random);
  const NetworkResult even = joined(net);
  net.surfaces[0].weights = Eigen::VectorXd::Constant(net.surfaces[0].surface.poles.rows(), 1e4);
  const NetworkResult costly = joined(net);
  expectJoined(costly, net);
  EXPECT_LT(costly.moves_mm[0], 0.02 * even.moves_mm[0]);
}

TEST(Network, BadInputIsRefused) {
  std::mt19937_64 random(testSeed());
  const Net net = grid(2, 2, 1, random);
  const auto expectRefused = [&](const Net& bad, const std::string& message,
                                 const NetworkOptions& options = {}) {
    try {
      joined(bad, options);
      ADD_FAILURE() << "accepted, instead of: " << message;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(message));
    }
  };
  const auto with = [&](const auto& change) {
    Net bad = net;
    change(bad);
    return bad;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused(with([](Net& n) { n.surfaces[2].surface.poles(3, 1) = nan; }), "surface 2: ");
  expectRefused(with([](Net& n) { n.surfaces[1].surface.poles.row(3) *= 2; }),
                "surface 1 is rational");
  expectRefused(with([](Net& n) { n.surfaces[1].weights = Eigen::VectorXd::Ones(3); }),
                "weights of surface 1 are 3");
  expectRefused(with([](Net& n) {
                  n.surfaces[3].weights = Eigen::VectorXd::Ones(16);
                  n.surfaces[3].weights(7) = -1;
                }),
                "weight 7 of a move of surface 3 is -1");
  expectRefused(with([](Net& n) { n.surfaces[1].fixed = {true}; }),
                "fixed poles of surface 1 are 1");
  expectRefused(with([](Net& n) { n.seams[1].surfaces[1] = 4; }), "seam 1 names surface 4 of 4");
  expectRefused(with([](Net& n) { n.seams[1].order = 3; }), "order of seam 1 is 3");
  expectRefused(with([](Net& n) { n.seams.push_back(n.seams[2]); }), "is in seam 2 and in seam 4");
  expectRefused(with([](Net& n) {
                  n.surfaces[1].surface = withKnot(n.surfaces[1].surface, SurfaceDirection::U,
                                                   0.4 * n.surfaces[1].surface.knots_u.back());
                }),
                "poles 4 and 5");
  expectRefused(with([](Net& n) {
                  n.seams[0].held = ConnectionFunctions{};
                  n.seams[0].held->alpha(0) = 0;
                }),
                "coefficient 0 of alpha of the connection of seam 0 is 0");
  expectRefused(
      with([](Net& n) { n.seams[2].held = ConnectionFunctions{.e1 = Eigen::Vector2d(0, 1)}; }),
      "the connection of seam 2 scales poles");
  expectRefused(net, "regular_rad is 2", {.regular_rad = 2});
  expectRefused(net, "max_iterations is -1", {.max_iterations = -1});
  EXPECT_EQ(nearestNetwork({}, {}).status, NetworkStatus::Unchanged);
  EXPECT_EQ(nearestNetwork(net.surfaces, {}).status, NetworkStatus::Unchanged);
}

}  // namespace
}  // namespace seamwright
