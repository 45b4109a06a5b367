// SPDX-License-Identifier: LGPL-2.1-or-later
// Times of the operations on Bernstein forms, by degree.
#include <benchmark/benchmark.h>

#include <random>
#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bernstein/tensor.hpp>

namespace seamwright {
namespace {

Eigen::MatrixXd randomMatrix(Eigen::Index rows, Eigen::Index cols, double lower = -1) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(lower, 1);
  return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return uniform(random); });
}

/// Has an error bound, like a polynomial in the middle of a chain of operations.
BernsteinPolynomial polynomial(benchmark::State& state) {
  return BernsteinPolynomial(randomMatrix(state.range(0) + 1, 1), 1e-15);
}

BernsteinTensor tensor(benchmark::State& state) {
  return BernsteinTensor(randomMatrix(state.range(0) + 1, state.range(0) + 1), 1e-15);
}

void polynomialEvaluate(benchmark::State& state) {
  const BernsteinPolynomial p = polynomial(state);
  for (auto _ : state) benchmark::DoNotOptimize(p.evaluate(0.3));
}

void polynomialSplit(benchmark::State& state) {
  const BernsteinPolynomial p = polynomial(state);
  for (auto _ : state) benchmark::DoNotOptimize(p.split(0.5));
}

void polynomialProduct(benchmark::State& state) {
  const BernsteinPolynomial p = polynomial(state);
  for (auto _ : state) benchmark::DoNotOptimize(p * p);
}

void polynomialSumOfTwoDegrees(benchmark::State& state) {
  const BernsteinPolynomial p = polynomial(state), q = p.derivative();
  for (auto _ : state) benchmark::DoNotOptimize(p + q);
}

void polynomialRange(benchmark::State& state) {
  const BernsteinPolynomial p = polynomial(state);
  for (auto _ : state) benchmark::DoNotOptimize(p.range(1e-9));
}

void tensorEvaluate(benchmark::State& state) {
  const BernsteinTensor f = tensor(state);
  for (auto _ : state) benchmark::DoNotOptimize(f.evaluate(0.3, 0.7));
}

void tensorProduct(benchmark::State& state) {
  const BernsteinTensor f = tensor(state);
  for (auto _ : state) benchmark::DoNotOptimize(f * f);
}

void tensorRestrict(benchmark::State& state) {
  const BernsteinTensor f = tensor(state);
  for (auto _ : state) benchmark::DoNotOptimize(f.restricted({0.2, 0.4}, {0.5, 0.9}));
}

/// The composition of a surface of bi-degree n with a parameter curve of degree 3.
void tensorComposed(benchmark::State& state) {
  const BernsteinTensor f = tensor(state);
  const BernsteinPolynomial u(randomMatrix(4, 1, 0)), v(u.coefficients().reverse());
  for (auto _ : state) benchmark::DoNotOptimize(f.composed(u, v));
}

BENCHMARK(polynomialEvaluate)->Arg(3)->Arg(12)->Arg(60);
BENCHMARK(polynomialSplit)->Arg(3)->Arg(12)->Arg(60);
BENCHMARK(polynomialProduct)->Arg(3)->Arg(12)->Arg(60);
BENCHMARK(polynomialSumOfTwoDegrees)->Arg(3)->Arg(12)->Arg(60);
BENCHMARK(polynomialRange)->Arg(3)->Arg(12)->Arg(60);
BENCHMARK(tensorEvaluate)->Arg(3)->Arg(7);
BENCHMARK(tensorProduct)->Arg(3)->Arg(7);
BENCHMARK(tensorRestrict)->Arg(3)->Arg(7);
BENCHMARK(tensorComposed)->Arg(3)->Arg(5);

}  // namespace
}  // namespace seamwright

BENCHMARK_MAIN();
