// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Face.hxx>
#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/fill/sheet_fill.hpp>
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

/// Faces on the sheets of a SheetSequence, bounded by copies of the hole's edges.
class SheetFaces {
 public:
  explicit SheetFaces(const FillTask& task) : task_(task) {}

  /// The next one; nothing after the last, and if the hole has not four corners, all below 180
  /// degrees.
  /// \throws std::invalid_argument as SheetSequence, GeometryError, Cancelled, Standard_Failure.
  std::optional<SheetFace> next(const Progress& progress);

 private:
  void begin();

  const FillTask& task_;
  std::vector<HoleSide> sides_;
  std::array<SheetFillSide, 4> given_;
  std::optional<SheetSequence> sheets_;
  bool begun_ = false;
};

}  // namespace seamwright::occ
