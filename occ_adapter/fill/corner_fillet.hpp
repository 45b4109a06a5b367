// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/fill/corner_reason.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Options of cornerFillet(). Edges are numbered from 1, in the order of TopExp::MapShapes.
struct CornerFilletOptions {
  std::map<int, double> radii_mm;  ///< of every edge at the vertex
  /// Distance from the vertex, along the edge, to the section where its fillet ends; without a
  /// value, or with 0, it is chosen.
  std::map<int, double> setbacks_mm;
  /// Largest gap between cylinders and patches, in [1e-9, 0.1]. At curved faces the sides are
  /// fitted to a twentieth of the tolerance instead.
  double section_mm = 1e-6;
  ContinuityTolerance tolerance;  ///< what the new seams must meet
  bool patches_only = false;      ///< OpenCASCADE's own fillet is no result
  int jobs = 0;                   ///< threads; 0: one for each processor

  /// The setback of an edge; nothing if it is to be chosen.
  std::optional<double> setback_mm(int edge) const;

  /// \throws std::invalid_argument with the edge and the offending number.
  void validate() const;
};

/// The faces that a new edge separates.
enum class CornerSeamKind {
  Spoke,    ///< two patches
  Section,  ///< a patch and a fillet
  Spring,   ///< a patch and a face
  Contact,  ///< a fillet and a face
  Fillets   ///< two fillets, where OpenCASCADE fills the corner
};

/// What closes the corner between the fillets.
enum class CornerFiller {
  Patches,     ///< of nSidedFill() or fillHole()
  OpenCascade  ///< the fillets that BRepFilletAPI_MakeFillet makes of all edges
};

struct CornerSeam {
  CornerSeamKind kind = CornerSeamKind::Spoke;
  SeamResult result;  ///< with the numbers of the new model
};

/// An edge at the vertex and the fillet that rounds it.
struct CornerFilletEdge {
  int edge = 0;  ///< number in the given model
  bool convex = true;
  /// Between its faces at the vertex: inside the solid, at a concave edge outside of it.
  double angle_rad = 0;
  double radius_mm = 0;
  double contact_mm = 0;  ///< distance of the contact lines from the edge, at the section
  double setback_mm = 0;  ///< 0 where OpenCASCADE fills the corner: the fillet is not set back
  bool rounded = true;    ///< false: nearly smooth, and OpenCASCADE leaves it as it is
};

struct CornerFillet {
  Model model;  ///< faces and solids that are still there keep their names and colours
  std::vector<CornerFilletEdge> edges;  ///< counter-clockwise as seen from outside
  CornerFiller filler = CornerFiller::Patches;
  /// Why patches do not fill the corner; empty if they do.
  CornerReason patches_shortfall;
  std::vector<int> faces;  ///< numbers of the fillets and patches in the new model
  /// The patches; none where OpenCASCADE fills the corner. Side 2 i is the section of edge i, side
  /// 2 i + 1 the spring curve after it. At curved faces only patches (none if some had to be
  /// splines), corners and regular are set.
  NSidedFill fill;
  /// Sampled distance of the section curves from their circles; at curved faces the sampled
  /// distance of all sides.
  double section_error_mm = 0;
  std::vector<CornerSeam> seams;  ///< new seams, by edge number
  bool valid = false;             ///< OpenCASCADE's checks of the new shell pass
  /// What fails; empty if the shell is valid, patches are proved regular, new faces run into no
  /// others, and the new seams meet the tolerance with G1.
  CornerReason shortfall;

  bool met() const { return shortfall.empty(); }
  /// The largest upper bounds of the new seams; infinite if a seam has none.
  double largestGap_mm() const;
  double largestAngle_rad() const;
};

/// Numbers of the edges at a vertex, counter-clockwise seen from outside.
/// \throws as cornerFillet().
std::vector<int> cornerEdges(const Model& model, int vertex);

/// Rounds the edges that meet at a vertex, each with its own radius, and closes the corner with
/// patches that meet each other exactly with G1 (nSidedFill()). See docs/corner_fillet.md.
///
///     CornerFilletOptions options;
///     for (int edge : cornerEdges(model, 6)) options.radii_mm[edge] = 2;
///     const CornerFillet corner = cornerFillet(model, 6, options);
///
/// Between planes the fillets are cylinders, and the patches meet the planes exactly and the
/// cylinders to within section_mm. OpenCASCADE makes the fillets if a face at the vertex is curved,
/// if an edge is not a line, or if anything but two more edges and one more plane meets at its far
/// end; then fillHole() fills the corner. The second way is also tried if the first falls short.
///
/// If patches fail or fall short, and no setback is given, the corner is OpenCASCADE's fillet of
/// all its edges, if that is a valid solid and better: CornerFillet::filler. Its seams are measured
/// in the same way.
///
/// **Supported** is a vertex in one shell of one solid where 3 to 6 edges, convex or concave, and
/// as many faces meet, no two of them tangent along an edge. The shell may be the wall of a void.
/// Other shells and solids stay. The given model is not changed.
///
/// Identities (each has a test of its number):
///   (1) Between planes, the distance of the cylinders' axes from both is the radius.
///   (2) A solid longer by h along an edge is larger by h times the filleted cross-section.
///   (3) Rigid motion and scale move the corner likewise.
///
/// \param vertex from 1, in the order of TopExp::MapShapes.
/// \throws std::invalid_argument for invalid options, for a vertex that the model does not have,
/// for an edge at the vertex without a radius, and for radii and setbacks of other edges;
/// CornerRefused for corners that are not supported, setbacks that leave no room
/// for spring curves, fillets that reach beyond their faces or that OpenCASCADE does not make, and
/// openings too sharp for section_mm; ModelError (Malformed) for a model with numbers that are not
/// finite, or 1e100 and more; Cancelled.
/// Source: docs/theory/fills.md F2.1, F2.3.
CornerFillet cornerFillet(const Model& model, int vertex, const CornerFilletOptions& options,
                          const Progress& progress = {});

}  // namespace seamwright::occ
