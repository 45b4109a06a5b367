// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <seamwright/core/blend/correspondence.hpp>
#include <seamwright/core/blend/frame_features.hpp>
#include <seamwright/core/blend/frame_samples.hpp>
#include <seamwright/core/blend/frame_starts.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::match {

namespace {

/// About their mean.
Poles samples(const Measured& frame, int count) {
  const Poles result = samplesOf(frame, count);
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

/// Joints of a closed frame that are as sharp as the one where it starts, or all sharp ones.
struct SharpJoints {
  std::optional<FeatureKind> kind;
  std::vector<Feature> all;  ///< by their place
  Poles points;              ///< about their mean
};

SharpJoints withPoints(const Measured& frame, std::optional<FeatureKind> kind,
                       std::vector<Feature> all) {
  SharpJoints result{kind, std::move(all), {}};
  if (result.all.empty()) return result;
  result.points.resize(static_cast<Eigen::Index>(result.all.size()), 3);
  for (std::size_t i = 0; i < result.all.size(); ++i)
    result.points.row(static_cast<Eigen::Index>(i)) = frame.point(result.all[i].place).transpose();
  result.points = (result.points.rowwise() - result.points.colwise().mean()).eval();
  return result;
}

/// \param kind nothing: that of the joint where the frame starts.
SharpJoints sharpJoints(const Measured& frame, const Features& features,
                        std::optional<FeatureKind> kind) {
  if (!kind && features.closing) kind = features.closing->kind;
  if (!kind) return {};
  std::vector<Feature> all = sharpFeatures(features);
  std::erase_if(all, [&](const Feature& feature) { return feature.kind != *kind; });
  return withPoints(frame, kind, std::move(all));
}

/// Whether the joints are those of the first frame in their order if a frame starts at its joint i.
bool areAlikeFrom(const std::vector<Feature>& first, const std::vector<Feature>& joints,
                  std::size_t i) {
  if (first.size() != joints.size()) return false;
  for (std::size_t k = 0; k < first.size(); ++k)
    if (!areAlike(first[k], joints[(i + k) % joints.size()])) return false;
  return true;
}

/// Joints from which a frame may start.
using MayStart = std::function<bool(std::size_t)>;

/// The sharp joint to start from if there are equally many: the best one by their distances, if the
/// sum of their squares is below that limit.
std::optional<Place> pairedStart(const SharpJoints& first, const SharpJoints& joints, double limit,
                                 const MayStart& mayStart) {
  const Eigen::VectorXd costs = shiftCosts(first.points, joints.points);
  const double equal = equal_cost * (first.points.squaredNorm() + joints.points.squaredNorm());
  std::optional<Place> best;
  double best_cost = limit;
  for (std::size_t i = 0; i < joints.all.size(); ++i) {
    const double cost = costs(static_cast<Eigen::Index>(i));
    if (!(cost < best_cost - equal) || !mayStart(i)) continue;
    best = joints.all[i].place;
    best_cost = cost;
  }
  return best;
}

/// What it costs to match the corners of closed frames if the second one starts at its corner i.
double costFrom(const std::vector<Feature>& first, const std::vector<Feature>& corners,
                std::size_t i, double reach) {
  std::vector<Feature> from_start;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Feature corner = corners[(i + k) % corners.size()];
    corner.share -= corners[i].share;
    if (corner.share < 0) corner.share += 1;
    from_start.push_back(corner);
  }
  const std::vector<Feature> others(first.begin() + 1, first.end()),
      others_from_start(from_start.begin() + 1, from_start.end());
  return pairCost(first.front(), from_start.front(), reach) +
         matchingCost(others, others_from_start, reach);
}

/// A joint as a start.
struct SharpCandidate {
  const Feature* joint;
  std::size_t index;
  double cost;  ///< by the distances of samples
};

/// The sharp joint to start from within reach of the best place of all: the best one by the
/// distances of samples, for corners that from which they match best.
std::optional<Place> nearStart(const SharpJoints& first, const SharpJoints& joints,
                               const Eigen::VectorXd& costs, double share, double reach,
                               double equal) {
  std::vector<SharpCandidate> candidates;
  for (std::size_t i = 0; i < joints.all.size(); ++i)
    if (const Feature& joint = joints.all[i]; apart(joint.share, share) <= reach)
      candidates.push_back({&joint, i, costAt(costs, joint.share)});
  if (candidates.empty()) return std::nullopt;
  const auto less = [&](const SharpCandidate& a, const SharpCandidate& b) {
    return a.cost < b.cost - equal;
  };
  if (*first.kind != FeatureKind::Corner)
    return std::ranges::min_element(candidates, less)->joint->place;
  // Each costs the time of one matching.
  constexpr std::size_t most_candidates = 32;
  std::ranges::stable_sort(candidates, {}, &SharpCandidate::cost);
  if (candidates.size() > most_candidates) candidates.resize(most_candidates);
  const SharpCandidate* best = &candidates.front();
  double best_cost = infinite;
  for (const SharpCandidate& candidate : candidates) {
    const double cost = costFrom(first.all, joints.all, candidate.index, reach);
    if (!(cost < best_cost - equal_cost * (1 + cost))) continue;
    best = &candidate;
    best_cost = cost;
  }
  return best->joint->place;
}

/// The place to start from: a joint, where one is near.
Place startPlace(const Measured& frame, double share, double near_share) {
  int best = 0;
  for (int i = 0; i < frame.spline().segments(); ++i)
    if (apart(frame.share(i), share) < apart(frame.share(best), share)) best = i;
  return apart(frame.share(best), share) <= near_share ? Place{best, 0} : frame.placeAt(share);
}

/// Whether closed frames go round the same way; nothing if they have no areas to compare.
std::optional<bool> goAlike(const Poles& first, const Poles& frame) {
  const std::optional<Eigen::Vector3d> a = roundOf(first), b = roundOf(frame);
  // A choice: planes that are turned by more than 84 degrees say nothing.
  constexpr double least_cosine = 0.1;
  if (!a || !b || !(std::abs(a->dot(*b)) > least_cosine * a->norm() * b->norm()))
    return std::nullopt;
  return a->dot(*b) > 0;
}

/// What the other frames are compared with.
struct FirstFrame {
  Poles points;
  SharpJoints sharp;   ///< none if its start is smooth, or starts are not found
  SharpJoints joints;  ///< all sharp ones, likewise
  bool flat = false;   ///< all frames are
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
    if (!finds_start_) return;
    const Features of_first = features(first);
    first_.sharp = sharpJoints(first, of_first, std::nullopt);
    if (first_.sharp.kind) first_.joints = withPoints(first, {}, sharpFeatures(of_first));
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
      if (frame.closed && options_.find_direction && !goAlike(first_.points, points).value_or(true))
        continue;
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
    if (first_.sharp.kind)
      if (const auto place = sharpStart(frame, costs, share, equal)) return *place;
    return startPlace(frame, share, near_share_);
  }

  /// \pre the first frame starts at a corner or jump.
  std::optional<Place> sharpStart(const Measured& frame, const Eigen::VectorXd& costs, double share,
                                  double equal) const {
    const Features of_frame = features(frame);
    const SharpJoints joints = withPoints(frame, {}, sharpFeatures(of_frame));
    if (first_.joints.all.size() == joints.all.size()) {
      // Beyond that the frame would be turned by more than a right angle, and frames between
      // shrink.
      const double limit = first_.joints.points.squaredNorm() + joints.points.squaredNorm();
      const MayStart mayStart = [&](std::size_t i) {
        return areAlikeFrom(first_.joints.all, joints.all, i);
      };
      if (const auto place = pairedStart(first_.joints, joints, limit, mayStart)) return place;
    }
    const SharpJoints sharp = sharpJoints(frame, of_frame, first_.sharp.kind);
    return first_.sharp.all.size() == sharp.all.size()
               ? pairedStart(first_.sharp, sharp, infinite, [](std::size_t) { return true; })
               : nearStart(first_.sharp, sharp, costs, share, options_.reach, equal);
  }

  const MatchOptions& options_;
  double near_share_;
  bool finds_start_;
  FirstFrame first_;
};

/// The joints that are corners, as measureJoints() has them.
std::vector<std::size_t> cornersOf(const BezierSpline& frame, double corner_rad) {
  std::vector<std::size_t> result;
  const std::vector<CurveJoint> joints = measureJoints(frame, 1);
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].angle_rad && *joints[i].angle_rad > corner_rad) result.push_back(i);
  return result;
}

/// A closed frame from a corner on. \param corners some
Turned fromCorner(const BezierSpline& frame, std::size_t index,
                  const std::vector<std::size_t>& corners) {
  const std::size_t closing = static_cast<std::size_t>(frame.segments()) - 1;
  if (corners.back() == closing) return {frame};
  const Place place{static_cast<int>(corners.front()) + 1, 0};
  return {startingAt(frame, place), false, measured(frame, index).shareAt(place)};
}

/// The first frame from a corner on, if all frames have corners: a start that corresponds to no
/// corner would come between those that do. If it has more than another frame, from one that
/// corresponds to a corner of the frame with the fewest.
void startAtCorner(const MatchOptions& options, double near_share,
                   std::vector<BezierSpline>& frames, MatchSummary& summary) {
  std::vector<std::vector<std::size_t>> corners;
  for (const BezierSpline& frame : frames) corners.push_back(cornersOf(frame, options.corner_rad));
  const auto fewest = std::ranges::min_element(corners, {}, &std::vector<std::size_t>::size);
  if (fewest->empty()) return;
  Turned first = fromCorner(frames[0], 0, corners[0]);
  if (fewest->size() < corners[0].size()) {
    const auto f = static_cast<std::size_t>(fewest - corners.begin());
    const BezierSpline alike = Turner(frames, options, near_share)(frames[f], f).frame;
    MatchOptions direct = options;
    direct.find_direction = false;
    const Turned other = fromCorner(alike, f, cornersOf(alike, options.corner_rad));
    first = Turner({other.frame, frames[0]}, direct, near_share)(frames[0], 0);
  }
  frames[0] = std::move(first.frame);
  summary.start[0] = first.start;
}

/// Whether the corners and jumps of a closed frame are those of the first one in cyclic order.
bool areAlikeAround(const std::vector<Feature>& first, const std::vector<Feature>& joints) {
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (areAlikeFrom(first, joints, i)) return true;
  return false;
}

/// The first frame from a corner or jump on, if those of all frames are alike in cyclic order: then
/// all of them correspond from there on.
void startAtAlike(const MatchOptions& options, std::vector<BezierSpline>& frames,
                  MatchSummary& summary) {
  const bool flat = areFlat(frames);
  const auto features = [&](const BezierSpline& frame, std::size_t f) {
    return featuresOf(measured(frame, f), flat, {options.corner_rad, options.prominence});
  };
  const Features first = features(frames[0], 0);
  const std::vector<Feature> joints = sharpFeatures(first);
  if (first.closing || joints.empty()) return;
  for (std::size_t f = 1; f < frames.size(); ++f)
    if (!areAlikeAround(joints, sharpFeatures(features(frames[f], f))) &&
        !(options.find_direction &&
          areAlikeAround(joints, sharpFeatures(features(runBackwards(frames[f]), f)))))
      return;
  summary.start[0] = joints.front().share;
  frames[0] = startingAt(frames[0], joints.front().place);
}

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
  if (options.find_start && frames[0].closed) {
    startAtCorner(options, near_share, result, summary);
    if (options.by == MatchBy::Features) startAtAlike(options, result, summary);
  }
  const Turner turn(result, options, near_share);
  for (std::size_t f = 1; f < frames.size(); ++f) {
    Turned best = turn(frames[f], f);
    result[f] = std::move(best.frame);
    summary.reversed[f] = best.reversed;
    summary.start[f] = best.start;
  }
  return result;
}

}  // namespace seamwright::match
