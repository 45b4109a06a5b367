// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <seamwright/core/join/condition/composition.hpp>

namespace seamwright {

using rows::derivative;
using rows::Field;
using rows::Sum;
using rows::times;

std::vector<Field<4>> composedDerivatives(const Ribbon& given, const ConnectionFunctions& c,
                                          int order) {
  const Field<4>&P = given.position, &P_s = given.first, &P_ss = given.second, &P_sss = given.third;
  const Field<4> P_t = derivative<4>(P);
  std::vector<Field<4>> result = {P};
  result.push_back(Sum<4>().add(c.alpha, P_s).add(c.beta, P_t).total());
  if (order < 2) return result;

  const Field<4> P_st = derivative<4>(P_s), P_tt = derivative<4>(P_t);
  const Eigen::VectorXd alpha_2 = times(c.alpha, c.alpha), beta_2 = times(c.beta, c.beta);
  result.push_back(Sum<4>()
                       .add(alpha_2, P_ss)
                       .add(2 * times(c.alpha, c.beta), P_st)
                       .add(beta_2, P_tt)
                       .add(c.p, P_s)
                       .add(c.q, P_t)
                       .total());
  if (order < 3) return result;

  result.push_back(Sum<4>()
                       .add(times(alpha_2, c.alpha), P_sss)
                       .add(3 * times(alpha_2, c.beta), derivative<4>(P_ss))
                       .add(3 * times(c.alpha, beta_2), derivative<4>(P_st))
                       .add(times(beta_2, c.beta), derivative<4>(P_tt))
                       .add(3 * times(c.alpha, c.p), P_ss)
                       .add(3 * times(c.alpha, c.q), P_st)
                       .add(3 * times(c.beta, c.p), P_st)
                       .add(3 * times(c.beta, c.q), P_tt)
                       .add(c.h, P_s)
                       .add(c.k, P_t)
                       .total());
  return result;
}

Field<4> scaledDerivative(const std::vector<Field<4>>& composed, const ConnectionFunctions& c,
                          int order) {
  const std::array scale = {&c.e0, &c.e1, &c.e2, &c.e3};
  const Eigen::VectorXd& binomials = bernstein::binomials(order);
  Sum<4> sum;
  for (int j = 0; j <= order; ++j) {
    const auto at = static_cast<std::size_t>(j);
    sum.add(binomials(j) * *scale[static_cast<std::size_t>(order) - at], composed[at]);
  }
  return sum.total();
}

}  // namespace seamwright
