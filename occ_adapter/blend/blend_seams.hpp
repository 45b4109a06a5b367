// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <memory>
#include <vector>

#include <seamwright/occ_adapter/blend/blend_sheet.hpp>
#include <seamwright/occ_adapter/blend/blend_surface.hpp>

/// The seams of a new face with the sides that it was made on. Not a public header.
namespace seamwright::occ {

/// A side of the model as it was chosen.
struct ChosenEnd {
  BlendEnd end;
  HoleSide edges;
  std::shared_ptr<const SidePath> path;
  std::shared_ptr<const SideDirections> directions;
  bool closed = false;
};

/// Measures and judges the seams of report.face: its boundary v = 0 with the first end, v = 1 with
/// the second one, if there are two. Sets seams, ends, fold and reached of the report.
void measureBlend(const TopoDS_Shape& model, const std::vector<ChosenEnd>& ends,
                  const BlendTask& task, BlendSurfaceReport& report);

}  // namespace seamwright::occ
