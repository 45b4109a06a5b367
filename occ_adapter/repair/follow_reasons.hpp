// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include <seamwright/occ_adapter/repair/task_places.hpp>

/// Why a face can't meet its paths; not a public header. All texts are empty where there is no such reason.
namespace seamwright::occ {

/// The path asks for a move beyond the one allowed, or turns the face over.
std::string whyBeyondReach(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface,
                           std::size_t path);

/// Two paths ask for different things where their ends meet.
std::string whyCornersContradict(const FaceTask& task, const TaskPlaces& places,
                                 const MovingSurface& surface);

/// A ratio is above the task's share. \param misses at all places
std::string whyMissed(const FaceTask& task, const Misses& misses, const MovingSurface& surface,
                      int refinements);

/// The normal turned by 90 degrees or more.
std::string whyFolded(const MovingSurface& surface);

}  // namespace seamwright::occ
