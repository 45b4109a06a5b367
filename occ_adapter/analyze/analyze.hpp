// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

struct AnalyzeOptions {
  ContinuityTolerance tolerance;
  Level level = Level::G1;  ///< what a seam must reach: G0..G3; the change of curvature is measured
                            ///< for G3 alone
  double match_mm = 0;  ///< also seams of free edges within this distance of one another; 0: none
  bool certify = true;  ///< enclose the figures; false: sample them only
  int jobs = 0;         ///< threads; 0: one for each processor
  std::vector<int> faces = {};  ///< from 1: seams of these faces alone; empty: of all

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// Measures and judges every seam of a model.
///
/// Seams are measured in parallel, the result does not depend on the number of threads. A seam that
/// can't be measured has no figures, level None, class Defect and a note that says why; the others
/// are not affected. So it is with faces and edges whose numbers are not finite, or 1e100 and more.
/// A model without seams passes, with a note. The shape is never changed.
///
/// \throws std::invalid_argument for bad options, also for a gap tolerance or a distance to match
/// below the rounding of the model's coordinates, and for faces that the model does not have;
/// Cancelled.
Report analyze(const Model& model, const AnalyzeOptions& options = {},
               const Progress& progress = {});

ModelFacts factsOf(const Model& model);

}  // namespace seamwright::occ
