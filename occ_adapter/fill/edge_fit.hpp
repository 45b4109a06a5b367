// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <seamwright/occ_adapter/fill/fit_corner.hpp>
#include <seamwright/occ_adapter/fill/interval_path.hpp>
#include <seamwright/occ_adapter/fill/side_fit.hpp>

/// The edge of a side as a polynomial. Not a public header.
namespace seamwright::occ {

/// Samples of a side. Every fourth checked sample is fitted.
struct SideSamples {
  std::vector<SideSample> checked, fitted;
};

/// A polynomial edge, and its errors at the checked samples.
struct EdgeFit {
  std::shared_ptr<const SideSamples> samples;
  BezierCurve edge{Poles(Poles::Zero(1, 3))};
  std::vector<Eigen::Vector3d> directions;  ///< at the checked samples
  double gap_mm = 0, tilt_rad = 0;
  double miss = HUGE_VAL;  ///< error over accepted error
};

/// The fit of the lowest degree that is near enough, or that higher degrees hardly improve.
/// \param enough_rad accepted angle to the tangent planes of the faces.
/// \throws GeometryError if an edge has no tangent where it ends.
EdgeFit nearestEdge(const IntervalPath& path, Parametrisation parametrisation,
                    const std::array<SideFitEnd, 2>& ends, const SideFitOptions& options,
                    double enough_rad);

/// The Bernstein polynomials of a degree at t.
Eigen::VectorXd bernsteinAt(int degree, double t);

}  // namespace seamwright::occ
