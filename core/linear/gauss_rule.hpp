// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

/// Not a public header.
namespace seamwright {

/// Gauss' quadrature on [0, 1]: exact for polynomials up to the degree 2 count - 1. The nodes fall.
struct GaussRule {
  std::vector<double> nodes, weights;
};

/// \pre count is at least 1.
GaussRule gaussRule(int count);

}  // namespace seamwright
