// SPDX-License-Identifier: LGPL-2.1-or-later
#include <BRepAdaptor_Curve.hxx>
#include <Eigen/Geometry>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <seamwright/core/angle.hpp>
#include <seamwright/occ_adapter/blend/side_directions.hpp>
#include <seamwright/occ_adapter/convert/points.hpp>

namespace seamwright::occ {

namespace {

using Eigen::Vector3d;

/// The direction in which an edge arrives at its vertex; nothing if it has none.
std::optional<Vector3d> arrivingDirection(const TopoDS_Edge& edge, const TopoDS_Vertex& vertex) {
  try {
    const BRepAdaptor_Curve curve(edge);
    const bool first = TopExp::FirstVertex(edge).IsSame(vertex);
    gp_Pnt point;
    gp_Vec derivative;
    curve.D1(first ? curve.FirstParameter() : curve.LastParameter(), point, derivative);
    const Vector3d along = (first ? -1 : 1) * vector(derivative);
    if (!(along.norm() > 0) || !along.allFinite()) return std::nullopt;
    return along.normalized();
  } catch (const Standard_Failure&) {
    return std::nullopt;  // an edge without a curve has no direction
  }
}

/// The direction at the vertex of the single other edge of the face that ends there.
std::optional<Vector3d> lateralAt(const Coedge& use, const TopoDS_Vertex& vertex) {
  std::vector<TopoDS_Edge> others;
  for (TopExp_Explorer at(use.shape, TopAbs_EDGE); at.More(); at.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(at.Current());
    if (edge.IsSame(use.edge)) continue;
    const bool ends_here =
        TopExp::FirstVertex(edge).IsSame(vertex) || TopExp::LastVertex(edge).IsSame(vertex);
    if (ends_here) others.push_back(edge);
  }
  return others.size() == 1 ? arrivingDirection(others[0], vertex) : std::nullopt;
}

/// The angle from the right angle that a lateral direction at that angle gives.
double limitedTilt(double angle_rad) {
  constexpr double quarter = std::numbers::pi / 4;
  const double size = std::abs(angle_rad);
  return std::copysign(size <= quarter ? size : std::max(0.0, 2 * quarter - size), angle_rad);
}

/// The lateral direction, limited, or the given one, minus the right angle.
Vector3d turnAt(const SideSample& sample, const std::optional<Vector3d>& lateral,
                const std::optional<Vector3d>& given) {
  const std::optional<Vector3d>& direction = given ? given : lateral;
  if (!direction) return Vector3d::Zero();
  const Vector3d across = -sample.beyond, along = sample.derivative.normalized();
  const double angle = std::atan2(direction->dot(along), direction->dot(across));
  const double tilt = given ? angle : limitedTilt(angle);
  return std::cos(tilt) * across + std::sin(tilt) * along - across;
}

/// The Bernstein polynomial with the values at equal shares.
Vector3d bernsteinMean(const Eigen::MatrixXd& values, double share) {
  const auto degree = static_cast<int>(values.rows()) - 1;
  // From the end where the polynomials are larger: 2^-256 is a normal number.
  const bool from_begin = share <= 0.5;
  const double by = from_begin ? share : 1 - share, ratio = by / (1 - by);
  double polynomial = std::pow(1 - by, degree);
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i <= degree; ++i) {
    sum += polynomial * values.row(from_begin ? i : degree - i).transpose();
    polynomial *= ratio * (degree - i) / (i + 1);
  }
  return sum;
}

/// The mean with the kernel cos^n of de la Vallée-Poussin, n the number of values, a power of 2.
Vector3d periodicMean(const Eigen::MatrixXd& values, double share) {
  Vector3d sum = Vector3d::Zero();
  const Eigen::Index count = values.rows();
  for (Eigen::Index i = 0; i < count; ++i) {
    double kernel =
        std::cos(std::numbers::pi * (share - static_cast<double>(i) / static_cast<double>(count)));
    for (Eigen::Index power = 1; power < count; power *= 2) kernel *= kernel;
    sum += kernel * values.row(i).transpose();
  }
  return sum;
}

}  // namespace

LateralDirections lateralDirections(const HoleSide& side, bool closed) {
  LateralDirections result;
  if (closed) return result;
  for (const int end : {0, 1}) {
    const HoleEdge& edge = end == 0 ? side.edges.front() : side.edges.back();
    const bool first = (end == 0) != edge.reversed;
    const TopoDS_Vertex vertex =
        first ? TopExp::FirstVertex(edge.use.edge) : TopExp::LastVertex(edge.use.edge);
    if (!vertex.IsNull()) result[end] = lateralAt(edge.use, vertex);
  }
  return result;
}

SideDirections::SideDirections(const SidePath& path, bool closed, const LateralDirections& lateral,
                               const LateralDirections& given)
    : closed_(closed) {
  for (const int end : {0, 1})
    turn_[end] = turnAt(path.besidePoleAtShare(end, end == 0), lateral[end], given[end]);
  // Wide means first: they are the smoothest. A choice.
  for (const int count : {16, 64, 256}) {
    right_angles_.resize(count + (closed ? 0 : 1), 3);
    for (int i = 0; i < right_angles_.rows(); ++i)
      right_angles_.row(i) =
          -path.besidePoleAtShare(static_cast<double>(i) / count, i < count).beyond;
    if (isNearRightAngles(path)) break;
  }
}

bool SideDirections::isNearRightAngles(const SidePath& path) const {
  constexpr int samples = 64;
  constexpr double least_cosine = 0.5;  // 60 degrees: a choice
  for (int i = 0; i <= samples; ++i) {
    const double share = static_cast<double>(i) / samples;
    const SideSample sample = path.besidePoleAtShare(share, i < samples);
    if (!(-at(share, sample).dot(sample.beyond) >= least_cosine)) return false;
  }
  return true;
}

Vector3d SideDirections::mean(double share) const {
  return closed_ ? periodicMean(right_angles_, share) : bernsteinMean(right_angles_, share);
}

Vector3d SideDirections::at(double share, const SideSample& sample) const {
  const double back = 1 - share;
  const Vector3d direction =
      mean(share) + back * back * back * turn_[0] + share * share * share * turn_[1];
  return (direction - direction.dot(sample.normal) * sample.normal).normalized();
}

}  // namespace seamwright::occ
