// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>

namespace seamwright {

/// The variation of curvature along one line; all points count equally.
struct LineVariation {
  double total = 0;     ///< sum of |differences| of neighbours
  int extrema = 0;      ///< turns from rising to falling, or back, by more than the noise
  int inflections = 0;  ///< changes of sign between values beyond the noise
};

/// Total variation, extrema and changes of sign of a sequence of values. A turn counts once the
/// values have come back by more than \p noise from the extremum. A change of sign counts between a
/// value above \p noise and a value below -noise. The total includes noise.
///
/// Identities (each has a test of its number):
///   (1) A monotone sequence has total |last - first| and no extremum.
///   (2) Reversing the sequence or its signs changes nothing.
///   (3) A constant added to all values changes neither total nor extrema.
///   (4) Scaling values and noise scales the total and changes no count.
///   (5) Waves of an amplitude of at most half the noise add neither extrema nor inflections.
/// \param noise not negative. For an empty sequence all three are 0.
LineVariation variationOf(std::span<const double> values, double noise);

/// Curvature at points along an iso-line of a surface where it is inside the face, in the direction
/// of the line.
struct CurvatureLine {
  std::vector<double> mean_per_mm;    ///< mean curvature (k1 + k2) / 2 for the normal X_u x X_v
  std::vector<double> normal_per_mm;  ///< normal curvature in the direction of the line
};

/// How the curvature of one surface varies over a face.
struct SurfaceMeasure {
  /// Total variation of the mean curvature along an iso-line, averaged over all lines.
  double variation_per_mm = 0;
  double largest_variation_per_mm = 0;  ///< of a single line
  int extrema = 0;                      ///< of the mean curvature along all lines
  int inflections = 0;  ///< changes of sign of the normal curvature along the line, over all lines
  int lines = 0;        ///< number of lines with at least two points
};

/// \param noise_per_mm noise of the curvature, see variationOf(). Values that are not finite are
/// left out.
/// Source: docs/theory/repair.md R4.
SurfaceMeasure measureSurface(std::span<const CurvatureLine> lines, double noise_per_mm);

/// How the points of a surface have changed.
struct SurfaceChange {
  double normal_move_mm = 0;      ///< largest part of a move along the normal before the change
  double tangential_move_mm = 0;  ///< largest part of a move across that normal
  double turn_rad = 0;            ///< largest turn of a normal, 0..pi
  /// The largest change of a normal curvature: the spectral norm of the difference of the curvature
  /// tensors. The smallest rotation first turns the normal after the change back to the normal
  /// before it.
  double curvature_change_per_mm = 0;
  /// The largest move of a point of the face: the lower end is attained, the upper end is a bound.
  Interval move_mm = {0, 0};
  SurfaceMeasure before, after;
};

/// A point of a surface, with its curvature tensor if it has a normal.
struct CurvedPoint {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> normal;
  Eigen::Matrix3d curvature_per_mm = Eigen::Matrix3d::Zero();
};
CurvedPoint curvedPoint(const SurfaceJet& jet, const JetNoise& noise = {});

/// Includes one point in the change. \p move_mm grows at its lower end. The normal and the
/// tangential part of the move need a normal before; turn and change of curvature need a normal
/// before and after. A point that is not finite changes nothing.
void include(SurfaceChange& change, const CurvedPoint& before, const CurvedPoint& after);

}  // namespace seamwright
