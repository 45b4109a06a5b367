// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Compound.hxx>
#include <vector>

/// Not a public header.
namespace seamwright::occ {

/// The parts, in their order, in one compound.
TopoDS_Compound compoundOf(const std::vector<TopoDS_Shape>& parts);

}  // namespace seamwright::occ
