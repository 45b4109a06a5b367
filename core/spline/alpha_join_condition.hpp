// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include <seamwright/core/spline/alpha_surface.hpp>

namespace seamwright {

/// Which alpha-surfaces Y(u, v) can go on at u = 1 of a given one X, by the shapes c = next_a_v, a
/// = a_v along the seam. Shapes across it are free (1e-6 to 1).
///
/// **Curves of two shapes.** The quintics of shape a, poles X_0..X_3, are the Bernstein
/// coefficients q_0..q_5 with
///   (i) q_2 = q_3   and   (ii) q_1 + q_4 - (1 - a) (q_0 + q_5) - a (q_2 + q_3) = 0.
/// For X the left side of (ii), with c in the place of a, is (a - c) (X_1 + X_2 - X_0 - X_3). So
/// for c != a a curve has both shapes iff X_0 + X_3 = X_1 + X_2, "balanced".
///
/// **C^0, C^1, C^2.** The row of Y^(k) along the seam is X^(k)'s, a combination of the net's rows 3
/// .. 3 - k with a factor other than 0 at the last. So for c = a every net has joins of every
/// order. For c != a it has a C^n one iff its rows 3 .. 3 - n are balanced; general nets have not
/// even C^0. The same holds for G^n in proportional form: Y_u = beta1 X_u, Y_uu = beta1^2 X_uu +
/// beta2 X_u with constants (alphaJoinRows()).
///
/// **G^1.** Y_u = alpha(v) X_u + beta(v) X_v, alpha > 0. Where X_u x X_v has degree 9 and no zero,
/// complex ones among them, and X_v degree 4 - as for general nets - alpha is constant and beta
/// linear: a denominator of both would vanish where X_u x X_v does, and alpha X_u x X_v = Y_u x X_v
/// has degree 9. Then (i) and (ii) say which: six linear equations for alpha, beta(0), beta(1),
/// whose solutions are the family below. With A, B, 0, C, D the coefficients of X_v, (i) is beta(1)
/// B = beta(0) C. So where B and C are not parallel beta is 0, and for c != a the row 2 has to be
/// balanced too. On a straight boundary there may be more, and on some curved ones: for c = a with
/// a = 2/3 and B = -C = (A - D) / 4, beta(1) = -beta(0); with a = 4/5, C = 0, B = (A - D) / 4,
/// beta(1) = 0, or run backwards; with a = 1 and B = C = -(A + D) / 4, beta constant.
///
/// Identities (each has a test of its number):
///   (1) For c = a: any net, order 2. For c != a: order n iff the rows 3 .. 3 - n are balanced.
///   (2) What the condition allows alphaJoinRows() builds, what it forbids that refuses.
///   (3) A general net has a family of dimension 1 for c = a, alpha alone, and of dimension 0 for c
///       != a.
///   (4) The three curved boundaries above have dimension 2.
/// Source: docs/theory/curves.md C9.2 to C9.4.
struct AlphaSeamCondition {
  bool any_net = false;  ///< the shapes along the seam are the same
  /// |P_i0 + P_i3 - P_i1 - P_i2| of the rows i = 3, 2, 1, and what counts as rounding of it.
  std::array<double, 3> defects_mm{};
  double noise_mm = 0;
  int order = -1;  ///< largest n <= 2 for which C^n and proportional G^n joins exist; -1: the edges
                   ///< cannot even meet
  /// (alpha, beta(0), beta(1)) of Y_u = alpha X_u + beta X_v, a basis of all that give an
  /// alpha-surface; 3 by
  /// 0..3.
  Eigen::Matrix3Xd first_rows = Eigen::Matrix3Xd(3, 0);
  /// Singular values of the six equations, of X_u and X_v divided by their sizes, descending; up to
  /// rank_noise is 0.
  Eigen::Vector3d singular = Eigen::Vector3d::Zero();
  double rank_noise = 0;
  bool g1 = false;  ///< the edges can meet, and some member of the family has alpha > 0
};

/// \throws std::invalid_argument for poles not finite, shapes outside 1e-6 to 1, rows 2 and 3 the
/// same, or a row 3 that is one point.
AlphaSeamCondition alphaSeamCondition(const AlphaSurface& given, double next_a_v);

/// The rows Q_0j, Q_1j of the next net for Y_u = alpha X_u + beta X_v, beta(v) = (1 - v) beta0 + v
/// beta1: eight poles.
///   (5) They hold that equation at every v, for all members of the family.
/// \throws std::invalid_argument for arguments as above, alpha <= 0, and functions outside the
/// family, with the defect.
Poles alphaSlidingRows(const AlphaSurface& given, double next_a_u, double next_a_v, double alpha,
                       double beta0, double beta1);

/// The given surface with the nearest rows 3 .. 3 - order that are balanced: X_1, X_2 move by a
/// quarter of the defect, X_0, X_3 by as much against it. \param order 0 to 2.
///   (6) No balanced rows are nearer in the sum of squares.
/// Source: docs/theory/curves.md C9.2.
AlphaSurface alphaBalanced(const AlphaSurface& given, int order);

/// How two alpha-surfaces meet, a at u = 1 and b at u = 0, in proportional form: the largest
/// Bernstein coefficient of what is left of each equation, so a bound of it at every v.
struct AlphaSeamFit {
  double gap_mm = 0;            ///< of the edges at the same v
  double beta1 = 0, beta2 = 0;  ///< that fit best
  double first = 0,
         second =
             0;  ///< |Y' - beta1 X'| by |Y'|; |Y'' - beta1^2 X'' - beta2 X'| by the largest term
  double c_first = 0, c_second = 0;  ///< the same for beta1 = 1, beta2 = 0
  std::array<double, 3> noise{};     ///< what counts as rounding of the gap, first and second
  int parametric_order = -1;         ///< C^n, n <= 2; -1: the edges do not meet
  int geometric_order = -1;  ///< G^n in proportional form, n <= 2; joins that slide are not seen
};

/// \param length, next_length of u in the common parameter.
/// \throws std::invalid_argument as alphaSeamCondition(), for a length out of range, and for a
/// result beyond the range of a double.
///   (7) Surfaces of alphaJoinRows() have its order and betas; a pole moved by 1e-6 of the size
///       ends the order of its row.
/// Source: docs/theory/curves.md C9.5.
AlphaSeamFit alphaSeamFit(const AlphaSurface& a, const AlphaSurface& b, double length = 1,
                          double next_length = 1);

struct AlphaNearestOptions {
  int order = 1;            ///< 0, 1 or 2
  bool parametric = false;  ///< C^order; else G^order, beta1 and beta2 found
  double length = 1, next_length = 1;
};

struct AlphaNearest {
  AlphaSurface given, next;
  double beta1 = 1, beta2 = 0;
  /// Sums of squared moves, mm^2; 0 or infinite where that is beyond the range of a double.
  double cost_given = 0, cost_next = 0;
};

/// The nearest proportional join: the given surface moves only where no join exists as it is
/// (alphaBalanced()), then the rows of the next one move as little as can be, over all beta1 > 0
/// and beta2.
///
/// In the sum of squares. beta2 is linear; what is left is a polynomial of degree 4 in beta1 with
/// one minimum at most at beta1 > 0, where it may be dearer than next to beta1 = 0.
///   (8) No beta1, beta2 near by cost less, nor any other of a search, nor those next to beta1 = 0.
/// \returns nothing where joins next to beta1 = 0, which have lost the tangent, cost less than all
/// others: as a rule the next surface runs backwards.
/// \throws std::invalid_argument as alphaSeamCondition(), for an order or length out of range, and
/// for betas or poles of the join beyond the range of a double.
/// Source: docs/theory/curves.md C9.5.
std::optional<AlphaNearest> alphaNearestJoin(const AlphaSurface& given, const AlphaSurface& next,
                                             const AlphaNearestOptions& options = {});

}  // namespace seamwright
