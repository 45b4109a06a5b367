// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/fill/fit_corner.hpp>
#include <seamwright/occ_adapter/fill/hole_contradiction.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

namespace seamwright::occ {

namespace {

/// An edge of a hole with its ends.
struct EdgeEnds {
  HoleEdge edge;
  SideSample begin, end;
};

std::vector<EdgeEnds> endsOf(const Hole& hole, double gap_mm) {
  std::vector<EdgeEnds> ends;
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges) {
      const SidePath path({{edge}, edge.length_mm}, gap_mm);
      ends.push_back({edge, path.besidePoleAtShare(0, true), path.besidePoleAtShare(1, false)});
    }
  return ends;
}

}  // namespace

std::vector<FillReason> causesOfContradiction(const Hole& hole, double angle_rad, double gap_mm) {
  const std::vector<EdgeEnds> ends = endsOf(hole, gap_mm);
  FillReason worst{.fault = FillFault::NeighboursContradict};
  double most_rad = 2 * angle_rad;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const EdgeEnds &in = ends[(k + ends.size() - 1) % ends.size()], &out = ends[k];
    const double angle = angleBetween(in.end.normal, out.begin.normal);
    if (!(angle > most_rad)) continue;
    most_rad = angle;
    worst.numbers = {{"angle_deg", angle * degrees_per_radian}};
    worst.edges = {in.edge.edge, out.edge.edge};
    worst.point_mm = out.begin.point;
  }
  if (worst.edges.empty()) return {};
  return {worst};
}

}  // namespace seamwright::occ
