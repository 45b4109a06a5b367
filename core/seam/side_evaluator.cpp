// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/piecewise_map.hpp>
#include <seamwright/core/seam/side_evaluator.hpp>

namespace seamwright {

namespace {

constexpr double shortest_crossing =
    0x1p-30;  ///< of the seam: a shorter piece takes both sides of a knot line

PiecewiseMap mapOf(const SeamSide& side) {
  return {side.s, side.t};
}

/// The x in [-1, 1] at which a series takes a value, bracketed by two points on either side of the
/// value. Nothing if none of 8 steps shows a change of side.
std::optional<double> crossing(const ChebyshevModel& series, double value) {
  // A choice. Two crossings within one step are not found; the caller then cuts in the middle.
  constexpr int steps = 8;
  double low = -1;
  const auto above = [&](double x) { return series.seriesAt(x) > value; };
  for (int i = 1; i <= steps; ++i) {
    double high = -1 + 2.0 * i / steps;
    if (above(low) != above(high)) {
      // More halvings than a double has digits.
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (above(middle) == above(low) ? low : high) = middle;
      }
      return 0.5 * (low + high);
    }
    low = high;
  }
  return std::nullopt;
}

}  // namespace

bool SideFields::hasPlane() const {
  return std::ranges::all_of(alternatives, [](const SurfaceFields& fields) {
    return std::ranges::all_of(fields.normal, [](const ChebyshevModel& n) { return n.isKnown(); });
  });
}

bool SideFields::hasCurvature() const {
  return hasPlane() && std::ranges::all_of(alternatives, [](const SurfaceFields& fields) {
           return fields.bounds_curvature &&
                  std::ranges::all_of(fields.tensor,
                                      [](const ChebyshevModel& k) { return k.isKnown(); });
         });
}

SideEvaluator::SideEvaluator(const SeamSide& side) : side_(side) {
  if (side_.surface->parameterSize(0) == 0 && side_.surface->parameterSize(1) == 0) return;
  for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const ChebyshevModel t = parameter(s, s);
    const VectorModel uv = side_.path.jet(t, t.coefficient(0), 0).p;
    for (const int d : {0, 1}) reach_[d] = std::max(reach_[d], uv[d].magnitude());
  }
}

void SideEvaluator::addBreaks(std::vector<double>& breaks) const {
  const auto [low, high] = std::minmax(side_.t.front(), side_.t.back());
  breaks.insert(breaks.end(), side_.s.begin() + 1, side_.s.end() - 1);
  for (const double knot : side_.path.knotsInside({low, high}))
    breaks.push_back(mapOf(side_).backAt(knot));
}

SideFields SideEvaluator::fields(double from, double to, Detail detail) const {
  const double middle = 0.5 * (from + to);
  const ChebyshevModel t = parameter(from, to);
  const VectorModel uv = side_.path.jet(t, t.coefficient(0), 0).p;
  SideFields result;
  std::array<std::vector<double>, 2> hints;
  for (const int d : {0, 1}) {
    if (!uv[d].isKnown()) {
      result.split = middle;
      return result;
    }
    hints[d] = this->hints(d, uv, from, to, result.split);
    if (result.split) return result;
  }
  for (const double u : hints[0])
    for (const double v : hints[1])
      result.alternatives.push_back(side_.surface->fields(uv[0], uv[1], u, v, detail));
  if (detail >= Detail::CurvatureChange) {
    result.direction = side_.path.jet(t, t.coefficient(0), 1).d1;
    if (side_.t.back() < side_.t.front()) result.direction = -result.direction;
  }
  return result;
}

ChebyshevModel SideEvaluator::parameter(double from, double to) const {
  const PiecewiseMap map = mapOf(side_);
  const double t0 = map.valueAt(from), t1 = map.valueAt(to);
  const double rounding =
      8 * machine_epsilon * (std::abs(side_.t.front()) + std::abs(side_.t.back()));
  const std::size_t piece = map.pieceAt(0.5 * (from + to));
  constexpr double at_end = 0x1p-40;  // breaks that differ by rounding are one
  if (map.stride() == 1 || from < side_.s[piece] - at_end || to > side_.s[piece + 1] + at_end)
    return ChebyshevModel::linear(0.5 * (t0 + t1), 0.5 * (t1 - t0), rounding);
  // By how much the cubic differs from the chord at a third and at two thirds of the interval.
  const double begin = map.shareIn(piece, from), step = (map.shareIn(piece, to) - begin) / 3;
  const double bend0 = map.bend(piece, begin), bend1 = map.bend(piece, begin + 3 * step);
  const double first = map.bend(piece, begin + step) - (2 * bend0 + bend1) / 3,
               second = map.bend(piece, begin + 2 * step) - (bend0 + 2 * bend1) / 3;
  const double even = 27.0 / 96 * (first + second), odd = 27.0 / 64 * (first - second);
  const std::array<double, 4> cubic = {0.5 * (t0 + t1) + even, 0.5 * (t1 - t0) - odd, -even, odd};
  return ChebyshevModel::series(cubic, 2 * rounding);
}

/// One point of each smooth piece of the surface that coordinate d of the path meets.
std::vector<double> SideEvaluator::hints(int d, const VectorModel& uv, double from, double to,
                                         std::optional<double>& split) const {
  const Interval range = uv[d].range();
  const double size = side_.surface->parameterSize(d);
  if (size == 0) return {range.middle()};
  const double touch = touchingDistance(d, uv[d]);
  const std::vector<double> met =
      side_.surface->knotsInside(d, {range.lower - touch, range.upper + touch});
  std::vector<double> knots;  // the path crosses these; it does not only touch them
  for (const double knot : met)
    if (knot > range.lower + touch && knot < range.upper - touch) knots.push_back(knot);
  const double along = std::max(std::min(0x1p-36 * size, 1e-10 * uv[1 - d].range().width()), touch);
  if (!met.empty() && range.width() <= along) return besideKnots(met, d, uv);
  if (knots.empty()) return {range.middle()};
  if (to - from > shortest_crossing) {
    const double knot = knots[knots.size() / 2];
    const double x = crossing(uv[d], knot).value_or(0);
    split = 0.5 * ((1 - x) * from + (1 + x) * to);
    const double margin = 0x1p-10 * (to - from);  // a cut nearer to the end makes no progress
    split = std::clamp(*split, from + (x < -0.999 ? margin : 0), to - (x > 0.999 ? margin : 0));
    return {};
  }
  std::vector<double> hints = {range.lower};
  hints.insert(hints.end(), knots.begin(), knots.end());
  for (std::size_t i = 1; i < hints.size(); ++i)
    hints[i] = 0.5 * (hints[i] + (i + 1 < hints.size() ? hints[i + 1] : range.upper));
  return hints;
}

/// The distance within which coordinate d of the path counts as on a knot line: 2^-46 of the
/// parameter, or the rounding of the path, which is the same for a piece as for the whole path.
double SideEvaluator::touchingDistance(int d, const ChebyshevModel& coordinate) const {
  const Interval range = coordinate.range();
  const double of_parameter =
      64 * machine_epsilon * (std::abs(range.lower) + std::abs(range.upper) + range.width());
  const double of_path = 4 * coordinate.radius();
  return of_path <= 0x1p-36 * reach_[d] ? std::max(of_parameter, of_path) : of_parameter;
}

/// A hint beside knot lines that differ only by rounding, on the side of the face. Hints on both
/// sides if the path has no direction.
std::vector<double> SideEvaluator::besideKnots(const std::vector<double>& knots, int d,
                                               const VectorModel& uv) const {
  const double below = std::nextafter(knots.front(), -infinite);
  const double above = std::nextafter(knots.back(), infinite);
  const double along = uv[1 - d].coefficient(1);
  if (along == 0) return {below, above};
  const double into = (d == 0 ? -along : along) * (side_.face_on_left ? 1 : -1);
  return {into > 0 ? above : below};
}

}  // namespace seamwright
