// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/occ_adapter/fill/side_cut.hpp>
#include <seamwright/occ_adapter/fill/side_path.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// The progress along a side at equal shares of its length: the sum of length and turning, each
/// over that of the hole.
class Progression {
 public:
  explicit Progression(const SidePath& path) : length_mm_(path.length_mm()) {
    Vector3d last = path.atShare(0, true).derivative.normalized();
    for (int k = 1; k <= count; ++k) {
      const Vector3d tangent = path.atShare(at(k), k < count).derivative.normalized();
      turning_[k] = turning_[k - 1] + std::atan2(last.cross(tangent).norm(), last.dot(tangent));
      last = tangent;
    }
  }

  double length_mm() const { return length_mm_; }
  double turning_rad() const { return turning_[count]; }
  void relateTo(double length_mm, double turning_rad) {
    for (int k = 0; k <= count; ++k)
      progress_[k] =
          at(k) * length_mm_ / length_mm + (turning_rad > 0 ? turning_[k] / turning_rad : 0);
  }
  double total() const { return progress_[count]; }

  /// The progress at which the side turns most.
  double atSharpestTurn() const {
    int most = 0;
    for (int k = 1; k < count; ++k)
      if (turning_[k + 1] - turning_[k] > turning_[most + 1] - turning_[most]) most = k;
    return (progress_[most] + progress_[most + 1]) / 2;
  }

  /// The share of a loop's length at a progress, for any number of turns around the loop.
  double shareAround(double progress) const {
    const double rounds = std::floor(progress / total());
    return rounds + shareAt(progress - rounds * total());
  }

  double progressAt(double share) const {
    const int k = std::min(static_cast<int>(share * count), count - 1);
    return progress_[k] + (share * count - k) * (progress_[k + 1] - progress_[k]);
  }

  double shareAt(double progress) const {
    const auto after = std::upper_bound(progress_.begin() + 1, progress_.end() - 1, progress);
    const int k = static_cast<int>(after - progress_.begin()) - 1;
    return (k + (progress - progress_[k]) / (progress_[k + 1] - progress_[k])) / count;
  }

 private:
  /// A choice: cuts are moved to joints within a third of a part, so hundredths of a side suffice.
  static constexpr int count = 128;
  static double at(int k) { return static_cast<double>(k) / count; }

  double length_mm_;
  std::array<double, count + 1> turning_{}, progress_{};
};

std::vector<Progression> progressionsOf(const std::vector<SidePath>& paths) {
  std::vector<Progression> progressions;
  double length_mm = 0, turning_rad = 0;
  for (const SidePath& path : paths) {
    progressions.emplace_back(path);
    length_mm += progressions.back().length_mm();
    turning_rad += progressions.back().turning_rad();
  }
  // Straight sides have a turning from rounding, which does not count.
  if (turning_rad < 1e-9) turning_rad = 0;
  for (Progression& one : progressions) one.relateTo(length_mm, turning_rad);
  return progressions;
}

/// The number of parts of each side.
std::vector<int> partCounts(const std::vector<Progression>& progressions, std::size_t count) {
  std::vector<int> parts(progressions.size(), 1);
  for (std::size_t k = progressions.size(); k < count; ++k) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (progressions[i].total() / parts[i] >
          (1 + 1e-9) * progressions[longest].total() / parts[longest])
        longest = i;
    ++parts[longest];
  }
  return parts;
}

/// The jump of the turning at a share of the length: the difference of the turnings on short
/// intervals before and after it. It is 0 if this is too small to be a jump. At share 0 the
/// interval before is the end of the path.
double turningJump(const SidePath& path, double at) {
  // Over so short a step the turning of a smooth path hardly changes, and it is still far above
  // rounding. A jump below a tenth of the turning does not count. Both are choices.
  constexpr double most_step = 1.0 / 256, least_jump = 0.1;
  const double end = at > 0 ? at : 1, step = std::min({most_step, end, 1 - at});
  const auto turn = [&](double from, double to) {
    const Vector3d a = path.atShare(from, true).derivative, b = path.atShare(to, false).derivative;
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  const double before = turn(end - step, end), after = turn(at, at + step);
  const double jump = std::abs(before - after);
  return jump > least_jump * std::max(before, after) + 1e-9 ? jump : 0;
}

/// Joints at which the curvature of the path jumps, as between a line and an arc. Polynomials fit
/// badly across them.
std::vector<double> jointsWithJump(const SidePath& path) {
  std::vector<double> joints = path.joints();
  std::erase_if(joints, [&](double at) { return turningJump(path, at) == 0; });
  return joints;
}

/// Moves each cut to the nearest joint no further than \p reach. Each joint is used at most once.
void moveToJoints(std::vector<double>& cuts, std::vector<double> joints, double reach) {
  for (double& cut : cuts) {
    if (joints.empty()) return;
    const auto nearest =
        std::ranges::min_element(joints, {}, [&](double at) { return std::abs(at - cut); });
    if (std::abs(*nearest - cut) > reach) continue;
    cut = *nearest;
    joints.erase(nearest);
  }
  std::ranges::sort(cuts);
}

std::vector<SidePath> pathsOf(const Hole& hole, double gap_mm) {
  std::vector<SidePath> paths;
  for (const HoleSide& side : hole.sides) paths.emplace_back(side, gap_mm);
  return paths;
}

/// Finds where to cut a smooth loop, as shares of its length.
class LoopCutter {
 public:
  LoopCutter(const Hole& hole, std::size_t count, double gap_mm)
      : side_(hole.sides.front()),
        count_(count),
        path_(side_, gap_mm),
        progression_(progressionsOf({path_}).front()),
        joints_(path_.joints()) {
    joints_.insert(joints_.begin(), 0);
  }

  /// Joints at which the curvature jumps by no less than a fifth of the largest jump.
  std::vector<double> curvatureJumps() const {
    std::vector<double> jumps;
    for (const double at : joints_) jumps.push_back(turningJump(path_, at));
    const double most = std::ranges::max(jumps);
    std::vector<double> joints;
    for (std::size_t k = 0; k < jumps.size(); ++k)
      if (jumps[k] > 0 && jumps[k] >= most / 5) joints.push_back(joints_[k]);
    return joints;
  }

  /// Joints at which the hole passes from one face to another.
  std::vector<double> faceJoints() const {
    std::vector<double> between;
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      const std::size_t before = (k + joints_.size() - 1) % joints_.size();
      if (side_.edges[before].use.face != side_.edges[k].use.face) between.push_back(joints_[k]);
    }
    return between;
  }

  /// The share that lies \p shift intervals after the point where the loop turns most.
  double shareAfterSharpestTurn(double shift) const {
    return progression_.shareAround(progression_.atSharpestTurn() +
                                    shift * progression_.total() / static_cast<double>(count_));
  }

  /// Cuts the loop. The first interval begins at \p begin, or at a joint if only a sliver would be
  /// left between. The others end at the given joints where these are near, or at any joint to
  /// which only a sliver would be left.
  std::vector<SideInterval> cut(double begin, std::vector<double> joints) const {
    // In intervals, as choices: below a half, so that cuts keep their order and parts their size;
    // and a part so short that a patch of its own would be a strip.
    constexpr double near = 1 / 3.0, sliver = 1 / 20.0;
    begin = atNearJoint(begin, sliver);
    std::vector<double> cuts;
    const double first = progression_.progressAt(begin);
    for (std::size_t k = 1; k < count_; ++k)
      cuts.push_back(
          progression_.shareAround(first + progression_.total() * static_cast<double>(k) /
                                               static_cast<double>(count_)) -
          begin);
    moveToJoints(cuts, after(begin, std::move(joints)), near / static_cast<double>(count_));
    moveToJoints(cuts, after(begin, joints_), sliver / static_cast<double>(count_));
    cuts.push_back(1);
    std::vector<SideInterval> intervals;
    double last = 0;
    for (const double next : cuts) {
      const double rounds = std::floor(begin + last);
      intervals.push_back({0, begin + last - rounds, begin + next - rounds, true});
      last = next;
    }
    return intervals;
  }

 private:
  /// The joint nearest to a share if it is within so many intervals; otherwise the share.
  double atNearJoint(double at, double intervals) const {
    at -= std::floor(at);
    double nearest = at, reach = intervals / static_cast<double>(count_);
    for (const double joint : joints_)
      for (const double same : {joint, joint + 1})
        if (std::abs(same - at) < reach) nearest = joint, reach = std::abs(same - at);
    return nearest;
  }

  /// Joints relative to the begin, in (0, 1).
  static std::vector<double> after(double begin, std::vector<double> joints) {
    for (double& joint : joints) joint -= begin + std::floor(joint - begin);
    std::erase_if(joints, [](double joint) { return !(joint > 0); });
    return joints;
  }

  const HoleSide& side_;
  std::size_t count_;
  SidePath path_;
  Progression progression_;
  std::vector<double> joints_;  ///< joints of the loop, its begin included
};

}  // namespace

std::vector<SideInterval> wholeSides(const Hole& hole) {
  std::vector<SideInterval> intervals;
  for (std::size_t k = 0; k < hole.sides.size(); ++k)
    intervals.push_back({k, 0, 1, !hole.has_corners});
  return intervals;
}

std::vector<SideInterval> cutSides(const Hole& hole, std::size_t count, double gap_mm,
                                   bool at_joints) {
  const std::vector<SidePath> paths = pathsOf(hole, gap_mm);
  const std::vector<Progression> progressions = progressionsOf(paths);
  const std::vector<int> parts = partCounts(progressions, count);
  std::vector<SideInterval> intervals;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    std::vector<double> cuts;
    for (int part = 1; part < parts[k]; ++part)
      cuts.push_back(progressions[k].shareAt(progressions[k].total() * part / parts[k]));
    if (at_joints) moveToJoints(cuts, jointsWithJump(paths[k]), 1 / (3.0 * parts[k]));
    cuts.push_back(1);
    double begin = 0;
    for (const double end : cuts) {
      intervals.push_back({k, begin, end, begin > 0 || !hole.has_corners});
      begin = end;
    }
  }
  return intervals;
}

std::vector<std::vector<SideInterval>> loopCuts(const Hole& hole, std::size_t count,
                                                double gap_mm) {
  const LoopCutter loop(hole, count, gap_mm);
  std::vector<std::vector<SideInterval>> cuts;
  for (const std::vector<double>& joints : {loop.curvatureJumps(), loop.faceJoints()})
    if (!joints.empty()) cuts.push_back(loop.cut(joints.front(), joints));
  for (const double shift : {0.0, 0.5})
    cuts.push_back(loop.cut(loop.shareAfterSharpestTurn(shift), {}));
  return cuts;
}

HoleAngle sharpestTurn(const Hole& hole, double gap_mm) {
  HoleAngle sharpest{0, Eigen::Vector3d::Zero(), {}};
  for (const HoleSide& side : hole.sides) {
    const SidePath path(side, gap_mm);
    std::vector<double> joints = path.joints();
    if (!hole.has_corners) joints.push_back(0);
    for (const double at : joints) {
      const SideSample in = path.atShare(at > 0 ? at : 1, false), out = path.atShare(at, true);
      const double turn_rad =
          std::atan2(in.derivative.cross(out.derivative).norm(), in.derivative.dot(out.derivative));
      if (turn_rad > sharpest.angle_rad)
        sharpest = {turn_rad, out.point, {path.edgeAt(at > 0 ? at - 1e-9 : 1), path.edgeAt(at)}};
    }
  }
  return sharpest;
}

std::vector<HoleAngle> anglesOf(const Hole& hole, double gap_mm) {
  std::vector<HoleAngle> angles;
  if (!hole.has_corners) return angles;
  const std::vector<SidePath> paths = pathsOf(hole, gap_mm);
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::size_t before = (k + paths.size() - 1) % paths.size();
    const SideSample in = paths[before].atShare(1, false), out = paths[k].atShare(0, true);
    const Vector3d arriving = in.derivative.normalized(), leaving = out.derivative.normalized();
    const Vector3d up = in.beyond.cross(arriving) + out.beyond.cross(leaving);
    const Vector3d across = arriving.cross(leaving);
    const double turn = std::atan2(across.norm(), arriving.dot(leaving));
    HoleAngle angle{std::numbers::pi + (across.dot(up) < 0 ? turn : -turn), out.point};
    angle.edges = {hole.sides[before].edges.back().edge, hole.sides[k].edges.front().edge};
    angles.push_back(angle);
  }
  return angles;
}

}  // namespace seamwright::occ
