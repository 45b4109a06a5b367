// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/checked_connection.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;

void requireFunction(const char* name, const Eigen::VectorXd& function) {
  if (function.size() == 0)
    throw std::invalid_argument(std::string(name) + " has no coefficient: at least one is needed");
  // A limit of the interface, as a choice: binomials of products stay far within a double.
  constexpr Eigen::Index most = 100;
  if (function.size() > most + 1)
    throw std::invalid_argument(std::string(name) + " has degree " +
                                std::to_string(function.size() - 1) + ": it must be within " +
                                std::to_string(most));
  for (Eigen::Index i = 0; i < function.size(); ++i)
    if (!std::isfinite(function(i)))
      throw std::invalid_argument(std::string(name) + " has coefficient " + std::to_string(i) +
                                  " = " + text(function(i)) + ": it must be finite");
}

void requirePositive(const char* name, const Eigen::VectorXd& function) {
  const BernsteinPolynomial p(function);
  if (const auto at = rows::notPositiveAt(p)) {
    const Interval value = p.evaluate(*at);
    throw std::invalid_argument(std::string(name) + " is " + text((value.lower + value.upper) / 2) +
                                " at t = " + text(*at) + ": it must be positive on [0, 1]");
  }
}

}  // namespace

ConnectionFunctions checked(const ConnectionFunctions& c) {
  requireFunction("alpha", c.alpha);
  requireFunction("beta", c.beta);
  requireFunction("p", c.p);
  requireFunction("q", c.q);
  requireFunction("h", c.h);
  requireFunction("k", c.k);
  requireFunction("e0", c.e0);
  requireFunction("e1", c.e1);
  requireFunction("e2", c.e2);
  requireFunction("e3", c.e3);
  requirePositive("alpha", c.alpha);
  requirePositive("e0", c.e0);
  if (!isConstant(c.gamma, 1))
    throw std::invalid_argument("gamma is not 1: only networks have a common denominator");
  return {.alpha = rows::trimmed(c.alpha),
          .beta = rows::trimmed(c.beta),
          .p = rows::trimmed(c.p),
          .q = rows::trimmed(c.q),
          .h = rows::trimmed(c.h),
          .k = rows::trimmed(c.k),
          .e0 = rows::trimmed(c.e0),
          .e1 = rows::trimmed(c.e1),
          .e2 = rows::trimmed(c.e2),
          .e3 = rows::trimmed(c.e3)};
}

}  // namespace seamwright
