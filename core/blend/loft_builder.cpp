// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <seamwright/core/blend/frame_form.hpp>
#include <seamwright/core/blend/loft_builder.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::loft {

namespace {

/// The surface of a loft and the pieces in omega that it is made of.
struct Pieces {
  std::vector<double> breaks;
  FormPoles poles;
  bool rational = false;

  Interval span(int i) const { return {breaks[i], breaks[i + 1]}; }
  int count() const { return static_cast<int>(breaks.size()) - 1; }
};

/// Measures a loft at its checks.
class Check {
 public:
  Check(const FrameLoftOptions& options, Frames& frames, const Stations& stations,
        const Pieces& pieces, FrameLoft& result)
      : options_(options),
        frames_(frames),
        stations_(stations),
        pieces_(pieces),
        result_(result),
        prove_(options.derivative_bound && !pieces.rational) {}

  /// Measures all spans; returns the stations to add.
  std::vector<double> faults() {
    result_.distance_mm = result_.zone_distance_mm = 0;
    result_.proven_mm.reset();
    for (const double omega : stations_.all())
      if (stations_.counts(omega)) note(omega);
    double proven = 0;
    std::vector<double> added;
    for (int i = 0; i < pieces_.count(); ++i) {
      if (stations_.inZone(pieces_.span(i))) {
        for (const double omega : nodes(pieces_.span(i)))
          result_.zone_distance_mm = std::max(result_.zone_distance_mm, distanceAt(omega));
        continue;
      }
      double worst = 0;
      for (const double omega : nodes(pieces_.span(i))) worst = std::max(worst, note(omega));
      if (prove_) worst = provenOn(i, worst);
      proven = std::max(proven, worst);
      const std::vector<int>& unsafe = pieces_.poles.unsafe;
      if (worst <= options_.tolerance_mm &&
          std::find(unsafe.begin(), unsafe.end(), i) == unsafe.end())
        continue;
      added.push_back(stations_.halving(pieces_.span(i)));
    }
    if (prove_) result_.proven_mm = proven;
    return added;
  }

 private:
  /// Chebyshev's nodes of a span.
  std::vector<double> nodes(const Interval& span) const {
    const int count = prove_ ? options_.derivative_bound->order : options_.checks;
    std::vector<double> result;
    for (int i = 0; i < count; ++i)
      result.push_back(span.middle() -
                       0.5 * span.width() * std::cos((i + 0.5) * std::numbers::pi / count));
    return result;
  }

  /// Lebesgue's constant of k of these nodes is at most 1 + (2 / pi) log k. The difference and its
  /// interpolant differ by at most (h/2)^k 2^(1-k) / k! times its k-th derivative.
  double provenOn(int span, double measured) const {
    const int k = options_.derivative_bound->order, q = pieces_.poles.degree;
    const double h = pieces_.span(span).width();
    Eigen::MatrixXd rows =
        pieces_.poles.rows.middleRows(static_cast<Eigen::Index>(span) * q, q + 1);
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

  double distanceAt(double omega) {
    return poleDistance(isoCurve(result_.surface, omega, frames_.closed()), frames_.at(omega));
  }

  double note(double omega) {
    const double distance = distanceAt(omega);
    if (distance >= result_.distance_mm) {
      result_.distance_mm = distance;
      result_.distance_at = omega;
    }
    return distance;
  }

  const FrameLoftOptions& options_;
  Frames& frames_;
  const Stations& stations_;
  const Pieces& pieces_;
  FrameLoft& result_;
  bool prove_;
};

/// Builds the loft from its stations, and adds stations until it is near enough.
class Builder {
 public:
  Builder(const FrameFunction& function, const Interval& omegas, const Ends& ends,
          const FrameLoftOptions& options)
      : omegas_(omegas),
        options_(options),
        frames_(function, omegas, options.order),
        ends_(preparedEnds(ends, frames_, omegas, options)),
        stations_(omegas, ends_, options) {
    if (!options_.closed) return;
    const double gap = poleDistance(frames_.at(omegas.lower), frames_.at(omegas.upper));
    if (!(gap <= options_.tolerance_mm))
      refuse(fmt::format("closed: the frames at omega {} and {} are {} mm apart, allowed {}",
                         omegas.lower, omegas.upper, gap, options_.tolerance_mm));
  }

  FrameLoft run() {
    for (int round = 0;; ++round) {
      checkProgress(options_.progress, shareAfter(round));
      build();
      const std::vector<double> added =
          Check(options_, frames_, stations_, pieces_, result_).faults();
      result_.frames = frames_.count();
      result_.reached = added.empty();
      if (added.empty() || stations_.spans() + static_cast<int>(added.size()) > options_.max_spans)
        return result_;
      stations_.add(added);
    }
  }

 private:
  /// The knots of the surface: of the ribbons, or the mean of those of the frames.
  std::vector<double> meanKnots() {
    if (ends_.start) return ends_.start->ribbon.position.knots;
    if (ends_.end) return ends_.end->ribbon.position.knots;
    std::vector<double> result = frames_.at(stations_.all().front()).knots;
    bool equal = true;
    for (const double omega : stations_.all()) equal = equal && frames_.at(omega).knots == result;
    if (equal) return result;
    std::fill(result.begin(), result.end(), 0);
    const auto count = static_cast<double>(stations_.all().size());
    for (const double omega : stations_.all())
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
    for (const double omega : stations_.all()) {
      const BezierSpline& frame = frames_.at(omega);
      smooth = smooth && isSmooth(frame, knots);
      rational = rational || (frame.poles.col(3).array() != 1).any();
    }
    if (rational && !smooth)
      refuse(fmt::format("rational frames have to be C^{} by equal knots", options_.order));
    if (form_ && knots == shape_.knots && smooth == result_.smooth_frames) return;
    shape_ = {frames_.degree(), knots, frames_.closed(), options_.order, options_.joint_orders};
    const auto joints = static_cast<std::size_t>(shape_.segments()) - (shape_.closed ? 0 : 1);
    if (!shape_.joint_orders.empty() && shape_.joint_orders.size() != joints)
      refuse(fmt::format("orders of {} joints are given: the frames have {}",
                         shape_.joint_orders.size(), joints));
    form_ = smooth ? smoothForm(shape_) : jointForm(shape_);
    result_.smooth_frames = smooth;
    pieces_.rational = rational;
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
  OmegaSpline interpolated(std::size_t first, std::size_t last) {
    const std::vector<double>& stations = stations_.all();
    OmegaData data;
    data.omegas.assign(stations.begin() + static_cast<std::ptrdiff_t>(first),
                       stations.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    const auto count = static_cast<Eigen::Index>(data.omegas.size());
    data.values.resize(count, numbersAt(stations[first]).size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const double omega = data.omegas[static_cast<std::size_t>(i)];
      const bool again = options_.closed && omega == omegas_.upper;
      data.values.row(i) = numbersAt(again ? omegas_.lower : omega);
    }
    data.closed = options_.closed && first == 0 && last + 1 == stations.size();
    if (first == 0) giveEnd(ends_.start, 0, data, data.start);
    if (last + 1 == stations.size()) giveEnd(ends_.end, count - 1, data, data.end);
    return omegaSpline(data);
  }

  void build() {
    chooseForm();
    OmegaSpline all;
    kink_.assign(1, false);
    const std::vector<double>& stations = stations_.all();
    for (std::size_t first = 0; first + 1 < stations.size();) {
      std::size_t last = first + 1;
      while (last + 1 < stations.size() && !stations_.isKink(stations[last])) ++last;
      OmegaSpline part = interpolated(first, last);
      kink_.back() = first > 0;
      kink_.resize(kink_.size() + part.breaks.size() - 1, false);
      const Eigen::Index old = all.rows.rows(), skip = old > 0 ? 1 : 0;
      all.breaks.insert(all.breaks.end(), part.breaks.begin() + skip, part.breaks.end());
      all.rows.conservativeResize(old + part.rows.rows() - skip, part.rows.cols());
      all.rows.bottomRows(part.rows.rows() - skip) = part.rows.bottomRows(part.rows.rows() - skip);
      first = last;
    }
    pieces_.breaks = all.breaks;
    pieces_.poles = form_->poles(all);
    assemble();
  }

  void assemble() {
    const OmegaPoles poles =
        omegaPoles(pieces_.breaks, kink_, pieces_.poles.degree, pieces_.poles.rows);
    BSplineSurface& surface = result_.surface;
    surface.degree_u = shape_.degree;
    surface.degree_v = pieces_.poles.degree;
    surface.knots_u = form_->knotsAlong();
    surface.knots_v = poles.knots;
    const Eigen::Index rows = poles.rows.rows(), count = poles.rows.cols() / 4;
    surface.poles.resize(count * rows, 4);
    for (Eigen::Index i = 0; i < count; ++i)
      surface.poles.middleRows(i * rows, rows) = poles.rows.middleCols(4 * i, 4);
    if (shape_.closed) surface.poles.bottomRows(rows) = surface.poles.topRows(rows);
    result_.spans = static_cast<int>(pieces_.breaks.size()) - 1;
    result_.ratios_positive = pieces_.poles.unsafe.empty();
    requireValid(surface);
  }

  Interval omegas_;
  const FrameLoftOptions& options_;
  Frames frames_;
  Ends ends_;
  Stations stations_;
  FrameShape shape_;
  std::unique_ptr<FrameForm> form_;
  std::map<double, Row> numbers_;
  std::vector<bool> kink_;  ///< of each break
  Pieces pieces_;
  FrameLoft result_;
};

}  // namespace

FrameLoft builtLoft(const FrameFunction& frame, const Interval& omegas, const Ends& ends,
                    const FrameLoftOptions& options) {
  requireOptions(omegas, options);
  return Builder(frame, omegas, ends, options).run();
}

}  // namespace seamwright::loft
