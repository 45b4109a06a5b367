// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>

#include <seamwright/core/bernstein/coefficients.hpp>
#include <seamwright/core/bezier/frenet.hpp>

namespace seamwright {

namespace {

using Eigen::Vector3d;

struct CurveSample {
  double t;
  Vector3d point, tangent;
};

[[noreturn]] void refuseCusp(double t) {
  throw std::invalid_argument("the curve has a cusp at parameter " + bernstein::text(t) +
                              ": no frame can be carried through it");
}

CurveSample sampleAt(const BezierCurve& curve, double t) {
  const FrenetFrame frame = frenetFrame(curve, t);
  if (frame.kind == CurvePoint::Cusp || frame.kind == CurvePoint::Point) refuseCusp(t);
  return {t, curve.point(t), *frame.tangent};
}

Vector3d reflected(const Vector3d& vector, const Vector3d& across) {
  return vector - (2 * across.dot(vector) / across.squaredNorm()) * across;
}

/// The normal at \p a, carried to \p b by two reflections. The first plane swaps the points, the
/// second takes the reflected tangent to the tangent at \p b. A step that turns too far for that is
/// halved.
Vector3d carried(const BezierCurve& curve, const CurveSample& a, const CurveSample& b,
                 const Vector3d& normal, int depth) {
  const Vector3d chord = b.point - a.point;
  // Where the points coincide (a closed curve, a tiny step), the first reflection is the one that
  // reverses the tangent.
  const Vector3d across = chord.isZero(0) ? a.tangent : chord.stableNormalized();
  const Vector3d tangent = reflected(a.tangent, across);
  if (tangent.dot(b.tangent) <= 0 && a.tangent.dot(b.tangent) >= 0)
    return reflected(reflected(normal, across), b.tangent - tangent);
  const double middle = 0.5 * (a.t + b.t);
  // More halvings than a double has digits.
  constexpr int deepest = 60;
  if (depth == deepest || middle <= a.t || middle >= b.t) refuseCusp(middle);
  const CurveSample half = sampleAt(curve, middle);
  return carried(curve, half, b, carried(curve, a, half, normal, depth + 1), depth + 1);
}

Vector3d orthogonal(const Vector3d& vector, const Vector3d& tangent) {
  return (vector - vector.dot(tangent) * tangent).stableNormalized();
}

Vector3d firstNormal(const std::optional<Vector3d>& wanted, const Vector3d& tangent) {
  if (!wanted) return tangent.unitOrthogonal();
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite((*wanted)(i)))
      throw std::invalid_argument("coordinate " + std::to_string(i) + " of the normal is " +
                                  bernstein::text((*wanted)(i)) + ": it must be finite");
  const Vector3d unit = wanted->stableNormalized();
  const double sine = unit.cross(tangent).norm();
  // A choice: half of the digits of a unit vector. Nearer to the tangent the direction is mostly
  // rounding of it.
  if (!(sine > 1e-9))
    throw std::invalid_argument("the normal is at an angle of " + bernstein::text(sine) +
                                " to the tangent: it must not lie along it");
  return orthogonal(unit, tangent);
}

void requireIncreasing(const std::vector<double>& parameters) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const bool increases = i == 0 || parameters[i] > parameters[i - 1];
    if (!std::isfinite(parameters[i]) || !increases)
      throw std::invalid_argument("parameter " + std::to_string(i) + " is " +
                                  bernstein::text(parameters[i]) +
                                  ": finite numbers that increase are needed");
  }
}

/// Checks for cusps separately, because a long step may pass a cusp without showing it.
void requireNoCusp(const BezierCurve& curve, double first, double last) {
  for (const CurveDegeneracies::Interval& interval : findDegeneracies(curve).intervals) {
    const double t = 0.5 * (interval.first + interval.last);
    if (interval.kind == CurvePoint::Cusp && first < t && t < last) refuseCusp(t);
  }
}

}  // namespace

std::vector<MovingFrame> rotationMinimizingFrames(const BezierCurve& curve,
                                                  const std::vector<double>& parameters,
                                                  std::optional<Vector3d> normal) {
  requireIncreasing(parameters);
  if (parameters.size() > 1) requireNoCusp(curve, parameters.front(), parameters.back());
  std::vector<MovingFrame> frames;
  frames.reserve(parameters.size());
  for (const double t : parameters) {
    const CurveSample sample = sampleAt(curve, t);
    Vector3d turned;
    if (frames.empty()) {
      turned = firstNormal(normal, sample.tangent);
    } else {
      const MovingFrame& last = frames.back();
      turned =
          orthogonal(carried(curve, {last.t, last.point, last.tangent}, sample, last.normal, 0),
                     sample.tangent);
    }
    frames.push_back({t, sample.point, sample.tangent, turned, sample.tangent.cross(turned)});
  }
  return frames;
}

}  // namespace seamwright
