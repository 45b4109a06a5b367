// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include <seamwright/core/differential/fundamental_forms.hpp>

namespace seamwright {

namespace {

bool isFinite(const SurfaceJet& jet) {
  return jet.p.allFinite() && jet.u.allFinite() && jet.v.allFinite() && jet.uu.allFinite() &&
         jet.uv.allFinite() && jet.vv.allFinite();
}

/// The dual basis of two vectors in their plane. Cross products keep its accuracy where the vectors
/// are nearly parallel and E G - F^2 would cancel.
std::pair<Eigen::Vector3d, Eigen::Vector3d> dualBasis(const Eigen::Vector3d& u,
                                                      const Eigen::Vector3d& v) {
  const Eigen::Vector3d cross = u.cross(v);
  return {v.cross(cross) / cross.squaredNorm(), cross.cross(u) / cross.squaredNorm()};
}

}  // namespace

std::string_view name(Degeneracy degeneracy) {
  switch (degeneracy) {
    case Degeneracy::None:
      return "none";
    case Degeneracy::VanishingNormal:
      return "vanishing normal";
    case Degeneracy::NotFinite:
      return "not finite";
  }
  return "unknown";
}

Degeneracy degeneracy(const SurfaceJet& jet, const JetNoise& noise) {
  if (!isFinite(jet)) return Degeneracy::NotFinite;
  const double possible_error = noise.u * jet.v.norm() + noise.v * jet.u.norm() + noise.u * noise.v;
  return jet.u.cross(jet.v).norm() <= possible_error ? Degeneracy::VanishingNormal
                                                     : Degeneracy::None;
}

std::optional<Eigen::Vector3d> unitNormal(const SurfaceJet& jet, const JetNoise& noise) {
  if (degeneracy(jet, noise) != Degeneracy::None) return std::nullopt;
  // The partials are normalised first: the product of two long or two short partials may exceed the
  // range of a double.
  return jet.u.stableNormalized().cross(jet.v.stableNormalized()).stableNormalized();
}

FirstForm firstForm(const SurfaceJet& jet) {
  return {jet.u.squaredNorm(), jet.u.dot(jet.v), jet.v.squaredNorm()};
}

SecondForm secondForm(const SurfaceJet& jet, const Eigen::Vector3d& normal) {
  return {normal.dot(jet.uu), normal.dot(jet.uv), normal.dot(jet.vv)};
}

Eigen::Matrix3d curvatureTensor(const SurfaceJet& jet, const Eigen::Vector3d& normal) {
  // The parameters are scaled to unit partials, so no product exceeds the range of a double.
  const double length_u = jet.u.stableNorm();
  const double length_v = jet.v.stableNorm();
  const double L = normal.dot(jet.uu) / length_u / length_u;
  const double M = normal.dot(jet.uv) / length_u / length_v;
  const double N = normal.dot(jet.vv) / length_v / length_v;
  const auto [dual_u, dual_v] = dualBasis(jet.u / length_u, jet.v / length_v);
  return L * dual_u * dual_u.transpose() +
         M * (dual_u * dual_v.transpose() + dual_v * dual_u.transpose()) +
         N * dual_v * dual_v.transpose();
}

double curvatureChange(const SurfaceJet& jet, const Eigen::Vector3d& normal,
                       const Eigen::Vector3d& direction) {
  const double U = jet.u.stableNorm();
  const double V = jet.v.stableNorm();
  const auto dual = dualBasis(jet.u / U, jet.v / V);
  // Parameter vectors are taken in the scaled parameters; the partials are scaled in the same way.
  const auto parameters = [&](const Eigen::Vector3d& vector) {
    return Eigen::Vector2d(dual.first.dot(vector), dual.second.dot(vector));
  };
  const auto second = [&](const Eigen::Vector2d& x, const Eigen::Vector2d& y) -> Eigen::Vector3d {
    return x(0) * y(0) * (jet.uu / U / U) + (x(0) * y(1) + x(1) * y(0)) * (jet.uv / U / V) +
           x(1) * y(1) * (jet.vv / V / V);
  };
  const Eigen::Vector2d v1 = parameters(direction);
  const Eigen::Vector2d v2 = -parameters(second(v1, v1));
  const double a = v1(0), b = v1(1);
  const double third = a * a * a * (normal.dot(jet.uuu) / U / U / U) +
                       3 * a * a * b * (normal.dot(jet.uuv) / U / U / V) +
                       3 * a * b * b * (normal.dot(jet.uvv) / U / V / V) +
                       b * b * b * (normal.dot(jet.vvv) / V / V / V);
  return third + 3 * normal.dot(second(v1, v2));
}

PrincipalCurvatures principalCurvatures(const SurfaceJet& jet, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d x = normal.unitOrthogonal();
  const Eigen::Vector3d y = normal.cross(x);
  const PlaneTensor plane = restrictToPlane(curvatureTensor(jet, normal), normal, x);
  Eigen::Matrix2d matrix;
  matrix << plane.xx, plane.xy, plane.xy, plane.yy;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(matrix);
  const Eigen::Matrix2d& vectors = solver.eigenvectors();
  return {solver.eigenvalues()(1), solver.eigenvalues()(0), vectors(0, 1) * x + vectors(1, 1) * y,
          vectors(0, 0) * x + vectors(1, 0) * y};
}

double PlaneTensor::spectralNorm() const {
  return std::abs(0.5 * (xx + yy)) + std::hypot(0.5 * (xx - yy), xy);
}

PlaneTensor restrictToPlane(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& normal,
                            const Eigen::Vector3d& x) {
  const Eigen::Vector3d y = normal.cross(x);
  return {x.dot(tensor * x), x.dot(tensor * y), y.dot(tensor * y)};
}

}  // namespace seamwright
