// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/core/differential/fundamental_forms.hpp>

namespace seamwright {

/// One side of a seam at one point.
struct SidePoint {
  SurfaceJet jet;
  JetNoise noise;
  /// Tangent of the seam in the direction of its parameter, of any length; zero if unknown.
  Eigen::Vector3d tangent = Eigen::Vector3d::Zero();
  /// The face lies to the left of the tangent when seen from the tip of X_u x X_v.
  bool face_on_left = true;
  /// The jet holds third partials.
  bool third_order = false;
};

/// The difference of two curvature tensors at a point, with normals aligned; all in 1/mm.
struct CurvatureDifference {
  double difference_per_mm = 0;  ///< largest difference of normal curvature over all directions
  double norm_a_per_mm = 0;      ///< largest absolute normal curvature of side a
  double norm_b_per_mm = 0;      ///< largest absolute normal curvature of side b
};

/// The difference of the changes of curvature across a seam, for the same direction on both sides
/// and with normals aligned; all in 1/mm^2.
struct CurvatureChange {
  double difference_per_mm2 = 0;  ///< |f_bbb of side b - f_bbb of side a|
  double change_a_per_mm2 = 0;    ///< |f_bbb of side a|
  double change_b_per_mm2 = 0;    ///< |f_bbb of side b|
};

/// How two surfaces meet at one pair of corresponding points. The struct holds numbers only;
/// judge() judges them.
struct PairMeasure {
  std::optional<double> gap_mm;                     ///< nothing if a side is not finite
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on side a
  Degeneracy degenerate_a = Degeneracy::None;
  Degeneracy degenerate_b = Degeneracy::None;
  /// Angle between the tangent planes, 0..pi/2; nothing if a side has no tangent plane.
  std::optional<double> angle_rad;
  /// The faces leave the seam to the same side: one turns back over the other by more than 90
  /// degrees. False also where the tangents of both sides contradict each other.
  bool fold = false;
  /// Nothing if a side has no tangent plane, or if the curvature exceeds the range of a double.
  std::optional<CurvatureDifference> curvature;
  /// Nothing also if a jet has no third partials or if the sides disagree on the seam's tangent.
  std::optional<CurvatureChange> curvature_change;
};

/// Measures gap, tangent-plane angle and curvature difference of two surface points; from jets of
/// third order also the difference of the change of curvature. docs/seams.md explains the figures.
///
///     const PairMeasure figures = measurePair({.jet = a, .tangent = t}, {.jet = b, .tangent = t});
///
/// The angle is atan2(|n_a x n_b|, |n_a . n_b|). For the curvature n_b is aligned with n_a, the
/// smallest rotation that takes n_b to n_a turns the tensor of b, and the figure is the spectral
/// norm of the difference. The change of curvature is f_bbb of curvatureChange() in the direction B
/// = N x T across the seam, T its tangent. Where the sides are G2 all along the seam they are G3
/// iff f_bbb agrees; elsewhere it is one of four numbers.
///
/// Identities (each has a test of its number):
///   (1) Swapping the sides, or reversing the seam, changes no figure.
///   (2) Reversing either normal (swap of u and v) changes no figure and does not hide a fold.
///   (3) A rigid motion of both sides changes no figure; scaling by s multiplies gap by s,
///       curvature by 1/s, its change by 1/s^2.
///   (4) Reparametrising either side changes no figure.
///   (5) Cylinders of radius R have a common tangent plane and axes at the angle phi: the
///       difference is sin(phi) / R.
///   (6) Spheres of radii r and R touch from the same side: the difference is |1/r - 1/R|.
///   (7) Q(u, t) = P(s(u, t), tau(u, t)) + X(t) u^3 / 6 + ... along u = 0, s = 1: the difference of
///       the change of curvature is |N.X| / |Q_u.B|^3.
///
/// The result names degenerate input (no tangent plane, not finite). No figure is ever NaN or
/// infinite.
/// Source: docs/theory/surfaces.md S1.2, S1.3, S1.5, S1.6; [PegnaWolter1992].
PairMeasure measurePair(const SidePoint& a, const SidePoint& b);

/// The difference divided by the larger norm, 0..2: 1 beside a plane. It is 0 where both sides are
/// flatter than the flat radius. Where only one is, it is not 1 as in ISO 10303-59: two sides of
/// nearly the same curvature, just below and above 1 / R, are nearly smooth.
/// \param flat_radius_mm positive.
double relativeDifference(const CurvatureDifference& curvature, double flat_radius_mm);

/// The difference divided by the largest of both changes and k^2, with k the larger of both
/// curvature norms; 0..2. For a normal section, difference / k^2 is the jump of d(radius)/ds. 0
/// where both changes are below 100 / R^2 with R the flat radius: within R / 100 they add less than
/// the flat curvature 1 / R.
/// \param flat_radius_mm positive.
double relativeChange(const CurvatureChange& change, const CurvatureDifference& curvature,
                      double flat_radius_mm);

}  // namespace seamwright
