// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>

#include <seamwright/occ_adapter/repair/move_conditions.hpp>
#include <seamwright/occ_adapter/repair/task_places.hpp>

/// The move of a surface's poles that makes it meet its paths; not a public header.
namespace seamwright::occ {

/// The conditions of all samples, linear in the poles about a surface: points, tangent planes n . X_w = 0, curvature
/// n . X_ww = II(X_w, X_w), each over the share of its tolerance; and the fairness of the move since the surface was given, its second
/// differences. What is referred to must outlive it.
class FairMove {
 public:
  FairMove(const FaceTask& task, const TaskPlaces& places, const MovingSurface& surface);
  FairMove(const FairMove&) = delete;
  FairMove& operator=(const FairMove&) = delete;

  /// Unknown moves.
  int count() const { return numbers_.count; }
  /// The conditions are about the surface as it is now, not as it was given: curvature is not linear, and beside a side that is one point
  /// tangents turn with the poles.
  bool dependsOnMove() const { return depends_on_move_; }

  /// The poles after the move of least squares. \param fairness the smaller, the better the samples are met and the less fair the move.
  /// \returns nothing where the move is without sense, as the conditions contradict one another.
  std::optional<PointRows> poles(double fairness) const;

 private:
  void addPlace(const Place& place);
  void addFairness();
  double curvatureLimit(const TargetPoint& target) const;
  double fairnessWeight(double fairness) const;

  const FaceTask& task_;
  const TaskPlaces& places_;
  const MovingSurface& surface_;
  MoveNumbers numbers_;
  bool depends_on_move_;
  PointRows start_;
  MoveConditions conditions_;
};

}  // namespace seamwright::occ
