// SPDX-License-Identifier: LGPL-2.1-or-later
#include <queue>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bernstein/polynomial.hpp>

namespace seamwright {

namespace {

struct Piece {
  BernsteinPolynomial p;
  double lower;  ///< lower end of its range

  explicit Piece(BernsteinPolynomial polynomial)
      : p(std::move(polynomial)), lower(p.range().lower) {}
  bool operator<(const Piece& other) const {
    return lower > other.lower;
  }  // the queue has the lowest piece on top
  double lowerEnd() const { return std::min(p.coefficients()(0), p.coefficients()(p.degree())); }
  /// Whether the hull is below the lower end by no more than the padding: a split would then not
  /// certainly raise it.
  bool exhausted() const { return lowerEnd() - p.coefficients().minCoeff() <= p.padding(); }
};

/// A lower bound of p, below the minimum by at most tolerance as far as the padding allows.
double lowerBound(const BernsteinPolynomial& p, double tolerance) {
  std::priority_queue<Piece> pieces;
  pieces.emplace(p);
  double attained = std::numeric_limits<double>::infinity();  // the minimum is not above this
  while (true) {
    const Piece lowest = pieces.top();
    const double end = lowest.lowerEnd();
    attained = std::min(attained, rounding::widened({end, end}, lowest.p.padding()).upper);
    if (attained - lowest.lower <= tolerance || lowest.exhausted()) return lowest.lower;
    pieces.pop();
    const auto [left, right] = lowest.p.split(0.5);
    pieces.emplace(left);
    pieces.emplace(right);
  }
}

}  // namespace

BernsteinPolynomial::BernsteinPolynomial(Eigen::VectorXd coefficients, double padding)
    : coefficients_(std::move(coefficients)), padding_(padding) {
  bernstein::requireUsable(coefficients_, padding_);
}

Interval BernsteinPolynomial::evaluate(double t) const {
  bernstein::requireUnit(t);
  const bernstein::Step step = bernstein::Step::at(t);
  const double value = bernstein::collapsed(coefficients_, step)(0);
  const double companion = bernstein::collapsed<Eigen::VectorXd>(coefficients_.cwiseAbs(), step)(0);
  return bernstein::enclosure(value, companion, padding_, step.roundings * degree(), degree());
}

BernsteinPolynomial BernsteinPolynomial::derivative() const {
  return bernstein::derivative(*this);
}

BernsteinPolynomial BernsteinPolynomial::elevated(int by) const {
  if (by < 0)
    throw std::invalid_argument("elevation by " + std::to_string(by) + ": it must not be negative");
  return by == 0 ? *this : *this * BernsteinPolynomial(Eigen::VectorXd::Ones(by + 1));
}

std::pair<BernsteinPolynomial, BernsteinPolynomial> BernsteinPolynomial::split(double t) const {
  return bernstein::split(*this, t);
}

BernsteinPolynomial BernsteinPolynomial::restricted(const Interval& domain) const {
  return bernstein::restricted(*this, domain);
}

Interval BernsteinPolynomial::range() const {
  return bernstein::range(*this);
}

Interval BernsteinPolynomial::range(double tolerance) const {
  if (!(tolerance >= 0))
    throw std::invalid_argument("tolerance is " + bernstein::text(tolerance) +
                                ": it must be 0 or positive");
  return {lowerBound(*this, tolerance / 2), -lowerBound(-*this, tolerance / 2)};
}

BernsteinPolynomial BernsteinPolynomial::operator-() const {
  return BernsteinPolynomial(-coefficients_, padding_);
}

bool BernsteinPolynomial::operator==(const BernsteinPolynomial& other) const {
  return degree() == other.degree() && coefficients_ == other.coefficients_ &&
         padding_ == other.padding_;
}

BernsteinPolynomial operator+(const BernsteinPolynomial& p, const BernsteinPolynomial& q) {
  const int degree = std::max(p.degree(), q.degree());
  return bernstein::sum(p.elevated(degree - p.degree()), q.elevated(degree - q.degree()));
}

BernsteinPolynomial operator-(const BernsteinPolynomial& p, const BernsteinPolynomial& q) {
  return p + -q;
}

BernsteinPolynomial operator*(const BernsteinPolynomial& p, const BernsteinPolynomial& q) {
  return bernstein::product(p, q);
}

BernsteinPolynomial operator*(double factor, const BernsteinPolynomial& p) {
  return bernstein::scaled(factor, p);
}

}  // namespace seamwright
