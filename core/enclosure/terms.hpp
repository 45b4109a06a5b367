// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Sums of series, all terms at once. Processors that have AVX2 take four terms an instruction,
/// others two. The operations on each term are the same in both cases, in the same order and
/// rounded one by one (no fused operations), so the results are equal to the last bit.
/// Not a public header.
namespace seamwright::terms {

/// Adds twice the coefficients of factor times the product of two Chebyshev series to \p low, and
/// those of the terms above the degree of a model to \p high. Unused coefficients are zero.
///
/// T_i T_j = (T_(i + j) + T_|i - j|) / 2. With b_-k = b_k, and b_0 twice, twice the coefficient of
/// T_k in the product is the sum of a_i (b_(k - i) + b_(k + i)) over i; half of that for k = 0.
void addProduct(const double* a, int degree_a, double factor, const double* b, int degree_b,
                double* low, double* high);

/// Of the eight terms of a product.
struct Sums {
  double variation = 0;  ///< the sum of the absolute values, but for the first one
  double rest = 0;       ///< the same of the terms above, with the first one
};

/// Halves the terms of \p low, and sums up. \p high counts if the product is that long.
Sums halve(const double* low, const double* high, bool is_long, double* halved);

/// Adds the sum of factors[i] times the terms series + 8 i over i < count to \p sum, and that of
/// |factors[i]| times the two numbers off + 2 i to \p sum_off.
void addCombination(const double* factors, int count, const double* series, const double* off,
                    double* sum, double* sum_off);

}  // namespace seamwright::terms
