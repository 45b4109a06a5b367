// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/join/connection.hpp>

/// What connection functions must be; not a public header.
namespace seamwright {

/// The same functions, those whose coefficients are all the same as constants.
/// \throws std::invalid_argument, with name, index and value, for a function without coefficients,
/// above degree 100, or with one that is not finite; for alpha or e0 that is not positive
/// everywhere on [0, 1].
Connection checked(const Connection& connection);

}  // namespace seamwright
