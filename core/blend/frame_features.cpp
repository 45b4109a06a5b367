// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <stdexcept>

#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/blend/frame_features.hpp>
#include <seamwright/core/blend/frame_samples.hpp>
#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::match {

namespace {

/// What it costs to leave a feature alone, in units of the reach. Two other features at the limit
/// of the reach cost as much as to leave both; corners are matched in preference to jumps of the
/// curvature, and these to extrema.
double aloneCost(const Feature& feature) {
  switch (feature.kind) {
    case FeatureKind::Corner:
      return 2;
    case FeatureKind::Rise:
    case FeatureKind::Fall:
      return 1;
    case FeatureKind::Maximum:
    case FeatureKind::Minimum:
      break;
  }
  return 0.5;
}

/// The corner where piece i begins.
Feature cornerAt(const Measured& frame, const FrameExtent& extent, int i) {
  Feature result{FeatureKind::Corner, {i, 0}, frame.share(i)};
  result.from_middle = (frame.point(result.place) - extent.middle) / extent.radius_mm;
  const int before = i > 0 ? i - 1 : frame.spline().segments() - 1;
  const Eigen::Vector3d arriving = segment(frame.spline(), before).derivatives(1, 1).row(1),
                        leaving = segment(frame.spline(), i).derivatives(0, 1).row(1);
  result.turn = arriving.stableNormalized().cross(leaving.stableNormalized());
  if (!extent.round) return result;
  const double turn = arriving.cross(leaving).dot(*extent.round);
  result.side = turn > 0 ? 1 : turn < 0 ? -1 : 0;
  return result;
}

void addCorners(const Measured& frame, double corner_rad, Features& result) {
  const std::vector<CurveJoint> joints = measureJoints(frame.spline(), 1);
  const auto isCorner = [&](const CurveJoint& joint) {
    return joint.angle_rad && *joint.angle_rad > corner_rad;
  };
  if (std::none_of(joints.begin(), joints.end(), isCorner)) return;
  const FrameExtent extent = extentOf(frame);
  for (int i = 1; i < frame.spline().segments(); ++i)
    if (isCorner(joints[static_cast<std::size_t>(i) - 1]))
      result.all.push_back(cornerAt(frame, extent, i));
  if (frame.spline().closed && isCorner(joints.back())) result.closing = cornerAt(frame, extent, 0);
}

/// The curvature at a place of a run between corners.
struct CurvaturePoint {
  Place place;
  double share = 0;
  double curvature_per_mm = 0;
};

double curvatureAt(const BezierCurve& curve, double t, bool planar) {
  const CurveDerivatives d = curve.derivatives(t, 2);
  const Eigen::Vector3d first = d.row(1), second = d.row(2), normal = first.cross(second);
  const double speed = first.norm();
  return (planar ? normal.z() : normal.norm()) / (speed * speed * speed);
}

/// The curvature at both ends of piece i and at its extrema. \throws std::domain_error for a piece
/// that may stop: the curvature may be infinite there.
std::vector<CurvaturePoint> pointsOf(const Measured& frame, int i, bool planar) {
  const BezierCurve curve = segment(frame.spline(), i);
  if (stoppedEnds(curve).any()) throw std::domain_error("the curve stops at an end");
  const CurvatureProfile profile =
      planar ? planarCurvatureProfile(curve) : spaceCurvatureProfile(curve);
  std::vector<CurvaturePoint> points = {{{i, 0}, frame.share(i), curvatureAt(curve, 0, planar)}};
  for (const CurvatureExtremum& extremum : profile.extrema) {
    const Place place{i, extremum.parameters.middle()};
    points.push_back({place, frame.shareAt(place), extremum.curvature_per_mm});
  }
  points.push_back({{i + 1, 0}, frame.share(i + 1), curvatureAt(curve, 1, planar)});
  return points;
}

using Run = std::vector<CurvaturePoint>;

/// The ends of a run and its local extrema, as indices.
std::vector<std::size_t> turningPoints(const Run& run) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const std::size_t n = result.size();
    const auto curvature = [&](std::size_t k) { return run[result[k]].curvature_per_mm; };
    const double rise = n > 0 ? run[i].curvature_per_mm - curvature(n - 1) : 1;
    if (rise == 0) continue;
    const bool goes_on = n > 1 && (curvature(n - 1) > curvature(n - 2)) == (rise > 0);
    if (goes_on) result.pop_back();
    result.push_back(i);
  }
  return result;
}

/// Leaves out extrema that differ from a neighbour by less than that, the least prominent first.
void dropFaint(const Run& run, std::vector<std::size_t>& turns, double prominence_per_mm) {
  while (turns.size() > 2) {
    std::size_t at = 1;
    double least = infinite;
    for (std::size_t k = 1; k < turns.size(); ++k)
      if (const double step =
              std::abs(run[turns[k]].curvature_per_mm - run[turns[k - 1]].curvature_per_mm);
          step < least) {
        least = step;
        at = k;
      }
    if (!(least < prominence_per_mm)) return;
    // The ends stay; beside an end only the extremum goes.
    const std::size_t first = at > 1 ? at - 1 : at;
    const std::size_t last = at + 1 < turns.size() ? at : at - 1;
    if (first > last) return;
    turns.erase(turns.begin() + static_cast<std::ptrdiff_t>(first),
                turns.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
}

/// The curvature along the runs between corners. Pieces of unknown curvature have none.
std::vector<Run> runsOf(const Measured& frame, bool planar, const std::vector<Feature>& corners,
                        int& unknown_pieces) {
  std::vector<Run> runs(1);
  for (int i = 0; i < frame.spline().segments(); ++i) {
    const bool corner = std::any_of(corners.begin(), corners.end(), [&](const Feature& feature) {
      return feature.place.piece == i;
    });
    if (corner) runs.emplace_back();
    try {
      for (const CurvaturePoint& point : pointsOf(frame, i, planar)) runs.back().push_back(point);
    } catch (const std::domain_error&) {
      // The curve may stop in this piece, so it has no curvature there.
      ++unknown_pieces;
    }
  }
  return runs;
}

/// The extremum, in the middle of the points between its neighbours that are as high or low.
/// Nothing if these reach from jump to jump, which say where they are.
std::optional<Feature> extremumAt(const Measured& frame, const Run& run,
                                  const std::vector<std::size_t>& turns, std::size_t k,
                                  double flat_per_mm) {
  const CurvaturePoint& top = run[turns[k]];
  const bool maximum = top.curvature_per_mm > run[turns[k - 1]].curvature_per_mm;
  Feature result{maximum ? FeatureKind::Maximum : FeatureKind::Minimum, top.place, top.share};
  std::size_t first = turns[k], last = turns[k];
  for (std::size_t i = turns[k - 1] + 1; i < turns[k + 1]; ++i)
    if (std::abs(run[i].curvature_per_mm - top.curvature_per_mm) <= flat_per_mm) {
      first = std::min(first, i);
      last = std::max(last, i);
    }
  const double from = run[first].share, to = run[last].share;
  if (run[first - 1].share == from && run[last + 1].share == to) return std::nullopt;
  if (from < to) {
    result.share = 0.5 * (from + to);
    result.place = frame.placeAt(result.share);
  }
  return result;
}

/// What the curvature does from one point to the next, if it jumps.
std::optional<FeatureKind> jumpBetween(const CurvaturePoint& before, const CurvaturePoint& after,
                                       double least_per_mm) {
  const double rise = after.curvature_per_mm - before.curvature_per_mm;
  if (!(least_per_mm > 0) || !(std::abs(rise) >= least_per_mm)) return std::nullopt;
  return rise > 0 ? FeatureKind::Rise : FeatureKind::Fall;
}

/// Joints between corners at which the curvature jumps by as much as extrema stand out.
void addJumps(const Measured& frame, const std::vector<Run>& runs, double least_per_mm,
              Features& result) {
  for (const Run& run : runs)
    for (std::size_t i = 1; i < run.size(); ++i) {
      const Place &before = run[i - 1].place, &after = run[i].place;
      if (before.piece != after.piece || before.t != 0 || after.t != 0) continue;
      if (const auto jump = jumpBetween(run[i - 1], run[i], least_per_mm))
        result.all.push_back({*jump, after, run[i].share});
    }
  if (!frame.spline().closed || result.closing || runs.front().empty() || runs.back().empty())
    return;
  const CurvaturePoint &end = runs.back().back(), &start = runs.front().front();
  if (end.place.piece == frame.spline().segments() && start.place.piece == 0)
    if (const auto jump = jumpBetween(end, start, least_per_mm))
      result.closing = Feature{*jump, {0, 0}, 0};
}

/// Entry j: the least cost of the features of a from i on and those of b from j on.
using CostRow = std::vector<double>;

class CostRows {
 public:
  CostRows(const std::vector<Feature>& a, const std::vector<Feature>& b, double reach)
      : a_(a), b_(b), reach_(reach) {}

  /// Without features of a.
  CostRow last() const {
    CostRow row(b_.size() + 1, 0);
    for (std::size_t j = b_.size(); j-- > 0;) row[j] = aloneCost(b_[j]) + row[j + 1];
    return row;
  }

  /// Row i from the row after it.
  CostRow before(const CostRow& next, int i) const {
    CostRow row(next.size());
    row.back() = aloneCost(a_[i]) + next.back();
    for (std::size_t j = b_.size(); j-- > 0;)
      row[j] = std::min({aloneCost(a_[i]) + next[j], aloneCost(b_[j]) + row[j + 1],
                         pairCost(a_[i], b_[j], reach_) + next[j + 1]});
    return row;
  }

 private:
  const std::vector<Feature>&a_, &b_;
  double reach_;
};

bool isCorner(const Feature& feature) {
  return feature.kind == FeatureKind::Corner;
}

std::vector<Feature> picked(const std::vector<Feature>& features, const std::vector<int>& indices) {
  std::vector<Feature> result;
  for (const int i : indices) result.push_back(features[i]);
  return result;
}

/// A range of the length.
struct ShareRange {
  double from = 0, to = 1;
};

/// Features first to last - 1 of a range of the length, moved to another range.
std::vector<Feature> movedTo(const ShareRange& target, const std::vector<Feature>& features,
                             int first, int last, const ShareRange& range) {
  std::vector<Feature> result(features.begin() + first, features.begin() + last);
  for (Feature& feature : result)
    feature.share = target.from + (feature.share - range.from) / (range.to - range.from) *
                                      (target.to - target.from);
  return result;
}

using FeaturePairs = std::vector<std::pair<int, int>>;

/// The pairs of features that lie in one range of both frames. \param tests what corresponds in
/// order, if it is alike; between that what the rest of the tests says.
FeaturePairs pairsIn(const ShareRange& range, const std::vector<Feature>& a,
                     const std::vector<Feature>& b, double reach,
                     std::span<bool (*const)(const Feature&)> tests) {
  if (tests.empty()) return matchedFeatures(a, b, reach);
  std::vector<int> of_a, of_b;
  for (int i = 0; i < std::ssize(a); ++i)
    if (tests.front()(a[i])) of_a.push_back(i);
  for (int i = 0; i < std::ssize(b); ++i)
    if (tests.front()(b[i])) of_b.push_back(i);
  if (!areAlike(picked(a, of_a), picked(b, of_b))) return matchedFeatures(a, b, reach);
  FeaturePairs result;
  int first_a = 0, first_b = 0;
  ShareRange range_a{range.from, range.to}, range_b = range_a, common = range_a;
  for (std::size_t k = 0; k <= of_a.size(); ++k) {
    const bool end = k == of_a.size();
    const int last_a = end ? static_cast<int>(a.size()) : of_a[k],
              last_b = end ? static_cast<int>(b.size()) : of_b[k];
    range_a.to = end ? range.to : a[last_a].share;
    range_b.to = end ? range.to : b[last_b].share;
    common.to = 0.5 * (range_a.to + range_b.to);
    for (const auto& [i, j] :
         pairsIn(common, movedTo(common, a, first_a, last_a, range_a),
                 movedTo(common, b, first_b, last_b, range_b), reach, tests.subspan(1)))
      result.emplace_back(first_a + i, first_b + j);
    if (!end) result.emplace_back(last_a, last_b);
    first_a = last_a + 1;
    first_b = last_b + 1;
    range_a.from = range_a.to;
    range_b.from = range_b.to;
    common.from = common.to;
  }
  return result;
}

}  // namespace

bool isSharp(const Feature& feature) {
  return feature.kind == FeatureKind::Corner || feature.kind == FeatureKind::Rise ||
         feature.kind == FeatureKind::Fall;
}

std::vector<Feature> sharpFeatures(const Features& features) {
  std::vector<Feature> result;
  if (features.closing) result.push_back(*features.closing);
  std::ranges::copy_if(features.all, std::back_inserter(result), isSharp);
  return result;
}

bool areAlike(const Feature& a, const Feature& b) {
  if (a.kind != b.kind) return false;
  if (a.kind != FeatureKind::Corner) return true;
  return a.side == 0 && b.side == 0 ? a.turn.dot(b.turn) > 0 : a.side == b.side;
}

bool areAlike(const std::vector<Feature>& a, const std::vector<Feature>& b) {
  return std::ranges::equal(
      a, b, [](const Feature& one, const Feature& other) { return areAlike(one, other); });
}

double pairCost(const Feature& a, const Feature& b, double reach) {
  const double moved = std::abs(a.share - b.share);
  if (a.kind != b.kind || !(moved <= reach)) return infinite;
  if (a.kind != FeatureKind::Corner) return moved == 0 ? 0 : moved / reach;
  // Two corners that turn alike cost less than to leave both alone, however far a frame is turned;
  // two that do not, only if they are nearer than the radius.
  constexpr double farthest = 1.5;
  const double apart = std::min((a.from_middle - b.from_middle).norm(), farthest);
  return aloneCost(a) * (moved + apart + (a.side * b.side < 0 ? 1 : 0));
}

double matchingCost(const std::vector<Feature>& a, const std::vector<Feature>& b, double reach) {
  const CostRows rows(a, b, reach);
  CostRow row = rows.last();
  for (auto i = static_cast<int>(a.size()) - 1; i >= 0; --i) row = rows.before(row, i);
  return row.front();
}

Features featuresOf(const Measured& frame, bool planar, const FeatureOptions& options) {
  Features result;
  addCorners(frame, options.corner_rad, result);
  const std::vector<Run> runs = runsOf(frame, planar, result.all, result.unknown_pieces);
  double least = infinite, most = -infinite;
  for (const Run& run : runs)
    for (const CurvaturePoint& point : run) {
      least = std::min(least, point.curvature_per_mm);
      most = std::max(most, point.curvature_per_mm);
    }
  const double prominence_per_mm = options.prominence * (most - least);
  addJumps(frame, runs, prominence_per_mm, result);
  // Above what a spline through points of an arc waves, below what moves the vertex of a nose.
  constexpr double flat = 0.25;
  for (const Run& run : runs) {
    std::vector<std::size_t> turns = turningPoints(run);
    dropFaint(run, turns, prominence_per_mm);
    for (std::size_t k = 1; k + 1 < turns.size(); ++k)
      if (const auto extremum = extremumAt(frame, run, turns, k, flat * prominence_per_mm))
        result.all.push_back(*extremum);
  }
  std::stable_sort(result.all.begin(), result.all.end(),
                   [](const Feature& a, const Feature& b) { return a.share < b.share; });
  return result;
}

std::vector<std::pair<int, int>> matchedFeatures(const std::vector<Feature>& a,
                                                 const std::vector<Feature>& b, double reach) {
  const CostRows rows(a, b, reach);
  const auto m = static_cast<int>(a.size()), n = static_cast<int>(b.size());
  // All rows would take m n numbers: every stride-th is kept, and those between are computed again.
  const int stride = static_cast<int>(std::sqrt(m)) + 1;
  std::vector<CostRow> kept(m / stride + 1);
  CostRow row = rows.last();
  for (int i = m; i >= 0; --i) {
    if (i < m) row = rows.before(row, i);
    if (i % stride == 0) kept[i / stride] = row;
  }
  std::vector<std::pair<int, int>> pairs;
  std::vector<CostRow> block;
  for (int i = 0, j = 0; i < m && j < n;) {
    if (block.empty()) {
      const int end = std::min(i + stride, m);
      block.push_back(end < m ? kept[end / stride] : rows.last());
      for (int k = end - 1; k >= i; --k) block.push_back(rows.before(block.back(), k));
    }
    const double cost = block.back()[j];
    const CostRow& next = block[block.size() - 2];
    if (cost == pairCost(a[i], b[j], reach) + next[j + 1]) {
      pairs.emplace_back(i, j++);
    } else if (cost != aloneCost(a[i]) + next[j]) {
      ++j;
      continue;
    }
    ++i;
    block.pop_back();
    if (block.size() == 1) block.clear();
  }
  return pairs;
}

std::vector<std::pair<int, int>> correspondingFeatures(const std::vector<Feature>& a,
                                                       const std::vector<Feature>& b,
                                                       double reach) {
  constexpr std::array tests = {isCorner, isSharp};
  return pairsIn({0, 1}, a, b, reach, tests);
}

}  // namespace seamwright::match
