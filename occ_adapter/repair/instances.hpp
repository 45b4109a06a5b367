// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/repair/convert_faces.hpp>

/// Parts of an assembly that stand in several places; not a public header.
namespace seamwright::occ {

/// Repairs each such part in its first place and has it so in all others: what the options say of
/// one of its instances holds for all. A part is what compounds hold: a solid, a shell, a loose
/// face, or a whole compound whose parts have edges in common. Parts that have something in common
/// with others stay, and so do all while open edges are matched, as instances may meet one another
/// there.
/// \param repair keeps what stands in several places. \throws what \p repair throws.
RepairReport repairInstances(const Model& model, const RepairOptions& options,
                             const PlainRepair& repair, const Progress& progress);

}  // namespace seamwright::occ
