// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Geom_BSplineSurface.hxx>
#include <array>
#include <vector>

#include <seamwright/core/differential/jet.hpp>
#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

/// Points and derivatives of a spline surface as sums over its poles; not a public header.
namespace seamwright::occ {

/// X, X_u, X_v and, if they are asked for, X_uu, X_uv, X_vv (a row each) = sum of share times pole.
struct PoleShares {
  std::vector<int> poles;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6> share;
};

/// Flat knots of one direction.
struct SplineAxis {
  int degree = 0;
  int poles = 0;
  bool periodic = false;
  double first = 0, last = 0;
  std::vector<double> knots;  ///< the span of place i holds the functions of the poles i - degree
                              ///< .. i, counted round if periodic
  double step = 1;            ///< mean length of the spans, at most 1

  /// Into [first, last[ if periodic.
  double wrapped(double t) const;
  /// The span that holds t; on a knot that on the side \p toward points to.
  int span(double& t, double toward) const;
  /// Spans that are not empty.
  std::vector<int> spans() const;
  double length(int span) const { return knots[span + 1] - knots[span]; }
  double middle(int span) const { return (knots[span + 1] + knots[span]) / 2; }
  int pole(int function) const { return periodic ? function % poles : function; }
  /// The poles whose functions are not zero at t, and up to three more on both sides.
  std::vector<int> polesNear(double t) const;
};

/// Of a surface with given knots and weights; poles are given to it.
class SurfaceBasis {
 public:
  explicit SurfaceBasis(const Geom_BSplineSurface& surface);

  const SplineAxis& u() const { return u_; }
  const SplineAxis& v() const { return v_; }
  int pole(int i, int j) const { return i * v_.poles + j; }

  /// \param into on knot lines the polynomials on that side. \param order of the highest
  /// derivatives, 1 or 2.
  PoleShares at(const Eigen::Vector2d& uv, const Eigen::Vector2d& into = Eigen::Vector2d::Zero(),
                int order = 2) const;
  /// The denominator and its derivatives, as the rows of PoleShares, over the weight of the first
  /// pole; empty if the surface is polynomial.
  Eigen::VectorXd denominator(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const;

 private:
  /// Shares in the numerator.
  PoleShares ofNumerator(const Eigen::Vector2d& uv, const Eigen::Vector2d& into, int order) const;

  SplineAxis u_, v_;
  Eigen::VectorXd weights_;
};

/// Shares in a numerator become those in the quotient. \param denominator with its derivatives, as
/// the rows of the shares
void divide(PoleShares& shares, const Eigen::VectorXd& denominator);

PointRows polesOf(const Geom_BSplineSurface& surface);
/// Poles with equal coordinates are not touched.
void setPoles(Geom_BSplineSurface& surface, const PointRows& poles);

/// \pre the shares have second derivatives
SurfaceJet jetOf(const PoleShares& shares, const PointRows& poles);

/// The step of (u, v) that goes along a tangent vector.
Eigen::Vector2d parameterStep(const SurfaceJet& jet, const Eigen::Vector3d& way);
/// Shares of the poles in the derivative along a step of (u, v), and in the second one along two.
Eigen::RowVectorXd derivative(const PoleShares& shares, const Eigen::Vector2d& step);
Eigen::RowVectorXd secondDerivative(const PoleShares& shares, const Eigen::Vector2d& a,
                                    const Eigen::Vector2d& b);

/// What may be rounding in a jet, as FaceStrip has it.
JetNoise noiseOf(const SurfaceJet& jet, const SurfaceBasis& basis);

/// The poles of each side that is one point, or within that distance one.
std::vector<std::vector<int>> collapsedSides(const SurfaceBasis& basis, const PointRows& poles,
                                             double near_mm);

/// Length of a knot span at t.
double spanLength(const SplineAxis& axis, double t);
/// Poles that a knot span adds, in the mean.
double polesPerSpan(const SplineAxis& axis);

}  // namespace seamwright::occ
