// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

using Eigen::Vector3d;

namespace {

/// The largest angle by which a path turns at once.
double largestKink_rad(const FaceStrip& strip) {
  constexpr double beside = 1e-9;  // of the path: far above rounding, and no arc turns so fast
  double largest = 0;
  for (const double at : strip.breaks()) {
    const Vector3d before = strip.trace(std::max(0.0, at - beside)).d,
                   after = strip.trace(std::min(1.0, at + beside)).d;
    largest = std::max(largest, std::atan2(before.cross(after).norm(), before.dot(after)));
  }
  return largest;
}

/// The strip along the edge's curve in space, if that is smoother and within the edge's tolerance.
std::shared_ptr<const FaceStrip> smootherStrip(const std::shared_ptr<const FaceStrip>& strip,
                                               const Coedge& use, const Pcurve& pcurve) {
  constexpr double least_kink_rad = 1e-4, smoother = 0.1;  // choices: what nobody sees; a tenth
  const double kink_rad = largestKink_rad(*strip);
  double first = 0, last = 0;
  const bool has_curve = !BRep_Tool::Curve(use.edge, first, last).IsNull();
  if (!(kink_rad > least_kink_rad) || !has_curve || first != pcurve.first || last != pcurve.last)
    return strip;
  auto along_curve = std::make_shared<FaceStrip>(*strip);
  along_curve->followCurve(use.edge);
  constexpr int samples = 64;
  for (int i = 0; i <= samples; ++i) {
    const double at = static_cast<double>(i) / samples;
    const double apart_mm = (along_curve->trace(at).p - strip->trace(at).p).norm();
    // Both are that far from the curve at most; those who read files measure at some points only.
    if (!(apart_mm <= 3 * BRep_Tool::Tolerance(use.edge))) return strip;
  }
  return largestKink_rad(*along_curve) <= smoother * kink_rad ? along_curve : strip;
}

}  // namespace

SidePath::SidePath(const HoleSide& side, double gap_mm, JetOrder order, PathAlong along) {
  for (const HoleEdge& edge : side.edges) {
    const Pcurve pcurve = pcurveOf(edge.use.edge, edge.use.shape, gap_mm);
    auto strip = std::make_shared<const FaceStrip>(edge.use, pcurve, order);
    strips_.push_back(along == PathAlong::Smoother ? smootherStrip(strip, edge.use, pcurve)
                                                   : strip);
    breaks_.push_back(strips_.back()->breaks());
    lengths_.emplace_back(
        [&](double parameter) { return strips_.back()->trace(parameter).d.norm(); },
        breaks_.back());
    reversed_.push_back(edge.reversed);
    numbers_.push_back(edge.edge);
    begins_mm_.push_back(length_mm_);
    length_mm_ += lengths_.back().length_mm();
  }
  if (!(length_mm_ > 0 && std::isfinite(length_mm_)))
    throw GeometryError("edge " + std::to_string(side.edges.front().edge) + " has no length");
}

std::vector<double> SidePath::joints() const {
  std::vector<double> shares;
  for (std::size_t k = 1; k < begins_mm_.size(); ++k) shares.push_back(begins_mm_[k] / length_mm_);
  return shares;
}

std::vector<double> SidePath::breaks() const {
  std::vector<double> shares;
  for (std::size_t k = 0; k < strips_.size(); ++k)
    for (const double parameter : breaks_[k]) {
      const double to_mm = lengths_[k].lengthTo(parameter);
      const double along_mm = reversed_[k] ? lengths_[k].length_mm() - to_mm : to_mm;
      shares.push_back((begins_mm_[k] + along_mm) / length_mm_);
    }
  std::ranges::sort(shares);
  return shares;
}

std::size_t SidePath::edgeIndex(double share, bool after) const {
  // Sums of lengths round by less.
  const double rounding_mm = 1e-12 * length_mm_, at_mm = share * length_mm_;
  std::size_t k = 0;
  while (k + 1 < begins_mm_.size() &&
         at_mm > begins_mm_[k + 1] + (after ? -rounding_mm : rounding_mm))
    ++k;
  return k;
}

SidePath::Place SidePath::placeOf(double share, bool after) const {
  const std::size_t k = edgeIndex(share, after);
  const double rest = std::clamp(share * length_mm_ - begins_mm_[k], 0.0, lengths_[k].length_mm());
  return {k, lengths_[k].parameterAt(reversed_[k] ? lengths_[k].length_mm() - rest : rest)};
}

SideSample SidePath::atShare(double share, bool after) const {
  const Place place = placeOf(share, after);
  return byShare(sampleOf(place, pointAt(place)));
}

SideSample SidePath::byShare(SideSample sample) const {
  sample.derivative = length_mm_ * sample.derivative.normalized();
  return sample;
}

bool SidePath::hasTangentPlane(double share) const {
  const SidePoint there = pointAt(placeOf(share, true));
  return degeneracy(there.jet, there.noise) == Degeneracy::None;
}

SideSample SidePath::besidePoleAtShare(double share, bool after) const {
  Place place = placeOf(share, after);
  const SidePoint there = pointAt(place);
  if (degeneracy(there.jet, there.noise) == Degeneracy::None)
    return byShare(sampleOf(place, there));
  const int end = place.parameter < 0.5 ? 0 : 1;
  // Rounding turns the normal by as much as the reach is of the distance; less than an angle that
  // anyone measures. The bounds are far below a span, and far above rounding of parameters.
  const double distance = std::clamp(1e4 * strips_[place.edge]->poleReach(end), 1e-6, 1e-3);
  place.parameter = end == 0 ? distance : 1 - distance;
  SideSample result = byShare(sampleOf(place, pointAt(place)));
  result.point = there.jet.p;
  return result;
}

SideSample SidePath::atParameter(double parameter) const {
  const Place place{0, reversed_[0] ? 1 - parameter : parameter};
  return sampleOf(place, pointAt(place));
}

double SidePath::parameterOf(double share) const {
  if (share <= 0 || share >= 1) return share <= 0 ? 0 : 1;
  return reversed_[0] ? 1 - lengths_[0].parameterAt((1 - share) * length_mm_)
                      : lengths_[0].parameterAt(share * length_mm_);
}

double SidePath::shareOf(double parameter) const {
  return reversed_[0] ? 1 - lengths_[0].lengthTo(1 - parameter) / length_mm_
                      : lengths_[0].lengthTo(parameter) / length_mm_;
}

SideSample SidePath::sampleOf(const Place& place, const SidePoint& point) const {
  const Vector3d normal = point.jet.u.cross(point.jet.v).normalized();
  const Vector3d beyond = (point.face_on_left ? 1 : -1) * normal.cross(point.tangent).normalized();
  const double sense = reversed_[place.edge] ? -1 : 1;
  return {0, point.jet.p, sense * point.tangent, normal, beyond, point.jet};
}

}  // namespace seamwright::occ
