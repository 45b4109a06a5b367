// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/repair/solve.hpp>

/// All faces of a repair moved together; not a public header.
namespace seamwright::occ {

/// The displacement of the faces beside treated seams with the least bending energy that brings these seams within the tolerance and keeps
/// what the other edges of the faces show. Sampled; prove() decides.
/// \throws Cancelled; Standard_Failure.
RepairSolution displaceFaces(const RepairTask& task, const Progress& progress);

}  // namespace seamwright::occ
