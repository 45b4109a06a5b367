// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <array>
#include <utility>
#include <vector>

/// Describes a vertex of a solid with its edges and faces. Not a public header.
namespace seamwright::occ {

/// An edge that leaves the corner, with the topology at its far end.
struct CornerEdge {
  int number = 0;  ///< from 1, in the order of TopExp::MapShapes
  TopoDS_Edge edge;
  Eigen::Vector3d axis;  ///< unit tangent at the corner, pointing out of the corner
  double length_mm = 0;  ///< straight distance to the far vertex
  /// Unit vectors across the edge at the corner: into the face before the edge and into the face
  /// after it, counter-clockwise as seen from outside.
  std::array<Eigen::Vector3d, 2> into;
  bool convex = true;
  /// Angle between the two faces: inside the solid, or, at a concave edge, outside of it; in (0,
  /// pi).
  double opening_rad = 0;
  TopoDS_Vertex far;
  /// The third face at the far vertex; this and the next members are set only for a polyhedral
  /// corner.
  TopoDS_Face end;
  Eigen::Vector3d end_normal;  ///< unit
  /// Edges of that face with the face before and with the face after.
  std::array<TopoDS_Edge, 2> end_edges;
};

/// The face between an edge and the next one.
struct CornerFace {
  TopoDS_Face face;
  Eigen::Vector3d normal;  ///< unit normal at the corner, out of the solid
  double angle_rad = 0;    ///< at the corner, in (0, 2 pi)
};

/// Edges and faces are in counter-clockwise order as seen from outside. Face i lies between edges i
/// and i + 1.
struct Corner {
  TopoDS_Vertex vertex;
  Eigen::Vector3d point;
  TopoDS_Solid solid;
  TopoDS_Shell shell;
  std::vector<CornerEdge> edges;
  std::vector<CornerFace> faces;
  /// All of the given shape; their indices are the numbers in messages.
  TopTools_IndexedMapOfShape given_faces, given_edges;
  /// The faces are planes and the edges are lines. At the far end of each edge, two more edges and
  /// one more plane meet, and that plane does not pass through the corner.
  bool polyhedral = false;

  std::size_t count() const { return edges.size(); }
  std::size_t before(std::size_t i) const { return (i + count() - 1) % count(); }
  std::size_t after(std::size_t i) const { return (i + 1) % count(); }
};

/// The same corner in a solid made of its shell alone. If the shell is the wall of a void, the
/// solid is the filling of the void, seen from its outside.
/// \returns the corner, and whether the shell is the wall of a void.
std::pair<Corner, bool> ofShellAlone(const Corner& corner);

/// \param vertex from 1, in the order of TopExp::MapShapes.
/// \throws std::invalid_argument for a number that the shape does not have; CornerRefused for a
/// corner that cornerFillet() does not support.
Corner cornerOf(const TopoDS_Shape& shape, int vertex);

/// The end of the edge that is not this one.
TopoDS_Vertex otherEnd(const TopoDS_Edge& edge, const TopoDS_Vertex& end);

}  // namespace seamwright::occ
