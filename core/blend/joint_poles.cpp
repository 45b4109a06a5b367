// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/blend/joint_poles.hpp>

namespace seamwright::loft {

namespace {

Bern plus(const Bern& p, const Bern& q) {
  const Eigen::Index degree = std::max(p.rows(), q.rows()) - 1;
  return raisedTo(p, degree) + raisedTo(q, degree);
}

/// The product of a function with one column and any function.
Bern times(const Bern& factor, const Bern& p) {
  if (factor.rows() == 1) return factor(0, 0) * p;
  if (p.rows() == 1) return factor * p;
  const Eigen::Index m = factor.rows() - 1, n = p.rows() - 1;
  const Eigen::VectorXd &cm = bernstein::binomials(m), &cn = bernstein::binomials(n);
  Bern result = Bern::Zero(m + n + 1, p.cols());
  for (Eigen::Index i = 0; i <= m; ++i)
    for (Eigen::Index j = 0; j <= n; ++j)
      result.row(i + j) += cm(i) * cn(j) * factor(i, 0) * p.row(j);
  const Eigen::VectorXd& all = bernstein::binomials(m + n);
  for (Eigen::Index i = 0; i <= m + n; ++i) result.row(i) /= all(i);
  return result;
}

/// d! / (d - k)!
double falling(int d, int k) {
  double result = 1;
  for (int i = 0; i < k; ++i) result *= d - i;
  return result;
}

/// B_kl of the coefficients, for 1 <= l <= k <= n, by B_kl = sum_i C(k-1, i-1) b_i B_(k-i)(l-1).
std::vector<std::vector<Bern>> bell(const std::vector<Bern>& b) {
  const auto n = static_cast<int>(b.size());
  std::vector<std::vector<Bern>> result(n + 1, std::vector<Bern>(n + 1, Bern::Zero(1, 1)));
  result[0][0] = Bern::Ones(1, 1);
  for (int k = 1; k <= n; ++k)
    for (int l = 1; l <= k; ++l)
      for (int i = 1; i <= k - l + 1; ++i)
        result[k][l] = plus(result[k][l], bernstein::binomials(k - 1)(i - 1) *
                                              times(b[i - 1], result[k - i][l - 1]));
  return result;
}

}  // namespace

Bern raisedTo(Bern p, Eigen::Index degree) {
  while (p.rows() <= degree) {
    const Eigen::Index n = p.rows();
    Bern q(n + 1, p.cols());
    q.row(0) = p.row(0);
    q.row(n) = p.row(n - 1);
    for (Eigen::Index i = 1; i < n; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(n);
      q.row(i) = share * p.row(i - 1) + (1 - share) * p.row(i);
    }
    p = std::move(q);
  }
  return p;
}

std::vector<Bern> jointPoles(const std::vector<Bern>& jet, const std::vector<Bern>& change,
                             int degree, bool before) {
  const auto n = static_cast<int>(change.size());
  const std::vector<std::vector<Bern>> matrix = bell(change);
  std::vector<Bern> derivative{jet[0]};
  for (int k = 1; k <= n; ++k) {
    Bern sum = Bern::Zero(1, 3);
    for (int l = 1; l <= k; ++l) sum = plus(sum, times(matrix[k][l], jet[l]));
    derivative.push_back(std::move(sum));
  }
  std::vector<Bern> result;
  for (int k = 0; k <= n; ++k) {
    Bern pole = derivative[0];
    for (int i = 1; i <= k; ++i) {
      const double sign = before && i % 2 == 1 ? -1 : 1;
      pole = plus(pole, sign * bernstein::binomials(k)(i) / falling(degree, i) * derivative[i]);
    }
    result.push_back(std::move(pole));
  }
  return result;
}

}  // namespace seamwright::loft
