// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <limits>
#include <vector>

#include <seamwright/core/seam/piece.hpp>
#include <seamwright/core/seam/side_length.hpp>

namespace seamwright {

double SideLength::whole_mm() const {
  if (whole_mm_) return *whole_mm_;
  // A choice: the length is the unit of shares that are powers of 2, so some percent do not matter.
  constexpr int chords = 16;
  std::optional<Eigen::Vector3d> before;
  whole_mm_ = 0;
  for (int i = 0; i <= chords; ++i) {
    const double s = static_cast<double>(i) / chords;
    const SideFields side = side_.fields(s, s, Detail::Position);
    if (side.alternatives.empty()) continue;
    const VectorModel& p = side.alternatives.front().point;
    const Eigen::Vector3d here(p[0].coefficient(0), p[1].coefficient(0), p[2].coefficient(0));
    if (before) *whole_mm_ += (here - *before).norm();
    before = here;
  }
  return *whole_mm_;
}

bool SideLength::isShort(double from, double to, double share) const {
  return to - from <= share && !(of(from, to).upper > share * whole_mm());
}

Interval SideLength::of(double from, double to, int halvings) const {
  const SideFields side = side_.fields(from, to, Detail::Position);
  if (side.split) {
    if (halvings == 0) return {0, infinite};
    const Interval first = of(from, *side.split, halvings - 1);
    const Interval second = of(*side.split, to, halvings - 1);
    return {first.lower + second.lower, first.upper + second.upper};
  }
  std::vector<ControlPolygon<3>> polygons;
  for (const SurfaceFields& fields : side.alternatives)
    polygons.push_back(controlPolygon(fields.point));
  Interval length = {infinite, 0};
  for (const ControlPolygon<3>& polygon : polygons) {
    double sum = 2 * polygon.radius;
    for (int i = 1; i <= polygon.degree; ++i)
      sum += (polygon.points[i] - polygon.points[i - 1]).norm();
    length.upper = std::max(length.upper, sum);
    // The piece may begin on one side of a knot line and end on the other one.
    for (const ControlPolygon<3>& end : polygons) {
      const double chord = (end.points[end.degree] - polygon.points[0]).norm();
      length.lower = std::min(length.lower, std::max(0.0, chord - (polygon.radius + end.radius)));
    }
  }
  return length;
}

}  // namespace seamwright
