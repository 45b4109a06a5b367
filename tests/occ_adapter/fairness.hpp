// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

#include <seamwright/occ_adapter/repair/repair.hpp>

/// Fairness of faces by OpenCASCADE's curvature, on grids that know nothing of the judge's own.
namespace seamwright::test {

/// The mean over iso-lines of the total variation of the mean curvature, with a test for inside of
/// its own.
/// \param face its boundaries, in the parameters of the surface.
double variationByOpenCascade(const TopoDS_Face& face,
                              const opencascade::handle<Geom_Surface>& surface);

/// A changed face, and how much its mean curvature varies.
struct FaceFairness {
  int face = 0;  ///< from 1
  double before_per_mm = 0, after_per_mm = 0;
  /// 1.5 times before, and 3 angle / size more: once for the angle that is tolerated, over the
  /// face's diagonal, and for the largest angle of a treated seam, over the face's mean width
  /// beside it.
  double limit_per_mm = 0;

  bool isWorse() const { return after_per_mm > limit_per_mm; }
};

/// Of all faces whose surface is another one. \pre nothing was sewn
std::vector<FaceFairness> fairnessOfChanges(const TopoDS_Shape& before,
                                            const occ::RepairReport& report,
                                            const ContinuityTolerance& tolerance);

}  // namespace seamwright::test
