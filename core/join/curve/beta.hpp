// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <seamwright/core/bezier/curve.hpp>
#include <seamwright/core/seam/curve_joint.hpp>

namespace seamwright {

/// The beta constraint: a curve a arrives, a curve b leaves, and the joint is G^n iff there are
/// beta_1 > 0, beta_2, .., beta_n with b_k = sum_j B_kj(beta) a_j for the derivatives of orders k =
/// 0..n; beta_k is the k-th derivative of a's parameter by b's. Betas are given as a vector, beta_1
/// first.
///
/// The matrix: (n+1) by (n+1), lower triangular, B_00 = 1, partial Bell polynomials
/// B_kj = sum_i C(k-1, i-1) beta_i B_{k-i, j-1}.
/// Identities (each has a test of its number):
///   (1) betaMatrix(composed(b, c)) = betaMatrix(b) betaMatrix(c): c is applied first.
///   (2) betaMatrix(inverse(b)) is the inverse matrix: the sides' roles exchanged.
///   (3) Both curves run backwards and exchanged: reversed(b)_k = (-1)^(k+1) inverse(b)_k.
///   (4) beta = (1, 0, .., 0): the unit matrix, C^n.
/// \throws std::invalid_argument for numbers not finite, beta_1 <= 0, more than 30 betas, different
/// numbers of betas, or a result beyond the range of a double; with index and value.
/// Source: docs/theory/curves.md C2.1, C2.2 (also the opposite convention); [BarskyDeRose1989].
Eigen::MatrixXd betaMatrix(const Eigen::VectorXd& beta);
Eigen::VectorXd composedBeta(const Eigen::VectorXd& beta, const Eigen::VectorXd& first);
Eigen::VectorXd inverseBeta(const Eigen::VectorXd& beta);
Eigen::VectorXd reversedBeta(const Eigen::VectorXd& beta);

/// The betas that fit best, order by order, and what they leave.
struct BetaFit {
  Eigen::VectorXd beta;  ///< beta_1 .. beta_n; none where beta_1 <= 0 or a tangent is lost
  /// defects[k], k = 0..n, without unit: |c_k of b - c_k of a| L^(k-1) with c_k the derivatives by
  /// arc length (k = 0: the gap by L). 0 to rounding for all k <= n iff the joint is G^n. The gap
  /// alone where a tangent is lost or a c_k is beyond the range of a double.
  std::vector<double> defects;
  /// Certain bounds of the defects, rounding of evaluation included, the homogeneous poles and L
  /// being exact; as many as defects. Where lower > 0 the joint is proved not to be G^k.
  std::vector<double> lower, upper;
  double length_mm = 0;  ///< L
};

/// Measures by the beta constraint: beta_k is the projection of row k on a's tangent, by the
/// parameters of the curves. The bounds come of running error analysis: the speed v from
/// (v^2)^(m) = (X' . X')^(m), then c from the equations X^(k) = sum_j B_kj(v, v', ..) c_j.
/// \param length_mm L. Nothing: the smaller distance of the end points of the two curves; a closed
/// curve, whose end points are within 1e-12 of its size, does not count, and for two of them it is
/// the diagonal of the smaller box of poles. Identities (each has a test of its number):
///   (5) Invariant under rigid motion, scale (L with it), reparametrisation of either side,
///       elevation.
///   (6) Built with beta by nextPoles(), the fit returns beta.
///   (7) defects against measureJoint(): differences[k] L^(k-1).
/// \throws std::invalid_argument for an order outside 0..30, a length that is not positive (all
/// poles are one point), or end points beyond the range of a double.
/// Source: docs/theory/curves.md C2.5 to C2.7.
BetaFit fitBeta(const BezierCurve& a, const BezierCurve& b, int order,
                std::optional<double> length_mm = std::nullopt);

/// How b goes on where a ends.
struct CurveJoinRule {
  Eigen::VectorXd
      beta;           ///< beta_1..beta_n by the common parameter; n is the order. (1, 0, ..): C^n
  double length = 1;  ///< of a in the common parameter
  double next_length = 1;  ///< of b
  /// Value and derivatives e_0 > 0, e_1, .. e_n by the common parameter of the factor between the
  /// homogeneous curves: H_b^(k) = sum_j C(k,j) e_{k-j} (B(beta) H_a)_j. Empty: 1, 0, .., 0. It
  /// changes weights and poles, not the order.
  Eigen::VectorXd scale;
};

/// The first n + 1 homogeneous poles of the curve of degree \p degree that follows \p a by that
/// rule; its others are free. The first one is e_0 times a's last, bit by bit for e_0 = 1.
///   (8) Explicit for n = 2 and unit lengths: Q_1 = Q_0 + (m/m') beta_1 (P_m - P_{m-1}), Q_2 = 2
///       Q_1 - Q_0 + (m (m-1) beta_1^2 (P_m - 2 P_{m-1} + P_{m-2}) + m beta_2 (P_m - P_{m-1})) /
///       (m' (m'-1)).
/// \throws std::invalid_argument for a degree below n or above 100, betas as betaMatrix(), lengths
/// not positive, a scale of another number than n + 1 or with e_0 <= 0, a without tangent at its
/// end, and a weight that comes out not positive (index and value): a smaller next_length or
/// smaller e_1, e_2, .. help.
/// Source: docs/theory/curves.md C2.4, C3.1, C3.2.
HomogeneousPoles nextPoles(const BezierCurve& a, int degree, const CurveJoinRule& rule);

/// \p b with its first n + 1 homogeneous poles replaced by nextPoles(); elevated first to degree 2n
/// + 1 if
/// \p keep_end, so that its own end stays as it is to order n, else to n if need be. Poles that
/// stay, stay bit by bit.
///   (9) fitBeta() returns beta_k next_length^k / length, which is beta for unit lengths; C^n
///       equals derivatives by the common parameter.
/// \throws as nextPoles().
/// Source: docs/theory/curves.md C3.3.
BezierCurve joinedCurve(const BezierCurve& a, const BezierCurve& b, const CurveJoinRule& rule,
                        bool keep_end = true);

/// The curve of degree n + m + 1 between the end of \p a and the beginning of \p b that joins the
/// one G^n, the other G^m: beta_1..beta_n for the joint with a, beta_end_1..beta_end_m for the
/// joint with b (b's derivatives are those of the bridge by betaMatrix(beta_end)). Its end is
/// nextPoles() of b backwards, with reversedBeta(beta_end).
/// \throws std::invalid_argument for a rational curve (the first weights that differ), else as
/// nextPoles().
/// Source: docs/theory/curves.md C3.3.
BezierCurve bridgeCurve(const BezierCurve& a, const BezierCurve& b, const Eigen::VectorXd& beta,
                        const Eigen::VectorXd& beta_end);

}  // namespace seamwright
