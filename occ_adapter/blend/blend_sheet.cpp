// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <seamwright/core/blend/hermite_sheet.hpp>
#include <seamwright/core/bspline/surface_jets.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/seam/measure.hpp>
#include <seamwright/occ_adapter/blend/blend_sheet.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

namespace {

/// The parameter up to which a curve, given by its derivatives at 0, has the length.
double parameterAtLength(const CurveDerivatives& derivatives, double length_mm) {
  static const GaussRule rule = gaussRule(12);
  const auto lengthTo = [&](double t) {
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      Eigen::RowVector3d slope = Eigen::RowVector3d::Zero();
      double power = 1;
      for (Eigen::Index k = 1; k < derivatives.rows(); ++k) {
        slope += power * derivatives.row(k);
        power *= rule.nodes[i] * t / static_cast<double>(k);
      }
      sum += rule.weights[i] * slope.norm();
    }
    return t * sum;
  };
  // The speed is least at 0, where it is 1: the other derivatives are normal to the first one.
  double low = 0, high = length_mm;
  constexpr int halvings = 60;  // more than a double has digits
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (lengthTo(middle) < length_mm ? low : high) = middle;
  }
  return high;
}

/// The distance of the sides, which is the speed of the surface across for a tension of 1.
double distanceAt(const BlendTask& task, const std::vector<SideSample>& at, double share) {
  const double distance_mm = (at[1].point - at[0].point).norm();
  // Where sides meet they open in proportion to the share.
  const double opening = (task.meets[0] ? share : 1) * (task.meets[1] ? 1 - share : 1);
  if (!(distance_mm > opening * task.tolerance.gap_mm))
    throw GeometryError(fmt::format(
        "at the share {:.3g} of their lengths, at ({:.6g}), the sides are {:.3g} mm apart: that is "
        "no more than the gap tolerance of {:.3g} mm",
        share, fmt::join(at[0].point, ", "), distance_mm, task.tolerance.gap_mm));
  return distance_mm;
}

/// The speed across of an end: at lateral boundaries it is that for the length of the curve.
double speedAt(const BlendTask& task, const std::vector<SideSample>& at, double share,
               const BlendEnd& end) {
  double distance_mm = distanceAt(task, at, share);
  for (const BlendLateral& lateral : task.laterals)
    distance_mm += weightBeside(lateral.side, share) * lateral.longer_mm;
  return end.tension * distance_mm;
}

LineBend bendAt(const BlendTask& task, int end, double share) {
  LineBend sum;
  for (const BlendLateral& lateral : task.laterals) {
    const double weight = weightBeside(lateral.side, share);
    sum.geodesic_per_mm += weight * lateral.bends[end].geodesic_per_mm;
    sum.third_per_mm2 += weight * lateral.bends[end].third_per_mm2;
  }
  return sum;
}

std::vector<SideSample> samplesAt(const BlendTask& task, double share) {
  std::vector<SideSample> at;
  for (int k = 0; k < task.count(); ++k) {
    at.push_back(task.sides[k].at(share, share < 1));
    const bool is_path = at[k].point.allFinite() && at[k].derivative.allFinite();
    if (!is_path || !at[k].beyond.allFinite())
      throw GeometryError(fmt::format(
          "{}: at the share {:.3g}, on edge {}, {}", task.ends[k].side.name, share,
          task.sides[k].edgeAt(share),
          is_path ? "the face has no tangent plane" : "the edge stands still or jumps"));
  }
  return at;
}

/// The derivatives by the parameter across, of each end, at a share of the sides.
std::vector<CurveDerivatives> derivativesAt(const BlendTask& task, double share) {
  const std::vector<SideSample> at = samplesAt(task, share);
  std::vector<CurveDerivatives> result;
  for (int k = 0; k < task.count(); ++k) {
    // Both ends run with the parameter: out of the face at the start, into it at the end.
    result.push_back(
        continuation(at[k], k == 0 ? 1 : -1, task.ends[k].order, bendAt(task, k, share)));
    const double speed_mm = task.count() < 2 ? parameterAtLength(result[k], task.length_mm)
                                             : speedAt(task, at, share, task.ends[k]);
    for (int order = 1; order <= task.ends[k].order; ++order)
      result[k].row(order) *= std::pow(speed_mm, order);
    if (!result[k].allFinite())
      throw GeometryError(
          fmt::format("{}: at the share {:.3g} the face has no curvature, or the {} is too large",
                      task.ends[k].side.name, share, task.count() < 2 ? "length" : "tension"));
  }
  return result;
}

/// What the position of a side lacks where both meet: half of what they are apart there.
Eigen::Vector3d towardMeeting(const BlendTask& task, int k, double share) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int end : {0, 1})
    if (task.meets[end])
      sum += weightBeside(end == 0 ? LateralSide::First : LateralSide::Last, share) * 0.5 *
             (task.sides[1 - k].at(end, end == 0).point - task.sides[k].at(end, end == 0).point);
  return sum;
}

/// A cubic of the share with the values 0 and the derivatives of the first derivative across where
/// the sides meet: the speed grows in proportion to the share.
class MeetingSlopes {
 public:
  MeetingSlopes(const BlendTask& task, int k) {
    for (const int end : {0, 1}) {
      if (!task.meets[end]) continue;
      const std::vector<SideSample> at = samplesAt(task, end);
      const double opening_mm = (at[1].derivative - at[0].derivative).norm();
      slopes_[end] = task.ends[k].tension * opening_mm * lineFrame(at[k], k == 0 ? 1 : -1).across;
    }
  }
  Eigen::Vector3d at(double share) const {
    const double back = 1 - share;
    return share * back * (back * slopes_[0] + share * slopes_[1]);
  }

 private:
  std::array<Eigen::Vector3d, 2> slopes_ = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

/// The ribbons of sides that meet: near a corner the derivative of order k across vanishes with
/// that power of the share, and the first one has its exact direction. So curvatures, which are
/// quotients of these, stay bounded.
std::vector<SheetRibbon> meetingRibbons(const BlendTask& task, const std::vector<double>& knots) {
  const GrevilleInterpolation positions(task.degree, knots, task.closure);
  std::vector<SheetRibbon> ribbons;
  for (int k = 0; k < task.count(); ++k) {
    const MeetingSlopes slopes(task, k);
    Eigen::MatrixXd points(positions.parameters().size(), 3), cubic(points.rows(), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const double share = positions.parameters()[i];
      points.row(i) = task.sides[k].at(share, share < 1).point + towardMeeting(task, k, share);
      cubic.row(i) = slopes.at(share);
    }
    ribbons.push_back({task.degree, knots, {positions.poles(points)}});
    for (int order = 1; order <= task.ends[k].order; ++order) {
      const int zeros = std::max(2, order);
      const ZeroEndInterpolation fields(task.degree, knots, task.meets[0] ? zeros : 0,
                                        task.meets[1] ? zeros : 0);
      Eigen::MatrixXd values(fields.parameters().size(), 3);
      for (Eigen::Index i = 0; i < values.rows(); ++i) {
        const double share = fields.parameters()[i];
        values.row(i) = derivativesAt(task, share)[k].row(order);
        if (order == 1) values.row(i) -= slopes.at(share).transpose();
      }
      Eigen::MatrixXd poles = fields.poles(values);
      if (order == 1) poles += positions.poles(cubic);
      ribbons[k].derivatives.emplace_back(poles);
    }
  }
  return ribbons;
}

BSplineSurface sheetOver(const BlendTask& task, const std::vector<double>& knots) {
  if (task.meets[0] || task.meets[1]) {
    const std::vector<SheetRibbon> ribbons = meetingRibbons(task, knots);
    return hermiteSheet(ribbons[0], ribbons[1]);
  }
  const GrevilleInterpolation interpolation(task.degree, knots, task.closure);
  const std::vector<double>& parameters = interpolation.parameters();
  std::vector<Eigen::MatrixXd> values;
  for (const BlendEnd& end : task.ends) values.emplace_back(parameters.size(), 3 * (end.order + 1));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::vector<CurveDerivatives> derivatives = derivativesAt(task, parameters[i]);
    for (int k = 0; k < task.count(); ++k)
      values[k].row(static_cast<Eigen::Index>(i)) = derivatives[k].reshaped<Eigen::RowMajor>();
  }
  std::vector<SheetRibbon> ribbons;
  for (int k = 0; k < task.count(); ++k) {
    const Eigen::MatrixXd poles = interpolation.poles(values[k]);
    ribbons.push_back({.degree = task.degree, .knots = knots, .derivatives = {}});
    for (int order = 0; order <= task.ends[k].order; ++order)
      ribbons[k].derivatives.emplace_back(poles.middleCols(3 * order, 3));
  }
  return task.count() < 2 ? taylorSheet(ribbons[0]) : hermiteSheet(ribbons[0], ribbons[1]);
}

/// The largest figure at a point of an end over its tolerance.
double excessAt(const BlendTask& task, const SurfaceJets& sheet, int k, double share) {
  const SideSample sample = task.sides[k].at(share, share < 1);
  const bool third = task.ends[k].order == most_blend_order;
  const SidePoint of_face{sample.jet, {}, sample.derivative, true, third},
      of_sheet{sheet.at(share, k), {}, sample.derivative, true, third};
  const PairMeasure figures = measurePair(of_face, of_sheet);
  const ContinuityTolerance& tolerance = task.aim(k);
  double excess = figures.gap_mm.value_or(HUGE_VAL) / tolerance.gap_mm;
  if (task.ends[k].order > 0)
    excess = std::max(excess, figures.angle_rad.value_or(HUGE_VAL) / tolerance.angle_rad);
  if (task.ends[k].order > 1 && figures.curvature)
    excess = std::max(excess, relativeDifference(*figures.curvature, tolerance.flat_radius_mm) /
                                  tolerance.curvature_rel);
  if (task.ends[k].order > 2 && figures.curvature && figures.curvature_change)
    excess = std::max(excess, relativeChange(*figures.curvature_change, *figures.curvature,
                                             tolerance.flat_radius_mm) /
                                  tolerance.curvature_rel);
  return excess;
}

/// A span in which a seam is beyond its share of the tolerance.
struct PoorSpan {
  double from = 0, to = 0;
  double excess = 0;
};

struct PoorSpans {
  std::vector<PoorSpan> divisible;  ///< the worst first
  double stuck_excess = 0;          ///< the largest of those that are too short to be halved
};

PoorSpans poorSpans(const BlendTask& task, const BSplineSurface& sheet, const SheetKnots& knots,
                    double share_of_aim) {
  // Seams are worst beside breaks and at ends.
  constexpr std::array<double, 8> samples = {1e-4, 0.03, 0.15, 0.38, 0.62, 0.85, 0.97, 1 - 1e-4};
  // Where a derivative of the face jumps no spline is near enough. The figures of second order need
  // second differences, those of third order third ones: over shorter spans they have fewer than
  // half of the digits.
  const auto is_third = [](const BlendEnd& end) { return end.order == most_blend_order; };
  const double shortest = std::ranges::any_of(task.ends, is_third) ? 1.0 / 512 : 1.0 / 65536;
  const SurfaceJets jets(sheet);
  PoorSpans result;
  const std::map<double, int>& at = knots.multiplicities();
  for (auto from = at.begin(), to = std::next(from); to != at.end(); from = to++) {
    PoorSpan span{from->first, to->first};
    const auto look = [&](double share) {
      for (int k = 0; k < task.count(); ++k)
        span.excess = std::max(span.excess, excessAt(task, jets, k, share));
    };
    for (const double sample : samples) {
      // Nearer to a corner where sides meet, second differences have no digits.
      constexpr double near = 0.01;
      if ((task.meets[0] && span.from == 0 && sample < near) ||
          (task.meets[1] && span.to == 1 && sample > 1 - near))
        continue;
      look(span.from + sample * (span.to - span.from));
    }
    for (const double within : knots.breaksWithin(span.from, span.to)) look(within);
    if (!(span.excess > share_of_aim)) continue;
    if (span.to - span.from < shortest)
      result.stuck_excess = std::max(result.stuck_excess, span.excess);
    else
      result.divisible.push_back(span);
  }
  std::ranges::sort(result.divisible, std::greater(), &PoorSpan::excess);
  return result;
}

/// The multiplicity of a knot at a break of a side; 1 where only derivatives above the second jump.
int multiplicityAt(const BlendSide& side, double at, int degree) {
  // Of the side: far above rounding, and so near that smooth curvature changes by less than
  // another sixth digit. A jump below the fourth digit is below every tolerance.
  constexpr double beside = 1e-7, least_jump = 1e-4;
  const SideSample before = side.at(at - beside), after = side.at(at + beside);
  const Eigen::Matrix3d one = curvatureTensor(before.jet, before.normal),
                        other = curvatureTensor(after.jet, after.normal);
  const auto differ = [&](const auto& a, const auto& b) {
    return !((a - b).norm() <= least_jump * std::max(a.norm(), b.norm()));
  };
  // The path may turn, and derivatives of the directions jump.
  if (differ(one, other) || differ(before.derivative, after.derivative)) return degree;
  // What second derivatives of the path differ by, without what the third ones make of it.
  const auto jump = [&](double step) -> Eigen::Vector3d {
    return (side.at(at + step).derivative - after.derivative -
            (before.derivative - side.at(at - step).derivative)) /
           step;
  };
  constexpr double step = 1e-4, least_bend = 1e-2;  // of the side; of its second derivative
  const Eigen::Vector3d bend = 2 * jump(0.5 * step) - jump(step);
  const double size =
      (side.at(at + step).derivative - side.at(at - step).derivative).norm() / (2 * step);
  return bend.norm() > least_bend * (size + after.derivative.norm()) ? degree - 1 : 1;
}

/// Where normals turn over along a line across the sheet.
std::optional<SheetFold> foldAlong(const SurfaceJets& sheet, double u) {
  constexpr int steps = 24;
  Eigen::Vector3d before = Eigen::Vector3d::Zero(), last = sheet.at(u, 0, 0).p;
  double distance_mm = 0;
  for (int i = 0; i <= steps; ++i) {
    const SurfaceJet there = sheet.at(u, static_cast<double>(i) / steps, 1);
    distance_mm += (there.p - last).norm();
    last = there.p;
    const Eigen::Vector3d normal = there.u.cross(there.v);
    if (normal.dot(before) < 0) return SheetFold{distance_mm, there.p};
    before = normal;
  }
  return std::nullopt;
}

}  // namespace

double weightBeside(LateralSide side, double u) {
  return std::pow(side == LateralSide::First ? 1 - u : u, 3);
}

bool BlendTask::mayBeCubic() const {
  return laterals.empty() && !meets[0] && !meets[1] &&
         std::ranges::all_of(ends, [](const BlendEnd& end) { return end.order <= 2; });
}

SheetKnots::SheetKnots(const BlendTask& task)
    : degree_(task.degree), multiplicities_{{0, degree_ + 1}, {1, degree_ + 1}} {
  constexpr double end = 1e-6;  // nearer, there is no room for the differences
  // G3 holds third derivatives, so that every break counts.
  const bool is_third = std::ranges::any_of(
      task.ends, [](const BlendEnd& of) { return of.order == most_blend_order; });
  for (const BlendSide& side : task.sides)
    for (const auto& places : {side.joints(), side.breaks()})
      for (const double at : places) {
        if (at < end || at > 1 - end) continue;
        const int multiplicity = multiplicityAt(side, at, degree_);
        if (is_third)
          add(at, std::max(multiplicity, degree_ - 1));
        else if (multiplicity > 1)
          add(at, multiplicity);
        else
          breaks_.push_back(at);
      }
  std::ranges::sort(breaks_);
  fill();
}

SheetKnots::SheetKnots(int degree, const std::map<double, int>& inner)
    : degree_(degree), multiplicities_{{0, degree + 1}, {1, degree + 1}} {
  for (const auto& [at, multiplicity] : inner) add(at, multiplicity);
  fill();
}

std::vector<double> SheetKnots::breaksWithin(double from, double to) const {
  const auto first = std::ranges::upper_bound(breaks_, from),
             last = std::ranges::lower_bound(breaks_, to);
  return first < last ? std::vector(first, last) : std::vector<double>();
}

void SheetKnots::divide(double from, double to) {
  const double middle = 0.5 * (from + to);
  const std::vector<double> inside = breaksWithin(from, to);
  const auto nearest =
      std::ranges::min_element(inside, {}, [&](double at) { return std::abs(at - middle); });
  // A choice: spans that are much shorter than those beside are as little use as knots elsewhere.
  constexpr double near = 0.25;
  if (nearest == inside.end() || std::abs(*nearest - middle) > near * (to - from))
    return halve(from, to);
  std::erase(breaks_, *nearest);
  add(*nearest, 1);
}

void SheetKnots::refine(double from, double to) {
  if (degree_ == 3) return divide(from, to);
  // Choices: over longer spans splines are near enough in spite of most breaks, and knots that are
  // much nearer to one another than the span is long make spikes of curvature.
  constexpr double short_span = 1.0 / 48, least_part = 0.1;
  const std::vector<double> inside = breaksWithin(from, to);
  if (inside.empty() || to - from > short_span) return halve(from, to);
  double last = from;
  for (const double at : inside) {
    std::erase(breaks_, at);
    if (std::min(at - last, to - at) < least_part * (to - from)) continue;
    // Second derivatives are continuous there, and stay so.
    add(at, degree_ - 2);
    last = at;
  }
  if (last == from) halve(from, to);
}

void SheetKnots::fill() {
  // A boundary with fewer spans meets its tolerance by chance only.
  constexpr double longest = 0.25;
  for (auto from = multiplicities_.begin();
       degree_ == 3 && std::next(from) != multiplicities_.end();)
    if (const double to = std::next(from)->first; to - from->first > longest)
      divide(from->first, to);
    else
      ++from;
  const std::map<double, int> needed = multiplicities_;
  for (auto from = needed.begin(), to = std::next(from); to != needed.end(); from = to++) {
    const double length = to->first - from->first;
    const int parts = static_cast<int>(std::ceil(length / longest));
    for (int i = 1; i < parts; ++i) multiplicities_[from->first + length * i / parts] = 1;
  }
  grade();
}

void SheetKnots::grade() {
  // Slopes at a knot between a long and a short span are as good as in the long one; divided by the
  // length of the short one they are its error of curvature.
  constexpr double most = 4;
  for (auto from = multiplicities_.begin(); std::next(from) != multiplicities_.end();) {
    const auto to = std::next(from);
    const double length = to->first - from->first;
    double beside = length;
    if (from != multiplicities_.begin()) beside = from->first - std::prev(from)->first;
    if (std::next(to) != multiplicities_.end())
      beside = std::min(beside, std::next(to)->first - to->first);
    if (length <= most * beside) {
      ++from;
      continue;
    }
    halve(from->first, to->first);
    if (from != multiplicities_.begin()) --from;  // its span may be too long now
  }
}

void SheetKnots::add(double at, int multiplicity) {
  // Sums of lengths round by less, and splines over shorter spans have no digits left.
  constexpr double same = 1e-6;
  const auto after = multiplicities_.lower_bound(at);
  for (const auto& near : {after, std::prev(after)})
    if (near != multiplicities_.end() && std::abs(near->first - at) <= same) {
      near->second = std::max(near->second, multiplicity);
      return;
    }
  multiplicities_[at] = multiplicity;
}

std::vector<double> SheetKnots::flat() const {
  std::vector<double> result;
  for (const auto& [at, multiplicity] : multiplicities_)
    result.insert(result.end(), multiplicity, at);
  return result;
}

BSplineSurface firstSheet(const BlendTask& task) {
  return sheetOver(task, SheetKnots(task).flat());
}

RefinedSheet refinedSheet(const BlendTask& task, double share_of_aim, int max_spans,
                          SheetKnots& knots, const Progress& progress, int max_poles) {
  for (int round = 0;; ++round) {
    checkProgress(progress, shareAfter(round));
    BSplineSurface sheet = sheetOver(task, knots.flat());
    const PoorSpans poor = poorSpans(task, sheet, knots, share_of_aim);
    const int more = std::min({static_cast<int>(poor.divisible.size()), max_spans - knots.spans(),
                               max_poles - knots.poles()});
    if (more <= 0) {
      const double left = poor.divisible.empty() ? 0 : poor.divisible[0].excess;
      return {std::move(sheet), std::max(left, poor.stuck_excess)};
    }
    for (int i = 0; i < more; ++i) knots.refine(poor.divisible[i].from, poor.divisible[i].to);
    knots.grade();
  }
}

std::optional<SheetFold> foldOf(const BSplineSurface& sheet) {
  constexpr int parts = 8;  // of a span: a choice
  const SurfaceJets jets(sheet);
  std::optional<SheetFold> nearest;
  for (std::size_t i = 0; i + 1 < sheet.knots_u.size(); ++i) {
    const double from = sheet.knots_u[i], length = sheet.knots_u[i + 1] - from;
    for (int part = 0; length > 0 && part < parts; ++part) {
      const auto fold = foldAlong(jets, from + length * (part + 0.5) / parts);
      if (fold && (!nearest || fold->distance_mm < nearest->distance_mm)) nearest = fold;
    }
  }
  return nearest;
}

}  // namespace seamwright::occ
