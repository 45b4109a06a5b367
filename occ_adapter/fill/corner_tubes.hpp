// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_CylindricalSurface.hxx>
#include <array>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_hole.hpp>
#include <seamwright/occ_adapter/fill/edge_maker.hpp>

/// The cylinders of a corner. Not a public header.
namespace seamwright::occ {

/// A cylinder of the corner with its new vertices and edges. In its parameters the section is
/// v = 0, with its middle at u = pi. Contact lines run away from the section. Sections and far ends
/// run from the face before the edge to the face after it.
struct CornerTube {
  opencascade::handle<Geom_CylindricalSurface> surface;
  TopoDS_Face face;
  std::array<double, 2> u{};  ///< u of both contact lines
  std::array<TopoDS_Vertex, 2> near, far;
  std::array<TopoDS_Edge, 2> contacts;
  TopoDS_Edge end;
};

/// The cylinder of one edge. Its face has no wire yet.
/// \throws CornerRefused if the plane at its far end cuts it before the section.
CornerTube cornerTube(const CornerEdge& edge, const CornerStrip& strip, const EdgeMaker& maker);

}  // namespace seamwright::occ
