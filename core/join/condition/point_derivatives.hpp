// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <seamwright/core/numeric.hpp>

/// The derivatives of the points of a ribbon as polynomials; not a public header.
namespace seamwright {

/// Bound of all roundings in a product of fields: the noise is this times machine_epsilon for each
/// factor.
inline constexpr double field_roundings = 64;

/// A vector-valued polynomial, and a bound of the error of a coefficient.
template <int Size>
struct RoundedField {
  rows::Field<Size> field;
  double noise = 0;

  double size() const { return rows::size(field); }
};

/// The derivatives of the points of a side, each multiplied by the power of the weight that makes
/// it a polynomial.
struct PointDerivatives {
  Eigen::VectorXd w;
  RoundedField<3> p;                   ///< times w
  RoundedField<3> s, t;                ///< times w^2
  RoundedField<3> ss, st, tt;          ///< times w^3
  RoundedField<3> sss, sst, stt, ttt;  ///< times w^4
};

/// Noise relative to size; at least that of computing with it.
template <int Size>
double relativeNoise(const RoundedField<Size>& x) {
  const double size = x.size();
  return field_roundings * machine_epsilon + (size > 0 ? x.noise / size : 0);
}

/// \param rounding of a pole.
PointDerivatives pointDerivativesOf(const Ribbon& ribbon, double rounding);

}  // namespace seamwright
