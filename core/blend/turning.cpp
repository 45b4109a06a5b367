// SPDX-License-Identifier: LGPL-2.1-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include <seamwright/core/blend/joint_jet.hpp>
#include <seamwright/core/blend/turning.hpp>
#include <seamwright/core/linear/dense.hpp>

namespace seamwright::blending {

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Tangents whose common normal is shorter count as parallel: then its direction is mostly
/// rounding. A choice, between rounding and angles that matter.
constexpr double least_normal = 1e-6;

Vector3d tangentOf(const Poles& points) {
  const Index n = (points.rows() - 1) / 2;
  return (points.row(n + 1) - points.row(n - 1)).transpose().normalized();
}

Matrix3d turned(const Turn& turn, double share) {
  return Eigen::AngleAxisd(share * turn.angle_rad, turn.axis).toRotationMatrix();
}

/// The poles beside the joint and the far ends, from the joint.
Poles legsOf(const JointKey& key) {
  const Poles points = pointsOf(key.poles);
  Poles legs(points.rows() + key.far.rows(), 3);
  legs << points, key.far;
  const Eigen::RowVector3d joint = points.row((points.rows() - 1) / 2);
  return legs.rowwise() - joint;
}

/// Of the plane through 0 nearest to all legs.
Vector3d normalOfLegs(const Poles& first, const Poles& second) {
  const Eigen::MatrixXd moments = first.transpose() * first + second.transpose() * second;
  return linear::symmetricEigenvalues(moments).vectors.col(0);
}

/// An edge's direction in the frame of the one before, as the turn from there.
Vector3d turningVector(const Vector3d& before, const Vector3d& after) {
  const Vector3d normal = before.cross(after);
  const double sine = normal.norm(), angle = std::atan2(sine, before.dot(after));
  // Legs in line or back on themselves have no axis; they are taken as straight.
  return sine > 0 ? Vector3d(normal * (angle / sine)) : Vector3d::Zero();
}

/// Lengths and turning vectors of the edges on one side of the joint, outwards, seen from a frame
/// that is carried along.
struct EdgeChain {
  Eigen::VectorXd lengths;
  Poles turns;  ///< row j: from edge j - 1 to edge j; row 0 is not used
};

/// \param frame directions are seen from; its inverse is applied.
EdgeChain chainOf(const Poles& outwards, Matrix3d frame) {
  const Index count = outwards.rows() - 1;
  EdgeChain chain{Eigen::VectorXd(count), Poles::Zero(count, 3)};
  Vector3d before = Vector3d::Zero();
  for (Index j = 0; j < count; ++j) {
    const Vector3d edge = outwards.row(j + 1) - outwards.row(j);
    chain.lengths(j) = edge.norm();
    Vector3d direction = chain.lengths(j) > 0 ? Vector3d(edge / chain.lengths(j)) : before;
    if (j > 0) {
      const Vector3d turn = turningVector(before, direction);
      chain.turns.row(j) = (frame.transpose() * turn).transpose();
      if (turn.norm() > 0)
        frame = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * frame;
    }
    before = direction;
  }
  return chain;
}

/// The points of a chain from its first point.
Poles pointsAlong(const EdgeChain& chain, const Vector3d& start, Vector3d direction,
                  Matrix3d frame) {
  Poles result(chain.lengths.size() + 1, 3);
  result.row(0) = start.transpose();
  for (Index j = 0; j < chain.lengths.size(); ++j) {
    const Vector3d turn = frame * chain.turns.row(j).transpose();
    if (turn.norm() > 0) {
      const Matrix3d step = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
      direction = step * direction;
      frame = step * frame;
    }
    result.row(j + 1) = result.row(j) + chain.lengths(j) * direction.transpose();
  }
  return result;
}

EdgeChain between(const EdgeChain& x, const EdgeChain& y, double share) {
  return {(1 - share) * x.lengths + share * y.lengths, (1 - share) * x.turns + share * y.turns};
}

HomogeneousPoles weighted(const Poles& points, const Eigen::VectorXd& weights) {
  HomogeneousPoles result(points.rows(), 4);
  result << weights.asDiagonal() * points, weights;
  return result;
}

}  // namespace

Turn turnBetween(const JointKey& first, const JointKey& second) {
  const Vector3d u = tangentOf(pointsOf(first.poles)), v = tangentOf(pointsOf(second.poles));
  const Vector3d normal = u.cross(v);
  Turn turn;
  turn.angle_rad = std::atan2(normal.norm(), u.dot(v));
  if (normal.norm() > least_normal) {
    turn.axis = normal.normalized();
    return turn;
  }
  const Poles one = legsOf(first), two = legsOf(second);
  const Vector3d across = normalOfLegs(one, two);
  turn.axis = (across - across.dot(u) * u).stableNormalized();
  if (!(turn.axis.norm() > 0.5)) turn.axis = u.unitOrthogonal();
  const Index far = one.rows() - 2;
  const Vector3d mean =
      (one.row(far + 1) - one.row(far) + two.row(far + 1) - two.row(far)).transpose();
  if (turn.axis.cross(u).dot(mean) < 0) turn.axis = -turn.axis;
  return turn;
}

HomogeneousPoles halfTurned(const JointKey& first, const JointKey& second) {
  const Poles one = pointsOf(first.poles), two = pointsOf(second.poles);
  const Index n = (one.rows() - 1) / 2;
  const Turn turn = turnBetween(first, second);
  const Poles legs = ((one.rowwise() - one.row(n)) * turned(turn, 0.5).transpose() +
                      (two.rowwise() - two.row(n)) * turned(turn, -0.5).transpose()) /
                     2;
  const Eigen::RowVector3d middle = (one.row(n) + two.row(n)) / 2;
  return weighted(legs.rowwise() + middle, (first.poles.col(3) + second.poles.col(3)) / 2);
}

HomogeneousPoles intrinsicPoles(const JointKey& first, const JointKey& second, double share) {
  const Poles one = pointsOf(first.poles), two = pointsOf(second.poles);
  const Index n = (one.rows() - 1) / 2;
  const Turn turn = turnBetween(first, second);
  const Matrix3d frame = turned(turn, share);
  const Vector3d tangent = frame * tangentOf(one);
  const Vector3d start = ((1 - share) * one.row(n) + share * two.row(n)).transpose();
  const auto side = [&](bool after) -> Poles {
    const auto outwards = [&](const Poles& points) -> Poles {
      if (after) return points.bottomRows(n + 1);
      return points.topRows(n + 1).colwise().reverse();
    };
    const EdgeChain chain = between(chainOf(outwards(one), Matrix3d::Identity()),
                                    chainOf(outwards(two), turned(turn, 1)), share);
    return pointsAlong(chain, start, after ? tangent : Vector3d(-tangent), frame);
  };
  Poles points(one.rows(), 3);
  points << side(false).colwise().reverse(), side(true).bottomRows(n);
  return weighted(points, (1 - share) * first.poles.col(3) + share * second.poles.col(3));
}

}  // namespace seamwright::blending
