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
#include <string>
#include <utility>
#include <vector>

/// A vertex of a solid and what meets there; not a public header.
namespace seamwright::occ {

/// An edge that leaves the corner, and what is at its other end.
struct CornerEdge {
  int number = 0;  ///< from 1, order of TopExp::MapShapes
  TopoDS_Edge edge;
  Eigen::Vector3d axis;  ///< unit, out of the corner; the tangent there
  double length_mm = 0;  ///< to the far vertex, straight
  /// Unit, across the edge at the corner: into the face before it and into the face after it, seen
  /// from outside counter-clockwise.
  std::array<Eigen::Vector3d, 2> into;
  bool convex = true;
  double opening_rad = 0;  ///< angle between the two faces, of the solid or, where it is concave,
                           ///< of the air; in (0, pi)
  TopoDS_Vertex far;
  TopoDS_Face end;  ///< the third face at the far vertex; this and what follows: of a polyhedral
                    ///< corner alone
  Eigen::Vector3d end_normal;  ///< unit
  std::array<TopoDS_Edge, 2>
      end_edges;  ///< of that face with the face before and with the face after
};

/// The face between an edge and the next one.
struct CornerFace {
  TopoDS_Face face;
  Eigen::Vector3d normal;  ///< unit, out of the solid, at the corner
  double angle_rad = 0;    ///< at the corner, in (0, 2 pi)
};

/// Edges and faces counter-clockwise, seen from outside; face i lies between edges i and i + 1.
struct Corner {
  TopoDS_Vertex vertex;
  Eigen::Vector3d point;
  TopoDS_Solid solid;
  TopoDS_Shell shell;
  std::vector<CornerEdge> edges;
  std::vector<CornerFace> faces;
  TopTools_IndexedMapOfShape given_faces,
      given_edges;  ///< of the whole shape: what they are called
  /// The faces are planes, the edges lines, and at the far end of each edge meet two more and one
  /// more plane, not through the corner.
  bool polyhedral = false;

  std::size_t count() const { return edges.size(); }
  std::size_t before(std::size_t i) const { return (i + count() - 1) % count(); }
  std::size_t after(std::size_t i) const { return (i + 1) % count(); }
};

/// "2.5 mm".
std::string lengthText(double length_mm);

/// The corner in a solid of its own shell alone; where that is the wall of a void, in what fills
/// the void, seen from its outside.
/// \returns the corner, and whether it is that of a void.
std::pair<Corner, bool> ofShellAlone(const Corner& corner);

/// \param vertex from 1, order of TopExp::MapShapes.
/// \throws std::invalid_argument for a number that the shape does not have; std::domain_error, with
/// numbers, for a corner that cornerFillet() does not support.
Corner cornerOf(const TopoDS_Shape& shape, int vertex);

}  // namespace seamwright::occ
