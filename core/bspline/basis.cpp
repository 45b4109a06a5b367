// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/numeric.hpp>

namespace seamwright::bspline {

namespace {

/// One number for each basis function of a span.
using Functional =
    Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, max_spline_degree + 1>;

/// The values of the basis functions, by the recursion of Cox, de Boor and Mansfield.
Functional basisValues(int degree, const std::vector<double>& knots, int span, double t) {
  Functional values = Functional::Zero(degree + 1);
  values(0) = 1;
  for (int p = 1; p <= degree; ++p) {
    double carried = 0;
    for (int r = 0; r < p; ++r) {
      const double right = knots[span + r + 1] - t, left = t - knots[span + 1 - p + r];
      const double share = values(r) / (right + left);
      values(r) = carried + right * share;
      carried = left * share;
    }
    values(p) = carried;
  }
  return values;
}

/// Converts a functional of the coefficients of the derivative, of degree p - 1, to a functional of
/// the coefficients of the spline of degree p.
Functional onSpline(const Functional& functional, const std::vector<double>& knots, int span) {
  const int p = static_cast<int>(functional.size());
  Functional result = Functional::Zero(p + 1);
  for (int j = 0; j < p; ++j) {
    const double factor = p * functional(j) / (knots[span + j + 1] - knots[span - p + j + 1]);
    result(j + 1) += factor;
    result(j) -= factor;
  }
  return result;
}

}  // namespace

void requireDegree(int degree, const std::string& suffix) {
  if (degree < 1 || degree > max_spline_degree)
    refuse("degree" + suffix + " is " + std::to_string(degree) + ": 1 to " +
           std::to_string(max_spline_degree) + " is needed");
}

void requireKnots(int degree, const std::vector<double>& knots, const std::string& suffix) {
  requireDegree(degree, suffix);
  const int count = static_cast<int>(knots.size()) - degree - 1;
  if (count < degree + 1)
    refuse("knots" + suffix + " are " + std::to_string(knots.size()) + ": degree " +
           std::to_string(degree) + " needs at least " + std::to_string(2 * degree + 2));
  const auto refuseKnot = [&](std::size_t i, const std::string& needed) {
    refuse("knot " + std::to_string(i) + " of knots" + suffix + " is " + bernstein::text(knots[i]) +
           ": " + needed);
  };
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) refuseKnot(i, "knots must be finite");
    if (i > 0 && knots[i] < knots[i - 1]) refuseKnot(i, "knots must not decrease");
  }
  if (const double range = knots.back() - knots.front(); range != 0 && !std::isnormal(range))
    refuseKnot(knots.size() - 1, "the range of the knots must not overflow, nor underflow");
  for (int i = 1; i <= degree; ++i) {
    if (knots[i] != knots[0]) refuseKnot(i, "the first degree + 1 knots must be equal");
    if (knots[count + i] != knots[count])
      refuseKnot(count + i, "the last degree + 1 knots must be equal");
  }
  for (int i = 1; i < count; ++i)
    if (knots[i + degree] == knots[i])
      refuseKnot(i, "an inner knot may be repeated as often as the degree, no more");
}

int spanOf(int degree, const std::vector<double>& knots, double t) {
  const auto first = knots.begin() + degree, last = knots.end() - degree - 1;
  auto above = std::upper_bound(first, last, t);
  if (above == first) above = std::upper_bound(first, last, *first);
  if (above == last) above = std::lower_bound(first, last, *last);
  return static_cast<int>(above - knots.begin()) - 1;
}

Eigen::MatrixXd basisDerivatives(int degree, const std::vector<double>& knots, int span, double t,
                                 int order) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(order + 1, degree + 1);
  for (int k = 0; k <= std::min(order, degree); ++k) {
    Functional functional = basisValues(degree - k, knots, span, t);
    while (functional.size() <= degree) functional = onSpline(functional, knots, span);
    result.row(k) = functional;
  }
  return result;
}

}  // namespace seamwright::bspline
