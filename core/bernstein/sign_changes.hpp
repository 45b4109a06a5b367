// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/bernstein/polynomial.hpp>

namespace seamwright {

/// An interval in which a polynomial changes its sign exactly once.
struct SignChange {
  Interval interval;
  bool to_positive = false;  ///< from below 0 to above 0
};

/// The sign of a polynomial on [0, 1].
struct SignChanges {
  std::vector<SignChange> changes;  ///< in the order of the parameter
  /// Intervals in which rounding hides the sign: a zero at an end of [0, 1], a zero without a sign
  /// change, several zeros close together.
  std::vector<Interval> undecided;
};

/// The sign changes of a polynomial on [0, 1], isolated by subdivision. Outside of the intervals
/// returned the polynomial is certainly not 0. Identities (each has a test of its number):
///   (1) A polynomial with known simple zeros inside of (0, 1) has one change around each of them.
///   (2) The changes of -p are those of p, in the other direction.
///   (3) A polynomial that is 0 up to its padding has one undecided interval: [0, 1].
///   (4) A double zero is in an undecided interval.
/// \param width largest width of an interval around a simple zero, unless the padding hides the
/// sign on a larger one. An undecided interval is wider if the padding is.
/// \throws std::invalid_argument if the width is not in [2^-48, 1].
/// Source: docs/theory/enclosures.md E1.1 to E1.3.
SignChanges signChanges(const BernsteinPolynomial& polynomial, double width = 0x1p-40);

}  // namespace seamwright
