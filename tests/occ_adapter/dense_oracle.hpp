// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/seam/tolerance.hpp>

/// Seams measured a second time: by plain evaluation at many points, with formulas written down
/// here. Nothing of the library takes part.
namespace seamwright::test {

/// A face beside an edge: its surface where it lies in space, the edge's path in the parameter
/// plane.
struct DenseSide {
  opencascade::handle<Geom_Surface> surface;
  opencascade::handle<Geom2d_Curve> path;
  double first = 0;
  double last = 0;
  bool face_on_left = true;
};

/// A figure at a point, and what the rounding of its evaluation may have added to it.
///
/// Coordinates of size P are rounded by c eps P (c = 64: a sum of some dozens of terms, through
/// OpenCASCADE's caches). A first partial by a parameter is a difference over a step h, the knot
/// span over the degree, or 1: e_1 = c eps P / h; a second one e_2 = c eps P / h^2. With x the
/// length of the partial and sin the sine between the partials the normal turns by e_1 / (x sin),
/// and a normal curvature k changes by e_2 / (x sin)^2 + 4 |k| e_1 / (x sin); the errors of the
/// sides and of the directions add.
struct DenseValue {
  double value = 0;
  double noise = 0;
  double sure() const { return value - noise; }
};

/// What a pair of points shows; no angle where a side has no normal.
struct DensePoint {
  DenseValue gap_mm;
  std::optional<DenseValue> angle_rad;
  DenseValue curvature_per_mm;
  DenseValue curvature_rel;
  double norm_per_mm = 0;  ///< largest absolute normal curvature of the two sides
  bool fold = false;
  std::array<double, 4> partials{};  ///< lengths of X_u, X_v of both sides
};

/// Near a collapsed side of a surface rounding speaks: where a partial is shorter than 1e-5 of its
/// largest length along the seam there counts as no normal, and curvature and folds, which divide
/// by its square, are taken only above 1e-2.
struct DenseMaxima {
  DenseValue gap_mm;  ///< of each figure the point with the largest sure() value
  std::optional<DenseValue> angle_rad;
  DenseValue curvature_per_mm;  ///< of the points whose angle is not above the crease angle
  DenseValue curvature_rel;
  double norm_per_mm = 0;
  bool fold = false;
  double below_crease_share = 0;  ///< of the points, those whose angle is within tolerance
  int points_without_normal = 0;
};

/// The two sides of an edge (number from 1); nothing if it has another number of sides, or no path
/// on one.
std::optional<std::array<DenseSide, 2>> denseSides(const TopoDS_Shape& shape, int edge,
                                                   const std::array<int, 2>& faces);

/// \param s 0..1 of the edge's parameter range.
DensePoint densePoint(const std::array<DenseSide, 2>& sides, double s, double flat_radius_mm);

DenseMaxima denseMaxima(const std::array<DenseSide, 2>& sides, int points,
                        const ContinuityTolerance& tolerance);

}  // namespace seamwright::test
