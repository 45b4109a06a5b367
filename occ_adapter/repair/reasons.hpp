// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Standard_Failure.hxx>
#include <string>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/repair/repair_reason.hpp>

/// All reasons of a repair, and their words. Not a public header.
namespace seamwright::occ::why {

// Why a face stays. The text follows "face 3 ".
RepairReason isFixed();
RepairReason isHeld();
/// \param fault what is wrong with its numbers, such as "has the number inf".
RepairReason isUnusable(const std::string& fault);
RepairReason hasUnusableNeighbour(int edge, int face, const std::string& fault);
RepairReason hasInstances(int count);
RepairReason hasEdgeWithInstances(int edge, int count);
RepairReason hasNonManifoldEdge(int edge, int faces);
RepairReason hasNoPoles(const std::string& kind);
/// \param obstacles by face.
RepairReason facesStay(const std::vector<std::pair<int, RepairReason>>& obstacles);

// Why a seam is not treated, or has no solution.
RepairReason notMeasured(const std::string& note);
RepairReason hasLevel();
RepairReason facesFold(double at);
RepairReason surfaceKink(int face, double turn_deg, double at);
/// \param limit_mm finite if the moves were restrained: their limit.
RepairReason missesTolerance(double missed, double limit_mm);
RepairReason sidesApart(double apart_mm);
RepairReason surfacesApart();
RepairReason pathNotEnough();
RepairReason timeLimit();
RepairReason failed(const Standard_Failure& failure);
RepairReason failed(const std::string& message);

// Why a solution is not kept. Faults of a face are about "it"; see onFace().
/// \param figures of the seam after the move.
RepairReason stillMisses(const std::string& figures);
/// \param change "a larger gap". \param after, before figures of the seam.
RepairReason spoilsSeam(int edge, const std::string& change, const std::string& after,
                        const std::string& before);
RepairReason edgeStrays(double stray_mm);
RepairReason foldsOver();
RepairReason pointMovesFar(double move_mm, double pole_move_mm);
RepairReason checksFail();
RepairReason volumeChanges(int solid, double change_mm3, double explained_mm3);
RepairReason movesTooFar(double move_mm, double limit_mm);
RepairReason lessFair(const std::string& figures);
RepairReason passesThrough(int face);
RepairReason nothingProven(bool of_its_faces);
RepairReason instanceLessCertain();

// Reasons of reasons. The fault stays.
/// "face 3: ..."
RepairReason onFace(int face, RepairReason reason);
/// "its new path would spoil ..."
RepairReason pathSpoils(RepairReason reason);
/// "instance of edge 3: ..."
RepairReason ofInstance(int first_edge, RepairReason reason);
/// "with its faces as splines: ..."
RepairReason asSplines(RepairReason reason);
/// "...; ...". The fault is that of the first one, unless that is empty.
RepairReason joined(RepairReason first, const RepairReason& second);
/// The reason with a remark behind it.
RepairReason withRemark(RepairReason reason, const std::string& remark);
/// The reason after a note: "note; ...".
RepairReason afterNote(const std::string& note, RepairReason reason);

}  // namespace seamwright::occ::why
