// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>

/// The end of a curve that moves; not a public header.
namespace seamwright::nearest_curve {

/// One end of a clamped Bézier or B-spline curve.
struct End {
  int degree;
  const std::vector<double>& knots;
  const HomogeneousPoles& poles;
  bool last;  ///< true: the end of the curve; false: its beginning

  Eigen::Index firstPole(int order) const { return last ? poles.rows() - order - 1 : 0; }
  Eigen::Vector3d point() const;
};

/// Derivatives of orders 0..n at an end as a linear function of the n + 1 poles there, with fixed
/// weights: derivatives by (unit times the curve's parameter) = jet * points.
struct Side {
  Eigen::MatrixXd jet;  ///< (n + 1) by (n + 1)
  Eigen::MatrixXd
      points;  ///< the poles relative to the origin, (n + 1) by 3, in the order of the curve
  Eigen::VectorXd reach;  ///< cost^(-1/2) of each pole; 0: the pole stays
  double unit = 1;

  /// The same with derivatives by \p factor times that parameter.
  void rescale(double factor);
};

/// The side in a parameter by which a curve without inner knots has the first derivative P_n -
/// P_(n-1) (for equal weights).
/// \param costs one per pole of the whole curve, or none. \pre order <= degree
/// Source: docs/theory/curves.md C4.1.
Side sideOf(const End& end, int order, const Eigen::Vector3d& origin, const Eigen::VectorXd& costs,
            bool moves);

}  // namespace seamwright::nearest_curve
