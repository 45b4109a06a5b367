// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/umbrella/spokes.hpp>
#include <stdexcept>
#include <string>

namespace seamwright::umbrella {

namespace {

using bernstein::text;

/// The factor n (n - 1) ... of a derivative of that order.
double falling(int n, int order) {
  double factor = 1;
  for (int k = 0; k < order; ++k) factor *= n - k;
  return factor;
}

/// The spokes with changed derivatives of that order at 0, and the same of lower order and the same
/// ends. A change of the size of rounding changes nothing.
std::vector<BezierCurve> withDerivatives(const std::vector<BezierCurve>& spokes, int order,
                                         const Eigen::Matrix3Xd& changes) {
  const int degree = spokes.front().degree(), n = std::max(order + 1, degree);
  double size = 0;
  for (const BezierCurve& spoke : spokes)
    size = std::max(size, spoke.poles().cwiseAbs().maxCoeff());
  const double noise = 64 * std::numeric_limits<double>::epsilon() * std::pow(degree, order) * size;
  if (changes.cwiseAbs().maxCoeff() <= noise) return spokes;
  std::vector<BezierCurve> result;
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    Poles poles = rows::elevated<3>(spokes[i].poles(), n);
    poles.row(order) += changes.col(static_cast<Eigen::Index>(i)).transpose() / falling(n, order);
    result.emplace_back(poles);
  }
  return result;
}

}  // namespace

std::vector<BezierCurve> fromOnePoint(const std::vector<BezierCurve>& curves, double gap_mm) {
  if (!(gap_mm >= 0) || !std::isfinite(gap_mm))
    refuse("gap_mm is " + text(gap_mm) + ": a finite number, 0 or more, is needed");
  if (curves.empty()) refuse("0 spokes: an umbrella has at least 3");
  int degree = 1;
  Eigen::RowVector3d from_first = Eigen::RowVector3d::Zero();
  double size = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string spoke = "spoke " + std::to_string(i) + " ";
    if (curves[i].isRational())
      refuse(spoke + "is rational: only polynomial ones are built around");
    if (curves[i].degree() < 1) refuse(spoke + "has degree 0: it is a point");
    degree = std::max(degree, curves[i].degree());
    from_first += curves[i].poles().row(0) - curves[0].poles().row(0);
    size = std::max(size, curves[i].poles().cwiseAbs().maxCoeff());
  }
  const Eigen::RowVector3d start =
      curves[0].poles().row(0) + from_first / static_cast<double>(curves.size());
  const double allowed = gap_mm + 16 * std::numeric_limits<double>::epsilon() * size;
  std::vector<BezierCurve> result;
  double largest = 0;
  std::size_t furthest = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    Poles poles = rows::elevated<3>(curves[i].poles(), degree);
    const double gap = (poles.row(0) - start).norm();
    if (gap > largest) furthest = i;
    largest = std::max(largest, gap);
    poles.row(0) = start;
    result.emplace_back(poles);
  }
  if (largest > allowed)
    refuse("spoke " + std::to_string(furthest) + " begins " + text(largest) +
           " mm from the mean of all beginnings: at most " + text(gap_mm) + " is allowed");
  return result;
}

Eigen::Matrix3Xd tangentsOf(const std::vector<BezierCurve>& spokes) {
  Eigen::Matrix3Xd tangents(3, std::ssize(spokes));
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const Poles poles = spokes[i].poles();
    tangents.col(static_cast<Eigen::Index>(i)) = spokes[i].degree() * (poles.row(1) - poles.row(0));
  }
  return tangents;
}

Eigen::Matrix3Xd secondsOf(const std::vector<BezierCurve>& spokes) {
  Eigen::Matrix3Xd seconds = Eigen::Matrix3Xd::Zero(3, std::ssize(spokes));
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const int n = spokes[i].degree();
    const Poles poles = spokes[i].poles();
    if (n >= 2)
      seconds.col(static_cast<Eigen::Index>(i)) =
          n * (n - 1) * ((poles.row(2) - poles.row(1)) - (poles.row(1) - poles.row(0)));
  }
  return seconds;
}

Eigen::Matrix3Xd thirdsOf(const std::vector<BezierCurve>& spokes) {
  Eigen::Matrix3Xd thirds(3, std::ssize(spokes));
  for (std::size_t i = 0; i < spokes.size(); ++i)
    thirds.col(static_cast<Eigen::Index>(i)) = spokes[i].derivatives(0, 3).row(3).transpose();
  return thirds;
}

std::vector<BezierCurve> withTangents(const std::vector<BezierCurve>& spokes,
                                      const Eigen::Matrix3Xd& tangents) {
  const Eigen::Matrix3Xd turns = tangents - tangentsOf(spokes);
  std::vector<BezierCurve> result;
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const int n = spokes[i].degree();
    const Eigen::RowVector3d move = turns.col(static_cast<Eigen::Index>(i)).transpose() / n;
    Poles poles = spokes[i].poles();
    poles.row(1) += move;
    if (n >= 3) poles.row(2) += 2 * move;
    result.emplace_back(poles);
  }
  return result;
}

std::vector<BezierCurve> withSeconds(const std::vector<BezierCurve>& spokes,
                                     const Eigen::Matrix3Xd& seconds) {
  return withDerivatives(spokes, 2, seconds - secondsOf(spokes));
}

std::vector<BezierCurve> withThirds(const std::vector<BezierCurve>& spokes,
                                    const Eigen::Matrix3Xd& thirds) {
  return withDerivatives(spokes, 3, thirds - thirdsOf(spokes));
}

Eigen::Matrix3Xd shaped(const UmbrellaVertex& vertex, const Eigen::Matrix3d& form,
                        const Eigen::Matrix3Xd& second) {
  if (!form.allFinite()) refuse("the second fundamental form is not finite");
  if (form != form.transpose()) refuse("the second fundamental form is not symmetric");
  return shapedBy(vertex, form, second);
}

double largestMove(const std::vector<BezierCurve>& from, const std::vector<BezierCurve>& to) {
  double largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Poles before = rows::elevated<3>(from[i].poles(), to[i].degree());
    largest = std::max(largest, (to[i].poles() - before).rowwise().norm().maxCoeff());
  }
  return largest;
}

}  // namespace seamwright::umbrella
