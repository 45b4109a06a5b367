// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <seamwright/core/spline/band_factor.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// Common functions of nu-splines and beta-splines; not a public header.
namespace seamwright {

/// The equations of the first derivatives at the points of an interpolating cubic spline. Each
/// equation connects neighbouring points.
class SlopeEquations {
 public:
  /// \param closed the first point follows the last one.
  SlopeEquations(Eigen::Index count, bool closed);

  /// lower x_(i-1) + (2 + tension) x_i + upper x_(i+1) = 3 (before + after), stored divided by
  /// about 1 + |tension|. So a large tension gives a small x_i with exact leading digits, and an
  /// infinite tension gives 0.
  void set(Eigen::Index i, double lower, double tension, double upper,
           const Eigen::RowVector3d& before, const Eigen::RowVector3d& after);
  void give(Eigen::Index i, const Eigen::RowVector3d& derivative);

  struct Solution {
    Poles derivatives;
    Eigen::VectorXd noise;  ///< bound of the rounding in the largest coordinate of each
  };
  /// \throws std::domain_error as solveBand() does.
  Solution solve() &&;

 private:
  BandMatrix matrix_;
  Poles right_;
  Eigen::VectorXd right_size_;  ///< size of the terms of the right side
};

/// \throws std::invalid_argument for too few points, a point that is not finite, neighbours that
/// are equal or so far apart that their difference is not finite, and a periodic spline whose end
/// differs from its beginning.
void requirePoints(const Poles& points, bool periodic);
/// \throws std::invalid_argument that names the value, unless there are \p count values, all
/// finite.
void requireNumbers(const char* name, const std::vector<double>& values, Eigen::Index count);
/// \throws std::invalid_argument that names a number that is not finite, with its value.
void requireFinite(const std::string& name, const Eigen::Vector3d& vector);
void requireFiniteRows(const char* name,
                       const Eigen::Ref<const Poles, 0, Eigen::OuterStride<>>& rows);
/// \throws std::invalid_argument unless the knots are finite, increase, and have a normal number as
/// their range; \p reason ends the message.
void requireIncreasing(const std::vector<double>& knots, const char* reason);

/// Distances of the inner poles of a segment from its ends, in units of the derivatives there.
struct Reach {
  double start, end;
};

/// The cubic segments through the points. \p reach gives the Reach of each segment.
/// \throws std::invalid_argument for a pole that is not finite.
template <class ReachOf>
BezierSpline hermiteSpline(const Poles& points, const Poles& derivatives,
                           const std::vector<double>& knots, bool closed, const ReachOf& reach) {
  const Eigen::Index segments = points.rows() - 1;
  BezierSpline spline{3, knots, HomogeneousPoles(3 * segments + 1, 4), closed};
  spline.poles.col(3).setOnes();
  for (Eigen::Index i = 0; i < segments; ++i) {
    const Reach r = reach(i);
    spline.poles.row(3 * i).head<3>() = points.row(i);
    spline.poles.row(3 * i + 1).head<3>() = points.row(i) + r.start * derivatives.row(i);
    spline.poles.row(3 * i + 2).head<3>() = points.row(i + 1) - r.end * derivatives.row(i + 1);
  }
  spline.poles.row(3 * segments).head<3>() = points.row(segments);
  requireFiniteRows("pole", spline.poles.leftCols<3>());
  return spline;
}

/// Points whose derivative is within its noise, or is so small that the poles beside the point
/// equal the point up to rounding.
/// \param noise one per point; for a closed spline the last entry belongs to the first point.
std::vector<int> stationaryPoints(const BezierSpline& spline, const Poles& derivatives,
                                  const Eigen::VectorXd& noise);

}  // namespace seamwright
