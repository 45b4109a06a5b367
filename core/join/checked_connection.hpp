// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/join/connection_functions.hpp>

/// Checks of connection functions; not a public header.
namespace seamwright {

/// The same functions; a function whose coefficients are all the same is reduced to a constant.
/// \throws std::invalid_argument, with name, index and value, for a function without coefficients,
/// of a degree above 100, or with a coefficient that is not finite; for an alpha or e0 that is not
/// positive everywhere on [0, 1]; and for a gamma other than 1.
ConnectionFunctions checked(const ConnectionFunctions& connection);

/// Whether all coefficients of a function have that value.
inline bool isConstant(const Eigen::VectorXd& function, double value) {
  return function.size() > 0 && (function.array() == value).all();
}

}  // namespace seamwright
