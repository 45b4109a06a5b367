// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/corner_solid.hpp>
#include <seamwright/occ_adapter/progress.hpp>

/// A corner whose faces may be curved; not a public header.
namespace seamwright::occ {

struct BandedCorner {
  CornerShell shell;
  std::vector<CornerFilletEdge> edges;
  NSidedFill fill;  ///< patches (where they are no splines), corners, regular
  double section_error_mm = 0;
};

/// Rounds the edges outside a ball about the vertex (roundedOutside()), cuts the bands off in
/// sections at their setbacks and the faces along spring curves, and fills the hole (fillHole()).
/// \throws as cornerFillet() for corners that it does not support.
BandedCorner bandedCorner(const Corner& corner, const CornerFilletOptions& options,
                          const Progress& progress);

}  // namespace seamwright::occ
