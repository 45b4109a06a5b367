// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BSplCLib.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <math_Matrix.hxx>
#include <numbers>

#include <seamwright/occ_adapter/match/side_basis.hpp>

namespace seamwright::occ {

namespace {

/// Values and derivatives (a row each) of the basis functions that do not vanish at a parameter.
struct Basis {
  int first = 0;
  Eigen::MatrixXd values;
};

Basis basisAt(const std::vector<double>& flat_knots, int degree, double parameter,
              int derivatives) {
  TColStd_Array1OfReal knots(1, static_cast<int>(flat_knots.size()));
  std::ranges::copy(flat_knots, knots.begin());
  math_Matrix matrix(1, derivatives + 1, 1, degree + 1, 0.0);
  Basis basis;
  BSplCLib::EvalBsplineBasis(derivatives, degree + 1, knots, parameter, basis.first, matrix);
  --basis.first;
  basis.values.resize(derivatives + 1, degree + 1);
  for (int k = 0; k <= derivatives; ++k)
    for (int j = 0; j <= degree; ++j) basis.values(k, j) = matrix(k + 1, j + 1);
  return basis;
}

/// Derivatives across at the side; those above the degree are zero.
Eigen::MatrixXd acrossAtSide(const EdgeRows& rows) {
  const int degree = rows.degreeAcross(), known = std::min(degree, most_rows - 1);
  Eigen::MatrixXd across = Eigen::MatrixXd::Zero(most_rows, std::max(most_rows, degree + 1));
  across.topLeftCorner(known + 1, degree + 1) =
      basisAt(knotsFromSide(rows), degree, 0, known).values;
  return across;
}

}  // namespace

SideBasis::SideBasis(const EdgeRows& rows)
    : rows_(rows), along_(rows.knotsAlong()), across_(acrossAtSide(rows)) {}

Blend SideBasis::at(double t) const {
  const Basis basis = basisAt(along_, rows_.degreeAlong(), t, 0);
  const int rows = std::min(most_rows, rows_.rows());
  Blend blend{basis.first, {}};
  std::array<Eigen::MatrixXd, most_rows> weighted;
  std::array<double, most_rows> sum{};
  for (int k = 0; k < most_rows; ++k) {
    weighted[k] = Eigen::MatrixXd::Zero(most_rows, basis.values.cols());
    for (int r = 0; r < rows; ++r)
      for (int j = 0; j < basis.values.cols(); ++j)
        weighted[k](r, j) = across_(k, r) * basis.values(0, j) * rows_.weight(r, basis.first + j);
    sum[k] = weighted[k].sum();
  }
  // The derivatives of sum N w P / sum N w by the rule for quotients.
  blend.share[0] = weighted[0] / sum[0];
  blend.share[1] = (weighted[1] - sum[1] * blend.share[0]) / sum[0];
  blend.share[2] = (weighted[2] - 2 * sum[1] * blend.share[1] - sum[2] * blend.share[0]) / sum[0];
  return blend;
}

Eigen::Vector3d derivative(const EdgeRows& rows, const Blend& blend, int order) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int r = 0; r <= order; ++r)
    for (int j = 0; j < blend.share[order].cols(); ++j)
      sum += blend.share[order](r, j) * rows.pole(r, blend.first + j);
  return sum;
}

std::vector<double> knotsFromSide(const EdgeRows& rows) {
  std::vector<double> knots = rows.knotsAcross();
  const bool at_end = rows.edge() == PatchEdge::U1 || rows.edge() == PatchEdge::V1;
  if (at_end) std::ranges::reverse(knots);
  const double side = knots.front();
  for (double& knot : knots) knot = std::abs(knot - side);
  return knots;
}

std::vector<double> parametersInSpans(const std::vector<double>& knots, int per_span) {
  std::vector<double> t = {0};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (knots[i + 1] <= knots[i]) continue;
    for (int k = 1; k <= per_span; ++k)
      t.push_back(knots[i] +
                  (knots[i + 1] - knots[i]) *
                      (k == per_span ? 1 : (1 - std::cos(std::numbers::pi * k / per_span)) / 2));
  }
  return t;
}

}  // namespace seamwright::occ
