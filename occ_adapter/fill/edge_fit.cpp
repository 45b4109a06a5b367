// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>

#include <seamwright/core/linear/dense.hpp>
#include <seamwright/occ_adapter/fill/edge_fit.hpp>
#include <seamwright/occ_adapter/geometry_error.hpp>

namespace seamwright::occ {

using Eigen::Index, Eigen::Vector3d;

namespace {

std::shared_ptr<const SideSamples> sampled(const IntervalPath& path,
                                           Parametrisation parametrisation, int most_degree) {
  // Choices: six samples for each degree determine the fit, and checks at four times as many show
  // what it does between them.
  constexpr int finer = 4, samples_per_degree = 6;
  const auto samples = std::make_shared<SideSamples>();
  samples->checked = samplesOf(path, parametrisation, finer * samples_per_degree * most_degree);
  for (std::size_t i = 0; i < samples->checked.size(); i += finer)
    samples->fitted.push_back(samples->checked[i]);
  for (const SideSample* sample : {&samples->fitted.front(), &samples->fitted.back()})
    // So much shorter than the mean derivative is rounding of a zero.
    if (!(sample->derivative.norm() > 1e-9 * path.length_mm()))
      throw GeometryError("an edge has no tangent where it ends");
  return samples;
}

/// Fits the edge by least squares with fixed ends and end derivatives.
BezierCurve fittedEdge(const std::vector<SideSample>& samples,
                       const std::array<SideFitEnd, 2>& ends, int degree) {
  Poles poles(degree + 1, 3);
  poles.row(0) = ends[0].point;
  poles.row(1) = ends[0].point + derivativeAt(ends[0], samples.front()) / degree;
  poles.row(degree - 1) = ends[1].point - derivativeAt(ends[1], samples.back()) / degree;
  poles.row(degree) = ends[1].point;
  const Index free = degree - 3, count = static_cast<Index>(samples.size());
  if (free == 0) return BezierCurve(poles);
  Eigen::MatrixXd matrix(count, free), right(count, 3);
  for (Index i = 0; i < count; ++i) {
    const Eigen::VectorXd basis = bernsteinAt(degree, samples[i].t);
    matrix.row(i) = basis.segment(2, free).transpose();
    right.row(i) = samples[i].point.transpose();
    for (const Index fixed : {Index{0}, Index{1}, Index{degree} - 1, Index{degree}})
      right.row(i) -= basis(fixed) * poles.row(fixed);
  }
  poles.middleRows(2, free) = linear::PivotedQr(matrix).solve(right);
  return BezierCurve(poles);
}

EdgeFit measured(std::shared_ptr<const SideSamples> samples, BezierCurve edge,
                 const SideFitOptions& options, double enough_rad) {
  EdgeFit fit;
  fit.samples = std::move(samples), fit.edge = std::move(edge);
  for (const SideSample& check : fit.samples->checked) {
    const CurveJet jet = fit.edge.jet(check.t);
    fit.gap_mm = std::max(fit.gap_mm, (jet.p - check.point).norm());
    fit.directions.push_back(jet.d1.normalized());
    fit.tilt_rad = std::max(fit.tilt_rad, angleToPlane(jet.d1, check.normal));
  }
  fit.miss = std::max(fit.gap_mm / options.gap_mm, fit.tilt_rad / enough_rad);
  return fit;
}

}  // namespace

Eigen::VectorXd bernsteinAt(int degree, double t) {
  Eigen::VectorXd basis = Eigen::VectorXd::Zero(degree + 1);
  basis(0) = 1;
  for (int n = 1; n <= degree; ++n)
    for (int i = n; i >= 0; --i) basis(i) = (1 - t) * basis(i) + (i > 0 ? t * basis(i - 1) : 0);
  return basis;
}

// Ends may lie a little off the path because neighbours share them. A higher degree corrects this
// offset on a shorter interval, and so tilts the edge more: the lowest degree is taken.
EdgeFit nearestEdge(const IntervalPath& path, Parametrisation parametrisation,
                    const std::array<SideFitEnd, 2>& ends, const SideFitOptions& options,
                    double enough_rad) {
  // A higher degree counts as better if it reduces the error by a tenth.
  constexpr double nearer = 0.9;
  constexpr int patience = 2;  // symmetric paths improve only with every second degree
  const std::shared_ptr<const SideSamples> samples =
      sampled(path, parametrisation, options.most_degree);
  EdgeFit best;
  for (int degree = 3; degree <= options.most_degree; ++degree) {
    EdgeFit tried =
        measured(samples, fittedEdge(samples->fitted, ends, degree), options, enough_rad);
    if (tried.miss < nearer * best.miss) best = std::move(tried);
    if (best.miss <= 1 || degree - best.edge.degree() >= patience) break;
  }
  return best;
}

}  // namespace seamwright::occ
