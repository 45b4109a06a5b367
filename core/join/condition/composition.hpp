// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/connection_functions.hpp>
#include <seamwright/core/join/ribbon.hpp>
#include <vector>

/// The derivatives of a reparametrised side along the seam; not a public header.
namespace seamwright {

/// The derivatives by u at u = 0 of P(sigma, tau) with sigma = alpha u + p u^2 / 2 + h u^3 / 6 and
/// tau = t + beta u + q u^2 / 2 + k u^3 / 6, up to an order of 3: P, Y1, Y2, Y3 of
/// ConnectionFunctions. Each has the lowest degree in which its terms can be written.
std::vector<rows::Field<4>> composedDerivatives(const Ribbon& given, const ConnectionFunctions& c,
                                                int order);

/// The derivative of that order of (e0 + e1 u + e2 u^2 / 2 + e3 u^3 / 6) P(sigma, tau), from those
/// of P(sigma, tau).
rows::Field<4> scaledDerivative(const std::vector<rows::Field<4>>& composed,
                                const ConnectionFunctions& c, int order);

}  // namespace seamwright
