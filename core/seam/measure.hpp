// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/core/differential/fundamental_forms.hpp>

namespace seamwright {

/// What one side of a seam shows at one point of it.
struct SidePoint {
  SurfaceJet jet;
  JetNoise noise;
  /// Tangent of the seam in the sense of its parameter, any length; zero if unknown.
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
  /// The face lies to the left of the tangent when seen from the tip of X_u x X_v.
  bool face_on_left = true;
  /// The jet holds third partials.
  bool third_order = false;
};

/// The difference of two curvature tensors at a point, normals aligned; all in 1/mm.
struct CurvatureDifference {
  double difference_per_mm = 0;  ///< largest difference of normal curvature over all directions
  double norm_a_per_mm = 0;      ///< largest absolute normal curvature of side a
  double norm_b_per_mm = 0;      ///< and of side b
};

/// The difference of the changes of curvature across a seam, in the sense of one and the same
/// direction and with normals aligned; all in 1/mm^2.
struct CurvatureChange {
  double difference_per_mm2 = 0;  ///< |f_bbb of side b - f_bbb of side a|
  double change_a_per_mm2 = 0;    ///< |f_bbb of side a|
  double change_b_per_mm2 = 0;    ///< and of side b
};

/// How two surfaces meet at one pair of corresponding points. Numbers only; judge() says what they
/// amount to.
struct PairMeasure {
  std::optional<double> gap_mm;                     ///< nothing where a side is not finite
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on side a
  Degeneracy degenerate_a = Degeneracy::None;
  Degeneracy degenerate_b = Degeneracy::None;
  /// Angle between the tangent planes, 0..pi/2; nothing where a side has no tangent plane.
  std::optional<double> angle_rad;
  /// The faces leave the seam to the same side, turning back by more than 90 degrees: the tangent
  /// planes of a knife edge agree as they do in a smooth join. False also where the tangents of the
  /// two sides contradict one another.
  bool fold = false;
  /// Nothing where a side has no tangent plane, or where the curvature leaves the range of a
  /// double.
  std::optional<CurvatureDifference> curvature;
  /// Nothing where, moreover, a jet has no third partials or the seam has no tangent on which the
  /// sides agree.
  std::optional<CurvatureChange> curvature_change;
};

/// Measures gap, tangent-plane angle, curvature difference and, from jets of third order, the
/// difference of the change of curvature of two surface points.
///
/// The angle is atan2(|n_a x n_b|, |n_a . n_b|). For the curvature, the tensor of b (with n_b on
/// the side of n_a) is turned by the smallest rotation that takes n_b to n_a, which for two planes
/// through the seam's tangent is the rotation about that tangent; the figure is the spectral norm
/// of the difference in the common plane.
///
/// The change of curvature is that across the seam, f_bbb of curvatureChange() in the direction B =
/// N x T with T the tangent of the seam, which is perpendicular to the seam in the side's own
/// tangent plane; the rotation about T that takes one tangent plane to the other takes one B to the
/// other. Where the sides are
/// G2 all along the seam the third orders of both can differ in no other number, and they are G3
/// iff f_bbb agrees. Elsewhere it is one of the four numbers of (D II).
///
/// Identities (each has a test of its number):
///   (1) Swapping the sides, or reversing the seam, changes no figure.
///   (2) Reversing either normal (swap of u and v) changes no figure but may not hide a fold.
///   (3) A rigid motion of both sides changes no figure; scaling by s multiplies gap by s,
///       curvature by 1/s, its change by 1/s^2.
///   (4) Reparametrising either side changes no figure.
///   (5) Cylinders of radius R crossed at angle phi at a common tangent plane: difference sin(phi)
///       / R.
///   (6) Spheres of radii r and R that touch from the same side: difference |1/r - 1/R|.
///   (7) Q(u, t) = P(s(u, t), tau(u, t)) + X(t) u^3 / 6 + ... along u = 0, s = 1: difference of the
///       change of curvature |N.X| / |Q_u.B|^3.
///
/// Degenerate input (no tangent plane, not finite) is named in the result; no figure is ever NaN or
/// infinite.
/// Source: docs/theory/surfaces.md S1.2, S1.3, S1.5, S1.6; [PegnaWolter1992].
PairMeasure measurePair(const SidePoint& a, const SidePoint& b);

/// The difference divided by the larger norm. 0 where both sides are flatter than the flat radius,
/// 1 where only one is (the flat rule of ISO 10303-59). \param flat_radius_mm positive.
double relativeDifference(const CurvatureDifference& curvature, double flat_radius_mm);

/// The difference divided by the largest of both changes and k^2, with k the larger of both
/// curvature norms;
/// 0..2.
///
/// Difference / k^2 is, for a normal section of curvature k, the jump of d(radius)/ds. Where a
/// change is larger than k^2 (an inflection, a spiral that starts from a line) it is the share of
/// that change. 0 where both changes are below 100 / R^2 with R the flat radius: within R / 100, 1
/// m by default, they add less than the flat curvature 1 / R. (Poles rounded to 1e-7 mm show
/// changes of 1e-9 per mm^2 where there are none.) Scaling the sides and R changes nothing.
/// \param flat_radius_mm positive.
double relativeChange(const CurvatureChange& change, const CurvatureDifference& curvature,
                      double flat_radius_mm);

}  // namespace seamwright
