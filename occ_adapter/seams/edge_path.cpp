// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>
#include <seamwright/occ_adapter/seams/edge_path.hpp>

namespace seamwright::occ {

namespace {

/// A choice: bends of a smooth path show at the samples of an eighth of it.
constexpr int least_pieces = 8;
/// A deviation of a fiftieth of the chord is a turn of about 9 degrees.
constexpr double largest_bend = 0.02;
/// A bound of the work at kinks and cusps: a piece is at least 1 / 256 of a first one.
constexpr int most_halvings = 8;

/// 0, the breaks of the path apart from one another, 1, and points between them, so that there are
/// enough pieces.
std::vector<double> firstCuts(const FaceStrip& strip) {
  std::vector<double> breaks = strip.breaks();
  std::ranges::sort(breaks);
  std::vector<double> cuts = {0};
  // Of the range. Breaks that are nearer come from one knot, rounded in different ways, and a piece
  // between them would be a point.
  constexpr double apart = 1e-6;
  for (const double s : breaks)
    if (s > cuts.back() + apart && s < 1 - apart) cuts.push_back(s);
  for (int i = 1; i <= least_pieces; ++i) cuts.push_back(static_cast<double>(i) / least_pieces);
  std::ranges::sort(cuts);
  const auto close = [](double a, double b) { return b - a < apart; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), close), cuts.end());
  cuts.back() = 1;
  return cuts;
}

}  // namespace

double PathPiece::nearestShare(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d chord = end - start;
  const double square = chord.squaredNorm();
  return square > 0 ? std::clamp((p - start).dot(chord) / square, 0.0, 1.0) : 0;
}

EdgePath::EdgePath(const Coedge& use, int edge, double gap_mm)
    : use_(use), edge_(edge), strip_(use, pcurveOf(use.edge, use.shape, gap_mm)) {
  const std::vector<double> cuts = firstCuts(strip_);
  PathPoint start = strip_.trace(0);
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const PathPoint end = strip_.trace(cuts[i]);
    addPieces(cuts[i - 1], cuts[i], start, end, 0);
    start = end;
  }
  lengths_mm_ = {0};
  for (const PathPiece& piece : pieces_)
    lengths_mm_.push_back(lengths_mm_.back() + lengthBetween_mm(piece.from, piece.to));
  if (!std::isfinite(length_mm())) throw GeometryError("its path is not finite");
  // A choice: far above rounding, also of files, and far below any opening that matters.
  closed_ = (pieces_.front().start - pieces_.back().end).norm() <= 1e-6 * length_mm();
}

void EdgePath::addPieces(double from, double to, const PathPoint& start, const PathPoint& end,
                         int depth) {
  PathPiece piece{.from = from, .to = to, .start = start.p, .end = end.p};
  const double chord = (end.p - start.p).norm();
  if (!std::isfinite(chord)) throw GeometryError("its path is not finite");
  // Unequally spaced, so that a wave does not vanish at all of them. Twice the largest, for what
  // lies between them.
  for (const double share : {0.23, 0.5, 0.77})
    piece.sagitta_mm =
        std::max(piece.sagitta_mm, 2 * piece.distance(strip_.trace(piece.parameter(share)).p));
  const double rounding =
      // Evaluation of a spline and its placement take some dozens of operations on a coordinate.
      64 * std::numeric_limits<double>::epsilon() * start.p.lpNorm<Eigen::Infinity>();
  if (depth == most_halvings || piece.sagitta_mm <= std::max(2 * largest_bend * chord, rounding)) {
    pieces_.push_back(piece);
    return;
  }
  const double middle = 0.5 * (from + to);
  const PathPoint half = strip_.trace(middle);
  addPieces(from, middle, start, half, depth + 1);
  addPieces(middle, to, half, end, depth + 1);
}

std::size_t EdgePath::pieceAt(double parameter) const {
  const auto after =
      std::upper_bound(pieces_.begin(), pieces_.end(), parameter,
                       [](double s, const PathPiece& piece) { return s < piece.from; });
  return after == pieces_.begin() ? 0 : static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

double EdgePath::lengthTo_mm(double parameter) const {
  const std::size_t i = pieceAt(parameter);
  const double share = (parameter - pieces_[i].from) / (pieces_[i].to - pieces_[i].from);
  return lengths_mm_[i] + share * (lengths_mm_[i + 1] - lengths_mm_[i]);
}

double EdgePath::lengthBetween_mm(double from, double to) const {
  // Gauss-Legendre quadrature with three points: the pieces turn little.
  constexpr std::array<double, 3> shares = {0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr std::array<double, 3> weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double speed = 0;
  for (std::size_t i = 0; i < 3; ++i)
    speed += weights[i] * strip_.trace(from + shares[i] * (to - from)).d.norm();
  return speed * std::abs(to - from);
}

double EdgePath::nearestOnChords(const std::vector<std::size_t>& pieces,
                                 const Eigen::Vector3d& p) const {
  const std::size_t nearest =
      *std::ranges::min_element(pieces, {}, [&](std::size_t i) { return pieces_[i].distance(p); });
  return pieces_[nearest].parameter(pieces_[nearest].nearestShare(p));
}

double EdgePath::nearest(const Eigen::Vector3d& p, double start) const {
  const double parameter = nearestParameter(strip_, p, start);
  if (!closed_ || (parameter > 0 && parameter < 1)) return parameter;
  const double beyond = nearestParameter(strip_, p, 1 - parameter);
  const auto distance = [&](double s) { return (strip_.trace(s).p - p).squaredNorm(); };
  return distance(beyond) < distance(parameter) ? beyond : parameter;
}

Eigen::Vector3d EdgePath::direction(double parameter) const {
  const Eigen::Vector3d derivative = strip_.trace(parameter).d;
  // A choice: a derivative so much shorter than the mean one counts as zero.
  if (derivative.norm() > 1e-6 * length_mm()) return derivative.normalized();
  // Of the range. A choice: near where the derivative vanishes, and far above the rounding of
  // points.
  constexpr double step = 1e-4;
  return (strip_.trace(std::min(parameter + step, 1.0)).p -
          strip_.trace(std::max(parameter - step, 0.0)).p)
      .normalized();
}

}  // namespace seamwright::occ
