// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>

namespace seamwright::occ {

/// How many parts got new geometry.
struct Carried {
  int faces = 0;     ///< another surface
  int edges = 0;     ///< another curve, pcurve, range, tolerance or flag
  int vertices = 0;  ///< another point or tolerance
  double largest_tolerance_mm =
      0;  ///< of the edges and vertices whose tolerance grew; 0: none grew
};

/// Copies the geometry of \p changed into the faces, edges and vertices of \p into, in place.
///
/// \p changed is \p into after a round trip to the asking process (written and read twice in
/// OpenCASCADE's binary format), during which geometry was changed. Changes that the round trip
/// itself makes, in the last bits of axes, do not count: such parts stay as they are.
///
/// \returns nothing, with \p into untouched, if the two are not the same graph: if kind, number,
/// order, orientation, location or sharing of parts differ.
/// \throws ModelError (UnlikeInstances, without a path) if \p into has several instances of a part
/// whose counterparts in \p changed differ.
std::optional<Carried> carryGeometry(const TopoDS_Shape& changed, const TopoDS_Shape& into);

}  // namespace seamwright::occ
