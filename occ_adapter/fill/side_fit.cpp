// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <memory>

#include <seamwright/occ_adapter/fill/cross_fit.hpp>
#include <seamwright/occ_adapter/fill/edge_fit.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// An angle that is known up to rounding is accepted with this factor.
constexpr double rounding = 1.01;

/// Fits one side.
class SideFit {
 public:
  SideFit(std::shared_ptr<const SidePath> path, const SideInterval& interval,
          const SideFitOptions& options)
      : path_(std::move(path), interval), options_(options) {}

  SideSample end(bool last) const { return path_.at(last ? 1 : 0, parametrisations()[0]); }

  /// The largest turn of an end. A turn by θ moves a cubic edge of length L by at most 4 θ L / 27
  /// (docs/theory/repair.md R1). The move may be five times the gap of the fit, which is itself a
  /// small share of the tolerance.
  double mostTurn_rad() const {
    constexpr double gap_of_turn = 4.0 / 27, share = 5;
    return share * options_.gap_mm / (gap_of_turn * path_.length_mm());
  }

  /// The fit in the first parametrisation that is near enough, or else in the one that comes
  /// nearest.
  FittedSide fitted(const FitCorner& begin, const FitCorner& end) const {
    Corners corners{.ends = {begin.begin, end.end},
                    .normals = {begin.normal, end.normal},
                    .angles_rad = {angleBetween(begin.normal, this->end(false).normal),
                                   angleBetween(end.normal, this->end(true).normal)}};
    corners.enough_rad =
        std::max(options_.angle_rad, rounding * std::ranges::max(corners.angles_rad));
    const auto missOf = [&](const FittedSide& side) {
      return std::max(side.gap_mm / options_.gap_mm, side.angle_rad / corners.enough_rad);
    };
    std::optional<FittedSide> best;
    std::vector<EdgeFit> edges;
    const auto all = parametrisations();
    for (const Parametrisation parametrisation : all) {
      edges.push_back(
          nearestEdge(path_, parametrisation, corners.ends, options_, corners.enough_rad));
      if (edges.back().miss > 1 && parametrisation != all.back()) continue;
      std::ranges::stable_sort(edges, {}, &EdgeFit::miss);
      for (const EdgeFit& edge : edges) {
        if (best && edge.miss >= missOf(*best)) continue;
        FittedSide side = sideOf(edge, corners);
        if (!best || missOf(side) < missOf(*best)) best = std::move(side);
      }
      if (missOf(*best) <= 1) break;
      edges.clear();
    }
    return std::move(*best);
  }

 private:
  struct Corners {
    std::array<SideFitEnd, 2> ends;
    std::array<Vector3d, 2> normals;
    std::array<double, 2> angles_rad = {};  ///< between the planes of the corners and of the faces
    double enough_rad = 0;  ///< accepted angle, or the larger one that the corners allow
  };

  std::array<Parametrisation, 3> parametrisations() const {
    return path_.isOneEdge() ? std::array{Parametrisation::Own, Parametrisation::ArcLength,
                                          Parametrisation::AffineArcLength}
                             : std::array{Parametrisation::ArcLength, Parametrisation::Centripetal,
                                          Parametrisation::AffineArcLength};
  }

  FittedSide sideOf(const EdgeFit& edge, const Corners& corners) const {
    FittedSide side{
        .side = {edge.edge, std::nullopt}, .gap_mm = edge.gap_mm, .corner_rad = corners.angles_rad};
    if (std::ranges::max(corners.angles_rad) > options_.planar_rad) return side;
    const CrossFit cross =
        fittedCross(edge, corners.normals, path_.length_mm(), options_.most_degree,
                    std::max(corners.enough_rad, rounding * edge.tilt_rad));
    side.side.cross = cross.cross;
    side.angle_rad = cross.angle_rad;
    if (!options_.curvature) return side;
    const BendFit bend =
        fittedBend(*edge.samples, cross.cross, path_.length_mm(), options_.most_degree);
    side.side.bend = bend.bend;
    side.curvature_per_mm = bend.curvature_per_mm;
    return side;
  }

  IntervalPath path_;
  SideFitOptions options_;
};

}  // namespace

std::vector<FittedSide> fitSides(const std::vector<HoleSide>& sides,
                                 const std::vector<SideInterval>& intervals,
                                 const SideFitOptions& options) {
  const std::size_t n = intervals.size();
  const auto before = [n](std::size_t k) { return (k + n - 1) % n; };
  const auto next = [n](std::size_t k) { return (k + 1) % n; };
  std::vector<std::shared_ptr<const SidePath>> paths;
  for (const HoleSide& side : sides)
    paths.push_back(std::make_shared<const SidePath>(side, options.gap_mm));
  std::vector<SideFit> fits;
  for (const SideInterval& interval : intervals)
    fits.emplace_back(paths.at(interval.side), interval, options);
  std::vector<FitCorner> corners;  // by side: the corner at its begin
  for (std::size_t k = 0; k < n; ++k) {
    const SideFit &in = fits[before(k)], &out = fits[k];
    corners.push_back(
        intervals[k].begins_smoothly
            ? smoothCorner(in.end(true), out.end(false))
            : sharpCorner(in.end(true), out.end(false), {in.mostTurn_rad(), out.mostTurn_rad()}));
  }
  std::vector<FittedSide> fitted;
  for (std::size_t k = 0; k < n; ++k)
    fitted.push_back(fits[k].fitted(corners[k], corners[next(k)]));
  return fitted;
}

}  // namespace seamwright::occ
