// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/occ_adapter/convert/edge_image.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// One edge in place of two that lie along one another; not a public header.
namespace seamwright::occ {

/// Where an interval of an edge begins and ends: places 0..1 of the range of its curve.
using Places = std::array<double, 2>;

/// An edge without vertices, in the frame of the shape, that runs with the first edge of a matched
/// seam and has a path on both sides.
struct CommonEdge {
  TopoDS_Edge edge;
  opencascade::handle<Geom_Curve> curve;
  double first = 0, last = 0;
  std::vector<EdgeSide> sides;  ///< paths over [first, last]
  double tolerance_mm = 0;      ///< distance of the curve and the images of both paths, as measured
};

/// The curve lies halfway between both sides; one that both edges have is kept. The first side
/// keeps its path, the second gets one that leads to the places that belong to the first one's: the
/// same path run along otherwise, exactly where that is at constant speed (to a thousandth of \p
/// gap_mm), else interpolated to as much.
/// \param places of the interval, on both sides; those of the second belong to those of the first,
/// and may decrease.
/// \throws std::runtime_error where the points of the two sides do not follow one another or a
/// curve can't be built; Standard_Failure.
CommonEdge commonEdge(const Seam& seam, const std::array<Places, 2>& places, double gap_mm);

}  // namespace seamwright::occ
