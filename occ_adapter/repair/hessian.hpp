// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/repair/surface_basis.hpp>

/// Second derivatives of a displacement in the metric of the surface that it displaces. Not a
/// public header.
namespace seamwright::occ {

/// The covariant Hessian of a displacement in an orthonormal frame, as rows of shares: along both
/// axes and, times sqrt(2), mixed. So the sum of squares of the rows is the squared Frobenius norm.
/// \param shares of the displacement at a point.
/// \param jet of the surface there.
/// \param least_metric added to the metric, so that degenerate points have one.
/// Source: docs/theory/repair.md R2.
Eigen::MatrixXd hessianShares(const PoleShares& shares, const SurfaceJet& jet, double least_metric);

}  // namespace seamwright::occ
