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

/// Samples the conditions on the sides of moving faces. Not a public header.
namespace seamwright::occ {

/// A face that moves.
struct MovingFace {
  Displacement displacement;
  double budget_per_mm = 0;  ///< how much the variation of the mean curvature may grow
  double area_mm2 = 0;
  double size_mm = 0;  ///< size of the face, see sizeOf_mm()
  /// Factor on the cost of bending: the face spends less where it is above 1.
  double stiffness = 1;
  /// A move of this size costs as much as the budget.
  double restraint_mm = std::numeric_limits<double>::infinity();
};

using MovingFaces = std::map<int, MovingFace>;  ///< by number of the face

enum class Ask {
  Join,    ///< the sides are to meet
  Keep,    ///< the figures may not grow
  Outline  ///< a free edge, which keeps its position
};

/// A boundary shared by two faces, or a free boundary of one.
struct Joint {
  std::size_t seam = 0;  ///< not used for an outline
  Ask ask = Ask::Keep;
  int order = 1;  ///< 0: position, 1: tangent planes, 2: curvature
  std::vector<Coedge> sides;
  std::vector<Pcurve> paths;
  Correspondence map;
  double turn_rad = 0;           ///< how much the angle of a kept crease may change
  std::set<double> also;         ///< parameters in 0..1 at which samples missed before
  std::array<bool, 2> slides{};  ///< by side: its face stays, and the edge may slide on it
};

/// One side of a joint at a sample.
struct JointSide {
  const MovingFace* mover = nullptr;  ///< null: the face stays
  Eigen::Vector2d uv = Eigen::Vector2d::Zero(), into = Eigen::Vector2d::Zero();
  PoleShares shares;  ///< of the mover's coefficients
  /// By coefficient of the shares: its index in the sample's cell; -1: it stays.
  std::vector<Eigen::Index> column;
  /// Before any move; on a side on which the edge slides: beside the other side as it is now.
  SidePoint shown;
  /// Null: the edge keeps its position on this side.
  std::shared_ptr<const StayingSurface> slides_on = {};
};

/// Differences of two sides, with aligned normals. For an outline: the vector from its given
/// position.
struct Differences {
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();
  /// Difference of the unit normals, where both sides have one.
  std::optional<Eigen::Vector3d> normal;
  /// Entries of the difference of the curvature tensors: along, mixed, across.
  Eigen::Vector3d bend = Eigen::Vector3d::Zero();
};

/// Accepted differences of a sample.
/// Source: docs/theory/repair.md R3.
struct JointLimits {
  double gap_mm = 0;
  double slide_mm = 0;    ///< along the seam, and at its ends in all directions
  double overlap_mm = 0;  ///< in the tangent plane across the seam
  double angle_rad = 0;
  double curvature_per_mm = 0;  ///< for entries of the curvature tensors
};

struct JointSample {
  double s = 0;
  std::vector<JointSide> sides;
  JointLimits limits;
  /// Direction across the seam, in the tangent plane of the first side.
  Eigen::Vector3d across = Eigen::Vector3d::Zero();
  /// Differences that may stay; for a joint that is to meet at most a small gap.
  Differences given;
  bool keeps_gap = false;  ///< the gap may stay as it was
  /// Largest differences anywhere along a kept joint. Local differences may grow up to these, as
  /// only the largest ones are measured.
  double kept_gap_mm = 0, kept_angle_rad = 0, kept_bend_per_mm = 0;
  double part = 0;    ///< share of the joint's length
  double weight = 1;  ///< grows where the sample is missed
  double ratio = 0;   ///< its miss over its tolerance
  int cell = -1;      ///< cell of the system
};

/// Samples equally spaced in the knot spans that the joint crosses, of the movers or of their
/// displacements, with both ends and five samples around each parameter of Joint::also.
/// \throws Standard_Failure where OpenCASCADE can't evaluate.
std::vector<JointSample> sampled(const Joint& joint, const MovingFaces& movers,
                                 const ContinuityTolerance& tolerance);

/// Updates the curvature limit of a joint that is to have G2: a share of the larger curvature,
/// which changes while faces move.
void followCurvature(const Joint& joint, const ContinuityTolerance& tolerance, JointSample& sample);

/// Moves the sample of a sliding edge to the foot of the moving side on the face that stays.
void followSlide(JointSample& sample);

/// The differences of both sides at a sample, for the present positions of the movers.
Differences differencesAt(const Joint& joint, const JointSample& sample);

/// The largest miss of a sample over its tolerance; infinite if a figure can't be computed. A
/// difference that may stay counts by its growth: up to half the tolerance it is free, beyond that
/// the accepted growth is a tenth of the tolerance.
double missedShare(const Joint& joint, const JointSample& sample);

/// The sum of squares of a sample's conditions.
double costOf(const Joint& joint, const JointSample& sample);

/// Adds the conditions of a sample on the steps of its cell's coefficients. They are linear in the
/// moves.
void addConditions(const Joint& joint, const JointSample& sample, StepSystem& system);

}  // namespace seamwright::occ
