// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/surface/judge.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>

namespace seamwright::occ {

struct RepairOptions {
  int order = 1;                  ///< 1: G1, 2: G2
  ContinuityTolerance tolerance;  ///< what a seam must meet to count as repaired
  /// Larger than zero. No pole may move further, and no point of an edge on its face. None: by a
  /// hundredth of the size of the face, see sizeOf_mm(), and twice the largest gap of its seams to
  /// be repaired.
  std::optional<double> max_move_mm;
  /// Edges whose seams are treated, from 1, order of TopExp::MapShapes; empty: all seams of class
  /// defect.
  std::vector<int> edges;
  std::vector<int> fixed_faces;  ///< faces that stay
  double match_mm = 0;           ///< also open edges within this distance of one another; 0: none
  bool sew = true;  ///< matched seams that meet within the gap tolerance become one edge
  bool convert_analytic =
      false;  ///< planes, cylinders and the like may become splines where they have to move
  /// A face may not become worse: its curvature may vary so many times as much as before, see
  /// judgeSurface().
  double fairness = 1.5;
  /// A seam that surely is G2 stays so also where G1 is asked for.
  bool keep_curvature = false;
  /// After this time no more repairs are tried; what was repaired so far is kept. The analysis
  /// counts, but is never cut short. Sewing, and the proof of what is kept, come after it.
  double max_time_s = std::numeric_limits<double>::infinity();
  int jobs = 0;  ///< threads; 0: one for each processor

  /// What a seam has to reach.
  Level level() const { return order == 1 ? Level::G1 : Level::G2; }

  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// The analysis that a repair is judged by.
AnalyzeOptions analyzeOptions(const RepairOptions& options);

/// A seam before and after.
struct SeamRepair {
  SeamResult before, after;
  bool treated = false;   ///< it was to be repaired
  bool repaired = false;  ///< it meets the target, and its change was kept
  /// Why it was not treated or not repaired; of a matched one that is left it begins with the note
  /// before.
  std::string reason;
  /// It was meant and not repaired, and no face of it can move, but one could as a spline: see
  /// RepairOptions::convert_analytic.
  bool wants_conversion = false;
  bool sewn = false;     ///< two edges before, one after
  std::string not_sewn;  ///< of a matched seam that was to be sewn: why it was not
};

struct FaceMove {
  int face = 0;  ///< number in the given model
  /// No point of the face moved further: the largest of the poles of the part that it shows, in the
  /// knots that it has now.
  double largest_move_mm = 0;
  /// Of the face's surface, on a grid of lines that is even in its knot spans; nothing where
  /// OpenCASCADE can't evaluate it.
  std::optional<SurfaceChange> surface = {};
  /// Of that change. What may be added to the variation is visibleVariation() for the accepted
  /// angle over the diagonal of the face's box, and for the angles of its treated seams over the
  /// mean width of the face beside them.
  SurfaceVerdict verdict = {};
};

/// An edge that runs elsewhere on the faces beside it, or along them at another speed.
struct EdgeMove {
  int edge = 0;
  double largest_move_mm = 0;  ///< how far its image on a face is from the one before; the sum
                               ///< where it moved several times
};

/// A face that was a plane, a cylinder, ... and is a polynomial spline with the same parameters
/// now.
struct FaceConversion {
  int face = 0;         ///< number in the given model
  std::string kind;     ///< what it was
  double error_mm = 0;  ///< of the spline before it moved; contained in its move
};

struct RepairReport {
  /// Same faces, edges and solids in the same order unless something was sewn; what did not change
  /// is shared with the given one.
  Model model;
  Report before, after;  ///< seams in the same order; each with the numbers of its own model
  std::vector<SeamRepair> seams;          ///< all seams, in the order of before
  std::vector<FaceMove> moves;            ///< of the faces that moved
  std::vector<FaceConversion> converted;  ///< of moved faces
  /// Of the edges that run elsewhere on faces that stay; numbers of the given model.
  std::vector<EdgeMove> edge_moves;
  /// What has which number in model, by its number in the given one (from 1; the first stands for
  /// none); empty if nothing was sewn. Edges that were sewn have one number; one that was cut has
  /// several, in the sense of its curve, and is in the reports with the first.
  std::vector<int> faces_now;
  std::vector<std::vector<int>> edges_now;
  double repair_s = 0;

  bool sewn() const { return !faces_now.empty(); }
  bool changed() const { return !moves.empty() || !edge_moves.empty() || sewn(); }
};

/// Moves B-spline and Bezier faces, with the least bending, until the seams chosen are smooth;
/// proves it, or leaves them as they were. Planes, cylinders and the like stay, and faces that have
/// an edge where three or more meet.
///
/// First, where the gap alone is too large and the surfaces meet near the edge, the edge gets new
/// paths on its faces, between the same ends, and no surface moves. Then all faces beside the other
/// seams move at once: each by a displacement with few knots of its own, which has the least
/// bending energy, over what the face may spend, that brings the seams within the tolerance and
/// keeps what other edges have. Edges slide on faces that stay, where there is surface on both
/// sides of them and the face is not fixed. What can't be met so, or makes a face less fair
/// (judgeSurface()), or another seam worse, is given up, one seam of a face after the other, until
/// the rest can be proven. Source: docs/theory/repair.md.
///
/// With order 2, seams that can't have one curvature are tried as G1, if they lack that too: they
/// are not repaired then, but left better. A seam that has neither has a reason of the form "...;
/// G1: ...".
///
/// A seam that would be a crease (see judge()) if its sides met gets its gap closed and stays
/// sharp, unless its edge was picked. Where faces fold back on one another below the crease angle
/// nothing is tried.
///
/// A treated seam counts as repaired, and its change is kept, only if afterwards its enclosed
/// figures meet the target (of a sharp one: its gap does); no other seam of the model is worse than
/// it was; no face is less fair; no pole moved further than it may; no face folded; no edge lies
/// further from its faces than twice the gap tolerance or what it had; and the shape passes
/// OpenCASCADE's checks as before, closed solids stay closed, and their volume changed by no more
/// than the moves explain. What could not be repaired is told with the reason and left as it was. A
/// seam on a moved face, or between two, may be left better than it was.
///
/// A seam is worse if it was a crease and is a defect, or it is less certain; if its level is
/// lower, above the level asked for only with keep_curvature and where it had the higher one for
/// sure (where a side is nearly flat the figures often can't tell); if it was a crease whose
/// largest angle changed by more than the angle tolerance and what treated seams lose at its ends;
/// or if a figure that the target asks for, of a crease the gap alone, is surely above its
/// tolerance and exceeds its upper bound in the model given by more than a tenth of the tolerance.
/// Figures within the tolerance are as good as one another, and so are those that differ by less
/// than that tenth. A model without seams to treat or to sew comes back as it is, sharing
/// everything.
///
/// Faces with numbers that are not finite, or 1e100 and more, stay as they are, as do the faces
/// that share an edge with them. Their seams can't be measured, so they are not repaired, with that
/// reason. No check of OpenCASCADE looks at them, and the shape as a whole is not checked then. A
/// shell that has one becomes no solid by sewing, nor is a solid that has one turned.
///
/// With convert_analytic other faces than splines may move too (planes, cylinders, cones, spheres,
/// tori, extrusions, ...), as polynomial splines with the same parameters, so that edges keep their
/// paths: planes and extrusions of splines exactly, others to a thousandth of the gap tolerance.
/// That is done where it helps: beside seams where nothing else may move, one face of each first,
/// else beside seams that were not repaired; what did not move stays what it was. No seam has then
/// a level lower than the model surely had before conversion.
///
/// A part with several instances is repaired in its first place, and changed alike in all others:
/// edges picked and faces fixed in one place are so in all. Seams in the other places are measured
/// there; where rounding makes one less certain, it is not repaired, with that reason. Instances
/// that have an edge or a face in common with other parts stay, and so do all with match_mm above
/// 0.
///
/// At last matched seams (of the edges picked, or all) are sewn, creases too, if they surely meet
/// within the gap tolerance: their two edges become one halfway between them, with a path on both
/// faces and the tolerance that is measured. Of edges that are longer than what lies beside them
/// the interval is cut out. Vertices are merged where edges end together; what ends nearer than the
/// gap tolerance to a vertex ends there. Faces that hang together so become one shell, turned as
/// the first of them, and a closed one a solid, turned outward; it stands where the first part
/// (face, shell, or solid of one shell) stood that it is made of. Surfaces stay, and so do fixed
/// faces. The order of the faces stays if the faces of each new shell stood one after another.
/// Names, colours and layers stay with their faces, edges and vertices; those of shells and solids
/// that became part of another go to their faces, as far as these have none. A seam that moved
/// apart by more than match_mm is sewn over all of the interval that was found in the given model.
/// It is kept only if each sewn seam, measured again as one edge, has a gap within the tolerance
/// and the level that it surely had; if the faces and the shape pass OpenCASCADE's checks as
/// before; and if no vertex reaches further than twice the gap tolerance or what it did. Parts with
/// several instances, solids of several shells and faces that have one surface in common are not
/// sewn.
///
/// \throws std::invalid_argument for bad options, also for edges and faces that the model does not
/// have and edges that are no seam; Cancelled.
/// Source: docs/theory/repair.md R1 to R4.
RepairReport repair(const Model& model, const RepairOptions& options = {},
                    const Progress& progress = {});

}  // namespace seamwright::occ
