// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>

namespace seamwright::occ {

/// The text of a STEP file with each real in the fewest digits that read back as the same double,
/// and its lines broken again. Reals that are written without an exponent, texts in quotes and
/// everything else stay as they are.
std::string withShortestReals(std::string_view step);

}  // namespace seamwright::occ
