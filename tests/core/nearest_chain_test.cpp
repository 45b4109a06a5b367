// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/planar/nearest_chain.hpp>

#include "planar.hpp"

namespace seamwright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;
using test::uniform;

struct ChainSamples {
  std::vector<Vector2d> points;
  std::vector<int> starts;
};

ChainSamples samplesOf(const std::vector<PlanarArc>& chain, double error_mm,
                       std::mt19937_64& random) {
  ChainSamples samples;
  constexpr int steps = 20;
  for (const PlanarArc& arc : chain) {
    samples.starts.push_back(static_cast<int>(samples.points.size()));
    for (int k = 0; k < steps; ++k)
      samples.points.push_back(arc.point(arc.length_mm * (k + 0.5) / steps) +
                               error_mm * Vector2d(uniform(random, -1, 1), uniform(random, -1, 1)));
  }
  return samples;
}

std::vector<PlanarArc> joined(std::vector<PlanarArc> arcs) {
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    arcs[i].start = arcs[i - 1].end();
    arcs[i].direction_rad = arcs[i - 1].endDirection_rad();
  }
  return arcs;
}

PlanarArc piece(double curvature_per_mm, double length_mm) {
  return {.start = {2, 1},
          .direction_rad = 0.3,
          .curvature_per_mm = curvature_per_mm,
          .length_mm = length_mm};
}

/// A slot, and an open chain of two arcs beside each other between lines.
const std::vector<PlanarArc> slot =
    joined({piece(0, 40), piece(0.1, 10 * pi), piece(0, 40), piece(0.1, 10 * pi)});
const std::vector<PlanarArc> bend =
    joined({piece(0, 30), piece(0.05, 25), piece(-0.1, 12), piece(0, 20), piece(0.02, 30)});

/// Each arc moved and bent by itself.
std::vector<PlanarArc> disturbed(std::vector<PlanarArc> chain, std::mt19937_64& random) {
  for (PlanarArc& arc : chain) {
    arc.start += 0.1 * Vector2d(uniform(random, -1, 1), uniform(random, -1, 1));
    arc.direction_rad += uniform(random, -0.01, 0.01);
    arc.curvature_per_mm *= uniform(random, 0.97, 1.03);
  }
  return chain;
}

double sumOfSquares(const std::vector<PlanarArc>& chain, const ChainSamples& samples) {
  double sum = 0;
  for (std::size_t v = 0; v < samples.points.size(); ++v) {
    std::size_t i = chain.size() - 1;
    while (samples.starts[i] > static_cast<int>(v)) --i;
    const PlanarArc& arc = chain[i];
    const Vector2d normal = unitVector(arc.direction_rad + pi / 2);
    const double k = arc.curvature_per_mm;
    const double off = k == 0
                           ? (samples.points[v] - arc.start).dot(normal)
                           : (samples.points[v] - arc.start - normal / k).norm() - 1 / std::abs(k);
    sum += off * off;
  }
  return sum;
}

TEST(NearestChain, OfPointsOfAChainIsThisChain) {  // identity (1)
  std::mt19937_64 random(testSeed());
  for (const bool closed : {true, false}) {
    const std::vector<PlanarArc>& exact = closed ? slot : bend;
    const ChainSamples samples = samplesOf(exact, 0, random);
    const auto found =
        nearestChain({.points = samples.points, .starts = samples.starts, .closed = closed},
                     disturbed(exact, random));
    ASSERT_TRUE(found);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const bool is_inside = closed || (i > 0 && i + 1 < exact.size());
      if (is_inside) {
        EXPECT_LT(((*found)[i].start - exact[i].start).norm(), 1e-6) << i;
        EXPECT_LT(((*found)[i].end() - exact[i].end()).norm(), 1e-6) << i;
      }
      EXPECT_NEAR((*found)[i].curvature_per_mm, exact[i].curvature_per_mm, 1e-8) << i;
    }
    EXPECT_LT(sumOfSquares(*found, samples), 1e-18);
  }
}

TEST(NearestChain, ChainsNearItHaveNoSmallerSum) {  // identity (2)
  std::mt19937_64 random(testSeed());
  const ChainSamples samples = samplesOf(bend, 0.05, random);
  const auto found = nearestChain({.points = samples.points, .starts = samples.starts}, bend);
  ASSERT_TRUE(found);
  const double least = sumOfSquares(*found, samples);
  EXPECT_LT(least, sumOfSquares(bend, samples));
  // Moves that keep an open chain G1: of its begin, and of lengths and curvatures.
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<PlanarArc> other = *found;
    const double size = std::pow(10, uniform(random, -6, -2));
    other.front().start += size * Vector2d(uniform(random, -1, 1), uniform(random, -1, 1));
    other.front().direction_rad += size / 10 * uniform(random, -1, 1);
    for (PlanarArc& arc : other) {
      arc.curvature_per_mm *= 1 + size * uniform(random, -1, 1);
      arc.length_mm += size * uniform(random, -1, 1);
    }
    EXPECT_GE(sumOfSquares(joined(other), samples), least * (1 - 1e-9)) << size;
  }
}

TEST(NearestChain, JoinsWithoutTurns) {
  std::mt19937_64 random(testSeed());
  for (const bool closed : {true, false}) {
    const ChainSamples samples = samplesOf(closed ? slot : bend, 0.05, random);
    const auto found =
        nearestChain({.points = samples.points, .starts = samples.starts, .closed = closed},
                     closed ? slot : bend);
    ASSERT_TRUE(found);
    for (std::size_t i = closed ? 0 : 1; i < found->size(); ++i) {
      const PlanarArc& before = (*found)[i > 0 ? i - 1 : found->size() - 1];
      EXPECT_LT((before.end() - (*found)[i].start).norm(), 1e-10) << i;
      EXPECT_NEAR(wrapped(before.endDirection_rad() - (*found)[i].direction_rad), 0, 1e-10) << i;
    }
  }
}

TEST(NearestChain, OfTwoLinesIsNothing) {
  std::mt19937_64 random(testSeed());
  const std::vector<PlanarArc> lines = joined({piece(0, 10), piece(0, 10)});
  const ChainSamples samples = samplesOf(lines, 0, random);
  EXPECT_FALSE(nearestChain({.points = samples.points, .starts = samples.starts}, lines));
}

}  // namespace
}  // namespace seamwright
