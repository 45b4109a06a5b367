// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <seamwright/core/seam/survey.hpp>

namespace seamwright {

namespace {

enum Quantity { Gap, Angle, Curvature, RelativeCurvature, Change, RelativeChange, QuantityCount };

struct Sample {
  double t = 0;
  PairMeasure pair;
  std::array<std::optional<double>, QuantityCount> values;
};

using Span = std::vector<Sample>;

class Survey {
 public:
  Survey(const PairAt& pair_at, const ContinuityTolerance& tolerance, const SurveyOptions& options,
         double first, double last)
      : pair_at_(pair_at), tolerance_(tolerance), options_(options), first_(first), last_(last) {}

  void start(double from, double to, int count);
  void refine();
  SeamFigures figures() const;

 private:
  Sample sampleAt(double t);
  void note(const Sample& sample);
  double allowedError(Quantity quantity) const;
  bool mayHideMaximum(const Sample& before, const Sample& middle, const Sample& after) const;
  bool halveWhereNeeded(Span& span, double shortest);
  double fraction(double t) const { return (t - first_) / (last_ - first_); }
  /// Share of the length over which the predicate holds.
  template <class Predicate>
  double share(const Predicate& predicate) const;
  /// The intervals around samples without a value, each up to the neighbouring samples.
  LeftOut leftOut(Quantity quantity) const;

  const PairAt& pair_at_;
  const ContinuityTolerance& tolerance_;
  const SurveyOptions& options_;
  double first_;
  double last_;
  std::vector<Span> spans_;
  std::array<std::optional<Figure>, QuantityCount> maxima_;
  double largest_norm_ = 0;
  std::optional<double> fold_at_;
  std::vector<DegeneratePoint> degenerate_;
  int points_ = 0;
  bool settled_ = true;
};

Sample Survey::sampleAt(double t) {
  Sample sample{t, pair_at_(t), {}};
  ++points_;
  const PairMeasure& pair = sample.pair;
  sample.values[Gap] = pair.gap_mm;
  sample.values[Angle] = pair.angle_rad;
  if (pair.curvature && *pair.angle_rad <= tolerance_.crease_rad && !pair.fold) {
    sample.values[Curvature] = pair.curvature->difference_per_mm;
    sample.values[RelativeCurvature] =
        relativeDifference(*pair.curvature, tolerance_.flat_radius_mm);
    largest_norm_ =
        std::max({largest_norm_, pair.curvature->norm_a_per_mm, pair.curvature->norm_b_per_mm});
    if (pair.curvature_change) {
      sample.values[Change] = pair.curvature_change->difference_per_mm2;
      sample.values[RelativeChange] =
          relativeChange(*pair.curvature_change, *pair.curvature, tolerance_.flat_radius_mm);
    }
  }
  note(sample);
  return sample;
}

void Survey::note(const Sample& sample) {
  const double at = fraction(sample.t);
  for (int q = 0; q < QuantityCount; ++q)
    if (const auto& value = sample.values[q]; value && (!maxima_[q] || *value > maxima_[q]->lower))
      maxima_[q] = Figure{*value, std::nullopt, at};
  const PairMeasure& pair = sample.pair;
  if (pair.fold && pair.angle_rad && *pair.angle_rad <= tolerance_.crease_rad && !fold_at_)
    fold_at_ = at;
  if (pair.degenerate_a != Degeneracy::None || pair.degenerate_b != Degeneracy::None)
    degenerate_.push_back({at, pair.degenerate_a, pair.degenerate_b});
}

void Survey::start(double from, double to, int count) {
  // Samples lie just inside inner breaks, because derivatives may jump there.
  const double inset = 1e-7 * (to - from);
  const double a = from > first_ ? from + inset : from;
  const double b = to < last_ ? to - inset : to;
  Span span;
  for (int k = 0; k < count; ++k) {
    const double share = 0.5 * (1 - std::cos(std::numbers::pi * k / (count - 1)));
    span.push_back(sampleAt(k == count - 1 ? b : a + share * (b - a)));
  }
  spans_.push_back(std::move(span));
}

double Survey::allowedError(Quantity quantity) const {
  const double seen = maxima_[quantity] ? maxima_[quantity]->lower : 0;
  const double norm = std::max(largest_norm_, 1 / tolerance_.flat_radius_mm);
  const std::array<double, QuantityCount> floors = {tolerance_.gap_mm,
                                                    tolerance_.angle_rad,
                                                    tolerance_.curvature_rel * norm,
                                                    tolerance_.curvature_rel,
                                                    tolerance_.curvature_rel * norm * norm,
                                                    tolerance_.curvature_rel};
  return 0.005 * std::max(seen, floors[quantity]);  // half of the 1 % that surveySeam() promises
}

bool Survey::mayHideMaximum(const Sample& before, const Sample& middle, const Sample& after) const {
  const double share = (middle.t - before.t) / (after.t - before.t);
  for (int q = 0; q < QuantityCount; ++q) {
    const auto &f0 = before.values[q], &f1 = middle.values[q], &f2 = after.values[q];
    if (!f1 || (!f0 && !f2)) continue;
    // Next to a point without a value (a pole) the figure may continue to grow at the same rate.
    const double deviation =
        f0 && f2 ? std::abs(*f1 - (*f0 + share * (*f2 - *f0))) : *f1 - *(f0 ? f0 : f2);
    const double reach = std::max({f0.value_or(*f1), *f1, f2.value_or(*f1)}) + deviation;
    if (deviation > allowedError(static_cast<Quantity>(q)) && reach > maxima_[q]->lower)
      return true;
  }
  return false;
}

bool Survey::halveWhereNeeded(Span& span, double shortest) {
  std::vector<bool> halve(span.size() - 1, false);
  for (std::size_t i = 1; i + 1 < span.size(); ++i)
    if (mayHideMaximum(span[i - 1], span[i], span[i + 1])) halve[i - 1] = halve[i] = true;
  Span refined;
  bool changed = false;
  for (std::size_t i = 0; i < span.size(); ++i) {
    if (i > 0 && halve[i - 1] && span[i].t - span[i - 1].t > 2 * shortest) {
      if (points_ >= options_.max_points) {
        settled_ = false;
      } else {
        refined.push_back(sampleAt(0.5 * (span[i - 1].t + span[i].t)));
        changed = true;
      }
    }
    refined.push_back(std::move(span[i]));
  }
  span = std::move(refined);
  return changed;
}

void Survey::refine() {
  const double scale = std::ldexp(1.0 / options_.points_per_span, -options_.max_halvings);
  bool changed = true;
  while (changed && settled_) {
    changed = false;
    for (Span& span : spans_)
      changed = halveWhereNeeded(span, scale * (span.back().t - span.front().t)) || changed;
  }
}

template <class Predicate>
double Survey::share(const Predicate& predicate) const {
  double length = 0;
  double counted = 0;
  for (const Span& span : spans_)
    for (std::size_t i = 1; i < span.size(); ++i) {
      const double step = (span[i].pair.point - span[i - 1].pair.point).norm();
      length += step;
      counted += 0.5 * step * (predicate(span[i - 1]) + predicate(span[i]));
    }
  return length > 0 ? counted / length : 0;
}

LeftOut Survey::leftOut(Quantity quantity) const {
  LeftOut left_out;
  for (const Span& span : spans_)
    for (std::size_t i = 0; i < span.size(); ++i) {
      if (span[i].values[quantity]) continue;
      const double from = fraction(span[i > 0 ? i - 1 : i].t);
      const double to = fraction(span[i + 1 < span.size() ? i + 1 : i].t);
      if (!left_out.intervals.empty() && from <= left_out.intervals.back().upper)
        left_out.intervals.back().upper = to;
      else
        left_out.intervals.push_back({from, to});
      left_out.upper.reset();
    }
  return left_out;
}

SeamFigures Survey::figures() const {
  SeamFigures figures;
  figures.degenerate = degenerate_;
  figures.points = points_;
  const auto is_not_finite = [](const DegeneratePoint& point) {
    return point.side_a == Degeneracy::NotFinite || point.side_b == Degeneracy::NotFinite;
  };
  if (std::ranges::any_of(degenerate_, is_not_finite)) return figures;
  figures.gap_mm = maxima_[Gap];
  figures.angle_rad = maxima_[Angle];
  if (figures.angle_rad) figures.angle_left_out = leftOut(Angle);
  if (figures.angle_rad && figures.angle_rad->lower <= tolerance_.crease_rad) {
    figures.curvature_per_mm = maxima_[Curvature];
    figures.curvature_rel = maxima_[RelativeCurvature];
    if (figures.curvature_rel) figures.curvature_left_out = leftOut(RelativeCurvature);
    figures.curvature_change_per_mm2 = maxima_[Change];
    figures.curvature_change_rel = maxima_[RelativeChange];
  }
  figures.fold_at = fold_at_;
  figures.below_crease_share = share([&](const Sample& sample) {
    return sample.values[Angle] && *sample.values[Angle] <= tolerance_.crease_rad &&
           !sample.pair.fold;
  });
  figures.plane_share =
      share([](const Sample& sample) { return sample.values[Angle].has_value(); });
  figures.settled = settled_;
  return figures;
}

void validate(std::span<const double> breaks, const SurveyOptions& options) {
  if (breaks.size() < 2)
    throw std::invalid_argument("breaks " + std::to_string(breaks.size()) +
                                ": at least 2 are needed");
  for (std::size_t i = 1; i < breaks.size(); ++i)
    if (!(breaks[i] > breaks[i - 1]))
      throw std::invalid_argument(fmt::format("break {} is {} after {}: breaks must increase", i,
                                              breaks[i], breaks[i - 1]));
  if (options.points_per_span < 3)
    throw std::invalid_argument("points per span " + std::to_string(options.points_per_span) +
                                ": at least 3 are needed");
}

}  // namespace

SeamFigures surveySeam(const PairAt& pair_at, std::span<const double> breaks,
                       const ContinuityTolerance& tolerance, const SurveyOptions& options) {
  tolerance.validate();
  validate(breaks, options);
  Survey survey(pair_at, tolerance, options, breaks.front(), breaks.back());
  const int spans = static_cast<int>(breaks.size()) - 1;
  const int count = std::max(options.points_per_span, (options.first_points - 1) / spans + 1);
  for (std::size_t i = 1; i < breaks.size(); ++i) survey.start(breaks[i - 1], breaks[i], count);
  survey.refine();
  return survey.figures();
}

}  // namespace seamwright
