// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include <seamwright/core/umbrella/twists.hpp>

/// The functions of G2 across spokes, and what the vertex requires of them; not a public header.
namespace seamwright::umbrella {

/// Across a spoke C, with U and V the derivatives of the members before and behind it away from it,
/// and U2, V2 the second ones, in Bernstein form:
///   V  = a C' + b U + e C,
///   V2 = b^2 U2 + 2 a b U' + a^2 C'' + p U + q C'   if order is 2.
/// An empty e is 0. No functions on a boundary spoke.
struct SpokeLaw {
  int order = 1;
  Eigen::VectorXd a, b, p, q, e;
};

/// Two directions that span the plane across N.
Eigen::Matrix<double, 2, 3> planeOf(const UmbrellaVertex& vertex);

/// The second derivatives that are the values of one quadratic form of the tangents, those nearest
/// to the given ones.
Eigen::Matrix3Xd continued(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second);

/// The laws of order 2 with which the tangential parts of all spokes agree to second order at O:
/// a linear, b and p constant, q linear. Among all, lambda, p and q are least, and the twists are
/// nearest to those of the form of continued().
/// \pre the normal parts are those of one form.
/// Source: docs/theory/fills.md F1.10.
std::vector<SpokeLaw> secondOrderLaws(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second);

/// The equations of the mixed third derivatives of the members at O, with tangents of length 1.
struct ThirdOrder {
  /// The ratio of the largest to the smallest singular value that is not 0.
  double condition = 1;
  /// The given third derivatives, changed along N by the least amount for which the equations have
  /// a solution.
  Eigen::Matrix3Xd third;
};

/// Source: docs/theory/fills.md F1.11.
ThirdOrder thirdOrder(const UmbrellaVertex& vertex, const std::vector<SpokeLaw>& laws,
                      const Eigen::Matrix3d& form, const Eigen::Matrix3Xd& second,
                      const Eigen::Matrix3Xd& third);

}  // namespace seamwright::umbrella
