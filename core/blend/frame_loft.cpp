// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>

#include <seamwright/core/blend/loft_builder.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/bspline_side.hpp>

namespace seamwright {

namespace {

const std::vector<double>& knotsAcross(const BSplineSurface& surface, SurfaceDirection direction) {
  return direction == SurfaceDirection::U ? surface.knots_u : surface.knots_v;
}

/// The part between two knots of multiplicity degree, or ends.
BSplineSurface surfacePart(const BSplineSurface& surface, SurfaceDirection direction, double from,
                           double to) {
  const bool in_u = direction == SurfaceDirection::U;
  const std::vector<double>& knots = knotsAcross(surface, direction);
  const int degree = in_u ? surface.degree_u : surface.degree_v;
  const auto last_from = std::upper_bound(knots.begin(), knots.end(), from);
  const auto first_to = std::lower_bound(knots.begin(), knots.end(), to);
  const auto first = static_cast<Eigen::Index>(last_from - knots.begin()) - degree - 1;
  const auto count = static_cast<Eigen::Index>(first_to - last_from) + degree + 1;
  std::vector<double> part(static_cast<std::size_t>(degree) + 1, from);
  part.insert(part.end(), last_from, first_to);
  part.insert(part.end(), static_cast<std::size_t>(degree) + 1, to);
  BSplineSurface result = surface;
  (in_u ? result.knots_u : result.knots_v) = part;
  const Eigen::Index columns = surface.countV();
  if (in_u) {
    result.poles = surface.poles.middleRows(first * columns, count * columns);
    return result;
  }
  const Eigen::Index rows = surface.countU();
  result.poles.resize(rows * count, 4);
  for (Eigen::Index i = 0; i < rows; ++i)
    result.poles.middleRows(i * count, count) =
        surface.poles.middleRows(i * columns + first, count);
  return result;
}

}  // namespace

FrameLoft frameLoft(const FrameFunction& frame, const Interval& omegas,
                    const FrameLoftOptions& options) {
  return loft::builtLoft(frame, omegas, {}, options);
}

BezierSpline isoCurve(const BSplineSurface& surface, double omega, bool closed) {
  const std::vector<double>& knots = surface.knots_v;
  const int n = surface.degree_v;
  if (!(omega >= knots.front() && omega <= knots.back()))
    refuse(fmt::format("omega is {}: the surface covers {} to {}", omega, knots.front(),
                       knots.back()));
  const int span = bspline::spanOf(n, knots, omega);
  const Eigen::RowVectorXd basis = bspline::basisDerivatives(n, knots, span, omega, 0).row(0);
  BSplineCurve curve{surface.degree_u, surface.knots_u, HomogeneousPoles(surface.countU(), 4)};
  for (Eigen::Index i = 0; i < curve.poles.rows(); ++i)
    curve.poles.row(i) = basis * surface.poles.middleRows(i * surface.countV() + span - n, n + 1);
  return bezierSpline(curve, closed);
}

std::vector<BSplineSurface> partsBetween(const BSplineSurface& surface, SurfaceDirection direction,
                                         const std::vector<double>& lines) {
  requireValid(surface);
  const std::vector<double>& knots = knotsAcross(surface, direction);
  const int degree = direction == SurfaceDirection::U ? surface.degree_u : surface.degree_v;
  std::vector<BSplineSurface> parts;
  double from = knots.front();
  for (const double line : lines) {
    if (!(line > from && line < knots.back()) || std::ranges::count(knots, line) != degree)
      refuse(
          fmt::format("{} is no inner knot of the multiplicity {} behind {}", line, degree, from));
    parts.push_back(surfacePart(surface, direction, from, line));
    from = line;
  }
  parts.push_back(surfacePart(surface, direction, from, knots.back()));
  return parts;
}

std::vector<KnotLine> encloseKnotLines(const BSplineSurface& surface, SurfaceDirection direction,
                                       const ContinuityTolerance& tolerance, bool closed,
                                       const EncloseOptions& options) {
  requireValid(surface);
  const bool in_u = direction == SurfaceDirection::U;
  const BSplineSurface divided =
      withRaisedKnots(surface, direction, in_u ? surface.degree_u : surface.degree_v);
  std::vector<double> lines = knotsAcross(surface, direction);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  const PatchEdge end = in_u ? PatchEdge::U1 : PatchEdge::V1,
                  beginning = in_u ? PatchEdge::U0 : PatchEdge::V0;
  std::vector<KnotLine> result;
  const auto part = [&](std::size_t i) {
    return surfacePart(divided, direction, lines[i], lines[i + 1]);
  };
  const auto enclose = [&](std::size_t before, std::size_t after, double knot) {
    result.push_back({knot, encloseSeam(seamSide(part(before), end),
                                        seamSide(part(after), beginning), tolerance, options)});
  };
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) enclose(i - 1, i, lines[i]);
  if (closed) enclose(lines.size() - 2, 0, lines.back());
  return result;
}

}  // namespace seamwright
