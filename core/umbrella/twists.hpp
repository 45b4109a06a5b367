// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/core/umbrella/vertex.hpp>

namespace seamwright {

/// The second order of the spokes and of their connections at O, one entry for each spoke. Entries
/// of boundary spokes are ignored.
///
/// Let V be the cross-boundary derivative of member i and U that of member i - 1, both into the
/// member. Across spoke i:
///   V = a C' + b U,   a(0) = alpha_i, a'(0) = lambda_i, b(0) = beta_i, b'(0) = mu_i.
struct SpokeSeconds {
  Eigen::Matrix3Xd second;  ///< q_i = C_i''(0)
  Eigen::VectorXd lambda;
  Eigen::VectorXd mu;
};

/// lambda_i = -alpha_i, so that a of degree 1 is 0 at the far end, and mu_i = 0.
SpokeSeconds defaultSeconds(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second);

/// The defect by which a closed fan of an even number of members does not close:
///   R = sum_i (-1)^i d_i,   d_i = (alpha_i q_i + lambda_i r_i + mu_i r_(i-1)) / S_i.
/// Twists exist iff it is zero. It is zero for open and odd fans, which always close.
Eigen::Vector3d closingDefect(const UmbrellaVertex& vertex, const SpokeSeconds& seconds);

/// The smallest change for which a closed fan of an even number of members closes; no change for
/// other fans.
///
/// The normal part of the defect is removed by changes of the q_i along N, with the least sum of
/// |dq_i|^2: an orthogonal projection. At a regular vertex the defect does not depend on the q_i,
/// and they stay. The tangential part is removed by changes of lambda, with the least sum of
/// weight_i dlambda_i^2.
/// \param weights of lambda, > 0, one for each spoke; nothing: 1 / |beta_i|, with which the sense
/// of the order has no influence.
/// \throws std::invalid_argument if the numbers of columns and entries differ from the number of
/// spokes, and for values that are not finite.
/// Source: docs/theory/fills.md F1.5.
SpokeSeconds closed(const UmbrellaVertex& vertex, const SpokeSeconds& seconds,
                    const std::optional<Eigen::VectorXd>& weights = std::nullopt);

/// How the twists X_i, the mixed second derivatives of the members at O, follow from the spokes:
/// X_i - beta_i X_(i-1) = e_i := alpha_i q_i + lambda_i r_i + mu_i r_(i-1).
struct TwistSolution {
  Eigen::MatrixXd
      of_sums;  ///< X = e of_sums^T has the least sum of |X_i|^2 / S_i^2; #members by #spokes
  /// All solutions are X + x direction^T with any vector x; empty if X is unique.
  Eigen::VectorXd direction;
};

/// A closed fan of an odd number of members has unique twists; other fans have one free vector.
/// Source: docs/theory/fills.md F1.4.
TwistSolution solveTwists(const UmbrellaVertex& vertex);

/// The twists of that solution, 3 by #members. \pre closingDefect() is zero.
Eigen::Matrix3Xd leastTwists(const UmbrellaVertex& vertex, const SpokeSeconds& seconds);

/// The second fundamental form nearest to the normal curvatures of the spokes: the symmetric matrix
/// M, in 1/mm, of M N = 0, with the least sum of squares of (r_i^T M r_i - N.q_i) / |r_i|^2. If the
/// spokes run along fewer than 3 lines, it is the smallest such M.
Eigen::Matrix3d secondForm(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second);

/// The second derivatives with the normal parts that the form prescribes, N.q_i = r_i^T M r_i. With
/// them every fan closes along N.
Eigen::Matrix3Xd shapedBy(const UmbrellaVertex& vertex, const Eigen::Matrix3d& form,
                          Eigen::Matrix3Xd second);

}  // namespace seamwright
