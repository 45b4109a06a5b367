// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/core/bezier/curve.hpp>

/// Homogeneous poles, shared by curves, patches and triangles; not a public header.
namespace seamwright {

/// (w x, w y, w z, w) of each pole. \throws std::invalid_argument naming the index and value that cannot be.
HomogeneousPoles homogeneousPoles(const Eigen::Ref<const Poles>& poles, const Eigen::VectorXd& weights);

/// \throws std::invalid_argument for no poles, a number that is not finite or a weight that is not positive; with
/// index and value.
void requireValid(const HomogeneousPoles& poles);

Poles affinePoles(const HomogeneousPoles& poles);

bool isRational(const HomogeneousPoles& poles);

/// Homogeneous partials h[k][l] = d^(k+l) H / du^k dv^l for k + l <= 3.
using HomogeneousPartials = std::array<std::array<Eigen::Vector4d, 4>, 4>;

/// The jet of the surface with these homogeneous partials.
SurfaceJet affineJet(const HomogeneousPartials& h);

}  // namespace seamwright
