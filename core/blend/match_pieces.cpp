// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include <seamwright/core/blend/correspondence.hpp>
#include <seamwright/core/blend/frame_fault.hpp>
#include <seamwright/core/blend/frame_features.hpp>
#include <seamwright/core/blend/frame_form.hpp>
#include <seamwright/core/blend/frame_starts.hpp>
#include <seamwright/core/blend/joint_blend.hpp>
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
    throw FrameFault(frame, fmt::format("frame {}: ", frame), fault.what());
  }
}

void requireFrames(const Splines& frames) {
  if (frames.size() < 2) refuse(fmt::format("frames {}: at least 2 are needed", frames.size()));
  for (std::size_t f = 0; f < frames.size(); ++f) {
    naming(f, [&] { requireValid(frames[f]); });
    if (frames[f].closed != frames[0].closed)
      throw FrameFault(f, fmt::format("frame {} ", f),
                       fmt::format("is {}, frame 0 is {}", frames[f].closed ? "closed" : "open",
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
    const bool closed = frames[f].closed;
    for (std::size_t i = 0; i < given.size(); ++i) {
      // Once around a closed frame, from the first one on.
      const double end = closed && i > 0 ? given[0] + knots.back() - knots.front() : knots.back();
      const bool inside =
          given[i] < end && (given[i] > knots.front() || (closed && given[i] == knots.front()));
      if (!inside || (i > 0 && !(given[i] > given[i - 1])))
        refuse(fmt::format("frame {}: given parameter {} is {}: they must increase within {} to {}",
                           f, i, given[i], knots.front(), end));
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

/// A feature beside a joint is at the nearest one.
Feature snapped(const Measured& frame, Feature feature, double near_share) {
  if (feature.place.t == 0) return feature;
  const double share = feature.share;
  for (int i = 1; i < frame.spline().segments(); ++i)
    if (const double apart = std::abs(frame.share(i) - share);
        apart <= near_share && (feature.place.t > 0 || apart < std::abs(feature.share - share))) {
      feature.place = {i, 0};
      feature.share = frame.share(i);
    }
  return feature;
}

/// Whether an anchor lies between two others, or ends, in all frames.
bool isBetween(const Anchor& anchor, const Anchor* before, const Anchor* after, double closeness) {
  for (std::size_t f = 0; f < anchor.shares.size(); ++f) {
    const double last = before ? before->shares[f] : 0, next = after ? after->shares[f] : 1;
    if (!(anchor.shares[f] > last + closeness) || !(anchor.shares[f] < next - closeness))
      return false;
  }
  return true;
}

/// Adds an anchor where it belongs, unless others leave no room.
void insert(const Anchor& anchor, double closeness, std::vector<Anchor>& all) {
  const auto after = std::find_if(all.begin(), all.end(), [&](const Anchor& other) {
    return other.shares[0] > anchor.shares[0];
  });
  if (isBetween(anchor, after == all.begin() ? nullptr : &*(after - 1),
                after == all.end() ? nullptr : &*after, closeness))
    all.insert(after, anchor);
}

/// The unit tangent at a place; 0 where the curve stops.
Eigen::Vector3d tangentAt(const BezierSpline& spline, const Place& place) {
  const Eigen::Vector3d first = segment(spline, place.piece).derivatives(place.t, 1).row(1);
  return first.stableNorm() > 0 ? first.stableNormalized() : Eigen::Vector3d::Zero();
}

/// Whether the frames have one tangent at a place.
bool areParallel(const std::vector<Measured>& frames, const std::vector<Place>& places) {
  const Eigen::Vector3d first = tangentAt(frames[0].spline(), places[0]);
  for (std::size_t f = 1; f < frames.size(); ++f)
    if (!((tangentAt(frames[f].spline(), places[f]) - first).norm() <=
          JointBlendOptions().parallel_rad))
      return false;
  return true;
}

MatchedKind matchedKind(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::Corner:
      return MatchedKind::Corner;
    case FeatureKind::Rise:
    case FeatureKind::Fall:
      return MatchedKind::Jump;
    case FeatureKind::Maximum:
    case FeatureKind::Minimum:
      break;
  }
  return MatchedKind::Extremum;
}

/// An anchor of features of one kind.
Anchor anchorAt(const std::vector<Measured>& frames, const std::vector<Feature>& features) {
  Anchor result{.places = {}, .shares = {}, .kind = matchedKind(features[0].kind)};
  for (const Feature& feature : features) {
    result.places.push_back(feature.place);
    result.shares.push_back(feature.share);
  }
  result.may_kink = result.kind == MatchedKind::Corner ||
                    (result.kind == MatchedKind::Jump && areParallel(frames, result.places));
  return result;
}

std::vector<Features> featuresOfAll(const std::vector<Measured>& frames,
                                    const MatchOptions& options, bool planar) {
  std::vector<Features> result;
  for (const Measured& frame : frames)
    result.push_back(featuresOf(frame, planar, {options.corner_rad, options.prominence}));
  return result;
}

/// Where closed frames begin, if it is a feature of one kind.
std::optional<Anchor> startAnchor(const std::vector<Measured>& frames,
                                  const std::vector<Features>& features) {
  std::vector<Feature> starts;
  for (const Features& of_frame : features) {
    if (!of_frame.closing || of_frame.closing->kind != features[0].closing->kind)
      return std::nullopt;
    starts.push_back(*of_frame.closing);
  }
  return anchorAt(frames, starts);
}

std::vector<Anchor> featureAnchors(const std::vector<Measured>& frames,
                                   const std::vector<Features>& features,
                                   const MatchOptions& options, double near_share) {
  std::vector<std::vector<Feature>> all;
  for (const Features& of_frame : features) all.push_back(of_frame.all);
  // For each feature of the first frame its partners in the others.
  std::vector<std::vector<int>> partners(all[0].size(), std::vector<int>(frames.size(), -1));
  for (std::size_t i = 0; i < partners.size(); ++i) partners[i][0] = static_cast<int>(i);
  for (std::size_t f = 1; f < frames.size(); ++f)
    for (const auto& [i, j] : correspondingFeatures(all[0], all[f], options.reach))
      partners[i][f] = j;
  // Corners first: an extremum beside one leaves it no room.
  std::stable_sort(partners.begin(), partners.end(),
                   [&](const std::vector<int>& a, const std::vector<int>& b) {
                     return all[0][a[0]].kind < all[0][b[0]].kind;
                   });
  std::vector<Anchor> result;
  for (const std::vector<int>& partner : partners) {
    if (std::find(partner.begin(), partner.end(), -1) != partner.end()) continue;
    std::vector<Feature> partners_of_it;
    for (std::size_t f = 0; f < frames.size(); ++f)
      partners_of_it.push_back(snapped(frames[f], all[f][partner[f]], near_share));
    const Anchor anchor = anchorAt(frames, partners_of_it);
    // Joints that exist may be close together, as the corners of a blunt end.
    const bool exists = std::all_of(anchor.places.begin(), anchor.places.end(),
                                    [](const Place& place) { return place.t == 0; });
    insert(anchor, exists ? same_place : options.closeness, result);
  }
  return result;
}

/// The corner or jump at a place, if there is one.
std::optional<FeatureKind> sharpKindAt(const Features& features, const Place& place) {
  for (const Feature& feature : sharpFeatures(features))
    if (feature.place.piece == place.piece && feature.place.t == place.t) return feature.kind;
  return std::nullopt;
}

/// Whether the speeds may jump at given places: all frames have a corner or a jump there, and where
/// it is a jump in all of them, one tangent.
bool mayKink(const std::vector<Measured>& frames, const std::vector<Features>& features,
             const std::vector<Place>& places) {
  bool corner = false;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const std::optional<FeatureKind> kind = sharpKindAt(features[f], places[f]);
    if (!kind) return false;
    corner = corner || *kind == FeatureKind::Corner;
  }
  return corner || areParallel(frames, places);
}

std::vector<Anchor> givenAnchors(const std::vector<Measured>& frames, const Splines& original,
                                 const std::vector<Features>& features,
                                 const MatchOptions& options) {
  std::vector<Anchor> result;
  const bool closed = original[0].closed;
  for (std::size_t i = closed ? 1 : 0; i < options.given[0].size(); ++i) {
    Anchor anchor;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const double start = closed ? options.given[f][0] : original[f].knots.front();
      const Place place =
          frames[f].placeOf(frames[f].spline().knots.front() + (options.given[f][i] - start));
      // The difference from the start rounds.
      constexpr double rounding = 1e-9;
      const Feature at_joint =
          snapped(frames[f], {.place = place, .share = frames[f].shareAt(place)}, rounding);
      anchor.places.push_back(at_joint.place);
      anchor.shares.push_back(at_joint.share);
    }
    if (!isBetween(anchor, result.empty() ? nullptr : &result.back(), nullptr, 0))
      refuse(fmt::format("given parameter {} is at the same place as another", i));
    anchor.may_kink = mayKink(frames, features, anchor.places);
    result.push_back(std::move(anchor));
  }
  return result;
}

/// Where closed frames begin by given parameters.
Anchor givenStart(const std::vector<Measured>& frames, const std::vector<Features>& features) {
  Anchor result{.places = std::vector<Place>(frames.size()),
                .shares = std::vector<double>(frames.size(), 0)};
  result.may_kink = mayKink(frames, features, result.places);
  return result;
}

/// The piecewise linear map from the values of one list to those of another.
double mapped(double x, const std::vector<double>& from, const std::vector<double>& to) {
  const auto above = std::upper_bound(from.begin() + 1, from.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - from.begin());
  return to[i - 1] + (x - from[i - 1]) / (from[i] - from[i - 1]) * (to[i] - to[i - 1]);
}

/// The least sum of squared differences of unit vectors and others that are turned alike, by the
/// singular values of the sum of their products.
double leastDifference(const Poles& a, const Poles& b) {
  const Eigen::Matrix3d products = a.transpose() * b;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products);
  const Eigen::Vector3d& values = svd.singularValues();
  const double last = products.determinant() < 0 ? -values(2) : values(2);
  return a.squaredNorm() + b.squaredNorm() - 2 * (values(0) + values(1) + last);
}

/// How much the tangents at corresponding places of neighbouring frames differ, if the frames are
/// turned such that they differ least: the mean square of the difference.
double turnOf(const std::vector<Measured>& frames, const std::vector<Anchor>& anchors) {
  constexpr int count = 256;  // dense enough for outlines of a few dozen features
  const Scale scale = scaleOf(anchors, frames.size());
  double sum = 0;
  Poles before;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    Poles tangents(count, 3);
    for (int i = 0; i < count; ++i) {
      const double share = mapped((i + 0.5) / count, scale.common, scale.of_frame[f]);
      tangents.row(i) = tangentAt(frames[f].spline(), frames[f].placeAt(share, 1e-4)).transpose();
    }
    if (f > 0) sum += leastDifference(before, tangents);
    before = std::move(tangents);
  }
  return sum / count;
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
        f, fmt::format("frame {}: ", f),
        fmt::format("{} pieces are needed and {} possible: joints are too close together; a larger "
                    "closeness merges them",
                    count, result.segments()));
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

/// Whether the corners and jumps of all frames are alike, so that lines and arcs between them
/// correspond.
bool joinAlike(const std::vector<Features>& features) {
  const std::vector<Feature> first = sharpFeatures(features[0]);
  return std::ranges::all_of(
      features, [&](const Features& of_frame) { return areAlike(first, sharpFeatures(of_frame)); });
}

/// The anchors, or those at corners, and at jumps if all of them correspond, or none, if the
/// tangents at corresponding places differ less.
std::vector<Anchor> fittingAnchors(const std::vector<Measured>& frames,
                                   const std::vector<Anchor>& anchors, bool join_alike,
                                   MatchSummary& summary) {
  std::vector<Anchor> sharp;
  std::ranges::copy_if(anchors, std::back_inserter(sharp), [&](const Anchor& anchor) {
    return anchor.kind == MatchedKind::Corner || (join_alike && anchor.kind == MatchedKind::Jump);
  });
  const double with_all = turnOf(frames, anchors), with_sharp = turnOf(frames, sharp);
  // Less by rounding is not less. These are left out only for much less: without them frames have
  // the corners and jumps of both curves.
  constexpr double rounding = 1e-9, much_less = 0.5;
  const bool fewer = with_sharp < with_all - rounding;
  const bool none = turnOf(frames, {}) < much_less * std::min(with_all, with_sharp) - rounding;
  summary.lengths_fit_better = fewer || none;
  if (none) return {};
  return fewer ? sharp : anchors;
}

/// A share of a frame as it is given.
double givenShare(double share, std::size_t f, const MatchSummary& summary) {
  const double here = share + summary.start[f], around = here >= 1 ? here - 1 : here;
  return summary.reversed[f] && around > 0 ? 1 - around : around;
}

/// The anchors, and where closed frames start.
std::vector<MatchedPlaces> matchedPlaces(const Correspondence& all, MatchedKind start,
                                         const MatchSummary& summary) {
  const std::size_t count = all.frames.size();
  std::vector<MatchedPlaces> result;
  const auto add = [&](MatchedKind kind, const std::vector<Place>& places,
                       const std::vector<double>& shares) {
    MatchedPlaces one{.kind = kind, .points = {}, .shares = {}};
    for (std::size_t f = 0; f < count; ++f) {
      one.points.push_back(all.frames[f].point(places[f]));
      one.shares.push_back(givenShare(shares[f], f, summary));
    }
    result.push_back(std::move(one));
  };
  if (all.frames[0].spline().closed)
    add(start, std::vector<Place>(count), std::vector<double>(count, 0));
  for (const Anchor& anchor : all.anchors) add(anchor.kind, anchor.places, anchor.shares);
  return result;
}

}  // namespace

Measured measured(const BezierSpline& frame, std::size_t index) {
  return naming(index, [&] { return Measured(frame); });
}

Correspondence corresponding(const std::vector<BezierSpline>& frames, const MatchOptions& options,
                             double near_share, MatchSummary& summary) {
  requireFrames(frames);
  requireOptions(frames, options);
  for (const BezierSpline& frame : frames) summary.pieces_before.push_back(frame.segments());
  const Splines start = turned(frames, options, near_share, summary);
  Correspondence result;
  for (std::size_t f = 0; f < start.size(); ++f) result.frames.push_back(measured(start[f], f));
  const bool planar = areFlat(frames);
  if (options.by == MatchBy::Features) {
    const std::vector<Features> features = featuresOfAll(result.frames, options, planar);
    for (const Features& of_frame : features) {
      summary.features.push_back(static_cast<int>(of_frame.all.size()));
      summary.unknown_pieces += of_frame.unknown_pieces;
    }
    result.start = startAnchor(result.frames, features);
    result.anchors = featureAnchors(result.frames, features, options, near_share);
    result.anchors = fittingAnchors(result.frames, result.anchors, joinAlike(features), summary);
  }
  // The first of the given places of closed frames is their start.
  const bool starts_given =
      options.by == MatchBy::Given && frames[0].closed && !options.given[0].empty();
  if (options.by == MatchBy::Given) {
    const std::vector<Features> features = featuresOfAll(result.frames, options, planar);
    result.anchors = givenAnchors(result.frames, frames, features, options);
    if (starts_given) result.start = givenStart(result.frames, features);
  }
  summary.matched_features = static_cast<int>(result.anchors.size()) + (result.start ? 1 : 0);
  summary.pairs =
      matchedPlaces(result, result.start ? result.start->kind : MatchedKind::Start, summary);
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
  const Correspondence correspondence =
      corresponding(frames, options, std::max(options.closeness, same_place), summary);
  const std::vector<Measured>& all = correspondence.frames;
  const std::vector<Anchor>& anchors = correspondence.anchors;
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
