// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_DataMapOfShapeShape.hxx>
#include <map>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_hole.hpp>

/// A shell whose corner is cut out and closed again; not a public header.
namespace seamwright::occ {

struct CornerShell {
  TopoDS_Shell shell;  ///< old faces in their order, then the cylinders, then the patches
  TopTools_DataMapOfShapeShape became;  ///< faces that were made again
  std::vector<std::pair<TopoDS_Edge, CornerSeamKind>> seams;
};

/// \throws std::domain_error, with numbers, for fillets that reach beyond an edge at a far end or
/// into their own sections.
CornerShell cornerShell(const Corner& corner, const CornerHole& hole, const NSidedFill& fill);

/// The shape with another shell in place of one of its own. Locations and orientations of what
/// holds it are applied to its parts.
TopoDS_Shape withShell(const TopoDS_Shape& shape, const TopoDS_Shell& shell,
                       const TopoDS_Shell& other);

}  // namespace seamwright::occ
