// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic_distance.hpp>
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/conic_spline.hpp>
#include <seamwright/core/planar/fit_options.hpp>
#include <seamwright/core/planar/planar_curve.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// A point of the curve through which the conics pass.
struct ConicPoint {
  double u = 0;
  Vector2d point = Vector2d::Zero();
  bool line_after = false;  ///< up to the next point
};

/// A curve with what conics have to know of its segments and joints.
struct ConicFitCurve {
  PlanarCurve curve;
  std::vector<double> turns_rad;  ///< before segment i
  std::vector<bool> lines;        ///< segments to be kept as lines
};

bool isStraight(const BezierCurve& segment) {
  const Poles poles = segment.poles();
  const Vector2d start = poles.row(0).head<2>(),
                 chord = poles.row(poles.rows() - 1).head<2>().transpose() - start;
  // Poles have roundings of their coordinates.
  const double noise_mm = 16 * machine_epsilon * poles.leftCols<2>().cwiseAbs().maxCoeff();
  for (Eigen::Index i = 1; i + 1 < poles.rows(); ++i) {
    const Vector2d from = poles.row(i).head<2>().transpose() - start;
    if (std::abs(cross(chord.normalized(), from)) > noise_mm) return false;
  }
  return true;
}

ConicFitCurve conicFitCurve(const BezierSpline& spline, double corner_rad) {
  ConicFitCurve result{.curve = planarCurve(spline), .turns_rad = {}, .lines = {}};
  const PlanarCurve& curve = result.curve;
  const int n = curve.count();
  for (int i = 0; i < n; ++i) {
    const bool first = i == 0 && !spline.closed;
    result.turns_rad.push_back(
        first ? 0 : wrapped(curve.direction_rad(i, 0) - curve.direction_rad((i + n - 1) % n, 1)));
  }
  // The sides of a polygon that samples a curve are no lines to be kept: it turns at their ends.
  constexpr double smooth_rad = 1e-6;
  const auto keeps = [&](int joint) {
    const double turn_rad = std::abs(result.turns_rad[joint % n]);
    return turn_rad <= smooth_rad || turn_rad > corner_rad;
  };
  for (int i = 0; i < n; ++i)
    result.lines.push_back(isStraight(curve.segments[i]) && keeps(i) && keeps(i + 1));
  return result;
}

/// Lets a closed curve begin with another segment.
void beginAt(ConicFitCurve& of, int segment) {
  const auto turn = [&](auto& values) {
    std::rotate(values.begin(), values.begin() + segment, values.end());
  };
  turn(of.curve.segments), turn(of.curve.polynomials), turn(of.curve.origins);
  turn(of.turns_rad), turn(of.lines);
}

/// A part of the curve between corners.
struct ConicRun {
  int begin = 0, end = 0;  ///< segments
  bool closed = false;
};

/// Two points divide each line: so three neighbours are on it, and conicSpline() keeps it.
void appendLine(const PlanarCurve& curve, int begin, int end, std::vector<ConicPoint>& points) {
  const Vector2d start = curve.point(begin);
  const Vector2d chord = curve.segments[end - 1].point(1).head<2>().transpose() - start.transpose();
  for (const double share : {0.0, 1.0 / 3, 2.0 / 3})
    points.push_back(
        {.u = begin + share * (end - begin), .point = start + share * chord, .line_after = true});
}

/// The ends of lines, and parts of the rest.
std::vector<ConicPoint> firstPoints(const ConicFitCurve& of, const ConicRun& run) {
  const PlanarCurve& curve = of.curve;
  std::vector<ConicPoint> points;
  for (int i = run.begin; i < run.end;) {
    int end = i + 1;
    while (end < run.end && of.lines[end] == of.lines[i]) ++end;
    if (of.lines[i]) {
      appendLine(curve, i, end, points);
    } else {
      // Four pieces of a closed run turn by a right angle each.
      const int parts = run.closed && end - i == run.end - run.begin ? 4 : 1;
      for (int k = 0; k < parts; ++k) {
        const double u = i + static_cast<double>(k) * (end - i) / parts;
        points.push_back({.u = u, .point = curve.point(u)});
      }
    }
    i = end;
  }
  const Vector2d last =
      run.closed ? points.front().point : Vector2d(curve.segments[run.end - 1].point(1).head<2>());
  points.push_back({.u = static_cast<double>(run.end), .point = last});
  return points;
}

/// The conics from one point to the next one.
struct ConicSpan {
  std::vector<PlanarConic> conics;
  std::vector<bool> g1;  ///< whether they begin at a joint that is not G2
};

std::optional<std::vector<ConicSpan>> spansThrough(const std::vector<ConicPoint>& points,
                                                   bool closed, const Progress& progress) {
  const auto count = static_cast<Eigen::Index>(points.size()) - (closed ? 1 : 0);
  PlanarPoints rows(count, 2);
  for (Eigen::Index i = 0; i < count; ++i)
    rows.row(i) = points[static_cast<std::size_t>(i)].point.transpose();
  for (Eigen::Index i = 1; i < count; ++i)
    if (rows.row(i) == rows.row(i - 1)) return std::nullopt;
  ConicSpline spline;
  try {
    spline = conicSpline(rows, closed, progress);
  } catch (const std::domain_error&) {  // points are too far apart for the turn between them
    return std::nullopt;
  }
  const auto has = [](const std::vector<int>& joints, int i) {
    return std::ranges::find(joints, i) != joints.end();
  };
  std::vector<ConicSpan> spans(1);
  for (int i = 0; i < static_cast<int>(spline.conics.size()); ++i) {
    const PlanarConic& conic = spline.conics[static_cast<std::size_t>(i)];
    spans.back().conics.push_back(conic);
    spans.back().g1.push_back(has(spline.g1_joints, i) || has(spline.corners, i));
    if (conic.end == points[spans.size()].point && spans.size() + 1 < points.size())
      spans.emplace_back();
  }
  return spans.size() + 1 == points.size() ? std::optional(spans) : std::nullopt;
}

std::vector<CurvePiece> piecesBetween(const PlanarCurve& curve, double u0, double u1) {
  std::vector<CurvePiece> pieces;
  for (int i = static_cast<int>(u0); i < curve.count() && i < u1; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Interval domain = {std::max(u0 - i, 0.0), std::min(u1 - i, 1.0)};
    if (domain.width() > 0)
      pieces.push_back(
          {.polynomials = curve.polynomials[k], .origin = curve.origins[k], .domain = domain});
  }
  return pieces;
}

/// Appends the conics of a run. The spans of a line become one line.
void appendSpans(const std::vector<ConicPoint>& points, const std::vector<ConicSpan>& spans,
                 ConicFit& result) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const bool longer =
        i > 0 && points[i].line_after && points[i - 1].line_after && !spans[i].g1.front();
    if (longer) {
      PlanarConic& line = result.conics.back();
      line.end = spans[i].conics.back().end;
      line.corner = (line.start + line.end) / 2;
      continue;
    }
    for (std::size_t k = 0; k < spans[i].conics.size(); ++k) {
      if (spans[i].g1[k]) result.g1_joints.push_back(static_cast<int>(result.conics.size()));
      result.conics.push_back(spans[i].conics[k]);
    }
  }
}

/// Halves what is further than the tolerance until nothing is.
void fitConicRun(const ConicFitCurve& of, const ConicRun& run, double tolerance_mm,
                 const Progress& progress, ConicFit& result) {
  std::vector<ConicPoint> points = firstPoints(of, run);
  // Where a segment needs shorter pieces, the curve turns back or has a cusp.
  constexpr double shortest = 0x1p-12;
  for (int round = 0;; ++round) {
    const Progress of_round = partOf(progress, shareAfter(round), shareAfter(round));
    const auto spans = spansThrough(points, run.closed, of_round);
    double largest_mm = 0;
    std::vector<ConicPoint> finer;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      checkProgress(of_round, 0);
      const ConicPoint &from = points[i], &to = points[i + 1];
      finer.push_back(from);
      std::optional<double> distance_mm;
      if (spans)
        distance_mm = distanceFromConics(piecesBetween(of.curve, from.u, to.u), (*spans)[i].conics,
                                         tolerance_mm);
      if (distance_mm) {
        largest_mm = std::max(largest_mm, *distance_mm);
        continue;
      }
      if (from.line_after && !spans) continue;
      if (to.u - from.u < shortest)
        throw std::domain_error(fmt::format(
            "no conics keep the tolerance {} mm at the parameter {} (segments count by 1): the "
            "curve turns back there, or the tolerance is below its rounding",
            tolerance_mm, from.u));
      const double middle = (from.u + to.u) / 2;
      finer.push_back({.u = middle, .point = of.curve.point(middle)});
    }
    finer.push_back(points.back());
    if (finer.size() == points.size()) {
      if (!spans)
        throw std::domain_error(
            fmt::format("no conics pass through the lines from the parameter "
                        "{} to {} (segments count by 1)",
                        run.begin, run.end));
      appendSpans(points, *spans, result);
      result.distance_mm = std::max(result.distance_mm, largest_mm);
      return;
    }
    points = std::move(finer);
  }
}

}  // namespace

ConicFit fitConics(const BezierSpline& spline, const ConicFitOptions& options,
                   const Progress& progress) {
  requireValid(spline);
  requireFitOptions(options.tolerance_mm, options.corner_rad);
  ConicFitCurve of = conicFitCurve(spline, options.corner_rad);
  const int n = of.curve.count();
  const auto isCorner = [&](int joint) {
    return std::abs(of.turns_rad[joint]) > options.corner_rad;
  };
  if (spline.closed)
    for (int joint = 0; joint < n; ++joint) {
      if (!isCorner(joint)) continue;
      beginAt(of, joint);
      break;
    }
  std::vector<int> cuts = {0};
  for (int joint = 1; joint < n; ++joint)
    if (isCorner(joint)) cuts.push_back(joint);
  cuts.push_back(n);
  const bool smooth = cuts.size() == 2 && spline.closed && !isCorner(0);
  ConicFit result = {.conics = {}, .corners = {}, .g1_joints = {}, .closed = spline.closed};
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (i > 1 || (spline.closed && isCorner(0)))
      result.corners.push_back(static_cast<int>(result.conics.size()));
    const double whole = n;
    fitConicRun(of, {.begin = cuts[i - 1], .end = cuts[i], .closed = smooth}, options.tolerance_mm,
                partOf(progress, cuts[i - 1] / whole, cuts[i] / whole), result);
  }
  return result;
}

}  // namespace seamwright
