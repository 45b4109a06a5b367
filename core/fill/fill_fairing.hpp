// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fill/fill_space.hpp>

/// The fairest of the fills of a space; not a public header.
namespace seamwright::fill {

/// Fairness is the sum of squared differences of that order along all rows of poles, in both
/// directions. Of fills that are equally fair, as order 3 leaves with sides of position alone, the
/// one with the least second differences is taken.
struct Fairest {
  Poles unknowns;
  double fairness_mm2 = 0;
};

/// One row for each difference of that order, of poles or of what stands for them, in both
/// directions.
Eigen::MatrixXd differencesOf(const FillSpace& space, const Eigen::MatrixXd& poles, int order);

/// \param spoke_scale prescribes the star of the spokes' tangents: so long as the regular star that
/// is nearest to the vectors from the centre to the middles of the sides, times that scale.
/// Source: docs/theory/fills.md F2.6.
Fairest fairest(const FillSpace& space, int order, std::optional<double> spoke_scale);

}  // namespace seamwright::fill
