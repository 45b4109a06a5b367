// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <seamwright/core/join/condition/connection.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <vector>

namespace seamwright {

/// Rows of homogeneous poles of a patch, counted from the seam: rows[0] is the seam, rows[k] the
/// k-th row behind it. In a tensor-product patch each row has n + 1 poles, in a triangle row k has
/// n + 1 - k.
struct JoinRows {
  std::vector<HomogeneousPoles> rows;
  /// Degree across of the tensor-product patch that the rows are for; for a triangle its degree.
  int degree_across = 0;
};

/// The following holds for all functions below.
///
/// The given ribbon runs out of its patch (Across::OutOf). The result begins at the seam and
/// satisfies the equations of ConnectionFunctions along the whole seam, up to rounding of the
/// poles.
///
///     const BezierPatch next = continuation(ribbon, {.beta = Eigen::Vector2d(0.2, -0.2)}, 2, 5);
///
/// Without a given degree, the degree along the seam is the lowest in which each term of those
/// equations can be written (docs/joins.md has the table): constant alpha and p with linear beta
/// and q keep the degree of a tensor-product patch. With a given degree, rows are raised to it, or
/// lowered to it if their sums have that degree.
///
/// \throws std::invalid_argument, with name, index and value, for a function without coefficients,
/// of a degree above 100, or with a coefficient that is not finite; for an alpha or e0 that is not
/// positive everywhere on [0, 1]; for a gamma other than 1; for an order outside 1 to 3 or
/// above the degree across; for a degree above 800; for rows that cannot be written in the given
/// degree, with the defect as a distance of homogeneous poles; and for a resulting weight that is
/// zero or negative, with its row and index. Source: docs/theory/surfaces.md S2.1, S3.1, S3.3,
/// S3.4, S4.2, S4.3; [Farin2002].

/// The first order + 1 rows of a tensor-product patch of that degree across:
///   Q[0] = Q(0), Q[1] = Q[0] + Q_u / l, Q[2] = 2 Q[1] - Q[0] + Q_uu / (l (l - 1)),
///   Q[3] = 3 Q[2] - 3 Q[1] + Q[0] + Q_uuu / (l (l - 1) (l - 2)).
/// Here l is the degree across. Further rows are free. From l = 2 order + 1 on the opposite edge
/// can be joined independently.
/// Identities (each has a test of its number):
///   (1) The ribbon of a patch with these rows satisfies the equations of ConnectionFunctions.
///   (2) The join is G^order along the whole seam for any other rows, certified by encloseSeam().
///   (3) The default connection gives C^order.
JoinRows tensorRows(const Ribbon& given, const ConnectionFunctions& connection, int order,
                    int degree_across, std::optional<int> degree = std::nullopt);

/// The first order + 1 rows of a triangle, by the same differences with its degree as l: Q_u has
/// one degree less than the triangle, Q_uu two less, Q_uuu three less. Identity (4): the ribbon of
/// a triangle with these rows satisfies the equations of ConnectionFunctions.
JoinRows triangleRows(const Ribbon& given, const ConnectionFunctions& connection, int order,
                      std::optional<int> degree = std::nullopt);

/// The patch on the other side of the given patch's edge (u = 0 is the seam, v = t) whose
/// derivatives by u of an order above \p order vanish.
BezierPatch continuation(const Ribbon& given, const ConnectionFunctions& connection, int order,
                         int degree_across, std::optional<int> degree = std::nullopt);

/// The triangle on the other side of the given patch's edge whose derivatives by s of an order
/// above \p order vanish. Its edge L0 is the seam, and the barycentric coordinates of (P0, P1, P2)
/// are (s, 1 - s - t, t).
BezierTriangle triangleContinuation(const Ribbon& given, const ConnectionFunctions& connection,
                                    int order, std::optional<int> degree = std::nullopt);

/// The patch between two given patches, of degree 2 order + 1 in u. It joins the first patch at u =
/// 0 and the second one at u = 1. Both ribbons run out of their patches, along the same v. The
/// degree in v is the higher one of the two joins.
BezierPatch blend(const Ribbon& first, const ConnectionFunctions& to_first, const Ribbon& second,
                  const ConnectionFunctions& to_second, int order);

/// The patch with the first rows at one of its edges replaced; the other rows stay. Patch and rows
/// are brought to the same degree along the seam: the lower one is raised.
/// \throws std::invalid_argument if the degree of the patch across the edge differs from the degree
/// across that the rows are for.
BezierPatch withRows(const BezierPatch& patch, PatchEdge edge, bool reversed, const JoinRows& rows);

/// The triangle with its first rows at an edge replaced. A triangle of lower degree than the rows
/// is raised first.
/// \throws std::invalid_argument for rows of lower degree than the triangle: triangleRows() can
/// build them in its degree.
BezierTriangle withRows(const BezierTriangle& triangle, TriangleEdge edge, bool reversed,
                        const JoinRows& rows);

}  // namespace seamwright
