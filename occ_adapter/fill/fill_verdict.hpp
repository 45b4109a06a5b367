// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/fill/fill_faces.hpp>
#include <seamwright/occ_adapter/fill/sewn_fill.hpp>

/// Stage 5 of a fill: whether it is good. Not a public header.
namespace seamwright::occ {

struct FillVerdict {
  FillReason reason;          ///< why the fill is not good, or not allowed; empty if it is good
  bool valid = false;         ///< OpenCASCADE's checks pass, or fail as before
  bool meets_others = false;  ///< the new faces run into others, or into each other
};

/// \throws Cancelled, Standard_Failure.
FillVerdict judgeFill(const FillTask& task, const FillFaces& made, const SewnFill& fill,
                      const FillSeams& seams);

/// Largest distance of poles from the middle of the hole, over half the diagonal of its sides. A
/// fill that exceeds it is rejected. For comparison, the poles of a hemisphere reach less than 2.
inline constexpr double most_reach = 3;

}  // namespace seamwright::occ
