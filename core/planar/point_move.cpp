// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/point_move.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// Means of rows that follow one another.
class RowMeans {
 public:
  RowMeans(const PlanarPoints& rows, bool closed)
      : closed_(closed), sums_(PlanarPoints::Zero(rows.rows() + 1, 2)), origin_(rows.row(0)) {
    for (Index i = 0; i < rows.rows(); ++i) sums_.row(i + 1) = sums_.row(i) + rows.row(i) - origin_;
  }

  /// \pre at most as many rows as there are. Beyond an open end is the end.
  Eigen::RowVector2d of(Index first, Index last) const {
    const Index n = sums_.rows() - 1;
    if (!closed_) {
      first = std::clamp<Index>(first, 0, n - 1);
      last = std::clamp<Index>(last, 0, n - 1);
    }
    Eigen::RowVector2d sum =
        sums_.row(std::min(last + 1, n)) - sums_.row(std::max<Index>(first, 0));
    if (first < 0) sum += sums_.row(n) - sums_.row(first + n);
    if (last >= n) sum += sums_.row(last + 1 - n);
    return origin_ + sum / static_cast<double>(last - first + 1);
  }

 private:
  bool closed_;
  PlanarPoints sums_;  ///< of the rows before each one, from the first
  Eigen::RowVector2d origin_;
};

Eigen::RowVector2d chordOfNeighbours(const PlanarPoints& points, Index i, bool closed) {
  const Index n = points.rows();
  const Index before = closed ? (i + n - 1) % n : std::max<Index>(i - 1, 0);
  const Index after = closed ? (i + 1) % n : std::min(i + 1, n - 1);
  return points.row(after) - points.row(before);
}

}  // namespace

MoveNormals moveNormals(const PlanarPoints& points, const Eigen::VectorXd& tolerances_mm,
                        bool closed) {
  const Index n = points.rows(), most = std::max<Index>(n / 4, 1);
  PlanarPoints chords(n, 2);
  std::vector<Index> counts(static_cast<std::size_t>(n), 1);
  std::optional<RowMeans> means;
  for (Index i = 0; i < n; ++i) {
    const double unit_mm2 = 16 * tolerances_mm(i) * tolerances_mm(i);
    Eigen::RowVector2d best = chordOfNeighbours(points, i, closed);
    double best_mm2 = best.squaredNorm();
    if (best_mm2 < unit_mm2 && !means) means.emplace(points, closed);
    for (Index count = 2; best_mm2 < unit_mm2 && count <= most; count *= 2) {
      const Eigen::RowVector2d chord = means->of(i + 1, i + count) - means->of(i - count, i - 1);
      const double size_mm2 = chord.squaredNorm() / std::sqrt(static_cast<double>(count));
      if (size_mm2 <= best_mm2) continue;
      best = chord;
      best_mm2 = size_mm2;
      counts[static_cast<std::size_t>(i)] = count;
    }
    chords.row(i) = best.normalized();
  }
  if (means) {
    const RowMeans directions(chords, closed);
    for (Index i = 0; i < n; ++i) {
      const Index count = counts[static_cast<std::size_t>(i)];
      if (count > 1) chords.row(i) = directions.of(i - count, i + count).normalized();
    }
  }
  MoveNormals result{.vectors = PlanarPoints(n, 2), .crowded = means.has_value()};
  result.vectors << -chords.col(1), chords.col(0);
  return result;
}

void requireTolerances(const Eigen::VectorXd& tolerances_mm, Index count) {
  if (tolerances_mm.size() != count)
    refuse(fmt::format("{} tolerances for {} points", tolerances_mm.size(), count));
  for (Index i = 0; i < count; ++i)
    if (!(tolerances_mm(i) >= 0) || tolerances_mm(i) == infinite)
      refuse(fmt::format("the tolerance of point {} is {} mm: it must be at least 0 and finite", i,
                         tolerances_mm(i)));
}

}  // namespace seamwright
