// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace seamwright {

enum class SplineClosure { Open, Periodic };

/// Interpolation by splines at the Greville abscissae: the means of degree neighbouring knots. It
/// needs no derivatives at the ends, and its errors are a small multiple of the least ones.
///
/// A periodic spline has equal values and derivatives 0 to degree - 1 at both ends of the range.
class GrevilleInterpolation {
 public:
  /// \param knots flat, clamped
  /// \throws std::invalid_argument for a degree outside of 1..25 and for knots that make no
  /// continuous spline.
  GrevilleInterpolation(int degree, std::vector<double> knots,
                        SplineClosure closure = SplineClosure::Open);

  int degree() const { return degree_; }
  const std::vector<double>& knots() const { return knots_; }
  /// The parameters at which values are interpolated: one for each pole, of a periodic spline
  /// degree fewer, which lie in [begin, end).
  const std::vector<double>& parameters() const { return parameters_; }

  /// The poles of the spline that has row i of \p values at parameter i.
  ///   (1) A polynomial of the degree is reproduced, up to rounding.
  ///   (2) The spline has the values at the parameters.
  ///   (3) A periodic one is C^(degree - 1) across the ends.
  /// \throws std::invalid_argument if the number of rows is not that of the parameters.
  Eigen::MatrixXd poles(const Eigen::MatrixXd& values) const;

 private:
  int degree_;
  std::vector<double> knots_;
  SplineClosure closure_;
  std::vector<double> parameters_;
};

}  // namespace seamwright
