// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/curve.hpp>

/// Not a public header.
namespace seamwright {

/// The first n + 1 poles of a curve of that degree from its derivatives 0..n at 0, by forward
/// differences: X^(k) = degree! / (degree - k)! Delta^k P_0.
Poles polesFrom(const CurveDerivatives& derivatives, int degree);

}  // namespace seamwright
