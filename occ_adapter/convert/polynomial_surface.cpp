// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <GeomConvert_ApproxSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <seamwright/occ_adapter/convert/closed_spline.hpp>
#include <seamwright/occ_adapter/convert/polynomial_surface.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

namespace {

using opencascade::handle;
using Spline = handle<Geom_BSplineSurface>;
/// u from, to, v from, to.
using Range = std::array<double, 4>;

/// Points in each direction of a face at which two surfaces are compared: the faces that become
/// splines are analytic ones or have few spans, and the error varies with these.
constexpr int points_across = 33;

/// Within the surface's own range, and not longer than a period.
void keepWithin(double low, double high, bool periodic, double& from, double& to) {
  if (periodic) {
    to = std::min(to, from + (high - low));
  } else {
    from = std::max(from, low);
    to = std::min(to, high);
  }
}

Range rangeOf(const TopoDS_Face& face, const Geom_Surface& surface) {
  Range range{}, whole{};
  BRepTools::UVBounds(face, range[0], range[1], range[2], range[3]);
  surface.Bounds(whole[0], whole[1], whole[2], whole[3]);
  keepWithin(whole[0], whole[1], surface.IsUPeriodic(), range[0], range[1]);
  keepWithin(whole[2], whole[3], surface.IsVPeriodic(), range[2], range[3]);
  return range;
}

template <class Visit>
void visitGrid(const Range& range, const Visit& visit) {
  for (int i = 0; i < points_across; ++i)
    for (int j = 0; j < points_across; ++j)
      visit(range[0] + (range[1] - range[0]) * i / (points_across - 1),
            range[2] + (range[3] - range[2]) * j / (points_across - 1));
}

/// At points of the same parameters, and what of it may be rounding.
struct Distance {
  double largest_mm = 0, rounding_mm = 0;
};

Distance distanceOf(const Geom_Surface& a, const Geom_Surface& b, const Range& range) {
  Distance distance;
  double size = 0;
  visitGrid(range, [&](double u, double v) {
    const gp_Pnt p = a.Value(u, v);
    size = std::max(size, p.XYZ().Modulus());
    distance.largest_mm = std::max(distance.largest_mm, p.Distance(b.Value(u, v)));
  });
  // A conversion composes a segmentation, knot insertions and an evaluation: some hundred
  // operations on a coordinate, each off by up to half of epsilon.
  distance.rounding_mm = 1024 * std::numeric_limits<double>::epsilon() * size;
  return distance;
}

/// The surface itself where it is a polynomial in the same parameters; else null.
PolynomialSurface exact(const handle<Geom_Surface>& trimmed, const Range& range) {
  const Spline spline = GeomConvert::SurfaceToBSplineSurface(trimmed);
  if (spline.IsNull() || spline->IsURational() || spline->IsVRational() || spline->IsUPeriodic() ||
      spline->IsVPeriodic())
    return {};
  const Distance distance = distanceOf(*trimmed, *spline, range);
  if (!(distance.largest_mm <= distance.rounding_mm)) return {};
  return {spline, distance.largest_mm};
}

void moveKnots(Geom_BSplineSurface& spline, Direction direction, double by) {
  if (by == 0) return;
  TColStd_Array1OfReal knots(1, direction == Direction::U ? spline.NbUKnots() : spline.NbVKnots());
  direction == Direction::U ? spline.UKnots(knots) : spline.VKnots(knots);
  for (double& knot : knots) knot += by;
  direction == Direction::U ? spline.SetUKnots(knots) : spline.SetVKnots(knots);
}

/// In the parameters of the range: OpenCASCADE counts those of a trimmed periodic surface from its
/// first period on.
PolynomialSurface approximated(const handle<Geom_Surface>& trimmed, const Range& range,
                               double near_mm) {
  // These bound the time and the size of the surface. If they do not suffice, the error that is
  // returned is above the tolerance and the caller refuses the surface.
  constexpr int largest_degree = 8, most_spans = 200;
  const GeomConvert_ApproxSurface approximation(trimmed, near_mm, GeomAbs_C2, GeomAbs_C2,
                                                largest_degree, largest_degree, most_spans, 0);
  if (!approximation.HasResult())
    throw GeometryError("it can't be approximated by a polynomial spline");
  const Spline spline = approximation.Surface();
  Range of_spline{};
  spline->Bounds(of_spline[0], of_spline[1], of_spline[2], of_spline[3]);
  moveKnots(*spline, Direction::U, range[0] - of_spline[0]);
  moveKnots(*spline, Direction::V, range[2] - of_spline[2]);
  return {spline, approximation.MaxError()};
}

double largestDifference_mm(const Geom_BSplineSurface& a, const Geom_BSplineSurface& b) {
  double largest = 0;
  for (int i = 1; i <= a.NbUPoles(); ++i)
    for (int j = 1; j <= a.NbVPoles(); ++j)
      largest = std::max(largest, a.Pole(i, j).Distance(b.Pole(i, j)));
  return largest;
}

/// Where the surface goes round the spline ends at itself as smoothly as can be.
/// \returns by how much poles moved.
double close(const Geom_Surface& surface, const Range& range, double near_mm,
             Geom_BSplineSurface& spline) {
  const Spline given = Spline::DownCast(spline.Copy());
  const auto closeIn = [&](Direction direction, double length, double period) {
    if (std::abs(length - period) <= Precision::PConfusion() &&
        endsAtItself(spline, direction, near_mm))
      makePeriodic(spline, direction, near_mm);
  };
  if (surface.IsUPeriodic()) closeIn(Direction::U, range[1] - range[0], surface.UPeriod());
  if (surface.IsVPeriodic()) closeIn(Direction::V, range[3] - range[2], surface.VPeriod());
  makeClamped(spline);
  return largestDifference_mm(*given, spline);
}

/// Poles of a side of the spline that is one point of the surface become that point.
void collapse(const Geom_Surface& surface, const Range& range, Geom_BSplineSurface& spline) {
  for (const bool along_u : {true, false})
    for (const bool at_end : {false, true}) {
      std::vector<gp_Pnt> side;
      for (int k = 0; k < points_across; ++k) {
        const double share = static_cast<double>(k) / (points_across - 1);
        const double u = along_u ? range[0] + share * (range[1] - range[0]) : range[at_end ? 1 : 0];
        const double v = along_u ? range[at_end ? 3 : 2] : range[2] + share * (range[3] - range[2]);
        side.push_back(surface.Value(u, v));
      }
      const double rounding =
          1024 * std::numeric_limits<double>::epsilon() * (1 + side.front().XYZ().Modulus());
      if (std::ranges::any_of(side,
                              [&](const gp_Pnt& p) { return p.Distance(side.front()) > rounding; }))
        continue;
      const int count = along_u ? spline.NbUPoles() : spline.NbVPoles();
      for (int k = 1; k <= count; ++k)
        spline.SetPole(along_u ? k : (at_end ? spline.NbUPoles() : 1),
                       along_u ? (at_end ? spline.NbVPoles() : 1) : k, side.front());
    }
}

}  // namespace

PolynomialSurface polynomialSurface(const TopoDS_Face& face, double near_mm) {
  TopLoc_Location location;
  const handle<Geom_Surface> surface = BRep_Tool::Surface(face, location);
  if (surface.IsNull()) throw GeometryError("it has no surface");
  const Range range = rangeOf(face, *surface);
  const handle<Geom_Surface> trimmed =
      new Geom_RectangularTrimmedSurface(surface, range[0], range[1], range[2], range[3]);
  PolynomialSurface polynomial = exact(trimmed, range);
  if (polynomial.surface.IsNull()) {
    // Half of the tolerance is for the approximation. Closing may use an eighth of that for each
    // knot that it removes, and the rest is for what OpenCASCADE's error misses.
    polynomial = approximated(trimmed, range, near_mm / 2);
    polynomial.error_mm += close(*surface, range, near_mm / 16, *polynomial.surface);
    collapse(*surface, range, *polynomial.surface);
    polynomial.error_mm =
        std::max(polynomial.error_mm, distanceOf(*trimmed, *polynomial.surface, range).largest_mm);
  }
  polynomial.surface->Transform(location.Transformation());
  polynomial.error_mm *= std::abs(location.Transformation().ScaleFactor());
  if (polynomial.error_mm <= near_mm) return polynomial;
  throw GeometryError(
      fmt::format("a polynomial spline keeps only as near as {:.6g} mm, not {:.6g} mm",
                  polynomial.error_mm, near_mm));
}

}  // namespace seamwright::occ
