// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/blend/frame_features.hpp>
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::match {

namespace {

/// What it costs to leave a feature alone, in units of the reach. Two other features at the limit
/// of the reach cost as much as to leave both; corners are matched in preference to extrema.
double aloneCost(const Feature& feature) {
  return feature.kind == FeatureKind::Corner ? 2 : 0.5;
}

double pairCost(const Feature& a, const Feature& b, double reach) {
  const double moved = std::abs(a.share - b.share);
  if (a.kind != b.kind || !(moved <= reach)) return infinite;
  return moved == 0 ? 0 : moved / reach;
}

void addCorners(const Measured& frame, double corner_rad, std::vector<Feature>& all) {
  const std::vector<CurveJoint> joints = measureJoints(frame.spline(), 1);
  for (int i = 1; i < frame.spline().segments(); ++i)
    if (const auto& angle = joints[static_cast<std::size_t>(i) - 1].angle_rad;
        angle && *angle > corner_rad)
      all.push_back({FeatureKind::Corner, {i, 0}, frame.share(i)});
}

}  // namespace

Features featuresOf(const Measured& frame, bool planar, double corner_rad) {
  Features result;
  addCorners(frame, corner_rad, result.all);
  for (int i = 0; i < frame.spline().segments(); ++i) {
    const BezierCurve curve = segment(frame.spline(), i);
    try {
      const CurvatureProfile profile =
          planar ? planarCurvatureProfile(curve) : spaceCurvatureProfile(curve);
      for (const CurvatureExtremum& extremum : profile.extrema) {
        const Place place{i, extremum.parameters.middle()};
        result.all.push_back({extremum.maximum ? FeatureKind::Maximum : FeatureKind::Minimum, place,
                              frame.shareAt(place)});
      }
    } catch (const std::domain_error&) {
      // The curve may stop in this piece.
      ++result.unknown_pieces;
    }
  }
  std::stable_sort(result.all.begin(), result.all.end(),
                   [](const Feature& a, const Feature& b) { return a.share < b.share; });
  return result;
}

std::vector<std::pair<int, int>> matchedFeatures(const std::vector<Feature>& a,
                                                 const std::vector<Feature>& b, double reach) {
  const auto m = static_cast<int>(a.size()), n = static_cast<int>(b.size());
  // cost(i, j): least cost of the features from i and j on.
  Eigen::MatrixXd cost = Eigen::MatrixXd::Zero(m + 1, n + 1);
  for (int i = m; i >= 0; --i)
    for (int j = n; j >= 0; --j) {
      if (i == m && j == n) continue;
      double best = infinite;
      if (i < m) best = std::min(best, aloneCost(a[i]) + cost(i + 1, j));
      if (j < n) best = std::min(best, aloneCost(b[j]) + cost(i, j + 1));
      if (i < m && j < n) best = std::min(best, pairCost(a[i], b[j], reach) + cost(i + 1, j + 1));
      cost(i, j) = best;
    }
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0, j = 0; i < m && j < n;) {
    if (cost(i, j) == pairCost(a[i], b[j], reach) + cost(i + 1, j + 1)) {
      pairs.emplace_back(i++, j++);
    } else if (cost(i, j) == aloneCost(a[i]) + cost(i + 1, j)) {
      ++i;
    } else {
      ++j;
    }
  }
  return pairs;
}

}  // namespace seamwright::match
