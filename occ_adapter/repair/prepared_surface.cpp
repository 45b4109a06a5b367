// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Precision.hxx>

#include <seamwright/occ_adapter/convert/closed_spline.hpp>
#include <seamwright/occ_adapter/repair/prepared_surface.hpp>
#include <seamwright/occ_adapter/repair/surface_basis.hpp>

namespace seamwright::occ {

namespace {

using Surface = opencascade::handle<Geom_BSplineSurface>;

bool isPeriodic(const Geom_BSplineSurface& surface) {
  return surface.IsUPeriodic() || surface.IsVPeriodic();
}

bool isClamped(const Geom_BSplineSurface& surface) {
  const int u = surface.UDegree() + 1, v = surface.VDegree() + 1;
  return surface.UMultiplicity(1) == u && surface.UMultiplicity(surface.NbUKnots()) == u &&
         surface.VMultiplicity(1) == v && surface.VMultiplicity(surface.NbVKnots()) == v;
}

/// Makes the surface periodic where it closes on itself, as smooth there as before. A surface that
/// is not periodic is clamped, so that its outermost poles are those of its boundaries.
Surface closed(const Surface& given) {
  // Closing by so little is rounding: it moves nothing that any tolerance sees.
  const double exactly_mm = Precision::Confusion() / 1000;
  const Surface surface = Surface::DownCast(given->Copy());
  if (isPeriodic(*given)) return surface;
  for (const Direction direction : {Direction::U, Direction::V})
    if (endsAtItself(*surface, direction, exactly_mm))
      makePeriodic(*surface, direction, exactly_mm);
  if (!isPeriodic(*surface) && !isClamped(*surface)) makeClamped(*surface);
  return surface;
}

/// Replaces the poles of a degenerate side by their mean. Otherwise their scatter would determine
/// the tangent plane at the point.
/// \returns the largest move of a pole.
double collapse(const Surface& surface, double near_mm) {
  const SurfaceBasis basis(*surface);
  const PointRows given = polesOf(*surface);
  PointRows poles = given;
  for (const std::vector<int>& side : collapsedSides(basis, given, near_mm)) {
    const Eigen::RowVector3d mean = given(side, Eigen::indexing::all).colwise().mean();
    for (const int pole : side) poles.row(pole) = mean;
  }
  setPoles(*surface, poles);
  return (poles - given).rowwise().norm().maxCoeff();
}

}  // namespace

PreparedSurface prepared(const Surface& given, double near_mm) {
  const Surface surface = closed(given);
  const double collapse_mm = collapse(surface, near_mm);
  return {surface, collapse_mm};
}

}  // namespace seamwright::occ
