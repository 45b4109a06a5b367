// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <seamwright/core/seam/tolerance.hpp>
#include <seamwright/occ_adapter/convert/face_strip.hpp>
#include <seamwright/occ_adapter/repair/displacement.hpp>
#include <seamwright/occ_adapter/repair/slide.hpp>
#include <seamwright/occ_adapter/repair/step_system.hpp>
#include <seamwright/occ_adapter/seams/find.hpp>

/// What sides of moving faces are to meet, in samples; not a public header.
namespace seamwright::occ {

/// A face that moves.
struct MovingFace {
  Displacement displacement;
  double budget_per_mm = 0;  ///< by how much the mean curvature may vary more
  double area_mm2 = 0;
  double size_mm = 0;    ///< of the face, see sizeOf_mm()
  double stiffness = 1;  ///< above 1: it may spend so much less
  double restraint_mm =
      std::numeric_limits<double>::infinity();  ///< a move of this size costs as much as the budget
};

using MovingFaces = std::map<int, MovingFace>;  ///< by number of the face

enum class Ask {
  Join,    ///< the sides are to meet
  Keep,    ///< what they lack may not grow
  Outline  ///< one side, which keeps its place
};

/// A boundary shared by two faces, or an open one.
struct Joint {
  std::size_t seam = 0;  ///< of an outline: none
  Ask ask = Ask::Keep;
  int order = 1;  ///< 0: place, 1: tangent planes, 2: curvature
  std::vector<Coedge> sides;
  std::vector<Pcurve> paths;
  Correspondence map;
  double turn_rad = 0;           ///< by which the angle of a kept crease may change
  std::set<double> also;         ///< places, 0..1, where samples missed something before
  std::array<bool, 2> slides{};  ///< by side: its face stays, and the edge may run elsewhere on it
};

/// A side at a sample.
struct JointSide {
  const MovingFace* mover = nullptr;  ///< null: the face stays
  Eigen::Vector2d uv = Eigen::Vector2d::Zero(), into = Eigen::Vector2d::Zero();
  PoleShares shares;  ///< of the mover's coefficients
  std::vector<Eigen::Index>
      column;       ///< by coefficient of the shares: its place in the sample's cell, -1: it stays
  SidePoint shown;  ///< before any move; of a side that the edge slides on: beside the other side
                    ///< as it is now
  std::shared_ptr<const StayingSurface> slides_on =
      {};  ///< null: the edge has its place on the side
};

/// What two sides lack. Normals are aligned. Of an outline: the way from its place.
struct Differences {
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> normal;  ///< of the unit normals, where both sides have one
  Eigen::Vector3d bend =
      Eigen::Vector3d::Zero();  ///< of the curvature tensors: along, mixed, across
};

/// What a sample may miss.
struct JointLimits {
  double gap_mm = 0;
  double slide_mm = 0;    ///< along the seam, and at its ends in all directions
  double overlap_mm = 0;  ///< in the tangent plane across the seam
  double angle_rad = 0;
  double curvature_per_mm = 0;  ///< of entries of the curvature tensors
};

struct JointSample {
  double s = 0;
  std::vector<JointSide> sides;
  JointLimits limits;
  Eigen::Vector3d across =
      Eigen::Vector3d::Zero();  ///< the seam, in the tangent plane of the first side
  Differences given;            ///< what may stay: of a joint that is to meet at most a small gap
  bool keeps_gap = false;       ///< the gap may stay as it was
  /// Of a kept joint: the largest that it lacks anywhere, as no more is seen of it.
  double kept_gap_mm = 0, kept_angle_rad = 0, kept_bend_per_mm = 0;
  double part = 0;    ///< of the joint's length
  double weight = 1;  ///< grows where the sample is missed
  double ratio = 0;   ///< of what it misses to its tolerance
  int cell = -1;      ///< of the system
};

/// Samples even in the knot spans, of the movers or of their displacements, that the joint crosses,
/// both ends, and five around each place of Joint::also.
/// \throws Standard_Failure where OpenCASCADE can't evaluate.
std::vector<JointSample> sampled(const Joint& joint, const MovingFaces& movers,
                                 const ContinuityTolerance& tolerance);

/// Of a joint that is to have G2: the accepted difference is a share of the larger curvature, which
/// changes while faces move.
void followCurvature(const Joint& joint, const ContinuityTolerance& tolerance, JointSample& sample);

/// Edges that slide run to the feet of the sides that move.
void followSlide(JointSample& sample);

Differences differencesAt(const Joint& joint, const JointSample& sample);

/// What a sample misses over its tolerance; what may stay counts where it grows by more than a
/// tenth of the tolerance.
double missedShare(const Joint& joint, const JointSample& sample);

/// The sum of squares of a sample's conditions.
double costOf(const Joint& joint, const JointSample& sample);

/// The conditions of a sample for the steps of its cell's coefficients, linear in the moves.
void addConditions(const Joint& joint, const JointSample& sample, StepSystem& system);

}  // namespace seamwright::occ
