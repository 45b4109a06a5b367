// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>

/// Homogeneous poles, shared by curves and patches; not a public header.
namespace seamwright {

/// (w x, w y, w z, w) of each pole. \throws std::invalid_argument naming the index and value that cannot be.
HomogeneousPoles homogeneousPoles(const Eigen::Ref<const Poles>& poles, const Eigen::VectorXd& weights);

Poles affinePoles(const HomogeneousPoles& poles);

bool isRational(const HomogeneousPoles& poles);

}  // namespace seamwright
