// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/core/join/nearest/nearest.hpp>

/// Both sides of a join with one degree, the same knots and one parameter along the seam; not a
/// public header.
namespace seamwright::nearest {

struct CommonSide {
  JoinSide side;  ///< over the common parameter; weights and fixed poles of the refined surface
  BSplineSurface own;  ///< the refined surface over its own parameter
  /// By which the homogeneous poles of \p own were multiplied; empty: 1.
  Eigen::VectorXd factors = {};
  SeamChange change = {};

  /// The join of \p side over the own parameter. Poles that did not move are those of \p own,
  /// bitwise.
  BSplineSurface inOwnParameter(const BSplineSurface& joined) const;
};

struct CommonSeam {
  CommonSide a, b;
  std::optional<SeamParameter> parameter_of_b = std::nullopt;
};

/// Sides that have the same degree and knots, to rounding, are returned bitwise.
/// \param order of the join: rows behind it do not move.
/// \throws std::invalid_argument as nearestJoin() does.
/// Source: docs/theory/surfaces.md S1.9, S5.7.
CommonSeam commonSeam(const JoinSide& a, const JoinSide& b, int order);

}  // namespace seamwright::nearest
