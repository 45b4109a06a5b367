// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

/// Exact arithmetic on the numbers m 2^e, among them all doubles: an oracle without rounding.
namespace seamwright::test {

class Dyadic {
 public:
  Dyadic(double value = 0) {  // NOLINT(google-explicit-constructor): a double is a dyadic number
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    negative_ = mantissa < 0;
    exponent_ = exponent - 53;
    for (auto rest = static_cast<std::uint64_t>(std::abs(mantissa)); rest != 0; rest >>= 32)
      limbs_.push_back(static_cast<std::uint32_t>(rest));
    normalise();
  }

  int sign() const { return limbs_.empty() ? 0 : negative_ ? -1 : 1; }

  Dyadic operator-() const {
    Dyadic result = *this;
    result.negative_ = !negative_;
    return result;
  }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic result;
    result.negative_ = a.negative_ != b.negative_;
    result.exponent_ = a.exponent_ + b.exponent_;
    result.limbs_.assign(a.limbs_.size() + b.limbs_.size(), 0);
    for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
      std::uint64_t carry = 0;
      for (std::size_t j = 0; j < b.limbs_.size(); ++j) {
        carry += result.limbs_[i + j] + std::uint64_t{a.limbs_[i]} * b.limbs_[j];
        result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      result.limbs_[i + b.limbs_.size()] = static_cast<std::uint32_t>(carry);
    }
    result.normalise();
    return result;
  }

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.limbs_.empty()) return b;
    if (b.limbs_.empty()) return a;
    const int exponent = std::min(a.exponent_, b.exponent_);
    const Limbs x = a.shifted(exponent), y = b.shifted(exponent);
    Dyadic result;
    result.exponent_ = exponent;
    if (a.negative_ == b.negative_) {
      result.negative_ = a.negative_;
      result.limbs_ = sum(x, y);
    } else {
      const bool swap = less(x, y);
      result.negative_ = swap ? b.negative_ : a.negative_;
      result.limbs_ = swap ? difference(y, x) : difference(x, y);
    }
    result.normalise();
    return result;
  }

  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
  friend bool operator<=(const Dyadic& a, const Dyadic& b) { return (a - b).sign() <= 0; }
  friend bool operator==(const Dyadic& a, const Dyadic& b) { return (a - b).sign() == 0; }
  Dyadic abs() const { return negative_ ? -*this : *this; }

  /// Truncated to about 64 bits: for ratios and messages.
  long double approximate() const {
    long double result = 0;
    for (std::size_t i = limbs_.size(); i-- > 0;)
      result +=
          std::ldexp(static_cast<long double>(limbs_[i]), exponent_ + 32 * static_cast<int>(i));
    return negative_ ? -result : result;
  }

 private:
  using Limbs = std::vector<std::uint32_t>;

  void normalise() {
    while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
    std::size_t zeros = 0;
    while (zeros < limbs_.size() && limbs_[zeros] == 0) ++zeros;
    limbs_.erase(limbs_.begin(), limbs_.begin() + static_cast<std::ptrdiff_t>(zeros));
    exponent_ += 32 * static_cast<int>(zeros);
  }

  Limbs shifted(int exponent) const {
    const auto shift = static_cast<unsigned>(exponent_ - exponent);
    Limbs result(shift / 32, 0);
    std::uint64_t carry = 0;
    for (const std::uint32_t limb : limbs_) {
      carry |= std::uint64_t{limb} << (shift % 32);
      result.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    result.push_back(static_cast<std::uint32_t>(carry));
    return result;
  }

  static bool less(const Limbs& x, const Limbs& y) {
    for (std::size_t i = std::max(x.size(), y.size()); i-- > 0;) {
      const std::uint32_t a = i < x.size() ? x[i] : 0, b = i < y.size() ? y[i] : 0;
      if (a != b) return a < b;
    }
    return false;
  }

  static Limbs sum(const Limbs& x, const Limbs& y) {
    Limbs result;
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < std::max(x.size(), y.size()) + 1; ++i) {
      carry += (i < x.size() ? x[i] : std::uint64_t{0}) + (i < y.size() ? y[i] : 0);
      result.push_back(static_cast<std::uint32_t>(carry));
      carry >>= 32;
    }
    return result;
  }

  /// \pre x >= y.
  static Limbs difference(const Limbs& x, const Limbs& y) {
    Limbs result;
    std::int64_t borrow = 0;
    for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i) {
      borrow += (i < x.size() ? std::int64_t{x[i]} : 0) - (i < y.size() ? std::int64_t{y[i]} : 0);
      result.push_back(static_cast<std::uint32_t>(borrow));
      borrow >>= 32;
    }
    return result;
  }

  Limbs limbs_;  ///< least significant first
  int exponent_ = 0;
  bool negative_ = false;
};

using DyadicVector = std::vector<Dyadic>;

inline DyadicVector exact(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

/// C(n, 0..n) by Pascal's triangle.
inline DyadicVector exactBinomials(int n) {
  DyadicVector row(1, 1.0);
  for (int i = 1; i <= n; ++i) {
    row.emplace_back(1.0);
    for (int j = i - 1; j > 0; --j) row[j] = row[j - 1] + row[j];
  }
  return row;
}

/// sum_i C(n, i) c_i t^i (1 - t)^(n - i): the definition.
inline Dyadic exactBernstein(const DyadicVector& c, const Dyadic& t) {
  const int n = static_cast<int>(c.size()) - 1;
  const DyadicVector binomials = exactBinomials(n);
  DyadicVector powers_of_s(1, 1.0);
  for (int i = 0; i < n; ++i) powers_of_s.push_back(powers_of_s.back() * (Dyadic(1) - t));
  Dyadic value = 0, power_of_t = 1;
  for (int i = 0; i <= n; ++i, power_of_t = power_of_t * t)
    value = value + binomials[i] * c[i] * power_of_t * powers_of_s[n - i];
  return value;
}

/// C(m + n, k) times the coefficient k of a product: sum_i C(m, i) a_i C(n, k - i) b_(k - i).
inline DyadicVector exactProductTimesBinomials(const DyadicVector& a, const DyadicVector& b) {
  const DyadicVector wa = exactBinomials(static_cast<int>(a.size()) - 1),
                     wb = exactBinomials(static_cast<int>(b.size()) - 1);
  DyadicVector result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      result[i + j] = result[i + j] + wa[i] * a[i] * (wb[j] * b[j]);
  return result;
}

/// Coefficients over [a, b]: coefficient j is the blossom of n - j arguments a and j arguments b.
inline DyadicVector exactRestriction(const DyadicVector& c, const Dyadic& a, const Dyadic& b) {
  DyadicVector result;
  for (std::size_t j = 0; j < c.size(); ++j) {
    DyadicVector work = c;
    for (std::size_t step = 0; work.size() > 1; ++step) {
      const Dyadic& t = step < j ? b : a;
      for (std::size_t i = 0; i + 1 < work.size(); ++i)
        work[i] = work[i] + t * (work[i + 1] - work[i]);
      work.pop_back();
    }
    result.push_back(work.front());
  }
  return result;
}

}  // namespace seamwright::test
