// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string_view>

namespace seamwright {

/// A boundary of a tensor-product patch: u = 0, u = 1, v = 0, v = 1, where 0 and 1 stand for the
/// ends of the parameter range. The edge runs in the direction of the other parameter.
enum class PatchEdge { U0, U1, V0, V1 };

/// The edge of that name ("u0", "u1", "v0", "v1"); nothing for other text.
std::optional<PatchEdge> patchEdgeFromName(std::string_view name);

/// A boundary of a triangle with corners P0, P1, P2. On edge Lk the barycentric coordinate k is
/// zero. The edges run cyclically: L0 from P1 to P2, L1 from P2 to P0, L2 from P0 to P1.
enum class TriangleEdge { L0, L1, L2 };

/// The edge of that name ("l0", "l1", "l2"); nothing for other text.
std::optional<TriangleEdge> triangleEdgeFromName(std::string_view name);

}  // namespace seamwright
