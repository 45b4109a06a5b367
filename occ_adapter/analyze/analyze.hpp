// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

struct AnalyzeOptions {
  ContinuityTolerance tolerance;
  Level level = Level::G1;  ///< what a seam must reach: G0..G3; the change of curvature is measured
                            ///< only for G3
  double match_mm = 0;  ///< free edges within this distance of each other also form seams; 0: none
  bool certify = true;  ///< enclose the figures; false: sample them only
  bool figures = true;  ///< false: enclosures are of any width, narrow enough for certain verdicts
  int jobs = 0;         ///< threads; 0: one for each processor
  std::vector<int> faces = {};  ///< only seams of these faces, from 1; empty: all seams

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// Measures and judges every seam of a model. docs/seams.md defines the figures and the verdicts.
///
///     const Report report = analyze(readModel("part.step"), {.level = Level::G2});
///     for (const SeamResult& seam : report.seams)
///       if (seam.verdict.seam_class == SeamClass::Defect) show(seam.edges, figuresText(seam));
///
/// Seams are measured in parallel; the result does not depend on the number of threads. A seam that
/// can't be measured has no figures, level None, class Defect and a note that says why; other seams
/// are not affected. The same holds for faces and edges with numbers that are not finite, or 1e100
/// and more. A model without seams passes, with a note. The model is not changed.
///
/// \throws std::invalid_argument for invalid options, for a gap tolerance or a matching distance
/// below the rounding of the model's coordinates, and for faces that the model does not have;
/// Cancelled.
Report analyze(const Model& model, const AnalyzeOptions& options = {},
               const Progress& progress = {});

/// What a report says of its model.
ModelFacts factsOf(const Model& model);

}  // namespace seamwright::occ
