// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seamwright/core/bernstein/polynomial.hpp>
#include <seamwright/core/bezier/homogeneous.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/join/checked_connection.hpp>
#include <seamwright/core/join/condition/construct.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;
using rows::Field;

void requireRibbon(const Ribbon& given) {
  for (const HomogeneousPoles* part : {&given.position, &given.first, &given.second})
    if (part->rows() == 0 || !part->allFinite())
      throw std::invalid_argument("the given ribbon has a part that is empty or not finite");
}

/// The ribbon of the other patch at the seam, into that patch. Each part has the lowest degree in
/// which its terms can be written.
Ribbon beyond(const Ribbon& given, const ConnectionFunctions& c, int order) {
  requireRibbon(given);
  const Field<4>&P = given.position, &P_s = given.first, &P_ss = given.second;
  const Field<4> P_t = rows::derivative<4>(P);
  const Field<4> first = rows::Sum<4>().add(c.alpha, P_s).add(c.beta, P_t).total();
  Ribbon result;
  result.position = rows::product<4>(c.e0, P);
  result.first = rows::Sum<4>().add(c.e1, P).add(c.e0, first).total();
  result.second = Field<4>::Zero(1, 4);
  if (order < 2) return result;
  const Field<4> second = rows::Sum<4>()
                              .add(rows::times(c.alpha, c.alpha), P_ss)
                              .add(2 * rows::times(c.alpha, c.beta), rows::derivative<4>(P_s))
                              .add(rows::times(c.beta, c.beta), rows::derivative<4>(P_t))
                              .add(c.p, P_s)
                              .add(c.q, P_t)
                              .total();
  result.second = rows::Sum<4>().add(c.e2, P).add(2 * c.e1, first).add(c.e0, second).total();
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
            (r == 0 ? "e0 controls it" : "e1 and, behind row 1, e2 control it"));
  }
}

/// Rows 0..count - 1 of the polynomial Q + u Q_u + u^2 Q_uu / 2 in degree l across.
JoinRows tensorRowsOf(const Ribbon& q, int order, int l, int count, std::optional<int> degree) {
  requireLowestDegree(l, 1);
  int along = std::max(rows::degree(q.position), rows::degree(q.first));
  if (order == 2) along = std::max(along, rows::degree(q.second));
  requireLowestDegree(along = degree.value_or(along), 0);
  const double magnitude = rows::size(q.position) + rows::size(q.first) + rows::size(q.second);
  const Field<4> position = written(q.position, along, magnitude, "Q"),
                 first = written(q.first, along, magnitude, "Q_s"),
                 second = written(q.second, along, magnitude, "Q_ss");
  JoinRows result{{}, l};
  for (int i = 0; i < count; ++i) {
    HomogeneousPoles row = position + static_cast<double>(i) / l * first;
    if (order == 2 && i >= 2)
      row += static_cast<double>(i * (i - 1)) / (2.0 * l * (l - 1)) * second;
    result.rows.push_back(std::move(row));
  }
  requireUsable(result);
  return result;
}

void requireOrder(int order, int degree_across) {
  if (order != 1 && order != 2)
    throw std::invalid_argument("order " + std::to_string(order) + ": known are 1 and 2");
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
  return tensorRowsOf(beyond(given, checked(connection), order), order, degree_across, order + 1,
                      degree);
}

BezierPatch continuation(const Ribbon& given, const ConnectionFunctions& connection, int order,
                         int degree_across, std::optional<int> degree) {
  requireOrder(order, degree_across);
  const Ribbon q = beyond(given, checked(connection), order);
  return patchOf(tensorRowsOf(q, order, degree_across, degree_across + 1, degree).rows);
}

JoinRows triangleRows(const Ribbon& given, const ConnectionFunctions& connection,
                      std::optional<int> degree) {
  const Ribbon q = beyond(given, checked(connection), 1);
  const int n = degree.value_or(std::max(rows::degree(q.position), rows::degree(q.first) + 1));
  requireLowestDegree(n, 1);
  const double magnitude = rows::size(q.position) + rows::size(q.first);
  const HomogeneousPoles seam = written(q.position, n, magnitude, "Q");
  const HomogeneousPoles next = seam.topRows(n) + written(q.first, n - 1, magnitude, "Q_s") / n;
  JoinRows result{{seam, next}, n};
  requireUsable(result);
  return result;
}

/// The pole (r, k) of Q(t) + s Q_s(t) is Q_k + r (next_k - Q_k): as a polynomial of (s, t), Q has
/// the poles Q_k in all rows.
BezierTriangle triangleContinuation(const Ribbon& given, const ConnectionFunctions& connection,
                                    std::optional<int> degree) {
  JoinRows all = triangleRows(given, connection, degree);
  const int n = all.degree_across;
  const HomogeneousPoles seam = all.rows[0], step = all.rows[1] - seam.topRows(n);
  for (int r = 2; r <= n; ++r)
    all.rows.emplace_back(seam.topRows(n + 1 - r) + r * step.topRows(n + 1 - r));
  requireUsable(all);
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
