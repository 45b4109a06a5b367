// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <seamwright/occ_adapter/analyze/analyze.hpp>

namespace seamwright::occ {

struct RepairOptions {
  int order = 1;                  ///< 1: G1, 2: G2
  ContinuityTolerance tolerance;  ///< what a seam must meet to count as repaired
  double max_move_mm = 0.5;       ///< no pole may move further
  /// Edges whose seams are treated, from 1, order of TopExp::MapShapes; empty: all seams of class defect.
  std::vector<int> edges;
  std::vector<int> fixed_faces;  ///< faces that stay
  bool convert_analytic =
      false;            ///< planes, cylinders, .. may become B-spline surfaces and move; else they stay
  double match_mm = 0;  ///< also open edges within this distance of one another; 0: none
  int jobs = 0;         ///< threads; 0: one for each processor

  /// What a seam has to reach.
  Level level() const { return order == 1 ? Level::G1 : Level::G2; }

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// A seam before and after.
struct SeamRepair {
  SeamResult before, after;
  bool treated = false;   ///< it was to be repaired
  bool repaired = false;  ///< it meets the target, and its change was kept
  std::string reason;     ///< why it was not treated or not repaired
};

struct FaceMove {
  int face = 0;
  double largest_move_mm = 0;
};

struct RepairReport {
  Model
      model;  ///< same faces, edges and solids in the same order; what did not move is shared with the given one
  Report before, after;
  std::vector<SeamRepair> seams;  ///< all seams, in the order of before
  std::vector<FaceMove> moves;    ///< of the faces that moved
  double repair_s = 0;

  bool changed() const { return !moves.empty(); }
};

/// Moves poles of spline faces, as little as possible, until the seams chosen flow; proves it, or leaves them as they were.
///
/// A treated seam counts as repaired, and its change is kept, only if afterwards its enclosed figures meet the target; no other seam of
/// the model is worse than it was (a lower level or class, or a figure above both its tolerance and its old upper bound); no pole moved
/// further than max_move_mm; no face folded; and the shape passes OpenCASCADE's checks, closed solids stay closed, and their volume
/// changed by no more than the moves explain. What could not be repaired is told with the reason and left as it was.
/// A model without seams to treat comes back as it is, sharing everything.
///
/// \throws std::invalid_argument for bad options, also for edges and faces that the model does not have; Cancelled.
/// Source: MATH-surfaces 6 and 7.
RepairReport repair(const Model& model, const RepairOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
