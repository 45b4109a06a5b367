// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/fill/fill_reason.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>
#include <seamwright/occ_adapter/repair/repair_reason.hpp>

namespace seamwright::occ {

struct FillHoleOptions {
  /// What every new seam has to reach. Fills are built for G1 with small jumps of curvature.
  Level target = Level::G1;
  ContinuityTolerance tolerance{.gap_mm = 0.001, .angle_rad = 0.01 * radians_per_degree};
  /// A fill that misses the target is kept too.
  bool keep_anyway = false;
  /// A surface beside the hole may continue through it; false: patches or a graph.
  bool continue_surface = true;
  /// Where patches miss the target one face between four sides may fill the hole.
  bool sheet = true;
  /// Where this misses it too, one face over a plane may.
  bool graph = true;
  double corner_rad = 0.26;  ///< see HoleOptions::corner_rad
  int most_degree = 9;       ///< largest degree of the polynomials fitted to a side, 3 to 11
  int jobs = 0;              ///< threads; 0: one for each processor

  /// Sets the accepted angle, and raises a smaller crease angle to it.
  void setAngle(double angle_rad);
  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

struct FilledSide {
  std::vector<int> edges;  ///< edge numbers of the given model
  bool position_only = false;
  int edge_degree = 0, cross_degree = 0;
  double gap_mm = 0;     ///< distance of the polynomial edge to the faces
  double angle_rad = 0;  ///< angle of the fitted tangent planes to those of the faces
  /// Angle of the fill's plane to that of the face beside this side, at both corners.
  std::array<double, 2> corner_rad{};
};

/// What a fill consists of.
enum class FillMethod {
  None,     ///< nothing was built
  Surface,  ///< one face on a surface beside the hole, or on its plane
  Patches,  ///< patches that meet in the hole
  Graph,    ///< one face on a spline over a plane
  Sheet     ///< one face on a spline whose four edges are the sides of the hole
};

/// "", "surface", "patches", "graph" or "sheet".
const char* name(FillMethod method);

/// A seam that missed the tolerances and was not repaired.
struct LeftSeam {
  std::vector<int> edges;  ///< numbers of the given model
  RepairReason reason;
};

/// What was repaired around a hole before it was filled.
struct RepairedAround {
  std::vector<int> edges;  ///< of the seams that end at the hole; numbers of the given model
  int treated = 0;         ///< those that missed the tolerances
  int repaired = 0;
  std::vector<LeftSeam> left;
  double largest_move_mm = 0;  ///< of a face around
  /// false: only the fill of the model as it was given reaches the target, so the repair is left
  /// out.
  bool used = true;
};

struct FillHoleReport {
  Model model;          ///< with the fill, or as given
  bool filled = false;  ///< the fill is in the model
  /// The new faces are regular and not too large, and every new seam certainly reaches the target.
  bool reached = false;
  /// Why the target is not reached, with numbers of the given model; empty if it is.
  FillReason reason;
  FillMethod method = FillMethod::None;
  std::vector<FilledSide> sides;
  std::vector<FillCorner> corners;
  bool regular = false;       ///< see NSidedFill::regular
  bool meets_others = false;  ///< the new faces run into others, or into each other
  /// Distance of the farthest pole from the middle of the hole's box, over half its diagonal.
  double reach = 0;
  /// See NSidedFill, against neighbours as fitted; nothing if it was not minimised.
  std::optional<double> curvature_jump_per_mm;
  /// The largest normal curvature of the new faces, of those beside them and of those that they
  /// replace, at points inside; nothing if the fill was not kept, or if no face was taken out.
  std::optional<double> curvature_per_mm, around_curvature_per_mm, removed_curvature_per_mm;
  /// The smaller one of the largest mean curvatures to either side of the new faces: large in
  /// dents and waves, small in domes and saddles.
  std::optional<double> both_ways_per_mm;
  /// Between new faces and others, also measured if the fill was not kept.
  std::vector<SeamResult> outer;
  std::vector<SeamResult> inner;  ///< seams between the new faces
  std::vector<int> faces;         ///< numbers of the new faces in the filled model
  /// By face of the filled model: "face 3", with the number in the given model, or "the fill".
  std::vector<std::string> face_names;
  double build_s = 0;  ///< time to fit the sides and build the surfaces
  double sew_s = 0;
  double measure_s = 0;
  std::optional<RepairedAround> around;  ///< only of repairedAndFilledHole() and the like

  /// \param face from 1, as seams of the filled model name it.
  const std::string& faceName(int face) const {
    return face_names.at(static_cast<std::size_t>(face) - 1);
  }

  /// both_ways_per_mm over around_curvature_per_mm, if that is 2 or more: such a fill has dents or
  /// waves, whatever its seams. Nothing beside flat faces.
  std::optional<double> waves() const;
  /// The largest upper bounds over all new seams; nothing if one is not known or nothing was sewn.
  std::optional<double> largestGap_mm() const;
  std::optional<double> largestAngle_rad() const;
  std::optional<double> largestCurvature_rel() const;
};

/// Fills a hole and sews the faces to the neighbours. See docs/fill.md.
///
///     for (const Hole& hole : findHoles(model.shape).holes) {
///       const FillHoleReport report = fillHole(model, hole);
///       if (report.filled) return report.model;
///     }
///
/// If one surface continues through the hole, within a twentieth of the tolerance of all edges and,
/// above G0, of the tangent planes along them, the fill is one face on it. Otherwise a hole of 3 to
/// 12 corners, none above pi, gets as many patches (nSidedFill()), and one of fewer corners, or of
/// four with some above pi, five (ringFill()). If these do not reach the target, a hole of four
/// corners gets one face on a spline between its sides (sheetFill()). Otherwise, if the faces
/// around the hole can all be seen from one direction, the fill is one trimmed face on a spline
/// over a plane, for any number of corners of any angle (graphFill()). Surfaces, names, colours and
/// layers of the neighbours stay; their edges are cut at the middles of the sides. A closed shell
/// becomes a solid, oriented outward.
///
/// The fill is kept if every new seam certainly reaches the target, by enclosures; if the new faces
/// are proved regular, not too large, and clear of others; and if OpenCASCADE's checks pass as
/// before. With keep_anyway it is kept if it could be sewn. Otherwise the model is returned as it
/// is, and the report says how near the fill came.
///
/// A defect of the hole never throws; it is the reason in the report. Not filled are holes beside
/// faces or edges with numbers that are not finite, or 1e100 and more.
///
/// The given model is not changed.
/// \param hole one of findHoles() of this model.
/// \throws std::invalid_argument for invalid options and unknown edges; Cancelled.
/// Source: docs/theory/fills.md F2.1 to F2.7, F3.2, F5.1; docs/theory/enclosures.md E3.5, E5.3.
FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options = {},
                        const Progress& progress = {});

/// Removes faces and fills the hole that they leave. Faces that leave several loops, or have an
/// edge without a neighbour, are not replaced, with a reason. Faces with numbers that are not
/// finite can be replaced if those of the edges around them and of their neighbours are.
/// \param faces from 1, in the order of TopExp::MapShapes; at least one, each once.
/// \throws std::invalid_argument for invalid options, no face, unknown faces and a face that is
/// given twice; Cancelled.
FillHoleReport replaceFaces(const Model& model, const std::vector<int>& faces,
                            const FillHoleOptions& options = {}, const Progress& progress = {});
/// The same for one face.
FillHoleReport replaceFace(const Model& model, int face, const FillHoleOptions& options = {},
                           const Progress& progress = {});

}  // namespace seamwright::occ
