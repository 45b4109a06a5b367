// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <string>
#include <utility>
#include <vector>

#include <seamwright/core/surface/judge.hpp>
#include <seamwright/occ_adapter/repair/repair_reason.hpp>

/// All reasons of a repair, and their words. Not a public header.
namespace seamwright::occ::why {

// Why a face stays. The text follows "face 3 ".

/// The options fix the face.
RepairReason isFixed();
/// A former repair that moved the face made a seam worse in the written file.
RepairReason isHeld();
/// The face has invalid numbers.
/// \param fault what is wrong with its numbers, such as "has the number inf".
RepairReason isUnusable(const std::string& fault);
/// The face shares the edge with a face that has invalid numbers.
RepairReason hasUnusableNeighbour(int edge, int face, const std::string& fault);
/// The face occurs that many times in the model.
RepairReason hasInstances(int count);
/// An edge of the face occurs that many times in the model.
RepairReason hasEdgeWithInstances(int edge, int count);
/// More than two faces share an edge of the face.
RepairReason hasNonManifoldEdge(int edge, int faces);
/// \param kind of the surface, such as "a plane".
RepairReason hasNoPoles(const std::string& kind);
/// None of the faces beside a seam can move.
/// \param obstacles by face.
RepairReason facesStay(const std::vector<std::pair<int, RepairReason>>& obstacles);

// Why a seam is not treated, or has no solution.

/// \param note of the measurement; may be empty.
RepairReason notMeasured(const std::string& note);
/// The seam reaches the target.
RepairReason hasLevel();
/// \param at parameter of the first fold, 0 to 1.
RepairReason facesFold(double at);
/// \param at parameter of the seam, 0 to 1.
RepairReason surfaceKink(int face, double turn_deg, double at);
/// \param missed the worst figure as a multiple of its tolerance.
/// \param limit_mm finite if the moves were restrained: their limit.
RepairReason missesTolerance(double missed, double limit_mm);
/// The edge alone can't close the seam: the ends of its sides are that far apart.
RepairReason sidesApart(double apart_mm);
/// The edge alone can't close the seam: the surfaces do not intersect near it.
RepairReason surfacesApart();
/// The edge alone can close the seam, but not make it smooth.
RepairReason pathNotEnough();
/// The time limit was reached before the seam was repaired.
RepairReason timeLimit();
/// The type and message of the failure are in the text.
RepairReason failed(const Standard_Failure& failure);
/// \param message of a geometry that can't be evaluated.
RepairReason failed(const std::string& message);

// Why a solution is not kept. Faults of a face are about "it"; see onFace().

/// The seam, measured after the move, does not reach the target.
/// \param figures of the seam after the move.
RepairReason stillMisses(const std::string& figures);
/// Another seam would become worse.
/// \param change "a larger gap". \param after, before figures of the seam.
RepairReason spoilsSeam(int edge, const std::string& change, const std::string& after,
                        const std::string& before);
/// An edge would leave its face by more than its tolerance allows.
RepairReason edgeStrays(double stray_mm);
/// The normal of the moved face turns over.
RepairReason foldsOver();
/// A point moves further than any pole, so the move is not what was computed.
RepairReason pointMovesFar(double move_mm, double pole_move_mm);
/// A changed face, or the shape, fails checks that it passed before.
RepairReason checksFail();
/// The volume of a solid changes by more than the moves of its faces explain.
RepairReason volumeChanges(int solid, double change_mm3, double explained_mm3);
/// The largest move of the face is above the limit.
RepairReason movesTooFar(double move_mm, double limit_mm);
/// The moved face is less fair, with the figures; empty for SurfaceFault::None.
RepairReason lessFair(SurfaceFault fault, const SurfaceChange& change);
/// The moved face intersects another one.
RepairReason passesThrough(int face);
/// No set of changes could be proven that contains one for the seam.
RepairReason nothingProven(bool of_its_faces);
/// Rounding differs in the positions of instances: in this one the proof fails.
RepairReason instanceLessCertain();

// Reasons of reasons. The fault stays.

/// "face 3: ...", with that face as the first one.
RepairReason onFace(int face, RepairReason reason);
/// "it would be less fair: ..."
RepairReason wouldBe(RepairReason less_fair);
/// "its new pcurve would make worse: ..."
RepairReason pathSpoils(RepairReason reason);
/// "instance of edge 3: ...", with that edge as the first one.
RepairReason ofInstance(int first_edge, RepairReason reason);
/// "with its faces as splines: ..."
RepairReason asSplines(RepairReason reason);
/// "...; ...". The fault is that of the first one, unless that is empty. Both have their location
/// in the result; of numbers with one name, that of the first one is there.
RepairReason joined(RepairReason first, const RepairReason& second);
/// The reason with a remark behind it.
RepairReason withRemark(RepairReason reason, const std::string& remark);
/// The reason after a note: "note; ...".
RepairReason afterNote(const std::string& note, RepairReason reason);

}  // namespace seamwright::occ::why
