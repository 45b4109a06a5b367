// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <seamwright/core/bezier/patch.hpp>

namespace seamwright {

/// A tensor product of alpha-curves: X(u, v) = sum_ij P_ij b_i(u; a_u) b_j(v; a_v) on [0, 1]^2,
/// with the basis
///   b_0 = (1-t)^5 + 5 (1-a) (1-t)^4 t,      b_1 = 5 a (1-t)^4 t + 5 (1-t)^2 t^2,
///   b_2 = 5 (1-t)^2 t^2 + 5 a (1-t) t^4,    b_3 = 5 (1-a) (1-t) t^4 + t^5.
struct AlphaSurface {
  using Net = Eigen::Matrix<double, 16, 3, Eigen::RowMajor>;

  Net poles = Net::Zero();  ///< row 4 i + j is P_ij
  double a_u = 1, a_v = 1;  ///< shape, 0..1
};

/// The same surface as a Bézier patch of degrees 5, 5. It is exact, because the basis is quintic.
/// \throws std::invalid_argument for a pole that is not finite, or a shape outside [0, 1].
/// Source: docs/theory/curves.md C8.1, C9.1.
BezierPatch alphaSurfacePatch(const AlphaSurface& surface);

/// The rule by which the next alpha-surface continues a given one at u = 1.
struct AlphaJoin {
  int order = 1;  ///< 1, 2 or 3
  /// 1 and 0 for C^1 and C^2. With order 3 beta2 is determined and not read.
  double beta1 = 1, beta2 = 0;
  double length = 1;       ///< length of the given surface's u in the common parameter
  double next_length = 1;  ///< length of the next surface's u
  double next_a_u = 1, next_a_v = 1;
};

/// The rows Q_0j, Q_1j and, for order 2 or 3, Q_2j of the next surface's net, four poles per row.
/// The other rows are free.
///
/// Let R be the position and h, k the lengths of the two surfaces. The derivatives by the common
/// parameter satisfy, at every v:
///   order 1  R'(+) = beta1 R'(-)
///   order 2  also R''(+) = beta1^2 R''(-) + beta2 R'(-)
///   order 3  also R'''(+) = beta1^3 R'''(-) + 3 beta1 beta2 R''(-) + beta3 R'(-),
///            with beta2 = -2 beta1 (beta1 / h + 1 / k) and
///            beta3 = 12 beta1^2 / h (beta1 / h + 1 / k), the only possible values
/// So the surfaces are C^n for beta1 = 1, beta2 = 0, and G^n for any beta1 > 0. For general nets no
/// other G1 join of alpha-surfaces exists. On special boundaries there are more
/// (alpha_join_condition.hpp). tensorRows() builds the other joins of the Bézier patches.
///
/// a_v may differ from next_a_v only if every resulting row has Q_i0 + Q_i3 = Q_i1 + Q_i2. Then the
/// curve of the row stays the same when the inner poles move in the ratio a_v / next_a_v.
/// \throws std::invalid_argument for an order, a length, beta1 or a shape out of range (shapes of a
/// join are 1e-6 to 1); for a given surface whose last two rows are the same; for a_v different
/// from next_a_v if a row does not allow it, with its defect in mm; and for resulting poles beyond
/// the range of a double (index and value).
/// Source: docs/theory/curves.md C8.4, C8.5, C9.2 to C9.4.
Poles alphaJoinRows(const AlphaSurface& given, const AlphaJoin& join);

}  // namespace seamwright
