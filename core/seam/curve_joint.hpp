// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/seam/tolerance.hpp>

namespace seamwright {

/// One end of a curve: its derivatives there, in the sense of travel through the joint.
struct CurveEnd {
  CurveDerivatives derivatives;  ///< orders 0..n by the curve's own parameter, (n+1) by 3
  double speed_noise = 0;        ///< what rounding may have added to the first derivative
};

/// How two curves meet. Numbers only; orderReached() says what they amount to.
struct CurveJoint {
  std::optional<double> gap_mm;  ///< nothing where an end is not finite
  std::optional<double>
      angle_rad;  ///< of the tangents in the sense of travel, 0..pi; pi: the curve turns back
  /// |c_k of b - c_k of a| in mm^(1-k) with c_k the k-th derivative by arc length, k = 0..n; empty
  /// where an end has no tangent or is not finite.
  std::vector<double> differences;
  /// The larger |c_k| of both ends, in mm^(1-k), k = 0..n; empty as differences.
  std::vector<double> sizes;
};

/// Measures the joint of a curve \p a that arrives and a curve \p b that leaves.
///
/// Two regular curves meet with G^n iff their derivatives by arc length agree up to order n. That
/// is more than continuous curvature and torsion: c_3 = -kappa^2 T + kappa_s N + kappa tau B.
///
/// Identities (each has a test of its number):
///   (1) Swapping the ends, both reversed, changes no figure.
///   (2) A rigid motion changes no figure; a scale s multiplies differences[k] and sizes[k] (k >=
///       1) by s^(1-k).
///   (3) Reparametrising either curve changes no figure.
///   (4) The two halves of one curve, each in a parameter of its own: all differences are rounding.
///   (5) An arc of radius r, then a clothoid that leaves it with curvature 1/r and its rate c by
///       arc length: differences 0, 0, 0, |c|: G2 and not G3.
///   (6) Arcs of radii r and R on one side of their tangent: differences[2] = |1/r - 1/R|.
///   (7) A cusp, b being a run backwards: angle pi, differences[1] = 2.
///
/// Figures go to the lower order of both ends.
/// \throws std::invalid_argument if an end has no row.
/// Source: docs/theory/curves.md C1.2, C2.1, C2.3, C2.5.
CurveJoint measureJoint(const CurveEnd& a, const CurveEnd& b);

/// The end t = 1 of \p a and the beginning t = 0 of \p b, to that order.
/// \throws std::invalid_argument if the order is negative.
CurveJoint measureJoint(const BezierCurve& a, const BezierCurve& b, int order);

/// differences[k] / s^(k-1) for k >= 2, with s in 1/mm the largest sizes[j]^(1/(j-1)) over j =
/// 2..k: without unit, the same for any size of the curves. s^(k-1) is no smaller than sizes[k], so
/// this is at most 2; and it holds the lower orders, so where c_k vanishes rounding of it counts
/// for nothing. 0 where sizes[k] < (100 / R)^(k-2) / R with R the flat radius: within R / 100 that
/// adds less than the flat curvature 1 / R.
/// \pre 2 <= k < differences.size(); \param flat_radius_mm positive.
/// Source: docs/theory/curves.md C2.5.
double relativeDifference(const CurveJoint& joint, int k, double flat_radius_mm);

/// The geometric continuity of a joint: the largest n up to the order measured for which the gap is
/// <= gap_mm, (n >= 1) the angle <= angle_rad, and (n >= 2) relativeDifference() <= curvature_rel
/// for k = 2..n; -1 if not even the gap.
/// \throws std::invalid_argument for tolerances that are none.
int orderReached(const CurveJoint& joint, const ContinuityTolerance& tolerance);

}  // namespace seamwright
