// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/differential/jet.hpp>

namespace seamwright {

/// A joint of a key frame: the end of a is the beginning of b, with one homogeneous pole.
struct JointFrame {
  BezierCurve a;  ///< arrives
  BezierCurve b;  ///< leaves
};

/// Where linear blending makes a vector shortest.
struct ShortestBlend {
  double omega = 0;        ///< 0..1
  double length_mm = 0;    ///< of (1 - omega) u + omega v
  double rounding_mm = 0;  ///< bound of the error of length_mm
  /// The blended vector is 0 up to rounding.
  bool vanishes() const { return length_mm <= rounding_mm; }
};

/// The smallest |(1 - omega) u + omega v| for omega in [0, 1], in closed form: |u x v| / |u - v| or
/// the shorter end.
///   (1) It vanishes iff v is a multiple of u by a factor <= 0, or one of them is 0.
/// \param rounding_mm bound of the rounding in each of the two vectors, >= 0. Four roundings of
/// their lengths are added.
/// \throws std::invalid_argument, with the value, for vectors that are not finite.
/// Source: docs/theory/curves.md C11.2.
ShortestBlend shortestBlend(const Eigen::Vector3d& u, const Eigen::Vector3d& v,
                            double rounding_mm = 0);

/// Which condition makes linear blending of two joints keep G1 or G2 for all omega in [0, 1].
enum class PlainBlendCase {
  EqualBetas,        ///< both frames have the same betas
  ParallelTangents,  ///< G1: both frames have one tangent direction
  EqualBeta1,        ///< G2: the same beta_1 and one tangent direction
  Straight,          ///< G2: one tangent direction, and no curvature in both frames
  None               ///< no condition holds, or the blended tangent vanishes
};

/// What linear blending of two joints does, with the figures that decide.
struct PlainBlend {
  PlainBlendCase kind = PlainBlendCase::None;
  /// Defects of C2.6 that remain if both frames get the betas of the first: over all orders, and of
  /// order 1.
  double betas_defect = 0, beta1_defect = 0;
  double angle_rad = 0;  ///< between the tangents of the frames, 0..pi
  double ratio = 0;  ///< lambda: the first derivative of a in the second frame by that in the first
  double bend = 0;   ///< the largest L times curvature
  ShortestBlend tangent_a = {}, tangent_b = {};  ///< the blended first derivatives
  /// Derivatives 0..n of both curves in both frames.
  CurveDerivatives first_a, first_b, second_a, second_b;

  bool keeps() const { return kind != PlainBlendCase::None; }
  /// The betas of the blended joint at omega. They are measured (C2.6) on the blended derivatives,
  /// so where the blend does not keep the order they are those that fit best. Fewer than n if
  /// beta_1 is not positive.
  Eigen::VectorXd beta(double omega) const;
};

/// When linear blending of all poles keeps the joint G^n, n = 1 or 2, for all omega in [0, 1].
/// Curves of degree below n are raised first. The conditions are necessary and sufficient
/// (up to the tolerance):
///
///     G1   EqualBetas, ParallelTangents
///     G2   EqualBetas, EqualBeta1, Straight
///
/// and the blended tangents must not vanish.
///
/// Identities (each has a test of its number):
///   (2) If a condition holds, the defects of the blended joint are at most about the tolerance.
///   (3) If none holds, the blended joint is not G^n for some omega.
///   (4) ParallelTangents: beta_1 = ((1 - omega) beta_1^0 + lambda omega beta_1^1) /
///       ((1 - omega) + lambda omega). EqualBeta1: beta_2 likewise.
///   (5) Exchanging the frames turns omega into 1 - omega.
/// \param tolerance largest dimensionless defect, angle or bend that counts as 0.
/// \throws std::invalid_argument for an order other than 1 and 2, rational curves, an invalid
/// tolerance, curves that do not meet, and frames without tangent (with the figures).
/// Source: docs/theory/curves.md C11.2.
PlainBlend plainBlend(const JointFrame& first, const JointFrame& second, int order,
                      double tolerance = 1e-11);

}  // namespace seamwright
