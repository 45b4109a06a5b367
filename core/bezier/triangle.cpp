// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bezier/triangle.hpp>

namespace seamwright {

namespace {

/// The degree n of a net with (n+1)(n+2)/2 poles.
int degreeOf(Eigen::Index poles) {
  int degree = 0;
  while (BezierTriangle::row(degree, degree, 0) + 1 < poles) ++degree;
  if (BezierTriangle::row(degree, degree, 0) + 1 != poles)
    throw std::invalid_argument("poles " + std::to_string(poles) +
                                ": a triangle of degree n has (n+1)(n+2)/2 of them");
  return degree;
}

/// One step of de Casteljau's algorithm, from the given degree to the next lower one. The rows of
/// the result are at the front of the net.
void step(HomogeneousPoles& net, int degree, const Barycentric& l) {
  Eigen::Index to = 0;
  for (int i = 0; i < degree; ++i)
    for (int j = 0; i + j < degree; ++j, ++to)
      net.row(to) = l(0) * net.row(BezierTriangle::row(degree, i + 1, j)) +
                    l(1) * net.row(BezierTriangle::row(degree, i, j + 1)) +
                    l(2) * net.row(BezierTriangle::row(degree, i, j));
}

Eigen::Vector4d collapse(HomogeneousPoles net, int degree, const Barycentric& l) {
  for (; degree > 0; --degree) step(net, degree, l);
  return net.row(0).transpose();
}

/// The net of a derivative, of one degree less: by l0 (di = 1, dj = 0) at constant l1, or by l1 (di
/// = 0, dj = 1) at constant l0.
HomogeneousPoles derivativeNet(const HomogeneousPoles& net, int degree, int di, int dj) {
  if (degree == 0) return HomogeneousPoles::Zero(1, 4);
  HomogeneousPoles result(net.rows() - degree - 1, 4);
  Eigen::Index to = 0;
  for (int i = 0; i < degree; ++i)
    for (int j = 0; i + j < degree; ++j, ++to)
      result.row(to) = degree * (net.row(BezierTriangle::row(degree, i + di, j + dj)) -
                                 net.row(BezierTriangle::row(degree, i, j)));
  return result;
}

/// Homogeneous partials by l0 and l1.
HomogeneousPartials trianglePartials(HomogeneousPoles by_l0, int of_degree, const Barycentric& l) {
  HomogeneousPartials h;
  for (int k = 0; k < 4; ++k) {
    HomogeneousPoles net = by_l0;
    for (int m = 0; k + m < 4; ++m) {
      const int degree = std::max(of_degree - k - m, 0);
      h[k][m] = collapse(net, degree, l);
      net = derivativeNet(net, degree, 0, 1);
    }
    by_l0 = derivativeNet(by_l0, std::max(of_degree - k, 0), 1, 0);
  }
  return h;
}

}  // namespace

BezierTriangle::BezierTriangle(const Eigen::Ref<const Poles>& poles)
    : BezierTriangle(poles, Eigen::VectorXd::Ones(poles.rows())) {}

BezierTriangle::BezierTriangle(const Eigen::Ref<const Poles>& poles,
                               const Eigen::Ref<const Eigen::VectorXd>& weights)
    : homogeneous_(seamwright::homogeneousPoles(poles, weights)), degree_(degreeOf(poles.rows())) {}

BezierTriangle BezierTriangle::fromHomogeneous(HomogeneousPoles poles) {
  requireValid(poles);
  const int degree = degreeOf(poles.rows());
  return {Homogeneous{}, degree, std::move(poles)};
}

bool BezierTriangle::isRational() const {
  return seamwright::isRational(homogeneous_);
}

Poles BezierTriangle::poles() const {
  return affinePoles(homogeneous_);
}

Eigen::Vector3d BezierTriangle::pole(int i, int j) const {
  const auto h = homogeneous_.row(row(degree_, i, j));
  return h.head<3>().transpose() / h(3);
}

Eigen::Vector3d BezierTriangle::point(double l0, double l1) const {
  const Eigen::Vector4d h = collapse(homogeneous_, degree_, {l0, l1, 1 - l0 - l1});
  return h.head<3>() / h(3);
}

SurfaceJet BezierTriangle::jet(double l0, double l1) const {
  const Barycentric l(l0, l1, 1 - l0 - l1);
  if (!isRational()) return affineJet(trianglePartials(homogeneous_, degree_, l));
  const Eigen::Vector3d here = point(l0, l1);
  SurfaceJet result = affineJet(trianglePartials(about(homogeneous_, here), degree_, l));
  result.p += here;
  return result;
}

JetNoise BezierTriangle::noise() const {
  const double size = poles().cwiseAbs().maxCoeff();
  const double weight_ratio = homogeneous_.col(3).maxCoeff() / homogeneous_.col(3).minCoeff();
  const double noise =
      8 * (degree_ + 4) * std::numeric_limits<double>::epsilon() * degree_ * size * weight_ratio;
  return {noise, noise};
}

Eigen::Vector4d BezierTriangle::blossom(std::span<const Barycentric> arguments) const {
  if (arguments.size() != static_cast<std::size_t>(degree_))
    throw std::invalid_argument("arguments " + std::to_string(arguments.size()) + ", degree " +
                                std::to_string(degree_) + ": the numbers must be equal");
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (!arguments[i].allFinite())
      throw std::invalid_argument("argument " + std::to_string(i) + " is not finite");
  // The arguments are sorted, so that rounding is symmetric too. Corners come first, since they
  // only choose poles.
  std::vector<Barycentric> sorted(arguments.begin(), arguments.end());
  std::ranges::sort(sorted, [](const Barycentric& a, const Barycentric& b) {
    const double top_a = a.maxCoeff(), top_b = b.maxCoeff();
    return top_a != top_b ? top_a > top_b : std::ranges::lexicographical_compare(a, b);
  });
  HomogeneousPoles net = homogeneous_;
  for (int degree = degree_; degree > 0; --degree) step(net, degree, sorted[degree_ - degree]);
  Eigen::Vector4d result = net.row(0).transpose();
  if (!isRational()) result(3) = homogeneous_(0, 3);
  return result;
}

BezierCurve BezierTriangle::edgeCurve(TriangleEdge edge) const {
  const BezierTriangle turned = edge == TriangleEdge::L0   ? *this
                                : edge == TriangleEdge::L1 ? permuted({1, 2, 0})
                                                           : permuted({2, 0, 1});
  const HomogeneousPoles h = turned.homogeneous_.topRows(degree_ + 1).colwise().reverse();
  return {affinePoles(h), h.col(3)};
}

BezierTriangle BezierTriangle::elevated() const {
  const int n = degree_ + 1;
  HomogeneousPoles result(row(n, n, 0) + 1, 4);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      Eigen::RowVector4d sum = Eigen::RowVector4d::Zero();
      if (i > 0) sum += i * homogeneous_.row(row(degree_, i - 1, j));
      if (j > 0) sum += j * homogeneous_.row(row(degree_, i, j - 1));
      if (i + j < n) sum += (n - i - j) * homogeneous_.row(row(degree_, i, j));
      result.row(row(n, i, j)) = sum / n;
    }
  if (!isRational()) result.col(3).setConstant(homogeneous_(0, 3));
  return {Homogeneous{}, n, std::move(result)};
}

BezierTriangle BezierTriangle::permuted(const std::array<int, 3>& corners) const {
  std::array<int, 3> sorted = corners;
  std::ranges::sort(sorted);
  if (sorted != std::array{0, 1, 2})
    throw std::invalid_argument("corners " + std::to_string(corners[0]) + ", " +
                                std::to_string(corners[1]) + ", " + std::to_string(corners[2]) +
                                ": 0, 1 and 2 are needed");
  HomogeneousPoles result(homogeneous_.rows(), 4);
  for (int i = 0; i <= degree_; ++i)
    for (int j = 0; i + j <= degree_; ++j) {
      std::array<int, 3> index{};
      index[corners[0]] = i;
      index[corners[1]] = j;
      index[corners[2]] = degree_ - i - j;
      result.row(row(degree_, i, j)) = homogeneous_.row(row(degree_, index[0], index[1]));
    }
  return {Homogeneous{}, degree_, std::move(result)};
}

BezierTriangle BezierTriangle::subtriangle(const std::array<Barycentric, 3>& corners) const {
  for (std::size_t c = 0; c < 3; ++c)
    if (!corners[c].allFinite())
      throw std::invalid_argument("corner " + std::to_string(c) + " is not finite");
  HomogeneousPoles result(homogeneous_.rows(), 4);
  std::vector<Barycentric> arguments(degree_);
  for (int i = 0; i <= degree_; ++i)
    for (int j = 0; i + j <= degree_; ++j) {
      std::fill_n(arguments.begin(), i, corners[0]);
      std::fill_n(arguments.begin() + i, j, corners[1]);
      std::fill(arguments.begin() + i + j, arguments.end(), corners[2]);
      const Eigen::Index to = row(degree_, i, j);
      result.row(to) = blossom(arguments).transpose();
      if (!(result(to, 3) > 0))
        throw std::invalid_argument(fmt::format(
            "weight {} of the part is {}: weights must be positive", to, result(to, 3)));
    }
  return {Homogeneous{}, degree_, std::move(result)};
}

std::array<BezierTriangle, 3> BezierTriangle::splitAt(double l0, double l1) const {
  const Barycentric p0(1, 0, 0), p1(0, 1, 0), p2(0, 0, 1), s(l0, l1, 1 - l0 - l1);
  return {subtriangle({s, p1, p2}), subtriangle({p0, s, p2}), subtriangle({p0, p1, s})};
}

std::array<BezierTriangle, 4> BezierTriangle::quartered() const {
  const Barycentric p0(1, 0, 0), p1(0, 1, 0), p2(0, 0, 1);
  const Barycentric m0(0, 0.5, 0.5), m1(0.5, 0, 0.5), m2(0.5, 0.5, 0);
  return {subtriangle({p0, m2, m1}), subtriangle({m2, p1, m0}), subtriangle({m1, m0, p2}),
          subtriangle({m0, m1, m2})};
}

}  // namespace seamwright
