// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/umbrella/umbrella.hpp>

namespace seamwright::umbrella {

/// umbrellaAround() with an outer boundary or weights, as one linear system; not a public header.
/// Source: docs/theory/fills.md F1.13, F1.14.
Umbrella solvedUmbrella(const std::vector<BezierCurve>& spokes, const UmbrellaOptions& options);

}  // namespace seamwright::umbrella
