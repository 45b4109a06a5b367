// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include <seamwright/core/join/nearest/nearest_condition.hpp>
#include <seamwright/core/join/network/network.hpp>

/// The equations of a seam as a linear system of the poles; not a public header.
namespace seamwright::network {

enum Function { Gamma, Alpha, Beta, P, Q, function_count };

/// The connection functions in the order of Function.
std::array<Eigen::VectorXd*, function_count> functions(ConnectionFunctions& connection);
std::array<const Eigen::VectorXd*, function_count> functions(const ConnectionFunctions& connection);

/// Constant gamma and alpha whose quotient alpha / gamma is the ratio, with the sum 2; beta = 0.
ConnectionFunctions withRatio(double ratio);

bool isZero(const Eigen::VectorXd& function);

/// The equations of a join at points of the seam. Their left sides are splines, and the points are
/// as many as determine these splines. The unknowns are in blocks of one row of poles each: the
/// seam, the rows of side 0 behind it, then those of side 1. Each row is divided by the larger
/// coefficient of the two poles behind the seam. So a residual is a length that is comparable to a
/// move of one of these poles.
class Condition {
 public:
  /// \param shape has the degrees of all connection functions that will be used; if its beta or q
  /// is zero, that function stays zero.
  Condition(nearest::SeamRows a, nearest::SeamRows b, int order, const ConnectionFunctions& shape);

  Eigen::Index rows() const { return static_cast<Eigen::Index>(points_.size()); }
  Eigen::Index columns() const;
  const nearest::SeamRows& side(int k) const { return k == 0 ? a_ : b_; }

  /// A(connection).
  Eigen::MatrixXd matrix(const ConnectionFunctions& connection) const;
  /// The derivative of A(connection) x by the connection functions, in that direction.
  Eigen::MatrixXd change(const ConnectionFunctions& connection,
                         const ConnectionFunctions& direction, const Eigen::MatrixXd& x) const;
  /// Largest length of a row of A x, relative to the largest derivative in it.
  double residual(const ConnectionFunctions& connection, const Eigen::MatrixXd& x) const;

  /// Square root of the ratio of the two sides' squared normals. It is alpha / gamma if the
  /// sides join with a constant alpha / gamma.
  double ratio(const Eigen::MatrixXd& x) const;
  /// The connection with the functions \p sought replaced by those that fit the condition of order
  /// \p order best. The other functions stay.
  ConnectionFunctions fitted(ConnectionFunctions connection, int order,
                             const std::vector<Function>& sought, const Eigen::MatrixXd& x) const;
  /// The connection that fits best, with gamma and alpha of degree \p degree, beta of one degree
  /// more, and p, q of twice these degrees. The mean of gamma + alpha is 2.
  ConnectionFunctions closest(int degree, const Eigen::MatrixXd& x) const;
  /// Vectors along the normals of a side at the points, one per row. The vectors of both sides have
  /// the same direction if there is no fold.
  Eigen::MatrixXd normals(int side, const Eigen::MatrixXd& x) const;

 private:
  enum Field { FieldPt, FieldPtt, FieldPs, FieldPst, FieldPss, FieldQs, FieldQss, field_count };
  using Combination = Eigen::Matrix<double, field_count, 1>;
  using Values = std::array<double, function_count>;
  struct Point {
    int order = 1;
    double t = 0;
    double scale = 1;  ///< of the row
    int first = 0;     ///< first pole of the span
    Eigen::MatrixXd fields;
  };

  Point pointAt(int order, double t, int span) const;
  Eigen::MatrixXd fieldsAt(const Point& point, const Eigen::MatrixXd& x) const;
  static Values values(const ConnectionFunctions& connection, double t);
  static Combination combination(int order, const Values& f);
  static Combination derivative(int order, const Values& f, const Values& direction);
  int blocks() const { return 1 + a_.depth + b_.depth; }

  nearest::SeamRows a_, b_;
  int width_;
  std::vector<Point> points_;
};

}  // namespace seamwright::network
