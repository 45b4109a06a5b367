// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include <seamwright/core/bernstein/interval.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>

namespace seamwright {

/// What curvature does along one line; all places count alike.
struct LineVariation {
  double total = 0;     ///< sum of |differences| of neighbours
  int extrema = 0;      ///< turns from rising to falling, or back, by more than the noise
  int inflections = 0;  ///< changes of sign between values beyond the noise
};

/// Total variation, extrema and changes of sign of a sequence of values. A turn counts once the
/// values have come back by more than \p noise from the extremum; a change of sign counts between a
/// value above \p noise and one below minus it. The total does not leave out noise.
///
/// Identities (each has a test of its number):
///   (1) A monotone sequence has total |last - first| and no extremum.
///   (2) Reversing the sequence or its signs changes nothing.
///   (3) A constant added to all values changes neither total nor extrema.
///   (4) Scaling values and noise scales the total and changes no count.
///   (5) Waves of an amplitude of at most half the noise add neither extrema nor inflections.
/// \param noise not negative. An empty sequence has none of all.
LineVariation variationOf(std::span<const double> values, double noise);

/// Curvature at places along an iso-line of a surface, where it is inside the face, in the sense of
/// the line.
struct CurvatureLine {
  std::vector<double> mean_per_mm;    ///< mean curvature (k1 + k2) / 2 to the normal X_u x X_v
  std::vector<double> normal_per_mm;  ///< normal curvature in the direction of the line
};

/// How the curvature of one surface varies over a face.
struct SurfaceMeasure {
  /// Total variation of the mean curvature along an iso-line, the mean of all lines.
  double variation_per_mm = 0;
  double largest_variation_per_mm = 0;  ///< of a line
  int extrema = 0;                      ///< of the mean curvature along all lines
  int inflections =
      0;          ///< along all lines: changes of sign of the normal curvature in their directions
  int lines = 0;  ///< with two places at least
};

/// \param noise_per_mm of curvature, see variationOf(). Values that are not finite are left out.
/// Source: docs/theory/repair.md R4.
SurfaceMeasure measureSurface(std::span<const CurvatureLine> lines, double noise_per_mm);

/// What became of the points of a surface.
struct SurfaceChange {
  double normal_move_mm = 0;      ///< the largest part of a move along the normal before
  double tangential_move_mm = 0;  ///< and across it
  double turn_rad = 0;            ///< the largest turn of a normal, 0..pi
  /// The largest change of a normal curvature: the spectral norm of the difference of the curvature
  /// tensors, the normal after turned back to the one before by the smallest rotation.
  double curvature_change_per_mm = 0;
  /// The largest move of a point of the face: seen, and not exceeded.
  Interval move_mm = {0, 0};
  SurfaceMeasure before, after;
};

/// A place of a surface, with its curvature tensor where it has a normal.
struct CurvedPoint {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> normal;
  Eigen::Matrix3d curvature_per_mm = Eigen::Matrix3d::Zero();
};
CurvedPoint curvedPoint(const SurfaceJet& jet, const JetNoise& noise = {});

/// Takes one place into the change: moves, turn and change of curvature, as far as both have a
/// normal. \p move_mm grows at its lower end. Nothing where a place is not finite.
void include(SurfaceChange& change, const CurvedPoint& before, const CurvedPoint& after);

}  // namespace seamwright
