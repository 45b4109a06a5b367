// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>

#include <seamwright/occ_adapter/progress.hpp>
#include <seamwright/occ_adapter/seams/rivals.hpp>

namespace seamwright::occ {

/// By pair of paths, with the smaller number first: the pieces that may come within match_mm of
/// each other and have about the same direction. \throws Cancelled.
std::map<std::pair<std::size_t, std::size_t>, ClosePieces> findClosePieces(
    const EdgePaths& paths, double match_mm, const Progress& progress);

}  // namespace seamwright::occ
