// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <stdexcept>

#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/occ_adapter/blend/blend_sheet.hpp>
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
  if (!(depth_mm > 0) || !std::isfinite(depth_mm))
    throw std::invalid_argument(
        fmt::format("depth_mm is {}: it must be positive and finite", depth_mm));
  if (side.order == 0) throw std::invalid_argument("order is 0: a ribbon is G1, G2 or G3");
  const BlendSurfaceReport beyond = extendSurface(model, side, depth_mm, options, progress);
  SideRibbon ribbon{before(beyond.surface), beyond.ends[0], beyond.seams, beyond.ends[0].reached};
  if (const std::optional<SheetFold> fold = foldOf(ribbon.surface)) {
    ribbon.reached = false;
    if (ribbon.side.reason.empty())
      ribbon.side.reason =
          fmt::format("the ribbon turns over at ({:.6g}): a smaller depth may help",
                      fmt::join(fold->point_mm, ", "));
  }
  return ribbon;
}

}  // namespace seamwright::occ
