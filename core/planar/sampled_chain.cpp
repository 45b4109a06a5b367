// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/point_corners.hpp>
#include <seamwright/core/planar/point_pieces.hpp>
#include <seamwright/core/planar/sampled_chain.hpp>
#include <seamwright/core/planar/tangent_chain.hpp>
#include <seamwright/core/planar/touch_point.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// Choices. Points of lines and arcs show corners that those of other curves do not: with a corner
/// at a smaller turn there are fewer pieces, or it is none. Pieces between such corners have more
/// points than the chords of an arc, or are lines of three.
constexpr double least_corner_deg = 12, least_steps = 3;
constexpr std::size_t least_of_arc = 4, least_of_line = 3;

/// An upper bound, which is the distance up to rounding for points near the arc.
double distance_mm(const PlanarArc& arc, const Vector2d& point) {
  const double s = touchPointOf(arc).lengthTo_mm(point), k = arc.curvature_per_mm;
  double result = (arc.point(std::clamp(s, 0.0, arc.length_mm)) - point).norm();
  if (k == 0) return result;
  const double once_around = s + 2 * std::numbers::pi / std::abs(k);
  return std::min(result, (arc.point(std::clamp(once_around, 0.0, arc.length_mm)) - point).norm());
}

/// The largest distance of a point from the arcs beside which it lies.
double largestDistance_mm(const PlacedArcs& placed, const std::vector<Vector2d>& points) {
  double largest = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    double nearest = infinite;
    for (std::size_t i = 0; i < placed.arcs.size(); ++i) {
      const double begin = i > 0 ? placed.ends[i - 1].begin : 0, end = placed.ends[i].end;
      const auto at = static_cast<double>(v);
      if (begin <= at && at <= end)
        nearest = std::min(nearest, distance_mm(placed.arcs[i], points[v]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// Whether the chain is as long as arcs between neighbours are. A piece has four of them or more,
/// so those of half a circle are longer than their chords by 3 %.
bool runsFromPointToPoint(const SampledChain& chain, const std::vector<Vector2d>& points) {
  constexpr double longer = 1.1;
  double length_mm = 0, polygon_mm = 0;
  if (chain.closed) polygon_mm = (points.front() - points.back()).norm();
  for (const PlanarArc& arc : chain.arcs) length_mm += arc.length_mm;
  for (std::size_t v = 1; v < points.size(); ++v) polygon_mm += (points[v] - points[v - 1]).norm();
  return length_mm <= longer * polygon_mm;
}

/// Whether each arc begins where the one before ends, up to rounding.
bool joins(const SampledChain& chain) {
  constexpr double roundings = 1024;
  for (std::size_t i = chain.closed ? 0 : 1; i < chain.arcs.size(); ++i) {
    const PlanarArc& before = chain.arcs[i > 0 ? i - 1 : chain.arcs.size() - 1];
    const double size_mm = before.start.norm() + before.length_mm + chain.arcs[i].start.norm();
    if ((before.end() - chain.arcs[i].start).norm() > roundings * machine_epsilon * size_mm)
      return false;
  }
  return true;
}

std::ptrdiff_t linesIn(const SampledChain& chain) {
  return std::ranges::count(chain.arcs, 0, &PlanarArc::curvature_per_mm);
}

/// Whether arcs are as flat as points near a line can be.
bool hasFlatArcs(const SampledChain& chain, double tolerance_mm) {
  return std::ranges::any_of(chain.arcs, [&](const PlanarArc& arc) {
    const double height_mm = std::abs(arc.curvature_per_mm) * arc.length_mm * arc.length_mm / 8;
    return arc.curvature_per_mm != 0 && height_mm <= 2 * tolerance_mm;
  });
}

/// The last point of a run and the first one of the next; the same if the corner is a point. Before
/// the first point of a closed curve the last one is -1.
struct CornerPoints {
  int last = 0, first = 0;
};

/// Corners, ascending.
struct Corners {
  std::vector<CornerPoints> at = {};
  bool is_of_pieces = false;  ///< not of the points alone
};

/// A corner as the points show it.
struct CornerSteps {
  Vector2d last, first;  ///< the points before and after it
  /// The steps before and after it, two of each: one of them can be the closing one.
  std::array<double, 2> before_mm, after_mm;
  bool is_closing = false;  ///< between the last and the first point, up to two steps apart

  /// Whether a crossing can be the corner. Between two points it is one only if the steps of the
  /// points go on around it: where they do not, both points are corners, as those of a chamfer.
  bool allows(const Vector2d& crossing, double within_mm) const {
    constexpr double share = 0.1;
    const double around_mm = (crossing - last).norm() + (crossing - first).norm();
    const auto goesOn = [&](double step_mm) {
      const double off_mm = share * step_mm + 2 * within_mm;
      if (is_closing) return around_mm <= 2 * step_mm + off_mm;
      return std::abs(around_mm - step_mm) <= off_mm;
    };
    return around_mm <= 2 * within_mm ||
           (std::ranges::any_of(before_mm, goesOn) && std::ranges::any_of(after_mm, goesOn));
  }
};

/// The corner between two runs.
CornerSteps stepsBeside(const std::vector<Vector2d>& ended, const std::vector<Vector2d>& begun) {
  CornerSteps result{.last = ended.back(), .first = begun.front(), .before_mm = {}, .after_mm = {}};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t before = ended.size() - 1 - std::min(k, ended.size() - 2),
                      after = std::min(k, begun.size() - 2);
    result.before_mm[k] = (ended[before] - ended[before - 1]).norm();
    result.after_mm[k] = (begun[after + 1] - begun[after]).norm();
  }
  return result;
}

/// Lets an arc end, and the next one begin, where both cross near a corner. Returns whether they
/// do.
bool meetNear(PlanarArc& before, PlanarArc& after, const CornerSteps& steps, double within_mm) {
  const TouchPoint end = touchPointOf(before).after(before.length_mm), start = touchPointOf(after);
  const auto crossing = crossingNear(end, start, (steps.last + steps.first) / 2);
  if (!crossing || !steps.allows(*crossing, within_mm)) return false;
  before.length_mm += end.lengthTo_mm(*crossing);
  const double ahead_mm = start.lengthTo_mm(*crossing);
  after = start.after(ahead_mm).arc(after.length_mm - ahead_mm);
  return before.length_mm > 0 && after.length_mm > 0;
}

/// What is asked for, and with which noise.
struct ChainTask {
  bool closed = false;
  double tolerance_mm = 0, noise_mm = 0, line_mm = 0;
  int fewer_than = 0;

  TangentChainOptions options(int count) const {
    return {.noise_mm = noise_mm, .line_mm = line_mm, .fewer_than = fewer_than - count};
  }
};

/// Without corners.
std::optional<SampledChain> smoothChain(const std::vector<Vector2d>& points,
                                        const ChainTask& task) {
  const auto placed = tangentChain({.vertices = points, .closed = task.closed}, task.options(0));
  if (!placed) return std::nullopt;
  SampledChain chain{.arcs = placed->arcs,
                     .corners = {},
                     .closed = task.closed,
                     .distance_mm = largestDistance_mm(*placed, points)};
  const bool is_divided = chain.arcs.front().curvature_per_mm == chain.arcs.back().curvature_per_mm;
  if (!task.closed || !is_divided || chain.arcs.size() == 1) return chain;
  // The arc beside the first point is divided there.
  const double tail_mm = chain.arcs.front().length_mm;
  chain.arcs.front() = chain.arcs.back();
  chain.arcs.front().length_mm += tail_mm;
  chain.arcs.pop_back();
  return chain;
}

std::vector<std::vector<Vector2d>> runsOf(const std::vector<Vector2d>& points,
                                          const std::vector<CornerPoints>& corners, bool closed) {
  const int n = static_cast<int>(points.size());
  std::vector<CornerPoints> cuts = corners;
  if (closed) {
    cuts.push_back({.last = corners.front().last + n, .first = 0});
  } else {
    cuts.insert(cuts.begin(), CornerPoints{});
    cuts.push_back({.last = n - 1, .first = 0});
  }
  std::vector<std::vector<Vector2d>> runs;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    runs.emplace_back();
    for (int i = cuts[k - 1].first; i <= cuts[k].last; ++i)
      runs.back().push_back(points[static_cast<std::size_t>(i % n)]);
  }
  return runs;
}

/// From corner to corner.
std::optional<SampledChain> chainWithCorners(const std::vector<Vector2d>& points,
                                             const Corners& corners, const ChainTask& task) {
  SampledChain chain{.arcs = {}, .corners = {}, .closed = task.closed};
  const auto n = static_cast<int>(points.size());
  const std::vector<std::vector<Vector2d>> runs = runsOf(points, corners.at, task.closed);
  std::vector<PlacedArcs> placed;
  int count = 0;
  for (const std::vector<Vector2d>& run : runs) {
    if (corners.is_of_pieces && run.size() < least_of_line) return std::nullopt;
    auto arcs = tangentChain({.vertices = run}, task.options(count));
    if (!arcs) return std::nullopt;
    if (corners.is_of_pieces && run.size() < least_of_arc &&
        arcs->arcs.front().curvature_per_mm != 0)
      return std::nullopt;
    count += static_cast<int>(arcs->arcs.size());
    placed.push_back(*std::move(arcs));
  }
  for (std::size_t r = task.closed ? 0 : 1; r < runs.size(); ++r) {
    const std::size_t before = r > 0 ? r - 1 : runs.size() - 1;
    CornerSteps steps = stepsBeside(runs[before], runs[r]);
    steps.is_closing = corners.at[task.closed ? r : r - 1].first % n == 0;
    // The corner of the points is off by the noise itself.
    if (!meetNear(placed[before].arcs.back(), placed[r].arcs.front(), steps,
                  task.tolerance_mm + task.noise_mm))
      return std::nullopt;
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    chain.distance_mm = std::max(chain.distance_mm, largestDistance_mm(placed[r], runs[r]));
    if (r > 0 || task.closed) chain.corners.push_back(static_cast<int>(chain.arcs.size()));
    chain.arcs.insert(chain.arcs.end(), placed[r].arcs.begin(), placed[r].arcs.end());
  }
  return chain;
}

/// Where the lines and circles of neighbouring pieces cross at an angle.
std::vector<CornerPoints> cornersBetweenPieces(const std::vector<Vector2d>& points,
                                               const ChainTask& task) {
  const std::vector<PointPiece> pieces = pointPieces(points, {.closed = task.closed,
                                                              .noise_mm = task.noise_mm,
                                                              .line_mm = task.line_mm,
                                                              .fewer_than = task.fewer_than});
  const int n = static_cast<int>(points.size());
  const auto at = [&](int i) { return points[static_cast<std::size_t>((i + n) % n)]; };
  std::vector<CornerPoints> corners;
  for (std::size_t i = task.closed ? 0 : 1; i < pieces.size(); ++i) {
    const TouchPoint& before = pieces[i > 0 ? i - 1 : pieces.size() - 1].circle;
    const TouchPoint& after = pieces[i].circle;
    CornerPoints corner{.last = pieces[i].first - 1, .first = pieces[i].first};
    const Vector2d last = at(corner.last), first = at(corner.first);
    const auto crossing = crossingNear(before, after, (last + first) / 2);
    if (!crossing) continue;
    const double turn_rad = std::abs(
        wrapped(after.beside(*crossing).direction_rad - before.beside(*crossing).direction_rad));
    const double of_step_rad = (first - last).norm() * std::max(std::abs(before.curvature_per_mm),
                                                                std::abs(after.curvature_per_mm));
    if (turn_rad < std::max(least_corner_deg * radians_per_degree, least_steps * of_step_rad))
      continue;
    // Points on both sides.
    if ((*crossing - first).norm() <= task.noise_mm)
      corner.last = corner.first;
    else if ((*crossing - last).norm() <= task.noise_mm)
      corner.first = corner.last;
    const int turns = corner.first < 0 ? n : corner.first >= n ? -n : 0;
    corners.push_back({.last = corner.last + turns, .first = corner.first + turns});
  }
  std::ranges::sort(corners, {}, &CornerPoints::first);
  return corners;
}

/// The given corners, which are points, and those between pieces from one to the next.
Corners withThoseBetween(const std::vector<Vector2d>& points, const Corners& given,
                         const ChainTask& task) {
  Corners all{.at = given.at, .is_of_pieces = true};
  ChainTask open = task;
  open.closed = false;
  const int n = static_cast<int>(points.size());
  int begin = task.closed ? given.at.front().first : 0;
  for (const std::vector<Vector2d>& run : runsOf(points, given.at, task.closed)) {
    for (const CornerPoints& corner : cornersBetweenPieces(run, open)) {
      const int turns = begin + corner.first < n ? 0 : n;
      all.at.push_back(
          {.last = begin + corner.last - turns, .first = begin + corner.first - turns});
    }
    begin += static_cast<int>(run.size()) - 1;
  }
  std::ranges::sort(all.at, {}, &CornerPoints::first);
  return all;
}

/// Whether of two runs one has the points that an arc needs. Few points of a smooth curve turn at
/// each of them.
bool areShown(const Corners& corners, const std::vector<Vector2d>& points, bool closed) {
  const auto runs = runsOf(points, corners.at, closed);
  for (std::size_t k = closed ? 0 : 1; k < runs.size(); ++k)
    if (std::max(runs[k].size(), runs[k > 0 ? k - 1 : runs.size() - 1].size()) < least_of_arc)
      return false;
  return true;
}

/// The chains with the corners of the points, with those between pieces as well, and with these
/// alone: where no point is near a corner, the one next to it can turn as a corner does.
std::vector<SampledChain> chainsOf(const std::vector<Vector2d>& points,
                                   const std::array<Corners, 2>& of_points, const ChainTask& task) {
  std::vector<SampledChain> result;
  const auto add = [&](std::optional<SampledChain> chain) {
    if (chain) result.push_back(*std::move(chain));
  };
  const auto& [sharp, all] = of_points;
  if (sharp.at.empty()) {
    add(smoothChain(points, task));
  } else {
    add(chainWithCorners(points, sharp, task));
    const Corners with_others = withThoseBetween(points, sharp, task);
    if (with_others.at.size() > sharp.at.size()) add(chainWithCorners(points, with_others, task));
  }
  if (all.at.size() > sharp.at.size() && areShown(all, points, task.closed))
    add(chainWithCorners(points, all, task));
  const Corners between{.at = cornersBetweenPieces(points, task), .is_of_pieces = true};
  if (!between.at.empty()) add(chainWithCorners(points, between, task));
  return result;
}

/// Those that turn by 60 degrees or more, and those of any corner.
std::array<Corners, 2> cornersOf(const PlanarPoints& points, const ChainTask& task) {
  std::array<Corners, 2> result;
  PointCornerOptions options{.closed = task.closed, .error_mm = task.noise_mm};
  for (Corners& corners : result) {
    for (const Eigen::Index at : pointCorners(points, options))
      corners.at.push_back({.last = static_cast<int>(at), .first = static_cast<int>(at)});
    options.corner_rad = least_corner_deg * radians_per_degree;
  }
  return result;
}

}  // namespace

std::optional<SampledChain> sampledChain(const PlanarPoints& points,
                                         const SampledChainOptions& options) {
  std::vector<Vector2d> all;
  for (const auto& point : points.rowwise()) all.emplace_back(point.transpose());
  std::optional<SampledChain> best;
  constexpr Eigen::Index least_points = 3;
  if (points.rows() < least_points) return best;
  int fewer_than = std::min(options.most_arcs + 1, static_cast<int>(all.size()));
  for (const double share : noise_shares) {
    ChainTask task{.closed = options.closed,
                   .tolerance_mm = options.tolerance_mm,
                   .noise_mm = share * options.tolerance_mm};
    const std::array<Corners, 2> corners = cornersOf(points, task);
    // Lines rather than flat arcs, if there is a chain of them.
    for (const double line_mm : {options.tolerance_mm, task.noise_mm}) {
      task.line_mm = line_mm;
      task.fewer_than = fewer_than;
      for (SampledChain& chain : chainsOf(all, corners, task)) {
        const auto count = static_cast<int>(chain.arcs.size());
        if (!(chain.distance_mm <= options.tolerance_mm) || count >= fewer_than) continue;
        if (best && best->arcs.size() == chain.arcs.size() && linesIn(*best) >= linesIn(chain))
          continue;
        if (!joins(chain) || !runsFromPointToPoint(chain, all)) continue;
        best = std::move(chain);
        // With more noise flat arcs can be lines.
        fewer_than = hasFlatArcs(*best, options.tolerance_mm) ? count + 1 : count;
      }
    }
  }
  return best;
}

}  // namespace seamwright
