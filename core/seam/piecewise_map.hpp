// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <vector>

/// Not a public header.
namespace seamwright {

/// y as a function of x, both rising or falling. With as many y as x it is linear between them;
/// with three y a piece, and one for the end, it is cubic on each piece: y holds the values at its
/// begin, at a third and at two thirds of it.
struct PiecewiseMap {
  const std::vector<double>& x;
  const std::vector<double>& y;

  std::size_t stride() const { return y.size() > x.size() ? 3 : 1; }
  /// The piece, from 0, that holds a value of x; at a knot the one before it.
  std::size_t pieceAt(double at) const {
    return pieceOf(at, x.size() - 1, [this](std::size_t i) { return x[i]; });
  }
  double begin(std::size_t piece) const { return y[stride() * piece]; }
  double end(std::size_t piece) const { return y[stride() * (piece + 1)]; }
  double shareIn(std::size_t piece, double at) const {
    const double width = x[piece + 1] - x[piece];
    return width == 0 ? 0 : (at - x[piece]) / width;
  }
  /// What the cubic differs by from the chord of a piece.
  double bend(std::size_t piece, double share) const {
    if (stride() == 1) return 0;
    const double* values = &y[3 * piece];
    const double step = (values[3] - values[0]) / 3;
    const double first = values[1] - (values[0] + step),
                 second = values[2] - (values[0] + 2 * step);
    return 4.5 * share * (1 - share) * (first * (2 - 3 * share) + second * (3 * share - 1));
  }
  double valueIn(std::size_t piece, double share) const {
    return begin(piece) + share * (end(piece) - begin(piece)) + bend(piece, share);
  }
  double valueAt(double at) const {
    const std::size_t piece = pieceAt(at);
    return valueIn(piece, shareIn(piece, at));
  }
  /// The x of a value of y.
  double backAt(double value) const {
    const std::size_t piece =
        pieceOf(value, x.size() - 1, [this](std::size_t i) { return y[stride() * i]; });
    const double width = end(piece) - begin(piece);
    double share = width == 0 ? 0 : (value - begin(piece)) / width;
    double low = 0, high = 1;
    // More halvings than a double has digits.
    for (int i = 0; i < 60 && stride() > 1; ++i) {
      share = 0.5 * (low + high);
      ((valueIn(piece, share) < value) == (width > 0) ? low : high) = share;
    }
    return x[piece] + share * (x[piece + 1] - x[piece]);
  }

 private:
  /// \param last the number of the last knot
  template <class Knot>
  static std::size_t pieceOf(double at, std::size_t last, const Knot& knot) {
    const bool rises = knot(last) >= knot(0);
    std::size_t low = 0, high = last;
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      ((rises ? knot(middle) < at : knot(middle) > at) ? low : high) = middle;
    }
    return low;
  }
};

}  // namespace seamwright
