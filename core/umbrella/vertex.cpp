// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/linear/dense.hpp>
#include <seamwright/core/numeric.hpp>
#include <seamwright/core/umbrella/vertex.hpp>
#include <stdexcept>
#include <string>

namespace seamwright {

namespace {

using bernstein::text;
using std::numbers::pi;

/// Determinants of unit vectors below this are rounding.
constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

void requireTangents(const Eigen::Matrix3Xd& tangents) {
  if (tangents.cols() < 3)
    refuse(std::to_string(tangents.cols()) + " spokes: an umbrella has at least 3");
  for (Eigen::Index i = 0; i < tangents.cols(); ++i) {
    if (!tangents.col(i).allFinite())
      refuse("the tangent of spoke " + std::to_string(i) + " is not finite");
    if (const double length = tangents.col(i).stableNorm(); !(length > 0) || !std::isfinite(length))
      refuse("the tangent of spoke " + std::to_string(i) + " has length " + text(length) +
             ": it must have a direction");
  }
}

Eigen::Matrix3Xd unit(const Eigen::Matrix3Xd& tangents) {
  Eigen::Matrix3Xd result = tangents;
  for (Eigen::Index i = 0; i < result.cols(); ++i) result.col(i).stableNormalize();
  return result;
}

/// The normal of the plane nearest to all directions, on the side from which most sectors turn
/// counter-clockwise.
Eigen::Vector3d normalOf(const Eigen::Matrix3Xd& directions, bool closed) {
  const linear::SingularValues svd = linear::singularValues(directions, Eigen::ComputeFullU);
  if (!(svd.values(1) > kRounding * svd.values(0)))
    refuse("the tangents of all spokes are parallel: they span no plane");
  const Eigen::Vector3d normal = svd.u.col(2);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  const Eigen::Index n = directions.cols();
  for (Eigen::Index i = 0; i < (closed ? n : n - 1); ++i)
    area += Eigen::Vector3d(directions.col(i)).cross(Eigen::Vector3d(directions.col((i + 1) % n)));
  return area.dot(normal) < 0 ? Eigen::Vector3d(-normal) : normal;
}

/// Puts the tangents into the plane and returns their largest angle with it before.
double flatten(Eigen::Matrix3Xd& tangents, const Eigen::Vector3d& normal, double flat_rad) {
  double largest = 0;
  Eigen::Index worst = 0;
  for (Eigen::Index i = 0; i < tangents.cols(); ++i) {
    const double height = normal.dot(tangents.col(i));
    const double angle = std::asin(std::min(1.0, std::abs(height) / tangents.col(i).stableNorm()));
    if (angle > largest) {
      largest = angle;
      worst = i;
    }
    tangents.col(i) -= height * normal;
  }
  if (largest > flat_rad)
    refuse("the tangent of spoke " + std::to_string(worst) + " is " + text(largest) +
           " rad out of the plane of all spokes: at most " + text(flat_rad) + " is allowed");
  return largest;
}

void requireSector(int member, int end, double sine, double angle_rad) {
  if (sine > kRounding) return;
  const std::string sector = "sector " + std::to_string(member) + ", from spoke " +
                             std::to_string(member) + " to " + std::to_string(end) + ", ";
  if (sine < -kRounding)
    refuse(sector + "has the angle " + text(2 * pi + angle_rad) +
           " rad: it must be below pi, put a spoke into it");
  if (std::abs(angle_rad) > pi / 2)
    refuse(sector + "has the angle pi: it must be below, put a spoke into it");
  refuse(sector + "has no angle: the spokes have the same tangent");
}

/// The equations y_(i-1) / s_(i-1) + y_i / s_i = d_i of unit tangents, as equations of the twists
/// y_i.
double conditionOf(const UmbrellaVertex& vertex) {
  const int m = vertex.members(), equations = vertex.closed ? m : m - 1;
  const Eigen::VectorXd sines = vertex.angles_rad.array().sin();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(equations, m);
  for (int i = 0; i < equations; ++i) {
    const int spoke = vertex.closed ? i : i + 1, before = vertex.memberBefore(spoke);
    const double scale = std::sqrt(sines(before) * sines(spoke));
    matrix(i, before) += scale / sines(before);
    matrix(i, spoke) += scale / sines(spoke);
  }
  const Eigen::VectorXd values = linear::singularValues(matrix).values;
  const int rank = vertex.closed && m % 2 == 0 ? m - 1 : equations;
  return values(0) / values(rank - 1);
}

}  // namespace

bool UmbrellaVertex::isRegular() const {
  return closed && members() == 4 && alpha.isZero(0);
}

UmbrellaVertex umbrellaVertex(const Eigen::Matrix3Xd& tangents, bool closed,
                              const VertexOptions& options) {
  if (!(options.flat_rad >= 0 && options.flat_rad < pi / 2))
    refuse("flat_rad is " + text(options.flat_rad) + ": 0 to pi / 2 is needed");
  requireTangents(tangents);
  UmbrellaVertex vertex;
  vertex.closed = closed;
  vertex.normal = normalOf(unit(tangents), closed);
  vertex.tangents = tangents;
  vertex.out_of_plane_rad = flatten(vertex.tangents, vertex.normal, options.flat_rad);

  const auto det = [&](const Eigen::Matrix3Xd& of, int i, int j) {
    return vertex.normal.dot(Eigen::Vector3d(of.col(i)).cross(Eigen::Vector3d(of.col(j))));
  };
  const Eigen::Matrix3Xd directions = unit(vertex.tangents), &r = vertex.tangents;
  const int spokes = vertex.spokes(), members = closed ? spokes : spokes - 1;
  vertex.sectors.resize(members);
  vertex.angles_rad.resize(members);
  for (int i = 0; i < members; ++i) {
    const int end = vertex.after(i);
    const double sine = det(directions, i, end);
    vertex.angles_rad(i) = std::atan2(sine, directions.col(i).dot(directions.col(end)));
    requireSector(i, end, sine, vertex.angles_rad(i));
    vertex.sectors(i) = det(r, i, end);
  }
  const double around = vertex.angles_rad.sum();
  if (closed ? std::abs(around - 2 * pi) > 1 : !(around < 2 * pi))
    refuse("the sectors sum up to " + text(around) +
           " rad: a closed fan goes around once, an open one less");

  vertex.alpha = vertex.beta = Eigen::VectorXd::Zero(spokes);
  for (int i = 0; i < spokes; ++i) {
    if (!vertex.isInner(i)) continue;
    const int before = vertex.before(i), after = vertex.after(i);
    const double area = vertex.sectors(vertex.memberBefore(i));
    if (std::abs(det(directions, before, after)) > kRounding)
      vertex.alpha(i) = det(r, before, after) / area;
    vertex.beta(i) = -vertex.sectors(i) / area;
  }
  vertex.condition = conditionOf(vertex);
  return vertex;
}

}  // namespace seamwright
