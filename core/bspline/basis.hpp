// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

/// B-spline basis functions over flat, clamped knots; not a public header.
namespace seamwright::bspline {

/// 1 <= degree <= 25. \param suffix of the name in the message, as "_u".
void requireDegree(int degree, const std::string& suffix);

/// That degree and flat knots make a clamped spline that is continuous: 1 <= degree <= 25, inner
/// knots of multiplicity at most the degree, a range that is a normal number. \param suffix of the
/// names in the message, as "_u".
/// \throws std::invalid_argument with the index and the value.
void requireKnots(int degree, const std::vector<double>& knots, const std::string& suffix);

/// The index i of the span with knots[i] <= t < knots[i + 1]; the first (last) span that is not
/// empty for a t below (at or above) the range.
int spanOf(int degree, const std::vector<double>& knots, double t);

/// Row k holds the k-th derivatives at t of the degree + 1 basis functions of the span (those of
/// poles span - degree to span), each the polynomial that it is on the span. \pre knots[span] <
/// knots[span + 1]
Eigen::MatrixXd basisDerivatives(int degree, const std::vector<double>& knots, int span, double t,
                                 int order);

}  // namespace seamwright::bspline
