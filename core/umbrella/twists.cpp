// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/LU>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/umbrella/laws.hpp>
#include <seamwright/core/umbrella/twists.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

void requireSeconds(const UmbrellaVertex& vertex, const SpokeSeconds& seconds) {
  const auto require = [&](const char* what, Eigen::Index count, bool finite) {
    if (count != vertex.spokes())
      throw std::invalid_argument(std::to_string(count) + " " + what + " for " +
                                  std::to_string(vertex.spokes()) + " spokes");
    if (!finite) throw std::invalid_argument(std::string(what) + " are not all finite");
  };
  require("second derivatives", seconds.second.cols(), seconds.second.allFinite());
  require("values of lambda", seconds.lambda.size(), seconds.lambda.allFinite());
  require("values of mu", seconds.mu.size(), seconds.mu.allFinite());
}

bool mayFailToClose(const UmbrellaVertex& vertex) {
  return vertex.closed && vertex.members() % 2 == 0;
}

double sign(int i) {
  return i % 2 == 0 ? 1 : -1;
}

/// e_i of an inner spoke.
Eigen::Vector3d sumAt(const UmbrellaVertex& vertex, const SpokeSeconds& seconds, int spoke) {
  return vertex.alpha(spoke) * seconds.second.col(spoke) +
         seconds.lambda(spoke) * vertex.tangents.col(spoke) +
         seconds.mu(spoke) * vertex.tangents.col(vertex.before(spoke));
}

}  // namespace

SpokeSeconds defaultSeconds(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second) {
  return {second, -vertex.alpha, Eigen::VectorXd::Zero(vertex.spokes())};
}

Eigen::Vector3d closingDefect(const UmbrellaVertex& vertex, const SpokeSeconds& seconds) {
  requireSeconds(vertex, seconds);
  Eigen::Vector3d defect = Eigen::Vector3d::Zero();
  if (mayFailToClose(vertex))
    for (int i = 0; i < vertex.spokes(); ++i)
      defect += sign(i) / vertex.sectors(i) * sumAt(vertex, seconds, i);
  return defect;
}

SpokeSeconds closed(const UmbrellaVertex& vertex, const SpokeSeconds& seconds,
                    const std::optional<Eigen::VectorXd>& weights) {
  requireSeconds(vertex, seconds);
  SpokeSeconds result = seconds;
  if (!mayFailToClose(vertex)) return result;
  const int spokes = vertex.spokes();
  const Eigen::VectorXd weight =
      weights.value_or(Eigen::VectorXd(vertex.beta.cwiseAbs().cwiseInverse()));
  if (weight.size() != spokes || !(weight.array() > 0).all() || !weight.allFinite())
    throw std::invalid_argument(std::to_string(weight.size()) + " weights of lambda for " +
                                std::to_string(spokes) +
                                " spokes: as many positive numbers are needed");

  const Eigen::VectorXd share = vertex.alpha.cwiseQuotient(vertex.sectors);
  const Eigen::Vector3d defect = closingDefect(vertex, seconds);
  if (!vertex.isRegular())
    for (int i = 0; i < spokes; ++i)
      result.second.col(i) -=
          sign(i) * share(i) * vertex.normal.dot(defect) / share.squaredNorm() * vertex.normal;

  Eigen::Matrix2Xd influence(2, spokes);
  const Eigen::Matrix<double, 2, 3> plane = umbrella::planeOf(vertex);
  for (int i = 0; i < spokes; ++i)
    influence.col(i) =
        sign(i) / (vertex.sectors(i) * std::sqrt(weight(i))) * plane * vertex.tangents.col(i);
  const Eigen::VectorXd change = influence.transpose() *
                                 (influence * influence.transpose()).inverse() *
                                 -(plane * closingDefect(vertex, result));
  result.lambda += change.cwiseQuotient(weight.cwiseSqrt());
  return result;
}

/// With y_i = X_i / S_i and d_i = e_i / S_i: y_i = (-1)^i (y_0 + sum_(0 < j <= i) (-1)^j d_j);
/// around an odd fan y_0 is half the alternating sum of all d_i.
TwistSolution solveTwists(const UmbrellaVertex& vertex) {
  const int m = vertex.members();
  Eigen::MatrixXd alternating =
      Eigen::MatrixXd::Zero(m, vertex.spokes());  // (-1)^i (y_i - y_0) of e
  for (int i = 1; i < m; ++i) {
    alternating.row(i) = alternating.row(i - 1);
    alternating(i, i) += sign(i) / vertex.sectors(i);
  }
  const bool unique = vertex.closed && m % 2 == 1;
  Eigen::RowVectorXd first = -alternating.colwise().mean();
  if (unique) {
    first = -alternating.row(m - 1) / 2;
    first(0) += 1 / (2 * vertex.sectors(0));
  }
  TwistSolution result;
  Eigen::VectorXd direction = vertex.sectors;
  for (int i = 1; i < m; i += 2) direction(i) *= -1;
  result.of_sums = direction.asDiagonal() * (alternating.rowwise() + first);
  if (!unique) result.direction = direction;
  return result;
}

Eigen::Matrix3Xd leastTwists(const UmbrellaVertex& vertex, const SpokeSeconds& seconds) {
  requireSeconds(vertex, seconds);
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, vertex.spokes());
  for (int i = 0; i < vertex.spokes(); ++i)
    if (vertex.isInner(i)) sums.col(i) = sumAt(vertex, seconds, i);
  return sums * solveTwists(vertex).of_sums.transpose();
}

Eigen::Matrix3d secondForm(const UmbrellaVertex& vertex, const Eigen::Matrix3Xd& second) {
  const Eigen::Matrix<double, 2, 3> plane = umbrella::planeOf(vertex);
  Eigen::MatrixXd rows(vertex.spokes(), 3);
  Eigen::VectorXd curvatures(vertex.spokes());
  for (int i = 0; i < vertex.spokes(); ++i) {
    const Eigen::Vector2d direction = plane * vertex.tangents.col(i).normalized();
    const double x = direction.x(), y = direction.y();
    rows.row(i) << x * x, std::sqrt(2.0) * x * y,
        y * y;  // so that the smallest solution is the smallest M
    curvatures(i) = vertex.normal.dot(second.col(i)) / vertex.tangents.col(i).squaredNorm();
  }
  const Eigen::Vector3d form = linear::LeastSquares(rows).solve(curvatures);
  const double mixed = form(1) / std::sqrt(2.0);
  Eigen::Matrix2d matrix;
  matrix << form(0), mixed, mixed, form(2);
  const Eigen::Matrix3d in_space = plane.transpose() * matrix * plane;
  return (in_space + in_space.transpose()) / 2;
}

Eigen::Matrix3Xd shapedBy(const UmbrellaVertex& vertex, const Eigen::Matrix3d& form,
                          Eigen::Matrix3Xd second) {
  for (int i = 0; i < vertex.spokes(); ++i) {
    const Eigen::Vector3d r = vertex.tangents.col(i);
    second.col(i) += (r.dot(form * r) - vertex.normal.dot(second.col(i))) * vertex.normal;
  }
  return second;
}

}  // namespace seamwright
