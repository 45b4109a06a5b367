// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/sampled_chain.hpp>

#include "planar.hpp"

/// Outlines of lines and arcs, and points on them.
namespace seamwright::test {

/// A piece of an outline: it turns at its start, then is a line or an arc.
struct OutlinePiece {
  double turn_rad = 0, curvature_per_mm = 0, length_mm = 0;
};

inline std::vector<PlanarArc> outlineOf(const std::vector<OutlinePiece>& pieces,
                                        double direction_rad) {
  std::vector<PlanarArc> arcs;
  PlanarArc arc{.start = {3, 5}, .direction_rad = direction_rad};
  for (const OutlinePiece& piece : pieces) {
    arc.direction_rad += piece.turn_rad;
    arc.curvature_per_mm = piece.curvature_per_mm;
    arc.length_mm = piece.length_mm;
    arcs.push_back(arc);
    arc.start = arc.end();
    arc.direction_rad = arc.endDirection_rad();
  }
  return arcs;
}

struct Sampling {
  int steps = 8;           ///< of a piece
  double unit_mm = 1e-12;  ///< of the last digit
  int first = 0;           ///< of a closed outline
  bool closed = true;
};

inline PlanarPoints samplesOf(const std::vector<PlanarArc>& outline, const Sampling& sampling) {
  std::vector<Eigen::Vector2d> points;
  for (const PlanarArc& arc : outline)
    for (int k = 0; k < sampling.steps; ++k)
      points.push_back(arc.point(arc.length_mm * k / sampling.steps));
  if (!sampling.closed) points.push_back(outline.back().end());
  PlanarPoints result(std::ssize(points), 2);
  const auto n = static_cast<Eigen::Index>(points.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d& point = points[static_cast<std::size_t>((i + sampling.first) % n)];
    result.row(i) = (point / sampling.unit_mm).array().round().transpose() * sampling.unit_mm;
  }
  return result;
}

/// Distance of a point from a chain, by the centres and angles of its arcs.
inline double distanceTo(const std::vector<PlanarArc>& arcs, const Eigen::Vector2d& point) {
  double nearest = infinite;
  for (const PlanarArc& arc : arcs) {
    nearest = std::min({nearest, (arc.start - point).norm(), (arc.end() - point).norm()});
    const Eigen::Vector2d along = unitVector(arc.direction_rad), left(-along.y(), along.x());
    if (arc.curvature_per_mm == 0) {
      const Eigen::Vector2d away = point - arc.start;
      if (away.dot(along) >= 0 && away.dot(along) <= arc.length_mm)
        nearest = std::min(nearest, std::abs(away.dot(left)));
      continue;
    }
    const double radius_mm = 1 / arc.curvature_per_mm;  // below 0: to the right
    const Eigen::Vector2d centre = arc.start + radius_mm * left;
    double turn_rad = angleFromTo(arc.start - centre, point - centre) * (radius_mm > 0 ? 1 : -1);
    if (turn_rad < 0) turn_rad += 2 * std::numbers::pi;
    if (turn_rad <= arc.length_mm / std::abs(radius_mm))
      nearest = std::min(nearest, std::abs((point - centre).norm() - std::abs(radius_mm)));
  }
  return nearest;
}

inline double largestDistance(const std::vector<PlanarArc>& arcs, const PlanarPoints& points) {
  double largest = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    largest = std::max(largest, distanceTo(arcs, points.row(i).transpose()));
  return largest;
}

/// The turn at the start of each arc but the first; also there if the chain is closed. Arcs that do
/// not touch have none.
inline std::vector<double> turnsOf(const SampledChain& chain) {
  std::vector<double> turns;
  for (std::size_t i = chain.closed ? 0 : 1; i < chain.arcs.size(); ++i) {
    const PlanarArc& before = chain.arcs[i > 0 ? i - 1 : chain.arcs.size() - 1];
    const PlanarArc& arc = chain.arcs[i];
    EXPECT_LT((before.end() - arc.start).norm(), 1e-9) << i;
    turns.push_back(std::abs(wrapped(arc.direction_rad - before.endDirection_rad())));
  }
  return turns;
}

/// Points of a closed outline, each piece of which is divided into the fewest equal
/// steps that are no longer than this.
inline PlanarPoints stepsOfPieces(const std::vector<PlanarArc>& outline, double step_mm) {
  std::vector<Eigen::Vector2d> points;
  for (const PlanarArc& arc : outline) {
    const double steps = std::ceil(arc.length_mm / step_mm);
    for (double k = 0; k < steps; ++k) points.push_back(arc.point(arc.length_mm * k / steps));
  }
  PlanarPoints rows(std::ssize(points), 2);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) = points[static_cast<std::size_t>(i)].transpose();
  return rows;
}

}  // namespace seamwright::test
