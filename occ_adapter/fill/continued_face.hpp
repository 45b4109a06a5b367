// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <optional>

#include <seamwright/occ_adapter/fill/holes.hpp>

/// Fills a hole by continuing a surface beside it. Not a public header.
namespace seamwright::occ {

/// A face with copies of the hole's edges on one surface that continues through the hole. The
/// surface comes within gap_mm of all edges of the hole, and its normals come within angle_rad of
/// those of the faces there. It is the plane of the hole, or the surface of a face beside the hole
/// if that is a plane, cylinder, cone, sphere or torus, or if all edges of the hole have a pcurve
/// on it.
///
/// The result is nothing if there is no such surface; if the loop does not bound the hole on the
/// surface, as around a tube or outside of a sheet; or if the surface is not proved regular or is
/// not C^1.
/// \param angle_rad nothing: normals are not compared.
/// \throws GeometryError for an edge that can't be evaluated; Standard_Failure.
std::optional<TopoDS_Face> continuedFace(const Hole& hole, double gap_mm,
                                         std::optional<double> angle_rad);

}  // namespace seamwright::occ
