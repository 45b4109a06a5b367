// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <cmath>

#include <seamwright/core/blend/loft_builder.hpp>
#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// The surface with the edge at u = front, and v along it in the sense of the ribbon.
struct RowsBehind {
  int degree_across = 1, degree_along = 1;
  std::vector<double> across, along;  ///< flat knots, increasing from the edge
  std::vector<Poles> rows;            ///< the first three rows at most, from the edge
};

std::vector<double> mirroredKnots(const std::vector<double>& knots) {
  std::vector<double> result;
  for (auto knot = knots.rbegin(); knot != knots.rend(); ++knot)
    result.push_back(knots.front() + (knots.back() - *knot));
  return result;
}

RowsBehind rowsBehind(const BSplineSurface& surface, PatchEdge edge, bool reversed) {
  const bool across_u = edge == PatchEdge::U0 || edge == PatchEdge::U1;
  const bool at_end = edge == PatchEdge::U1 || edge == PatchEdge::V1;
  RowsBehind result;
  result.degree_across = across_u ? surface.degree_u : surface.degree_v;
  result.degree_along = across_u ? surface.degree_v : surface.degree_u;
  result.across = across_u ? surface.knots_u : surface.knots_v;
  result.along = across_u ? surface.knots_v : surface.knots_u;
  if (at_end) result.across = mirroredKnots(result.across);
  if (reversed) result.along = mirroredKnots(result.along);
  const Eigen::Index nu = surface.countU(), nv = surface.countV();
  const Eigen::Index across = across_u ? nu : nv, along = across_u ? nv : nu;
  for (Eigen::Index r = 0; r < std::min<Eigen::Index>(3, across); ++r) {
    Poles row(along, 3);
    for (Eigen::Index k = 0; k < along; ++k) {
      const Eigen::Index i = at_end ? across - 1 - r : r, j = reversed ? along - 1 - k : k;
      row.row(k) = surface.poles.row(across_u ? i * nv + j : j * nv + i).head<3>();
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

BezierSpline ribbonCurve(const RowsBehind& behind, const Poles& poles, bool closed) {
  BSplineCurve curve{behind.degree_along, behind.along, HomogeneousPoles(poles.rows(), 4)};
  curve.poles.leftCols<3>() = poles;
  curve.poles.col(3).setOnes();
  return bezierSpline(curve, closed);
}

/// The mean size of rows.
double meanRowSize(const Poles& rows) {
  return rows.rowwise().norm().mean();
}

Poles ribbonPoles(const BezierSpline& spline) {
  return spline.poles.leftCols<3>().array().colwise() / spline.poles.col(3).array();
}

}  // namespace

FrameRibbon edgeRibbon(const BSplineSurface& surface, PatchEdge edge, bool reversed, SheetSide side,
                       double rate, bool closed) {
  requireValid(surface);
  if (surface.poles.col(3) != Eigen::VectorXd::Ones(surface.poles.rows()))
    refuse("the surface is rational: all weights have to be 1");
  if (!(rate > 0) || !std::isfinite(rate))
    refuse(fmt::format("rate is {}: it must be positive and finite", rate));
  const RowsBehind behind = rowsBehind(surface, edge, reversed);
  const int p = behind.degree_across;
  const std::vector<double>& t = behind.across;
  // Derivatives into the surface at a clamped end, [PieglTiller1997] section 3.3.
  const Poles first = p / (t[p + 1] - t[1]) * (behind.rows[1] - behind.rows[0]);
  Poles second = Poles::Zero(first.rows(), 3);
  if (p > 1) {
    const Poles next = p / (t[p + 2] - t[2]) * (behind.rows[2] - behind.rows[1]);
    second = (p - 1) / (t[p + 1] - t[2]) * (next - first);
  }
  const double sense = side == SheetSide::Start ? -rate : rate;
  return {ribbonCurve(behind, behind.rows[0], closed), ribbonCurve(behind, sense * first, closed),
          ribbonCurve(behind, rate * rate * second, closed)};
}

double evenRate(const FrameFunction& frame, const Interval& omegas, const FrameRibbon& ribbon,
                SheetSide side, double share) {
  if (!(share > 0 && share <= 1)) refuse(fmt::format("share is {}: above 0, at most 1", share));
  const double step = share * omegas.width();
  const double from = side == SheetSide::Start ? omegas.lower : omegas.upper;
  const double to = side == SheetSide::Start ? omegas.lower + step : omegas.upper - step;
  loft::Frames frames(frame, omegas, 0);
  const double moved =
      meanRowSize(ribbonPoles(frames.at(to)) - ribbonPoles(frames.at(from))) / step;
  const double given = meanRowSize(ribbonPoles(ribbon.first));
  if (!(moved > 0) || !(given > 0) || !std::isfinite(moved / given))
    refuse(
        fmt::format("frames move by {} by omega, the ribbon's derivative is {}: both must be "
                    "positive",
                    moved, given));
  return moved / given;
}

FrameLoft frameSheet(const FrameFunction& frame, const Interval& omegas,
                     const std::optional<SheetEnd>& start, const std::optional<SheetEnd>& end,
                     const FrameLoftOptions& options) {
  if (!start && !end) refuse("neither start nor end of the sheet is given");
  if (options.closed) refuse("a sheet has two ends: it cannot be closed in omega");
  return loft::builtLoft(frame, omegas, {start, end}, options);
}

}  // namespace seamwright
