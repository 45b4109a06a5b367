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

VectorXd distancesOf(const FunctionPoints& points) {
  return points.col(0).tail(points.rows() - 1) - points.col(0).head(points.rows() - 1);
}

/// The piece after point i as a polynomial in x - x_i.
struct FunctionPiece {
  double value, slope, second, third;

  FunctionPiece(const FunctionSpline& spline, Index i) {
    const FunctionPoints& p = spline.points;
    const double h = p(i + 1, 0) - p(i, 0), m = spline.second_per_mm(i),
                 next = spline.second_per_mm(i + 1);
    value = p(i, 1);
    slope = (p(i + 1, 1) - p(i, 1)) / h - h * (2 * m + next) / 6;
    second = m;
    third = (next - m) / h;
  }

  Eigen::Vector4d derivatives(double d) const {
    return {value + d * (slope + d * (second / 2 + d * third / 6)),
            slope + d * (second + d * third / 2), second + d * third, third};
  }
};

void requirePoints(const FunctionPoints& points, const std::optional<EndSlopes>& slopes) {
  if (points.rows() < 2) refuse(fmt::format("{} points make no spline", points.rows()));
  for (Index i = 0; i < points.rows(); ++i) {
    if (!points.row(i).allFinite())
      refuse(fmt::format("point {} is ({}, {})", i, points(i, 0), points(i, 1)));
    if (i > 0 && !(points(i, 0) > points(i - 1, 0)))
      refuse(fmt::format("x must increase: point {} has x = {} mm after {} mm", i, points(i, 0),
                         points(i - 1, 0)));
  }
  if (slopes && !(std::isfinite(slopes->start) && std::isfinite(slopes->end)))
    refuse(fmt::format("the slopes {} and {} must be finite", slopes->start, slopes->end));
}

}  // namespace

SecondEquations::SecondEquations(const VectorXd& distances_mm, bool clamped)
    : distances_(distances_mm),
      clamped_(clamped),
      diagonal_(VectorXd::Zero(distances_mm.size() + 1)),
      off_(distances_mm / 6) {
  const Index last = distances_.size();
  diagonal_.head(last) += distances_ / 3;
  diagonal_.tail(last) += distances_ / 3;
  if (!clamped_) {
    off_(0) = off_(last - 1) = 0;
    diagonal_(0) = diagonal_(last) = 1;
  }
  from_left_ = from_right_ = diagonal_;
  for (Index i = 1; i <= last; ++i) from_left_(i) -= off_(i - 1) * off_(i - 1) / from_left_(i - 1);
  for (Index i = last; i-- > 0;) from_right_(i) -= off_(i) * off_(i) / from_right_(i + 1);
}

VectorXd SecondEquations::solve(VectorXd right) const {
  const Index last = distances_.size();
  for (Index i = 1; i <= last; ++i) right(i) -= off_(i - 1) / from_left_(i - 1) * right(i - 1);
  right(last) /= from_left_(last);
  for (Index i = last; i-- > 0;) right(i) = (right(i) - off_(i) * right(i + 1)) / from_left_(i);
  return right;
}

SecondEquations::Window SecondEquations::cardinal(Index j) const {
  const double before = 1 / distances_(j - 1), after = 1 / distances_(j);
  const double left = isFree(j - 1) ? before : 0, right = isFree(j + 1) ? after : 0;
  // The rows beside j, with all rows beyond eliminated towards them.
  const double p = from_left_(j - 1), q = from_right_(j + 1), a = off_(j - 1), b = off_(j);
  const double middle =
      (-(before + after) - a * left / p - b * right / q) / (diagonal_(j) - a * a / p - b * b / q);
  std::vector<double> down = {(left - a * middle) / p}, up = {(right - b * middle) / q};
  // Each step divides by 2 at least: the couplings of a row are half of its diagonal.
  const double least = 0x1p-60 * std::abs(middle);
  for (Index i = j - 1; i > 0 && std::abs(down.back()) > least; --i)
    down.push_back(-off_(i - 1) / from_left_(i - 1) * down.back());
  for (Index i = j + 1; i < distances_.size() && std::abs(up.back()) > least; ++i)
    up.push_back(-off_(i) / from_right_(i + 1) * up.back());
  Window result{.first = j - static_cast<Index>(down.size()),
                .second = {down.rbegin(), down.rend()}};
  result.second.push_back(middle);
  result.second.insert(result.second.end(), up.begin(), up.end());
  return result;
}

FunctionSpline functionSpline(const FunctionPoints& points,
                              const std::optional<EndSlopes>& slopes) {
  requirePoints(points, slopes);
  const Index last = points.rows() - 1;
  const VectorXd h = distancesOf(points);
  const VectorXd chords = (points.col(1).tail(last) - points.col(1).head(last)).cwiseQuotient(h);
  VectorXd right = VectorXd::Zero(last + 1);
  right.segment(1, last - 1) = chords.tail(last - 1) - chords.head(last - 1);
  if (slopes) {
    right(0) = chords(0) - slopes->start;
    right(last) = slopes->end - chords(last - 1);
  }
  return {.points = points,
          .slopes = slopes,
          .second_per_mm = SecondEquations(h, slopes.has_value()).solve(std::move(right))};
}

Eigen::Vector4d derivatives(const FunctionSpline& spline, double x_mm) {
  const auto x = spline.points.col(0);
  Index low = 0, high = x.size() - 1;
  while (high - low > 1) {
    const Index middle = (low + high) / 2;
    (x(middle) <= x_mm ? low : high) = middle;
  }
  return pieceDerivatives(spline, low, x_mm);
}

Eigen::Vector4d pieceDerivatives(const FunctionSpline& spline, Index piece, double x_mm) {
  return FunctionPiece(spline, piece).derivatives(x_mm - spline.points(piece, 0));
}

VectorXd thirdJumps_per_mm2(const FunctionSpline& spline) {
  const VectorXd h = distancesOf(spline.points), &m = spline.second_per_mm;
  const VectorXd thirds = (m.tail(h.size()) - m.head(h.size())).cwiseQuotient(h);
  return thirds.tail(h.size() - 1) - thirds.head(h.size() - 1);
}

BSplineCurve bsplineCurve(const FunctionSpline& spline) {
  const FunctionPoints& p = spline.points;
  const Index last = p.rows() - 1;
  const VectorXd h = distancesOf(p);
  BSplineCurve curve{.degree = 3, .knots = {}, .poles = HomogeneousPoles::Zero(last + 3, 4)};
  curve.knots.assign(3, p(0, 0));
  curve.knots.insert(curve.knots.end(), p.col(0).begin(), p.col(0).end());
  curve.knots.insert(curve.knots.end(), 3, p(last, 0));
  curve.poles.col(3).setOnes();
  const double end_slope = FunctionPiece(spline, last - 1).derivatives(h(last - 1))(1);
  curve.poles.row(0).head<2>() = p.row(0);
  curve.poles.row(1).head<2>() << p(0, 0) + h(0) / 3,
      p(0, 1) + FunctionPiece(spline, 0).slope * h(0) / 3;
  for (Index i = 1; i < last; ++i) {
    const FunctionPiece piece(spline, i);
    curve.poles.row(i + 1).head<2>() << p(i, 0) + (h(i) - h(i - 1)) / 3,
        p(i, 1) + piece.slope * (h(i) - h(i - 1)) / 3 - piece.second * h(i - 1) * h(i) / 6;
  }
  curve.poles.row(last + 1).head<2>() << p(last, 0) - h(last - 1) / 3,
      p(last, 1) - end_slope * h(last - 1) / 3;
  curve.poles.row(last + 2).head<2>() = p.row(last);
  return curve;
}

FunctionFairness fairnessOf(const FunctionSpline& spline) {
  const Index pieces = spline.points.rows() - 1;
  const VectorXd h = distancesOf(spline.points);
  const auto from = spline.second_per_mm.head(pieces).array(),
             to = spline.second_per_mm.tail(pieces).array();
  return {.bending_per_mm = (h.array() / 3 * (from * from + from * to + to * to)).sum(),
          .jumps_per_mm2 = thirdJumps_per_mm2(spline).cwiseAbs().sum(),
          .curve = fairnessOf(bsplineCurve(spline))};
}

int FairedFunction::addedExtrema() const {
  return std::max(0, after.curve.extrema + after.curve.extrema_at_knots - before.curve.extrema -
                         before.curve.extrema_at_knots);
}

int FairedFunction::addedInflections() const {
  return std::max(0, after.curve.inflections - before.curve.inflections);
}

}  // namespace seamwright
