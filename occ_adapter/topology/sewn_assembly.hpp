// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopTools_DataMapOfShapeShape.hxx>

#include <seamwright/occ_adapter/topology/sewn_faces.hpp>

/// Puts faces with sewn edges together to shells, solids and compounds. Not a public header.
namespace seamwright::occ {

struct SewnAssembly {
  TopoDS_Shape shape;
  TopTools_DataMapOfShapeShape became;  ///< see SewnShape; without vertices
};

/// \param faces by number in the shape of \p parts, oriented to agree.
SewnAssembly sewnAssembly(const ShapeParts& parts, const SewnEdges& edges, const FaceGroups& groups,
                          const std::vector<TopoDS_Face>& faces);

}  // namespace seamwright::occ
