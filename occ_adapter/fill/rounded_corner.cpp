// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include <seamwright/occ_adapter/fill/rounded_corner.hpp>

namespace seamwright::occ {

RoundedCorner turnedBack(RoundedCorner made) {
  made.shell.shell.Reverse();
  std::ranges::reverse(made.edges);
  for (CornerFilletEdge& edge : made.edges) edge.convex = !edge.convex;
  std::ranges::reverse(made.fill.patches);
  for (BezierPatch& patch : made.fill.patches) patch = patch.transposed();
  std::ranges::reverse(made.fill.corners);
  return made;
}

}  // namespace seamwright::occ
