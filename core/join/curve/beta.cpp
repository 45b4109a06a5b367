// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/join/curve/bell.hpp>
#include <seamwright/core/join/curve/beta.hpp>

namespace seamwright {

namespace {

using bernstein::text;
using Eigen::Index;

/// A limit of the interface, as a choice, far above the orders in use.
constexpr Index most_betas = 30;

void refuseOverflow(const Eigen::MatrixXd& result, const char* what) {
  for (Index k = 0; k < result.rows(); ++k)
    for (Index j = 0; j < result.cols(); ++j)
      if (!std::isfinite(result(k, j)))
        throw std::invalid_argument("the betas are too large: " + std::string(what) + " (" +
                                    std::to_string(k) + ", " + std::to_string(j) + ") is " +
                                    text(result(k, j)));
}

}  // namespace

void requireBeta(const Eigen::VectorXd& beta) {
  if (beta.size() > most_betas)
    throw std::invalid_argument(std::to_string(beta.size()) + " betas: at most " +
                                std::to_string(most_betas) + " are known");
  for (Index k = 0; k < beta.size(); ++k)
    if (!std::isfinite(beta(k)))
      throw std::invalid_argument("beta_" + std::to_string(k + 1) + " is " + text(beta(k)) +
                                  ": it must be finite");
  if (beta.size() > 0 && beta(0) <= 0)
    throw std::invalid_argument("beta_1 is " + text(beta(0)) + ": it must be positive");
}

Eigen::MatrixXd betaMatrix(const Eigen::VectorXd& beta) {
  requireBeta(beta);
  Eigen::MatrixXd matrix = bellMatrix<double>(beta);
  refuseOverflow(matrix, "entry");
  return matrix;
}

Eigen::VectorXd composedBeta(const Eigen::VectorXd& beta, const Eigen::VectorXd& first) {
  if (beta.size() != first.size())
    throw std::invalid_argument("betas " + std::to_string(beta.size()) + " and " +
                                std::to_string(first.size()) + ": the numbers must be equal");
  requireBeta(first);
  const Index order = beta.size();
  Eigen::VectorXd result = betaMatrix(beta).bottomRightCorner(order, order) * first;
  refuseOverflow(result, "result");
  return result;
}

Eigen::VectorXd inverseBeta(const Eigen::VectorXd& beta) {
  const Index order = beta.size();
  Eigen::VectorXd result = Eigen::VectorXd::Identity(order, 1);
  const Eigen::MatrixXd matrix = betaMatrix(beta).bottomRightCorner(order, order);
  matrix.triangularView<Eigen::Lower>().solveInPlace(result);
  refuseOverflow(result, "result");
  return result;
}

Eigen::VectorXd reversedBeta(const Eigen::VectorXd& beta) {
  Eigen::VectorXd result = inverseBeta(beta);
  for (Index k = 1; k < result.size(); k += 2) result(k) = -result(k);
  return result;
}

}  // namespace seamwright
