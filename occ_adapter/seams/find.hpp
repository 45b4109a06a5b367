// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/seam.hpp>

namespace seamwright::occ {

/// \throws GeometryError with the fault of the side, if it has one.
void requireUsable(const Coedge& use);

/// An edge that bounds one face, or more than two.
struct NonSeamEdge {
  int edge = 0;
  std::vector<int> faces;
};

/// The seams of a shape, and the edges that are in none.
struct SeamGraph {
  std::vector<Seam> seams;                ///< by edge number; matched ones after the others
  std::vector<NonSeamEdge> open;          ///< one face
  std::vector<Coedge> open_uses;          ///< the coedge of each free edge, in the order of open
  std::vector<NonSeamEdge> non_manifold;  ///< more than two uses, by edge number
  std::vector<std::string> notes;         ///< what could not be examined, and why
};

/// Finds the seams of a shape by shared topology, in time linear in its size. For faces that share
/// no edges see matchFreeEdges(). Sides that can't be computed with have a fault. The shape is not
/// changed.
///
/// Not included are degenerated edges (the pole of a sphere is not a seam), edges that bound no
/// face, and edges inside a face that do not bound it (orientation INTERNAL or EXTERNAL). IsSame
/// distinguishes faces and edges: a face that two solids share counts once, and two instances of a
/// part count twice.
SeamGraph findSeams(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
