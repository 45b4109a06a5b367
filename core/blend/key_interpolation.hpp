// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace seamwright {

/// Linear interpolation of values v_0 .. v_(K-1), given at omega_0 < .. < omega_(K-1):
/// v(omega) = sum_i N_i(omega) v_i.
///
/// C0: piecewise linear, 0 <= N_i <= 1. C1: cubics; the slope at a key is that of the parabola
/// through it and its neighbours, or of the last parabola at an end. C2: the natural cubic spline.
/// With two keys all of them are linear. For C1 and C2 the N_i can be negative.
///
/// Identities (each has a test of its number):
///   (1) sum_i N_i = 1, and at omega_i the N are exactly the unit vector i.
///   (2) Linear values are reproduced, by C1 with three or more keys quadratic ones too.
///   (3) Reversing omega and the keys reverses the N.
/// Source: docs/theory/curves.md C11.8; [deBoor2001].
class KeyInterpolation {
 public:
  enum class Continuity { C0, C1, C2 };

  /// \throws std::invalid_argument, with index and value, for fewer than two omegas and for omegas
  /// that are not finite or do not increase.
  KeyInterpolation(std::vector<double> omegas, Continuity continuity);

  const std::vector<double>& omegas() const { return omegas_; }
  Continuity continuity() const { return continuity_; }
  int keys() const { return static_cast<int>(omegas_.size()); }

  /// N_0 .. N_(K-1). The time is O(K).
  /// \throws std::invalid_argument outside [omega_0, omega_(K-1)].
  Eigen::VectorXd weights(double omega) const;
  /// The same for the piecewise linear interpolation.
  Eigen::VectorXd linearWeights(double omega) const;
  /// The key at exactly this omega.
  std::optional<int> keyAt(double omega) const;
  /// i of the interval [omega_i, omega_(i+1)] and the share of it before omega, 0..1.
  std::pair<int, double> interval(double omega) const;

 private:
  std::vector<double> omegas_;
  Continuity continuity_;
  Eigen::MatrixXd slopes_;  ///< K by K: first (C1) or second (C2) derivatives of the values
};

}  // namespace seamwright
