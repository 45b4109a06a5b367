// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/seam.hpp>
#include <seamwright/occ_adapter/topology/sew_reasons.hpp>
#include <seamwright/occ_adapter/topology/shape_parts.hpp>

/// Finds seams that can't be sewn, whatever their geometry. Not a public header.
namespace seamwright::occ {

/// The name of a face in reasons, by its number.
using FaceNames = std::function<std::string(int)>;

/// "face 3".
std::string numberedFace(int number);

/// The seams with a face that occurs in the shape several times or is in a solid of several shells,
/// and those whose two faces share their surface.
SewReasons notSewable(const ShapeParts& parts, const std::vector<Seam>& seams,
                      const std::vector<std::size_t>& chosen, const FaceNames& names);

}  // namespace seamwright::occ
