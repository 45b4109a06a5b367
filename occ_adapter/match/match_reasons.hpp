// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/match/match_reason.hpp>
#include <seamwright/occ_adapter/repair/repair.hpp>

/// All reasons and remarks of a match, and their words. Not a public header.
namespace seamwright::occ::match_why {

/// Adds a reason, unless it is empty or its words are there already.
void add(std::vector<MatchReason>& reasons, MatchReason reason);

/// Remarks and failures in one line.
std::string textOf(const std::vector<MatchReason>& remarks,
                   const std::vector<MatchReason>& failures);

// Remarks.

/// A side was joined by a change that ends within the depth.
MatchReason joinedInZone(double depth_mm);
/// \param kind of the surface before, such as "a plane". \param error_mm of the spline.
MatchReason faceConverted(int face, const std::string& kind, double error_mm);
/// \param edges of the seams that lost a level.
MatchReason otherSeamsWorse(const std::vector<int>& edges);
/// Of length_mm, only met_mm have a neighbour.
MatchReason sidePartlyMet(const std::vector<int>& edges, double met_mm, double length_mm);
/// The moved face is less fair, which is allowed.
MatchReason isLessFair(int face, const FaceMove& move);
/// The faces share several edges. The one that was taken is the first edge of the reason.
/// \param is_longest whether that is why the edge was taken; else it was asked for.
MatchReason oneOfSeveralEdges(const std::vector<int>& common, int taken, bool is_longest);
/// A face that may move can't.
/// \param obstacle one of those of onFace().
MatchReason faceStays(MatchReason obstacle);
/// The faces have the level, so nothing was changed.
MatchReason hasLevel();
/// How an exact join was made.
/// \param repeated how many times more than before the inner knots along the seam are there: 0..2.
MatchReason joinedInPoles(int repeated);
/// How a fitted join was made.
/// \param halvings of knot spans.
MatchReason joinedToTolerance(int halvings);
/// The face is degenerate at an end of the seam.
MatchReason endsInPoint(int face);
/// The gap that the move opened at another edge of both faces.
MatchReason otherEdgeApart(double gap_mm);
/// The face stays by the options, and has nothing against a move.
MatchReason faceCouldMove(int face);

// The common boundary.

/// The face has invalid numbers.
/// \param fault what is wrong with its numbers, such as "has a surface with the number inf".
MatchReason faceUnusable(int face, const std::string& fault);
MatchReason faceInstances(int face, int count);
/// No edge is shared, and no free edges are within match_mm.
MatchReason noCommonBoundary(double match_mm);
/// \param apart_mm distance of the faces.
MatchReason noCommonBoundary(double match_mm, double apart_mm);
/// The boundary is closed or shorter than the gap tolerance.
MatchReason closedBoundary();
/// The ends of both boundaries are that far apart.
MatchReason endsApart(double apart_mm);
/// Of length_mm, only side_by_side_mm are within near_mm.
MatchReason boundariesApart(double near_mm, double side_by_side_mm, double length_mm);
/// The correspondence of both boundaries is not monotonous.
MatchReason boundaryFolds();
/// The path in the parameter of the other face strays by stray_mm with the largest number of
/// pieces.
MatchReason pathNotFitted(int face, int pieces, double stray_mm, double limit_mm);

/// No edge meets the side.
MatchReason sideIsFree(const std::vector<int>& edges, double match_mm);

// Why a face can't move. The text follows "face 3 "; see onFace().

/// \param kind of the surface, such as "a plane".
MatchReason hasNoPoles(const std::string& kind);
/// The boundary is not a parameter line of the surface.
MatchReason isTrimmed();
/// The face has points on both sides of the boundary's parameter line.
MatchReason goesOn();
/// The boundary is only a part of a side of the face.
MatchReason sideIsLonger();
/// The face leaves the parameter range of its surface.
MatchReason reachesBeyond();
/// The path of the boundary is not monotonous.
MatchReason boundaryTurnsBack();
/// "face 3 is a plane, ..."
MatchReason onFace(int face, MatchReason obstacle);

// Why there is no join.

/// \param why the message of nearestJoin().
MatchReason joinRefused(const std::string& why);
/// The equations of the join have no solution in these poles and knots.
MatchReason noExactJoin();
/// Both faces leave the boundary to the same side.
MatchReason facesFold();
/// No fit with up to that many halvings is near enough.
/// \param missed the worst figure as a multiple of its tolerance.
MatchReason missesTolerance(int halvings, double missed);
/// No pole acts within that distance of the side alone.
MatchReason depthTooSmall(int face, double depth_mm);
/// Held sides: one has its end that far from the other face.
MatchReason sideEndsAway(double gap_mm);
/// Held sides: one leaves the tangent plane of the other face by that angle.
MatchReason sideEndsTilted(double angle_deg);
/// Normal curvatures.
MatchReason sideEndsCurved(double own_per_mm, double other_per_mm);

// Why a join is not kept. \p how is joinedInPoles() or joinedToTolerance(); its numbers stay.

/// The moved face would be less fair.
MatchReason lessFair(int face, const FaceMove& move);
/// The largest move of a pole is above the limit.
MatchReason movesTooFar(double move_mm, double limit_mm);
/// A boundary that has to stay would move.
MatchReason sideMoves(int face, double move_mm);
/// The normal of the moved face turns over.
MatchReason foldsOver(const MatchReason& how, int face);
/// The measured seam does not reach the target.
/// \param figures of the seam after the move.
MatchReason stillMisses(const MatchReason& how, const std::string& figures);
/// Edges of the moved faces leave them by more than tolerances allow.
MatchReason edgesStray(const MatchReason& how, double stray_mm);
/// Free edges side by side, of two faces that both move, have that gap afterwards.
MatchReason neighboursApart(const MatchReason& how, const std::vector<int>& edges, double gap_mm);
/// BRepCheck finds the new faces invalid.
MatchReason checksFail(const MatchReason& how);
/// The type and message of the failure are in the text.
MatchReason openCascadeFailed(const Standard_Failure& failure);
/// \param message of a geometry that can't be evaluated.
MatchReason failed(const std::string& message);

}  // namespace seamwright::occ::match_why
