// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <optional>

#include <seamwright/core/progress.hpp>
#include <seamwright/occ_adapter/fill/filling.hpp>

/// Fills a hole of four corners with a spline whose edges are the sides of the hole. Not a public
/// header.
namespace seamwright::occ {

struct SheetFace {
  TopoDS_Face face;
  bool regular = false;
  double reach = 0;  ///< see FillHoleReport::reach
};

/// A face on a sheetFill(), bounded by copies of the hole's edges; nothing if the hole has not four
/// corners, all below 180 degrees.
/// \param share_of_tolerance how near the spline is to come to the sides
/// \throws std::invalid_argument as sheetFill(), GeometryError, Cancelled, Standard_Failure.
std::optional<SheetFace> sheetFace(const FillTask& task, double share_of_tolerance,
                                   const Progress& progress);

}  // namespace seamwright::occ
