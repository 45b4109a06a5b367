// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>

/// What the makers of a corner hand to cornerFillet(), which measures it. Not a public header.
namespace seamwright::occ {

/// A shell whose corner is rounded.
struct CornerShell {
  TopoDS_Shell shell;
  TopTools_DataMapOfShapeShape became;  ///< new faces by the faces that they replace
  std::vector<std::pair<TopoDS_Edge, CornerSeamKind>> seams;
};

struct RoundedCorner {
  CornerShell shell;
  std::vector<CornerFilletEdge> edges;
  CornerFiller filler = CornerFiller::Patches;
  NSidedFill fill;  ///< see CornerFillet::fill
  double section_error_mm = 0;
};

/// Returns a corner that was made with inside and outside exchanged to the order and orientation of
/// its solid.
RoundedCorner turnedBack(RoundedCorner made);

}  // namespace seamwright::occ
