// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/triangle.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>

namespace seamwright {

/// A number with a bound of its error.
struct BoundedChange {
  double value_per_mm2 = 0;
  double error_per_mm2 = 0;
};

/// Normal and curvature of a surface at a point, with bounds of the error that rounding made of
/// them; poles count as exact. The bounds are proved up to rounding in themselves.
struct SurfaceShape {
  /// VanishingNormal: X_u x X_v is within rounding of zero; NotFinite: it, or a curvature, is
  /// beyond the range of a double. All that follows is then 0.
  Degeneracy degeneracy = Degeneracy::None;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of unit length, in the sense of X_u x X_v
  double normal_error_rad = 0;
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();  ///< curvatureTensor()
  double tensor_error_per_mm = 0;  ///< in the spectral norm, so of any normal curvature, too
  /// By two parameters of the surface's own, not u and v: unitNormal(), curvatureTensor() and
  /// curvatureChange() of it are those of the surface.
  SurfaceJet jet;
  /// Bounds of errors in the jet's derivatives: of u and v; of uu, uv and vv; of uuu, uuv, uvv and
  /// vvv.
  std::array<double, 2> first_errors{};
  std::array<double, 3> second_errors{};
  std::array<double, 4> third_errors{};
};

/// Curvatures from jet() lose digits where weights differ by many orders of magnitude: partials by
/// u and v are then nearly parallel to those of lower orders, and curvature is what is left of
/// them. Here the terms of the surface, g_q P_q with q = (i, j) and g_q = C(m, i) C(n, j) w_ij (u /
/// (1-u))^i (v / (1-v))^j, are taken by the parameters a and b in which the largest term q_0 is of
/// order 0, the largest beside it, q_1, of order 1 in a, and the largest not in line with both,
/// q_2, of order 1 in b; the weight has no first derivative. So q_0, q_1, q_2 count in no higher
/// derivative.
///
/// Identities (each has a test of its number):
///   (1) Curvature and change of curvature are those of exact arithmetic, within the bounds,
///       whatever the weights.
///   (2) Of patches with weights 1 they are curvatureTensor() and curvatureChange() of jet(), to
///       rounding.
///   (3) Of a triangle whose corners are permuted they agree within the bounds, up to the sign of
///       the normal.
/// \param u, v finite; outside [0, 1] the weights may cancel, which the bounds include.
/// \throws std::invalid_argument for a parameter that is not finite; if the distance of two poles
/// is not.
SurfaceShape surfaceShape(const BezierPatch& patch, double u, double v);
/// By u = l0, v = l1; g_q = n! / (i! j! k!) w_ij (l0 / l2)^i (l1 / l2)^j.
SurfaceShape surfaceShape(const BezierTriangle& triangle, double l0, double l1);

/// curvatureChange() in the unit tangent direction, with its bound; the direction counts as exact.
/// \pre shape.degeneracy is None.
BoundedChange curvatureChange(const SurfaceShape& shape, const Eigen::Vector3d& direction);

}  // namespace seamwright
