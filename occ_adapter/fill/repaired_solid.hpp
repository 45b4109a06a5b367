// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ShapeBuild_ReShape.hxx>
#include <TopoDS_Shape.hxx>

/// Repairs what OpenCASCADE's fillets leave. Not a public header.
namespace seamwright::occ {

/// A solid, repaired or as it was, and what its faces became.
struct RepairedSolid {
  TopoDS_Shape solid;
  opencascade::handle<ShapeBuild_ReShape> repairs;  ///< null if nothing was changed

  TopoDS_Shape imageOf(const TopoDS_Shape& face) const {
    return repairs.IsNull() ? face : repairs->Apply(face);
  }
};

/// OpenCASCADE's fillets may leave faces that fail its own checks, often beside pcurves that do not
/// follow their edges. ShapeFix gives these new pcurves. A solid that stays invalid is returned as
/// it was.
RepairedSolid repairedSolid(const TopoDS_Shape& solid);

}  // namespace seamwright::occ
