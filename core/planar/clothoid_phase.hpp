// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>

/// Integrals of clothoids; not a public header.
namespace seamwright {

/// Nodes and weights of Gauss' quadrature on [0, 1].
struct GaussRule {
  static constexpr int count = 16;
  std::array<double, count> nodes = {}, weights = {};
};

const GaussRule& gaussRule();

/// The integral over [0, 1] of a function whose phase turns by at most \p turn_rad: 16 nodes in
/// each panel of 3 rad are exact up to rounding.
template <class Function>
auto integral(const Function& function, double turn_rad) {
  const GaussRule& rule = gaussRule();
  constexpr double panel_rad = 3;
  const int panels = static_cast<int>(std::ceil((turn_rad + 1) / panel_rad));
  decltype(function(0.0)) sum = function(0.0) * 0.0;
  for (int panel = 0; panel < panels; ++panel)
    for (int i = 0; i < GaussRule::count; ++i)
      sum += rule.weights[i] * function((panel + rule.nodes[i]) / panels);
  return decltype(sum)(sum / panels);
}

/// A clothoid on a chord of length 1 along the first axis, as the integrals over t in [0, 1] of its
/// phase a t^2 + (d - a) t + f.
struct Phase {
  double start = 0;   ///< f: direction at the start
  double change = 0;  ///< d: direction at the end minus that at the start

  double at(double a, double t) const { return (a * t + change - a) * t + start; }
  double turn(double a) const { return std::abs(a) + std::abs(change); }
  /// The height of the end: zero for the solution.
  double height(double a) const {
    return integral([&](double t) { return std::sin(at(a, t)); }, turn(a));
  }
  double heightSlope(double a) const {
    return integral([&](double t) { return (t * t - t) * std::cos(at(a, t)); }, turn(a));
  }
  /// The width of the end: the chord over the length.
  double width(double a) const {
    return integral([&](double t) { return std::cos(at(a, t)); }, turn(a));
  }
};

}  // namespace seamwright
