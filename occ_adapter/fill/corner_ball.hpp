// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_hole.hpp>

/// Rounds the edges of a corner by OpenCASCADE. Not a public header.
namespace seamwright::occ {

/// A solid from which a ball about the corner is removed. The corner's edges are rounded outside
/// the ball.
struct RoundedOutside {
  TopoDS_Shape solid;
  std::vector<TopoDS_Face> caps;   ///< faces on the ball
  std::vector<TopoDS_Face> bands;  ///< by edge: the part of its fillet that ends on the ball
  /// By edge: the edges in which its band ends on the ball, in any order.
  std::vector<std::vector<TopoDS_Edge>> band_ends;
  /// By face of the corner: the edges in which the ball cuts it, in any order.
  std::vector<std::vector<TopoDS_Edge>> arcs;
  std::map<int, TopoDS_Face> became;  ///< new face by number of a face in the given solid
};

/// Removes the ball and rounds what is left of the corner's edges, which do not obstruct each other
/// there.
/// \throws CornerRefused if OpenCASCADE fails, or does not make a band from face to face along
/// each edge.
RoundedOutside roundedOutside(const Corner& corner, const std::vector<CornerStrip>& strips,
                              double ball_mm);

}  // namespace seamwright::occ
