// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/surface/judge.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/repair/repair_reason.hpp>
#include <seamwright/occ_adapter/topology/sew_reason.hpp>

namespace seamwright::occ {

struct RepairOptions {
  int order = 1;                  ///< 1: G1, 2: G2
  ContinuityTolerance tolerance;  ///< what a seam must meet to count as repaired
  /// Upper bound, above 0, of the move of a pole and of a point of an edge; nothing: by the size of
  /// the face.
  std::optional<double> max_move_mm;
  /// Edges to be treated, from 1, in the order of TopExp::MapShapes; empty: all defects.
  std::vector<int> edges;
  std::vector<int> fixed_faces;  ///< faces that stay, from 1
  /// The same, because their move makes a seam worse in the written file.
  std::vector<int> held_faces;
  /// Free edges within this distance also form seams; 0: none do.
  double match_mm = 0;
  bool sew = true;  ///< matched seams that meet within the gap tolerance become one edge
  /// Analytic faces may become splines where they have to move.
  bool convert_analytic = false;
  /// Factor by which the variation of a face's curvature may grow, see judgeSurface().
  double fairness = 1.5;
  /// Seams that certainly are G2 stay G2.
  bool keep_curvature = false;
  /// No more repairs are tried after this time; those made so far are proven and kept.
  double max_time_s = std::numeric_limits<double>::infinity();
  int jobs = 0;  ///< threads; 0: one for each processor

  /// The level that a seam has to reach.
  Level level() const { return order == 1 ? Level::G1 : Level::G2; }

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// Options of the analysis that judges a repair.
AnalyzeOptions analyzeOptions(const RepairOptions& options);

struct SeamRepair {
  SeamResult before, after;
  bool treated = false;   ///< the seam was to be repaired
  bool repaired = false;  ///< the seam meets the target, and its change was kept
  /// Why the seam was not treated or not repaired.
  RepairReason reason;
  /// None of its faces can move, but one could with convert_analytic.
  bool wants_conversion = false;
  bool sewn = false;   ///< two edges before, one after
  SewReason not_sewn;  ///< why a matched seam that was to be sewn was not
};

struct FaceMove {
  int face = 0;                ///< number in the given model
  double largest_move_mm = 0;  ///< upper bound, of all its points
  /// Change of the face's surface along iso-lines; nothing where it can't be evaluated.
  std::optional<SurfaceChange> surface = {};
  /// Why it is less fair than before, see docs/theory/repair.md R4; empty if it is not.
  RepairReason less_fair = {};
};

/// An edge that got new pcurves on its faces: another curve, or the old one at another speed.
struct EdgeMove {
  int edge = 0;
  /// Between its old and new image on a face; the sum if it moved several times.
  double largest_move_mm = 0;
};

/// A face without poles that is now a polynomial spline with the same parameters.
struct FaceConversion {
  int face = 0;         ///< number in the given model
  std::string kind;     ///< the kind of surface before
  double error_mm = 0;  ///< of the spline before it moved; its move includes it
};

struct RepairReport {
  /// Same faces, edges and solids in the same order unless something was sewn; shares what stays.
  Model model;
  Report before, after;           ///< seams in the same order, with the numbers of each one's model
  std::vector<SeamRepair> seams;  ///< all seams, in the order of before
  std::vector<FaceMove> moves;    ///< of the faces that moved
  std::vector<FaceConversion> converted;  ///< of moved faces
  /// On faces that stay; numbers of the given model.
  std::vector<EdgeMove> edge_moves;
  /// New numbers by given number (entry 0 is unused); empty if nothing was sewn. An edge that was
  /// cut has several.
  std::vector<int> faces_now;
  std::vector<std::vector<int>> edges_now;
  double repair_s = 0;

  bool sewn() const { return !faces_now.empty(); }
  bool changed() const { return !moves.empty() || !edge_moves.empty() || sewn(); }
};

/// Moves B-spline and Bezier faces, with as little bending as possible, until the chosen seams are
/// smooth. docs/repair.md states all rules.
///
///     const RepairReport report = repair(readModel("part.step"), {.order = 2});
///     if (report.changed()) writeModel(report.model, "smooth.step");
///
/// A seam counts as repaired, and its change is kept, only if these hold afterwards:
///   - Its enclosed figures meet the target at every point.
///   - No other seam is worse.
///   - No face is less fair (judgeSurface()), folded, or moved further than allowed.
///   - No edge lies further from its faces than twice the gap tolerance, or than before.
///   - The shape passes OpenCASCADE's checks as before, and closed solids stay closed.
///
/// Other seams are left as they were, with a reason. With order 2 a seam that can't reach G2 is
/// tried with G1; it does not count as repaired. Faces without poles stay unless they may be
/// converted, and so do faces at non-manifold edges and faces with numbers that are not finite, or
/// 1e100 and more. A model without seams to treat or to sew is returned as it is.
///
/// The given model is not changed. Without a limit of time the result does not depend on the number
/// of jobs.
///
/// \throws std::invalid_argument for invalid options, unknown edges and faces, and edges that are
/// not seams; Cancelled.
/// Source: docs/theory/repair.md R1 to R4.
RepairReport repair(const Model& model, const RepairOptions& options = {},
                    const Progress& progress = {});

}  // namespace seamwright::occ
