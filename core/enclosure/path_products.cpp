// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include <seamwright/core/enclosure/path_products.hpp>

namespace seamwright {

namespace {

VectorModel space(const HomogeneousModel& h) {
  return {h[0], h[1], h[2]};
}

/// a - factor * b.
VectorModel difference(const VectorModel& a, const ChebyshevModel& factor, const VectorModel& b) {
  static const ChebyshevModel one(1);
  VectorModel result;
  for (int d = 0; d < 3; ++d) result[d] = ProductSum().add(one, a[d]).add(factor, b[d], -1).model();
  return result;
}

/// Partial derivatives of the quotient of the space part and the weight of h, by the product rule
/// solved for them.
/// \param up_to_tangents the second derivatives leave out multiples of the first.
JetModel projected(const std::array<HomogeneousModel, 10>& h, int order, bool up_to_tangents) {
  const ChebyshevModel w = inverse(h[0][3]);
  JetModel jet;
  jet.p = w * space(h[0]);
  if (order < 1) return jet;
  const auto without_p = [&](int k) { return w * difference(space(h[k]), h[k][3], jet.p); };
  jet.u = without_p(1);
  jet.v = without_p(2);
  if (order < 2) return jet;
  if (up_to_tangents) {
    jet.uu = without_p(3);
    jet.uv = without_p(4);
    jet.vv = without_p(5);
    return jet;
  }
  jet.uu = w * (space(h[3]) - 2 * (h[1][3] * jet.u) - h[3][3] * jet.p);
  jet.uv = w * (space(h[4]) - h[1][3] * jet.v - h[2][3] * jet.u - h[4][3] * jet.p);
  jet.vv = w * (space(h[5]) - 2 * (h[2][3] * jet.v) - h[5][3] * jet.p);
  if (order < 3) return jet;
  jet.uuu = w * (space(h[6]) - 3 * (h[1][3] * jet.uu + h[3][3] * jet.u) - h[6][3] * jet.p);
  jet.uuv = w * (space(h[7]) - 2 * (h[1][3] * jet.uv + h[4][3] * jet.u) - h[2][3] * jet.uu -
                 h[3][3] * jet.v - h[7][3] * jet.p);
  jet.uvv = w * (space(h[8]) - 2 * (h[2][3] * jet.uv + h[4][3] * jet.v) - h[1][3] * jet.vv -
                 h[5][3] * jet.u - h[8][3] * jet.p);
  jet.vvv = w * (space(h[9]) - 3 * (h[2][3] * jet.vv + h[5][3] * jet.v) - h[9][3] * jet.p);
  return jet;
}

/// T_k of x or -x, if that is all that the model holds but for rounding. With |x - t| <= off for t
/// in [-1, 1], |T_k(x) - T_k(t)| is at most off times the slope of T_k at 1 + off, which for
/// off < 2^-40 and k <= 25 is below 1.001 k^2.
bool addMonomials(const ChebyshevModel& x, int degree, std::vector<ChebyshevModel>& t) {
  const double sign = x.coefficient(1) < 0 ? -1 : 1;
  const double off =
      (x.radius() + std::abs(x.coefficient(0)) + std::abs(x.coefficient(1) - sign)) * (1 + 1e-12);
  if (x.degree() != 1 || !(off < 0x1p-40)) return false;
  std::array<double, max_spline_degree + 1> series{};
  for (int k = 2; k <= degree; ++k) {
    series[k] = k % 2 == 1 ? sign : 1;
    t.push_back(ChebyshevModel::series({series.data(), static_cast<std::size_t>(k) + 1},
                                       1.001 * k * k * off));
    series[k] = 0;
  }
  return true;
}

}  // namespace

/// T_(i + j) = 2 T_i T_j - T_(j - i). With halved indices the radii grow with the square of the
/// index k; with steps of one they would grow like 2.4^k.
std::vector<ChebyshevModel> chebyshevPolynomials(const ChebyshevModel& x, int degree) {
  const ChebyshevModel one(1);
  std::vector<ChebyshevModel> t;
  t.reserve(std::max(degree + 1, 2));
  t.push_back(one);
  t.push_back(x);
  if (degree >= 2 && addMonomials(x, degree, t)) return t;
  for (int k = 2; k <= degree; ++k)
    t.push_back(ProductSum().add(one, t[k % 2], -1).add(t[k / 2], t[k - k / 2], 2).model());
  t.resize(degree + 1);
  return t;
}

JetModel jetFrom(const std::array<HomogeneousModel, 10>& h, bool rational, int order,
                 bool up_to_tangents) {
  if (rational) return projected(h, order, up_to_tangents);
  JetModel jet;
  const std::array<VectorModel*, 10> fields = {&jet.p,  &jet.u,   &jet.v,   &jet.uu,  &jet.uv,
                                               &jet.vv, &jet.uuu, &jet.uuv, &jet.uvv, &jet.vvv};
  for (int k = 0; k < netCount(order); ++k) *fields[k] = space(h[k]);
  return jet;
}

PathProducts::PathProducts(const std::vector<ChebyshevModel>& tx,
                           const std::vector<ChebyshevModel>& ty)
    : series(ChebyshevModel::size, tx.size() * ty.size()),
      off(2, tx.size() * ty.size()),
      count_x(static_cast<Eigen::Index>(tx.size())) {
  int column = 0;
  const auto add = [&](const ChebyshevModel& product) {
    series.col(column) = Eigen::Map<const Terms>(product.coefficients().data());
    off.col(column++) << product.radius(), product.magnitude();
    degree = std::max(degree, product.degree());
  };
  // The first polynomial of both is the constant 1.
  for (const ChebyshevModel& s : tx) add(s);
  for (std::size_t j = 1; j < ty.size(); ++j) {
    add(ty[j]);
    for (std::size_t i = 1; i < tx.size(); ++i) add(tx[i] * ty[j]);
  }
}

ChebyshevModel PathProducts::sum(const Eigen::Ref<const Eigen::MatrixXd>& coefficients,
                                 double error) const {
  ChebyshevModel::Coefficients sum{};
  std::array<double, 2> sum_off{};  // radius and rounding
  for (Eigen::Index j = 0; j < coefficients.cols(); ++j)
    terms::addCombination(coefficients.col(j).data(), static_cast<int>(coefficients.rows()),
                          series.col(j * count_x).data(), off.col(j * count_x).data(), sum.data(),
                          sum_off.data());
  // A term has one rounding of its product, and one for each sum.
  const double rounding =
      0.5 * machine_epsilon * static_cast<double>(coefficients.size() + 4) * sum_off[1];
  return ChebyshevModel::series({sum.data(), static_cast<std::size_t>(degree + 1)},
                                // The last factor covers the rounding of this bound itself.
                                (sum_off[0] + rounding + error) * (1 + 1e-12));
}

}  // namespace seamwright
