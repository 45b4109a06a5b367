// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <optional>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bernstein/polynomial.hpp>

/// Vector-valued polynomials in Bernstein form on [0, 1], one coefficient per row; not a public
/// header.
///
/// The numbers are plain doubles without padding. So constructed values are rounded, and a
/// judgement compares with the noise.
namespace seamwright::rows {

/// Degree + 1 coefficients of Size numbers each.
template <int Size>
using Field = Eigen::Matrix<double, Eigen::Dynamic, Size,
                            Size == 1 ? int{Eigen::ColMajor} : int{Eigen::RowMajor}>;

template <class Rows>
int degree(const Rows& rows) {
  return static_cast<int>(rows.rows()) - 1;
}

/// Length of the largest coefficient.
template <class Rows>
double size(const Rows& rows) {
  return rows.rowwise().norm().maxCoeff();
}

/// A bilinear operation on two polynomials. Coefficient k is the mean of op(a_i, b_j), i + j = k,
/// with the weights C(m,i) C(n,j) / C(m+n,k).
template <int Size, class A, class B, class Operation>
Field<Size> combined(const A& a, const B& b, const Operation& op) {
  const Eigen::Index m = a.rows() - 1, n = b.rows() - 1;
  const Eigen::VectorXd &outer = bernstein::binomials(m), &inner = bernstein::binomials(n),
                        &total = bernstein::binomials(m + n);
  Field<Size> result = Field<Size>::Zero(m + n + 1, Size);
  for (Eigen::Index i = 0; i <= m; ++i)
    for (Eigen::Index j = 0; j <= n; ++j)
      result.row(i + j) += (outer(i) * inner(j) / total(i + j)) * op(a.row(i), b.row(j));
  return result;
}

/// Factor times field. A constant factor multiplies the coefficients directly, so the factor 1
/// changes no bit.
template <int Size>
Field<Size> product(const Eigen::VectorXd& factor, const Field<Size>& field) {
  if (factor.size() == 1) return factor(0) * field;
  return combined<Size>(factor, field,
                        [](const auto& f, const auto& x) { return (f(0) * x).eval(); });
}

template <int Size>
Eigen::VectorXd dot(const Field<Size>& a, const Field<Size>& b) {
  return combined<1>(
      a, b, [](const auto& x, const auto& y) { return Eigen::Matrix<double, 1, 1>(x.dot(y)); });
}

inline Field<3> cross(const Field<3>& a, const Field<3>& b) {
  return combined<3>(a, b, [](const auto& x, const auto& y) { return x.cross(y).eval(); });
}

inline Eigen::VectorXd determinant(const Field<3>& a, const Field<3>& b, const Field<3>& c) {
  return dot<3>(cross(a, b), c);
}

/// The minors 01, 02, 03, 23, 31, 12 of two vectors of four entries.
inline Field<6> minors(const Field<4>& a, const Field<4>& b) {
  return combined<6>(a, b, [](const auto& x, const auto& y) {
    const auto minor = [&](int i, int j) { return x(i) * y(j) - x(j) * y(i); };
    Eigen::Matrix<double, 1, 6> all;
    all << minor(0, 1), minor(0, 2), minor(0, 3), minor(2, 3), minor(3, 1), minor(1, 2);
    return all;
  });
}

inline Eigen::VectorXd determinant(const Field<4>& a, const Field<4>& b, const Field<4>& c,
                                   const Field<4>& d) {
  const Field<6> first = minors(a, b);
  Field<6> second = minors(c, d);
  second.leftCols<3>().swap(second.rightCols<3>());
  return dot<6>(first, second);
}

template <int Size>
Field<Size> derivative(const Field<Size>& field) {
  const Eigen::Index n = field.rows() - 1;
  if (n == 0) return Field<Size>::Zero(1, Size);
  return static_cast<double>(n) * (field.bottomRows(n) - field.topRows(n));
}

/// The same polynomial in the degree \p to, or in its own degree if that is higher. Constant
/// columns stay constant bitwise.
template <int Size>
Field<Size> elevated(Field<Size> field, int to) {
  while (degree(field) < to) {
    const Eigen::Index n = field.rows();
    Field<Size> next(n + 1, Size);
    next.row(0) = field.row(0);
    next.row(n) = field.row(n - 1);
    for (Eigen::Index k = 1; k < n; ++k)
      next.row(k) = field.row(k) + (static_cast<double>(k) / static_cast<double>(n)) *
                                       (field.row(k - 1) - field.row(k));
    field = std::move(next);
  }
  return field;
}

template <int Size>
Field<Size> sum(const Field<Size>& a, const Field<Size>& b) {
  const int to = std::max(degree(a), degree(b));
  return elevated<Size>(a, to) + elevated<Size>(b, to);
}

/// Degree elevation as a matrix.
inline Eigen::MatrixXd elevation(int from, int to) {
  Eigen::MatrixXd matrix(to + 1, from + 1);
  for (int j = 0; j <= from; ++j)
    matrix.col(j) = elevated<1>(Eigen::VectorXd::Unit(from + 1, j), to);
  return matrix;
}

/// A polynomial of lower degree, and the largest distance of its coefficients, raised to the old
/// degree, from the given ones.
template <int Size>
struct Lowered {
  Field<Size> field;
  double defect = 0;
};

/// The nearest polynomial of degree \p to, by least squares of the coefficients. If the polynomial
/// has that degree, the result is exact up to rounding. Constant columns stay constant bitwise.
template <int Size>
Lowered<Size> lowered(const Field<Size>& field, int to) {
  if (degree(field) <= to) return {elevated<Size>(field, to), 0};
  const Eigen::MatrixXd up = elevation(to, degree(field));
  Field<Size> low = up.householderQr().solve(field);
  for (Eigen::Index c = 0; c < field.cols(); ++c)
    if ((field.col(c).array() == field(0, c)).all()) low.col(c).setConstant(field(0, c));
  const double defect = size(Field<Size>(up * low - field));
  return {std::move(low), defect};
}

/// The function, reduced to degree 0 if all its coefficients are the same.
inline Eigen::VectorXd trimmed(const Eigen::VectorXd& function) {
  if ((function.array() == function(0)).all()) return function.head(1);
  return function;
}

inline bool isZero(const Eigen::VectorXd& function) {
  return (function.array() == 0).all();
}

/// A parameter at which the polynomial is not positive, or is too near to zero to tell; nothing if
/// it is positive on the whole of [0, 1].
inline std::optional<double> notPositiveAt(const BernsteinPolynomial& p, double begin = 0,
                                           double end = 1) {
  const double at_begin = p.coefficients()(0), at_end = p.coefficients()(p.degree());
  if (at_begin <= p.padding()) return begin;
  if (at_end <= p.padding()) return end;
  if (p.range().lower > 0) return std::nullopt;
  const double middle = (begin + end) / 2;
  // A bound of the recursion: so near a zero the sign is a matter of rounding.
  if (end - begin < 0x1p-40) return middle;
  const auto [left, right] = p.split(0.5);
  if (const auto at = notPositiveAt(left, begin, middle)) return at;
  return notPositiveAt(right, middle, end);
}

/// A sum of terms factor times field. Terms that vanish are skipped and do not raise the degree.
template <int Size>
class Sum {
 public:
  Sum& add(const Eigen::VectorXd& factor, const Field<Size>& field) {
    if (isZero(factor) || field.isZero(0)) return *this;
    const Field<Size> term = product<Size>(factor, field);
    total_ = empty_ ? term : sum<Size>(total_, term);
    empty_ = false;
    return *this;
  }
  const Field<Size>& total() const { return total_; }

 private:
  Field<Size> total_ = Field<Size>::Zero(1, Size);
  bool empty_ = true;
};

inline Eigen::VectorXd times(const Eigen::VectorXd& f, const Eigen::VectorXd& g) {
  return product<1>(f, g);
}

}  // namespace seamwright::rows
