// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/repair/convert_faces.hpp>

/// Repairs parts of an assembly that have several instances. Not a public header.
namespace seamwright::occ {

/// Repairs the first instance of each such part and changes all other instances alike. What the
/// options say of one instance holds for all. A part is what compounds hold: a solid, a shell, a
/// single face, or a whole compound whose parts share edges. Parts that share something with other
/// parts stay. While free edges are matched all instances stay, because instances may meet each
/// other there.
/// \param repair keeps parts with several instances unchanged.
/// \throws what \p repair throws.
RepairReport repairInstances(const Model& model, const RepairOptions& options,
                             const PlainRepair& repair, const Progress& progress);

}  // namespace seamwright::occ
