// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {

/// One end of a curve: the derivatives there, in the direction of travel through the joint.
struct CurveEnd {
  CurveDerivatives derivatives;  ///< orders 0..n by the parameter of the curve, (n+1) by 3
  double speed_noise = 0;        ///< bound of the rounding in the first derivative
};

/// How two curves meet. The struct holds numbers only; orderReached() judges them.
struct CurveJoint {
  std::optional<double> gap_mm;     ///< nothing if an end is not finite
  std::optional<double> angle_rad;  ///< between the tangents in the direction of travel, 0..pi; pi:
                                    ///< the curve turns back
  /// |c_k of b - c_k of a| in mm^(1-k) for k = 0..n, with c_k the k-th derivative by arc length.
  /// Empty if an end has no tangent or is not finite.
  std::vector<double> differences;
  /// The larger |c_k| of both ends in mm^(1-k), k = 0..n. Empty where differences is empty.
  std::vector<double> sizes;
};

/// Measures the joint of a curve \p a that arrives and a curve \p b that leaves.
///
/// Two regular curves meet with G^n iff their derivatives by arc length agree up to order n. This
/// asks for more than continuous curvature and torsion: c_3 = -kappa^2 T + kappa_s N + kappa tau B.
///
/// Identities (each has a test of its number):
///   (1) Swapping the ends and reversing both changes no figure.
///   (2) A rigid motion changes no figure; a scale s multiplies differences[k] and sizes[k] (k >=
///       1) by s^(1-k).
///   (3) Reparametrising either curve changes no figure.
///   (4) For the two halves of one curve, each with its own parameter, all differences are rounding
///       only.
///   (5) An arc of radius r meets a clothoid that starts with curvature 1/r and changes it at the
///       rate c by arc length: the differences are 0, 0, 0, |c|, so the joint is G2 and not G3.
///   (6) Arcs of radii r and R lie on one side of their common tangent: differences[2] = |1/r -
///       1/R|.
///   (7) A cusp where b is a run backwards: the angle is pi, and differences[1] = 2.
///
/// The figures go up to the lower of the orders of both ends.
/// \throws std::invalid_argument if an end has no row.
/// Source: docs/theory/curves.md C1.2, C2.1, C2.3, C2.5.
CurveJoint measureJoint(const CurveEnd& a, const CurveEnd& b);

/// Measures the joint of the end t = 1 of \p a and the beginning t = 0 of \p b, up to \p order.
/// \throws std::invalid_argument if the order is negative.
CurveJoint measureJoint(const BezierCurve& a, const BezierCurve& b, int order);

/// The quotient differences[k] / s^(k-1) for k >= 2. s in 1/mm is the largest sizes[j]^(1/(j-1))
/// over j = 2..k. The quotient has no unit and does not depend on the scale of the curves. s^(k-1)
/// is at least sizes[k], so the quotient is at most 2. s includes the lower orders, so rounding of
/// a c_k that vanishes does not count.
///
/// The result is 0 where sizes[k] < (100 / R)^(k-2) / R with R the flat radius: over a length of R
/// / 100 such a derivative adds less than the flat curvature 1 / R.
/// \pre 2 <= k < differences.size().
/// \param flat_radius_mm positive.
/// Source: docs/theory/curves.md C2.5.
double relativeDifference(const CurveJoint& joint, int k, double flat_radius_mm);

/// The geometric continuity of a joint: the largest n, up to the order measured, that meets all of
/// these conditions. The gap is <= gap_mm. For n >= 1 the angle is <= angle_rad. For n >= 2
/// relativeDifference() is <= curvature_rel for all k = 2..n. The result is -1 if the gap exceeds
/// gap_mm.
/// \throws std::invalid_argument for invalid tolerances.
int orderReached(const CurveJoint& joint, const ContinuityTolerance& tolerance);

}  // namespace seamwright
