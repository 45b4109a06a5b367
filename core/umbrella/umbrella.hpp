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

/// A patch over [0, 1]^2 or a triangle over u = l0, v = l1; (0, 0) is the common point O.
using UmbrellaMember = std::variant<BezierPatch, BezierTriangle>;
enum class MemberKind { Tensor, Triangle };

/// Spoke i, an edge through O, is the edge v = 0 of member i (V0, or L1 of a triangle) and the edge
/// u = 0 of member i - 1 (U0, or L0 run backwards).
///
/// Across an inner spoke C, with U and V the derivatives of members i - 1 and i away from it:
/// V = a C' + b U, b < 0 (as ConnectionFunctions alpha = -b, beta = a). In Bernstein form; one
/// coefficient for a constant, none on a boundary spoke.
struct SpokeFunctions {
  Eigen::VectorXd a, b;
  /// Of a rational umbrella, with homogeneous coordinates: V = a C' + b U + e C. Else empty.
  Eigen::VectorXd e = {};
};

/// The outer boundary of a member; what is not given is free.
struct MemberBoundary {
  /// From the end of its first spoke: the edge u = 1, by v; of a triangle the edge to the end of
  /// its second spoke.
  std::optional<BezierCurve> from_first = std::nullopt;
  /// From the end of its second spoke: the edge v = 1, by u; none of a triangle.
  std::optional<BezierCurve> from_second = std::nullopt;
  /// The derivatives across these edges, by u and by v, as vectors in place of poles. Not of
  /// triangles, nor of rational umbrellas.
  std::optional<BezierCurve> across_first = std::nullopt, across_second = std::nullopt;
};

/// Of all members together; the time grows with the cube.
constexpr int most_umbrella_poles = 1600;

struct UmbrellaOptions {
  bool closed = true;
  /// Empty: the kinds of the given members, or all tensor products.
  std::vector<MemberKind> kinds = {};
  /// Members to be moved least, in the sum of squares; empty: the result is the fairest.
  std::vector<UmbrellaMember> members = {};
  /// One for each member, or empty: all boundaries are free. Given ones are kept; lambda and mu are
  /// then found.
  std::vector<MemberBoundary> boundary = {};
  /// Of all members in u and v; nothing: the lowest possible one, and not below given members.
  std::optional<int> degree = std::nullopt;
  /// a'(0) and b'(0) of each spoke; nothing: the best lambda, and mu = 0.
  std::optional<Eigen::VectorXd> lambda = std::nullopt, mu = std::nullopt;
  /// Second fundamental form at O, in 1/mm, whose curvatures the spokes get; nothing: their own.
  std::optional<Eigen::Matrix3d> form = std::nullopt;
  double gap_mm = 1e-9;  ///< starts of spokes within this distance of their mean count as one point
  VertexOptions vertex = {};
};

struct Umbrella {
  std::vector<UmbrellaMember> members;
  std::vector<BezierCurve> spokes;
  UmbrellaVertex vertex;
  std::vector<SpokeFunctions> functions;  ///< across each spoke
  double largest_spoke_move_mm = 0;       ///< of a pole of a spoke
  double largest_second_change = 0;       ///< |C''(0)|, in mm
  double largest_lambda_change = 0;       ///< of a given lambda
  double largest_member_move_mm = 0;      ///< of a pole of a given member
  Eigen::Index free_vectors = 0;          ///< number of free vectors in the poles
};

/// The lowest degree of members for a linear and b constant, see docs/umbrella.md.
int lowestUmbrellaDegree(const std::vector<MemberKind>& kinds, bool closed, int spoke_degree);

/// The umbrella around spokes; see docs/umbrella.md.
///
///     const Umbrella umbrella = umbrellaAround({spoke0, spoke1, spoke2, spoke3, spoke4});
///
/// \param spokes curves that begin at O, in their order around it. Member i follows spoke i; an
/// open fan has one member less. If a spoke, a boundary or a given member is rational, all are
/// built in homogeneous coordinates.
///
/// Spokes stay, except for their third poles in a closed fan of an even number of members or with a
/// given form, and for tangents near one plane, which are put into it.
/// lambda and the free poles make the members move least, or minimise the energy.
///
/// Identities (each has a test of its number):
///   (1) V = a C' + b U across every inner spoke, up to rounding of the largest term.
///   (2) Members that already are such an umbrella are returned the same.
///   (3) Another first spoke, or the reversed order, give the same members. Rigid motion and scale
///       act on them in the same way.
///   (4) Symmetric input gives a symmetric umbrella.
///   (5) No other umbrella with these spokes and b constant, a linear has a smaller sum.
///
///   (6) A given boundary, and derivatives across it, are kept, up to rounding.
///   (7) A projective map of an umbrella is one, and is returned the same.
///
/// \throws std::invalid_argument as umbrellaVertex() does, and for spokes of degree 0 or without a
/// common start, counts that do not match the spokes, values that are not finite, a degree that is
/// too low, and a nonzero mu where no member allows it; for boundaries that do not begin at the
/// ends of spokes, do not meet, or have no common tangent plane with the spoke there, with the
/// figure; for lambda or mu with a boundary or weights; and for resulting weights that are not
/// positive.
/// Source: docs/theory/fills.md F1.1 to F1.8, F1.13, F1.14; [DuSchmitt1990]; [Peters1991].
Umbrella umbrellaAround(const std::vector<BezierCurve>& spokes,
                        const UmbrellaOptions& options = {});

struct UmbrellaInsideOptions {
  int spoke_degree = 3;  ///< 3 or more
  /// As in UmbrellaOptions; at least the degree of the sides.
  std::optional<int> degree = std::nullopt;
  double gap_mm = 1e-9;  ///< ends of sides within this distance count as one point
};

/// The umbrella of least energy inside a closed boundary: one member for each corner, and spokes to
/// the middles of the sides. There is no condition across the boundary. Member i has the corner
/// between side i and side i + 1 at (u, v) = (1, 1).
/// \param sides 3 to 12 polynomial curves, each beginning where the one before ends.
/// \throws std::invalid_argument for another number of sides, sides that are rational or not
/// connected, a degree that is too low, and tangents at O that become parallel.
/// Source: docs/theory/fills.md F1.8, F1.9; [Loop1994].
Umbrella umbrellaInside(const std::vector<BezierCurve>& sides,
                        const UmbrellaInsideOptions& options = {});

}  // namespace seamwright
