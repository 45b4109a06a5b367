// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <seamwright/core/fill/ring_curvature.hpp>
#include <seamwright/core/join/bernstein_rows.hpp>

namespace seamwright::fill {

namespace {

using Eigen::Vector3d;

constexpr std::size_t corners = 4;

/// Where curvature beyond the sides is not known, smooth corners at which the curvature of the
/// sides in the tangent plane jumps by less than this share are taken as corners without a jump.
/// There the normal curvature of the spoke would be a quotient of two small numbers.
constexpr double least_bend = 1e-3;

/// Derivatives of the functions c, d and e, which are linear.
struct Slopes {
  double c = 0, d = 0, e = 0;
};

Slopes slopesOf(const SpokeEnd& end) {
  return {end.c - 1, end.d - 1, end.e + 1};
}

/// The functions of edge k of the middle patch, between the spokes to corners k and k + 1.
CurvatureLaw middleLaw(const Slopes& at, const Slopes& next) {
  return {.p = Eigen::Vector2d(-(2 + at.e + at.d) / 2, -(2 + next.e + next.c) / 2),
          .q = Eigen::Vector2d((2 - at.e - 2 * at.c + at.d) / 2,
                               (next.e + 2 * next.d - next.c - 2) / 2)};
}

double slopeOf(const Eigen::VectorXd& linear) {
  return linear(1) - linear(0);
}

/// A function by its value and slope at both ends.
struct Ends {
  double begin = 0, begin_slope = 0, end = 0, end_slope = 0;

  Eigen::VectorXd cubic() const {
    return Eigen::Vector4d(begin, begin + begin_slope / 3, end - end_slope / 3, end);
  }
  Eigen::VectorXd quadratic() const { return Vector3d(begin, begin + begin_slope / 2, end); }
};

/// The values and slopes of p and q of a spoke.
struct SpokeEnds {
  Ends p, q;
};

/// At the inner end, where three edges meet.
/// \param after, before  the edges of the middle patch beside the spoke
SpokeEnds innerEnd(const Slopes& at, const CurvatureLaw& after, const CurvatureLaw& before) {
  const double pa = slopeOf(after.p), qa = slopeOf(after.q), pb = slopeOf(before.p),
               qb = slopeOf(before.q);
  SpokeEnds law;
  law.p.begin = -2;
  law.p.begin_slope = at.e - (at.c + at.d) / 2 - 2 + (pa - pb - qa - qb) / 2;
  law.q.begin_slope = (at.c - at.d - 3 * pa - 3 * pb - qa + qb) / 2;
  return law;
}

Vector3d derivativeAt(const Poles& polynomial, int order, bool end) {
  Poles derived = polynomial;
  for (int k = 0; k < order; ++k) derived = rows::derivative<3>(derived);
  return derived.row(end ? derived.rows() - 1 : 0).transpose();
}

/// The second derivative of a neighbour along a tangent vector, up to a part in the tangent plane.
std::optional<Vector3d> bendAlong(const FillSide& side, bool end, const Vector3d& tangent) {
  if (!side.cross || !side.bend) return std::nullopt;
  const Poles edge = side.edge.poles();
  const Vector3d edge1 = derivativeAt(edge, 1, end);
  const Eigen::Vector2d c = combination(derivativeAt(*side.cross, 0, end), edge1, tangent);
  return c(0) * c(0) * derivativeAt(*side.bend, 0, end) +
         2 * c(0) * c(1) * derivativeAt(*side.cross, 1, end) +
         c(1) * c(1) * derivativeAt(edge, 2, end);
}

/// The outer end of a spoke, with the patches beside it as far as the sides determine them.
class OuterEnd {
 public:
  OuterEnd(const std::vector<FillSide>& sides, const RingFields& fields, std::size_t k)
      : spoke_(fields.spokes[k]),
        slopes_(slopesOf(spoke_)),
        before_(sides[(k + corners - 1) % corners]),
        after_(sides[k]) {
    const Poles before = before_.edge.poles(), after = after_.edge.poles();
    v_ = derivativeAt(after, 1, false), v2_ = derivativeAt(after, 2, false);
    u_ = -derivativeAt(before, 1, true), u2_ = derivativeAt(before, 2, true);
    if (const auto& field = fields.fields[k])
      v1_ = derivativeAt(*field, 1, false), v21_ = derivativeAt(*field, 2, false);
    if (const auto& field = fields.fields[(k + corners - 1) % corners])
      u1_ = -derivativeAt(*field, 1, true), u21_ = derivativeAt(*field, 2, true);
    between_ = spoke_.d * u_ - spoke_.c * v_;
    across_ = spoke_.derivative.value_or(Vector3d::Zero());
    const std::optional<Vector3d> one = bendAlong(before_, true, across_),
                                  other = bendAlong(after_, false, across_);
    if (one || other) bend_ = ((one ? *one : *other) + (other ? *other : *one)) / 2;
  }

  /// Sets p, q and the defects of \p law; its inner end is \p inner.
  void complete(CurvatureLaw& law, SpokeEnds inner) const {
    if (!spoke_.derivative) return completeFree(law, inner);
    const Vector3d value = valueAtEnd();
    const Eigen::Vector2d solution = combination(between_, across_, value);
    inner.p.end = solution(0), inner.q.end = solution(1);
    const double size = (spoke_.c * spoke_.c * v2_).norm() + (spoke_.d * spoke_.d * u2_).norm();
    if (spoke_.smooth && !bend_ && std::abs(inner.q.end) * across_.norm() <= least_bend * size)
      inner.q.end = 0;
    const bool is_known = v1_ && u1_;
    if (is_known || spoke_.smooth)
      law.defect = value - inner.p.end * between_ - inner.q.end * across_;
    if (!is_known) {
      law.p = inner.p.quadratic(), law.q = inner.q.quadratic();
      return;
    }
    const Vector3d slope = slopeAtEnd(inner.p.end);
    const Eigen::Vector2d change = combination(between_, across_, slope);
    inner.p.end_slope = change(0), inner.q.end_slope = change(1);
    law.p = inner.p.cubic(), law.q = inner.q.cubic();
    if (spoke_.smooth) law.defect_slope = slopeDefect(slope, inner.q.end);
  }

  /// The jump of curvature beside the corner that a defect of that degree leaves.
  double jump_per_mm(const CurvatureLaw& law, int degree) const {
    const Vector3d normal = between_.cross(across_);
    if (normal.isZero(0)) return 0;
    const double last = law.defect.dot(normal.normalized()),
                 before = last - law.defect_slope.dot(normal.normalized()) / degree;
    const double share = std::pow(1 - 1.0 / degree, degree - 1);  // the largest value of its weight
    const double wide = spoke_.c * v_.cross(across_).norm() / across_.norm();
    return std::max(std::abs(last), share * std::abs(before)) / (wide * wide);
  }

 private:
  /// c^2 V2 - d^2 U2 + e (d U' - c V'), where a derivative that no side gives is that for S'' = 0.
  Vector3d valueAtEnd() const {
    const Vector3d together =
        slopes_.e * across_ - slopes_.c * v_ - slopes_.d * u_;  // c V' + d U' for S'' = 0
    Vector3d apart;
    if (v1_ && u1_)
      apart = spoke_.d * *u1_ - spoke_.c * *v1_;
    else if (v1_)
      apart = together - 2 * spoke_.c * *v1_;
    else
      apart = 2 * spoke_.d * *u1_ - together;
    return spoke_.c * spoke_.c * v2_ - spoke_.d * spoke_.d * u2_ + spoke_.e * apart;
  }

  /// What p' (d U - c V) + q' S' + q S'' has to be if d U'' = c V'' there.
  Vector3d slopeAtEnd(double p) const {
    const double c = spoke_.c, d = spoke_.d;
    return 2 * c * slopes_.c * v2_ + c * c * *v21_ - 2 * d * slopes_.d * u2_ - d * d * *u21_ +
           slopes_.e * (d * *u1_ - c * *v1_) + spoke_.e * (slopes_.d * *u1_ - slopes_.c * *v1_) -
           p * (slopes_.d * u_ + d * *u1_ - slopes_.c * v_ - c * *v1_);
  }

  /// At a smooth corner S'' is free. With q = 0 it does not occur, else it is that of the
  /// neighbours if that is known.
  Vector3d slopeDefect(const Vector3d& slope, double q) const {
    const Vector3d normal = between_.cross(across_).normalized();
    const double rest = slope.dot(normal);
    if (q == 0) return rest * normal;
    return bend_ ? Vector3d((rest - q * bend_->dot(normal)) * normal) : Vector3d::Zero();
  }

  /// Between two sides of position alone.
  void completeFree(CurvatureLaw& law, SpokeEnds inner) const {
    inner.p.end = inner.p.begin;
    if (spoke_.smooth) {
      const Vector3d value = spoke_.c * spoke_.c * v2_ - spoke_.d * spoke_.d * u2_;
      inner.p.end = value.dot(between_) / between_.squaredNorm();
      law.defect = value - inner.p.end * between_;
    }
    law.p = inner.p.quadratic(), law.q = inner.q.quadratic();
  }

  const SpokeEnd& spoke_;
  Slopes slopes_;
  const FillSide &before_, &after_;
  Vector3d v_, u_, v2_, u2_, between_, across_;
  std::optional<Vector3d> v1_, u1_, v21_, u21_;
  std::optional<Vector3d> bend_;  // the second derivative of the neighbours along the spoke
};

}  // namespace

RingCurvature ringCurvature(const std::vector<FillSide>& sides, const RingFields& fields) {
  RingCurvature curvature;
  std::array<Slopes, corners> at;
  for (std::size_t k = 0; k < corners; ++k) at.at(k) = slopesOf(fields.spokes[k]);
  for (std::size_t k = 0; k < corners; ++k)
    curvature.middle.at(k) = middleLaw(at.at(k), at.at((k + 1) % corners));
  for (std::size_t k = 0; k < corners; ++k) {
    const OuterEnd end(sides, fields, k);
    CurvatureLaw& law = curvature.spokes.at(k);
    end.complete(law, innerEnd(at.at(k), curvature.middle.at(k),
                               curvature.middle.at((k + corners - 1) % corners)));
    curvature.spoke_jump_per_mm =
        std::max(curvature.spoke_jump_per_mm, end.jump_per_mm(law, fields.degree - 1));
  }
  return curvature;
}

}  // namespace seamwright::fill
