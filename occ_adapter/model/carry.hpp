// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>

namespace seamwright::occ {

/// How many parts got other geometry.
struct Carried {
  int faces = 0;     ///< another surface
  int edges = 0;     ///< another curve, parameter curve, range, tolerance or flag
  int vertices = 0;  ///< another point or tolerance
  double largest_tolerance_mm =
      0;  ///< of the edges and vertices that have a larger one now; 0: of none
};

/// Carries the geometry of \p changed over into the faces, edges and vertices of \p into, in place.
///
/// \p changed is \p into after a journey to the asking process and back (written and read in
/// OpenCASCADE's binary format twice) on which geometry was changed. What that journey itself moves
/// (the last bits of axes) is no change: such parts stay as they are.
///
/// \returns nothing, with \p into untouched, where the two are not the same graph: another kind,
/// number, order, orientation, placement or sharing of parts.
/// \throws ModelError (UnlikeInstances, without a path) where \p into has one part in several
/// places and \p changed has unlike ones there.
std::optional<Carried> carryGeometry(const TopoDS_Shape& changed, const TopoDS_Shape& into);

}  // namespace seamwright::occ
