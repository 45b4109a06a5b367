// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <seamwright/core/fair/function_spline.hpp>
#include <seamwright/core/fair/second_equations.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

void requireFunctionTolerance(double tolerance_mm) {
  if (!(tolerance_mm >= 0) || tolerance_mm == infinite)
    refuse(fmt::format("the tolerance is {} mm: it must be at least 0 and finite", tolerance_mm));
}

FunctionSpline withOrdinates(const FunctionSpline& spline, const VectorXd& ordinates_mm) {
  FunctionPoints points = spline.points;
  points.col(1) = ordinates_mm;
  return functionSpline(points, spline.slopes);
}

/// Upper bound of the distance of two splines with the same x: the largest Bézier ordinate of their
/// difference, and the rounding of those. Source: docs/theory/planar.md P12.1.
double moveBound_mm(const FunctionSpline& a, const FunctionSpline& b) {
  if (a.points == b.points && a.second_per_mm == b.second_per_mm) return 0;
  const VectorXd y = a.points.col(1) - b.points.col(1), m = a.second_per_mm - b.second_per_mm;
  const VectorXd sizes = a.points.col(1).cwiseAbs() + b.points.col(1).cwiseAbs();
  const VectorXd bends = a.second_per_mm.cwiseAbs() + b.second_per_mm.cwiseAbs();
  double largest = 0, size = 0;
  for (Index i = 0; i + 1 < y.size(); ++i) {
    const double h = a.points(i + 1, 0) - a.points(i, 0), square = h * h / 18;
    const double first = (2 * y(i) + y(i + 1)) / 3 - square * (2 * m(i) + m(i + 1));
    const double second = (y(i) + 2 * y(i + 1)) / 3 - square * (m(i) + 2 * m(i + 1));
    largest =
        std::max({largest, std::abs(y(i)), std::abs(first), std::abs(second), std::abs(y(i + 1))});
    size = std::max(
        {size, sizes(i) + 3 * square * bends(i), sizes(i + 1) + 3 * square * bends(i + 1)});
  }
  // Each ordinate is a sum with fewer than 16 roundings by half of machine_epsilon.
  return largest + 8 * machine_epsilon * size;
}

struct Step {
  FunctionSpline spline;
  double moved_mm = 0;
};

/// The spline on the way from one to other ordinates that is furthest and within the tolerance of
/// the original one, up to 1/100 of the tolerance. The bound of the distance is convex on the way,
/// so the chord of its graph over a part of the way gives a share that is within the tolerance.
Step furthest(const FunctionSpline& original, const Step& from, const VectorXd& to,
              double tolerance_mm) {
  const auto stepTo = [&](const VectorXd& ordinates) {
    Step step{.spline = withOrdinates(original, ordinates)};
    step.moved_mm = moveBound_mm(step.spline, original);
    return step;
  };
  const Step whole = stepTo(to);
  if (whole.moved_mm <= tolerance_mm) return whole;
  const VectorXd start = from.spline.points.col(1);
  Step best = from;
  double share = 0;
  // Rounding must not spoil the last chord.
  const double wanted_mm = 0.995 * tolerance_mm;
  // Three chords reach 1/100 unless the graph has a sharp bend.
  constexpr int most_chords = 10;
  for (int k = 0; k < most_chords && best.moved_mm < 0.99 * tolerance_mm; ++k) {
    share += (1 - share) * (wanted_mm - best.moved_mm) / (whole.moved_mm - best.moved_mm);
    Step step = stepTo(start + share * (to - start));
    if (step.moved_mm > tolerance_mm) break;  // by rounding
    best = std::move(step);
  }
  return best;
}

FairedFunction faired(const FunctionSpline& before, Step step, int steps) {
  FairedFunction result;
  result.spline = std::move(step.spline);
  result.moved_mm = step.moved_mm;
  result.before = fairnessOf(before);
  result.after = result.moved_mm == 0 ? result.before : fairnessOf(result.spline);
  result.steps = steps;
  return result;
}

/// Second derivatives and jumps while ordinates move one by one.
class Corrections {
 public:
  explicit Corrections(const FunctionSpline& spline)
      : x_(spline.points.col(0)),
        ordinates_(spline.points.col(1)),
        jumps_(VectorXd::Zero(x_.size())),
        equations_(x_.tail(x_.size() - 1) - x_.head(x_.size() - 1), spline.slopes.has_value()) {
    jumps_.segment(1, x_.size() - 2) = thirdJumps_per_mm2(spline);
  }

  const VectorXd& ordinates() const { return ordinates_; }
  double jump(Index i) const { return std::abs(jumps_(i)); }

  /// Changes of the jumps by the base spline of a point.
  struct Base {
    SecondEquations::Window window;
    std::vector<double> jumps;  ///< of the points of the window

    double at(Index i) const { return jumps[i - window.first]; }
  };

  Base baseOf(Index point) const {
    Base base{.window = equations_.cardinal(point), .jumps = {}};
    for (Index i = base.window.first; i < base.window.end(); ++i)
      base.jumps.push_back(i > 0 && i + 1 < x_.size() ? jumpOf(base.window, i) : 0);
    return base;
  }

  /// The move of a point that removes its jump.
  double moveOf(const Base& base, Index point) const { return -jumps_(point) / base.at(point); }

  void add(const Base& base, Index point, double move) {
    ordinates_(point) += move;
    for (Index i = base.window.first; i < base.window.end(); ++i) jumps_(i) += move * base.at(i);
  }

 private:
  double jumpOf(const SecondEquations::Window& second, Index i) const {
    return (second.at(i + 1) - second.at(i)) / (x_(i + 1) - x_(i)) -
           (second.at(i) - second.at(i - 1)) / (x_(i) - x_(i - 1));
  }

  VectorXd x_, ordinates_, jumps_;
  SecondEquations equations_;
};

/// \returns the number of steps. Source: docs/theory/planar.md P12.2.
int correctWorst(Corrections& corrections, const VectorXd& original, double tolerance_mm) {
  const Index count = original.size();
  double threshold = 0;
  for (Index i = 1; i + 1 < count; ++i) threshold = std::max(threshold, corrections.jump(i));
  int steps = 0;
  for (int round = 0; round < max_correction_rounds; ++round) {
    threshold /= 2;
    for (Index j = 1; j + 1 < count; ++j) {
      if (!(corrections.jump(j) > threshold)) continue;
      const Corrections::Base base = corrections.baseOf(j);
      const double now = corrections.ordinates()(j) - original(j);
      const double move =
          std::clamp(corrections.moveOf(base, j), -tolerance_mm - now, tolerance_mm - now);
      ++steps;
      corrections.add(base, j, move);
    }
  }
  return steps;
}

/// The mean with the weights 1/6, 4/6, 1/6 between the ends.
VectorXd means(const VectorXd& y) {
  VectorXd result = y;
  const Index inner = y.size() - 2;
  result.segment(1, inner) = (y.head(inner) + 4 * y.segment(1, inner) + y.tail(inner)) / 6;
  return result;
}

void requireUniform(const FunctionSpline& spline) {
  if (spline.slopes) refuse("a spline with slopes at its ends can't be polished");
  const auto x = spline.points.col(0);
  const double mean = (x(x.size() - 1) - x(0)) / static_cast<double>(x.size() - 1);
  for (Index i = 1; i < x.size(); ++i) {
    const double distance = x(i) - x(i - 1);
    if (!(std::abs(distance - mean) <= 1e-9 * mean))
      refuse(
          fmt::format("points must be equally spaced: point {} is {} mm after the previous one, "
                      "the mean distance is {} mm",
                      i, distance, mean));
  }
}

}  // namespace

FunctionSpline correctedAt(const FunctionSpline& spline, Index point, double limit_mm) {
  if (point < 1 || point + 1 >= spline.points.rows())
    refuse(fmt::format("point {} of {} is not between the ends", point, spline.points.rows()));
  if (!(limit_mm >= 0)) refuse(fmt::format("the limit is {} mm: it must be at least 0", limit_mm));
  const Corrections corrections(spline);
  const double move = corrections.moveOf(corrections.baseOf(point), point);
  VectorXd ordinates = spline.points.col(1);
  ordinates(point) += std::clamp(move, -limit_mm, limit_mm);
  return withOrdinates(spline, ordinates);
}

FairedFunction correctFunction(const FunctionSpline& spline, double tolerance_mm) {
  requireFunctionTolerance(tolerance_mm);
  const Step start{.spline = spline};
  if (tolerance_mm == 0 || spline.points.rows() < 3) return faired(spline, start, 0);
  Corrections corrections(spline);
  const int steps = correctWorst(corrections, spline.points.col(1), tolerance_mm);
  return faired(spline, furthest(spline, start, corrections.ordinates(), tolerance_mm), steps);
}

FunctionSpline rebounded(const FunctionSpline& spline) {
  const FunctionPoints& p = spline.points;
  const Index last = p.rows() - 1;
  const VectorXd& m = spline.second_per_mm;
  FunctionPoints middles(last + 2, 2);
  middles.row(0) = p.row(0);
  middles.row(last + 1) = p.row(last);
  for (Index i = 0; i < last; ++i) {
    const double h = p(i + 1, 0) - p(i, 0);
    middles.row(i + 1) = (p.row(i) + p.row(i + 1)) / 2;
    middles(i + 1, 1) -= h * h * (m(i) + m(i + 1)) / 16;
  }
  const FunctionSpline half = functionSpline(middles, spline.slopes);
  VectorXd ordinates = p.col(1);
  // Point i is between the middles i and i + 1.
  for (Index i = 1; i < last; ++i) ordinates(i) = pieceDerivatives(half, i, p(i, 0))(0);
  return withOrdinates(spline, ordinates);
}

FairedFunction reboundFunction(const FunctionSpline& spline, double tolerance_mm,
                               const ReboundOptions& options) {
  requireFunctionTolerance(tolerance_mm);
  if (options.most_rebounds < 0)
    refuse(fmt::format("{} rebounds: the number must be at least 0", options.most_rebounds));
  Step now{.spline = spline};
  int steps = 0;
  while (steps < options.most_rebounds && now.moved_mm < tolerance_mm) {
    ++steps;
    const VectorXd next = rebounded(now.spline).points.col(1);
    now = furthest(spline, now, next, tolerance_mm);
    if (now.spline.points.col(1) != next) break;
  }
  return faired(spline, now, steps);
}

VectorXd polishedPoles(const VectorXd& ordinates_mm, int steps) {
  if (ordinates_mm.size() < 2) refuse(fmt::format("{} points make no spline", ordinates_mm.size()));
  if (steps < 0) refuse(fmt::format("{} steps: the number must be at least 0", steps));
  VectorXd poles = ordinates_mm;
  for (int k = 0; k < steps; ++k) poles += ordinates_mm - means(poles);
  return poles;
}

FairedFunction polishFunction(const FunctionSpline& spline, double tolerance_mm) {
  requireFunctionTolerance(tolerance_mm);
  requireUniform(spline);
  const Step start{.spline = spline};
  if (tolerance_mm == 0 || spline.points.rows() < 3) return faired(spline, start, 0);
  const VectorXd y = spline.points.col(1);
  VectorXd poles = y;
  // The error falls by the factor 2/3 at least, so this reaches rounding.
  constexpr int most_steps = 90;
  for (int k = 0; k <= most_steps; ++k) {
    const VectorXd values = means(poles);
    Step step{.spline = withOrdinates(spline, values)};
    step.moved_mm = moveBound_mm(step.spline, spline);
    if (step.moved_mm <= tolerance_mm) return faired(spline, step, k);
    poles += y - values;
  }
  return faired(spline, start, most_steps);
}

}  // namespace seamwright
