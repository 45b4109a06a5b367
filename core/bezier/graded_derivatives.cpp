// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/graded_derivatives.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>

namespace seamwright {

namespace {

/// mantissa 2^exponent: powers of z of a high degree leave the range of a double.
struct GradedTerm {
  int exponent = 0;
  double mantissa = 0;

  explicit GradedTerm(double value, int shift = 0) {
    mantissa = std::frexp(value, &exponent);
    exponent += shift;
  }
  GradedTerm times(double factor) const { return GradedTerm(mantissa * factor, exponent); }
  GradedTerm times(const GradedTerm& other) const {
    return GradedTerm(mantissa * other.mantissa, exponent + other.exponent);
  }
  bool exceeds(const GradedTerm& other) const {
    if (mantissa == 0 || other.mantissa == 0) return mantissa != 0;
    if (exponent != other.exponent) return exponent > other.exponent;
    return std::abs(mantissa) > std::abs(other.mantissa);
  }
};

/// z and ds / dt. At the ends z is so small, or so large, that all but the first terms of each order vanish beside
/// any weights.
struct LogParameter {
  GradedTerm z, rate;
};

LogParameter logParameter(double t) {
  constexpr int beyond = 1 << 14;
  if (t == 0) return {GradedTerm(1, -beyond), GradedTerm(1, beyond)};
  if (t == 1) return {GradedTerm(1, beyond), GradedTerm(1, beyond)};
  const GradedTerm a(t), b(1 - t);
  return {GradedTerm(a.mantissa / b.mantissa, a.exponent - b.exponent),
          GradedTerm(1 / (a.mantissa * b.mantissa), -a.exponent - b.exponent)};
}

class GradedSums {
 public:
  GradedSums(const HomogeneousPoles& poles, double t);

  /// Goes on to the next order.
  void differentiate();
  GradedVector derivative() const;
  double pivot() const { return static_cast<double>(pivot_); }
  /// The sum of the terms over that of order 0.
  GradedNumber weight() const;

 private:
  void choosePivot();
  void setLocalPoles(const HomogeneousPoles& poles);

  double rounding_;  ///< relative, of a term (five roundings for each power of z) and of a sum
  std::vector<GradedTerm> terms_;
  Eigen::Index pivot_ = 0;
  Eigen::VectorXd shares_;  ///< terms over a power of 2, that of the pivot in [0.5, 1)
  Poles local_;             ///< about the first pivot, over 2^size_
  int size_ = 0;
  int first_exponent_ = 0;         ///< of the shares of order 0
  double first_weight_ = 0;        ///< sum of the shares of order 0
  double first_weight_error_ = 0;  ///< relative
  Eigen::RowVector3d point_;       ///< among the local poles
  double point_size_ = 0;          ///< bounds what it is summed from
};

void GradedSums::choosePivot() {
  pivot_ = 0;
  for (std::size_t i = 1; i < terms_.size(); ++i)
    if (terms_[i].exceeds(terms_[static_cast<std::size_t>(pivot_)])) pivot_ = static_cast<Eigen::Index>(i);
  const GradedTerm& largest = terms_[static_cast<std::size_t>(pivot_)];
  for (std::size_t i = 0; i < terms_.size(); ++i)
    shares_(static_cast<Eigen::Index>(i)) =
        std::ldexp(terms_[i].mantissa, std::max(terms_[i].exponent - largest.exponent, -2000));
}

/// A fused product rounds A_i - w_i O once, so curves far from the origin lose nothing.
void GradedSums::setLocalPoles(const HomogeneousPoles& poles) {
  const Eigen::RowVector3d origin = poles.row(pivot_).head<3>() / poles(pivot_, 3);
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    for (int k = 0; k < 3; ++k) {
      local_(i, k) = std::fma(-poles(i, 3), origin(k), poles(i, k)) / poles(i, 3);
      if (!std::isfinite(local_(i, k)))
        throw std::invalid_argument("pole " + std::to_string(i) + " is " + bernstein::text(local_(i, k)) +
                                    " from another in coordinate " + std::to_string(k) +
                                    ": distances must be finite");
    }
  std::frexp(local_.cwiseAbs().maxCoeff(), &size_);
  for (double& coordinate : local_.reshaped()) coordinate = std::ldexp(coordinate, -size_);
}

GradedSums::GradedSums(const HomogeneousPoles& poles, double t)
    : rounding_(3 * (static_cast<double>(poles.rows()) + 1) * std::numeric_limits<double>::epsilon()),
      shares_(poles.rows()),
      local_(poles.rows(), 3) {
  const auto degree = static_cast<double>(poles.rows() - 1);
  const GradedTerm z = logParameter(t).z;
  GradedTerm power(1);
  for (Eigen::Index i = 0; i < poles.rows(); ++i) {
    terms_.push_back(power.times(GradedTerm(poles(i, 3))));
    const auto index = static_cast<double>(i);
    power = power.times((degree - index) / (index + 1)).times(z);
  }
  choosePivot();
  setLocalPoles(poles);
  first_exponent_ = terms_[static_cast<std::size_t>(pivot_)].exponent;
  first_weight_ = shares_.sum();
  point_ = shares_.transpose() * local_ / first_weight_;
  point_size_ = shares_.cwiseAbs().dot(local_.rowwise().norm()) / std::abs(first_weight_);
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
  const Poles about_point = local_.rowwise() - point_;
  result.value = (shares_.transpose() * about_point).transpose() / first_weight_;
  // The point is off by up to twice what its sum is: both sums of the quotient are rounded.
  const Eigen::VectorXd sizes = local_.rowwise().norm().array() + 3 * point_size_;
  result.error = rounding_ * shares_.cwiseAbs().dot(sizes) / std::abs(first_weight_) +
                 first_weight_error_ * result.value.norm();
  int normalised = 0;
  std::frexp(result.value.cwiseAbs().maxCoeff(), &normalised);
  for (double& coordinate : result.value) coordinate = std::ldexp(coordinate, -normalised);
  result.error = std::ldexp(result.error, -normalised);
  result.exponent = terms_[static_cast<std::size_t>(pivot_)].exponent - first_exponent_ + size_ + normalised;
  return result;
}

GradedNumber GradedSums::weight() const {
  const double ratio = shares_.sum() / first_weight_;
  const double error = rounding_ * shares_.cwiseAbs().sum() / std::abs(first_weight_);
  return {ratio, error + first_weight_error_ * std::abs(ratio),
          terms_[static_cast<std::size_t>(pivot_)].exponent - first_exponent_};
}

/// By the parameter whose derivative of order 2 is that with the pivots p_0 and p_1 the third one has p_2 replaced
/// by 2 p_1 - p_0; three times the first derivative of the weight comes from the quotient.
GradedNumber shiftOf(double pivot_shift, const GradedNumber& weight) {
  if (pivot_shift == 0) return {3 * weight.value, 3 * weight.error, weight.exponent};
  return {pivot_shift + std::ldexp(3 * weight.value, weight.exponent),
          std::ldexp(3 * weight.error, weight.exponent), 0};
}

}  // namespace

GradedDerivatives gradedDerivatives(const HomogeneousPoles& poles, double t, int order) {
  GradedDerivatives result;
  const GradedTerm rate = logParameter(t).rate;
  result.rate = {rate.mantissa, 4 * std::numeric_limits<double>::epsilon() * std::abs(rate.mantissa),
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

}  // namespace seamwright
