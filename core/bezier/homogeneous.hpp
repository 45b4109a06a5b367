// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/core/bezier/curve.hpp>

/// Homogeneous poles, shared by curves, patches and triangles; not a public header.
namespace seamwright {

/// (w x, w y, w z, w) of each pole. \throws std::invalid_argument naming the index and value that
/// cannot be.
HomogeneousPoles homogeneousPoles(const Eigen::Ref<const Poles>& poles,
                                  const Eigen::VectorXd& weights);

/// \throws std::invalid_argument for no poles, a number that is not finite or a weight that is not
/// positive; with index and value.
void requireValid(const HomogeneousPoles& poles);

Poles affinePoles(const HomogeneousPoles& poles);

bool isRational(const HomogeneousPoles& poles);

/// The poles P_i - \p origin with their weights. About the point evaluated there is nothing to
/// cancel in Leibniz' rule, where w^(i) X would be of the size of A^(i): a heavy pole is near that
/// point.
HomogeneousPoles about(const HomogeneousPoles& poles, const Eigen::Vector3d& origin);

/// Point and derivatives of the curve from those of its homogeneous form A = w X, by Leibniz' rule:
/// X^(k) = (A^(k) - sum_{i=1..k} C(k,i) w^(i) X^(k-i)) / w.
template <int Count>
casteljau::Derivatives<3, Count> affineDerivatives(const casteljau::Derivatives<4, Count>& h) {
  casteljau::Derivatives<3, Count> x = h.template leftCols<3>();
  for (Eigen::Index k = 0; k < h.rows(); ++k) {
    double binomial = 1;
    for (Eigen::Index i = 1; i <= k; ++i) {
      binomial *= static_cast<double>(k - i + 1) / static_cast<double>(i);
      x.row(k) -= binomial * h(i, 3) * x.row(k - i);
    }
    x.row(k) /= h(0, 3);
  }
  return x;
}

/// Homogeneous partials h[k][l] = d^(k+l) H / du^k dv^l for k + l <= 3.
using HomogeneousPartials = std::array<std::array<Eigen::Vector4d, 4>, 4>;

/// The jet of the surface with these homogeneous partials.
SurfaceJet affineJet(const HomogeneousPartials& h);

}  // namespace seamwright
