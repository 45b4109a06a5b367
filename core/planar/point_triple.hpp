// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include <seamwright/core/planar/arc.hpp>
#include <seamwright/core/planar/biarc_spline.hpp>

/// Not a public header.
namespace seamwright {

/// A point and its neighbours: the vector to the point, and the vector from it.
struct PointTriple {
  Eigen::Vector2d before, after;

  double lengthProduct() const { return before.norm() * after.norm() * (before + after).norm(); }

  /// Of the circle through the three points.
  double curvature_per_mm() const { return 2 * cross(before, after) / lengthProduct(); }

  /// The change of the curvature by moves of the three points as if the lengths stayed.
  Eigen::Vector3d turnSlopes(const std::array<Eigen::Vector2d, 3>& moves) const {
    const double factor = 2 / lengthProduct();
    return factor * Eigen::Vector3d(cross(after, moves[0]),
                                    cross(moves[1], after) + cross(moves[1], before),
                                    cross(before, moves[2]));
  }

  /// The change of the curvature by moves of the three points along these vectors, one each.
  Eigen::Vector3d curvatureSlopes(const std::array<Eigen::Vector2d, 3>& moves) const {
    const Eigen::Vector2d chord = before + after;
    const double curvature = curvature_per_mm();
    const double product = lengthProduct();
    const auto slope = [&](const Eigen::Vector2d& of_before, const Eigen::Vector2d& of_after) {
      return 2 * (cross(of_before, after) + cross(before, of_after)) / product -
             curvature * (before.dot(of_before) / before.squaredNorm() +
                          after.dot(of_after) / after.squaredNorm() +
                          chord.dot(of_before + of_after) / chord.squaredNorm());
    };
    const Eigen::Vector2d none = Eigen::Vector2d::Zero();
    return {slope(-moves[0], none), slope(moves[1], -moves[1]), slope(none, moves[2])};
  }
};

/// The points of a sequence that have two neighbours.
class PointTriples {
 public:
  /// \throws std::invalid_argument as pointCurvatures_per_mm() does.
  PointTriples(const PlanarPoints& points, bool closed);

  Eigen::Index count() const { return closed_ ? points_.rows() : points_.rows() - 2; }
  /// Indices of the three points.
  std::array<Eigen::Index, 3> indices(Eigen::Index i) const {
    const Eigen::Index n = points_.rows();
    if (!closed_) return {i, i + 1, i + 2};
    return {(i + n - 1) % n, i, (i + 1) % n};
  }
  PointTriple at(Eigen::Index i) const {
    const auto [a, b, c] = indices(i);
    return {.before = (points_.row(b) - points_.row(a)).transpose(),
            .after = (points_.row(c) - points_.row(b)).transpose()};
  }

 private:
  const PlanarPoints& points_;
  bool closed_;
};

}  // namespace seamwright
