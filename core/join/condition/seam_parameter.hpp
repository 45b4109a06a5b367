// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <seamwright/core/join/ribbon.hpp>

namespace seamwright {

/// A map of the seam's parameter, from 0 to 1 onto itself and increasing: the quotient of two
/// polynomials in Bernstein form.
struct SeamParameter {
  Eigen::VectorXd numerator, denominator;  ///< of one degree; the denominator begins with 1
  double error = 0;                        ///< bound of its rounding

  double at(double t) const;
};

/// The ribbon over t, with \p map at t as its old parameter. With n the degree of the position and
/// d that of the map, the parts get degree n d. They are multiplied by the n-th power of the
/// denominator, which changes no point.
///   (1) The points, and the derivatives of points by s, are those of the ribbon at the map of t.
Ribbon reparametrised(const Ribbon& ribbon, const SeamParameter& map);

/// Two ribbons over a common parameter.
struct CommonParameter {
  Ribbon a, b;
  double roundings = 1;  ///< of their coefficients, of the size of the largest
  SeamParameter map;
  bool of_a = true;  ///< the map is the parameter of a; otherwise that of b
};

/// Finds the parameter in which the seams of two ribbons are the same, where they run along it at
/// different speeds: a at the map of t is b at t, or the other way round. Maps are linear-rational,
/// polynomials, and quotients of polynomials, of a degree up to 6; a quotient only if a side is
/// rational. It is found by nearest points, and fits these to rounding. Nothing: the seams differ,
/// have the same parameter, or correspond in another way, such as two sides that were both made
/// from a third by polynomials.
///   (2) A reparametrised side is recognised, and the map is the one used, up to rounding.
/// Source: docs/theory/surfaces.md S1.8.
std::optional<CommonParameter> commonParameter(const Ribbon& a, const Ribbon& b);

}  // namespace seamwright
