// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace seamwright::occ {

/// Why a corner is not rounded, or what a rounded one falls short of. docs/corner_fillet.md says
/// what helps.
enum class CornerFault {
  None,
  // The corner is not supported.
  NotInOneShell,  ///< the vertex is in no shell of a solid, or in several
  EdgeCount,      ///< fewer than 3 or more than 6 edges meet there
  NotOneFan,      ///< the faces at the vertex do not surround it once
  EdgeFaces,      ///< an edge has one face, or more than two
  FacesTurned,    ///< faces beside an edge have opposite orientations
  FaceTwice,      ///< a face comes to the vertex several times
  EdgeIsLoop,     ///< an edge begins and ends at the vertex
  NoTangent,      ///< of an edge at the vertex
  NoNormal,       ///< of a face at the vertex
  SmoothEdge,     ///< the faces beside an edge are tangent
  FlatAngle,      ///< two edges of a face are in one line at the vertex
  // There is no room, or no curve.
  SectionMisses,  ///< no polynomial meets a section within section_mm
  SetbackTooSmall,
  SetbackTooLarge,  ///< beyond the fillet, or beyond the far end of its edge
  FarEndCut,        ///< the face at the far end cuts the fillet before its section
  FarEdgeCut,       ///< nothing would be left of an edge at a far end
  FilletsCross,     ///< before their sections
  // OpenCASCADE does not make the fillets.
  BallDividesSolid,
  EdgeNotRounded,     ///< for a reason that is named, an edge has no fillet
  NotRounded,         ///< the edges have no fillets together
  BallNotSurrounded,  ///< the ball is not bounded by fillets and faces of the corner
  NoSection,          ///< a fillet has no section from face to face
  NoPath,             ///< a spring curve has no path on its face
  OpenCascadeFailed,
  // There is no fill.
  HoleOfOtherShape,  ///< the fillets leave no hole, or one with other sides
  ConstructionRefused,
  NotFilled,
  // The corner is made, and falls short.
  ChecksFail,  ///< OpenCASCADE's checks
  MayFold,     ///< the patches are not proved regular
  RunsIntoFace,
  MissesTarget  ///< a new seam
};

/// A fault with its numbers and its location in the given model, and its text for the user.
struct CornerReason {
  CornerFault fault = CornerFault::None;
  std::string text = {};
  /// By name with the unit, such as {"setback_mm", 3}.
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<int> faces = {}, edges = {};

  bool empty() const { return fault == CornerFault::None; }
};

/// The name of a fault in reports: "smooth_edge".
/// \throws std::out_of_range for a value that is not of the enum.
std::string codeOf(CornerFault fault);

/// A corner that is not rounded. The message is the text of the reason.
class CornerRefused : public std::domain_error {
 public:
  explicit CornerRefused(CornerReason reason)
      : std::domain_error(reason.text), reason_(std::move(reason)) {}

  const CornerReason& reason() const { return reason_; }

 private:
  CornerReason reason_;
};

}  // namespace seamwright::occ
