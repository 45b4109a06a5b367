// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/corner.hpp>
#include <seamwright/occ_adapter/fill/rounded_corner.hpp>

/// Measures rounded corners. Not a public header.
namespace seamwright::occ {

/// The model with the corner, its new seams measured, and what it falls short of.
CornerFillet judgedCorner(const Model& model, const Corner& corner, RoundedCorner made,
                          const CornerFilletOptions& options, const Progress& progress);

}  // namespace seamwright::occ
