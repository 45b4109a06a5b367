// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include <seamwright/core/planar/biarc_spline.hpp>
#include <seamwright/core/planar/narrow_band.hpp>

/// Not a public header.
namespace seamwright {

/// Which lengths divide the turns of points into curvatures.
enum class EnergyLengths {
  Own,   ///< those of the points
  Given  ///< those of other points: the curvature at a point is linear in its move across the curve
};

/// Points with those whose distances are the lengths.
struct MeasuredPoints {
  const PlanarPoints& points;
  const PlanarPoints& lengths_of;
};

/// Half the energy of PointFairness: a sum of squares, one for each four neighbours. Infinite or
/// not a number where neighbours are equal.
double halfEnergyOf(const MeasuredPoints& at, bool closed);

/// A residual of half the energy with its derivatives by moves of four neighbours.
struct EnergyRow {
  std::array<Eigen::Index, 4> points;
  std::array<double, 4> slopes;
  double residual = 0;
};

/// One row for each residual, for moves along vectors.
std::vector<EnergyRow> energyRowsOf(const PlanarPoints& points, const PlanarPoints& moves,
                                    EnergyLengths lengths, bool closed);

/// In the order of elimination.
Eigen::Index firstPlaceOf(const EnergyRow& row, const NarrowOrder& order);
/// Rows by their first place.
std::vector<std::size_t> orderOf(const std::vector<EnergyRow>& rows, const NarrowOrder& order);

}  // namespace seamwright
