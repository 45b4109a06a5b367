// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace seamwright {

/// Conditions of a G^n joint as ratios of a polygon.
///
/// A curve of degree m arrives with the poles P_(-m) .. P_0, a curve of degree m' leaves with P_0
/// .. P_(m'). The joint is G^n with these betas iff sum_j g_kj P_j = 0 for k = 1..n, j = -k..k. The
/// auxiliary points T_k0 .. T_kk of level k = 0..n are T_00 = P_0, T_k0 = P_(-k), T_kk = P_k and
///
///     T_kj = (1 - delta_kj) T_(k+1)j + delta_kj T_(k+1)(j+1),   k = 0..n-1, j = 0..k
///
/// The ratios delta depend on the betas and the degrees only. Points T_n0 .. T_nn are free: cutting
/// down from any of them results in poles of a joint that is G^n.
///
/// Poles of all functions here are rows -n..n, 2n + 1 of them, with any number of columns. Rational
/// curves have homogeneous poles: the joint then meets C2.4 with the factor e = (1, 0, .., 0).
/// Source: docs/theory/curves.md C11.3 to C11.5.

/// Why a step of the construction has no result, or none that keeps digits.
struct BalanceFault {
  enum class Kind {
    NoRatio,   ///< a ratio has a denominator that is (almost) 0; value: share of the largest g
    FarPoint,  ///< a ratio is (almost) 0 or 1, or huge: an auxiliary point is (almost) infinitely
               ///< far; value: the ratio
    LostTangent,   ///< the poles beside the joint coincide; value: their distance as a share
    NegativeBeta,  ///< beta_1 is not positive; value: beta_1
    Weights,       ///< homogeneous poles of a frame miss a relation by value, a share of its terms;
                   ///< or a blended weight is value, which is not positive
  };
  Kind kind = Kind::NoRatio;
  int level = 0;  ///< k of delta_kj
  int index = 0;  ///< j of delta_kj
  double value = 0;

  bool operator==(const BalanceFault&) const = default;
};

/// What counts as almost.
struct BalanceGuards {
  double least_pivot = 1e-9;  ///< |A| / max |g_k| of a denominator A is above
  double least_ratio = 1e-6;  ///< |delta| and |1 - delta| are above
  double most_ratio = 1e6;    ///< |delta| is below
  /// \throws std::invalid_argument, with the value, unless they are positive, and the ratio's
  /// bounds around 1.
  void validate() const;
};

/// g_kj, n by (2n + 1): row k - 1, column n + j. Entries with |j| > k are 0.
///   (1) Each row adds up to 0.
///   (2) g times the poles of a joint with these betas is 0.
/// \throws std::invalid_argument as betaMatrix(), for no betas, and for a degree below their number
/// or above 100.
Eigen::MatrixXd balanceRelations(const Eigen::VectorXd& beta, int degree_a, int degree_b);

/// The ratios of betas and degrees.
struct BalanceRatios {
  Eigen::MatrixXd delta;  ///< n by n, lower triangular: delta(k, j)
  /// NoRatio and NegativeBeta end the computation: the entries from there on are 0. FarPoint does
  /// not: points can be cut down with such a ratio, but not be found from poles.
  std::vector<BalanceFault> faults;
  /// Row K's denominators, the smallest |A| / max |g_K|: the distance to NoRatio.
  double least_pivot = 0;

  bool canCut() const;  ///< all ratios exist
  bool canSolve() const { return faults.empty(); }
};

/// Level by level from the relations; O(n^3).
///   (3) delta_00 = m' / (m' + m beta_1).
///   (4) For n = 2, with M = m (m-1) beta_1^2, N = m' (m'-1), q = m beta_2, E = N - M - q:
///       delta_10 = (M + q + E (1 - delta_00)) / (2 M + q + E (1 - delta_00)),
///       delta_11 = N / (2 N - E delta_00).
///   (5) Curves reversed and exchanged, with reversedBeta(): delta~_kj = 1 - delta_k(k-j).
///   (6) If both degrees grow without bound, all ratios tend into (0, 1).
/// \throws std::invalid_argument for betas that are not finite, no betas, and degrees as above; for
/// invalid guards. beta_1 <= 0 is a fault.
BalanceRatios balanceRatios(const Eigen::VectorXd& beta, int degree_a, int degree_b,
                            const BalanceGuards& guards = {});

/// T_n0 .. T_nn, n + 1 rows.
struct AuxiliaryPoints {
  Eigen::MatrixXd points;
  /// The largest distance by which a point of a level misses what the next level gives: the joint's
  /// own defect, in the unit of the poles.
  double residual = 0;
};

/// The auxiliary points of a joint. Level k has k equations for k - 1 unknown points; they are
/// solved by least squares, so that both sides count alike.
/// \pre ratios.canSolve()
/// \throws std::invalid_argument if the poles are not 2n + 1 rows or not finite, or the ratios have
/// faults.
AuxiliaryPoints auxiliaryPoints(const BalanceRatios& ratios,
                                const Eigen::Ref<const Eigen::MatrixXd>& poles);

/// The poles -n..n that these points are cut down to.
///   (7) auxiliaryPoints() of a joint that is G^n, and back, is the identity.
///   (8) The poles meet balanceRelations() of the ratios' betas.
/// \throws std::invalid_argument if there are not n + 1 points, or a ratio is missing.
Eigen::MatrixXd balancedPoles(const BalanceRatios& ratios,
                              const Eigen::Ref<const Eigen::MatrixXd>& points);

}  // namespace seamwright
