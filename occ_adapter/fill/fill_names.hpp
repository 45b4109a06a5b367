// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/fill.hpp>
#include <seamwright/occ_adapter/repair/sewn_shape.hpp>

/// Fills of models that are parts or stages of what the user gave; not a public header.
namespace seamwright::occ {

/// As fillHole(); \param names of the model's faces.
FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options,
                        const FaceNames& names, const Progress& progress);

}  // namespace seamwright::occ
