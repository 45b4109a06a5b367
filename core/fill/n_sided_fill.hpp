// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/join/connection.hpp>

namespace seamwright {

/// One side of a hole: its boundary curve E(t), with the hole to the left, and the tangent planes
/// of the adjacent surface, spanned by E'(t) and T(t).
struct FillSide {
  BezierCurve edge;  ///< degree 1 at least, polynomial
  /// T, transversal to the edge and out of the hole, in Bernstein form on [0, 1], of any degree;
  /// nothing: the side has position alone.
  std::optional<Poles> cross = std::nullopt;
  /// The second derivative of the adjacent surface along T. Only its normal part, the curvature,
  /// matters. It is used only if curvature is asked for.
  std::optional<Poles> bend = std::nullopt;
};

/// The side of a hole that is an edge of a patch. T is the cross-boundary derivative into the
/// patch; bend is the second derivative.
/// \param reversed the hole's sense is opposite to the sense of the edge.
/// \throws std::invalid_argument for a rational patch.
FillSide fillSide(const BezierPatch& neighbour, PatchEdge edge, bool reversed);

/// The function a(t) of the seams between the patches of a fill, t running from the centre to the
/// side, c = 2 cos(2 pi / n).
enum class SpokeLaw {
  /// c (1 - t): patches of degree 4 for sides and cross-boundary derivatives of degree 3. It is the
  /// law of the regular polygon cut into bilinear patches, so a paraboloid over a regular polygon
  /// is reproduced.
  Linear,
  /// c (1 - t)^2: degree 5, more freedom, and cross-boundary derivatives of class C^1 along each
  /// side. It is less fair if n is far from 4.
  Quadratic
};

struct FillOptions {
  SpokeLaw law = SpokeLaw::Linear;
  int fairness_order = 3;  ///< of the differences of poles whose squares are summed, 2 or 3
  /// Largest allowed angle between the tangent planes of two sides at their corner, in [0, 0.1], in
  /// addition to rounding. If they differ, the fill is not exact at the corner.
  double corner_tolerance_rad = 0;
  /// If given, the curvature jumps along all edges, including those to neighbours with
  /// FillSide::bend, are made small, in a degree higher by this number. Nothing: only fairness
  /// counts.
  std::optional<int> curvature_degrees = std::nullopt;
};

/// The figures of a fill at the corner where side k begins and side k - 1 ends.
struct FillCorner {
  double angle_rad = 0;  ///< of the hole, in (0, pi)
  /// Between the tangent planes of both sides; for a side of position alone: to its tangent.
  double plane_angle_rad = 0;
  /// delta_k, the normal part of the difference between the mixed derivatives that the two
  /// neighbours prescribe; 0 unless both have tangent planes.
  double twist_defect_mm = 0;
  /// Both figures are rounding: the fill has the tangent planes of both sides on the halves next to
  /// the corner.
  bool exact = true;
  /// Bound of the angle to the tangent planes of both sides on these halves; 0 if exact.
  double angle_bound_rad = 0;
};

/// The join of a fill to a neighbour whose derivative out of the hole is T: the connection of the
/// fill to it on each half of the side, with a parameter in [0, 1] on each half. It holds if the
/// half's corner is exact.
using FillSideJoin = std::array<Connection, 2>;

/// A hole filled by as many patches as it has sides.
struct NSidedFill {
  /// Patch k belongs to corner k, where it has (u, v) = (1, 1); (0, 0) is the centre. u = 1 is the
  /// second half of side k - 1, v = 1 the first half of side k, against its sense; v = 0 is spoke k
  /// - 1, u = 0 spoke k, which ends in the middle of side k.
  std::vector<BezierPatch> patches;
  Connection spoke;  ///< of patch k + 1, edge V0, to patch k, edge U0; the same on all spokes
  std::vector<std::optional<FillSideJoin>> sides;  ///< nothing: position alone
  std::vector<FillCorner> corners;
  double fairness_mm2 = 0;  ///< sum of the squared differences of poles
  /// True: no normal of a patch vanishes or turns back, certified by Bernstein coefficients of the
  /// normals. False: not proven.
  bool regular = false;
  /// The length of the spokes' first derivatives, relative to the regular set of tangents towards
  /// the middles of the sides, that was prescribed to keep the patches regular. Nothing: it was
  /// chosen by fairness, like all free quantities.
  std::optional<double> spoke_scale;
  /// The largest jump of normal curvature at sampled parameters of all edges, if curvature was
  /// asked for.
  std::optional<double> curvature_jump_per_mm = std::nullopt;
};

/// Fills a hole of 3 to 12 sides with tensor-product Bezier patches. They meet each other, and the
/// tangent planes of the surroundings, exactly with G1: the equations hold as polynomials, not only
/// at sampled points.
///
/// The cross-boundary derivative out of the hole is G = p T + q E' along each side, p > 0, with the
/// scalar functions p and q such that neighbouring sides agree in the corners. Spokes run from the
/// centre to the middles of the sides; across spoke k, V + U = a S' holds (see SpokeLaw). The
/// degree of the patches in u and v is N = max(4, e + 1, d + 1), with the quadratic law at least 5,
/// d and e the largest degrees of edges and cross-boundary derivatives. The free quantities
/// (centre, spokes, twists, interiors, and the cross-boundary derivatives of sides of position
/// alone) minimise the sum of squared differences of poles. This is one linear least-squares
/// problem. If its patches are not proven regular, several lengths of the spokes' first derivatives
/// are prescribed, and differences of the other order are tried.
///
/// **Curvature.** With FillOptions::curvature_degrees, the fill minimises the squared jumps of
/// normal curvature at sampled parameters of all edges, plus the differences of poles with a small
/// weight. The joins stay. A result is rejected if it does not decrease the squares, increases the
/// largest jump by more than a fiftieth, or is not proven regular. In general no choice makes all
/// jumps zero, because two neighbours of a corner would have to agree to higher order.
///
/// **Corners.** The edges and cross-boundary derivatives of the two sides of a corner have to be in
/// one plane, and the angle of the hole there has to be between 0 and pi. The mixed derivatives
/// that the two neighbours prescribe agree if both have the same second fundamental form
/// II(E_(k-1)', E_k'), as parts of one C^2 surface do. If they differ by delta_k, no patch can meet
/// both. Then each side takes half of the difference: next to that corner the fill's cross-boundary
/// derivative deviates from the tangent planes of both sides by at most asin(sup|dG| /
/// inf|G_perp|), G_perp the part across the edge. The joins between the patches stay exact.
///
/// Identities (each has a test of its number):
///   (1) Edges U1 and V1 of the patches are the sides; neighbours share the poles of their spoke
///       bitwise.
///   (2) encloseSeam(): the angle across spokes, and to neighbours next to exact corners, is
///       rounding; next to other corners it is within the bound.
///   (3) Rigid motion, scale, and the numbering of the sides act on the fill in the same way;
///       reversing all sides exchanges u and v.
///   (4) The fill of planar sides is planar; a symmetric hole has a symmetric fill.
///   (5) No other choice of the free quantities is fairer.
///
/// \throws std::invalid_argument, with side or corner and number, for fewer than 3 sides or more
/// than 12 (with 2 sides the spokes would be one line; splitting a side does not help, because the
/// new corner would have an angle of pi); for edges that are rational, of degree 0 or above 12, or
/// that do not begin where the previous edge ends, up to rounding; for a cross-boundary derivative
/// that is empty, of degree above 12, not finite, or parallel to the edge at a corner; for corners
/// whose planes differ by more than rounding and the tolerance; for an angle of pi (merge the two
/// sides) or more (split the hole), or 0; for an order other than 2 and 3; for a tolerance outside
/// [0, 0.1]; for curvature degrees outside 0 to 6.
/// Source: docs/theory/fills.md F2.1 to F2.7, F3.1; [GregoryZhou1994]; [Hahn1989].
NSidedFill nSidedFill(const std::vector<FillSide>& sides, const FillOptions& options = {});

}  // namespace seamwright
