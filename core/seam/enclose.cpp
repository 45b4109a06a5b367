// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include <seamwright/core/numeric.hpp>
#include <seamwright/core/seam/enclose.hpp>
#include <seamwright/core/seam/piece.hpp>
#include <seamwright/core/seam/seam_pieces.hpp>
#include <seamwright/core/seam/side_evaluator.hpp>
#include <seamwright/core/seam/side_length.hpp>

namespace seamwright {

namespace {

using namespace enclosure;

/// Allowed width of the bounds of a figure, as a share of the figure or, if that is larger, of its
/// tolerance: two digits, as reports show.
constexpr double allowed_share = 0.01;
/// Share of the parameter of the seam. A shorter piece that has bounds is not cut to make them
/// narrower.
constexpr double shortest_piece = 0x1p-24;
/// Share of the parameter of the seam. No piece is cut to less; this is four units in the last
/// place of 1.
constexpr double last_piece = 0x1p-50;
/// Share of the seam, in parameter and in length. The figures leave out the curvature this close to
/// a point without tangent plane, where it may grow without limit.
constexpr double degenerate_reach = 0x1p-20;
/// The same where no bound of the angle is known up to the point. Rounding scatters the poles of
/// such a point, and its effect on curvature grows with the inverse square of the distance.
constexpr double scattered_reach = 0x1p-16;

/// Cuts the seam into pieces and measures them, see start() for the order.
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

  void start();
  SeamPieces finish();
  /// Whether start() found that the curvature is not measured on the whole seam.
  bool leavesOut() const {
    const bool is_whole = curvature_range_.lower == 0 && curvature_range_.upper == 1;
    return !is_whole && lower_[Angle] <= tolerance_.crease_rad;
  }
  const SideLength& length_a() const { return length_a_; }
  const SideLength& length_b() const { return length_b_; }

 private:
  /// Above the crease angle there are no curvature figures. lower_[Angle] only grows. So a seam
  /// that ends below the crease angle had all its pieces measured with curvature; on one that ends
  /// above it, pieces that were measured before have curvatures, which isSettled(), excess() and
  /// figuresOf() ignore.
  Detail detail() const {
    if (lower_[Angle] > tolerance_.crease_rad || isVerdictBelowG2()) return Detail::TangentPlane;
    return options_.curvature_change ? Detail::CurvatureChange : Detail::Curvature;
  }
  /// Whether only the verdict is wanted, and the level is certainly below G2: then the bounds of
  /// the curvature count no more.
  bool isVerdictBelowG2() const {
    return !options_.figures &&
           (lower_[Gap] > tolerance_.gap_mm || lower_[Angle] > tolerance_.angle_rad ||
            lower_[RelativeCurvature] > tolerance_.curvature_rel);
  }
  bool folds(const Piece& piece) const {
    return enclosure::folds(piece, a_.faceOnLeft() == b_.faceOnLeft());
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
  void seeCurvatureAgain();
  // These functions add to degenerate_, set curvature_range_, or mark pieces.
  void leaveOut(const Piece& piece, const SideFields& a, const SideFields& b);
  std::optional<double> poleReach(double end);
  double shortened(double end, double share) const;
  void findPoles();
  bool hasCurvatureAt(double end) const;
  void lookAgain(const Interval& part, double at);
  void leaveOutCurvatureNearDegenerate();
  void leaveOutCurvatureBetweenKnots();

  // These functions only read.
  double tolerated(Quantity quantity) const;
  double allowed(Quantity quantity) const;
  bool isEnough(Quantity quantity, double upper) const;
  double excess(const PieceBound& bound, Quantity quantity) const;
  double excess(const Piece& piece) const;
  bool isOnOneSide(const PieceBound& relative_curvature) const;
  bool isFoldUnknown(const Piece& piece) const;
  bool isSettled(const Piece& piece) const;

  SideEvaluator a_;
  SideEvaluator b_;
  SideLength length_a_, length_b_;
  const ContinuityTolerance& tolerance_;
  const EncloseOptions& options_;
  std::vector<Piece> pieces_;
  std::array<double, Quantities> lower_{};  ///< largest values found so far
  std::array<double, Quantities> at_{};     ///< where they are
  double curvature_norm_ = 0;               ///< largest norm found so far
  double left_out_lower_ = 0;               ///< largest relative curvature found that is left out
  int looks_ = 0;                           ///< number of pieces measured
  int cuts_ = 0;                            ///< number of cuts at knot lines
  bool exhausted_ = false;
  std::vector<DegeneratePoint> degenerate_;
  Interval curvature_range_ = {0, 1};  ///< the seam without the poles at its ends
};

double Enclosure::tolerated(Quantity quantity) const {
  const double flat = 1 / tolerance_.flat_radius_mm;
  const double flat_change = 100 * flat * flat;  // see relativeChange()
  const double tolerances[] = {
      tolerance_.gap_mm,
      tolerance_.angle_rad,
      tolerance_.curvature_rel * std::max(curvature_norm_, flat),
      tolerance_.curvature_rel,
      tolerance_.curvature_rel * std::max(curvature_norm_ * curvature_norm_, flat_change),
      tolerance_.curvature_rel};
  return tolerances[quantity];
}

double Enclosure::allowed(Quantity quantity) const {
  return allowed_share * std::max(lower_[quantity], tolerated(quantity));
}

/// Whether the upper bound of a piece may stay as it is.
bool Enclosure::isEnough(Quantity quantity, double upper) const {
  if (quantity == RelativeCurvature || quantity == RelativeChange)
    upper = std::min(upper, largest_relative_difference);
  if (options_.figures) return upper <= lower_[quantity] + allowed(quantity);
  return quantity == Curvature || quantity == Change || upper <= tolerated(quantity) ||
         lower_[quantity] > tolerated(quantity);
}

/// Whether the curvature is certainly within the tolerance or certainly above it: all that matters
/// for a curvature that is left out.
bool Enclosure::isOnOneSide(const PieceBound& relative_curvature) const {
  return relative_curvature.upper <= tolerance_.curvature_rel ||
         relative_curvature.lower > tolerance_.curvature_rel;
}

/// Whether the angle may be that of a fold, and it is not known to which sides the faces leave.
/// Where the seam is sharp anyway, a fold would not change the verdict.
bool Enclosure::isFoldUnknown(const Piece& piece) const {
  return lower_[Angle] <= tolerance_.crease_rad && piece.figures.sense == 0 &&
         piece.figures.smallest_angle_rad <= tolerance_.crease_rad;
}

/// Whether no figure of the piece needs a cut.
bool Enclosure::isSettled(const Piece& piece) const {
  const PieceFigures& f = piece.figures;
  if (!isEnough(Gap, f.gap_mm.upper)) return false;
  if (piece.left_out) return true;
  if (isFoldUnknown(piece)) return false;
  const double crease = tolerance_.crease_rad;
  const bool sharp = lower_[Angle] > crease;
  // The share of the length below the crease angle is needed to a hundredth. A fold counts at any
  // length.
  const bool across = f.smallest_angle_rad <= crease && f.angle_rad.upper > crease;
  if (across && (!sharp || folds(piece) || piece.width() > 0.01)) return false;
  if (!isEnough(Angle, f.angle_rad.upper)) return false;
  if (sharp || isVerdictBelowG2()) return std::isfinite(f.angle_rad.upper);
  if (piece.curvature_left_out)
    return left_out_lower_ > tolerance_.curvature_rel ||
           (f.curvature_rel && isOnOneSide(*f.curvature_rel)) ||
           isAtPole(piece, degenerate_, length_a_);
  if (!f.curvature_per_mm || !isEnough(Curvature, f.curvature_per_mm->upper) ||
      !isEnough(RelativeCurvature, f.curvature_rel->upper))
    return false;
  return !options_.curvature_change ||
         (f.curvature_change_per_mm2 && isEnough(Change, f.curvature_change_per_mm2->upper) &&
          isEnough(RelativeChange, f.curvature_change_rel->upper));
}

double Enclosure::excess(const PieceBound& bound, Quantity quantity) const {
  // A verdict may need no bound of the curvature, but where the angle has none, a point without
  // tangent plane is to be found.
  if ((quantity == Gap || quantity == Angle) && !std::isfinite(bound.upper)) return infinite;
  if (isEnough(quantity, bound.upper)) return 0;
  return (bound.upper - bound.lower) /
         std::max(allowed(quantity), std::numeric_limits<double>::min());
}

/// Largest width of a bound that is too wide, in units of the allowed width; infinite where no
/// bound is known.
double Enclosure::excess(const Piece& piece) const {
  const PieceFigures& figures = piece.figures;
  if (isFoldUnknown(piece)) return infinite;
  const double largest = std::max(excess(figures.gap_mm, Gap), excess(figures.angle_rad, Angle));
  if (detail() == Detail::TangentPlane) return largest;
  if (!figures.curvature_per_mm) return infinite;
  if (piece.curvature_left_out) {
    if (isOnOneSide(*figures.curvature_rel)) return largest;
    return std::max(largest, excess(*figures.curvature_rel, RelativeCurvature));
  }
  const double of_curvature = std::max({largest, excess(*figures.curvature_per_mm, Curvature),
                                        excess(*figures.curvature_rel, RelativeCurvature)});
  if (!options_.curvature_change) return of_curvature;
  if (!figures.curvature_change_per_mm2) return infinite;
  return std::max({of_curvature, excess(*figures.curvature_change_per_mm2, Change),
                   excess(*figures.curvature_change_rel, RelativeChange)});
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
  if (piece.curvature_left_out) {
    if (const auto& relative = piece.figures.curvature_rel)
      left_out_lower_ = std::max(left_out_lower_, relative->lower);
    return;
  }
  curvature_norm_ = std::max(curvature_norm_, piece.figures.curvature_norm_per_mm);
  if (!piece.figures.curvature_per_mm) return;
  see(Curvature, *piece.figures.curvature_per_mm, piece);
  see(RelativeCurvature, *piece.figures.curvature_rel, piece);
  if (!piece.figures.curvature_change_per_mm2) return;
  see(Change, *piece.figures.curvature_change_per_mm2, piece);
  see(RelativeChange, *piece.figures.curvature_change_rel, piece);
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
  piece.across_knots = a.alternatives.size() > 1 || b.alternatives.size() > 1;
  piece.bounds_curvature = a.hasCurvature() && b.hasCurvature();
  const PieceSlack slack = {
      {allowed_share, allowed(Gap)},       {allowed_share, allowed(Angle)},
      {allowed_share, allowed(Curvature)}, {allowed_share, allowed(RelativeCurvature)},
      {allowed_share, allowed(Change)},    {allowed_share, allowed(RelativeChange)}};
  bool first = true;
  for (const SurfaceFields& fields_a : a.alternatives)
    for (const SurfaceFields& fields_b : b.alternatives) {
      PieceFigures figures =
          measurePiece(fields_a, fields_b, detail, tolerance_.flat_radius_mm, slack);
      if (detail == Detail::CurvatureChange)
        measureChange({fields_a, a.direction}, {fields_b, b.direction}, tolerance_.flat_radius_mm,
                      slack, figures);
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
  const std::vector<double> ends = partsOf(piece, curvature_range_);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) look(ends[i], ends[i + 1]);
  const auto parts = std::span(pieces_).subspan(first);
  const bool better = std::ranges::any_of(
      parts, [&](const Piece& part) { return part.excess <= 0.5 * piece.excess; });
  for (Piece& part : parts) part.stalled = better ? 0 : piece.stalled + 1;
}

/// Cuts pieces until all are settled, are too short or stalled, or the work limit is reached. A
/// round cuts each open piece once, so that lower bounds found in one part of the seam may settle
/// pieces of another.
void Enclosure::refine() {
  const int limit = options_.max_pieces + looks_;
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
    if (evaluator.isRegular()) return Degeneracy::None;
    const SideFields side = evaluator.fields(from, to, Detail::Curvature);
    has_plane = has_plane && side.hasPlane();
    return side.split || side.hasCurvature() ? Degeneracy::None : Degeneracy::VanishingNormal;
  };
  const DegeneratePoint point{end, kind(a_), kind(b_)};
  if (point.side_a == Degeneracy::None && point.side_b == Degeneracy::None) return std::nullopt;
  degenerate_.push_back(point);
  return has_plane ? degenerate_reach : scattered_reach;
}

/// The share of the parameter at an end that is at most \p share of the length as well.
double Enclosure::shortened(double end, double share) const {
  double length = share;
  while (length > pole_piece && !(end == 0 ? length_a_.isShort(0, length, share)
                                           : length_a_.isShort(1 - length, 1, share)))
    length *= 0.5;
  return length;
}

/// Whether the piece at that end says that the curvature of both sides is bounded there.
bool Enclosure::hasCurvatureAt(double end) const {
  return std::ranges::any_of(pieces_, [&](const Piece& piece) {
    return (end == 0 ? piece.from == 0 : piece.to == 1) && !piece.left_out &&
           piece.bounds_curvature;
  });
}

/// Measures the pieces that meet the part again, cut at one of its ends.
void Enclosure::lookAgain(const Interval& part, double at) {
  const auto first = std::stable_partition(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
    return piece.to <= part.lower || piece.from >= part.upper;
  });
  const std::vector<Piece> met(first, pieces_.end());
  pieces_.erase(first, pieces_.end());
  for (const Piece& piece : met) {
    const bool is_cut = piece.from < at && at < piece.to;
    look(piece.from, is_cut ? at : piece.to);
    if (is_cut) look(at, piece.to);
  }
}

/// Looks for poles at the ends of the seam, where edges end at poles. Poles elsewhere are found by
/// pieces that shrink to them. A first measurement without unbounded curvature shows that there is
/// none.
void Enclosure::findPoles() {
  for (const double end : {0.0, 1.0}) {
    if (end == 0 ? options_.range.lower > 0 : options_.range.upper < 1) continue;
    if (hasCurvatureAt(end)) continue;
    const auto share = poleReach(end);
    if (!share) continue;
    const double length = shortened(end, *share);
    const double at = end == 0 ? length : 1 - length;
    const Interval part = end == 0 ? Interval{0, at} : Interval{at, 1};
    (end == 0 ? curvature_range_.lower : curvature_range_.upper) = at;
    std::erase_if(degenerate_, [&](const DegeneratePoint& point) {
      return point.at != end && part.contains(point.at);
    });
    lookAgain(part, at);
    seeCurvatureAgain();
  }
}

/// The lower bounds of curvature may come from pieces that are left out, so they are found again
/// from the others.
void Enclosure::seeCurvatureAgain() {
  for (const Quantity quantity : {Curvature, RelativeCurvature, Change, RelativeChange})
    lower_[quantity] = 0;
  curvature_norm_ = 0;
  for (const Piece& piece : pieces_) see(piece);
}

/// Points without tangent plane that refine() found are known only now.
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
  if (changed) seeCurvatureAgain();
}

/// Where both sides cross a knot line at nearly the same point, a piece that was cut down to the
/// shortest crossing has every combination of their polynomials, also that of one side before its
/// knot with the other behind its own. If the verdict depends on these, the curvature of the piece
/// is left out: whether the interval counts is then decided by the tolerance of the gap. Values of
/// such a piece are never lower bounds, so those stay.
void Enclosure::leaveOutCurvatureBetweenKnots() {
  const auto is_undecided = [&](const std::optional<PieceBound>& bound, Quantity quantity) {
    return bound && bound->upper > tolerated(quantity) && lower_[quantity] <= tolerated(quantity);
  };
  for (Piece& piece : pieces_) {
    const PieceFigures& figures = piece.figures;
    if (!piece.across_knots || piece.left_out || piece.curvature_left_out) continue;
    if (!is_undecided(figures.curvature_rel, RelativeCurvature) &&
        !is_undecided(figures.curvature_change_rel, RelativeChange))
      continue;
    piece.curvature_left_out = length_a_.isShort(piece.from, piece.to, degenerate_reach);
  }
}

/// The order, of which 4 and 5 are in finish():
///   1. The middle, for a first lower bound of the angle.
///   2. A first measurement between breaks: knots, and the ends of the range.
///   3. Poles at the ends, which determine curvature_range_.
///   4. refine(), which needs the lower bounds of the whole seam.
///   5. What lies near points without tangent plane, and between knots of both sides that nearly
///      coincide, is left out of the curvature.
void Enclosure::start() {
  const Interval& range = options_.range;
  std::vector<double> breaks = {range.lower, range.upper, 1};
  a_.addBreaks(breaks);
  b_.addBreaks(breaks);
  // The middle is measured first: a seam that is a crease there has no curvature figures, which
  // saves their computation.
  Piece middle{.from = range.middle(), .to = range.middle()};
  std::optional<double> split;
  if (measure(middle, Detail::TangentPlane, split)) see(middle);
  if (range.lower > 0)
    curvature_range_.lower = std::max(range.lower, shortened(0, scattered_reach));
  if (range.upper < 1)
    curvature_range_.upper = std::min(range.upper, 1 - shortened(1, scattered_reach));
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
  findPoles();
}

SeamPieces Enclosure::finish() {
  refine();
  leaveOutCurvatureNearDegenerate();
  leaveOutCurvatureBetweenKnots();
  return {.pieces = std::move(pieces_),
          .lower = lower_,
          .at = at_,
          .degenerate = std::move(degenerate_),
          .faces_on_one_side = a_.faceOnLeft() == b_.faceOnLeft(),
          .looks = looks_,
          .exhausted = exhausted_,
          .is_verdict_below_g2 = isVerdictBelowG2(),
          .has_change = options_.curvature_change};
}

}  // namespace

SeamFigures encloseSeam(const SeamSide& a, const SeamSide& b, const ContinuityTolerance& tolerance,
                        const EncloseOptions& options) {
  tolerance.validate();
  // What is left out depends on how far the pieces are cut, and so do the values beside it.
  EncloseOptions all = options;
  all.figures = true;
  Enclosure enclosure(a, b, tolerance, options);
  enclosure.start();
  if (!options.figures && enclosure.leavesOut()) return encloseSeam(a, b, tolerance, all);
  SeamPieces pieces = enclosure.finish();
  SeamFigures figures = figuresOf(std::move(pieces), enclosure.length_a(), enclosure.length_b(),
                                  {.tolerance = tolerance, .range = options.range});
  const bool leaves_out =
      !figures.angle_left_out.intervals.empty() || !figures.curvature_left_out.intervals.empty();
  if (options.figures || !leaves_out) return figures;
  return encloseSeam(a, b, tolerance, all);
}

}  // namespace seamwright
