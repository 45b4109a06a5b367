// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/bezier/triangle.hpp>

namespace seamwright {

/// Proves that X_u x X_v vanishes nowhere on a polynomial patch.
///
/// The patch is cut until on each piece all Bernstein coefficients of w . (X_u x X_v) are positive,
/// for some vector w of the piece. Then no normal vanishes, and because normals change continuously
/// none turns back. The paddings include rounding; the poles count as exact.
///
/// \param max_pieces limit of the work; a second limit is 16 cuts of one piece, alternating in u
/// and in v.
/// \return false if there is no proof within the limits, so always if a normal vanishes, and for a
/// rational patch.
/// Source: docs/theory/enclosures.md E5.3.
bool provedRegular(const BezierPatch& patch, int max_pieces = 256);
/// The same for a triangle, by its regularPatches(), each with that limit.
bool provedRegular(const BezierTriangle& triangle, int max_pieces = 256);

}  // namespace seamwright
