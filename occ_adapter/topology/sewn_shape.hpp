// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_DataMapOfShapeShape.hxx>
#include <map>
#include <vector>

#include <seamwright/occ_adapter/topology/sewable.hpp>

/// Joins separate faces to one shell. Not a public header.
namespace seamwright::occ {

/// A shape with some of its matched seams sewn, and the new parts by the given ones.
struct SewnShape {
  TopoDS_Shape shape;  ///< null where seams were refused
  /// By seam that prevents sewing: the reason; the caller tries again without these seams.
  SewReasons refused;
  std::vector<int> faces;  ///< by number in the given shape, from 1: the number in this one
  std::vector<std::vector<int>> edges;    ///< the same for edges; several where an edge was cut
  std::map<std::size_t, int> seam_edges;  ///< by sewn seam: number of its edge in this shape
  /// New vertices, wires, shells, solids and compounds by the given ones that they replace. Shells
  /// and solids whose faces were sewn to another shell are not included.
  TopTools_DataMapOfShapeShape became;
};

/// Sews these seams. Two edges become one with a pcurve on both faces; where only a part of an edge
/// lies along the other one, the edge is cut first. An end nearer than \p gap_mm to a vertex
/// becomes that vertex. Vertices are merged in their middle. Connected faces become one shell,
/// oriented to agree with the first of them. It replaces the first part (shell, or solid of one
/// shell) that contained any of them. A closed shell becomes a solid, oriented outward. With
/// unusable parts (see UnusableParts) a shell stays a shell, and a solid is oriented by its first
/// face. Surfaces and the curves of other edges stay. Unaffected parts are shared with the given
/// shape. Tolerances are the distances as measured.
///
/// A pipeline of values: notSewable() refuses seams that can't be sewn in any case, sewnEdges()
/// makes edges and vertices, facesWithEdges() makes faces of them, sewnGroups() and orientFaces()
/// say which faces become one shell and how they are oriented, and sewnAssembly() makes shells and
/// solids. A stage that refuses seams ends it.
///
/// A seam is refused in these cases:
/// - A face of it occurs in the shape several times, is in a solid of several shells, or shares its
///   surface with the other face.
/// - Another interval interrupts its interval or has taken it.
/// - The tolerance of one of its vertices would exceed both twice \p gap_mm and twice its old
/// value.
/// - It would close a band that has only one side, such as a Moebius band.
///
/// \param seams of kind Matched.
/// \throws GeometryError where a pcurve can't be built; Standard_Failure.
SewnShape sewnShape(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm,
                    const FaceNames& names = numberedFace);

}  // namespace seamwright::occ
