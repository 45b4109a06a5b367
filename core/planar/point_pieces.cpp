// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/free_arcs.hpp>
#include <seamwright/core/planar/point_pieces.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// The line with the least squared distances from points, in the middle of the band that holds
/// them.
struct PointLine {
  TouchPoint line;
  double off_mm = 0;
};

PointLine lineThrough(const std::vector<Vector2d>& points, const Vector2d& beside) {
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d& point : points) centre += point / static_cast<double>(points.size());
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const Vector2d& point : points) squares += (point - centre) * (point - centre).transpose();
  const double direction_rad = std::atan2(2 * squares(0, 1), squares(0, 0) - squares(1, 1)) / 2;
  PointLine found{.line = {.point = beside, .direction_rad = direction_rad}};
  if (found.line.tangent().dot(points.back() - points.front()) < 0)
    found.line.direction_rad += std::numbers::pi;
  double low_mm = infinite, high_mm = -infinite;
  for (const Vector2d& point : points) {
    const double left_mm = (point - beside).dot(found.line.normal());
    low_mm = std::min(low_mm, left_mm);
    high_mm = std::max(high_mm, left_mm);
  }
  found.line.point += (low_mm + high_mm) / 2 * found.line.normal();
  found.off_mm = (high_mm - low_mm) / 2;
  return found;
}

/// The points of a sequence, divided.
class DividedPoints {
 public:
  DividedPoints(const std::vector<Vector2d>& points, const PointPieceOptions& options)
      : points_(points), options_(options), n_(static_cast<int>(points.size())) {
    // From the end of a piece on, so that the first piece is whole.
    const int begin = options.closed ? (freeArcEnds(points, options.noise_mm).front() + 1) % n_ : 0;
    starts_ = {begin};
    for (const int end : freeArcEnds(from(begin, n_), options.noise_mm))
      starts_.push_back(begin + end + 1);
  }

  int count() const { return static_cast<int>(starts_.size()) - 1; }

  /// Pieces reach as far as the noise allows, so that the last ones can be parts of one.
  void merge() {
    for (int i = 0; i + 1 < count();)
      if (isOne(starts_[i], starts_[i + 2]))
        starts_.erase(starts_.begin() + i + 1);
      else
        ++i;
    if (!options_.closed || count() < 3) return;
    const int last = starts_[count() - 1];
    if (!isOne(last, starts_[1] + n_)) return;
    starts_.pop_back();
    starts_.front() = last - n_;
  }

  /// Moves the ends of pieces to where the points become nearer to the next one.
  void settle() {
    if (count() < 2) return;
    std::vector<TouchPoint> circles;
    for (int i = 0; i < count(); ++i) circles.push_back(pieceAt(i).circle);
    const std::vector<int> before = starts_;
    for (int i = options_.closed ? 0 : 1; i < count(); ++i) {
      const int last = i > 0 ? i - 1 : count() - 1, shift = i > 0 ? 0 : n_;
      const int from = (before[last] + before[last + 1]) / 2 - shift,
                to = (before[i] + before[i + 1]) / 2;
      starts_[i] = nearestCut(circles[last], circles[i], from + 1, to);
    }
    if (options_.closed) starts_.back() = starts_.front() + n_;
  }

  std::vector<PointPiece> pieces() const {
    std::vector<PointPiece> result;
    for (int i = 0; i < count(); ++i) result.push_back(pieceAt(i));
    return result;
  }

 private:
  const Vector2d& at(int i) const { return points_[static_cast<std::size_t>((i + n_) % n_)]; }
  std::vector<Vector2d> from(int first, int count) const {
    std::vector<Vector2d> result;
    for (int i = first; i < first + count; ++i) result.push_back(at(i));
    return result;
  }
  bool isOne(int first, int end) const {
    return end - first <= n_ &&
           freeArcEnds(from(first, end - first), options_.noise_mm).size() == 1;
  }
  PointPiece pieceAt(int i) const {
    PointPiece piece{.first = starts_[i], .last = starts_[i + 1] - 1, .circle = {}};
    // Ends can belong to the neighbours; of few points, these have one each.
    constexpr int share = 8, few = 4;
    int first = piece.first + piece.count() / share, last = piece.last - piece.count() / share;
    const std::vector<Vector2d> own = from(first, last - first + 1);
    if (piece.count() < few) {
      first = options_.closed ? first - 1 : std::max(0, first - 1);
      last = options_.closed ? last + 1 : std::min(n_ - 1, last + 1);
    }
    const std::vector<Vector2d> inside = from(first, last - first + 1);
    const Vector2d& middle = at((piece.first + piece.last) / 2);
    const PointLine line = lineThrough(own, middle);
    piece.off_line_mm = line.off_mm;
    piece.circle = line.line;
    if (line.off_mm <= options_.line_mm) return piece;
    const ArcStart found = nearestCircle(inside, middle);
    piece.circle = {.point = found.point,
                    .direction_rad = found.direction_rad,
                    .curvature_per_mm = found.curvature_per_mm};
    const int centre = (first + last) / 2;
    if (piece.circle.tangent().dot(at(centre + 1) - at(centre - 1)) < 0) {
      piece.circle.direction_rad += std::numbers::pi;
      piece.circle.curvature_per_mm = -piece.circle.curvature_per_mm;
    }
    return piece;
  }
  /// The first point of the second piece with the least sum of squared distances.
  int nearestCut(const TouchPoint& a, const TouchPoint& b, int from, int to) const {
    double sum = 0, least = 0;
    int best = from;
    for (int i = from; i < to; ++i) {
      const double of_a = a.distance_mm(at(i)), of_b = b.distance_mm(at(i));
      sum += of_a * of_a - of_b * of_b;
      if (sum < least) {
        least = sum;
        best = i + 1;
      }
    }
    return best;
  }

  const std::vector<Vector2d>& points_;
  const PointPieceOptions& options_;
  int n_;
  std::vector<int> starts_;  ///< of the pieces, and where one after the last one would begin
};

}  // namespace

std::vector<PointPiece> pointPieces(const std::vector<Vector2d>& points,
                                    const PointPieceOptions& options) {
  DividedPoints divided(points, options);
  // Merging can join two of them.
  if (divided.count() > options.fewer_than) return {};
  constexpr int rounds = 4;
  for (int i = 0; i < rounds; ++i) {
    divided.merge();
    divided.settle();
  }
  if (divided.count() >= options.fewer_than) return {};
  return divided.pieces();
}

}  // namespace seamwright
