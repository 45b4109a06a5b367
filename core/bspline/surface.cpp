// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/bspline/refinement.hpp>
#include <seamwright/core/bspline/surface.hpp>
#include <seamwright/core/bspline/surface_jets.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

/// A net with one row for each pole of one direction.
using Net = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Net netAlong(const BSplineSurface& surface, SurfaceDirection direction) {
  const int nu = surface.countU(), nv = surface.countV();
  if (direction == SurfaceDirection::U) return surface.poles.reshaped<Eigen::RowMajor>(nu, 4 * nv);
  Net net(nv, 4 * nu);
  for (int i = 0; i < nu; ++i) net.middleCols(4L * i, 4) = surface.poles.middleRows(i * nv, nv);
  return net;
}

/// The surface with a new net, new knots and a new degree in one direction.
BSplineSurface replaced(const BSplineSurface& surface, SurfaceDirection direction, const Net& net,
                        int degree, std::vector<double> knots) {
  BSplineSurface result = surface;
  const Eigen::Index across = net.cols() / 4, count = net.rows();
  if (direction == SurfaceDirection::U) {
    result.degree_u = degree;
    result.knots_u = std::move(knots);
    result.poles = net.reshaped<Eigen::RowMajor>(count * across, 4);
    return result;
  }
  result.degree_v = degree;
  result.knots_v = std::move(knots);
  result.poles.resize(count * across, 4);
  for (Eigen::Index i = 0; i < across; ++i)
    result.poles.middleRows(i * count, count) = net.middleCols(4 * i, 4);
  return result;
}

struct Direction {
  int degree;
  const std::vector<double>& knots;
};

Direction directionOf(const BSplineSurface& surface, SurfaceDirection direction) {
  if (direction == SurfaceDirection::U) return {surface.degree_u, surface.knots_u};
  return {surface.degree_v, surface.knots_v};
}

bool hasInnerKnots(const Direction& d) {
  return d.knots.size() > 2 * static_cast<std::size_t>(d.degree + 1);
}

/// Homogeneous partials of the polynomial of a span.
/// \param in_u, in_v derivatives of the basis functions of the span, one order per row, at most 4.
/// \param poles the poles of the span.
HomogeneousPartials splinePartials(const HomogeneousPoles& poles, const Eigen::MatrixXd& in_u,
                                   const Eigen::MatrixXd& in_v) {
  HomogeneousPartials h;
  for (auto& row : h) row.fill(Eigen::Vector4d::Zero());
  const Eigen::Index orders = in_v.rows();
  for (Eigen::Index i = 0; i < in_u.cols(); ++i) {
    std::array<Eigen::Vector4d, 4> along_v;
    along_v.fill(Eigen::Vector4d::Zero());
    for (Eigen::Index j = 0; j < in_v.cols(); ++j)
      for (Eigen::Index l = 0; l < orders; ++l)
        along_v[l] += in_v(l, j) * poles.row(i * in_v.cols() + j).transpose();
    for (Eigen::Index k = 0; k < in_u.rows(); ++k)
      for (Eigen::Index l = 0; l < orders && k + l < 4; ++l) h[k][l] += in_u(k, i) * along_v[l];
  }
  return h;
}

}  // namespace

void requireValid(const BSplineSurface& surface) {
  bspline::requireKnots(surface.degree_u, surface.knots_u, "_u");
  bspline::requireKnots(surface.degree_v, surface.knots_v, "_v");
  const Eigen::Index count = static_cast<Eigen::Index>(surface.countU()) * surface.countV();
  if (surface.poles.rows() != count)
    refuse("poles " + std::to_string(surface.poles.rows()) + ", knots for " +
           std::to_string(surface.countU()) + " by " + std::to_string(surface.countV()) +
           ": the numbers must be equal");
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!surface.poles.row(i).allFinite()) refuse("pole " + std::to_string(i) + " is not finite");
    if (!(surface.poles(i, 3) > 0))
      refuse(fmt::format("weight {} is {}: weights must be positive", i, surface.poles(i, 3)));
  }
}

BSplineSurface splineSurface(const BezierPatch& patch) {
  const auto knots = [](int degree) {
    std::vector<double> result(2 * (static_cast<std::size_t>(degree) + 1), 0.0);
    std::fill(result.begin() + degree + 1, result.end(), 1.0);
    return result;
  };
  return {patch.degreeU(), patch.degreeV(), knots(patch.degreeU()), knots(patch.degreeV()),
          patch.homogeneousPoles()};
}

BezierPatch bezierPatch(const BSplineSurface& surface) {
  requireValid(surface);
  for (const SurfaceDirection direction : {SurfaceDirection::U, SurfaceDirection::V})
    if (hasInnerKnots(directionOf(surface, direction)))
      refuse("a surface with inner knots is not a Bezier patch");
  return {surface.degree_u, surface.degree_v, affinePoles(surface.poles), surface.poles.col(3)};
}

SurfaceJet jet(const BSplineSurface& surface, double u, double v) {
  return SurfaceJets(surface).at(u, v);
}

SurfaceJets::SurfaceJets(const BSplineSurface& surface) : surface_(&surface) {
  requireValid(surface);
  is_rational_ = isRational(surface.poles);
}

SurfaceJet SurfaceJets::at(double u, double v, int order) const {
  if (!std::isfinite(u)) refuse(fmt::format("parameter u is {}: it must be finite", u));
  if (!std::isfinite(v)) refuse(fmt::format("parameter v is {}: it must be finite", v));
  using bspline::basisDerivatives, bspline::spanOf;
  const BSplineSurface& surface = *surface_;
  const int span_u = spanOf(surface.degree_u, surface.knots_u, u);
  const int span_v = spanOf(surface.degree_v, surface.knots_v, v);
  const Eigen::MatrixXd in_u =
      basisDerivatives(surface.degree_u, surface.knots_u, span_u, u, order);
  const Eigen::MatrixXd in_v =
      basisDerivatives(surface.degree_v, surface.knots_v, span_v, v, order);
  HomogeneousPoles local((surface.degree_u + 1) * (surface.degree_v + 1), 4);
  for (int i = 0; i <= surface.degree_u; ++i) {
    const Eigen::Index first =
        static_cast<Eigen::Index>(span_u - surface.degree_u + i) * surface.countV() + span_v -
        surface.degree_v;
    local.middleRows(i * in_v.cols(), in_v.cols()) = surface.poles.middleRows(first, in_v.cols());
  }
  if (!is_rational_) return affineJet(splinePartials(local, in_u, in_v));
  const Eigen::Vector4d value = splinePartials(local, in_u.topRows(1), in_v.topRows(1))[0][0];
  const Eigen::Vector3d here = value.head<3>() / value(3);
  SurfaceJet result = affineJet(splinePartials(about(local, here), in_u, in_v));
  result.p += here;
  return result;
}

BSplineSurface withKnot(const BSplineSurface& surface, SurfaceDirection direction, double knot) {
  requireValid(surface);
  const auto [degree, knots] = directionOf(surface, direction);
  if (!(knot > knots.front() && knot < knots.back()))
    refuse(fmt::format("knot {}: it must lie strictly between {} and {}", knot, knots.front(),
                       knots.back()));
  if (std::ranges::count(knots, knot) >= degree)
    refuse(fmt::format("knot {} is repeated as often as the degree, {}, already", knot, degree));
  const int span = bspline::spanOf(degree, knots, knot);
  const Net net = netAlong(surface, direction);
  Net finer(net.rows() + 1, net.cols());
  for (int i = 0; i < finer.rows(); ++i) {
    if (i <= span - degree) {
      finer.row(i) = net.row(i);
    } else if (i > span) {
      finer.row(i) = net.row(i - 1);
    } else {
      const double share = (knot - knots[i]) / (knots[i + degree] - knots[i]);
      finer.row(i) = (1 - share) * net.row(i - 1) + share * net.row(i);
    }
  }
  std::vector<double> more = knots;
  more.insert(more.begin() + span + 1, knot);
  return replaced(surface, direction, finer, degree, std::move(more));
}

BSplineSurface withKnots(const BSplineSurface& surface, SurfaceDirection direction,
                         const std::vector<double>& added) {
  requireValid(surface);
  const auto [degree, knots] = directionOf(surface, direction);
  for (const double knot : added)
    if (!(knot > knots.front() && knot < knots.back()))
      refuse(fmt::format("knot {}: it must lie strictly between {} and {}", knot, knots.front(),
                         knots.back()));
  std::vector<double> finer = knots;
  finer.insert(finer.end(), added.begin(), added.end());
  std::ranges::sort(finer);
  for (const double knot : added)
    if (std::ranges::upper_bound(finer, knot) - std::ranges::lower_bound(finer, knot) > degree)
      refuse(fmt::format("knot {} would be repeated more often than the degree, {}", knot, degree));
  const bspline::PoleShares shares = bspline::insertionShares(degree, knots, finer);
  return replaced(surface, direction, bspline::combined(shares, netAlong(surface, direction)),
                  degree, std::move(finer));
}

BSplineSurface withRaisedKnots(const BSplineSurface& surface, SurfaceDirection direction,
                               int times) {
  requireValid(surface);
  if (times < 0) refuse("times is " + std::to_string(times) + ": it must not be negative");
  const auto [degree, knots] = directionOf(surface, direction);
  std::vector<double> added;
  const auto end = knots.end() - degree - 1;
  for (auto knot = knots.begin() + degree + 1; knot != end;) {
    const auto next = std::upper_bound(knot, end, *knot);
    added.insert(added.end(), std::min(times, degree - static_cast<int>(next - knot)), *knot);
    knot = next;
  }
  return withKnots(surface, direction, added);
}

BSplineSurface elevated(const BSplineSurface& surface, SurfaceDirection direction) {
  requireValid(surface);
  const Direction given = directionOf(surface, direction);
  if (given.degree == max_spline_degree)
    refuse(fmt::format("the degree is {} already, the highest", max_spline_degree));
  const Net net = netAlong(surface, direction);
  return replaced(surface, direction,
                  bspline::combined(bspline::elevationShares(given.degree, given.knots), net),
                  given.degree + 1, bspline::elevatedKnots(given.knots));
}

SurfaceDirection along(PatchEdge edge) {
  return edge == PatchEdge::U0 || edge == PatchEdge::U1 ? SurfaceDirection::V : SurfaceDirection::U;
}

}  // namespace seamwright
