// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bspline/surface.hpp>

namespace seamwright {

/// The boundaries u = 0 and u = 1 of a sheet: those that run across, from one side to the other.
enum class LateralSide { First, Last };

/// Interpolation by splines whose outer poles vanish: the first \p zeros_first and the last \p
/// zeros_last. So the values and the derivatives up to zeros - 1 vanish at these ends.
class ZeroEndInterpolation {
 public:
  /// \param knots flat, clamped
  /// \throws std::invalid_argument for a degree outside of 1..25, knots that make no continuous
  /// spline, negative counts, and if no pole is left.
  ZeroEndInterpolation(int degree, std::vector<double> knots, int zeros_first, int zeros_last);

  /// The Greville abscissae of the other poles.
  const std::vector<double>& parameters() const { return parameters_; }

  /// All poles of the spline that has row i of \p values at parameter i.
  ///   (1) A spline over these knots with such outer poles is reproduced, up to rounding.
  /// \throws std::invalid_argument if the number of rows is not that of the parameters.
  Eigen::MatrixXd poles(const Eigen::MatrixXd& values) const;

 private:
  int degree_;
  std::vector<double> knots_;
  int zeros_first_, zeros_last_;
  std::vector<double> parameters_;
};

/// The same sheet with that degree across and these knots across, which begin and end as its own.
///   (2) Points and partials do not change, up to rounding.
/// \throws std::invalid_argument for a sheet with inner knots across, and a lower degree.
BSplineSurface withKnotsAcross(const BSplineSurface& sheet, int degree,
                               const std::vector<double>& knots);

/// Adds D(v) (1 - u)^3 to a sheet over [0, 1]^2, or D(v) u^3 at the last boundary.
///   (3) The boundary moves by D(v); the other one keeps points and partials up to the second.
///   (4) Where D and its derivatives up to k vanish, so do all changes of partials up to k by v.
/// \param displacement the poles of D over the knots across, #V by 3.
/// \throws std::invalid_argument for a polynomial degree along below 3, another number of poles,
/// and a range that is not [0, 1].
BSplineSurface displacedBoundary(const BSplineSurface& sheet, LateralSide side,
                                 const Eigen::MatrixXd& displacement);

/// Adds D(v) u (1 - u)^3 to a sheet over [0, 1]^2, or -D(v) (1 - u) u^3 at the last boundary.
///   (5) The partial by u changes by D(v) at the boundary, which stays as it is; the other boundary
///       keeps points and partials up to the second. (4) holds too.
/// \throws std::invalid_argument as displacedBoundary(), for a degree along below 4.
BSplineSurface turnedBoundary(const BSplineSurface& sheet, LateralSide side,
                              const Eigen::MatrixXd& displacement);

/// Adds D(v) u^2 (1 - u)^3 / 2 to a sheet over [0, 1]^2, or D(v) (1 - u)^2 u^3 / 2 at the last
/// boundary.
///   (6) The second partial by u changes by D(v) at the boundary, which keeps points and first
///       partials; the other boundary keeps points and partials up to the second. (4) holds too.
/// \throws std::invalid_argument as displacedBoundary(), for a degree along below 5.
BSplineSurface bentBoundary(const BSplineSurface& sheet, LateralSide side,
                            const Eigen::MatrixXd& displacement);

}  // namespace seamwright
