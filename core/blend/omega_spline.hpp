// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

/// Piecewise cubic functions of the loft's parameter omega; not a public header.
namespace seamwright::loft {

/// The value, or one of its derivatives, of every function: one column each.
using Row = Eigen::RowVectorXd;

/// What is given at an end beside the value: the first derivative, or the first and the second.
/// With neither, the third derivative is continuous at the nearest break.
struct EndDerivatives {
  std::optional<Row> first, second;
};

/// Given values of several functions, one column each.
struct OmegaData {
  std::vector<double> omegas;  ///< increasing, at least 2
  Eigen::MatrixXd values;      ///< one row for each omega
  EndDerivatives start, end;
  bool closed = false;  ///< the last row is the first one; derivatives given at ends do not count
};

/// Cubic pieces in Bernstein form.
struct OmegaSpline {
  std::vector<double> breaks;  ///< those of the data, and those that second derivatives need
  Eigen::MatrixXd rows;        ///< 3 (breaks - 1) + 1; rows 3 i to 3 i + 3 belong to piece i
};

/// The C^2 cubic spline through the data. A second derivative that is given at an end takes one
/// more break, in the middle of the outermost interval. Without derivatives two values make a
/// line and three a parabola.
///   (1) A cubic is reproduced; values are met bitwise.
/// \throws std::invalid_argument if omegas do not increase, or if counts do not match.
/// Source: docs/theory/surfaces.md S7.3; [deBoor2001].
OmegaSpline omegaSpline(const OmegaData& data);

/// The B-spline poles of a function of class C^2 from its Bernstein coefficients of degree q >= 3
/// on every piece: flat knots repeat inner breaks q - 2 times. At breaks[i] with kink[i] the
/// function is continuous only, and the knot is repeated q times.
struct OmegaPoles {
  std::vector<double> knots;
  Eigen::MatrixXd rows;
};
OmegaPoles omegaPoles(const std::vector<double>& breaks, const std::vector<bool>& kink, int degree,
                      const Eigen::MatrixXd& rows);

}  // namespace seamwright::loft
