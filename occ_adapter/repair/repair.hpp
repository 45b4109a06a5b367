// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/surface/judge.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/repair/repair_reason.hpp>

namespace seamwright::occ {

struct RepairOptions {
  int order = 1;                  ///< 1: G1, 2: G2
  ContinuityTolerance tolerance;  ///< what a seam must meet to count as repaired
  /// Upper bound, above zero, of the move of a pole and of a point of an edge on its face. Without
  /// a value the limit of a face is a hundredth of its size, see sizeOf_mm(), plus twice the
  /// largest gap of its seams to be repaired.
  std::optional<double> max_move_mm;
  /// Edges whose seams are treated, from 1, in the order of TopExp::MapShapes; empty: all seams of
  /// class defect.
  std::vector<int> edges;
  std::vector<int> fixed_faces;  ///< faces that stay
  /// Faces that stay because their move makes a seam worse in the written file.
  std::vector<int> held_faces;
  /// Free edges within this distance of each other also form seams; 0: none do.
  double match_mm = 0;
  bool sew = true;  ///< matched seams that meet within the gap tolerance become one edge
  /// Analytic faces may become splines where they have to move.
  bool convert_analytic = false;
  /// Factor by which the variation of a face's curvature may grow, see judgeSurface().
  double fairness = 1.5;
  /// Seams that certainly are G2 stay G2 even if G1 is the target.
  bool keep_curvature = false;
  /// No more repairs are tried after this time; repairs made so far are kept. The time of the
  /// analysis counts, but the analysis always runs to its end. Sewing, and the proof of what is
  /// kept, come after the limit.
  double max_time_s = std::numeric_limits<double>::infinity();
  int jobs = 0;  ///< threads; 0: one for each processor

  /// The level that a seam has to reach.
  Level level() const { return order == 1 ? Level::G1 : Level::G2; }

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// Options of the analysis that judges a repair.
AnalyzeOptions analyzeOptions(const RepairOptions& options);

/// A seam before and after.
struct SeamRepair {
  SeamResult before, after;
  bool treated = false;   ///< the seam was to be repaired
  bool repaired = false;  ///< the seam meets the target, and its change was kept
  /// Why the seam was not treated or not repaired. For a matched seam that is left as it was, the
  /// text begins with the note of SeamRepair::before.
  RepairReason reason;
  /// The seam was meant but not repaired: none of its faces can move, but one could as a spline.
  /// See RepairOptions::convert_analytic.
  bool wants_conversion = false;
  bool sewn = false;     ///< two edges before, one after
  std::string not_sewn;  ///< why a matched seam that was to be sewn was not
};

struct FaceMove {
  int face = 0;  ///< number in the given model
  /// Upper bound of the move of any point of the face: the largest move of a pole of the part that
  /// the face shows, in its new knots.
  double largest_move_mm = 0;
  /// Change of the face's surface, on a grid of lines equally spaced in its knot spans; nothing
  /// where OpenCASCADE can't evaluate the surface.
  std::optional<SurfaceChange> surface = {};
  /// Verdict on that change. The variation may grow by visibleVariation() of the accepted angle
  /// over the diagonal of the face's box, and by that of the angles of its treated seams over the
  /// mean width of the face beside them.
  SurfaceVerdict verdict = {};
};

/// An edge that has a new path on its faces, or runs along the old one at another speed.
struct EdgeMove {
  int edge = 0;
  /// Largest distance between its old and new image on a face; the sum if it moved several times.
  double largest_move_mm = 0;
};

/// A face that was analytic (or another surface without poles) and is now a polynomial spline with
/// the same parameters.
struct FaceConversion {
  int face = 0;         ///< number in the given model
  std::string kind;     ///< the kind of surface before
  double error_mm = 0;  ///< error of the spline before it moved; its move includes it
};

struct RepairReport {
  /// The repaired model. It has the same faces, edges and solids in the same order unless something
  /// was sewn. Unchanged parts are shared with the given model.
  Model model;
  Report before, after;  ///< seams in the same order; each report uses the numbers of its own model
  std::vector<SeamRepair> seams;          ///< all seams, in the order of before
  std::vector<FaceMove> moves;            ///< of the faces that moved
  std::vector<FaceConversion> converted;  ///< of moved faces
  /// Edges with a new path on faces that stay; numbers of the given model.
  std::vector<EdgeMove> edge_moves;
  /// Numbers in the new model by number in the given one (from 1; entry 0 is unused); empty if
  /// nothing was sewn. Two edges that were sewn have the same number. An edge that was cut has
  /// several numbers, in the direction of its curve; the reports use the first one.
  std::vector<int> faces_now;
  std::vector<std::vector<int>> edges_now;
  double repair_s = 0;

  bool sewn() const { return !faces_now.empty(); }
  bool changed() const { return !moves.empty() || !edge_moves.empty() || sewn(); }
};

/// Moves B-spline and Bezier faces, with the least bending, until the chosen seams are smooth. The
/// result is proven; seams without a proof are left as they were. Analytic faces and faces with a
/// non-manifold edge stay.
///
/// First, where only the gap is too large and the surfaces meet near the edge, the edge gets new
/// pcurves with the same ends, and no surface moves. Then all faces beside the other seams move at
/// once. Each face gets a displacement with a few knots of its own. Together, the displacements
/// have the least bending energy, relative to the budgets of the faces, that brings the seams
/// within the tolerance and keeps the figures of other edges. Edges slide on faces that stay, where
/// the surface extends on both sides of the edge and the face is not fixed. A seam that can't be
/// met, or whose repair makes a face less fair (judgeSurface()) or another seam worse, is excluded,
/// one seam of a face after the other, until the rest can be proven.
/// Source: docs/theory/repair.md.
///
/// With order 2, a seam that can't reach G2 is tried with G1 if it lacks G1 too. It does not count
/// as repaired then, but is better than before. A seam that reaches neither has a reason of the
/// form "...; G1: ...".
///
/// If a seam would be a crease (see judge()) with its gap closed, the gap is closed and the seam
/// stays sharp, unless its edge was picked. Seams whose faces fold back on one another below the
/// crease angle are not tried.
///
/// A treated seam counts as repaired, and its change is kept, only if all of these hold afterwards:
/// - Its enclosed figures meet the target (for a sharp seam, its gap does).
/// - No other seam of the model is worse than before.
/// - No face is less fair, moved a pole further than allowed, or folded.
/// - No edge lies further from its faces than twice the gap tolerance, or than before.
/// - The shape passes OpenCASCADE's checks as before.
/// - Closed solids stay closed, and their volume changed by no more than the moves explain.
///
/// A seam that could not be repaired is reported with the reason and left as it was. A seam on a
/// moved face, or between two moved faces, may be better than before.
///
/// A seam is worse in these cases:
/// - It was a crease and is a defect, or it is less certain.
/// - Its level is lower. Above the target this counts only with keep_curvature, and only if the
///   seam certainly had the higher level (where a side is nearly flat the figures often can't
///   tell).
/// - It was a crease, and its largest angle changed by more than the angle tolerance plus the angle
///   that treated seams lose at its ends.
/// - A figure that the target asks for (of a crease the gap alone) is certainly above its tolerance
///   and exceeds its upper bound in the given model by more than a tenth of the tolerance. A
///   difference of curvature must also exceed that bound by a tenth of itself.
///
/// Figures within the tolerance count as equal, and so do figures that differ by less than that
/// tenth. A model without seams to treat or to sew is returned as it is and shares everything.
///
/// Faces with numbers that are not finite, or 1e100 and more, stay as they are, and so do the faces
/// that share an edge with them. Their seams can't be measured, so they are not repaired, with that
/// reason. OpenCASCADE's checks skip these faces, and the shape as a whole is not checked then.
/// Sewing does not turn a shell with such a face into a solid and does not reorient a solid with
/// one.
///
/// With convert_analytic, faces that are not splines may move too (planes, cylinders, cones,
/// spheres, tori, extrusions, ...). They become polynomial splines with the same parameters, so
/// that edges keep their pcurves. Planes and extrusions of splines are converted exactly, others to
/// a thousandth of the gap tolerance. Conversion is done where it helps: first for one face of each
/// seam that has no movable face, then for faces beside seams that were not repaired. A face that
/// did not move stays what it was. No seam has a lower level afterwards than it certainly had
/// before conversion.
///
/// A part with several instances is repaired in its first instance, and all others change alike. An
/// edge picked or a face fixed in one instance is so in all. The seams of the other instances are
/// measured there. If rounding makes one of these less certain, the seam is not repaired, with that
/// reason. Instances that share an edge or a face with other parts stay, and so do all instances if
/// match_mm is above 0.
///
/// Finally matched seams (of the picked edges, or all), creases too, are sewn if they certainly
/// meet within the gap tolerance. Their two edges become one edge halfway between them, with a
/// pcurve on both faces and a tolerance as measured. If an edge is longer than the edge beside it,
/// the matched interval is cut out. Vertices are merged where edges end together. An edge that ends
/// nearer than the gap tolerance to a vertex ends at that vertex. Connected faces become one shell,
/// oriented as the first of them. A closed shell becomes a solid, oriented outward. The new part
/// takes the position of the first part (face, shell, or solid of one shell) that it is made from.
/// Surfaces stay, and so do fixed faces. The faces keep their order if the faces of each new shell
/// were consecutive. Names, colours and layers stay with their faces, edges and vertices. Those of
/// shells and solids that became part of another one go to their faces, as far as these have none.
/// A seam that moved apart by more than match_mm is sewn over the whole interval that was found in
/// the given model.
///
/// Sewing is kept only if each sewn seam, measured again as one edge, has a gap within the
/// tolerance and the level that it certainly had; if the faces and the shape pass OpenCASCADE's
/// checks as before; and if the tolerance of each vertex is at most twice the gap tolerance, or
/// what it was. Parts with several instances, solids of several shells and faces that share one
/// surface are not sewn.
///
/// \throws std::invalid_argument for invalid options, for edges and faces that the model does not
/// have, and for edges that are not seams; Cancelled.
/// Source: docs/theory/repair.md R1 to R4.
RepairReport repair(const Model& model, const RepairOptions& options = {},
                    const Progress& progress = {});

}  // namespace seamwright::occ
