// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/occ_adapter/blend/side_ribbon.hpp>

namespace seamwright::occ {

namespace {

/// The part v in [-1, 0] of a surface without inner knots in v.
BSplineSurface before(BSplineSurface surface) {
  const int count = surface.countV();
  for (int i = 0; i < surface.countU(); ++i) {
    auto line = surface.poles.middleRows(static_cast<Eigen::Index>(i) * count, count);
    const casteljau::Coefficients<4> back = casteljau::split<4>(line, -1).first;
    line = back.colwise().reverse();
  }
  return surface;
}

}  // namespace

SideRibbon sideRibbon(const TopoDS_Shape& model, const BlendEnd& side, double depth_mm,
                      const BlendSurfaceOptions& options, const Progress& progress) {
  const BlendSurfaceReport beyond = extendSurface(model, side, depth_mm, options, progress);
  return {before(beyond.surface), beyond.ends[0], beyond.seams, beyond.reached};
}

}  // namespace seamwright::occ
