// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <optional>
#include <vector>

#include <seamwright/core/fill/fill_corners.hpp>
#include <seamwright/occ_adapter/fill/hole_cuts.hpp>

/// Stage 2 of a fill: faces for the sides. Not a public header.
namespace seamwright::occ {

struct FillFaces {
  std::vector<TopoDS_Face> faces;
  HoleCut cut;  ///< the sides that the faces meet; empty for a face that is given
  std::vector<FillCorner> corners;
  bool regular = false;
  bool is_fitted = false;   ///< one face of a graph or sheet
  bool is_trimmed = false;  ///< one face inside its surface, a graph or a given surface
  double reach = 0;         ///< see FillHoleReport::reach
  std::optional<double> curvature_jump_per_mm;
};

/// Builds patches for the first cut, or, for a ring, for the first acceptable cut with a regular
/// fill.
/// \throws NotFilled, std::invalid_argument and std::domain_error if the construction refuses the
/// sides, Standard_Failure.
FillFaces fillFaces(const HoleCuts& cuts, const FillHoleOptions& options,
                    const FillAttempt& attempt);

}  // namespace seamwright::occ
