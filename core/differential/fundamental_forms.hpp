// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include <seamwright/core/differential/jet.hpp>

namespace seamwright {

/// First fundamental form: E = X_u.X_u, F = X_u.X_v, G = X_v.X_v.
struct FirstForm {
  double E = 0;
  double F = 0;
  double G = 0;
  double determinant() const { return E * G - F * F; }
};

/// Second fundamental form for the unit normal n: L = n.X_uu, M = n.X_uv, N = n.X_vv.
struct SecondForm {
  double L = 0;
  double M = 0;
  double N = 0;
};

/// Why a surface has no tangent plane at a point.
enum class Degeneracy {
  None,             ///< it has a tangent plane
  VanishingNormal,  ///< |X_u x X_v| is within rounding of zero: a pole, a cusp, a collapsed edge
  NotFinite         ///< the jet holds infinities or NaN
};

std::string_view name(Degeneracy degeneracy);

/// Decides whether X_u x X_v has a reliable direction.
///
/// VanishingNormal iff |X_u x X_v| <= noise.u |X_v| + noise.v |X_u| + noise.u noise.v: the cross
/// product may then be rounding alone. With zero noise only a normal that vanishes exactly counts.
Degeneracy degeneracy(const SurfaceJet& jet, const JetNoise& noise = {});

/// Unit normal X_u x X_v / |X_u x X_v|; nothing where degeneracy() is not None.
std::optional<Eigen::Vector3d> unitNormal(const SurfaceJet& jet, const JetNoise& noise = {});

FirstForm firstForm(const SurfaceJet& jet);

/// \param normal unit normal; the opposite normal changes the sign of the form.
SecondForm secondForm(const SurfaceJet& jet, const Eigen::Vector3d& normal);

/// The curvature tensor of a surface at a point as a symmetric 3 by 3 matrix W in space, in 1/mm.
///
/// For a unit tangent vector d the normal curvature is d.W d. The eigenvectors of W are the
/// principal directions and the normal, with eigenvalues k1, k2 and 0. W does not depend on the
/// parametrisation: W = J I^-1 II I^-1 J^T with J = [X_u X_v].
///
/// Identities (each has a test of its number):
///   (1) W n = 0 and W = W^T.
///   (2) W changes sign with the normal.
///   (3) trace W = k1 + k2 = (E N - 2 F M + G L) / (E G - F^2).
///   (4) k1 k2 = (L N - M^2) / (E G - F^2).
///   (5) W is the same for X(u, v) and X(u(a, b), v(a, b)) if the map keeps the orientation.
///   (6) Under a rotation R it becomes R W R^T, under a scale s it becomes W / s.
///
/// \pre degeneracy(jet) is None; \p normal is the unit normal or its negative.
/// Source: docs/theory/surfaces.md S1.4; [doCarmo1976].
Eigen::Matrix3d curvatureTensor(const SurfaceJet& jet, const Eigen::Vector3d& normal);

/// The change of curvature in a tangent direction d: the derivative by arc length of the curvature
/// of the normal section along d, in 1/mm^2.
///
/// It is f_ddd, the third derivative along d of the height f of the surface over its tangent plane.
/// It is also (D II)(d, d, d), the covariant derivative of the second fundamental form. The formula
/// is n.(D3X[v1, v1, v1] + 3 D2X[v1, v2]): v1 is the parameter vector of d, and v2 that of minus
/// the tangential part of D2X[v1, v1].
///
/// Identities (each has a test of its number):
///   (1) It changes sign with the normal and with the direction.
///   (2) It does not depend on the parametrisation.
///   (3) A rigid motion of all three arguments changes nothing; a scale s divides it by s^2.
///   (4) Spheres, cylinders and planes: 0 in all directions.
///   (5) Surfaces of revolution with straight or circular meridian (cone, torus): 3 cos^2(a) sin(a)
///       dk/ds at the angle a from the parallel, k the normal curvature along the parallel and s
///       the arc length of the meridian.
///   (6) The graph z = (quadratic form) + (cubic form c) + ... over its tangent plane: 6 c(d).
///
/// \param jet jet with third partials.
/// \pre degeneracy(jet) is None; \p normal is the unit normal or its negative; \p direction is a
/// unit vector of the tangent plane.
/// \returns the change of curvature; not finite if third partials are not finite or exceed the
/// range of a double.
/// Source: docs/theory/surfaces.md S1.6.
double curvatureChange(const SurfaceJet& jet, const Eigen::Vector3d& normal,
                       const Eigen::Vector3d& direction);

/// Principal curvatures k1 >= k2 with their unit directions. At an umbilic (k1 = k2) the directions
/// are any orthonormal pair.
struct PrincipalCurvatures {
  double k1 = 0;
  double k2 = 0;
  Eigen::Vector3d direction1 = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction2 = Eigen::Vector3d::Zero();
};

/// \pre The same as for curvatureTensor().
PrincipalCurvatures principalCurvatures(const SurfaceJet& jet, const Eigen::Vector3d& normal);

/// A symmetric bilinear form on a tangent plane, as the matrix [[xx, xy], [xy, yy]] in an
/// orthonormal basis of that plane.
struct PlaneTensor {
  double xx = 0;
  double xy = 0;
  double yy = 0;
  /// Largest absolute eigenvalue.
  double spectralNorm() const;
};

/// The part of a symmetric space tensor that acts in the plane of normal \p normal.
/// \param x unit vector of the plane; the second basis vector is normal x x.
PlaneTensor restrictToPlane(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& normal,
                            const Eigen::Vector3d& x);

}  // namespace seamwright
