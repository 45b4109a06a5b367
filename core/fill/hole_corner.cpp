// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <seamwright/core/angle.hpp>
#include <seamwright/core/fill/hole_corner.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>
#include <seamwright/core/numeric.hpp>
#include <stdexcept>
#include <string>

namespace seamwright::fill {

namespace {

using bernstein::text;
using Eigen::Vector3d;
using rows::Field;

/// A limit of the interface, as a choice: it bounds the degree of patches, and so their size.
constexpr int max_side_degree = 12;

std::string sideName(std::size_t k) {
  return "side " + std::to_string(k);
}

void requireDegree(int degree, int lowest, const std::string& what) {
  if (degree < lowest || degree > max_side_degree)
    throw std::invalid_argument(what + " has degree " + std::to_string(degree) +
                                ": it must be within " + std::to_string(lowest) + " to " +
                                std::to_string(max_side_degree));
}

void requireField(const std::optional<Poles>& field, const std::string& side,
                  const std::string& name) {
  if (!field) return;
  requireDegree(static_cast<int>(field->rows()) - 1, 0, side + ": the " + name);
  for (Eigen::Index i = 0; i < field->rows(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!std::isfinite((*field)(i, c)))
        throw std::invalid_argument(side + ": coefficient " + std::to_string(i) + " of the " +
                                    name + " is " + text((*field)(i, c)));
}

void requireSide(const FillSide& side, std::size_t k) {
  if (side.edge.isRational())
    throw std::invalid_argument(sideName(k) +
                                ": the edge is rational, fills are built from polynomials");
  requireDegree(side.edge.degree(), 1, sideName(k) + ": the edge");
  requireField(side.cross, sideName(k), "cross-boundary derivative");
  requireField(side.bend, sideName(k), "second derivative");
}

/// Size of the coordinates; their rounding determines all other rounding.
double extent(const std::vector<FillSide>& sides) {
  double size = 0;
  for (const FillSide& side : sides) size = std::max(size, rows::size(side.edge.poles()));
  return size;
}

double angleBetween(const Vector3d& a, const Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The first or last coefficient.
Vector3d endOf(const Poles& coefficients, bool last) {
  return coefficients.row(last ? coefficients.rows() - 1 : 0);
}

SideEnd endOfSide(const FillSide& side, bool last, double size) {
  const Poles edge1 = rows::derivative<3>(side.edge.poles());
  SideEnd end{endOf(edge1, last), endOf(rows::derivative<3>(edge1), last), endOf(*side.cross, last),
              endOf(rows::derivative<3>(*side.cross), last)};
  const double degree = std::max<double>(side.edge.degree(), rows::degree(*side.cross));
  end.noise = 64 * machine_epsilon * (degree + 1) * (size + rows::size(*side.cross));
  return end;
}

std::string cornerName(std::size_t k) {
  return "corner " + std::to_string(k);
}

Vector3d normal(const SideEnd& end) {
  return end.cross.cross(end.edge).normalized();
}

/// Bounds within a thousandth of the largest coefficient: that changes a bound of an angle by as
/// little.
double least(const Eigen::VectorXd& polynomial) {
  const BernsteinPolynomial p(polynomial);
  return std::max(0.0, p.range(1e-3 * polynomial.cwiseAbs().maxCoeff()).lower);
}

double greatest(const Eigen::VectorXd& polynomial) {
  return std::max(
      0.0, BernsteinPolynomial(polynomial).range(1e-3 * polynomial.cwiseAbs().maxCoeff()).upper);
}

}  // namespace

void requireSides(const std::vector<FillSide>& sides) {
  for (std::size_t k = 0; k < sides.size(); ++k) requireSide(sides[k], k);
  const double noise = 64 * machine_epsilon * extent(sides);
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const std::size_t before = (k + sides.size() - 1) % sides.size();
    const double gap = (sides[before].edge.point(1) - sides[k].edge.point(0)).norm();
    if (gap > noise)
      throw std::invalid_argument(sideName(k) + " begins " + text(gap) + " mm from where " +
                                  sideName(before) + " ends, rounding is " + text(noise));
    if (tangentAtBegin(sides[k]).norm() <= noise || tangentAtEnd(sides[k]).norm() <= noise)
      throw std::invalid_argument(sideName(k) + ": the edge has no tangent at one of its ends");
  }
}

std::string degreesText(double angle_rad) {
  return fmt::format("{:.6g} degrees", angle_rad * degrees_per_radian);
}

void requireFairness(int order) {
  if (order != 2 && order != 3)
    throw std::invalid_argument("fairness order " + std::to_string(order) + ": known are 2 and 3");
}

void requireTolerance(double corner_tolerance_rad) {
  if (!(corner_tolerance_rad >= 0 && corner_tolerance_rad <= 0.1))
    throw std::invalid_argument("corner tolerance " + degreesText(corner_tolerance_rad) +
                                " is not within 0 to " + degreesText(0.1));
}

void requireCurvature(const std::optional<int>& degrees) {
  if (degrees && (*degrees < 0 || *degrees > 6))
    throw std::invalid_argument("curvature degrees " + std::to_string(*degrees) +
                                ": known are 0 to 6");
}

Vector3d tangentAtBegin(const FillSide& side) {
  return endOf(rows::derivative<3>(side.edge.poles()), false);
}

Vector3d tangentAtEnd(const FillSide& side) {
  return endOf(rows::derivative<3>(side.edge.poles()), true);
}

Eigen::Vector2d combination(const Vector3d& first, const Vector3d& second, const Vector3d& vector) {
  const Vector3d normal = first.cross(second);
  return Eigen::Vector2d(vector.cross(second).dot(normal), first.cross(vector).dot(normal)) /
         normal.squaredNorm();
}

HoleCorner::HoleCorner(const std::vector<FillSide>& sides, std::size_t k)
    : k_(k),
      in_(tangentAtEnd(sides[(k + sides.size() - 1) % sides.size()])),
      out_(tangentAtBegin(sides[k])) {
  const FillSide& before = sides[(k + sides.size() - 1) % sides.size()];
  const double size = extent(sides);
  if (before.cross) before_ = endOfSide(before, true, size);
  if (sides[k].cross) after_ = endOfSide(sides[k], false, size);
  noise_rad_ = 64 * machine_epsilon * size * (before.edge.degree() + sides[k].edge.degree()) *
               (1 / in_.norm() + 1 / out_.norm());
  if (before_) noise_rad_ += planeNoise(*before_, k == 0 ? sides.size() - 1 : k - 1);
  if (after_) noise_rad_ += planeNoise(*after_, k);
}

FillCorner HoleCorner::figures(double tolerance_rad) const {
  FillCorner corner;
  corner.plane_angle_rad = planeAngle();
  if (corner.plane_angle_rad > noise_rad_ + tolerance_rad)
    throw std::invalid_argument(cornerName(k_) + ": the tangent planes of its sides differ by " +
                                degreesText(corner.plane_angle_rad) + ", allowed are " +
                                degreesText(noise_rad_ + tolerance_rad));
  corner.angle_rad = interiorAngle();
  corner.exact = corner.plane_angle_rad <= noise_rad_;
  return corner;
}

FillCorner HoleCorner::convexFigures(double tolerance_rad) const {
  const FillCorner corner = figures(tolerance_rad);
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(cornerName(k_) + ": the angle of the hole is " + what);
  };
  const double beyond = corner.angle_rad - std::numbers::pi;
  if (std::abs(beyond) <= noise_rad_) refuse("180 degrees: merge the two sides");
  if (beyond > 0) refuse(degreesText(corner.angle_rad) + ", above 180 degrees: split the hole");
  if (corner.angle_rad <= noise_rad_)
    refuse(degreesText(corner.angle_rad) + ", it must be positive");
  return corner;
}

double HoleCorner::planeNoise(const SideEnd& end, std::size_t side) const {
  const double area = end.edge.cross(end.cross).norm();
  const double noise = end.noise * (end.edge.norm() + end.cross.norm());
  if (!(area > noise))
    throw std::invalid_argument(sideName(side) + ": at " + cornerName(k_) +
                                " the cross-boundary derivative is parallel to the edge or one of "
                                "them vanishes, |E' x T| is " +
                                text(area) + ", rounding " + text(noise));
  return noise / area;
}

Vector3d HoleCorner::up() const {
  Vector3d sum = Vector3d::Zero();
  if (before_) sum += normal(*before_);
  if (after_) sum += normal(*after_);
  return sum;
}

double HoleCorner::planeAngle() const {
  if (before_ && after_) return angleBetween(normal(*before_), normal(*after_));
  if (before_) return std::asin(std::min(1.0, std::abs(normal(*before_).dot(out_)) / out_.norm()));
  if (after_) return std::asin(std::min(1.0, std::abs(normal(*after_).dot(in_)) / in_.norm()));
  return 0;
}

double HoleCorner::interiorAngle() const {
  const Vector3d across = in_.cross(out_);
  const double sine =
      before_ || after_ ? std::copysign(across.norm(), across.dot(up())) : across.norm();
  const double angle = std::atan2(sine, -in_.dot(out_));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

double angleBound(const Poles& field, const Poles& change, const Poles& edge1) {
  const Field<3> across = rows::cross(field, edge1);
  const double part =
      std::sqrt(least(rows::dot<3>(across, across)) / greatest(rows::dot<3>(edge1, edge1)));
  const double moved = std::sqrt(greatest(rows::dot<3>(change, change)));
  return part > moved ? std::asin(moved / part) : std::numbers::pi / 2;
}

}  // namespace seamwright::fill
