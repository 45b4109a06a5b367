// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright {

/// The beta constraint: the joint of a curve a and a curve b is G^n iff there are beta_1 > 0,
/// beta_2, .., beta_n with b_k = sum_j B_kj(beta) a_j for the derivatives of orders k = 0..n. The
/// matrix is (n+1) by (n+1) and lower triangular. See docs/curve_joins.md.
///
///     const BezierCurve joined = joinedCurve(a, b, {.beta = Eigen::Vector2d(1.2, -0.5)});  // G2
///
/// Identities (each has a test of its number):
///   (1) betaMatrix(composed(b, c)) = betaMatrix(b) betaMatrix(c).
///   (2) betaMatrix(inverse(b)) is the inverse matrix: the sides exchange their roles.
///   (3) Curves reversed and exchanged: reversed(b)_k = (-1)^(k+1) inverse(b)_k.
///   (4) beta = (1, 0, .., 0): the unit matrix, C^n.
/// \throws std::invalid_argument, with index and value, for numbers that are not finite, beta_1 <=
/// 0, more than 30 betas, different numbers of betas, or a result out of range.
/// Source: docs/theory/curves.md C2.1, C2.2; [BarskyDeRose1989].
Eigen::MatrixXd betaMatrix(const Eigen::VectorXd& beta);
Eigen::VectorXd composedBeta(const Eigen::VectorXd& beta, const Eigen::VectorXd& first);
Eigen::VectorXd inverseBeta(const Eigen::VectorXd& beta);
Eigen::VectorXd reversedBeta(const Eigen::VectorXd& beta);

/// The betas that fit best, order by order.
struct BetaFit {
  /// Empty if beta_1 <= 0 or a tangent is undefined.
  Eigen::VectorXd beta;
  /// |c_k of b - c_k of a| L^(k-1), k = 0..n, of the derivatives by arc length; only k = 0 if a
  /// curve has no tangent, or a c_k exceeds the range of a double.
  std::vector<double> defects;
  /// Proven bounds of the defects, for exact poles and L. lower[k] > 0: the joint is not G^k.
  std::vector<double> lower, upper;
  double length_mm = 0;  ///< L
};

/// Measures a joint; beta_k by projection of row k on a's tangent.
/// \param length_mm L; nothing: the smaller chord of curves that are not closed (ends within 1e-12
/// of the size), or else the smaller diagonal of the boxes of the poles.
///
/// Identities (each has a test of its number):
///   (5) Rigid motion, scale (of L too), reparametrisation and degree elevation change nothing.
///   (6) For a curve that nextPoles() built with beta, the fit returns beta.
///   (7) defects[k] = differences[k] L^(k-1), with the differences of measureJoint().
/// \throws std::invalid_argument for an order outside 0..30, a length that is not positive, or end
/// points out of range.
/// Source: docs/theory/curves.md C2.5 to C2.7.
BetaFit fitBeta(const BezierCurve& a, const BezierCurve& b, int order,
                std::optional<double> length_mm = std::nullopt);

/// The rule by which b continues a.
struct CurveJoinRule {
  Eigen::VectorXd
      beta;           ///< beta_1..beta_n by the common parameter; n is the order; (1, 0, ..) is C^n
  double length = 1;  ///< length of a in the common parameter
  double next_length = 1;  ///< length of b in the common parameter
  /// e_0 > 0, e_1, .., e_n: the factor between the homogeneous curves and its derivatives; empty:
  /// 1, 0, .., 0.
  Eigen::VectorXd scale;
};

/// The first n + 1 homogeneous poles of a curve of that degree that continues \p a by \p rule; the
/// others are free. The first is e_0 times the last pole of a, bitwise if e_0 = 1.
///   (8) For n = 2 and unit lengths the formulas of docs/curve_joins.md ("Building").
/// \throws std::invalid_argument as betaMatrix(), for a degree outside n..100, lengths that are not
/// positive, a scale of another size or with e_0 <= 0, an undefined tangent of a, and a resulting
/// weight that is not positive (index and value).
/// Source: docs/theory/curves.md C2.4, C3.1, C3.2.
HomogeneousPoles nextPoles(const BezierCurve& a, int degree, const CurveJoinRule& rule);

/// \p b with its first n + 1 homogeneous poles replaced by nextPoles(); the others stay bitwise. b
/// is raised before: to degree 2n + 1 if its end is to stay up to order n, otherwise to degree n.
///   (9) fitBeta() returns beta_k next_length^k / length, which is beta for unit lengths. For C^n
///       the derivatives by the common parameter are equal.
/// \throws as nextPoles().
/// Source: docs/theory/curves.md C3.3.
BezierCurve joinedCurve(const BezierCurve& a, const BezierCurve& b, const CurveJoinRule& rule,
                        bool keep_end = true);

/// The curve of degree n + m + 1 from the end of \p a to the beginning of \p b that joins a with
/// G^n and b with G^m. \p beta_end maps derivatives of the bridge to those of b.
/// \throws std::invalid_argument for a rational curve (with weights), otherwise as nextPoles().
/// Source: docs/theory/curves.md C3.3.
BezierCurve bridgeCurve(const BezierCurve& a, const BezierCurve& b, const Eigen::VectorXd& beta,
                        const Eigen::VectorXd& beta_end);

}  // namespace seamwright
