// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <seamwright/core/planar/biarc_spline.hpp>

#include "splines.hpp"
#include "support/random.hpp"

/// What tests of planar curves share.
namespace seamwright::test {

inline double uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Eigen::Vector2d planarVector(const nlohmann::json& value) {
  return {number(value[0]), number(value[1])};
}

inline PlanarPoints planarPoints(const nlohmann::json& values) {
  PlanarPoints points(static_cast<Eigen::Index>(values.size()), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) = planarVector(values[static_cast<std::size_t>(i)]).transpose();
  return points;
}

/// Difference of two angles without multiples of 2 pi.
inline double angleBetween(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

inline HermiteEnds randomEnds(std::mt19937_64& random) {
  const auto point = [&] {
    return Eigen::Vector2d(uniform(random, -9, 9), uniform(random, -9, 9));
  };
  return {.start = point(),
          .start_direction_rad = uniform(random, -4, 4),
          .end = point(),
          .end_direction_rad = uniform(random, -4, 4)};
}

/// Ends with given angles against a chord from (0, 0) to (chord, 0).
inline HermiteEnds endsWith(double alpha_rad, double beta_rad, double chord_mm = 1) {
  return {.start_direction_rad = -alpha_rad,
          .end = Eigen::Vector2d(chord_mm, 0),
          .end_direction_rad = beta_rad};
}

/// The end point of a curve whose direction is a function of the arc length, by quadrature.
template <class Direction>
Eigen::Vector2d integrated(const Eigen::Vector2d& start, const Direction& direction,
                           double length_mm) {
  // Gauss-Legendre with 4 nodes in each panel.
  constexpr std::array<double, 4> nodes = {0.069431844202973712388, 0.330009478207571867599,
                                           0.669990521792428132401, 0.930568155797026287612};
  constexpr std::array<double, 4> weights = {0.173927422568726928687, 0.326072577431273071313,
                                             0.326072577431273071313, 0.173927422568726928687};
  constexpr int panels = 400;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < panels; ++i)
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double angle = direction(length_mm * (i + nodes[k]) / panels);
      sum += weights[k] * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
  return start + sum * length_mm / panels;
}

}  // namespace seamwright::test
