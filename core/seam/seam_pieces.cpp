// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <string>

#include <seamwright/core/seam/seam_pieces.hpp>

namespace seamwright::enclosure {

namespace {

/// What the pieces say together.
struct Summary {
  std::array<double, Quantities> upper{};
  bool has_plane = false;  ///< on some piece
  bool may_fold = false;   ///< somewhere, at less than the crease angle
  std::optional<double> fold_at, unknown_at;
};

/// The figures of pieces that are sorted by parameter.
class Figures {
 public:
  Figures(const SeamPieces& seam, const SideLength& length_a, const SideLength& length_b,
          const FigureOptions& options)
      : seam_(seam),
        length_a_(length_a),
        length_b_(length_b),
        tolerance_(options.tolerance),
        range_(options.range) {}

  SeamFigures all() const;

 private:
  bool foldsAt(const Piece& piece) const { return folds(piece, seam_.faces_on_one_side); }
  bool mayFoldAt(const Piece& piece) const { return mayFold(piece, seam_.faces_on_one_side); }
  bool isSharp() const { return seam_.lower[Angle] > tolerance_.crease_rad; }
  /// Whether a fold that is not excluded could change the verdict: not if the seam is sharp anyway.
  bool isFoldOpen(const Summary& sum) const { return sum.may_fold && !sum.fold_at && !isSharp(); }
  Summary summary() const;
  std::optional<Figure> figure(Quantity quantity, double upper) const;
  void addFigures(const Summary& sum, SeamFigures& figures) const;
  double planeShare() const;
  Interval belowCreaseShare() const;
  void addLeftOut(SeamFigures& figures) const;
  std::string whyUncertified(const Summary& sum, const SeamFigures& figures,
                             bool is_crease_known) const;

  const SeamPieces& seam_;
  const SideLength &length_a_, &length_b_;
  const ContinuityTolerance& tolerance_;
  const Interval range_;
};

void Figures::addLeftOut(SeamFigures& figures) const {
  const auto add = [&](LeftOut& left_out, const Piece& piece, double upper) {
    if (!left_out.intervals.empty() && piece.from <= left_out.intervals.back().upper)
      left_out.intervals.back().upper = piece.to;
    else
      left_out.intervals.push_back({piece.from, piece.to});
    if (upper > left_out.upper.value_or(infinite)) left_out.upper = upper;
    if (left_out.upper == infinite) left_out.upper.reset();
  };
  for (const Piece& piece : seam_.pieces) {
    const bool in_range = piece.at(0) > range_.lower && piece.at(0) < range_.upper;
    if (piece.left_out) add(figures.angle_left_out, piece, in_range ? 0 : infinite);
    if (!figures.curvature_rel || !(piece.left_out || piece.curvature_left_out)) continue;
    const auto& curvature = piece.figures.curvature_rel;
    double upper = infinite;
    if (in_range && (piece.left_out || isAtPole(piece, seam_.degenerate, length_a_)))
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

std::optional<Figure> Figures::figure(Quantity quantity, double upper) const {
  Figure figure{seam_.lower[quantity], std::nullopt, seam_.at[quantity]};
  if (std::isfinite(upper)) figure.upper = std::max(upper, figure.lower);
  return figure;
}

double Figures::planeShare() const {
  double left_out = 0;
  if (range_.lower > 0) left_out += length_a_.of(0, range_.lower).upper;
  if (range_.upper < 1) left_out += length_a_.of(range_.upper, 1).upper;
  for (const Piece& piece : seam_.pieces)
    if (piece.left_out && piece.from >= range_.lower && piece.to <= range_.upper)
      left_out += length_a_.of(piece.from, piece.to).upper;
  return left_out > 0 ? std::max(0.0, 1 - left_out / std::max(length_a_.whole_mm(), left_out)) : 1;
}

Interval Figures::belowCreaseShare() const {
  if (std::ranges::none_of(seam_.pieces, [&](const Piece& piece) {
        return !piece.left_out &&
               (piece.figures.angle_rad.upper > tolerance_.crease_rad || mayFoldAt(piece));
      }))
    return {1, 1};
  if (std::ranges::none_of(seam_.pieces, [&](const Piece& piece) {
        return !piece.left_out && piece.figures.smallest_angle_rad <= tolerance_.crease_rad;
      }))
    return {0, 0};
  Interval below, other, either;
  for (const Piece& piece : seam_.pieces) {
    const PieceFigures& f = piece.figures;
    const bool is_above =
        piece.left_out || f.smallest_angle_rad > tolerance_.crease_rad || foldsAt(piece);
    const bool is_below = f.angle_rad.upper <= tolerance_.crease_rad && !mayFoldAt(piece);
    Interval& sum = is_above ? other : is_below ? below : either;
    const Interval length = length_a_.of(piece.from, piece.to);
    sum.lower += length.lower;
    sum.upper += length.upper;
  }
  const double least = below.lower / std::max(below.lower + other.upper + either.upper, 1e-300);
  const double most =
      (below.upper + either.upper) / std::max(below.upper + either.upper + other.lower, 1e-300);
  return {least, most};
}

Summary Figures::summary() const {
  Summary sum;
  for (const Piece& piece : seam_.pieces) {
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
      const auto& change = f.curvature_change_per_mm2;
      sum.upper[Change] = std::max(sum.upper[Change], change ? change->upper : infinite);
      const auto& relative = f.curvature_change_rel;
      sum.upper[RelativeChange] =
          std::max(sum.upper[RelativeChange], relative ? relative->upper : infinite);
    }
    if (!std::isfinite(f.angle_rad.upper)) sum.unknown_at = piece.at(0);
    if (!mayFoldAt(piece)) continue;
    if (f.smallest_angle_rad <= tolerance_.crease_rad) sum.may_fold = true;
    if (foldsAt(piece) && f.angle_rad.upper <= tolerance_.crease_rad && !sum.fold_at)
      sum.fold_at = piece.at(0);
  }
  // The relative difference cannot be larger where the curvature has bounds at all.
  const auto limit = [&](Quantity relative, Quantity absolute) {
    if (std::isfinite(sum.upper[absolute]))
      sum.upper[relative] = std::min(sum.upper[relative], largest_relative_difference);
  };
  limit(RelativeCurvature, Curvature);
  limit(RelativeChange, Change);
  return sum;
}

void Figures::addFigures(const Summary& sum, SeamFigures& figures) const {
  figures.gap_mm = figure(Gap, sum.upper[Gap]);
  figures.fold_at = sum.fold_at;
  if (!sum.has_plane) return;
  figures.angle_rad = figure(Angle, sum.upper[Angle]);
  if (isSharp() || sum.fold_at) return;
  figures.curvature_per_mm = figure(Curvature, sum.upper[Curvature]);
  figures.curvature_rel = figure(RelativeCurvature, sum.upper[RelativeCurvature]);
  if (!seam_.has_change) return;
  figures.curvature_change_per_mm2 = figure(Change, sum.upper[Change]);
  figures.curvature_change_rel = figure(RelativeChange, sum.upper[RelativeChange]);
}

/// The most important reason comes first.
std::string Figures::whyUncertified(const Summary& sum, const SeamFigures& figures,
                                    bool is_crease_known) const {
  if (sum.unknown_at) {
    const std::string pieces = seam_.exhausted ? fmt::format(" with {} pieces", seam_.looks) : "";
    return fmt::format("no bound was found at {:.6g}{}", *sum.unknown_at, pieces);
  }
  if (isFoldOpen(sum)) return "the faces may fold back on one another";
  if (!is_crease_known) return "the crease angle is passed near the middle of its length";
  if (!seam_.is_verdict_below_g2) {
    if (figures.curvature_rel && !figures.curvature_rel->upper)
      return "the curvature is not bounded";
    if (figures.curvature_change_rel && !figures.curvature_change_rel->upper)
      return "the change of curvature is not bounded";
  }
  if (seam_.exhausted)
    return fmt::format("the enclosures are still wide after {} pieces", seam_.looks);
  return "";
}

SeamFigures Figures::all() const {
  const Summary sum = summary();
  SeamFigures figures;
  addFigures(sum, figures);
  const Interval share = belowCreaseShare();
  // The judge asks whether half of the length is below the crease angle.
  const bool is_crease_known = !(share.lower <= 0.5 && share.upper > 0.5);
  figures.below_crease_share = share.middle();
  figures.plane_share = planeShare();
  figures.shares_known = is_crease_known && !isFoldOpen(sum);
  figures.degenerate = seam_.degenerate;
  addLeftOut(figures);
  figures.points = seam_.looks;
  figures.uncertified = whyUncertified(sum, figures, is_crease_known);
  const auto known = [](const std::optional<Figure>& figure) { return !figure || figure->upper; };
  figures.certified =
      known(figures.gap_mm) && known(figures.angle_rad) &&
      (figures.fold_at || seam_.is_verdict_below_g2 ||
       (known(figures.curvature_per_mm) && known(figures.curvature_rel) &&
        known(figures.curvature_change_per_mm2) && known(figures.curvature_change_rel)));
  return figures;
}

}  // namespace

std::vector<double> partsOf(const Piece& piece, const Interval& curvature_range) {
  std::vector<double> ends = {piece.from, piece.to};
  const auto& relative = piece.figures.curvature_rel;
  const bool has_bounds =
      std::isfinite(piece.excess) && (!relative || relative->upper < largest_relative_difference);
  const auto grade = [&](double nearest, double farthest, double end) {
    double distance = std::max(2 * nearest, pole_piece);
    for (; distance < farthest / 1.5; distance *= 2)
      ends.push_back(end == 0 ? distance : 1 - distance);
  };
  if (!has_bounds && curvature_range.lower > 0 && piece.to > 2 * piece.from)
    grade(piece.from, piece.to, 0);
  else if (!has_bounds && curvature_range.upper < 1 && 1 - piece.from > 2 * (1 - piece.to))
    grade(1 - piece.to, 1 - piece.from, 1);
  if (ends.size() == 2) ends.push_back(piece.at(0));
  std::ranges::sort(ends);
  return ends;
}

bool isAtPole(const Piece& piece, std::span<const DegeneratePoint> poles,
              const SideLength& length) {
  return std::ranges::any_of(poles, [&](const DegeneratePoint& pole) {
    return length.isShort(std::min(piece.from, pole.at), std::max(piece.to, pole.at), pole_piece);
  });
}

SeamFigures figuresOf(SeamPieces seam, const SideLength& length_a, const SideLength& length_b,
                      const FigureOptions& options) {
  std::ranges::sort(seam.pieces, {}, &Piece::from);
  return Figures(seam, length_a, length_b, options).all();
}

}  // namespace seamwright::enclosure
