// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <seamwright/core/bezier/curve_difference.hpp>
#include <seamwright/core/bezier/stopped_ends.hpp>
#include <seamwright/core/blend/common_knots.hpp>
#include <seamwright/core/blend/correspondence.hpp>
#include <seamwright/core/blend/frame_fault.hpp>
#include <seamwright/core/join/curve/beta.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace match {

namespace {

/// Value and two derivatives.
using Jet1 = std::array<double, 3>;
using PointJet = std::array<Eigen::Vector3d, 3>;

/// Parameters this near are the same: shares of the length are known to some 1e-9.
constexpr double same_parameter = 1e-8;

/// A value over a parameter.
struct CourseNode {
  double at = 0, value = 0;
  bool may_kink = false;  ///< so may the function through them
};

/// The increasing function through values over nodes that is C^2 between kinks; see C12.3.
class MonotoneQuintic {
 public:
  /// \param closed the ends are one node: it may kink, or is C^2 there too.
  MonotoneQuintic(const std::vector<CourseNode>& nodes, bool closed) {
    for (const CourseNode& node : nodes) {
      nodes_.push_back(node.at);
      values_.push_back(node.value);
    }
    const std::size_t last = nodes_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const bool end = i == 0 || i == last;
      const double before = secant(i > 0    ? i - 1
                                   : closed ? last - 1
                                            : 0),
                   after = secant(i < last ? i
                                  : closed ? 0
                                           : last - 1);
      const double mean = 2 * before * after / (before + after);
      const bool kinks = nodes[i].may_kink || (end && !closed);
      slopes_.push_back(kinks ? Slopes{before, after} : Slopes{mean, mean});
    }
  }

  /// \param before a node counts to the interval before it.
  Jet1 at(double x, bool before = false) const {
    const double near = before ? -same_parameter : same_parameter;
    const auto above = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, x + near);
    const auto i = static_cast<std::size_t>(above - nodes_.begin()) - 1;
    const double h = nodes_[i + 1] - nodes_[i], t = (x - nodes_[i]) / h, s = 1 - t;
    const double rise = values_[i + 1] - values_[i];
    const double a = h * slopes_[i].after, b = h * slopes_[i + 1].before;
    // The quintic with value 0, slope a and second derivative 0 at 0; rise, b and 0 at 1.
    const double t3 = t * t * t;
    return {values_[i] + rise * t3 * (10 - 15 * t + 6 * t * t) +
                a * (t - t3 * (6 - 8 * t + 3 * t * t)) + b * t3 * (-4 + 7 * t - 3 * t * t),
            (30 * rise * t * t * s * s + a * (1 - t * t * (18 - 32 * t + 15 * t * t)) +
             b * t * t * (-12 + 28 * t - 15 * t * t)) /
                h,
            (60 * rise * t * s * (1 - 2 * t) - a * t * (36 - 96 * t + 60 * t * t) +
             b * t * (-24 + 84 * t - 60 * t * t)) /
                (h * h)};
  }

  /// The x of a value, by bisection to the last digit.
  double inverse(double value) const {
    double low = nodes_.front(), high = nodes_.back();
    for (;;) {
      const double middle = 0.5 * (low + high);
      if (middle <= low || middle >= high) return middle;
      (at(middle)[0] < value ? low : high) = middle;
    }
  }

 private:
  double secant(std::size_t i) const {
    return (values_[i + 1] - values_[i]) / (nodes_[i + 1] - nodes_[i]);
  }

  struct Slopes {
    double before, after;
  };

  std::vector<double> nodes_, values_;
  std::vector<Slopes> slopes_;
};

/// A frame by the common parameter p.
class Course {
 public:
  Course(const Measured& frame, MonotoneQuintic shares, std::size_t index)
      : frame_(frame), shares_(std::move(shares)), index_(index) {
    for (int i = 1; i < frame.spline().segments(); ++i)
      joints_.push_back(shares_.inverse(frame.share(i)));
  }

  const BezierSpline& spline() const { return frame_.spline(); }
  /// The parameters of the inner joints.
  const std::vector<double>& joints() const { return joints_; }
  /// The part over [p, q], in which no joint lies: joints are among p and q only.
  BezierCurve part(double p, double q) const {
    const int piece = place(0.5 * (p + q)).piece;
    const double start = parameterIn(piece, place(p)), end = parameterIn(piece, place(q));
    if (!(start < end))  // It is shorter than the accuracy of places.
      return BezierCurve(Poles(frame_.point({piece, start}).transpose()));
    const BezierCurve up_to_end = segment(spline(), piece).split(end).first;
    return up_to_end.split(start / end).second;
  }
  /// The jet at p, at a joint that of its side before or after it.
  PointJet jet(double p, bool before) const {
    const Jet1 share = shares_.at(p, before);
    Place at = place(p);
    if (before && at.t == 0 && at.piece > 0) at = {at.piece - 1, 1};
    const BezierCurve piece = segment(frame_.spline(), at.piece);
    // The curvature may be infinite where a piece stops at an end; the jet has none.
    if (const std::optional<Eigen::Vector3d> tangent = stoppedTangent(piece, at.t))
      return {piece.point(at.t), frame_.length_mm() * share[1] * *tangent,
              frame_.length_mm() * share[2] * *tangent};
    const CurveDerivatives x = piece.derivatives(at.t, 2);
    const double speed = x.row(1).norm();
    if (!(speed > 0))
      throw FrameFault(index_, fmt::format("frame {} ", index_),
                       fmt::format("stops in piece {} at {}", at.piece, at.t));
    const Eigen::Vector3d tangent = x.row(1).transpose() / speed, second = x.row(2).transpose();
    const Eigen::Vector3d bend = (second - second.dot(tangent) * tangent) / (speed * speed);
    const double rate = frame_.length_mm() * share[1];
    return {x.row(0).transpose(), rate * tangent,
            rate * rate * bend + frame_.length_mm() * share[2] * tangent};
  }

 private:
  /// The parameter of a place in a piece, 0 or 1 for places before and after it.
  static double parameterIn(int piece, const Place& place) {
    if (place.piece == piece) return place.t;
    return place.piece < piece ? 0 : 1;
  }
  /// The place of p: a joint if the parameter is that of a joint.
  Place place(double p) const {
    if (p <= 0) return {0, 0};
    if (p >= 1) return {frame_.spline().segments() - 1, 1};
    const auto joint = std::ranges::lower_bound(joints_, p - same_parameter);
    if (joint != joints_.end() && *joint <= p + same_parameter)
      return {static_cast<int>(joint - joints_.begin()) + 1, 0};
    return frame_.placeAt(std::clamp(shares_.at(p)[0], 0.0, 1.0));
  }

  const Measured& frame_;
  MonotoneQuintic shares_;
  std::size_t index_;
  std::vector<double> joints_;
};

/// The quintic over [p, q] with these jets.
BezierCurve quintic(const PointJet& start, const PointJet& end, double h) {
  Poles poles(6, 3);
  poles.row(0) = start[0].transpose();
  poles.row(1) = (start[0] + h / 5 * start[1]).transpose();
  poles.row(2) = (start[0] + 2 * h / 5 * start[1] + h * h / 20 * start[2]).transpose();
  poles.row(3) = (end[0] - 2 * h / 5 * end[1] + h * h / 20 * end[2]).transpose();
  poles.row(4) = (end[0] - h / 5 * end[1]).transpose();
  poles.row(5) = end[0].transpose();
  return BezierCurve(poles);
}

/// Common parameters at which some frame has a joint of lower order; with both ends.
std::vector<double> breaksOf(const std::vector<Course>& courses, double joint_tolerance) {
  std::set<double> breaks = {0, 1};
  for (const Course& course : courses) {
    for (int i = 1; i < course.spline().segments(); ++i) {
      const BetaFit fit = fitBeta(segment(course.spline(), i - 1), segment(course.spline(), i), 2);
      const bool smooth = fit.defects.size() == 3 && fit.beta.size() == 2 &&
                          *std::ranges::max_element(fit.defects) <= joint_tolerance;
      if (!smooth) breaks.insert(course.joints()[i - 1]);
    }
  }
  std::vector<double> result;
  for (const double p : breaks)
    if (result.empty() || p - result.back() > same_parameter) result.push_back(p);
  if (result.size() > 1) result.back() = 1;
  return result;
}

struct Segments {
  const std::vector<Course>& courses;
  double tolerance_mm;
  std::size_t max_segments;
  std::vector<double> knots = {0};
  std::vector<std::vector<BezierCurve>> curves;  ///< of each frame
  std::vector<double> distance_mm;
  bool reached = true;

  /// Bound of the distance of a segment over [p, q] from its part of a frame.
  double distance(const Course& course, const BezierCurve& curve, double p, double q) const {
    // A bound of a quarter of the tolerance is sharp enough; more digits take more divisions.
    const double enough_mm = 0.25 * tolerance_mm;
    double result = 0, start = p;
    BezierCurve rest = curve;
    std::vector<double> ends = course.joints();
    std::erase_if(ends, [&](double joint) { return joint <= p || joint >= q; });
    ends.push_back(q);
    for (const double end : ends) {
      const auto [here, after] = rest.split(end < q ? (end - start) / (q - start) : 1);
      result = std::max(
          result, correspondenceBound(course.part(start, end), here, enough_mm, tolerance_mm));
      rest = after;
      start = end;
    }
    return result;
  }

  void add(double p, double q) {
    std::vector<BezierCurve> made;
    std::vector<double> distances;
    for (const Course& course : courses) {
      made.push_back(quintic(course.jet(p, false), course.jet(q, true), q - p));
      distances.push_back(distance(course, made.back(), p, q));
    }
    const double middle = 0.5 * (p + q);
    const bool within = *std::ranges::max_element(distances) <= tolerance_mm;
    // Shorter segments have too few digits for second derivatives.
    constexpr double shortest = 1e-6;
    if (!within && knots.size() < max_segments && q - p > 2 * shortest) {
      add(p, middle);
      add(middle, q);
      return;
    }
    reached = reached && within;
    knots.push_back(q);
    for (std::size_t f = 0; f < courses.size(); ++f) {
      curves[f].push_back(std::move(made[f]));
      distance_mm[f] = std::max(distance_mm[f], distances[f]);
    }
  }
};

BezierSpline splineOf(const std::vector<BezierCurve>& curves, const std::vector<double>& knots,
                      bool closed) {
  Poles poles(5 * static_cast<Eigen::Index>(curves.size()) + 1, 3);
  for (std::size_t i = 0; i < curves.size(); ++i)
    poles.middleRows(5 * static_cast<Eigen::Index>(i), 6) = curves[i].poles();
  if (closed) poles.bottomRows<1>() = poles.topRows<1>();
  HomogeneousPoles homogeneous(poles.rows(), 4);
  homogeneous << poles, Eigen::VectorXd::Ones(poles.rows());
  return {5, knots, homogeneous, closed};
}

/// Places are known to a billionth of a piece.
void requireMeasurable(const Correspondence& correspondence, double tolerance_mm) {
  constexpr double share = 1e-9;
  for (std::size_t f = 0; f < correspondence.frames.size(); ++f) {
    const Measured& frame = correspondence.frames[f];
    double longest_mm = 0;
    for (int i = 0; i < frame.spline().segments(); ++i)
      longest_mm = std::max(longest_mm, (frame.share(i + 1) - frame.share(i)) * frame.length_mm());
    if (const double known_mm = share * longest_mm; tolerance_mm < known_mm)
      throw FrameFault(
          f, fmt::format("frame {}: ", f),
          fmt::format("the tolerance is {:.3g} mm, and places on the curve are known to {:.3g} mm",
                      tolerance_mm, known_mm));
  }
}

/// Whether all closed frames have a corner where they begin.
bool beginAtCorners(const std::vector<Measured>& frames) {
  return std::ranges::all_of(frames, [](const Measured& frame) {
    if (!frame.spline().closed) return false;
    const std::optional<double> angle_rad = measureJoints(frame.spline(), 1).back().angle_rad;
    return angle_rad && *angle_rad > MatchOptions().corner_rad;
  });
}

std::vector<Course> coursesOf(const Correspondence& correspondence) {
  const Scale scale = scaleOf(correspondence.anchors, correspondence.frames.size());
  const bool start_may_kink = (correspondence.start && correspondence.start->may_kink) ||
                              beginAtCorners(correspondence.frames);
  const std::size_t last = scale.common.size() - 1;
  std::vector<Course> courses;
  for (std::size_t f = 0; f < correspondence.frames.size(); ++f) {
    const Measured& frame = correspondence.frames[f];
    std::vector<CourseNode> nodes;
    for (std::size_t i = 0; i <= last; ++i) {
      const bool is_end = i == 0 || i == last;
      nodes.push_back({scale.common[i], scale.of_frame[f][i],
                       is_end ? start_may_kink : correspondence.anchors[i - 1].may_kink});
    }
    courses.emplace_back(frame, MonotoneQuintic(nodes, frame.spline().closed), f);
  }
  return courses;
}

}  // namespace

}  // namespace match

CommonKnots commonKnots(const std::vector<BezierSpline>& frames,
                        const CommonKnotsOptions& options) {
  if (!(options.tolerance_mm > 0) || !std::isfinite(options.tolerance_mm))
    refuse(fmt::format("the tolerance is {} mm: it must be positive and finite",
                       options.tolerance_mm));
  CommonKnots result;
  const match::Correspondence correspondence =
      match::corresponding(frames, options.match, match::same_place, result.summary);
  match::requireMeasurable(correspondence, options.tolerance_mm);
  const std::vector<match::Course> courses = match::coursesOf(correspondence);
  const std::size_t count = courses.size();
  match::Segments segments{.courses = courses,
                           .tolerance_mm = options.tolerance_mm,
                           .max_segments = static_cast<std::size_t>(options.max_segments),
                           .curves = std::vector<std::vector<BezierCurve>>(count),
                           .distance_mm = std::vector<double>(count, 0)};
  const std::vector<double> breaks = match::breaksOf(courses, options.joint_tolerance);
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    // A quintic over more than an eighth of a curve meets its tolerance by chance only.
    constexpr double longest = 0.125;
    const double length = breaks[i] - breaks[i - 1];
    const int parts = static_cast<int>(std::ceil(length / longest));
    for (int k = 0; k < parts; ++k)
      segments.add(breaks[i - 1] + length * k / parts,
                   k + 1 < parts ? breaks[i - 1] + length * (k + 1) / parts : breaks[i]);
  }
  for (const std::vector<BezierCurve>& curves : segments.curves)
    result.frames.push_back(match::splineOf(curves, segments.knots, frames[0].closed));
  result.distance_mm = segments.distance_mm;
  result.reached = segments.reached;
  result.summary.pieces_after = result.frames[0].segments();
  return result;
}

}  // namespace seamwright
