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
};

/// The difference of two curvature tensors at a point, normals aligned; all in 1/mm.
struct CurvatureDifference {
  double difference_per_mm = 0;  ///< largest difference of normal curvature over all directions
  double norm_a_per_mm = 0;      ///< largest absolute normal curvature of side a
  double norm_b_per_mm = 0;      ///< and of side b
};

/// How two surfaces meet at one pair of corresponding points. Numbers only; judge() says what they amount to.
struct PairMeasure {
  std::optional<double> gap_mm;                     ///< nothing where a side is not finite
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on side a
  Degeneracy degenerate_a = Degeneracy::None;
  Degeneracy degenerate_b = Degeneracy::None;
  /// Angle between the tangent planes, 0..pi/2; nothing where a side has no tangent plane.
  std::optional<double> angle_rad;
  /// The faces leave the seam to the same side, turning back by more than 90 degrees: the tangent planes of a knife edge
  /// agree as they do in a smooth join. False also where the tangents of the two sides contradict one another.
  bool fold = false;
  /// Nothing where a side has no tangent plane, or where the curvature leaves the range of a double.
  std::optional<CurvatureDifference> curvature;
};

/// Measures gap, tangent-plane angle and curvature difference of two surface points.
///
/// The angle is atan2(|n_a x n_b|, |n_a . n_b|). For the curvature, the tensor of b (with n_b on the side of
/// n_a) is turned by the smallest rotation that takes n_b to n_a, which for two planes through the seam's
/// tangent is the rotation about that tangent; the figure is the spectral norm of the difference in the
/// common plane.
///
/// Identities (each has a test of its number):
///   (1) Swapping the sides changes no figure.
///   (2) Reversing either normal (swap of u and v) changes no figure but may not hide a fold.
///   (3) A rigid motion of both sides changes no figure; scaling by s multiplies gap by s, curvature by 1/s.
///   (4) Reparametrising either side changes no figure.
///   (5) Cylinders of radius R crossed at angle phi at a common tangent plane: difference sin(phi) / R.
///   (6) Spheres of radii r and R that touch from the same side: difference |1/r - 1/R|.
///
/// Degenerate input (no tangent plane, not finite) is named in the result; no figure is ever NaN or infinite.
/// Source: MATH-surfaces 1.2 (angle, fold), 1.3 and 1.4 (M2').
PairMeasure measurePair(const SidePoint& a, const SidePoint& b);

/// The difference divided by the larger norm. 0 where both sides are flatter than the flat radius, 1 where
/// only one is (the flat rule of ISO 10303-59). \param flat_radius_mm positive.
double relativeDifference(const CurvatureDifference& curvature, double flat_radius_mm);

}  // namespace seamwright
