// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/graded_derivatives.hpp>
#include <seamwright/core/bezier/graded_term.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>

namespace seamwright {

/// A fused product rounds A_i - w_i O only once, so poles far from the origin lose no accuracy.
LocalPoles localPoles(const HomogeneousPoles& poles, Eigen::Index pivot) {
  const Eigen::Vector3d origin = poles.row(pivot).head<3>().transpose() / poles(pivot, 3);
  LocalPoles local{affinePoles(about(poles, origin)), 0};
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(local.poles(i, k)))
        throw std::invalid_argument(
            "pole " + std::to_string(i) + " is " + bernstein::text(local.poles(i, k)) +
            " from another in coordinate " + std::to_string(k) + ": distances must be finite");
  std::frexp(local.poles.cwiseAbs().maxCoeff(), &local.exponent);
  for (double& coordinate : local.poles.reshaped())
    coordinate = std::ldexp(coordinate, -local.exponent);
  return local;
}

namespace {

/// The parameter z and the rate ds / dt.
struct LogParameter {
  GradedTerm z, rate;
};

LogParameter logParameter(double t) {
  const GradedTerm a = gradedParameter(t), b = gradedParameter(1 - t);
  return {a.over(b), GradedTerm(1).over(a.times(b))};
}

class GradedSums {
 public:
  GradedSums(const HomogeneousPoles& poles, double t);

  /// Proceeds to the next order.
  void differentiate();
  GradedVector derivative() const;
  double pivot() const { return static_cast<double>(pivot_); }
  /// The sum of the terms, divided by the sum of order 0.
  GradedNumber weight() const;
  /// The term i of the current order, divided by the sum of order 0.
  GradedTerm share(Eigen::Index i) const {
    return GradedTerm(terms_[static_cast<std::size_t>(i)].mantissa / first_weight_,
                      terms_[static_cast<std::size_t>(i)].exponent - first_exponent_);
  }
  Poles aboutPoint() const { return local_.poles.rowwise() - point_; }
  int size() const { return local_.exponent; }

 private:
  void choosePivot();

  double rounding_;  ///< relative, of a term (five roundings per power of z) and of a sum
  std::vector<GradedTerm> terms_;
  Eigen::Index pivot_ = 0;
  Eigen::VectorXd shares_;   ///< terms divided by a power of 2; that of the pivot is in [0.5, 1)
  LocalPoles local_;         ///< relative to the first pivot
  int first_exponent_ = 0;   ///< exponent of the shares of order 0
  double first_weight_ = 0;  ///< sum of the shares of order 0
  double first_weight_error_ = 0;  ///< relative
  Eigen::RowVector3d point_;       ///< the point relative to the first pivot
  double point_size_ = 0;          ///< sum of the absolute values of its terms
};

void GradedSums::choosePivot() {
  const std::size_t largest = largestTerm(terms_);
  pivot_ = static_cast<Eigen::Index>(largest);
  for (std::size_t i = 0; i < terms_.size(); ++i)
    shares_(static_cast<Eigen::Index>(i)) = terms_[i].overPowerOf2(terms_[largest].exponent);
}

GradedSums::GradedSums(const HomogeneousPoles& poles, double t)
    : rounding_(3 * (static_cast<double>(poles.rows()) + 1) *
                std::numeric_limits<double>::epsilon()),
      shares_(poles.rows()) {
  const auto degree = static_cast<double>(poles.rows() - 1);
  const GradedTerm z = logParameter(t).z;
  GradedTerm power(1);
  for (Eigen::Index i = 0; i < poles.rows(); ++i) {
    terms_.push_back(power.times(GradedTerm(poles(i, 3))));
    const auto index = static_cast<double>(i);
    power = power.times((degree - index) / (index + 1)).times(z);
  }
  choosePivot();
  local_ = localPoles(poles, pivot_);
  first_exponent_ = terms_[static_cast<std::size_t>(pivot_)].exponent;
  first_weight_ = shares_.sum();
  point_ = shares_.transpose() * local_.poles / first_weight_;
  point_size_ = shares_.cwiseAbs().dot(local_.poles.rowwise().norm()) / std::abs(first_weight_);
  first_weight_error_ = rounding_ * shares_.cwiseAbs().sum() / std::abs(first_weight_);
  if (!point_.allFinite())
    throw std::invalid_argument("the weight at parameter " + bernstein::text(t) + " is " +
                                bernstein::text(first_weight_) + ": there is no point");
}

void GradedSums::differentiate() {
  for (std::size_t i = 0; i < terms_.size(); ++i)
    terms_[i] = terms_[i].times(static_cast<double>(static_cast<Eigen::Index>(i) - pivot_));
  rounding_ += std::numeric_limits<double>::epsilon();
  choosePivot();
}

GradedVector GradedSums::derivative() const {
  GradedVector result;
  result.value = (shares_.transpose() * aboutPoint()).transpose() / first_weight_;
  // The error of the point is up to twice that of its sum, because both sums of the quotient are
  // rounded.
  const Eigen::VectorXd sizes = local_.poles.rowwise().norm().array() + 3 * point_size_;
  result.error = rounding_ * shares_.cwiseAbs().dot(sizes) / std::abs(first_weight_) +
                 first_weight_error_ * result.value.norm();
  int normalised = 0;
  std::frexp(result.value.cwiseAbs().maxCoeff(), &normalised);
  for (double& coordinate : result.value) coordinate = std::ldexp(coordinate, -normalised);
  result.error = std::ldexp(result.error, -normalised);
  result.exponent = terms_[static_cast<std::size_t>(pivot_)].exponent - first_exponent_ +
                    local_.exponent + normalised;
  return result;
}

GradedNumber GradedSums::weight() const {
  const double ratio = shares_.sum() / first_weight_;
  const double error = rounding_ * shares_.cwiseAbs().sum() / std::abs(first_weight_);
  return {ratio, error + first_weight_error_ * std::abs(ratio),
          terms_[static_cast<std::size_t>(pivot_)].exponent - first_exponent_};
}

/// The shift for the parameter whose derivative of order 2 is the one with the pivots p_0 and p_1.
/// In its third derivative 2 p_1 - p_0 replaces p_2. The quotient adds three times the first
/// derivative of the weight.
GradedNumber shiftOf(double pivot_shift, const GradedNumber& weight) {
  if (pivot_shift == 0) return {3 * weight.value, 3 * weight.error, weight.exponent};
  return {pivot_shift + std::ldexp(3 * weight.value, weight.exponent),
          std::ldexp(3 * weight.error, weight.exponent), 0};
}

}  // namespace

GradedDerivatives gradedDerivatives(const HomogeneousPoles& poles, double t, int order) {
  GradedDerivatives result;
  const GradedTerm rate = logParameter(t).rate;
  result.rate = {rate.mantissa,
                 4 * std::numeric_limits<double>::epsilon() * std::abs(rate.mantissa),
                 rate.exponent};
  GradedSums sums(poles, t);
  std::vector<double> pivots = {sums.pivot()};
  GradedNumber weight;
  for (int k = 1; k <= order; ++k) {
    sums.differentiate();
    result.by_order.push_back(sums.derivative());
    pivots.push_back(sums.pivot());
    if (k == 1) weight = sums.weight();
  }
  if (order >= 3) result.shift = shiftOf(pivots[2] - 2 * pivots[1] + pivots[0], weight);
  return result;
}

namespace {

/// Coefficients, by powers of b with a = b / (1 - turn b), of a function of a divided by 1 / (1 -
/// turn b): sum_k c_k b^k (1 - turn b)^(1 - k).
/// \pre If c_0 is not zero, the coefficient c_1 includes its contribution.
template <class Rows>
Rows projectedSeries(const Rows& c, double turn) {
  Rows result = c;
  for (Eigen::Index k = 2; k < c.rows(); ++k) {
    double factor = 1;
    for (Eigen::Index j = 1; k + j < c.rows(); ++j) {
      factor *= turn * static_cast<double>(k - 2 + j) / static_cast<double>(j);
      result.row(k + j) += factor * c.row(k);
    }
  }
  return result;
}

/// Coefficients by powers of a of sum_i share_i (1 + a)^x_i (P_i - X), x_i = (i - p_0) / (p_1 -
/// p_0), and of the weight. a is in units of 2^unit.
struct OwnSeries {
  CurveDerivatives points;
  Eigen::VectorXd weights;
};

OwnSeries ownSeries(const GradedSums& sums, double first, double second, int unit, int order) {
  OwnSeries series{CurveDerivatives::Zero(order + 1, 3), Eigen::VectorXd::Zero(order + 1)};
  const Poles poles = sums.aboutPoint();
  for (Eigen::Index i = 0; i < poles.rows(); ++i) {
    GradedTerm term = sums.share(i);
    for (int k = 1; k <= order; ++k) {
      const double steps = static_cast<double>(i) - first - (k - 1) * (second - first);
      term = term.times(steps / (k * (second - first)));
      const double coefficient = term.overPowerOf2(-k * unit);
      series.points.row(k) += coefficient * poles.row(i);
      series.weights(k) += coefficient;
    }
  }
  return series;
}

}  // namespace

OwnDerivatives ownDerivatives(const HomogeneousPoles& poles, double t, int order) {
  GradedSums sums(poles, t);
  OwnDerivatives result{CurveDerivatives::Zero(order + 1, 3), 0};
  const GradedSums start = sums;
  sums.differentiate();
  const GradedVector first = sums.derivative();
  if (order == 0 || first.value.isZero(0)) return result;
  // The unit of a makes the speed about 1.
  const double step = sums.pivot() - start.pivot();
  const OwnSeries series = ownSeries(start, start.pivot(), sums.pivot(), -first.exponent, order);
  const CurveDerivatives points = projectedSeries(series.points, series.weights(1));
  const Eigen::VectorXd weights = projectedSeries(series.weights, series.weights(1));
  for (int k = 1; k <= order; ++k) {
    result.derivatives.row(k) = points.row(k);
    for (int j = 2; j < k; ++j)
      result.derivatives.row(k) -= weights(j) * result.derivatives.row(k - j);
  }
  const bool backwards = (step < 0) != (logParameter(t).rate.mantissa < 0);
  double factor = std::ldexp(1, start.size());
  for (int k = 1; k <= order; ++k) {
    factor *= k * (backwards ? -1 : 1);
    result.derivatives.row(k) *= factor;
  }
  result.speed_noise = first.error / std::abs(step);
  return result;
}

}  // namespace seamwright
