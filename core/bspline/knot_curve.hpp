// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <utility>

#include <seamwright/core/bspline/curve.hpp>

namespace seamwright {

/// A (rational) B-spline curve in the form of modelling kernels: each knot occurs once, with a
/// multiplicity. The ends are clamped or not, or the curve is periodic.
struct KnotCurve {
  int degree = 0;
  std::vector<double> knots;  ///< increasing
  /// One multiplicity for each knot: at most the degree, at the ends of an open curve at most the
  /// degree + 1. The first and the last knot of a periodic curve are the same knot and have the
  /// same multiplicity.
  std::vector<int> multiplicities;
  /// Number of poles of an open curve: the sum of the multiplicities minus (degree + 1). Number of
  /// poles of a periodic curve: the sum of all multiplicities except the first; pole 0 belongs to
  /// the \p degree knots that end with the last copy of the first knot.
  HomogeneousPoles poles;
  bool periodic = false;
};

/// The parameter range in which the polynomials of the curve are complete. For a periodic curve it
/// runs from the first knot to the last. For an open curve it lies between the knots that have \p
/// degree other knots outside them.
std::pair<double, double> rangeOf(const KnotCurve& curve);

/// The curve over [first, last], clamped. De Boor's triangle at both ends combines poles convexly,
/// however short the spans are. A clamped curve over its own range is returned bitwise. Parameters
/// of a periodic curve may lie in any of its turns; first may be up to 2^40 periods from its
/// beginning. Beyond the range of an open curve the outermost polynomials continue. Identities
/// (each has a test of its number):
///   (1) The result has the same points at the same parameters.
///   (2) Multiplying knots and parameters by a power of two keeps the poles bitwise.
/// \throws std::invalid_argument, with index and value, if counts do not match, knots do not
/// increase, a number is not finite, a weight is not positive, or first is not below last; for a
/// periodic curve also if the range covers more than two turns or first is too far away.
BSplineCurve clampedCurve(const KnotCurve& curve, double first, double last);

}  // namespace seamwright
