// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

#include <seamwright/core/seam/tolerance.hpp>
#include <seamwright/core/surface/measure.hpp>

namespace seamwright {

/// What the user accepts of a changed surface.
struct SurfaceTolerance {
  double fairness = 1.5;  ///< the variation may grow to that multiple of itself, at least 1 ...
  double visible_per_mm =
      0;  ///< ... and by that much more; also the noise of extrema and inflections

  /// \throws std::invalid_argument for a fairness below 1 or not finite, or a visible variation
  /// that is negative or not finite.
  void validate() const;
};

/// What a turn of the tangent plane along one boundary by that angle costs in variation of the mean
/// curvature with the least bending energy, if it ends smoothly at the far end of a face of that
/// size: 3 angle / size. For the accepted angle it is no more visible than the seam that is
/// accepted; for the angle of a seam that is repaired it is what the fairest repair by one face
/// alone costs.
/// \param size_mm above 0.
/// The curvature of the profile of least bending energy runs from -4 angle / size to
/// 2 angle / size.
/// Source: docs/theory/repair.md R1.
double visibleVariation(double angle_rad, double size_mm);

struct SurfaceVerdict {
  bool worse = false;
  std::string reason;  ///< with the figures; empty if it is not worse
};

/// Worse iff the variation after exceeds fairness times that before plus what is visible, or more
/// than one line in five has an inflection that it did not have before: the difference of all
/// inflections is larger than a fifth of the lines.
///
/// Nothing becomes worse by a larger tolerance.
SurfaceVerdict judgeSurface(const SurfaceChange& change, const SurfaceTolerance& tolerance);

}  // namespace seamwright
