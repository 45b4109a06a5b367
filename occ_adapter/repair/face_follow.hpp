// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <seamwright/core/seam/measure.hpp>
#include <seamwright/core/seam/tolerance.hpp>
#include <seamwright/occ_adapter/convert/pcurve.hpp>
#include <seamwright/occ_adapter/progress.hpp>

/// A spline face that is made to meet what is given along paths in its parameter plane; not a public header.
namespace seamwright::occ {

/// What a face has to meet at a point of a path.
struct TargetPoint {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::
      Zero();  ///< of length 1, in the sense of the face's X_u x X_v; zero: only the point is to be met
  Eigen::Matrix3d curvature =
      Eigen::Matrix3d::Zero();  ///< curvature tensor for that normal; read for order 2
};

/// A surface point with these; not degenerate, its tangent unknown.
SidePoint sideOf(const TargetPoint& target);

/// "0.012 mm, 0.3 degrees, 4 % of curvature", as far as the order needs them.
std::string figuresText(const PairMeasure& pair, int order, const ContinuityTolerance& tolerance);

/// A path that has to be met: s in 0..1 along the pcurve.
struct FollowPath {
  Pcurve path;
  int order = 1;  ///< 0: points, 1: and tangent planes, 2: and curvature
  std::function<TargetPoint(double s)> target;
  bool face_on_left = true;  ///< of the path in the parameter plane; on a knot line the face's side counts
  std::string name = {};     ///< what failures call it; empty: "path" and its number from 1
};

struct FaceTask {
  opencascade::handle<Geom_BSplineSurface> surface;  ///< placed in space; it may be periodic
  std::vector<FollowPath>
      paths;  ///< all boundaries of the face: those that stay have what the face shows there as their target
  ContinuityTolerance tolerance;
  double share = 0.25;      ///< of the tolerance, to be met at the samples
  int max_refinements = 6;  ///< halvings of knot spans near the paths
  int max_poles = 40000;    ///< no refinement beyond
  /// No refinement once so many moves of poles were solved for, summed over all solutions: a limit of the work that depends neither on the
  /// machine nor on threads.
  int max_work = 50000;
  /// What was refined and is met to this share of the tolerance is refined, and moved less fairly, no more ...
  double fair_share = 0.7;
  int fair_work = 5000;  ///< ... once so many were solved for
  double max_move_mm =
      std::numeric_limits<double>::infinity();  ///< targets further away are refused before any work
  std::function<bool()> is_cancelled = {};      ///< asked before each solution; may be none
};

struct FaceFollow {
  opencascade::handle<Geom_BSplineSurface>
      surface;  ///< with the parameters of the given one; its knots may be more, its degrees higher
  double largest_move_mm = 0;  ///< of a pole, against the given surface with the same degrees and knots
  int refinements = 0;
  /// The worst figure over its tolerance at the samples and between them, one a path; infinite where a normal is turned.
  std::vector<double> ratios;
  /// By path: it can't be met to the tolerance. Of a task that was refused only the paths that are the reason.
  std::vector<bool> missed;
  /// Why a ratio is above the share, with the place and the figures, or where the surface folds; empty: all is well. The surface is the
  /// best that was found also then.
  std::string failure;
};

/// The smallest move of the poles near the paths (least squares, with fairness of the move) that meets the targets.
/// Weights stay. Poles that no path touches stay to the bit: the surface stays where their functions alone are not zero, and along a
/// natural side only rows 0..order move. A side that is one point stays one. A surface that meets its targets comes back as it is.
/// Where the share is not met, the knot spans that a path crosses there are halved; degrees not above the order are raised before, as a
/// knot would be a crease. The move is as fair as the targets allow; refinement is preferred to moves that grow beyond twice the fairest.
/// At a corner where curvature is asked for along two paths it is met with the first power of the spans' size, as the changes of both
/// curvatures mostly contradict one another there.
/// Where the targets' normals turn along a path its points are met so closely that tangent planes agree at nearest points too: what a point is
/// off along the path, times that turn, counts as angle.
/// No work is done where it is in vain for certain: a path's point is further from the face than poles may move, or its normal turned by
/// more than 90 degrees. Refinement ends where two in a row gained nothing.
/// \throws Standard_Failure; Cancelled.
/// Source: MATH-surfaces 7.
FaceFollow followPaths(const FaceTask& task);

}  // namespace seamwright::occ
