// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// A (rational) tensor-product Bézier patch of degrees m, n on [0, 1]^2, stored by its homogeneous
/// poles.
///
/// Row i (n+1) + j of the pole matrix is the pole P[i][j]; i belongs to u (degree m), j to v
/// (degree n).
class BezierPatch {
 public:
  /// Polynomial patch. \param poles (m+1)(n+1) by 3.
  /// \throws std::invalid_argument if the number of rows is not (m+1)(n+1), or a pole is not finite
  /// (its row is named).
  BezierPatch(int degree_u, int degree_v, const Eigen::Ref<const Poles>& poles);
  /// Rational patch. \param weights (m+1)(n+1) positive finite numbers in the order of the poles.
  BezierPatch(int degree_u, int degree_v, const Eigen::Ref<const Poles>& poles,
              const Eigen::Ref<const Eigen::VectorXd>& weights);
  /// The patch with these homogeneous poles, copied bitwise. \throws as the constructors do.
  static BezierPatch fromHomogeneous(int degree_u, int degree_v, HomogeneousPoles poles);

  int degreeU() const { return degree_u_; }
  int degreeV() const { return degree_v_; }
  bool isRational() const;
  Poles poles() const;
  Eigen::VectorXd weights() const { return homogeneous_.col(3); }
  const HomogeneousPoles& homogeneousPoles() const { return homogeneous_; }
  Eigen::Vector3d pole(int i, int j) const;

  Eigen::Vector3d point(double u, double v) const;
  /// Point and partials up to third order at (u, v).
  SurfaceJet jet(double u, double v) const;
  /// Bound of the rounding in the first partials of jet() on [0, 1]^2: 8 (m + n + 4) eps d |P|_max
  /// w_max / w_min with d the degree in that direction. It bounds the error of the evaluation only:
  /// the poles count as exact.
  JetNoise noise() const;

  /// The same patch with u and v exchanged; its natural normal changes sign.
  BezierPatch transposed() const;
  /// The patch X(1 - u, v); its natural normal changes sign.
  BezierPatch reversedU() const;
  /// The pieces over u in [0, t] and [t, 1], each reparametrised to [0, 1].
  std::pair<BezierPatch, BezierPatch> splitU(double t) const;
  /// The iso-line at constant u.
  BezierCurve isoCurveU(double u) const;

  bool operator==(const BezierPatch& other) const {
    return degree_u_ == other.degree_u_ && degree_v_ == other.degree_v_ &&
           homogeneous_ == other.homogeneous_;
  }

 private:
  struct Homogeneous {};
  BezierPatch(Homogeneous, int degree_u, int degree_v, HomogeneousPoles poles)
      : degree_u_(degree_u), degree_v_(degree_v), homogeneous_(std::move(poles)) {}

  int degree_u_;
  int degree_v_;
  HomogeneousPoles homogeneous_;
};

}  // namespace seamwright
