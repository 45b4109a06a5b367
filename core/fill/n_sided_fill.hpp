// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/patch_edge.hpp>
#include <seamwright/core/join/condition/connection.hpp>

namespace seamwright {

/// One side E(t) of a hole, which lies to the left. E' and T span the neighbour's tangent planes.
struct FillSide {
  BezierCurve edge;  ///< degree 1 at least, polynomial
  /// T, out of the hole, in Bernstein form of any degree; nothing: the side has position alone.
  std::optional<Poles> cross = std::nullopt;
  /// The second derivative along T; its normal part is used for curvature.
  std::optional<Poles> bend = std::nullopt;
};

/// An edge of a patch as a side, with curvature.
/// \param reversed the hole's sense is opposite to that of the edge.
/// \throws std::invalid_argument for a rational patch.
FillSide fillSide(const BezierPatch& neighbour, PatchEdge edge, bool reversed);

/// The function a(t) of the spokes from the centre to the sides, c = 2 cos(2 pi / n).
enum class SpokeLaw {
  /// c (1 - t); reproduces a paraboloid over a regular polygon.
  Linear,
  /// c (1 - t)^2; cross-boundary derivatives are C^1 along each side; less fair.
  Quadratic,
  /// c (1 - t), with second derivatives across the spokes such that the patches meet each other
  /// with G2.
  G2
};

struct FillOptions {
  SpokeLaw law = SpokeLaw::Linear;
  int fairness_order = 3;  ///< of the differences of poles whose squares are summed, 2 or 3
  /// Accepted angle between the tangent planes at a corner, in [0, 0.1].
  double corner_tolerance_rad = 0;
  /// Jumps of curvature are made small in a degree higher by this, 0 to 6; nothing: they are not.
  std::optional<int> curvature_degrees = std::nullopt;
};

/// The figures of a fill at the corner where side k begins.
struct FillCorner {
  double angle_rad = 0;  ///< of the hole, in (0, pi)
  /// Between both tangent planes, or to the tangent of a side of position alone.
  double plane_angle_rad = 0;
  /// Normal part of the difference of the mixed derivatives that the neighbours prescribe.
  double twist_defect_mm = 0;
  /// Both figures are rounding, so that the fill meets both planes on the halves of sides here.
  bool exact = true;
  /// Bound of the angle to these planes on these halves; 0 if exact.
  double angle_bound_rad = 0;
};

/// To a neighbour, on each half of a side over [0, 1]; valid if the half's corner is exact.
using FillSideJoin = std::array<ConnectionFunctions, 2>;

/// A hole filled by as many patches as it has sides.
struct NSidedFill {
  /// Patch k has the centre at (0, 0), corner k at (1, 1), spoke k at u = 0 and spoke k - 1 at v =
  /// 0. u = 1 is the second half of side k - 1; v = 1 is the first half of side k, backwards.
  std::vector<BezierPatch> patches;
  /// Of patch k + 1, edge V0, to patch k, edge U0; the same on all spokes.
  ConnectionFunctions spoke;
  std::vector<std::optional<FillSideJoin>> sides;  ///< nothing: position alone
  std::vector<FillCorner> corners;
  double fairness_mm2 = 0;  ///< sum of the squared differences of poles
  /// Proven: no normal of a patch vanishes or turns back.
  bool regular = false;
  /// Relative length of the spokes' first derivatives, if prescribed.
  std::optional<double> spoke_scale;
  /// The largest at samples of all edges, if asked for.
  std::optional<double> curvature_jump_per_mm = std::nullopt;
};

/// Fills a hole of 3 to 12 sides with Bezier patches. They meet each other, and the tangent planes
/// of the surroundings, exactly with G1. See docs/n_sided_fill.md.
///
///     nSidedFill({fillSide(a, PatchEdge::V1, true), fillSide(b, PatchEdge::U0, false),
///                 fillSide(c, PatchEdge::V0, false)}).patches
///
/// The degree is max(4, e + 1, d + 1), with the quadratic law at least 5, for edges of degree d and
/// cross-boundary derivatives of degree e; with SpokeLaw::G2 it is max(6, e + 2, d + 2). A corner
/// needs one tangent plane and an angle between 0 and pi.
///
/// Identities (each has a test of its number):
///   (1) Edges U1 and V1 are the sides; neighbours share the poles of their spoke bitwise.
///   (2) encloseSeam(): the angle across spokes, and next to exact corners, is rounding; next to
///       others it is within the bound.
///   (3) Rigid motion, scale and numbering act on the fill likewise; reversal exchanges u and v.
///   (4) The fill of planar sides is planar; a symmetric hole has a symmetric fill.
///   (5) No other choice of the free quantities is fairer.
///   (6) encloseSeam(): with SpokeLaw::G2 the difference of curvature across spokes is rounding.
///
/// \throws std::invalid_argument, with side or corner and number, for a number of sides outside 3
/// to 12; edges that are rational, of degree 0 or above 12, or not connected; a field T that is
/// empty, of degree above 12, not finite, or parallel to the edge at a corner; corners that are not
/// as above; and options out of range.
/// Source: docs/theory/fills.md F2.1 to F2.8, F3.1; [GregoryZhou1994]; [Hahn1989].
NSidedFill nSidedFill(const std::vector<FillSide>& sides, const FillOptions& options = {});

}  // namespace seamwright
