// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>

#include <seamwright/core/linear/gauss_rule.hpp>

/// Integrals of clothoids; not a public header.
namespace seamwright {

inline constexpr int phase_nodes = 16;

/// Of that many nodes.
const GaussRule& phaseRule();

/// The integral over [0, 1] of a function whose phase turns by at most \p turn_rad: 16 nodes in
/// each panel of 6 rad are exact up to rounding. Source: docs/theory/planar.md P4.1.
template <class Function>
auto integral(const Function& function, double turn_rad) {
  const GaussRule& rule = phaseRule();
  constexpr double panel_rad = 6;
  const int panels = static_cast<int>(std::ceil((turn_rad + 1) / panel_rad));
  decltype(function(0.0)) sum = function(0.0) * 0.0;
  for (int panel = 0; panel < panels; ++panel)
    for (int i = 0; i < phase_nodes; ++i)
      sum += rule.weights[i] * function((panel + rule.nodes[i]) / panels);
  return decltype(sum)(sum / panels);
}

/// Where the curve of a phase ends.
struct PhaseEnd {
  double height = 0;  ///< integral of the sine: 0 on the chord
  double height_slope = 0;
  double width = 0;  ///< integral of the cosine: the chord over the length
  double width_slope = 0;
};

/// A clothoid on a chord of length 1 along the first axis, as the integrals over t in [0, 1] of its
/// phase a t^2 + (d - a) t + f.
struct Phase {
  double start = 0;   ///< f: direction at the start
  double change = 0;  ///< d: direction at the end minus that at the start

  double at(double a, double t) const { return (a * t + change - a) * t + start; }
  double turn(double a) const { return std::abs(a) + std::abs(change); }
  /// The end, and its derivatives by a.
  PhaseEnd end(double a) const;
};

/// The phase whose curve ends on the chord.
struct PhaseRoot {
  double a = 0;
  double width = 0;
  int steps = 0;  ///< of Newton's method
};

/// The root with the least |a| of those with a width above 0. \throws std::domain_error if the
/// steps find none. Source: docs/theory/planar.md P4.2.
PhaseRoot rootOf(const Phase& phase);

}  // namespace seamwright
