// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

#include <seamwright/occ_adapter/repair/repair.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// What is to be repaired, and what may move for it; not a public header.
namespace seamwright::occ {

/// A face as repair sees it. Faces count from 1, so the first of a vector stands for none.
struct FaceChoice {
  bool may_move = false;
  bool may_be_trimmed = false;  ///< the paths of its edges may be others
  std::string cannot_move;      ///< why not, as "face 3 ..." goes on
  bool convertible = false;     ///< it has no poles; but for that it might move
};

struct Choice {
  std::vector<bool> treated;  ///< by seam, in the order of the report
  std::vector<bool> sharp;    ///< by seam: of a treated one the gap alone is to be closed
  std::vector<std::string>
      reasons;  ///< by seam: why it is not treated though it was meant; else empty
  std::vector<bool>
      wants_conversion;  ///< by seam: it falls short, and no face of it moves but as a spline
  std::vector<FaceChoice> faces;
};

/// Seams of class defect, or those of the edges picked that do not have the level yet; at least one
/// of the faces has to be able to move, or only the edge strays: isOfGapAlone(), and one of the
/// faces may be trimmed otherwise. A face can move if it lies on a B-spline or Bezier surface, is
/// not fixed, stands in the model once, and has no edge where three faces or more meet. Nor does a
/// face move that can't be computed with (UnusableParts), or that has an edge in common with one. A
/// defect that would be a crease if its gap were closed is sharp by design: it stays so. Faces that
/// fold back on one another below the crease angle are not treated, as no small move turns a normal
/// over.
/// \throws std::invalid_argument for edges and faces that the model does not have, and for a picked
/// edge that is no seam.
Choice choose(const Model& model, const Report& before, const RepairOptions& options);

/// Why none of the faces of a seam moves; empty if one may.
std::string whyNoneMoves(const std::array<int, 2>& faces, const std::vector<FaceChoice>& choices);

/// Two faces share the edge, and but for the gap the seam is as it should be.
bool isOfGapAlone(const SeamResult& seam, bool sharp, const ContinuityTolerance& tolerance,
                  Level level);

/// Why the sides of a seam cannot have one tangent plane within the tolerance, whatever smooth
/// displacement they get: where the surface of one has a kink of its own across the seam, and the
/// other one does not turn with it, one of them misses on one side of the kink. Empty if that is
/// not so. \throws Standard_Failure.
std::string whyKinked(const Seam& seam, const ContinuityTolerance& tolerance);

/// 1: G1, 2: G2.
inline Level levelOf(int order) {
  return order == 1 ? Level::G1 : Level::G2;
}

/// The seam surely has what is asked for. \param sharp see Choice.
bool isRepaired(const SeamResult& after, bool sharp, const ContinuityTolerance& tolerance,
                Level level);

}  // namespace seamwright::occ
