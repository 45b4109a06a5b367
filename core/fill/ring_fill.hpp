// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>

namespace seamwright {

struct RingFillOptions {
  int fairness_order = 2;                               ///< as of FillOptions
  double corner_tolerance_rad = 0;                      ///< as of FillOptions
  std::optional<int> curvature_degrees = std::nullopt;  ///< as of FillOptions
};

/// A hole of four sides filled by a ring of four patches around a fifth.
struct RingFill {
  /// Patch k < 4 has side k as its edge u = 1, v along it; v = 0 is the spoke to corner k, v = 1
  /// that to corner k + 1, both begun inside. Its edge u = 0 is edge k of patch 4: V0, U1, V1 and
  /// U0, those two against their sense.
  std::vector<BezierPatch> patches;
  /// Angles are within (0, 2 pi). Where a corner is smooth, twist_defect_mm is the normal part by
  /// which the mixed derivatives of both sides differ; exact and angle_bound_rad are as of
  /// FillCorner, for both sides next to the corner.
  std::vector<FillCorner> corners;
  double fairness_mm2 = 0;  ///< sum of the squared differences of poles
  bool regular = false;     ///< as of NSidedFill
  /// The length of the spokes' ends, over two thirds of the distance of the corners from the mean
  /// of them (a quarter of the mean distance at least), that was taken.
  double spoke_scale = 1;
  std::optional<double> curvature_jump_per_mm = std::nullopt;  ///< as of NSidedFill
};

/// Fills a hole of four sides any of whose corners may be smooth, or reflex, with five
/// tensor-product Bezier patches that meet each other, and the tangent planes of the surroundings,
/// with G1, exactly.
///
/// In nSidedFill() both sides of a corner are edges of one patch, which has no normal there if they
/// go on as one smooth line. Here a spoke ends in each corner: across the sides' common tangent
/// where that is smooth, along the line that halves the angle elsewhere. So no patch has an angle
/// of pi: a round hole is cut into four sides anywhere. Nor do the neighbours of a corner have to
/// agree about the mixed derivative, unless it is smooth.
///
/// The cross derivative out of the hole is G = p T + q E' along each side, with the same value in a
/// corner on both of its sides. Across a spoke S, from the inside, with derivatives V and U into
/// the patches beside it, c V + d U = e S', c, d and e linear: (1, 1, -1) inside, where the three
/// edges of a corner of the middle patch have tangents that add up to zero, and what both sides ask
/// for at their corner. Across the edges of the middle patch V + U = e S', e from -1 to 1. The
/// degree N of the patches is max(5, e + 3, d + 2), d and e the largest degrees of edges and cross
/// fields. What these equations leave free makes the sum of squared differences of poles least: of
/// second ones, as third ones leave the height of the middle nearly free. Where the patches are not
/// proved regular, other lengths of the spokes are tried. Curvature is as of nSidedFill().
///
/// Identities (each has a test of its number):
///   (1) Edges U1 of patches 0 to 3 are the sides; neighbours share the poles of their common edge
///       bitwise.
///   (2) encloseSeam(): the angle across all inner edges, and to neighbours along sides without an
///       inexact corner, is rounding.
///   (3) Rigid motion, scale, and the numbering of the sides move the fill likewise.
///   (4) The fill of planar sides is planar; a symmetric hole has a symmetric fill.
///
/// \throws std::invalid_argument as nSidedFill() for sides, fields and planes, with side or corner
/// and number; for another number of sides than 4; for angles of 0 and 2 pi, and for corners that
/// turn by less than 0.01 rad but more than rounding.
/// Source: docs/theory/fills.md F5.1, F1.2.
RingFill ringFill(const std::vector<FillSide>& sides, const RingFillOptions& options = {});

}  // namespace seamwright
