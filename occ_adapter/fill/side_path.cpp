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

ArcLength::ArcLength(std::function<double(double)> speed_mm) : speed_mm_(std::move(speed_mm)) {
  for (int k = 0; k < pieces; ++k) lengths_[k + 1] = lengths_[k] + between(at(k), at(k + 1));
}

double ArcLength::lengthTo(double parameter) const {
  const int k = std::clamp(static_cast<int>(parameter * pieces), 0, pieces - 1);
  return lengths_[k] + between(at(k), parameter);
}

double ArcLength::parameterAt(double length_mm) const {
  const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length_mm);
  const int k = static_cast<int>(after - lengths_.begin()) - 1;
  const double rest = length_mm - lengths_[k];
  double parameter = at(k) + rest / (lengths_[k + 1] - lengths_[k]) / pieces;
  // Newton's method ends at this share of the length, near rounding.
  constexpr double rounding = 1e-14;
  for (int step = 0; step < 4; ++step) {
    const double beyond_mm = between(at(k), parameter) - rest;
    if (std::abs(beyond_mm) <= rounding * this->length_mm()) break;
    parameter -= beyond_mm / speed_mm_(std::clamp(parameter, 0.0, 1.0));
  }
  return std::clamp(parameter, 0.0, 1.0);
}

double ArcLength::between(double from, double to) const {
  // Gauss-Legendre nodes and weights of five points on [-1, 1]; the others follow by symmetry.
  constexpr std::array<double, 3> nodes = {0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weights = {0.5688888888888889, 0.4786286704993665,
                                             0.2369268850561891};
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const double node : {-nodes[i], nodes[i]})
      sum +=
          (i == 0 ? 0.5 : 1) * weights[i] * speed_mm_(std::clamp(middle + half * node, 0.0, 1.0));
  return half * sum;
}

SidePath::SidePath(const HoleSide& side, double gap_mm, JetOrder order, PathAlong along) {
  for (const HoleEdge& edge : side.edges) {
    const Pcurve pcurve = pcurveOf(edge.use.edge, edge.use.shape, gap_mm);
    auto strip = std::make_shared<const FaceStrip>(edge.use, pcurve, order);
    strips_.push_back(along == PathAlong::Smoother ? smootherStrip(strip, edge.use, pcurve)
                                                   : strip);
    lengths_.emplace_back(
        [strip = strips_.back()](double parameter) { return strip->trace(parameter).d.norm(); });
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
    for (const double parameter : strips_[k]->breaks()) {
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
  SideSample result = sample(placeOf(share, after));
  result.derivative = length_mm_ * result.derivative.normalized();
  return result;
}

bool SidePath::hasTangentPlane(double share) const {
  const Place place = placeOf(share, true);
  const SidePoint there = strips_[place.edge]->at(place.parameter);
  return degeneracy(there.jet, there.noise) == Degeneracy::None;
}

SideSample SidePath::besidePoleAtShare(double share, bool after) const {
  Place place = placeOf(share, after);
  const FaceStrip& strip = *strips_[place.edge];
  const SidePoint there = strip.at(place.parameter);
  if (degeneracy(there.jet, there.noise) == Degeneracy::None) return atShare(share, after);
  const int end = place.parameter < 0.5 ? 0 : 1;
  // Rounding turns the normal by as much as the reach is of the distance; less than an angle that
  // anyone measures. The bounds are far below a span, and far above rounding of parameters.
  const double distance = std::clamp(1e4 * strip.poleReach(end), 1e-6, 1e-3);
  place.parameter = end == 0 ? distance : 1 - distance;
  SideSample result = sample(place);
  result.point = there.jet.p;
  result.derivative = length_mm_ * result.derivative.normalized();
  return result;
}

SideSample SidePath::atParameter(double parameter) const {
  return sample({0, reversed_[0] ? 1 - parameter : parameter});
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

SideSample SidePath::sample(const Place& place) const {
  const std::size_t k = place.edge;
  const SidePoint side = strips_[k]->at(place.parameter);
  const Vector3d normal = side.jet.u.cross(side.jet.v).normalized();
  const Vector3d beyond = (side.face_on_left ? 1 : -1) * normal.cross(side.tangent).normalized();
  return {0, side.jet.p, (reversed_[k] ? -1 : 1) * side.tangent, normal, beyond, side.jet};
}

}  // namespace seamwright::occ
