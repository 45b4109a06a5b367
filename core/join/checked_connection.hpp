// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/join/connection.hpp>

/// Checks of connection functions; not a public header.
namespace seamwright {

/// The same functions; a function whose coefficients are all the same is reduced to a constant.
/// \throws std::invalid_argument, with name, index and value, for a function without coefficients,
/// of a degree above 100, or with a coefficient that is not finite; and for an alpha or e0 that is
/// not positive everywhere on [0, 1].
Connection checked(const Connection& connection);

}  // namespace seamwright
