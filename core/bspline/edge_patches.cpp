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

/// The Bezier poles, one a row, of a part of a spline within one span: its polar form at both ends
/// of the part.
Eigen::MatrixXd partOf(const Eigen::MatrixXd& poles, const std::vector<double>& knots, int degree,
                       double from, double to) {
  const auto after = std::upper_bound(knots.begin() + degree + 1, knots.end() - degree - 1, from);
  const auto span = std::distance(knots.begin(), after) - 1;
  Eigen::MatrixXd part(degree + 1, poles.cols());
  for (int k = 0; k <= degree; ++k) {
    Eigen::MatrixXd rows = poles.middleRows(span - degree, degree + 1);
    for (int r = 1; r <= degree; ++r) {
      const double at = r <= degree - k ? from : to;
      for (int j = degree; j >= r; --j) {
        const double lower = knots[span - degree + j], upper = knots[span + 1 + j - r],
                     share = (at - lower) / (upper - lower);
        rows.row(j) = (1 - share) * rows.row(j - 1) + share * rows.row(j);
      }
    }
    part.row(k) = rows.row(degree);
  }
  return part;
}

/// Row i of a net: the poles (i, j) of a surface, or (j, i), one after the other.
Eigen::MatrixXd rowsAlong(const HomogeneousPoles& poles, Eigen::Index count_u, Eigen::Index count_v,
                          SurfaceDirection direction) {
  const bool by_u = direction == SurfaceDirection::U;
  Eigen::MatrixXd net(by_u ? count_u : count_v, 4 * (by_u ? count_v : count_u));
  for (Eigen::Index i = 0; i < count_u; ++i)
    for (Eigen::Index j = 0; j < count_v; ++j)
      net.block<1, 4>(by_u ? i : j, 4 * (by_u ? j : i)) = poles.row(i * count_v + j);
  return net;
}

/// The strip of one span beside an edge: row i has its poles across, from u0 or v0 on.
Eigen::MatrixXd stripBeside(const BSplineSurface& surface, PatchEdge edge) {
  const SurfaceDirection direction = along(edge), across = otherThan(direction);
  const std::vector<double>& knots = knotsAlong(surface, across);
  const int degree = degreeAlong(surface, across);
  const std::vector<double> inner = innerKnots(surface, across);
  const bool at_begin = edge == PatchEdge::U0 || edge == PatchEdge::V0;
  const double from = at_begin || inner.empty() ? knots.front() : inner.back(),
               to = at_begin && !inner.empty() ? inner.front() : knots.back();
  const Eigen::MatrixXd part =
      partOf(rowsAlong(surface.poles, surface.countU(), surface.countV(), across), knots, degree,
             from, to);
  Eigen::MatrixXd strip(part.cols() / 4, 4 * part.rows());
  for (Eigen::Index i = 0; i < strip.rows(); ++i)
    for (Eigen::Index j = 0; j < part.rows(); ++j)
      strip.block<1, 4>(i, 4 * j) = part.block<1, 4>(j, 4 * i);
  return strip;
}

/// The patch whose poles along an edge are the rows of a part of a strip.
BezierPatch patchOf(const Eigen::MatrixXd& part, SurfaceDirection direction) {
  const Eigen::Index count = part.rows(), wide = part.cols() / 4;
  const bool by_u = direction == SurfaceDirection::U;
  HomogeneousPoles poles(count * wide, 4);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < wide; ++j)
      poles.row(by_u ? i * wide + j : j * count + i) = part.block<1, 4>(i, 4 * j);
  const int degree = static_cast<int>(count) - 1, across = static_cast<int>(wide) - 1;
  return {by_u ? degree : across, by_u ? across : degree, affinePoles(poles), poles.col(3)};
}

/// The parameters at which a boundary is divided: its knots, and shares that are no knots.
std::vector<double> partsOf(const BSplineSurface& surface, PatchEdge edge, std::vector<double> more,
                            double noise) {
  for (const double share : more)
    if (!(share > 0 && share < 1))
      refuse(fmt::format("break {}: it must lie strictly between 0 and 1", share));
  std::ranges::sort(more);
  const std::vector<double>& knots = knotsAlong(surface, along(edge));
  const double range = knots.back() - knots.front();
  std::vector<double> given = innerKnots(surface, along(edge));
  given.push_back(knots.back());
  std::vector<double> parts = {knots.front()};
  auto next = more.begin();
  for (const double knot : given) {
    const double end = (knot - knots.front()) / range;
    for (double last = (parts.back() - knots.front()) / range; next != more.end() && *next < end;
         ++next)
      if (*next - last > noise && end - *next > noise) {
        parts.push_back(knots.front() + *next * range);
        last = *next;
      }
    while (next != more.end() && *next - end <= noise) ++next;
    parts.push_back(knot);
  }
  return parts;
}

/// edgePatches(), with the distance within which breaks are one.
std::vector<BezierPatch> patchesBeside(const BSplineSurface& surface, PatchEdge edge,
                                       const std::vector<double>& more, double noise) {
  const SurfaceDirection direction = along(edge);
  const std::vector<double> parts = partsOf(surface, edge, more, noise);
  const Eigen::MatrixXd strip = stripBeside(surface, edge);
  std::vector<BezierPatch> patches;
  Eigen::RowVectorXd end;  // of the part before: neighbours have bitwise the same poles
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    Eigen::MatrixXd part = partOf(strip, knotsAlong(surface, direction),
                                  degreeAlong(surface, direction), parts[i], parts[i + 1]);
    if (i > 0) part.row(0) = end;
    end = part.bottomRows<1>();
    patches.push_back(patchOf(part, direction));
  }
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
