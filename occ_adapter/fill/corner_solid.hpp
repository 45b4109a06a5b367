// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/corner_hole.hpp>
#include <seamwright/occ_adapter/fill/rounded_corner.hpp>

/// Replaces the corner of a shell by fillets and patches. Not a public header.
namespace seamwright::occ {

/// \throws CornerRefused for fillets that reach beyond an edge at a far end or
/// into their own sections.
CornerShell cornerShell(const Corner& corner, const CornerHole& hole, const NSidedFill& fill);

/// The shape with \p shell replaced by \p other. Locations and orientations of the parts that
/// contain it are applied to the parts themselves.
TopoDS_Shape withShell(const TopoDS_Shape& shape, const TopoDS_Shell& shell,
                       const TopoDS_Shell& other);

}  // namespace seamwright::occ
