// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
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

/// A lateral boundary as it was chosen, from the start to the end.
struct ChosenLateral {
  int order = 0;
  std::array<int, 2> corners{};  ///< the ends, 0 or 1, of the paths of start and end
  std::vector<int> edges = {};
  std::shared_ptr<const LateralCurve> curve = nullptr;
  HoleSide uses = {};  ///< with the faces beside; empty: these do not matter
  std::shared_ptr<const SidePath> beside = nullptr;
  bool against = false;  ///< that path runs from the end to the start

  /// The unit normal of the face beside at a share of the curve, and its curvature tensor.
  Eigen::Vector3d normalAt(double share) const { return besideAt(share).normal; }
  Eigen::Matrix3d curvatureAt(double share) const;

 private:
  SideSample besideAt(double share) const;
};

/// The sides and the lateral boundaries of a blend.
struct ChosenBlend {
  std::vector<ChosenEnd> ends;
  std::vector<ChosenLateral> laterals = {};
};

/// Measures and judges the seams of report.face: its boundary v = 0 with the first end, v = 1 with
/// the second one, if there are two, and its lateral boundaries. Sets seams, ends, laterals, fold
/// and reached of the report.
void measureBlend(const TopoDS_Shape& model, const ChosenBlend& chosen, const BlendTask& task,
                  BlendSurfaceReport& report);

}  // namespace seamwright::occ
