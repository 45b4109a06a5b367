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

/// How far a side has come at equal shares of its length: length plus turning, each over that of the hole.
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
      come_[k] = at(k) * length_mm_ / length_mm + (turning_rad > 0 ? turning_[k] / turning_rad : 0);
  }
  double total() const { return come_[count]; }

  /// Where it turns most.
  double bent() const {
    int most = 0;
    for (int k = 1; k < count; ++k)
      if (turning_[k + 1] - turning_[k] > turning_[most + 1] - turning_[most]) most = k;
    return (come_[most] + come_[most + 1]) / 2;
  }

  /// Of a loop, any number of times around.
  double shareAround(double come) const {
    const double rounds = std::floor(come / total());
    return rounds + shareAt(come - rounds * total());
  }

  double shareAt(double come) const {
    const auto after = std::upper_bound(come_.begin() + 1, come_.end() - 1, come);
    const int k = static_cast<int>(after - come_.begin()) - 1;
    return (k + (come - come_[k]) / (come_[k + 1] - come_[k])) / count;
  }

 private:
  static constexpr int count = 128;
  static double at(int k) { return static_cast<double>(k) / count; }

  double length_mm_;
  std::array<double, count + 1> turning_{}, come_{};
};

std::vector<Progression> progressionsOf(const std::vector<SidePath>& paths) {
  std::vector<Progression> progressions;
  double length_mm = 0, turning_rad = 0;
  for (const SidePath& path : paths) {
    progressions.emplace_back(path);
    length_mm += progressions.back().length_mm();
    turning_rad += progressions.back().turning_rad();
  }
  // Straight sides turn by rounding.
  if (turning_rad < 1e-9) turning_rad = 0;
  for (Progression& one : progressions) one.relateTo(length_mm, turning_rad);
  return progressions;
}

/// Numbers of parts of each side.
std::vector<int> partsOf(const std::vector<Progression>& progressions, std::size_t count) {
  std::vector<int> parts(progressions.size(), 1);
  for (std::size_t k = progressions.size(); k < count; ++k) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (progressions[i].total() / parts[i] > (1 + 1e-9) * progressions[longest].total() / parts[longest])
        longest = i;
    ++parts[longest];
  }
  return parts;
}

/// Joints at which the curvature of the path jumps, as between a line and an arc: no polynomial goes across them well.
std::vector<double> bendJoints(const SidePath& path) {
  constexpr double step = 1.0 / 256, least_jump = 0.1;
  std::vector<double> joints;
  for (const double at : path.joints()) {
    const auto turn = [&](double from, double to) {
      const Vector3d a = path.atShare(std::max(0.0, from), true).derivative,
                     b = path.atShare(std::min(1.0, to), false).derivative;
      return std::atan2(a.cross(b).norm(), a.dot(b));
    };
    const double before = turn(at - step, at), after = turn(at, at + step);
    if (std::abs(before - after) > least_jump * std::max(before, after) + 1e-9) joints.push_back(at);
  }
  return joints;
}

/// The nearest joint to each cut, each at most once, nearer than a third of the mean stretch.
void moveToJoints(std::vector<double>& cuts, std::vector<double> joints, std::size_t parts) {
  for (double& cut : cuts) {
    if (joints.empty()) return;
    const auto nearest = std::ranges::min_element(joints, {}, [&](double at) { return std::abs(at - cut); });
    if (std::abs(*nearest - cut) > 1 / (3.0 * static_cast<double>(parts))) continue;
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

}  // namespace

std::vector<SideStretch> wholeSides(const Hole& hole) {
  std::vector<SideStretch> stretches;
  for (std::size_t k = 0; k < hole.sides.size(); ++k) stretches.push_back({k, 0, 1, !hole.has_corners});
  return stretches;
}

std::vector<SideStretch> cutSides(const Hole& hole, std::size_t count, double gap_mm, bool at_joints) {
  const std::vector<SidePath> paths = pathsOf(hole, gap_mm);
  const std::vector<Progression> progressions = progressionsOf(paths);
  const std::vector<int> parts = partsOf(progressions, count);
  std::vector<SideStretch> stretches;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    std::vector<double> cuts;
    for (int part = 1; part < parts[k]; ++part)
      cuts.push_back(progressions[k].shareAt(progressions[k].total() * part / parts[k]));
    if (at_joints) moveToJoints(cuts, bendJoints(paths[k]), static_cast<std::size_t>(parts[k]));
    cuts.push_back(1);
    double begin = 0;
    for (const double end : cuts) {
      stretches.push_back({k, begin, end, begin > 0 || !hole.has_corners});
      begin = end;
    }
  }
  return stretches;
}

std::vector<SideStretch> cutLoop(const Hole& hole, std::size_t count, double gap_mm, double shift) {
  const Progression loop = progressionsOf(pathsOf(hole, gap_mm)).front();
  const double part = loop.total() / static_cast<double>(count);
  const auto cut = [&](std::size_t k) {
    return loop.shareAround(std::fmod(loop.bent() + shift * part, loop.total()) +
                            static_cast<double>(k) * part);
  };
  std::vector<SideStretch> stretches;
  for (std::size_t k = 0; k < count; ++k) {
    const double rounds = std::floor(cut(k));
    stretches.push_back({0, cut(k) - rounds, (k + 1 == count ? cut(0) + 1 : cut(k + 1)) - rounds, true});
  }
  return stretches;
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
