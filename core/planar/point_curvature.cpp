// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/point_curvature.hpp>
#include <seamwright/core/planar/point_triple.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// The curvatures of a sequence with bounds of what rounding of the coordinates changes.
struct NoisyCurvatures {
  Eigen::VectorXd values, noise;
  std::vector<Index> points = {};  ///< of each value
  bool closed = false;

  Index count() const { return values.size(); }
};

/// How much moves of the three points by a small distance change the curvature.
/// Source: docs/theory/planar.md P10.7.
double changeByMoves(const PointTriple& triple, double distance_mm) {
  const double a = triple.before.norm(), b = triple.after.norm(),
               c = (triple.before + triple.after).norm();
  return 2 * distance_mm * (1 / (a * b) + 1 / (a * c) + 1 / (b * c)) +
         2 * distance_mm * std::abs(triple.curvature_per_mm()) * (1 / a + 1 / b + 1 / c);
}

NoisyCurvatures noisyCurvatures(const PlanarPoints& points, bool closed,
                                double given_rounding_mm = 0) {
  const PointTriples triples(points, closed);
  NoisyCurvatures result{.values = Eigen::VectorXd(triples.count()),
                         .noise = Eigen::VectorXd(triples.count()),
                         .closed = closed};
  const double rounding_mm = machine_epsilon * points.cwiseAbs().maxCoeff();
  for (Index i = 0; i < triples.count(); ++i) {
    const PointTriple triple = triples.at(i);
    result.values(i) = triple.curvature_per_mm();
    result.points.push_back(triples.indices(i)[1]);
    // A move of d of one point changes the curvature by at most 2 d / (a b) + 3 d |k| / a, where a
    // and b are the least of the distances, and |k| <= 2 / a. Three points move.
    const double least_mm = std::min(
        {triple.before.norm(), triple.after.norm(), (triple.before + triple.after).norm()});
    result.noise(i) = 24 * (rounding_mm / least_mm + machine_epsilon) / least_mm;
    if (given_rounding_mm > 0)
      result.noise(i) = std::max(result.noise(i), changeByMoves(triple, given_rounding_mm));
  }
  return result;
}

/// A value is an extremum once a later one differs from it by more than the noise. A ring is run
/// through once, from its largest value.
std::vector<Index> extremaOf(const NoisyCurvatures& curvatures) {
  Index extreme = 0;
  if (curvatures.closed) curvatures.values.maxCoeff(&extreme);
  const Index start = extreme, steps = curvatures.count() - (curvatures.closed ? 0 : 1);
  int direction = curvatures.closed ? 1 : 0;
  std::vector<Index> found;
  for (Index step = 1; step <= steps; ++step) {
    const Index i = (start + step) % curvatures.count();
    const double change = curvatures.values(i) - curvatures.values(extreme);
    const int sign = change > 0 ? 1 : -1;
    const bool certain = std::abs(change) > curvatures.noise(i) + curvatures.noise(extreme);
    if (sign == direction) {
      extreme = i;
    } else if (certain) {
      if (direction != 0) found.push_back(curvatures.points[static_cast<std::size_t>(extreme)]);
      direction = sign;
      extreme = i;
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Index> inflectionsOf(const NoisyCurvatures& curvatures) {
  Index start = 0;
  if (curvatures.closed) curvatures.values.cwiseAbs().maxCoeff(&start);
  const Index steps = curvatures.count() - (curvatures.closed ? 0 : 1);
  int sign = 0;
  std::vector<Index> found;
  for (Index step = 0; step <= steps; ++step) {
    const Index i = (start + step) % curvatures.count();
    if (std::abs(curvatures.values(i)) <= curvatures.noise(i)) continue;
    const int own = curvatures.values(i) > 0 ? 1 : -1;
    if (sign != 0 && own != sign) found.push_back(curvatures.points[static_cast<std::size_t>(i)]);
    sign = own;
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Lengths in mm for which no formula overflows or vanishes: the highest power is the ninth, in
/// squares of slopes of the energy, and 2^900 is in the range of doubles.
constexpr double shortest_mm = 0x1p-100, longest_mm = 0x1p100;

}  // namespace

PointTriples::PointTriples(const PlanarPoints& points, bool closed)
    : points_(points), closed_(closed) {
  const Index n = points.rows();
  if (n < 3) refuse(fmt::format("{} points: at least 3 are needed", n));
  for (Index i = 0; i < n; ++i)
    if (!points.row(i).allFinite()) refuse(fmt::format("point {} is not finite", i));
  for (Index i = 0; i < count(); ++i) {
    const auto [a, b, c] = indices(i);
    for (const auto& [one, other] : {std::pair{a, b}, {b, c}, {a, c}}) {
      if (points.row(one) == points.row(other))
        refuse(fmt::format("points {} and {} are equal: ({}, {})", one, other, points(one, 0),
                           points(one, 1)));
      const double apart_mm = (points.row(one) - points.row(other)).lpNorm<Eigen::Infinity>();
      if (!(apart_mm >= shortest_mm && apart_mm <= longest_mm))
        refuse(
            fmt::format("points {} and {} are {:.3g} mm apart: the energy needs distances from "
                        "{:.3g} mm to {:.3g} mm, so scale the points",
                        one, other, apart_mm, shortest_mm, longest_mm));
    }
  }
}

Eigen::VectorXd pointCurvatures_per_mm(const PlanarPoints& points, bool closed) {
  return noisyCurvatures(points, closed).values;
}

std::vector<Index> isolatedInflections(const PlanarPoints& points, bool closed) {
  const NoisyCurvatures curvatures = noisyCurvatures(points, closed);
  const Index n = curvatures.count();
  const auto opposite = [&](Index i, Index j) {
    return curvatures.values(i) * curvatures.values((j + n) % n) < 0;
  };
  std::vector<Index> found;
  for (Index i = closed ? 0 : 1; i < n - (closed ? 0 : 1); ++i)
    if (opposite(i, i - 1) && opposite(i, i + 1))
      found.push_back(curvatures.points[static_cast<std::size_t>(i)]);
  return found;
}

PointFairness fairnessOf(const PlanarPoints& points, bool closed, double rounding_mm) {
  if (!(rounding_mm >= 0) || rounding_mm == infinite)
    refuse(fmt::format("the rounding is {} mm: it must be at least 0 and finite", rounding_mm));
  const NoisyCurvatures curvatures = noisyCurvatures(points, closed, rounding_mm);
  PointFairness result{.extrema = extremaOf(curvatures), .inflections = inflectionsOf(curvatures)};
  const Index n = curvatures.count();
  for (Index i = 0; i < n - (closed ? 0 : 1); ++i) {
    const Index next = (i + 1) % n;
    const double change = curvatures.values(next) - curvatures.values(i);
    const double distance_mm = (points.row(curvatures.points[static_cast<std::size_t>(next)]) -
                                points.row(curvatures.points[static_cast<std::size_t>(i)]))
                                   .norm();
    const double noise = curvatures.noise(next) + curvatures.noise(i);
    result.energy_per_mm3 += change * change / distance_mm;
    result.rounding_per_mm3 += noise * noise / distance_mm;
  }
  return result;
}

}  // namespace seamwright
