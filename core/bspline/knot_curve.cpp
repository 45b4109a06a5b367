// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/bspline/blossom.hpp>
#include <seamwright/core/bspline/knot_curve.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using bernstein::text;
using Eigen::Index;

/// The largest number of turns. Beyond 2^40 turns a double near the parameter keeps only the
/// leading 12 to 13 bits of a period.
constexpr double kMostTurns = 0x1p40;

void requireMultiplicities(const KnotCurve& curve) {
  const std::vector<int>& times = curve.multiplicities;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool end = !curve.periodic && (i == 0 || i + 1 == times.size());
    if (const int most = curve.degree + (end ? 1 : 0); times[i] < 1 || times[i] > most)
      refuse("multiplicity " + std::to_string(i) + " is " + std::to_string(times[i]) + ": 1 to " +
             std::to_string(most) + " is needed");
  }
  if (curve.periodic && times.front() != times.back())
    refuse("multiplicities of the first and the last knot are " + std::to_string(times.front()) +
           " and " + std::to_string(times.back()) + ": of a periodic curve they must be equal");
  const int poles = std::accumulate(times.begin() + (curve.periodic ? 1 : 0), times.end(), 0) -
                    (curve.periodic ? 0 : curve.degree + 1);
  if (poles < (curve.periodic ? 1 : curve.degree + 1) || curve.poles.rows() != poles)
    refuse("poles " + std::to_string(curve.poles.rows()) + ", knots of degree " +
           std::to_string(curve.degree) + " for " + std::to_string(poles) +
           ": the numbers must be equal");
}

void requireNumbers(const KnotCurve& curve) {
  bspline::requireDegree(curve.degree, "");
  if (curve.knots.size() < 2 || curve.multiplicities.size() != curve.knots.size())
    refuse("knots " + std::to_string(curve.knots.size()) + ", multiplicities " +
           std::to_string(curve.multiplicities.size()) + ": as many, and at least 2, are needed");
  for (std::size_t i = 0; i < curve.knots.size(); ++i) {
    if (!std::isfinite(curve.knots[i]))
      refuse("knot " + std::to_string(i) + " is " + text(curve.knots[i]) +
             ": knots must be finite");
    if (i > 0 && !(curve.knots[i] > curve.knots[i - 1]))
      refuse("knot " + std::to_string(i) + " is " + text(curve.knots[i]) + " after " +
             text(curve.knots[i - 1]) + ": knots must increase");
  }
  requireMultiplicities(curve);
  requireValid(curve.poles);
}

/// The curve with flat knots, clamped or not, and its poles.
BSplineCurve flat(const KnotCurve& curve) {
  BSplineCurve result{curve.degree, {}, curve.poles};
  for (std::size_t i = 0; i < curve.knots.size(); ++i)
    result.knots.insert(result.knots.end(), static_cast<std::size_t>(curve.multiplicities[i]),
                        curve.knots[i]);
  return result;
}

/// The turns of a periodic curve that cover [first, last], and as many turns before and after them
/// as hold degree + 1 knots.
BSplineCurve unwound(const KnotCurve& curve, double first, double last) {
  const double start = curve.knots.front(), end = curve.knots.back(), period = end - start;
  std::vector<double> turn;
  for (std::size_t i = 1; i < curve.knots.size(); ++i)
    turn.insert(turn.end(), static_cast<std::size_t>(curve.multiplicities[i]), curve.knots[i]);
  const Index count = curve.poles.rows(), around = (curve.degree + count) / count;
  const Index from = static_cast<Index>(std::floor((first - start) / period)) - around;
  const Index to = static_cast<Index>(std::ceil((last - start) / period)) + around;
  BSplineCurve result{curve.degree, {}, {}};
  for (Index k = from; k < to; ++k) {
    const auto turns = static_cast<double>(k);
    for (const double knot : turn)
      result.knots.push_back(k < 0 && knot == end ? start + (turns + 1) * period
                                                  : knot + turns * period);
  }
  result.poles.resize(result.count(), 4);
  for (Index i = 0; i < result.poles.rows(); ++i)
    result.poles.row(i) = curve.poles.row((i + curve.degree + 1) % count);
  return result;
}

/// The curve from u on. Its first poles are the last ones of de Boor's triangle at u; the poles
/// that u does not affect follow.
BSplineCurve begunAt(const BSplineCurve& curve, double u) {
  const int n = curve.degree, span = bspline::spanOf(n, curve.knots, u);
  const double* left = curve.knots.data() + span - n;
  HomogeneousPoles triangle = curve.poles.middleRows(span - n, n + 1);
  BSplineCurve result{n, std::vector<double>(static_cast<std::size_t>(n) + 1, u), {}};
  result.knots.insert(result.knots.end(), curve.knots.begin() + span + 1, curve.knots.end());
  result.poles.resize(result.count(), 4);
  result.poles.bottomRows(result.count() - n - 1) = curve.poles.bottomRows(result.count() - n - 1);
  result.poles.row(n) = triangle.row(n);
  for (int r = 1; r <= n; ++r) {
    for (int j = n; j >= r; --j)
      triangle.row(j) = bspline::between(triangle.row(j - 1), triangle.row(j),
                                         (u - left[j]) / (left[n + j - r + 1] - left[j]));
    result.poles.row(n - r) = triangle.row(n);
  }
  return result;
}

BSplineCurve reversed(BSplineCurve curve) {
  std::ranges::reverse(curve.knots);
  for (double& knot : curve.knots) knot = -knot;
  curve.poles = curve.poles.colwise().reverse().eval();
  return curve;
}

bool isClamped(const KnotCurve& curve) {
  return !curve.periodic && curve.multiplicities.front() > curve.degree &&
         curve.multiplicities.back() > curve.degree;
}

}  // namespace

std::pair<double, double> rangeOf(const KnotCurve& curve) {
  requireNumbers(curve);
  if (curve.periodic) return {curve.knots.front(), curve.knots.back()};
  const std::vector<double> knots = flat(curve).knots;
  return {knots[static_cast<std::size_t>(curve.degree)],
          knots[knots.size() - static_cast<std::size_t>(curve.degree) - 1]};
}

BSplineCurve clampedCurve(const KnotCurve& curve, double first, double last) {
  const std::pair<double, double> range = rangeOf(curve);
  if (!(range.first < range.second))
    refuse("the range is " + text(range.first) + " to " + text(range.second) +
           ": it must not be empty");
  if (!(first < last) || !std::isfinite(last - first))
    refuse("first is " + text(first) + ", last " + text(last) +
           ": first must be below last, both finite");
  const double period = range.second - range.first;
  if (curve.periodic &&
      !(last - first <= 2 * period && std::abs(first - range.first) <= kMostTurns * period))
    refuse("first is " + text(first) + ", last " + text(last) + ": at most two periods, each " +
           text(period) + ", within 2^40 of them from its beginning");
  BSplineCurve result = curve.periodic ? unwound(curve, first, last) : flat(curve);
  if (!isClamped(curve) || std::pair(first, last) != range)
    result = reversed(begunAt(reversed(begunAt(result, first)), -last));
  requireValid(result);
  return result;
}

}  // namespace seamwright
