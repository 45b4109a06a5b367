// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include <seamwright/occ_adapter/fill/edge_fit.hpp>

/// The cross-boundary derivatives of a side as polynomials. Not a public header.
namespace seamwright::occ {

/// A field T that spans the tangent planes of the side together with the tangent of the edge.
struct CrossFit {
  Poles cross;
  double angle_rad = 0;  ///< to the tangent planes of the faces
};

/// The field of the lowest degree whose planes are near enough and whose component across the edge
/// is even; otherwise the best one.
/// \param corner_normals normals of the planes that the field has at its ends.
CrossFit fittedCross(const EdgeFit& edge, const std::array<Eigen::Vector3d, 2>& corner_normals,
                     double length_mm, int most_degree, double enough_rad);

/// The curvature across a side, FillSide::bend.
struct BendFit {
  Poles bend;
  double curvature_per_mm = 0;  ///< its difference from the curvature of the faces
};

/// The bend of the lowest degree that meets the normal curvature along \p cross to a thousandth of
/// the largest one, or of 1 / length_mm where that is larger; otherwise the best one up to \p
/// most_degree.
BendFit fittedBend(const SideSamples& samples, const Poles& cross, double length_mm,
                   int most_degree);

}  // namespace seamwright::occ
