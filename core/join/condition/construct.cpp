// SPDX-License-Identifier: LGPL-2.1-or-later
#include <array>
#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/checked_connection.hpp>
#include <seamwright/core/join/condition/composition.hpp>
#include <seamwright/core/join/condition/construct.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;
using rows::Field;

/// The derivatives of the other patch by u at the seam, of orders 0 to \p order.
std::vector<Field<4>> beyond(const Ribbon& given, const ConnectionFunctions& connection,
                             int order) {
  for (const HomogeneousPoles* part : given.parts())
    if (part->rows() == 0 || !part->allFinite())
      throw std::invalid_argument("the given ribbon has a part that is empty or not finite");
  const ConnectionFunctions c = checked(connection);
  const std::vector<Field<4>> composed = composedDerivatives(given, c, order);
  std::vector<Field<4>> result;
  for (int k = 0; k <= order; ++k) result.push_back(scaledDerivative(composed, c, k));
  return result;
}

/// The field in that degree. \throws std::invalid_argument, with the defect, if the defect is more
/// than rounding.
Field<4> written(const Field<4>& field, int degree, double magnitude, const char* what) {
  const rows::Lowered<4> low = rows::lowered<4>(field, degree);
  const double noise =
      64 * std::numeric_limits<double>::epsilon() * (rows::degree(field) + 1) * magnitude;
  if (low.defect > noise)
    throw std::invalid_argument(
        std::string(what) + " has degree " + std::to_string(rows::degree(field)) +
        " and cannot be written in degree " + std::to_string(degree) + ": the defect is " +
        text(low.defect) + ", rounding " + text(noise));
  return low.field;
}

void requireLowestDegree(int degree, int lowest) {
  if (degree < lowest || degree > bernstein::kMaxDegree)
    throw std::invalid_argument("degree " + std::to_string(degree) + " is not within " +
                                std::to_string(lowest) + " to " +
                                std::to_string(bernstein::kMaxDegree));
}

void requireUsable(const JoinRows& rows) {
  for (std::size_t r = 0; r < rows.rows.size(); ++r) {
    if (!rows.rows[r].allFinite())
      throw std::invalid_argument("row " + std::to_string(r) +
                                  " has a pole that is not finite: the connection functions are "
                                  "too large");
    for (Eigen::Index k = 0; k < rows.rows[r].rows(); ++k)
      if (const double weight = rows.rows[r](k, 3); !(weight > 0))
        throw std::invalid_argument(
            "row " + std::to_string(r) + ", pole " + std::to_string(k) + " has weight " +
            text(weight) + ": it must be positive; " +
            (r == 0 ? "e0 controls it" : "e1 and, behind row 1, e2 and e3 control it"));
  }
}

/// The derivatives, by their order, divided by l (l - 1) ... for the differences of rows that they
/// are in degree l across. The k-th one is written in degree \p along - shrink k.
std::vector<HomogeneousPoles> differences(const std::vector<Field<4>>& derivatives, int l,
                                          int along, int shrink) {
  static constexpr std::array names = {"Q", "Q_s", "Q_ss", "Q_sss"};
  double magnitude = 0, factor = 1;
  for (const Field<4>& derivative : derivatives) magnitude += rows::size(derivative);
  std::vector<HomogeneousPoles> result;
  for (std::size_t k = 0; k < derivatives.size(); ++k) {
    const int order = static_cast<int>(k);
    result.emplace_back(written(derivatives[k], along - shrink * order, magnitude, names[k]) /
                        factor);
    factor *= l - order;
  }
  return result;
}

/// Row r with the given differences at the seam: those of an order above theirs are zero.
HomogeneousPoles rowOf(const std::vector<HomogeneousPoles>& differences, int r,
                       Eigen::Index poles) {
  const Eigen::VectorXd& binomials = bernstein::binomials(r);
  HomogeneousPoles row = differences[0].topRows(poles);
  for (int k = 1; k <= std::min(r, static_cast<int>(differences.size()) - 1); ++k)
    row += binomials(k) * differences[static_cast<std::size_t>(k)].topRows(poles);
  return row;
}

/// Rows 0..count - 1 of the Taylor polynomial of these derivatives by u, in degree l across.
JoinRows tensorRowsOf(const std::vector<Field<4>>& derivatives, int l, int count,
                      std::optional<int> degree) {
  requireLowestDegree(l, 1);
  int along = 0;
  for (const Field<4>& derivative : derivatives) along = std::max(along, rows::degree(derivative));
  requireLowestDegree(along = degree.value_or(along), 0);
  const std::vector<HomogeneousPoles> steps = differences(derivatives, l, along, 0);
  JoinRows result{{}, l};
  for (int r = 0; r < count; ++r) result.rows.push_back(rowOf(steps, r, along + 1));
  requireUsable(result);
  return result;
}

/// The same for a triangle of degree \p degree.
JoinRows triangleRowsOf(const std::vector<Field<4>>& derivatives, std::optional<int> count,
                        std::optional<int> degree) {
  int lowest = 1;
  for (std::size_t k = 0; k < derivatives.size(); ++k)
    lowest = std::max(lowest, rows::degree(derivatives[k]) + static_cast<int>(k));
  const int n = degree.value_or(lowest);
  requireLowestDegree(n, static_cast<int>(derivatives.size()) - 1);
  const std::vector<HomogeneousPoles> steps = differences(derivatives, n, n, 1);
  JoinRows result{{}, n};
  for (int r = 0; r < count.value_or(n + 1); ++r) result.rows.push_back(rowOf(steps, r, n + 1 - r));
  requireUsable(result);
  return result;
}

void requireOrder(int order) {
  if (order < 1 || order > 3)
    throw std::invalid_argument("order " + std::to_string(order) + ": known are 1, 2 and 3");
}

void requireOrder(int order, int degree_across) {
  requireOrder(order);
  if (order > degree_across)
    throw std::invalid_argument(
        "order " + std::to_string(order) +
        " needs a degree across of at least as much: " + std::to_string(degree_across));
}

HomogeneousPoles triangleNet(HomogeneousPoles net, TriangleEdge edge, bool reversed,
                             const JoinRows& rows) {
  const int n = rows.degree_across;
  for (int r = 0; r < static_cast<int>(rows.rows.size()); ++r)
    for (int k = 0; k <= n - r; ++k)
      net.row(poleRow(n, edge, reversed, r, k)) = rows.rows[r].row(k);
  return net;
}

BezierPatch patchOf(const std::vector<HomogeneousPoles>& rows) {
  const Eigen::Index columns = rows.front().rows();
  HomogeneousPoles net(static_cast<Eigen::Index>(rows.size()) * columns, 4);
  for (std::size_t i = 0; i < rows.size(); ++i)
    net.middleRows(static_cast<Eigen::Index>(i) * columns, columns) = rows[i];
  return {static_cast<int>(rows.size()) - 1, static_cast<int>(columns) - 1, affinePoles(net),
          net.col(3)};
}

/// All rows of a net, counted along u, in a degree along v that is no lower.
std::vector<HomogeneousPoles> rowsOf(const BezierPatch& patch, int degree) {
  std::vector<HomogeneousPoles> result;
  const int columns = patch.degreeV() + 1;
  for (int i = 0; i <= patch.degreeU(); ++i)
    result.push_back(rows::elevated<4>(
        patch.homogeneousPoles().middleRows(static_cast<Eigen::Index>(i) * columns, columns),
        degree));
  return result;
}

}  // namespace

JoinRows tensorRows(const Ribbon& given, const ConnectionFunctions& connection, int order,
                    int degree_across, std::optional<int> degree) {
  requireOrder(order, degree_across);
  return tensorRowsOf(beyond(given, connection, order), degree_across, order + 1, degree);
}

BezierPatch continuation(const Ribbon& given, const ConnectionFunctions& connection, int order,
                         int degree_across, std::optional<int> degree) {
  requireOrder(order, degree_across);
  return patchOf(
      tensorRowsOf(beyond(given, connection, order), degree_across, degree_across + 1, degree)
          .rows);
}

JoinRows triangleRows(const Ribbon& given, const ConnectionFunctions& connection, int order,
                      std::optional<int> degree) {
  requireOrder(order);
  return triangleRowsOf(beyond(given, connection, order), order + 1, degree);
}

BezierTriangle triangleContinuation(const Ribbon& given, const ConnectionFunctions& connection,
                                    int order, std::optional<int> degree) {
  requireOrder(order);
  const JoinRows all = triangleRowsOf(beyond(given, connection, order), std::nullopt, degree);
  const int n = all.degree_across;
  const HomogeneousPoles net =
      triangleNet(HomogeneousPoles((n + 1) * (n + 2) / 2, 4), TriangleEdge::L0, false, all);
  return {affinePoles(net), net.col(3)};
}

BezierPatch blend(const Ribbon& first, const ConnectionFunctions& to_first, const Ribbon& second,
                  const ConnectionFunctions& to_second, int order) {
  const int degree = 2 * order + 1;
  std::vector<HomogeneousPoles> net = tensorRows(first, to_first, order, degree).rows;
  const std::vector<HomogeneousPoles> far = tensorRows(second, to_second, order, degree).rows;
  net.insert(net.end(), far.rbegin(), far.rend());
  const int along = std::max(rows::degree(net.front()), rows::degree(net.back()));
  for (HomogeneousPoles& row : net) row = rows::elevated<4>(row, along);
  return patchOf(net);
}

BezierPatch withRows(const BezierPatch& patch, PatchEdge edge, bool reversed,
                     const JoinRows& rows) {
  const BezierPatch turned = turnedToU0(patch, edge, reversed);
  if (rows.rows.empty() || rows.degree_across != turned.degreeU() ||
      static_cast<int>(rows.rows.size()) > turned.degreeU() + 1)
    throw std::invalid_argument(
        std::to_string(rows.rows.size()) + " rows for degree " +
        std::to_string(rows.degree_across) + " across, the patch has degree " +
        std::to_string(turned.degreeU()) + ": the degrees must be the same");
  const int along = std::max(turned.degreeV(), rows::degree(rows.rows.front()));
  std::vector<HomogeneousPoles> net = rowsOf(turned, along);
  for (std::size_t r = 0; r < rows.rows.size(); ++r)
    net[r] = rows::elevated<4>(rows.rows[r], along);
  return turnedFromU0(patchOf(net), edge, reversed);
}

BezierTriangle withRows(const BezierTriangle& triangle, TriangleEdge edge, bool reversed,
                        const JoinRows& rows) {
  if (rows.degree_across < triangle.degree())
    throw std::invalid_argument("rows for a triangle of degree " +
                                std::to_string(rows.degree_across) + ", the triangle has degree " +
                                std::to_string(triangle.degree()) +
                                ": the rows must be built in its degree");
  requireLowestDegree(rows.degree_across, triangle.degree());
  BezierTriangle raised = triangle;
  while (raised.degree() < rows.degree_across) raised = raised.elevated();
  const HomogeneousPoles net = triangleNet(raised.homogeneousPoles(), edge, reversed, rows);
  return {affinePoles(net), net.col(3)};
}

}  // namespace seamwright
