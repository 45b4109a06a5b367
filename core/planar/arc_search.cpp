// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/arc_search.hpp>
#include <seamwright/core/planar/biarc.hpp>
#include <seamwright/core/planar/free_arcs.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The end of an arc of a chain: on the normal of the sample.
struct JointState {
  int sample = 0;
  Vector2d point = Vector2d::Zero();
  double direction_rad = 0;
  double curvature_per_mm = 0, length_mm = 0;  ///< of the arc that ends here
  int before = -1;                             ///< the state in which this arc begins
};

/// The length of an arc up to the projection of a point.
double lengthTo(double curvature_per_mm, const LocalPoint& p) {
  const double sine = curvature_per_mm * p.along, cosine = 1 - curvature_per_mm * p.left;
  // Below it the angle and its tangent are the same.
  constexpr double flat_rad = 1e-8;
  if (std::abs(sine) < flat_rad * std::abs(cosine) && cosine > 0) return p.along / cosine;
  const double turn_rad = std::atan2(sine, cosine);
  const double length_mm = turn_rad / curvature_per_mm;
  return length_mm > 0 ? length_mm : length_mm + 2 * std::numbers::pi / std::abs(curvature_per_mm);
}

/// Signed distance of a point from the circle of an arc, above 0 to the right.
double offsetOf(double curvature_per_mm, const LocalPoint& p) {
  const double h = curvature_per_mm * (p.along * p.along + p.left * p.left) - 2 * p.left;
  return h / (1 + std::sqrt(std::max(0.0, 1 + curvature_per_mm * h)));
}

class ArcSearch {
 public:
  ArcSearch(const SampledRun& run, const RunEnds& ends, const ArcSearchOptions& options)
      : run_(run), ends_(ends), options_(options) {
    addHeadings();
    if (!ends.end.direction_rad) return;
    const std::vector<Vector2d> reversed(run.points.rbegin(), run.points.rend());
    const ArcStart end{.point = ends.end.point,
                       .direction_rad = *ends.end.direction_rad + std::numbers::pi};
    backward_ = run.last() + 1 - pointsBeside(reversed, end, options.tolerance_mm);
  }

  std::optional<PlacedArcs> chain(const Progress& progress) {
    begin();
    // The furthest state can lead nowhere, and others overtake it soon.
    constexpr int most_waits = 6;
    int furthest = 0, waits = 0;
    while (!frontier_.empty()) {
      checkProgress(progress, run_.parameters[furthest] / run_.parameters.back());
      for (const int index : frontier_)
        if (auto found = finished(index)) return found;
      advance();
      int next = 0;
      for (const int index : frontier_) next = std::max(next, states_[index].sample);
      waits = next > furthest ? 0 : waits + 1;
      if (waits > most_waits) return std::nullopt;
      furthest = std::max(next, furthest);
    }
    return std::nullopt;
  }

 private:
  void addHeadings();
  void begin();
  void advance();
  void expand(int index);
  void keep(const JointState& state);
  /// The range for all samples up to each one after the state, until it is empty.
  std::vector<CurvatureRange> ranges(const JointState& state) const;
  CurvatureRange sided(int from, int to) const;
  std::optional<PlacedArcs> finished(int index) const;
  std::optional<PlacedArcs> finishedByOne(int index) const;
  std::optional<PlacedArcs> finishedByTwo(int index) const;
  bool isBeside(const PlanarArc& arc, int from, int to) const;
  bool isPassedOnce(const Vector2d& joint, double direction_rad, int sample) const;
  /// It moves the arc by a millionth of the tolerance.
  double negligibleCurvature(const PlanarArc& arc) const {
    return 1e-6 * options_.tolerance_mm / (arc.length_mm * arc.length_mm);
  }
  PlacedArcs placed(int index) const;

  const SampledRun& run_;
  const RunEnds& ends_;
  const ArcSearchOptions& options_;
  std::vector<double> headings_rad_;
  std::vector<JointState> states_;
  std::vector<int> frontier_;
  /// The furthest state of each class of offsets and directions.
  static constexpr int offset_classes = 11, direction_classes = 24;
  std::array<int, static_cast<std::size_t>(offset_classes* direction_classes)> furthest_{};
  int backward_ = 0;  ///< the first sample that the last arc can be beside
};

/// The direction of the chord between points that are a quarter of an arc away.
void ArcSearch::addHeadings() {
  int from = 0, to = 0;
  for (int i = 0; i <= run_.last(); ++i) {
    const double away_mm = run_.scales_mm[i] / 4;
    from = std::min(from, std::max(0, i - 1));
    while (from + 1 < i && run_.lengths_mm[i] - run_.lengths_mm[from + 1] >= away_mm) ++from;
    to = std::max(to, std::min(i + 1, run_.last()));
    while (to < run_.last() && run_.lengths_mm[to] - run_.lengths_mm[i] < away_mm) ++to;
    headings_rad_.push_back(directionOf(run_.points[to] - run_.points[from]));
  }
}

void ArcSearch::begin() {
  const JointState start{.point = ends_.begin.point};
  if (ends_.begin.direction_rad) {
    states_.push_back(start);
    states_.back().direction_rad = *ends_.begin.direction_rad;
  } else {
    // Around the tangent of the circle through three samples, an arc apart, in directions in which
    // an arc can leave a band of the width of the tolerance.
    constexpr int half_fan = 24;
    const double scale_mm = run_.scales_mm.front();
    const auto at = [&](double length_mm) -> const Vector2d& {
      const auto found = std::ranges::lower_bound(run_.lengths_mm, length_mm);
      return run_.points[std::min<std::size_t>(found - run_.lengths_mm.begin(), run_.last())];
    };
    const Vector2d half = at(scale_mm / 2) - start.point, whole = at(scale_mm) - start.point;
    const double middle_rad = directionOf(half) - angleFromTo(whole, whole - half);
    const double most_rad = std::min(16 * options_.tolerance_mm / scale_mm, std::numbers::pi / 4);
    for (int k = -half_fan; k <= half_fan; ++k) {
      states_.push_back(start);
      states_.back().direction_rad = middle_rad + most_rad * k / half_fan;
    }
  }
  for (int i = 0; i < static_cast<int>(states_.size()); ++i) frontier_.push_back(i);
}

CurvatureRange ArcSearch::sided(int from, int to) const {
  // The curve must not come near the centre of an arc.
  const double most_per_mm = 0.8 / options_.tolerance_mm;
  CurvatureRange range{.lower = -most_per_mm, .upper = most_per_mm};
  if (!options_.keeps_sides) return range;
  if (run_.left[to] == run_.left[from]) range.upper = 0;
  if (run_.right[to] == run_.right[from]) range.lower = 0;
  return range;
}

std::vector<CurvatureRange> ArcSearch::ranges(const JointState& state) const {
  const Vector2d tangent = unitVector(state.direction_rad);
  std::vector<CurvatureRange> result;
  CurvatureRange range;
  for (int i = state.sample + 1; i <= run_.last(); ++i) {
    const LocalPoint p = localPoint(run_.points[i], state.point, tangent);
    const CurvatureRange near = curvaturesNear(p, options_.tolerance_mm);
    range.lower = std::max(range.lower, near.lower);
    range.upper = std::min(range.upper, near.upper);
    if (range.isEmpty()) break;
    const double least = std::max({0.0, range.lower, -range.upper});
    if (least * (run_.lengths_mm[i] - run_.lengths_mm[state.sample]) > options_.most_turn_rad)
      break;
    result.push_back(range);
  }
  return result;
}

void ArcSearch::keep(const JointState& state) {
  const Vector2d normal(-std::sin(state.direction_rad), std::cos(state.direction_rad));
  const double offset =
      (run_.points[state.sample] - state.point).dot(normal) / options_.tolerance_mm;
  const int across =
      std::clamp(static_cast<int>((offset + 1) / 2 * offset_classes), 0, offset_classes - 1);
  // In units of the tolerance by the length of an arc; that of an ideal chain is up to 10.4.
  constexpr double widest = 24;
  const double turn = wrapped(state.direction_rad - headings_rad_[state.sample]) *
                      run_.scales_mm[state.sample] / options_.tolerance_mm;
  const int along = std::clamp(static_cast<int>((turn / widest + 1) / 2 * direction_classes), 0,
                               direction_classes - 1);
  int& furthest = furthest_[static_cast<std::size_t>(across * direction_classes + along)];
  if (furthest >= 0 && states_[furthest].sample >= state.sample) return;
  if (furthest >= 0) {
    states_[furthest] = state;
    return;
  }
  furthest = static_cast<int>(states_.size());
  states_.push_back(state);
}

void ArcSearch::expand(int index) {
  const JointState from = states_[index];
  const std::vector<CurvatureRange> found = ranges(from);
  const Vector2d tangent = unitVector(from.direction_rad);
  const int reach = static_cast<int>(found.size());
  // Choices: finer ones save few arcs.
  constexpr int most_ends = 16, curvatures = 7;
  const int nearest = std::max(1, reach / 3);
  const int stride = std::max(1, (reach - nearest) / most_ends);
  for (int k = reach; k >= nearest; k -= stride) {
    const int to = from.sample + k;
    if (to >= run_.last()) continue;
    const CurvatureRange side = sided(from.sample, to);
    const CurvatureRange range = {.lower = std::max(found[k - 1].lower, side.lower),
                                  .upper = std::min(found[k - 1].upper, side.upper)};
    if (range.isEmpty() || !std::isfinite(range.lower) || !std::isfinite(range.upper)) continue;
    const LocalPoint p = localPoint(run_.points[to], from.point, tangent);
    for (int c = 0; c < curvatures; ++c) {
      JointState state{.sample = to, .before = index};
      state.curvature_per_mm = std::lerp(range.lower, range.upper, double(c) / (curvatures - 1));
      state.length_mm = lengthTo(state.curvature_per_mm, p);
      const PlanarArc arc{.start = from.point,
                          .direction_rad = from.direction_rad,
                          .curvature_per_mm = state.curvature_per_mm,
                          .length_mm = state.length_mm};
      if (!(arc.length_mm > 0) || std::abs(arc.sweep_rad()) > options_.most_turn_rad) continue;
      state.point = arc.end();
      state.direction_rad = arc.endDirection_rad();
      if (isPassedOnce(state.point, state.direction_rad, to)) keep(state);
      if (range.lower == range.upper) break;
    }
  }
}

void ArcSearch::advance() {
  furthest_.fill(-1);
  const std::vector<int> from = std::move(frontier_);
  frontier_.clear();
  for (const int index : from) expand(index);
  for (const int index : furthest_)
    if (index >= 0) frontier_.push_back(index);
}

/// Whether samples are within the tolerance of the circle of an arc, and forward from its start.
bool ArcSearch::isBeside(const PlanarArc& arc, int from, int to) const {
  const CurvatureRange side = sided(from, to);
  const double negligible = negligibleCurvature(arc);
  if (arc.curvature_per_mm < side.lower - negligible ||
      arc.curvature_per_mm > side.upper + negligible)
    return false;
  if (std::abs(arc.sweep_rad()) > options_.most_turn_rad) return false;
  const Vector2d tangent = unitVector(arc.direction_rad);
  for (int i = from; i <= to; ++i) {
    const LocalPoint p = localPoint(run_.points[i], arc.start, tangent);
    if (std::abs(offsetOf(arc.curvature_per_mm, p)) > options_.tolerance_mm) return false;
  }
  return true;
}

/// Whether the samples near a joint pass its normal at the given one only. A curve that turns more
/// sharply than the arcs is beyond the end of an arc before.
bool ArcSearch::isPassedOnce(const Vector2d& joint, double direction_rad, int sample) const {
  const Vector2d tangent = unitVector(direction_rad);
  // As far as the curve can go back within the tolerance; what is a part of the tolerance does not
  // count.
  const double near_mm = 4 * options_.tolerance_mm, negligible_mm = 0.1 * options_.tolerance_mm;
  const auto ahead = [&](int i) { return (run_.points[i] - joint).dot(tangent); };
  const auto away = [&](int i) { return std::abs(run_.lengths_mm[i] - run_.lengths_mm[sample]); };
  for (int i = sample - 1; i >= 0 && away(i) < near_mm; --i)
    if (ahead(i) > negligible_mm) return false;
  for (int i = sample + 1; i <= run_.last() && away(i) < near_mm; ++i)
    if (ahead(i) < -negligible_mm) return false;
  return true;
}

PlacedArcs ArcSearch::placed(int index) const {
  PlacedArcs found;
  for (int i = index; states_[i].before >= 0; i = states_[i].before) {
    const JointState &to = states_[i], &from = states_[to.before];
    found.arcs.push_back({.start = from.point,
                          .direction_rad = from.direction_rad,
                          .curvature_per_mm = to.curvature_per_mm,
                          .length_mm = to.length_mm});
    found.ends.push_back({run_.parameters[to.sample], run_.parameters[to.sample]});
  }
  std::ranges::reverse(found.arcs);
  std::ranges::reverse(found.ends);
  return found;
}

std::optional<PlacedArcs> ArcSearch::finished(int index) const {
  if (states_[index].sample >= run_.last()) return std::nullopt;
  return ends_.end.direction_rad ? finishedByTwo(index) : finishedByOne(index);
}

std::optional<PlacedArcs> ArcSearch::finishedByOne(int index) const {
  const JointState& from = states_[index];
  const std::vector<CurvatureRange> found = ranges(from);
  if (from.sample + static_cast<int>(found.size()) < run_.last()) return std::nullopt;
  if (from.point == ends_.end.point) return std::nullopt;
  PlanarArc arc = arcThrough(from.point, from.direction_rad, ends_.end.point);
  if (std::abs(arc.curvature_per_mm) <= negligibleCurvature(arc)) arc.curvature_per_mm = 0;
  if (!isBeside(arc, from.sample, run_.last())) return std::nullopt;
  PlacedArcs result = placed(index);
  result.arcs.push_back(arc);
  result.ends.push_back({run_.parameters.back(), run_.parameters.back()});
  return result;
}

std::optional<PlacedArcs> ArcSearch::finishedByTwo(int index) const {
  const JointState& from = states_[index];
  if (from.sample + static_cast<int>(ranges(from).size()) < backward_) return std::nullopt;
  if (from.point == ends_.end.point) return std::nullopt;
  const HermiteEnds ends = {.start = from.point,
                            .start_direction_rad = from.direction_rad,
                            .end = ends_.end.point,
                            .end_direction_rad = *ends_.end.direction_rad};
  const ChordAngles angles = chordAngles(ends);
  if (std::abs(angles.alpha_rad + angles.beta_rad) > options_.most_turn_rad) return std::nullopt;
  constexpr int shares = 16;
  for (int k = 0; k < shares - 1; ++k) {
    // From the middle outwards.
    const int away = (k + 1) / 2 * (k % 2 == 0 ? 1 : -1);
    const Biarc pair = biarc(ends, 0.5 + static_cast<double>(away) / shares);
    const Vector2d tangent = unitVector(pair.second.direction_rad);
    int joint = from.sample;
    while (joint < run_.last() && (run_.points[joint] - pair.joint()).dot(tangent) < 0) ++joint;
    if (joint == from.sample || joint == run_.last()) continue;
    if (!isPassedOnce(pair.joint(), pair.second.direction_rad, joint)) continue;
    if (!isBeside(pair.first, from.sample, joint - 1)) continue;
    if (!isBeside(pair.second, joint, run_.last())) continue;
    PlacedArcs result = placed(index);
    result.arcs.insert(result.arcs.end(), {pair.first, pair.second});
    result.ends.insert(result.ends.end(), {{run_.parameters[joint - 1], run_.parameters[joint]},
                                           {run_.parameters.back(), run_.parameters.back()}});
    return result;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PlacedArcs> fewArcs(const SampledRun& run, const RunEnds& ends,
                                  const ArcSearchOptions& options, const Progress& progress) {
  return ArcSearch(run, ends, options).chain(progress);
}

}  // namespace seamwright
