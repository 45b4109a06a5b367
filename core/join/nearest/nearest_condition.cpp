// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/join/nearest/nearest_condition.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::nearest {

namespace {

constexpr std::array terms_of_order_1 = {Term{1, FieldQs}, Term{-1, FieldP, {E1, -1, -1}},
                                         Term{-1, FieldPs, {Alpha, -1, -1}},
                                         Term{-1, FieldPt, {Beta, -1, -1}}};

constexpr std::array terms_of_order_2 = {
    Term{1, FieldQss},
    Term{-1, FieldP, {E2, -1, -1}},
    Term{-2, FieldPs, {E1, Alpha, -1}},
    Term{-2, FieldPt, {E1, Beta, -1}},
    Term{-1, FieldPss, {Alpha, Alpha, -1}},
    Term{-2, FieldPst, {Alpha, Beta, -1}},
    Term{-1, FieldPtt, {Beta, Beta, -1}},
    Term{-1, FieldPs, {P, -1, -1}},
    Term{-1, FieldPt, {Q, -1, -1}},
};

constexpr std::array terms_of_order_3 = {
    Term{1, FieldQsss},
    Term{-1, FieldP, {E3, -1, -1}},
    Term{-3, FieldPs, {E2, Alpha, -1}},
    Term{-3, FieldPt, {E2, Beta, -1}},
    Term{-3, FieldPss, {E1, Alpha, Alpha}},
    Term{-6, FieldPst, {E1, Alpha, Beta}},
    Term{-3, FieldPtt, {E1, Beta, Beta}},
    Term{-3, FieldPs, {E1, P, -1}},
    Term{-3, FieldPt, {E1, Q, -1}},
    Term{-1, FieldPsss, {Alpha, Alpha, Alpha}},
    Term{-3, FieldPsst, {Alpha, Alpha, Beta}},
    Term{-3, FieldPstt, {Alpha, Beta, Beta}},
    Term{-1, FieldPttt, {Beta, Beta, Beta}},
    Term{-3, FieldPss, {Alpha, P, -1}},
    Term{-3, FieldPst, {Alpha, Q, -1}},
    Term{-3, FieldPst, {Beta, P, -1}},
    Term{-3, FieldPtt, {Beta, Q, -1}},
    Term{-1, FieldPs, {H, -1, -1}},
    Term{-1, FieldPt, {K, -1, -1}},
};

/// Derivatives by t in each field.
constexpr std::array<int, field_count> derivatives_along = {0, 1, 2, 3, 0, 1, 2, 0, 1, 0, 0, 0, 0};

/// Degree of the left side of the condition; \p n that of the rows.
int conditionDegree(int order, int n, const Degrees& degrees) {
  int highest = n;
  for (const Term& term : termsOf(order)) {
    int degree = n - derivatives_along[term.field];
    bool vanishes = false;
    for (const int function : term.functions) {
      if (function < 0) continue;
      vanishes = vanishes || degrees[function] < 0;
      degree += degrees[function];
    }
    if (!vanishes) highest = std::max(highest, degree);
  }
  return highest;
}

/// The product of the values of a term's functions, those at the given places left out.
double productOf(const Term& term, const auto& values, std::size_t without = 3,
                 std::size_t and_without = 3) {
  double product = term.factor;
  for (std::size_t k = 0; k < term.functions.size(); ++k)
    if (term.functions[k] >= 0 && k != without && k != and_without)
      product *= values(term.functions[k]);
  return product;
}

/// Adds the parameters that determine a spline of that degree on a part of the seam inside which it
/// is continuous. The knots include repetitions and are clamped.
void addParameters(int degree, const std::vector<double>& knots, const std::vector<double>& own,
                   int own_degree, std::vector<SeamParameter>& parameters) {
  const int count = static_cast<int>(knots.size()) - degree - 1;
  const double begin = knots.front(), end = knots.back();
  for (int i = 0; i < count; ++i) {
    double t = 0;
    if (count == degree + 1) {
      const double angle = std::numbers::pi * (2 * i + 1) / (2 * count);
      t = (begin + end - (end - begin) * std::cos(angle)) / 2;
    } else {
      for (int k = 1; k <= degree; ++k) t += knots[i + k] / degree;
      t = std::clamp(t, begin, end);
    }
    const double inside = std::min(t, std::nextafter(end, begin));
    parameters.push_back({t, bspline::spanOf(own_degree, own, inside)});
  }
}

}  // namespace

std::span<const Term> termsOf(int order) {
  if (order == 1) return terms_of_order_1;
  if (order == 2) return terms_of_order_2;
  return terms_of_order_3;
}

std::array<int, function_count + 1> offsets(const Degrees& degrees) {
  std::array<int, function_count + 1> result{};
  for (int f = 0; f < function_count; ++f) result[f + 1] = result[f] + degrees[f] + 1;
  return result;
}

Eigen::VectorXd bernsteinValues(int degree, double t) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(degree + 1);
  if (degree >= 0) values(0) = 1;
  for (int p = 1; p <= degree; ++p) {
    for (int i = p; i > 0; --i) values(i) = (1 - t) * values(i) + t * values(i - 1);
    values(0) *= 1 - t;
  }
  return values;
}

std::vector<SeamParameter> determiningParameters(int n, const std::vector<double>& knots, int order,
                                                 int degree, const std::vector<double>& vanishing) {
  std::vector<SeamParameter> result;
  std::vector<double> part(degree + 1, 0.0);
  for (std::size_t i = n + 1; i < knots.size();) {
    const double knot = knots[i];
    const auto multiplicity = static_cast<int>(std::ranges::count(knots, knot));
    const bool last = knot == knots.back();
    const int smoothness = n - multiplicity - (std::ranges::count(vanishing, knot) > 0 ? 0 : order);
    const int repeats = last || smoothness < 0 ? degree + 1 : degree - smoothness;
    part.insert(part.end(), repeats, knot);
    if (last || smoothness < 0) {
      addParameters(degree, part, knots, n, result);
      part.assign(degree + 1, knot);
    }
    i += multiplicity;
  }
  return result;
}

Condition::Condition(const Unknowns& unknowns, int order, const Degrees& degrees,
                     const std::vector<double>& vanishing)
    : unknowns_(unknowns),
      degrees_(degrees),
      offset_(offsets(degrees)),
      width_(unknowns.a.degree + 1),
      columns_(static_cast<Eigen::Index>(unknowns.blocks()) * unknowns.count()) {
  for (int k = 1; k <= order; ++k) addPoints(k, vanishing);
}

void Condition::addPoints(int order, const std::vector<double>& vanishing) {
  const int n = unknowns_.a.degree, degree = conditionDegree(order, n, degrees_);
  for (const SeamParameter& parameter :
       determiningParameters(n, unknowns_.a.knots, order, degree, vanishing))
    points_.push_back(pointAt(order, parameter.t, parameter.span));
}

Condition::Point Condition::pointAt(int order, double t, int span) const {
  const Unknowns& u = unknowns_;
  const Eigen::MatrixXd basis = bspline::basisDerivatives(u.a.degree, u.a.knots, span, t, 3);
  Point point;
  point.order = order;
  point.first = span - u.a.degree;
  for (int f = 0; f < function_count; ++f) point.bernstein[f] = bernsteinValues(degrees_[f], t);
  point.fields = Eigen::MatrixXd::Zero(field_count, static_cast<Eigen::Index>(u.blocks()) * width_);
  const auto set = [&](Field field, int block, double factor, int derivative) {
    point.fields.row(field).segment(static_cast<Eigen::Index>(block) * width_, width_) +=
        factor * basis.row(derivative);
  };
  set(FieldP, 0, 1, 0);
  set(FieldPt, 0, 1, 1);
  set(FieldPtt, 0, 1, 2);
  set(FieldPttt, 0, 1, 3);
  for (int row = 0; row <= u.a.depth; ++row) {
    set(FieldPs, row, -u.a.across(1, row), 0);
    set(FieldPst, row, -u.a.across(1, row), 1);
    set(FieldPstt, row, -u.a.across(1, row), 2);
    set(FieldPss, row, u.a.across(2, row), 0);
    set(FieldPsst, row, u.a.across(2, row), 1);
    set(FieldPsss, row, -u.a.across(3, row), 0);
  }
  for (int row = 0; row <= u.b.depth; ++row) {
    const int block = row == 0 ? 0 : u.a.depth + row;
    set(FieldQs, block, u.b.across(1, row), 0);
    set(FieldQss, block, u.b.across(2, row), 0);
    set(FieldQsss, block, u.b.across(3, row), 0);
  }
  const double factor = std::max(std::abs(u.b.across(order, order)), u.b.across(1, 1));
  point.scale = 1 / factor;
  return point;
}

Condition::Values Condition::values(const Point& point, const Eigen::VectorXd& c) const {
  Values result;
  for (int f = 0; f < function_count; ++f)
    result(f) = point.bernstein[f].dot(c.segment(offset_[f], degrees_[f] + 1));
  return result;
}

Condition::Combination Condition::combination(int order, const Values& f) {
  Combination w = Combination::Zero();
  for (const Term& term : termsOf(order)) w(term.field) += productOf(term, f);
  return w;
}

Condition::Combination Condition::derivative(int order, const Values& f, int function) {
  Combination w = Combination::Zero();
  for (const Term& term : termsOf(order))
    for (std::size_t k = 0; k < term.functions.size(); ++k)
      if (term.functions[k] == function) w(term.field) += productOf(term, f, k);
  return w;
}

Condition::Combination Condition::secondDerivative(int order, const Values& f, int function,
                                                   int other) {
  Combination w = Combination::Zero();
  for (const Term& term : termsOf(order))
    for (std::size_t k = 0; k < term.functions.size(); ++k)
      for (std::size_t l = 0; l < term.functions.size(); ++l)
        if (k != l && term.functions[k] == function && term.functions[l] == other)
          w(term.field) += productOf(term, f, k, l);
  return w;
}

Eigen::MatrixXd Condition::local(const Point& point, const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd result(point.fields.cols(), x.cols());
  for (int block = 0; block < unknowns_.blocks(); ++block)
    result.middleRows(static_cast<Eigen::Index>(block) * width_, width_) =
        x.middleRows(static_cast<Eigen::Index>(block) * unknowns_.count() + point.first, width_);
  return result;
}

Eigen::MatrixXd Condition::matrix(const Eigen::VectorXd& c) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows(), columns_);
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    const Eigen::RowVectorXd row =
        point.scale * combination(point.order, values(point, c)).transpose() * point.fields;
    for (int block = 0; block < unknowns_.blocks(); ++block)
      result.row(i).segment(static_cast<Eigen::Index>(block) * unknowns_.count() + point.first,
                            width_) =
          row.segment(static_cast<Eigen::Index>(block) * width_, width_);
  }
  return result;
}

std::vector<Eigen::MatrixXd> Condition::derivatives(const Eigen::VectorXd& c,
                                                    const Eigen::MatrixXd& x) const {
  std::vector<Eigen::MatrixXd> result(coefficients(), Eigen::MatrixXd::Zero(rows(), x.cols()));
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    const Eigen::MatrixXd fields = point.fields * local(point, x);
    const Values f = values(point, c);
    for (int function = 0; function < function_count; ++function) {
      const Eigen::RowVectorXd by_value =
          point.scale * derivative(point.order, f, function).transpose() * fields;
      for (int k = 0; k <= degrees_[function]; ++k)
        result[offset_[function] + k].row(i) = point.bernstein[function](k) * by_value;
    }
  }
  return result;
}

std::vector<Eigen::MatrixXd> Condition::transposed(const Eigen::VectorXd& c,
                                                   const Eigen::MatrixXd& nu) const {
  std::vector<Eigen::MatrixXd> result(coefficients(), Eigen::MatrixXd::Zero(columns_, nu.cols()));
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    const Values f = values(point, c);
    for (int function = 0; function < function_count; ++function) {
      if (degrees_[function] < 0) continue;
      const Eigen::MatrixXd by_value = point.fields.transpose() *
                                       (point.scale * derivative(point.order, f, function)) *
                                       nu.row(i);
      for (int k = 0; k <= degrees_[function]; ++k)
        for (int block = 0; block < unknowns_.blocks(); ++block)
          result[offset_[function] + k].middleRows(
              static_cast<Eigen::Index>(block) * unknowns_.count() + point.first, width_) +=
              point.bernstein[function](k) *
              by_value.middleRows(static_cast<Eigen::Index>(block) * width_, width_);
    }
  }
  return result;
}

Eigen::MatrixXd Condition::curvature(const Eigen::VectorXd& c, const Eigen::MatrixXd& nu,
                                     const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(coefficients(), coefficients());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    if (point.order == 1) continue;
    const Values values_there = values(point, c);
    const Combination weighted =
        point.scale * (point.fields * (local(point, x) * nu.row(i).transpose()));
    // A function of the condition's own order is in no product.
    const int last = functions_of_order * (point.order - 1);
    for (int f = 0; f < last; ++f)
      for (int g = 0; g < last; ++g)
        result.block(offset_[f], offset_[g], degrees_[f] + 1, degrees_[g] + 1) +=
            secondDerivative(point.order, values_there, f, g).dot(weighted) * point.bernstein[f] *
            point.bernstein[g].transpose();
  }
  return result;
}

Eigen::VectorXd Condition::fittedPart(const Eigen::MatrixXd& x, const Eigen::MatrixXd& basis,
                                      int order, const Eigen::VectorXd& c) const {
  // With the other coefficients fixed, the condition of that order is linear in its own
  // coefficients.
  const int first = offset_[functions_of_order * (order - 1)],
            last = offset_[functions_of_order * order];
  const std::vector<Eigen::MatrixXd> by = derivatives(c, x);
  const Eigen::MatrixXd residual = matrix(c) * x;
  const Eigen::Index entries = residual.size();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(entries, coefficients());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(entries);
  for (Eigen::Index i = 0; i < rows(); ++i) {
    if (points_[i].order != order) continue;
    for (Eigen::Index d = 0; d < x.cols(); ++d) {
      right(i * x.cols() + d) = -residual(i, d);
      for (int k = first; k < last; ++k) all(i * x.cols() + d, k) = by[k](i, d);
    }
  }
  const Eigen::MatrixXd reduced = all * basis;
  return basis * linear::LeastSquares(reduced).solve(right);
}

Eigen::VectorXd Condition::fitted(const Eigen::MatrixXd& x, const Eigen::MatrixXd& basis,
                                  const Eigen::VectorXd& held, double smallest_alpha) const {
  Eigen::VectorXd c = held + fittedPart(x, basis, 1, held);
  const int alphas = degrees_[Alpha] + 1;
  if (c.head(alphas).minCoeff() < smallest_alpha) {
    c << c.head(alphas).cwiseMax(smallest_alpha), held.tail(held.size() - alphas);
    Eigen::MatrixXd others = basis;
    others.topRows(alphas).setZero();
    c += fittedPart(x, others, 1, c);
  }
  c += fittedPart(x, basis, 2, c);
  c += fittedPart(x, basis, 3, c);
  return c;
}

std::array<double, 2> Condition::crossSpeeds(const Eigen::MatrixXd& x) const {
  double p = 0, q = 0;
  for (const Point& point : points_) {
    const Eigen::MatrixXd fields = point.fields * local(point, x);
    p += fields.row(FieldPs).squaredNorm();
    q += fields.row(FieldQs).squaredNorm();
  }
  const auto number = static_cast<double>(points_.size());
  return {std::sqrt(p / number), std::sqrt(q / number)};
}

Eigen::MatrixXd Condition::normals(const Eigen::MatrixXd& x, bool of_b) const {
  const std::vector<double>& knots = unknowns_.a.knots;
  const int n = unknowns_.a.degree, steps = 4 * n;
  Eigen::MatrixXd result(static_cast<Eigen::Index>(unknowns_.count() - n) * (steps + 1), 3);
  Eigen::Index filled = 0;
  for (int span = n; span < unknowns_.count(); ++span) {
    if (knots[span] == knots[span + 1]) continue;
    for (int k = 0; k <= steps; ++k) {
      const Point point =
          pointAt(1, std::lerp(knots[span], knots[span + 1], k / (1.0 * steps)), span);
      const Eigen::MatrixXd fields = point.fields * local(point, x);
      // For homogeneous coordinates this is w^2 times the derivative of the point.
      const auto affine = [&](Field field) -> Eigen::Vector3d {
        if (x.cols() == 3) return fields.row(field).transpose();
        return fields(FieldP, 3) * fields.row(field).head<3>() -
               fields(field, 3) * fields.row(FieldP).head<3>();
      };
      result.row(filled++) = affine(of_b ? FieldQs : FieldPs).cross(affine(FieldPt)).transpose();
    }
  }
  return result.topRows(filled);
}

double Condition::largestDerivative(const Eigen::MatrixXd& x) const {
  double largest = 0;
  for (const Point& point : points_) {
    const Eigen::MatrixXd fields = point.fields * local(point, x);
    const Field derivative = termsOf(point.order).front().field;
    largest = std::max(largest, point.scale * fields.row(derivative).norm());
  }
  return largest;
}

}  // namespace seamwright::nearest
