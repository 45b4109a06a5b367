// SPDX-License-Identifier: LGPL-2.1-or-later
#include <vector>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bernstein/tensor.hpp>

namespace seamwright {

namespace {

std::pair<BernsteinTensor, BernsteinTensor> transposed(
    const std::pair<BernsteinTensor, BernsteinTensor>& pieces) {
  return {pieces.first.transposed(), pieces.second.transposed()};
}

/// One step of de Casteljau with a polynomial as parameter: (1 - w) a + w b, for a and b of equal
/// degree.
///
/// The effect of the paddings of a and b on a coefficient is a convex combination of |1 - w_i| e_a
/// + |w_i| e_b, and
/// |1 - w_i| + |w_i| = 1 + 2 (distance of w_i from [0, 1]). The padding of w enters times b - a.
BernsteinPolynomial blend(const BernsteinPolynomial& w, const BernsteinPolynomial& a,
                          const BernsteinPolynomial& b) {
  using rounding::kUnit, rounding::productUp, rounding::sumUp, rounding::up;
  const Eigen::VectorXd complement = 1 - w.coefficients().array();
  const auto kept = bernstein::product(complement, 0, a.coefficients(), 0);
  const auto taken = bernstein::product(w.coefficients(), 0, b.coefficients(), 0);
  Eigen::VectorXd values = kept.values + taken.values;

  const double outside =
      std::max({0.0, -w.coefficients().minCoeff(), up(w.coefficients().maxCoeff() - 1)});
  const double spread = sumUp(1, 2 * outside, 2 * w.padding());
  const double difference =
      up(bernstein::largest(Eigen::VectorXd(b.coefficients() - a.coefficients())));
  const double inherited = sumUp(productUp(std::max(a.padding(), b.padding()), spread),
                                 productUp(w.padding(), difference));
  const double complement_error = productUp(
      kUnit, productUp(bernstein::largest(complement), bernstein::largest(a.coefficients())));
  const double sum_error = productUp(kUnit, bernstein::largest(values));
  return bernstein::result<BernsteinPolynomial>(
      std::move(values), sumUp(inherited, kept.error, taken.error, complement_error, sum_error),
      "composition");
}

/// The value at w of the Bernstein form whose coefficients are polynomials of equal degree.
BernsteinPolynomial collapsed(std::vector<BernsteinPolynomial> coefficients,
                              const BernsteinPolynomial& w) {
  while (coefficients.size() > 1) {
    for (std::size_t i = 0; i + 1 < coefficients.size(); ++i)
      coefficients[i] = blend(w, coefficients[i], coefficients[i + 1]);
    coefficients.pop_back();
  }
  return coefficients.front();
}

}  // namespace

BernsteinTensor::BernsteinTensor(Eigen::MatrixXd coefficients, double padding)
    : coefficients_(std::move(coefficients)), padding_(padding) {
  bernstein::requireUsable(coefficients_, padding_);
}

Interval BernsteinTensor::evaluate(double u, double v) const {
  bernstein::requireUnit(u);
  bernstein::requireUnit(v);
  const bernstein::Step step_u = bernstein::Step::at(u), step_v = bernstein::Step::at(v);
  const auto at = [&](const Eigen::MatrixXd& c) {
    return bernstein::collapsed(bernstein::collapsed(c, step_u), step_v)(0);
  };
  return bernstein::enclosure(at(coefficients_), at(coefficients_.cwiseAbs()), padding_,
                              step_u.roundings * degreeU() + step_v.roundings * degreeV(),
                              degreeU() + degreeV());
}

BernsteinTensor BernsteinTensor::partialU() const {
  return bernstein::derivative(*this);
}

BernsteinTensor BernsteinTensor::partialV() const {
  return bernstein::derivative(transposed()).transposed();
}

BernsteinTensor BernsteinTensor::elevated(int by_u, int by_v) const {
  if (by_u < 0 || by_v < 0)
    throw std::invalid_argument("elevation by " + std::to_string(by_u) + ", " +
                                std::to_string(by_v) + ": it must not be negative");
  return by_u == 0 && by_v == 0
             ? *this
             : *this * BernsteinTensor(Eigen::MatrixXd::Ones(by_u + 1, by_v + 1));
}

std::pair<BernsteinTensor, BernsteinTensor> BernsteinTensor::splitU(double t) const {
  return bernstein::split(*this, t);
}

std::pair<BernsteinTensor, BernsteinTensor> BernsteinTensor::splitV(double t) const {
  return seamwright::transposed(bernstein::split(transposed(), t));
}

BernsteinTensor BernsteinTensor::restricted(const Interval& u, const Interval& v) const {
  return bernstein::restricted(bernstein::restricted(*this, u).transposed(), v).transposed();
}

BernsteinPolynomial BernsteinTensor::edge(Edge edge) const {
  switch (edge) {
    case Edge::U0:
      return BernsteinPolynomial(coefficients_.row(0).transpose(), padding_);
    case Edge::U1:
      return BernsteinPolynomial(coefficients_.row(degreeU()).transpose(), padding_);
    case Edge::V0:
      return BernsteinPolynomial(coefficients_.col(0), padding_);
    case Edge::V1:
      break;
  }
  return BernsteinPolynomial(coefficients_.col(degreeV()), padding_);
}

BernsteinTensor BernsteinTensor::transposed() const {
  return BernsteinTensor(coefficients_.transpose(), padding_);
}

Interval BernsteinTensor::range() const {
  return bernstein::range(*this);
}

BernsteinPolynomial BernsteinTensor::composed(const BernsteinPolynomial& u,
                                              const BernsteinPolynomial& v) const {
  std::vector<BernsteinPolynomial> along_v;
  for (int j = 0; j <= degreeV(); ++j) {
    std::vector<BernsteinPolynomial> column;
    for (int i = 0; i <= degreeU(); ++i)
      column.emplace_back(Eigen::VectorXd::Constant(1, coefficients_(i, j)), padding_);
    along_v.push_back(collapsed(std::move(column), u));
  }
  return collapsed(std::move(along_v), v);
}

BernsteinTensor BernsteinTensor::operator-() const {
  return BernsteinTensor(-coefficients_, padding_);
}

bool BernsteinTensor::operator==(const BernsteinTensor& other) const {
  return degreeU() == other.degreeU() && degreeV() == other.degreeV() &&
         coefficients_ == other.coefficients_ && padding_ == other.padding_;
}

BernsteinTensor operator+(const BernsteinTensor& f, const BernsteinTensor& g) {
  const int m = std::max(f.degreeU(), g.degreeU()), n = std::max(f.degreeV(), g.degreeV());
  return bernstein::sum(f.elevated(m - f.degreeU(), n - f.degreeV()),
                        g.elevated(m - g.degreeU(), n - g.degreeV()));
}

BernsteinTensor operator-(const BernsteinTensor& f, const BernsteinTensor& g) {
  return f + -g;
}

BernsteinTensor operator*(const BernsteinTensor& f, const BernsteinTensor& g) {
  return bernstein::product(f, g);
}

BernsteinTensor operator*(double factor, const BernsteinTensor& f) {
  return bernstein::scaled(factor, f);
}

}  // namespace seamwright
