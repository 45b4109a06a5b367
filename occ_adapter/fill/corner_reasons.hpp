// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <array>
#include <string>

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/occ_adapter/fill/corner_reason.hpp>

/// All reasons of corner fillets, and their words. Numbers of edges, faces and vertices are those
/// of the given model. Not a public header.
namespace seamwright::occ::corner_why {

/// "2.5 mm".
std::string lengthText(double length_mm);

// The corner is not supported.
CornerReason notInOneShell(int vertex, int shells);
/// \param least, most numbers of edges that are supported.
CornerReason edgeCount(int edges, int least, int most);
CornerReason notOneFan(int faces, int edges);
CornerReason edgeFaces(int edge, int faces);
CornerReason facesTurned(int edge);
CornerReason faceTwice(int face, int visits);
CornerReason edgeIsLoop(int edge);
CornerReason noTangent(int edge);
CornerReason noNormal(int face);
CornerReason smoothEdge(int edge);
CornerReason flatAngle(int face, double angle_deg);

// There is no room, or no curve.
/// \param error_mm distance of the best polynomial from the circle.
CornerReason sectionMisses(int edge, double radius_mm, double sweep_deg, double error_mm,
                           double section_mm);
CornerReason setbackTooSmall(int edge, double setback_mm, double least_mm);
/// A fillet, and the edge whose radius explains its setback: itself or a neighbour.
struct SetBackFillet {
  int edge = 0;
  double edge_mm = 0;  ///< length of the edge
  double setback_mm = 0;
  int cause = 0;
  double cause_radius_mm = 0;
};
/// \param length_mm of the fillet along one contact line; may be negative.
CornerReason setBackTooFar(const SetBackFillet& fillet, double length_mm);
CornerReason setBackBeyondEnd(const SetBackFillet& fillet);
/// \param from_mm, to_mm where the fillet of the edge is, from the vertex.
CornerReason setbackOutside(int edge, double setback_mm, double from_mm, double to_mm);
/// \param from_mm where the far plane begins to cut, beyond the section.
CornerReason farEndCut(int edge, double radius_mm, double from_mm);
CornerReason farEdgeCut(int edge, double length_mm, double from_mm, double to_mm);
CornerReason filletsCross(const std::array<int, 2>& edges,
                          const std::array<double, 2>& setbacks_mm);

// OpenCASCADE does not make the fillets outside of a ball about the vertex.
CornerReason ballStays(double ball_mm);
CornerReason ballDividesSolid(double ball_mm);
CornerReason notRounded(double ball_mm);
CornerReason noSolid(double ball_mm);
CornerReason ballIsGone(double ball_mm);
CornerReason ballNotSurrounded(double ball_mm, std::size_t edges, std::size_t of_corner);
CornerReason filletInSeveralFaces(double ball_mm);
CornerReason ballFailed(double ball_mm, const Standard_Failure& failure);
/// An edge outside the ball, and the edge whose radius makes the ball so large: itself or another.
struct EdgeOutside {
  int edge = 0;
  int cause = 0;
  double cause_radius_mm = 0;
  double ball_mm = 0;
};
CornerReason edgeInParts(const EdgeOutside& at, int parts);
CornerReason edgeContinues(const EdgeOutside& at);
CornerReason edgeHasNoFillet(const EdgeOutside& at);
CornerReason filletMissesBall(const EdgeOutside& at);

// Sections and spring curves are not found.
CornerReason filletApart(int edge);
CornerReason filletHasNoEdge(int edge);
CornerReason noSection(int edge);
CornerReason noSpringCurve(int edge);
CornerReason noPath();

// There is no fill.
CornerReason noHole();
CornerReason holeSides(std::size_t sides, std::size_t needed);
CornerReason constructionRefused(const std::string& why);
CornerReason notFilled(const std::string& why);

// The corner is made, and falls short.
CornerReason checksFail();
CornerReason mayFold();
/// \param face 0: another new face.
CornerReason runsIntoFace(int face);
/// \param face of the given model beside the seam; 0: both faces are new.
/// \param figures of the seam.
CornerReason missesTarget(CornerSeamKind kind, int face, const std::string& figures);

}  // namespace seamwright::occ::corner_why
