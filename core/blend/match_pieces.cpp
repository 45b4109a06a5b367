// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <seamwright/core/blend/correspondence.hpp>
#include <seamwright/core/blend/frame_fault.hpp>
#include <seamwright/core/blend/frame_features.hpp>
#include <seamwright/core/blend/frame_form.hpp>
#include <seamwright/core/blend/match_pieces.hpp>
#include <seamwright/core/blend/spline_places.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace match {

namespace {

using Splines = std::vector<BezierSpline>;

/// Does the work; names the frame in what it refuses.
template <class Work>
auto naming(std::size_t frame, const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& fault) {
    throw FrameFault(frame, fmt::format("frame {}: {}", frame, fault.what()));
  }
}

void requireFrames(const Splines& frames) {
  if (frames.size() < 2) refuse(fmt::format("frames {}: at least 2 are needed", frames.size()));
  for (std::size_t f = 0; f < frames.size(); ++f) {
    naming(f, [&] { requireValid(frames[f]); });
    if (frames[f].closed != frames[0].closed)
      throw FrameFault(
          f, fmt::format("frame {} is {}, frame 0 is {}", f, frames[f].closed ? "closed" : "open",
                         frames[0].closed ? "closed" : "open"));
  }
}

void requireGiven(const Splines& frames, const MatchOptions& options) {
  if (options.find_start || options.find_direction)
    refuse("given parameters fix the start and the direction: they cannot be found");
  if (options.given.size() != frames.size())
    refuse(fmt::format("frames {}, lists of given parameters {}", frames.size(),
                       options.given.size()));
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const std::vector<double>&given = options.given[f], &knots = frames[f].knots;
    if (given.size() != options.given[0].size())
      refuse(fmt::format("frame {} has {} given parameters, frame 0 {}", f, given.size(),
                         options.given[0].size()));
    for (std::size_t i = 0; i < given.size(); ++i) {
      const bool inside =
          given[i] < knots.back() &&
          (given[i] > knots.front() || (frames[f].closed && given[i] == knots.front()));
      if (!inside || (i > 0 && !(given[i] > given[i - 1])))
        refuse(fmt::format("frame {}: given parameter {} is {}: they must increase within {} to {}",
                           f, i, given[i], knots.front(), knots.back()));
    }
  }
}

void requireOptions(const Splines& frames, const MatchOptions& options) {
  for (const auto& [name, value] : {std::pair{"closeness", options.closeness},
                                    {"reach", options.reach},
                                    {"prominence", options.prominence}})
    if (!(value >= 0 && value <= 0.5))
      refuse(fmt::format("{} is {}: 0 to 1/2 is possible", name, value));
  if (!(options.corner_rad > 0)) refuse(fmt::format("corner_rad is {}", options.corner_rad));
  if (options.by == MatchBy::Given)
    requireGiven(frames, options);
  else if (!options.given.empty())
    refuse("given parameters are for MatchBy::Given only");
}

Measured measured(const BezierSpline& frame, std::size_t index) {
  return naming(index, [&] { return Measured(frame); });
}

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

/// Mean square distances of a frame from the first, for every shift by one sample.
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

struct Turned {
  BezierSpline frame;
  bool reversed = false;
  double start = 0;
};

/// The place to start from: a joint, where one is within the closeness, or half a sample.
Place startPlace(const Measured& frame, double share, double closeness) {
  const double near = std::max(closeness, 0.5 / sample_count);
  int best = 0;
  double best_distance = infinite;
  for (int i = 0; i < frame.spline().segments(); ++i) {
    const double apart = std::abs(frame.share(i) - share), distance = std::min(apart, 1 - apart);
    if (distance < best_distance) {
      best = i;
      best_distance = distance;
    }
  }
  return best_distance <= near ? Place{best, 0} : frame.placeAt(share);
}

Turned turnedLike(const Poles& first, const BezierSpline& frame, std::size_t index,
                  const MatchOptions& options) {
  double best_cost = infinite;
  Turned best{frame};
  for (const bool reversed : {false, true}) {
    if (reversed && !options.find_direction) continue;
    const Measured candidate = measured(reversed ? runBackwards(frame) : frame, index);
    const Poles points = samples(candidate, sample_count);
    const bool shifts = frame.closed && options.find_start;
    const Eigen::VectorXd costs =
        shifts ? shiftCosts(first, points)
               : Eigen::VectorXd::Constant(1, (first - points).squaredNorm());
    Eigen::Index at = 0;
    const double cost = costs.minCoeff(&at);
    if (!(cost < best_cost)) continue;
    best_cost = cost;
    best = {candidate.spline(), reversed, 0};
    if (!shifts) continue;
    const double share =
        (static_cast<double>(at) + refinedShift(costs, at) + sample_count) / sample_count;
    const Place place = startPlace(candidate, share - std::floor(share), options.closeness);
    best.frame = startingAt(candidate.spline(), place);
    best.start = candidate.shareAt(place);
  }
  return best;
}

/// The frames in their directions, from their starts.
Splines turned(const Splines& frames, const MatchOptions& options, MatchSummary& summary) {
  Splines result = frames;
  summary.reversed.assign(frames.size(), false);
  summary.start.assign(frames.size(), 0);
  if (options.by == MatchBy::Given && frames[0].closed && !options.given[0].empty())
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const Measured frame = measured(frames[f], f);
      const Place place = frame.placeOf(options.given[f][0]);
      summary.start[f] = frame.shareAt(place);
      result[f] = startingAt(frames[f], place);
    }
  if (!options.find_direction && !(options.find_start && frames[0].closed)) return result;
  const Poles first = samples(measured(frames[0], 0), sample_count);
  for (std::size_t f = 1; f < frames.size(); ++f) {
    Turned best = turnedLike(first, frames[f], f, options);
    result[f] = std::move(best.frame);
    summary.reversed[f] = best.reversed;
    summary.start[f] = best.start;
  }
  return result;
}

/// A feature beside a joint is at the joint.
Feature snapped(const Measured& frame, Feature feature, double closeness) {
  for (int i = 1; i < frame.spline().segments(); ++i)
    if (std::abs(frame.share(i) - feature.share) <= closeness) {
      feature.place = {i, 0};
      feature.share = frame.share(i);
    }
  return feature;
}

/// Whether an anchor lies inside, and after the one before, in all frames.
bool follows(const Anchor& anchor, const std::vector<Anchor>& before, double closeness) {
  for (std::size_t f = 0; f < anchor.shares.size(); ++f) {
    const double last = before.empty() ? 0 : before.back().shares[f];
    if (!(anchor.shares[f] > last + closeness) || !(anchor.shares[f] < 1 - closeness)) return false;
  }
  return true;
}

std::vector<Anchor> featureAnchors(const std::vector<Measured>& frames, const MatchOptions& options,
                                   MatchSummary& summary) {
  bool planar = true;
  for (const Measured& frame : frames)
    planar = planar && (frame.spline().poles.col(2).array() == 0).all();
  std::vector<std::vector<Feature>> all;
  for (const Measured& frame : frames) {
    Features features = featuresOf(frame, planar, {options.corner_rad, options.prominence});
    summary.features.push_back(static_cast<int>(features.all.size()));
    summary.unknown_pieces += features.unknown_pieces;
    all.push_back(std::move(features.all));
  }
  // For each feature of the first frame its partners in the others.
  std::vector<std::vector<int>> partners(all[0].size(), std::vector<int>(frames.size(), -1));
  for (std::size_t i = 0; i < partners.size(); ++i) partners[i][0] = static_cast<int>(i);
  for (std::size_t f = 1; f < frames.size(); ++f)
    for (const auto& [i, j] : matchedFeatures(all[0], all[f], options.reach)) partners[i][f] = j;
  std::vector<Anchor> result;
  for (const std::vector<int>& partner : partners) {
    if (std::find(partner.begin(), partner.end(), -1) != partner.end()) continue;
    Anchor anchor;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const Feature feature = snapped(frames[f], all[f][partner[f]], options.closeness);
      anchor.places.push_back(feature.place);
      anchor.shares.push_back(feature.share);
    }
    if (follows(anchor, result, options.closeness)) result.push_back(std::move(anchor));
  }
  return result;
}

std::vector<Anchor> givenAnchors(const std::vector<Measured>& frames, const Splines& original,
                                 const MatchOptions& options) {
  std::vector<Anchor> result;
  const bool closed = original[0].closed;
  for (std::size_t i = closed ? 1 : 0; i < options.given[0].size(); ++i) {
    Anchor anchor;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const double start = closed ? options.given[f][0] : original[f].knots.front();
      anchor.places.push_back(
          frames[f].placeOf(frames[f].spline().knots.front() + (options.given[f][i] - start)));
      anchor.shares.push_back(frames[f].shareAt(anchor.places.back()));
    }
    if (!follows(anchor, result, 0))
      refuse(fmt::format("given parameter {} is at the same place as another", i));
    result.push_back(std::move(anchor));
  }
  return result;
}

/// The piecewise linear map from the values of one list to those of another.
double mapped(double x, const std::vector<double>& from, const std::vector<double>& to) {
  const auto above = std::upper_bound(from.begin() + 1, from.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - from.begin());
  return to[i - 1] + (x - from[i - 1]) / (from[i] - from[i - 1]) * (to[i] - to[i - 1]);
}

/// A joint of one frame at its common place.
struct OwnJoint {
  double place = 0;
  std::size_t frame = 0;
};

/// A joint of all frames.
struct CommonJoint {
  double place = 0;       ///< the mean
  std::vector<bool> own;  ///< whether it is a joint of the frame already
};

/// Links neighbours up to the closeness, each frame at most once. \param joints by place.
std::vector<CommonJoint> linked(const std::vector<OwnJoint>& joints, std::size_t frames,
                                double closeness) {
  std::vector<CommonJoint> result;
  std::vector<double> sums, counts;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const OwnJoint& joint = joints[k];
    if (k == 0 || !(joint.place - joints[k - 1].place <= closeness) ||
        result.back().own[joint.frame]) {
      result.push_back({0, std::vector<bool>(frames, false)});
      sums.push_back(0);
      counts.push_back(0);
    }
    result.back().own[joint.frame] = true;
    sums.back() += joint.place;
    ++counts.back();
    result.back().place = sums.back() / counts.back();
  }
  return result;
}

/// The joints that no anchor makes, between the anchors.
std::vector<OwnJoint> ownJoints(const std::vector<Measured>& frames,
                                const std::vector<Anchor>& anchors, const Scale& scale) {
  std::vector<OwnJoint> result;
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (int i = 1; i < frames[f].spline().segments(); ++i) {
      const bool taken = std::any_of(anchors.begin(), anchors.end(), [&](const Anchor& anchor) {
        return anchor.places[f].piece == i && anchor.places[f].t == 0;
      });
      if (!taken)
        result.push_back({mapped(frames[f].share(i), scale.of_frame[f], scale.common), f});
    }
  std::stable_sort(result.begin(), result.end(),
                   [](const OwnJoint& a, const OwnJoint& b) { return a.place < b.place; });
  return result;
}

/// Common joints, linked between neighbouring anchors only.
std::vector<CommonJoint> commonJoints(const std::vector<OwnJoint>& joints, const Scale& scale,
                                      std::size_t frames, double closeness) {
  std::vector<CommonJoint> result;
  auto next = joints.begin();
  for (std::size_t k = 1; k < scale.common.size(); ++k) {
    std::vector<OwnJoint> between;
    while (next != joints.end() && (k + 1 == scale.common.size() || next->place < scale.common[k]))
      between.push_back(*next++);
    for (CommonJoint& joint : linked(between, frames, closeness)) result.push_back(joint);
  }
  return result;
}

BezierSpline divided(const Measured& frame, std::size_t f, const std::vector<Anchor>& anchors,
                     const std::vector<CommonJoint>& joints, const Scale& scale) {
  std::vector<Place> places;
  for (const Anchor& anchor : anchors)
    if (anchor.places[f].t > 0) places.push_back(anchor.places[f]);
  for (const CommonJoint& joint : joints)
    if (!joint.own[f])
      places.push_back(frame.placeAt(mapped(joint.place, scale.common, scale.of_frame[f])));
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.piece != b.piece ? a.piece < b.piece : a.t < b.t;
  });
  const auto count = static_cast<int>(anchors.size() + joints.size()) + 1;
  BezierSpline result = dividedAt(frame.spline(), places);
  if (result.segments() != count)
    throw FrameFault(
        f, fmt::format("frame {}: {} pieces are needed and {} possible: joints are too close "
                       "together; a larger closeness merges them",
                       f, count, result.segments()));
  return result;
}

double largestRatio(const Splines& frames) {
  std::vector<Measured> all;
  for (std::size_t f = 0; f < frames.size(); ++f) all.push_back(measured(frames[f], f));
  double result = 1;
  for (int i = 0; i < frames[0].segments(); ++i) {
    double least = infinite, most = 0;
    for (const Measured& frame : all) {
      const double length = frame.share(i + 1) - frame.share(i);
      least = std::min(least, length);
      most = std::max(most, length);
    }
    result = std::max(result, most / least);
  }
  return result;
}

}  // namespace

Correspondence corresponding(const std::vector<BezierSpline>& frames, const MatchOptions& options,
                             MatchSummary& summary) {
  requireFrames(frames);
  requireOptions(frames, options);
  for (const BezierSpline& frame : frames) summary.pieces_before.push_back(frame.segments());
  const Splines start = turned(frames, options, summary);
  Correspondence result;
  for (std::size_t f = 0; f < start.size(); ++f) result.frames.push_back(measured(start[f], f));
  if (options.by == MatchBy::Features)
    result.anchors = featureAnchors(result.frames, options, summary);
  if (options.by == MatchBy::Given) result.anchors = givenAnchors(result.frames, frames, options);
  summary.matched_features = static_cast<int>(result.anchors.size());
  return result;
}

Scale scaleOf(const std::vector<Anchor>& anchors, std::size_t frames) {
  Scale result{{0}, std::vector<std::vector<double>>(frames, {0})};
  for (const Anchor& anchor : anchors) {
    const double sum = std::accumulate(anchor.shares.begin(), anchor.shares.end(), 0.0);
    result.common.push_back(sum / static_cast<double>(frames));
    for (std::size_t f = 0; f < frames; ++f) result.of_frame[f].push_back(anchor.shares[f]);
  }
  result.common.push_back(1);
  for (std::vector<double>& shares : result.of_frame) shares.push_back(1);
  return result;
}

}  // namespace match

MatchedFrames matchPieces(const std::vector<BezierSpline>& frames, const MatchOptions& options) {
  using namespace match;
  MatchedFrames result;
  MatchSummary& summary = result.summary;
  const auto [all, anchors] = corresponding(frames, options, summary);
  int degree = 0;
  for (const BezierSpline& frame : frames) degree = std::max(degree, frame.degree);
  const Scale scale = scaleOf(anchors, all.size());
  const std::vector<CommonJoint> joints =
      commonJoints(ownJoints(all, anchors, scale), scale, all.size(), options.closeness);
  for (const CommonJoint& joint : joints)
    if (std::count(joint.own.begin(), joint.own.end(), true) > 1) ++summary.merged;
  for (std::size_t f = 0; f < all.size(); ++f)
    result.frames.push_back(loft::raised(divided(all[f], f, anchors, joints, scale), degree));
  summary.pieces_after = result.frames[0].segments();
  summary.largest_ratio = largestRatio(result.frames);
  return result;
}

}  // namespace seamwright
