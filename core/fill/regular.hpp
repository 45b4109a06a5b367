// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/triangle.hpp>

namespace seamwright {

/// Proves that X_u x X_v vanishes nowhere on a polynomial patch.
///
/// The patch is cut until on each piece all Bernstein coefficients of w . (X_u x X_v) are positive,
/// for a vector w of the piece: then no normal vanishes, and as they change continuously none turns
/// back. Rounding is inside the paddings; the poles count as exact.
///
/// \param max_pieces work limit; another is 16 cuts of one piece, by turns in u and in v.
/// \return false where that was not proved within the limit, so always where a normal vanishes.
/// False too for a rational patch.
/// Source: docs/theory/enclosures.md E5.3.
bool provedRegular(const BezierPatch& patch, int max_pieces = 256);
/// The same of a triangle, by its regularPatches(), each with that limit.
bool provedRegular(const BezierTriangle& triangle, int max_pieces = 256);

}  // namespace seamwright
