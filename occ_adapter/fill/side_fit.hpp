// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>
#include <seamwright/occ_adapter/fill/side_cut.hpp>

/// Sides of a hole as polynomials; not a public header.
namespace seamwright::occ {

struct SideFitOptions {
  double gap_mm = 0;       ///< distance of points of the same parameter to be reached
  double angle_rad = 0;    ///< angle to the tangent planes to be reached
  int most_degree = 9;     ///< of edges and cross fields, 3 to 11
  double planar_rad = 0;   ///< a corner's tangents leave the plane of a side that keeps its tangent
                           ///< planes by no more
  bool curvature = false;  ///< FillSide::bend is fitted as well
};

/// A side of a hole for nSidedFill(), and how near it comes to the faces, at four times as many
/// points as were fitted.
struct FittedSide {
  FillSide side;
  double gap_mm = 0;
  double angle_rad =
      0;  ///< of the planes spanned by E' and T to those of the faces; 0 for position alone
  /// By which the planes at its corners leave those of the faces. The fill has that angle to its
  /// neighbour there.
  std::array<double, 2> corner_rad{};
  double curvature_per_mm =
      0;  ///< difference of the curvature across the side, as fitted, from that of the faces
};

/// Edges and cross fields of the lowest degrees that come near enough, or of the highest, by least
/// squares; exact, but for rounding, where the edge is a polynomial of such a degree in its own
/// parameter, and where such a field exists. An interval of one edge keeps the edge's parameter
/// unless that of arc length, or of nearly affine arc length, comes nearer and its own is not near
/// enough; one of several has that of arc length, or one in which short edges or bent places have
/// more. Ends of neighbouring intervals are one point, halfway, and T is in the plane of both edges
/// at each corner: the one halfway between the planes of the faces, into which both edges are
/// turned, where that moves neither by much, else that of the edges as they are. Where an interval
/// begins smoothly, both edges have one tangent, halfway, and T is in a plane halfway between those
/// of the faces. Where that plane leaves the tangent plane of a side by more than planar_rad, the
/// side asks for position alone.
/// \throws std::runtime_error for an edge that can't be evaluated or has no tangent at a corner;
/// Standard_Failure.
std::vector<FittedSide> fitSides(const std::vector<HoleSide>& sides,
                                 const std::vector<SideInterval>& intervals,
                                 const SideFitOptions& options);

}  // namespace seamwright::occ
