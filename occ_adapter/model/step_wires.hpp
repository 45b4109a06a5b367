// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <STEPControl_Writer.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace seamwright::occ {

/// OpenCASCADE writes a wire outside of faces as a set of curves, from which readers make single
/// edges. After the transfer of \p shapes this makes each such set the one composite curve that it
/// is, of which readers make a wire, with its edges in their order. A set is left as it is if its
/// curves do not follow each other, or one of them has a style, which readers would lose.
void keepWires(STEPControl_Writer& writer, const std::vector<TopoDS_Shape>& shapes);

}  // namespace seamwright::occ
