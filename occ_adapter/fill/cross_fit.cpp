// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <seamwright/core/linear/dense.hpp>
#include <seamwright/occ_adapter/fill/cross_fit.hpp>

namespace seamwright::occ {

using Eigen::Index, Eigen::Vector3d;

namespace {

/// The T that minimises the sum of (T - L beyond)^2 plus the weighted squares of its normal parts.
/// The normal parts at the ends are zero.
Poles nearestCross(const std::vector<SideSample>& samples,
                   const std::array<Vector3d, 2>& corner_normals, double length_mm, int degree,
                   const Eigen::VectorXd& weights) {
  // Large enough that the normal parts at the ends vanish.
  constexpr double weight_at_ends = 1e6;
  const Index unknowns = 3 * (degree + 1), count = static_cast<Index>(samples.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4 * count, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(4 * count);
  for (Index i = 0; i < count; ++i) {
    const SideSample& sample = samples[i];
    const bool is_end = i == 0 || i + 1 == count;
    const Vector3d& normal = is_end ? corner_normals[i == 0 ? 0 : 1] : sample.normal;
    const Eigen::VectorXd basis = bernsteinAt(degree, sample.t);
    for (int c = 0; c < 3; ++c) {
      for (int j = 0; j <= degree; ++j) {
        matrix(4 * i, 3 * j + c) = (is_end ? weight_at_ends : weights(i)) * basis(j) * normal(c);
        matrix(4 * i + 1 + c, 3 * j + c) = basis(j);
      }
      right(4 * i + 1 + c) = sample.beyond(c);
    }
  }
  const Eigen::VectorXd solution = length_mm * linear::PivotedQr(matrix).solve(right);
  Poles cross = Eigen::Map<const Poles>(solution.data(), degree + 1, 3);
  for (const int end : {0, 1}) {
    const Vector3d& normal = corner_normals[end];
    auto last = cross.row(end == 0 ? 0 : degree);
    last -= (last * normal) * normal.transpose();
  }
  return cross;
}

/// Weights that reduce the largest angle, as in Lawson's algorithm: the square root of the angle
/// to the face at each sample over the mean of all.
Eigen::VectorXd unevenness(const std::vector<SideSample>& samples, const Poles& cross) {
  // So that a sample that happens to have no angle keeps influence. A choice: any small share does.
  constexpr double least = 0.1;
  const BezierCurve field(cross);
  Eigen::VectorXd angles(static_cast<Index>(samples.size()));
  for (Index i = 0; i < angles.size(); ++i)
    angles(i) = angleToPlane(field.point(samples[i].t), samples[i].normal);
  if (!(angles.maxCoeff() > 0)) return Eigen::VectorXd::Ones(angles.size());
  return (angles / angles.mean()).cwiseSqrt().cwiseMax(least);
}

struct CrossForm {
  double angle_rad = 0;
  /// Smallest component across the edge, out of the hole, over the largest one.
  double evenness = 0;

  /// A choice: what varies more makes the parameter lines of patches uneven.
  bool isEven() const { return evenness >= 0.7; }
};

CrossForm formOf(const EdgeFit& edge, const Poles& cross) {
  const BezierCurve field(cross);
  double angle = 0, least = HUGE_VAL, most = 0;
  for (std::size_t i = 0; i < edge.directions.size(); ++i) {
    const SideSample& check = edge.samples->checked[i];
    const Vector3d here = field.point(check.t), area = here.cross(edge.directions[i]);
    const double across = here.dot(check.beyond);
    angle = std::max(angle,
                     std::atan2(area.cross(check.normal).norm(), std::abs(area.dot(check.normal))));
    least = std::min(least, across);
    most = std::max(most, across);
  }
  return {angle, least / most};
}

/// II(T, T) of the face, for T in its tangent plane.
double bendAlong(const SideSample& sample, const Vector3d& direction) {
  Eigen::Matrix<double, 3, 2> plane;
  plane << sample.jet.u, sample.jet.v;
  const Eigen::Vector2d c = plane.colPivHouseholderQr().solve(direction);
  return sample.normal.dot(c(0) * c(0) * sample.jet.uu + 2 * c(0) * c(1) * sample.jet.uv +
                           c(1) * c(1) * sample.jet.vv);
}

/// The polynomial nearest to II(T, T) N. This product does not depend on the orientation of the
/// face.
Poles nearestBend(const std::vector<SideSample>& samples, const Eigen::VectorXd& wanted,
                  int degree) {
  const Index count = static_cast<Index>(samples.size());
  Eigen::MatrixXd matrix(count, degree + 1), right(count, 3);
  for (Index i = 0; i < count; ++i) {
    matrix.row(i) = bernsteinAt(degree, samples[i].t).transpose();
    right.row(i) = wanted(i) * samples[i].normal.transpose();
  }
  return linear::PivotedQr(matrix).solve(right);
}

}  // namespace

// A field that is nearly zero somewhere, compared with its largest value, may have the right planes
// but makes folds. So the evenness decides too.
CrossFit fittedCross(const EdgeFit& edge, const std::array<Vector3d, 2>& corner_normals,
                     double length_mm, int most_degree, double enough_rad) {
  // Smaller weights trade angle for evenness, so large ones are tried first.
  constexpr std::array<double, 4> weights_of_normal_part = {1e6, 1e5, 1e4, 1e3};
  const std::vector<SideSample>& samples = edge.samples->fitted;
  CrossFit best;
  std::optional<CrossForm> best_form;
  const auto isEnough = [&](const Poles& cross, const CrossForm& form) {
    if (best_form &&
        (form.isEven() != best_form->isEven() ? best_form->isEven()
                                              : !(form.angle_rad < best_form->angle_rad)))
      return false;
    best_form = form;
    best = {.cross = cross, .angle_rad = form.angle_rad};
    return form.isEven() && form.angle_rad <= enough_rad;
  };
  for (int degree = 2; degree <= most_degree; ++degree) {
    const auto crossBy = [&](const Eigen::VectorXd& weights) {
      return nearestCross(samples, corner_normals, length_mm, degree, weights);
    };
    for (const double weight : weights_of_normal_part) {
      Eigen::VectorXd weights =
          Eigen::VectorXd::Constant(static_cast<Index>(samples.size()), weight);
      const Poles cross = crossBy(weights);
      const CrossForm form = formOf(edge, cross);
      if (isEnough(cross, form)) return best;
      if (weight > weights_of_normal_part.back() || !form.isEven()) continue;
      weights.array() *= unevenness(samples, cross).array();
      const Poles evened = crossBy(weights);
      if (isEnough(evened, formOf(edge, evened))) return best;
    }
  }
  return best;
}

BendFit fittedBend(const SideSamples& samples, const Poles& cross_poles, double length_mm,
                   int most_degree) {
  // Share of the largest curvature, or of the reciprocal length.
  constexpr double near_enough = 1e-3;
  const BezierCurve cross(cross_poles);
  const auto bends = [&](const std::vector<SideSample>& at) {
    Eigen::VectorXd along(static_cast<Index>(at.size()));
    for (Index i = 0; i < along.size(); ++i) along(i) = bendAlong(at[i], cross.point(at[i].t));
    return along;
  };
  const Eigen::VectorXd wanted = bends(samples.fitted), checked = bends(samples.checked);
  Eigen::VectorXd squares(checked.size());
  for (Index i = 0; i < checked.size(); ++i)
    squares(i) = cross.point(samples.checked[i].t).squaredNorm();
  const double largest_per_mm =
      std::max(1 / length_mm, checked.cwiseQuotient(squares).cwiseAbs().maxCoeff());
  std::optional<BendFit> best;
  for (int degree = 0; degree <= most_degree; ++degree) {
    const BezierCurve bend(nearestBend(samples.fitted, wanted, degree));
    double missed_per_mm = 0;
    for (Index i = 0; i < checked.size(); ++i)
      missed_per_mm = std::max(
          missed_per_mm,
          std::abs(samples.checked[i].normal.dot(bend.point(samples.checked[i].t)) - checked(i)) /
              squares(i));
    if (best && !(missed_per_mm < best->curvature_per_mm)) continue;
    best = {.bend = bend.poles(), .curvature_per_mm = missed_per_mm};
    if (missed_per_mm <= near_enough * largest_per_mm) break;
  }
  return *best;
}

}  // namespace seamwright::occ
