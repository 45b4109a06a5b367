// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Precision.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>
#include <seamwright/occ_adapter/repair/surface_basis.hpp>

namespace seamwright::occ {

double SplineAxis::wrapped(double t) const {
  if (!periodic) return t;
  const double period = last - first;
  const double shifted = t - period * std::floor((t - first) / period);
  return shifted < last ? shifted : first;
}

int SplineAxis::span(double& t, double toward) const {
  // A parameter that rounding moved off a knot counts as that knot.
  const double near = 1e-10 * (last - first);
  t = wrapped(t);
  const auto begin = knots.begin() + degree;
  const auto end = std::lower_bound(begin, knots.end(), last);
  double beside = t;
  const auto knot = std::lower_bound(begin, end, t - near);
  if (toward != 0 && std::abs(*knot - t) <= near) beside += std::copysign(2 * near, toward);
  if (periodic && beside >= last) {
    t -= last - first;
    beside -= last - first;
  } else if (periodic && beside < first) {
    t += last - first;
    beside += last - first;
  }
  const auto after = std::upper_bound(begin, end, std::clamp(beside, first, last));
  const int found = static_cast<int>(after - knots.begin()) - 1;
  return found;
}

std::vector<int> SplineAxis::spans() const {
  std::vector<int> found;
  for (int i = degree; knots[i] < last; ++i)
    if (knots[i + 1] > knots[i]) found.push_back(i);
  return found;
}

std::vector<int> SplineAxis::polesNear(double t) const {
  // For degree 3 these are all that overlap one of those at t. For higher degrees, which overlap
  // more, it is a choice that bounds the work.
  constexpr int most_more = 3;
  const int at = span(t, 0), more = std::min(degree, most_more);
  std::vector<int> near;
  for (int k = at - degree - more; k <= at + more; ++k) {
    if (periodic)
      near.push_back((k % poles + poles) % poles);
    else if (k >= 0 && k < poles)
      near.push_back(k);
  }
  return near;
}

namespace {

SplineAxis withStep(SplineAxis axis) {
  axis.step = std::min(1.0, (axis.last - axis.first) / static_cast<double>(axis.spans().size()));
  return axis;
}

SplineAxis axisU(const Geom_BSplineSurface& surface) {
  const TColStd_Array1OfReal& knots = surface.UKnotSequence();
  return withStep({surface.UDegree(),
                   surface.NbUPoles(),
                   surface.IsUPeriodic(),
                   surface.UKnot(surface.FirstUKnotIndex()),
                   surface.UKnot(surface.LastUKnotIndex()),
                   {knots.begin(), knots.end()}});
}

SplineAxis axisV(const Geom_BSplineSurface& surface) {
  const TColStd_Array1OfReal& knots = surface.VKnotSequence();
  return withStep({surface.VDegree(),
                   surface.NbVPoles(),
                   surface.IsVPeriodic(),
                   surface.VKnot(surface.FirstVKnotIndex()),
                   surface.VKnot(surface.LastVKnotIndex()),
                   {knots.begin(), knots.end()}});
}

}  // namespace

SurfaceBasis::SurfaceBasis(const Geom_BSplineSurface& surface)
    : u_(axisU(surface)), v_(axisV(surface)) {
  if (!surface.IsURational() && !surface.IsVRational()) return;
  weights_.resize(static_cast<Eigen::Index>(u_.poles) * v_.poles);
  for (int i = 0; i < u_.poles; ++i)
    for (int j = 0; j < v_.poles; ++j) weights_[pole(i, j)] = surface.Weight(i + 1, j + 1);
}

PoleShares SurfaceBasis::ofNumerator(const Eigen::Vector2d& uv, const Eigen::Vector2d& into,
                                     int order) const {
  double u = uv[0], v = uv[1];
  const int span_u = u_.span(u, into[0]), span_v = v_.span(v, into[1]);
  const Eigen::MatrixXd a = bspline::basisDerivatives(u_.degree, u_.knots, span_u, u, order);
  const Eigen::MatrixXd b = bspline::basisDerivatives(v_.degree, v_.knots, span_v, v, order);
  const int rows = order < 2 ? 3 : 6;
  PoleShares shares;
  const int count = (u_.degree + 1) * (v_.degree + 1);
  shares.poles.reserve(count);
  shares.share.resize(rows, count);
  for (int i = 0; i <= u_.degree; ++i)
    for (int j = 0; j <= v_.degree; ++j) {
      const int column = static_cast<int>(shares.poles.size());
      shares.poles.push_back(
          pole(u_.pole(span_u - u_.degree + i), v_.pole(span_v - v_.degree + j)));
      const double weight = weights_.size() == 0 ? 1 : weights_[shares.poles.back()];
      auto share = shares.share.col(column);
      share.head<3>() << a(0, i) * b(0, j), a(1, i) * b(0, j), a(0, i) * b(1, j);
      if (order > 1) share.tail<3>() << a(2, i) * b(0, j), a(1, i) * b(1, j), a(0, i) * b(2, j);
      share *= weight;
    }
  return shares;
}

PoleShares SurfaceBasis::at(const Eigen::Vector2d& uv, const Eigen::Vector2d& into,
                            int order) const {
  PoleShares shares = ofNumerator(uv, into, order);
  if (weights_.size() > 0) divide(shares, shares.share.rowwise().sum());
  return shares;
}

Eigen::VectorXd SurfaceBasis::denominator(const Eigen::Vector2d& uv,
                                          const Eigen::Vector2d& into) const {
  if (weights_.size() == 0) return {};
  return ofNumerator(uv, into, 2).share.rowwise().sum() / weights_[0];
}

void divide(PoleShares& shares, const Eigen::VectorXd& w) {
  auto& s = shares.share;
  s.row(0) /= w[0];
  s.row(1) = (s.row(1) - w[1] * s.row(0)) / w[0];
  s.row(2) = (s.row(2) - w[2] * s.row(0)) / w[0];
  if (s.rows() < 6) return;
  s.row(3) = (s.row(3) - 2 * w[1] * s.row(1) - w[3] * s.row(0)) / w[0];
  s.row(4) = (s.row(4) - w[1] * s.row(2) - w[2] * s.row(1) - w[4] * s.row(0)) / w[0];
  s.row(5) = (s.row(5) - 2 * w[2] * s.row(2) - w[5] * s.row(0)) / w[0];
}

PointRows polesOf(const Geom_BSplineSurface& surface) {
  PointRows poles(surface.NbUPoles() * surface.NbVPoles(), 3);
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      poles.row((i - 1) * surface.NbVPoles() + j - 1) = vector(surface.Pole(i, j)).transpose();
    }
  return poles;
}

void setPoles(Geom_BSplineSurface& surface, const PointRows& poles) {
  const PointRows old = polesOf(surface);
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      const int row = (i - 1) * surface.NbVPoles() + j - 1;
      if (poles.row(row) == old.row(row)) continue;
      surface.SetPole(i, j, gp_Pnt(poles(row, 0), poles(row, 1), poles(row, 2)));
    }
}

Eigen::Vector2d parameterStep(const SurfaceJet& jet, const Eigen::Vector3d& way) {
  const FirstForm form = firstForm(jet);
  const double a = way.dot(jet.u), b = way.dot(jet.v);
  return Eigen::Vector2d(form.G * a - form.F * b, form.E * b - form.F * a) / form.determinant();
}

Eigen::RowVectorXd derivative(const PoleShares& shares, const Eigen::Vector2d& step) {
  return step[0] * shares.share.row(1) + step[1] * shares.share.row(2);
}

Eigen::RowVectorXd secondDerivative(const PoleShares& shares, const Eigen::Vector2d& a,
                                    const Eigen::Vector2d& b) {
  return a[0] * b[0] * shares.share.row(3) + (a[0] * b[1] + a[1] * b[0]) * shares.share.row(4) +
         a[1] * b[1] * shares.share.row(5);
}

namespace {

/// The first rows of the jet, in the order of PoleShares.
template <int rows>
Eigen::Matrix<double, rows, 3> sumOf(const PoleShares& shares, const PointRows& poles) {
  Eigen::Matrix<double, rows, 3> sum = Eigen::Matrix<double, rows, 3>::Zero();
  for (std::size_t k = 0; k < shares.poles.size(); ++k)
    sum += shares.share.col(static_cast<Eigen::Index>(k)).template head<rows>() *
           poles.row(shares.poles[k]);
  return sum;
}

}  // namespace

SurfaceJet jetOf(const PoleShares& shares, const PointRows& poles) {
  const auto sum = sumOf<6>(shares, poles);
  SurfaceJet jet;
  jet.p = sum.row(0);
  jet.u = sum.row(1);
  jet.v = sum.row(2);
  jet.uu = sum.row(3);
  jet.uv = sum.row(4);
  jet.vv = sum.row(5);
  return jet;
}

JetNoise noiseOf(const SurfaceJet& jet, const SurfaceBasis& basis) {
  const double step_u = basis.u().step, step_v = basis.v().step;
  const double size =
      jet.p.lpNorm<Eigen::Infinity>() + step_u * jet.u.norm() + step_v * jet.v.norm();
  // For degrees up to 7 a derivative is a sum of at most 64 terms.
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * size;
  return {std::max(rounding / step_u, Precision::Confusion() / (basis.u().last - basis.u().first)),
          std::max(rounding / step_v, Precision::Confusion() / (basis.v().last - basis.v().first))};
}

std::vector<std::vector<int>> collapsedSides(const SurfaceBasis& basis, const PointRows& poles,
                                             double near_mm) {
  std::vector<std::vector<int>> sides;
  const auto collect = [&](int count, const auto& number) {
    std::vector<int> side;
    for (int k = 0; k < count; ++k) side.push_back(number(k));
    double spread = 0, size = 0;
    for (const int pole : side) {
      spread = std::max(spread, (poles.row(pole) - poles.row(side.front())).norm());
      size = std::max(size, poles.row(pole).cwiseAbs().maxCoeff());
    }
    // Poles of one point, computed by some dozens of operations, differ by their rounding.
    if (spread <= std::max(near_mm, 64 * std::numeric_limits<double>::epsilon() * size))
      sides.push_back(std::move(side));
  };
  const int last_u = basis.u().poles - 1, last_v = basis.v().poles - 1;
  if (!basis.u().periodic)
    for (const int i : {0, last_u}) collect(last_v + 1, [&](int j) { return basis.pole(i, j); });
  if (!basis.v().periodic)
    for (const int j : {0, last_v}) collect(last_u + 1, [&](int i) { return basis.pole(i, j); });
  return sides;
}

double spanLength(const SplineAxis& axis, double t) {
  return axis.length(axis.span(t, 0));
}

double polesPerSpan(const SplineAxis& axis) {
  return static_cast<double>(axis.poles - (axis.periodic ? 0 : axis.degree)) /
         static_cast<double>(axis.spans().size());
}

}  // namespace seamwright::occ
