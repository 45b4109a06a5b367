// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/edge_patches.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

const std::vector<double>& knotsAlong(const BSplineSurface& surface, SurfaceDirection direction) {
  return direction == SurfaceDirection::U ? surface.knots_u : surface.knots_v;
}

int degreeAlong(const BSplineSurface& surface, SurfaceDirection direction) {
  return direction == SurfaceDirection::U ? surface.degree_u : surface.degree_v;
}

std::vector<double> innerKnots(const BSplineSurface& surface, SurfaceDirection direction) {
  const std::vector<double>& knots = knotsAlong(surface, direction);
  const int degree = degreeAlong(surface, direction);
  std::vector<double> inner(knots.begin() + degree + 1, knots.end() - degree - 1);
  inner.erase(std::unique(inner.begin(), inner.end()), inner.end());
  return inner;
}

SurfaceDirection otherThan(SurfaceDirection direction) {
  return direction == SurfaceDirection::U ? SurfaceDirection::V : SurfaceDirection::U;
}

/// By how much the share of a knot may differ from what it was made from: knots have roundings of
/// their own size, shares one of theirs.
double shareNoise(const BSplineSurface& surface, PatchEdge edge) {
  const std::vector<double>& knots = knotsAlong(surface, along(edge));
  const double size = std::max(std::abs(knots.front()), std::abs(knots.back()));
  return 4 * std::numeric_limits<double>::epsilon() * (1 + size / (knots.back() - knots.front()));
}

/// The surface with each knot as often as its degree, so that spans have their own poles.
BSplineSurface divided(const BSplineSurface& surface, SurfaceDirection direction) {
  return withRaisedKnots(surface, direction, degreeAlong(surface, direction));
}

/// The patch of one span of a divided surface.
BezierPatch patchOf(const BSplineSurface& surface, std::size_t span_u, std::size_t span_v) {
  const int m = surface.degree_u, n = surface.degree_v;
  HomogeneousPoles poles((m + 1) * (n + 1), 4);
  for (int i = 0; i <= m; ++i)
    poles.middleRows(i * (n + 1), n + 1) =
        surface.poles.middleRows((static_cast<Eigen::Index>(span_u) * m + i) * surface.countV() +
                                     static_cast<Eigen::Index>(span_v) * n,
                                 n + 1);
  return {m, n, affinePoles(poles), poles.col(3)};
}

/// edgePatches(), with the distance within which breaks are one.
std::vector<BezierPatch> patchesBeside(const BSplineSurface& surface, PatchEdge edge,
                                       const std::vector<double>& more, double noise) {
  const std::vector<double> own = edgeBreaks(surface, edge);
  const SurfaceDirection direction = along(edge), across = otherThan(direction);
  const std::vector<double>& knots = knotsAlong(surface, direction);
  BSplineSurface cut = surface;
  std::vector<double> breaks = own;
  breaks.insert(breaks.end(), {0, 1});
  for (const double share : more) {
    if (!(share > 0 && share < 1))
      refuse(fmt::format("break {}: it must lie strictly between 0 and 1", share));
    if (std::ranges::any_of(breaks, [&](double at) { return std::abs(share - at) <= noise; }))
      continue;
    breaks.push_back(share);
    cut = withKnot(cut, direction, knots.front() + share * (knots.back() - knots.front()));
  }
  cut = divided(divided(cut, direction), across);
  const bool at_begin = edge == PatchEdge::U0 || edge == PatchEdge::V0;
  const std::size_t beside = at_begin ? 0 : innerKnots(surface, across).size();
  std::vector<BezierPatch> patches;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    patches.push_back(direction == SurfaceDirection::U ? patchOf(cut, i, beside)
                                                       : patchOf(cut, beside, i));
  return patches;
}

}  // namespace

std::vector<double> edgeBreaks(const BSplineSurface& surface, PatchEdge edge) {
  requireValid(surface);
  const std::vector<double>& knots = knotsAlong(surface, along(edge));
  std::vector<double> shares;
  for (const double knot : innerKnots(surface, along(edge)))
    shares.push_back((knot - knots.front()) / (knots.back() - knots.front()));
  return shares;
}

std::vector<BezierPatch> edgePatches(const BSplineSurface& surface, PatchEdge edge,
                                     const std::vector<double>& more) {
  requireValid(surface);
  return patchesBeside(surface, edge, more, shareNoise(surface, edge));
}

std::vector<std::pair<BezierPatch, BezierPatch>> edgePairs(const BSplineSurface& a,
                                                           PatchEdge edge_a,
                                                           const BSplineSurface& b,
                                                           PatchEdge edge_b, bool reversed) {
  const auto turned = [&](std::vector<double> shares) {
    if (reversed)
      for (double& share : shares) share = 1 - share;
    return shares;
  };
  const std::vector<double> of_a = edgeBreaks(a, edge_a), of_b = edgeBreaks(b, edge_b);
  const double noise = shareNoise(a, edge_a) + shareNoise(b, edge_b);
  const std::vector<BezierPatch> first = patchesBeside(a, edge_a, turned(of_b), noise);
  std::vector<BezierPatch> second = patchesBeside(b, edge_b, turned(of_a), noise);
  if (first.size() != second.size())
    refuse(fmt::format("{} and {} spans correspond: knots are nearer to each other than rounding",
                       first.size(), second.size()));
  if (reversed) std::ranges::reverse(second);
  std::vector<std::pair<BezierPatch, BezierPatch>> pairs;
  for (std::size_t i = 0; i < first.size(); ++i) pairs.emplace_back(first[i], second[i]);
  return pairs;
}

}  // namespace seamwright
