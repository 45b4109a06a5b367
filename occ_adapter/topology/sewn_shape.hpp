// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_DataMapOfShapeShape.hxx>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/seams/find.hpp>

/// Loose faces made one shell; not a public header.
namespace seamwright::occ {

/// What faces are called in reasons, by their numbers.
using FaceNames = std::function<std::string(int)>;

/// "face 3".
std::string numberedFace(int number);

/// A shape with some of its matched seams sewn, and what became of the parts of the given one.
struct SewnShape {
  TopoDS_Shape shape;  ///< null where seams were refused
  std::map<std::size_t, std::string>
      refused;             ///< seams that stand in the way, and why: to be asked again without them
  std::vector<int> faces;  ///< by number of the given shape, from 1
  std::vector<std::vector<int>> edges;    ///< the same; several where one was cut
  std::map<std::size_t, int> seam_edges;  ///< by sewn seam
  /// Vertices, wires, shells, solids and compounds that were made again, one for one; not those
  /// that were sewn to faces of another shell.
  TopTools_DataMapOfShapeShape became;
};

/// Sews these seams: two edges become one with a path on both faces, or cut edges where only a part
/// of one lies along the other; ends nearer than \p gap_mm to a vertex are that vertex; vertices
/// are merged in their middle; faces that hang together become one shell, turned so that they agree
/// with the first, in place of the first part (shell, or solid of one shell) that they stood in; a
/// closed shell becomes a solid, turned outward (but see UnusableParts: with one of these a shell
/// stays a shell, and a solid is turned as its first face). Surfaces and the curves of other edges
/// stay; what is not concerned is shared with the given shape. Tolerances are what is measured.
///
/// Refused are seams whose faces stand in the shape several times, are in a solid of several shells
/// or have one surface in common; whose interval another one interrupts or has taken; whose
/// vertices would reach further than twice \p gap_mm, or as far as they did; and that would close a
/// band which has one side only.
/// \param seams of kind Matched. \throws Standard_Failure.
SewnShape sewnShape(const TopoDS_Shape& shape, const std::vector<Seam>& seams,
                    const std::vector<std::size_t>& chosen, double gap_mm,
                    const FaceNames& names = numberedFace);

}  // namespace seamwright::occ
