// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/core/seam/tolerance.hpp>
#include <seamwright/core/surface/measure.hpp>

namespace seamwright {

/// The tolerances of the user for a changed surface.
struct SurfaceTolerance {
  double fairness = 1.5;  ///< the variation may grow to this multiple of itself, >= 1 ...
  double visible_per_mm =
      0;  ///< ... and by this amount more; also the noise of extrema and inflections

  /// \throws std::invalid_argument for a fairness below 1 or not finite, or a visible variation
  /// that is negative or not finite.
  void validate() const;
};

/// The variation of the mean curvature that a turn of the tangent plane by \p angle_rad along one
/// boundary costs: 3 angle / size. The turn is the one of least bending energy that ends smoothly
/// at the far end of a face of size \p size_mm. The curvature of its profile runs from -4 angle /
/// size to 2 angle / size. For the accepted angle this variation is no more visible than the seam
/// that is accepted. For the angle of a seam that is repaired it is the cost of the fairest repair
/// by one face alone.
/// \param size_mm above 0.
/// Source: docs/theory/repair.md R1.
double visibleVariation(double angle_rad, double size_mm);

/// Why a changed surface is less fair than before. The figures are in its SurfaceChange.
enum class SurfaceFault {
  None,
  Variation,   ///< its mean curvature varies more
  Inflections  ///< its lines have more inflections
};

/// The first fault that holds. Variation: the variation after exceeds fairness times the variation
/// before plus what is visible, or is not finite. Inflections: more than one line in five has a new
/// inflection, that is, the number of all inflections grows by more than a fifth of the lines.
///
/// A larger tolerance never adds a fault.
SurfaceFault judgeSurface(const SurfaceChange& change, const SurfaceTolerance& tolerance);

}  // namespace seamwright
