// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Geom_BSplineSurface.hxx>
#include <array>
#include <vector>

#include <seamwright/core/differential/jet.hpp>
#include <seamwright/occ_adapter/deform/block_cholesky.hpp>

/// Writes points and derivatives of a spline surface as sums over its poles. Not a public header.
namespace seamwright::occ {

/// X, X_u, X_v and, if asked for, X_uu, X_uv, X_vv as sums of share times pole. Each has one row.
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
  /// Span i has the basis functions of the poles i - degree .. i, counted modulo the number of
  /// poles if periodic.
  std::vector<double> knots;
  double step = 1;  ///< mean length of the spans, at most 1

  /// The parameter, shifted by periods into [first, last[ if periodic.
  double wrapped(double t) const;
  /// The span that contains t. At a knot it is the span on the side to which \p toward points. \p t
  /// is wrapped into the domain.
  int span(double& t, double toward) const;
  /// Indices of the spans that are not empty.
  std::vector<int> spans() const;
  double length(int span) const { return knots[span + 1] - knots[span]; }
  double middle(int span) const { return (knots[span + 1] + knots[span]) / 2; }
  int pole(int function) const { return periodic ? function % poles : function; }
  /// The poles whose basis functions are not zero at t, and up to three more on both sides.
  std::vector<int> polesNear(double t) const;
};

/// The basis of a surface with given knots and weights. Callers supply the poles.
class SurfaceBasis {
 public:
  explicit SurfaceBasis(const Geom_BSplineSurface& surface);

  const SplineAxis& u() const { return u_; }
  const SplineAxis& v() const { return v_; }
  int pole(int i, int j) const { return i * v_.poles + j; }

  /// \param into on knot lines the polynomials on the side to which it points are used.
  /// \param order order of the highest derivatives, 1 or 2.
  PoleShares at(const Eigen::Vector2d& uv, const Eigen::Vector2d& into = Eigen::Vector2d::Zero(),
                int order = 2) const;
  /// The denominator and its derivatives, in the order of the rows of PoleShares, divided by the
  /// weight of the first pole. Empty if the surface is polynomial.
  Eigen::VectorXd denominator(const Eigen::Vector2d& uv, const Eigen::Vector2d& into) const;

 private:
  /// Shares of the poles in the numerator.
  PoleShares ofNumerator(const Eigen::Vector2d& uv, const Eigen::Vector2d& into, int order) const;

  SplineAxis u_, v_;
  Eigen::VectorXd weights_;
};

/// Turns shares in a numerator into shares in the quotient.
/// \param denominator with its derivatives, in the order of the rows of the shares.
void divide(PoleShares& shares, const Eigen::VectorXd& denominator);

/// The poles without weights, pole (i, j) in row i columns + j, both from 0.
PointRows polesOf(const Geom_BSplineSurface& surface);
/// Sets the poles. Poles whose coordinates stay equal are not touched.
void setPoles(Geom_BSplineSurface& surface, const PointRows& poles);

/// \pre the shares have second derivatives
SurfaceJet jetOf(const PoleShares& shares, const PointRows& poles);

/// The step of (u, v) that moves the point by a tangent vector.
Eigen::Vector2d parameterStep(const SurfaceJet& jet, const Eigen::Vector3d& way);
/// Shares of the poles in the derivative along a step of (u, v), and in the second derivative along
/// two steps.
Eigen::RowVectorXd derivative(const PoleShares& shares, const Eigen::Vector2d& step);
Eigen::RowVectorXd secondDerivative(const PoleShares& shares, const Eigen::Vector2d& a,
                                    const Eigen::Vector2d& b);

/// Bound of the rounding in a jet, as FaceStrip computes it.
JetNoise noiseOf(const SurfaceJet& jet, const SurfaceBasis& basis);

/// The poles of each side that is one point, or lies within \p near_mm of one.
std::vector<std::vector<int>> collapsedSides(const SurfaceBasis& basis, const PointRows& poles,
                                             double near_mm);

/// Length of a knot span at t.
double spanLength(const SplineAxis& axis, double t);
/// Mean number of poles that a knot span adds.
double polesPerSpan(const SplineAxis& axis);

}  // namespace seamwright::occ
