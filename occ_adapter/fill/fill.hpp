// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/analyze/analyze.hpp>
#include <seamwright/occ_adapter/fill/holes.hpp>

namespace seamwright::occ {

struct FillHoleOptions {
  /// What every new seam has to reach. Fills are built for G1, what that leaves free is spent on
  /// small jumps of curvature: with G1 in low degrees, with G2 always and in higher ones.
  Level target = Level::G1;
  ContinuityTolerance tolerance{.gap_mm = 0.001, .angle_rad = 0.01 * 0.017453292519943295};
  bool keep_anyway =
      false;  ///< a fill that closes the hole is kept even if it does not reach the target
  bool continue_surface =
      true;                  ///< one face is made where a surface goes on; false: patches always
  double corner_rad = 0.26;  ///< as of HoleOptions
  int most_degree = 9;       ///< of the polynomials that stand for a side, 3 to 11
  int jobs = 0;              ///< threads; 0: one for each processor

  /// Seams of a fill are never taken for creases.
  void setAngle(double angle_rad);
  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// A side of a hole as it was given to nSidedFill().
struct FilledSide {
  std::vector<int> edges;  ///< numbers of the given model
  bool position_only = false;
  int edge_degree = 0, cross_degree = 0;
  double gap_mm = 0;     ///< of the polynomial edge to the faces
  double angle_rad = 0;  ///< of the planes asked for to those of the faces
  /// Of the plane of the fill to the tangent planes of the faces along this side, at both corners.
  std::array<double, 2> corner_rad{};
};

struct FillHoleReport {
  Model model;           ///< with the fill, or as given
  bool filled = false;   ///< the fill is in the model
  bool reached = false;  ///< every new seam surely reaches the target, and the new faces are sound
  std::string
      reason;  ///< why it is not reached, with numbers of the given model; empty where it is
  std::vector<FilledSide> sides;
  std::vector<FillCorner> corners;
  bool regular = false;       ///< as of NSidedFill
  bool meets_others = false;  ///< the new faces run into others, or into one another
  double reach =
      0;  ///< the farthest pole of the fill from the middle of the hole, over that of its sides
  /// As of NSidedFill, against the curvature of the neighbours as it was fitted; nothing where it
  /// was not made small: with the target
  /// G0, with G1 in high degrees.
  std::optional<double> curvature_jump_per_mm;
  std::vector<SeamResult> outer;  ///< between the new faces and the others; measured in the filled
                                  ///< model, also if that was not kept
  std::vector<SeamResult> inner;  ///< between the new faces
  std::vector<int> faces;         ///< numbers of the new faces in the filled model
  /// Of the faces of the filled model: "face 3" with the number in the given one; "the fill".
  std::vector<std::string> face_names;
  double build_s = 0;  ///< fitting the sides and building the surfaces
  double sew_s = 0;
  double measure_s = 0;

  /// \param face from 1, as seams of the filled model name it.
  const std::string& faceName(int face) const {
    return face_names.at(static_cast<std::size_t>(face) - 1);
  }

  /// The largest upper ends over outer and inner seams; nothing where one is not known or nothing
  /// was sewn.
  std::optional<double> largestGap_mm() const;
  std::optional<double> largestAngle_rad() const;
  std::optional<double> largestCurvature_rel() const;
};

/// Fills a hole and sews the faces to the neighbours.
///
/// Where one surface comes within a twentieth of the tolerance of all edges, and for more than G0
/// of the tangent planes along them, the fill is one face on it, whatever the form of the hole: its
/// plane, a plane, cylinder, cone, sphere or torus beside it, or any regular surface that all faces
/// around it lie on. Such a fill has no sides and corners in the report. Else it is built of
/// patches:
///
/// A hole of 3 to 12 corners, none above pi, gets as many faces (nSidedFill()). One of fewer
/// corners is cut into four sides, those first that are longest and turn most, at joints of its
/// edges where these are near, and a smooth one where that does not do at other joints and where it
/// turns most: it gets five faces (ringFill()), as does one of up to four corners of which some are
/// above pi.
///
/// Edges and tangent planes along the sides are fitted by polynomials to a twentieth of the
/// tolerance, exactly where they are such. Where the tangent planes of two sides differ at their
/// corner by more than 0.1 rad, the sides concerned get no tangent planes: position alone. Corners
/// where the neighbours disagree about the mixed derivative get knots (withCornerKnots()).
///
/// The new faces meet in one point inside and along lines from it to the middles of the sides,
/// where the edges of the neighbours are cut: both halves of a side become an edge that lies
/// halfway between the faces, with a path on both and the tolerance that is measured. Surfaces of
/// neighbours stay. A shell that is closed becomes a solid, turned outward.
///
/// Then every new seam is measured as one edge, by enclosures. The target is reached if they surely
/// reach it, and the new faces are proved regular, stand out to three times the size of the hole at
/// most, and touch no face that they share no vertex with. Where that fails, sides of degree 5 are
/// tried, and a fill that leaves curvature alone; the better one counts. The fill is kept if the
/// target is reached and OpenCASCADE's checks pass for the new faces, and for the neighbours and
/// the shape as before; with keep_anyway also if the target is missed, as long as it could be sewn.
/// Else the model comes back as it is, with how near the fill came. Names, colours and layers stay.
///
/// A smooth loop of which the neighbours are to be met with G0 alone gets no tangent planes: a flat
/// one stays flat.
///
/// A hole with more than 12 corners, more than 4 one of which is above pi, or one above 5.3 rad is
/// not filled.
/// \param hole one of findHoles() of this model. Nothing that is wrong with the hole throws: it is
/// a reason.
///
/// Faces with numbers that are not finite, or 1e100 and more, stay as they are, and nothing is
/// checked against them: neither OpenCASCADE's checks nor whether the fill runs into them. A shell
/// that has one becomes no solid, nor is a solid that has one turned. A hole that is bounded by
/// such a face or edge is not filled, with that reason.
/// \throws std::invalid_argument for bad options and for a hole with an edge that the model does
/// not have; Cancelled.
/// Source: docs/theory/fills.md F2.1 to F2.7, F3.2, F5.1; docs/theory/enclosures.md E3.5, E5.3.
FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options = {},
                        const Progress& progress = {});

/// Takes a face out and fills the hole that it leaves. \param face from 1, order of
/// TopExp::MapShapes. A face that has several loops, or a neighbour on one side only, is not
/// replaced; the model comes back as it is, with the reason. A face with numbers that are not
/// finite can be replaced where its edges and the faces beside it have none.
/// \throws std::invalid_argument for bad options and for a face that the model does not have;
/// Cancelled.
FillHoleReport replaceFace(const Model& model, int face, const FillHoleOptions& options = {},
                           const Progress& progress = {});

}  // namespace seamwright::occ
