// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <random>

#include <seamwright/core/spline/beta_spline.hpp>

#include "support/random.hpp"

namespace seamwright::test {
namespace {

using opencascade::handle;

Eigen::Vector3d vector(const gp_XYZ& v) {
  return {v.X(), v.Y(), v.Z()};
}

/// OpenCASCADE's cubic spline through the same points with the same knots.
handle<Geom_BSplineCurve> interpolated(const NuSplineData& data) {
  const bool periodic = data.ends == SplineEnds::Periodic;
  const int count = static_cast<int>(data.points.rows());
  const handle<TColgp_HArray1OfPnt> points =
      new TColgp_HArray1OfPnt(1, periodic ? count - 1 : count);
  const handle<TColStd_HArray1OfReal> knots = new TColStd_HArray1OfReal(1, count);
  for (int i = 0; i < points->Length(); ++i)
    points->SetValue(i + 1, gp_Pnt(data.points(i, 0), data.points(i, 1), data.points(i, 2)));
  for (int i = 0; i < count; ++i) knots->SetValue(i + 1, data.knots[static_cast<std::size_t>(i)]);
  GeomAPI_Interpolate interpolate(points, knots, periodic, 1e-9);
  const auto gp = [](const Eigen::Vector3d& v) { return gp_Vec(v.x(), v.y(), v.z()); };
  if (data.ends == SplineEnds::Clamped)
    interpolate.Load(gp(data.start_derivative), gp(data.end_derivative), false);
  interpolate.Perform();
  return interpolate.IsDone() ? interpolate.Curve() : nullptr;
}

/// The largest difference of points and derivatives to the second, relative to the largest pole.
double difference(const BezierSpline& spline, const Geom_BSplineCurve& curve) {
  double largest = 0;
  const double size = spline.poles.leftCols<3>().cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i + 1 < spline.knots.size(); ++i)
    for (const double share : {0.1, 0.5, 0.9}) {
      const double h = spline.knots[i + 1] - spline.knots[i], t = spline.knots[i] + share * h;
      const CurveDerivatives x = derivatives(spline, t, 2);
      gp_Pnt p;
      gp_Vec d1, d2;
      curve.D2(t, p, d1, d2);
      largest = std::max({largest, (x.row(0).transpose() - vector(p.XYZ())).norm() / size,
                          (x.row(1).transpose() - vector(d1.XYZ())).norm() * h / size,
                          (x.row(2).transpose() - vector(d2.XYZ())).norm() * h * h / size});
    }
  return largest;
}

NuSplineData randomData(Eigen::Index count, SplineEnds ends, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> length(0.5, 2);
  NuSplineData data{Poles::NullaryExpr(count, 3, [&] { return 10 * normal(random); }),
                    {0},
                    std::vector<double>(static_cast<std::size_t>(count), 0.0),
                    ends,
                    Eigen::Vector3d::NullaryExpr([&] { return normal(random); }),
                    Eigen::Vector3d::NullaryExpr([&] { return normal(random); })};
  for (Eigen::Index i = 1; i < count; ++i) data.knots.push_back(data.knots.back() + length(random));
  if (ends == SplineEnds::Periodic) data.points.row(count - 1) = data.points.row(0);
  return data;
}

TEST(NuSpline, ClampedWithoutTensionItIsOpenCascadesInterpolation) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 100; ++k) {
    NuSplineData data = randomData(4 + k % 9, SplineEnds::Clamped, random);
    const handle<Geom_BSplineCurve> curve = interpolated(data);
    ASSERT_FALSE(curve.IsNull());
    ASSERT_LT(difference(nuSpline(data).curve, *curve), 1e-11) << k;
    data.nu[1] = 1e-3;
    ASSERT_GT(difference(nuSpline(data).curve, *curve), 1e-7) << k;
  }
}

TEST(NuSpline, PeriodicItIsC2WhereOpenCascadesInterpolationIsC1) {
  // OpenCASCADE takes a tangent for the seam, where its knot is double: that is a clamped spline.
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 100; ++k) {
    NuSplineData data = randomData(4 + k % 9, SplineEnds::Periodic, random);
    const handle<Geom_BSplineCurve> curve = interpolated(data);
    ASSERT_FALSE(curve.IsNull());
    ASSERT_EQ(curve->Multiplicity(1), 2);
    const BezierSpline spline = nuSpline(data).curve;
    gp_Pnt p;
    gp_Vec first, start, end;
    curve->D2(data.knots.back() * (1 - 1e-15), p, first, end);
    curve->D2(data.knots.front(), p, first, start);
    const auto own = [&](double t) { return derivatives(spline, t, 2).row(2).transpose().eval(); };
    const double size = own(0).norm();
    ASSERT_LT((own(data.knots.back()) - own(0)).norm(), 1e-11 * size) << k;
    ASSERT_GT((end - start).Magnitude(), 1e-4 * size) << k;
    data.ends = SplineEnds::Clamped;
    data.start_derivative = data.end_derivative = vector(first.XYZ());
    ASSERT_LT(difference(nuSpline(data).curve, *curve), 1e-11) << k;
  }
}

TEST(NuSpline, ABetaSplineWithoutBiasAndTensionIsOpenCascadesInterpolation) {
  std::mt19937_64 random(testSeed());
  for (int k = 0; k < 50; ++k) {
    NuSplineData data = randomData(4 + k % 9, SplineEnds::Clamped, random);
    for (std::size_t i = 0; i < data.knots.size(); ++i) data.knots[i] = static_cast<double>(i);
    BetaSplineData beta{data.points, std::vector<double>(data.knots.size(), 1.0), data.nu,
                        data.ends};
    beta.start_derivative = data.start_derivative;
    beta.end_derivative = data.end_derivative;
    const handle<Geom_BSplineCurve> curve = interpolated(data);
    ASSERT_FALSE(curve.IsNull());
    ASSERT_LT(difference(betaSpline(beta).curve, *curve), 1e-11) << k;
    beta.bias[1] = 1.001;
    ASSERT_GT(difference(betaSpline(beta).curve, *curve), 1e-7) << k;
  }
}

}  // namespace
}  // namespace seamwright::test
