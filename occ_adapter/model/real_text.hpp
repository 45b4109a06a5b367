// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>

namespace seamwright::occ {

/// The text of a STEP file with each real in the fewest digits that read back as the same double.
/// Lines are broken again. Reals without an exponent, quoted texts and everything else stay the
/// same.
std::string withShortestReals(std::string_view step);

}  // namespace seamwright::occ
