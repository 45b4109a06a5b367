// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

/// Numbers that STEP and IGES can't express. Not a public header.
namespace seamwright::occ {

/// The first face with a number that is not finite, or otherwise the first such edge, as one
/// clause: "face 3 has a surface with the number nan". Empty if all numbers are finite, however
/// large. Time is linear in the size of the shape.
std::string whyNotFinite(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
