// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The way of a network (docs/theory/surfaces.md S6):
//   plan        the kinds of vertices, and the forms of the connection functions that they need
//               (S6.1, S6.2): network_plan.cpp
//   parameters  the numbers that determine all these functions: network_parameters.cpp
//   start       their values that fit the given poles, and the directions in which they may move:
//               this file
//   projection  the nearest poles for given functions, and the step of the parameters that
//               decreases the move (S6.3): network_projection.cpp
#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/join/network/network_projection.hpp>
#include <seamwright/core/join/network/network_start.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::network {

namespace {

/// A seam whose connection functions are sought, and the given poles of its condition.
struct SoughtSeam {
  int index = 0;
  Condition condition;
  Eigen::MatrixXd x;
  bool stays = false;  ///< all these poles
};

std::vector<SoughtSeam> soughtSeams(const Network& network, const Unknowns& u, const Plan& plan) {
  std::vector<SoughtSeam> result;
  for (int i = 0; i < std::ssize(plan.seams); ++i) {
    if (!plan.seams[i].takes_part || network.seams[i].held) continue;
    Condition condition = naturalCondition(network, i, plan.seams[i].order);
    const std::vector<int> columns = columnsOf(u, network.seams[i], condition);
    result.push_back({.index = i,
                      .condition = std::move(condition),
                      .x = polesOf(u.target, columns),
                      .stays = staysWhole(u, columns)});
  }
  return result;
}

/// Sums over the seams of each line.
struct LineSums {
  explicit LineSums(int lines)
      : value(Eigen::VectorXd::Zero(lines)), weight(Eigen::VectorXd::Zero(lines)) {}
  void add(int line, double of_seam) {
    value(line) += of_seam;
    weight(line) += 1;
  }

  Eigen::VectorXd value, weight;
};

/// log(alpha / gamma) of lines, as sums over their seams. A line with seams that stay is stiff:
/// only these count, as their ratio cannot change.
struct LineRatios {
  LineSums sums;
  std::vector<bool> stiff;
};

LineRatios ratiosOf(const Plan& plan, const std::vector<SoughtSeam>& seams,
                    const std::vector<double>& ratios) {
  LineRatios result{.sums = LineSums(plan.lines), .stiff = std::vector<bool>(plan.lines)};
  LineSums of_stiff(plan.lines);
  for (std::size_t i = 0; i < seams.size(); ++i) {
    const SeamPlan& seam = plan.seams[seams[i].index];
    if (seam.line < 0) continue;
    result.sums.add(seam.line, seam.sense * ratios[i]);
    if (seams[i].stays) of_stiff.add(seam.line, seam.sense * ratios[i]);
  }
  for (int line = 0; line < plan.lines; ++line) {
    result.stiff[line] = of_stiff.weight(line) > 0;
    if (!result.stiff[line]) continue;
    result.sums.value(line) = of_stiff.value(line);
    result.sums.weight(line) = of_stiff.weight(line);
  }
  return result;
}

/// One row for each extraordinary vertex of constant ratios: the sum around it, which is zero.
Eigen::SparseMatrix<double> closingSums(const Plan& plan) {
  std::vector<Eigen::Triplet<double>> entries;
  int rows = 0;
  for (std::size_t v = 0; v < plan.vertices.size(); ++v) {
    const Vertex& vertex = plan.vertices[v];
    const bool constant = plan.sorts[v].sort == VertexSort::Extraordinary &&
                          std::ranges::all_of(vertex.spokes, [&](const Spoke& s) {
                            return plan.seams[s.seam].line >= 0;
                          });
    if (!constant) continue;
    for (const Spoke& spoke : vertex.spokes)
      entries.emplace_back(rows, plan.seams[spoke.seam].line,
                           plan.seams[spoke.seam].sense * (spoke.first ? 1.0 : -1.0));
    ++rows;
  }
  Eigen::SparseMatrix<double> closing(rows, plan.lines);
  closing.setFromTriplets(entries.begin(), entries.end());
  return closing;
}

/// The mean logarithms of lines, changed as little as possible so that they close around each
/// extraordinary vertex of constant ratios.
Eigen::MatrixXd closedRatios(const Plan& plan, const LineRatios& ratios) {
  const Eigen::SparseMatrix<double> closing = closingSums(plan);
  Eigen::VectorXd free_weight = ratios.sums.weight;
  for (int line = 0; line < plan.lines; ++line)
    if (ratios.stiff[line]) free_weight(line) = 0;
  OrderedFactors factors;
  return project(closing, free_weight, ratios.sums.value.cwiseQuotient(ratios.sums.weight), factors)
      .x;
}

/// The tangents at extraordinary vertices, and the ratios of lines and of ends.
Eigen::VectorXd tangentsAndRatios(const Plan& plan, const Parameters& parameters,
                                  const std::vector<SoughtSeam>& seams,
                                  const std::vector<double>& ratios,
                                  const LineRatios& line_ratios) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(parameters.count);
  for (std::size_t v = 0; v < plan.vertices.size(); ++v)
    if (parameters.extraordinary[v] >= 0)
      y.segment(parameters.extraordinary[v], plan.sorts[v].rays.size()) =
          plan.sorts[v].rays.reshaped();
  for (std::size_t i = 0; i < seams.size(); ++i)
    for (const int slot : parameters.of_seam[seams[i].index].end_ratio)
      if (slot >= 0) y(slot) = ratios[i];
  const Eigen::MatrixXd closed = closedRatios(plan, line_ratios);
  for (int line = 0; line < plan.lines; ++line) y(parameters.ratio[line]) = closed(line, 0);
  return withoutExcess(plan, parameters, std::move(y));
}

/// The connection of a seam whose beta fits best, if beta has parameters, and whose p and q do so
/// for order 2. At an end that is an extraordinary vertex beta is given; the other end's value fits
/// best with it.
ConnectionFunctions fitted(const SoughtSeam& seam, const SeamPlan& plan, const SeamSlots& slots,
                           ConnectionFunctions connection) {
  if (slots.tied >= 0 || slots.bulge >= 0 || slots.beta[0] >= 0 || slots.beta[1] >= 0)
    connection = seam.condition.fitted(std::move(connection), 1, {Beta}, seam.x);
  if (plan.order == 1) return connection;
  return seam.condition.fitted(std::move(connection), 2, {P, Q}, seam.x);
}

/// \returns the parameters with the values of beta and q at ends set.
Eigen::VectorXd withEndValues(Eigen::VectorXd y, const SeamPlan& plan, const SeamSlots& slots,
                              const ConnectionFunctions& fit) {
  const Eigen::VectorXd& beta = fit.beta;
  if (slots.tied >= 0)  // half of the sum over the two seams of the line
    y(slots.tied) += (plan.ends[0].sort == VertexSort::Regular ? beta(1) : -beta(0)) / 2;
  for (int end = 0; end < 2; ++end) {
    if (slots.beta[end] >= 0) y(slots.beta[end]) = beta(end * (beta.size() - 1));
    if (slots.q[end] >= 0) y(slots.q[end]) = fit.q(end);
  }
  if (slots.bulge >= 0) y(slots.bulge) = beta(1) - (beta(0) + beta(2)) / 2;
  return y;
}

/// Conditions on the coordinates of an extraordinary vertex's rays that move steps must satisfy:
/// the ratios stay, the rays that stay do, and no step is a linear map of all rays, since that does
/// not change the connection functions. With the rays r_i of the start, all of them r, and their
/// steps s_i, the steps are the kernel of
///
///     [ |r| J   ]   J: derivative of the excess of the ratios
///     [ R / |r| ]   4 rows: the sum over i of r_i(d) s_i(c), for coordinates c and d
///     [ S       ]   a unit row for each coordinate of a ray that stays, otherwise a zero row
///
/// The factors |r| give all blocks the same scale, whatever the length of the rays is.
Eigen::MatrixXd rayConditions(const Plan& plan, const Parameters& parameters, int vertex,
                              const Eigen::VectorXd& start) {
  const auto& stays = plan.sorts[vertex].stays;
  const auto coordinates = static_cast<Eigen::Index>(2 * stays.size());
  Eigen::MatrixXd conditions = excessDerivative(plan, parameters, vertex, start);
  const Eigen::Index ratios = conditions.rows();
  constexpr Eigen::Index linear_maps = 4;  // of the plane
  conditions.conservativeResizeLike(
      Eigen::MatrixXd::Zero(ratios + linear_maps + coordinates, coordinates));
  const Eigen::VectorXd rays = start.segment(parameters.extraordinary[vertex], coordinates);
  for (Eigen::Index k = 0; k < coordinates; ++k) {
    conditions(ratios + 2 * (k % 2), k) = rays(2 * (k / 2)) / rays.norm();
    conditions(ratios + 2 * (k % 2) + 1, k) = rays(2 * (k / 2) + 1) / rays.norm();
    if (stays[k / 2]) conditions(ratios + linear_maps + k, k) = 1;
  }
  conditions.topRows(ratios) *= rays.norm();
  return conditions;
}

}  // namespace

Eigen::VectorXd startOf(const Network& network, const Unknowns& unknowns, const Plan& plan,
                        const Parameters& parameters) {
  const std::vector<SoughtSeam> seams = soughtSeams(network, unknowns, plan);
  std::vector<double> ratios;
  for (const SoughtSeam& seam : seams) ratios.push_back(std::log(seam.condition.ratio(seam.x)));
  const LineRatios line_ratios = ratiosOf(plan, seams, ratios);
  Eigen::VectorXd y = tangentsAndRatios(plan, parameters, seams, ratios, line_ratios);

  // On a stiff line p / alpha is that of the seams that stay. The others need a weight too, as
  // those that stay may have order 1 and no p.
  constexpr double of_stiff_line = 1e-9;
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(plan.lines), weights = shares;
  for (const SoughtSeam& seam : seams) {
    const SeamPlan& form = plan.seams[seam.index];
    const SeamSlots& slots = parameters.of_seam[seam.index];
    const ConnectionFunctions fit =
        fitted(seam, form, slots, connectionAt(network, plan, parameters, seam.index, y));
    y = withEndValues(std::move(y), form, slots, fit);
    if (form.order == 1) continue;
    const double weight = !seam.stays && line_ratios.stiff[form.line] ? of_stiff_line : 1;
    shares(form.line) += weight * fit.p(0) / fit.alpha(0);
    weights(form.line) += weight;
  }
  for (int line = 0; line < plan.lines; ++line)
    if (parameters.share[line] >= 0) y(parameters.share[line]) = shares(line) / weights(line);
  return y;
}

Eigen::SparseMatrix<double> freeDirections(const Plan& plan, const Parameters& parameters,
                                           const Eigen::VectorXd& start) {
  std::vector<Eigen::Triplet<double>> entries;
  int count = 0;
  std::vector<bool> of_extraordinary(start.size(), false), held(start.size(), false);
  for (int v = 0; v < std::ssize(plan.vertices); ++v) {
    const int first = parameters.extraordinary[v];
    if (first < 0) continue;
    for (const Spoke& spoke : plan.vertices[v].spokes)
      if (plan.seams[spoke.seam].line >= 0)
        held[parameters.ratio[plan.seams[spoke.seam].line]] = true;
    const Eigen::MatrixXd kernel =
        linear::kernel(rayConditions(plan, parameters, v, start), least_pivot);
    std::fill_n(of_extraordinary.begin() + first, kernel.rows(), true);
    for (Eigen::Index i = 0; i < kernel.cols(); ++i, ++count)
      for (Eigen::Index k = 0; k < kernel.rows(); ++k)
        entries.emplace_back(first + k, count, kernel(k, i));
  }
  for (Eigen::Index k = 0; k < start.size(); ++k)
    if (!of_extraordinary[k] && !held[k]) entries.emplace_back(k, count++, 1.0);
  Eigen::SparseMatrix<double> directions(start.size(), count);
  directions.setFromTriplets(entries.begin(), entries.end());
  return directions;
}

}  // namespace seamwright::network
