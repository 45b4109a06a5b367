// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/fill/n_sided_fill.hpp>

namespace seamwright {

/// The patches of a fill as splines that keep the tangent planes of both sides of a corner with a
/// twist defect within \p angle_rad.
///
/// No patch that is C^2 at the corner can meet both sides there, so its tangent plane has to
/// deviate from theirs. These splines deviate only along the last 2^-K of the two halves next to
/// the corner, by 2^-K of the deviation of the patch. K is the least number, at most 12, for which
/// the bound is within the angle. The bound is FillCorner::angle_bound_rad less plane_angle_rad,
/// which no fill can remove. The splines have knots of multiplicity 2 (C^(N-2)) at 1 - 2^-k, k =
/// 1..K+2, in u and v. With beta(x) = x (1 - x)^(N - 1), h_k = 2^-k, beta_k(t) = h_k beta((1 - t) /
/// h_k) for 1 - h_k <= t, else 0, phi_0 = beta_0 and phi_k = 2 beta_k - beta_(k+1), which is
/// straight where t = 1,
///   Q_K(u, v) = Q(u, v) + delta / 4 sum_(k <= K) (phi_(k+1)(u) phi_k(v) - phi_k(u) phi_(k+1)(v))
///   times the normal at the corner,
/// which changes no point of the sides and nothing up to second order at the spokes. It changes the
/// second derivatives by a bounded multiple of delta for any K: terms of one k are of size h_k^2
/// over a square of size h_k. Because phi_k is straight, second derivatives across the sides change
/// only by the part of phi_0, see (4). This change vanishes at the corner, so the curvature across
/// the sides stays there.
///
/// Identities (each has a test of its number):
///   (1) Points of all four edges, and first and second derivatives at the spokes, equal those of
///       the patch.
///   (2) Outside the last 2^-K before the corner the cross-boundary derivative is in the tangent
///       planes, as polynomials. Inside, the angle is at most 2^-K of the bound.
///   (3) Without defects the splines are the patches.
///   (4) Second derivatives across the sides change by (N - 1) / 2 delta phi_1 times the normal
///       where u = 1, by minus that where v = 1.
///
/// \throws std::invalid_argument for an angle that is not positive.
/// Source: docs/theory/fills.md F3.1, F3.2.
std::vector<BSplineSurface> withCornerKnots(const NSidedFill& fill, double angle_rad);

}  // namespace seamwright
