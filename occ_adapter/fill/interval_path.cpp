// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <seamwright/occ_adapter/fill/interval_path.hpp>

namespace seamwright::occ {

/// The share of an interval as a function of t, with dt / ds proportional to the cube root of the
/// geodesic curvature. Geodesic curvature is smooth where the path passes from one surface to
/// another that is tangent to it. Straight parts get a small least rate.
class AffineArcLengthShare {
 public:
  /// \param at the path at shares of the interval. Its normals may change sign between edges, as
  /// the orientation of faces may.
  explicit AffineArcLengthShare(const std::function<SideSample(double)>& at) {
    std::vector<SideSample> samples;
    for (int k = 0; k <= 2 * pieces; ++k) samples.push_back(at(k / (2.0 * pieces)));
    std::vector<double> bending(samples.size());  // turning per interval
    for (std::size_t k = 1; k + 1 < samples.size(); ++k)
      bending[k] =
          pieces * (samples[k + 1].derivative.normalized() - samples[k - 1].derivative.normalized())
                       .dot(samples[k].beyond);
    bending.front() = 2 * bending[1] - bending[2];
    bending.back() = 2 * bending[2 * pieces - 1] - bending[2 * pieces - 2];
    double mean = 0;
    for (const double one : bending) mean += std::abs(one) / static_cast<double>(bending.size());
    const double least = straight_rad + straight_share * mean;
    const auto rate = [&](int k) { return std::cbrt(std::hypot(bending[k], least)); };
    for (int k = 0; k <= pieces; ++k) rate_[k] = rate(2 * k);
    for (int k = 0; k < pieces; ++k)
      integral_[k + 1] =
          integral_[k] + (rate(2 * k) + 4 * rate(2 * k + 1) + rate(2 * k + 2)) / (6 * pieces);
  }

  /// The share at t and its derivative.
  std::array<double, 2> at(double t) const {
    const double integral = t * integral_[pieces];
    const auto after = std::upper_bound(integral_.begin() + 1, integral_.end() - 1, integral);
    const int k = static_cast<int>(after - integral_.begin()) - 1;
    double x = (integral - integral_[k]) / (integral_[k + 1] - integral_[k]);
    for (int step = 0; step < 4; ++step) x -= (within(k, x)[0] - integral) / within(k, x)[1];
    return {(k + x) / pieces, integral_[pieces] / (pieces * within(k, x)[1])};
  }

 private:
  /// A choice: any smooth increasing function will do, as fits are measured at points of the path.
  static constexpr int pieces = 128;
  /// Least turning per interval: an absolute part and a share of the mean turning. Choices: less
  /// makes samples on straight parts too few, more makes the parametrisation arc-length.
  static constexpr double straight_rad = 0.02, straight_share = 0.03;

  /// The cubic Hermite interpolant on a piece, and its derivative by x.
  std::array<double, 2> within(int k, double x) const {
    const double rise = integral_[k + 1] - integral_[k], a = rate_[k] / pieces,
                 b = rate_[k + 1] / pieces;
    const double square = 3 * rise - 2 * a - b, cube = a + b - 2 * rise;
    return {integral_[k] + x * (a + x * (square + x * cube)), a + x * (2 * square + 3 * x * cube)};
  }

  std::array<double, pieces + 1> rate_{}, integral_{};
};

namespace {

SideSample placed(SideSample sample, double t, double range) {
  sample.t = t;
  sample.derivative *= range;
  return sample;
}

}  // namespace

SideSample IntervalPath::at(double t, Parametrisation parametrisation) const {
  if (parametrisation == Parametrisation::Own) {
    const double first = path_->parameterOf(interval_.begin),
                 range = parameterAround(interval_.end) - first;
    const double parameter = first + t * range;
    return placed(path_->atParameter(parameter > 1 ? parameter - 1 : parameter), t, range);
  }
  if (parametrisation == Parametrisation::AffineArcLength) {
    const auto [share, rate] = affineShare().at(t);
    return placed(atShare(t == 1 ? 1 : share), t, rate * range());
  }
  const double slope = parametrisation == Parametrisation::ArcLength ? 1 : slope_;
  return placed(atShare(t == 1 ? 1 : t * (slope + (1 - slope) * t)), t,
                (slope + 2 * (1 - slope) * t) * range());
}

SideSample IntervalPath::atShare(double part) const {
  const double share = part == 1 ? interval_.end : interval_.begin + part * range();
  return share > 1 ? path_->atShare(share - 1, part < 1) : path_->atShare(share, part < 1);
}

double IntervalPath::parameterAround(double share) const {
  return share > 1 ? 1 + path_->parameterOf(share - 1) : path_->parameterOf(share);
}

const AffineArcLengthShare& IntervalPath::affineShare() const {
  if (!affine_)
    affine_ =
        std::make_shared<const AffineArcLengthShare>([this](double part) { return atShare(part); });
  return *affine_;
}

double IntervalPath::centripetalSlope() const {
  // A choice: the speeds at the ends differ by the factor (2 - least) / least = 7 at most. At 0 one
  // end has no derivative.
  constexpr double least = 0.25;
  std::vector<double> ends;
  for (const double joint : path_->joints())
    for (const double share : {joint, joint + 1})
      if (share > interval_.begin && share < interval_.end)
        ends.push_back((share - interval_.begin) / range());
  ends.push_back(1);
  std::ranges::sort(ends);
  std::vector<double> roots;
  for (std::size_t k = 0; k < ends.size(); ++k)
    roots.push_back((k == 0 ? 0 : roots.back()) + std::sqrt(ends[k] - (k == 0 ? 0 : ends[k - 1])));
  double product = 0, square = 0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double t = roots[k] / roots.back(), bulge = t - t * t;
    product += (ends[k] - t * t) * bulge;
    square += bulge * bulge;
  }
  return square > 0 ? std::clamp(product / square, least, 2 - least) : 1;
}

std::vector<SideSample> samplesOf(const IntervalPath& path, Parametrisation parametrisation,
                                  int count) {
  std::vector<SideSample> samples;
  for (int i = 0; i <= count; ++i)
    samples.push_back(path.at((1 - std::cos(std::numbers::pi * i / count)) / 2, parametrisation));
  return samples;
}

}  // namespace seamwright::occ
