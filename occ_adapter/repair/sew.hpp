// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/occ_adapter/topology/sewn_shape.hpp>

/// Sews matched seams to edges. Not a public header.
namespace seamwright::occ {

/// A shape with its seams and their figures.
struct SewTask {
  const TopoDS_Shape& shape;
  const std::vector<Seam>& seams;         ///< of shape
  const std::vector<SeamResult>& before;  ///< in the same order
  const RepairOptions& options;
};

struct SewSolution {
  SewnShape sewn = {};  ///< has no shape if nothing is sewn
  /// In the order of before, with the numbers of the sewn shape.
  std::vector<SeamResult> after = {};
  std::vector<NonSeamEdge> open = {}, non_manifold = {};  ///< of the sewn shape
  /// By seam that was to be sewn and is not: the reason.
  SewReasons reasons = {};
};

/// Sews the seams for which sewing can be proven. \throws Cancelled.
SewSolution sewFreeEdges(const SewTask& task, const Progress& progress);

/// Transfers the attributes of a shape to the sewn shape.
std::vector<ShapeAttribute> attributesAfter(const std::vector<ShapeAttribute>& attributes,
                                            const TopoDS_Shape& before, const SewnShape& sewn);

}  // namespace seamwright::occ
