// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <optional>

#include <seamwright/occ_adapter/fill/holes.hpp>

/// A hole in a surface that goes on below it; not a public header.
namespace seamwright::occ {

/// A face with copies of the hole's edges, on one surface that comes within gap_mm of all of them
/// and whose normals come within angle_rad of those of the faces there: the plane of the hole, or
/// the surface of a face beside it, where it is a plane, cylinder, cone, sphere or torus, or where
/// all edges of the hole have a path on it. Nothing where there is none; where the hole is not what
/// the loop bounds there, as around a tube or outside of a sheet; and where the surface is not
/// proved regular, or not C^1.
/// \param angle_rad nothing: normals don't matter. \throws std::runtime_error for an edge that
/// can't be evaluated; Standard_Failure.
std::optional<TopoDS_Face> continuedFace(const Hole& hole, double gap_mm,
                                         std::optional<double> angle_rad);

}  // namespace seamwright::occ
