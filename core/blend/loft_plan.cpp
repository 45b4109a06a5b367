// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <seamwright/core/blend/frame_form.hpp>
#include <seamwright/core/blend/loft_plan.hpp>
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

/// The part of omega outside of the zones of the ends.
Interval insideOf(const Interval& omegas, const Ends& ends, const FrameLoftOptions& options) {
  const auto share = [](const std::optional<SheetEnd>& end) {
    return end && end->order > 0 ? end->zone : 0;
  };
  const double before = share(ends.start), after = share(ends.end);
  if (!(before >= 0) || !(after >= 0) || !(before + after <= 1))
    refuse(fmt::format("zones are {} and {}: shares of omega whose sum is at most 1 are needed",
                       before, after));
  // Zones that cover everything meet at one station.
  const double lower = omegas.lower + before * omegas.width();
  const Interval inside{lower, before + after == 1 ? lower : omegas.upper - after * omegas.width()};
  const auto outside = [&](const char* name, const std::vector<double>& values) {
    for (const double value : values)
      if (!inside.contains(value) && value != omegas.lower && value != omegas.upper)
        refuse(fmt::format("{} {} is in the zone of an end: the sheet is free from {} to {}", name,
                           value, inside.lower, inside.upper));
  };
  outside("station", options.stations);
  outside("kink", options.kinks);
  return inside;
}

}  // namespace

void requireOptions(const Interval& omegas, const FrameLoftOptions& options) {
  if (!std::isfinite(omegas.lower) || !std::isfinite(omegas.upper) ||
      !std::isnormal(omegas.width()) || !(omegas.upper > omegas.lower))
    refuse(fmt::format("omega runs from {} to {}: finite numbers that increase are needed",
                       omegas.lower, omegas.upper));
  if (options.order < 0 || options.order > max_loft_order)
    refuse(fmt::format("order is {}: 0 to {} is possible", options.order, max_loft_order));
  for (std::size_t i = 0; i < options.joint_orders.size(); ++i)
    if (const int order = options.joint_orders[i]; order < 0 || order > options.order)
      refuse(
          fmt::format("order of joint {} is {}: 0 to {} is possible", i + 1, order, options.order));
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

Ends preparedEnds(Ends ends, Frames& frames, const Interval& omegas,
                  const FrameLoftOptions& options) {
  int degree = frames.degree();
  const auto check = [&](const char* name, const std::optional<SheetEnd>& end) {
    if (!end) return;
    requireRibbon(name, *end, frames);
    degree = std::max(degree, end->ribbon.position.degree);
  };
  check("start", ends.start);
  check("end", ends.end);
  frames.raiseTo(degree);
  const auto raise = [&](const char* name, std::optional<SheetEnd>& end, double omega) {
    if (!end) return;
    FrameRibbon& ribbon = end->ribbon;
    ribbon.position = smoothRibbon(name, ribbon.position, degree, options.order);
    if (end->order > 0) ribbon.first = smoothRibbon(name, ribbon.first, degree, options.order);
    if (end->order > 1) ribbon.second = smoothRibbon(name, ribbon.second, degree, options.order);
    const double gap = poleDistance(ribbon.position, frames.at(omega));
    if (!(gap <= options.tolerance_mm))
      refuse(fmt::format("{}: the profile is {} mm from the frame at omega {}, allowed {}", name,
                         gap, omega, options.tolerance_mm));
  };
  raise("start", ends.start, omegas.lower);
  raise("end", ends.end, omegas.upper);
  if (ends.start && ends.end &&
      ends.start->ribbon.position.knots != ends.end->ribbon.position.knots)
    refuse("the ribbons of start and end have different knots");
  return ends;
}

Stations::Stations(const Interval& omegas, const Ends& ends, const FrameLoftOptions& options)
    : inside_(insideOf(omegas, ends, options)), kinks_(options.kinks) {
  add({omegas.lower, inside_.lower, inside_.upper, omegas.upper});
  add(options.stations);
  add(options.kinks);
  while (spans() < options.first_spans) {
    Interval longest;
    for (std::size_t i = 0; i + 1 < stations_.size(); ++i)
      if (const Interval span{stations_[i], stations_[i + 1]};
          !inZone(span) && span.width() > longest.width())
        longest = span;
    const double middle = longest.middle();
    if (!(middle > longest.lower && middle < longest.upper)) return;
    add({middle});
  }
}

bool Stations::isKink(double omega) const {
  return std::find(kinks_.begin(), kinks_.end(), omega) != kinks_.end();
}

double Stations::halving(const Interval& span) const {
  const auto above = std::upper_bound(stations_.begin(), stations_.end(), span.middle());
  return Interval{*(above - 1), *above}.middle();
}

void Stations::add(const std::vector<double>& stations) {
  stations_.insert(stations_.end(), stations.begin(), stations.end());
  std::sort(stations_.begin(), stations_.end());
  stations_.erase(std::unique(stations_.begin(), stations_.end()), stations_.end());
}

}  // namespace seamwright::loft
