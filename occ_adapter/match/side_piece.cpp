// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include <seamwright/core/differential/fundamental_forms.hpp>
#include <seamwright/occ_adapter/convert/nearest.hpp>
#include <seamwright/occ_adapter/convert/seam_strips.hpp>
#include <seamwright/occ_adapter/match/side_piece.hpp>

namespace seamwright::occ {

namespace {

Correspondence exchangedOf(const Correspondence& map) {
  return {map.s, map.b, map.a};
}

/// The smallest rotation that takes one unit vector to another.
Eigen::Matrix3d turnOf(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

}  // namespace

Seam withFirst(Seam seam, int face) {
  if (seam.sides[0].face == face) return seam;
  std::swap(seam.sides[0], seam.sides[1]);
  if (seam.edges.size() == 2) std::swap(seam.edges[0], seam.edges[1]);
  Correspondence& map = seam.correspondence;
  std::swap(map.a, map.b);
  if (map.s.empty() || map.a.front() < map.a.back()) return seam;
  for (double& s : map.s) s = 1 - s;
  for (std::vector<double>* values : {&map.s, &map.a, &map.b}) std::ranges::reverse(*values);
  return seam;
}

std::optional<Seam> partOfSeam(const Seam& seam, double from, double to) {
  const Correspondence& map = seam.correspondence;
  const double first = map.s.empty() ? 0 : map.a.front(), last = map.s.empty() ? 1 : map.a.back();
  // Of the range of the edge: what is shorter is the rounding of the bounds.
  constexpr double nothing = 1e-6;
  from = std::max(from, first);
  to = std::min(to, last);
  if (to - from <= nothing) return std::nullopt;
  if (from - first <= nothing && last - to <= nothing) return seam;
  const Correspondence by_a = {map.a, map.b, map.s};
  // As fine as the knots of a correspondence usually are; points are sought again beside them.
  constexpr int pieces = 64;
  Seam part = seam;
  part.kind = SeamKind::Matched;
  if (part.edges.size() == 1) part.edges.push_back(part.edges.front());
  part.correspondence = {};
  for (int k = 0; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces, a = from + share * (to - from);
    part.correspondence.s.push_back(share);
    part.correspondence.a.push_back(a);
    part.correspondence.b.push_back(map.s.empty() ? a : parameterOnFirst(by_a, a));
  }
  return part;
}

PieceStrips::PieceStrips(const Seam& seam, double gap_mm)
    : seam_(seam),
      exchanged_(exchangedOf(seam.correspondence)),
      pcurves_{pcurveOf(seam.sides[0].edge, seam.sides[0].shape, gap_mm),
               pcurveOf(seam.sides[1].edge, seam.sides[1].shape, gap_mm)},
      own_(seam.sides[0], pcurves_[0]),
      other_(seam.sides[1], pcurves_[1]) {}

PiecePoint PieceStrips::at(double s) const {
  const double a = parameterOnFirst(seam_.correspondence, s);
  PiecePoint point{own_.at(a), {}, {}, {}};
  double b = parameterOnFirst(exchanged_, s);
  const std::vector<double>& shares = seam_.correspondence.b;
  // Points of one edge correspond by its parameter.
  const bool is_one_edge = seam_.edges.size() == 1 || seam_.edges[0] == seam_.edges[1];
  if (!shares.empty() && !is_one_edge) {
    const auto [low, high] = std::minmax(shares.front(), shares.back());
    b = nearestParameter(other_, point.own.jet.p, b, low, high);
  }
  point.other = other_.at(b);
  if (!shares.empty() && shares.back() < shares.front()) {
    point.other.tangent = -point.other.tangent;
    point.other.face_on_left = !point.other.face_on_left;
  }
  const gp_Pnt2d own = own_.parametersAt(a), other = other_.parametersAt(b);
  point.own_uv = {own.X(), own.Y()};
  point.other_uv = {other.X(), other.Y()};
  return point;
}

MatchTarget PieceStrips::otherAt(double s) const {
  const SidePoint other = at(s).other;
  MatchTarget target{other.jet.p, unitNormal(other.jet, other.noise)};
  if (target.normal) target.curvature = curvatureTensor(other.jet, *target.normal);
  return target;
}

std::optional<PieceStrips::Frame> PieceStrips::meanFrameAt(double s) const {
  const PiecePoint both = at(s);
  std::optional<Eigen::Vector3d> own = unitNormal(both.own.jet, both.own.noise);
  std::optional<Eigen::Vector3d> other = unitNormal(both.other.jet, both.other.noise);
  if (!own || !other) return std::nullopt;
  if (own->dot(*other) < 0) *other = -*other;
  Frame mean;
  mean.point = (both.own.jet.p + both.other.jet.p) / 2;
  mean.normal = (*own + *other).normalized();
  mean.along = both.own.tangent.normalized();
  const Eigen::Vector3d across = mean.normal.cross(mean.along).normalized();
  const auto bend = [&](const SidePoint& side, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d way = turnOf(mean.normal, normal) * across;
    return way.dot(curvatureTensor(side.jet, normal) * way);
  };
  mean.curvature_across_per_mm = (bend(both.own, *own) + bend(both.other, *other)) / 2;
  return mean;
}

MatchTarget PieceStrips::meanAt(double s) const {
  const std::optional<Frame> mean = meanFrameAt(s);
  if (!mean) {
    const PiecePoint both = at(s);
    return {(both.own.jet.p + both.other.jet.p) / 2, std::nullopt};
  }
  // Central differences lose a third of the digits of the normals.
  constexpr double step = 1e-5;
  const double before = std::max(0.0, s - step), after = std::min(1.0, s + step);
  const std::optional<Frame> low = meanFrameAt(before), high = meanFrameAt(after);
  MatchTarget target{mean->point, mean->normal};
  if (!low || !high) return target;
  const Eigen::Vector3d& n = mean->normal;
  Eigen::Vector3d way = high->point - low->point;
  const double length_mm = way.norm();
  if (!(length_mm > 0)) return target;
  way = (way - n * n.dot(way)).normalized();
  Eigen::Vector3d turn = high->normal;
  turn = (n.dot(turn) < 0 ? -turn : turn) - (n.dot(low->normal) < 0 ? -1 : 1) * low->normal;
  turn /= length_mm;
  const Eigen::Vector3d across = n.cross(way);
  const double along = -turn.dot(way), torsion = -turn.dot(across);
  target.curvature = along * way * way.transpose() +
                     torsion * (way * across.transpose() + across * way.transpose()) +
                     mean->curvature_across_per_mm * across * across.transpose();
  return target;
}

std::vector<double> PieceStrips::breaks() const {
  return SeamStrips(seam_, pcurves_).breaks();
}

}  // namespace seamwright::occ
