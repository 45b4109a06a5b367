// SPDX-License-Identifier: LGPL-2.1-or-later
// Times of planar curves, and how those of methods that are linear in the points grow beside a bare
// tridiagonal solve of as many unknowns (the counter "ratio", of the same run). Times of those
// methods are processor time.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>
#include <vector>

#include <seamwright/core/fair/fair_curve.hpp>
#include <seamwright/core/fair/function_spline.hpp>
#include <seamwright/core/fair/polish_curve.hpp>
#include <seamwright/core/planar/clothoid.hpp>
#include <seamwright/core/planar/clothoid_phase.hpp>
#include <seamwright/core/planar/fair_clothoids.hpp>
#include <seamwright/core/planar/fair_points.hpp>
#include <seamwright/core/planar/point_curvature.hpp>
#include <seamwright/core/planar/tridiagonal.hpp>

namespace seamwright {
namespace {

using std::numbers::pi;

constexpr int pair_count = 1'000'000;

/// Ends on a chord from (0, 0) to (1, 0), with tangents over the whole square of angles but for the
/// corners, where the length has no bound.
const std::vector<HermiteEnds>& tangentPairs() {
  static const std::vector<HermiteEnds> pairs = [] {
    std::mt19937_64 random(19);
    std::uniform_real_distribution<double> angle(-pi, pi);
    std::vector<HermiteEnds> result;
    while (result.size() < pair_count) {
      const double start_rad = angle(random), end_rad = angle(random);
      if (std::abs(start_rad - end_rad) < 2 * pi - 1e-3)
        result.push_back({.start_direction_rad = start_rad,
                          .end = Eigen::Vector2d(1, 0),
                          .end_direction_rad = end_rad});
    }
    return result;
  }();
  return pairs;
}

Phase phaseOf(const HermiteEnds& ends) {
  return {.start = ends.start_direction_rad,
          .change = ends.end_direction_rad - ends.start_direction_rad};
}

void clothoidOfEnds(benchmark::State& state) {
  const std::vector<HermiteEnds>& pairs = tangentPairs();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(clothoid(pairs[i++ % pair_count]));
}

/// The end of the same clothoids by 16 nodes over the whole length.
void clothoidQuadrature(benchmark::State& state) {
  std::vector<Clothoid> curves;
  for (int i = 0; i < 10'000; ++i) curves.push_back(clothoid(tangentPairs()[i]));
  const GaussRule& rule = phaseRule();
  std::size_t next = 0;
  for (auto _ : state) {
    const Clothoid& curve = curves[next++ % curves.size()];
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int i = 0; i < phase_nodes; ++i) {
      const double direction_rad = curve.directionAt_rad(rule.nodes[i] * curve.length_mm);
      sum += rule.weights[i] * Eigen::Vector2d(std::cos(direction_rad), std::sin(direction_rad));
    }
    benchmark::DoNotOptimize(sum);
  }
}

/// A million pairs of tangents: the most steps of Newton's method, the largest distance of the root
/// from that of a finer quadrature against |start| + |end|, and the shortest width.
void clothoidRoots(benchmark::State& state) {
  double most_steps = 0, error = 0, least_width = 1;
  const auto finer = [](const Phase& phase, double a) {
    // Panels a sixth as wide: another rule, with other roundings.
    const Eigen::Array2d sums = integral(
        [&](double t) {
          const double at = phase.at(a, t);
          return Eigen::Array2d(std::sin(at), (t * t - t) * std::cos(at));
        },
        6 * phase.turn(a));
    return sums(0) / sums(1);
  };
  for (auto _ : state)
    for (const HermiteEnds& ends : tangentPairs()) {
      const Phase phase = phaseOf(ends);
      const PhaseRoot root = rootOf(phase);
      const double size = std::abs(phase.start) + std::abs(phase.start + phase.change);
      most_steps = std::max<double>(most_steps, root.steps);
      error = std::max(error, std::abs(finer(phase, root.a)) / size);
      least_width = std::min(least_width, root.width);
    }
  state.counters["most_steps"] = most_steps;
  state.counters["error"] = error;
  state.counters["least_width"] = least_width;
  if (!(most_steps <= 5 && error <= 1e-12 && least_width > 0))
    state.SkipWithError("too many steps, an error or a wrong root");
}

/// A wave on an arc of a large circle, with equal distances of 1 mm and noise.
PlanarPoints noisyPoints(Eigen::Index count, double noise_mm) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0, noise_mm);
  PlanarPoints points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double x = static_cast<double>(i);
    points.row(i) << x, 40 * std::sin(x / 100) + noise(random);
  }
  return points;
}

double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double secondsOf(const auto& work) {
  const double start = processorSeconds();
  work();
  return processorSeconds() - start;
}

void solveBare(Eigen::Index count) {
  TridiagonalEquations equations(count, false);
  for (Eigen::Index i = 0; i < count; ++i)
    equations.add(i, i > 0 ? 1 : 0, 4, i + 1 < count ? 1 : 0, static_cast<double>(i % 7));
  benchmark::DoNotOptimize(std::move(equations).solve());
}

/// Times \p work in turn with the bare solve. \p steps of an iteration count as one each.
void besideBareSolve(benchmark::State& state, const auto& work) {
  const Eigen::Index count = state.range(0);
  double bare_s = 0, own_s = 0, steps = 0;
  for (auto _ : state) {
    bare_s += secondsOf([&] { solveBare(count); });
    double taken = 0;
    const double spent_s = secondsOf([&] { taken = work(); });
    own_s += spent_s;
    steps += taken;
    state.SetIterationTime(spent_s);
  }
  const auto points = static_cast<double>(count) * static_cast<double>(state.iterations());
  state.counters["ns_per_point"] = 1e9 * own_s / points;
  state.counters["steps"] = steps / static_cast<double>(state.iterations());
  state.counters["ratio"] = own_s / bare_s;
  state.counters["ratio_per_step"] =
      own_s / bare_s * static_cast<double>(state.iterations()) / steps;
}

void tridiagonalSolve(benchmark::State& state) {
  for (auto _ : state) solveBare(state.range(0));
}

/// With little noise, because these tangents sum up the errors of all points.
void nearCircleTangents(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-5);
  besideBareSolve(state, [&] {
    benchmark::DoNotOptimize(tangentsAt(points, {.rule = TangentRule::NearCircles}));
    return 1;
  });
}

void screening(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-3);
  besideBareSolve(state, [&] {
    benchmark::DoNotOptimize(isolatedInflections(points));
    return 1;
  });
}

void biarcSplineThroughPoints(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-3);
  besideBareSolve(state, [&] {
    benchmark::DoNotOptimize(biarcSpline(points));
    return 1;
  });
}

void linearEnergyTangents(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-3);
  besideBareSolve(state, [&] {
    benchmark::DoNotOptimize(tangentsAt(points));
    return 1;
  });
}

void energyTangents(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-3);
  besideBareSolve(state,
                  [&] { return 1 + tangentsAt(points, {.rule = TangentRule::Energy}).steps; });
}

void curvatureFilter(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-3);
  besideBareSolve(
      state, [&] { return std::max(1, filterCurvature(points, 0.01, {.max_passes = 10}).steps); });
}

void polishing(benchmark::State& state) {
  const FunctionSpline spline = functionSpline(noisyPoints(state.range(0), 1e-3));
  besideBareSolve(state, [&] { return std::max(1, polishFunction(spline, 0.01).steps); });
}

/// The poles alone, which is what polishing iterates.
void polishedOrdinates(benchmark::State& state) {
  const Eigen::VectorXd ordinates = noisyPoints(state.range(0), 1e-3).col(1);
  constexpr int steps = 4;
  besideBareSolve(state, [&] {
    benchmark::DoNotOptimize(polishedPoles(ordinates, steps));
    return steps;
  });
}

void rebound(benchmark::State& state) {
  const FunctionSpline spline = functionSpline(noisyPoints(state.range(0), 1e-3));
  besideBareSolve(state, [&] {
    benchmark::DoNotOptimize(rebounded(spline));
    return 1;
  });
}

void rebounds(benchmark::State& state) {
  const FunctionSpline spline = functionSpline(noisyPoints(state.range(0), 1e-3));
  besideBareSolve(state, [&] { return std::max(1, reboundFunction(spline, 0.01).steps); });
}

/// Each point has a tolerance of its own; every tenth stays.
Eigen::VectorXd unequalTolerances(Eigen::Index count) {
  Eigen::VectorXd tolerances_mm(count);
  for (Eigen::Index i = 0; i < count; ++i) tolerances_mm(i) = 0.001 * static_cast<double>(i % 10);
  return tolerances_mm;
}

void fairedPoints(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-3);
  const Eigen::VectorXd tolerances_mm = unequalTolerances(points.rows());
  besideBareSolve(state, [&] { return std::max(1, fairPoints(points, tolerances_mm).steps); });
}

void fairedClothoids(benchmark::State& state) {
  const PlanarPoints points = noisyPoints(state.range(0), 1e-3);
  const Eigen::VectorXd tolerances_mm = Eigen::VectorXd::Constant(points.rows(), 0.005);
  besideBareSolve(state, [&] { return std::max(1, fairClothoids(points, tolerances_mm).steps); });
}

/// Cubic, with uniform knots and noise in its poles.
BSplineCurve noisyCurve(Eigen::Index count) {
  const PlanarPoints points = noisyPoints(count, 1e-3);
  BSplineCurve curve;
  curve.degree = 3;
  curve.poles.resize(count, 4);
  curve.poles << points, Eigen::VectorXd::Zero(count), Eigen::VectorXd::Ones(count);
  for (Eigen::Index i = 0; i < count + 4; ++i)
    curve.knots.push_back(static_cast<double>(std::clamp<Eigen::Index>(i - 3, 0, count - 3)));
  return curve;
}

void fairedSpline(benchmark::State& state) {
  const BSplineCurve curve = noisyCurve(state.range(0));
  besideBareSolve(state, [&] { return std::max(1, fairCurve(curve, 0.01).steps); });
}

void polishedCurve(benchmark::State& state) {
  const BSplineCurve curve = noisyCurve(state.range(0));
  besideBareSolve(state, [&] { return std::max(1, polishCurve(curve, 0.01).steps); });
}

void fairedAtKnots(benchmark::State& state) {
  const BSplineCurve curve = noisyCurve(state.range(0));
  besideBareSolve(state, [&] { return std::max(1, fairKnots(curve, 0.01).steps); });
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int count : {1000, 10'000, 100'000, 1'000'000}) benchmark->Arg(count);
  benchmark->UseManualTime()->Unit(benchmark::kMillisecond);
}

/// Of methods that take a hundred times as long.
void fewerSizes(benchmark::internal::Benchmark* benchmark) {
  for (const int count : {1000, 10'000, 100'000}) benchmark->Arg(count);
  benchmark->UseManualTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(clothoidOfEnds);
BENCHMARK(clothoidQuadrature);
BENCHMARK(clothoidRoots)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(tridiagonalSolve)
    ->Arg(1000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(linearEnergyTangents)->Apply(sizes);
BENCHMARK(nearCircleTangents)->Apply(sizes);
BENCHMARK(screening)->Apply(sizes);
BENCHMARK(biarcSplineThroughPoints)->Apply(sizes);
BENCHMARK(energyTangents)->Apply(sizes);
BENCHMARK(curvatureFilter)->Apply(sizes);
BENCHMARK(polishedOrdinates)->Apply(sizes);
BENCHMARK(polishing)->Apply(sizes);
BENCHMARK(rebound)->Apply(sizes);
BENCHMARK(rebounds)->Apply(sizes);
BENCHMARK(fairedPoints)->Apply(sizes);
BENCHMARK(fairedClothoids)->Apply(fewerSizes);
BENCHMARK(fairedSpline)->Apply(fewerSizes);
BENCHMARK(fairedAtKnots)->Apply(fewerSizes);
BENCHMARK(polishedCurve)->Apply(fewerSizes);

}  // namespace
}  // namespace seamwright

BENCHMARK_MAIN();
