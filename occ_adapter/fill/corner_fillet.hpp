// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/occ_adapter/model/model.hpp>
#include <seamwright/occ_adapter/progress.hpp>

namespace seamwright::occ {

/// Edges are named by number, from 1, in the order of TopExp::MapShapes.
struct CornerFilletOptions {
  std::map<int, double> radii_mm;  ///< of every edge at the vertex
  /// From the vertex along the edge to the section where its fillet ends. Edges that are not named,
  /// or with 0, get the least one that the radii allow, and half the mean distance of the contact
  /// lines from their edges.
  std::map<int, double> setbacks_mm;
  /// Largest distance of the polynomial section curves from their circles: the gap between
  /// cylinders and patches, [1e-9, 0.1]. Where faces are curved the sides are fitted to a twentieth
  /// of the tolerance instead.
  double section_mm = 1e-6;
  ContinuityTolerance tolerance;  ///< what the new seams must meet
  int jobs = 0;                   ///< threads; 0: one for each processor

  /// Nothing: it is chosen.
  std::optional<double> setback_mm(int edge) const;

  /// \throws std::invalid_argument with the edge and the offending number.
  void validate() const;
};

/// What a new edge separates.
enum class CornerSeamKind {
  Spoke,    ///< two patches
  Section,  ///< a patch and a fillet
  Spring,   ///< a patch and a face
  Contact   ///< a fillet and a face
};

struct CornerSeam {
  CornerSeamKind kind = CornerSeamKind::Spoke;
  SeamResult result;  ///< with the numbers of the new model
};

/// An edge at the vertex and the fillet that rounds it.
struct CornerFilletEdge {
  int edge = 0;  ///< number in the given model
  bool convex = true;
  double angle_rad =
      0;  ///< between its faces at the vertex: of the solid, or of the air where it is concave
  double radius_mm = 0;
  double contact_mm = 0;  ///< distance of the contact lines from the edge, at the section
  double setback_mm = 0;
};

struct CornerFillet {
  Model model;  ///< names and colours are those of the faces and solids that are still there
  std::vector<CornerFilletEdge> edges;  ///< counter-clockwise, seen from outside
  NSidedFill fill;  ///< the patches (at curved faces none where some had to be splines, and of the
                    ///< rest corners and regular alone); side 2 i is the section of edge i, side 2
                    ///< i + 1 the spring curve after it
  double section_error_mm = 0;    ///< distance of the section curves from their circles, at curved
                                  ///< faces of all sides, as sampled
  std::vector<CornerSeam> seams;  ///< the new ones, by edge number
  bool valid = false;             ///< OpenCASCADE's checks of the new shell pass
  /// Empty: valid, the patches are proved regular, and the new seams meet the tolerance with G1.
  /// Else what fails, with numbers.
  std::string shortfall;

  bool met() const { return shortfall.empty(); }
  /// The largest upper bounds of the new seams; infinite where one has none.
  double largestGap_mm() const;
  double largestAngle_rad() const;
};

/// Numbers of the edges at a vertex, counter-clockwise seen from outside.
/// \throws as cornerFillet().
std::vector<int> cornerEdges(const Model& model, int vertex);

/// Rounds the edges that meet at a vertex, each with a radius of its own, and closes the corner
/// with patches that meet each other exactly with G1 (nSidedFill()).
///
/// Between planes, each edge gets a cylinder that touches both its faces: a rolling ball's, inside
/// the solid along convex edges, outside along concave ones. It begins set back from the vertex, in
/// a section across the edge, and runs to the far end, where the face there cuts it. In the faces,
/// a cubic spring curve leads from the contact line of one cylinder to that of the next, tangent to
/// both. The sections and spring curves of m edges bound a hole of 2 m sides. Its corners are right
/// angles at which the neighbours agree to second order, so that the patches meet the planes, and
/// the cylinders but for section_mm, along all of them.
///
/// Where a face at the vertex is curved, an edge is no line, or its far end is not that of two more
/// edges and one more plane, the fillets are OpenCASCADE's, of the solid without a ball about the
/// vertex. They are cut off at the setbacks, the spring curves are dropped onto the faces, and
/// fillHole() fills the hole. Setbacks that are not given are so large, then, that the sections are
/// outside the ball.
///
/// **Supported** is a vertex in one shell of one solid where 3 to 6 edges, convex or concave, and
/// as many faces meet, no two of them tangent along an edge. It may be in the wall of a void. Other
/// shells and solids stay.
///
/// Identities (each has a test of its number):
///   (1) Between planes, the distance of the cylinders' axes from both is the radius.
///   (2) A solid that is longer by h along an edge is larger by h times the cross-section with its
///       fillet.
///   (3) Rigid motion and scale move the corner likewise.
///
/// \param vertex from 1, order of TopExp::MapShapes.
/// \throws std::invalid_argument for options that are not valid, a vertex that the model does not
/// have, radii that miss an edge at the vertex, and radii and setbacks of other edges;
/// std::domain_error, with numbers, for corners that are not supported, setbacks that leave no room
/// for spring curves, fillets that reach beyond their faces or that OpenCASCADE does not make, and
/// openings too sharp for section_mm; ModelError (Malformed) for a model with numbers that are not
/// finite, or 1e100 and more; Cancelled.
/// Source: docs/theory/fills.md F2.1, F2.3.
CornerFillet cornerFillet(const Model& model, int vertex, const CornerFilletOptions& options,
                          const Progress& progress = {});

}  // namespace seamwright::occ
