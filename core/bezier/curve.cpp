// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>

namespace seamwright {

HomogeneousPoles homogeneousPoles(const Eigen::Ref<const Poles>& poles,
                                  const Eigen::VectorXd& weights) {
  if (poles.rows() == 0) throw std::invalid_argument("no poles: at least one is needed");
  if (weights.size() != poles.rows())
    throw std::invalid_argument("poles " + std::to_string(poles.rows()) + ", weights " +
                                std::to_string(weights.size()) + ": the numbers must be equal");
  for (Eigen::Index i = 0; i < poles.rows(); ++i) {
    if (!poles.row(i).allFinite())
      throw std::invalid_argument("pole " + std::to_string(i) + " is not finite");
    if (!(weights(i) > 0) || !std::isfinite(weights(i)))
      throw std::invalid_argument("weight " + std::to_string(i) + " is " +
                                  bernstein::text(weights(i)) +
                                  ": weights must be positive and finite");
  }
  HomogeneousPoles result(poles.rows(), 4);
  result << weights.asDiagonal() * poles, weights;
  return result;
}

void requireValid(const HomogeneousPoles& poles) {
  homogeneousPoles(poles.leftCols<3>(), poles.col(3));
}

Poles affinePoles(const HomogeneousPoles& poles) {
  return poles.leftCols<3>().array().colwise() / poles.col(3).array();
}

bool isRational(const HomogeneousPoles& poles) {
  return (poles.col(3).array() != poles(0, 3)).any();
}

BezierCurve::BezierCurve(const Eigen::Ref<const Poles>& poles)
    : BezierCurve(poles, Eigen::VectorXd::Ones(poles.rows())) {}

BezierCurve BezierCurve::fromHomogeneous(HomogeneousPoles poles) {
  requireValid(poles);
  return {Homogeneous{}, std::move(poles)};
}

BezierCurve::BezierCurve(const Eigen::Ref<const Poles>& poles,
                         const Eigen::Ref<const Eigen::VectorXd>& weights)
    : homogeneous_(seamwright::homogeneousPoles(poles, weights)) {}

bool BezierCurve::isRational() const {
  return seamwright::isRational(homogeneous_);
}

Poles BezierCurve::poles() const {
  return affinePoles(homogeneous_);
}

Eigen::Vector3d BezierCurve::point(double t) const {
  HomogeneousPoles work = homogeneous_;
  const Eigen::Vector4d h = casteljau::collapse<4>(work, t).transpose();
  return h.head<3>() / h(3);
}

CurveJet BezierCurve::jet(double t) const {
  const CurveDerivatives x = derivatives(t, 3);
  return {x.row(0), x.row(1), x.row(2), x.row(3)};
}

CurveDerivatives BezierCurve::derivatives(double t, int order) const {
  if (order < 0)
    throw std::invalid_argument("order " + std::to_string(order) + ": it must not be negative");
  const auto of = [&](const HomogeneousPoles& poles) -> CurveDerivatives {
    return affineDerivatives<Eigen::Dynamic>(
        casteljau::derivatives<4, Eigen::Dynamic>(poles, t, order + 1));
  };
  if (!isRational()) return of(homogeneous_);
  const Eigen::Vector3d here = point(t);
  CurveDerivatives result = of(about(homogeneous_, here));
  result.row(0) += here.transpose();
  return result;
}

double BezierCurve::noise() const {
  const double size = poles().cwiseAbs().maxCoeff();
  const double weight_ratio = homogeneous_.col(3).maxCoeff() / homogeneous_.col(3).minCoeff();
  return 8 * (degree() + 4) * std::numeric_limits<double>::epsilon() * degree() * size *
         weight_ratio;
}

BezierCurve BezierCurve::reversed() const {
  return {Homogeneous{}, homogeneous_.colwise().reverse()};
}

BezierCurve BezierCurve::elevated() const {
  const Eigen::Index count = homogeneous_.rows();
  HomogeneousPoles result(count + 1, 4);
  result.row(0) = homogeneous_.row(0);
  result.row(count) = homogeneous_.row(count - 1);
  for (Eigen::Index i = 1; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count);
    result.row(i) = share * homogeneous_.row(i - 1) + (1 - share) * homogeneous_.row(i);
  }
  return {Homogeneous{}, result};
}

std::pair<BezierCurve, BezierCurve> BezierCurve::split(double t) const {
  auto [left, right] = casteljau::split<4>(homogeneous_, t);
  return {BezierCurve(Homogeneous{}, std::move(left)),
          BezierCurve(Homogeneous{}, std::move(right))};
}

}  // namespace seamwright
