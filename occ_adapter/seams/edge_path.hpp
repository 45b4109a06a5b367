// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <vector>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

/// A short part of a path and its chord.
struct PathPiece {
  double from = 0, to = 0;  ///< places, 0..1
  Eigen::Vector3d start, end;
  double sagitta_mm =
      0;  ///< the path stays so close to the chord (twice the largest deviation of 3 points)

  double place(double share) const { return from + share * (to - from); }
  /// Share of the chord, 0..1, at its point nearest to p.
  double nearestShare(const Eigen::Vector3d& p) const;
  double distance(const Eigen::Vector3d& p) const {
    return (start + nearestShare(p) * (end - start) - p).norm();
  }
};

/// A free edge as its face sees it: the image of its pcurve, cut into nearly straight pieces.
///
/// Places are 0..1 of the edge's curve range. Not to be shared between threads.
class EdgePath {
 public:
  /// \throws std::runtime_error if the edge has no path on the face or one that is not finite;
  /// Standard_Failure.
  EdgePath(const Coedge& use, int edge, double gap_mm);

  const Coedge& use() const { return use_; }
  int edge() const { return edge_; }
  const FaceStrip& strip() const { return strip_; }
  const std::vector<PathPiece>& pieces() const { return pieces_; }
  std::size_t pieceAt(double place) const;

  double length_mm() const { return lengths_mm_.back(); }
  /// Arc length from the start to the place; within a piece taken as linear.
  double lengthTo_mm(double place) const;
  /// Arc length between two places, by quadrature.
  double lengthBetween_mm(double from, double to) const;
  /// The place whose chord comes nearest to p among those pieces, at least one: where to start a
  /// search.
  double nearestOnChords(const std::vector<std::size_t>& pieces, const Eigen::Vector3d& p) const;
  /// As nearestPlace(); a closed path is searched across its start.
  double nearest(const Eigen::Vector3d& p, double start) const;
  /// Unit tangent; where the path is stationary, the direction of a short chord.
  Eigen::Vector3d direction(double place) const;

 private:
  void addPieces(double from, double to, const PathPoint& start, const PathPoint& end, int depth);

  Coedge use_;
  int edge_;
  FaceStrip strip_;
  std::vector<PathPiece> pieces_;
  std::vector<double> lengths_mm_;  ///< up to the start of each piece, and the whole
  bool closed_ = false;
};

/// How far apart the path and another may be: an interval is at least 4 times as long as the paths
/// are apart.
inline double reach_mm(const EdgePath& path, double match_mm) {
  return std::min(match_mm, path.length_mm() / 4);
}

/// What is shorter is no seam, and may be left out of a path that is matched over its whole length.
inline double shortestSeam_mm(const EdgePath& path, double match_mm) {
  return std::min(4 * match_mm, path.length_mm() / 10);
}

}  // namespace seamwright::occ
