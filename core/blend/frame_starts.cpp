// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include <seamwright/core/blend/correspondence.hpp>
#include <seamwright/core/blend/frame_features.hpp>
#include <seamwright/core/blend/frame_starts.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::match {

namespace {

/// Points at equal shares of the length, about their mean. They are only compared, so that a
/// thousandth of a piece is precise enough.
Poles samples(const Measured& frame, int count) {
  const bool closed = frame.spline().closed;
  Poles result(count, 3);
  for (int i = 0; i < count; ++i)
    result.row(i) =
        frame.point(frame.placeAt(static_cast<double>(i) / (closed ? count : count - 1), 1e-3));
  return result.rowwise() - result.colwise().mean();
}

/// Sums of squared distances of a frame from the first, for every shift by one sample.
Eigen::VectorXd shiftCosts(const Poles& first, const Poles& frame) {
  const Eigen::Index count = first.rows();
  Eigen::VectorXd result(count);
  for (Eigen::Index shift = 0; shift < count; ++shift)
    result(shift) = (first.topRows(count - shift) - frame.bottomRows(count - shift)).squaredNorm() +
                    (first.bottomRows(shift) - frame.topRows(shift)).squaredNorm();
  return result;
}

/// The minimum of the parabola through three neighbours, in steps from the middle one.
double refinedShift(const Eigen::VectorXd& costs, Eigen::Index at) {
  const Eigen::Index count = costs.size();
  const double before = costs((at + count - 1) % count), after = costs((at + 1) % count);
  const double bend = before - 2 * costs(at) + after;
  return bend > 0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0;
}

/// Samples of a curve: enough for outlines of a few dozen features; a start is found to about a
/// hundredth of their distance, and may be given where that is too coarse.
constexpr int sample_count = 128;

/// Sums of squares that differ by less, as a share of what they are made of, are equal: which of
/// them is less is rounding, and the first one is taken.
constexpr double equal_cost = 1e-9;

double costAt(const Eigen::VectorXd& costs, double share) {
  const double at = share * static_cast<double>(costs.size());
  const auto before = static_cast<Eigen::Index>(at);
  const double part = at - static_cast<double>(before);
  return (1 - part) * costs(before % costs.size()) + part * costs((before + 1) % costs.size());
}

/// The distance of two places along a closed curve.
double apart(double share, double other) {
  const double distance = std::abs(share - other);
  return std::min(distance, 1 - distance);
}

/// The joint of a closed frame where it is as sharp as the first frame where that one starts, and
/// nearest to it. \param share the nearest place of all.
std::optional<Place> sharpStart(const Features& features, FeatureKind kind,
                                const Eigen::VectorXd& costs, double share, double reach,
                                double equal) {
  std::vector<Feature> candidates;
  if (features.closing == kind) candidates.push_back({kind, {0, 0}, 0});
  for (const Feature& feature : features.all)
    if (feature.kind == kind) candidates.push_back(feature);
  std::optional<Place> best;
  double best_cost = infinite;
  for (const Feature& candidate : candidates) {
    if (apart(candidate.share, share) > reach) continue;
    const double cost = costAt(costs, candidate.share);
    if (!(cost < best_cost - equal)) continue;
    best = candidate.place;
    best_cost = cost;
  }
  return best;
}

/// The place to start from: a joint, where one is near.
Place startPlace(const Measured& frame, double share, double near_share) {
  int best = 0;
  for (int i = 0; i < frame.spline().segments(); ++i)
    if (apart(frame.share(i), share) < apart(frame.share(best), share)) best = i;
  return apart(frame.share(best), share) <= near_share ? Place{best, 0} : frame.placeAt(share);
}

/// What the other frames are compared with.
struct FirstFrame {
  Poles points;
  std::optional<FeatureKind> start;  ///< what its start is, if it is closed and starts are found
  bool flat = false;                 ///< all frames are
};

struct Turned {
  BezierSpline frame;
  bool reversed = false;
  double start = 0;
};

class Turner {
 public:
  Turner(const std::vector<BezierSpline>& frames, const MatchOptions& options, double near_share)
      : options_(options),
        near_share_(near_share),
        finds_start_(frames[0].closed && options.find_start) {
    const Measured first = measured(frames[0], 0);
    first_.points = samples(first, sample_count);
    first_.flat = areFlat(frames);
    if (finds_start_) first_.start = features(first).closing;
  }

  Turned operator()(const BezierSpline& frame, std::size_t index) const {
    double best_cost = infinite;
    Turned best{frame};
    for (const bool reversed : {false, true}) {
      if (reversed && !options_.find_direction) continue;
      const Measured candidate = measured(reversed ? runBackwards(frame) : frame, index);
      const Poles points = samples(candidate, sample_count);
      const Eigen::VectorXd costs =
          finds_start_ ? shiftCosts(first_.points, points)
                       : Eigen::VectorXd::Constant(1, (first_.points - points).squaredNorm());
      const double equal = equal_cost * (first_.points.squaredNorm() + points.squaredNorm());
      if (!(costs.minCoeff() < best_cost - equal)) continue;
      best_cost = costs.minCoeff();
      best = {candidate.spline(), reversed, 0};
      if (!finds_start_) continue;
      const Place place = start(candidate, costs, equal);
      best.frame = startingAt(candidate.spline(), place);
      best.start = candidate.shareAt(place);
    }
    return best;
  }

 private:
  Features features(const Measured& frame) const {
    return featuresOf(frame, first_.flat, {options_.corner_rad, options_.prominence});
  }

  Place start(const Measured& frame, const Eigen::VectorXd& costs, double equal) const {
    Eigen::Index at = 0;
    while (!(costs(at) <= costs.minCoeff() + equal)) ++at;
    const double steps = static_cast<double>(at) + refinedShift(costs, at) + sample_count;
    const double share = steps / sample_count - std::floor(steps / sample_count);
    if (first_.start)
      if (const std::optional<Place> sharp =
              sharpStart(features(frame), *first_.start, costs, share, options_.reach, equal))
        return *sharp;
    return startPlace(frame, share, near_share_);
  }

  const MatchOptions& options_;
  double near_share_;
  bool finds_start_;
  FirstFrame first_;
};

/// Closed frames from their first given parameters.
void startAtGiven(const std::vector<BezierSpline>& frames, const MatchOptions& options,
                  std::vector<BezierSpline>& result, MatchSummary& summary) {
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const Measured frame = measured(frames[f], f);
    const Place place = frame.placeOf(options.given[f][0]);
    summary.start[f] = frame.shareAt(place);
    result[f] = startingAt(frames[f], place);
  }
}

}  // namespace

bool areFlat(const std::vector<BezierSpline>& frames) {
  return std::all_of(frames.begin(), frames.end(), [](const BezierSpline& frame) {
    return (frame.poles.col(2).array() == 0).all();
  });
}

std::vector<BezierSpline> turned(const std::vector<BezierSpline>& frames,
                                 const MatchOptions& options, double near_share,
                                 MatchSummary& summary) {
  std::vector<BezierSpline> result = frames;
  summary.reversed.assign(frames.size(), false);
  summary.start.assign(frames.size(), 0);
  if (options.by == MatchBy::Given && frames[0].closed && !options.given[0].empty())
    startAtGiven(frames, options, result, summary);
  if (!options.find_direction && !(options.find_start && frames[0].closed)) return result;
  const Turner turn(frames, options, near_share);
  for (std::size_t f = 1; f < frames.size(); ++f) {
    Turned best = turn(frames[f], f);
    result[f] = std::move(best.frame);
    summary.reversed[f] = best.reversed;
    summary.start[f] = best.start;
  }
  return result;
}

}  // namespace seamwright::match
