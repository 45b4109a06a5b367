// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/core/blend/loft_builder.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::loft {

namespace {

/// The highest order: 5 is possible by degree (18 in omega), but measures of joints end at 4 in
/// practice, where rounding leaves about half of the digits.
constexpr int max_loft_order = 4;
constexpr int max_bound_order = 8;

void requireInside(const char* name, const std::vector<double>& values, const Interval& omegas) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] >= omegas.lower && values[i] <= omegas.upper))
      refuse(fmt::format("{} {} is {}: it must lie within {} to {}", name, i, values[i],
                         omegas.lower, omegas.upper));
}

void requireRibbon(const char* name, const SheetEnd& end, Frames& frames) {
  if (end.order < 0 || end.order > 2)
    refuse(fmt::format("{}: order is {}: 0, 1 or 2 is possible", name, end.order));
  const auto one = [&](const char* part, const BezierSpline& curve) {
    requireValid(curve);
    const BezierSpline& position = end.ribbon.position;
    if (curve.segments() != frames.segments() || curve.closed != frames.closed())
      refuse(fmt::format("{} {}: {} segments, {}, the frames have {}, {}", name, part,
                         curve.segments(), curve.closed ? "closed" : "open", frames.segments(),
                         frames.closed() ? "closed" : "open"));
    if (curve.degree != position.degree || curve.knots != position.knots)
      refuse(
          fmt::format("{} {}: its degree and knots differ from those of the position", name, part));
    if (curve.poles.col(3) != Eigen::VectorXd::Ones(curve.poles.rows()))
      refuse(fmt::format("{} {}: a rational ribbon, all weights have to be 1", name, part));
  };
  one("position", end.ribbon.position);
  if (end.order > 0) one("first derivative", end.ribbon.first);
  if (end.order > 1) one("second derivative", end.ribbon.second);
}

/// The ribbon of the degree of the loft. \throws std::invalid_argument if it is not C^n.
BezierSpline smoothRibbon(const char* name, const BezierSpline& curve, int degree, int order) {
  BezierSpline result = raised(curve, degree);
  if (result.segments() == 1 && !result.closed) return result;
  if (const int reached = continuity(result, result.closed); reached < order)
    refuse(fmt::format("{}: of class C^{} at its joints, C^{} is needed", name, reached, order));
  return result;
}

}  // namespace

Frames::Frames(const FrameFunction& function, const Interval& omegas, int order)
    : function_(function) {
  if (!function) refuse("no function of the frames");
  const BezierSpline first = checked(omegas.lower);
  given_degree_ = first.degree;
  segments_ = first.segments();
  closed_ = first.closed;
  const bool joints = segments_ > 1 || closed_;
  degree_ = joints ? std::max(first.degree, 2 * order + 1) : first.degree;
  if (degree_ > max_spline_degree)
    refuse(fmt::format("degree {} is needed: {} is the highest", degree_, max_spline_degree));
  frames_.emplace(omegas.lower, raised(first, degree_));
}

const BezierSpline& Frames::at(double omega) {
  const auto known = frames_.find(omega);
  if (known != frames_.end()) return known->second;
  return frames_.emplace(omega, raised(checked(omega), degree_)).first->second;
}

void Frames::raiseTo(int degree) {
  if (degree <= degree_) return;
  if (degree > max_spline_degree)
    refuse(fmt::format("degree {} is needed: {} is the highest", degree, max_spline_degree));
  degree_ = degree;
  for (auto& [omega, frame] : frames_) frame = raised(frame, degree);
}

BezierSpline Frames::checked(double omega) const {
  BezierSpline frame = function_(omega);
  try {
    requireValid(frame);
  } catch (const std::invalid_argument& fault) {
    refuse(fmt::format("frame at omega {}: {}", omega, fault.what()));
  }
  if (segments_ > 0 &&
      (frame.degree != given_degree_ || frame.segments() != segments_ || frame.closed != closed_))
    refuse(
        fmt::format("frame at omega {}: degree {}, segments {}, {}; the first frame has degree "
                    "{}, segments {}, {}",
                    omega, frame.degree, frame.segments(), frame.closed ? "closed" : "open",
                    given_degree_, segments_, closed_ ? "closed" : "open"));
  return frame;
}

double poleDistance(const BezierSpline& a, const BezierSpline& b) {
  // Interpolation of equal weights rounds a few times for each.
  const double rounding = 64 * machine_epsilon;
  double result = 0;
  for (Eigen::Index i = 0; i < a.poles.rows(); ++i) {
    const double v = a.poles(i, 3), w = b.poles(i, 3);
    if (!(std::abs(v - w) <= rounding * w))
      refuse(fmt::format("weight {} varies with omega: {} and {}", i, v, w));
    result = std::max(result,
                      (a.poles.row(i).head<3>() / v - b.poles.row(i).head<3>() / w).stableNorm());
  }
  return result;
}

void requireOptions(const Interval& omegas, const FrameLoftOptions& options) {
  if (!std::isfinite(omegas.lower) || !std::isfinite(omegas.upper) ||
      !std::isnormal(omegas.width()) || !(omegas.upper > omegas.lower))
    refuse(fmt::format("omega runs from {} to {}: finite numbers that increase are needed",
                       omegas.lower, omegas.upper));
  if (options.order < 0 || options.order > max_loft_order)
    refuse(fmt::format("order is {}: 0 to {} is possible", options.order, max_loft_order));
  if (!(options.tolerance_mm > 0) || !std::isfinite(options.tolerance_mm))
    refuse(fmt::format("tolerance_mm is {}: it must be positive and finite", options.tolerance_mm));
  for (const auto& [name, value] : {std::pair{"first_spans", options.first_spans},
                                    {"max_spans", options.max_spans},
                                    {"checks", options.checks}})
    if (value < 1) refuse(fmt::format("{} is {}: at least 1 is needed", name, value));
  requireInside("station", options.stations, omegas);
  requireInside("kink", options.kinks, omegas);
  if (!options.derivative_bound) return;
  const FrameDerivativeBound& bound = *options.derivative_bound;
  if (bound.order < 1 || bound.order > max_bound_order)
    refuse(fmt::format("order of the derivative bound is {}: 1 to {} is possible", bound.order,
                       max_bound_order));
  if (!(bound.size >= 0)) refuse(fmt::format("derivative bound is {}", bound.size));
}

namespace {

/// Breaks of a loft, from kink to kink, and the surface that they give.
class Builder {
 public:
  Builder(const FrameFunction& function, const Interval& omegas, const Ends& ends,
          const FrameLoftOptions& options)
      : omegas_(omegas), ends_(ends), options_(options), frames_(function, omegas, options.order) {
    prepareEnds();
    prepareZones();
    firstStations();
    if (options_.closed) {
      const double gap = poleDistance(frames_.at(omegas.lower), frames_.at(omegas.upper));
      if (!(gap <= options_.tolerance_mm))
        refuse(fmt::format("closed: the frames at omega {} and {} are {} mm apart, allowed {}",
                           omegas.lower, omegas.upper, gap, options_.tolerance_mm));
    }
  }

  FrameLoft run() {
    for (int round = 0;; ++round) {
      checkProgress(options_.progress, shareAfter(round));
      build();
      const std::vector<double> added = faults();
      result_.frames = frames_.count();
      result_.reached = added.empty();
      if (added.empty() || spans() + static_cast<int>(added.size()) > options_.max_spans)
        return result_;
      stations_.insert(stations_.end(), added.begin(), added.end());
      std::sort(stations_.begin(), stations_.end());
      stations_.erase(std::unique(stations_.begin(), stations_.end()), stations_.end());
    }
  }

 private:
  int spans() const { return static_cast<int>(stations_.size()) - 1; }

  void prepareEnds() {
    int degree = frames_.degree();
    const auto prepare = [&](const char* name, std::optional<SheetEnd>& end) {
      if (!end) return;
      requireRibbon(name, *end, frames_);
      degree = std::max(degree, end->ribbon.position.degree);
    };
    prepare("start", ends_.start);
    prepare("end", ends_.end);
    frames_.raiseTo(degree);
    const auto raise = [&](const char* name, std::optional<SheetEnd>& end, double omega) {
      if (!end) return;
      FrameRibbon& ribbon = end->ribbon;
      ribbon.position = smoothRibbon(name, ribbon.position, degree, options_.order);
      if (end->order > 0) ribbon.first = smoothRibbon(name, ribbon.first, degree, options_.order);
      if (end->order > 1) ribbon.second = smoothRibbon(name, ribbon.second, degree, options_.order);
      const double gap = poleDistance(ribbon.position, frames_.at(omega));
      if (!(gap <= options_.tolerance_mm))
        refuse(fmt::format("{}: the profile is {} mm from the frame at omega {}, allowed {}", name,
                           gap, omega, options_.tolerance_mm));
    };
    raise("start", ends_.start, omegas_.lower);
    raise("end", ends_.end, omegas_.upper);
    if (ends_.start && ends_.end &&
        ends_.start->ribbon.position.knots != ends_.end->ribbon.position.knots)
      refuse("the ribbons of start and end have different knots");
  }

  void prepareZones() {
    const auto share = [](const std::optional<SheetEnd>& end) {
      return end && end->order > 0 ? end->zone : 0;
    };
    const double before = share(ends_.start), after = share(ends_.end);
    if (!(before >= 0) || !(after >= 0) || !(before + after <= 1))
      refuse(fmt::format("zones are {} and {}: shares of omega whose sum is at most 1 are needed",
                         before, after));
    // Zones that cover everything meet at one station.
    inside_.lower = omegas_.lower + before * omegas_.width();
    inside_.upper = before + after == 1 ? inside_.lower : omegas_.upper - after * omegas_.width();
    const auto outside = [&](const char* name, const std::vector<double>& values) {
      for (const double value : values)
        if (!inside_.contains(value) && value != omegas_.lower && value != omegas_.upper)
          refuse(fmt::format("{} {} is in the zone of an end: the sheet is free from {} to {}",
                             name, value, inside_.lower, inside_.upper));
    };
    outside("station", options_.stations);
    outside("kink", options_.kinks);
  }

  bool inZone(const Interval& span) const { return !inside_.contains(span.middle()); }

  void firstStations() {
    stations_ = {omegas_.lower, inside_.lower, inside_.upper, omegas_.upper};
    stations_.insert(stations_.end(), options_.stations.begin(), options_.stations.end());
    stations_.insert(stations_.end(), options_.kinks.begin(), options_.kinks.end());
    std::sort(stations_.begin(), stations_.end());
    stations_.erase(std::unique(stations_.begin(), stations_.end()), stations_.end());
    while (spans() < options_.first_spans) {
      Interval longest;
      for (std::size_t i = 0; i + 1 < stations_.size(); ++i)
        if (const Interval span{stations_[i], stations_[i + 1]};
            !inZone(span) && span.width() > longest.width())
          longest = span;
      const double middle = longest.middle();
      if (!(middle > longest.lower && middle < longest.upper)) return;
      stations_.insert(std::upper_bound(stations_.begin(), stations_.end(), middle), middle);
    }
  }

  bool isKink(double omega) const {
    return std::find(options_.kinks.begin(), options_.kinks.end(), omega) != options_.kinks.end();
  }

  /// The knots of the surface: of the ribbons, or the mean of those of the frames.
  std::vector<double> meanKnots() {
    if (ends_.start) return ends_.start->ribbon.position.knots;
    if (ends_.end) return ends_.end->ribbon.position.knots;
    std::vector<double> result = frames_.at(stations_.front()).knots;
    bool equal = true;
    for (const double omega : stations_) equal = equal && frames_.at(omega).knots == result;
    if (equal) return result;
    std::fill(result.begin(), result.end(), 0);
    const auto count = static_cast<double>(stations_.size());
    for (const double omega : stations_)
      for (std::size_t i = 0; i < result.size(); ++i)
        result[i] += frames_.at(omega).knots[i] / count;
    return result;
  }

  bool isSmooth(const BezierSpline& frame, const std::vector<double>& knots) const {
    if (frame.segments() == 1 && !frame.closed) return options_.order < frame.degree;
    return frame.knots == knots && options_.order < frame.degree &&
           continuity(frame, frame.closed) >= options_.order;
  }

  /// The form of the numbers; kept while the knots are the same.
  void chooseForm() {
    const std::vector<double> knots = meanKnots();
    bool smooth = true, rational = false;
    for (const double omega : stations_) {
      const BezierSpline& frame = frames_.at(omega);
      smooth = smooth && isSmooth(frame, knots);
      rational = rational || (frame.poles.col(3).array() != 1).any();
    }
    if (rational && !smooth)
      refuse(fmt::format("rational frames have to be C^{} by equal knots", options_.order));
    if (form_ && knots == shape_.knots && smooth == result_.smooth_frames) return;
    shape_ = {frames_.degree(), knots, frames_.closed(), options_.order};
    form_ = smooth ? smoothForm(shape_) : jointForm(shape_);
    result_.smooth_frames = smooth;
    rational_ = rational;
    numbers_.clear();
  }

  const Row& numbersAt(double omega) {
    const auto known = numbers_.find(omega);
    if (known != numbers_.end()) return known->second;
    Row row;
    try {
      row = form_->numbers(frames_.at(omega));
    } catch (const std::invalid_argument& fault) {
      refuse(fmt::format("frame at omega {}: {}", omega, fault.what()));
    }
    return numbers_.emplace(omega, std::move(row)).first->second;
  }

  void giveEnd(const std::optional<SheetEnd>& end, Eigen::Index row, OmegaData& data,
               EndDerivatives& given) {
    if (!end) return;
    data.values.row(row) = form_->smoothNumbers(end->ribbon.position);
    if (end->order > 0) given.first = form_->smoothDerivatives(end->ribbon.first);
    if (end->order > 1) given.second = form_->smoothDerivatives(end->ribbon.second);
  }

  /// The numbers over the stations first to last, between which there is no kink.
  OmegaSpline run(std::size_t first, std::size_t last) {
    OmegaData data;
    data.omegas.assign(stations_.begin() + static_cast<std::ptrdiff_t>(first),
                       stations_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto count = static_cast<Eigen::Index>(data.omegas.size());
    data.values.resize(count, numbersAt(stations_[first]).size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const double omega = data.omegas[static_cast<std::size_t>(i)];
      const bool again = options_.closed && omega == omegas_.upper;
      data.values.row(i) = numbersAt(again ? omegas_.lower : omega);
    }
    data.closed = options_.closed && first == 0 && last + 1 == stations_.size();
    if (first == 0) giveEnd(ends_.start, 0, data, data.start);
    if (last + 1 == stations_.size()) giveEnd(ends_.end, count - 1, data, data.end);
    return omegaSpline(data);
  }

  void build() {
    chooseForm();
    OmegaSpline all;
    kink_.assign(1, false);
    for (std::size_t first = 0; first + 1 < stations_.size();) {
      std::size_t last = first + 1;
      while (last + 1 < stations_.size() && !isKink(stations_[last])) ++last;
      OmegaSpline part = run(first, last);
      kink_.back() = first > 0;
      kink_.resize(kink_.size() + part.breaks.size() - 1, false);
      const Eigen::Index old = all.rows.rows(), skip = old > 0 ? 1 : 0;
      all.breaks.insert(all.breaks.end(), part.breaks.begin() + skip, part.breaks.end());
      all.rows.conservativeResize(old + part.rows.rows() - skip, part.rows.cols());
      all.rows.bottomRows(part.rows.rows() - skip) = part.rows.bottomRows(part.rows.rows() - skip);
      first = last;
    }
    breaks_ = all.breaks;
    form_poles_ = form_->poles(all);
    assemble();
  }

  void assemble() {
    const OmegaPoles poles = omegaPoles(breaks_, kink_, form_poles_.degree, form_poles_.rows);
    BSplineSurface& surface = result_.surface;
    surface.degree_u = shape_.degree;
    surface.degree_v = form_poles_.degree;
    surface.knots_u = form_->knotsAlong();
    surface.knots_v = poles.knots;
    const Eigen::Index rows = poles.rows.rows(), count = poles.rows.cols() / 4;
    surface.poles.resize(count * rows, 4);
    for (Eigen::Index i = 0; i < count; ++i)
      surface.poles.middleRows(i * rows, rows) = poles.rows.middleCols(4 * i, 4);
    if (shape_.closed) surface.poles.bottomRows(rows) = surface.poles.topRows(rows);
    result_.spans = static_cast<int>(breaks_.size()) - 1;
    result_.ratios_positive = form_poles_.unsafe.empty();
    requireValid(surface);
  }

  /// Chebyshev's nodes of a span.
  static std::vector<double> nodes(const Interval& span, int count) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i)
      result.push_back(span.middle() -
                       0.5 * span.width() * std::cos((i + 0.5) * std::numbers::pi / count));
    return result;
  }

  /// Lebesgue's constant of k of these nodes is at most 1 + (2 / pi) log k. The difference and its
  /// interpolant differ by at most (h/2)^k 2^(1-k) / k! times its k-th derivative.
  double provenOn(int span, double measured) const {
    const int k = options_.derivative_bound->order;
    const double h = breaks_[span + 1] - breaks_[span];
    const int q = form_poles_.degree;
    Eigen::MatrixXd rows = form_poles_.rows.middleRows(static_cast<Eigen::Index>(span) * q, q + 1);
    double factor = 1, share = 2;
    for (int i = 0; i < k; ++i) {
      factor *= std::max(q - i, 0) / h;
      share *= h / (4 * (i + 1));
      if (i < q) rows = (rows.bottomRows(q - i) - rows.topRows(q - i)).eval();
    }
    double own = 0;
    if (k <= q)
      for (Eigen::Index j = 0; j < rows.cols(); j += 4)
        own = std::max(own, rows.middleCols(j, 3).rowwise().norm().maxCoeff());
    return (1 + 2 / std::numbers::pi * std::log(k)) * measured +
           share * (options_.derivative_bound->size + factor * own);
  }

  /// Measures the spans; returns the stations to add.
  std::vector<double> faults() {
    result_.distance_mm = result_.zone_distance_mm = 0;
    result_.proven_mm.reset();
    const bool prove = options_.derivative_bound && !rational_;
    const int checks = prove ? options_.derivative_bound->order : options_.checks;
    double proven = 0;
    for (const double omega : stations_)
      if (inside_.contains(omega)) note(omega);
    std::vector<double> added;
    for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
      const auto piece = static_cast<int>(i);
      const Interval span{breaks_[i], breaks_[i + 1]};
      double worst = 0;
      if (inZone(span)) {
        for (const double omega : nodes(span, checks))
          result_.zone_distance_mm = std::max(result_.zone_distance_mm, distanceAt(omega));
        continue;
      }
      for (const double omega : nodes(span, checks)) worst = std::max(worst, note(omega));
      if (prove) worst = provenOn(piece, worst);
      proven = std::max(proven, worst);
      const bool safe = std::find(form_poles_.unsafe.begin(), form_poles_.unsafe.end(), piece) ==
                        form_poles_.unsafe.end();
      if (worst <= options_.tolerance_mm && safe) continue;
      added.push_back(splitAt(span));
    }
    if (prove) result_.proven_mm = proven;
    return added;
  }

  /// The middle of the interval of stations that holds the span.
  double splitAt(const Interval& span) const {
    const auto above = std::upper_bound(stations_.begin(), stations_.end(), span.middle());
    return Interval{*(above - 1), *above}.middle();
  }

  double distanceAt(double omega) {
    return poleDistance(isoCurve(result_.surface, omega, shape_.closed), frames_.at(omega));
  }

  double note(double omega) {
    const double distance = distanceAt(omega);
    if (distance >= result_.distance_mm) {
      result_.distance_mm = distance;
      result_.distance_at = omega;
    }
    return distance;
  }

  Interval omegas_;
  Interval inside_;  ///< between the zones of the ends
  Ends ends_;
  const FrameLoftOptions& options_;
  Frames frames_;
  std::vector<double> stations_, breaks_;
  std::vector<bool> kink_;  ///< of each break
  FrameShape shape_;
  std::unique_ptr<FrameForm> form_;
  bool rational_ = false;
  std::map<double, Row> numbers_;
  FormPoles form_poles_;
  FrameLoft result_;
};

}  // namespace

FrameLoft builtLoft(const FrameFunction& frame, const Interval& omegas, const Ends& ends,
                    const FrameLoftOptions& options) {
  requireOptions(omegas, options);
  return Builder(frame, omegas, ends, options).run();
}

}  // namespace seamwright::loft
