// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/join/connection.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <vector>

namespace seamwright {

/// Rows of homogeneous poles of a patch, counted from the seam: rows[0] is the seam, rows[k] the
/// k-th row behind it. Of a tensor-product patch each has n + 1 poles, of a triangle n + 1 - k.
struct JoinRows {
  std::vector<HomogeneousPoles> rows;
  int degree_across =
      0;  ///< of the tensor-product patch that the rows are for; of a triangle its degree
};

/// Everywhere below:
///
/// The given ribbon runs out of its patch (Across::OutOf). What is built begins at the seam and
/// satisfies the equations of Connection as polynomials, so the join is exact along the whole seam,
/// but for rounding of the poles.
///
/// Degrees. Without a degree asked for, the degree along the seam is the lowest in which each term
/// of those equations can be written:
///   tensor, G1 max of n, deg alpha + deg P_s, deg beta + n - 1 (with e0 = 1, e1 = 0) tensor, G2
///   moreover 2 deg alpha + deg P_ss, deg alpha + deg beta + deg P_s - 1, 2 deg beta + n - 2, deg p
///   + deg P_s, deg q + n - 1 triangle max of n, 1 + deg alpha + deg P_s, 1 + deg beta + n - 1
/// with deg P_s = deg P_ss = n of a tensor-product patch, n - 1 and n - 2 of a triangle. A function
/// that is zero has no term, and one whose coefficients are all the same is a constant. So constant
/// alpha and p with linear beta and q keep the degree n of a tensor-product patch. With a degree
/// asked for, rows are raised to it, or lowered where their sums happen to allow that: see
/// docs/theory/surfaces.md S2.1, S4.2.
///
/// \throws std::invalid_argument, with name, index and value, for a function without coefficients,
/// above degree 100, or with one that is not finite; for alpha or e0 that is not positive
/// everywhere on [0, 1]; for an order other than 1 and 2 or above the degree across; for a degree
/// above 800; for rows that cannot be written in the degree asked for, with the defect in the size
/// of homogeneous poles; and for a weight that comes out zero or negative, with its place (e1 and
/// e2 control the weights of rows 1 and 2).
/// Source: docs/theory/surfaces.md S2.1, S3.1, S3.3, S4.2, S4.3; [Farin2002].

/// The first order + 1 rows of a tensor-product patch of that degree across:
///   Q[0] = Q(0), Q[1] = Q[0] + Q_u / l, Q[2] = 2 Q[1] - Q[0] + Q_uu / (l (l - 1)).
/// Further rows are free; the opposite edge can be joined on its own from l = 2 order + 1 on.
/// Identities (each has a test of its number):
///   (1) The ribbon of a patch with these rows satisfies the equations of Connection.
///   (2) The join is G1 (order 2: G2) along the whole seam, certified by encloseSeam(), whatever
///       the other rows are.
///   (3) alpha = 1, beta = p = q = 0 gives C^order.
JoinRows tensorRows(const Ribbon& given, const Connection& connection, int order, int degree_across,
                    std::optional<int> degree = std::nullopt);

/// The first two rows of a triangle; p, q and e2 do not enter.
/// Identity (4): the ribbon of a triangle with these rows satisfies the equations of Connection.
JoinRows triangleRows(const Ribbon& given, const Connection& connection,
                      std::optional<int> degree = std::nullopt);

/// The patch beyond the given one's edge (u = 0 is the seam, v = t) whose derivatives by u beyond
/// the order vanish.
BezierPatch continuation(const Ribbon& given, const Connection& connection, int order,
                         int degree_across, std::optional<int> degree = std::nullopt);

/// The triangle beyond the given one's edge, of degree 1 in s: Q + s Q_s. Its edge L0 is the seam:
/// the barycentric coordinates of (P0, P1, P2) are (s, 1 - s - t, t).
BezierTriangle triangleContinuation(const Ribbon& given, const Connection& connection,
                                    std::optional<int> degree = std::nullopt);

/// The patch between two given ones, of degree 2 order + 1 in u: it joins the first at u = 0, the
/// second at u = 1. Both ribbons run out of their patches, along the same v. The degree along is
/// the higher one of both joins.
BezierPatch blend(const Ribbon& first, const Connection& to_first, const Ribbon& second,
                  const Connection& to_second, int order);

/// A patch with the rows behind one of its edges replaced; the others stay. The patch or the rows
/// are raised along the seam, whichever has the lower degree there.
/// \throws std::invalid_argument if the patch has another degree across than the rows are for.
BezierPatch withRows(const BezierPatch& patch, PatchEdge edge, bool reversed, const JoinRows& rows);

/// A triangle of lower degree than the rows is raised first.
/// \throws std::invalid_argument for rows of lower degree than the triangle: triangleRows() builds
/// them in its degree.
BezierTriangle withRows(const BezierTriangle& triangle, TriangleEdge edge, bool reversed,
                        const JoinRows& rows);

}  // namespace seamwright
