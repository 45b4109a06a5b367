// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <seamwright/core/enclosure/chebyshev_model.hpp>
#include <seamwright/core/enclosure/terms.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

constexpr int model_size = ChebyshevModel::size;

/// All terms of a series: one operation for each packet of them costs less than a loop over those
/// up to the degree. Terms above the degree are zero.
using Terms = Eigen::Array<double, model_size, 1>;
using TermsView = Eigen::Map<Terms>;
using ConstTermsView = Eigen::Map<const Terms>;

TermsView view(ChebyshevModel::Coefficients& coefficients) {
  return TermsView(coefficients.data());
}

ConstTermsView view(const ChebyshevModel::Coefficients& coefficients) {
  return ConstTermsView(coefficients.data());
}

/// Makes a bound safe against rounding, where a few dozen operations computed it from non-negative
/// numbers.
double up(double bound) {
  return bound * (1 + 16 * machine_epsilon) + std::numeric_limits<double>::min();
}

/// The matrix times a column of terms is a sum of rows here: the first index is the column.
using Matrix = std::array<ChebyshevModel::Coefficients, model_size>;

Terms product(const Matrix& matrix, const Terms& terms, int count) {
  Terms sum = terms[0] * view(matrix[0]);
  for (int k = 1; k < count; ++k) sum += terms[k] * view(matrix[k]);
  return sum;
}

double binomial(int n, int k) {
  double value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

/// Column k holds the Bernstein coefficients of T_k, elevated to the degree. In degree k the
/// coefficients of T_k are (-1)^(k - j) C(2 k, 2 j) / C(k, j).
Matrix chebyshevToBernstein(int degree) {
  Matrix matrix{};
  for (int k = 0; k <= degree; ++k)
    for (int i = 0; i <= degree; ++i)
      for (int j = std::max(0, i - (degree - k)); j <= std::min(i, k); ++j) {
        const double own = ((k - j) % 2 == 0 ? 1 : -1) * binomial(2 * k, 2 * j) / binomial(k, j);
        matrix[k][i] += own * binomial(k, j) * binomial(degree - k, i - j) / binomial(degree, i);
      }
  return matrix;
}

std::array<Matrix, model_size> bernsteinTables() {
  std::array<Matrix, model_size> tables{};
  for (int degree = 0; degree < model_size; ++degree) tables[degree] = chebyshevToBernstein(degree);
  return tables;
}

/// T_k at the i-th of model_size Chebyshev points.
double chebyshevAtPoint(int k, int i) {
  return std::cos(k * std::numbers::pi * (2 * i + 1) / (2 * model_size));
}

/// The matrix that takes a series to its values at the Chebyshev points.
Matrix seriesToValues() {
  Matrix matrix{};
  for (int k = 0; k < model_size; ++k)
    for (int i = 0; i < model_size; ++i) matrix[k][i] = chebyshevAtPoint(k, i);
  return matrix;
}

/// Its inverse.
Matrix valuesToSeries() {
  Matrix matrix{};
  for (int i = 0; i < model_size; ++i)
    for (int k = 0; k < model_size; ++k)
      matrix[i][k] = (k == 0 ? 1.0 : 2.0) / model_size * chebyshevAtPoint(k, i);
  return matrix;
}

const std::array<Matrix, model_size> to_bernstein = bernsteinTables();
const Matrix series_to_values = seriesToValues();
const Matrix values_to_series = valuesToSeries();

/// The series that takes the values function(f) at the Chebyshev points. It is only a guess for
/// function(f): the caller bounds its error.
template <class Function>
ChebyshevModel interpolate(const ChebyshevModel& f, const Function& function) {
  if (f.degree() == 0) return ChebyshevModel(function(f.coefficient(0)));
  Terms values = product(series_to_values, view(f.coefficients()), f.degree() + 1);
  for (double& value : values) value = function(value);
  ChebyshevModel::Coefficients series;
  view(series) = product(values_to_series, values, model_size);
  return ChebyshevModel::series(series, 0);
}

}  // namespace

ChebyshevModel ChebyshevModel::linear(double middle, double half, double radius) {
  ChebyshevModel model(middle);
  model.coefficients_[1] = half;
  model.variation_ = std::abs(half);
  model.degree_ = half == 0 ? 0 : 1;
  model.radius_ = radius;
  return model;
}

ChebyshevModel ChebyshevModel::series(std::span<const double> coefficients, double radius) {
  ChebyshevModel model;
  const std::size_t kept = std::min<std::size_t>(coefficients.size(), model_size);
  std::copy_n(coefficients.begin(), kept, model.coefficients_.begin());
  double rest = 0;
  for (const double coefficient : coefficients.subspan(kept)) rest += std::abs(coefficient);
  model.radius_ = rest != 0 ? up(radius + rest) : radius;
  model.degree_ = static_cast<int>(std::max<std::size_t>(kept, 1)) - 1;
  model.sumUp();
  model.trim();
  return model;
}

ChebyshevModel ChebyshevModel::unknown() {
  ChebyshevModel model;
  model.radius_ = infinite;
  return model;
}

bool ChebyshevModel::isKnown() const {
  return std::isfinite(magnitude());
}

void ChebyshevModel::sumUp() {
  // The first of the terms by itself: packets that begin elsewhere than those stored before wait.
  variation_ = degree_ == 0 ? 0
                            : std::abs(coefficients_[1]) +
                                  view(coefficients_).tail<max_degree - 1>().abs().sum();
}

/// Expects the variation of the coefficients as they are.
void ChebyshevModel::trim() {
  const double least = negligible * variation_;
  double rest = 0;
  while (degree_ > 0 && rest + std::abs(coefficients_[degree_]) <= least) {
    rest += std::abs(coefficients_[degree_]);
    coefficients_[degree_--] = 0;
  }
  if (rest > 0) radius_ = up(radius_ + rest);
}

double ChebyshevModel::seriesAt(double x) const {
  const Coefficients& c = coefficients_;
  if (x == 0) return (c[0] - c[2]) + (c[4] - c[6]);
  if (x == 1 || x == -1)
    return ((c[0] + c[2]) + (c[4] + c[6])) + x * ((c[1] + c[3]) + (c[5] + c[7]));
  double next = 0, after = 0;
  for (int k = degree_; k > 0; --k) {
    const double here = coefficients_[k] + 2 * x * next - after;
    after = next;
    next = here;
  }
  return coefficients_[0] + x * next - after;
}

double ChebyshevModel::magnitude() const {
  return up(radius_ + absoluteSum());
}

Interval ChebyshevModel::range() const {
  if (degree_ == 0)
    return {coefficients_[0] - up(radius_ + machine_epsilon * std::abs(coefficients_[0])),
            coefficients_[0] + up(radius_ + machine_epsilon * std::abs(coefficients_[0]))};
  const Coefficients control = bernstein(degree_);
  const auto [low, high] = std::minmax_element(control.begin(), control.begin() + degree_ + 1);
  const double margin = up(radius_ + bernsteinRounding() +
                           machine_epsilon * std::max(std::abs(*low), std::abs(*high)));
  return {*low - margin, *high + margin};
}

ChebyshevModel::Coefficients ChebyshevModel::bernstein(int degree) const {
  Coefficients control;
  view(control) = product(to_bernstein[degree], view(coefficients_), degree_ + 1);
  return control;
}

double ChebyshevModel::bernsteinRounding() const {
  // The Bernstein coefficients of T_k are at most C(2 k, k') / C(k, k') < 2^k in absolute value,
  // and each is rounded a few times.
  constexpr Coefficients bounds = {1, 2, 4, 8, 16, 32, 64, 128};
  return 16 * machine_epsilon * (view(bounds) * view(coefficients_).abs()).sum();
}

ChebyshevModel& ChebyshevModel::operator+=(const ChebyshevModel& other) {
  view(coefficients_) += view(other.coefficients_);
  return summed(other);
}

ChebyshevModel& ChebyshevModel::operator-=(const ChebyshevModel& other) {
  view(coefficients_) -= view(other.coefficients_);
  return summed(other);
}

/// The radius and the degree of the sum, or of the difference, whose coefficients are there.
ChebyshevModel& ChebyshevModel::summed(const ChebyshevModel& other) {
  degree_ = std::max(degree_, other.degree_);
  sumUp();
  radius_ = up(radius_ + other.radius_ + machine_epsilon * absoluteSum());
  trim();
  return *this;
}

ChebyshevModel combination(const std::array<double, 3>& factors,
                           const std::array<const ChebyshevModel*, 3>& models) {
  ChebyshevModel sum;
  double absolute = 0;
  for (int i = 0; i < 3; ++i) {
    const ChebyshevModel& model = *models[i];
    const double factor = factors[i];
    if (factor == 0 && model.isKnown()) continue;
    const Terms terms = factor * view(model.coefficients_);
    view(sum.coefficients_) += terms;
    absolute += terms.abs().sum();
    sum.degree_ = std::max(sum.degree_, model.degree_);
    sum.radius_ += std::abs(factor) * model.radius_;
  }
  sum.radius_ = up(sum.radius_ + 2 * machine_epsilon * absolute);
  sum.sumUp();
  sum.trim();
  return sum;
}

ChebyshevModel& ChebyshevModel::operator*=(double factor) {
  if (factor == 1) return *this;
  view(coefficients_) *= factor;
  sumUp();
  radius_ = up(std::abs(factor) * radius_ + machine_epsilon * absoluteSum());
  trim();
  return *this;
}

ChebyshevModel ChebyshevModel::operator-() const {
  ChebyshevModel negative = *this;
  view(negative.coefficients_) = -view(coefficients_);
  return negative;
}

void ChebyshevModel::widen(double radius) {
  radius_ = up(radius_ + radius);
}

ProductSum& ProductSum::add(const ChebyshevModel& a, const ChebyshevModel& b, double factor) {
  if ((a.isZero() && b.isKnown()) || (b.isZero() && a.isKnown())) return *this;
  const bool in_order = a.degree_ <= b.degree_;
  const ChebyshevModel& outer = in_order ? a : b;
  const ChebyshevModel& inner = in_order ? b : a;
  const double absolute_outer = std::abs(factor) * outer.absoluteSum();
  const double absolute_inner = inner.absoluteSum();
  if (outer.degree_ == 0)
    view(low_) += 2 * factor * outer.coefficients_[0] * view(inner.coefficients_);
  else
    terms::addProduct(outer.coefficients_.data(), outer.degree_, factor, inner.coefficients_.data(),
                      inner.degree_, low_.data(), high_.data());
  degree_ = std::max(degree_, outer.degree_ + inner.degree_);
  // A term of the product has the roundings of the factor times a_i, of the sum of two b_k, of
  // their product and of the sum over i; then all terms have one more.
  const double absolute = absolute_outer * absolute_inner;
  absolute_ += absolute;
  roundings_ += (outer.degree_ + 3) * absolute + absolute_;
  if (a.radius_ != 0 || b.radius_ != 0)  // also true for NaN, which unknown times zero may give
    radius_ += absolute_outer * inner.radius_ +
               (absolute_inner + inner.radius_) * (std::abs(factor) * outer.radius_);
  return *this;
}

ChebyshevModel ProductSum::model() const {
  ChebyshevModel result;
  const bool is_long = degree_ > ChebyshevModel::max_degree;
  const auto [variation, rest] =
      terms::halve(low_.data(), high_.data(), is_long, result.coefficients_.data());
  result.degree_ = is_long ? ChebyshevModel::max_degree : degree_;
  result.radius_ = up(radius_ + 0.5 * rest + 0.5 * machine_epsilon * roundings_);
  result.variation_ = variation;
  if (result.degree_ > 0) result.trim();
  return result;
}

ChebyshevModel operator*(const ChebyshevModel& a, const ChebyshevModel& b) {
  return ProductSum().add(a, b).model();
}

ChebyshevModel inverse(const ChebyshevModel& f) {
  const Interval range = f.range();
  const double smallest = std::max(range.lower, -range.upper);
  if (!(smallest > 0) || !std::isfinite(range.width())) return ChebyshevModel::unknown();
  ChebyshevModel guess = interpolate(f, [](double value) { return 1 / value; });
  const ChebyshevModel residual =
      ChebyshevModel(1) - f * guess;  // |1/f - guess| = |residual| / |f|
  guess.widen(up(residual.magnitude() / smallest));
  return guess;
}

ChebyshevModel inverseSqrt(const ChebyshevModel& f) {
  const Interval range = f.range();
  if (!(range.lower > 0) || !std::isfinite(range.width())) return ChebyshevModel::unknown();
  ChebyshevModel guess = interpolate(f, [](double value) { return 1 / std::sqrt(value); });
  // With e = f guess^2 - 1, |guess - f^(-1/2)| = f^(-1/2) |sqrt(1 + e) - 1| <= f^(-1/2) |e| for |e|
  // <= 1.
  const double e = (f * guess * guess - ChebyshevModel(1)).magnitude();
  if (!(e <= 1)) return ChebyshevModel::unknown();
  guess.widen(up(e / std::sqrt(range.lower)));
  return guess;
}

namespace {

/// Cosine and sine of f (sign -1), or hyperbolic cosine and sine (sign 1), from both values at the
/// middle of f. The addition theorems differ only in the sign.
std::pair<ChebyshevModel, ChebyshevModel> aroundMiddle(const ChebyshevModel& f, double sign,
                                                       double cosine_there, double sine_there) {
  const ChebyshevModel offset = f - ChebyshevModel(f.coefficient(0));
  const double reach = offset.magnitude();
  if (!(reach <= 2)) return {ChebyshevModel::unknown(), ChebyshevModel::unknown()};
  ChebyshevModel cos_middle(cosine_there), sin_middle(sine_there);
  cos_middle.widen(machine_epsilon * std::abs(cosine_there));
  sin_middle.widen(machine_epsilon * std::abs(sine_there));
  if (offset.degree() == 0) {
    const double change =
        4 * reach * (std::abs(cosine_there) + std::abs(sine_there));  // reach cosh(reach) < 4 reach
    cos_middle.widen(change);
    sin_middle.widen(change);
    return {cos_middle, sin_middle};
  }
  // The Taylor series in offset ends when the next term is below rounding. Lagrange's remainder is
  // at most that term times cosh(2) < 4.
  int terms = 1;
  double next = reach * reach / 2;
  while (next > 0x1p-44 && terms < 16) {
    next *= reach * reach / ((2 * terms + 1) * (2 * terms + 2));
    ++terms;
  }
  const ChebyshevModel square = offset * offset;
  ChebyshevModel cosine(1), sine(1);
  for (int k = terms - 1; k > 0; --k) {
    cosine = ChebyshevModel(1) + cosine * square * (sign / ((2 * k - 1) * (2 * k)));
    sine = ChebyshevModel(1) + sine * square * (sign / ((2 * k) * (2 * k + 1)));
  }
  sine = sine * offset;
  cosine.widen(up(4 * next));
  sine.widen(up(4 * next * std::max(reach, 1.0)));
  return {ProductSum().add(cos_middle, cosine).add(sin_middle, sine, sign).model(),
          ProductSum().add(sin_middle, cosine).add(cos_middle, sine).model()};
}

}  // namespace

std::pair<ChebyshevModel, ChebyshevModel> cosSin(const ChebyshevModel& f) {
  return aroundMiddle(f, -1, std::cos(f.coefficient(0)), std::sin(f.coefficient(0)));
}

std::pair<ChebyshevModel, ChebyshevModel> coshSinh(const ChebyshevModel& f) {
  return aroundMiddle(f, 1, std::cosh(f.coefficient(0)), std::sinh(f.coefficient(0)));
}

}  // namespace seamwright
