// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string_view>

#include <seamwright/core/bezier/patch.hpp>
#include <seamwright/core/seam/enclose.hpp>

namespace seamwright {

/// A boundary of a patch: u = 0, u = 1, v = 0, v = 1.
enum class PatchEdge { U0, U1, V0, V1 };

/// The edge of that name ("u0", "u1", "v0", "v1"); nothing for other text.
std::optional<PatchEdge> patchEdgeFromName(std::string_view name);

/// The side that a patch gives to a seam along one of its edges, for encloseSeam(). s is the parameter that
/// runs along the edge, or 1 minus it if \p reversed. The numbers of poles() and weights() count as exact.
SeamSide seamSide(const BezierPatch& patch, PatchEdge edge, bool reversed = false);

}  // namespace seamwright
