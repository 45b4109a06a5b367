// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/fair/function_spline.hpp>

/// The second derivatives of cubic splines y(x); not a public header.
namespace seamwright {

/// derivatives() of the piece after a point; x may be anywhere.
Eigen::Vector4d pieceDerivatives(const FunctionSpline& spline, Eigen::Index piece, double x_mm);

/// The equations for the second derivatives of splines with given distances of their points.
/// Source: docs/theory/planar.md P12.1.
class SecondEquations {
 public:
  /// \param clamped slopes are given at the ends; otherwise S'' is 0 there.
  SecondEquations(const Eigen::VectorXd& distances_mm, bool clamped);

  Eigen::VectorXd solve(Eigen::VectorXd right) const;

  /// Consecutive second derivatives, of the points first, first + 1, ...; those of other points are
  /// below rounding. There are at most 60 on each side of the point.
  struct Window {
    Eigen::Index first = 0;
    std::vector<double> second;

    Eigen::Index end() const { return first + static_cast<Eigen::Index>(second.size()); }
    double at(Eigen::Index i) const { return i < first || i >= end() ? 0 : second[i - first]; }
  };

  /// The second derivatives of the spline that is 1 at a point between the ends and 0 at the
  /// others, with slopes 0.
  Window cardinal(Eigen::Index point) const;

 private:
  bool isFree(Eigen::Index row) const {
    return clamped_ || (row > 0 && row + 1 < diagonal_.size());
  }

  Eigen::VectorXd distances_;
  bool clamped_;
  Eigen::VectorXd diagonal_, off_;          ///< off_(i) couples i and i + 1
  Eigen::VectorXd from_left_, from_right_;  ///< pivots of eliminations in both directions
};

}  // namespace seamwright
