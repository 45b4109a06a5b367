// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include <seamwright/core/join/nearest/nearest_rows.hpp>

/// The condition of a join as a linear system of the poles, A(c) x = 0; not a public header.
namespace seamwright::nearest {

/// The connection functions, in the order of their coefficients in c: three for each order.
enum Function { Alpha, Beta, E1, P, Q, E2, H, K, E3, function_count };
inline constexpr int functions_of_order = 3;
/// The order of the condition in which a function appears first.
constexpr int orderOf(int function) {
  return function / functions_of_order + 1;
}
/// Beta, q and k: the factors of P_t.
constexpr bool isAlong(int function) {
  return function % functions_of_order == Beta;
}
/// E1, e2 and e3, of rational surfaces only.
constexpr bool isScaling(int function) {
  return function % functions_of_order == E1;
}

/// Degree of each function; -1 means that the function is zero.
using Degrees = std::array<int, function_count>;

/// The derivatives of both sides that the conditions are made of. P_s points out of a, Q_s into b.
enum Field {
  FieldP,
  FieldPt,
  FieldPtt,
  FieldPttt,
  FieldPs,
  FieldPst,
  FieldPstt,
  FieldPss,
  FieldPsst,
  FieldPsss,
  FieldQs,
  FieldQss,
  FieldQsss,
  field_count
};

/// A term of a condition: factor times the product of up to three functions times the field.
struct Term {
  double factor = 1;
  Field field = FieldP;
  std::array<int, 3> functions = {-1, -1, -1};  ///< -1: none
};

/// The terms of the condition of an order, 1 to 3. Q_s, Q_ss or Q_sss is the first one.
std::span<const Term> termsOf(int order);

/// Index in c at which the coefficients of each function begin; the last entry is the number of all
/// coefficients.
std::array<int, function_count + 1> offsets(const Degrees& degrees);

/// Values of the Bernstein polynomials of that degree at t; empty for degree -1.
Eigen::VectorXd bernsteinValues(int degree, double t);

/// A parameter of the seam, and the span of the rows that it belongs to.
struct SeamParameter {
  double t;
  int span;
};

/// Parameters that determine the left side of the condition of order \p order as a spline of degree
/// \p degree. The rows have degree \p n and the knots \p knots, with repetitions. At the inner
/// knots in \p vanishing the condition is as smooth as the rows.
std::vector<SeamParameter> determiningParameters(int n, const std::vector<double>& knots, int order,
                                                 int degree, const std::vector<double>& vanishing);

/// The conditions of order 1, and below it those of order 2 and 3, at points of the seam. The left
/// side is a spline, and the points are as many as determine it:
///   Q_s - e1 P - alpha P_s - beta P_t = 0
///   Q_ss - e2 P - (2 e1 alpha + p) P_s - (2 e1 beta + q) P_t
///        - alpha^2 P_ss - 2 alpha beta P_st - beta^2 P_tt = 0
/// and that of order 3 of ConnectionFunctions, with e0 = 1. P_s points out of a, Q_s into b. Each
/// row is divided by the coefficient of b's pole behind the seam. So a residual is a length that is
/// comparable to a move of that pole.
///
/// At a knot where the rows are of class C^r the condition of order k is of class C^(r-k), or C^r
/// if beta, q and k vanish there. A spline of degree d and that class is zero iff it is zero at its
/// Greville points (Schoenberg and Whitney). A polynomial of degree d is zero iff it is zero at d +
/// 1 points.
class Condition {
 public:
  /// \param vanishing the inner knots where beta, q and k are zero.
  Condition(const Unknowns& unknowns, int order, const Degrees& degrees,
            const std::vector<double>& vanishing);

  Eigen::Index rows() const { return static_cast<Eigen::Index>(points_.size()); }
  Eigen::Index columns() const { return columns_; }
  int coefficients() const { return offset_.back(); }
  const Degrees& degrees() const { return degrees_; }

  /// A(c).
  Eigen::MatrixXd matrix(const Eigen::VectorXd& c) const;
  /// dA/dc_i x for each coefficient.
  std::vector<Eigen::MatrixXd> derivatives(const Eigen::VectorXd& c,
                                           const Eigen::MatrixXd& x) const;
  /// (dA/dc_i)' nu for each coefficient.
  std::vector<Eigen::MatrixXd> transposed(const Eigen::VectorXd& c,
                                          const Eigen::MatrixXd& nu) const;
  /// <nu, d2A/dc_i dc_j x>.
  Eigen::MatrixXd curvature(const Eigen::VectorXd& c, const Eigen::MatrixXd& nu,
                            const Eigen::MatrixXd& x) const;
  /// The coefficients held + basis y that fit these poles best, condition by condition, with the
  /// coefficients of alpha at least \p smallest_alpha.
  /// Source: docs/theory/surfaces.md S2.5.
  Eigen::VectorXd fitted(const Eigen::MatrixXd& x, const Eigen::MatrixXd& basis,
                         const Eigen::VectorXd& held, double smallest_alpha) const;
  /// Root mean squares of |P_s| and of |Q_s| along the seam.
  std::array<double, 2> crossSpeeds(const Eigen::MatrixXd& x) const;
  /// Vectors along P_s x P_t (for b: Q_s x P_t) at evenly spaced parameters of each span, its ends
  /// included, one per row.
  Eigen::MatrixXd normals(const Eigen::MatrixXd& x, bool of_b) const;
  /// Largest derivative of Q across the seam of each order, divided by the factors of their rows.
  double largestDerivative(const Eigen::MatrixXd& x) const;

 private:
  using Combination = Eigen::Matrix<double, field_count, 1>;
  using Values = Eigen::Matrix<double, function_count, 1>;
  struct Point {
    int order = 1;
    double scale = 1;  ///< of the row
    int first = 0;     ///< first pole of the span
    std::array<Eigen::VectorXd, function_count> bernstein;
    Eigen::MatrixXd fields;  ///< field_count by the poles of the span, block after block
  };

  void addPoints(int order, const std::vector<double>& vanishing);
  Point pointAt(int order, double t, int span) const;
  Eigen::MatrixXd local(const Point& point, const Eigen::MatrixXd& x) const;
  Values values(const Point& point, const Eigen::VectorXd& c) const;
  static Combination combination(int order, const Values& f);
  static Combination derivative(int order, const Values& f, int function);
  static Combination secondDerivative(int order, const Values& f, int function, int other);
  Eigen::VectorXd fittedPart(const Eigen::MatrixXd& x, const Eigen::MatrixXd& basis, int order,
                             const Eigen::VectorXd& c) const;

  const Unknowns& unknowns_;
  Degrees degrees_;
  std::array<int, function_count + 1> offset_;
  int width_;  ///< poles of a span
  Eigen::Index columns_;
  std::vector<Point> points_;
};

}  // namespace seamwright::nearest
