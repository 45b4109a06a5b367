// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include <seamwright/core/spline/alpha_surface.hpp>

namespace seamwright {

/// The condition for an alpha-surface Y(u, v) that continues a given one X at u = 1. It depends on
/// the shapes along the seam, a = a_v of X and c = next_a_v of Y. See docs/alpha_curves.md.
///
/// A row X_0..X_3 is balanced iff X_0 + X_3 = X_1 + X_2. Joins have proportional form if Y_u =
/// beta1 X_u, Y_uu = beta1^2 X_uu + beta2 X_u with constants. The family are the G^1 joins Y_u =
/// alpha X_u + beta X_v with alpha constant and beta linear.
///
///     const AlphaSeamCondition condition = alphaSeamCondition(given, 0.9);
///     if (condition.order < 1) given = alphaBalanced(given, 1);
///
/// Identities (each has a test of its number):
///   (1) For c = a any net has order 2, for c != a order n iff its rows 3 .. 3 - n are balanced.
///   (2) alphaJoinRows() builds the joins that the condition allows and refuses the others.
///   (3) The family of a general net has dimension 1 for c = a (alpha alone), else 0.
///   (4) The three curved boundaries of C9.4 that allow beta != 0 have dimension 2.
/// Source: docs/theory/curves.md C9.2 to C9.4.
struct AlphaSeamCondition {
  bool any_net = false;  ///< the shapes along the seam are the same
  /// |P_i0 + P_i3 - P_i1 - P_i2| of the rows i = 3, 2, 1; up to noise_mm it counts as rounding.
  std::array<double, 3> defects_mm{};
  double noise_mm = 0;
  /// Largest n <= 2 with C^n and proportional G^n joins; -1: the edges cannot meet.
  int order = -1;
  /// A basis of all (alpha, beta(0), beta(1)) of the family; 3 by 0..3.
  Eigen::Matrix3Xd first_rows = Eigen::Matrix3Xd(3, 0);
  /// Of the six equations, without unit, descending; up to rank_noise they count as 0.
  Eigen::Vector3d singular = Eigen::Vector3d::Zero();
  double rank_noise = 0;
  bool g1 = false;  ///< the edges can meet, and some member of the family has alpha > 0
};

/// \throws std::invalid_argument for poles that are not finite, shapes outside 1e-6 to 1, equal
/// rows 2 and 3, or a row 3 that is one point.
AlphaSeamCondition alphaSeamCondition(const AlphaSurface& given, double next_a_v);

/// The rows Q_0j, Q_1j of the next net for Y_u = alpha X_u + beta X_v, beta(v) = (1 - v) beta0 + v
/// beta1.
///   (5) The rows satisfy that equation at every v, for all members of the family.
/// \throws std::invalid_argument as alphaSeamCondition(), for alpha <= 0, and for functions outside
/// the family, with the defect.
Poles alphaSlidingRows(const AlphaSurface& given, double next_a_u, double next_a_v, double alpha,
                       double beta0, double beta1);

/// The given surface with balanced rows 3 .. 3 - order, order 0 to 2.
///   (6) No other balanced rows are nearer in the sum of squares.
/// Source: docs/theory/curves.md C9.2.
AlphaSurface alphaBalanced(const AlphaSurface& given, int order);

/// How two alpha-surfaces meet, a at u = 1 and b at u = 0. Figures bound residuals at every v.
struct AlphaSeamFit {
  double gap_mm = 0;            ///< of the edges at the same v
  double beta1 = 0, beta2 = 0;  ///< the betas that fit best
  /// Relative residuals of Y' and Y''.
  double first = 0, second = 0;
  double c_first = 0, c_second = 0;  ///< the same for beta1 = 1, beta2 = 0
  /// Up to these, gap, first and second count as rounding.
  std::array<double, 3> noise{};
  int parametric_order = -1;  ///< C^n, n <= 2; -1: the edges do not meet
  /// G^n in proportional form, n <= 2.
  int geometric_order = -1;
};

/// \param length, next_length lengths of u in the common parameter.
/// \throws std::invalid_argument as alphaSeamCondition(), and for a length or result out of range.
///   (7) Surfaces of alphaJoinRows() have its order and betas; a pole moved by 1e-6 of the size
///       loses the order of its row.
/// Source: docs/theory/curves.md C9.5.
AlphaSeamFit alphaSeamFit(const AlphaSurface& a, const AlphaSurface& b, double length = 1,
                          double next_length = 1);

struct AlphaNearestOptions {
  int order = 1;            ///< 0, 1 or 2
  bool parametric = false;  ///< true: C^order; false: G^order, with beta1 and beta2 found
  double length = 1, next_length = 1;
};

struct AlphaNearest {
  AlphaSurface given, next;
  double beta1 = 1, beta2 = 0;
  /// Sums of squared moves, in mm^2; may underflow to 0 or be infinite.
  double cost_given = 0, cost_next = 0;
};

/// The nearest proportional join in the sum of squared moves, over all beta1 > 0 and beta2. The
/// given surface moves only by alphaBalanced().
///   (8) No beta1, beta2 of a search, nearby, over a range and near beta1 = 0, cost less.
/// \returns nothing if joins near beta1 = 0 cost less than all others.
/// \throws std::invalid_argument as alphaSeamFit(), and for an order out of range.
/// Source: docs/theory/curves.md C9.5.
std::optional<AlphaNearest> alphaNearestJoin(const AlphaSurface& given, const AlphaSurface& next,
                                             const AlphaNearestOptions& options = {});

}  // namespace seamwright
