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
/// of the surface beyond it, spanned by E'(t) and T(t).
struct FillSide {
  BezierCurve edge;  ///< degree 1 at least, polynomial
  /// T, transversal to the edge and out of the hole, in Bernstein form on [0, 1], of any degree;
  /// nothing: the side asks for position alone.
  std::optional<Poles> cross = std::nullopt;
  /// The second derivative of the surface beyond along T, as far as its normal part goes: its
  /// curvature; only used where that is asked for.
  std::optional<Poles> bend = std::nullopt;
};

/// The side that a patch gives to a hole along one of its edges: T is its cross derivative, into
/// the patch, with the second one.
/// \param reversed the hole's sense runs against the edge's own sense.
/// \throws std::invalid_argument for a rational patch.
FillSide fillSide(const BezierPatch& neighbour, PatchEdge edge, bool reversed);

/// The function a(t) of the seams between the patches of a fill, t running from the centre to the
/// side, c = 2 cos(2 pi / n).
enum class SpokeLaw {
  /// c (1 - t): patches of degree 4 for sides and cross fields of degree 3. The law of the regular
  /// polygon cut into bilinear patches: a paraboloid over one is reproduced.
  Linear,
  /// c (1 - t)^2: degree 5, more freedom, and cross fields of class C^1 along each side; less fair
  /// where n is far from 4.
  Quadratic
};

struct FillOptions {
  SpokeLaw law = SpokeLaw::Linear;
  int fairness_order = 3;  ///< of the differences of poles whose squares are summed, 2 or 3
  /// Largest angle between the tangent planes of two sides at their corner, [0, 0.1], beyond
  /// rounding. Such a corner is not met exactly.
  double corner_tolerance_rad = 0;
  /// The jumps of curvature along all edges, those to neighbours with FillSide::bend among them,
  /// are made small, in a degree higher by this number; nothing: they are left to fairness.
  std::optional<int> curvature_degrees = std::nullopt;
};

/// What a fill found at the corner where side k begins and side k - 1 ends.
struct FillCorner {
  double angle_rad = 0;  ///< of the hole, in (0, pi)
  double plane_angle_rad =
      0;  ///< between the tangent planes of both sides; of position alone: to the other's tangent
  /// delta_k, the normal part by which the mixed derivatives that the two neighbours ask for
  /// differ; 0 unless both have tangent planes.
  double twist_defect_mm = 0;
  bool exact = true;  ///< both figures are rounding: the tangent planes of both sides are met on
                      ///< the halves next to the corner
  /// Bound of the angle to the tangent planes of both sides on these halves; 0 where exact.
  double angle_bound_rad = 0;
};

/// The join of a fill to a neighbour, of which T is the derivative out of the hole: connection of
/// the fill to it on either half of the side, each with its own parameter in [0, 1]. It holds where
/// the half's corner is exact.
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
  /// No normal of a patch vanishes or turns back: certified by Bernstein coefficients of the
  /// normals. False: not proved.
  bool regular = false;
  /// The length of the spokes' beginnings, over that of the regular star through the middles of the
  /// sides, that had to be prescribed to keep the patches regular; nothing: it was chosen by
  /// fairness, like everything that is free.
  std::optional<double> spoke_scale;
  /// The largest jump of normal curvature found at places along all edges, where it was asked for.
  std::optional<double> curvature_jump_per_mm = std::nullopt;
};

/// Fills a hole of 3 to 12 sides with tensor-product Bezier patches that meet each other, and the
/// tangent planes of the surroundings, with
/// G1, exactly: not in places but as polynomials.
///
/// The cross derivative out of the hole is G = p T + q E' along each side, p > 0, with the scalar
/// functions p and q such that neighbouring sides agree in the corners. Spokes run from the centre
/// to the middles of the sides; across spoke k, V + U = a S' holds (see SpokeLaw). The degree of
/// the patches in u and v is N = max(4, e + 1, d + 1), with the quadratic law at least 5, d and e
/// the largest degrees of edges and cross fields. What these equations leave free (centre, spokes,
/// twists, interiors, and the cross fields of sides of position alone) makes the sum of squared
/// differences of poles least. That is one linear least-squares problem. Where its patches are not
/// proved regular, beginnings of the spokes are prescribed in some lengths, and differences of the
/// other order are tried.
///
/// **Curvature.** With FillOptions::curvature_degrees, the squared jumps of normal curvature at
/// places along all edges are made least, with little of the differences of poles. The joins stay
/// as they are. What does not make the squares smaller, makes the largest jump larger by more than
/// a fiftieth, or is not proved regular, is not taken. Jumps are zero in general for no choice: two
/// neighbours of a corner would have to agree to higher order.
///
/// **Corners.** The edges and cross fields of the two sides of a corner are in one plane, and the
/// angle of the hole there is between 0 and pi. The mixed derivatives that the two neighbours ask
/// for agree where they have the same second fundamental form II(E_(k-1)', E_k'), as parts of one
/// C^2 surface have. Where they differ by delta_k no patch can meet both. Then each takes half: the
/// fill's cross derivative leaves the tangent planes of both sides next to that corner by at most
/// asin(sup|dG| / inf|G_perp|), G_perp the part across the edge. The joins between the patches stay
/// exact.
///
/// Identities (each has a test of its number):
///   (1) Edges U1 and V1 of the patches are the sides, neighbours share the poles of their spoke to
///       the bit.
///   (2) encloseSeam(): the angle across spokes, and to neighbours next to exact corners, is
///       rounding; next to others within the bound.
///   (3) Rigid motion, scale, and the numbering of the sides move the fill likewise; reversing all
///       sides exchanges u and v.
///   (4) The fill of planar sides is planar; a symmetric hole has a symmetric fill.
///   (5) No choice of what is free is fairer.
///
/// \throws std::invalid_argument, with side or corner and number, for fewer than 3 sides or more
/// than 12 (with 2 the spokes would be one line: a splitting of a side helps not, its corner would
/// have an angle of pi); for edges that are rational, of degree 0 or above 12, or that do not begin
/// where the previous one ends, to rounding; for a cross field that is empty, of degree above 12,
/// not finite, or parallel to the edge at a corner; for corners whose planes differ by more than
/// rounding and the tolerance; for an angle of pi (merge the two sides) or more (split the hole),
/// or 0; for an order other than 2 and 3; for a tolerance outside [0, 0.1]; for curvature degrees
/// outside 0 to 6.
/// Source: docs/theory/fills.md F2.1 to F2.7, F3.1; [GregoryZhou1994]; [Hahn1989].
NSidedFill nSidedFill(const std::vector<FillSide>& sides, const FillOptions& options = {});

}  // namespace seamwright
