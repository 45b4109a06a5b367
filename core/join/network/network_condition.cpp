// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/bspline/basis.hpp>
#include <seamwright/core/join/network/network_condition.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::network {

namespace {

double valueOf(const Eigen::VectorXd& function, double t) {
  return nearest::bernsteinValues(static_cast<int>(function.size()) - 1, t).dot(function);
}

/// Degree of the condition of that order; \p n that of the rows.
int conditionDegree(int order, int n, const SeamLaw& law) {
  std::array<int, law_functions> degree{};
  const auto all = functions(law);
  for (int f = 0; f < law_functions; ++f)
    degree[f] = isZero(*all[f]) ? -n : static_cast<int>(all[f]->size()) - 1;
  if (order == 1) return std::max({n + degree[C], n + degree[D], n - 1 + degree[E]});
  return std::max({n + 2 * degree[C], n + 2 * degree[D], n - 1 + degree[D] + degree[E],
                   n - 2 + 2 * degree[E], n + degree[P], n - 1 + degree[Q]});
}

}  // namespace

std::array<Eigen::VectorXd*, law_functions> functions(SeamLaw& law) {
  return {&law.c, &law.d, &law.e, &law.p, &law.q};
}

std::array<const Eigen::VectorXd*, law_functions> functions(const SeamLaw& law) {
  return {&law.c, &law.d, &law.e, &law.p, &law.q};
}

bool isZero(const Eigen::VectorXd& function) {
  return (function.array() == 0).all();
}

Condition::Condition(nearest::SeamRows a, nearest::SeamRows b, int order, const SeamLaw& law)
    : a_(std::move(a)), b_(std::move(b)), width_(a_.degree + 1) {
  const std::vector<double> inner(a_.knots.begin() + a_.degree + 1, a_.knots.end() - a_.degree - 1);
  const bool smooth = isZero(law.e) && isZero(law.q);
  for (int k = 1; k <= order; ++k) {
    const int degree = conditionDegree(k, a_.degree, law);
    for (const nearest::Place& place :
         nearest::places(a_.degree, a_.knots, k, degree, smooth ? inner : std::vector<double>{}))
      points_.push_back(pointAt(k, place.t, place.span));
  }
}

Eigen::Index Condition::columns() const {
  return static_cast<Eigen::Index>(blocks()) * a_.count;
}

Condition::Point Condition::pointAt(int order, double t, int span) const {
  const Eigen::MatrixXd basis = bspline::basisDerivatives(a_.degree, a_.knots, span, t, 2);
  Point point;
  point.order = order;
  point.t = t;
  point.first = span - a_.degree;
  point.fields = Eigen::MatrixXd::Zero(field_count, static_cast<Eigen::Index>(blocks()) * width_);
  const auto set = [&](Field field, int block, double factor, int derivative) {
    point.fields.row(field).segment(static_cast<Eigen::Index>(block) * width_, width_) +=
        factor * basis.row(derivative);
  };
  set(FieldPt, 0, 1, 1);
  set(FieldPtt, 0, 1, 2);
  for (int row = 0; row <= a_.depth; ++row) {
    set(FieldPs, row, -a_.across(1, row), 0);
    set(FieldPst, row, -a_.across(1, row), 1);
    set(FieldPss, row, a_.across(2, row), 0);
  }
  for (int row = 0; row <= b_.depth; ++row) {
    const int block = row == 0 ? 0 : a_.depth + row;
    set(FieldQs, block, b_.across(1, row), 0);
    set(FieldQss, block, b_.across(2, row), 0);
  }
  point.scale = 1 / std::max({std::abs(a_.across(order, order)), std::abs(b_.across(order, order)),
                              std::abs(a_.across(1, 1)), std::abs(b_.across(1, 1))});
  return point;
}

Condition::Values Condition::values(const SeamLaw& law, double t) {
  Values result{};
  const auto all = functions(law);
  for (int f = 0; f < law_functions; ++f) result[f] = valueOf(*all[f], t);
  return result;
}

Condition::Combination Condition::combination(int order, const Values& f) {
  Combination w = Combination::Zero();
  if (order == 1) {
    w(FieldQs) = f[C];
    w(FieldPs) = -f[D];
    w(FieldPt) = -f[E];
    return w;
  }
  w(FieldQss) = f[C] * f[C];
  w(FieldPss) = -f[D] * f[D];
  w(FieldPst) = -2 * f[D] * f[E];
  w(FieldPtt) = -f[E] * f[E];
  w(FieldPs) = -f[P];
  w(FieldPt) = -f[Q];
  return w;
}

Condition::Combination Condition::derivative(int order, const Values& f, const Values& by) {
  if (order == 1) return combination(1, by);
  Combination w = Combination::Zero();
  w(FieldQss) = 2 * f[C] * by[C];
  w(FieldPss) = -2 * f[D] * by[D];
  w(FieldPst) = -2 * (f[D] * by[E] + f[E] * by[D]);
  w(FieldPtt) = -2 * f[E] * by[E];
  w(FieldPs) = -by[P];
  w(FieldPt) = -by[Q];
  return w;
}

Eigen::MatrixXd Condition::fieldsAt(const Point& point, const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd local(point.fields.cols(), x.cols());
  for (int block = 0; block < blocks(); ++block)
    local.middleRows(static_cast<Eigen::Index>(block) * width_, width_) =
        x.middleRows(static_cast<Eigen::Index>(block) * a_.count + point.first, width_);
  return point.fields * local;
}

Eigen::MatrixXd Condition::matrix(const SeamLaw& law) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows(), columns());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    const Eigen::RowVectorXd row =
        point.scale * combination(point.order, values(law, point.t)).transpose() * point.fields;
    for (int block = 0; block < blocks(); ++block)
      result.row(i).segment(static_cast<Eigen::Index>(block) * a_.count + point.first, width_) =
          row.segment(static_cast<Eigen::Index>(block) * width_, width_);
  }
  return result;
}

Eigen::MatrixXd Condition::change(const SeamLaw& law, const SeamLaw& direction,
                                  const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd result(rows(), x.cols());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    const Combination w = derivative(point.order, values(law, point.t), values(direction, point.t));
    result.row(i) = point.scale * w.transpose() * fieldsAt(point, x);
  }
  return result;
}

double Condition::residual(const SeamLaw& law, const Eigen::MatrixXd& x) const {
  std::array<double, 3> worst{}, largest{};
  for (const Point& point : points_) {
    const Eigen::MatrixXd fields = fieldsAt(point, x);
    const Values f = values(law, point.t);
    const double derivative = point.order == 1 ? f[C] * fields.row(FieldQs).norm()
                                               : f[C] * f[C] * fields.row(FieldQss).norm() +
                                                     f[C] * f[C] * fields.row(FieldQs).norm();
    largest[point.order] = std::max(largest[point.order], derivative);
    worst[point.order] =
        std::max(worst[point.order], (combination(point.order, f).transpose() * fields).norm());
  }
  const double first = worst[1] / largest[1];
  return largest[2] > 0 ? std::max(first, worst[2] / largest[2]) : first;
}

double Condition::ratio(const Eigen::MatrixXd& x) const {
  return std::sqrt(normals(1, x).squaredNorm() / normals(0, x).squaredNorm());
}

SeamLaw Condition::fitted(SeamLaw law, int order, const std::vector<Function>& sought,
                          const Eigen::MatrixXd& x) const {
  SeamLaw zero = law;
  for (Eigen::VectorXd* f : functions(zero)) f->setZero();
  Eigen::Index count = 0;
  for (const Function f : sought) {
    functions(law)[f]->setZero();
    count += functions(law)[f]->size();
  }
  const auto ofOrder = [&](Eigen::MatrixXd values) -> Eigen::VectorXd {
    for (Eigen::Index i = 0; i < rows(); ++i)
      if (points_[i].order != order) values.row(i).setZero();
    return values.reshaped();
  };
  Eigen::MatrixXd by(rows() * x.cols(), count);
  Eigen::Index column = 0;
  for (const Function f : sought)
    for (Eigen::Index k = 0; k < functions(law)[f]->size(); ++k) {
      SeamLaw unit = zero;
      (*functions(unit)[f])(k) = 1;
      by.col(column++) = ofOrder(change(law, unit, x));
    }
  const Eigen::VectorXd found = linear::LeastSquares(by).solve(-ofOrder(matrix(law) * x));
  column = 0;
  for (const Function f : sought) {
    Eigen::VectorXd& function = *functions(law)[f];
    function = found.segment(column, function.size());
    column += function.size();
  }
  return law;
}

SeamLaw Condition::closest(int degree, const Eigen::MatrixXd& x) const {
  SeamLaw zero;
  zero.c = zero.d = Eigen::VectorXd::Zero(degree + 1);
  zero.e = Eigen::VectorXd::Zero(degree + 2);
  zero.p = Eigen::VectorXd::Zero(2 * degree + 1);
  zero.q = Eigen::VectorXd::Zero(2 * degree + 2);
  // Of order 1 the law is linear and homogeneous: the singular vector of the least singular value,
  // in comparable units.
  std::vector<Eigen::VectorXd> columns;
  for (const Function f : {C, D, E})
    for (Eigen::Index k = 0; k < functions(zero)[f]->size(); ++k) {
      SeamLaw unit = zero;
      (*functions(unit)[f])(k) = 1;
      Eigen::MatrixXd values = change(zero, unit, x);
      for (Eigen::Index i = 0; i < rows(); ++i)
        if (points_[i].order != 1) values.row(i).setZero();
      columns.emplace_back(values.reshaped());
    }
  Eigen::MatrixXd by(rows() * x.cols(), std::ssize(columns));
  for (Eigen::Index k = 0; k < by.cols(); ++k) by.col(k) = columns[k];
  const Eigen::VectorXd unit = by.colwise().norm().transpose().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd v = linear::singularValues(by * unit.asDiagonal(), Eigen::ComputeThinV).v;
  Eigen::VectorXd found = unit.cwiseProduct(v.rightCols(1).col(0));
  const double sum = found.head(2 * degree + 2).sum();
  if (sum != 0) found *= 2 * (degree + 1) / sum;
  SeamLaw law = zero;
  law.c = found.head(degree + 1);
  law.d = found.segment(degree + 1, degree + 1);
  law.e = found.tail(degree + 2);
  return points_.back().order == 2 ? fitted(law, 2, {P, Q}, x) : law;
}

Eigen::MatrixXd Condition::normals(int side, const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd result(rows(), 3);
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Eigen::MatrixXd fields = fieldsAt(points_[i], x);
    const Eigen::Vector3d across = fields.row(side == 0 ? FieldPs : FieldQs),
                          along = fields.row(FieldPt);
    result.row(i) = across.cross(along).transpose();
  }
  return result;
}

}  // namespace seamwright::network
