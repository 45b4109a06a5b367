// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRep_Tool.hxx>
#include <algorithm>
#include <cmath>
#include <iterator>

#include <seamwright/occ_adapter/seams/rivals.hpp>

namespace seamwright::occ {

namespace {

/// A range of parameters of a path.
struct Range {
  double low = 0, high = 0;
};

/// An interval as one of its paths sees it.
struct Claim {
  std::size_t interval = 0;
  Range on;
};

/// A part of a path to which the same intervals lay claim throughout.
struct Contest {
  struct Rival {
    double distance_mm = 0;  ///< largest over that part
    std::size_t interval = 0;
    auto operator<=>(const Rival&) const = default;
  };
  Range on;
  std::vector<Rival> rivals;  ///< by increasing distance
};

enum class Between { EdgesOfOneFace, Faces };

class Referee {
 public:
  Referee(const std::vector<EdgeInterval>& intervals, const EdgePaths& paths, double match_mm)
      : intervals_(intervals), paths_(paths), match_mm_(match_mm), lost_(intervals.size()) {}

  Settled settle(Between between);

 private:
  std::vector<Contest> contests(std::size_t path, std::vector<Claim> claims) const;
  Contest contest(std::size_t path, Range on, const std::vector<Claim>& claims) const;
  double largestDistance(const EdgeInterval& interval, std::size_t path, Range on) const;
  std::size_t otherPath(const EdgeInterval& interval, std::size_t path) const {
    return interval.path_a == path ? interval.path_b : interval.path_a;
  }
  int otherFace(std::size_t interval, std::size_t path) const {
    return paths_[otherPath(intervals_[interval], path)]->use().face;
  }
  std::vector<std::size_t> equals(std::size_t path, const Contest& contest) const;
  void decideBetweenEdges(std::size_t path, const Contest& contest);
  void decideBetweenFaces(std::size_t path, const std::vector<Contest>& contests);
  void crowd(std::size_t path, const Contest& contest);
  void lose(std::size_t interval, std::size_t path, Range on);
  bool isLongEnough(const EdgeInterval& interval) const;
  std::vector<EdgeInterval> remains(std::size_t interval) const;
  double length_mm(std::size_t path, Range on) const {
    return std::abs(paths_[path]->lengthTo_mm(on.high) - paths_[path]->lengthTo_mm(on.low));
  }

  const std::vector<EdgeInterval>& intervals_;
  const EdgePaths& paths_;
  double match_mm_;
  std::vector<std::vector<Range>> lost_;  ///< of each interval, parameters of its path a
  std::map<std::size_t, std::set<int>> crowded_;
};

double Referee::largestDistance(const EdgeInterval& interval, std::size_t path, Range on) const {
  double largest = 0;
  // Distances are interpolated between feet, of which an interval has few.
  constexpr int steps = 8;
  for (int i = 0; i <= steps; ++i) {
    const double parameter = on.low + i * (on.high - on.low) / steps;
    const double a = interval.path_a == path ? parameter : interval.aOf(parameter);
    largest = std::max(largest, interval.distanceAt_mm(a));
  }
  return largest;
}

Contest Referee::contest(std::size_t path, Range on, const std::vector<Claim>& claims) const {
  Contest contest{on, {}};
  for (const Claim& claim : claims)
    contest.rivals.push_back(
        {largestDistance(intervals_[claim.interval], path, on), claim.interval});
  std::ranges::sort(contest.rivals);
  return contest;
}

/// The rivals that are about as near as the nearest, with it.
std::vector<std::size_t> Referee::equals(std::size_t path, const Contest& contest) const {
  const Contest::Rival& winner = contest.rivals.front();
  std::vector<std::size_t> equals;
  for (const Contest::Rival& rival : contest.rivals) {
    // The least of the tolerances: a large one speaks of a fault of its own edge.
    double tolerance = BRep_Tool::Tolerance(paths_[path]->use().edge);
    for (const std::size_t interval : {rival.interval, winner.interval})
      tolerance =
          std::min(tolerance,
                   BRep_Tool::Tolerance(paths_[otherPath(intervals_[interval], path)]->use().edge));
    // Rule (4) of matchFreeEdges(): twice as far is clearly further away.
    if (rival.distance_mm <= std::max(2 * winner.distance_mm, tolerance))
      equals.push_back(rival.interval);
  }
  return equals;
}

/// The parts of a path that two intervals or more lay claim to, in order.
std::vector<Contest> Referee::contests(std::size_t path, std::vector<Claim> claims) const {
  std::ranges::sort(claims, {}, [](const Claim& claim) { return claim.on.low; });
  std::vector<double> cuts;
  for (const Claim& claim : claims) cuts.insert(cuts.end(), {claim.on.low, claim.on.high});
  std::ranges::sort(cuts);
  std::vector<Contest> contests;
  std::vector<Claim> active;
  auto next = claims.begin();
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const Range on{cuts[i - 1], cuts[i]};
    for (; next != claims.end() && next->on.low <= on.low; ++next) active.push_back(*next);
    std::erase_if(active, [&](const Claim& claim) { return claim.on.high <= on.low; });
    if (active.size() > 1 && on.high > on.low) contests.push_back(contest(path, on, active));
  }
  return contests;
}

void Referee::lose(std::size_t interval, std::size_t path, Range on) {
  const EdgeInterval& loser = intervals_[interval];
  const double low = loser.path_a == path ? on.low : loser.aOf(on.low);
  const double high = loser.path_a == path ? on.high : loser.aOf(on.high);
  lost_[interval].push_back({std::min(low, high), std::max(low, high)});
}

/// Of the edges of one face the nearest one keeps the part.
void Referee::decideBetweenEdges(std::size_t path, const Contest& contest) {
  std::set<int> seen;
  for (const Contest::Rival& rival : contest.rivals)
    if (!seen.insert(otherFace(rival.interval, path)).second)
      lose(rival.interval, path, contest.on);
}

void Referee::crowd(std::size_t path, const Contest& contest) {
  std::set<std::size_t> members = {path};
  for (const std::size_t interval : equals(path, contest)) {
    members.insert(otherPath(intervals_[interval], path));
    lose(interval, path, contest.on);
  }
  for (const std::size_t member : members)
    for (const std::size_t other : members) crowded_[member].insert(paths_[other]->use().face);
}

/// The nearest face keeps the part, unless others are as near over a length that counts.
void Referee::decideBetweenFaces(std::size_t path, const std::vector<Contest>& contests) {
  for (const Contest& contest : contests)
    for (std::size_t i = 1; i < contest.rivals.size(); ++i)
      lose(contest.rivals[i].interval, path, contest.on);
  const auto is_equal = [&](const Contest& contest) { return equals(path, contest).size() > 1; };
  for (auto first = contests.begin(); first != contests.end();) {
    first = std::find_if(first, contests.end(), is_equal);
    if (first == contests.end()) return;
    auto last = std::next(first);
    while (last != contests.end() && is_equal(*last) && last->on.low == std::prev(last)->on.high)
      ++last;
    if (length_mm(path, {first->on.low, std::prev(last)->on.high}) >=
        shortestSeam_mm(*paths_[path], match_mm_))
      std::for_each(first, last, [&](const Contest& contest) { crowd(path, contest); });
    first = last;
  }
}

bool Referee::isLongEnough(const EdgeInterval& interval) const {
  const EdgePath &a = *paths_[interval.path_a], &b = *paths_[interval.path_b];
  double least = std::min(shortestSeam_mm(a, match_mm_), shortestSeam_mm(b, match_mm_));
  // Rule (1) of matchFreeEdges().
  for (const Foot& foot : interval.feet) least = std::max(least, 4 * foot.distance_mm);
  return length_mm(interval.path_a, {interval.front().a, interval.back().a}) >= least &&
         length_mm(interval.path_b, {interval.front().b, interval.back().b}) >= least;
}

/// What is left of an interval that lost parts, as far as it is long enough.
std::vector<EdgeInterval> Referee::remains(std::size_t index) const {
  const EdgeInterval& whole = intervals_[index];
  std::vector<Range> lost = lost_[index];
  std::ranges::sort(lost, {}, &Range::low);
  lost.push_back({whole.back().a, whole.back().a});
  std::vector<EdgeInterval> left;
  double low = whole.front().a;
  for (const Range& gone : lost) {
    const Range on{low, gone.low};
    low = std::max(low, gone.high);
    if (on.high <= on.low) continue;
    const double low_b = whole.bOf(on.low), high_b = whole.bOf(on.high);
    const bool against = whole.front().against;
    EdgeInterval part{
        whole.path_a, whole.path_b, {{on.low, low_b, whole.distanceAt_mm(on.low), against}}};
    std::ranges::copy_if(whole.feet, std::back_inserter(part.feet),
                         [&](const Foot& foot) { return foot.a > on.low && foot.a < on.high; });
    part.feet.push_back({on.high, high_b, whole.distanceAt_mm(on.high), against});
    if (isLongEnough(part)) left.push_back(std::move(part));
  }
  return left;
}

Settled Referee::settle(Between between) {
  std::map<std::size_t, std::vector<Claim>> claims;
  for (std::size_t i = 0; i < intervals_.size(); ++i) {
    if (!isLongEnough(intervals_[i])) continue;
    const Foot &front = intervals_[i].front(), &back = intervals_[i].back();
    claims[intervals_[i].path_a].push_back({i, {front.a, back.a}});
    claims[intervals_[i].path_b].push_back(
        {i, {std::min(front.b, back.b), std::max(front.b, back.b)}});
  }
  for (const auto& [path, of_path] : claims) {
    const std::vector<Contest> of_parts = contests(path, of_path);
    if (between == Between::Faces)
      decideBetweenFaces(path, of_parts);
    else
      for (const Contest& contest : of_parts) decideBetweenEdges(path, contest);
  }
  Settled settled;
  for (std::size_t i = 0; i < intervals_.size(); ++i)
    for (EdgeInterval& left : remains(i)) settled.intervals.push_back(std::move(left));
  settled.crowded = std::move(crowded_);
  return settled;
}

}  // namespace

Settled settleRivals(const std::vector<EdgeInterval>& intervals, const EdgePaths& paths,
                     double match_mm) {
  // First within each face: between faces, the far edge of a narrow face would be a rival of the
  // near one.
  const std::vector<EdgeInterval> nearest =
      Referee(intervals, paths, match_mm).settle(Between::EdgesOfOneFace).intervals;
  return Referee(nearest, paths, match_mm).settle(Between::Faces);
}

}  // namespace seamwright::occ
