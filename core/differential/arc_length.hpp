// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/differential/jet.hpp>

namespace seamwright {

/// Derivatives of a curve by its arc length s, from those by any regular parameter: c_0 is the
/// point, c_1 the unit tangent, c_2 the curvature vector, c_k = d^k X / ds^k in mm^(1-k). Two
/// curves meet with G^n iff c_0..c_n agree.
///
/// c_{k+1} is the derivative of c_k divided by the speed: with power series of X' and of 1/|X'| =
/// (X'.X')^(-1/2), cut off at the order that is left, in O(n^3) operations. The parameter is scaled
/// to unit speed first.
///
/// Identities (each has a test of its number):
///   (1) A circle of radius r: c_k = (N, -T, -N, T, ...) / r^(k-1) for k = 2, 3, 4, 5, ...
///   (2) c_2 = kappa N, c_3 = -kappa^2 T + kappa_s N + kappa tau B.
///   (3) Independent of the parameter, if the sense is kept; reversing it changes the sign of c_k
///       for odd k.
///   (4) A rigid motion moves c_0 and turns the others; a scale s multiplies c_k by s^(1-k).
///   (5) Arc-length derivatives are their own arc-length derivatives.
///
/// \param derivatives by the parameter, of orders 0..n, (n+1) by 3.
/// \param speed_noise what rounding may have added to the first derivative.
/// \returns c_0..c_n, (n+1) by 3; nothing where the tangent is lost (|X'| <= speed_noise) or a
/// number is not finite. With n = 0 the point alone.
/// \throws std::invalid_argument if there is no row.
/// Source: docs/theory/curves.md C1.2.
std::optional<CurveDerivatives> arcLengthDerivatives(const CurveDerivatives& derivatives,
                                                     double speed_noise = 0);

}  // namespace seamwright
