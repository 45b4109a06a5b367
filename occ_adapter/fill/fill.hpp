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
  /// The level that every new seam has to reach. Fills are built for G1. The remaining freedom
  /// minimises the jumps of curvature: for target G1 only in low degrees, for target G2 always and
  /// in higher degrees.
  Level target = Level::G1;
  ContinuityTolerance tolerance{.gap_mm = 0.001, .angle_rad = 0.01 * 0.017453292519943295};
  /// A fill that closes the hole is kept even if it misses the target.
  bool keep_anyway = false;
  /// If a surface beside the hole continues through it, the fill is one face on it; false:
  /// always patches.
  bool continue_surface = true;
  double corner_rad = 0.26;  ///< see HoleOptions::corner_rad
  int most_degree = 9;       ///< largest degree of the polynomials fitted to a side, 3 to 11
  int jobs = 0;              ///< threads; 0: one for each processor

  /// Sets the accepted angle. A smaller crease angle is raised to it, so that no accepted seam of a
  /// fill counts as a crease.
  void setAngle(double angle_rad);
  /// \throws std::invalid_argument with the offending number.
  void validate() const;
};

/// A side of a hole as it was passed to nSidedFill().
struct FilledSide {
  std::vector<int> edges;  ///< edge numbers of the given model
  bool position_only = false;
  int edge_degree = 0, cross_degree = 0;
  double gap_mm = 0;     ///< distance of the polynomial edge to the faces
  double angle_rad = 0;  ///< angle of the requested tangent planes to those of the faces
  /// Angle, at both corners of the side, between the plane of the fill and the tangent plane of the
  /// face beside this side.
  std::array<double, 2> corner_rad{};
};

struct FillHoleReport {
  Model model;          ///< with the fill, or as given
  bool filled = false;  ///< the fill is in the model
  /// Every new seam certainly reaches the target, and the new faces are regular and within their
  /// size limit.
  bool reached = false;
  /// Why the target is not reached, with numbers of the given model; empty if it is reached.
  FillReason reason;
  std::vector<FilledSide> sides;
  std::vector<FillCorner> corners;
  bool regular = false;       ///< see NSidedFill::regular
  bool meets_others = false;  ///< the new faces run into others, or into each other
  /// Distance of the farthest pole of the fill from the middle of the box of the hole's sides,
  /// over half the diagonal of that box.
  double reach = 0;
  /// See NSidedFill, relative to the fitted curvature of the neighbours; nothing if it was not
  /// minimised: with target G0, and with target G1 in high degrees.
  std::optional<double> curvature_jump_per_mm;
  /// Seams between the new faces and the others, measured in the filled model even if that was not
  /// kept.
  std::vector<SeamResult> outer;
  std::vector<SeamResult> inner;  ///< seams between the new faces
  std::vector<int> faces;         ///< numbers of the new faces in the filled model
  /// Names of the faces of the filled model: "face 3", with the number in the given model, or "the
  /// fill".
  std::vector<std::string> face_names;
  double build_s = 0;  ///< time to fit the sides and build the surfaces
  double sew_s = 0;
  double measure_s = 0;

  /// \param face from 1, as seams of the filled model name it.
  const std::string& faceName(int face) const {
    return face_names.at(static_cast<std::size_t>(face) - 1);
  }

  /// The largest upper bound over outer and inner seams; nothing if a bound is not known or nothing
  /// was sewn.
  std::optional<double> largestGap_mm() const;
  std::optional<double> largestAngle_rad() const;
  std::optional<double> largestCurvature_rel() const;
};

/// Fills a hole and sews the faces to the neighbours.
///
/// If one surface continues through the hole, the fill is one face on it, whatever the form of the
/// hole. The surface must come within a twentieth of the tolerance of all edges and, for targets
/// above G0, of the tangent planes along them. It is the plane of the hole; a plane, cylinder,
/// cone, sphere or torus beside it; or any regular surface on which all faces around it lie. Such a
/// fill has no sides and corners in the report. Otherwise the fill is built of patches:
///
/// A hole of 3 to 12 corners, none above pi, gets as many faces (nSidedFill()). A hole with fewer
/// corners is cut into four sides and gets five faces (ringFill()). The sides that are longest and
/// turn most are cut first, at joints of edges where these are near. If that fails for a smooth
/// loop, it is cut at other joints and where it turns most. A hole of up to four corners of which
/// some are above pi also gets five faces.
///
/// Edges and tangent planes along the sides are fitted by polynomials to a twentieth of the
/// tolerance, and exactly where they are polynomials. Where the tangent planes of two sides differ
/// at their corner by more than 0.1 rad, these sides have position only, without tangent planes.
/// Corners where the neighbours disagree about the twist get knots (withCornerKnots()).
///
/// The new faces meet at one inner point and along lines from it to the middles of the sides. The
/// edges of the neighbours are cut at these middles. Each half of a side becomes an edge halfway
/// between its faces, with a pcurve on both and a tolerance as measured. Surfaces of neighbours
/// stay. A closed shell becomes a solid, oriented outward.
///
/// Then every new seam is measured as one edge, by enclosures. The fill reaches the target if every
/// seam certainly reaches it, and if the new faces are proved regular, reach out to at most three
/// times the size of the hole, and touch other faces only near shared edges and vertices. Otherwise
/// sides of degree 5 are tried, and a fill that ignores curvature; the better one counts. The fill
/// is kept if it reaches the target and OpenCASCADE's checks pass for the new faces, and as before
/// for the neighbours and the shape. With keep_anyway it is kept even if it misses the target, as
/// long as it could be sewn. Otherwise the model is returned as it is, and the report says how near
/// the fill came. Names, colours and layers stay.
///
/// A smooth loop with target G0 gets no tangent planes, so the fill of a flat loop is flat.
///
/// A hole is not filled if it has more than 12 corners, more than 4 of which one is above pi, or a
/// corner above 5.3 rad.
///
/// A defect of the hole never throws. The report has it as the reason.
///
/// Faces with numbers that are not finite, or 1e100 and more, stay as they are and are not part of
/// any check: neither OpenCASCADE's checks nor the test whether the fill runs into other faces. A
/// shell with such a face does not become a solid, and a solid with one is not reoriented. A hole
/// that is bounded by such a face or edge is not filled, with that reason.
/// \param hole one of findHoles() of this model.
/// \throws std::invalid_argument for invalid options and for a hole with an edge that the model
/// does not have; Cancelled.
/// Source: docs/theory/fills.md F2.1 to F2.7, F3.2, F5.1; docs/theory/enclosures.md E3.5, E5.3.
FillHoleReport fillHole(const Model& model, const Hole& hole, const FillHoleOptions& options = {},
                        const Progress& progress = {});

/// Removes a face and fills the hole that it leaves. A face that has several loops, or an edge
/// without a neighbour, is not replaced; the model is returned as it is, with the reason. A face
/// with numbers that are not finite can be replaced if its edges and the faces beside it have only
/// finite ones.
/// \param face from 1, in the order of TopExp::MapShapes.
/// \throws std::invalid_argument for invalid options and for a face that the model does not have;
/// Cancelled.
FillHoleReport replaceFace(const Model& model, int face, const FillHoleOptions& options = {},
                           const Progress& progress = {});

}  // namespace seamwright::occ
