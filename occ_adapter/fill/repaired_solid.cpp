// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepCheck_Analyzer.hxx>
#include <ShapeFix_Shape.hxx>

#include <seamwright/occ_adapter/fill/repaired_solid.hpp>

namespace seamwright::occ {

RepairedSolid repairedSolid(const TopoDS_Shape& solid) {
  if (BRepCheck_Analyzer(solid).IsValid()) return {solid, {}};
  ShapeFix_Shape fix(solid);
  fix.Perform();
  if (fix.Shape().ShapeType() != TopAbs_SOLID || !BRepCheck_Analyzer(fix.Shape()).IsValid())
    return {solid, {}};
  return {fix.Shape(), fix.Context()};
}

}  // namespace seamwright::occ
