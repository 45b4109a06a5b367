// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <string>
#include <vector>

#include <seamwright/occ_adapter/match/match_reason.hpp>

/// All reasons and remarks of a match, and their words. Not a public header.
namespace seamwright::occ::match_why {

/// Adds a reason, unless it is empty or its words are there already.
void add(std::vector<MatchReason>& reasons, MatchReason reason);

// Remarks.
/// \param is_longest whether that is why the edge was taken; else it was asked for.
MatchReason oneOfSeveralEdges(const std::vector<int>& common, int taken, bool is_longest);
/// \param obstacle one of those of onFace().
MatchReason faceStays(MatchReason obstacle);
MatchReason hasLevel();
/// \param repeated how many times more than before the inner knots along the seam are there: 0..2.
MatchReason joinedInPoles(int repeated);
/// \param halvings of knot spans.
MatchReason joinedToTolerance(int halvings);
MatchReason endsInPoint(int face);
MatchReason otherEdgeApart(double gap_mm);
MatchReason faceCouldMove(int face);

// The common boundary.
/// \param fault what is wrong with its numbers, such as "has a surface with the number inf".
MatchReason faceUnusable(int face, const std::string& fault);
MatchReason noCommonBoundary(double match_mm);
/// \param apart_mm distance of the faces.
MatchReason noCommonBoundary(double match_mm, double apart_mm);
MatchReason closedBoundary();
MatchReason endsApart(double apart_mm);
MatchReason boundariesApart(double near_mm, double side_by_side_mm, double length_mm);
MatchReason boundaryFolds();
MatchReason pathNotFitted(int face, int pieces, double stray_mm, double limit_mm);

// Why a face can't move. The text follows "face 3 "; see onFace().
MatchReason hasNoPoles(const std::string& kind);
MatchReason isTrimmed();
MatchReason goesOn();
MatchReason sideIsLonger();
MatchReason reachesBeyond();
MatchReason boundaryTurnsBack();
/// "face 3 is a plane, ..."
MatchReason onFace(int face, MatchReason obstacle);

// Why there is no join.
MatchReason joinRefused(const std::string& why);
MatchReason noExactJoin();
MatchReason facesFold();
/// \param missed the worst figure as a multiple of its tolerance.
MatchReason missesTolerance(int halvings, double missed);
MatchReason sideEndsAway(double gap_mm);
MatchReason sideEndsTilted(double angle_deg);
/// Normal curvatures.
MatchReason sideEndsCurved(double own_per_mm, double other_per_mm);

// Why a join is not kept. \p how is joinedInPoles() or joinedToTolerance().
MatchReason movesTooFar(double move_mm, double limit_mm);
MatchReason sideMoves(int face, double move_mm);
MatchReason foldsOver(const MatchReason& how, int face);
/// \param figures of the seam after the move.
MatchReason stillMisses(const MatchReason& how, const std::string& figures);
MatchReason edgesStray(const MatchReason& how, double stray_mm);
MatchReason checksFail(const MatchReason& how);
MatchReason openCascadeFailed(const Standard_Failure& failure);
MatchReason failed(const std::string& message);

}  // namespace seamwright::occ::match_why
