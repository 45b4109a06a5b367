// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <seamwright/core/spline/band_factor.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

/// What nu-splines and beta-splines share; not a public header.
namespace seamwright {

/// The first derivatives at the points of an interpolating cubic spline, from those of the
/// neighbours.
class SlopeEquations {
 public:
  /// \param closed the first point follows the last one.
  SlopeEquations(Eigen::Index count, bool closed);

  /// lower x_(i-1) + (2 + tension) x_i + upper x_(i+1) = 3 (before + after), kept divided by about
  /// 1 + |tension|: so large tensions make small x_i, exact in their leading digits, and an
  /// infinite one makes 0.
  void set(Eigen::Index i, double lower, double tension, double upper,
           const Eigen::RowVector3d& before, const Eigen::RowVector3d& after);
  void give(Eigen::Index i, const Eigen::RowVector3d& derivative);

  struct Solution {
    Poles derivatives;
    Eigen::VectorXd noise;  ///< what rounding may have added to the largest coordinate of each
  };
  /// \throws std::domain_error as solveBand().
  Solution solve() &&;

 private:
  BandMatrix matrix_;
  Poles right_;
  Eigen::VectorXd right_size_;  ///< of the terms of the right side
};

/// \throws std::invalid_argument for too few points, one that is not finite, neighbours that are
/// the same or so far apart that their difference is not finite, and a periodic end that is not the
/// beginning.
void requirePoints(const Poles& points, bool periodic);
/// \throws std::invalid_argument naming the value unless there are \p count, all finite.
void requireNumbers(const char* name, const std::vector<double>& values, Eigen::Index count);
/// \throws std::invalid_argument naming what is not finite, with its value.
void requireFinite(const std::string& name, const Eigen::Vector3d& vector);
void requireFiniteRows(const char* name,
                       const Eigen::Ref<const Poles, 0, Eigen::OuterStride<>>& rows);
/// \throws std::invalid_argument unless they are finite and increase over a normal number; \p
/// reason ends the sentence.
void requireIncreasing(const std::vector<double>& knots, const char* reason);

/// How far the inner poles of a segment are from its ends, in units of the derivatives there.
struct Reach {
  double start, end;
};

/// The cubic segments through the points; \p reach is asked for each segment's.
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

/// Points whose derivative is within its noise, or so small that the poles beside the point are it
/// but for rounding.
/// \param noise of the points; a closed spline's last one is that of the first.
std::vector<int> stationaryPoints(const BezierSpline& spline, const Poles& derivatives,
                                  const Eigen::VectorXd& noise);

}  // namespace seamwright
