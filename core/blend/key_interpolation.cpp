// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/key_interpolation.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using bernstein::text;
using Eigen::Index;
using Continuity = KeyInterpolation::Continuity;

void requireOmegas(const std::vector<double>& omegas) {
  if (omegas.size() < 2)
    refuse("omegas " + std::to_string(omegas.size()) + ": at least 2 are needed");
  for (std::size_t i = 0; i < omegas.size(); ++i) {
    if (!std::isfinite(omegas[i]))
      refuse("omega " + std::to_string(i) + " is " + text(omegas[i]) + ": it must be finite");
    if (i > 0 && !(omegas[i] > omegas[i - 1]))
      refuse("omega " + std::to_string(i) + " is " + text(omegas[i]) + ", the one before " +
             text(omegas[i - 1]) + ": omegas must increase");
  }
}

/// The derivative at x of the parabola through the values at three omegas.
Eigen::RowVector3d parabolaSlope(const double* at, double x) {
  const double a = at[0], b = at[1], c = at[2];
  return {((x - b) + (x - c)) / ((a - b) * (a - c)), ((x - a) + (x - c)) / ((b - a) * (b - c)),
          ((x - a) + (x - b)) / ((c - a) * (c - b))};
}

Eigen::MatrixXd firstDerivatives(const std::vector<double>& omegas) {
  const auto count = static_cast<Index>(omegas.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
  if (count == 2) {
    const double slope = 1 / (omegas[1] - omegas[0]);
    result << -slope, slope, -slope, slope;
    return result;
  }
  for (Index i = 0; i < count; ++i) {
    const Index first = std::clamp<Index>(i - 1, 0, count - 3);
    result.row(i).segment<3>(first) = parabolaSlope(omegas.data() + first, omegas[i]);
  }
  return result;
}

/// Of the natural cubic spline.
Eigen::MatrixXd secondDerivatives(const std::vector<double>& omegas) {
  const auto count = static_cast<Index>(omegas.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(count, count);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, count);
  for (Index i = 1; i + 1 < count; ++i) {
    const double before = omegas[i] - omegas[i - 1], after = omegas[i + 1] - omegas[i];
    matrix.row(i).segment<3>(i - 1) << before / 6, (before + after) / 3, after / 6;
    right.row(i).segment<3>(i - 1) << 1 / before, -1 / before - 1 / after, 1 / after;
  }
  return linear::PivotedQr(matrix).solve(right);
}

}  // namespace

KeyInterpolation::KeyInterpolation(std::vector<double> omegas, Continuity continuity)
    : omegas_(std::move(omegas)), continuity_(continuity) {
  requireOmegas(omegas_);
  if (continuity_ == Continuity::C1) slopes_ = firstDerivatives(omegas_);
  if (continuity_ == Continuity::C2) slopes_ = secondDerivatives(omegas_);
}

std::optional<int> KeyInterpolation::keyAt(double omega) const {
  const auto found = std::lower_bound(omegas_.begin(), omegas_.end(), omega);
  if (found == omegas_.end() || *found != omega) return std::nullopt;
  return static_cast<int>(found - omegas_.begin());
}

std::pair<int, double> KeyInterpolation::interval(double omega) const {
  if (!(omega >= omegas_.front() && omega <= omegas_.back()))
    refuse("omega is " + text(omega) + ": it must be within " + text(omegas_.front()) + " to " +
           text(omegas_.back()));
  const auto above = std::upper_bound(omegas_.begin() + 1, omegas_.end() - 1, omega);
  const auto i = static_cast<int>(above - omegas_.begin()) - 1;
  return {i, (omega - omegas_[i]) / (omegas_[i + 1] - omegas_[i])};
}

Eigen::VectorXd KeyInterpolation::linearWeights(double omega) const {
  const auto [i, share] = interval(omega);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(keys());
  result(i) = 1 - share;
  result(i + 1) = share;
  return result;
}

Eigen::VectorXd KeyInterpolation::weights(double omega) const {
  Eigen::VectorXd result = linearWeights(omega);
  if (continuity_ == Continuity::C0 || keys() == 2 || keyAt(omega)) return result;
  const auto [i, t] = interval(omega);
  const double length = omegas_[i + 1] - omegas_[i], s = 1 - t;
  if (continuity_ == Continuity::C1) {
    // Hermite's cubic about the line: s t (s - t) and its mirror image.
    result(i) += s * t * (s - t);
    result(i + 1) -= s * t * (s - t);
    result += length * s * t * (s * slopes_.row(i) - t * slopes_.row(i + 1)).transpose();
  } else {
    result += length * length / 6 *
              ((s * s * s - s) * slopes_.row(i) + (t * t * t - t) * slopes_.row(i + 1)).transpose();
  }
  return result;
}

}  // namespace seamwright
