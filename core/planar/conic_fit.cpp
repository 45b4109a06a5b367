// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <seamwright/core/fair/curvature_profile.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/planar/conic_distance.hpp>
#include <seamwright/core/planar/conic_fit.hpp>
#include <seamwright/core/planar/conic_pair.hpp>

namespace seamwright {

namespace {

using Eigen::Vector2d;

/// Point, direction and curvature at a parameter. The curvature 0 leaves it to the conics.
struct FitFrame {
  Vector2d point;
  double direction_rad = 0, curvature_per_mm = 0;
};

/// A curve of N segments with the parameter u from 0 to N; segment i runs from i to i + 1.
class ConicFitCurve {
 public:
  explicit ConicFitCurve(const BezierSpline& spline) {
    for (int i = 0; i < spline.segments(); ++i) {
      const BezierCurve one = segment(spline, i);
      const Poles poles = one.poles();
      if (poles.col(2).any())
        refuse(fmt::format("segment {} is outside of the plane z = 0: it has a pole at z = {} mm",
                           i, poles.col(2).cwiseAbs().maxCoeff()));
      segments_.push_back(one);
      polynomials_.push_back(curvePolynomials(one, poles.row(0)));
      origins_.emplace_back(poles.row(0).head<2>());
      lines_.push_back(onLine(poles));
    }
  }

  int count() const { return static_cast<int>(segments_.size()); }
  const BezierCurve& segmentAt(int i) const { return segments_[static_cast<std::size_t>(i)]; }
  bool isLine(int i) const { return lines_[static_cast<std::size_t>(i)]; }

  /// At t in segment i.
  FitFrame frame(int i, double t) const {
    const CurveDerivatives d = segmentAt(i).derivatives(t, 2);
    const Vector2d first = d.row(1).head<2>(), second = d.row(2).head<2>();
    const double speed = first.norm();
    if (!(speed > 0))
      throw std::domain_error(
          fmt::format("the curve stops in segment {} at the parameter {}: it has no tangent there",
                      i, t));
    return {.point = d.row(0).head<2>(),
            .direction_rad = directionOf(first),
            .curvature_per_mm = isLine(i) ? 0 : cross(first, second) / std::pow(speed, 3)};
  }
  FitFrame at(double u) const {
    const int i = std::min(static_cast<int>(u), count() - 1);
    return frame(i, u - i);
  }

  std::vector<CurvePiece> part(double u0, double u1) const {
    std::vector<CurvePiece> pieces;
    for (int i = static_cast<int>(u0); i < count() && i < u1; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Interval domain = {std::max(u0 - i, 0.0), std::min(u1 - i, 1.0)};
      if (domain.width() > 0)
        pieces.push_back(
            {.polynomials = polynomials_[k], .origin = origins_[k], .domain = domain});
    }
    return pieces;
  }

 private:
  static bool onLine(const Poles& poles) {
    const Vector2d start = poles.row(0).head<2>(),
                   chord = poles.row(poles.rows() - 1).head<2>().transpose() - start;
    // Coordinates have roundings; a curve this flat is a line for every use.
    constexpr double flat = 1e-12;
    const double noise = flat * poles.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 1; i + 1 < poles.rows(); ++i) {
      const Vector2d from = poles.row(i).head<2>().transpose() - start;
      if (std::abs(cross(chord.normalized(), from)) > noise) return false;
    }
    return true;
  }

  std::vector<BezierCurve> segments_;
  std::vector<CurvePolynomials> polynomials_;
  std::vector<Vector2d> origins_;
  std::vector<bool> lines_;
};

enum class FitBreak { None, Smooth, G1, Corner };

/// A point of the curve where conics have to meet.
struct FitNode {
  double u = 0;
  FitBreak kind = FitBreak::Smooth;
  FitFrame before, after;
};

/// The joint between two segments. Curvatures within a millionth are the same.
FitNode jointNode(const ConicFitCurve& curve, int before, int after, double corner_rad) {
  FitNode node{.u = static_cast<double>(after),
               .before = curve.frame(before, 1),
               .after = curve.frame(after, 0)};
  double &d0 = node.before.direction_rad, &d1 = node.after.direction_rad;
  double &k0 = node.before.curvature_per_mm, &k1 = node.after.curvature_per_mm;
  const double turn_rad = wrapped(d1 - d0);
  if (std::abs(turn_rad) > corner_rad) {
    node.kind = FitBreak::Corner;
    return node;
  }
  // Both sides share the mean direction; a line keeps its own.
  const double shared = curve.isLine(before)  ? d0
                        : curve.isLine(after) ? d1
                                              : d0 + turn_rad / 2;
  d0 = d1 = shared;
  if (curve.isLine(before) && curve.isLine(after)) return node;
  if (!(k0 * k1 > 0)) {
    node.kind = FitBreak::G1;
    return node;
  }
  constexpr double same = 1e-6, same_rad = 1e-9;
  if (std::abs(k1 - k0) <= same * std::abs(k0) && std::abs(turn_rad) <= same_rad)
    node.kind = FitBreak::None;
  k0 = k1 = std::copysign(std::sqrt(k0 * k1), k0);
  return node;
}

/// Inflections and extrema of the curvature inside of a segment.
std::vector<FitNode> innerNodes(const ConicFitCurve& curve, int i) {
  if (curve.isLine(i)) return {};
  const CurvatureProfile profile = planarCurvatureProfile(curve.segmentAt(i));
  std::vector<FitNode> nodes;
  const auto add = [&](const Interval& place, FitBreak kind) {
    const double t = place.middle();
    if (!(t > 0 && t < 1)) return;
    FitFrame frame = curve.frame(i, t);
    if (kind == FitBreak::G1) frame.curvature_per_mm = 0;
    nodes.push_back({.u = i + t, .kind = kind, .before = frame, .after = frame});
  };
  for (const Interval& place : profile.inflections) add(place, FitBreak::G1);
  for (const CurvatureExtremum& extremum : profile.extrema)
    add(extremum.parameters, FitBreak::Smooth);
  std::ranges::sort(nodes, {}, &FitNode::u);
  return nodes;
}

std::vector<FitNode> nodesOf(const ConicFitCurve& curve, bool closed, double corner_rad) {
  const int n = curve.count();
  std::vector<FitNode> nodes;
  FitNode first{.before = curve.frame(n - 1, 1), .after = curve.frame(0, 0)};
  if (closed) first = jointNode(curve, n - 1, 0, corner_rad);
  if (first.kind == FitBreak::None) first.kind = FitBreak::Smooth;
  first.u = 0;
  nodes.push_back(first);
  for (int i = 0; i < n; ++i) {
    if (i > 0) {
      const FitNode node = jointNode(curve, i - 1, i, corner_rad);
      if (node.kind != FitBreak::None) nodes.push_back(node);
    }
    for (const FitNode& node : innerNodes(curve, i)) nodes.push_back(node);
  }
  first.u = n;
  nodes.push_back(first);
  return nodes;
}

/// The size of the curvature at an end of a span, if it is free or too small for a pair.
double usableCurvature(double given_per_mm, const PairAngles& angles) {
  // The curvature of conics is nowhere 0; below this share of that of the circle they get flat.
  constexpr double least_share = 0.05;
  const double circle = 2 * std::sin(angles.own_rad) / angles.chord_mm;
  if (std::abs(given_per_mm) > least_share * circle) return std::abs(given_per_mm);
  return std::min(circle, pairCurvature_per_mm(angles));
}

/// Part of the curve on its way to conics.
struct FitSpan {
  double u0 = 0, u1 = 0;
  FitFrame start, end;
};

/// One conic with the tangents and curvatures of the ends, if there is one.
std::optional<PlanarConic> singleConic(const FitSpan& span, const ChordAngles& angles, double k0,
                                       double k1) {
  const double alpha = std::abs(angles.alpha_rad), beta = std::abs(angles.beta_rad);
  const double edge_mm = angles.chord_mm * std::sin(beta) / std::sin(alpha + beta);
  PlanarConic conic{.start = span.start.point,
                    .corner = span.start.point + edge_mm * unitVector(span.start.direction_rad),
                    .end = span.end.point};
  conic.weight = std::sqrt(std::abs(conic.startCurvature_per_mm()) / k0);
  constexpr double same = 1e-7;
  if (!(std::abs(std::abs(conic.endCurvature_per_mm()) - k1) <= same * k1)) return std::nullopt;
  return conic;
}

/// One conic or two with the frames of a span; none if the frames form no C-shape.
std::vector<PlanarConic> conicsBetween(const FitSpan& span) {
  const ChordAngles angles = chordAngles({.start = span.start.point,
                                          .start_direction_rad = span.start.direction_rad,
                                          .end = span.end.point,
                                          .end_direction_rad = span.end.direction_rad});
  const double alpha = std::abs(angles.alpha_rad), beta = std::abs(angles.beta_rad);
  constexpr double widest_rad = std::numbers::pi / 2;
  const bool c_shape = angles.alpha_rad * angles.beta_rad > 0;
  if (!c_shape || std::max(alpha, beta) >= widest_rad) return {};
  const double sign = angles.alpha_rad > 0 ? 1 : -1;
  const double given0 = span.start.curvature_per_mm, given1 = span.end.curvature_per_mm;
  if (sign * given0 < 0 || sign * given1 < 0) return {};
  const double k0 = usableCurvature(
      given0, {.chord_mm = angles.chord_mm, .own_rad = alpha, .other_rad = beta});
  const double k1 = usableCurvature(
      given1, {.chord_mm = angles.chord_mm, .own_rad = beta, .other_rad = alpha});
  if (const auto conic = singleConic(span, angles, k0, k1)) return {*conic};
  if (alpha + beta > most_pair_turn_rad) return {};
  const ConicPair pair = fairConics({.ends = {.start = span.start.point,
                                              .start_direction_rad = span.start.direction_rad,
                                              .end = span.end.point,
                                              .end_direction_rad = span.end.direction_rad},
                                     .start_curvature_per_mm = sign * k0,
                                     .end_curvature_per_mm = sign * k1});
  return {pair.conics.begin(), pair.conics.end()};
}

PlanarConic lineBetween(const FitSpan& span) {
  return {.start = span.start.point,
          .corner = (span.start.point + span.end.point) / 2,
          .end = span.end.point};
}

/// Conics within the tolerance for a span, by halving.
void fitSpan(const ConicFitCurve& curve, const FitSpan& span, double tolerance_mm,
             ConicFit& result) {
  // A share of a segment. Below it the curve is flat to rounding.
  constexpr double shortest = 0x1p-24;
  std::vector<FitSpan> open = {span};
  while (!open.empty()) {
    const FitSpan next = open.back();
    open.pop_back();
    if (next.start.point == next.end.point) continue;
    const std::vector<PlanarConic> conics = conicsBetween(next);
    std::optional<double> distance_mm;
    if (!conics.empty())
      distance_mm = distanceFromConics(curve.part(next.u0, next.u1), conics, tolerance_mm);
    if (distance_mm) {
      result.distance_mm = std::max(result.distance_mm, *distance_mm);
      result.conics.insert(result.conics.end(), conics.begin(), conics.end());
      continue;
    }
    if (next.u1 - next.u0 < shortest) {
      result.distance_mm = infinite;
      result.conics.push_back(lineBetween(next));
      continue;
    }
    // At a joint of segments if there is one.
    double middle = (next.u0 + next.u1) / 2;
    if (const double joint = std::round(middle); joint > next.u0 && joint < next.u1)
      middle = joint;
    const FitFrame frame = curve.at(middle);
    open.push_back({middle, next.u1, frame, next.end});
    open.push_back({next.u0, middle, next.start, frame});
  }
}

}  // namespace

ConicFit fitConics(const BezierSpline& spline, const ConicFitOptions& options) {
  requireValid(spline);
  if (!(options.tolerance_mm > 0 && std::isfinite(options.tolerance_mm)))
    refuse(fmt::format("the tolerance is {} mm: it must be positive and finite",
                       options.tolerance_mm));
  if (!(options.corner_rad > 0 && options.corner_rad < std::numbers::pi))
    refuse(
        fmt::format("the corner angle is {} rad: it must be between 0 and pi", options.corner_rad));
  const ConicFitCurve curve(spline);
  const std::vector<FitNode> nodes = nodesOf(curve, spline.closed, options.corner_rad);
  ConicFit result = {.conics = {}, .corners = {}, .g1_joints = {}, .closed = spline.closed};
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const FitNode &from = nodes[i], &to = nodes[i + 1];
    if (i > 0 || spline.closed) {
      const int joint = static_cast<int>(result.conics.size());
      if (from.kind == FitBreak::Corner) result.corners.push_back(joint);
      if (from.kind == FitBreak::G1) result.g1_joints.push_back(joint);
    }
    const FitSpan span{from.u, to.u, from.after, to.before};
    const int segment = std::min(static_cast<int>(from.u), curve.count() - 1);
    if (curve.isLine(segment) && to.u <= segment + 1)
      result.conics.push_back(lineBetween(span));
    else
      fitSpan(curve, span, options.tolerance_mm, result);
  }
  return result;
}

}  // namespace seamwright
