// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <seamwright/core/fill/graph_boundary.hpp>
#include <stdexcept>

namespace seamwright {

namespace fill {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

bool isFinite(const GraphSample& sample) {
  return sample.at.allFinite() && std::isfinite(sample.height_mm) && sample.slope.allFinite() &&
         sample.across.allFinite() && std::isfinite(sample.bend_per_mm) &&
         std::isfinite(sample.speed_mm);
}

/// The jumps of the second derivatives across lines through a joint for which a function has the
/// slopes of both parts: across the line along y, and across the one along x. Not finite if no such
/// lines exist; 0 across a line that is not needed.
Vector2d jumpsAt(const GraphJoint& joint) {
  constexpr double least_jump = 0.01;   // per unit: less is left to short spans
  constexpr double least_slant = 0.05;  // of the boundary against a line
  Vector2d jumps = Vector2d::Zero();
  if (joint.isSmooth()) {
    const Vector2d rise = joint.rate_out - joint.rate_in,
                   along = (joint.in + joint.out).normalized();
    for (int d = 0; d < 2; ++d)
      if (std::abs(rise(d)) >= least_jump)
        jumps(d) = std::abs(along(d)) < least_slant ? HUGE_VAL : rise(d) / along(d);
    return jumps;
  }
  // The mixed second derivative along both tangents, as both parts have it.
  const double differ = joint.rate_in.dot(joint.out) - joint.rate_out.dot(joint.in);
  if (std::abs(differ) < least_jump) return jumps;
  // Lines that have the parts on different sides.
  Vector2d between = joint.in.cwiseProduct(joint.out);
  for (int d = 0; d < 2; ++d)
    if (between(d) < least_slant) between(d) = 0;
  if (between.isZero()) return Vector2d::Constant(HUGE_VAL);
  return -differ / between.squaredNorm() * between;
}

/// The largest jump of second derivatives that joints need, if x and y are turned.
double largestJump(const std::vector<GraphJoint>& joints, double turn_rad) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(-turn_rad).toRotationMatrix();
  double most = 0;
  for (const GraphJoint& joint : joints)
    most = std::max(most, jumpsAt({turn * joint.at, turn * joint.in, turn * joint.out,
                                   turn * joint.rate_in, turn * joint.rate_out})
                              .cwiseAbs()
                              .maxCoeff());
  return most;
}

}  // namespace

GraphScale scaleOf(const std::vector<GraphBoundary>& boundary) {
  constexpr int count = 32;
  Vector3d low = Vector3d::Constant(HUGE_VAL), high = -low;
  for (const GraphBoundary& part : boundary)
    for (int k = 0; k < count; ++k) {
      const GraphSample sample = part((k + 0.5) / count);
      const Vector3d point(sample.at.x(), sample.at.y(), sample.height_mm);
      low = low.cwiseMin(point), high = high.cwiseMax(point);
    }
  const Vector3d centre = 0.5 * (low + high);
  return {centre.head<2>(), centre.z(), 0.5 * (high - low).head<2>().norm()};
}

const GraphSample& GraphPart::at(double t) {
  const auto found = samples_.find(t);
  if (found != samples_.end()) return found->second;
  const GraphSample sample = scale_.scaled((*boundary_)(t));
  if (!isFinite(sample))
    throw std::invalid_argument("a sample of the boundary of a graph is not finite");
  return samples_.emplace(t, sample).first->second;
}

std::vector<double> GraphPart::parameters(const GraphKnots& u, const GraphKnots& v) {
  std::vector<double> all = {least_t};
  constexpr int pieces = 8;  // a choice: as a start, so that no arc looks like a chord
  for (int k = 0; k < pieces; ++k)
    divide(std::max(least_t, k / double{pieces}), std::min(1 - least_t, (k + 1) / double{pieces}),
           u, v, all);
  return all;
}

void GraphPart::divide(double from, double to, const GraphKnots& u, const GraphKnots& v,
                       std::vector<double>& all) {
  constexpr double most_share = 0.3;   // of a span: three samples in each
  constexpr double least_step = 1e-5;  // of the part
  const double middle = 0.5 * (from + to);
  const Vector2d here = at(from).at, there = at(to).at, between = at(middle).at;
  const double wide_u = most_share * u.width(u.spanAt(between.x())),
               wide_v = most_share * v.width(v.spanAt(between.y()));
  if (to - from > least_step &&
      (std::abs(there.x() - here.x()) > wide_u || std::abs(there.y() - here.y()) > wide_v)) {
    divide(from, middle, u, v, all);
    divide(middle, to, u, v, all);
  } else {
    all.push_back(to);
  }
}

std::vector<GraphJoint> jointsOf(std::vector<GraphPart>& parts) {
  constexpr double step = 1e-3;  // of a part
  std::vector<GraphJoint> joints;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    GraphPart &in = parts[(k + parts.size() - 1) % parts.size()], &out = parts[k];
    const auto rate = [&](GraphPart& part, double from, double to) -> Vector2d {
      return (part.at(to).slope - part.at(from).slope) / (part.at(to).at - part.at(from).at).norm();
    };
    const auto along = [](const GraphSample& sample) {
      return Vector2d(-sample.across.y(), sample.across.x());
    };
    joints.push_back({.at = 2 * out.at(least_t).at - out.at(2 * least_t).at,
                      .in = along(in.at(1 - step)),
                      .out = along(out.at(step)),
                      .rate_in = rate(in, 1 - 2 * step, 1 - step),
                      .rate_out = rate(out, step, 2 * step)});
  }
  return joints;
}

GraphBends bendsOf(const std::vector<GraphJoint>& joints, const Vector2d& low,
                   const Vector2d& high) {
  constexpr double near = 1e-6;
  GraphBends bends;
  for (const GraphJoint& joint : joints) {
    const Vector2d jumps = jumpsAt(joint);
    for (int d = 0; d < 2; ++d) {
      if (jumps(d) == 0 || !std::isfinite(jumps(d))) continue;
      if (joint.at(d) - low(d) < near || high(d) - joint.at(d) < near) continue;
      auto& its = bends[static_cast<std::size_t>(d)];
      if (std::ranges::none_of(its,
                               [&](double other) { return std::abs(other - joint.at(d)) < near; }))
        its.push_back(joint.at(d));
    }
  }
  return bends;
}

}  // namespace fill

std::optional<double> graphTurn_rad(const std::vector<GraphBoundary>& boundary) {
  constexpr double much = 2;  // a choice: by less, a turn is not worth it
  constexpr int steps = 90;   // of a degree
  const fill::GraphScale scale = fill::scaleOf(boundary);
  std::vector<fill::GraphPart> parts;
  for (const GraphBoundary& part : boundary) parts.emplace_back(part, scale);
  const std::vector<fill::GraphJoint> joints = fill::jointsOf(parts);
  double best_rad = 0, least = HUGE_VAL;
  for (int k = 0; k < steps; ++k) {
    const double turn_rad = k * std::numbers::pi / (2 * steps),
                 jump = fill::largestJump(joints, turn_rad);
    if (jump < least) least = jump, best_rad = turn_rad;
  }
  if (!(much * least < fill::largestJump(joints, 0))) return std::nullopt;
  return best_rad;
}

}  // namespace seamwright
