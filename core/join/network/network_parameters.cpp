// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/join/network/network_parameters.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::network {

namespace {

using BetaForm = SeamPlan::BetaForm;

bool hasThreeCoefficients(BetaForm form) {
  return form == BetaForm::Quadratic || form == BetaForm::Double;
}

double determinant(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// gamma, alpha, beta of an extraordinary vertex at the end of a seam whose side 0 is the corner
/// before its spoke; gamma and alpha are exchanged if side 0 is the corner after the spoke.
Eigen::Vector3d extraordinaryValues(const Plan& plan, const Parameters& parameters, int vertex,
                                    int spoke, const Eigen::VectorXd& y) {
  const auto count = static_cast<int>(plan.vertices[vertex].spokes.size());
  const auto ray = [&](int k) -> Eigen::Vector2d {
    return y.segment<2>(parameters.extraordinary[vertex] + 2L * (k % count));
  };
  const Eigen::Vector2d before = ray(spoke + count - 1), own = ray(spoke), after = ray(spoke + 1);
  const double gamma = determinant(before, own), alpha = determinant(own, after),
               beta = determinant(before, after);
  return 2 * Eigen::Vector3d(gamma, alpha, beta) / (gamma + alpha);
}

Eigen::VectorXd excess(const Plan& plan, const Parameters& parameters, int vertex,
                       const Eigen::VectorXd& y) {
  const Vertex& of = plan.vertices[vertex];
  std::vector<double> result;
  for (std::size_t i = 0; i < of.spokes.size(); ++i) {
    const SeamPlan& seam = plan.seams[of.spokes[i].seam];
    if (seam.line < 0) continue;
    const Eigen::Vector3d values =
        extraordinaryValues(plan, parameters, vertex, static_cast<int>(i), y);
    const double of_line =
        seam.sense * (of.spokes[i].first ? 1 : -1) * y(parameters.ratio[seam.line]);
    result.push_back(std::log(values(1) / values(0)) - of_line);
  }
  return Eigen::Map<Eigen::VectorXd>(result.data(), std::ssize(result));
}

/// Newton's method for the rays of one vertex.
Eigen::VectorXd withoutExcessAt(const Plan& plan, const Parameters& parameters, int vertex,
                                Eigen::VectorXd y) {
  // It converges quadratically, in a handful of steps, or stops because the excess does not fall.
  constexpr int max_steps = 20;
  // Logarithms of ratios near 1 have rounding above this.
  constexpr double rounding = 1e-16;
  double size = excess(plan, parameters, vertex, y).norm();
  for (int k = 0; k < max_steps && size > rounding; ++k) {
    const Eigen::MatrixXd by = excessDerivative(plan, parameters, vertex, y);
    // The ratios around a vertex have the product 1: one of them follows from the others.
    const linear::LeastSquares inverse(by, least_pivot);
    Eigen::VectorXd trial = y;
    trial.segment(parameters.extraordinary[vertex], by.cols()) -=
        inverse.solve(excess(plan, parameters, vertex, y));
    const double next = excess(plan, parameters, vertex, trial).norm();
    if (!(next < size)) break;
    y = trial;
    size = next;
  }
  return y;
}

/// Hands out indices of y.
class Numbers {
 public:
  int next(int size = 1) { return std::exchange(count_, count_ + size); }
  int count() const { return count_; }

 private:
  int count_ = 0;
};

/// The parameters of one seam that its ends and its line do not have yet.
void addSeam(const Plan& plan, int index, Numbers& numbers, Parameters& parameters) {
  const SeamPlan& seam = plan.seams[index];
  SeamSlots& slots = parameters.of_seam[index];
  std::vector<int>& all = parameters.all_of_seam[index];
  const auto add = [&](int& slot) { all.push_back(slot = numbers.next()); };
  const auto addOfLine = [&](int& slot, int& of_line) {
    if (of_line < 0) of_line = numbers.next();
    all.push_back(slot = of_line);
  };
  if (seam.line >= 0) addOfLine(slots.ratio, parameters.ratio[seam.line]);
  if (seam.line >= 0 && seam.order == 2) addOfLine(slots.share, parameters.share[seam.line]);
  if (seam.beta == BetaForm::Tied) addOfLine(slots.tied, parameters.tied[seam.line]);
  if (seam.beta == BetaForm::Quadratic) add(slots.bulge);
  for (int end = 0; end < 2; ++end) {
    const SeamPlan::End& at = seam.ends[end];
    if (at.sort == VertexSort::Extraordinary) {
      const int begin = parameters.extraordinary[at.vertex];
      for (std::size_t k = 0; k < 2 * plan.vertices[at.vertex].spokes.size(); ++k)
        all.push_back(begin + static_cast<int>(k));
      continue;
    }
    if (seam.linear) add(slots.end_ratio[end]);
    if (seam.beta == BetaForm::Linear || seam.beta == BetaForm::Quadratic) add(slots.beta[end]);
    if (seam.beta == BetaForm::Linear && seam.order == 2) add(slots.q[end]);
  }
}

}  // namespace

Parameters parametersOf(const Network& network, const Plan& plan) {
  Numbers numbers;
  Parameters result;
  result.of_seam.resize(plan.seams.size());
  result.all_of_seam.resize(plan.seams.size());
  result.extraordinary.assign(plan.vertices.size(), -1);
  result.ratio.assign(plan.lines, -1);
  result.share.assign(plan.lines, -1);
  result.tied.assign(plan.lines, -1);
  for (int& slot : result.ratio) slot = numbers.next();
  for (std::size_t v = 0; v < plan.vertices.size(); ++v)
    if (plan.sorts[v].sort == VertexSort::Extraordinary)
      result.extraordinary[v] = numbers.next(static_cast<int>(2 * plan.vertices[v].spokes.size()));
  for (int i = 0; i < std::ssize(plan.seams); ++i)
    if (plan.seams[i].takes_part && !network.seams[i].held) addSeam(plan, i, numbers, result);
  result.count = numbers.count();
  return result;
}

ConnectionFunctions connectionAt(const Network& network, const Plan& all,
                                 const Parameters& parameters, int seam, const Eigen::VectorXd& y) {
  if (network.seams[seam].held) return *network.seams[seam].held;
  const SeamPlan& plan = all.seams[seam];
  const SeamSlots& slots = parameters.of_seam[seam];
  ConnectionFunctions connection =
      plan.line >= 0 ? withRatio(std::exp(plan.sense * y(slots.ratio))) : ConnectionFunctions{};
  if (plan.linear) connection.gamma = connection.alpha = Eigen::VectorXd::Zero(2);
  if (plan.beta != BetaForm::Zero)
    connection.beta = Eigen::VectorXd::Zero(hasThreeCoefficients(plan.beta) ? 3 : 2);
  if (plan.order == 2 && plan.beta == BetaForm::Linear) connection.q = Eigen::VectorXd::Zero(2);
  for (int end = 0; end < 2; ++end) {
    const SeamPlan::End& at = plan.ends[end];
    const Eigen::Index last = end == 0 ? 0 : connection.beta.size() - 1;
    if (at.sort == VertexSort::Extraordinary) {
      Eigen::Vector3d values = extraordinaryValues(all, parameters, at.vertex, at.spoke, y);
      if (!all.vertices[at.vertex].spokes[at.spoke].first) std::swap(values(0), values(1));
      connection.beta(last) = end == 0 ? values(2) : -values(2);
      if (plan.linear) {
        connection.gamma(end) = values(0);
        connection.alpha(end) = values(1);
      }
      continue;
    }
    if (plan.linear) {
      const ConnectionFunctions here = withRatio(std::exp(y(slots.end_ratio[end])));
      connection.gamma(end) = here.gamma(0);
      connection.alpha(end) = here.alpha(0);
    }
    if (slots.beta[end] >= 0) connection.beta(last) = y(slots.beta[end]);
    if (slots.q[end] >= 0) connection.q(end) = y(slots.q[end]);
  }
  if (slots.tied >= 0) {
    const bool begins = plan.ends[0].sort == VertexSort::Regular;
    connection.beta(begins ? 1 : 0) = begins ? y(slots.tied) : -y(slots.tied);
  }
  if (slots.bulge >= 0)
    connection.beta(1) = (connection.beta(0) + connection.beta(2)) / 2 + y(slots.bulge);
  if (slots.share >= 0) connection.p(0) = y(slots.share) * connection.alpha(0);
  return connection;
}

Eigen::MatrixXd excessDerivative(const Plan& plan, const Parameters& parameters, int vertex,
                                 const Eigen::VectorXd& y) {
  const auto& stays = plan.sorts[vertex].stays;
  const auto coordinates = static_cast<Eigen::Index>(2 * stays.size());
  Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(excess(plan, parameters, vertex, y).size(), coordinates);
  for (Eigen::Index k = 0; k < coordinates && result.rows() > 0; ++k) {
    if (stays[k / 2]) continue;
    const Eigen::Index slot = parameters.extraordinary[vertex] + k;
    const double h =
        difference_step * y.segment(parameters.extraordinary[vertex], coordinates).norm();
    Eigen::VectorXd above = y, below = y;
    above(slot) += h;
    below(slot) -= h;
    result.col(k) =
        (excess(plan, parameters, vertex, above) - excess(plan, parameters, vertex, below)) /
        (2 * h);
  }
  return result;
}

Eigen::VectorXd withoutExcess(const Plan& plan, const Parameters& parameters, Eigen::VectorXd y) {
  for (int v = 0; v < std::ssize(plan.vertices); ++v)
    if (parameters.extraordinary[v] >= 0) y = withoutExcessAt(plan, parameters, v, std::move(y));
  return y;
}

}  // namespace seamwright::network
