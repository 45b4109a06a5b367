// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>

#include <seamwright/occ_adapter/match/reference.hpp>

/// The deformation of a spline surface whose side is constrained to meet another face; not a public
/// header.
namespace seamwright::occ {

struct DeformationOptions {
  int order = 1;
  bool hold_sides = false;
  ContinuityTolerance tolerance;
};

/// A surface before and after its rows were moved, with the same knots.
struct MovedSurface {
  opencascade::handle<Geom_BSplineSurface> before, after;
  double largest_move_mm = 0;
};

/// The largest figure over its tolerance, of those that the order needs; infinite where the faces
/// fold.
double ratioOf(const PairMeasure& pair, int order, const ContinuityTolerance& tolerance);

/// All poles of the column are in one point.
bool isCollapsed(const EdgeRows& rows, int column);

/// Of a pole; where weights changed too, also of the points of a grid over the moved rows (9 a knot
/// span along the side, 17 across), which can move further than poles do. Degrees and knots must be
/// equal.
double largestMove_mm(const EdgeRows& before, const EdgeRows& after, int order);

/// Moves rows 0..order so that the side meets the reference: row 0 by its points, row 1 by its
/// normals n.X_w = 0, row 2 by its curvature n.X_ww = II(X_w, X_w), where w runs across. Each row
/// is the least-squares solution at some points of each knot span, and of the rows that meet them
/// alike the one that moves least (Tikhonov, 1e-5 of a unit row). A column that is one point stays
/// one. Weights stay.
/// Source: docs/theory/surfaces.md S5.5.
MovedSurface deformed(const EdgeRows& rows, const Reference& reference,
                      const DeformationOptions& options);

/// For each knot span along the side the largest figure over its tolerance, sampled; infinite where
/// the faces fold.
std::vector<double> sampledRatios(const EdgeRows& rows, const Reference& reference,
                                  const DeformationOptions& options);

/// Why the side's first and last column can't stay, with numbers; empty if they can.
std::string whySidesMove(const EdgeRows& rows, const Reference& reference,
                         const DeformationOptions& options);

/// Whether a surface's normal turned by 90 degrees or more where rows 0..order were moved; sampled.
bool isTurnedOver(const EdgeRows& before, const EdgeRows& after, int order);

}  // namespace seamwright::occ
