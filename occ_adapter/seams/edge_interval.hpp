// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <seamwright/occ_adapter/seams/edge_path.hpp>

namespace seamwright::occ {

/// A parameter of one path, that of the nearest point of another path, and their distance.
struct Foot {
  double a = 0;
  double b = 0;
  double distance_mm = 0;
  bool against = false;  ///< b runs against a
};

/// Two paths that run side by side: a increases and b increases or decreases from foot to foot.
struct EdgeInterval {
  std::size_t path_a = 0;
  std::size_t path_b = 0;
  std::vector<Foot> feet;  ///< at least two

  const Foot& front() const { return feet.front(); }
  const Foot& back() const { return feet.back(); }
  /// The parameter of b for one of a, and the reverse; linear between feet.
  double bOf(double a) const;
  double aOf(double b) const;
  /// Distance at a parameter of a, linear between feet.
  double distanceAt_mm(double a) const;
};

/// Numbers of pieces of two paths that are close to each other.
using ClosePieces = std::vector<std::pair<std::size_t, std::size_t>>;

/// Finds where path b runs within a distance of path a and within 45 degrees of its direction.
class PairWalk {
 public:
  PairWalk(const EdgePath& a, const EdgePath& b, const ClosePieces& close, double match_mm);

  /// The intervals in the order of a, however short. They end where the distance or the angle is
  /// exceeded, or where either path ends. Closed paths end at their start.
  std::vector<std::vector<Foot>> intervals() const;

 private:
  std::vector<double> events() const;
  std::optional<Foot> footAt(double parameter) const;
  bool overhangs(const Foot& foot, const Eigen::Vector3d& p) const;
  bool continues(const Foot& from, const Foot& to) const;
  bool join(std::vector<Foot>& feet, const Foot& next) const;
  std::optional<Foot> lastBefore(const Foot& good, double bad) const;

  const EdgePath& a_;
  const EdgePath& b_;
  double match_mm_;
  std::vector<std::vector<std::size_t>> near_;  ///< by piece of a: the pieces of b that are close
};

}  // namespace seamwright::occ
