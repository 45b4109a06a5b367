// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <seamwright/core/blend/frame_form.hpp>
#include <seamwright/core/blend/loft_frames.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::loft {

Frames::Frames(const FrameFunction& function, const Interval& omegas, int order)
    : function_(function) {
  if (!function) refuse("no function of the frames");
  const BezierSpline first = checked(omegas.lower);
  given_degree_ = first.degree;
  segments_ = first.segments();
  closed_ = first.closed;
  const bool joints = segments_ > 1 || closed_;
  degree_ = joints ? std::max(first.degree, 2 * order + 1) : first.degree;
  if (degree_ > max_spline_degree)
    refuse(fmt::format("degree {} is needed: {} is the highest", degree_, max_spline_degree));
  frames_.emplace(omegas.lower, raised(first, degree_));
}

const BezierSpline& Frames::at(double omega) {
  const auto known = frames_.find(omega);
  if (known != frames_.end()) return known->second;
  return frames_.emplace(omega, raised(checked(omega), degree_)).first->second;
}

void Frames::raiseTo(int degree) {
  if (degree <= degree_) return;
  if (degree > max_spline_degree)
    refuse(fmt::format("degree {} is needed: {} is the highest", degree, max_spline_degree));
  degree_ = degree;
  for (auto& [omega, frame] : frames_) frame = raised(frame, degree);
}

BezierSpline Frames::checked(double omega) const {
  BezierSpline frame = function_(omega);
  try {
    requireValid(frame);
  } catch (const std::invalid_argument& fault) {
    refuse(fmt::format("frame at omega {}: {}", omega, fault.what()));
  }
  if (segments_ > 0 &&
      (frame.degree != given_degree_ || frame.segments() != segments_ || frame.closed != closed_))
    refuse(
        fmt::format("frame at omega {}: degree {}, segments {}, {}; the first frame has degree "
                    "{}, segments {}, {}",
                    omega, frame.degree, frame.segments(), frame.closed ? "closed" : "open",
                    given_degree_, segments_, closed_ ? "closed" : "open"));
  return frame;
}

double poleDistance(const BezierSpline& a, const BezierSpline& b) {
  // Interpolation of equal weights rounds a few times for each.
  const double rounding = 64 * machine_epsilon;
  double result = 0;
  for (Eigen::Index i = 0; i < a.poles.rows(); ++i) {
    const double v = a.poles(i, 3), w = b.poles(i, 3);
    if (!(std::abs(v - w) <= rounding * w))
      refuse(fmt::format("weight {} varies with omega: {} and {}", i, v, w));
    result = std::max(result,
                      (a.poles.row(i).head<3>() / v - b.poles.row(i).head<3>() / w).stableNorm());
  }
  return result;
}

}  // namespace seamwright::loft
