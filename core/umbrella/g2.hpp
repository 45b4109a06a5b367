// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/umbrella/vertex.hpp>

namespace seamwright {

/// Across an inner spoke C, with U and V the first and U2 and V2 the second derivatives of members
/// i - 1 and i away from it: V = a C' + b U, V2 = b^2 U2 + 2 a b U' + a^2 C'' + p U + q C'. In
/// Bernstein form: b and p constant, a and q linear; none on a boundary spoke. As
/// ConnectionFunctions: alpha = -b, beta = a, p = -p, q = q.
struct G2SpokeFunctions {
  Eigen::VectorXd a, b, p, q;
};

struct G2UmbrellaOptions {
  bool closed = true;
  /// Members to be moved least, in the sum of squares; empty: the result is the fairest.
  std::vector<BezierPatch> members = {};
  /// Of all members in u and v; nothing: the lowest, that of the spokes, 3 or more.
  std::optional<int> degree = std::nullopt;
  /// Second fundamental form at O, in 1/mm; nothing: secondForm() of the spokes.
  std::optional<Eigen::Matrix3d> form = std::nullopt;
  double gap_mm = 1e-9;  ///< starts of spokes within this distance of their mean count as one point
  VertexOptions vertex = {};
};

struct G2Umbrella {
  std::vector<BezierPatch> members;
  std::vector<BezierCurve> spokes;
  UmbrellaVertex vertex;
  std::vector<G2SpokeFunctions> functions;  ///< across each spoke
  Eigen::Matrix3d form;  ///< second fundamental form of all members at O, in 1/mm
  /// Condition of the equations of the third derivatives at O, see docs/umbrella.md.
  double third_order_condition = 1;
  double largest_spoke_move_mm = 0;   ///< of a pole of a spoke
  double largest_second_change = 0;   ///< |C''(0)|, in mm
  double largest_third_change = 0;    ///< |C'''(0)|, in mm
  double largest_member_move_mm = 0;  ///< of a pole of a given member
  Eigen::Index free_vectors = 0;      ///< number of free vectors in the poles
};

/// The umbrella of patches around spokes that join G2 across every spoke, along its whole length.
///
///     const G2Umbrella umbrella = g2Umbrella({spoke0, spoke1, spoke2, spoke3, spoke4});
///
/// \param spokes polynomial curves that begin at O, in their order around it. Member i has spoke i
/// as its edge v = 0 and spoke i + 1 as its edge u = 0; an open fan has one member less.
///
/// Spokes stay, except for changes that G2 requires, each the least:
///   - tangents near one plane are put into it;
///   - second derivatives along N, so that one second fundamental form has all curvatures. None for
///     3 spokes along 3 lines. At a regular vertex also in the tangent plane, so that opposite
///     spokes continue each other to second order;
///   - third derivatives along N, in the rare fans in which the equations of the third derivatives
///     are singular and contradict each other.
/// Members have the degree of the spokes, 3 or more. The slopes of q and the free poles make the
/// members move least, or minimise the energy.
///
/// Identities (each has a test of its number):
///   (1) Both equations hold across every inner spoke, up to rounding of the largest term, and all
///       members have the form at O.
///   (2) Members that already are such an umbrella are returned the same.
///   (3) Another first spoke, or the reversed order, give the same members. Rigid motion and scale
///       act on them in the same way.
///   (4) Spokes of a paraboloid above straight rays of equal steps give the paraboloid.
///
/// \throws std::invalid_argument as umbrellaAround() does, and for a fan so near to a singular one
/// that the equations cannot be solved; the message has the condition and the defect. So are fans
/// with sectors so narrow that rounding leaves an angle of more than 1e-6 rad between members.
/// Source: docs/theory/fills.md F1.10 to F1.12; [Hahn1989]; [HermannPetersStrotman2012].
G2Umbrella g2Umbrella(const std::vector<BezierCurve>& spokes,
                      const G2UmbrellaOptions& options = {});

}  // namespace seamwright
