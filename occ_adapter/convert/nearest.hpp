// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <seamwright/occ_adapter/convert/face_strip.hpp>

namespace seamwright::occ {

/// The parameter in [low, high] of the path at which its distance from p has a local minimum, by
/// descent from \p start.
///
/// Gauss-Newton steps, halved until they lead downhill; they converge quickly where the distance is
/// small compared with the path's radius of curvature. The descent ends when no step longer than
/// 1e-13 of the path's range leads downhill, or after 60 steps.
/// \throws Standard_Failure where OpenCASCADE can't evaluate.
double nearestParameter(const FaceStrip& path, const Eigen::Vector3d& p, double start,
                        double low = 0, double high = 1);

}  // namespace seamwright::occ
