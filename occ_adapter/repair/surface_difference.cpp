// SPDX-License-Identifier: LGPL-2.1-or-later
#include <GeomAdaptor_Surface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <vector>

#include <seamwright/occ_adapter/repair/surface_difference.hpp>

namespace seamwright::occ {

namespace {

/// By knot span: parameters from its first end on. The last span also has its last end.
std::vector<std::vector<double>> gridOf(const TColStd_Array1OfReal& knots, double first,
                                        double last) {
  // A choice: differences change slowly within a span.
  constexpr int per_span = 4;
  std::vector<double> ends = {first};
  for (const double knot : knots)
    if (knot > first && knot < last) ends.push_back(knot);
  ends.push_back(last);
  std::vector<std::vector<double>> parameters(ends.size() - 1);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (int k = 0; k < per_span; ++k)
      parameters[i].push_back(ends[i] + (ends[i + 1] - ends[i]) * k / per_span);
  parameters.back().push_back(last);
  return parameters;
}

struct PointNormal {
  gp_Pnt point;
  gp_Vec normal;  ///< X_u x X_v
};

PointNormal at(const GeomAdaptor_Surface& surface, double u, double v) {
  gp_Pnt p;
  gp_Vec along_u, along_v;
  surface.D1(u, v, p, along_u, along_v);
  return {p, along_u.Crossed(along_v)};
}

}  // namespace

SurfaceDifference differenceOf(const opencascade::handle<Geom_Surface>& before,
                               const opencascade::handle<Geom_BSplineSurface>& after,
                               const std::array<double, 4>& range) {
  // Where X_u x X_v is shorter than this share of the longest one, the surface is nearly
  // degenerate.
  constexpr double collapsed = 1e-4;
  SurfaceDifference difference;
  struct Turned {
    double length;
    gp_Pnt at;
  };
  std::vector<Turned> turned;
  double longest = 0;
  const std::vector<std::vector<double>> all_v = gridOf(after->VKnots(), range[2], range[3]);
  // Span by span, because adaptors cache the polynomials of the last span.
  const GeomAdaptor_Surface was(before), is(after);
  for (const std::vector<double>& some_u : gridOf(after->UKnots(), range[0], range[1]))
    for (const std::vector<double>& some_v : all_v)
      for (const double u : some_u)
        for (const double v : some_v) {
          const PointNormal old = at(was, u, v), now = at(is, u, v);
          const double length = old.normal.Magnitude();
          longest = std::max(longest, length);
          difference.largest_mm = std::max(difference.largest_mm, old.point.Distance(now.point));
          if (old.normal.Dot(now.normal) < 0)
            turned.push_back({std::max(length, now.normal.Magnitude()), now.point});
        }
  const auto real = std::ranges::find_if(
      turned, [&](const Turned& sample) { return sample.length > collapsed * longest; });
  if (real != turned.end()) difference.folded_at = real->at;
  return difference;
}

}  // namespace seamwright::occ
