// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/blend/shared_corner.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// A side where it meets the other one.
struct MeetingSide {
  Vector3d point, along;  ///< along: the unit tangent away from the corner
  Vector3d out, normal;   ///< out of the face, at right angles to the side
};

MeetingSide meetingSide(const ChosenEnd& end, int corner) {
  const SideSample sample = end.path->besidePoleAtShare(corner, corner == 0);
  const Vector3d along = (corner == 0 ? 1 : -1) * sample.derivative.normalized();
  return {sample.point, along, -sample.beyond, sample.normal};
}

/// The angle from the one side to the other one across the gap, in the tangent plane of the one.
double angleAcross(const MeetingSide& one, const MeetingSide& other) {
  return std::atan2(other.along.dot(one.out), other.along.dot(one.along));
}

void requireOpening(const MeetingSide& start, const MeetingSide& end) {
  // Choices: beyond them the lines across fold or crowd together.
  constexpr double least_rad = 5 * radians_per_degree, most_rad = 175 * radians_per_degree;
  for (const double angle_rad : {angleAcross(start, end), angleAcross(end, start)})
    if (!(angle_rad >= least_rad && angle_rad <= most_rad))
      throw std::invalid_argument(fmt::format(
          "start and end meet at ({:.6g}), and the angle between them across the gap is {:.3g} "
          "degrees: {:.3g} to {:.3g} are possible; divide the gap by an edge from that vertex",
          fmt::join(start.point, ", "),
          (angle_rad < 0 ? angle_rad + 2 * std::numbers::pi : angle_rad) / radians_per_degree,
          least_rad / radians_per_degree, most_rad / radians_per_degree));
}

void requireOnePlane(const MeetingSide& start, const MeetingSide& end, double tolerance_rad) {
  const double angle_rad =
      std::atan2(start.normal.cross(end.normal).norm(), std::abs(start.normal.dot(end.normal)));
  if (!(angle_rad <= tolerance_rad))
    throw std::invalid_argument(fmt::format(
        "start and end meet at ({:.6g}), where the tangent planes of their faces differ by "
        "angle_rad = {:.3g} ({:.3g} degrees): no surface has bounded curvature there; G1 at both "
        "ends is possible",
        fmt::join(start.point, ", "), angle_rad, angle_rad / radians_per_degree));
}

}  // namespace

std::vector<SharedCorner> sharedCorners(const std::vector<ChosenEnd>& ends,
                                        const ContinuityTolerance& tolerance) {
  std::vector<SharedCorner> shared;
  if (ends[0].closed || ends[1].closed) return shared;
  for (const int i : {0, 1})
    for (const int j : {0, 1}) {
      const MeetingSide start = meetingSide(ends[0], i), end = meetingSide(ends[1], j);
      if ((end.point - start.point).norm() > tolerance.gap_mm) continue;
      requireOpening(start, end);
      if (ends[0].end.order > 1 || ends[1].end.order > 1)
        requireOnePlane(start, end, tolerance.angle_rad);
      shared.push_back({{i, j}});
    }
  return shared;
}

}  // namespace seamwright::occ
