// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <vector>

#include <seamwright/occ_adapter/match/match_reason.hpp>

/// Faces without poles become splines so that they can move. Not a public header.
namespace seamwright::occ {

/// Whether the face lies on a B-spline or Bezier surface.
bool hasPoles(const TopoDS_Face& face);

struct ConvertedModel {
  TopoDS_Shape shape;                ///< with the same numbers of faces and edges
  std::vector<MatchReason> remarks;  ///< one for each face
};

/// The model with those of the faces that have no poles as polynomial splines, within a thousandth
/// of the gap.
/// \throws std::invalid_argument as withChanges(); GeometryError, Standard_Failure.
ConvertedModel withSplines(const TopoDS_Shape& model, const std::vector<int>& faces, double gap_mm);

}  // namespace seamwright::occ
