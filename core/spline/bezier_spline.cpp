// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/bspline/blossom.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/spline/bezier_spline.hpp>

namespace seamwright {

namespace {

using bernstein::text;

void requireCounts(const BezierSpline& spline) {
  if (spline.degree < 1)
    refuse("degree is " + std::to_string(spline.degree) + ": at least 1 is needed");
  if (spline.knots.size() < 2)
    refuse("knots are " + std::to_string(spline.knots.size()) + ": at least 2 are needed");
  if (const Eigen::Index count = static_cast<Eigen::Index>(spline.segments()) * spline.degree + 1;
      spline.poles.rows() != count)
    refuse("poles " + std::to_string(spline.poles.rows()) + ": " +
           std::to_string(spline.segments()) + " segments of degree " +
           std::to_string(spline.degree) + " have " + std::to_string(count));
}

void requireKnots(const std::vector<double>& knots) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i]))
      refuse("knot " + std::to_string(i) + " is " + text(knots[i]) + ": knots must be finite");
    if (i > 0 && !(knots[i] > knots[i - 1]))
      refuse("knot " + std::to_string(i) + " is " + text(knots[i]) + ", the one before " +
             text(knots[i - 1]) + ": knots must increase");
  }
  if (const double range = knots.back() - knots.front(); !std::isnormal(range))
    refuse("the knots range over " + text(range) + ": that must not overflow, nor underflow");
}

/// The pole with that weight at the same point.
Eigen::RowVector4d reweighted(const Eigen::RowVector4d& pole, double weight) {
  Eigen::RowVector4d result = pole * (weight / pole(3));
  result(3) = weight;
  return result;
}

HomogeneousPoles polesOf(const BezierSpline& spline, int i) {
  return spline.poles.middleRows(static_cast<Eigen::Index>(i) * spline.degree, spline.degree + 1);
}

/// The segments, all of the highest degree.
std::vector<HomogeneousPoles> ofOneDegree(const std::vector<BezierCurve>& segments) {
  int degree = 1;
  for (const BezierCurve& segment : segments) degree = std::max(degree, segment.degree());
  std::vector<HomogeneousPoles> result;
  for (BezierCurve segment : segments) {
    while (segment.degree() < degree) segment = segment.elevated();
    result.push_back(segment.homogeneousPoles());
  }
  return result;
}

void requireGap(const Eigen::RowVector4d& end, const Eigen::RowVector4d& start, std::size_t joint,
                double gap_mm) {
  const double gap = (end.head<3>() / end(3) - start.head<3>() / start(3)).stableNorm();
  if (!(gap <= gap_mm))
    refuse("joint " + std::to_string(joint) + ": the ends are " + text(gap) +
           " mm apart, allowed " + text(gap_mm));
}

/// The end pole of the last segment so far has moved across a gap. Poles that were equal to it move
/// along, so that the tangent stays. \param end row of the pole. \param segment as it was given.
void moveEqualPoles(HomogeneousPoles& poles, Eigen::Index end, const BezierCurve& segment) {
  const int count = stoppedEnds(segment).end;
  for (Eigen::Index i = end - count; i < end; ++i)
    poles.row(i) = reweighted(poles.row(end), poles(i, 3));
}

/// The jumps of the homogeneous derivatives of orders 0.. at inner knot i, and bounds of the jumps
/// that rounding of the poles causes. Each row is (jump, bound).
Eigen::MatrixX2d jumps(const BezierSpline& spline, int i, int order) {
  const int n = spline.degree;
  const int last = i > 0 ? i - 1 : spline.segments() - 1;
  const HomogeneousPoles before = polesOf(spline, last), after = polesOf(spline, i);
  const auto arriving = casteljau::derivatives<4, Eigen::Dynamic>(before, 1, order + 1);
  const auto leaving = casteljau::derivatives<4, Eigen::Dynamic>(after, 0, order + 1);
  const double h = spline.knots[last + 1] - spline.knots[last],
               k = spline.knots[i + 1] - spline.knots[i];
  double noise_h =
      8 * (n + 4) * std::numeric_limits<double>::epsilon() * before.cwiseAbs().maxCoeff();
  double noise_k =
      8 * (n + 4) * std::numeric_limits<double>::epsilon() * after.cwiseAbs().maxCoeff();
  double power_h = 1, power_k = 1;
  Eigen::MatrixX2d result(order + 1, 2);
  for (int r = 0; r <= order; ++r) {
    result.row(r) << (leaving.row(r) / power_k - arriving.row(r) / power_h).stableNorm(),
        noise_h + noise_k;
    power_h *= h;
    power_k *= k;
    noise_h *= 2 * (n - r) / h;
    noise_k *= 2 * (n - r) / k;
  }
  return result;
}

void requireContinuity(const BezierSpline& spline, int order) {
  for (int i = 1; i < spline.segments(); ++i) {
    const Eigen::MatrixX2d rows = jumps(spline, i, order);
    for (int r = 1; r <= order; ++r)
      if (!(rows(r, 0) <= rows(r, 1)))
        refuse("knot " + std::to_string(i) + ": the derivative of order " + std::to_string(r) +
               " jumps by " + text(rows(r, 0)) + ", rounding " + text(rows(r, 1)));
  }
}

/// The segment whose blossom is evaluated at increasing arguments. It is the longest segment
/// between the arguments, because it extrapolates least. If all arguments are one knot, it is the
/// segment that begins there (at the last knot: that ends there).
int segmentFor(const std::vector<double>& knots, const double* first, const double* last) {
  const auto from =
      static_cast<int>(std::lower_bound(knots.begin(), knots.end(), *first) - knots.begin());
  const auto to =
      static_cast<int>(std::lower_bound(knots.begin(), knots.end(), *last) - knots.begin());
  int best = std::min(from, static_cast<int>(knots.size()) - 2);
  for (int i = from; i < to; ++i)
    if (knots[i + 1] - knots[i] > knots[best + 1] - knots[best]) best = i;
  return best;
}

/// The curve of that order whose poles are blossoms of the segments.
BSplineCurve merged(const BezierSpline& spline, int order) {
  const int n = spline.degree;
  BSplineCurve result{
      n, std::vector<double>(static_cast<std::size_t>(n) + 1, spline.knots.front()), {}};
  for (int i = 1; i < spline.segments(); ++i)
    result.knots.insert(result.knots.end(), static_cast<std::size_t>(n - order), spline.knots[i]);
  result.knots.insert(result.knots.end(), static_cast<std::size_t>(n) + 1, spline.knots.back());
  result.poles.resize(result.count(), 4);
  for (int i = 0; i < result.count(); ++i) {
    const double* arguments = result.knots.data() + i + 1;
    const int piece = segmentFor(spline.knots, arguments, arguments + n - 1);
    std::vector<double> ends(2 * static_cast<std::size_t>(n), spline.knots[piece]);
    std::fill(ends.begin() + n, ends.end(), spline.knots[piece + 1]);
    result.poles.row(i) = bspline::blossom(polesOf(spline, piece), ends.data(), arguments);
  }
  requireValid(result);
  return result;
}

/// The first segment whose poles the curve does not reproduce up to rounding, or -1. The jumps
/// alone are not sufficient beside a short segment, because the rounding of its derivatives hides
/// the derivatives of its neighbours.
int strayed(const BezierSpline& spline, const BSplineCurve& curve, int order) {
  const int n = spline.degree;
  const HomogeneousPoles back = bezierSpline(curve).poles;
  const double share = std::ldexp(8 * (n + 4) * std::numeric_limits<double>::epsilon(), 2 * order);
  for (int i = 0; i < spline.segments(); ++i) {
    const auto own = spline.poles.middleRows(static_cast<Eigen::Index>(i) * n, n + 1);
    const auto given = back.middleRows(static_cast<Eigen::Index>(i) * n, n + 1);
    const double size = curve.poles.middleRows(static_cast<Eigen::Index>(i) * (n - order), n + 1)
                            .cwiseAbs()
                            .maxCoeff();
    if (!((given - own).cwiseAbs().maxCoeff() <= share * size)) return i;
  }
  return -1;
}

/// Up to \p degree segments before and after the seam of a closed spline, with the seam at knot 0.
/// So lengths beside the seam keep their digits. The range ends before knots that would become
/// equal.
BezierSpline aroundSeam(const BezierSpline& spline) {
  const std::vector<double>& knots = spline.knots;
  const int segments = spline.segments(), most = std::min(segments, spline.degree);
  BezierSpline result{spline.degree, {0.0}, {}};
  Eigen::Index before = 0, after = 0;
  while (after < most && knots[after + 1] - knots.front() > result.knots.back())
    result.knots.push_back(knots[++after] - knots.front());
  while (before < most && knots[segments - before - 1] - knots.back() < result.knots.front())
    result.knots.insert(result.knots.begin(), knots[segments - ++before] - knots.back());
  result.poles.resize((before + after) * spline.degree + 1, 4);
  result.poles.topRows(before * spline.degree + 1) =
      spline.poles.bottomRows(before * spline.degree + 1);
  result.poles.bottomRows(after * spline.degree + 1) =
      spline.poles.topRows(after * spline.degree + 1);
  return result;
}

/// Whether a curve of that order reproduces all segments.
bool isMerged(const BezierSpline& spline, int order) {
  return strayed(spline, merged(spline, order), order) < 0;
}

}  // namespace

void requireValid(const BezierSpline& spline) {
  requireCounts(spline);
  requireKnots(spline.knots);
  requireValid(spline.poles);
  const Eigen::RowVector4d first = spline.poles.row(0),
                           last = spline.poles.row(spline.poles.rows() - 1);
  if (spline.closed && last != reweighted(first, last(3)))
    refuse("the last pole, " + std::to_string(spline.poles.rows() - 1) + ", is " +
           text((last.head<3>() / last(3) - first.head<3>() / first(3)).stableNorm()) +
           " mm from the first: a closed spline ends where it begins");
}

BezierCurve segment(const BezierSpline& spline, int i) {
  requireCounts(spline);
  if (i < 0 || i >= spline.segments())
    refuse("segment " + std::to_string(i) + ": there are " + std::to_string(spline.segments()));
  return BezierCurve::fromHomogeneous(polesOf(spline, i));
}

BezierSpline bezierSpline(const std::vector<BezierCurve>& segments,
                          const std::vector<double>& knots, bool closed, double gap_mm) {
  if (segments.empty()) refuse("no segments: at least one is needed");
  if (knots.size() != segments.size() + 1)
    refuse("segments " + std::to_string(segments.size()) + ", knots " +
           std::to_string(knots.size()) + ": one more is needed");
  if (!(gap_mm >= 0)) refuse("gap_mm is " + text(gap_mm) + ": it must not be negative");
  std::vector<HomogeneousPoles> rows = ofOneDegree(segments);
  const Eigen::Index n = rows.front().rows() - 1;
  BezierSpline result{static_cast<int>(n), knots, HomogeneousPoles(n * rows.size() + 1, 4), closed};
  result.poles.topRows(n + 1) = rows.front();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    auto end = result.poles.row(static_cast<Eigen::Index>(i) * n);
    requireGap(end, rows[i].row(0), i, gap_mm);
    result.poles.middleRows(static_cast<Eigen::Index>(i) * n, n + 1) =
        rows[i] * (end(3) / rows[i](0, 3));
    moveEqualPoles(result.poles, static_cast<Eigen::Index>(i) * n, segments[i - 1]);
  }
  if (closed) {
    auto end = result.poles.row(result.poles.rows() - 1);
    requireGap(end, rows.front().row(0), rows.size(), gap_mm);
    end = reweighted(rows.front().row(0), end(3)).eval();
    moveEqualPoles(result.poles, result.poles.rows() - 1, segments.back());
  }
  requireValid(result);
  return result;
}

BezierSpline splineOverLengths(const std::vector<BezierCurve>& segments, bool closed,
                               double gap_mm) {
  std::vector<BezierCurve> kept;
  std::vector<double> knots = {0};
  for (const BezierCurve& one : segments) {
    const double length_mm = polygonLength(one);
    if (length_mm == 0) continue;
    knots.push_back(knots.back() + length_mm);
    kept.push_back(one);
  }
  return bezierSpline(kept, knots, closed, gap_mm);
}

CurveDerivatives derivatives(const BezierSpline& spline, double t, int order) {
  requireCounts(spline);
  if (!std::isfinite(t)) refuse("parameter t is " + text(t) + ": it must be finite");
  const auto above = std::upper_bound(spline.knots.begin() + 1, spline.knots.end() - 1, t);
  const auto i = static_cast<int>(above - spline.knots.begin()) - 1;
  const double start = spline.knots[i], length = spline.knots[i + 1] - start;
  CurveDerivatives result = segment(spline, i).derivatives((t - start) / length, order);
  for (Eigen::Index k = 1; k < result.rows(); ++k) result.bottomRows(result.rows() - k) /= length;
  return result;
}

std::vector<CurveJoint> measureJoints(const BezierSpline& spline, int order) {
  requireValid(spline);
  std::vector<CurveJoint> joints;
  const BezierCurve first = segment(spline, 0);
  BezierCurve before = first;
  for (int i = 1; i < spline.segments(); ++i) {
    BezierCurve after = segment(spline, i);
    joints.push_back(measureJoint(before, after, order));
    before = std::move(after);
  }
  if (spline.closed) joints.push_back(measureJoint(before, first, order));
  return joints;
}

int continuity(const BezierSpline& spline, bool around) {
  requireValid(spline);
  if (around && !spline.closed) return -1;
  int order = spline.degree - 1;
  for (int i = around ? 0 : 1; i < spline.segments(); ++i) {
    const Eigen::MatrixX2d rows = jumps(spline, i, order);
    while (
        order >= 0 &&
        !(rows.topRows(order + 1).col(0).array() <= rows.topRows(order + 1).col(1).array()).all())
      --order;
  }
  while (order > 0 && !isMerged(spline, order)) --order;
  while (around && order > 0 && !isMerged(aroundSeam(spline), order)) --order;
  return order;
}

BSplineCurve bsplineCurve(const BezierSpline& spline, int order) {
  requireValid(spline);
  const int n = spline.degree;
  if (order < 0 || order >= n)
    refuse("order is " + std::to_string(order) + ": 0 to degree - 1, " + std::to_string(n - 1) +
           ", is possible");
  requireContinuity(spline, order);
  BSplineCurve result = merged(spline, order);
  if (const int i = strayed(spline, result, order); i >= 0)
    refuse("segment " + std::to_string(i) + " does not go into a curve of order " +
           std::to_string(order) +
           ": beside a short segment derivatives jump by more than their rounding shows");
  return result;
}

BezierSpline bezierSpline(const BSplineCurve& curve, bool closed) {
  requireValid(curve);
  const int n = curve.degree;
  BezierSpline result{n, curve.knots, {}, closed};
  result.knots.erase(std::unique(result.knots.begin(), result.knots.end()), result.knots.end());
  result.poles.resize(static_cast<Eigen::Index>(result.segments()) * n + 1, 4);
  for (int i = 0; i < result.segments(); ++i) {
    const int span = bspline::spanOf(n, curve.knots, result.knots[i]);
    const HomogeneousPoles local = curve.poles.middleRows(span - n, n + 1);
    std::vector<double> arguments(2 * static_cast<std::size_t>(n), result.knots[i]);
    std::fill(arguments.begin() + n, arguments.end(), result.knots[i + 1]);
    for (int j = 0; j <= n; ++j)
      result.poles.row(static_cast<Eigen::Index>(i) * n + j) =
          bspline::blossom(local, curve.knots.data() + span - n + 1, arguments.data() + j);
  }
  requireValid(result);
  return result;
}

}  // namespace seamwright
