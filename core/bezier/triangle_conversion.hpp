// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/bezier/triangle.hpp>

/// Bézier triangles as tensor-product patches, and back; polynomial and rational.
///
/// Identities (each has a test of its number; T of degree n, corners P0, P1, P2):
///   (1) degeneratePatch(T, 0) is T(1-u, u(1-v), uv). At u = 0 it is P0, at u = 1 the edge L0 in
///       its own direction, at v = 0 the edge from P0 to P1, at v = 1 the edge from P0 to P2. Its
///       row r is the row i = n - r of the triangle, which has degree r, raised to degree n. The
///       row u = 1 is copied bitwise.
///   (2) Patch k of regularPatches(T) is T over the quadrangle Pk, (Pk + Pk+1)/2, centroid, (Pk +
///       Pk+2)/2 (indices modulo 3), at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1).
///   (3) Common boundaries of the three patches have bitwise the same poles. The patches are parts
///       of one surface in other parameters, so they meet with G^n for every n where the triangle
///       is regular.
///   (4) A patch X(u, v) is T(1-u, u(1-v), uv) for some triangle T if and only if its row r has
///       degree <= r in v for every r. The least degree of such a T is the degree of X in u.
///   (5) recogniseTriangle(degeneratePatch(T)) is T, except for rounding, at the lowest degree that
///       represents T.
/// Source: docs/theory/surfaces.md S4.4, S4.5; [Hu1996]. (4): in powers X = sum_k u^k x_k(v); with
/// x = u(1-v), y = uv the terms of degree k of a polynomial in x, y are u^k times a polynomial of
/// degree <= k in v, and each such polynomial occurs.
namespace seamwright {

/// The triangle as one patch of degrees n, n. Its edge u = 0 is the corner \p apex; the other
/// corners follow in cyclic order. The natural normals agree.
/// \throws std::invalid_argument if apex is not 0, 1 or 2.
BezierPatch degeneratePatch(const BezierTriangle& triangle, int apex = 0);

/// Bound of the distance between a point of degeneratePatch() and that of the triangle: 16 (n + 1)
/// eps |P|_max w_max / w_min. The distance comes from rounding of the poles only. The share of row
/// r is (n - r) / n; the row next to u = 1 is raised by one degree only.
double conversionNoise(const BezierTriangle& triangle);

/// The triangle as three patches of degrees n, n around its centroid. They are regular where the
/// triangle is. The natural normals agree. The outer edges are cut at their midpoints: a neighbour
/// that joined the triangle there joins the patches once it is cut at t = 1/2.
///
/// Let b be the blossom, q00 = Pk, and q10, q11, q01 the other corners of (2). The pole (i, j) is
/// the convex combination sum_d C(i,d) C(n-i,j-d) / C(n,j) b(q00 n-i-j+d times, q10 i-d times, q01
/// j-d times, q11 d times).
std::array<BezierPatch, 3> regularPatches(const BezierTriangle& triangle);

/// Whether a patch with a collapsed edge is a triangle.
struct TriangleRecognition {
  std::optional<BezierTriangle> triangle;  ///< of the lowest degree that fits
  PatchEdge apex = PatchEdge::U0;  ///< the edge of the patch that is P0; the natural normals agree
  /// Bound of the distance of patch and triangle at equal parameters, except for rounding. If there
  /// is not a triangle, the distance to the nearest one that was tried.
  double deviation_mm = 0;
  double tolerance_mm = 0;  ///< the accepted deviation
};

/// Finds the triangle that equals the given patch, with any of the four edges as P0.
///
/// Rows are lowered to the degrees of (4) by least squares that keep their end poles. So the
/// triangle keeps the poles of the two edges from P0 where the degree in u is not lowered. If
/// several triangles fit, the one of lowest degree is returned. For a rational patch the
/// homogeneous poles must be those of a triangle; the function does not look for a common factor of
/// numerator and denominator.
/// \param tolerance_mm accepted deviation. The default is the rounding of conversion and fit: 8 (m
/// + n + 4) eps |P|_max w_max / w_min.
/// \throws std::invalid_argument if the tolerance is negative or NaN.
TriangleRecognition recogniseTriangle(const BezierPatch& patch,
                                      std::optional<double> tolerance_mm = std::nullopt);

}  // namespace seamwright
