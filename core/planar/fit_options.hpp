// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// What fits of arcs, clothoids and conics require of their options; not a public header.
namespace seamwright {

/// \throws std::invalid_argument, with the value, for a tolerance that is not positive and finite,
/// and for a corner angle outside of 0..pi.
void requireFitOptions(double tolerance_mm, double corner_rad);

}  // namespace seamwright
