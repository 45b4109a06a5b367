// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <seamwright/core/planar/point_energy.hpp>
#include <seamwright/core/planar/point_triple.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// Four neighbours: two triples, whose curvatures differ.
struct PointRows {
  Index points = 0;
  bool closed = false;

  Index triples() const { return closed ? points : points - 2; }
  Index count() const { return closed ? points : points - 3; }
  Index next(Index triple) const { return triple + 1 < triples() ? triple + 1 : 0; }
  std::array<Index, 3> ofTriple(Index i) const {
    if (!closed) return {i, i + 1, i + 2};
    return {i > 0 ? i - 1 : points - 1, i, i + 1 < points ? i + 1 : 0};
  }
};

PointTriple tripleOf(const PlanarPoints& points, const std::array<Index, 3>& at) {
  return {.before = (points.row(at[1]) - points.row(at[0])).transpose(),
          .after = (points.row(at[2]) - points.row(at[1])).transpose()};
}

double turnOver(const PointTriple& triple, const PointTriple& lengths) {
  return 2 * cross(triple.before, triple.after) / lengths.lengthProduct();
}

/// Curvature at a point, its derivatives by the moves of the three points, and the vector onwards.
struct CurvatureRow {
  double value = 0;
  Eigen::Vector3d slopes;
  Eigen::Vector2d after;
};

CurvatureRow curvatureRow(const PlanarPoints& points, const PlanarPoints& moves,
                          const std::array<Index, 3>& at, EnergyLengths lengths) {
  const PointTriple triple = tripleOf(points, at);
  const std::array<Eigen::Vector2d, 3> along{moves.row(at[0]), moves.row(at[1]), moves.row(at[2])};
  return {.value = triple.curvature_per_mm(),
          .slopes = lengths == EnergyLengths::Own ? triple.curvatureSlopes(along)
                                                  : triple.turnSlopes(along),
          .after = triple.after};
}

}  // namespace

double halfEnergyOf(const MeasuredPoints& at, bool closed) {
  const PointRows rows{.points = at.points.rows(), .closed = closed};
  const bool own = &at.points == &at.lengths_of;
  Eigen::VectorXd curvatures(rows.triples()), lengths_mm(rows.triples());
  for (Index i = 0; i < rows.triples(); ++i) {
    const PointTriple triple = tripleOf(at.points, rows.ofTriple(i));
    const PointTriple divisor = own ? triple : tripleOf(at.lengths_of, rows.ofTriple(i));
    curvatures(i) = turnOver(triple, divisor);
    lengths_mm(i) = divisor.after.norm();
  }
  double sum = 0;
  for (Index i = 0; i < rows.count(); ++i) {
    const double change = curvatures(rows.next(i)) - curvatures(i);
    sum += change * change / lengths_mm(i);
  }
  return sum / 2;
}

std::vector<EnergyRow> energyRowsOf(const PlanarPoints& points, const PlanarPoints& moves,
                                    EnergyLengths lengths, bool closed) {
  const PointRows rows{.points = points.rows(), .closed = closed};
  std::vector<EnergyRow> result;
  result.reserve(static_cast<std::size_t>(rows.count()));
  CurvatureRow one;
  if (rows.count() > 0) one = curvatureRow(points, moves, rows.ofTriple(0), lengths);
  for (Index i = 0; i < rows.count(); ++i) {
    const std::array<Index, 3> first = rows.ofTriple(i), second = rows.ofTriple(rows.next(i));
    const CurvatureRow other = curvatureRow(points, moves, second, lengths);
    const double length_mm = one.after.norm(), root = std::sqrt(length_mm);
    const double residual = (other.value - one.value) / root;
    EnergyRow row{.points = {first[0], first[1], first[2], second[2]},
                  .slopes = {-one.slopes(0) / root, (other.slopes(0) - one.slopes(1)) / root,
                             (other.slopes(1) - one.slopes(2)) / root, other.slopes(2) / root},
                  .residual = residual};
    if (lengths == EnergyLengths::Own) {
      // The length under the root changes as well.
      const Eigen::Vector2d factor = residual / (2 * length_mm * length_mm) * one.after;
      row.slopes[1] += factor.dot(moves.row(row.points[1]).transpose());
      row.slopes[2] -= factor.dot(moves.row(row.points[2]).transpose());
    }
    result.push_back(row);
    one = other;
  }
  return result;
}

Index firstPlaceOf(const EnergyRow& row, const NarrowOrder& order) {
  Index first = order.count;
  for (const Index point : row.points) first = std::min(first, order.placeOf(point));
  return first;
}

std::vector<std::size_t> orderOf(const std::vector<EnergyRow>& rows, const NarrowOrder& order) {
  std::vector<std::size_t> result(rows.size());
  std::iota(result.begin(), result.end(), std::size_t{0});
  std::ranges::stable_sort(result, {},
                           [&](std::size_t row) { return firstPlaceOf(rows[row], order); });
  return result;
}

}  // namespace seamwright
