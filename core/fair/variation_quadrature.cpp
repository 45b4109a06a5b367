// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/fair/span_maps.hpp>
#include <seamwright/core/fair/variation_quadrature.hpp>
#include <seamwright/core/linear/gauss_rule.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright {

namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// The variation by both rules, and what the fine one makes of the parts whose difference the
/// density is, to know the rounding in it.
struct RulePair {
  double coarse = 0, fine = 0, parts = 0;

  void add(int node, double weight, const Vector3d& first, const Vector3d& second,
           const Vector3d& third) {
    const double s = first.squaredNorm(), share = 3 * first.dot(second) / s;
    const Vector3d change = third - share * second;
    const Vector3d across = change - first.dot(change) / s * first;
    const double factor = weight / (s * s * std::sqrt(s));
    if (node < VariationQuadrature::coarse_nodes) {
      coarse += factor * across.squaredNorm();
      return;
    }
    fine += factor * across.squaredNorm();
    parts += factor * (third.squaredNorm() + share * share * second.squaredNorm());
  }

  bool agree() const {
    // A vector of the density has rounding of a few eps of its parts, 2^-42 with room: squared.
    constexpr double rounding = 0x1p-84;
    return std::abs(fine - coarse) <= variation_accuracy * fine + rounding * parts;
  }
};

/// Whether all vectors are within half of the length of their mean from it. Then their weighted
/// means have between half and three halves of its length.
bool nearTheirMean(const Matrix3Xd& vectors) {
  if (vectors.cols() == 0) return false;
  const Vector3d mean = vectors.rowwise().mean();
  const double reach = mean.squaredNorm() / 4;
  if (!(reach > 0)) return false;
  for (Index i = 0; i < vectors.cols(); ++i)
    if (!((vectors.col(i) - mean).squaredNorm() <= reach)) return false;
  return true;
}

/// Whether vectors have one direction, or the opposite one, up to rounding, and are not all 0.
bool parallel(const Matrix3Xd& vectors) {
  if (vectors.cols() == 0) return false;
  Index longest = 0;
  const double square = vectors.colwise().squaredNorm().maxCoeff(&longest);
  // Differences of poles have rounding of eps of the poles; 2^-48 has room for poles at a distance
  // of a few lengths of the segment.
  return square > 0 && vectors.colwise().cross(vectors.col(longest)).colwise().norm().maxCoeff() <=
                           0x1p-48 * square;
}

Matrix3Xd differences(const Matrix3Xd& vectors) {
  const Index count = vectors.cols() - 1;
  if (count < 1) return Matrix3Xd(3, 0);
  return static_cast<double>(count) * (vectors.rightCols(count) - vectors.leftCols(count));
}

/// Bernstein polynomials at the nodes of both rules, one row for each; none for a degree below 0.
Eigen::MatrixXd valuesAtNodes(int degree, const std::vector<double>& nodes) {
  Eigen::MatrixXd values(std::max(0, degree + 1), static_cast<Index>(nodes.size()));
  if (degree < 0) return values;
  for (Index k = 0; k < values.cols(); ++k)
    values.col(k) = bernsteinDerivatives(degree, nodes[k]).row(0).transpose();
  return values;
}

struct BothRules {
  std::vector<double> nodes, weights;

  BothRules() {
    for (const int count : {VariationQuadrature::coarse_nodes, VariationQuadrature::fine_nodes}) {
      const GaussRule rule = gaussRule(count);
      nodes.insert(nodes.end(), rule.nodes.begin(), rule.nodes.end());
      weights.insert(weights.end(), rule.weights.begin(), rule.weights.end());
    }
  }
};

}  // namespace

/// A piece with the parameter 0..1.
class PolynomialPiece {
 public:
  PolynomialPiece(const VariationQuadrature& rules, Matrix3Xd hodograph)
      : rules_(rules), hodograph_(std::move(hodograph)) {}

  bool regular() const { return nearTheirMean(hodograph_); }
  bool straight() const { return parallel(hodograph_); }

  RulePair variation() const {
    using AtNodes = Eigen::Matrix<double, 3, VariationQuadrature::nodes>;
    const Matrix3Xd change = differences(hodograph_);
    const AtNodes first = hodograph_.lazyProduct(rules_.first_),
                  second = change.lazyProduct(rules_.second_),
                  third = differences(change).lazyProduct(rules_.third_);
    RulePair result;
    for (int k = 0; k < VariationQuadrature::nodes; ++k)
      result.add(k, rules_.weights_(k), first.col(k), second.col(k), third.col(k));
    return result;
  }

  std::pair<PolynomialPiece, PolynomialPiece> halves() const {
    // The parameter of a half runs twice as fast.
    Matrix3Xd left = hodograph_ / 2, right = left;
    const Index last = left.cols() - 1;
    for (Index r = 1; r <= last; ++r) {
      for (Index i = 0; i + r <= last; ++i) right.col(i) = (right.col(i) + right.col(i + 1)) / 2;
      left.col(r) = right.col(0);
    }
    return {PolynomialPiece(rules_, std::move(left)), PolynomialPiece(rules_, std::move(right))};
  }

 private:
  const VariationQuadrature& rules_;
  Matrix3Xd hodograph_;
};

namespace {

class RationalPiece {
 public:
  RationalPiece(const BothRules& rules, BezierCurve curve)
      : rules_(rules), curve_(std::move(curve)) {}

  /// The derivative is a combination of the differences of neighbouring poles with shares that are
  /// not negative (P13.6).
  bool regular() const {
    const Eigen::VectorXd weights = curve_.weights();
    return weights.maxCoeff() <= 2 * weights.minCoeff() &&
           nearTheirMean(differences(curve_.poles().transpose()));
  }
  bool straight() const { return parallel(differences(curve_.poles().transpose())); }

  RulePair variation() const {
    RulePair result;
    for (int k = 0; k < VariationQuadrature::nodes; ++k) {
      const CurveDerivatives at = curve_.derivatives(rules_.nodes[k], 3);
      result.add(k, rules_.weights[k], at.row(1), at.row(2), at.row(3));
    }
    return result;
  }

  std::pair<RationalPiece, RationalPiece> halves() const {
    auto [left, right] = curve_.split(0.5);
    return {RationalPiece(rules_, std::move(left)), RationalPiece(rules_, std::move(right))};
  }

 private:
  const BothRules& rules_;
  BezierCurve curve_;
};

/// Adds the pieces of a piece; stops with an infinite energy at one that may stop.
/// \param halved how often since the piece was regular.
template <class Piece>
void addPieces(SegmentVariation& sum, const Piece& piece, const DyadicPiece& where, int halved) {
  // Where the curve is slower than 2^-32 of its speed the derivatives have lost half of the digits.
  constexpr int most_halvings = 32;
  // The rules converge on a regular piece, by two digits or more with each halving: what these do
  // not settle is rounding.
  constexpr int most_of_regular = 6;
  const bool regular = piece.regular();
  if (regular) {
    const RulePair found = piece.variation();
    if (found.agree() || halved == most_of_regular) {
      sum.energy_per_mm3 += found.fine;
      sum.pieces.push_back(where);
      return;
    }
  } else if (where.halvings == most_halvings) {
    sum.energy_per_mm3 = infinite;
    return;
  }
  const auto [left, right] = piece.halves();
  const int next = where.halvings + 1;
  addPieces(sum, left, {.start = where.start, .halvings = next}, regular ? halved + 1 : 0);
  if (sum.energy_per_mm3 == infinite) return;
  addPieces(sum, right, {.start = where.start + std::ldexp(1.0, -next), .halvings = next},
            regular ? halved + 1 : 0);
}

template <class Piece>
SegmentVariation variationOfWhole(const Piece& whole) {
  SegmentVariation result;
  addPieces(result, whole, {}, 0);
  if (result.energy_per_mm3 == infinite)
    result = {.energy_per_mm3 = whole.straight() ? 0 : infinite, .pieces = {DyadicPiece{}}};
  return result;
}

}  // namespace

VariationQuadrature::VariationQuadrature(int degree) {
  const BothRules rules;
  first_ = valuesAtNodes(degree - 1, rules.nodes);
  second_ = valuesAtNodes(degree - 2, rules.nodes);
  third_ = valuesAtNodes(degree - 3, rules.nodes);
  for (int k = 0; k < nodes; ++k) weights_(k) = rules.weights[k];
}

SegmentVariation VariationQuadrature::operator()(const Matrix3Xd& hodograph) const {
  return variationOfWhole(PolynomialPiece(*this, hodograph));
}

SegmentVariation variationOf(const BezierCurve& segment) {
  if (segment.isRational()) {
    const BothRules rules;
    return variationOfWhole(RationalPiece(rules, segment));
  }
  return VariationQuadrature(segment.degree())(differences(segment.poles().transpose()));
}

}  // namespace seamwright
