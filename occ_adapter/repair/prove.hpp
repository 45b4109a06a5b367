// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/solve.hpp>

/// Proves that a changed shape is repaired. Not a public header.
namespace seamwright::occ {

/// Which faces, from 1, pass OpenCASCADE's checks, and whether the whole shape does. Faces that
/// can't be computed with (UnusableParts) do not pass.
struct Validity {
  std::vector<bool> faces;
  bool whole = true;
};
/// \param jobs threads; 0: one for each processor. The result does not depend on it.
Validity validityOf(const TopoDS_Shape& shape, int jobs);

/// Seams of one shape as measured after changes. The key is the seam with the new surfaces of the
/// faces beside its edges (none: the face stays).
using MeasuredSeams =
    std::map<std::pair<std::size_t, std::vector<opencascade::handle<Geom_Surface>>>, SeamResult>;

/// What is wrong with a change. The change may be kept if nothing is.
struct Proof {
  std::vector<SeamResult> after;  ///< in the order of RepairTask::before
  /// By treated seam that does not have the level: the reason.
  std::map<std::size_t, RepairReason> unrepaired;
  std::map<std::size_t, RepairReason> worse;  ///< other seams
  /// By face: it folded, moved further than its limit, or fails OpenCASCADE's checks.
  std::map<int, RepairReason> faces;
  RepairReason whole;  ///< what is wrong with the shape as a whole

  bool holds() const {
    return unrepaired.empty() && worse.empty() && faces.empty() && whole.empty();
  }
};

/// The seams of a shape in \p changed, which withChanges() made of that shape or which is that
/// shape. A matched seam gets the interval that is found now if that contains the interval
/// before. Otherwise it keeps the interval before, so that no part is lost where the seam opened
/// beyond the matching distance.
/// \param before figures in the shape, in the order of \p seams.
/// \throws Cancelled.
std::vector<Seam> seamsAfter(const TopoDS_Shape& changed, std::vector<Seam> seams,
                             const std::vector<SeamResult>& before, const RepairOptions& options,
                             const Progress& progress);

/// Measures seams beside new faces and edges again; the other seams keep their figures. Costly
/// checks run only if the cheaper ones before them find nothing wrong: first the faces and the
/// treated seams, then the other seams, then OpenCASCADE's checks, then the volumes. A point of a
/// face must not move further than FaceChange::largest_move_mm. \param known measurements of the
/// task's shape; new ones are added. \throws Cancelled.
Proof prove(const RepairTask& task, const std::vector<FaceChange>& changes,
            const TopoDS_Shape& changed, MeasuredSeams& known, const Progress& progress);

}  // namespace seamwright::occ
