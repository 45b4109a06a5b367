// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/core/bezier/curve.hpp>

/// Homogeneous poles, shared by curves, patches and triangles; not a public header.
namespace seamwright {

/// The homogeneous poles (w x, w y, w z, w). \throws std::invalid_argument that names the invalid
/// index and value.
HomogeneousPoles homogeneousPoles(const Eigen::Ref<const Poles>& poles,
                                  const Eigen::VectorXd& weights);

/// Checks homogeneous poles.
/// \throws std::invalid_argument, with index and value, if there are no poles, a number is not
/// finite or a weight is not positive.
void requireValid(const HomogeneousPoles& poles);

Poles affinePoles(const HomogeneousPoles& poles);

bool isRational(const HomogeneousPoles& poles);

/// The homogeneous poles of P_i - \p origin, with the same weights. With the evaluated point as
/// origin nothing cancels in Leibniz' rule, because a pole of large weight is near that point. With
/// another origin w^(i) X may be as large as A^(i).
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

/// The jet of the surface that has these homogeneous partials.
SurfaceJet affineJet(const HomogeneousPartials& h);

}  // namespace seamwright
