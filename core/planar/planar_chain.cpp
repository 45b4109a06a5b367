// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include <seamwright/core/bezier/length.hpp>
#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/planar_chain.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

Vector2d pole(const BSplineCurve& curve, Eigen::Index i) {
  return curve.poles.row(i).head<2>() / curve.poles(i, 3);
}

BSplineCurve reversedSpline(const BSplineCurve& curve) {
  BSplineCurve result = curve;
  const double ends = curve.knots.front() + curve.knots.back();
  std::ranges::reverse(result.knots);
  for (double& knot : result.knots) knot = ends - knot;
  // Both ends stay bitwise, so that all knots of an end are equal.
  for (int i = 0; i <= curve.degree; ++i) {
    result.knots[i] = curve.knots.front();
    result.knots[result.knots.size() - 1 - i] = curve.knots.back();
  }
  result.poles = curve.poles.colwise().reverse();
  return result;
}

EndCurvature curvatureAtEnd(const BezierCurve& curve, double t) {
  const CurveDerivatives d = curve.derivatives(t, 2);
  const Vector2d first = d.row(1).head<2>(), second = d.row(2).head<2>();
  return {.curvature_per_mm = cross(first, second) / std::pow(first.norm(), 3)};
}

/// The integral of k^2 |r'| over [0, 1]: 16 panels with the 3 nodes of Gauss, whose error falls
/// with the sixth power of the panels.
double bendingOf(const BezierCurve& curve) {
  constexpr int panels = 16;
  const double off = std::sqrt(0.6) / 2;
  const std::array<double, 3> nodes = {0.5 - off, 0.5, 0.5 + off};
  const std::array<double, 3> weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double energy = 0;
  for (int panel = 0; panel < panels; ++panel)
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const CurveDerivatives d = curve.derivatives((panel + nodes[i]) / panels, 2);
      const Vector2d first = d.row(1).head<2>(), second = d.row(2).head<2>();
      const double turn = cross(first, second);
      energy += weights[i] / panels * turn * turn / std::pow(first.norm(), 5);
    }
  return energy;
}

/// From one end of a curve to the first pole that is not there: the tangent also where it stops.
Vector2d startLeg(const Poles& poles) {
  for (Eigen::Index i = 1; i < poles.rows(); ++i)
    if (poles.row(i) != poles.row(0)) return (poles.row(i) - poles.row(0)).head<2>();
  return Vector2d::Zero();
}

/// Collects figures of curves and the curvatures at which they begin, turn and end, from corner to
/// corner.
struct Course {
  ChainFigures figures;
  std::vector<std::vector<double>> runs_per_mm = {{}};
  std::optional<Vector2d> first_leg, last_leg;  ///< along the chain

  /// At a corner a new run begins.
  void join(const Vector2d& leg, const Vector2d& end_leg) {
    if (last_leg && isCorner(*last_leg, leg)) runs_per_mm.emplace_back();
    if (!first_leg) first_leg = leg;
    last_leg = end_leg;
  }
  void add(const PlanarArc& arc) {
    join(unitAt(arc.direction_rad),
         unitAt(arc.direction_rad + arc.curvature_per_mm * arc.length_mm));
    figures.length_mm += arc.length_mm;
    figures.energy_per_mm += arc.curvature_per_mm * arc.curvature_per_mm * arc.length_mm;
    take(arc.curvature_per_mm);
  }
  void add(const BezierCurve& curve) {
    const double polygon_mm = polygonLength(curve);
    if (polygon_mm == 0) return;
    join(startLeg(curve.poles()), -startLeg(curve.poles().colwise().reverse()));
    constexpr double relative = 1e-9;
    figures.length_mm += arcLength(curve, relative * polygon_mm).value_mm;
    if (curve.degree() == 1) return take(0);
    const StoppedEnds stops = stoppedEnds(curve);
    const EndCurvature start = stops.start > 0 ? startCurvature(curve) : curvatureAtEnd(curve, 0);
    const EndCurvature end = stops.end > 0 ? endCurvature(curve) : curvatureAtEnd(curve, 1);
    if (start.finite_energy && end.finite_energy)
      figures.energy_per_mm += bendingOf(curve);
    else
      figures.energy_per_mm = infinite;
    take(start.curvature_per_mm);
    for (const CurvatureExtremum& extremum : planarCurvatureProfile(curve).extrema)
      take(extremum.curvature_per_mm);
    take(end.curvature_per_mm);
  }
  /// Whether the ends of a closed chain meet without a corner. Then its last run goes on with the
  /// first one.
  bool isRing(bool closed) {
    if (!closed || !first_leg || isCorner(*last_leg, *first_leg)) return false;
    if (runs_per_mm.size() == 1) return true;
    std::vector<double>& first = runs_per_mm.front();
    first.insert(first.begin(), runs_per_mm.back().begin(), runs_per_mm.back().end());
    runs_per_mm.pop_back();
    return false;
  }

 private:
  static Vector2d unitAt(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }
  static bool isCorner(const Vector2d& before, const Vector2d& after) {
    // As ConicFitOptions and ClothoidFitOptions have it.
    constexpr double corner_rad = 1e-3;
    return std::abs(angleFromTo(before, after)) > corner_rad;
  }
  void take(double curvature_per_mm) { runs_per_mm.back().push_back(curvature_per_mm); }
};

/// The values without those that differ from the last one by no more than is negligible, except
/// where a run of small steps adds up.
std::vector<double> distinct(const std::vector<double>& values, double negligible) {
  std::vector<double> result;
  for (const double value : values)
    if (result.empty() || std::abs(value - result.back()) > negligible) result.push_back(value);
  return result;
}

int changesOfSign(const std::vector<double>& values, bool closed) {
  int changes = 0;
  for (std::size_t i = 1; i < values.size(); ++i) changes += values[i - 1] * values[i] < 0;
  if (closed && values.size() > 1) changes += values.back() * values.front() < 0;
  return changes;
}

}  // namespace

Vector2d startOf(const ChainCurve& curve) {
  if (const auto* spline = std::get_if<BSplineCurve>(&curve)) return pole(*spline, 0);
  if (const auto* arc = std::get_if<PlanarArc>(&curve)) return arc->start;
  return std::get<PlanarConic>(curve).start;
}

Vector2d endOf(const ChainCurve& curve) {
  if (const auto* spline = std::get_if<BSplineCurve>(&curve))
    return pole(*spline, spline->poles.rows() - 1);
  if (const auto* arc = std::get_if<PlanarArc>(&curve)) return arc->end();
  return std::get<PlanarConic>(curve).end;
}

ChainCurve reversed(const ChainCurve& curve) {
  if (const auto* spline = std::get_if<BSplineCurve>(&curve)) return reversedSpline(*spline);
  if (const auto* arc = std::get_if<PlanarArc>(&curve)) return reversed(*arc);
  return reversed(std::get<PlanarConic>(curve));
}

std::vector<BezierCurve> bezierCurves(const ChainCurve& curve) {
  if (const auto* arc = std::get_if<PlanarArc>(&curve)) return bezierCurves(*arc);
  if (const auto* conic = std::get_if<PlanarConic>(&curve)) return {bezierCurve(*conic)};
  const BezierSpline spline = bezierSpline(std::get<BSplineCurve>(curve));
  std::vector<BezierCurve> result;
  for (int i = 0; i < spline.segments(); ++i) {
    BezierCurve one = segment(spline, i);
    // More equal poles than the degree are a span without length.
    if (!isPoint(one)) result.push_back(std::move(one));
  }
  if (result.empty()) result.push_back(segment(spline, 0));
  return result;
}

BezierSpline bezierSpline(const PlanarChain& chain, double gap_mm) {
  std::vector<BezierCurve> segments;
  for (const ChainCurve& curve : chain.curves)
    for (BezierCurve& one : bezierCurves(curve)) segments.push_back(std::move(one));
  return splineOverLengths(segments, chain.closed, gap_mm);
}

ChainFigures figuresOf(const PlanarChain& chain, const Progress& progress) {
  Course course;
  const auto whole = static_cast<double>(chain.curves.size());
  double done = 0;
  for (const ChainCurve& curve : chain.curves) {
    checkProgress(progress, done / whole);
    if (const auto* arc = std::get_if<PlanarArc>(&curve)) {
      course.add(*arc);
    } else {
      const std::vector<BezierCurve> spans = bezierCurves(curve);
      for (std::size_t i = 0; i < spans.size(); ++i) {
        checkProgress(progress,
                      (done + static_cast<double>(i) / static_cast<double>(spans.size())) / whole);
        course.add(spans[i]);
      }
    }
    ++done;
  }
  const bool ring = course.isRing(chain.closed);
  double largest_per_mm = course.figures.length_mm > 0 ? 1 / course.figures.length_mm : 0;
  for (const std::vector<double>& run : course.runs_per_mm)
    for (const double k : run)
      if (std::isfinite(k)) largest_per_mm = std::max(largest_per_mm, std::abs(k));
  for (std::vector<double>& run : course.runs_per_mm) {
    // Of an infinite curvature only its sign and that it is the largest matter.
    for (double& k : run)
      if (std::isinf(k)) k = std::copysign(2 * largest_per_mm, k);
    constexpr double negligible = 1e-9;
    const SequenceTurns turns = turnsOf(run, ring, negligible * largest_per_mm);
    course.figures.extrema += turns.extrema;
    course.figures.inflections += turns.inflections;
  }
  return course.figures;
}

SequenceTurns turnsOf(const std::vector<double>& curvatures_per_mm, bool closed,
                      double negligible_per_mm) {
  SequenceTurns result;
  std::vector<double> values = distinct(curvatures_per_mm, negligible_per_mm);
  if (closed && values.size() > 1 && std::abs(values.back() - values.front()) <= negligible_per_mm)
    values.pop_back();
  std::vector<double> signs;
  std::ranges::copy_if(values, std::back_inserter(signs),
                       [&](double k) { return std::abs(k) > negligible_per_mm; });
  result.inflections = changesOfSign(signs, closed);
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) steps.push_back(values[i] - values[i - 1]);
  if (closed && values.size() > 1) steps.push_back(values.front() - values.back());
  result.extrema = changesOfSign(steps, closed);
  return result;
}

}  // namespace seamwright
