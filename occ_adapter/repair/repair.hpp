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
  double match_mm = 0;           ///< also open edges within this distance of one another; 0: none
  int jobs = 0;                  ///< threads; 0: one for each processor

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
  double largest_move_mm =
      0;  ///< of a pole, against the surface as it was in the knots that it has now; at most
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

/// Moves poles of B-spline and Bezier faces, as little as possible, until the seams chosen flow; proves it, or leaves them as they were.
/// Planes, cylinders and the like stay, and parts with several instances.
///
/// Three ways are tried one after the other, each for what the one before left: all seams between natural sides of polynomial surfaces at once,
/// exactly (core/join/network.hpp); one pair after the other (see matchFaces()); and all faces at once, to a share of the tolerance,
/// towards common targets of their seams that agree at vertices. What spoils a way is given up until the rest can be proven.
///
/// A treated seam counts as repaired, and its change is kept, only if afterwards its enclosed figures meet the target; no other seam of
/// the model is worse than it was; no pole moved further than max_move_mm, all ways together; no face folded; no edge lies further from
/// its faces than twice the gap tolerance or what it had; and the shape passes OpenCASCADE's checks as before, closed solids stay closed,
/// and their volume changed by no more than the moves explain. What could not be repaired is told with the reason and left as it was. A
/// seam on a moved face, or between two, may be left better than it was.
///
/// A seam is worse if its class is, or it is less certain; if its level is lower, above the level asked for only where it had the higher
/// one for sure (where a side is nearly flat the figures often can't tell); or if a figure that the target asks for, of a crease the gap
/// alone, is surely above its tolerance and exceeds its old upper bound by more than a tenth of the tolerance, in each of the three ways.
/// Figures within the tolerance are as good as one another, and so are those that differ by less than that tenth.
/// A model without seams to treat comes back as it is, sharing everything.
///
/// \throws std::invalid_argument for bad options, also for edges and faces that the model does not have and edges that are no
/// seam; Cancelled.
/// Source: MATH-surfaces 6 and 7.
RepairReport repair(const Model& model, const RepairOptions& options = {}, const Progress& progress = {});

}  // namespace seamwright::occ
