// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <map>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_hole.hpp>

/// A corner whose edges OpenCASCADE rounds; not a public header.
namespace seamwright::occ {

/// A solid without a ball about the corner, its edges outside the ball rounded.
struct RoundedOutside {
  TopoDS_Shape solid;
  std::vector<TopoDS_Face> caps;   ///< on the ball
  std::vector<TopoDS_Face> bands;  ///< of edge i: the part of its fillet that ends on the ball
  std::vector<std::vector<TopoDS_Edge>> band_ends;  ///< where it does, in any order
  std::vector<std::vector<TopoDS_Edge>>
      arcs;                           ///< where the ball cuts face i of the corner, in any order
  std::map<int, TopoDS_Face> became;  ///< by number of a face in the given solid
};

/// Takes the ball away and rounds the edges that are left of the corner's: there none is in the
/// other's way.
/// \throws std::domain_error where OpenCASCADE does not, or makes no band from face to face of each
/// edge.
RoundedOutside roundedOutside(const Corner& corner, const std::vector<CornerStrip>& strips,
                              double ball_mm);

}  // namespace seamwright::occ
