// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <seamwright/core/fair/fair_curve.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Index;

/// A cubic curve whose poles move.
class CubicPoles {
 public:
  explicit CubicPoles(const BSplineCurve& curve)
      : curve_(curve), poles_(curve.poles.leftCols<3>() / curve.poles(0, 3)) {}

  /// Whether the knot is simple and has three knots on each side.
  bool canBeFaired(int j) const {
    const std::vector<double>& u = curve_.knots;
    return j >= 4 && j < curve_.count() && u[j - 1] < u[j] && u[j] < u[j + 1];
  }

  /// Pole j - 2 after the knot j is removed and inserted again.
  Eigen::RowVector3d fairPole(int j) const {
    const std::vector<double>& u = curve_.knots;
    const Eigen::RowVector3d left =
        ((u[j + 1] - u[j - 3]) * poles_.row(j - 3) - (u[j + 1] - u[j]) * poles_.row(j - 4)) /
        (u[j] - u[j - 3]);
    const Eigen::RowVector3d right =
        ((u[j + 3] - u[j - 1]) * poles_.row(j - 1) - (u[j] - u[j - 1]) * poles_.row(j)) /
        (u[j + 3] - u[j]);
    return ((u[j + 2] - u[j]) * left + (u[j] - u[j - 2]) * right) / (u[j + 2] - u[j - 2]);
  }

  /// |jump of P'''| / |P'|^3 at a knot; 0 where the curve stops, since no pole mends that.
  double jump(int j) const {
    const double speed = speedAt(j);
    return speed > 0 ? (third(j) - third(j - 1)).norm() / std::pow(speed, 3) : 0;
  }

  void setPole(int i, const Eigen::RowVector3d& pole) { poles_.row(i) = pole; }
  Eigen::RowVector3d pole(int i) const { return poles_.row(i); }

  BSplineCurve curve() const {
    BSplineCurve result = curve_;
    result.poles.leftCols<3>() = poles_ * curve_.poles(0, 3);
    return result;
  }

 private:
  /// Pole i of the derivative of the order, by differences.
  Eigen::RowVector3d difference(int order, int i) const {
    if (order == 0) return poles_.row(i);
    const std::vector<double>& u = curve_.knots;
    const int p = 4 - order;
    return p * (difference(order - 1, i + 1) - difference(order - 1, i)) /
           (u[i + 4] - u[i + order]);
  }

  /// The third derivative on the span after knot j.
  Eigen::RowVector3d third(int j) const { return difference(3, j - 3); }

  /// The speed at a simple knot: its quadratic has two poles there.
  double speedAt(int j) const {
    const std::vector<double>& u = curve_.knots;
    const double share = (u[j] - u[j - 1]) / (u[j + 1] - u[j - 1]);
    return ((1 - share) * difference(1, j - 3) + share * difference(1, j - 2)).norm();
  }

  const BSplineCurve& curve_;
  Poles poles_;
};

/// \p wanted, or the point towards it that is at most \p limit_mm from \p from.
Eigen::RowVector3d towards(const Eigen::RowVector3d& from, const Eigen::RowVector3d& wanted,
                           double limit_mm) {
  const double distance_mm = (wanted - from).norm();
  // Rounding of the pole must not exceed the limit.
  const double rounding_mm = 4 * machine_epsilon * (from.norm() + wanted.norm());
  if (distance_mm + rounding_mm <= limit_mm) return wanted;
  const double share = std::max(limit_mm - rounding_mm, 0.0) / distance_mm;
  return from + share * (wanted - from);
}

void requireCubic(const BSplineCurve& curve) {
  if (curve.degree != 3)
    refuse(fmt::format("a curve of degree {} can't be faired at knots: only cubic ones can",
                       curve.degree));
}

/// Knots in the order of their jumps.
class KnotQueue {
 public:
  KnotQueue(const CubicPoles& poles, int knots) : jumps_(static_cast<std::size_t>(knots), 0) {
    for (int j = 0; j < knots; ++j)
      if (poles.canBeFaired(j)) {
        jumps_[j] = poles.jump(j);
        queue_.insert({jumps_[j], j});
      }
  }

  bool empty() const { return queue_.empty(); }
  int takeLargest() {
    const int j = std::prev(queue_.end())->second;
    queue_.erase(std::prev(queue_.end()));
    return j;
  }

  /// Sum over the knots that pole j - 2 influences.
  double sumAround(int j) const {
    double sum = 0;
    for (int k = first(j); k <= last(j); ++k) sum += jumps_[k];
    return sum;
  }
  double sumAround(int j, const CubicPoles& poles) const {
    double sum = 0;
    for (int k = first(j); k <= last(j); ++k)
      if (poles.canBeFaired(k)) sum += poles.jump(k);
    return sum;
  }
  /// Neighbours of a pole that moved are tried again.
  void update(int j, const CubicPoles& poles) {
    for (int k = first(j); k <= last(j); ++k) {
      if (!poles.canBeFaired(k)) continue;
      queue_.erase({jumps_[k], k});
      jumps_[k] = poles.jump(k);
      if (k != j) queue_.insert({jumps_[k], k});
    }
  }

 private:
  int first(int j) const { return std::max(j - 3, 0); }
  int last(int j) const { return std::min(j + 3, static_cast<int>(jumps_.size()) - 1); }

  std::vector<double> jumps_;
  std::set<std::pair<double, int>> queue_;
};

}  // namespace

BSplineCurve fairedAtKnot(const BSplineCurve& curve, int index, double limit_mm) {
  fairnessOf(curve);
  requireCubic(curve);
  if (!(limit_mm >= 0)) refuse(fmt::format("the limit is {} mm: it must be at least 0", limit_mm));
  CubicPoles poles(curve);
  if (!poles.canBeFaired(index))
    refuse(fmt::format("knot {} is not a simple knot with three knots on each side", index));
  const Eigen::RowVector3d old = poles.pole(index - 2);
  poles.setPole(index - 2, towards(old, poles.fairPole(index), limit_mm));
  return poles.curve();
}

FairedCurve fairKnots(const BSplineCurve& curve, double tolerance_mm,
                      const CurveFairingOptions& options, const Progress& progress) {
  FairedCurve result = fairCurve(curve, 0, {}, progress);
  requireCubic(curve);
  if (!(tolerance_mm >= 0) || tolerance_mm == infinite)
    refuse(fmt::format("the tolerance is {} mm: it must be at least 0 and finite", tolerance_mm));
  CubicPoles poles(curve);
  const CubicPoles original(curve);
  const int held = static_cast<int>(options.ends), count = curve.count();
  KnotQueue queue(poles, static_cast<int>(curve.knots.size()));
  // Each success puts six neighbours back; five rounds over all knots are enough in practice.
  const int max_steps = 5 * count;
  while (!queue.empty() && result.steps < max_steps) {
    checkProgress(progress, static_cast<double>(result.steps) / max_steps);
    const int j = queue.takeLargest(), pole = j - 2;
    if (pole < held || pole >= count - held) continue;
    ++result.steps;
    const double before = queue.sumAround(j);
    const Eigen::RowVector3d old = poles.pole(pole);
    poles.setPole(pole, towards(original.pole(pole), poles.fairPole(j), tolerance_mm));
    // Smaller gains are not worth a move, and rounding would make the loop long.
    if (queue.sumAround(j, poles) < 0.99 * before)
      queue.update(j, poles);
    else
      poles.setPole(pole, old);
  }
  result.curve = poles.curve();
  for (int i = 0; i < count; ++i)
    result.moved_mm = std::max(result.moved_mm, (poles.pole(i) - original.pole(i)).norm());
  result.after = fairnessOf(result.curve);
  return result;
}

}  // namespace seamwright
