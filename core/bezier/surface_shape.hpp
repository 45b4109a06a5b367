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

/// Normal and curvature of a surface at a point, with bounds of the rounding errors; the poles
/// count as exact. The bounds are proved, except for their own rounding.
struct SurfaceShape {
  /// VanishingNormal if X_u x X_v is within rounding of zero. NotFinite if X_u x X_v or a curvature
  /// exceeds the range of a double. In both cases all other members are 0.
  Degeneracy degeneracy = Degeneracy::None;
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  ///< of unit length, in the direction of X_u x X_v
  double normal_error_rad = 0;
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();  ///< curvatureTensor()
  double tensor_error_per_mm = 0;  ///< in the spectral norm, so it holds for any normal curvature
  /// The jet by two parameters of the method, which are not u and v. unitNormal(),
  /// curvatureTensor() and curvatureChange() of this jet are those of the surface.
  SurfaceJet jet;
  /// Error bounds of the derivatives of the jet: of u and v; of uu, uv and vv; of uuu, uuv, uvv and
  /// vvv.
  std::array<double, 2> first_errors{};
  std::array<double, 3> second_errors{};
  std::array<double, 4> third_errors{};
};

/// Normal and curvature at (u, v). Curvatures from jet() lose digits where weights differ by many
/// orders of magnitude: partials by u and v are then nearly parallel to those of lower orders, and
/// curvature is what remains after cancellation.
///
/// This function takes the terms of the surface, g_q P_q with q = (i, j) and g_q = C(m, i) C(n, j)
/// w_ij (u / (1-u))^i (v / (1-v))^j, by two other parameters a and b. The largest term, q_0, is of
/// order 0. The largest term beside it, q_1, is of order 1 in a. The largest term not in line with
/// both, q_2, is of order 1 in b. The weight has no first derivative. So q_0, q_1 and q_2 do not
/// enter higher derivatives.
///
/// Identities (each has a test of its number):
///   (1) Curvature and change of curvature are those of exact arithmetic, within the bounds, for
///       all weights.
///   (2) For patches with weights 1 they are curvatureTensor() and curvatureChange() of jet(),
///       within rounding.
///   (3) They agree, within the bounds and up to the sign of the normal, for a triangle whose
///       corners are permuted.
/// \param u, v finite; outside [0, 1] the weights may cancel, which the bounds include.
/// \throws std::invalid_argument if a parameter, or the distance of two poles, is not finite.
SurfaceShape surfaceShape(const BezierPatch& patch, double u, double v);
/// The same for a triangle, by u = l0 and v = l1; g_q = n! / (i! j! k!) w_ij (l0 / l2)^i (l1 /
/// l2)^j.
SurfaceShape surfaceShape(const BezierTriangle& triangle, double l0, double l1);

/// curvatureChange() in a unit tangent direction, with its error bound; the direction counts as
/// exact.
/// \pre shape.degeneracy is None.
BoundedChange curvatureChange(const SurfaceShape& shape, const Eigen::Vector3d& direction);

}  // namespace seamwright
