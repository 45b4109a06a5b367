// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <seamwright/core/fill/n_sided_fill.hpp>

namespace seamwright {

struct RingFillOptions {
  SpokeLaw law = SpokeLaw::Linear;                      ///< Linear or G2
  int fairness_order = 2;                               ///< as in FillOptions
  double corner_tolerance_rad = 0;                      ///< as in FillOptions
  std::optional<int> curvature_degrees = std::nullopt;  ///< as in FillOptions
};

/// The equations of the joins contradict each other: the sides have no ring of five patches.
class RingContradiction : public std::runtime_error {
 public:
  RingContradiction(const std::string& message, double missed_mm)
      : std::runtime_error(message), missed_mm_(missed_mm) {}
  double missed_mm() const { return missed_mm_; }  ///< largest residual of the equations

 private:
  double missed_mm_;
};

/// A hole of four sides filled by a ring of four patches around a fifth.
struct RingFill {
  /// Patch k < 4 has side k as its edge u = 1, v along it; v = 0 is the spoke to corner k, v = 1
  /// the spoke to corner k + 1, both from inside. Its edge u = 0 is an edge of patch 4: V0, U1, V1
  /// and U0 for k = 0..3, the last two reversed.
  std::vector<BezierPatch> patches;
  /// Angles are within (0, 2 pi). At a smooth corner twist_defect_mm is the normal part of the
  /// difference between the mixed derivatives of both sides. exact and angle_bound_rad are as in
  /// FillCorner, for both sides next to the corner.
  std::vector<FillCorner> corners;
  double fairness_mm2 = 0;  ///< sum of the squared differences of poles
  bool regular = false;     ///< as in NSidedFill
  /// The chosen length of the spokes' ends, divided by two thirds of the distance of the corner
  /// from the mean of the corners (at least a quarter of the mean distance).
  double spoke_scale = 1;
  std::optional<double> curvature_jump_per_mm = std::nullopt;  ///< as in NSidedFill
  /// With SpokeLaw::G2, about the largest difference of curvature that is left on spokes, beside
  /// their corners. It is rounding if the neighbours of each corner are parts of one surface.
  std::optional<double> spoke_jump_per_mm = std::nullopt;
};

/// Fills a hole of four sides with five tensor-product Bezier patches. They meet each other, and
/// the tangent planes of the surroundings, exactly with G1. Any corner may be smooth or reflex.
///
/// In nSidedFill() both sides of a corner are edges of one patch, which has no normal there if they
/// continue each other smoothly. Here a spoke ends in each corner: across the sides' common tangent
/// if the corner is smooth, and along the bisector of the angle otherwise. So no patch has an angle
/// of pi, and a round hole may be cut into four sides anywhere. The neighbours of a corner have to
/// agree in the mixed derivative only if the corner is smooth.
///
/// The cross-boundary derivative out of the hole is G = p T + q E' along each side, with the same
/// value in a corner on both of its sides. Across a spoke S, which begins inside, with derivatives
/// V and U into the patches beside it, c V + d U = e S' holds with linear c, d and e. At the inner
/// end (c, d, e) = (1, 1, -1), because the tangents of the three edges at a corner of the middle
/// patch add up to zero. At the outer end the two sides determine c, d and e. Across the edges of
/// the middle patch V + U = e S', e from -1 to 1. The degree N of the patches is max(5, e + 3, d +
/// 2), d and e the largest degrees of edges and cross-boundary derivatives. The remaining freedom
/// minimises the sum of squared differences of poles. Second differences are the default, because
/// third ones leave the height of the middle nearly free. If the patches are not proven regular,
/// other lengths of the spokes are tried. Curvature is treated as in nSidedFill().
///
/// With SpokeLaw::G2 the patches meet each other with G2, in the same degree. Of five lengths of
/// the spokes that is taken in which peaks of curvature are least. At a corner whose neighbours
/// disagree about the mixed derivative, or at a smooth one about the curvature along the sides, no
/// fill has G2. There the tangent planes are met all the same, and a jump of curvature is left on
/// the spoke, that fades away from the corner.
///
/// Identities (each has a test of its number):
///   (1) Edges U1 of patches 0 to 3 are the sides; neighbours share the poles of their common edge
///       bitwise.
///   (2) encloseSeam(): the angle across all inner edges, and to neighbours along sides without an
///       inexact corner, is rounding.
///   (3) Rigid motion, scale, and the numbering of the sides act on the fill in the same way.
///   (4) The fill of planar sides is planar; a symmetric hole has a symmetric fill.
///   (5) encloseSeam(): with SpokeLaw::G2 the difference of curvature across the inner edges is
///       rounding, but on spokes to corners whose neighbours disagree.
///
/// \throws std::invalid_argument as nSidedFill() does for sides, derivatives and planes, with side
/// or corner and number; for a number of sides other than 4; for SpokeLaw::Quadratic; for angles of
/// 0 and 2 pi; and for corners that turn by less than 0.01 rad but more than rounding.
/// RingContradiction.
/// Source: docs/theory/fills.md F5.1, F5.2, F1.2.
RingFill ringFill(const std::vector<FillSide>& sides, const RingFillOptions& options = {});

}  // namespace seamwright
