// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <utility>

#include <seamwright/core/differential/jet.hpp>

namespace seamwright {

/// Poles, one per row: #P by 3.
using Poles = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// Homogeneous poles (w x, w y, w z, w), one per row: #P by 4. For a polynomial curve or patch w =
/// 1 for all poles.
using HomogeneousPoles = Eigen::Matrix<double, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A (rational) Bézier curve of degree n on [0, 1]:
/// X(t) = sum_i w_i P_i B_i^n(t) / sum_i w_i B_i^n(t), stored by its homogeneous poles.
class BezierCurve {
 public:
  /// Polynomial curve. \param poles (n+1) by 3, at least one row, finite.
  /// \throws std::invalid_argument that names the invalid row.
  explicit BezierCurve(const Eigen::Ref<const Poles>& poles);
  /// Rational curve. \param weights n+1 positive finite numbers.
  /// \throws std::invalid_argument that names the invalid index and value.
  BezierCurve(const Eigen::Ref<const Poles>& poles,
              const Eigen::Ref<const Eigen::VectorXd>& weights);
  /// The curve with these homogeneous poles, copied bitwise. \throws as the constructors do.
  static BezierCurve fromHomogeneous(HomogeneousPoles poles);

  int degree() const { return static_cast<int>(homogeneous_.rows()) - 1; }
  /// Whether the weights differ.
  bool isRational() const;
  Poles poles() const;
  Eigen::VectorXd weights() const { return homogeneous_.col(3); }
  const HomogeneousPoles& homogeneousPoles() const { return homogeneous_; }

  Eigen::Vector3d point(double t) const;
  /// Point and derivatives up to third order at t. Outside [0, 1] the polynomial continues with
  /// less accuracy.
  CurveJet jet(double t) const;
  /// Point and derivatives at t up to \p order, (order + 1) by 3.
  /// \throws std::invalid_argument if the order is negative.
  CurveDerivatives derivatives(double t, int order) const;
  /// Bound of the rounding in the first derivative on [0, 1]: 8 (n + 4) eps n |P|_max w_max /
  /// w_min. It bounds the error of the evaluation only: the poles count as exact.
  double noise() const;

  /// The same curve run backwards: X(1 - t).
  BezierCurve reversed() const;
  /// The same curve with one degree more.
  BezierCurve elevated() const;
  /// The pieces over [0, t] and [t, 1], each reparametrised to [0, 1] (de Casteljau).
  std::pair<BezierCurve, BezierCurve> split(double t) const;

  bool operator==(const BezierCurve& other) const { return homogeneous_ == other.homogeneous_; }

 private:
  struct Homogeneous {};
  BezierCurve(Homogeneous, HomogeneousPoles poles) : homogeneous_(std::move(poles)) {}

  HomogeneousPoles homogeneous_;
};

}  // namespace seamwright
