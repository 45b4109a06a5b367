// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fill/fill_space.hpp>

/// The fairest of the fills of a space; not a public header.
namespace seamwright::fill {

/// Fairness is the sum of squared differences of the given order along all rows of poles, in both
/// directions. For sides of position alone order 3 leaves several fills that are equally fair. Then
/// the one with the smallest second differences is taken.
struct Fairest {
  Poles unknowns;
  double fairness_mm2 = 0;
};

/// One row for each difference of order \p order in both directions, of poles or of their
/// coefficients.
Eigen::MatrixXd differencesOf(const FillSpace& space, const Eigen::MatrixXd& poles, int order);

/// \param spoke_scale prescribes the tangents of the spokes. Their lengths are those of the regular
/// set of tangents that is nearest to the vectors from the centre to the middles of the sides,
/// times that scale. It needs a space with its centre.
/// Source: docs/theory/fills.md F2.6.
Fairest fairest(const FillSpace& space, int order, std::optional<double> spoke_scale);

}  // namespace seamwright::fill
