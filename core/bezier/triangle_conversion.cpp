// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <seamwright/core/bezier/casteljau.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/bezier/triangle_conversion.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright {

namespace {

/// Coefficients of a polynomial in Bernstein form, one per row.
using Coefficients = casteljau::Coefficients<Eigen::Dynamic>;

Coefficients elevated(Coefficients c, int degree) {
  while (c.rows() <= degree) {
    const Eigen::Index count = c.rows();
    Coefficients higher(count + 1, c.cols());
    higher.row(0) = c.row(0);
    higher.row(count) = c.row(count - 1);
    for (Eigen::Index i = 1; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      higher.row(i) = c.row(i) + share * (c.row(i - 1) - c.row(i));  // so constants stay bitwise
    }
    c = std::move(higher);
  }
  return c;
}

/// The polynomial of that degree, or of the given degree if it is lower. It has the same ends; its
/// coefficients, raised to the given degree, are nearest to the given ones.
Coefficients lowered(const Coefficients& c, int degree) {
  const int given = static_cast<int>(c.rows()) - 1;
  if (degree >= given) return c;
  if (degree == 0) return 0.5 * (c.row(0) + c.row(given));
  Coefficients result(degree + 1, c.cols());
  result.row(0) = c.row(0);
  result.row(degree) = c.row(given);
  const int inner = degree - 1;
  if (inner == 0) return result;
  const Coefficients matrix = elevated(Coefficients::Identity(degree + 1, degree + 1), given);
  const Coefficients rest =
      c - matrix.col(0) * result.row(0) - matrix.col(degree) * result.row(degree);
  result.middleRows(1, inner) = linear::PivotedQr(matrix.middleCols(1, inner)).solve(rest);
  return result;
}

/// The net as rows; each row is one coefficient of a polynomial in u.
Coefficients rowsOf(const BezierPatch& patch) {
  return patch.homogeneousPoles().reshaped<Eigen::RowMajor>(patch.degreeU() + 1,
                                                            4 * (patch.degreeV() + 1));
}

/// The net of T(1-u, u(1-v), uv), raised to degree_v if that is above the degree of the triangle.
Coefficients degenerateNet(const HomogeneousPoles& triangle, int degree, int degree_v) {
  const int columns = std::max(degree, degree_v) + 1;
  Coefficients net(degree + 1, 4 * columns);
  for (int r = 0; r <= degree; ++r) {
    const HomogeneousPoles row =
        triangle.middleRows(BezierTriangle::row(degree, degree - r, 0), r + 1).colwise().reverse();
    net.row(r) = elevated(row, columns - 1).reshaped<Eigen::RowMajor>(1, 4 * columns);
  }
  return net;
}

/// The homogeneous poles of the triangle of that degree whose degenerate net is near the given net.
HomogeneousPoles nearbyTriangle(const Coefficients& net, int degree) {
  const Coefficients rows = lowered(net, degree);
  HomogeneousPoles result(BezierTriangle::row(degree, degree, 0) + 1, 4);
  for (int r = 0; r <= degree; ++r) {
    const Coefficients row =
        elevated(lowered(rows.row(r).reshaped<Eigen::RowMajor>(net.cols() / 4, 4), r), r);
    result.middleRows(BezierTriangle::row(degree, degree - r, 0), r + 1) = row.colwise().reverse();
  }
  return result;
}

/// Bound of |a / w_a - b / w_b| over [0, 1]^2 for two nets of the same degrees. The difference is
/// ((a - b) - x_b (w_a - w_b)) / w_a, and x_b lies within the poles of b.
double distanceBound(const HomogeneousPoles& a, const HomogeneousPoles& b) {
  const Poles poles = affinePoles(b);
  const Eigen::RowVector3d centre = poles.row(0);
  const double radius = (poles.rowwise() - centre).rowwise().norm().maxCoeff();
  const HomogeneousPoles difference = a - b;
  const Poles numerator = difference.leftCols<3>() - difference.col(3) * centre;
  return ((numerator.rowwise().norm() + radius * difference.col(3).cwiseAbs()).array() /
          a.col(3).array())
      .maxCoeff();
}

struct Candidate {
  BezierTriangle triangle;
  double deviation;
};

/// The triangle of that degree that is near the patch; nothing if one of its weights is not
/// positive.
std::optional<Candidate> candidate(const BezierPatch& patch, int degree) {
  HomogeneousPoles h = nearbyTriangle(rowsOf(patch), degree);
  if (!patch.isRational()) h.col(3).setConstant(patch.homogeneousPoles()(0, 3));
  if (!h.allFinite() || !(h.col(3).array() > 0).all()) return std::nullopt;
  const BezierTriangle triangle(affinePoles(h), h.col(3));

  const int degree_v = std::max(degree, patch.degreeV());
  const Coefficients ours = elevated(degenerateNet(h, degree, degree_v), patch.degreeU());
  Coefficients given(patch.degreeU() + 1, 4 * (degree_v + 1));
  for (int r = 0; r <= patch.degreeU(); ++r)
    given.row(r) = elevated(patch.homogeneousPoles().middleRows(r * (patch.degreeV() + 1),
                                                                patch.degreeV() + 1),
                            degree_v)
                       .reshaped<Eigen::RowMajor>(1, 4 * (degree_v + 1));
  const Eigen::Index count = ours.size() / 4;
  return Candidate{triangle, distanceBound(given.reshaped<Eigen::RowMajor>(count, 4),
                                           ours.reshaped<Eigen::RowMajor>(count, 4))};
}

/// The patch, turned in its parameter plane so that the given edge is u = 0.
BezierPatch turnedToU0(const BezierPatch& patch, PatchEdge edge) {
  switch (edge) {
    case PatchEdge::U1:
      return patch.reversedU().transposed().reversedU().transposed();
    case PatchEdge::V0:
      return patch.reversedU().transposed();
    case PatchEdge::V1:
      return patch.transposed().reversedU();
    default:
      return patch;
  }
}

double poleSize(const Poles& poles, const Eigen::VectorXd& weights) {
  return poles.cwiseAbs().maxCoeff() * weights.maxCoeff() / weights.minCoeff();
}

TriangleRecognition recogniseAt(const BezierPatch& patch, PatchEdge edge, double tolerance) {
  const BezierPatch turned = turnedToU0(patch, edge);
  TriangleRecognition result{std::nullopt, edge, std::numeric_limits<double>::infinity(),
                             tolerance};
  const auto take = [&](int degree) {
    const std::optional<Candidate> found = candidate(turned, degree);
    if (!found) return;
    result.deviation_mm = found->deviation;
    if (found->deviation <= tolerance) result.triangle = found->triangle;
  };
  take(turned.degreeU());
  if (!result.triangle) return result;
  const TriangleRecognition highest = result;
  result.triangle.reset();
  for (int degree = 0; degree < turned.degreeU() && !result.triangle; ++degree) take(degree);
  return result.triangle ? result : highest;
}

/// The hypergeometric weight C(i,d) C(n-i,j-d) / C(n,j).
double share(int n, int i, int j, int d) {
  const auto choose = [](int a, int b) {
    double value = 1;
    for (int k = 1; k <= b; ++k) value = value * (a - b + k) / k;
    return value;
  };
  return choose(i, d) * choose(n - i, j - d) / choose(n, j);
}

BezierPatch quadrangle(const BezierTriangle& triangle, const std::array<Barycentric, 4>& q) {
  const int n = triangle.degree();
  HomogeneousPoles h = HomogeneousPoles::Zero((n + 1) * (n + 1), 4);
  std::vector<Barycentric> arguments(n);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int d = std::max(0, i + j - n); d <= std::min(i, j); ++d) {
        auto next = std::fill_n(arguments.begin(), n - i - j + d, q[0]);
        next = std::fill_n(next, i - d, q[1]);
        next = std::fill_n(next, j - d, q[2]);
        std::fill_n(next, d, q[3]);
        h.row(i * (n + 1) + j) += share(n, i, j, d) * triangle.blossom(arguments).transpose();
      }
  if (!triangle.isRational()) h.col(3).setConstant(triangle.weights()(0));
  return {n, n, affinePoles(h), h.col(3)};
}

}  // namespace

BezierPatch degeneratePatch(const BezierTriangle& triangle, int apex) {
  if (apex < 0 || apex > 2)
    throw std::invalid_argument("apex " + std::to_string(apex) + ": known are 0, 1 and 2");
  const int n = triangle.degree();
  const BezierTriangle turned = triangle.permuted({apex, (apex + 1) % 3, (apex + 2) % 3});
  const HomogeneousPoles h = degenerateNet(turned.homogeneousPoles(), n, n)
                                 .reshaped<Eigen::RowMajor>((n + 1) * (n + 1), 4);
  return {n, n, affinePoles(h), h.col(3)};
}

double conversionNoise(const BezierTriangle& triangle) {
  return 16 * (triangle.degree() + 1) * std::numeric_limits<double>::epsilon() *
         poleSize(triangle.poles(), triangle.weights());
}

std::array<BezierPatch, 3> regularPatches(const BezierTriangle& triangle) {
  const std::array<Barycentric, 3> corner = {Barycentric(1, 0, 0), Barycentric(0, 1, 0),
                                             Barycentric(0, 0, 1)};
  const Barycentric centroid = Barycentric::Constant(1.0 / 3);
  const auto patch = [&](int k) {
    const Barycentric &a = corner[k], &b = corner[(k + 1) % 3], &c = corner[(k + 2) % 3];
    return quadrangle(triangle, {a, 0.5 * (a + b), 0.5 * (a + c), centroid});
  };
  return {patch(0), patch(1), patch(2)};
}

TriangleRecognition recogniseTriangle(const BezierPatch& patch,
                                      std::optional<double> tolerance_mm) {
  if (tolerance_mm && !(*tolerance_mm >= 0))
    throw std::invalid_argument(
        fmt::format("tolerance_mm is {}: it must not be negative", *tolerance_mm));
  const double noise = 8 * (patch.degreeU() + patch.degreeV() + 4) *
                       std::numeric_limits<double>::epsilon() *
                       poleSize(patch.poles(), patch.weights());
  const auto better = [](const TriangleRecognition& a, const TriangleRecognition& b) {
    if (a.triangle && b.triangle && a.triangle->degree() != b.triangle->degree())
      return a.triangle->degree() < b.triangle->degree();
    if (a.triangle.has_value() != b.triangle.has_value()) return a.triangle.has_value();
    return a.deviation_mm < b.deviation_mm;
  };
  TriangleRecognition best = recogniseAt(patch, PatchEdge::U0, tolerance_mm.value_or(noise));
  for (const PatchEdge edge : {PatchEdge::U1, PatchEdge::V0, PatchEdge::V1}) {
    const TriangleRecognition other = recogniseAt(patch, edge, best.tolerance_mm);
    if (better(other, best)) best = other;
  }
  return best;
}

}  // namespace seamwright
