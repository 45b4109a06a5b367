// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include <seamwright/core/seam/piecewise_map.hpp>
#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/seam_strips.hpp>

namespace seamwright::occ {

namespace {

PiecewiseMap firstOf(const Correspondence& map) {
  return {map.s, map.a};
}

PiecewiseMap secondOf(const Correspondence& map) {
  return {map.s, map.b};
}

bool isWithin(const std::vector<double>& parameters, double parameter) {
  return parameter > std::min(parameters.front(), parameters.back()) &&
         parameter < std::max(parameters.front(), parameters.back());
}

/// The parameters of an edge as values of s, as far as they are on the seam.
void addMapped(const std::vector<double>& breaks, const PiecewiseMap& map,
               std::vector<double>& to) {
  for (const double parameter : breaks)
    if (map.x.empty())
      to.push_back(parameter);
    else if (isWithin(map.y, parameter))
      to.push_back(map.backAt(parameter));
}

}  // namespace

double parameterOnFirst(const Correspondence& correspondence, double s) {
  return correspondence.s.empty() ? s : firstOf(correspondence).valueAt(s);
}

SeamStrips::SeamStrips(const Seam& seam, const std::array<Pcurve, 2>& pcurves, JetOrder order)
    : map_(seam.correspondence),
      a_(seam.sides[0], pcurves[0], order),
      b_(seam.sides[1], pcurves[1], order) {}

double SeamStrips::parameterOnB(double s, const Eigen::Vector3d& on_a) const {
  const auto [low, high] = std::minmax(map_.b.front(), map_.b.back());
  return nearestParameter(b_, on_a, secondOf(map_).valueAt(s), low, high);
}

PairMeasure SeamStrips::measureAt(double s) const {
  if (map_.s.empty()) return measurePair(a_.at(s), b_.at(s));
  const SidePoint a = a_.at(firstOf(map_).valueAt(s));
  SidePoint b = b_.at(parameterOnB(s, a.jet.p));
  if (map_.b.back() < map_.b.front()) {
    b.tangent = -b.tangent;
    b.face_on_left = !b.face_on_left;
  }
  return measurePair(a, b);
}

std::vector<double> SeamStrips::breaks() const {
  std::vector<double> breaks;
  addMapped(a_.breaks(), firstOf(map_), breaks);
  addMapped(b_.breaks(), secondOf(map_), breaks);
  std::ranges::sort(breaks);
  // A knot of each side at the same point of a shared edge differs by the rounding of both paths.
  constexpr double apart = 1e-9;
  std::vector<double> merged = {0};
  for (const double s : breaks)
    if (s > merged.back() + apart && s < 1 - apart) merged.push_back(s);
  merged.push_back(1);
  return merged;
}

}  // namespace seamwright::occ
