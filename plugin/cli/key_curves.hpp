// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <seamwright/core/spline/bezier_spline.hpp>
#include <seamwright/occ_adapter/analyze/report.hpp>
#include <seamwright/plugin/cli/blend_command.hpp>
#include <seamwright/plugin/cli/sampled_curve.hpp>
#include <string>
#include <vector>

namespace seamwright::cli {

/// A key curve of `seamwright curve blend` as it is given.
struct KeyCurve {
  std::size_t input = 0;      ///< index of its file
  std::vector<int> edges;     ///< of a model, along the curve; empty for points
  std::ptrdiff_t points = 0;  ///< of a file of points; 0 for edges
  /// Numbers of the points, from 1, at which the curve has a corner.
  std::vector<std::ptrdiff_t> corners = {};
  /// The curve is the lines and arcs of which the points are samples.
  std::optional<SampledCurve> sampled = {};
  /// The mean angle of the polygon of the points, if the curve is a spline without corners.
  double turn_rad = 0;
  BezierSpline curve;        ///< polynomial
  double gap_mm = 0;         ///< the largest gap between edges that was closed
  double polynomial_mm = 0;  ///< bound of the distance from the rational curve
};

/// Two or more curves in the order of the files.
struct KeyCurves {
  std::vector<occ::ModelFacts> facts;  ///< of each file
  std::vector<KeyCurve> curves;
  std::vector<std::vector<std::string>> notes;  ///< of each file
};

/// Reads files of points and models, whose edges are joined to curves. Points are a sampledCurve(),
/// or a C2 cubic spline with centripetal knots is laid through them from corner to corner
/// (pointCorners(), for points in a plane within the tolerance). Each file has one curve; a single
/// model has all of them, in the order of their edges. \throws std::runtime_error for a file that
/// has no or several curves, and for fewer than two curves; occ::ModelError, occ::Cancelled.
KeyCurves keyCurves(const BlendArguments& arguments);

}  // namespace seamwright::cli
