// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace seamwright::occ {

/// Why a matched seam is not sewn. docs/repair.md says what helps.
enum class SewFault {
  None,
  GapTooLarge,    ///< the gap is not certainly within the tolerance
  FaceInstances,  ///< a face occurs in the model several times
  HollowSolid,    ///< a face is part of a solid of several shells
  CommonSurface,  ///< both faces have the same surface
  // The edges can't be cut.
  IntervalDivided,  ///< another interval of an edge begins or ends inside
  IntervalShort,    ///< the interval is no longer than the gap tolerance
  IntervalTaken,    ///< the same interval belongs to another seam too
  // There is no common edge or vertex.
  NoVertex,           ///< an edge ends without a vertex
  PointsOutOfOrder,   ///< corresponding points of both edges do not follow one another
  NoCurve,            ///< a curve or a pcurve can't be evaluated or built
  VertexTooWide,      ///< a common vertex would be far from the ends of its edges
  OneSided,           ///< the seam would close a band with one side, such as a Moebius band
  OpenCascadeFailed,  ///< an algorithm of OpenCASCADE stopped
  // The sewn shape is not kept.
  ChecksFail,  ///< OpenCASCADE's checks do not pass for a face, or for the shape
  ShellOpens,  ///< a closed shell would open
  LosesLevel   ///< measured as one edge, the seam loses a level or a tolerance
};

/// A fault with its numbers and its location in the given shape, and its text for the user.
struct SewReason {
  SewFault fault = SewFault::None;
  std::string text = {};
  /// By name with the unit, such as {"distance_mm", 0.03}.
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<int> faces = {}, edges = {};

  bool empty() const { return fault == SewFault::None; }
};

/// The name of a fault in reports: "vertex_too_wide".
/// \throws std::out_of_range for a value that is not of the enum.
std::string codeOf(SewFault fault);

}  // namespace seamwright::occ
