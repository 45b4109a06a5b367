// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// B-spline basis functions over flat, clamped knots; not a public header.
namespace seamwright::bspline {

/// Requires 1 <= degree <= 25.
/// \param suffix suffix of the name in the message, for instance "_u".
/// \throws std::invalid_argument for another degree.
void requireDegree(int degree, const std::string& suffix);

/// Requires that degree and flat knots make a clamped, continuous spline: 1 <= degree <= 25, inner
/// knots of multiplicity at most the degree, and a parameter range that is a normal number.
/// \param suffix suffix of the names in the message, for instance "_u".
/// \throws std::invalid_argument with the index and the value.
void requireKnots(int degree, const std::vector<double>& knots, const std::string& suffix);

/// The index i of the span with knots[i] <= t < knots[i + 1]. For a t below the range it is the
/// first span that is not empty; for a t at the end or above, the last such span.
int spanOf(int degree, const std::vector<double>& knots, double t);

/// The derivatives at t of the degree + 1 basis functions of the span, which belong to the poles
/// span - degree to span. Row k holds the k-th derivatives. Each basis function is taken as its
/// polynomial on the span.
/// \pre knots[span] < knots[span + 1]
Eigen::MatrixXd basisDerivatives(int degree, const std::vector<double>& knots, int span, double t,
                                 int order);

}  // namespace seamwright::bspline
