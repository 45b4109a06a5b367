// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>

#include <seamwright/core/bezier/patch_edge.hpp>

namespace seamwright {

namespace {

template <class Edge, std::size_t Count>
std::optional<Edge> named(const std::array<std::string_view, Count>& names, std::string_view name) {
  const auto* found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Edge>(found - names.begin());
}

}  // namespace

std::optional<PatchEdge> patchEdgeFromName(std::string_view name) {
  return named<PatchEdge, 4>({"u0", "u1", "v0", "v1"}, name);
}

std::optional<TriangleEdge> triangleEdgeFromName(std::string_view name) {
  return named<TriangleEdge, 3>({"l0", "l1", "l2"}, name);
}

}  // namespace seamwright
