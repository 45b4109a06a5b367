// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <stdexcept>
#include <string>

/// Two ribbons in coordinates where their size is 1; not a public header.
namespace seamwright {

/// Largest noise of a relative residual for which a condition is still decided.
inline constexpr double kLargestNoise = 1e-2;

inline void requireTolerance(const std::optional<double>& tolerance) {
  if (tolerance && !(*tolerance >= 0 && std::isfinite(*tolerance)))
    throw std::invalid_argument("tolerance is " + bernstein::text(*tolerance) +
                                ": it must be finite and not negative");
}

inline void requireUsable(const Ribbon& ribbon, const char* name) {
  for (const HomogeneousPoles* part : ribbon.parts())
    if (part->rows() == 0 || !part->allFinite())
      throw std::invalid_argument(std::string("ribbon ") + name +
                                  " has a part that is empty or not finite");
  constexpr int most =
      30;  // the condition of curvature has up to 24 times the degree, and binomials end at 800
  for (const HomogeneousPoles* part : ribbon.parts())
    if (rows::degree(*part) > most)
      throw std::invalid_argument(std::string("ribbon ") + name + " has degree " +
                                  std::to_string(rows::degree(*part)) + ": it must be within " +
                                  std::to_string(most));
  for (Eigen::Index k = 0; k < ribbon.position.rows(); ++k)
    if (!(ribbon.position(k, 3) > 0))
      throw std::invalid_argument(std::string("ribbon ") + name + ", pole " + std::to_string(k) +
                                  " has weight " + bernstein::text(ribbon.position(k, 3)) +
                                  ": it must be positive");
}

/// Two ribbons with a normalised origin, unit of length and unit of weights. The join of two
/// ribbons does not depend on these.
struct NormalizedPair {
  Ribbon a, b;
  double length = 1;    ///< in mm, the unit of length of the ribbons
  double rounding = 0;  ///< of a pole in that unit

  /// \param roundings of a coefficient, in those of a double of the original coordinates
  NormalizedPair(const Ribbon& given_a, const Ribbon& given_b, double roundings = 1)
      : a(given_a), b(given_b) {
    requireUsable(a, "a");
    requireUsable(b, "b");
    const double weight = std::max(a.position.col(3).maxCoeff(), b.position.col(3).maxCoeff());
    forEachPart([&](HomogeneousPoles& part) { part /= weight; });
    const double far = std::max(reach(a), reach(b));
    const Eigen::RowVector3d origin = a.position.row(0).head<3>() / a.position(0, 3);
    forEachPart([&](HomogeneousPoles& part) { part.leftCols<3>() -= part.col(3) * origin; });
    length = std::max(size(a), size(b));
    if (!(length > 0)) length = 1;
    forEachPart([&](HomogeneousPoles& part) { part.leftCols<3>() /= length; });
    rounding = roundings * std::numeric_limits<double>::epsilon() * (1 + far / length);
  }

 private:
  template <class Change>
  void forEachPart(const Change& change) {
    for (Ribbon* ribbon : {&a, &b})
      for (HomogeneousPoles* part : ribbon->parts()) change(*part);
  }
  static double reach(const Ribbon& ribbon) {
    return ribbon.position.leftCols<3>().cwiseAbs().maxCoeff();
  }
  /// Size of the poles of the seam and of the row behind it.
  static double size(const Ribbon& ribbon) {
    return std::max(reach(ribbon), ribbon.first.leftCols<3>().cwiseAbs().maxCoeff() /
                                       std::max(ribbon.degree_across, 1));
  }
};

}  // namespace seamwright
