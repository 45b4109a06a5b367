// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <optional>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/fill/fit_corner.hpp>
#include <seamwright/occ_adapter/fill/hole_contradiction.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

namespace seamwright::occ {

namespace {

/// An edge of a hole with the normals of its face at its ends, where it has a tangent plane.
struct EdgeEnds {
  HoleEdge edge;
  Eigen::Vector3d point;
  std::optional<Eigen::Vector3d> begin, end;
};

std::vector<EdgeEnds> endsOf(const Hole& hole, double gap_mm) {
  std::vector<EdgeEnds> ends;
  for (const HoleSide& side : hole.sides)
    for (const HoleEdge& edge : side.edges) {
      const SidePath path({{edge}, edge.length_mm}, gap_mm);
      EdgeEnds& one = ends.emplace_back(
          EdgeEnds{edge, path.besidePoleAtShare(0, true).point, std::nullopt, std::nullopt});
      if (path.hasTangentPlane(0)) one.begin = path.atShare(0, true).normal;
      if (path.hasTangentPlane(1)) one.end = path.atShare(1, false).normal;
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
    if (!in.end || !out.begin) continue;
    const double angle = angleBetween(*in.end, *out.begin);
    if (!(angle > most_rad)) continue;
    most_rad = angle;
    worst.numbers = {{"angle_deg", angle * degrees_per_radian}};
    worst.edges = {in.edge.edge, out.edge.edge};
    worst.point_mm = out.point;
  }
  if (worst.edges.empty()) return {};
  return {worst};
}

}  // namespace seamwright::occ
