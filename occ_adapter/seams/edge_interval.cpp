// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <seamwright/occ_adapter/seams/edge_interval.hpp>

namespace seamwright::occ {

namespace {

/// Two feet that should be one may differ by this: the descent to the nearest point ends with steps
/// of 1e-13 of the range, and its foot is stationary only to the root of rounding.
double roundingLength(const EdgePath& path) {
  return 1e-9 * path.length_mm();
}

/// Linear interpolation between the feet on either side of where \p key has the value; key
/// increases, or decreases.
template <class Key, class Value>
double interpolate(const std::vector<Foot>& feet, const Key& key, const Value& value, double at) {
  const bool rises = key(feet.back()) >= key(feet.front());
  const auto after = std::lower_bound(
      feet.begin() + 1, feet.end() - 1, at,
      [&](const Foot& foot, double x) { return rises ? key(foot) < x : key(foot) > x; });
  const Foot &left = *(after - 1), &right = *after;
  const double width = key(right) - key(left);
  const double share = width == 0 ? 0 : std::clamp((at - key(left)) / width, 0.0, 1.0);
  return value(left) + share * (value(right) - value(left));
}

}  // namespace

double EdgeInterval::bOf(double a) const {
  return interpolate(
      feet, [](const Foot& f) { return f.a; }, [](const Foot& f) { return f.b; }, a);
}

double EdgeInterval::aOf(double b) const {
  return interpolate(
      feet, [](const Foot& f) { return f.b; }, [](const Foot& f) { return f.a; }, b);
}

double EdgeInterval::distanceAt_mm(double a) const {
  return interpolate(
      feet, [](const Foot& f) { return f.a; }, [](const Foot& f) { return f.distance_mm; }, a);
}

PairWalk::PairWalk(const EdgePath& a, const EdgePath& b, const ClosePieces& close, double match_mm)
    : a_(a), b_(b), match_mm_(match_mm), near_(a.pieces().size()) {
  for (const auto& [i, j] : close) near_[i].push_back(j);
}

/// Where something may begin or end: the ends of the close pieces of a, and what is nearest to the
/// ends of those of b.
std::vector<double> PairWalk::events() const {
  std::vector<double> events;
  std::map<std::size_t, std::vector<std::size_t>> by_b;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    if (near_[i].empty()) continue;
    for (const double share : {0.0, 1.0}) events.push_back(a_.pieces()[i].parameter(share));
    for (const std::size_t j : near_[i]) by_b[j].push_back(i);
  }
  for (const auto& [j, close] : by_b)
    for (const double share : {0.0, 1.0}) {
      const Eigen::Vector3d p = b_.strip().trace(b_.pieces()[j].parameter(share)).p;
      events.push_back(a_.nearest(p, a_.nearestOnChords(close, p)));
    }
  std::ranges::sort(events);
  // Ends of pieces that follow each other are computed twice.
  const auto same = [](double s, double t) { return t - s < 1e-12; };
  events.erase(std::unique(events.begin(), events.end(), same), events.end());
  return events;
}

/// Whether p lies beyond the end of b by more than rounding or a thousandth of the distance.
bool PairWalk::overhangs(const Foot& foot, const Eigen::Vector3d& p) const {
  if (foot.b > 0 && foot.b < 1) return false;
  const double along = std::abs((p - b_.strip().trace(foot.b).p).dot(b_.direction(foot.b)));
  // 1e-11 of the length covers the rounding of points up to some hundred lengths from the origin.
  return along > 1e-3 * foot.distance_mm + 1e-11 * b_.length_mm();
}

std::optional<Foot> PairWalk::footAt(double parameter) const {
  const std::size_t piece = a_.pieceAt(parameter);
  const Eigen::Vector3d p = a_.strip().trace(parameter).p;
  const std::vector<std::size_t>* close = &near_[piece];
  // At the end of a piece the one before may be the one that is close.
  if (close->empty() && piece > 0 && parameter - a_.pieces()[piece].from < 1e-9)
    close = &near_[piece - 1];
  if (close->empty()) return std::nullopt;
  Foot foot{parameter, b_.nearest(p, b_.nearestOnChords(*close, p)), 0, false};
  foot.distance_mm = (b_.strip().trace(foot.b).p - p).norm();
  const double cosine = a_.direction(parameter).dot(b_.direction(foot.b));
  foot.against = cosine < 0;
  const bool beside = foot.distance_mm <= match_mm_ && std::abs(cosine) >= std::numbers::sqrt2 / 2;
  return beside && !overhangs(foot, p) ? std::optional(foot) : std::nullopt;
}

/// Whether b went on, in its own sense, by about as much as a did.
bool PairWalk::continues(const Foot& from, const Foot& to) const {
  if (from.against != to.against) return false;
  const double along_a = std::abs(a_.lengthTo_mm(to.a) - a_.lengthTo_mm(from.a));
  const bool onward = to.a >= from.a;
  const double along_b =
      (b_.lengthTo_mm(to.b) - b_.lengthTo_mm(from.b)) * (from.against == onward ? -1 : 1);
  const double rounding = roundingLength(a_) + roundingLength(b_);
  // Paths within 45 degrees of one another differ in length by a factor of up to the root of 2 on
  // straight pieces, more on bent ones. Three times as much is a jump to another branch of b.
  return along_b >= -rounding && along_b <= 3 * along_a + rounding;
}

/// The foot furthest from a good one toward a parameter that has none any more.
std::optional<Foot> PairWalk::lastBefore(const Foot& good, double bad) const {
  std::optional<Foot> last;
  double low = good.a, high = bad;
  // To 2^-40, 1e-12 of the path: as near as feet are told apart.
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    const std::optional<Foot> foot = footAt(middle);
    const bool goes_on = foot && continues(last.value_or(good), *foot);
    (goes_on ? low : high) = middle;
    if (goes_on) last = foot;
  }
  return last;
}

/// Adds the next foot, and one halfway, if the paths run side by side up to there.
bool PairWalk::join(std::vector<Foot>& feet, const Foot& next) const {
  if (!continues(feet.back(), next)) return false;
  const std::optional<Foot> half = footAt(0.5 * (feet.back().a + next.a));
  if (!half || !continues(feet.back(), *half) || !continues(*half, next)) return false;
  feet.push_back(*half);
  feet.push_back(next);
  return true;
}

std::vector<std::vector<Foot>> PairWalk::intervals() const {
  std::vector<std::vector<Foot>> found;
  std::vector<Foot> feet;
  const auto finish = [&](double bad) {
    if (feet.empty()) return;
    if (const std::optional<Foot> last = lastBefore(feet.back(), bad)) feet.push_back(*last);
    if (feet.size() > 1) found.push_back(std::move(feet));
    feet.clear();
  };
  double before = 0;
  for (const double parameter : events()) {
    const std::optional<Foot> foot = footAt(parameter);
    if (!foot) {
      finish(parameter);
    } else if (feet.empty() || !join(feet, *foot)) {
      finish(parameter);
      if (parameter > before)
        if (const std::optional<Foot> first = lastBefore(*foot, before)) feet.push_back(*first);
      feet.push_back(*foot);
    }
    before = parameter;
  }
  finish(1);
  return found;
}

}  // namespace seamwright::occ
