// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/corner.hpp>
#include <seamwright/occ_adapter/fill/rounded_corner.hpp>
#include <seamwright/occ_adapter/progress.hpp>

/// Rounds a corner whose faces may be curved. Not a public header.
namespace seamwright::occ {

/// Rounds the edges outside a ball about the vertex (roundedOutside()). Then it cuts the bands off
/// in sections at their setbacks, cuts the faces along spring curves, and fills the hole
/// (fillHole()).
/// \throws as cornerFillet() for corners that are not supported.
RoundedCorner bandedCorner(const Corner& corner, const CornerFilletOptions& options,
                           const Progress& progress);

}  // namespace seamwright::occ
