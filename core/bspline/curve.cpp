// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/bspline/curve.hpp>

namespace seamwright {

void requireValid(const BSplineCurve& curve) {
  bspline::requireKnots(curve.degree, curve.knots, "");
  if (curve.poles.rows() != curve.count())
    throw std::invalid_argument("poles " + std::to_string(curve.poles.rows()) + ", knots for " +
                                std::to_string(curve.count()) + ": the numbers must be equal");
  requireValid(curve.poles);
}

BSplineCurve splineCurve(const BezierCurve& curve) {
  std::vector<double> knots(2 * (static_cast<std::size_t>(curve.degree()) + 1), 0.0);
  std::fill(knots.begin() + curve.degree() + 1, knots.end(), 1.0);
  BSplineCurve result{curve.degree(), std::move(knots), curve.homogeneousPoles()};
  requireValid(result);
  return result;
}

CurveDerivatives derivatives(const BSplineCurve& curve, double t, int order) {
  requireValid(curve);
  if (!std::isfinite(t))
    throw std::invalid_argument("parameter t is " + bernstein::text(t) + ": it must be finite");
  if (order < 0)
    throw std::invalid_argument("order " + std::to_string(order) + ": it must not be negative");
  const int span = bspline::spanOf(curve.degree, curve.knots, t);
  const Eigen::MatrixXd basis =
      bspline::basisDerivatives(curve.degree, curve.knots, span, t, order);
  const HomogeneousPoles poles = curve.poles.middleRows(span - curve.degree, curve.degree + 1);
  if (!isRational(curve.poles)) return (basis * poles).leftCols<3>() / curve.poles(0, 3);
  const Eigen::RowVector4d h = basis.row(0) * poles;
  const Eigen::RowVector3d here = h.head<3>() / h(3);
  CurveDerivatives result = affineDerivatives<Eigen::Dynamic>(basis * about(poles, here));
  result.row(0) += here;
  return result;
}

}  // namespace seamwright
