// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include <seamwright/core/bezier/curve.hpp>

namespace seamwright {

/// How many poles beside an end of a curve are equal to its end pole. The derivatives by the
/// parameter up to that order are 0 there: the curve stops. It has a tangent nevertheless, from the
/// end to the first pole that differs.
struct StoppedEnds {
  int start = 0, end = 0;

  bool any() const { return start > 0 || end > 0; }
};

/// Poles that differ by no more than their rounding count as equal. A curve that is a point has no
/// stopped ends.
///   (1) r'(t) / (t^start (1 - t)^end) is not 0 at both ends, and has the direction of the tangent.
/// Source: docs/theory/planar.md P8.7.
StoppedEnds stoppedEnds(const BezierCurve& curve);

/// The unit tangent at t = 0 or 1 if the curve stops there; nothing elsewhere.
std::optional<Eigen::Vector3d> stoppedTangent(const BezierCurve& curve, double t);

/// Whether all poles are equal up to their rounding.
bool isPoint(const BezierCurve& curve);

}  // namespace seamwright
