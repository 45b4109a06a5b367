// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>

#include <seamwright/core/bspline/curve.hpp>

namespace seamwright {

/// A (rational) B-spline curve as modelling kernels hold it: each knot once, its ends clamped or
/// not, or periodic.
struct KnotCurve {
  int degree = 0;
  std::vector<double> knots;  ///< increasing
  /// One a knot, at most the degree, at the ends of an open curve one more. A periodic curve's
  /// first and last are one knot, with one multiplicity.
  std::vector<int> multiplicities;
  /// Open: as many as multiplicities together, less degree + 1. Periodic: as many as all but the
  /// first; pole 0 belongs to the \p degree knots that end with the last copy of the first one.
  HomogeneousPoles poles;
  bool periodic = false;
};

/// Where its polynomials are complete: from one end of a periodic curve to the other, of an open
/// one between the knots that have \p degree others outside them.
std::pair<double, double> rangeOf(const KnotCurve& curve);

/// The curve over [first, last], clamped: de Boor's triangle at both ends, which combines poles
/// convexly however short the spans are. A clamped curve over its range comes back bit by bit.
/// Parameters of a periodic curve may lie in any of its turns; beyond an open one's range the
/// outermost polynomials go on. Identities (each has a test of its number):
///   (1) The same points at the same parameters.
///   (2) Knots and parameters multiplied by a power of two: the same poles, bit by bit.
/// \throws std::invalid_argument if counts do not fit, knots do not increase, a number is not
/// finite, a weight is not positive, first is not below last, and for more than two turns of a
/// periodic curve; with index and value.
BSplineCurve clampedCurve(const KnotCurve& curve, double first, double last);

}  // namespace seamwright
