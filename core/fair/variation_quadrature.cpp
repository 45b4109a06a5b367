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

using AtNodes = VariationQuadrature::AtNodes;
using NodeVectors = Eigen::Matrix<double, VariationQuadrature::rows, 3>;

AtNodes dotAtNodes(const NodeVectors& a, const NodeVectors& b) {
  return a.col(0).array() * b.col(0).array() + a.col(1).array() * b.col(1).array() +
         a.col(2).array() * b.col(2).array();
}

/// Derivatives of the orders 1 to 3 at the nodes of both rules.
struct NodeDerivatives {
  NodeVectors first, second, third;
};

/// The variation by both rules, and what the fine one makes of the parts whose difference the
/// density is, to know the rounding in it.
struct RulePair {
  double coarse = 0, fine = 0, parts = 0;

  RulePair(const AtNodes& weights, const NodeDerivatives& at) {
    const auto& [first, second, third] = at;
    const AtNodes s = dotAtNodes(first, first), share = 3 * dotAtNodes(first, second) / s;
    const NodeVectors change = third - (second.array().colwise() * share).matrix();
    const AtNodes along = dotAtNodes(first, change) / s;
    const NodeVectors across = change - (first.array().colwise() * along).matrix();
    const AtNodes factor = weights / (s * s * s.sqrt());
    const AtNodes density = factor * dotAtNodes(across, across);
    const AtNodes part =
        factor * (dotAtNodes(third, third) + share * share * dotAtNodes(second, second));
    for (int k = 0; k < VariationQuadrature::coarse_nodes; ++k) coarse += density(k);
    for (int k = VariationQuadrature::coarse_nodes; k < VariationQuadrature::nodes; ++k) {
      fine += density(k);
      parts += part(k);
    }
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

/// Bernstein polynomials at the nodes of both rules, one column for each; none for a degree below
/// 0.
VariationQuadrature::ValuesAtNodes valuesAtNodes(int degree, const std::vector<double>& nodes) {
  VariationQuadrature::ValuesAtNodes values(VariationQuadrature::rows, std::max(0, degree + 1));
  if (degree < 0) return values;
  for (Index k = 0; k < values.rows(); ++k)
    values.row(k) = bernsteinDerivatives(degree, nodes[k]).row(0);
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
    nodes.resize(VariationQuadrature::rows, nodes.back());
    weights.resize(VariationQuadrature::rows, 0);
  }

  AtNodes weightsAtNodes() const { return AtNodes::Map(weights.data()); }
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
    const Matrix3Xd change = differences(hodograph_), second_change = differences(change);
    return {rules_.weights_, NodeDerivatives{
                                 .first = rules_.first_.lazyProduct(hodograph_.transpose()),
                                 .second = rules_.second_.lazyProduct(change.transpose()),
                                 .third = rules_.third_.lazyProduct(second_change.transpose()),
                             }};
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
    NodeDerivatives all;
    for (int k = 0; k < VariationQuadrature::rows; ++k) {
      const CurveDerivatives at = curve_.derivatives(rules_.nodes[k], 3);
      all.first.row(k) = at.row(1);
      all.second.row(k) = at.row(2);
      all.third.row(k) = at.row(3);
    }
    return {rules_.weightsAtNodes(), all};
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
  weights_ = rules.weightsAtNodes();
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
