// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace seamwright::bench {

constexpr int faces_per_pocket = 25;

/// A flat sheet with a square pattern of rounded pockets: 1 + 25 \p pockets faces in one shell.
///
/// Walls, floor and rim of a pocket join tangentially: planes, cylinders, tori and spheres, each
/// pocket with geometry of its own. The sheet around them is one face with a hole for each pocket,
/// so that work on a seam that grows with the size of its faces shows.
/// \throws std::invalid_argument if pockets < 1
TopoDS_Shape makePocketedSheet(int pockets);

}  // namespace seamwright::bench
