// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>

namespace seamwright {

/// A (rational) Bézier triangle of degree n over barycentric coordinates l0 + l1 + l2 = 1, stored by its homogeneous poles:
/// X = sum_{i+j+k=n} n!/(i! j! k!) l0^i l1^j l2^k w_ij P_ij / sum ... w_ij.
///
/// Poles are rows in the order i = 0..n, j = 0..n-i (k = n-i-j); the corners P0, P1, P2 are (i, j) = (n, 0), (0, n), (0, 0). As a
/// parametrised surface its parameters are u = l0, v = l1.
class BezierTriangle {
 public:
  /// Polynomial triangle. \param poles (n+1)(n+2)/2 by 3; their number gives the degree.
  /// \throws std::invalid_argument if the number of rows is no such number, or a pole is not finite (its row is named).
  explicit BezierTriangle(const Eigen::Ref<const Poles>& poles);
  /// Rational triangle. \param weights positive finite numbers in the order of the poles.
  BezierTriangle(const Eigen::Ref<const Poles>& poles, const Eigen::Ref<const Eigen::VectorXd>& weights);

  int degree() const { return degree_; }
  /// Row of the pole (i, j) of a net of that degree.
  static Eigen::Index row(int degree, int i, int j) { return i * (degree + 1) - i * (i - 1) / 2 + j; }
  bool isRational() const;
  Poles poles() const;
  Eigen::VectorXd weights() const { return homogeneous_.col(3); }
  const HomogeneousPoles& homogeneousPoles() const { return homogeneous_; }
  Eigen::Vector3d pole(int i, int j) const;

  Eigen::Vector3d point(double l0, double l1) const;
  /// Point and partials to third order by u = l0, v = l1.
  SurfaceJet jet(double l0, double l1) const;

  bool operator==(const BezierTriangle& other) const { return homogeneous_ == other.homogeneous_; }

 private:
  HomogeneousPoles homogeneous_;
  int degree_;
};

}  // namespace seamwright
