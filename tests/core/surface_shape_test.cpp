// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <limits>
#include <seamwright/core/bezier/surface_shape.hpp>
#include <seamwright/core/bspline/surface.hpp>

#include "exact_shape.hpp"
#include "support/random.hpp"
#include "surfaces.hpp"

namespace seamwright {
namespace {

/// Over a grid of about unit steps, with weights 2^-spread to 2^spread.
BezierPatch unevenPatch(int m, int n, double spread, std::mt19937_64& random) {
  std::uniform_real_distribution<double> exponent(-spread, spread);
  Poles poles((m + 1) * (n + 1), 3);
  Eigen::VectorXd weights(poles.rows());
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const int row = i * (n + 1) + j;
      poles.row(row) = Eigen::RowVector3d(i, j, 0) + 0.3 * test::randomVector(random).transpose();
      weights(row) = std::exp2(exponent(random));
    }
  return {m, n, poles, weights};
}

double spectralNorm(const Eigen::Matrix3d& tensor) {
  return tensor.selfadjointView<Eigen::Lower>().eigenvalues().cwiseAbs().maxCoeff();
}

/// \return the error bound of the tensor over its size
double expectExactShape(const BezierPatch& patch, double u, double v) {
  const SurfaceShape shape = surfaceShape(patch, u, v);
  EXPECT_EQ(shape.degeneracy, Degeneracy::None);
  const test::ExactShape exact = test::exactShape(patch, u, v);
  const double size = spectralNorm(shape.tensor), error = shape.tensor_error_per_mm;
  EXPECT_LE((shape.normal - exact.normal).norm(), shape.normal_error_rad);
  EXPECT_LE(std::abs(shape.tensor.trace() - exact.twice_mean), 2 * error);
  const double gauss =
      0.5 * (shape.tensor.trace() * shape.tensor.trace() - (shape.tensor * shape.tensor).trace());
  EXPECT_LE(std::abs(gauss - exact.gauss), 2 * size * error + error * error + 1e-15 * size * size);
  const BoundedChange change = curvatureChange(shape, exact.along_u);
  // The direction itself is rounded.
  const Eigen::Vector3d beside = exact.along_u + 1e-12 * shape.normal.cross(exact.along_u);
  const double by_direction =
      1e-3 * std::abs(curvatureChange(shape, beside).value_per_mm2 - change.value_per_mm2);
  EXPECT_LE(std::abs(change.value_per_mm2 - exact.change_along_u),
            change.error_per_mm2 + by_direction);
  return error / size;
}

TEST(SurfaceShape, Identity1ExactWhateverTheWeights) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> inside(0, 1);
  for (const double spread : {0.0, 4.0, 8.0, 12.0, 30.0}) {
    std::vector<double> worth;
    for (int i = 0; i < 60; ++i) {
      SCOPED_TRACE(std::to_string(spread) + ", " + std::to_string(i));
      const BezierPatch patch = unevenPatch(2 + i % 2, 1 + i % 3, spread, random);
      const double u = i % 4 == 0 ? i % 8 == 0 : inside(random),
                   v = i % 5 == 0 ? i % 10 == 0 : inside(random);
      worth.push_back(expectExactShape(patch, u, v));
    }
    std::ranges::sort(worth);
    EXPECT_LE(worth[30], 1e-11) << spread;
    EXPECT_LE(worth[54], 1e-8) << spread;
  }
}

// The bounds are no larger than what partials by u and v lose.
TEST(SurfaceShape, PartialsByUAndVLoseMoreThanTheBound) {
  std::mt19937_64 random(testSeed());
  int lost = 0;
  for (int i = 0; i < 60; ++i) {
    const BezierPatch patch = unevenPatch(2, 2, 40, random);
    const SurfaceShape shape = surfaceShape(patch, 0.4, 0.7);
    const auto normal = unitNormal(patch.jet(0.4, 0.7));
    lost += !normal || spectralNorm(curvatureTensor(patch.jet(0.4, 0.7), *normal) - shape.tensor) >
                           100 * shape.tensor_error_per_mm;
  }
  EXPECT_GT(lost, 10);
}

TEST(SurfaceShape, PartialsOfUnevenPatchesAreExactToTheirSize) {
  std::mt19937_64 random(testSeed());
  for (const double spread : {0.0, 6.0, 12.0})
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE(std::to_string(spread) + ", " + std::to_string(i));
      const BezierPatch patch = unevenPatch(2 + i % 2, 1 + i % 3, spread, random);
      const SurfaceJet jet = patch.jet(0.375, 0.8125);
      const SurfaceJet spline = seamwright::jet(splineSurface(patch), 0.375, 0.8125);
      const test::ExactPartials exact = test::exactPartials(patch, 0.375, 0.8125);
      for (const SurfaceJet* of : {&jet, &spline}) {
        EXPECT_LE((of->u - exact.u).norm(), 1e-12 * exact.u.norm());
        EXPECT_LE((of->uu - exact.uu).norm(), 1e-11 * exact.uu.norm());
        EXPECT_LE((of->uv - exact.uv).norm(), 1e-11 * exact.uv.norm());
      }
    }
}

TEST(SurfaceShape, Identity2OfUsualPatchesAsByTheirJets) {
  std::mt19937_64 random(testSeed());
  for (int i = 0; i < 200; ++i) {
    const BezierPatch patch = unevenPatch(1 + i % 4, 1 + i % 3, i % 2, random);
    const double u = 0.005 * i, v = 1 - 0.005 * i;
    const SurfaceJet jet = patch.jet(u, v);
    const SurfaceShape shape = surfaceShape(patch, u, v);
    ASSERT_EQ(shape.degeneracy, Degeneracy::None);
    const Eigen::Vector3d normal = *unitNormal(jet), along = jet.u.normalized();
    EXPECT_LT((shape.normal - normal).norm(), 1e-12);
    EXPECT_LT(spectralNorm(shape.tensor - curvatureTensor(jet, normal)),
              1e-11 * (1 + spectralNorm(shape.tensor)));
    const double change = curvatureChange(jet, normal, along);
    EXPECT_NEAR(curvatureChange(shape, along).value_per_mm2, change, 1e-9 * (1 + std::abs(change)));
  }
}

TEST(SurfaceShape, Identity3TrianglesWithCornersPermuted) {
  std::mt19937_64 random(testSeed());
  std::uniform_real_distribution<double> exponent(-20, 20);
  for (int run = 0; run < 100; ++run) {
    const int n = 2 + run % 3;
    Poles poles((n + 1) * (n + 2) / 2, 3);
    Eigen::VectorXd weights(poles.rows());
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) {
        const Eigen::Index row = BezierTriangle::row(n, i, j);
        poles.row(row) = Eigen::RowVector3d(i, j, 0) + 0.2 * test::randomVector(random).transpose();
        weights(row) = run % 2 ? std::exp2(exponent(random)) : 1;
      }
    const BezierTriangle triangle(poles, weights);
    const Barycentric l =
        run % 5 == 0 ? Barycentric(0, 0.25, 0.75) : Barycentric(0.125, 0.5, 0.375);
    const SurfaceShape shape = surfaceShape(triangle, l(0), l(1));
    ASSERT_EQ(shape.degeneracy, Degeneracy::None);
    const SurfaceShape turned = surfaceShape(triangle.permuted({1, 2, 0}), l(1), l(2)),
                       other = surfaceShape(triangle.permuted({2, 0, 1}), l(2), l(0)),
                       mirrored = surfaceShape(triangle.permuted({1, 0, 2}), l(1), l(0));
    for (const SurfaceShape* same : {&turned, &other}) {
      EXPECT_LE((same->normal - shape.normal).norm(),
                same->normal_error_rad + shape.normal_error_rad)
          << run;
      EXPECT_LE(spectralNorm(same->tensor - shape.tensor),
                same->tensor_error_per_mm + shape.tensor_error_per_mm);
    }
    EXPECT_LE((mirrored.normal + shape.normal).norm(),
              mirrored.normal_error_rad + shape.normal_error_rad);
    if (run % 2) continue;
    const SurfaceJet jet = triangle.jet(l(0), l(1));
    EXPECT_LT((shape.normal - *unitNormal(jet)).norm(), 1e-12);
    EXPECT_LT(spectralNorm(shape.tensor - curvatureTensor(jet, shape.normal)),
              1e-11 * (1 + spectralNorm(shape.tensor)));
  }
}

TEST(SurfaceShape, WithoutATangentPlane) {
  Poles collapsed(4, 3);
  collapsed << 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0;  // the edge u = 0 is a point
  const BezierPatch patch(1, 1, collapsed);
  EXPECT_EQ(surfaceShape(patch, 0, 0.5).degeneracy, Degeneracy::VanishingNormal);
  EXPECT_EQ(surfaceShape(patch, 0x1p-60, 0.5).degeneracy, Degeneracy::None);
  Poles line(4, 3);
  line << 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3;
  EXPECT_EQ(surfaceShape(BezierPatch(1, 1, line), 0.3, 0.5).degeneracy,
            Degeneracy::VanishingNormal);
  EXPECT_EQ(surfaceShape(BezierPatch(3, 0, line), 0.3, 0.5).degeneracy,
            Degeneracy::VanishingNormal);
  EXPECT_THROW(surfaceShape(patch, std::nan(""), 0), std::invalid_argument);
}

}  // namespace
}  // namespace seamwright
