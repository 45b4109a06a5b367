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
int conditionDegree(int order, int n, const ConnectionFunctions& connection) {
  std::array<int, function_count> degree{};
  const auto all = functions(connection);
  for (int f = 0; f < function_count; ++f)
    degree[f] = isZero(*all[f]) ? -n : static_cast<int>(all[f]->size()) - 1;
  if (order == 1) return std::max({n + degree[Gamma], n + degree[Alpha], n - 1 + degree[Beta]});
  return std::max({n + 2 * degree[Gamma], n + 2 * degree[Alpha],
                   n - 1 + degree[Alpha] + degree[Beta], n - 2 + 2 * degree[Beta], n + degree[P],
                   n - 1 + degree[Q]});
}

}  // namespace

std::array<Eigen::VectorXd*, function_count> functions(ConnectionFunctions& connection) {
  return {&connection.gamma, &connection.alpha, &connection.beta, &connection.p, &connection.q};
}

std::array<const Eigen::VectorXd*, function_count> functions(
    const ConnectionFunctions& connection) {
  return {&connection.gamma, &connection.alpha, &connection.beta, &connection.p, &connection.q};
}

ConnectionFunctions withRatio(double ratio) {
  ConnectionFunctions connection;
  connection.gamma(0) = 2 / (1 + ratio);
  connection.alpha(0) = 2 * ratio / (1 + ratio);
  return connection;
}

bool isZero(const Eigen::VectorXd& function) {
  return (function.array() == 0).all();
}

Condition::Condition(nearest::SeamRows a, nearest::SeamRows b, int order,
                     const ConnectionFunctions& shape)
    : a_(std::move(a)), b_(std::move(b)), width_(a_.degree + 1) {
  const std::vector<double> inner(a_.knots.begin() + a_.degree + 1, a_.knots.end() - a_.degree - 1);
  const bool smooth = isZero(shape.beta) && isZero(shape.q);
  for (int k = 1; k <= order; ++k) {
    const int degree = conditionDegree(k, a_.degree, shape);
    for (const nearest::SeamParameter& parameter : nearest::determiningParameters(
             a_.degree, a_.knots, k, degree, smooth ? inner : std::vector<double>{}))
      points_.push_back(pointAt(k, parameter.t, parameter.span));
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

Condition::Values Condition::values(const ConnectionFunctions& connection, double t) {
  Values result{};
  const auto all = functions(connection);
  for (int f = 0; f < function_count; ++f) result[f] = valueOf(*all[f], t);
  return result;
}

Condition::Combination Condition::combination(int order, const Values& f) {
  Combination w = Combination::Zero();
  if (order == 1) {
    w(FieldQs) = f[Gamma];
    w(FieldPs) = -f[Alpha];
    w(FieldPt) = -f[Beta];
    return w;
  }
  w(FieldQss) = f[Gamma] * f[Gamma];
  w(FieldPss) = -f[Alpha] * f[Alpha];
  w(FieldPst) = -2 * f[Alpha] * f[Beta];
  w(FieldPtt) = -f[Beta] * f[Beta];
  w(FieldPs) = -f[P];
  w(FieldPt) = -f[Q];
  return w;
}

Condition::Combination Condition::derivative(int order, const Values& f, const Values& by) {
  if (order == 1) return combination(1, by);
  Combination w = Combination::Zero();
  w(FieldQss) = 2 * f[Gamma] * by[Gamma];
  w(FieldPss) = -2 * f[Alpha] * by[Alpha];
  w(FieldPst) = -2 * (f[Alpha] * by[Beta] + f[Beta] * by[Alpha]);
  w(FieldPtt) = -2 * f[Beta] * by[Beta];
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

Eigen::MatrixXd Condition::matrix(const ConnectionFunctions& connection) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows(), columns());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    const Eigen::RowVectorXd row =
        point.scale * combination(point.order, values(connection, point.t)).transpose() *
        point.fields;
    for (int block = 0; block < blocks(); ++block)
      result.row(i).segment(static_cast<Eigen::Index>(block) * a_.count + point.first, width_) =
          row.segment(static_cast<Eigen::Index>(block) * width_, width_);
  }
  return result;
}

Eigen::MatrixXd Condition::change(const ConnectionFunctions& connection,
                                  const ConnectionFunctions& direction,
                                  const Eigen::MatrixXd& x) const {
  Eigen::MatrixXd result(rows(), x.cols());
  for (Eigen::Index i = 0; i < rows(); ++i) {
    const Point& point = points_[i];
    const Combination w =
        derivative(point.order, values(connection, point.t), values(direction, point.t));
    result.row(i) = point.scale * w.transpose() * fieldsAt(point, x);
  }
  return result;
}

double Condition::residual(const ConnectionFunctions& connection, const Eigen::MatrixXd& x) const {
  std::array<double, 3> worst{}, largest{};
  for (const Point& point : points_) {
    const Eigen::MatrixXd fields = fieldsAt(point, x);
    const Values f = values(connection, point.t);
    const double derivative = point.order == 1
                                  ? f[Gamma] * fields.row(FieldQs).norm()
                                  : f[Gamma] * f[Gamma] * fields.row(FieldQss).norm() +
                                        f[Gamma] * f[Gamma] * fields.row(FieldQs).norm();
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

ConnectionFunctions Condition::fitted(ConnectionFunctions connection, int order,
                                      const std::vector<Function>& sought,
                                      const Eigen::MatrixXd& x) const {
  ConnectionFunctions zero = connection;
  for (Eigen::VectorXd* f : functions(zero)) f->setZero();
  Eigen::Index count = 0;
  for (const Function f : sought) {
    functions(connection)[f]->setZero();
    count += functions(connection)[f]->size();
  }
  const auto ofOrder = [&](Eigen::MatrixXd values) -> Eigen::VectorXd {
    for (Eigen::Index i = 0; i < rows(); ++i)
      if (points_[i].order != order) values.row(i).setZero();
    return values.reshaped();
  };
  Eigen::MatrixXd by(rows() * x.cols(), count);
  Eigen::Index column = 0;
  for (const Function f : sought)
    for (Eigen::Index k = 0; k < functions(connection)[f]->size(); ++k) {
      ConnectionFunctions unit = zero;
      (*functions(unit)[f])(k) = 1;
      by.col(column++) = ofOrder(change(connection, unit, x));
    }
  const Eigen::VectorXd found = linear::LeastSquares(by).solve(-ofOrder(matrix(connection) * x));
  column = 0;
  for (const Function f : sought) {
    Eigen::VectorXd& function = *functions(connection)[f];
    function = found.segment(column, function.size());
    column += function.size();
  }
  return connection;
}

ConnectionFunctions Condition::closest(int degree, const Eigen::MatrixXd& x) const {
  ConnectionFunctions zero;
  zero.gamma = zero.alpha = Eigen::VectorXd::Zero(degree + 1);
  zero.beta = Eigen::VectorXd::Zero(degree + 2);
  zero.p = Eigen::VectorXd::Zero(2 * degree + 1);
  zero.q = Eigen::VectorXd::Zero(2 * degree + 2);
  // The equations of order 1 are linear and homogeneous in the functions. The singular vector of
  // the least singular value, in comparable units, solves them best.
  std::vector<Eigen::VectorXd> columns;
  for (const Function f : {Gamma, Alpha, Beta})
    for (Eigen::Index k = 0; k < functions(zero)[f]->size(); ++k) {
      ConnectionFunctions unit = zero;
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
  ConnectionFunctions connection = zero;
  connection.gamma = found.head(degree + 1);
  connection.alpha = found.segment(degree + 1, degree + 1);
  connection.beta = found.tail(degree + 2);
  return points_.back().order == 2 ? fitted(connection, 2, {P, Q}, x) : connection;
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
