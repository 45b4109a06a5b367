// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>
#include <seamwright/occ_adapter/fill/side_cut.hpp>

/// Fits polynomials to the sides of a hole. Not a public header.
namespace seamwright::occ {

struct SideFitOptions {
  double gap_mm = 0;     ///< accepted distance of points with the same parameter
  double angle_rad = 0;  ///< accepted angle to the tangent planes of the faces
  int most_degree = 9;   ///< largest degree of edges and cross-boundary derivatives, 3 to 11
  /// Largest angle between a corner's tangents and the tangent plane of a side that keeps its
  /// tangent planes.
  double planar_rad = 0;
  bool curvature = false;  ///< FillSide::bend is also fitted
};

/// A side of a hole for nSidedFill(), with its distances from the faces. These are sampled at four
/// times as many points as were fitted.
struct FittedSide {
  FillSide side;
  double gap_mm = 0;
  /// Angle of the planes spanned by E' and T to those of the faces; 0 for position alone.
  double angle_rad = 0;
  /// Angle, at both corners, between the plane of the side and that of the face. The fill has that
  /// angle to its neighbour there.
  std::array<double, 2> corner_rad{};
  /// Difference between the fitted curvature across the side and that of the faces.
  double curvature_per_mm = 0;
};

/// Fits edges E and cross-boundary derivatives T by least squares, in the lowest degrees that come
/// near enough, or else in the highest degree. The fit is exact, to rounding, where the edge is a
/// polynomial of such a degree in its own parameter and an exact T exists.
///
/// Parametrisation: an interval of one edge keeps the edge's parameter if that comes near enough.
/// Otherwise it has arc length, or nearly affine arc length, if that comes nearer. An interval of
/// several edges has arc length, or a parameter that gives more range to short edges or to strongly
/// curved parts.
///
/// Ends of neighbouring intervals are one point, halfway. At each corner T is in the plane of both
/// edges. This is the plane halfway between the tangent planes of the faces, with both edges turned
/// into it, if that turns neither edge by much; otherwise it is the plane of the edges as they are.
/// Where an interval begins smoothly, both edges have one tangent, halfway, and T is in a plane
/// halfway between those of the faces. Where the plane leaves the tangent plane of a side by more
/// than planar_rad, that side has position only.
/// \throws GeometryError for an edge that can't be evaluated or has no tangent at a corner;
/// Standard_Failure.
std::vector<FittedSide> fitSides(const std::vector<HoleSide>& sides,
                                 const std::vector<SideInterval>& intervals,
                                 const SideFitOptions& options);

}  // namespace seamwright::occ
