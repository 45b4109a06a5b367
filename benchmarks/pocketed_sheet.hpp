// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace seamwright::bench {

constexpr int faces_per_pocket = 25;

/// A flat sheet with a square pattern of rounded pockets: 1 + 25 \p pockets faces in one shell.
///
/// The walls, floor and rounded boundary of a pocket join tangentially: planes, cylinders, tori and
/// spheres. Each pocket has its own geometry. The sheet around the pockets is one face with a hole
/// for each pocket, so that work on a seam which grows with the size of its faces becomes visible.
/// \throws std::invalid_argument if pockets < 1
TopoDS_Shape makePocketedSheet(int pockets);

}  // namespace seamwright::bench
