// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <seamwright/core/fill/ring_fields.hpp>
#include <vector>

/// The second equation of the inner edges of a ring whose patches meet each other with G2; not a
/// public header.
namespace seamwright::fill {

/// Along an edge S, with first and second derivatives V, V2 and U, U2 into the patches beside it
/// and with c V + d U = e S',
///
///     c^2 V2 - d^2 U2 + e (d U' - c V') = p (d U - c V) + q S' + D.
///
/// D vanishes but near the end of the edge.
struct CurvatureLaw {
  Eigen::VectorXd p, q;  ///< Bernstein coefficients
  /// The value and the slope of D at the end: what the neighbours of a corner contradict each other
  /// by.
  Eigen::Vector3d defect = Eigen::Vector3d::Zero(), defect_slope = Eigen::Vector3d::Zero();
};

struct RingCurvature {
  std::array<CurvatureLaw, 4> spokes;  ///< from inside to the corners; V into the patch after
  std::array<CurvatureLaw, 4> middle;  ///< the edges of the middle patch; V out of it
  double spoke_jump_per_mm = 0;        ///< as in RingFill
};

/// Source: docs/theory/fills.md F5.2.
RingCurvature ringCurvature(const std::vector<FillSide>& sides, const RingFields& fields);

}  // namespace seamwright::fill
