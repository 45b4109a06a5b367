// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace seamwright {

/// The length of a path as a function of its parameter in [0, 1], and the inverse function. Not a
/// public header.
///
/// The speed is taken at some points, once. Its Chebyshev interpolants on pieces, which are halved
/// until their last coefficients are rounding, are integrated exactly.
///
///   (1) parameterAt() is the inverse of lengthTo(), up to rounding.
///   (2) The length to a parameter is that to a break plus that from there: a jump of the speed at
///   a
///       break spoils no digit.
class PathLength {
 public:
  /// \param speed_mm the length of the derivative at a parameter inside of [0, 1]
  /// \param breaks where the speed may not be smooth, in any order; those outside do nothing. At
  /// one that is not told, the length has fewer digits.
  explicit PathLength(const std::function<double(double)>& speed_mm,
                      const std::vector<double>& breaks = {});

  /// Not finite if a speed is not.
  double length_mm() const { return length_mm_; }
  double lengthTo(double parameter) const;
  double parameterAt(double length_mm) const;

 private:
  static constexpr int nodes = 12;  ///< a choice: an arc of 90 degrees is one piece
  using Coefficients = std::array<double, nodes + 1>;

  /// Between two parameters, which are -1 and 1 for the polynomials.
  struct Piece {
    double from = 0, to = 0;
    double begin_mm = 0;
    Coefficients speed = {}, length = {};
  };

  static Piece interpolant(const std::function<double(double)>& speed_mm, double from, double to);
  void add(const std::function<double(double)>& speed_mm, double from, double to, double tail,
           int stalled);
  double parameterIn(const Piece& piece, double rest_mm) const;

  std::vector<Piece> pieces_;
  double length_mm_ = 0;
};

}  // namespace seamwright
