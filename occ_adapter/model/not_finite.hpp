// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

/// Numbers that STEP and IGES have no words for; not a public header.
namespace seamwright::occ {

/// The first face, else edge, with a number that is not finite, as one clause: "face 3 has a
/// surface with the number nan". Empty if all numbers of UnusableParts are finite, however large.
/// Time is linear in the size of the shape.
std::string whyNotFinite(const TopoDS_Shape& shape);

}  // namespace seamwright::occ
