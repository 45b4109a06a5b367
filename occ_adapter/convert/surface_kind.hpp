// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <string>

/// The kind of a face's surface, for messages; not a public header.
namespace seamwright::occ {

/// The kind with its article: "a plane", "a cylinder", ...; "a surface of another kind" for kinds
/// without a name here, B-spline and Bezier surfaces included.
std::string kindOf(const TopoDS_Face& face);

}  // namespace seamwright::occ
