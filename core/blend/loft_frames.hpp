// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>

#include <seamwright/core/blend/frame_loft.hpp>

/// The frames of a loft; not a public header.
namespace seamwright::loft {

/// The frames, each evaluated once, checked and raised to the degree of the loft.
class Frames {
 public:
  Frames(const FrameFunction& function, const Interval& omegas, int order);

  /// \throws std::invalid_argument, with omega, for an invalid frame or one of another structure.
  const BezierSpline& at(double omega);
  int count() const { return static_cast<int>(frames_.size()); }
  int degree() const { return degree_; }
  int segments() const { return segments_; }
  bool closed() const { return closed_; }
  /// From now on frames are raised to that degree at least.
  void raiseTo(int degree);

 private:
  BezierSpline checked(double omega) const;

  const FrameFunction& function_;
  std::map<double, BezierSpline> frames_;
  int given_degree_ = 0, degree_ = 0, segments_ = 0;
  bool closed_ = false;
};

/// The largest distance of corresponding poles. \throws std::invalid_argument if the weights differ
/// by more than rounding.
double poleDistance(const BezierSpline& a, const BezierSpline& b);

}  // namespace seamwright::loft
