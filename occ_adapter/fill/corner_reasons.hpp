// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Standard_Failure.hxx>
#include <array>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/fill/corner_fillet.hpp>
#include <seamwright/occ_adapter/fill/corner_reason.hpp>

/// All reasons of corner fillets, and their words. Numbers of edges, faces and vertices are those
/// of the given model. Not a public header.
namespace seamwright::occ::corner_why {

/// "2.5 mm".
std::string lengthText(double length_mm);

// The corner is not supported.

/// The vertex belongs to no shell of a solid, or to several.
CornerReason notInOneShell(int vertex, int shells);
/// Too few or too many edges meet at the vertex.
/// \param least, most numbers of edges that are supported.
CornerReason edgeCount(int edges, int least, int most);
/// Faces and edges at the vertex are not one fan. Both are numbers of them there.
CornerReason notOneFan(int faces, int edges);
/// An edge at the vertex bounds that number of faces instead of two.
CornerReason edgeFaces(int edge, int faces);
/// The two faces beside the edge have opposite orientations.
CornerReason facesTurned(int edge);
/// The face has the vertex in its boundary that many times.
CornerReason faceTwice(int face, int visits);
/// The edge begins and ends at the vertex.
CornerReason edgeIsLoop(int edge);
/// The edge has a vanishing derivative at the vertex.
CornerReason noTangent(int edge);
/// The face is degenerate at the vertex.
CornerReason noNormal(int face);
/// Both faces beside the edge have one tangent plane at the vertex.
CornerReason smoothEdge(int edge);
/// Two edges of the face meet at the vertex at about 0 or 180 degrees.
CornerReason flatAngle(int face, double angle_deg);

// There is no room, or no curve.

/// No polynomial of an allowed degree meets the circle to section_mm.
/// \param error_mm distance of the best polynomial from the circle.
CornerReason sectionMisses(int edge, double radius_mm, double sweep_deg, double error_mm,
                           double section_mm);
/// The setback is not above the least one, at which contact lines meet.
CornerReason setbackTooSmall(int edge, double setback_mm, double least_mm);
/// A fillet, and the edge whose radius explains its setback: itself or a neighbour.
struct SetBackFillet {
  int edge = 0;
  double edge_mm = 0;  ///< length of the edge
  double setback_mm = 0;
  int cause = 0;
  double cause_radius_mm = 0;
  bool given = false;  ///< the setback was not chosen
};
/// The setback leaves too little of the fillet.
/// \param length_mm of the fillet along one contact line; may be negative.
CornerReason setBackTooFar(const SetBackFillet& fillet, double length_mm);
/// The setback is longer than the edge.
CornerReason setBackBeyondEnd(const SetBackFillet& fillet);
/// The setback is not within the fillet that OpenCASCADE made.
/// \param from_mm, to_mm where the fillet of the edge is, from the vertex.
CornerReason setbackOutside(int edge, double setback_mm, double from_mm, double to_mm);
/// A face at the far end cuts the fillet before its section.
/// \param from_mm where the far plane begins to cut, beyond the section.
CornerReason farEndCut(int edge, double radius_mm, double from_mm);
/// A fillet that cuts a part off an edge at its far end.
struct FarCutter {
  int edge = 0;  ///< whose fillet it is
  double radius_mm = 0;
  double cut_mm = 0;  ///< negative: the fillet's contact line passes the edge outside
};
/// Fillets leave too little of an edge at their far ends.
CornerReason farEdgeCut(int edge, double length_mm, const std::vector<FarCutter>& cutters);
/// Two neighbouring fillets cross before their sections.
CornerReason filletsCross(const std::array<int, 2>& edges,
                          const std::array<double, 2>& setbacks_mm);

// OpenCASCADE does not make the fillets outside of a ball about the vertex.

/// OpenCASCADE can't subtract the ball.
CornerReason ballStays(double ball_mm);
/// Without the ball, the solid is in several parts.
CornerReason ballDividesSolid(double ball_mm);
/// OpenCASCADE makes no fillets of the edges that are left.
/// \param edges of the corner whose fillets fail. \param points where fillets can't end or meet.
CornerReason notRounded(double ball_mm, const std::vector<int>& edges,
                        const std::vector<Eigen::Vector3d>& points);
/// The result of OpenCASCADE's fillets is not a solid.
CornerReason noSolid(double ball_mm);
/// No face of the ball is left after the fillets.
CornerReason ballIsGone(double ball_mm);
/// Only of_corner of the edges around the ball are on fillets and faces of the corner.
CornerReason ballNotSurrounded(double ball_mm, std::size_t edges, std::size_t of_corner);
/// A fillet meets the ball in several faces.
CornerReason filletInSeveralFaces(double ball_mm);
/// Any other failure of OpenCASCADE; its type and message are in the text.
CornerReason ballFailed(double ball_mm, const Standard_Failure& failure);
/// An edge outside the ball, and the edge whose radius makes the ball so large: itself or another.
struct EdgeOutside {
  int edge = 0;
  int cause = 0;
  double cause_radius_mm = 0;
  double ball_mm = 0;
};
/// The edge has that many parts outside the ball.
CornerReason edgeInParts(const EdgeOutside& at, int parts);
/// The edge continues another one of the corner smoothly, so that OpenCASCADE makes one fillet of
/// both.
CornerReason edgeContinues(const EdgeOutside& at);
/// OpenCASCADE made no fillet for the edge.
CornerReason edgeHasNoFillet(const EdgeOutside& at);
/// The fillet, or the next face, does not reach the ball.
CornerReason filletMissesBall(const EdgeOutside& at);

/// OpenCASCADE makes no fillet of all edges at once that closes the corner.
CornerReason openCascadeHasNone();

// Sections and spring curves are not found.

/// The fillet and the face beside it reach the ball in different points.
CornerReason filletApart(int edge);
/// No edge of the fillet leaves the ball.
CornerReason filletHasNoEdge(int edge);
/// No section runs across the fillet.
CornerReason noSection(int edge);
/// No curve could be made on the face after the fillet of the edge.
CornerReason noSpringCurve(int edge);
/// OpenCASCADE finds no path on a face between two fillets.
CornerReason noPath();

// There is no fill.

/// The model between the fillets has no hole.
CornerReason noHole();
/// The hole has another number of sides than the corner needs.
CornerReason holeSides(std::size_t sides, std::size_t needed);
/// The patches can't be made.
/// \param why the message of the construction.
CornerReason constructionRefused(const std::string& why);
/// The hole is not filled.
/// \param why the reason of the fill.
CornerReason notFilled(const std::string& why);

// The corner is made, and falls short.

/// BRepCheck finds the new shell invalid.
CornerReason checksFail();
/// No proof that the patches are regular.
CornerReason mayFold();
/// A new face meets another one where they are not neighbours.
/// \param face 0: another new face.
CornerReason runsIntoFace(int face);
/// A new seam does not reach the target.
/// \param face of the given model beside the seam; 0: both faces are new.
/// \param figures of the seam.
CornerReason missesTarget(CornerSeamKind kind, int face, const std::string& figures);

}  // namespace seamwright::occ::corner_why
