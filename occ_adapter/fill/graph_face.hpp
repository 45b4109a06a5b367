// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <optional>

#include <seamwright/occ_adapter/fill/filling.hpp>

/// A face on a spline graph that meets the surroundings of a hole. Not a public header.
namespace seamwright::occ {

/// One face for holes of any number of corners of any angle, with kinks and joints along the sides:
/// the spline of graphFill() over a plane, trimmed by the edges of the hole. Nothing if the hole is
/// not a graph over any plane: seen from no direction do all faces around it look upward, each by
/// more than 15 degrees from the line of sight, with an outline that does not cross itself.
/// \throws GeometryError, Standard_Failure, std::invalid_argument, Cancelled.
std::optional<TopoDS_Face> graphFace(const FillTask& task, const Progress& progress);

}  // namespace seamwright::occ
