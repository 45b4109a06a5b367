// SPDX-License-Identifier: LGPL-2.1-or-later
// nu-splines of up to a million points beside OpenCASCADE's interpolation and a plain tridiagonal
// solver.
//   bench_splines [--smoke]
// One process; the methods take turns for each repetition. Times are medians of processor time. The
// table goes to standard output.
#include <Eigen/Core>
#include <GeomAPI_Interpolate.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <seamwright/core/spline/beta_spline.hpp>

#include "program.hpp"

namespace {

using namespace seamwright;

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A noisy spiral; a periodic one ends at its first point.
NuSplineData dataOf(int points, SplineEnds ends) {
  std::mt19937_64 random(points);
  std::normal_distribution<double> noise(0, 0.01);
  NuSplineData data;
  data.ends = ends;
  data.points.resize(points, 3);
  for (int i = 0; i < points; ++i) {
    const double t = 8 * std::acos(-1.0) * i / (points - 1);
    data.points.row(i) << (100 + t) * std::cos(t), (100 + t) * std::sin(t),
        5 * t + noise(random) / points;
  }
  if (ends == SplineEnds::Periodic) data.points.row(points - 1) = data.points.row(0);
  data.knots = knotsOf(data.points);
  data.nu.assign(points, 0.0);
  data.start_derivative =
      (data.points.row(1) - data.points.row(0)) / (data.knots[1] - data.knots[0]);
  data.end_derivative = (data.points.row(points - 1) - data.points.row(points - 2)) /
                        (data.knots[points - 1] - data.knots[points - 2]);
  return data;
}

/// The derivatives of the natural nu-spline by Thomas's textbook algorithm, without checks and
/// without poles.
Poles thomas(const NuSplineData& data) {
  const Eigen::Index count = data.points.rows();
  const auto h = [&](Eigen::Index i) { return data.knots[i + 1] - data.knots[i]; };
  Eigen::VectorXd upper(count);
  Poles x(count, 3);
  double diagonal = 2 + data.nu[0] * h(0) / 2;
  upper(0) = 1 / diagonal;
  x.row(0) = 3 * (data.points.row(1) - data.points.row(0)) / h(0) / diagonal;
  for (Eigen::Index i = 1; i < count; ++i) {
    const bool last = i + 1 == count;
    const double a = h(i - 1), b = last ? 0 : h(i);
    const double lower = last ? 1 : b / (a + b);
    diagonal = 2 + data.nu[i] * a * (last ? 1 : lower) / 2 - lower * upper(i - 1);
    Eigen::RowVector3d right = lower * (data.points.row(i) - data.points.row(i - 1)) / a;
    if (!last) right += (1 - lower) * (data.points.row(i + 1) - data.points.row(i)) / b;
    upper(i) = (1 - lower) / diagonal;
    x.row(i) = (3 * right - lower * x.row(i - 1)) / diagonal;
  }
  for (Eigen::Index i = count - 1; i-- > 0;) x.row(i) -= upper(i) * x.row(i + 1);
  return x;
}

gp_Pnt pointOf(const Poles& points, Eigen::Index i) {
  return {points(i, 0), points(i, 1), points(i, 2)};
}

double interpolated(const NuSplineData& data) {
  const bool periodic = data.ends == SplineEnds::Periodic;
  const int count = static_cast<int>(data.points.rows());
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, periodic ? count - 1 : count);
  Handle(TColStd_HArray1OfReal) knots = new TColStd_HArray1OfReal(1, count);
  for (int i = 0; i < points->Length(); ++i) points->SetValue(i + 1, pointOf(data.points, i));
  for (int i = 0; i < count; ++i) knots->SetValue(i + 1, data.knots[i]);
  GeomAPI_Interpolate interpolate(points, knots, periodic, 1e-12);
  const auto vector = [](const Eigen::Vector3d& v) { return gp_Vec(v.x(), v.y(), v.z()); };
  if (data.ends == SplineEnds::Clamped)
    interpolate.Load(vector(data.start_derivative), vector(data.end_derivative), false);
  interpolate.Perform();
  return interpolate.IsDone() ? interpolate.Curve()->Value(data.knots[1]).X() : 0;
}

double fitted(const NuSplineData& data) {
  TColgp_Array1OfPnt points(1, static_cast<int>(data.points.rows()));
  for (int i = 0; i < points.Length(); ++i) points.SetValue(i + 1, pointOf(data.points, i));
  return GeomAPI_PointsToBSpline(points, 3, 8, GeomAbs_C2, 1e-3).Curve()->EndPoint().X();
}

struct Contender {
  std::string name;
  int most;  ///< largest number of points
  std::function<double(const NuSplineData&)> run;
  SplineEnds ends;
};

double solved(const NuSplineData& data) {
  return nuSpline(data).derivatives(1, 0);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const bool smoke = seamwright::bench::isSmoke(argc, argv);
  if (argc > 1 && !smoke) {
    std::fprintf(stderr, "usage: bench_splines [--smoke]\n");
    return 2;
  }
  const std::vector<int> sizes =
      smoke ? std::vector<int>{100, 200} : std::vector<int>{1000, 10000, 100000, 1000000};
  const int repetitions = smoke ? 1 : 7, all = sizes.back();
  const std::vector<Contender> contenders = {
      {"Thomas alone, natural", all, [](const NuSplineData& d) { return thomas(d)(1, 0); },
       SplineEnds::Natural},
      {"nu-spline, natural", all, solved, SplineEnds::Natural},
      {"nu-spline, clamped", all, solved, SplineEnds::Clamped},
      {"nu-spline, periodic", all, solved, SplineEnds::Periodic},
      {"nu-spline, natural, pivoted", all,
       [](const NuSplineData& d) {
         NuSplineData loose = d;
         loose.nu[1] = -4.1 * (1 / (d.knots[1] - d.knots[0]) + 1 / (d.knots[2] - d.knots[1]));
         return solved(loose);
       },
       SplineEnds::Natural},
      {"GeomAPI_Interpolate, tangents its own", all, interpolated, SplineEnds::Natural},
      {"GeomAPI_Interpolate, tangents given", all, interpolated, SplineEnds::Clamped},
      {"GeomAPI_Interpolate, periodic", all, interpolated, SplineEnds::Periodic},
      {"GeomAPI_PointsToBSpline", 100000, fitted, SplineEnds::Natural},
  };
  std::map<std::pair<std::size_t, int>, double> seconds;
  double checksum = 0;
  for (const int size : sizes) {
    std::map<std::size_t, std::vector<double>> times;
    for (int repetition = 0; repetition < repetitions; ++repetition)
      for (std::size_t k = 0; k < contenders.size(); ++k) {
        if (size > contenders[k].most) continue;
        if (!times[k].empty() && times[k].front() > 1) continue;  // slow methods run once
        const NuSplineData data = dataOf(size, contenders[k].ends);
        const double start = processorSeconds();
        checksum += contenders[k].run(data);
        times[k].push_back(processorSeconds() - start);
      }
    for (const auto& [k, values] : times) seconds[{k, size}] = median(values);
  }
  std::printf(
      "Nanoseconds of processor time a point, and beside nu-spline, natural, of the same "
      "points:\n\n| |");
  for (const int size : sizes) std::printf(" %d points |", size);
  std::printf("\n|---|");
  for (std::size_t i = 0; i < sizes.size(); ++i) std::printf("--:|");
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    std::printf("\n| %s |", contenders[k].name.c_str());
    for (const int size : sizes) {
      const auto found = seconds.find({k, size});
      if (found == seconds.end())
        std::printf(" - |");
      else
        std::printf(" %.0f (%.3g) |", 1e9 * found->second / size,
                    found->second / seconds[{1, size}]);
    }
  }
  const double growth = std::log(seconds[{1, sizes.back()}] / seconds[{1, sizes.front()}]) /
                        std::log(static_cast<double>(sizes.back()) / sizes.front());
  std::printf("\n\nTime of the natural nu-spline grows as points^%.2f.\n", growth);
  return std::isfinite(checksum) ? 0 : 1;
}
