// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/numeric.hpp>

/// Matrices that take the poles of a span to Bézier points and to Chebyshev coefficients.
/// Not a public header.
namespace seamwright {

/// A matrix for degrees up to 25, OpenCASCADE's largest degree, stored without allocation.
using SplineMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                                   max_spline_degree + 1, max_spline_degree + 1>;

/// Column j holds the Chebyshev coefficients on [-1, 1] of the Bernstein polynomial B_j = C(n, j)
/// (1 + x)^j (1 - x)^(n - j) / 2^n of degree n. Each is rounded once: without C(n, j) the
/// coefficients are multiples of 4^-n and at most 1, which are exact doubles.
const SplineMatrix& bezierToChebyshev(int degree);

/// Row j holds the Bézier point j of the span [knots[s], knots[s + 1]] as a combination of the
/// degree + 1 poles of the span, by blossoming.
SplineMatrix splineToBezier(const std::vector<double>& knots, int degree, int s);

/// The factors that turn differences of neighbouring poles into the poles of the derivative on the
/// span
/// [knots[s], knots[s + 1]]; none for degree 0.
Eigen::VectorXd derivativeFactors(const std::vector<double>& knots, int degree, int s);

}  // namespace seamwright
