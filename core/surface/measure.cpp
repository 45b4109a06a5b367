// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <seamwright/core/surface/measure.hpp>

namespace seamwright {

LineVariation variationOf(std::span<const double> values, double noise) {
  LineVariation line;
  if (values.empty()) return line;
  double low = values.front(), high = values.front();
  int way = 0, sign = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = values[k];
    if (k > 0) line.total += std::abs(value - values[k - 1]);
    if (std::abs(value) > noise) {
      const int now = value > 0 ? 1 : -1;
      if (sign != 0 && now != sign) ++line.inflections;
      sign = now;
    }
    low = std::min(low, value);
    high = std::max(high, value);
    const int turned = way >= 0 && value < high - noise  ? -1
                       : way <= 0 && value > low + noise ? 1
                                                         : 0;
    if (turned == 0) continue;
    if (way != 0) ++line.extrema;
    way = turned;
    low = high = value;
  }
  return line;
}

SurfaceMeasure measureSurface(std::span<const CurvatureLine> lines, double noise_per_mm) {
  const auto finite = [](const std::vector<double>& values) {
    std::vector<double> kept;
    std::ranges::copy_if(values, std::back_inserter(kept),
                         [](double value) { return std::isfinite(value); });
    return kept;
  };
  SurfaceMeasure measure;
  for (const CurvatureLine& line : lines) {
    const std::vector<double> mean = finite(line.mean_per_mm);
    if (mean.size() < 2) continue;
    const LineVariation of_mean = variationOf(mean, noise_per_mm);
    ++measure.lines;
    measure.variation_per_mm += of_mean.total;
    measure.largest_variation_per_mm = std::max(measure.largest_variation_per_mm, of_mean.total);
    measure.extrema += of_mean.extrema;
    measure.inflections += variationOf(finite(line.normal_per_mm), noise_per_mm).inflections;
  }
  if (measure.lines > 0) measure.variation_per_mm /= measure.lines;
  return measure;
}

CurvedPoint curvedPoint(const SurfaceJet& jet, const JetNoise& noise) {
  CurvedPoint point{jet.p, unitNormal(jet, noise)};
  if (point.normal) point.curvature_per_mm = curvatureTensor(jet, *point.normal);
  return point;
}

void include(SurfaceChange& change, const CurvedPoint& before, const CurvedPoint& after) {
  const Eigen::Vector3d move = after.p - before.p;
  if (!move.allFinite()) return;
  change.move_mm.lower = std::max(change.move_mm.lower, move.norm());
  change.move_mm.upper = std::max(change.move_mm.upper, change.move_mm.lower);
  const auto &was = before.normal, &is = after.normal;
  if (!was) return;
  const double along = was->dot(move);
  change.normal_move_mm = std::max(change.normal_move_mm, std::abs(along));
  change.tangential_move_mm = std::max(change.tangential_move_mm, (move - along * *was).norm());
  if (!is) return;
  change.turn_rad = std::max(change.turn_rad, std::atan2(was->cross(*is).norm(), was->dot(*is)));
  const Eigen::Matrix3d back = Eigen::Quaterniond::FromTwoVectors(*is, *was).toRotationMatrix();
  const Eigen::Matrix3d difference =
      back * after.curvature_per_mm * back.transpose() - before.curvature_per_mm;
  if (!difference.allFinite()) return;
  const Eigen::Vector3d u = was->unitOrthogonal(), v = was->cross(u);
  const double half_sum = (u.dot(difference * u) + v.dot(difference * v)) / 2;
  const double half = (u.dot(difference * u) - v.dot(difference * v)) / 2,
               mixed = u.dot(difference * v);
  change.curvature_change_per_mm =
      std::max(change.curvature_change_per_mm, std::abs(half_sum) + std::hypot(half, mixed));
}

}  // namespace seamwright
