// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/piece.hpp>
#include <seamwright/core/seam/side_evaluator.hpp>
#include <seamwright/core/seam/side_length.hpp>

namespace seamwright {

namespace {

/// Allowed width of the bounds of a figure, as a share of the figure or, if that is larger, of its
/// tolerance: two digits, as reports show.
constexpr double allowed_share = 0.01;
/// Share of the parameter of the seam. A shorter piece that has bounds is not cut to make them
/// narrower.
constexpr double shortest_piece = 0x1p-24;
/// Share of the seam, in parameter and in length. A shorter piece without known tangent plane is
/// left out.
constexpr double pole_piece = 0x1p-30;
/// Share of the parameter of the seam. No piece is cut to less; this is four units in the last
/// place of 1.
constexpr double last_piece = 0x1p-50;
/// Share of the seam, in parameter and in length. The figures leave out the curvature this close to
/// a point without tangent plane, where it may grow without limit.
constexpr double degenerate_reach = 0x1p-20;
/// The same where no bound of the angle is known up to the point. Rounding scatters the poles of
/// such a point, and its effect on curvature grows with the inverse square of the distance.
constexpr double scattered_reach = 0x1p-16;

struct Piece {
  double from = 0;
  double to = 0;
  PieceFigures figures = {};
  bool left_out = false;            ///< only the gap counts
  bool curvature_left_out = false;  ///< only gap and angle count
  /// How wide its bounds are, in units of the allowed width; 0 if they are narrow enough.
  double excess = infinite;
  int stalled = 0;  ///< number of cuts in a row that improved no part
  double width() const { return to - from; }
  /// The parameter of the seam at x in [-1, 1], as enclosures of a piece count: -1 is its begin, 0
  /// its middle, 1 its end.
  double at(double x) const { return 0.5 * ((1 - x) * from + (1 + x) * to); }
};

/// Cuts the seam into pieces and measures them, see run() for the order.
///
/// Four tests decide whether a piece is cut:
///   - isEnough(): one upper bound may stay as it is. It is near the lower bound of the whole seam,
///     or, if only the verdict is wanted, on one side of the tolerance.
///   - isOnOneSide(): the same for a curvature that the figures leave out. Only its verdict counts,
///     not its width.
///   - isSettled(): no figure of the piece needs a cut. refine() cuts all other pieces.
///   - excess(): how far the bounds are from enough, in units of the allowed width. cut() compares
///     it before and after a cut, to see where rounding prevents narrower bounds.
class Enclosure {
 public:
  Enclosure(const SeamSide& a, const SeamSide& b, const ContinuityTolerance& tolerance,
            const EncloseOptions& options)
      : a_(a), b_(b), length_a_(a_), length_b_(b_), tolerance_(tolerance), options_(options) {}

  SeamFigures run();

 private:
  enum Quantity { Gap, Angle, Curvature, RelativeCurvature, Quantities };

  /// Above the crease angle there are no curvature figures. lower_[Angle] only grows. So a seam
  /// that ends below the crease angle had all its pieces measured with curvature; on one that ends
  /// above it, pieces that were measured before have curvatures, which isSettled(), excess() and
  /// addFigures() ignore.
  Detail detail() const {
    return lower_[Angle] > tolerance_.crease_rad ? Detail::TangentPlane : Detail::Curvature;
  }
  bool folds(const Piece& piece) const {
    return piece.figures.sense != 0 &&
           (a_.faceOnLeft() == b_.faceOnLeft()) == (piece.figures.sense > 0);
  }

  // These functions change pieces_; refine() also sets exhausted_.
  void look(double from, double to);
  void lookAtGap(double from, double to);
  void cut(const Piece& piece);
  void refine();
  // These functions count work, and mayCut() sets exhausted_. measure() also leaves pieces out.
  bool measure(Piece& piece, Detail detail, std::optional<double>& split);
  bool mayCut(const Piece& piece, const std::optional<double>& split);
  // These functions raise lower_, at_ and curvature_norm_.
  void see(const Piece& piece);
  void see(Quantity quantity, const PieceBound& bound, const Piece& piece);
  // These functions add to degenerate_, set curvature_range_, or mark pieces.
  void leaveOut(const Piece& piece, const SideFields& a, const SideFields& b);
  std::optional<double> poleReach(double end);
  void findPoles();
  void leaveOutCurvatureNearDegenerate();

  // All others only read, except that addLeftOut() sorts pieces_.
  bool isAtPole(const Piece& piece) const;
  void addLeftOut(SeamFigures& figures);
  double tolerated(Quantity quantity) const;
  double allowed(Quantity quantity) const;
  bool isEnough(Quantity quantity, double upper) const;
  double excess(const PieceBound& bound, Quantity quantity) const;
  double excess(const Piece& piece) const;
  bool isOnOneSide(const PieceBound& relative_curvature) const;
  bool isSettled(const Piece& piece) const;
  double planeShare() const;
  /// What the pieces say together.
  struct Summary {
    std::array<double, Quantities> upper{};
    bool has_plane = false;  ///< on some piece
    bool may_fold = false;
    std::optional<double> fold_at, unknown_at;
    bool isFoldOpen() const { return may_fold && !fold_at; }
  };
  Summary summary() const;
  void addFigures(const Summary& sum, SeamFigures& figures) const;
  std::string whyUncertified(const Summary& sum, const SeamFigures& figures,
                             bool is_crease_known) const;
  SeamFigures figures();
  std::optional<Figure> figure(Quantity quantity, double upper) const;
  Interval belowCreaseShare() const;

  SideEvaluator a_;
  SideEvaluator b_;
  SideLength length_a_, length_b_;
  const ContinuityTolerance& tolerance_;
  const EncloseOptions& options_;
  std::vector<Piece> pieces_;
  std::array<double, Quantities> lower_{};  ///< largest values found so far
  std::array<double, Quantities> at_{};     ///< where they are
  double curvature_norm_ = 0;               ///< largest norm found so far
  int looks_ = 0;                           ///< number of pieces measured
  int cuts_ = 0;                            ///< number of cuts at knot lines
  bool exhausted_ = false;
  std::vector<DegeneratePoint> degenerate_;
  Interval curvature_range_ = {0, 1};  ///< the seam without the poles at its ends
};

double Enclosure::tolerated(Quantity quantity) const {
  const double tolerances[] = {
      tolerance_.gap_mm, tolerance_.angle_rad,
      tolerance_.curvature_rel * std::max(curvature_norm_, 1 / tolerance_.flat_radius_mm),
      tolerance_.curvature_rel};
  return tolerances[quantity];
}

double Enclosure::allowed(Quantity quantity) const {
  return allowed_share * std::max(lower_[quantity], tolerated(quantity));
}

/// Whether the upper bound of a piece may stay as it is.
bool Enclosure::isEnough(Quantity quantity, double upper) const {
  if (quantity == RelativeCurvature) upper = std::min(upper, largest_relative_difference);
  if (upper <= lower_[quantity] + allowed(quantity)) return true;
  if (options_.figures) return false;
  return quantity == Curvature || upper <= tolerated(quantity) ||
         lower_[quantity] > tolerated(quantity);
}

/// Whether the curvature is certainly within the tolerance or certainly above it: all that matters
/// for a curvature that is left out.
bool Enclosure::isOnOneSide(const PieceBound& relative_curvature) const {
  return relative_curvature.upper <= tolerance_.curvature_rel ||
         relative_curvature.lower > tolerance_.curvature_rel;
}

/// Whether no figure of the piece needs a cut.
bool Enclosure::isSettled(const Piece& piece) const {
  const PieceFigures& f = piece.figures;
  if (!isEnough(Gap, f.gap_mm.upper)) return false;
  if (piece.left_out) return true;
  const double crease = tolerance_.crease_rad;
  const bool sharp = lower_[Angle] > crease;
  // The share of the length below the crease angle is needed to a hundredth. A fold counts at any
  // length.
  const bool across = f.smallest_angle_rad <= crease && f.angle_rad.upper > crease;
  if (across && (!sharp || folds(piece) || piece.width() > 0.01)) return false;
  if (!isEnough(Angle, f.angle_rad.upper)) return false;
  if (sharp) return std::isfinite(f.angle_rad.upper);
  if (piece.curvature_left_out) return f.curvature_rel && isOnOneSide(*f.curvature_rel);
  return f.curvature_per_mm && isEnough(Curvature, f.curvature_per_mm->upper) &&
         isEnough(RelativeCurvature, f.curvature_rel->upper);
}

double Enclosure::excess(const PieceBound& bound, Quantity quantity) const {
  if (isEnough(quantity, bound.upper)) return 0;
  return (bound.upper - bound.lower) /
         std::max(allowed(quantity), std::numeric_limits<double>::min());
}

/// Largest width of a bound that is too wide, in units of the allowed width; infinite where no
/// bound is known.
double Enclosure::excess(const Piece& piece) const {
  const PieceFigures& figures = piece.figures;
  const double largest = std::max(excess(figures.gap_mm, Gap), excess(figures.angle_rad, Angle));
  if (detail() == Detail::TangentPlane) return largest;
  if (!figures.curvature_per_mm) return infinite;
  if (piece.curvature_left_out) {
    if (isOnOneSide(*figures.curvature_rel)) return largest;
    return std::max(largest, excess(*figures.curvature_rel, RelativeCurvature));
  }
  // Where one side becomes flat the figure steps from 0 to 1. The step does not shrink with the
  // piece, so the pieces must locate it.
  if (figures.curvature_rel->upper == 1 && figures.curvature_rel->lower < 1) return infinite;
  return std::max({largest, excess(*figures.curvature_per_mm, Curvature),
                   excess(*figures.curvature_rel, RelativeCurvature)});
}

/// Raises the lower bound of a figure to a value that the piece attains.
void Enclosure::see(Quantity quantity, const PieceBound& bound, const Piece& piece) {
  if (bound.lower > lower_[quantity]) {
    lower_[quantity] = bound.lower;
    at_[quantity] = piece.at(bound.at);
  }
}

void Enclosure::see(const Piece& piece) {
  see(Gap, piece.figures.gap_mm, piece);
  if (piece.left_out) return;
  see(Angle, piece.figures.angle_rad, piece);
  if (piece.curvature_left_out) return;
  curvature_norm_ = std::max(curvature_norm_, piece.figures.curvature_norm_per_mm);
  if (!piece.figures.curvature_per_mm) return;
  see(Curvature, *piece.figures.curvature_per_mm, piece);
  see(RelativeCurvature, *piece.figures.curvature_rel, piece);
}

void Enclosure::leaveOut(const Piece& piece, const SideFields& a, const SideFields& b) {
  if (!curvature_range_.contains(piece.at(0))) return;  // findPoles() has named it
  const auto kind = [](const SideFields& side) {
    return side.hasPlane() ? Degeneracy::None : Degeneracy::VanishingNormal;
  };
  degenerate_.push_back({piece.at(0), kind(a), kind(b)});
}

/// Measures the piece. False if it must first be cut at \p split.
bool Enclosure::measure(Piece& piece, Detail detail, std::optional<double>& split) {
  ++looks_;
  const SideFields a = a_.fields(piece.from, piece.to, detail);
  split = a.split;
  if (split) return false;
  const SideFields b = b_.fields(piece.from, piece.to, detail);
  split = b.split;
  if (split) return false;
  const PieceSlack slack = {{allowed_share, allowed(Gap)},
                            {allowed_share, allowed(Angle)},
                            {allowed_share, allowed(Curvature)},
                            {allowed_share, allowed(RelativeCurvature)}};
  bool first = true;
  for (const SurfaceFields& fields_a : a.alternatives)
    for (const SurfaceFields& fields_b : b.alternatives) {
      const PieceFigures figures =
          measurePiece(fields_a, fields_b, detail, tolerance_.flat_radius_mm, slack);
      if (first)
        piece.figures = figures;
      else
        include(piece.figures, figures);
      first = false;
    }
  const bool without_plane =
      detail != Detail::Position && !std::isfinite(piece.figures.angle_rad.upper);
  // For a short seam far from the origin the length of such a short piece is only rounding, so a
  // larger share is allowed.
  const double share = piece.width() < 2 * last_piece ? shortest_piece : pole_piece;
  if (without_plane && piece.width() > 0 && length_a_.isShort(piece.from, piece.to, share)) {
    piece.left_out = true;
    leaveOut(piece, a, b);
  }
  return true;
}

/// Whether a cut at a knot line is possible and within the work limit.
bool Enclosure::mayCut(const Piece& piece, const std::optional<double>& split) {
  if (cuts_ < options_.max_knot_cuts && piece.from < *split && *split < piece.to) {
    ++cuts_;
    return true;
  }
  exhausted_ = true;
  return false;
}

/// Measures an interval and appends it, in parts where it must be cut at knot lines.
void Enclosure::look(double from, double to) {
  Piece piece{.from = from, .to = to};
  const double middle = piece.at(0);
  piece.curvature_left_out = middle < curvature_range_.lower || middle > curvature_range_.upper;
  std::optional<double> split;
  if (measure(piece, detail(), split)) {
    see(piece);
    piece.excess = excess(piece);
    pieces_.push_back(piece);
    return;
  }
  if (!mayCut(piece, split)) {
    piece.figures.gap_mm.upper = piece.figures.angle_rad.upper = infinite;
    pieces_.push_back(piece);
    return;
  }
  look(from, *split);
  look(*split, to);
}

/// Measures only the gap, for pieces outside the range.
void Enclosure::lookAtGap(double from, double to) {
  Piece piece{.from = from, .to = to, .left_out = true};
  std::optional<double> split;
  if (!measure(piece, Detail::Position, split)) {
    if (mayCut(piece, split)) {
      lookAtGap(from, *split);
      lookAtGap(*split, to);
      return;
    }
    piece.figures.gap_mm.upper = infinite;
  }
  see(piece);
  pieces_.push_back(piece);
}

/// If no part of a cut is much better than the whole, rounding has stalled the piece. Next to a
/// kink of a figure one part is better.
void Enclosure::cut(const Piece& piece) {
  const std::size_t first = pieces_.size();
  look(piece.from, piece.at(0));
  look(piece.at(0), piece.to);
  const auto parts = std::span(pieces_).subspan(first);
  const bool better = std::ranges::any_of(
      parts, [&](const Piece& part) { return part.excess <= 0.5 * piece.excess; });
  for (Piece& part : parts) part.stalled = better ? 0 : piece.stalled + 1;
}

/// Cuts pieces until all are settled, are too short or stalled, or the work limit is reached. A
/// round cuts each open piece once, so that lower bounds found in one part of the seam may settle
/// pieces of another.
void Enclosure::refine() {
  const int limit = options_.max_pieces + static_cast<int>(pieces_.size());
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<Piece> open;
    const auto is_open = [&](const Piece& piece) {
      const double shortest = piece.curvature_left_out ? pole_piece : shortest_piece;
      const bool is_long_enough =
          piece.width() >= (std::isfinite(piece.excess) ? shortest : last_piece);
      return is_long_enough && piece.stalled < 2 && !piece.left_out && !isSettled(piece);
    };
    const auto first_open =
        std::stable_partition(pieces_.begin(), pieces_.end(), std::not_fn(is_open));
    open.assign(first_open, pieces_.end());
    pieces_.erase(first_open, pieces_.end());
    for (const Piece& piece : open) {
      if (looks_ >= limit) {
        exhausted_ = true;
        pieces_.push_back(piece);
      } else if (isSettled(piece)) {  // by values found since it was opened
        pieces_.push_back(piece);
      } else {
        cut(piece);
        changed = true;
      }
    }
  }
}

/// The distance from an end over which the figures leave out the curvature. Nothing unless a side
/// has no bounded curvature on a short piece at that end; that end is then named as degenerate.
std::optional<double> Enclosure::poleReach(double end) {
  const double from = end == 0 ? 0 : 1 - pole_piece, to = end == 0 ? pole_piece : 1;
  bool has_plane = true;
  const auto kind = [&](const SideEvaluator& evaluator) {
    const SideFields side = evaluator.fields(from, to, Detail::Curvature);
    has_plane = has_plane && side.hasPlane();
    return side.split || side.hasCurvature() ? Degeneracy::None : Degeneracy::VanishingNormal;
  };
  const DegeneratePoint point{end, kind(a_), kind(b_)};
  if (point.side_a == Degeneracy::None && point.side_b == Degeneracy::None) return std::nullopt;
  degenerate_.push_back(point);
  return has_plane ? degenerate_reach : scattered_reach;
}

/// Looks for poles at the ends of the seam, where edges end at poles. Poles elsewhere are found by
/// pieces that shrink to them.
void Enclosure::findPoles() {
  const auto [first, last] = options_.range;
  const auto reach = [&](int end, double share) {
    double length = share;
    while (length > pole_piece && !(end == 0 ? length_a_.isShort(0, length, share)
                                             : length_a_.isShort(1 - length, 1, share)))
      length *= 0.5;
    return length;
  };
  const auto poleShare = [&](int end, bool is_left_out) {
    return is_left_out ? std::optional(scattered_reach) : poleReach(end);
  };
  if (const auto share = poleShare(0, first > 0))
    curvature_range_.lower = std::max(first, reach(0, *share));
  if (const auto share = poleShare(1, last < 1))
    curvature_range_.upper = std::min(last, 1 - reach(1, *share));
}

/// Points without tangent plane that refine() found are known only now. The lower bounds of
/// curvature may come from pieces near them, so they are found again from the others.
void Enclosure::leaveOutCurvatureNearDegenerate() {
  bool changed = false;
  for (Piece& piece : pieces_) {
    if (piece.curvature_left_out) continue;
    piece.curvature_left_out = std::ranges::any_of(degenerate_, [&](const DegeneratePoint& point) {
      return curvature_range_.contains(point.at) &&
             length_a_.isShort(std::min(piece.from, point.at), std::max(piece.to, point.at),
                               2 * degenerate_reach);
    });
    changed |= piece.curvature_left_out;
  }
  if (!changed) return;
  lower_[Curvature] = lower_[RelativeCurvature] = 0;
  for (const Piece& piece : pieces_) see(piece);
}

/// Whether the piece is too near a point without tangent plane or without curvature to be
/// distinguished from it.
bool Enclosure::isAtPole(const Piece& piece) const {
  if (piece.left_out) return true;
  const auto is_near = [&](double pole) {
    return length_a_.isShort(std::min(piece.from, pole), std::max(piece.to, pole), pole_piece);
  };
  return std::ranges::any_of(degenerate_,
                             [&](const DegeneratePoint& point) { return is_near(point.at); });
}

void Enclosure::addLeftOut(SeamFigures& figures) {
  std::ranges::sort(pieces_, {}, &Piece::from);
  const auto add = [&](LeftOut& left_out, const Piece& piece, double upper) {
    if (!left_out.intervals.empty() && piece.from <= left_out.intervals.back().upper)
      left_out.intervals.back().upper = piece.to;
    else
      left_out.intervals.push_back({piece.from, piece.to});
    if (upper > left_out.upper.value_or(infinite)) left_out.upper = upper;
    if (left_out.upper == infinite) left_out.upper.reset();
  };
  const Interval& range = options_.range;
  for (const Piece& piece : pieces_) {
    const bool in_range = piece.at(0) > range.lower && piece.at(0) < range.upper;
    if (piece.left_out) add(figures.angle_left_out, piece, in_range ? 0 : infinite);
    if (!figures.curvature_rel || !(piece.left_out || piece.curvature_left_out)) continue;
    const auto& curvature = piece.figures.curvature_rel;
    double upper = infinite;
    if (in_range && isAtPole(piece))
      upper = 0;
    else if (in_range && curvature)
      upper = curvature->upper;
    add(figures.curvature_left_out, piece, upper);
  }
  for (LeftOut* left_out : {&figures.angle_left_out, &figures.curvature_left_out}) {
    left_out->longest_mm = 0;
    for (const Interval& interval : left_out->intervals)
      left_out->longest_mm =
          std::max({left_out->longest_mm, length_a_.of(interval.lower, interval.upper).upper,
                    length_b_.of(interval.lower, interval.upper).upper});
  }
}

/// The order:
///   1. The middle, for a first lower bound of the angle.
///   2. Poles at the ends, which determine curvature_range_.
///   3. A first measurement between breaks: knots, and the ends of both ranges.
///   4. refine(), which needs the lower bounds of the whole seam.
///   5. What lies near points without tangent plane is left out of the curvature.
///   6. The figures.
SeamFigures Enclosure::run() {
  const Interval& range = options_.range;
  std::vector<double> breaks = {range.lower, range.upper, 1};
  a_.addBreaks(breaks);
  b_.addBreaks(breaks);
  // The middle is measured first: a seam that is a crease there has no curvature figures, which
  // saves their computation.
  Piece middle{.from = range.middle(), .to = range.middle()};
  std::optional<double> split;
  if (measure(middle, Detail::TangentPlane, split)) see(middle);
  findPoles();
  breaks.insert(breaks.end(), {curvature_range_.lower, curvature_range_.upper});
  std::ranges::sort(breaks);
  double from = 0;
  for (const double at : breaks) {
    constexpr double apart = 0x1p-48;  // breaks that differ only by rounding are one
    if (at <= from + apart) continue;
    const double to = at > 1 - apart ? 1 : at;
    const double inner = 0.5 * (from + to);
    if (inner > range.lower && inner < range.upper)
      look(from, to);
    else
      lookAtGap(from, to);
    from = to;
  }
  refine();
  leaveOutCurvatureNearDegenerate();
  return figures();
}

std::optional<Figure> Enclosure::figure(Quantity quantity, double upper) const {
  Figure figure{lower_[quantity], std::nullopt, at_[quantity]};
  if (std::isfinite(upper)) figure.upper = std::max(upper, figure.lower);
  return figure;
}

double Enclosure::planeShare() const {
  const Interval& range = options_.range;
  double left_out = 0;
  if (range.lower > 0) left_out += length_a_.of(0, range.lower).upper;
  if (range.upper < 1) left_out += length_a_.of(range.upper, 1).upper;
  for (const Piece& piece : pieces_)
    if (piece.left_out && piece.from >= range.lower && piece.to <= range.upper)
      left_out += length_a_.of(piece.from, piece.to).upper;
  return left_out > 0 ? std::max(0.0, 1 - left_out / std::max(length_a_.whole_mm(), left_out)) : 1;
}

Interval Enclosure::belowCreaseShare() const {
  if (std::ranges::none_of(pieces_, [&](const Piece& piece) {
        return !piece.left_out &&
               (piece.figures.angle_rad.upper > tolerance_.crease_rad || folds(piece));
      }))
    return {1, 1};
  if (std::ranges::none_of(pieces_, [&](const Piece& piece) {
        return !piece.left_out && piece.figures.smallest_angle_rad <= tolerance_.crease_rad;
      }))
    return {0, 0};
  Interval below, other, either;
  for (const Piece& piece : pieces_) {
    const PieceFigures& f = piece.figures;
    const bool is_above =
        piece.left_out || f.smallest_angle_rad > tolerance_.crease_rad || folds(piece);
    Interval& sum = is_above ? other : f.angle_rad.upper <= tolerance_.crease_rad ? below : either;
    const Interval length = length_a_.of(piece.from, piece.to);
    sum.lower += length.lower;
    sum.upper += length.upper;
  }
  const double least = below.lower / std::max(below.lower + other.upper + either.upper, 1e-300);
  const double most =
      (below.upper + either.upper) / std::max(below.upper + either.upper + other.lower, 1e-300);
  return {least, most};
}

Enclosure::Summary Enclosure::summary() const {
  Summary sum;
  for (const Piece& piece : pieces_) {
    const PieceFigures& f = piece.figures;
    sum.upper[Gap] = std::max(sum.upper[Gap], f.gap_mm.upper);
    if (!std::isfinite(f.gap_mm.upper)) sum.unknown_at = piece.at(0);
    if (piece.left_out) continue;
    sum.has_plane = true;
    sum.upper[Angle] = std::max(sum.upper[Angle], f.angle_rad.upper);
    if (!piece.curvature_left_out) {
      sum.upper[Curvature] =
          std::max(sum.upper[Curvature], f.curvature_per_mm ? f.curvature_per_mm->upper : infinite);
      sum.upper[RelativeCurvature] = std::max(sum.upper[RelativeCurvature],
                                              f.curvature_rel ? f.curvature_rel->upper : infinite);
    }
    if (!std::isfinite(f.angle_rad.upper)) sum.unknown_at = piece.at(0);
    if (!folds(piece)) continue;
    if (f.angle_rad.upper <= tolerance_.crease_rad && !sum.fold_at) sum.fold_at = piece.at(0);
    if (f.smallest_angle_rad <= tolerance_.crease_rad) sum.may_fold = true;
  }
  // The relative difference cannot be larger where the curvature has bounds at all.
  if (std::isfinite(sum.upper[Curvature]))
    sum.upper[RelativeCurvature] =
        std::min(sum.upper[RelativeCurvature], largest_relative_difference);
  return sum;
}

void Enclosure::addFigures(const Summary& sum, SeamFigures& figures) const {
  figures.gap_mm = figure(Gap, sum.upper[Gap]);
  figures.fold_at = sum.fold_at;
  if (!sum.has_plane) return;
  figures.angle_rad = figure(Angle, sum.upper[Angle]);
  const bool sharp = lower_[Angle] > tolerance_.crease_rad;
  if (sharp || sum.fold_at) return;
  figures.curvature_per_mm = figure(Curvature, sum.upper[Curvature]);
  figures.curvature_rel = figure(RelativeCurvature, sum.upper[RelativeCurvature]);
}

/// The most important reason comes first.
std::string Enclosure::whyUncertified(const Summary& sum, const SeamFigures& figures,
                                      bool is_crease_known) const {
  if (sum.unknown_at) {
    const std::string pieces = exhausted_ ? fmt::format(" with {} pieces", looks_) : "";
    return fmt::format("no bound was found at {:.6g}{}", *sum.unknown_at, pieces);
  }
  if (sum.isFoldOpen()) return "the faces may fold back on one another";
  if (!is_crease_known) return "the crease angle is passed near the middle of its length";
  if (figures.curvature_rel && !figures.curvature_rel->upper) return "the curvature is not bounded";
  if (exhausted_) return fmt::format("the enclosures are still wide after {} pieces", looks_);
  return "";
}

SeamFigures Enclosure::figures() {
  const Summary sum = summary();
  SeamFigures figures;
  addFigures(sum, figures);
  const Interval share = belowCreaseShare();
  // The judge asks whether half of the length is below the crease angle.
  const bool is_crease_known = !(share.lower <= 0.5 && share.upper > 0.5);
  figures.below_crease_share = share.middle();
  figures.plane_share = planeShare();
  figures.shares_known = is_crease_known && !sum.isFoldOpen();
  figures.degenerate = degenerate_;
  addLeftOut(figures);
  figures.points = looks_;
  figures.uncertified = whyUncertified(sum, figures, is_crease_known);
  const auto known = [](const std::optional<Figure>& figure) { return !figure || figure->upper; };
  figures.certified =
      known(figures.gap_mm) && known(figures.angle_rad) &&
      (figures.fold_at || (known(figures.curvature_per_mm) && known(figures.curvature_rel)));
  return figures;
}

}  // namespace

SeamFigures encloseSeam(const SeamSide& a, const SeamSide& b, const ContinuityTolerance& tolerance,
                        const EncloseOptions& options) {
  tolerance.validate();
  return Enclosure(a, b, tolerance, options).run();
}

}  // namespace seamwright
