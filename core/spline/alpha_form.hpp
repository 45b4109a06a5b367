// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/curve.hpp>

/// Common functions of alpha-curves and alpha-surfaces; not a public header.
namespace seamwright::alpha {

inline constexpr double kSmallestShape =
    1e-6;  ///< Smallest shape of a join. Below it the end derivatives are too small

inline void requireWithin(const std::string& name, double value, double low, double high) {
  if (!(low <= value && value <= high))
    throw std::invalid_argument(name + " is " + bernstein::text(value) + ": it must be within " +
                                bernstein::text(low) + " to " + bernstein::text(high));
}

inline void requirePositive(const std::string& name, double value) {
  if (!(value > 0 && std::isfinite(value)))
    throw std::invalid_argument(name + " is " + bernstein::text(value) + ": it must be positive");
}

inline void requireFinite(const std::string& name, double value) {
  if (!std::isfinite(value))
    throw std::invalid_argument(name + " is " + bernstein::text(value) + ": it must be finite");
}

/// The matrix that maps the poles of an alpha-curve to those of its quintic.
inline Eigen::Matrix<double, 6, 4> quintic(double a) {
  Eigen::Matrix<double, 6, 4> map;
  map << 1, 0, 0, 0,   //
      1 - a, a, 0, 0,  //
      0, 0.5, 0.5, 0,  //
      0, 0.5, 0.5, 0,  //
      0, 0, a, 1 - a,  //
      0, 0, 0, 1;
  return map;
}

/// The poles of an alpha-curve, or a row of the net of an alpha-surface.
using Row = Eigen::Matrix<double, 4, 3, Eigen::RowMajor>;

/// The defect of a row in the equation X_0 + X_3 = X_1 + X_2.
inline Eigen::RowVector3d defect(const Row& row) {
  return row.row(0) + row.row(3) - row.row(1) - row.row(2);
}

/// For a row without defect: the row of the same curve in another shape. \p ratio is the old shape
/// divided by the new one.
inline Row reshaped(const Row& row, double ratio) {
  Row result = row;
  result.row(1) = (1 - ratio) * row.row(0) + ratio * row.row(1);
  result.row(2) = (1 - ratio) * row.row(3) + ratio * row.row(2);
  return result;
}

/// One side of a joint: the shape and the length in the common parameter.
struct Side {
  double a = 1, length = 1;
};

/// Factors that give the poles after a joint:
///   Q_1 = P_3 + first (P_3 - P_2),   Q_2 = P_3 + second (P_3 - P_2) + third (P_1 - P_3).
struct Factors {
  double first = 1, second = 0, third = 1;
};

/// The only beta2 for which a G2 join is G3.
inline double beta2OfG3(double beta1, double length, double next_length) {
  return -2 * beta1 * (beta1 / length + 1 / next_length);
}

/// Source: docs/theory/curves.md C8.4.
inline Factors factors(const Side& given, const Side& next, double beta1, double beta2) {
  const double ratio = next.length / given.length, pace = beta1 * ratio;
  const double first = pace * given.a / next.a, third = pace * pace;
  return {first,
          first * (4 * next.a - 1) + beta2 * given.a * next.length * ratio / 2 +
              third * (4 * given.a - 1),
          third};
}

/// Checks the poles that a join gives.
/// \param first the index of the first pole.
inline void requireInRange(const Eigen::Ref<const Poles>& poles, Eigen::Index first = 0) {
  for (Eigen::Index i = 0; i < poles.rows(); ++i)
    if (!poles.row(i).allFinite())
      throw std::invalid_argument(
          "pole " + std::to_string(first + i) + " of the next one comes out as (" +
          bernstein::text(poles(i, 0)) + ", " + bernstein::text(poles(i, 1)) + ", " +
          bernstein::text(poles(i, 2)) +
          "): beta1, beta2 or the lengths are too large or too small for it");
}

/// Checks the common members of AlphaCurveJoin and AlphaJoin.
template <class Join>
void requireJoin(const Join& join) {
  if (join.order < 1 || join.order > 3)
    throw std::invalid_argument("order " + std::to_string(join.order) + ": known are 1, 2 and 3");
  requirePositive("beta1", join.beta1);
  requireFinite("beta2", join.beta2);
  requirePositive("length", join.length);
  requirePositive("next_length", join.next_length);
}

}  // namespace seamwright::alpha
