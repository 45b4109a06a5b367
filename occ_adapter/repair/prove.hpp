// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/solve.hpp>

/// Whether a changed shape is a repaired one; not a public header.
namespace seamwright::occ {

/// Faces that pass OpenCASCADE's checks, from 1, and whether the whole does. Faces that can't be
/// computed with (UnusableParts) do not.
struct Validity {
  std::vector<bool> faces;
  bool whole = true;
};
/// \param jobs threads; 0: one for each processor. What is found does not depend on it.
Validity validityOf(const TopoDS_Shape& shape, int jobs);

/// Seams of one shape measured after changes of it, by the seam and the surfaces of the faces
/// beside its edges (none: it stays).
using MeasuredSeams =
    std::map<std::pair<std::size_t, std::vector<opencascade::handle<Geom_Surface>>>, SeamResult>;

/// What is wrong with a change; nothing, and it may be kept.
struct Proof {
  std::vector<SeamResult> after;                  ///< in the order of before
  std::map<std::size_t, std::string> unrepaired;  ///< treated seams that do not have the level
  std::map<std::size_t, std::string> worse;       ///< other seams
  std::map<int, std::string>
      faces;          ///< folded, moved further than told, or failing OpenCASCADE's checks
  std::string whole;  ///< of the shape as a whole

  bool holds() const {
    return unrepaired.empty() && worse.empty() && faces.empty() && whole.empty();
  }
};

/// The seams of the task in a shape that withChanges() made of its own, or the same one. Of a
/// matched seam the interval that is found there now, if it holds the one before; else that one, so
/// that nothing of it is lost where it opened beyond the distance to match. \throws Cancelled.
std::vector<Seam> seamsAfter(const RepairTask& task, const TopoDS_Shape& changed,
                             const Progress& progress);

/// Seams beside faces and edges that are new are measured again, the others have their figures from
/// before. What costs much is looked at only where nothing before it speaks against the change:
/// first the faces and the treated seams, then the other seams, then OpenCASCADE's checks, then
/// volumes. A face's points must not move further than its poles were told to.
/// \param known of the task's shape; it grows. \throws Cancelled.
Proof prove(const RepairTask& task, const std::vector<FaceChange>& changes,
            const TopoDS_Shape& changed, MeasuredSeams& known, const Progress& progress);

}  // namespace seamwright::occ
