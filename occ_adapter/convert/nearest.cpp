// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>

#include <seamwright/occ_adapter/convert/nearest.hpp>

namespace seamwright::occ {

namespace {

/// Goes downhill from a parameter along a path.
class Descent {
 public:
  Descent(const FaceStrip& path, const Eigen::Vector3d& p, double start, double low, double high)
      : path_(path),
        p_(p),
        low_(low),
        high_(high),
        s_(std::clamp(start, low, high)),
        at_(path.trace(s_)) {}

  double parameter() const { return s_; }

  /// One Gauss-Newton step, halved until it leads downhill. \returns whether to go on.
  bool step() {
    const double full = (p_ - at_.p).dot(at_.d) / at_.d.squaredNorm();
    if (!std::isfinite(full)) return leaveStationary();
    for (double step = std::clamp(full, low_ - s_, high_ - s_); std::abs(step) >= least_step;
         step /= 2)
      if (moveTo(s_ + step)) return true;
    return false;
  }

 private:
  /// Of the path's range. A hundred times the rounding of s: shorter steps change no distance.
  static constexpr double least_step = 1e-13;

  bool moveTo(double s) {
    const double next = std::clamp(s, low_, high_);
    const PathPoint there = path_.trace(next);
    if (!((p_ - there.p).squaredNorm() < (p_ - at_.p).squaredNorm())) return false;
    s_ = next;
    at_ = there;
    return true;
  }

  /// Where the path stands still its derivative shows no way down.
  bool leaveStationary() {
    // Near beside any bend of an edge, and far enough that a derivative that grows linearly from 0
    // is well above rounding.
    constexpr double aside = 1e-4;
    return at_.p.allFinite() && (moveTo(s_ + aside) || moveTo(s_ - aside));
  }

  const FaceStrip& path_;
  const Eigen::Vector3d& p_;
  double low_;
  double high_;
  double s_;
  PathPoint at_;
};

}  // namespace

double nearestParameter(const FaceStrip& path, const Eigen::Vector3d& p, double start, double low,
                        double high) {
  Descent descent(path, p, start, low, high);
  // Near the path steps converge quadratically and a few are enough. Far from it they converge
  // linearly, and the last digits do not matter: this bounds the time.
  constexpr int most_steps = 60;
  for (int i = 0; i < most_steps && descent.step(); ++i) continue;
  return descent.parameter();
}

}  // namespace seamwright::occ
