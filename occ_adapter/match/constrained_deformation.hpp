// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/match/reference.hpp>

/// Deforms a spline surface so that one of its sides meets another face. Not a public header.
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

/// The largest ratio of a figure to its tolerance, of the figures that the order requires; infinite
/// if the faces fold.
double ratioOf(const PairMeasure& pair, int order, const ContinuityTolerance& tolerance);

/// Whether all poles of the column are one point.
bool isCollapsed(const EdgeRows& rows, int column);

/// The largest move of a pole. If weights changed, points can move further, so those of a grid over
/// the moved rows count too (9 per knot span along the side, 17 across). \pre equal degrees and
/// knots.
double largestMove_mm(const EdgeRows& before, const EdgeRows& after, int order);

/// Moves rows 0..order so that the side meets the reference: row 0 by its points, row 1 by its
/// normals n.X_w = 0, row 2 by its curvature n.X_ww = II(X_w, X_w), where w runs across. Each row
/// is the least-squares solution at some points of each knot span; of equally good rows it is the
/// one that moves least (Tikhonov, 1e-5 of a unit row). A column that is one point stays one point.
/// Weights stay.
/// Source: docs/theory/surfaces.md S5.5.
MovedSurface deformed(const EdgeRows& rows, const Reference& reference,
                      const DeformationOptions& options);

/// ratioOf() by knot span along the side: the largest sample.
std::vector<double> sampledRatios(const EdgeRows& rows, const Reference& reference,
                                  const DeformationOptions& options);

/// Why the first and the last column can't stay; empty if they can.
MatchReason whySidesMove(const EdgeRows& rows, const Reference& reference,
                         const DeformationOptions& options);

/// Whether the normal turned by 90 degrees or more at a sample where rows 0..order moved.
bool isTurnedOver(const EdgeRows& before, const EdgeRows& after, int order);

}  // namespace seamwright::occ
