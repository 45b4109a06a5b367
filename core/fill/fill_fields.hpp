// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <seamwright/core/fill/n_sided_fill.hpp>

/// The cross-boundary derivatives of a fill along sides with tangent planes; not a public header.
namespace seamwright::fill {

/// c = 2 cos(2 pi / n), exactly 0 for n = 4. The n tangents r_k of a regular polygon have r_(k+1) =
/// c r_k - r_(k-1).
inline double starFactor(int n) {
  return n == 4 ? 0 : 2 * std::cos(2 * std::numbers::pi / n);
}

/// a'(1) of the law.
inline double slopeAtSide(SpokeLaw law, int n) {
  return law == SpokeLaw::Quadratic ? 0 : -starFactor(n);
}

/// The derivative of the fill out of the hole along the halves [0, 1/2] and [1/2, 1] of a side,
/// each in the degree of the patches.
struct SideField {
  std::array<Poles, 2> halves;
  FillSideJoin joins;
};

struct CrossBoundaryDerivatives {
  std::vector<std::optional<SideField>> sides;  ///< nothing: position alone
  std::vector<FillCorner> corners;
};

/// \throws as nSidedFill() does for corners.
/// Source: docs/theory/fills.md F2.1 to F2.3, F3.1.
CrossBoundaryDerivatives crossBoundaryDerivatives(const std::vector<FillSide>& sides, SpokeLaw law,
                                                  int degree, double tolerance_rad);

/// The coefficients of a polynomial on [0, 1/2] and on [1/2, 1].
std::array<Poles, 2> halved(const Poles& coefficients);

}  // namespace seamwright::fill
