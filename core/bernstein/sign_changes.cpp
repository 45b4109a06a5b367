// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include <seamwright/core/bernstein/sign_changes.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// -1 or 1 if all numbers of the interval have this sign, else 0.
int signOf(const Interval& values) {
  if (values.lower > 0) return 1;
  return values.upper < 0 ? -1 : 0;
}

/// A part of [0, 1] and the sign there; 0 if it is open.
struct Part {
  Interval domain;
  int sign = 0;
};

/// A piece of the polynomial, over a part of [0, 1].
struct SignPiece {
  BernsteinPolynomial polynomial;
  Interval domain;
};

/// Whether the padding hides most of what the coefficients say. Smaller pieces say no more then,
/// since a split adds padding.
bool hidden(const BernsteinPolynomial& piece) {
  return piece.coefficients().cwiseAbs().maxCoeff() <= 4 * piece.padding();
}

/// Parts of [0, 1] in their order, neighbours of different signs. Open parts are narrower than the
/// width, or hidden by the padding, or several of these side by side.
std::vector<Part> partsBySign(const BernsteinPolynomial& polynomial, double width) {
  std::vector<Part> parts;
  std::vector<SignPiece> pieces = {{.polynomial = polynomial, .domain = {0, 1}}};
  while (!pieces.empty()) {
    const SignPiece piece = std::move(pieces.back());
    pieces.pop_back();
    const int sign = signOf(piece.polynomial.range());
    if (sign == 0 && piece.domain.width() > width && !hidden(piece.polynomial)) {
      const double middle = piece.domain.middle();
      auto [left, right] = piece.polynomial.split(0.5);
      pieces.push_back({.polynomial = std::move(right), .domain = {middle, piece.domain.upper}});
      pieces.push_back({.polynomial = std::move(left), .domain = {piece.domain.lower, middle}});
    } else if (!parts.empty() && parts.back().sign == sign) {
      parts.back().domain.upper = piece.domain.upper;
    } else {
      parts.push_back({.domain = piece.domain, .sign = sign});
    }
  }
  return parts;
}

}  // namespace

SignChanges signChanges(const BernsteinPolynomial& polynomial, double width) {
  // Down to this width the middles of intervals are doubles without rounding.
  constexpr double smallest_width = 0x1p-48;
  if (!(width >= smallest_width && width <= 1))
    refuse(
        fmt::format("the width of the intervals is {}, not from {} to 1", width, smallest_width));
  const BernsteinPolynomial slope = polynomial.derivative();
  const std::vector<Part> parts = partsBySign(polynomial, width);
  SignChanges result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].sign != 0) continue;
    const Interval& open = parts[i].domain;
    const bool opposite =
        i > 0 && i + 1 < parts.size() && parts[i - 1].sign * parts[i + 1].sign < 0;
    if (opposite && signOf(slope.restricted(open).range()) != 0)
      result.changes.push_back({.interval = open, .to_positive = parts[i + 1].sign > 0});
    else
      result.undecided.push_back(open);
  }
  return result;
}

}  // namespace seamwright
