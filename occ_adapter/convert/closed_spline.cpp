// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Precision.hxx>
#include <algorithm>
#include <array>

#include <seamwright/occ_adapter/convert/closed_spline.hpp>

namespace seamwright::occ {

bool endsAtItself(const Geom_BSplineSurface& surface, Direction direction, double near_mm) {
  const bool in_u = direction == Direction::U;
  if (in_u ? surface.IsUPeriodic() : surface.IsVPeriodic()) return false;
  const int across = in_u ? surface.NbVPoles() : surface.NbUPoles();
  const auto pole = [&](bool at_end, int k) {
    return in_u ? surface.Pole(at_end ? surface.NbUPoles() : 1, k)
                : surface.Pole(k, at_end ? surface.NbVPoles() : 1);
  };
  // A side of one point meets any other such side: an extent is needed.
  double extent = 0;
  for (int k = 1; k <= across; ++k) {
    if (!(pole(false, k).Distance(pole(true, k)) <= near_mm)) return false;
    extent = std::max(extent, pole(false, k).Distance(pole(false, 1)));
  }
  return extent > std::max(near_mm, Precision::Confusion());
}

void makePeriodic(Geom_BSplineSurface& surface, Direction direction, double near_mm) {
  const bool in_u = direction == Direction::U;
  if (in_u)
    surface.SetUPeriodic();
  else
    surface.SetVPeriodic();
  const auto isRepeatedLess = [&] {
    const int times = in_u ? surface.UMultiplicity(1) : surface.VMultiplicity(1);
    return times > 1 && (in_u ? surface.RemoveUKnot(1, times - 1, near_mm)
                              : surface.RemoveVKnot(1, times - 1, near_mm));
  };
  // Each knot that is removed makes the surface smoother there by one order, within the tolerance.
  while (isRepeatedLess()) {
  }
}

/// Without a period the ends may be unclamped: Segment() clamps them at the given range.
void makeClamped(Geom_BSplineSurface& surface) {
  std::array<double, 4> range{};
  surface.Bounds(range[0], range[1], range[2], range[3]);
  if (surface.IsUPeriodic()) surface.SetUNotPeriodic();
  if (surface.IsVPeriodic()) surface.SetVNotPeriodic();
  surface.Segment(range[0], range[1], range[2], range[3]);
}

}  // namespace seamwright::occ
