// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/seam/tolerance.hpp>

/// Seams measured a second time: by plain evaluation at many points, with formulas written down here. Nothing of the
/// library takes part.
namespace seamwright::test {

/// A face beside an edge: its surface where it lies in space, the edge's path in the parameter plane.
struct DenseSide {
  opencascade::handle<Geom_Surface> surface;
  opencascade::handle<Geom2d_Curve> path;
  double first = 0;
  double last = 0;
  bool face_on_left = true;
};

/// What a pair of points shows; no angle where a side has no normal.
struct DensePoint {
  double gap_mm = 0;
  std::optional<double> angle_rad;
  double curvature_per_mm = 0;
  double curvature_rel = 0;
  double norm_per_mm = 0;  ///< largest absolute normal curvature of the two sides
  bool fold = false;
  std::array<double, 4> partials{};  ///< lengths of X_u, X_v of both sides
};

/// Near a collapsed side of a surface rounding speaks: where a partial is shorter than 1e-5 of its largest length along
/// the seam there counts as no normal, and curvature and folds, which divide by its square, are taken only above 1e-2.
struct DenseMaxima {
  double gap_mm = 0;
  std::optional<double> angle_rad;
  double curvature_per_mm = 0;  ///< of the points whose angle is not above the crease angle
  double curvature_rel = 0;
  double norm_per_mm = 0;
  bool fold = false;
  double below_crease_share = 0;  ///< of the points, those whose angle is within tolerance
  int points_without_normal = 0;
};

/// The two sides of an edge (number from 1); nothing if it has another number of sides, or no path on one.
std::optional<std::array<DenseSide, 2>> denseSides(const TopoDS_Shape& shape, int edge,
                                                   const std::array<int, 2>& faces);

/// \param s 0..1 of the edge's parameter range.
DensePoint densePoint(const std::array<DenseSide, 2>& sides, double s, double flat_radius_mm);

DenseMaxima denseMaxima(const std::array<DenseSide, 2>& sides, int points,
                        const ContinuityTolerance& tolerance);

}  // namespace seamwright::test
