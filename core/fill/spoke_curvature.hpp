// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/fill/fill_space.hpp>

/// Fills whose patches meet each other with G2; not a public header.
namespace seamwright::fill {

/// The fills of \p space, built with SpokeLaw::G2 in degree 6 at least, that have G2 across all
/// spokes. Their spokes can't be prescribed.
/// Source: docs/theory/fills.md F2.8.
FillSpace withG2Spokes(const FillSpace& space);

}  // namespace seamwright::fill
