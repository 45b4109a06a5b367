// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/fill/fill_reason.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>

namespace seamwright::occ {

struct FillHoleOptions {
  /// What every new seam has to reach. Fills are built for G1 with small jumps of curvature.
  Level target = Level::G1;
  ContinuityTolerance tolerance{.gap_mm = 0.001, .angle_rad = 0.01 * radians_per_degree};
  /// A fill that misses the target is kept too.
  bool keep_anyway = false;
  /// A surface beside the hole may continue through it; false: always patches.
  bool continue_surface = true;
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

struct FillHoleReport {
  Model model;          ///< with the fill, or as given
  bool filled = false;  ///< the fill is in the model
  /// The new faces are regular and not too large, and every new seam certainly reaches the target.
  bool reached = false;
  /// Why the target is not reached, with numbers of the given model; empty if it is.
  FillReason reason;
  std::vector<FilledSide> sides;
  std::vector<FillCorner> corners;
  bool regular = false;       ///< see NSidedFill::regular
  bool meets_others = false;  ///< the new faces run into others, or into each other
  /// Distance of the farthest pole from the middle of the hole's box, over half its diagonal.
  double reach = 0;
  /// See NSidedFill, against neighbours as fitted; nothing if it was not minimised.
  std::optional<double> curvature_jump_per_mm;
  /// Between new faces and others, also measured if the fill was not kept.
  std::vector<SeamResult> outer;
  std::vector<SeamResult> inner;  ///< seams between the new faces
  std::vector<int> faces;         ///< numbers of the new faces in the filled model
  /// By face of the filled model: "face 3", with the number in the given model, or "the fill".
  std::vector<std::string> face_names;
  double build_s = 0;  ///< time to fit the sides and build the surfaces
  double sew_s = 0;
  double measure_s = 0;

  /// \param face from 1, as seams of the filled model name it.
  const std::string& faceName(int face) const {
    return face_names.at(static_cast<std::size_t>(face) - 1);
  }

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
/// four with some above pi, five (ringFill()). Surfaces, names, colours and layers of the
/// neighbours stay; their edges are cut at the middles of the sides. A closed shell becomes a
/// solid, oriented outward.
///
/// The fill is kept if every new seam certainly reaches the target, by enclosures; if the new faces
/// are proved regular, not too large, and clear of others; and if OpenCASCADE's checks pass as
/// before. With keep_anyway it is kept if it could be sewn. Otherwise the model is returned as it
/// is, and the report says how near the fill came.
///
/// A defect of the hole never throws; it is the reason in the report. Not filled are holes with
/// more than 12 corners, with more than 4 of which one is above pi, with one above 5.3 rad, and
/// beside faces or edges with numbers that are not finite, or 1e100 and more.
///
/// The given model is not changed.
/// \param hole one of findHoles() of this model.
/// \throws std::invalid_argument for invalid options and unknown edges; Cancelled.
/// Source: docs/theory/fills.md F2.1 to F2.7, F3.2, F5.1; docs/theory/enclosures.md E3.5, E5.3.
FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options = {},
                        const Progress& progress = {});

/// Removes a face and fills the hole that it leaves. A face with several loops, or with an edge
/// without a neighbour, is not replaced, with a reason. A face with numbers that are not finite can
/// be replaced if those of its edges and neighbours are.
/// \param face from 1, in the order of TopExp::MapShapes.
/// \throws std::invalid_argument for invalid options and an unknown face; Cancelled.
FillHoleReport replaceFace(const Model& model, int face, const FillHoleOptions& options = {},
                           const Progress& progress = {});

}  // namespace seamwright::occ
