// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/umbrella/laws.hpp>

namespace seamwright::umbrella {

namespace {

/// Singular values below this share of the largest one are 0: the fan is a singular one.
constexpr double kSingular = 1e-9;

/// For each member the mixed value F(r_i, r_(i+1)) of a form in the tangent plane.
Eigen::VectorXd mixedValues(const UmbrellaVertex& vertex, const Eigen::Matrix3d& form) {
  Eigen::VectorXd values(vertex.members());
  for (int i = 0; i < vertex.members(); ++i)
    values(i) = vertex.tangents.col(i).dot(form * vertex.tangents.col(vertex.after(i)));
  return values;
}

/// The form nearest to the components of the second derivatives in a direction.
Eigen::Matrix3d formAlong(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second,
                          const Eigen::RowVector3d& direction) {
  return secondForm(vertex, vertex.normal * (direction * second));
}

/// The equations of the tangential second order: unknown are, each divided by its weight, lambda,
/// p and q of the spokes, and the differences of the twists from those of the nearest form.
class SecondOrder {
 public:
  SecondOrder(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second)
      : vertex_(vertex),
        r_(planeOf(vertex) * vertex.tangents),
        q_(planeOf(vertex) * second),
        twists_(2, vertex.members()) {
    const Eigen::Matrix<double, 2, 3> plane = planeOf(vertex);
    for (int c = 0; c < 2; ++c)
      twists_.row(c) = mixedValues(vertex, formAlong(vertex, second, plane.row(c))).transpose();
    const int n = vertex.spokes();
    matrix_ = Eigen::MatrixXd::Zero(4 * n, 3 * n + 2 * vertex.members());
    right_ = Eigen::VectorXd::Zero(4 * n);
    for (int i = 0; i < n; ++i)
      if (vertex.isInner(i)) add(i);
  }

  std::vector<SpokeLaw> laws() const {
    const Eigen::VectorXd solution = linear::LeastSquares(matrix_).solve(right_);
    std::vector<SpokeLaw> result(vertex_.spokes());
    for (int i = 0; i < vertex_.spokes(); ++i) {
      if (!vertex_.isInner(i)) continue;
      const double alpha = vertex_.alpha(i), beta = vertex_.beta(i), size = std::abs(beta);
      const double lambda = solution(lambdaAt(i)) * std::sqrt(size),
                   p = solution(pAt(i)) * size * std::sqrt(size), q = solution(qAt(i)) * size;
      const Eigen::Vector2d a(alpha, alpha + lambda);
      const Eigen::VectorXd along = Eigen::Vector2d::Constant(q) + (lambda + p / (2 * beta)) * a;
      const auto constant = [](double value) { return Eigen::VectorXd::Constant(1, value); };
      result[i] = {2, a, constant(beta), constant(p), along, {}};
    }
    return result;
  }

 private:
  int lambdaAt(int spoke) const { return spoke; }
  int pAt(int spoke) const { return vertex_.spokes() + spoke; }
  int qAt(int spoke) const { return 2 * vertex_.spokes() + spoke; }
  int twistAt(int member, int c) const { return 3 * vertex_.spokes() + 2 * member + c; }

  /// X_i - beta X_j - lambda r_i = alpha q_i,
  /// 2 alpha beta X_j + p r_j + q r_i = q_k - beta^2 q_j - alpha^2 q_i, where q of the law is
  /// q + alpha lambda + p alpha / (2 beta): so reversed order only changes signs and weights.
  void add(int i) {
    const int j = vertex_.before(i), k = vertex_.after(i);
    const double alpha = vertex_.alpha(i), beta = vertex_.beta(i), size = std::abs(beta);
    for (int c = 0; c < 2; ++c) {
      const int first = 4 * i + c, second = 4 * i + 2 + c;
      const auto addTwist = [&](int row, int member, double factor) {
        matrix_(row, twistAt(member, c)) += factor * twistWeight(member);
        right_(row) -= factor * twists_(c, member);
      };
      right_(first) += alpha * q_(c, i);
      addTwist(first, i, 1);
      addTwist(first, j, -beta);
      matrix_(first, lambdaAt(i)) -= std::sqrt(size) * r_(c, i);
      right_(second) += q_(c, k) - beta * beta * q_(c, j) - alpha * alpha * q_(c, i);
      addTwist(second, j, 2 * alpha * beta);
      matrix_(second, lambdaAt(i)) += std::sqrt(size) * alpha * r_(c, i);
      matrix_(second, pAt(i)) +=
          size * std::sqrt(size) * (r_(c, j) + alpha / (2 * beta) * r_(c, i));
      matrix_(second, qAt(i)) += size * r_(c, i);
    }
  }

  double twistWeight(int member) const {
    return std::sqrt(r_.col(member).norm() * r_.col(vertex_.after(member)).norm());
  }

  const UmbrellaVertex& vertex_;
  Eigen::Matrix2Xd r_, q_, twists_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_;
};

}  // namespace

Eigen::Matrix<double, 2, 3> planeOf(const UmbrellaVertex& vertex) {
  const Eigen::Vector3d across = vertex.normal.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> plane;
  plane << across.transpose(), vertex.normal.cross(across).transpose();
  return plane;
}

Eigen::Matrix3Xd continued(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second) {
  Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, vertex.spokes());
  for (int c = 0; c < 3; ++c) {
    const Eigen::Matrix3d form = formAlong(vertex, second, Eigen::RowVector3d::Unit(c));
    for (int i = 0; i < vertex.spokes(); ++i)
      result(c, i) = vertex.tangents.col(i).dot(form * vertex.tangents.col(i));
  }
  return result;
}

std::vector<SpokeLaw> secondOrderLaws(const UmbrellaVertex& vertex,
                                      const Eigen::Matrix3Xd& second) {
  return SecondOrder(vertex, second).laws();
}

/// Unknown are X_uvv and X_uuv of the members. Across spoke i, with j the member before it,
///   X_uuv,i = beta X_uvv,j + alpha C''' + 2 lambda C''
///   X_uvv,i = beta^2 X_uuv,j + 2 alpha beta X_uvv,j + alpha^2 C'''
///             + (2 lambda beta + p) X_uv,j + (2 alpha lambda + q) C''      along N.
/// Divided by the lengths of the tangents, the coefficients are those of tangents of length 1.
ThirdOrder thirdOrder(const UmbrellaVertex& vertex, const std::vector<SpokeLaw>& laws,
                      const Eigen::Matrix3d& form, const Eigen::Matrix3Xd& second,
                      const Eigen::Matrix3Xd& third) {
  const Eigen::RowVectorXd length = vertex.tangents.colwise().norm();
  const Eigen::Matrix3Xd directions = vertex.tangents.array().rowwise() / length.array();
  const UmbrellaVertex unit = umbrellaVertex(directions, vertex.closed);
  const Eigen::VectorXd twists = mixedValues(vertex, form),
                        curvatures = (vertex.normal.transpose() * second).transpose();
  const int m = vertex.members(), n = vertex.spokes();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * n, 2 * m);
  Eigen::MatrixXd of_third = Eigen::MatrixXd::Zero(2 * n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
  for (int i = 0; i < n; ++i) {
    if (!vertex.isInner(i)) continue;
    const int j = vertex.before(i), k = vertex.after(i);
    const double alpha = unit.alpha(i), beta = unit.beta(i);
    matrix(2 * i, m + i) += 1;
    matrix(2 * i, j) -= beta;
    matrix(2 * i + 1, i) += 1;
    matrix(2 * i + 1, m + j) -= beta * beta;
    matrix(2 * i + 1, j) -= 2 * alpha * beta;
    of_third(2 * i, i) = alpha;
    of_third(2 * i + 1, i) = alpha * alpha;
    const SpokeLaw& law = laws[i];
    const double lambda = law.a(1) - law.a(0);
    right(2 * i) = 2 * lambda * curvatures(i) / (length(i) * length(i) * length(k));
    right(2 * i + 1) = ((2 * lambda * law.b(0) + law.p(0)) * twists(j) +
                        (2 * law.a(0) * lambda + law.q(0)) * curvatures(i)) /
                       (length(i) * length(k) * length(k));
  }
  const Eigen::VectorXd cubes = length.array().cube();
  const Eigen::VectorXd scaled =
      (vertex.normal.transpose() * third).transpose().cwiseQuotient(cubes);
  const linear::SingularValues svd = linear::singularValues(matrix, Eigen::ComputeFullU);
  Eigen::Index rank = 0;
  while (rank < svd.values.size() && svd.values(rank) > kSingular * svd.values(0)) ++rank;
  const Eigen::MatrixXd left = svd.u.rightCols(2 * n - rank).transpose();
  const Eigen::MatrixXd influence = left * of_third;
  ThirdOrder result{svd.values(0) / svd.values(rank - 1), third};
  if (influence.norm() <= kSingular) return result;
  const Eigen::VectorXd change =
      -linear::LeastSquares(influence, kSingular).solve(left * (right + of_third * scaled));
  result.third += vertex.normal * change.cwiseProduct(cubes).transpose();
  return result;
}

}  // namespace seamwright::umbrella
