// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>
#include <vector>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/triangle.hpp>
#include <seamwright/core/umbrella/vertex.hpp>

namespace seamwright {

/// A patch over [0, 1]^2 or a triangle over u = l0, v = l1; (u, v) = (0, 0) is the common point O,
/// which is corner P2 of a triangle.
using UmbrellaMember = std::variant<BezierPatch, BezierTriangle>;
enum class MemberKind { Tensor, Triangle };

/// The edges through O. Spoke i is the edge v = 0 of member i, PatchEdge::V0 or TriangleEdge::L1,
/// and the edge u = 0 of member i - 1, PatchEdge::U0 or TriangleEdge::L0 run backwards.
///
/// Across an inner spoke C, with U the derivative of member i - 1 by u and V that of member i by v:
/// V = a C' + b U, b < 0. As a Connection it has alpha = -b and beta = a. Bernstein coefficients on
/// [0, 1]; one coefficient if a function is constant, none on a boundary spoke.
struct SpokeFunctions {
  Eigen::VectorXd a, b;
};

/// Largest number of poles of all members together. The system is dense, and its time grows with
/// the cube of this number.
constexpr int most_umbrella_poles = 1600;

struct UmbrellaOptions {
  bool closed = true;
  /// Kinds of the members; empty: those of the given members, or all tensor products if there are
  /// none.
  std::vector<MemberKind> kinds = {};
  /// Members to be changed as little as possible, by the sum of squared moves of poles. Empty: the
  /// result is made fair instead.
  std::vector<UmbrellaMember> members = {};
  /// Degree of all members in u and v; nothing: the lowest possible degree that is at least that of
  /// each given member.
  std::optional<int> degree = std::nullopt;
  /// a'(0) and b'(0) of each spoke. Without lambda the best values are sought; without mu it is 0.
  std::optional<Eigen::VectorXd> lambda = std::nullopt, mu = std::nullopt;
  /// A second fundamental form at O, in 1/mm. The spokes get its normal curvatures. Nothing: they
  /// keep their own.
  std::optional<Eigen::Matrix3d> form = std::nullopt;
  double gap_mm = 1e-9;  ///< starts of spokes within this distance of their mean count as one point
  VertexOptions vertex = {};
};

/// Members around a point that join G1 across every spoke, and the changes of the given data.
struct Umbrella {
  std::vector<UmbrellaMember> members;
  std::vector<BezierCurve> spokes;
  UmbrellaVertex vertex;
  std::vector<SpokeFunctions> laws;
  double largest_spoke_move_mm = 0;   ///< of a pole of a spoke
  double largest_second_change = 0;   ///< |C''(0)|, in mm
  double largest_lambda_change = 0;   ///< of a given lambda
  double largest_member_move_mm = 0;  ///< of a pole of a given member; 0 without given members
  Eigen::Index free_vectors = 0;      ///< number of free vectors in the poles
};

/// The lowest degree of members around spokes of degree \p spoke_degree, for laws with a linear and
/// b constant. For a patch next to a patch or a triangle it is the degree of the spokes. For a
/// triangle next to a triangle it is one more. (With a constant a the degree of the spokes would be
/// sufficient; umbrellaAround() uses that if lambda is given.) Triangles have at least degree 2.
/// With b linear (mu not 0) a patch next to a patch, or a patch behind a triangle, needs the degree
/// of the spokes; other pairs are impossible.
int lowestUmbrellaDegree(const std::vector<MemberKind>& kinds, bool closed, int spoke_degree);

/// The umbrella around spokes.
///
/// \param spokes polynomial curves that begin at O, in their order around it. A closed fan has as
/// many members as spokes, member i between spoke i and spoke i + 1; an open fan has one member
/// less. Spokes of lower degree are raised.
///
/// Spokes stay up to rounding, with three exceptions. First, a closed fan of an even number of
/// members imposes one condition on the second derivatives along N. The smallest change that
/// satisfies it is applied to the third poles (spokes of degree 2 are raised to 3 before). Second,
/// a second fundamental form changes the same poles. Third, tangents within the tolerance of one
/// plane are put into it.
///
/// b is the constant beta_i, and a is linear, from alpha_i to alpha_i + lambda_i. lambda, the
/// twists and all poles behind the spokes are chosen such that the members move least, or are
/// fairest. Fairest means the least sum of |P_uu|^2 + 2 |P_uv|^2 + |P_vv|^2, as differences of
/// poles. This is one linear least-squares problem, so there is no other minimum.
///
/// Identities (each has a test of its number):
///   (1) G1 across every inner spoke, up to rounding: V = a C' + b U, relative to the largest term.
///   (2) Members that already are such an umbrella are returned the same.
///   (3) Numbering from another spoke, and the order reversed, give the same members. Rigid motion
///       and scale act on them in the same way.
///   (4) Symmetric input gives a symmetric umbrella.
///   (5) No other umbrella with these spokes and b constant, a linear has a smaller sum.
/// Time is that of dense least squares: cubic in members times degree squared.
///
/// \throws std::invalid_argument as umbrellaVertex() does, and for spokes or members that are
/// rational, spokes of degree 0 or that do not begin at one point, numbers of kinds, members,
/// lambda and mu that do not match the spokes, values that are not finite, a degree that is too
/// low, and a nonzero mu where no member allows it.
/// Source: docs/theory/fills.md F1.1 to F1.8; [DuSchmitt1990]; [Peters1991].
Umbrella umbrellaAround(const std::vector<BezierCurve>& spokes,
                        const UmbrellaOptions& options = {});

struct UmbrellaInsideOptions {
  int spoke_degree = 3;  ///< 3 or more
  /// As in UmbrellaOptions; at least the degree of the sides.
  std::optional<int> degree = std::nullopt;
  double gap_mm = 1e-9;  ///< ends of sides within this distance count as one point
};

/// The umbrella inside a closed boundary. It has one member for each corner, and its spokes end in
/// the middles of the sides.
///
/// The tangents at O are an affine image of those of a regular polygon, so all sectors have the
/// same area: b = -1, and a falls linearly from 2 cos(2 pi / n) to 0. O, the tangents, and the rest
/// of the spokes and members are the fairest, by the energy of umbrellaAround() over all members at
/// once. The boundary stays up to rounding; there is no condition across it.
///
/// Member i has the corner between side i and side i + 1 at (u, v) = (1, 1).
/// \param sides polynomial curves, each beginning where the one before ends, of either sense; 3 to
/// 12.
/// \throws std::invalid_argument for a number of sides outside 3 to 12, sides that are rational or
/// not connected, a degree that is too low, and a boundary for which the tangents at O become
/// parallel.
/// Source: docs/theory/fills.md F1.8, F1.9; [Loop1994].
Umbrella umbrellaInside(const std::vector<BezierCurve>& sides,
                        const UmbrellaInsideOptions& options = {});

}  // namespace seamwright
