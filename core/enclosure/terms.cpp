// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include <seamwright/core/enclosure/chebyshev_model.hpp>
#include <seamwright/core/enclosure/terms.hpp>

#if defined(__GNUC__) && defined(__x86_64__)
#define SEAMWRIGHT_HAS_AVX2 1
#include <immintrin.h>
#endif

namespace seamwright::terms {

namespace {

constexpr int size = ChebyshevModel::size;
constexpr int middle = ChebyshevModel::max_degree;  ///< the place of b_0 among mirrored numbers
using Terms = Eigen::Array<double, size, 1>;

Terms at(const double* first) {
  return Eigen::Map<const Terms>(first);
}

void add(const Terms& more, double* sum) {
  Eigen::Map<Terms> view(sum);
  view += more;
}

double absoluteSum(const double* numbers, double first) {
  std::array<double, 4> sums = {first, std::abs(numbers[1]), std::abs(numbers[2]),
                                std::abs(numbers[3])};
  for (int k = 0; k < 4; ++k) sums[k] += std::abs(numbers[4 + k]);
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

#ifdef SEAMWRIGHT_HAS_AVX2
static_assert(size == 8, "two registers hold the terms");

/// All terms in two registers. The functions below have an attribute that allows the instructions;
/// the compiler does not fuse products and sums, because FMA is not allowed.
struct Registers {
  __m256d low, high;
};

/// Two halves at a time: they may have been stored by instructions of two numbers, and a processor
/// waits before it loads four numbers that are not stored as such.
[[gnu::target("avx2")]] inline __m256d load(const double* numbers) {
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(numbers)),
                              _mm_loadu_pd(numbers + 2), 1);
}

[[gnu::target("avx2")]] inline void addTo(double* sum, const Registers& more) {
  _mm256_storeu_pd(sum, _mm256_add_pd(load(sum), more.low));
  _mm256_storeu_pd(sum + 4, _mm256_add_pd(load(sum + 4), more.high));
}

/// The numbers b_-7 to b_8, with b_-k = b_k, and b_0 twice. Those above are zero.
/// at[k] holds four of them from b_(k - 7) on. They are shifted in registers: a load from parts of
/// two stores would wait for these.
struct Mirrored {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): the loop sets the others
  [[gnu::target("avx2")]] explicit Mirrored(const double* b) {
    constexpr int reverse = 0b00011011;
    const __m256d low = load(b), high = load(b + 4), zero = _mm256_setzero_pd();
    const __m256d doubled = _mm256_blend_pd(low, _mm256_add_pd(low, low), 1);
    at[0] = _mm256_permute4x64_pd(high, reverse);
    at[4] = _mm256_permute4x64_pd(doubled, reverse);
    at[8] = _mm256_permute4x64_pd(_mm256_blend_pd(low, high, 1), 0b00111001);
    at[12] = _mm256_permute4x64_pd(_mm256_blend_pd(high, zero, 1), 0b00111001);
    at[16] = zero;
    for (int k = 0; k < 16; k += 4) {
      at[k + 2] = _mm256_permute2f128_pd(at[k], at[k + 4], 0x21);
      at[k + 1] = _mm256_shuffle_pd(at[k], at[k + 2], 0b0101);
      at[k + 3] = _mm256_shuffle_pd(at[k + 2], at[k + 4], 0b0101);
    }
  }
  /// Four numbers from b_k on.
  [[gnu::target("avx2")]] __m256d from(int k) const { return at[std::min(k + middle, 16)]; }

  __m256d at[17];
};

/// The loops have a fixed length: without counters and branches they take half the instructions.
template <int Degree>
[[gnu::target("avx2")]] void addUnrolled(const double* a, const double* series, bool is_long,
                                         double* low, double* high) {
  const Mirrored b(series);
  Registers sum{_mm256_setzero_pd(), _mm256_setzero_pd()}, more = sum;
#pragma GCC unroll 8
  for (int i = 0; i <= Degree; ++i) {
    const __m256d by = _mm256_broadcast_sd(a + i);
    const __m256d first = _mm256_add_pd(b.from(-i), b.from(i));
    const __m256d second = _mm256_add_pd(b.from(4 - i), b.from(4 + i));
    sum.low = _mm256_add_pd(sum.low, _mm256_mul_pd(by, first));
    sum.high = _mm256_add_pd(sum.high, _mm256_mul_pd(by, second));
  }
  sum.low = _mm256_mul_pd(sum.low, _mm256_setr_pd(0.5, 1, 1, 1));
  addTo(low, sum);
  if (!is_long) return;
#pragma GCC unroll 8
  for (int i = 1; i <= Degree; ++i) {
    const __m256d by = _mm256_broadcast_sd(a + i);
    more.low = _mm256_add_pd(more.low, _mm256_mul_pd(by, b.from(size - i)));
    more.high = _mm256_add_pd(more.high, _mm256_mul_pd(by, b.from(size + 4 - i)));
  }
  addTo(high, more);
}

[[gnu::target("avx2")]] void addProductAvx2(const double* a, int degree_a, double factor,
                                            const double* b, int degree_b, double* low,
                                            double* high) {
  alignas(32) double scaled[size];
  if (factor != 1) {
    const __m256d by = _mm256_set1_pd(factor);
    _mm256_store_pd(scaled, _mm256_mul_pd(by, load(a)));
    _mm256_store_pd(scaled + 4, _mm256_mul_pd(by, load(a + 4)));
    a = scaled;
  }
  const bool is_long = degree_a + degree_b >= size;
  switch (degree_a) {
    case 1:
      return addUnrolled<1>(a, b, is_long, low, high);
    case 2:
      return addUnrolled<2>(a, b, is_long, low, high);
    case 3:
      return addUnrolled<3>(a, b, is_long, low, high);
    case 4:
      return addUnrolled<4>(a, b, is_long, low, high);
    case 5:
      return addUnrolled<5>(a, b, is_long, low, high);
    case 6:
      return addUnrolled<6>(a, b, is_long, low, high);
    default:
      return addUnrolled<7>(a, b, is_long, low, high);
  }
}

/// The sum of the absolute values of eight numbers in two registers, in the order of absoluteSum().
[[gnu::target("avx2")]] inline double absoluteSumAvx2(__m256d low, __m256d high) {
  const __m256d sign = _mm256_set1_pd(-0.0);
  const __m256d sum = _mm256_add_pd(_mm256_andnot_pd(sign, low), _mm256_andnot_pd(sign, high));
  const __m128d pairs = _mm_add_pd(_mm256_castpd256_pd128(sum), _mm256_extractf128_pd(sum, 1));
  return _mm_cvtsd_f64(pairs) + _mm_cvtsd_f64(_mm_unpackhi_pd(pairs, pairs));
}

[[gnu::target("avx2")]] Sums halveAvx2(const double* low, const double* high, bool is_long,
                                       double* halved) {
  const __m256d half = _mm256_set1_pd(0.5);
  const __m256d first = _mm256_mul_pd(half, load(low));
  const __m256d second = _mm256_mul_pd(half, load(low + 4));
  _mm256_storeu_pd(halved, first);
  _mm256_storeu_pd(halved + 4, second);
  return {absoluteSumAvx2(_mm256_blend_pd(first, _mm256_setzero_pd(), 1), second),
          is_long ? absoluteSumAvx2(load(high), load(high + 4)) : 0};
}

[[gnu::target("avx2")]] void addCombinationAvx2(const double* factors, int count,
                                                const double* series, const double* off,
                                                double* sum, double* sum_off) {
  Registers more{load(sum), load(sum + 4)};
  __m128d more_off = _mm_loadu_pd(sum_off);
  const __m128d sign = _mm_set1_pd(-0.0);
  for (int i = 0; i < count; ++i) {
    const __m256d factor = _mm256_set1_pd(factors[i]);
    more.low = _mm256_add_pd(more.low, _mm256_mul_pd(factor, _mm256_loadu_pd(series + 8 * i)));
    more.high =
        _mm256_add_pd(more.high, _mm256_mul_pd(factor, _mm256_loadu_pd(series + 8 * i + 4)));
    const __m128d size_of_factor = _mm_andnot_pd(sign, _mm256_castpd256_pd128(factor));
    more_off = _mm_add_pd(more_off, _mm_mul_pd(size_of_factor, _mm_loadu_pd(off + 2 * i)));
  }
  _mm256_storeu_pd(sum, more.low);
  _mm256_storeu_pd(sum + 4, more.high);
  _mm_storeu_pd(sum_off, more_off);
}

bool hasAvx2() {
  return __builtin_cpu_supports("avx2") != 0;
}
#endif

}  // namespace

Sums halve(const double* low, const double* high, bool is_long, double* halved) {
#ifdef SEAMWRIGHT_HAS_AVX2
  if (hasAvx2()) return halveAvx2(low, high, is_long, halved);
#endif
  Eigen::Map<Terms> view(halved);
  view = 0.5 * at(low);
  return {absoluteSum(halved, 0), is_long ? absoluteSum(high, std::abs(high[0])) : 0};
}

void addProduct(const double* a, int degree_a, double factor, const double* b, int degree_b,
                double* low, double* high) {
#ifdef SEAMWRIGHT_HAS_AVX2
  if (hasAvx2()) return addProductAvx2(a, degree_a, factor, b, degree_b, low, high);
#endif
  std::array<double, 3 * size> mirrored{};
  std::reverse_copy(b, b + size, mirrored.begin());
  std::copy_n(b, size, mirrored.begin() + middle);
  mirrored[middle] *= 2;
  const double* zero = &mirrored[middle];
  Terms sum = Terms::Zero();
  for (int i = 0; i <= degree_a; ++i) sum += (factor * a[i]) * (at(zero - i) + at(zero + i));
  sum[0] *= 0.5;
  add(sum, low);
  if (degree_a + degree_b < size) return;
  sum.setZero();
  for (int i = size - degree_b; i <= degree_a; ++i) sum += (factor * a[i]) * at(zero + size - i);
  add(sum, high);
}

void addCombination(const double* factors, int count, const double* series, const double* off,
                    double* sum, double* sum_off) {
#ifdef SEAMWRIGHT_HAS_AVX2
  if (hasAvx2()) return addCombinationAvx2(factors, count, series, off, sum, sum_off);
#endif
  Terms more = at(sum);
  Eigen::Array2d more_off(sum_off[0], sum_off[1]);
  for (int i = 0; i < count; ++i) {
    more += factors[i] * at(series + i * size);
    more_off += std::abs(factors[i]) * Eigen::Map<const Eigen::Array2d>(off + 2 * i);
  }
  Eigen::Map<Terms> result(sum);
  result = more;
  sum_off[0] = more_off[0];
  sum_off[1] = more_off[1];
}

}  // namespace seamwright::terms
