// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include <seamwright/core/blend/frame_form.hpp>
#include <seamwright/core/blend/frame_sheet.hpp>

/// The common work of frameLoft() and frameSheet(); not a public header.
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

struct Ends {
  std::optional<SheetEnd> start, end;
};

/// \throws std::invalid_argument that names the option and its value.
void requireOptions(const Interval& omegas, const FrameLoftOptions& options);

/// The loft through the frames with these ends.
FrameLoft builtLoft(const FrameFunction& frame, const Interval& omegas, const Ends& ends,
                    const FrameLoftOptions& options);

}  // namespace seamwright::loft
