// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/differential/jet.hpp>

namespace seamwright {

/// Derivatives of a curve by its arc length s, from those by any regular parameter. c_0 is the
/// point, c_1 the unit tangent, c_2 the curvature vector and c_k = d^k X / ds^k in mm^(1-k). Two
/// curves meet with G^n iff c_0..c_n agree.
///
/// c_{k+1} is the derivative of c_k divided by the speed. The computation uses power series of X'
/// and of 1/|X'| = (X'.X')^(-1/2), cut off at the order that is still needed, in O(n^3) operations.
/// The parameter is first scaled to unit speed.
///
/// Identities (each has a test of its number):
///   (1) A circle of radius r: c_k = (N, -T, -N, T, ...) / r^(k-1) for k = 2, 3, 4, 5, ...
///   (2) c_2 = kappa N, c_3 = -kappa^2 T + kappa_s N + kappa tau B.
///   (3) Independent of the parameter, if its direction is kept. Reversing the parameter changes
///       the sign of c_k for odd k.
///   (4) A rigid motion moves c_0 and turns the others; a scale s multiplies c_k by s^(1-k).
///   (5) The arc-length derivatives of arc-length derivatives are the same numbers.
///
/// \param derivatives derivatives by the parameter, orders 0..n, (n+1) by 3.
/// \param speed_noise bound of the rounding in the first derivative.
/// \returns c_0..c_n, (n+1) by 3. Nothing where the tangent is lost (|X'| <= speed_noise) or a
/// number is not finite. For n = 0 the point alone.
/// \throws std::invalid_argument if there is no row.
/// Source: docs/theory/curves.md C1.2.
std::optional<CurveDerivatives> arcLengthDerivatives(const CurveDerivatives& derivatives,
                                                     double speed_noise = 0);

}  // namespace seamwright
