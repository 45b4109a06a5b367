// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <vector>

#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

namespace seamwright::occ {

/// A short part of a path and its chord.
struct PathPiece {
  double from = 0, to = 0;  ///< parameters, 0..1
  Eigen::Vector3d start, end;
  double sagitta_mm =
      0;  ///< bound of the distance from the chord: twice the largest deviation of 3 points

  double parameter(double share) const { return from + share * (to - from); }
  /// The share of the chord, 0..1, at its point nearest to p.
  double nearestShare(const Eigen::Vector3d& p) const;
  double distance(const Eigen::Vector3d& p) const {
    return (start + nearestShare(p) * (end - start) - p).norm();
  }
};

/// The image of a free edge's pcurve on its face, cut into nearly straight pieces.
///
/// Parameters are 0..1 over the range of the edge's curve. Not thread-safe.
class EdgePath {
 public:
  /// \throws GeometryError if the edge has no pcurve, or one that is not finite;
  /// Standard_Failure.
  EdgePath(const Coedge& use, int edge, double gap_mm);

  const Coedge& use() const { return use_; }
  int edge() const { return edge_; }
  const FaceStrip& strip() const { return strip_; }
  const std::vector<PathPiece>& pieces() const { return pieces_; }
  std::size_t pieceAt(double parameter) const;

  double length_mm() const { return lengths_mm_.back(); }
  /// Arc length from the start to the parameter, linear within a piece.
  double lengthTo_mm(double parameter) const;
  /// Arc length between two parameters, by quadrature.
  double lengthBetween_mm(double from, double to) const;
  /// The parameter of the point nearest to p on the chords of these pieces (at least one): where a
  /// search starts.
  double nearestOnChords(const std::vector<std::size_t>& pieces, const Eigen::Vector3d& p) const;
  /// As nearestParameter(), on a closed path also across its start.
  double nearest(const Eigen::Vector3d& p, double start) const;
  /// Unit tangent; where the path is stationary, the direction of a short chord.
  Eigen::Vector3d direction(double parameter) const;

 private:
  void addPieces(double from, double to, const PathPoint& start, const PathPoint& end, int depth);

  Coedge use_;
  int edge_;
  FaceStrip strip_;
  std::vector<PathPiece> pieces_;
  std::vector<double> lengths_mm_;  ///< to the start of each piece, and the whole length
  bool closed_ = false;
};

/// Largest distance from another path in a seam: an interval is at least 4 times as long as its
/// paths are apart.
inline double reach_mm(const EdgePath& path, double match_mm) {
  return std::min(match_mm, path.length_mm() / 4);
}

/// The least length of a seam. Shorter intervals may be missing from a path that is matched over
/// its whole length.
inline double shortestSeam_mm(const EdgePath& path, double match_mm) {
  return std::min(4 * match_mm, path.length_mm() / 10);
}

}  // namespace seamwright::occ
